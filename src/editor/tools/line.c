/*
 * The line tool: drag to draw a straight line on the page, or on what the pen draws on instead. Shift constrains it to
 * steps of 15 degrees. Each further drag or click
 * continues from the end of the last line, in the same curve, with a corner there; a click on that end, or Esc,
 * finishes it.
 *
 * IDLE --down--> PRESSED --up, moved--> ON --down, up--> ON ... --Esc--> IDLE. A click in IDLE places the first
 * point.
 */
#include "base/real.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/pick/spot.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/disc.h"
#include "editor/show/overlay.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CLICK = 5; /* px of travel that still count as a click */

typedef struct lining {
    bool placed;             /* there is a point to continue from */
    bool hovering;           /* `at` is where the next line would end */
    bool pressed;            /* between down and up */
    bool began;              /* this press has placed the first point */
    bat_id object;           /* the curve being continued; 0: none yet */
    int dimension;           /* of the curve, and of these places; the rest of them is 0 */
    double from[3], at[3];   /* document units */
    double start[2], now[2]; /* view pixels: at the press; now */
} lining;

/* The curve being continued, as long as it ends where the last line did: undo or another tool may have changed it. A
 * curve of the page goes on on the page only. */
static const bat_curve *settle(const bat_context *c, lining *l) {
    const bool leaves = l->dimension == 2 && bat_stage_dimension(c->stage) != 2;
    if (!l->object) {
        if (leaves || !l->placed) l->dimension = bat_stage_dimension(c->stage);
        return NULL;
    }
    const bat_curve *curve = bat_edit_target_in(c->session->document, l->dimension, l->object, 0);
    bool good = curve && !leaves && !bat_curve_is_closed(curve) && bat_curve_degree(curve) == 3;
    if (good)
        good = !memcmp(bat_curve_points(curve) + l->dimension * (bat_point_count(curve) - 1), l->from,
                       (size_t)l->dimension * sizeof *l->from);
    if (good) return curve;
    l->object = 0;
    l->placed = l->pressed = false;
    l->dimension = bat_stage_dimension(c->stage);
    return NULL;
}

/* Where the pen is; it stays where it was when that is nowhere on the ground. */
static bat_status place(bat_context *c, lining *l, const bat_pointer *event) {
    l->now[0] = event->x;
    l->now[1] = event->y;
    return bat_spot(c, l->now, 0, NULL, l->placed ? l->from : NULL, l->at);
}

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    lining *l = state;
    settle(c, l);
    l->hovering = place(c, l, event) == BAT_OK;
}

static void leave(bat_context *c, void *state) {
    (void)c;
    ((lining *)state)->hovering = false;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    lining *l = state;
    settle(c, l);
    bat_notice(c, BAT_STRING_COUNT);
    if (place(c, l, event) != BAT_OK) {
        bat_notice_edge_on(c);
        return;
    }
    l->began = !l->placed;
    l->pressed = l->placed = true;
    if (l->began) memcpy(l->from, l->at, sizeof l->from);
    memcpy(l->start, l->now, sizeof l->start);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    lining *l = state;
    if (l->pressed && !event->predicted) place(c, l, event);
}

