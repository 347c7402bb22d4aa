/* The gizmo as it is seen. */
#ifndef BATTEN_EDITOR_SHOW_GIZMO_H
#define BATTEN_EDITOR_SHOW_GIZMO_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/view/gizmo.h"

/* over: the part under the pen, thicker; BAT_GIZMO_NONE: none. */
void bat_gizmo_show(const bat_context *c, const bat_gizmo *gizmo, int over, bat_overlay *overlay);
/* While a part is dragged: that alone, the lines that it is kept to, and in words and numbers how far it has come. */
void bat_gizmo_show_drag(const bat_context *c, const bat_gizmo *gizmo, int part, const double by[3],
                         bat_overlay *overlay);

#endif
