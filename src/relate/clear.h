/* Inside the room: where a parallel is sure to be no nearer to its curve than its distance, so that nobody need measure. */
#ifndef BATTEN_SRC_RELATE_CLEAR_H
#define BATTEN_SRC_RELATE_CLEAR_H

#include "relate/brim.h"

#include <batten/curve.h>
#include <batten/nearest.h>

typedef struct bat_clearance bat_clearance;

/* Of a planar curve at a distance (> 0), to both sides. brim: NULL, or how corners and ends of an outline are formed,
 * sorted; it is not kept. */
bat_status bat_clearance_create(const bat_curve *curve, double distance, double tolerance,
                                const bat_brim *brim, bat_clearance **out);
/* Whether all of a raw parallel within `radius` of `centre`, one of its places, is outside but for the tolerance. foot: the
 * place of the curve nearest to the centre. false: it may be or not. O(log n), but for the few stretches around the foot. */
bool bat_clearance_holds(const bat_clearance *clearance, const double *centre, double radius,
                         const bat_near *foot);
void bat_clearance_free(bat_clearance *clearance);

#endif
