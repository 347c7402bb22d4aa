/* A redrawn line: the surface passes through it, rows out of reach keep every bit, smoothness is preserved, reverting
 * an edit restores the surface; reach, holding, gain, seams; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/refine.h>
#include "support/random_surface.h"

enum { ROWS = 64 };

/* The line moved at random, on its knots or (finer) with one more. */
static bat_curve *other_line(random_source *r, const bat_surface *s, bat_direction direction, double at,
                             bool finer) {
    bat_curve *line = NULL, *more = NULL, *moved = NULL;
    double domain[2], points[ROWS * 3];
    assert_int_equal(bat_surface_isocurve(s, direction, at, &line), BAT_OK);
    bat_curve_domain(line, domain);
    assert_int_equal(
        bat_curve_insert_knot(line, random_between(r, domain[0], domain[1]), finer ? 1 : 0, &more), BAT_OK);
    const size_t count = bat_curve_count(more);
    memcpy(points, bat_curve_points(more), count * 3 * sizeof *points);
    for (size_t i = 0; i < 3 * count; i++) points[i] += random_between(r, -1, 1);
    assert_int_equal(bat_curve_create(3, bat_curve_degree(more), bat_curve_is_closed(more), count, points,
                                      bat_curve_knot_count(more), bat_curve_knots(more), &moved),
                     BAT_OK);
    bat_curve_free(line), bat_curve_free(more);
    return moved;
}

static double apart(const double *a, const double *b, int size) {
    double d = 0;
    for (int c = 0; c < size; c++) d = fmax(d, fabs(a[c] - b[c]));
    return d;
}

/* A row of the direction that is crossed: its j-th point. */
static const double *point_at(const bat_surface *s, bat_direction direction, int row, int j) {
    return direction == BAT_U ? bat_surface_row(s, row) + 3 * j : bat_surface_row(s, j) + 3 * row;
}

static void the_line_is_the_new_one(void **state) {
    (void)state;
    random_source r = {15};
    int kept = 0;
    for (int number = 0; number < 126; number++) {
        bat_surface *s = some_surface(&r, number), *made = NULL, *fine = NULL, *back = NULL;
        const bat_direction d = number % 2 ? BAT_V : BAT_U, e = d == BAT_U ? BAT_V : BAT_U;
        double at = random_parameter(&r, s, d), weights[ROWS], size = bat_surface_size(s);
        bat_curve *line = other_line(&r, s, d, at, number % 4 > 1), *now = NULL, *before = NULL;
        bat_surface_redraw_report report;
        if (bat_surface_redraw(s, d, at, line, NULL, &made, weights, &report) ==
            BAT_FAR) { /* knots of many kinds */
            assert_true(report.gain > 4);
            bat_curve_free(line), bat_surface_free(s);
            continue;
        }
        assert_non_null(made);
        assert_int_equal(bat_surface_isocurve(made, d, at, &now), BAT_OK);
        assert_true(apart(bat_curve_points(now), bat_curve_points(line), 3 * (int)bat_curve_count(now)) <
                    1e-10 * size);
        assert_true(report.line_error < 1e-10 * size && report.gain >= 1 - 1e-12 && report.gain <= 4);
        assert_int_equal(report.knots_after[d] - report.knots_before[d], 0);
        assert_int_equal(report.knots_after[e] - report.knots_before[e], number % 4 > 1);
        assert_int_equal(
            bat_surface_refine(s, e, bat_surface_knot_count(made, e), bat_surface_knots(made, e), &fine),
            BAT_OK);
        for (int i = 0; i < (int)bat_surface_count(s, d); i++)
            for (int j = 0; j < (int)bat_surface_count(made, e); j++) {
                const bool same = memcmp(point_at(made, d, i, j), point_at(fine, d, i, j),
                                         3 * sizeof(double)) == 0;
                assert_true(same == !(weights[i] > 0));
                kept += same;
            }
        for (int k = 0; k < 40; k++) { /* beyond what moved, nothing has */
            double a[3], b[3], where[2];
            where[0] = random_parameter(&r, s, BAT_U), where[1] = random_parameter(&r, s, BAT_V);
            if (bat_surface_is_closed(s, d) || (where[d] >= report.moved[0] && where[d] <= report.moved[1]))
                continue;
            bat_surface_eval(fine, where[0], where[1], 0, a);
            bat_surface_eval(made, where[0], where[1], 0, b);
            assert_memory_equal(a, b, sizeof a);
        }
        assert_int_equal(bat_surface_isocurve(fine, d, at, &before), BAT_OK);
        assert_int_equal(bat_surface_redraw(made, d, at, before, NULL, &back, NULL, NULL), BAT_OK);
        for (int i = 0; i < (int)bat_surface_count(fine, BAT_U); i++)
            assert_true(apart(bat_surface_row(back, i), bat_surface_row(fine, i),
                              3 * (int)bat_surface_count(fine, BAT_V)) < 1e-12 * size);
        bat_curve_free(line), bat_curve_free(now), bat_curve_free(before);
        bat_surface_free(s), bat_surface_free(made), bat_surface_free(fine), bat_surface_free(back);
    }
    assert_true(kept > 200);
}

