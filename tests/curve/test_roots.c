/*
 * Sign changes of polynomials in Bernstein form, against polynomials whose roots are known: one or two within, at the ends, double,
 * none; of all sizes, from 1e-150 to 1e150.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/real.h"
#include "curve/roots.h"

#include <math.h>

static double next(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

/* Of scale (x - r) (x - s). */
static void quadratic(double r, double s, double scale, double a[3]) {
    a[0] = scale * r * s;
    a[1] = scale * (r * s - 0.5 * (r + s));
    a[2] = scale * (1 - r) * (1 - s);
}

static int crossings(int degree, const double *a, double *x) {
    bat_signs signs = {0, 0};
    return bat_bernstein_crossings(degree, a, 0, &signs, x);
}

static void one_root_of_a_quadratic(void **state) {
    (void)state;
    uint64_t random = 11;
    for (int i = 0; i < 20000; i++) {
        const double r = 0.001 + 0.998 * next(&random);
        const double far = next(&random) * 20 - 10;
        const double s = far < 0 ? far - 0.001 : far + 1.001;
        const double power = next(&random) * 300 - 150;
        const double scale = bat_exp(power * 2.302585092994046);
        double a[3], x[4];
        quadratic(r, s, i % 2 ? scale : -scale, a);
        assert_int_equal(crossings(2, a, x), 1);
        assert_true(fabs(x[0] - r) < 1e-13);
    }
}

static void two_roots_of_a_quadratic(void **state) {
    (void)state;
    uint64_t random = 5;
    for (int i = 0; i < 5000; i++) {
        const double r = 0.01 + 0.4 * next(&random);
        const double s = r + 0.01 + 0.5 * next(&random);
        double a[3], x[4];
        quadratic(r, s, 1, a);
        assert_int_equal(crossings(2, a, x), 2);
        assert_true(fabs(x[0] - r) < 1e-12 && fabs(x[1] - s) < 1e-12);
    }
}

static void roots_at_the_ends_and_none(void **state) {
    (void)state;
    double x[4];
    assert_int_equal(crossings(2, (double[]){0, -1, 2}, x),
                     1); /* x (4 x - 2): the start has no sign of its own */
    assert_true(x[0] == 0.5);
    assert_int_equal(crossings(2, (double[]){2, -1, 0}, x), 1);
    assert_true(x[0] == 0.5);
    assert_int_equal(crossings(2, (double[]){0, 0, 1}, x), 0);
    assert_int_equal(crossings(2, (double[]){0, 0, 0}, x), 0);
    assert_int_equal(crossings(2, (double[]){1, -0.5, 1}, x), 0); /* no real root */
    assert_int_equal(crossings(1, (double[]){3, -1}, x), 1);
    assert_true(fabs(x[0] - 0.75) < 1e-15);
    /* What is within `zero` has no sign, so that the crossing near it does not count. */
    bat_signs signs = {0, 0};
    assert_int_equal(bat_bernstein_crossings(2, (double[]){1e-12, -1, 2}, 1e-9, &signs, x), 1);
    assert_true(fabs(x[0] - 0.5) < 1e-9);
}

/* (x - 0.2) (x - 0.5) (x - 0.9) in Bernstein form, from its blossom. */
static void a_cubic(void **state) {
    (void)state;
    const double roots[3] = {0.2, 0.5, 0.9};
    double a[4], x[5];
    for (int j = 0; j < 4; j++) {
        static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        a[j] = 0;
        for (int k = 0; k < 6; k++) {
            double product = 1;
            for (int i = 0; i < 3; i++) product *= (i < j) - roots[orders[k][i]];
            a[j] += product / 6;
        }
    }
    assert_int_equal(crossings(3, a, x), 3);
    for (int i = 0; i < 3; i++) assert_true(fabs(x[i] - roots[i]) < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_root_of_a_quadratic),
        cmocka_unit_test(two_roots_of_a_quadratic),
        cmocka_unit_test(roots_at_the_ends_and_none),
        cmocka_unit_test(a_cubic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
