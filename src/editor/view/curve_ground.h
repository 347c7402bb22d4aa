/* What a redraw of a curve lands on. */
#ifndef BATTEN_EDITOR_VIEW_CURVE_GROUND_H
#define BATTEN_EDITOR_VIEW_CURVE_GROUND_H

#include "editor/view/stage.h"

/* The normal of the curve's plane, or best plane, of length 1; of a straight curve some direction across it. Whether the
 * curve is planar and not straight. */
bool bat_curve_normal(const bat_curve *curve, double normal[3]);

/* The plane of a planar curve; false: it has none of its own, since it is not planar, or straight. */
bool bat_ground_of_planar(const bat_curve *curve, bat_ground *out);

/* The ground of a stroke over a curve in space, of the document: the curve's own plane; for a straight curve the plane in use, if it lies there; and for what is not planar, or seen at less than 15 degrees,
 * its ruled surface, which then runs along the normal of its best plane, or if that is seen from its edge, across the
 * gaze. */
bat_ground bat_ground_of_curve(const bat_stage *stage, bat_id object, int index, const bat_curve *curve);

/* The ruled surface of a curve: the curve moved by `tall` to both sides along a direction, as a closed polyline of
 * 2 BAT_RULED_POINTS points in space. */
enum { BAT_RULED_POINTS = 49 };
void bat_ruled_outline(const bat_curve *curve, const double along[3], double tall, double *points);

#endif
