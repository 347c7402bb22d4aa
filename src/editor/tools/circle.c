/*
 * The circle through three points: three clicks on the page, which snap; the circle shows from the second one on. Esc drops
 * the points. A press may be dragged to its place.
 *
 * EMPTY --up--> ONE --up--> TWO --up, not on a line--> EMPTY (one step).
 */
#include "base/real.h"
#include "document/document.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/pick/spot.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"
#include "hands/figures/primitive.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double FLAT = 1e-6; /* of the sides' product: less than that, the points lie on a line */

typedef struct circling {
    int count; /* of points that are set */
    bool pressed, there;
    double points[3][3], at[3]; /* document units */
} circling;

static bool locate(bat_context *c, circling *s, const bat_pointer *event) {
    const double pixel[2] = {event->x, event->y};
    s->there = bat_stage_dimension(c->stage) == 2 && bat_spot(c, pixel, 0, NULL, NULL, s->at) == BAT_OK;
    return s->there;
}

static void hover(bat_context *c, void *state, const bat_pointer *event) { locate(c, state, event); }

static void leave(bat_context *c, void *state) {
    (void)c;
    ((circling *)state)->there = false;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    circling *s = state;
    bat_notice(c, BAT_STRING_COUNT);
    if (bat_stage_dimension(c->stage) != 2) {
        bat_notice(c, BAT_STRING_NOTICE_SHAPES_ON_PAGE);
        return;
    }
    if (!locate(c, s, event)) {
        bat_notice_edge_on(c);
        return;
    }
    s->pressed = true;
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    circling *s = state;
    if (s->pressed && !event->predicted) locate(c, s, event);
}

/* The box of the circle through three points. False: they lie on a line. */
static bool find_circle(const double *p, const double *q, const double *r, double box[4], double *radius) {
    const double a[2] = {q[0] - p[0], q[1] - p[1]}, b[2] = {r[0] - p[0], r[1] - p[1]};
    const double aa = a[0] * a[0] + a[1] * a[1], bb = b[0] * b[0] + b[1] * b[1],
                 d = 2 * (a[0] * b[1] - a[1] * b[0]);
    if (!(fabs(d) > FLAT * sqrt(aa) * sqrt(bb))) return false;
    const double x = (b[1] * aa - a[1] * bb) / d, y = (a[0] * bb - b[0] * aa) / d;
    *radius = bat_hypot(x, y);
    const double middle[2] = {p[0] + x, p[1] + y};
    for (int k = 0; k < 2; k++) box[k] = middle[k] - *radius, box[k + 2] = middle[k] + *radius;
    return *radius > 0;
}

static bat_status commit(bat_context *c, const double box[4]) {
    const bat_primitive made = bat_primitive_ellipse(box);
    return bat_primitive_commit(c, &made, BAT_STRING_STEP_CIRCLE);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    circling *s = state;
    double box[4], radius;
    if (!s->pressed) return; /* cancelled */
    locate(c, s, event);
    s->pressed = false;
    memcpy(s->points[s->count], s->at, sizeof s->at);
    if (s->count < 2) {
        s->count++;
        return;
    }
    if (!find_circle(s->points[0], s->points[1], s->points[2], box, &radius)) {
        bat_notice(c, BAT_STRING_NOTICE_CIRCLE_LINE);
        return;
    }
    const bat_status status = commit(c, box);
    if (status == BAT_OK)
        s->count = 0;
    else
        bat_notice_failure(c, status);
}

static bool cancel(bat_context *c, void *state) {
    circling *s = state;
    const bool had = s->pressed || s->count > 0;
    s->pressed = false, s->count = 0;
    if (had) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return had;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const circling *)state)->pressed;
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    const circling *s = state;
    double box[4], radius, domain[2];
    char text[40];
    bat_curve *curve = NULL;
    for (int i = 0; i < s->count; i++) {
        bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
        bat_overlay_mark(list, s->points[i], 4);
    }
    if (s->count < 2 || !s->there || !find_circle(s->points[0], s->points[1], s->at, box, &radius)) return;
    const bat_primitive made = bat_primitive_ellipse(box);
    if (bat_primitive_curve(&made, &curve) != BAT_OK) return;
    (void)c;
    bat_curve_domain(curve, domain);
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2);
    bat_overlay_stretch(list, curve, domain[0], domain[1]);
    bat_curve_free(curve);
    snprintf(text, sizeof text, "r %.4g", radius);
    bat_overlay_label(list, BAT_ROLE_VALUE, s->at, 24, 24, text);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    return ((const circling *)state)->count ? BAT_STRING_HINT_CIRCLE_NEXT : BAT_STRING_HINT_CIRCLE_FIRST;
}

const bat_tool *bat_tool_circle(void) {
    static const bat_tool tool = {.size = sizeof(circling),
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .overlay = overlay,
                                  .hint = hint};
    return &tool;
}
