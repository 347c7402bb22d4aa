/* Surfaces from curves: revolutions against exact rotation, Coons patches against the formula and their sides, lofts
 * against their sections; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include <batten/sweep.h>
#include "support/random_curve.h"

static const double TURN = 6.283185307179586477;

static double apart(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static bat_curve *space_curve(random_source *r, bool closed) {
    const int degree = random_int(r, 1, 5), kind = closed ? 2 : random_int(r, 0, 1);
    return random_curve(r, degree, 3, kind, random_int(r, 0, 5));
}

/* ---- revolution ---- */

/* The point turned about the axis by Rodrigues' formula. */
static void turned(const double *p, const double *o, const double *d, double angle, double *out) {
    const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), c = cos(angle), s = sin(angle);
    double k[3], x[3], along = 0;
    for (int i = 0; i < 3; i++) k[i] = d[i] / length, x[i] = p[i] - o[i];
    for (int i = 0; i < 3; i++) along += k[i] * x[i];
    for (int i = 0; i < 3; i++) {
        const double cross = k[(i + 1) % 3] * x[(i + 2) % 3] - k[(i + 2) % 3] * x[(i + 1) % 3];
        out[i] = o[i] + x[i] * c + cross * s + k[i] * along * (1 - c);
    }
}

static void check_revolution(random_source *r, const bat_curve *profile, double angle, double tolerance) {
    const double o[3] = {1, -2, 0.5}, d[3] = {0.3, -2, 1};
    bat_surface *s = NULL;
    double domain[2], worst = 0, told = -1;
    assert_int_equal(bat_surface_revolve(profile, o, d, angle, tolerance, &s, &told), BAT_OK);
    assert_true(told <= tolerance && bat_surface_is_closed(s, BAT_U) == (fabs(angle) > 6.28318));
    assert_true(bat_surface_is_closed(s, BAT_V) == bat_curve_is_closed(profile));
    bat_surface_domain(s, BAT_U, domain);
    assert_true(domain[0] == 0 && domain[1] == 1);
    bat_curve_domain(profile, domain);
    for (int k = 0; k < 400; k++) {
        const double u = k < 3 ? 0.5 * k : random_unit(r), v = random_between(r, domain[0], domain[1]);
        double on[3] = {0, 0, 0}, wanted[3], got[3];
        bat_curve_eval(profile, v, 0, on);
        turned(on, o, d, angle * u, wanted);
        bat_surface_eval(s, u, v, 0, got);
        worst = fmax(worst, apart(wanted, got));
    }
    const double rounding = 1e-12 * bat_surface_size(s);
    assert_true(worst <= told + rounding && worst <= tolerance + rounding);
    bat_surface_free(s);
}

static void a_revolution_is_exact_to_the_tolerance(void **state) {
    (void)state;
    random_source r = {5};
    for (int number = 0; number < 60; number++) {
        bat_curve *profile = random_curve(&r, 1 + number % 5, 2 + number % 2, number % 3, 5);
        const double share = number % 4 == 0 ? 1 : random_unit(&r);
        const double angle = (number % 2 ? -1 : 1) * TURN * share;
        check_revolution(&r, profile, angle, number % 3 == 0 ? 1e-7 : number % 3 == 1 ? 1e-3 : 5);
        bat_curve_free(profile);
    }
}

/* A quarter of a torus and a sphere, whose profiles touch the axis. */
static void a_point_on_the_axis_stays_a_point(void **state) {
    (void)state;
    const double points[8] = {0, 3, 1, 3, 2, 1, 0, -1}, o[3] = {0, 0, 0}, y[3] = {0, 5, 0};
    bat_curve *profile = NULL;
    bat_surface *s = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &profile), BAT_OK);
    assert_int_equal(bat_surface_revolve(profile, o, y, TURN, 1e-4, &s, NULL), BAT_OK);
    for (int i = 0; i < (int)bat_surface_count(s, BAT_U); i++) {
        const double *row = bat_surface_row(s, i);
        assert_true(row[0] == 0 && row[1] == 3 && row[2] == 0);
        assert_true(row[9] == 0 && row[10] == -1 && row[11] == 0);
    }
    bat_surface_free(s);
    bat_curve_free(profile);
}

