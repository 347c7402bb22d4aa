/* The zoom tool: a click zooms in, with Alt out; a dragged rectangle is zoomed to fill the window. The document never
 * changes. */
#include "base/vec.h"
#include "editor/scene/path.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <math.h>

/* While the pointer is down; view pixels. */
typedef struct bat_zooming {
    bool down;
    double start[2], at[2];
} bat_zooming;

#define CLICK 5.0 /* pixels of travel that still count as a click */
#define STEP 2.0  /* zoom factor of a click */

static bool away(const bat_context *c) { return c->modifiers & BAT_ALT; }

static bool drawn(const bat_zooming *z) {
    return z->down && bat_hypot(z->at[0] - z->start[0], z->at[1] - z->start[1]) > CLICK;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)c;
    bat_zooming *z = state;
    z->down = true;
    z->start[0] = z->at[0] = event->x;
    z->start[1] = z->at[1] = event->y;
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    (void)c;
    bat_zooming *z = state;
    if (event->predicted) return;
    z->at[0] = event->x;
    z->at[1] = event->y;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_zooming *z = state;
    bat_stage *stage = c->stage;
    double window[2], centre[2];
    if (!z->down) return; /* cancelled */
    move(c, z, event);
    bat_stage_window(stage, window);
    bat_stage_middle(stage, centre);
    if (drawn(z) && window[0] > 0 && window[1] > 0) {
        double size[2] = {fabs(z->at[0] - z->start[0]), fabs(z->at[1] - z->start[1])};
        double middle[2] = {(z->at[0] + z->start[0]) / 2, (z->at[1] + z->start[1]) / 2};
        /* One side exceeds CLICK / sqrt(2), so the factor is finite. */
        double factor = fmin(window[0] / fmax(size[0], 1e-3), window[1] / fmax(size[1], 1e-3));
        bat_stage_pan(stage, middle, centre);
        bat_stage_zoom(stage, centre, away(c) ? 1 / factor : factor);
    } else {
        bat_stage_zoom(stage, z->at, away(c) ? 1 / STEP : STEP);
    }
    z->down = false;
}

static bool cancel(bat_context *c, void *state) {
    (void)c;
    bat_zooming *z = state;
    bool had = z->down;
    z->down = false;
    return had;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_zooming *z = state;
    return z->down;
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_zooming *z = state;
    if (!drawn(z)) return;
    bat_overlay_item(list, BAT_ROLE_MARQUEE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    bat_overlay_window_box(list, c->stage, z->start, z->at);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    const bat_zooming *z = state;
    return drawn(z) ? BAT_STRING_HINT_ZOOMING : BAT_STRING_HINT_ZOOM;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    return away(c) ? BAT_CURSOR_ZOOM_OUT : BAT_CURSOR_ZOOM_IN;
}

const bat_tool *bat_tool_zoom(void) {
    static const bat_tool tool = {.size = sizeof(bat_zooming),
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
