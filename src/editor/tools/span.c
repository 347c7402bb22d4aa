/*
 * The span tool: marks two points on a picture whose distance the user knows; the property picture-span then scales
 * the picture.
 *
 * IDLE --down near a point, or where there is room for one--> HELD --up--> IDLE; with two points the host is asked to
 * let the user enter the distance. A third press begins anew.
 */
#include "base/real.h"
#include "base/vec.h"
#include "editor/edit/affine.h"
#include "editor/edit/pictures.h"
#include "editor/tools/span.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include "base/matrix.h"
#include <string.h>

typedef struct bat_spanning {
    double at[2][2]; /* on the page, where pictures lie */
    int count;
    int held; /* the one being dragged; -1: none */
} bat_spanning;

static const double REACH = 10, REACH_TOUCH = 22, CROSS = 7; /* px */

static double distance(const bat_spanning *s) {
    return s->count < 2 ? 0 : bat_hypot(s->at[1][0] - s->at[0][0], s->at[1][1] - s->at[0][1]);
}

/* False: the page is seen from its edge; the point stays where it was. */
static bool put(bat_context *c, bat_spanning *s, const bat_pointer *event) {
    return s->held >= 0 && bat_stage_on_page(c->stage, (double[]){event->x, event->y}, s->at[s->held]);
}

/* False: behind the eye. */
static bool pixel_of(const bat_context *c, const double at[2], double pixel[2]) {
    double seen[2];
    if (!bat_stage_look(c->stage, 2, at, seen)) return false;
    bat_stage_project(c->stage, seen, pixel);
    return true;
}

static int place_at(const bat_context *c, const bat_spanning *s, const bat_pointer *event) {
    double within = event->device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH, screen[2];
    for (int i = s->count - 1; i >= 0; i--) {
        if (pixel_of(c, s->at[i], screen) && bat_hypot(screen[0] - event->x, screen[1] - event->y) <= within)
            return i;
    }
    return -1;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_spanning *s = state;
    bat_notice(c, BAT_STRING_COUNT);
    s->held = place_at(c, s, event);
    if (s->held >= 0) return;
    if (s->count == 2) s->count = 0;
    s->held = s->count++;
    if (put(c, s, event)) return;
    s->count--;
    s->held = -1;
    bat_notice_edge_on(c);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_spanning *s = state;
    if (!event->predicted) put(c, s, event);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_spanning *s = state;
    if (s->held < 0) return; /* refused, or cancelled */
    put(c, s, event);
    s->held = -1;
    if (s->count == 2 && memcmp(s->at[0], s->at[1], sizeof s->at[0]) != 0)
        c->notices->requests |= BAT_ASK_SPAN;
}

static bool cancel(bat_context *c, void *state) {
    (void)c;
    bat_spanning *s = state;
    bool any = s->count > 0;
    s->count = 0;
    s->held = -1;
    return any;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_spanning *s = state;
    return s->held >= 0;
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_spanning *s = state;
    double pixel = bat_stage_pixel(c->stage), seen[2][2];
    for (int i = 0; i < s->count; i++)
        if (!bat_stage_look(c->stage, 2, s->at[i], seen[i])) return;
    if (s->count == 2) {
        double middle[2] = {seen[0][0] / 2 + seen[1][0] / 2, seen[0][1] / 2 + seen[1][1] / 2};
        char text[BAT_UNIT_ROOM];
        bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED, 1.5F);
        bat_overlay_polyline(list, 2, seen[0]);
        bat_unit_write(c, distance(s), text);
        bat_overlay_label(list, BAT_ROLE_VALUE, middle, 0, -16, text);
    }
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_STROKED, 1.5F);
    for (int i = 0; i < s->count; i++) {
        bat_overlay_circle(list, seen[i], CROSS * pixel);
        bat_overlay_mark(list, seen[i], pixel);
    }
}

static bat_string hint(const bat_context *c, const void *state) {
    const bat_spanning *s = state;
    return !bat_tracing_count(c->session->document) ? BAT_STRING_NOTICE_NO_PICTURE
           : s->count == 2                          ? BAT_STRING_HINT_SPAN_TYPE
                                                    : BAT_STRING_HINT_SPAN;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    (void)c;
    return BAT_CURSOR_CROSS;
}

static void begin(void *state) { ((bat_spanning *)state)->held = -1; }

const bat_tool *bat_tool_span(void) {
    static const bat_tool tool = {.size = sizeof(bat_spanning),
                                  .begin = begin,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor};
    return &tool;
}

/* ---- the distance as a property ---- */

bat_status bat_span_set(bat_context *c, double value) {
    bat_spanning *s = bat_toolbox_state(c, bat_tool_span());
    double now = distance(s), factor = value / now, matrix[6];
    if (!(now > 0) || !(value > 0)) return BAT_STATE;
    bat_matrix_scaling(factor, factor, s->at[0], matrix);
    bat_status status = bat_tracing_scale(c, matrix);
    for (int k = 0; k < 2 && status == BAT_OK; k++)
        s->at[1][k] = s->at[0][k] + factor * (s->at[1][k] - s->at[0][k]);
    return status;
}

double bat_span_value(const bat_context *c) { return distance(bat_toolbox_state(c, bat_tool_span())); }
