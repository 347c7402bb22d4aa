/*
 * The span tool: two places on a picture whose distance the user knows; the property picture-span then scales it.
 *
 * IDLE --down near a place, or where there is room for one--> HELD --up--> IDLE; with two places the host is asked to
 * let the distance be typed. A third press begins anew.
 */
#include "base/real.h"
#include "editor/editor.h"
#include "editor/view/unit.h"
#include <string.h>

static const double REACH = 10, REACH_TOUCH = 22, CROSS = 7; /* px */

static void put(bat_editor *editor, const bat_pointer *event) {
    bat_spanning *s = &editor->spanning;
    if (s->held >= 0) bat_view_to_document(&editor->view, (double[]){event->x, event->y}, s->at[s->held]);
}

static int place_at(const bat_editor *editor, const bat_pointer *event) {
    const bat_spanning *s = &editor->spanning;
    double within = event->device == BAT_DEVICE_TOUCH ? REACH_TOUCH : REACH, screen[2];
    for (int i = s->count - 1; i >= 0; i--) {
        bat_view_to_screen(&editor->view, s->at[i], screen);
        if (bat_hypot(screen[0] - event->x, screen[1] - event->y) <= within) return i;
    }
    return -1;
}

static void down(bat_editor *editor, const bat_pointer *event) {
    bat_spanning *s = &editor->spanning;
    bat_editor_notice(editor, BAT_STRING_COUNT);
    s->held = place_at(editor, event);
    if (s->held >= 0) return;
    if (s->count == 2) s->count = 0;
    s->held = s->count++;
    put(editor, event);
}

static void move(bat_editor *editor, const bat_pointer *event) {
    if (!event->predicted) put(editor, event);
}

static void up(bat_editor *editor, const bat_pointer *event) {
    bat_spanning *s = &editor->spanning;
    put(editor, event);
    s->held = -1;
    if (s->count == 2 && memcmp(s->at[0], s->at[1], sizeof s->at[0]) != 0) editor->requests |= BAT_ASK_SPAN;
}

static bool cancel(bat_editor *editor) {
    bat_spanning *s = &editor->spanning;
    bool any = s->count > 0;
    s->count = 0;
    s->held = -1;
    return any;
}

static bool busy(const bat_editor *editor) { return editor->spanning.held >= 0; }

static void overlay(bat_editor *editor, bat_overlay *list) {
    const bat_spanning *s = &editor->spanning;
    double pixel = bat_view_pixel(&editor->view);
    if (s->count == 2) {
        double middle[2] = {s->at[0][0] / 2 + s->at[1][0] / 2, s->at[0][1] / 2 + s->at[1][1] / 2};
        char text[BAT_UNIT_ROOM];
        bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED, 1.5F);
        bat_overlay_polyline(list, 2, s->at[0]);
        bat_unit_write(editor, bat_tracing_value(editor, BAT_PROPERTY_PICTURE_SPAN), text);
        bat_overlay_label(list, BAT_ROLE_VALUE, middle, 0, -16, text);
    }
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_STROKED, 1.5F);
    for (int i = 0; i < s->count; i++) {
        bat_overlay_circle(list, s->at[i], CROSS * pixel);
        bat_overlay_mark(list, s->at[i], pixel);
    }
}

static bat_string hint(const bat_editor *editor) {
    return !bat_tracing_count(editor->document) ? BAT_STRING_NOTICE_NO_PICTURE
           : editor->spanning.count == 2        ? BAT_STRING_HINT_SPAN_TYPE
                                                : BAT_STRING_HINT_SPAN;
}

static bat_cursor cursor(const bat_editor *editor) {
    (void)editor;
    return BAT_CURSOR_CROSS;
}

const bat_tool *bat_tool_span(void) {
    static const bat_tool tool = {.down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor};
    return &tool;
}
