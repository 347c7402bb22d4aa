/* Internal to the library: derivatives of a curve by arc length at one of its ends, which do not depend on its parameters. */
#ifndef BATTEN_RELATE_END_H
#define BATTEN_RELATE_END_H

#include "base/vec.h"
#include <batten/blend.h>

/* Point, unit tangent, curvature vector, and third derivative by arc length. docs/math/blend.md 1. */
typedef struct bat_curve_end {
    vec at, tangent, bend, rate;
    int known; /* the highest order that exists: 0 or 1 where the speed vanishes */
} bat_curve_end;

/* Of the derivatives by any parameter, the first not zero. */
bat_curve_end bat_curve_end_of(vec at, vec d1, vec d2, vec d3);
/* Of an open curve, as one comes to its end (last), or leaves its start; turned: as one goes the other way. */
bat_curve_end bat_curve_end_at(const bat_curve *curve, bool last, bool turned);
/* Derivatives 1..3 by a parameter in which the speed is s[0], and its derivatives s[1] and s[2]. */
void bat_curve_end_derive(const bat_curve_end *end, const double s[3], vec d[3]);
/* The same curve, clamped, of a degree above the continuity, with so many control points that those of its two ends are apart. */
bat_status bat_curve_end_room(const bat_curve *curve, int continuity, bool last, bat_curve **out);
/* Moves the continuity + 1 control points of that end of a clamped curve so that it has the derivatives d there, d[0] the
 * point. How far they moved at most. */
double bat_curve_end_put(bat_curve *curve, bool last, int continuity, const vec d[BAT_CONTINUITY_MAX + 1]);
/* Whether a factor on the speed at an end is from 1e-3 to 1e3. */
bool bat_curve_end_is_tension(double factor);
/* The options as this version has them, whatever the caller's; NULL: the defaults. BAT_ARGUMENT: one is out of its range. */
bat_status bat_blend_options_read(const bat_blend_options *given, bat_blend_options *own);
/* Whether a and b are open and of one dimension, else what is wrong. */
bat_status bat_ends_check(const bat_curve *a, const bat_curve *b);

#endif
