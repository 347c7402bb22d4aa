/*
 * Points of a spline at parameters that nobody tells: at even lengths along it, at lengths whose density changes, and at
 * random ones. The fit finds the pieces, and takes no more spans than the curve has. Points of other curves get what they
 * got without.
 * label: slow
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include "curve/fit.h"
#include "support/random_curve.h"
#include "support/rounds.h"

enum { COUNT = 2000, TABLE = 20000 };

typedef struct wiggle {
    int degree, dimension, spans;
    bool closed;
} wiggle;

/* Control points some 14 px apart, knots uneven. */
static bat_curve *wiggly(random_source *r, const wiggle *w) {
    enum { MOST = 120 };
    const int p = w->degree, m = w->dimension, n = w->closed ? w->spans : w->spans + p;
    const int knot_count = w->closed ? n + 1 : n + p + 1;
    double points[3 * MOST], knots[MOST + 8], way = 0, at[3] = {0};
    for (int i = 0; i < n; i++) {
        const double a = 2 * 3.14159265358979 * i / n, radius = 2.2 * n + random_between(r, -8, 8);
        way += random_between(r, -1.2, 1.2);
        at[0] += 14 * cos(way), at[1] += 14 * sin(way), at[2] += random_between(r, -3, 3);
        for (int c = 0; c < m; c++)
            points[i * m + c] = w->closed && c < 2 ? radius * (c ? sin(a) : cos(a)) : at[c];
        if (w->closed && m == 3) points[i * m + 2] = random_between(r, -6, 6);
    }
    for (int i = 0; i < knot_count; i++) {
        const bool end = !w->closed && (i <= p || i > w->spans + p);
        knots[i] = i == 0 ? 0 : knots[i - 1] + (end ? 0 : random_between(r, 0.5, 1.5));
    }
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(m, p, w->closed, (size_t)n, points, knot_count, knots, &curve), BAT_OK);
    return curve;
}

enum places { EVEN, DENSER, RANDOM };

/* Shares of the length, from 0 on; open: to 1. */
static void choose_places(random_source *r, enum places places, bool closed, double *share) {
    const double steps = closed ? COUNT : COUNT - 1;
    share[0] = 0;
    for (int i = 1; i < COUNT; i++) {
        const double f = i / steps;
        share[i] = places == RANDOM   ? share[i - 1] + random_between(r, 0.5, 1.5)
                   : places == DENSER ? f + 0.05 * sin(2 * 3.14159265358979 * f)
                                      : f;
    }
    const double whole = share[COUNT - 1] + (closed ? 1 : 0);
    for (int i = 1; i < COUNT && places == RANDOM; i++) share[i] /= whole;
}

/* Points on the curve: where they are along it is the table's, which is near enough to even. */
static void sample(const bat_curve *curve, const double *share, double *x) {
    static double length[TABLE + 1];
    const int m = bat_curve_dimension(curve);
    double domain[2], before[3], now[3];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, before);
    for (int i = 1; i <= TABLE; i++) {
        double sum = 0;
        const double u = i < TABLE ? domain[0] + (domain[1] - domain[0]) * i / TABLE : domain[1];
        bat_curve_eval_left(curve, u, 0, now);
        for (int c = 0; c < m; c++) sum += (now[c] - before[c]) * (now[c] - before[c]);
        length[i] = length[i - 1] + sqrt(sum);
        memcpy(before, now, sizeof before);
    }
    for (int i = 0, k = 0; i < COUNT; i++) {
        const double at = share[i] * length[TABLE];
        while (k + 1 < TABLE && length[k + 1] < at) k++;
        const double f = fmin((at - length[k]) / (length[k + 1] - length[k]), 1);
        bat_curve_eval_left(curve, domain[0] + (domain[1] - domain[0]) * (k + f) / TABLE, 0,
                            x + (ptrdiff_t)i * m);
    }
    bat_curve_eval(curve, domain[0], 0, x);
}

