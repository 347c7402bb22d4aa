/* Strokes of varying width: profiles; areas of closed forms; the outline against membership and against the even one; bad data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/width.h>
#include "base/real.h"
#include "relate/outline.h"
#include "support/random_curve.h"

static const double CORNER = 0.02, PI = BAT_PI, LN_10 = 2.302585092994046;

static bat_width_profile profile_of(size_t count, const bat_width_stop *stops) {
    return (bat_width_profile){count, stops};
}

static size_t random_profile(random_source *r, bat_width_stop *stops) {
    size_t count = 0;
    const int wanted = random_int(r, 1, 9);
    for (int i = 0; i < wanted; i++) {
        const double at = random_between(r, -0.1, 1.1);
        const double share = random_between(r, -0.5, 2);
        bat_width_put(&count, stops, at, share, 0.01);
    }
    return count;
}

/* ---- profiles ---- */

static void values_between_stops(void **state) {
    (void)state;
    random_source r = {77};
    for (int round = 0; round < 200; round++) {
        bat_width_stop stops[BAT_WIDTHS_MAX];
        const size_t count = random_profile(&r, stops);
        const bat_width_profile p = profile_of(count, stops);
        assert_int_equal(bat_width_check(&p, NULL), BAT_OK);
        for (int closed = 0; closed < 2; closed++)
            for (size_t i = 0; i < count; i++) {
                double value[2], last = stops[i].share, other[2], back[2];
                bat_width_eval(&p, closed, stops[i].at, value);
                assert_true(fabs(value[0] - stops[i].share) < 1e-12);
                /* monotone up to the next stop, with the derivative that differences show */
                for (int k = 1; i + 1 < count && k <= 20; k++) {
                    const double gap = stops[i + 1].at - stops[i].at, x = stops[i].at + gap * k / 20;
                    bat_width_eval(&p, closed, x, value);
                    assert_true((value[0] - last) * (stops[i + 1].share - stops[i].share) >= -1e-12);
                    last = value[0];
                    if (k == 20) break;
                    bat_width_eval(&p, closed, x + 1e-6 * gap, other);
                    bat_width_eval(&p, closed, x - 1e-6 * gap, back);
                    assert_true(fabs((other[0] - back[0]) / (2e-6 * gap) - value[1]) <
                                1e-3 * (1 + fabs(value[1])));
                }
            }
        double seam[2], start[2];
        bat_width_eval(&p, true, 0, start);
        bat_width_eval(&p, true, 1, seam);
        if (count && stops[0].at > 0 && stops[count - 1].at < 1)
            assert_true(fabs(start[0] - seam[0]) < 1e-12);
    }
    double value[2];
    bat_width_eval(&(bat_width_profile){0}, false, 0.5, value);
    assert_true(value[0] == 1 && value[1] == 0);
}

