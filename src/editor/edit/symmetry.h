/* Symmetry as a setting: its axis, and which steps are mirrored (mirror.h). */
#ifndef BATTEN_EDITOR_EDIT_SYMMETRY_H
#define BATTEN_EDITOR_EDIT_SYMMETRY_H

#include "curve/mirror.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* The axis in force: that of the session, else upright through the middle of the page; without a page through the middle
 * of the drawing, or of the window when it is empty, and kept for the session from then on. Off: symmetry is off, or the
 * pen draws on something else than the page. */
bat_mirror bat_symmetry(bat_context *c);
/* Before a step of a tool is committed: mirrors what it changes, if its kind is mirrored. Strokes of the sketch tool say
 * so themselves (stroke.h). */
bat_status bat_symmetry_finish(bat_context *c, bat_string label);

#endif