/* A flat cubic sheet with uniform knots, spans of 1, over [0, n - 3] both ways; closed in u if asked for. */
static bat_surface *sheet(int n, bool closed, bool clamped) {
    double knots[2][ROWS], points[ROWS * 8 * 3];
    for (int i = 0; i < n + 4; i++) knots[0][i] = clamped ? fmin(fmax(i - 3, 0), n - 3) : i;
    for (int j = 0; j < 12; j++) knots[1][j] = fmin(fmax(j - 3, 0), 5);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < 8; j++) {
            const double p[3] = {closed ? 5 * cos(i * 6.283185307179586 / n) : i, j,
                                 closed ? 5 * sin(i * 6.283185307179586 / n) : 0};
            memcpy(points + 3 * (8 * i + j), p, sizeof p);
        }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){closed, false},
                                        (const size_t[2]){(size_t)n, 8}, points,
                                        (const int[2]){closed ? n + 1 : n + 4, 12}, knots[0], knots[1], &s),
                     BAT_OK);
    return s;
}

/* The line at u lifted by 1 in z: then z is the bump itself. */
static bat_status lift(const bat_surface *s, double u, const bat_surface_redraw_options *options,
                       bat_surface **out, double *weights, bat_surface_redraw_report *report) {
    bat_curve *line = NULL, *lifted = NULL;
    const double up[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1};
    assert_int_equal(bat_surface_isocurve(s, BAT_U, u, &line), BAT_OK);
    assert_int_equal(bat_curve_transform(line, up, &lifted), BAT_OK);
    bat_status status = bat_surface_redraw(s, BAT_U, u, lifted, options, out, weights, report);
    bat_curve_free(line), bat_curve_free(lifted);
    return status;
}

/* On uniform knots: the bump's radius is 2.5 spans, it ends 4 to 4.3 spans away, is even, overshoots by less than 1e-4,
 * and keeps first and second derivatives continuous across every knot. */
static void the_bump(void **state) {
    (void)state;
    bat_surface *s = sheet(24, false, false), *made = NULL;
    bat_surface_redraw_report report;
    double weights[ROWS];
    for (int k = 0; k <= 10; k++) {
        const double u = 12 + 0.1 * k;
        assert_int_equal(lift(s, u, NULL, &made, weights, &report), BAT_OK);
        assert_true(fabs(report.reach - 2.5) < 1e-14);
        assert_true(u - report.moved[0] >= 3.5 && u - report.moved[0] <= 4.5);
        assert_true(report.moved[1] - u >= 3.5 && report.moved[1] - u <= 4.5);
        double most = 0, a[18], b[18];
        for (int i = 0; i <= 400; i++) {
            bat_surface_eval(made, 3 + 0.05 * i, 2.5, 0, a);
            most = fmax(most, a[2]);
            assert_true(a[2] >= 0);
            if (fabs(3 + 0.05 * i - u) > 3.25) assert_true(a[2] < 0.011);
        }
        assert_true(most < 1 + 1e-4 && most > 1 - 1e-12);
        bat_surface_eval(made, u, 2.5, 0, a);
        assert_true(fabs(a[2] - 1) < 1e-13);
        for (int i = 4; i < 20; i++) {
            bat_surface_eval(made, i - 1e-9, 2.5, 2, a);
            bat_surface_eval(made, i, 2.5, 2, b);
            assert_true(apart(a, b, 18) < 1e-7);
        }
        bat_surface_free(made);
    }
    bat_surface_free(s);
}