static void edits_of_stops(void **state) {
    (void)state;
    bat_width_stop stops[BAT_WIDTHS_MAX];
    size_t count = 0;
    assert_int_equal(bat_width_put(&count, stops, 0.5, 2, 0), 0);
    assert_int_equal(bat_width_put(&count, stops, 0.2, -1, 0), 0);
    assert_int_equal(bat_width_put(&count, stops, 7, 1e9, 0), 2);
    assert_true(stops[0].share == 0 && stops[2].at == 1 && stops[2].share == BAT_WIDTH_SHARE_MAX);
    assert_int_equal(bat_width_put(&count, stops, 0.51, 3, 0.02), 1); /* the same one */
    assert_true(count == 3 && stops[1].at == 0.5 && stops[1].share == 3);
    assert_int_equal(bat_width_put(&count, stops, (double)NAN, 1, 0), -1);
    assert_int_equal(bat_width_put(&count, stops, 0.1, (double)INFINITY, 0), -1);
    assert_int_equal(bat_width_move(count, stops, 1, 5, 1), BAT_OK); /* not past its neighbour */
    assert_true(stops[1].at < 1 && stops[1].at > 0.99);
    assert_int_equal(bat_width_move(count, stops, 3, 0.5, 1), BAT_ARGUMENT);
    assert_int_equal(bat_width_move(count, stops, 0, (double)NAN, 1), BAT_NUMBER);
    assert_int_equal(bat_width_move(count, stops, -1, 0.5, 1), BAT_ARGUMENT);
    assert_int_equal(bat_width_remove(&count, stops, 0), BAT_OK);
    assert_true(count == 2 && stops[0].share == 1);
    assert_int_equal(bat_width_remove(&count, stops, 2), BAT_ARGUMENT);
    for (int i = 0; i < BAT_WIDTHS_MAX + 10; i++) bat_width_put(&count, stops, i / 300.0, 1, 0);
    assert_true(count == BAT_WIDTHS_MAX);
    assert_int_equal(bat_width_check(&(bat_width_profile){count, stops}, NULL), BAT_OK);
    const bat_width_stop bad[][2] = {{{0.5, 1}, {0.5, 2}}, {{0.5, 1}, {0.2, 2}}, {{-0.1, 1}, {0.5, 1}},
                                     {{0, 1}, {1.5, 1}},   {{0, -1}, {1, 1}},    {{0, 1}, {1, (double)NAN}}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(bat_width_check(&(bat_width_profile){2, bad[i]}, NULL), BAT_NUMBER);
    assert_int_equal(bat_width_check(&(bat_width_profile){1, NULL}, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_width_check(&(bat_width_profile){BAT_WIDTHS_MAX + 1, stops}, NULL), BAT_COUNT);
}

static void stretches_and_reversal(void **state) {
    (void)state;
    const bat_width_stop stops[] = {{0.1, 1}, {0.4, 3}, {0.8, 2}};
    const bat_width_profile p = profile_of(3, stops);
    bat_width_stop out[BAT_WIDTHS_MAX], again[BAT_WIDTHS_MAX];
    double a[2], b[2];
    const bat_width_profile back = profile_of(bat_width_stretch(&p, 1, 0, out), out);
    assert_int_equal(bat_width_check(&back, NULL), BAT_OK);
    const bat_width_profile twice = profile_of(bat_width_stretch(&back, 1, 0, again), again);
    for (int k = 0; k <= 10; k++) {
        bat_width_eval(&p, false, k / 10.0, a);
        bat_width_eval(&twice, false, k / 10.0, b);
        assert_true(fabs(a[0] - b[0]) < 0.02);
    }
    const bat_width_profile part = profile_of(bat_width_stretch(&p, 0.4, 0.8, out), out);
    assert_true(part.count == 2 && fabs(out[0].share - 3) < 1e-12 && fabs(out[1].share - 2) < 1e-12);
    assert_int_equal(bat_width_stretch(&p, 0.5, 0.5, out), 0);
    assert_int_equal(bat_width_stretch(&(bat_width_profile){0}, 0, 1, out), 0);
}

/* ---- areas ---- */

static bat_curve *polyline(int count, const double *points, bool closed) {
    double knots[16];
    bat_curve *curve;
    for (int i = 0; i < 16; i++) knots[i] = i;
    assert_int_equal(closed ? bat_curve_create(2, 1, true, (size_t)count, points, count + 1, knots, &curve)
                            : bat_curve_create_clamped(2, 1, (size_t)count, points, &curve),
                     BAT_OK);
    return curve;
}

static double sum_of(size_t count, bat_curve **out) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        assert_true(bat_curve_is_closed(out[i]));
        sum += bat_curve_area(out[i]);
    }
    bat_curves_free(count, out);
    return sum;
}

static double area_of(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *p,
                      double tolerance) {
    size_t count;
    bat_curve **out;
    double error;
    assert_int_equal(bat_curve_outline_width(curve, nib, p, tolerance, CORNER, &count, &out, &error), BAT_OK);
    assert_true(error <= 1.2 * tolerance);
    return sum_of(count, out);
}

