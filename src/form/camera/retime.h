/* Internal: a stretch of a timing redrawn by the sketch hand's fit. */
#ifndef BATTEN_FORM_RETIME_H
#define BATTEN_FORM_RETIME_H

#include <batten/curve.h>

/* Distance over time, of the last part of a stroke that is there at that time. */
double bat_stroke_height(size_t count, const double *points, double time);
/*
 * The timing, which is open and clamped, with the stretch low..high redrawn by few knots; *out: the caller's. NULL: the fit
 * can not be made ascending within a few pixels of the stroke, or the stretch is too short for one.
 */
bat_status bat_timing_fit(const bat_curve *timing, size_t count, const double *points, double low,
                          double high, bat_curve **out);

#endif
