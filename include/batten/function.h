/*
 * Batten: functions of one parameter, such as the twist and scale of a sweep. A number, or a B-spline over [0, 1]; the
 * argument is the host's domain mapped to [0, 1].
 */
#ifndef BATTEN_FUNCTION_H
#define BATTEN_FUNCTION_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The values are the first coordinate of the curve, whose domain is [0, 1]; without a curve the constant. Borrowed by
 * the calls that take a function; bat_function_clear frees the curve of one that was read (format.h). */
typedef struct bat_function {
    double constant;
    bat_curve *curve;
} bat_function;

static inline bat_function bat_function_of(double constant) {
    bat_function function = {constant, NULL};
    return function;
}
/* BAT_NUMBER: the constant is not finite or beyond BAT_COORDINATE_MAX; BAT_PARAMETER: the domain is not [0, 1].
 * problem (may be NULL) says what is wrong. */
BAT_API bat_status bat_function_check(const bat_function *function, bat_problem *problem);
/* The value and the first two derivatives at x, as bat_curve_eval: out[3]. */
BAT_API void bat_function_eval(const bat_function *function, double x, double out[3]);
BAT_API void bat_function_clear(bat_function *function);

#ifdef __cplusplus
}
#endif
#endif
