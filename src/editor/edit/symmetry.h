/* Symmetry as a setting: its axis, and which steps are mirrored (mirror.h). */
#ifndef BATTEN_EDITOR_EDIT_SYMMETRY_H
#define BATTEN_EDITOR_EDIT_SYMMETRY_H

#include "curve/mirror.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* The axis in force: the session's, or else the vertical through the middle of the page; without a page, the vertical
 * through the middle of the drawing, or of the window when the drawing is empty, which is then kept for the session.
 * Off: symmetry is off, or the pen draws on something other than the page. */
bat_mirror bat_symmetry(bat_context *c);
/* The same for surfaces, for which the axis stands for the upright plane through it: whatever the pen draws on. */
bat_mirror bat_symmetry_plane(bat_context *c);
/* The axis, whether or not symmetry is on. */
bat_mirror bat_symmetry_axis(bat_context *c);
/* The line through both ends of a planar curve, if it is straight between them, but for `within`. */
bool bat_symmetry_line(const bat_curve *curve, double within, bat_mirror *out);
/* Before a tool's step is committed: mirrors what it changes, if steps of its kind are mirrored. Strokes of the
 * sketch tool state this themselves (stroke.h). */
bat_status bat_symmetry_finish(bat_context *c, bat_string label);

#endif
