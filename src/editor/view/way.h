/* How far a drag moves what it has grabbed. */
#ifndef BATTEN_EDITOR_VIEW_WAY_H
#define BATTEN_EDITOR_VIEW_WAY_H

#include "editor/view/stage.h"

/* From one pixel to another, for a point of the curve or of its polygon: on the page for a curve of the page; in space
 * parallel to the curve's own plane, or across the gaze, when it has none or that is seen at less than 15 degrees. rise:
 * along the normal of that plane, or of the curve's best plane, instead. way: of the curve's dimension, the rest 0. False:
 * the pen cannot tell, since the page or the normal is seen from its edge, or a curve of the page cannot rise. */
bool bat_stage_way(const bat_stage *stage, const bat_curve *curve, const double from[2], const double to[2],
                   bool rise, double way[3]);

/* The same for a point of such a curve, in a plane with this normal, of length 1; a normal of no length: across the
 * gaze. Exact in perspective, too. */
bool bat_stage_way_in(const bat_stage *stage, int dimension, const double normal[3], const double place[3],
                      const double from[2], const double to[2], bool rise, double way[3]);

/* From a point of that dimension to what the pen, at a pixel, points at in the plane through the point. */
bool bat_stage_aim(const bat_stage *stage, int dimension, const double normal[3], const double *at,
                   const double pixel[2], double way[3]);

/* Turns a normal away from the eye; one of no length becomes the gaze. */
void bat_stage_turn_away(const bat_stage *stage, double normal[3]);

#endif
