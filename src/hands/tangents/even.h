/* Inside: splines of even curvature (math 1.5). Points are those that count: each differs from the one before. */
#ifndef BATTEN_SRC_EVEN_H
#define BATTEN_SRC_EVEN_H

#include "hands/tangents/spline.h"

/* Whether this is what the mode makes: a loop of two points, which has no even curvature, is the oval of math 1.4. */
bool bat_even_applies(const bat_tangents_options *options, bool closed, int count);
/* How many pieces: cubic segments, and spans of the B-spline. */
int bat_even_pieces(bool closed, int count);
/* keep: indices of the count points. Fills their joints, and 4 * dimension doubles for each piece. *out (may be NULL): one
 * quadratic B-spline. */
bat_status bat_even(const bat_spline *spline, const int *keep, int count, bat_joint *joints, double *bezier,
                    bat_curve **out);

#endif
