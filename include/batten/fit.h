/* Batten: least-squares fit of points to a tolerance in real distance. */
#ifndef BATTEN_FIT_H
#define BATTEN_FIT_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bat_fit_options {
    size_t size;      /* of this struct, as base.h says */
    double tolerance; /* greatest true distance from a point to the curve, document units, > 0 */
    double
        smoothing; /* shortest wavelength that may bend, document units; 0: none (docs/math/sketch.md 5.7) */
    int degree;    /* 3 by default */
    bool closed;
    bool hold_ends;      /* open: the curve meets the first and the last point exactly */
    int solves_max;      /* 0: the default budget */
    size_t corner_count; /* corners[i]: indices into the points, ascending, kept as multiplicity-p knots */
    const int *corners;
} bat_fit_options;

typedef struct bat_fit_report {
    double max_error; /* true distance */
    int knots;        /* interior knots (closed: knots of one period) */
    int solves;
} bat_fit_report;

/* Tolerance 1, cubic, open, no corners. */
BAT_API void bat_fit_options_init(bat_fit_options *options, size_t size);
static inline bat_fit_options bat_fit_defaults(void) {
    bat_fit_options options;
    bat_fit_options_init(&options, sizeof options);
    return options;
}
/* Fits count points in order, in document units; *out is the caller's; report may be NULL; options may be NULL.
 * Points sampled from a spline of this degree take no more spans than it has, whatever their parameters were (with exceptions
 * and limits in docs/math/sketch.md 5.7). BAT_COUNT: only one point, or all points coincide. Two points give a line. BAT_TOLERANCE: the best curve found
 * is handed over. */
BAT_API bat_status bat_fit(int dimension, size_t count, const double *points, const bat_fit_options *options,
                           bat_curve **out, bat_fit_report *report);

/*
 * Fits the curve again, with the same degree and as few knots as keep it within tolerance (0: only removals that
 * change nothing); corners (knots of multiplicity p at which the tangent turns by more than corner radians) and ends
 * stay. The parametrisation is new.
 * *error (may be NULL): the distance, measured both ways. Where a fit of samples of the curve has no fewer points
 * than bat_curve_simplify gives, the result is that of bat_curve_simplify.
 */
BAT_API bat_status bat_curve_refit(const bat_curve *curve, double tolerance, double corner, bat_curve **out,
                                   double *error);
/*
 * Covers the curve with as few cubics as keep it within tolerance, as path editors count: their joints lie on the curve
 * and have its tangent, and no more than that (G1). The result is cubic, with knots of multiplicity two: about two
 * points a cubic (of multiplicity three where the speed would change too much, as in bat_curve_from_bezier). Corners
 * (joints at which the tangent turns by more than corner radians) and ends stay. *error (may be NULL): the distance,
 * measured both ways. A curve of degree 3 or less that bat_curve_simplify gives as few spans becomes what that gives;
 * with tolerance 0 every curve does.
 */
BAT_API bat_status bat_curve_refit_g1(const bat_curve *curve, double tolerance, double corner,
                                      bat_curve **out, double *error);

/*
 * Covers a planar curve with cubics as type designers do: their joints are its extremes, with level and upright handles to the bit, its
 * corners (as above) and its ends; where one cubic between two of those cannot come within the tolerance (> 0), further joints
 * are put between, on the curve and along it. Extremes that stand out by no more than the tolerance are none. grid above 0: all
 * control points are multiples of it (1: whole numbers; those of straight pieces only at their ends), which moves them by
 * another 0.71 grids at most. The result has knots of multiplicity three. *error (may be NULL): the distance, measured both
 * ways. BAT_ARGUMENT, BAT_DIMENSION: not planar; BAT_COUNT: smaller than the tolerance or the grid. Cost: O(count), and
 * O(extremes^2) where many are too small.
 */
BAT_API bat_status bat_curve_refit_extremes(const bat_curve *curve, double tolerance, double corner,
                                            double grid, bat_curve **out, double *error);

#ifdef __cplusplus
}
#endif
#endif