static void no_more_spans_than_needed(void **state) {
    (void)state;
    const double points[4] = {1, 0, 1, 1}, o[3] = {0, 0, 0}, y[3] = {0, 1, 0};
    bat_curve *profile = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &profile), BAT_OK);
    double before = 0;
    for (double tolerance = 1e-2; tolerance > 1e-9; tolerance /= 16) { /* of order 4: twice as many */
        bat_surface *s = NULL;
        assert_int_equal(bat_surface_revolve(profile, o, y, TURN, tolerance, &s, NULL), BAT_OK);
        const double count = (double)bat_surface_count(s, BAT_U);
        if (before > 0) assert_true(count / before > 1.6 && count / before < 2.4);
        before = count;
        bat_surface_free(s);
    }
    bat_curve_free(profile);
}

static void what_cannot_be_revolved(void **state) {
    (void)state;
    const double points[4] = {0, 0, 0, 1}, o[3] = {0, 0, 0}, y[3] = {0, 1, 0}, x[3] = {1, 0, 0},
                 none[3] = {0, 0, 0};
    const double wild[3] = {0, NAN, 0};
    bat_curve *line = NULL;
    bat_surface *s = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &line), BAT_OK);
    assert_int_equal(bat_surface_revolve(line, o, y, 1, 1, &s, NULL), BAT_SINGULAR);
    assert_int_equal(bat_surface_revolve(line, o, none, 1, 1, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_revolve(line, o, x, 0, 1, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_revolve(line, o, x, 6.3, 1, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_revolve(line, o, x, 1, 0, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_revolve(line, wild, x, 1, 1, &s, NULL), BAT_NUMBER);
    assert_int_equal(bat_surface_revolve(line, o, x, NAN, 1, &s, NULL), BAT_NUMBER);
    assert_int_equal(bat_surface_revolve(line, o, x, 1, 1e-60, &s, NULL), BAT_COUNT);
    assert_int_equal(bat_surface_revolve(NULL, o, x, 1, 1, &s, NULL), BAT_ARGUMENT);
    assert_null(s);
    bat_curve_free(line);
}

/* ---- Coons ---- */

/* An open curve of any degree over any domain, between two given points. */
static bat_curve *between(random_source *r, const double *from, const double *to) {
    const int degree = random_int(r, 1, 5), kind = random_int(r, 0, 1);
    bat_curve *loose = random_curve(r, degree, 3, kind, random_int(r, 0, 4)), *clamped = NULL, *out = NULL;
    double points[3 * 24];
    assert_int_equal(bat_curve_clamp(loose, &clamped), BAT_OK);
    const size_t size = bat_curve_count(clamped);
    memcpy(points, bat_curve_points(clamped), 3 * size * sizeof *points);
    memcpy(points, from, 3 * sizeof *points);
    memcpy(points + 3 * (size - 1), to, 3 * sizeof *points);
    assert_int_equal(bat_curve_create(3, degree, false, size, points, bat_curve_knot_count(clamped),
                                      bat_curve_knots(clamped), &out),
                     BAT_OK);
    bat_curve_free(loose), bat_curve_free(clamped);
    return out;
}

static void at_share(const bat_curve *curve, double share, double *out) {
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0] + share * (domain[1] - domain[0]), 0, out);
}

static void check_coons(random_source *r, bat_curve *const *sides, const bat_surface *s, double reach) {
    double corner[4][3];
    for (int k = 0; k < 4; k++) at_share(sides[k / 2], k % 2, corner[k]);
    for (int k = 0; k < 100; k++) {
        const double u = k < 40 ? (k % 2) : random_unit(r), v = k >= 20 && k < 60 ? (k % 2) : random_unit(r);
        double c0[3], c1[3], d0[3], d1[3], got[3], wanted[3];
        at_share(sides[0], u, c0), at_share(sides[1], u, c1);
        at_share(sides[2], v, d0), at_share(sides[3], v, d1);
        for (int i = 0; i < 3; i++)
            wanted[i] = (1 - v) * c0[i] + v * c1[i] + (1 - u) * d0[i] + u * d1[i] -
                        (1 - u) * ((1 - v) * corner[0][i] + v * corner[2][i]) -
                        u * ((1 - v) * corner[1][i] + v * corner[3][i]);
        bat_surface_eval(s, u, v, 0, got);
        assert_true(apart(got, wanted) <= reach);
    }
}

static void a_coons_patch_is_the_formula(void **state) {
    (void)state;
    random_source r = {6};
    for (int number = 0; number < 60; number++) {
        double corner[4][3], gaps[4];
        for (int k = 0; k < 12; k++) corner[k / 3][k % 3] = random_between(&r, -9, 9);
        bat_curve *sides[4] = {between(&r, corner[0], corner[1]), between(&r, corner[2], corner[3]),
                               between(&r, corner[0], corner[2]), between(&r, corner[1], corner[3])};
        const bat_curve *given[4] = {sides[0], sides[1], sides[2], sides[3]};
        bat_surface *s = NULL;
        assert_int_equal(bat_surface_coons(given, 0, &s, gaps), BAT_OK);
        for (int k = 0; k < 4; k++) assert_true(gaps[k] == 0);
        check_coons(&r, sides, s, 1e-11 * bat_surface_size(s));
        bat_surface_free(s);
        for (int k = 0; k < 4; k++) bat_curve_free(sides[k]);
    }
}

static void corners_that_are_apart(void **state) {
    (void)state;
    random_source r = {7};
    const double corner[4][3] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 1}, {9, 9, 0}}, off[3] = {9, 9, 0.01};
    bat_curve *sides[4] = {between(&r, corner[0], corner[1]), between(&r, corner[2], corner[3]),
                           between(&r, corner[0], corner[2]), between(&r, corner[1], off)};
    const bat_curve *given[4] = {sides[0], sides[1], sides[2], sides[3]}, *wrong[4] = {NULL};
    bat_surface *s = NULL;
    double gaps[4];
    assert_int_equal(bat_surface_coons(given, 0.009, &s, gaps), BAT_FAR);
    assert_true(gaps[0] == 0 && gaps[1] == 0 && gaps[2] == 0 && fabs(gaps[3] - 0.01) < 1e-12);
    assert_int_equal(bat_surface_coons(given, 0.011, &s, NULL), BAT_OK);
    check_coons(&r, sides, s, 0.0051);
    bat_surface_free(s), s = NULL;
    assert_int_equal(bat_surface_coons(given, NAN, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_coons(wrong, 1, &s, NULL), BAT_ARGUMENT);
    bat_curve *closed = random_curve(&r, 3, 3, 2, 6);
    given[2] = closed;
    assert_int_equal(bat_surface_coons(given, 100, &s, NULL), BAT_ARGUMENT);
    assert_null(s);
    bat_curve_free(closed);
    for (int k = 0; k < 4; k++) bat_curve_free(sides[k]);
}