static double true_error(const bat_curve *curve, int m, const double *x) {
    bat_finder *finder;
    double worst = 0;
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    for (int i = 0; i < COUNT; i++) {
        bat_near near;
        bat_finder_nearest(finder, x + (ptrdiff_t)i * m, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static int spans_of(const wiggle *w, const double *x, double tolerance) {
    bat_fit_options options = bat_fit_defaults();
    bat_fit_report report;
    bat_curve *fit = NULL;
    options.tolerance = tolerance, options.degree = w->degree, options.closed = w->closed;
    assert_int_equal(bat_fit(w->dimension, COUNT, x, &options, &fit, &report), BAT_OK);
    assert_true(true_error(fit, w->dimension, x) <= tolerance * (1 + 1e-9));
    bat_curve_free(fit);
    return report.knots + !w->closed;
}

static const double tolerances[3] = {0.02, 0.1, 0.45};

/* Spans taken, of 1000 of the curves'; how many curves took more. */
static void judge(uint64_t seed, enum places places, int degree, int spans, int curves, int share[3],
                  int more[3]) {
    static double x[3 * COUNT], at[COUNT];
    random_source r = {seed};
    int sum = 0, taken[3] = {0};
    memset(more, 0, 3 * sizeof *more);
    for (int n = 0; n < curves; n++) {
        wiggle w = {degree, 2 + n % 2, spans, n / 2 % 2};
        if (w.closed && w.spans < 8) w.spans = 8;
        bat_curve *curve = wiggly(&r, &w);
        choose_places(&r, places, w.closed, at);
        sample(curve, at, x);
        for (int k = 0; k < 3; k++) {
            const int count = spans_of(&w, x, tolerances[k]);
            taken[k] += count, more[k] += count > w.spans;
        }
        sum += w.spans;
        bat_curve_free(curve);
    }
    for (int k = 0; k < 3; k++) share[k] = 1000 * taken[k] / sum;
    print_message("degree %d, %d spans, %s: %d %d %d of 1000, more in %d %d %d of %d\n", degree, spans,
                  places == EVEN     ? "even"
                  : places == DENSER ? "denser"
                                     : "random",
                  share[0], share[1], share[2], more[0], more[1], more[2], curves);
}

static void lengths_give_the_curve_back(void **state) {
    (void)state;
    int share[3], more[3];
    for (int degree = 2; degree <= 4; degree++)
        for (enum places places = EVEN; places <= DENSER; places++)
            for (int spans = 5; spans <= 20; spans += 15) {
                judge(97, places, degree, spans, ROUNDS_OF(degree == 3 ? 12 : 4), share, more);
                for (int k = 0; k < 3; k++) assert_true(degree == 4 ? share[k] <= 1200 : more[k] == 0);
            }
    for (enum places places = EVEN; places <= DENSER; places++) {
        judge(5, places, 3, 97, ROUNDS_OF(6), share, more);
        for (int k = 0; k < 3; k++) assert_true(share[k] <= 1020);
        judge(5, places, 2, 97, ROUNDS_OF(4), share, more);
        for (int k = 0; k < 3; k++) assert_true(share[k] <= 1010);
    }
}

static void random_places_nearly_do(void **state) {
    (void)state;
    int share[3], more[3];
    for (int spans = 5; spans <= 20; spans += 15) {
        judge(31, RANDOM, 3, spans, 8, share, more);
        assert_true(share[0] <= 1300 && share[1] <= 1200 && share[2] <= 1100);
    }
}

/* An ellipse, a wave, a spiral, clean and rounded to a tenth: as many spans as without the search. */
static void other_curves_are_as_before(void **state) {
    (void)state;
    static double x[2 * COUNT];
    for (int kind = 0; kind < 6; kind++)
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < COUNT; i++) {
                const double t = (double)i / (COUNT - 1), a = 6.283185307179586 * t, r = 100 * exp(-2 * t);
                x[2 * i] = kind % 3 == 0 ? 200 * cos(a) : kind % 3 == 1 ? 800 * t : r * cos(5 * a);
                x[2 * i + 1] = kind % 3 == 0   ? 100 * sin(a)
                               : kind % 3 == 1 ? 60 * sin(4 * a) + 20 * sin(3.3 * a)
                                               : r * sin(5 * a);
                for (int c = 0; c < 2 && kind >= 3; c++) x[2 * i + c] = floor(10 * x[2 * i + c]) / 10;
            }
            bat_fit_options options = bat_fit_defaults();
            bat_fit_report with, without;
            bat_curve *fit = NULL, *plain = NULL;
            options.tolerance = kind >= 3 ? 0.45 : tolerances[k];
            assert_int_equal(bat_fit(2, COUNT, x, &options, &fit, &with), BAT_OK);
            assert_int_equal(bat_fit_plain(2, COUNT, x, &options, &plain, &without), BAT_OK);
            assert_true(with.knots <= without.knots && with.max_error <= options.tolerance);
            bat_curve_free(fit);
            bat_curve_free(plain);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lengths_give_the_curve_back),
                                       cmocka_unit_test(random_places_nearly_do),
                                       cmocka_unit_test(other_curves_are_as_before)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
