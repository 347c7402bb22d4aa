/* Calming: a stretch of a curve, or what is selected, is faired with the knots there are. */
#ifndef BATTEN_EDITOR_TOOLS_CALM_H
#define BATTEN_EDITOR_TOOLS_CALM_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include <batten/sketch.h>

/* The stretch within `reach` (along the curve, document units) of u. Closed: it may leave the domain, and is at most
 * a period long. */
void bat_calm_range(const bat_curve *curve, double u, double reach, double range[2]);
/* The smooth brush: fairs the range (closed: in any period) as if a smoothing stroke had run along it; the curve moves by at most `limit` document units. pixel: a view pixel in
 * document units. */
bat_status bat_calm_curve(const bat_curve *curve, const double range[2], double limit, double pixel,
                          bat_curve **out);
/* The command: down shows what would be calmed, up does it. */
bat_status bat_command_calm(bat_context *c, bool down);
void bat_calm_show(bat_context *c, bat_overlay *overlay);

#endif
