/*
 * Seeing the shape, whatever the tool: curvature comb with inflections, knots, length. Shown on the curve under the
 * pen, which stays shown until the pen is at another; on the fit while one is drawn.
 */
#ifndef BATTEN_EDITOR_SHOW_INSPECT_H
#define BATTEN_EDITOR_SHOW_INSPECT_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/view/stage.h"

typedef struct bat_insight {
    bat_id object; /* 0: none yet */
    int curve;
} bat_insight;

/* Teeth along the normals, their length in proportion to the curvature, scaled so that the usual ones can be read at
 * this zoom; a line through their ends; marks on the inflections. Planar curves. */
void bat_comb_show(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage);
/* Once a frame, before the overlay of the tool. */
void bat_insight_show(bat_context *c, const bat_curve *made,
                      bat_overlay *overlay); /* made: what is under way; or NULL */

#endif
