/* Inside: a point put on a spline of even curvature. */
#ifndef BATTEN_SRC_EVEN_INSERT_H
#define BATTEN_SRC_EVEN_INSERT_H

#include <batten/tangents.h>

/* bat_tangents_insert where the mode is EVEN. */
bat_status bat_even_insert(const bat_spline *spline, int segment, double t,
                           const bat_tangents_options *options, bat_spline *out, void **block, int *index,
                           double *deviation);

#endif