/* The greatest jump of second derivatives across the inner knots of direction d, over their size. Within a span they are
 * linear in d for cubics, which gives the limit from below. */
static double jump(const bat_surface *s, bat_direction d, random_source *r) {
    double most = 0, size = 1;
    const double *knots = bat_surface_knots(s, d);
    const int degree = bat_surface_degree(s, d), count = bat_surface_knot_count(s, d);
    for (int i = 0; i < 8 * count; i++) {
        const int k = i / 8;
        if (k <= degree || k >= count - degree - 1) continue;
        double half[18], quarter[18], after[18], at[2];
        const double span = knots[k] - knots[k - 1];
        if (!(span > 0)) continue;
        at[0] = random_parameter(r, s, BAT_U), at[1] = random_parameter(r, s, BAT_V);
        at[d] = knots[k];
        bat_surface_eval(s, at[0], at[1], 2, after);
        at[d] = knots[k] - 0.5 * span;
        bat_surface_eval(s, at[0], at[1], 2, half);
        at[d] = knots[k] - 0.25 * span;
        bat_surface_eval(s, at[0], at[1], 2, quarter);
        const int own = d == BAT_U ? 9 : 15; /* Suu or Svv */
        for (int c = own; c < own + 3; c++) {
            most = fmax(most, fabs(2 * quarter[c] - half[c] - after[c]));
            size = fmax(size, fabs(after[c]));
        }
    }
    return most / size;
}

/* A cubic sheet stays C2 across the knots of both directions, whichever line is redrawn, also on knots of its own. */
static void smooth_both_ways(void **state) {
    (void)state;
    random_source r = {77};
    int drawn = 0;
    for (int number = 0; number < 60; number++) {
        bat_surface *s = sheet(16, false, true), *made = NULL;
        const bat_direction d = number % 2 ? BAT_V : BAT_U;
        const double at = random_parameter(&r, s, d);
        bat_curve *line = other_line(&r, s, d, at, number % 4 > 1);
        double weights[ROWS];
        if (bat_surface_redraw(s, d, at, line, NULL, &made, weights, NULL) == BAT_OK) {
            assert_true(jump(made, BAT_U, &r) < 1e-9 && jump(made, BAT_V, &r) < 1e-9);
            drawn++;
        }
        bat_curve_free(line), bat_surface_free(s), bat_surface_free(made);
    }
    assert_true(drawn > 40);
    bat_surface *s = sheet(16, false, true), *twice = NULL, *made = NULL;
    const double again[1] = {2}; /* a double knot lets the second derivative jump, which is seen */
    assert_int_equal(bat_surface_insert_knots(s, BAT_V, 1, again, &twice), BAT_OK);
    bat_curve *line = other_line(&r, twice, BAT_U, 5.5, false);
    assert_int_equal(bat_surface_redraw(twice, BAT_U, 5.5, line, NULL, &made, NULL, NULL), BAT_OK);
    assert_true(jump(made, BAT_V, &r) > 1e-3);
    bat_curve_free(line), bat_surface_free(s), bat_surface_free(twice), bat_surface_free(made);
}

