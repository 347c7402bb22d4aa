/*
 * The shape tools: drag a rectangle, an ellipse or a regular polygon on the page; each is selected, and stays a
 * shape whose numbers can be changed. The first two fill the box of the drag (Shift: of equal sides, Alt: about where it began), the polygon has its
 * middle where the drag began and a corner where it ends (Shift: turned by steps of 15 degrees).
 *
 * IDLE --down--> PRESSED --up--> IDLE (one step). A press that does not move makes a shape of some size there, whose width is then
 * asked for as a number.
 */
#include "base/real.h"
#include "document/document.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/pick/spot.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"
#include "hands/figures/primitive.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double CLICK = 4;   /* px of travel that are no drag */
static const double SHARE = 0.2; /* of the window: how large a click makes a shape */

typedef struct shaping {
    bool pressed;
    double from[3], at[3];   /* document units: at the press; now */
    double start[2], now[2]; /* view pixels */
} shaping;

/* Where that is nowhere on the page, it stays. */
static bat_status locate(bat_context *c, shaping *s, const bat_pointer *event, double at[3]) {
    s->now[0] = event->x;
    s->now[1] = event->y;
    return bat_spot(c, s->now, 0, NULL, NULL, at);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    shaping *s = state;
    bat_notice(c, BAT_STRING_COUNT);
    if (bat_stage_dimension(c->stage) != 2) {
        bat_notice(c, BAT_STRING_NOTICE_SHAPES_ON_PAGE);
        return;
    }
    if (locate(c, s, event, s->from) != BAT_OK) {
        bat_notice_edge_on(c);
        return;
    }
    memcpy(s->at, s->from, sizeof s->at);
    memcpy(s->start, s->now, sizeof s->start);
    s->pressed = true;
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    shaping *s = state;
    if (s->pressed && !event->predicted) locate(c, s, event, s->at);
}

static bool is_drag(const shaping *s) {
    return s->pressed && bat_hypot(s->now[0] - s->start[0], s->now[1] - s->start[1]) > CLICK;
}

/* ---- what the drag means ---- */

static void find_box(const bat_context *c, const shaping *s, double box[4]) {
    double side[2] = {s->at[0] - s->from[0], s->at[1] - s->from[1]};
    if (c->modifiers & BAT_SHIFT) {
        const double most = fmax(fabs(side[0]), fabs(side[1]));
        for (int k = 0; k < 2; k++) side[k] = side[k] < 0 ? -most : most;
    }
    for (int k = 0; k < 2; k++) {
        box[k] = s->from[k] - (c->modifiers & BAT_ALT ? side[k] : 0);
        box[k + 2] = s->from[k] + side[k];
    }
}

static void find_corner(const bat_context *c, const shaping *s, double corner[2]) {
    const double x = s->at[0] - s->from[0], y = s->at[1] - s->from[1];
    memcpy(corner, s->at, 2 * sizeof *corner);
    if (!(c->modifiers & BAT_SHIFT)) return;
    const double radius = bat_hypot(x, y), step = BAT_PI / 12, angle = step * round(bat_atan2(y, x) / step);
    corner[0] = s->from[0] + radius * bat_cos(angle);
    corner[1] = s->from[1] + radius * bat_sin(angle);
}

static bat_primitive make(const bat_context *c, const shaping *s, bat_primitive_kind is) {
    const double *values = c->settings->values;
    double box[4], corner[2];
    if (is == BAT_POLYGON) {
        find_corner(c, s, corner);
        return bat_primitive_polygon(s->from, corner, (int)values[BAT_PROPERTY_POLYGON_SIDES]);
    }
    find_box(c, s, box);
    return is == BAT_ELLIPSE ? bat_primitive_ellipse(box)
                             : bat_primitive_rectangle(box, values[BAT_PROPERTY_CORNER_RADIUS]);
}

static bat_status commit(bat_context *c, const shaping *s, bat_primitive_kind is) {
    static const bat_string labels[] = {BAT_STRING_STEP_RECTANGLE, BAT_STRING_STEP_ELLIPSE,
                                        BAT_STRING_STEP_POLYGON};
    const bat_primitive made = make(c, s, is);
    const bat_status status = bat_primitive_commit(c, &made, labels[is]);
    return status == BAT_COUNT ? BAT_OK : status; /* without a width or a height: nothing was drawn */
}