/* ---- loft ---- */

static void a_loft_passes_through_its_sections(void **state) {
    (void)state;
    enum { MOST = 9 };
    random_source r = {8};
    for (int number = 0; number < 60; number++) {
        const int count = 2 + number % 8;
        const bool closed = number % 2 == 0;
        bat_curve *sections[MOST];
        const bat_curve *given[MOST];
        double v[MOST];
        for (int k = 0; k < count; k++) given[k] = sections[k] = space_curve(&r, closed);
        bat_surface *s = NULL;
        const bat_status status = bat_surface_loft((size_t)count, given, &s, v);
        if (status == BAT_COUNT) { /* many sections of knots of their own */
            assert_true(count > 4);
        } else {
            assert_int_equal(status, BAT_OK);
            assert_true(v[0] == 0 && v[count - 1] == 1 && bat_surface_is_closed(s, BAT_U) == closed);
            assert_int_equal(bat_surface_degree(s, BAT_V), count > 3 ? 3 : count - 1);
            double domain[2], own[2];
            bat_surface_domain(s, BAT_U, domain);
            bat_curve_domain(sections[0], own);
            assert_true(domain[0] == own[0] && domain[1] == own[1]);
            for (int k = 0; k < count; k++)
                for (int i = 0; i < 30; i++) {
                    const double share = random_unit(&r);
                    double on[3], got[3];
                    at_share(sections[k], share, on);
                    bat_surface_eval(s, domain[0] + share * (domain[1] - domain[0]), v[k], 0, got);
                    assert_true(apart(on, got) < 1e-8 * bat_surface_size(s));
                }
        }
        bat_surface_free(s);
        for (int k = 0; k < count; k++) bat_curve_free(sections[k]);
    }
}