static void areas_of_a_line(void **state) {
    (void)state;
    bat_curve *line = polyline(2, (const double[]){0, 0, 10, 0}, false);
    const bat_width_stop cone[] = {{0, 0.5}, {1, 1.5}}, tip[] = {{0, 0}, {1, 1}},
                         leaf[] = {
                             {0, 0}, {0.5, 1}, {1, 0}}; /* each half: 5 times 2 (1/2 + slope 3 * 0.5 / 12) */
    const bat_width_profile a = profile_of(2, cone), b = profile_of(2, tip), c = profile_of(3, leaf);
    const bat_nib butt = {2, BAT_CAP_BUTT, BAT_JOIN_ROUND, 4}, round = {2, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4},
                  square = {2, BAT_CAP_SQUARE, BAT_JOIN_ROUND, 4};
    assert_true(fabs(area_of(line, &butt, &a, 1e-6) - 20) < 1e-4); /* a trapezoid: 10 (1 + 3) / 2 */
    assert_true(fabs(area_of(line, &round, &a, 1e-6) - 20 - PI / 2 * (0.25 + 2.25)) < 1e-4);
    assert_true(fabs(area_of(line, &square, &a, 1e-6) - 20 - 0.5 - 4.5) < 1e-4);
    assert_true(fabs(area_of(line, &butt, &b, 1e-6) - 10) < 1e-4);   /* a triangle */
    assert_true(fabs(area_of(line, &square, &b, 1e-6) - 12) < 1e-4); /* no cap where there is no width */
    assert_true(fabs(area_of(line, &round, &c, 1e-6) - 12.5) <
                1e-4); /* two cubics, each symmetric in itself */
    bat_curve_free(line);
}

/* Where a stroke does not lie over itself, its area is that of the profile over the length. */
static void areas_of_arcs(void **state) {
    (void)state;
    /* a circle, by cubics within 1e-9 */
    enum { ARCS = 24 };
    double points[2 * (3 * ARCS + 1)];
    const double handle = 4.0 / 3 * bat_tan(0.5 * PI / ARCS), radius = 10;
    for (int i = 0; i <= ARCS; i++) {
        const double angle = 2 * PI * (i % ARCS) / ARCS, x = bat_cos(angle), y = bat_sin(angle);
        points[6 * i] = radius * x, points[6 * i + 1] = radius * y;
        if (i < ARCS)
            points[6 * i + 2] = radius * (x - handle * y), points[6 * i + 3] = radius * (y + handle * x);
        if (i > 0)
            points[6 * i - 2] = radius * (x + handle * y), points[6 * i - 1] = radius * (y - handle * x);
    }
    bat_curve *circle, *arc;
    assert_int_equal(bat_curve_from_bezier(2, 3, true, ARCS, points, 0.1, 1e-9, &circle, NULL), BAT_OK);
    assert_int_equal(bat_curve_from_bezier(2, 3, false, ARCS / 2, points, 0.1, 1e-9, &arc, NULL), BAT_OK);
    const bat_width_stop even[] = {{0, 1}, {1, 1}}, slope[] = {{0, 0.5}, {1, 1.5}},
                         wave[] = {{0.25, 2}, {0.75, 1}};
    const bat_width_profile a = profile_of(2, even), b = profile_of(2, slope), c = profile_of(2, wave);
    const bat_nib nib = {2, BAT_CAP_BUTT, BAT_JOIN_ROUND, 4};
    assert_true(fabs(area_of(circle, &nib, &a, 1e-6) - PI * (11 * 11 - 9 * 9)) < 1e-3); /* a ring */
    assert_true(fabs(area_of(arc, &nib, &b, 1e-6) - PI * radius * 2) < 1e-3);
    assert_true(fabs(area_of(circle, &nib, &c, 1e-6) - 2 * PI * radius * 3) < 1e-3);
    bat_curve_free(circle), bat_curve_free(arc);
}

static void areas_of_joins(void **state) {
    (void)state;
    bat_curve *angle = polyline(3, (const double[]){0, 0, 10, 0, 10, 10}, false);
    /* widths 1 to 3, 2 at the corner: what lies twice there is a square less the slopes of the sides */
    const bat_width_stop stops[] = {{0, 0.5}, {1, 1.5}};
    const bat_width_profile p = profile_of(2, stops);
    double areas[3];
    for (int join = 0; join < 3; join++) {
        const bat_nib nib = {2, BAT_CAP_BUTT, (bat_join)join, 4};
        areas[join] = area_of(angle, &nib, &p, 1e-6);
    }
    assert_true(fabs(areas[BAT_JOIN_MITER] - areas[BAT_JOIN_BEVEL] - 0.5) < 1e-4);
    assert_true(fabs(areas[BAT_JOIN_ROUND] - areas[BAT_JOIN_BEVEL] - (PI / 4 - 0.5)) < 1e-4);
    bat_curve_free(angle);
}

