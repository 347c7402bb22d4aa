/*
 * The smooth brush. A circle shows its reach; the stretch of the nearest curve within it is lit. Painting adds to the
 * stretch, which is faired as a whole: the curve as it will be is shown, and kept when the pen is lifted. A tap calms
 * what is lit.
 */
#include "editor/edit/stroke.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/pressure.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/stage.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/brushing.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/view.h"
#include "base/real.h"
#include "editor/tools/calm.h"
#include "editor/pick/pick.h"
#include "editor/edit/curves_of.h"
#include <math.h>

static const float STRETCH_WIDTH = 4, FIT_WIDTH = 2;

static double radius(const bat_context *c) {
    return c->settings->values[BAT_PROPERTY_BRUSH_SIZE] * bat_view_pixel(c->view);
}

/* What the pen's pressure makes of it. A curve is found within all of it, however light the tap. */
static double pressed(const bat_context *c, const bat_brushing *b) { return b->pressure * radius(c); }

static const bat_curve *target(const bat_context *c, const bat_brushing *b) {
    return b->object ? bat_edit_target(c->session->document, b->object, b->curve) : NULL;
}

/* Half of the stretch within a circle: the chord's, at this distance from its middle. */
static double half(double radius_, double distance) {
    return sqrt(fmax(radius_ * radius_ - distance * distance, radius_ * radius_ / 16));
}

static void look(bat_context *c, bat_brushing *b) {
    double point[2], r = radius(c);
    b->object = 0;
    bat_stage_sync(c);
    bat_view_to_document(c->view, b->at, point);
    bat_pick pick = bat_pick_nearest(c->scene, point, r);
    if (!pick.object) return;
    b->object = pick.object;
    b->curve = pick.curve;
    b->u = pick.near.u;
    const bat_curve *curve = target(c, b);
    if (curve)
        bat_calm_range(curve, b->u, half(pressed(c, b), pick.near.distance), b->range);
    else
        b->object = 0;
}

/* The curve goes on under the brush: its stretch grows, in whichever period lies next. */
static void paint(bat_context *c, bat_brushing *b) {
    const bat_curve *curve = target(c, b);
    double point[2], domain[2], range[2], r = radius(c);
    bat_near near;
    if (!curve) return;
    bat_view_to_document(c->view, b->at, point);
    if (bat_curve_nearest(curve, point, &near) != BAT_OK || near.distance > r) return;
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0], turns = 0;
    if (bat_curve_closed(curve)) turns = floor((b->u - near.u) / period + 0.5) * period;
    bat_calm_range(curve, near.u, half(pressed(c, b), near.distance), range);
    b->u = near.u + turns;
    b->range[0] = fmin(b->range[0], range[0] + turns);
    b->range[1] = fmax(b->range[1], range[1] + turns);
    if (b->range[1] - b->range[0] > period) b->range[1] = b->range[0] + period;
    b->due = true;
}

static bat_status fair(bat_context *c, bat_brushing *b, bat_curve **out) {
    double pixel = bat_view_pixel(c->view);
    return bat_calm_curve(target(c, b), b->range, c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel,
                          pixel, out);
}

static void note(bat_context *c, bat_brushing *b, const bat_pointer *event) {
    b->hovering = true;
    b->device = event->device;
    b->at[0] = event->x;
    b->at[1] = event->y;
    if (event->phase != BAT_POINTER_UP) b->pressure = bat_pressure_of(c, event);
}

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    bat_brushing *b = state;
    note(c, b, event);
}
static void leave(bat_context *c, void *state) {
    (void)c;
    bat_brushing *b = state;
    b->hovering = false;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_brushing *b = state;
    bat_brushing_end(b);
    note(c, b, event);
    look(c, b);
    b->painting = b->due = true;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_brushing *b = state;
    if (!b->painting || event->predicted) return;
    note(c, b, event);
    if (b->object)
        paint(c, b);
    else
        look(c, b); /* the stroke began beside every curve */
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_brushing *b = state;
    (void)event;
    if (!b->painting) return;
    bat_curve *curve = NULL;
    if (!target(c, b)) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
    } else {
        bat_status status = fair(c, b, &curve);
        if (status == BAT_OK)
            status = bat_commit_curve(c, b->object, b->curve, curve, BAT_STRING_STEP_SMOOTH);
        if (status != BAT_OK) bat_notice_failure(c, status);
    }
    bat_brushing_end(b);
}

static bool cancel(bat_context *c, void *state) {
    bat_brushing *b = state;
    if (!b->painting) return false;
    bat_brushing_end(b);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_brushing *b = state;
    return b->painting;
}

static void update(bat_context *c, void *state) {
    bat_brushing *b = state;
    if (!b->painting) {
        b->object = 0;
        if (b->hovering) look(c, b);
        return;
    }
    if (!b->due || !target(c, b)) return;
    b->due = false;
    bat_curve_free(b->preview);
    b->preview = NULL;
    fair(c, b, &b->preview); /* without one nothing is shown */
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_brushing *b = state;
    const bat_curve *curve = target(c, b);
    double point[2];
    if (!b->hovering || c->input->holding_pan) return;
    if (curve) {
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
        bat_overlay_stretch(list, curve, b->range[0], b->range[1]);
    }
    if (b->preview) {
        bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, FIT_WIDTH);
        bat_path_curve(&list->path, b->preview);
    }
    bat_view_to_document(c->view, b->at, point);
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.25F);
    bat_overlay_circle(list, point, pressed(c, b));
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    const bat_brushing *b = state;
    if (b->painting) return BAT_STRING_HINT_BRUSHING;
    return b->object ? BAT_STRING_HINT_BRUSH : BAT_STRING_HINT_SMOOTH_NOTHING;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    (void)c;
    return BAT_CURSOR_CROSS;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_brushing *b = state;
    if (b->preview && !b->painting) return "a preview outlived its brush";
    if (b->painting && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a brush without a pen";
    return NULL;
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const bat_brushing *b = state;
    out->curve = b->preview;
}

static void end(void *state) { bat_brushing_end(state); }

static bat_status work(bat_context *c, void *state, const bat_stretch *on) {
    double pixel = bat_view_pixel(c->view), limit = c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel;
    const bat_curve *curve = bat_edit_target(c->session->document, on->object, on->curve);
    bat_curve *faired = NULL;
    (void)state;
    if (!curve) return BAT_ARGUMENT;
    bat_status status = bat_calm_curve(curve, on->u, limit, pixel, &faired);
    return status == BAT_OK ? bat_commit_curve(c, on->object, on->curve, faired, BAT_STRING_STEP_SMOOTH)
                            : status;
}

const bat_tool *bat_tool_smooth(void) {
    static const bat_tool tool = {.work = work,
                                  .size = sizeof(bat_brushing),
                                  .end = end,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .readout = readout,
                                  .check = check};
    return &tool;
}
