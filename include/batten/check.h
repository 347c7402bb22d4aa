/*
 * Batten: why numbers are refused. What makes a curve or a surface gives a status; these calls take the same arguments, and a problem
 * in place of the result, and say what is wrong: its place names the argument and the index ("knots[7]", "points[2][0]"), its message
 * what was expected and what was found. They are for after a refusal, and for programs that ask first.
 */
#ifndef BATTEN_CHECK_H
#define BATTEN_CHECK_H

#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The status of bat_curve_create for these arguments; problem (may be NULL) is filled in unless it is BAT_OK. O(count). One of the arrays NULL: BAT_ARGUMENT. */
BAT_API bat_status bat_curve_check(int dimension, int degree, bool closed, size_t count, const double *points,
                                   int knot_count, const double *knots, bat_problem *problem);
/* The same for bat_curve_create_clamped. */
BAT_API bat_status bat_curve_clamped_check(int dimension, int degree, size_t count, const double *points,
                                           bat_problem *problem);
/* The same for bat_surface_create: "u_knots[3]", "points[1][2][0]" of row 1. */
BAT_API bat_status bat_surface_check(const int degree[2], const bool closed[2], const size_t count[2],
                                     const double *points, const int knot_count[2], const double *u_knots,
                                     const double *v_knots, bat_problem *problem);

#ifdef __cplusplus
}
#endif
#endif