static void even_profiles_are_strokes(void **state) {
    (void)state;
    random_source r = {78};
    const bat_width_stop stops[] = {{0.2, 0.5}, {0.7, 0.5}}, none[] = {{0, 0}};
    const bat_width_profile p = profile_of(2, stops), zero = profile_of(1, none);
    for (int round = 0; round < 6; round++) {
        const int kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, 3, 2, kind, 4), **a, **b;
        size_t m, n;
        assert_int_equal(bat_curve_outline(curve, &(bat_nib){1, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4}, 1e-3,
                                           CORNER, &m, &a, NULL),
                         BAT_OK);
        const bat_nib nib = {2, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
        assert_int_equal(bat_curve_outline_width(curve, &nib, &p, 1e-3, CORNER, &n, &b, NULL), BAT_OK);
        assert_true(m == n && sum_of(m, a) == sum_of(n, b));
        assert_int_equal(bat_curve_outline_width(curve, &nib, &zero, 1e-3, CORNER, &n, &b, NULL), BAT_OK);
        assert_true(n == 0 && !b);
        bat_curve_free(curve);
    }
}

/* ---- what is inside ---- */

static int winding_of(size_t cubics, const double *points, const double *x) {
    enum { CHORDS = 64 };
    int sum = 0;
    for (size_t i = 0; i < cubics; i++) {
        const double *p = points + 8 * i;
        double a[2] = {p[0], p[1]}, b[2];
        for (int k = 1; k <= CHORDS; k++, memcpy(a, b, sizeof a)) {
            const double t = (double)k / CHORDS, u = 1 - t;
            for (int c = 0; c < 2; c++)
                b[c] = k == CHORDS ? p[6 + c]
                                   : u * u * u * p[c] + 3 * u * u * t * p[2 + c] + 3 * u * t * t * p[4 + c] +
                                         t * t * t * p[6 + c];
            const double side = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
            if (a[1] <= x[1] && b[1] > x[1] && side > 0) sum++;
            if (a[1] > x[1] && b[1] <= x[1] && side < 0) sum--;
        }
    }
    return sum;
}

static int winding(size_t count, bat_curve *const *curves, const double *x) {
    int sum = 0;
    for (size_t i = 0; i < count; i++) {
        double *cubics;
        int n;
        assert_int_equal(bat_curve_to_cubics(curves[i], 1e-6, &n, &cubics), BAT_OK);
        sum += winding_of((size_t)n, cubics, x);
        bat_free(cubics);
    }
    return sum;
}

/* Many lines across a curve. */
typedef struct across {
    int count;
    double *points, *normals, *halves;
} across;

static bool is_on(const across *a, const double *x, double slack) {
    for (int i = 0; i + 1 < a->count; i++) {
        /* between two lines across, each from side to side */
        double corner[4][2];
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 2; c++) {
                const double out = fmax(a->halves[i + k] + slack, 0) * a->normals[2 * (i + k) + c];
                corner[k][c] = a->points[2 * (i + k) + c] - out,
                corner[3 - k][c] = a->points[2 * (i + k) + c] + out;
            }
        if (a->halves[i] + slack <= 0 || a->halves[i + 1] + slack <= 0) continue;
        int left = 0, right = 0;
        for (int part = 0; part < 2; part++) { /* as two triangles, whichever way they run */
            left = right = 0;
            for (int k = 0; k < 3; k++) {
                const double *p = corner[part ? (k == 0 ? 0 : k + 1) : k], *q = corner[part ? (k == 2   ? 0
                                                                                               : k == 0 ? 2
                                                                                                        : 3)
                                                                                            : (k + 1) % 3];
                const double side = (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
                left += side >= 0, right += side <= 0;
            }
            if (left == 3 || right == 3) return true;
        }
    }
    return false;
}

