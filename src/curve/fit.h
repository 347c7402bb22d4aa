/* Inside the library: the fit for points that are known to be no spline's, or whose spline is at hand. */
#ifndef BATTEN_CURVE_FIT_H
#define BATTEN_CURVE_FIT_H

#include <batten/fit.h>

/* bat_fit without the search for the pieces of a spline whose parameters are unknown, which takes some milliseconds. */
bat_status bat_fit_plain(int dimension, size_t count, const double *points, const bat_fit_options *options,
                         bat_curve **out, bat_fit_report *report);

#endif