/* Sections of a paraboloid's cubic sibling: across, cubics are reproduced. */
static void a_loft_reproduces_a_cubic(void **state) {
    (void)state;
    enum { SECTIONS = 8 };
    bat_curve *sections[SECTIONS];
    const bat_curve *given[SECTIONS];
    double v[SECTIONS];
    for (int k = 0; k < SECTIONS; k++) { /* equal chords: translations along a line */
        const double z = k, points[12] = {0, 0, z, 3, 1, z, 5, -1, z, 9, 0, z};
        assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &sections[k]), BAT_OK);
        given[k] = sections[k];
    }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_loft(SECTIONS, given, &s, v), BAT_OK);
    for (int k = 0; k < SECTIONS; k++) assert_true(fabs(v[k] - k / 7.0) < 1e-15);
    for (int k = 0; k <= 70; k++) {
        double on[3], got[3];
        bat_curve_eval(sections[0], 0.3, 0, on);
        bat_surface_eval(s, 0.3, k / 70.0, 0, got);
        on[2] = k / 10.0;
        assert_true(apart(on, got) < 1e-13);
    }
    bat_surface_free(s);
    for (int k = 0; k < SECTIONS; k++) bat_curve_free(sections[k]);
}

/* Sections whose knots all differ: the knots of all give 4 times as many points as the largest section has, never more. */
static void knots_of_sections_stay_within_bounds(void **state) {
    (void)state;
    enum { MOST = 9, INNER = 4 };
    for (int closed = 0; closed < 2; closed++)
        for (int count = 2; count <= MOST; count++) {
            bat_curve *sections[MOST];
            const bat_curve *given[MOST];
            bat_surface *s = NULL;
            const int n = closed ? 2 * INNER : INNER + 4,
                      all = closed ? 1 + count * (n - 1) : 4 + count * INNER;
            for (int k = 0; k < count; k++) {
                double points[3 * (INNER + 4)], knots[INNER + 8];
                for (int i = 0; i < n; i++) {
                    points[3 * i] = closed ? cos(i * 6.283185307179586 / n) : i;
                    points[3 * i + 1] = closed ? sin(i * 6.283185307179586 / n) : (i * i + k) % 3;
                    points[3 * i + 2] = 2 * k;
                }
                const int inner = closed ? n - 1 : INNER, before = closed ? 1 : 4;
                for (int i = 0; i < before; i++) knots[i] = 0, knots[before + inner + i] = 1;
                for (int i = 0; i < inner; i++) knots[before + i] = (i + (k + 1.0) / (MOST + 1)) / inner;
                assert_int_equal(bat_curve_create(3, 3, closed, (size_t)n, points, 2 * before + inner, knots,
                                                  &sections[k]),
                                 BAT_OK);
                given[k] = sections[k];
            }
            const bat_status status = bat_surface_loft((size_t)count, given, &s, NULL);
            assert_int_equal(status, all <= 4 * n ? BAT_OK : BAT_COUNT);
            if (s) assert_int_equal(bat_surface_count(s, BAT_U), all);
            bat_surface_free(s);
            for (int k = 0; k < count; k++) bat_curve_free(sections[k]);
        }
}

static void what_cannot_be_lofted(void **state) {
    (void)state;
    random_source r = {9};
    bat_curve *open = random_curve(&r, 3, 3, 0, 6), *closed = random_curve(&r, 3, 3, 2, 6);
    const bat_curve *mixed[2] = {open, closed}, *twice[2] = {open, open}, *none[2] = {open, NULL};
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_loft(2, mixed, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_loft(2, twice, &s, NULL), BAT_SINGULAR);
    assert_int_equal(bat_surface_loft(2, none, &s, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_loft(1, mixed, &s, NULL), BAT_COUNT);
    assert_int_equal(bat_surface_loft(0, mixed, &s, NULL), BAT_COUNT);
    assert_int_equal(bat_surface_loft((size_t)-1, mixed, &s, NULL), BAT_COUNT);
    assert_null(s);
    bat_curve_free(open), bat_curve_free(closed);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_revolution_is_exact_to_the_tolerance),
        cmocka_unit_test(a_point_on_the_axis_stays_a_point),
        cmocka_unit_test(no_more_spans_than_needed),
        cmocka_unit_test(what_cannot_be_revolved),
        cmocka_unit_test(a_coons_patch_is_the_formula),
        cmocka_unit_test(corners_that_are_apart),
        cmocka_unit_test(a_loft_passes_through_its_sections),
        cmocka_unit_test(a_loft_reproduces_a_cubic),
        cmocka_unit_test(knots_of_sections_stay_within_bounds),
        cmocka_unit_test(what_cannot_be_lofted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