/* Held rows stay to the bit; the nearer the line is to what is held, the greater the gain, until it is refused. */
static void holding(void **state) {
    (void)state;
    bat_surface *s = sheet(16, false, true), *made = NULL;
    bat_surface_redraw_options options = bat_surface_redraw_defaults();
    const int rows[3] = {0, 1, 2};
    bat_surface_redraw_report report;
    double weights[ROWS], last = 0;
    options.hold = rows, options.hold_count = 1;
    const double at[4] = {2, 1, 0.3, 0.1};
    for (int k = 0; k < 4; k++) {
        assert_int_equal(lift(s, at[k], &options, &made, weights, &report), BAT_OK);
        assert_true(weights[0] == 0);
        assert_memory_equal(bat_surface_row(made, 0), bat_surface_row(s, 0), 24 * sizeof(double));
        assert_true(k < 2 ? report.gain < 1.25 : report.gain > 1.25 && report.gain > last);
        last = report.gain;
        bat_surface_free(made);
    }
    assert_true(last > 2.5);
    made = NULL;
    assert_int_equal(lift(s, 0.01, &options, &made, weights, &report), BAT_FAR);
    assert_true(report.gain > 4 && !made);
    assert_int_equal(lift(s, 0, &options, &made, weights, &report), BAT_FAR);
    assert_true(isinf(report.gain) && !made);
    options.hold_count = 3; /* place, tangents and curvature of the border */
    double a[18], b[18];
    assert_int_equal(lift(s, 3, &options, &made, weights, &report), BAT_OK);
    for (int k = 0; k <= 10; k++) {
        bat_surface_eval(s, 0, 0.5 * k, 2, a);
        bat_surface_eval(made, 0, 0.5 * k, 2, b);
        assert_memory_equal(a, b, sizeof a);
    }
    bat_surface_free(made);
    options.hold_count = 0, options.reach = 1e-3;
    made = NULL;
    assert_int_equal(lift(s, 4.4, &options, &made, weights, &report), BAT_FAR); /* reaches no row */
    bat_surface_free(s);
}

/* In a closed direction the bump crosses the seam unseen. */
static void across_the_seam(void **state) {
    (void)state;
    bat_surface *s = sheet(16, true, false), *here = NULL, *there = NULL;
    bat_surface_redraw_report report;
    double a[ROWS], b[ROWS];
    for (int k = 0; k < 10; k++) {
        const double u = 0.13 * k - 0.6;
        assert_int_equal(lift(s, u, NULL, &here, a, &report), BAT_OK);
        assert_true(report.moved[0] < report.value && report.moved[1] > report.value);
        assert_true(report.moved[1] - report.moved[0] < 9);
        assert_int_equal(lift(s, u + 8, NULL, &there, b, NULL), BAT_OK);
        for (int i = 0; i < 16; i++) assert_true(fabs(a[i] - b[(i + 8) % 16]) < 1e-13);
        bat_surface_free(here), bat_surface_free(there);
    }
    bat_surface_free(s);
}

static void what_is_refused(void **state) {
    (void)state;
    random_source r = {2};
    bat_surface *s = sheet(16, false, true), *made = NULL;
    bat_surface_redraw_options options = bat_surface_redraw_defaults();
    bat_curve *line = other_line(&r, s, BAT_U, 3, false), *flat = NULL, *high = NULL, *coarse = NULL;
    assert_int_equal(bat_curve_to_dimension(line, 2, &flat), BAT_OK);
    assert_int_equal(bat_curve_elevate(line, 4, &high), BAT_OK);
    assert_int_equal(bat_curve_remove_knot(line, 2, 1, 1e9, &coarse, NULL, NULL), BAT_OK);
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, flat, NULL, &made, NULL, NULL), BAT_DIMENSION);
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, high, NULL, &made, NULL, NULL), BAT_DEGREE);
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, coarse, NULL, &made, NULL, NULL), BAT_KNOTS);
    assert_int_equal(bat_surface_redraw(s, BAT_U, NAN, line, NULL, &made, NULL, NULL), BAT_NUMBER);
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, NULL, NULL, &made, NULL, NULL), BAT_ARGUMENT);
    options.reach = NAN;
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, line, &options, &made, NULL, NULL), BAT_ARGUMENT);
    options = bat_surface_redraw_defaults(), options.hold = (const int[1]){16}, options.hold_count = 1;
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, line, &options, &made, NULL, NULL), BAT_ARGUMENT);
    options.size = 8;
    assert_int_equal(bat_surface_redraw(s, BAT_U, 3, line, &options, &made, NULL, NULL), BAT_ARGUMENT);
    bat_surface_free(s);
    /* the tip of a cone */
    const double knots[] = {0, 0, 1, 1}, cone[] = {0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0};
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, cone, (const int[2]){4, 4}, knots, knots,
                                        &s),
                     BAT_OK);
    bat_curve *tip = other_line(&r, s, BAT_U, 0, false);
    assert_int_equal(bat_surface_redraw(s, BAT_U, 0, tip, NULL, &made, NULL, NULL), BAT_DOT);
    assert_null(made);
    bat_curve_free(line), bat_curve_free(flat), bat_curve_free(high), bat_curve_free(coarse),
        bat_curve_free(tip);
    bat_surface_free(s);
}

