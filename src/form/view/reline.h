/* Internal: a redrawn line on the knots of the line that it replaces. */
#ifndef BATTEN_FORM_RELINE_H
#define BATTEN_FORM_RELINE_H

#include "curve/curve.h"
#include <batten/sketch.h>

/* old: a line in space of degree 3 or more; redrawn: what bat_sketch made of it, with its report. *out: a curve on
 * knots of `old`, and on more of them where these cannot meet the tolerance; knots of `old` that it does not need are left
 * out. Outside the stretch that changed it is the old line. *error: its greatest distance from the redrawn line; more than the tolerance: it could not be met. */
bat_status bat_reline(const bat_curve *old, const bat_curve *redrawn, const bat_sketch_report *report,
                      double tolerance, bat_curve **out, double *error);

#endif
