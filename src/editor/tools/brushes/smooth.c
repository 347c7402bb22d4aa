/*
 * The smooth brush. A circle shows its reach; the stretch of the nearest curve within it is highlighted. Painting
 * adds to the stretch, which is faired as a whole: a preview shows the result, which is kept when the pen is lifted.
 * A tap fairs the highlighted stretch.
 */
#include "editor/edit/stroke.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/pressure.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/brushes/brush.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include "editor/edit/fair.h"
#include "editor/pick/pick.h"
#include "editor/edit/curves_of.h"
#include <math.h>

static const float STRETCH_WIDTH = 4, FIT_WIDTH = 2;

typedef struct smoothing {
    bat_brush brush;
    bool due;
    /* The curve under the brush, and the stretch within its reach; while painting: the whole painted stretch. Closed
     * curves: the stretch may begin or end in another period. */
    bat_id object; /* 0: none */
    int curve;
    double u, range[2];
    bat_curve *preview; /* owned; NULL: none */
} smoothing;

/* Ends whatever is under way, and frees the memory. */
static void end(void *state) {
    smoothing *b = state;
    bat_curve_free(b->preview);
    b->preview = NULL;
    b->brush.painting = b->due = false;
    b->object = 0;
}

static double radius(const bat_context *c) {
    return c->settings->values[BAT_PROPERTY_BRUSH_SIZE] * bat_stage_pixel(c->stage);
}

/* The radius scaled by the pen's pressure. A curve is found within the full radius, however light the tap. */
static double pressed(const bat_context *c, const smoothing *b) { return b->brush.pressure * radius(c); }

static const bat_curve *target(const bat_context *c, const smoothing *b) {
    return b->object ? bat_edit_target_in(c->session->document, 0, b->object, b->curve) : NULL;
}

/* Half of the chord that a circle cuts at this distance from its centre. */
static double half(double radius_, double distance) {
    return sqrt(fmax(radius_ * radius_ - distance * distance, radius_ * radius_ / 16));
}

static void look(bat_context *c, smoothing *b) {
    double point[2], r = radius(c);
    b->object = 0;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, b->brush.at, point);
    bat_pick pick = bat_pick_curve(c->scene, 0, point, r);
    if (!pick.object) return;
    b->object = pick.object;
    b->curve = pick.curve;
    b->u = pick.near.u;
    const bat_curve *curve = target(c, b);
    if (curve)
        bat_fair_range(curve, b->u, half(pressed(c, b), pick.near.distance), b->range);
    else
        b->object = 0;
}

/* The brush moves on along the curve: the stretch grows, in whichever period is nearest. */
static void paint(bat_context *c, smoothing *b) {
    const bat_curve *curve = target(c, b);
    double point[2], domain[2], range[2], r = radius(c);
    bat_near near;
    if (!curve) return;
    bat_stage_seen(c->stage, b->brush.at, point);
    if (!bat_pick_on(c->scene, b->object, b->curve, point, &near) || near.distance > r) return;
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0], turns = 0;
    if (bat_curve_is_closed(curve)) turns = floor((b->u - near.u) / period + 0.5) * period;
    bat_fair_range(curve, near.u, half(pressed(c, b), near.distance), range);
    b->u = near.u + turns;
    b->range[0] = fmin(b->range[0], range[0] + turns);
    b->range[1] = fmax(b->range[1], range[1] + turns);
    if (b->range[1] - b->range[0] > period) b->range[1] = b->range[0] + period;
    b->due = true;
}

static bat_status fair(bat_context *c, smoothing *b, bat_curve **out) {
    double pixel = bat_stage_pixel(c->stage);
    return bat_fair_curve(target(c, b), b->range, c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel,
                          pixel, out);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    smoothing *b = state;
    end(b);
    bat_brush_note(c, &b->brush, event);
    look(c, b);
    b->brush.painting = b->due = true;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    smoothing *b = state;
    if (!b->brush.painting || event->predicted) return;
    bat_brush_note(c, &b->brush, event);
    if (b->object)
        paint(c, b);
    else
        look(c, b); /* the stroke began away from every curve */
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    smoothing *b = state;
    (void)event;
    if (!b->brush.painting) return;
    bat_curve *curve = NULL;
    if (!target(c, b)) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
    } else {
        bat_status status = fair(c, b, &curve);
        if (status == BAT_OK)
            status = bat_commit_curve(c, b->object, b->curve, curve, BAT_STRING_STEP_SMOOTH);
        if (status != BAT_OK) bat_notice_failure(c, status);
    }
    end(b);
}

static bool cancel(bat_context *c, void *state) {
    smoothing *b = state;
    if (!b->brush.painting) return false;
    end(b);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static void update(bat_context *c, void *state) {
    smoothing *b = state;
    if (!b->brush.painting) {
        b->object = 0;
        if (b->brush.hovering) look(c, b);
        return;
    }
    if (!b->due || !target(c, b)) return;
    b->due = false;
    bat_curve_free(b->preview);
    b->preview = NULL;
    fair(c, b, &b->preview); /* if it fails, nothing is shown */
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    smoothing *b = state;
    const bat_curve *curve = target(c, b);
    if (!b->brush.hovering || c->input->holding_pan) return;
    if (curve) {
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
        bat_overlay_stretch(list, curve, b->range[0], b->range[1]);
    }
    if (b->preview) {
        bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, FIT_WIDTH);
        bat_path_curve(&list->path, b->preview);
    }
    bat_brush_show(c, &b->brush, pressed(c, b), list);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    const smoothing *b = state;
    if (b->brush.painting) return BAT_STRING_HINT_BRUSHING;
    return b->object ? BAT_STRING_HINT_BRUSH : BAT_STRING_HINT_SMOOTH_NOTHING;
}

static const char *check(const bat_context *c, const void *state) {
    const smoothing *b = state;
    if (b->preview && !b->brush.painting) return "a preview outlived its brush";
    return bat_brush_check(c, state);
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const smoothing *b = state;
    out->curve = b->preview;
}

static bat_status work(bat_context *c, void *state, const bat_stretch *on) {
    double pixel = bat_stage_pixel(c->stage), limit = c->settings->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel;
    const bat_curve *curve = bat_edit_target_in(c->session->document, 0, on->object, on->curve);
    bat_curve *faired = NULL;
    (void)state;
    if (!curve) return BAT_ARGUMENT;
    bat_status status = bat_fair_curve(curve, on->u, limit, pixel, &faired);
    return status == BAT_OK ? bat_commit_curve(c, on->object, on->curve, faired, BAT_STRING_STEP_SMOOTH)
                            : status;
}

const bat_tool *bat_tool_smooth(void) {
    static const bat_tool tool = {.work = work,
                                  .size = sizeof(smoothing),
                                  .end = end,
                                  .hover = bat_brush_hover,
                                  .leave = bat_brush_leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = bat_brush_busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = bat_brush_cursor,
                                  .readout = readout,
                                  .check = check};
    return &tool;
}
