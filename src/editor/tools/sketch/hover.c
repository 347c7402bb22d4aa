/* The pen above the drawing: which curve a stroke that begins here would redraw. */
#include "editor/edit/curves_of.h"
#include "editor/input/contacts.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tools/sketch/parts.h"
#include "editor/show/disc.h"
#include "editor/view/curve_ground.h"
#include "editor/view/stage.h"

static const double REACH = 12, REACH_TOUCH = 24; /* px: reach of the pen for curves */

static double reach(bat_device device) { return device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH; }

bat_pick bat_sketching_pick_at(bat_context *c, const double pixel[2], bat_device device) {
    double point[2];
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    return bat_pick_curve(c->scene, 0, point, reach(device) * bat_stage_pixel(c->stage));
}

/* The stage as it is; where the ground is a surface, and not under the pen, the page takes its place. */
static bat_stage stage_under(const bat_context *c, const double pixel[2]) {
    bat_stage stage = *c->stage;
    bat_hit hit;
    if (bat_ground_bounded(&stage.ground) && bat_stage_place(&stage, pixel, NULL, &hit) == BAT_FAR)
        stage.ground = bat_ground_page();
    return stage;
}

bat_stage bat_sketching_stage(const bat_context *c, const bat_pick *pick, const double pixel[2]) {
    bat_stage stage = stage_under(c, pixel);
    const bat_document *document = c->session->document;
    const bat_object *object = bat_document_at(document, bat_document_find(document, pick->object));
    if (!object || pick->curve < 0 || pick->curve >= bat_object_curve_count(object)) return stage;
    const bat_curve *curve = bat_object_curve(object, pick->curve);
    stage.ground = bat_curve_dimension(curve) == 2
                       ? bat_ground_page()
                       : bat_ground_of_curve(c->stage, pick->object, pick->curve, curve);
    return stage;
}

void bat_sketching_show_ground(const bat_context *c, const bat_stage *stage, bat_overlay *overlay) {
    const bat_ground *ground = &stage->ground;
    const int dimension = bat_stage_dimension(stage), curve = (int)ground->numbers[4];
    if (!bat_ground_rules(ground, ground->object, curve)) return;
    const bat_curve *line = bat_edit_target_in(c->session->document, dimension, ground->object, curve);
    if (line) bat_ruled_show(line, ground->numbers, overlay);
}

void bat_sketching_hover(bat_context *c, void *state, const bat_pointer *event) {
    (void)c;
    bat_sketching *s = state;
    s->hovering = s->hover_changed = true;
    s->device = event->device;
    s->hover[0] = event->x;
    s->hover[1] = event->y;
}

void bat_sketching_leave(bat_context *c, void *state) {
    (void)c;
    bat_sketching *s = state;
    s->hovering = false;
    if (s->state != BAT_SKETCHING_DRAWING) s->pick = (bat_pick){0};
}

void bat_sketching_look(bat_context *c, bat_sketching *s) {
    const bat_stage *stage = c->stage;
    if (s->pick_revision == c->session->revision && bat_stage_same(stage, &s->pick_stage) &&
        !s->hover_changed)
        return;
    s->pick = s->hovering ? bat_sketching_pick_at(c, s->hover, s->device) : (bat_pick){0};
    s->over = bat_sketching_stage(c, &s->pick, s->hover);
    s->pick_revision = c->session->revision;
    s->pick_stage = *stage;
    s->hover_changed = false;
}

void bat_sketching_highlight(const bat_context *c, bat_overlay *overlay, int dimension, bat_id object,
                             int curve) {
    const bat_curve *target = bat_edit_target_in(c->session->document, dimension, object, curve);
    const bat_object *held = bat_document_at(c->session->document,
                                             bat_document_find(c->session->document, object));
    if (!target || !held) return;
    const bat_width_profile profile = bat_object_widths(held);
    bat_sketching_halo(overlay, BAT_ROLE_HIGHLIGHT, bat_sketching_width(c, bat_object_style(held), &profile));
    bat_path_curve(&overlay->path, target);
}

bat_cursor bat_sketching_cursor(const bat_context *c, const void *state) {
    (void)c;
    const bat_sketching *s = state;
    return s->pick.object ? BAT_CURSOR_PEN : BAT_CURSOR_CROSS;
}

/* The curve that would be redrawn. */
bool bat_sketching_focus(const bat_context *c, const void *state, bat_focus *out) {
    const bat_sketching *s = state;
    (void)c;
    *out = (bat_focus){.object = s->pick.object, .curve = s->pick.curve};
    return s->pick.object != 0;
}