static void what_is_inside(void **state) {
    (void)state;
    random_source r = {79};
    enum { LINES = 1500 };
    across a = {.count = LINES + 1,
                .points = malloc(2 * (LINES + 1) * sizeof(double)),
                .normals = malloc(2 * (LINES + 1) * sizeof(double)),
                .halves = malloc((LINES + 1) * sizeof(double))};
    assert_true(a.points && a.normals && a.halves);
    int inside = 0, outside = 0, refused = 0, wrong = 0, holes = 0;
    for (int round = 0; round < 40; round++) {
        const int degree = random_int(&r, 2, 5), extra = random_int(&r, 0, 4);
        bat_curve *curve = random_curve(&r, degree, 2, 1, extra);
        bat_width_stop stops[BAT_WIDTHS_MAX];
        const bat_width_profile p = profile_of(random_profile(&r, stops), stops);
        const double size = bat_curve_size(curve),
                     half = size * bat_exp(-random_between(&r, 0.6, 1.8) * LN_10);
        const bat_nib nib = {2 * half, BAT_CAP_BUTT, BAT_JOIN_BEVEL, 4};
        double domain[2], low[2], high[2], d[4], *points;
        size_t cubics, count = 0;
        bat_curve **out = NULL;
        bat_curve_domain(curve, domain);
        const double length = bat_curve_length(curve, domain[0], domain[1], 1e-6);
        for (int i = 0; i <= LINES; i++) {
            const double share = (double)i / LINES;
            double value[2];
            bat_curve_eval(curve, bat_curve_at_length(curve, domain[0], share * length, 1e-6), 1, d);
            const double speed = fmax(bat_hypot(d[2], d[3]), 1e-12);
            bat_width_eval(&p, false, share, value);
            memcpy(a.points + 2 * i, d, 2 * sizeof *d);
            a.normals[2 * i] = -d[3] / speed, a.normals[2 * i + 1] = d[2] / speed,
                          a.halves[i] = half * value[0];
        }
        double bent = 1; /* where it turns about faster than can be seen, the lines are too few */
        for (int i = 0; i < LINES; i++)
            bent = fmin(bent, a.normals[2 * i] * a.normals[2 * i + 2] +
                                  a.normals[2 * i + 1] * a.normals[2 * i + 3]);
        if (bent < 0.9) {
            bat_curve_free(curve);
            continue;
        }
        assert_int_equal(bat_curve_cover_width(curve, &nib, &p, 1e-4 * size, CORNER, &cubics, &points),
                         BAT_OK);
        const bat_status status = bat_curve_outline_width(curve, &nib, &p, 1e-4 * size, CORNER, &count, &out,
                                                          NULL);
        if (status != BAT_OK) refused++;
        bat_curve_bounds(curve, low, high);
        for (int k = 0; k < 60; k++) {
            double x[2];
            for (int c = 0; c < 2; c++) x[c] = random_between(&r, low[c] - 1.5 * half, high[c] + 1.5 * half);
            const bool in = is_on(&a, x, -2e-3 * size), near = is_on(&a, x, 2e-3 * size);
            if (in != near) continue;
            const bool covered = winding_of(cubics, points, x) != 0, outlined = winding(count, out, x) != 0;
            if (covered != in) wrong++;
            if (status == BAT_OK && outlined != in) holes++;
            ++*(in ? &inside : &outside);
        }
        bat_free(points);
        bat_curves_free(count, out), bat_curve_free(curve);
    }
    free(a.points), free(a.normals), free(a.halves);
    print_message("%d inside, %d outside, %d refused, %d wrong, %d of outlines\n", inside, outside, refused,
                  wrong, holes);
    assert_true(inside > 150 && outside > 150 && refused == 0 && wrong == 0 && holes == 0);
}

