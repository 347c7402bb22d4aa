/* What the smooth brush and the eraser have in common: a circle that follows the pen, larger where the pen presses
 * harder. The first member of both states. */
#ifndef BATTEN_EDITOR_TOOLS_BRUSHES_BRUSH_H
#define BATTEN_EDITOR_TOOLS_BRUSHES_BRUSH_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

typedef struct bat_brush {
    bool hovering, painting;
    double at[2];    /* view pixels */
    double pressure; /* as a factor on the reach */
} bat_brush;

/* Records where the pen is. */
void bat_brush_note(bat_context *c, bat_brush *brush, const bat_pointer *event);
/* Functions for a tool whose state begins with a brush. */
void bat_brush_hover(bat_context *c, void *state, const bat_pointer *event);
void bat_brush_leave(bat_context *c, void *state);
bool bat_brush_busy(const bat_context *c, const void *state);
bat_cursor bat_brush_cursor(const bat_context *c, const void *state);
/* NULL, or the invariant that does not hold: while painting, the pen is on the paper. */
const char *bat_brush_check(const bat_context *c, const void *state);
/* Shows the circle; reach: its radius in document units. */
void bat_brush_show(const bat_context *c, const bat_brush *brush, double reach, bat_overlay *list);

#endif
