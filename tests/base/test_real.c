/* The elementary functions against long double libm over their ranges, in units in the last place; special values as in
 * C17 annex F. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include "base/real.h"

static uint64_t seed = 42;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(seed >> 11) * 0x1p-53);
}

/* Error of value in units in the last place of scale (or of the exact value, when scale is 0). */
static double ulps(double value, long double exact, double scale) {
    double at = scale > 0 ? scale : fabs((double)exact);
    return (double)fabsl((long double)value - exact) / (nextafter(at, INFINITY) - at);
}

enum { samples = 100000 };

typedef double function(double);
typedef long double oracle(long double);

static void sweep(const char *name, function *f, oracle *g, double low, double high, double scale,
                  double bound) {
    double worst = 0, where = 0;
    for (int i = 0; i < samples; i++) {
        double x = uniform(low, high), e = ulps(f(x), g(x), scale);
        if (!(e <= worst)) worst = e, where = x;
    }
    print_message("%s on [%g, %g]: %.3f ulp at %.17g\n", name, low, high, worst, where);
    assert_true(worst <= bound);
}

static void errors_are_bounded(void **state) {
    (void)state;
    sweep("exp", bat_exp, expl, -700, 700, 0, 2);
    sweep("exp", bat_exp, expl, -1, 1, 0, 2);
    sweep("log", bat_log, logl, 1e-300, 1e300, 0, 2);
    sweep("log", bat_log, logl, 0.3, 3, 0, 2);
    sweep("sin", bat_sin, sinl, -7, 7, 1, 2);
    sweep("sin", bat_sin, sinl, -1e6, 1e6, 1, 2);
    sweep("cos", bat_cos, cosl, -7, 7, 1, 2);
    sweep("cos", bat_cos, cosl, -1e6, 1e6, 1, 2);
    sweep("sin small", bat_sin, sinl, -0.7, 0.7, 0, 2);
    sweep("tan", bat_tan, tanl, -1, 1, 0, 4);
    sweep("atan", bat_atan, atanl, -3, 3, 0, 2);
    sweep("atan", bat_atan, atanl, -1e9, 1e9, 0, 2);
    sweep("acos", bat_acos, acosl, -1, 1, BAT_PI, 3);
    sweep("asin", bat_asin, asinl, -1, 1, 0, 4);
}

static void two_arguments(void **state) {
    (void)state;
    double worst_hypot = 0, worst_atan2 = 0;
    for (int i = 0; i < samples; i++) {
        int e = (int)uniform(-1000, 1000);
        double x = ldexp(uniform(-1, 1), e), y = ldexp(uniform(-1, 1), e + (int)uniform(-30, 10));
        double h = ulps(bat_hypot(x, y), hypotl(x, y), 0), a = ulps(bat_atan2(y, x), atan2l(y, x), 0);
        if (!(h <= worst_hypot)) worst_hypot = h;
        if (!(a <= worst_atan2)) worst_atan2 = a;
    }
    print_message("hypot: %.3f ulp, atan2: %.3f ulp\n", worst_hypot, worst_atan2);
    assert_true(worst_hypot <= 1.25);
    assert_true(worst_atan2 <= 2);
    assert_true(bat_hypot(3, 4) == 5);
    assert_true(bat_hypot(DBL_MAX / 2, DBL_MAX / 2) < INFINITY);
    assert_true(bat_hypot(DBL_TRUE_MIN, 0) == DBL_TRUE_MIN);
}

static void special_values(void **state) {
    (void)state;
    assert_true(bat_exp(0) == 1 && bat_exp(-INFINITY) == 0 && bat_exp(INFINITY) == INFINITY);
    assert_true(bat_exp(800) == INFINITY && bat_exp(-800) == 0 && isnan(bat_exp(NAN)));
    assert_true(bat_log(1) == 0 && bat_log(0) == -INFINITY && isnan(bat_log(-1)) &&
                bat_log(INFINITY) == INFINITY);
    assert_true(isnan(bat_sin(INFINITY)) && isnan(bat_cos(NAN)) && bat_cos(0) == 1);
    assert_true(signbit(bat_sin(-0.0)) && !signbit(bat_sin(0.0)));
    assert_true(fabs(bat_sin(1e300)) <= 1 && fabs(bat_cos(-1e17)) <= 1);
    assert_true(bat_hypot(INFINITY, NAN) == INFINITY && isnan(bat_hypot(NAN, 1)) && bat_hypot(0, -0.0) == 0);
    assert_true(bat_acos(1) == 0 && bat_acos(-1) == BAT_PI && isnan(bat_acos(1.5)) && isnan(bat_asin(-2)));
    const double values[] = {0.0, -0.0, 1, -1, INFINITY, -INFINITY};
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            double ours = bat_atan2(values[i], values[j]), theirs = atan2(values[i], values[j]);
            assert_true(fabs(ours - theirs) <= 0x1p-51 && signbit(ours) == signbit(theirs));
        }
    assert_true(isnan(bat_atan2(NAN, 1)));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(errors_are_bounded), cmocka_unit_test(two_arguments),
                                       cmocka_unit_test(special_values)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