/* Extends the curve (or nothing) by a straight piece: knot spacing equal to its length, a triple knot at the corner. */
static bat_status straight(const bat_curve *before, int dimension, const double from[3], const double to[3],
                           bat_curve **out) {
    const size_t size = (size_t)dimension;
    int old = before ? bat_point_count(before) : 1, count = old + 3;
    double length = bat_hypot(to[0] - from[0], to[1] - from[1]), last = 0;
    if (dimension == 3) length = bat_hypot(length, to[2] - from[2]);
    double *points = malloc((size_t)count * size * sizeof *points);
    double *knots = malloc((size_t)(count + 4) * sizeof *knots);
    bat_status status = points && knots ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        if (before) {
            memcpy(points, bat_curve_points(before), (size_t)old * size * sizeof *points);
            memcpy(knots, bat_curve_knots(before), (size_t)(old + 3) * sizeof *knots);
            last = knots[old + 2];
        } else {
            memcpy(points, from, size * sizeof *points);
            memset(knots, 0, 4 * sizeof *knots);
        }
        for (int i = 1; i <= 3; i++)
            for (int k = 0; k < dimension; k++)
                points[dimension * (old - 1 + i) + k] = from[k] + (to[k] - from[k]) * i / 3;
        memcpy(points + dimension * (count - 1), to, size * sizeof *points);
        for (int i = 0; i < 4; i++) knots[count + i] = last + length;
        status = bat_curve_create(dimension, 3, false, (size_t)count, points, count + 4, knots, out);
    }
    free(points);
    free(knots);
    return status;
}

static bat_status commit(bat_context *c, lining *l) {
    bat_curve *curve = NULL;
    bat_status status = straight(settle(c, l), l->dimension, l->from, l->at, &curve);
    if (status != BAT_OK) return status;
    if (l->object) return bat_commit_curve(c, l->object, 0, curve, BAT_STRING_STEP_LINE);
    return bat_commit_new_curve(c, curve, BAT_STRING_STEP_LINE, &l->object);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    lining *l = state;
    if (!l->pressed) return; /* cancelled */
    place(c, l, event);
    l->pressed = false;
    bool clicked = bat_hypot(l->now[0] - l->start[0], l->now[1] - l->start[1]) <= CLICK;
    if (clicked && l->began) return; /* this click has placed the first point */
    if (bat_spots_apart(c, l->dimension, l->from, l->at) <= CLICK) {
        l->placed = false; /* a click on the end finishes the curve */
        l->object = 0;
        return;
    }
    bat_status status = commit(c, l);
    if (status == BAT_OK)
        memcpy(l->from, l->at, sizeof l->from);
    else
        bat_notice_failure(c, status);
}

/* Cancels a press first, then finishes the line. */
static bool cancel(bat_context *c, void *state) {
    lining *l = state;
    bool had = l->placed;
    (void)c;
    if (l->pressed && !l->began) {
        l->pressed = false;
        return true;
    }
    l->pressed = l->placed = false;
    l->object = 0;
    return had;
}

/* Before undo: drops only what is not in the document yet. */
static bool undo(bat_context *c, void *state) {
    lining *l = state;
    return (l->pressed || !l->object) && cancel(c, state);
}

static bool accept(bat_context *c, void *state) { return cancel(c, state); }

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const lining *)state)->pressed;
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const lining *l = state;
    out->goes_on = l->placed && !l->pressed;
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    lining *l = state;
    settle(c, l);
    if (l->hovering && !l->pressed) bat_disc_show(c->stage, l->now, list);
    if (!l->placed) return;
    double pixel = bat_stage_pixel(c->stage), seen[4];
    if (!bat_stage_look(c->stage, l->dimension, l->from, seen) ||
        !bat_stage_look(c->stage, l->dimension, l->at, seen + 2))
        return;
    if (l->pressed || l->hovering) {
        bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2);
        bat_overlay_polyline(list, 2, seen);
    }
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 2);
    bat_overlay_circle(list, seen, 4 * pixel);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    return ((const lining *)state)->placed ? BAT_STRING_HINT_LINE_ON : BAT_STRING_HINT_LINE;
}

static const char *check(const bat_context *c, const void *state) {
    const lining *l = state;
    (void)c;
    if (l->object && !l->placed) return "a line goes on from nowhere";
    return l->pressed && !l->placed ? "a line is drawn from nowhere" : NULL;
}

const bat_tool *bat_tool_line(void) {
    static const bat_tool tool = {.size = sizeof(lining),
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .undo = undo,
                                  .accept = accept,
                                  .busy = busy,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .readout = readout,
                                  .check = check};
    return &tool;
}