/* As if the pen had been dragged from the press to the right and down. */
static void spread(const bat_context *c, shaping *s) {
    double size[2];
    bat_stage_window(c->stage, size);
    const double side = SHARE * fmin(size[0], size[1]) * bat_stage_pixel(c->stage);
    for (int k = 0; k < 2; k++) s->at[k] = s->from[k] + side;
}

static void lift(bat_context *c, shaping *s, const bat_pointer *event, bat_primitive_kind is) {
    if (!s->pressed) return; /* cancelled */
    locate(c, s, event, s->at);
    const bool drawn = is_drag(s);
    s->pressed = false;
    if (!drawn) spread(c, s);
    const bat_status status = commit(c, s, is);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else if (!drawn)
        c->notices->requests |= BAT_ASK_SIZE;
}

static bool cancel(bat_context *c, void *state) {
    shaping *s = state;
    const bool had = s->pressed;
    s->pressed = false;
    if (had) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return had;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const shaping *)state)->pressed;
}

/* Numbers beside the pointer: width and height; of a polygon the radius. */
static void show_numbers(const bat_context *c, const shaping *s, bat_primitive_kind is, bat_overlay *list) {
    char text[80];
    double box[4], corner[2];
    if (is == BAT_POLYGON) {
        find_corner(c, s, corner);
        snprintf(text, sizeof text, "%.4g", bat_hypot(corner[0] - s->from[0], corner[1] - s->from[1]));
    } else {
        find_box(c, s, box);
        snprintf(text, sizeof text, "%.4g × %.4g", fabs(box[2] - box[0]), fabs(box[3] - box[1]));
    }
    bat_overlay_label(list, BAT_ROLE_VALUE, s->at, 24, 24, text);
}

static void show(bat_context *c, const shaping *s, bat_primitive_kind is, bat_overlay *list) {
    bat_curve *curve = NULL;
    double domain[2];
    const bat_primitive made = make(c, s, is);
    if (!is_drag(s) || bat_primitive_curve(&made, &curve) != BAT_OK) return;
    bat_curve_domain(curve, domain);
    bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, 2);
    bat_overlay_stretch(list, curve, domain[0], domain[1]);
    bat_curve_free(curve);
    show_numbers(c, s, is, list);
}

/* ---- the three tools ---- */

static void up_rectangle(bat_context *c, void *state, const bat_pointer *event) {
    lift(c, state, event, BAT_RECTANGLE);
}
static void up_ellipse(bat_context *c, void *state, const bat_pointer *event) {
    lift(c, state, event, BAT_ELLIPSE);
}
static void up_polygon(bat_context *c, void *state, const bat_pointer *event) {
    lift(c, state, event, BAT_POLYGON);
}

static void show_rectangle(bat_context *c, void *state, bat_overlay *list) {
    show(c, state, BAT_RECTANGLE, list);
}
static void show_ellipse(bat_context *c, void *state, bat_overlay *list) {
    show(c, state, BAT_ELLIPSE, list);
}
static void show_polygon(bat_context *c, void *state, bat_overlay *list) {
    show(c, state, BAT_POLYGON, list);
}

static bat_string hint_box(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_STRING_HINT_BOX;
}

static bat_string hint_polygon(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_STRING_HINT_POLYGON;
}

#define SHAPE_TOOL(name, hints)                                                                              \
    const bat_tool *bat_tool_##name(void) {                                                                  \
        static const bat_tool tool = {.size = sizeof(shaping),                                               \
                                      .down = down,                                                          \
                                      .move = move,                                                          \
                                      .up = up_##name,                                                       \
                                      .cancel = cancel,                                                      \
                                      .busy = busy,                                                          \
                                      .overlay = show_##name,                                                \
                                      .hint = (hints)};                                                      \
        return &tool;                                                                                        \
    }

SHAPE_TOOL(rectangle, hint_box)
SHAPE_TOOL(ellipse, hint_box)
SHAPE_TOOL(polygon, hint_polygon)
