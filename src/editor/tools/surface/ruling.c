/* Turning the sheet on which strokes are placed: a handle at the grip, in the direction in which the sheet runs. A tap on
 * it takes the next of the surface's own direction, x, y, z and the one that was chosen last; a drag chooses one. */
#include "base/real.h"
#include "base/vec.h"
#include "editor/session/notice.h"
#include "editor/tables/settings.h"
#include "editor/tools/surface/state.h"
#include "editor/view/way.h"
#include "form/view/ruling.h"
#include <math.h>
#include <string.h>

static const double LENGTH = 64, LEAST = 28,
                    REACH = 12;                /* px: of the handle as it lies in space, and as it is seen */
static const double TAP = 4;                   /* px that a tap may travel */
static const double TOUCH = 2.2;               /* factor on the reach for fingers */
static const double STOP = 0.9961946980917455; /* cosine of 5 degrees, within which it stops */
enum { OWN = 0, AXES = 3, FREE = 4 };          /* choices of the property: the surface's own, x, y, z, free */

static double *choice_of(const bat_context *c) { return &c->settings->values[BAT_PROPERTY_LINE_RULING]; }

void bat_surfacing_along(const bat_context *c, const bat_surfacing *s, double along[3]) {
    const int choice = (int)*choice_of(c);
    for (int k = 0; k < 3; k++) along[k] = choice == FREE ? s->free[k] : choice == k + 1;
}

static bool grip_of(bat_context *c, bat_surfacing *s, const bat_surface **surface, bat_viewpoint *view,
                    double jet[9]) {
    *surface = bat_surfacing_surface(c, s);
    if (!*surface || bat_surfacing_view(c, *surface, view) != BAT_OK) return false;
    bat_surface_eval(*surface, s->lit.at[0], s->lit.at[1], 1, jet);
    return true;
}

bool bat_surfacing_handle_in(bat_context *c, bat_surfacing *s, const bat_mirror *mirror, double grip[2],
                             double pixel[2]) {
    const bat_surface *surface;
    bat_viewpoint view;
    double jet[9], along[3], way[3], tip[3];
    bool turned;
    if (!grip_of(c, s, &surface, &view, jet)) return false;
    bat_surfacing_along(c, s, along);
    const bat_direction d = s->lit.direction;
    if (bat_surface_ruling(surface, d, s->lit.at[d], &view, along, way, &turned) != BAT_OK) return false;
    for (int k = 0; k < 3; k++) tip[k] = jet[k] + LENGTH * bat_stage_pixel(c->stage) * way[k];
    if (mirror) {
        const double at[2] = {jet[0], jet[1]}, end[2] = {tip[0], tip[1]};
        bat_mirror_point(mirror, at, jet);
        bat_mirror_point(mirror, end, tip);
    }
    if (!bat_surfacing_pixel(&view, jet, grip) || !bat_surfacing_pixel(&view, tip, pixel)) return false;
    const double x = pixel[0] - grip[0], y = pixel[1] - grip[1], length = bat_hypot(x, y);
    if (length >= LEAST) return true;
    const bool shown = length > 1e-6;
    pixel[0] = grip[0] + (shown ? LEAST * x / length : 0);
    pixel[1] = grip[1] + (shown ? LEAST * y / length : -LEAST);
    return true;
}

bool bat_surfacing_handle(bat_context *c, bat_surfacing *s, double grip[2], double pixel[2]) {
    return bat_surfacing_handle_in(c, s, NULL, grip, pixel);
}

bool bat_surfacing_on_handle(bat_context *c, bat_surfacing *s, const double pixel[2]) {
    double grip[2], at[2];
    return bat_surfacing_handle(c, s, grip, at) && bat_hypot(at[0] - pixel[0], at[1] - pixel[1]) <=
                                                       REACH * (s->device == BAT_DEVICE_TOUCH ? TOUCH : 1);
}

/* The choice whose direction is this one, to either side; FREE: none. */
static int choice_near(const bat_surface *surface, const bat_surfacing *s, const bat_viewpoint *view,
                       vec way) {
    static const double none[3] = {0};
    const bat_direction d = s->lit.direction;
    double own[3];
    bool turned = true;
    if (bat_surface_ruling(surface, d, s->lit.at[d], view, none, own, &turned) == BAT_OK && !turned &&
        fabs(vec_dot(way, vec_load(own, 3))) >= STOP)
        return OWN;
    const double axes[AXES] = {way.x, way.y, way.z};
    for (int k = 0; k < AXES; k++)
        if (fabs(axes[k]) >= STOP) return k + 1;
    return FREE;
}

void bat_surfacing_turn(bat_context *c, bat_surfacing *s) {
    const bat_surface *surface;
    bat_viewpoint view;
    double jet[9], normal[3], way[3];
    if (!grip_of(c, s, &surface, &view, jet)) return;
    if (bat_hypot(s->hover[0] - s->start[0], s->hover[1] - s->start[1]) <= TAP) return;
    /* In the plane across the line; at a pole, which has none, across the gaze. */
    vec_store(vec_unit(vec_load(jet + (s->lit.direction == BAT_U ? 6 : 3), 3)), normal);
    if (!bat_stage_aim(c->stage, 3, normal, jet, s->hover, way)) return;
    const vec towards = vec_unit(vec_load(way, 3));
    if (!(vec_norm(towards) > 0)) return;
    vec_store(towards, s->free);
    *choice_of(c) = c->modifiers & BAT_SHIFT ? FREE : choice_near(surface, s, &view, towards);
}

void bat_surfacing_turn_back(bat_context *c, bat_surfacing *s) {
    *choice_of(c) = s->ruling_before;
    memcpy(s->free, s->free_before, sizeof s->free);
}

void bat_surfacing_turn_begin(const bat_context *c, bat_surfacing *s) {
    s->ruling_before = *choice_of(c);
    memcpy(s->free_before, s->free, sizeof s->free);
}

void bat_surfacing_turn_end(bat_context *c, bat_surfacing *s) {
    double *choice = choice_of(c);
    if (bat_hypot(s->hover[0] - s->start[0], s->hover[1] - s->start[1]) <= TAP) { /* a tap */
        bat_surfacing_turn_back(c, s);
        const int last = vec_norm(vec_load(s->free, 3)) > 0 ? FREE : AXES;
        *choice = *choice < last ? *choice + 1 : OWN;
    }
    bat_notice(c, (bat_string)(BAT_STRING_RULING_SURFACE + (int)*choice));
}