/* A dome, closed in u, whose lines along v run from a pole (v = 0) to the rim; turned: u and v exchanged. */
static bat_surface *dome(bool turned) {
    enum { ROUND = 12, UP = 7 };
    double knots[2][ROWS], points[ROUND * UP * 3];
    for (int i = 0; i <= ROUND; i++) knots[0][i] = i;
    for (int j = 0; j < UP + 4; j++) knots[1][j] = fmin(fmax(j - 3, 0), UP - 3);
    for (int i = 0; i < ROUND; i++)
        for (int j = 0; j < UP; j++) {
            const double a = i * 6.283185307179586 / ROUND;
            const double p[3] = {3 + 2 * j * cos(a), 2 * j * sin(a), 5 - 0.2 * j * j};
            memcpy(points + 3 * (turned ? ROUND * j + i : UP * i + j), p, sizeof p);
        }
    bat_surface *s = NULL;
    const int a = turned, b = !turned, sizes[2] = {ROUND, UP}, counts[2] = {ROUND + 1, UP + 4};
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){!turned, turned},
                                        (const size_t[2]){(size_t)sizes[a], (size_t)sizes[b]}, points,
                                        (const int[2]){counts[a], counts[b]}, knots[a], knots[b], &s),
                     BAT_OK);
    return s;
}

/* The greatest extent of the dome's pole, over its control points. */
static double opening(const bat_surface *s, bool turned) {
    double most = 0;
    for (int i = 0; i < 12; i++)
        most = fmax(most, apart(point_at(s, turned ? BAT_V : BAT_U, i, 0), bat_surface_row(s, 0), 3));
    return most;
}

/* A pole stays closed: a line that ends there is redrawn where it leaves the pole alone, and refused where it moves it;
 * a line round the pole leaves the pole's row alone. */
static void poles_stay_closed(void **state) {
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        bat_surface *s = dome(turned), *made = NULL;
        const bat_direction to_pole = turned ? BAT_V : BAT_U, round = turned ? BAT_U : BAT_V;
        double points[ROWS * 3], weights[ROWS];
        bat_curve *line = NULL, *other = NULL;
        assert_true(opening(s, turned) == 0);
        assert_int_equal(bat_surface_isocurve(s, to_pole, 4.3, &line), BAT_OK);
        for (int moved = 6; moved >= 0; moved -= 6) { /* the rim's point, or the pole */
            memcpy(points, bat_curve_points(line), 7 * 3 * sizeof *points);
            points[3 * moved + 2] += 1;
            assert_int_equal(bat_curve_create(3, 3, false, 7, points, 11, bat_curve_knots(line), &other),
                             BAT_OK);
            assert_int_equal(bat_surface_redraw(s, to_pole, 4.3, other, NULL, &made, weights, NULL),
                             moved == 0 ? BAT_SINGULAR : BAT_OK);
            assert_true(moved == 0 ? made == NULL : opening(made, turned) == 0);
            bat_surface_free(made), bat_curve_free(other);
            made = NULL, other = NULL;
        }
        bat_curve_free(line);
        line = NULL;
        assert_int_equal(bat_surface_isocurve(s, round, 0.7, &line), BAT_OK);
        memcpy(points, bat_curve_points(line), 12 * 3 * sizeof *points);
        for (int i = 0; i < 12; i++) points[3 * i + 2] += 0.2 * (i % 3);
        assert_int_equal(bat_curve_create(3, 3, true, 12, points, 13, bat_curve_knots(line), &other), BAT_OK);
        assert_int_equal(bat_surface_redraw(s, round, 0.7, other, NULL, &made, weights, NULL), BAT_OK);
        assert_true(opening(made, turned) == 0 && weights[0] == 0 && weights[1] > 0);
        bat_curve_free(line), bat_curve_free(other), bat_surface_free(made), bat_surface_free(s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_line_is_the_new_one), cmocka_unit_test(the_bump),
        cmocka_unit_test(smooth_both_ways),        cmocka_unit_test(holding),
        cmocka_unit_test(across_the_seam),         cmocka_unit_test(what_is_refused),
        cmocka_unit_test(poles_stay_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
