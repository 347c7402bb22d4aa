#include "editor/pick/pivot.h"
#include "curve/curve.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/pick/surface.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

static const double REACH = 24; /* px */

static bool on_surface(bat_context *c, const double pixel[2], double out[3]) {
    const bat_object *surface = bat_pick_surface(c, pixel);
    bat_stage stage = *c->stage;
    bat_hit hit;
    if (!surface || !bat_ground_of(surface, &stage.ground) ||
        bat_stage_place(&stage, pixel, NULL, &hit) != BAT_OK)
        return false;
    memcpy(out, hit.at, sizeof hit.at);
    return true;
}

bool bat_pivot_under(bat_context *c, const double pixel[2], double out[3]) {
    double at[2], within = REACH * bat_stage_pixel(c->stage), place[BAT_DIMENSION_MAX] = {0};
    bool found = false;
    bat_seen_sync(c);
    const bat_scene_entry *entries = c->scene->entries;
    bat_stage_seen(c->stage, pixel, at);
    for (int i = 0; i < c->scene->count; i++) {
        const double *box = entries[i].box;
        if (entries[i].hidden || at[0] < box[0] - within || at[0] > box[2] + within ||
            at[1] < box[1] - within || at[1] > box[3] + within)
            continue;
        for (int j = 0; j < bat_object_curve_count(entries[i].object); j++) {
            const bat_finder *finder = bat_scene_finder(c->scene, i, j);
            bat_near near = {.distance = INFINITY};
            if (finder) bat_finder_nearest(finder, at, &near);
            if (!(near.distance <= within)) continue;
            within = near.distance;
            found = true;
            place[2] = 0;
            bat_curve_eval(bat_object_curve(bat_scene_shown(c->scene, i), j), near.u, 0, place);
        }
    }
    for (int k = 0; k < 3 && found; k++) out[k] = place[k];
    return found || on_surface(c, pixel, out);
}

static void hold(double low[3], double high[3], const double *point, int dimension) {
    for (int k = 0; k < 3; k++) {
        low[k] = fmin(low[k], k < dimension ? point[k] : 0);
        high[k] = fmax(high[k], k < dimension ? point[k] : 0);
    }
}

/* The middle of the box around the control points of what is selected, or of everything and the page; of what is seen, not of
 * the cameras that see it. */
static bool middle(bat_context *c, bool selected, double out[3]) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, page[4];
    bat_document_page(c->session->document, page);
    for (int i = 0, end = 0; i < bat_document_count(c->session->document); i++) {
        const bat_object *object = bat_document_at(c->session->document, i);
        if (i >= end && bat_selection_has(&c->choice->selection, bat_object_id(object)))
            end = bat_document_end(c->session->document, i);
        if (bat_seen_hidden(c, i) || (selected && i >= end) || bat_object_camera(object)) continue;
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            const bat_curve *curve = bat_object_curve(object, j);
            const int size = bat_curve_dimension(curve);
            for (int k = 0; k < bat_point_count(curve); k++)
                hold(low, high, bat_curve_points(curve) + (size_t)k * (size_t)size, size);
        }
    }
    for (int i = 0; i < 2 && !selected && page[2] > 0; i++)
        hold(low, high, (double[]){page[0] + i * page[2], page[1] + i * page[3]}, 2);
    for (int k = 0; k < 3; k++) out[k] = low[k] / 2 + high[k] / 2;
    return low[0] <= high[0];
}

bool bat_pivot_of_all(bat_context *c, double out[3]) {
    bat_seen_sync(c);
    return middle(c, false, out);
}

void bat_pivot_set(bat_context *c, const double *pixel) {
    double at[3] = {0}, centre[2];
    bat_seen_sync(c);
    if ((pixel && bat_pivot_under(c, pixel, at)) || middle(c, true, at) || middle(c, false, at)) {
        bat_view_set_pivot(&c->stage->view, at);
        return;
    }
    bat_stage_middle(c->stage, centre); /* nothing is there */
    at[2] = 0;
    if (bat_stage_on_page(c->stage, centre, at)) bat_view_set_pivot(&c->stage->view, at);
}

void bat_perspective_follow(bat_context *c) {
    if (bat_stage_tilted(c->stage)) bat_pivot_set(c, NULL);
    c->stage->view.fov = c->settings->values[BAT_PROPERTY_PERSPECTIVE] != 0 ? BAT_FOV : 0;
}