/* Wide strokes that lie over themselves, of whose parallels no outline can be made: the outline is where the cover is. */
static void even_strokes_over_themselves(void **state) {
    (void)state;
    random_source r = {2};
    int other_way = 0, inside = 0;
    for (int round = 0; round < 60; round++) {
        const int degree = random_int(&r, 1, 6), kind = random_int(&r, 0, 2), extra = random_int(&r, 0, 7);
        bat_curve *curve = random_curve(&r, degree, 2, kind, extra), **out = NULL;
        const double size = bat_curve_size(curve), tolerance = 2e-4 * size,
                     half = size * bat_exp(-random_between(&r, 0.6, 2) * LN_10);
        const int cap = random_int(&r, 0, 2), join = random_int(&r, 0, 2);
        const bat_nib nib = {2 * half, (bat_cap)cap, (bat_join)join, 4};
        const bat_width_profile even = {0, NULL};
        size_t count = 0, cubics;
        double low[2], high[2], *points;
        const bat_status plain = bat_outline_parallels(curve, &nib, tolerance, CORNER, &count, &out, NULL);
        if (plain == BAT_OK) bat_curves_free(count, out);
        if (plain == BAT_SINGULAR) {
            other_way++;
            assert_int_equal(
                bat_curve_outline_width(curve, &nib, &even, tolerance, CORNER, &count, &out, NULL), BAT_OK);
            assert_int_equal(bat_curve_cover_width(curve, &nib, &even, tolerance, CORNER, &cubics, &points),
                             BAT_OK);
            bat_curve_bounds(curve, low, high);
            for (int k = 0; k < 200; k++) {
                double x[2];
                for (int c = 0; c < 2; c++)
                    x[c] = random_between(&r, low[c] - 1.5 * half, high[c] + 1.5 * half);
                const int outlined = winding(count, out, x);
                double gap = INFINITY;
                for (size_t i = 0; i < count; i++) {
                    bat_near near;
                    bat_curve_nearest(out[i], x, &near);
                    gap = fmin(gap, near.distance);
                }
                if (gap < 4 * tolerance) continue;
                assert_true(outlined == (winding_of(cubics, points, x) != 0));
                inside += outlined;
            }
            bat_free(points);
            bat_curves_free(count, out);
        }
        bat_curve_free(curve);
    }
    print_message("%d of 60, %d places inside\n", other_way, inside);
    assert_true(other_way >= 4 && inside > 100);
}

static void bad_data(void **state) {
    (void)state;
    bat_curve *line = polyline(2, (const double[]){0, 0, 10, 0}, false), **out, *space, *dot;
    const bat_nib good = {1, BAT_CAP_BUTT, BAT_JOIN_MITER, 4};
    const bat_width_stop stops[] = {{0, 1}, {1, 2}}, wrong[] = {{0.5, 1}, {0.5, 2}};
    const bat_width_profile p = profile_of(2, stops), bad = profile_of(2, wrong);
    double *points;
    size_t count;
    bat_nib nib = good;
    nib.width = 0;
    assert_int_equal(bat_curve_outline_width(line, &nib, &p, 1e-3, 0.1, &count, &out, NULL), BAT_ARGUMENT);
    for (double tolerance = 1e-14; tolerance > 0; tolerance *= 1e-155) {
        assert_int_equal(bat_curve_outline_width(line, &good, &p, tolerance, 0.1, &count, &out, NULL),
                         BAT_TOLERANCE);
        assert_int_equal(bat_curve_outline(line, &good, tolerance, 0.1, &count, &out, NULL), BAT_TOLERANCE);
    }
    assert_int_equal(bat_curve_outline_width(NULL, &good, &p, 1e-3, 0.1, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_outline_width(line, &good, &bad, 1e-3, 0.1, &count, &out, NULL), BAT_NUMBER);
    assert_int_equal(bat_curve_cover_width(line, &good, &p, 0, 0.1, &count, &points), BAT_ARGUMENT);
    assert_int_equal(bat_curve_cover_width(line, &good, &p, (double)NAN, 0.1, &count, &points), BAT_ARGUMENT);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, (const double[]){0, 0, 0, 1, 1, 1}, &space), BAT_OK);
    assert_int_equal(bat_curve_cover_width(space, &good, &p, 1e-3, 0.1, &count, &points), BAT_DIMENSION);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, (const double[]){1, 1, 1, 1}, &dot), BAT_OK);
    assert_int_equal(bat_curve_cover_width(dot, &good, &p, 1e-3, 0.1, &count, &points), BAT_OK);
    assert_int_equal(count, 0); /* no stroke of a point */
    bat_free(points);
    assert_int_equal(bat_curve_outline_width(dot, &good, &p, 1e-3, 0.1, &count, &out, NULL), BAT_OK);
    assert_int_equal(count, 0);
    bat_curve_free(line), bat_curve_free(space), bat_curve_free(dot);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_between_stops),
                                       cmocka_unit_test(edits_of_stops),
                                       cmocka_unit_test(stretches_and_reversal),
                                       cmocka_unit_test(areas_of_a_line),
                                       cmocka_unit_test(areas_of_arcs),
                                       cmocka_unit_test(areas_of_joins),
                                       cmocka_unit_test(even_profiles_are_strokes),
                                       cmocka_unit_test(what_is_inside),
                                       cmocka_unit_test(even_strokes_over_themselves),
                                       cmocka_unit_test(bad_data)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
