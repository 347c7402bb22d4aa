/* Functions of one parameter: the first coordinate of a curve, or a number. */
#include "curve/function.h"
#include "curve/curve.h"
#include "text/json.h"

#include <math.h>

bat_status bat_function_check(const bat_function *function, bat_problem *problem) {
    double domain[2] = {0, 1};
    if (!function)
        return bat_problem_set(problem, BAT_ARGUMENT, "function", "expected a function, found none");
    if (function->curve)
        bat_curve_domain(function->curve, domain);
    else if (bat_problem_outside(problem, "constant", 0, -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX,
                                 function->constant))
        return BAT_NUMBER;
    for (size_t i = 0; i < 2; i++)
        if (bat_problem_outside(problem, "domain[%zu]", i, (double)i, (double)i, domain[i]))
            return BAT_PARAMETER;
    return BAT_OK;
}

void bat_function_eval(const bat_function *function, double x, double out[3]) {
    double jet[3 * BAT_DIMENSION_MAX];
    out[0] = function->constant;
    out[1] = out[2] = 0;
    if (!function->curve) return;
    bat_curve_eval(function->curve, x, 2, jet);
    for (int k = 0; k < 3; k++) out[k] = jet[k * function->curve->dimension];
}

bat_status bat_function_copy(const bat_function *from, bat_function *to) {
    *to = bat_function_of(from->constant);
    return from->curve ? bat_curve_copy(from->curve, &to->curve) : BAT_OK;
}

void bat_function_clear(bat_function *function) {
    if (!function) return;
    bat_curve_free(function->curve);
    *function = bat_function_of(0);
}
