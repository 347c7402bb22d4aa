/*
 * Inspecting the shape, in any tool: curvature comb with inflections, knots, length. Shown for the curve under the
 * pen, and kept until the pen is at another; for the fit while one is being drawn.
 */
#ifndef BATTEN_EDITOR_SHOW_INSPECT_H
#define BATTEN_EDITOR_SHOW_INSPECT_H

#include "editor/session/context.h"
#include "editor/show/deviate.h"
#include "editor/show/overlay.h"
#include "editor/view/stage.h"

typedef struct bat_insight {
    bat_id object; /* 0: none yet */
    int curve;
    bat_deviating deviating;
} bat_insight;

/* Teeth along the normals, their length proportional to the curvature, scaled so that typical ones are readable at
 * this zoom; a line through their ends; marks on the inflections of planar curves. In space along the principal normals, as they are seen. */
void bat_comb_show(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage);
/* Once per frame, before the overlay of the tool. made: the curve under way, or NULL. */
void bat_insight_show(bat_context *c, const bat_curve *made, bat_overlay *overlay);

#endif
