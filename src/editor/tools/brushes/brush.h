/* What the smooth brush and the eraser have in common: a round reach that follows the pen, wider where it presses. The
 * first member of their states. */
#ifndef BATTEN_EDITOR_TOOLS_BRUSHES_BRUSH_H
#define BATTEN_EDITOR_TOOLS_BRUSHES_BRUSH_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

typedef struct bat_brush {
    bool hovering, painting;
    double at[2];    /* view pixels */
    double pressure; /* what it counts as: a share of the reach */
} bat_brush;

/* The pen is here. */
void bat_brush_note(bat_context *c, bat_brush *brush, const bat_pointer *event);
/* Calls of a tool whose state begins with a brush. */
void bat_brush_hover(bat_context *c, void *state, const bat_pointer *event);
void bat_brush_leave(bat_context *c, void *state);
bool bat_brush_busy(const bat_context *c, const void *state);
bat_cursor bat_brush_cursor(const bat_context *c, const void *state);
/* NULL, or what does not hold: who paints has a pen on the paper. */
const char *bat_brush_check(const bat_context *c, const void *state);
/* The circle of the reach, in document units. */
void bat_brush_show(const bat_context *c, const bat_brush *brush, double reach, bat_overlay *list);

#endif
