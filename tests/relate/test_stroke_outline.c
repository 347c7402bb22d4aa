/* Outlines of strokes: areas of closed forms; membership against the distance to the curve; joins, caps, crossings; bad data. */
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
#include <batten/region.h>
#include "base/real.h"
#include "relate/segment.h"
#include "relate/spot.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/rounds.h"

enum { REGIONS = ROUNDS_OF(20), STROKES = ROUNDS_OF(24), HARD = ROUNDS_OF(120), DOTS = ROUNDS_OF(60) };

static const double CORNER = 0.02;
static const double PI = BAT_PI, LN_10 = 2.302585092994046;

static bat_curve *polyline(int count, const double *points, bool closed) {
    double knots[16];
    bat_curve *curve;
    for (int i = 0; i < 16; i++) knots[i] = i;
    assert_int_equal(closed ? bat_curve_create(2, 1, true, (size_t)count, points, count + 1, knots, &curve)
                            : bat_curve_create_clamped(2, 1, (size_t)count, points, &curve),
                     BAT_OK);
    return curve;
}

static double area_of(const bat_curve *curve, const bat_nib *nib, double tolerance) {
    size_t count;
    bat_curve **out;
    double sum = 0, error;
    assert_int_equal(bat_curve_outline(curve, nib, tolerance, CORNER, &count, &out, &error), BAT_OK);
    assert_true(error <= 1.2 * tolerance);
    for (size_t i = 0; i < count; i++) {
        assert_true(bat_curve_is_closed(out[i]));
        sum += bat_curve_area(out[i]);
    }
    bat_curves_free(count, out);
    return sum;
}

static void areas_of_caps(void **state) {
    (void)state;
    bat_curve *line = polyline(2, (const double[]){0, 0, 10, 0}, false);
    assert_true(fabs(area_of(line, &(bat_nib){2, BAT_CAP_BUTT, BAT_JOIN_ROUND, 4}, 1e-6) - 20) < 1e-5);
    assert_true(fabs(area_of(line, &(bat_nib){2, BAT_CAP_SQUARE, BAT_JOIN_ROUND, 4}, 1e-6) - 24) < 1e-5);
    assert_true(fabs(area_of(line, &(bat_nib){2, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4}, 1e-6) - 20 - PI) < 1e-5);
    bat_curve_free(line);
}

/* A right angle with legs of 10, width 2: the corner adds a square, a triangle or a quarter of a disc. */
static void areas_of_joins(void **state) {
    (void)state;
    bat_curve *angle = polyline(3, (const double[]){0, 0, 10, 0, 10, 10}, false);
    static const struct {
        bat_join join;
        double limit, corner;
    } cases[] = {{BAT_JOIN_MITER, 4, 1},
                 {BAT_JOIN_MITER, 1.2, 0.5},
                 {BAT_JOIN_BEVEL, 4, 0.5},
                 {BAT_JOIN_ROUND, 4, 0.785398163397448310}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const bat_nib nib = {2, BAT_CAP_BUTT, cases[i].join, cases[i].limit};
        assert_true(fabs(area_of(angle, &nib, 1e-6) - 39 - cases[i].corner) < 1e-5);
    }
    bat_curve_free(angle);
    bat_curve *box = polyline(4, (const double[]){0, 0, 10, 0, 10, 10, 0, 10}, true);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const bat_nib nib = {2, BAT_CAP_BUTT, cases[i].join, cases[i].limit};
        assert_true(fabs(area_of(box, &nib, 1e-6) - 76 - 4 * cases[i].corner) < 1e-5);
        const bat_nib wide = {22, BAT_CAP_BUTT, cases[i].join, cases[i].limit}; /* nothing is left inside */
        assert_true(fabs(area_of(box, &wide, 1e-6) - 100 - 440 - 121 * 4 * cases[i].corner) < 1e-3);
    }
    bat_curve_free(box);
}

/* Whether closed curves hold a point: chords, by the winding number. */
static int winding(size_t count, bat_curve *const *curves, const double *x, double tolerance) {
    int sum = 0;
    for (size_t i = 0; i < count; i++) {
        size_t n;
        double *points;
        assert_int_equal(bat_curve_flatten(curves[i], tolerance, &n, &points, NULL), BAT_OK);
        for (size_t k = 1; k < n; k++) {
            const double *a = points + 2 * k - 2, *b = a + 2;
            const double side = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
            if (a[1] <= x[1] && b[1] > x[1] && side > 0) sum++;
            if (a[1] > x[1] && b[1] <= x[1] && side < 0) sum--;
        }
        bat_free(points);
    }
    return sum;
}

/* Cubics with cusps, folds, and handles of no length: each kind of them. */
static bat_curve *hard_cubic(random_source *r, int kind) {
    double x[8];
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    bat_curve *curve;
    for (int i = 0; i < 8; i++) x[i] = random_between(r, 0, 100);
    const double s = random_between(r, -1, 2), t = random_between(r, -1, 2);
    for (int c = 0; c < 2; c++) {
        if (kind == 0) x[2 + c] = x[c];
        if (kind == 1) x[4 + c] = x[6 + c];
        if (kind == 3) x[2 + c] = x[c] + s * (x[6 + c] - x[c]), x[4 + c] = x[c] + t * (x[6 + c] - x[c]);
    }
    if (kind == 2) { /* a cusp in the middle */
        const double a[2] = {x[0], x[1]}, b[2] = {x[2], x[3]};
        x[2] = b[0], x[3] = b[1], x[4] = a[0], x[5] = b[1], x[6] = b[0], x[7] = a[1];
    }
    assert_int_equal(bat_curve_create(2, 3, false, 4, x, 8, knots, &curve), BAT_OK);
    return curve;
}

/* With round caps and joins inside is what is near, whatever the curve does; none is refused, with no cap. */
static void hard_strokes(void **state) {
    (void)state;
    random_source r = {1613};
    int inside = 0, outside = 0;
    for (int round = 0; round < HARD; round++) {
        bat_curve *curve = hard_cubic(&r, round % 4), **out;
        const double size = bat_curve_size(curve),
                     half = size * bat_exp(-random_between(&r, 0.4, 1.8) * LN_10);
        double low[2], high[2], error;
        size_t count;
        bat_curve_bounds(curve, low, high);
        for (int cap = 0; cap < 3; cap++) {
            const bat_nib nib = {2 * half, (bat_cap)cap, BAT_JOIN_ROUND, 4};
            assert_int_equal(bat_curve_outline(curve, &nib, 1e-4 * size, CORNER, &count, &out, &error),
                             BAT_OK);
            assert_true(cap != BAT_CAP_ROUND || error <= 3e-4 * size);
            for (int k = 0; k < 40 && cap == BAT_CAP_ROUND; k++) {
                double x[2];
                bat_near near;
                for (int c = 0; c < 2; c++)
                    x[c] = random_between(&r, low[c] - 1.5 * half, high[c] + 1.5 * half);
                assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
                if (fabs(near.distance - half) < 1e-3 * size) continue;
                assert_int_equal(winding(count, out, x, 1e-4 * size), near.distance < half);
                ++*(near.distance < half ? &inside : &outside);
            }
            bat_curves_free(count, out);
        }
        bat_curve_free(curve);
    }
    assert_true(inside > 4 * HARD && outside > 4 * HARD);
}

/* A dot with round caps is a circle. */
static void dots(void **state) {
    (void)state;
    bat_curve *dot = polyline(2, (const double[]){3, 4, 3, 4}, false);
    assert_true(fabs(area_of(dot, &(bat_nib){8, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4}, 1e-6) - 16 * PI) < 1e-4);
    bat_curve_free(dot);
}

/* A handle of no length bends endlessly: with a butt cap, too, it takes some thousand allocations, not a million. */
static void retracted_ends(void **state) {
    (void)state;
    enum { FEW = 12000 };
    random_source r = {1619};
    for (int round = 0; round < DOTS; round++) {
        bat_curve *curve = hard_cubic(&r, round % 2), **out;
        const double size = bat_curve_size(curve),
                     half = size * bat_exp(-random_between(&r, 0.9, 2.5) * LN_10);
        const bat_nib nib = {2 * half, BAT_CAP_BUTT, BAT_JOIN_MITER, 4};
        size_t count;
        alloc_fail_at(FEW);
        assert_int_equal(bat_curve_outline(curve, &nib, 2e-3 * half, CORNER, &count, &out, NULL), BAT_OK);
        assert_false(alloc_fail_reached());
        bat_curves_free(count, out), bat_curve_free(curve);
    }
}

/* Random curves, a good part of which cross themselves: with round caps and joins, inside is what is near. */
static void inside_is_near(void **state) {
    (void)state;
    random_source r = {1601};
    int inside = 0, outside = 0, refused = 0;
    for (int round = 0; round < STROKES; round++) {
        const int degree = random_int(&r, 1, 5), style = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, degree, 2, style, random_int(&r, 0, 7));
        const double size = bat_curve_size(curve),
                     half = size * bat_exp(-random_between(&r, 0.4, 1.8) * LN_10);
        const bat_nib nib = {2 * half, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
        size_t count;
        bat_curve **out;
        double low[2], high[2], error;
        const bat_status status = bat_curve_outline(curve, &nib, 1e-4 * size, CORNER, &count, &out, &error);
        if (status != BAT_OK) {
            assert_int_equal(status, BAT_SINGULAR);
            print_message("round %d closed %d degree %d points %zu half/size %g:", round,
                          bat_curve_is_closed(curve), bat_curve_degree(curve), bat_curve_count(curve),
                          half / size);
            for (size_t i = 0; i < 2 * bat_curve_count(curve); i++)
                print_message(" %g", bat_curve_points(curve)[i]);
            print_message("\n");
            refused++, bat_curve_free(curve);
            continue;
        }
        assert_true(error <= 1.2e-4 * size);
        bat_curve_bounds(curve, low, high);
        for (int k = 0; k < 40; k++) {
            double x[2];
            for (int c = 0; c < 2; c++) x[c] = random_between(&r, low[c] - 1.5 * half, high[c] + 1.5 * half);
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
            if (fabs(near.distance - half) < 1e-3 * size)
                continue; /* beside what chords and the tolerance can tell */
            assert_int_equal(winding(count, out, x, 1e-4 * size), near.distance < half);
            ++*(near.distance < half ? &inside : &outside);
        }
        bat_curves_free(count, out), bat_curve_free(curve);
    }
    print_message("%d refused\n", refused);
    assert_true(inside > 6 * STROKES && outside > 6 * STROKES && refused == 0);
}

/* Random closed curves, most of which cross themselves: grown, what is inside or near; shrunk, what is inside and not near. */
static void regions_grow_and_shrink(void **state) {
    (void)state;
    random_source r = {1602};
    int inside = 0, outside = 0, refused = 0;
    for (int round = 0; round < REGIONS; round++) {
        const int degree = random_int(&r, 1, 4);
        bat_curve *curve = random_curve(&r, degree, 2, 2, random_int(&r, 1, 6));
        if (!bat_curve_is_closed(curve)) {
            bat_curve_free(curve);
            continue;
        }
        const double size = bat_curve_size(curve),
                     far = size * bat_exp(-random_between(&r, 0.7, 1.8) * LN_10);
        const double side = random_int(&r, 0, 1) ? 1 : -1;
        const bat_region region = {1, (const bat_curve *const *)&curve, random_int(&r, 0, 1) == 1};
        size_t count;
        bat_curve **out;
        double low[2], high[2];
        const bat_status status = bat_region_offset(&region, side * far, BAT_JOIN_ROUND, 4, 1e-4 * size,
                                                    CORNER, &count, &out);
        if (status != BAT_OK) {
            assert_int_equal(status, BAT_SINGULAR);
            refused++, bat_curve_free(curve);
            continue;
        }
        bat_curve_bounds(curve, low, high);
        for (int k = 0; k < 40; k++) {
            double x[2];
            for (int c = 0; c < 2; c++) x[c] = random_between(&r, low[c] - 1.5 * far, high[c] + 1.5 * far);
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
            const int turns = winding(1, &curve, x, 1e-4 * size);
            const bool in = region.even_odd ? turns & 1 : turns != 0;
            /* a boundary with the region on both sides is none: only the outermost one is grown */
            if (fabs(near.distance - far) < 1e-3 * size || near.distance < 1e-3 * size ||
                (in && near.distance < far))
                continue;
            const bool expected = side > 0 ? in || near.distance < far : in && near.distance > far;
            assert_int_equal(winding(count, out, x, 1e-4 * size), expected);
            ++*(expected ? &inside : &outside);
        }
        bat_curves_free(count, out), bat_curve_free(curve);
    }
    print_message("%d refused, %d inside, %d outside\n", refused, inside, outside);
    assert_true(inside > 5 * REGIONS && outside > 5 * REGIONS && refused == 0);
}

/* A loop whose end butts against its own stem: what the stem covers beyond the end is inside. */
static void an_end_upon_the_stem(void **state) {
    (void)state;
    bat_curve *loop = polyline(5, (const double[]){0, 0, 20, 0, 20, 10, 10, 10, 10, 1}, false);
    const double area = area_of(loop, &(bat_nib){4, BAT_CAP_BUTT, BAT_JOIN_MITER, 4}, 1e-6);
    /* strips of 20, 10, 10, 9 by 4; at the three corners as much lies twice as the mitres add; 4 by 1 lies twice at the end */
    assert_true(fabs(area - (49 * 4 - 4)) < 1e-4);
    bat_curve_free(loop);
}

static void bad_data(void **state) {
    (void)state;
    bat_curve *line = polyline(2, (const double[]){0, 0, 10, 0}, false), **out;
    size_t count;
    const bat_nib good = {1, BAT_CAP_BUTT, BAT_JOIN_MITER, 4};
    bat_nib nibs[] = {good, good, good, good, good};
    nibs[0].width = 0, nibs[1].width = (double)NAN, nibs[2].miter_limit = 0.5, nibs[3].cap = (bat_cap)7,
    nibs[4].width = 1e300;
    for (size_t i = 0; i < sizeof nibs / sizeof *nibs; i++)
        assert_int_equal(bat_curve_outline(line, &nibs[i], 1e-3, 0.1, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_outline(NULL, &good, 1e-3, 0.1, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_outline(line, &good, 0, 0.1, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_outline(line, &good, 1e-3, (double)NAN, &count, &out, NULL), BAT_ARGUMENT);
    bat_curve_free(line);
    bat_curve *dot = polyline(2, (const double[]){3, 3, 3, 3}, false);
    assert_int_equal(bat_curve_outline(dot, &good, 1e-3, 0.1, &count, &out, NULL), BAT_OK);
    assert_int_equal(count, 0);
    bat_curves_free(count, out);
    bat_curve_free(dot);
}

/* ---- what a stroke is, by its definition ---- */

/* A place of a span and its direction there. */
static void place_on(const bat_segment *s, double t, double *point, double *way) {
    double b[2 * (BAT_DEGREE_MAX + 1)];
    const int n = s->degree;
    memcpy(b, s->b, (size_t)(2 * n + 2) * sizeof *b);
    for (int r = n; r > 0; r--) {
        if (r == 1) way[0] = b[2] - b[0], way[1] = b[3] - b[1];
        for (int i = 0; i < 2 * r; i++) b[i] += t * (b[i + 2] - b[i]);
    }
    point[0] = b[0], point[1] = b[1];
    for (int i = 1; i <= n && way[0] == 0 && way[1] == 0; i++) /* a handle of no length */
        for (int c = 0; c < 2; c++)
            way[c] = t < 0.5 ? s->b[2 * i + c] - s->b[c] : s->b[2 * n + c] - s->b[2 * (n - i) + c];
    const double length = bat_hypot(way[0], way[1]);
    way[0] /= length, way[1] /= length;
}

/* How far a point is before the line across a place of a span; its distance from there. */
static double before_line(const bat_segment *s, double t, const double *x, double *distance) {
    double point[2], way[2];
    place_on(s, t, point, way);
    *distance = bat_hypot(x[0] - point[0], x[1] - point[1]);
    return (x[0] - point[0]) * way[0] + (x[1] - point[1]) * way[1];
}

/* How deep in the stroke a point is that lies on lines across a span. */
static double depth_of_lines(const bat_segment *s, double half, const double *x) {
    enum { LOOKS = 160 };
    double best = -INFINITY, distance, last = before_line(s, 0, x, &distance);
    for (int k = 1; k <= LOOKS; k++) {
        double low = (k - 1.0) / LOOKS, high = (double)k / LOOKS, at = before_line(s, high, x, &distance);
        if ((at > 0) != (last > 0)) {
            for (int j = 0; j < 60; j++) {
                const double middle = 0.5 * (low + high);
                *((before_line(s, middle, x, &distance) > 0) == (last > 0) ? &low : &high) = middle;
            }
            best = fmax(best, half - distance);
        }
        last = at;
    }
    return best;
}

static double depth_of_join(const bat_segment *s, const bat_segment *next, const bat_nib *nib,
                            const double *x) {
    double p[2], d[2], e[2], half = 0.5 * nib->width;
    place_on(s, 1, p, d), place_on(next, 0, p, e);
    const double turn = bat_atan2(d[0] * e[1] - d[1] * e[0], d[0] * e[0] + d[1] * e[1]);
    const double v[2] = {x[0] - p[0], x[1] - p[1]}, f = v[0] * d[0] + v[1] * d[1],
                 g = v[0] * e[0] + v[1] * e[1];
    const double side = turn > 0 ? -1 : 1, share = bat_cos(0.5 * turn);
    if (fabs(turn) <= CORNER) return (f > 0) != (g > 0) ? half - bat_hypot(v[0], v[1]) : -INFINITY;
    if (!(f >= 0 && g <= 0)) return -INFINITY;
    if (nib->join == BAT_JOIN_ROUND) return half - bat_hypot(v[0], v[1]);
    const double a = side * (v[1] * d[0] - v[0] * d[1]), b = side * (v[1] * e[0] - v[0] * e[1]);
    return nib->join == BAT_JOIN_MITER && share * nib->miter_limit >= 1
               ? half - fmax(a, b)
               : half * share - (a + b) / (2 * share);
}

static double depth_of_cap(const bat_segment *s, int end, const bat_nib *nib, const double *x) {
    double p[2], d[2], half = 0.5 * nib->width;
    place_on(s, end, p, d);
    const double v[2] = {x[0] - p[0], x[1] - p[1]}, f = (end ? 1 : -1) * (v[0] * d[0] + v[1] * d[1]);
    if (f < 0 || nib->cap == BAT_CAP_BUTT) return -INFINITY;
    return half -
           (nib->cap == BAT_CAP_ROUND ? bat_hypot(v[0], v[1]) : fmax(f, fabs(v[0] * d[1] - v[1] * d[0])));
}

static bool in_stroke(const bat_curve *curve, const bat_nib *nib, const double *x) {
    bat_segment *all;
    int count, n = 0;
    double best = -INFINITY;
    assert_int_equal(bat_segments_of(curve, &count, &all), BAT_OK);
    for (int i = 0; i < count; i++)
        if (bat_segment_reach(all + i) > 0) all[n++] = all[i];
    for (int i = 0; i < n; i++) {
        best = fmax(best, depth_of_lines(all + i, 0.5 * nib->width, x));
        if (i + 1 < n || bat_curve_is_closed(curve))
            best = fmax(best, depth_of_join(all + i, all + (i + 1) % n, nib, x));
    }
    for (int e = 0; e < 2 && !bat_curve_is_closed(curve); e++)
        best = fmax(best, depth_of_cap(all + (e ? n - 1 : 0), e, nib, x));
    free(all);
    return best > 0;
}

/* Strokes far wider than their curves, with all caps and joins: inside is what lines across the curve, joins and caps hold. Most are
 * made without looking where pieces meet. */
static void spots_of_all_kinds(void **state) {
    (void)state;
    enum { PLACES = 24, ROUNDS = ROUNDS_OF(18) };
    random_source r = {6401};
    static const double sizes[] = {1, 1e-6, 1e6};
    int made = 0, left = 0, looked = 0, holes = 0;
    for (int round = 0; round < ROUNDS; round++) {
        const int degree = random_int(&r, 1, 5), knots = random_int(&r, 0, 20);
        bat_curve *plain = random_curve(&r, degree, 2, round % 3, knots), *curve, **out;
        size_t count;
        const double scale = sizes[round / 3 % 3], size = bat_curve_size(plain) * scale;
        const double half = size * bat_exp(random_between(&r, 0.7, 5) * LN_10), tolerance = 1e-4 * size;
        const double rows[6] = {scale, 0, 0, 0, scale, 0};
        assert_int_equal(bat_curve_transform(plain, rows, &curve), BAT_OK);
        double low[2], high[2], error;
        bat_curve_bounds(curve, low, high);
        for (int kind = 0; kind < 9; kind++) {
            const bat_nib nib = {2 * half, (bat_cap)(kind / 3), (bat_join)(kind % 3), 4};
            const bat_status status = bat_spot_outline(curve, &nib, tolerance, CORNER, &count, &out, &error);
            if (status == BAT_SINGULAR) {
                left++;
                continue;
            }
            assert_int_equal(status, BAT_OK);
            assert_true(error <= tolerance);
            made++;
            for (int k = 0; k < PLACES; k++) {
                const double angle = random_between(&r, 0, 2 * BAT_PI), share = random_between(&r, -1, 1);
                const double far = k % 3 == 0   ? (1 + share) * size
                                   : k % 3 == 1 ? half + share * size
                                                : (1 + share) * half;
                const double x[2] = {0.5 * (low[0] + high[0]) + far * bat_cos(angle),
                                     0.5 * (low[1] + high[1]) + far * bat_sin(angle)};
                double apart = INFINITY;
                for (size_t i = 0; i < count; i++) {
                    bat_near near;
                    assert_int_equal(bat_curve_nearest(out[i], x, &near), BAT_OK);
                    apart = fmin(apart, near.distance);
                }
                if (apart < 1.5 * tolerance) continue;
                assert_int_equal(winding(count, out, x, 0.1 * tolerance), in_stroke(curve, &nib, x));
                looked++;
            }
            holes += count > 1;
            bat_curves_free(count, out);
        }
        bat_curve_free(curve), bat_curve_free(plain);
    }
    print_message("%d made, %d of them with holes, %d left to others, %d places\n", made, holes, left,
                  looked);
    assert_true(made > 4 * left && looked > 100 * ROUNDS);
}

/* A scribble a thousandth of the width large: every cap and join takes few allocations. */
static void scribbles(void **state) {
    (void)state;
    enum { POINTS = 62, FEW = 1000 };
    random_source r = {6402};
    double x[2 * POINTS];
    for (int i = 0; i < 2 * POINTS; i++) x[i] = 300 + random_between(&r, 0, 0.007);
    bat_curve *curve, **out;
    assert_int_equal(bat_curve_create_clamped(2, 3, POINTS, x, &curve), BAT_OK);
    for (int kind = 0; kind < 9; kind++) {
        const bat_nib nib = {60, (bat_cap)(kind / 3), (bat_join)(kind % 3), 4};
        size_t count;
        double error;
        alloc_fail_at(FEW);
        assert_int_equal(bat_curve_outline(curve, &nib, 1e-6, CORNER, &count, &out, &error), BAT_OK);
        assert_false(alloc_fail_reached());
        assert_true(count == 1 && error <= 1e-6);
        bat_curves_free(count, out);
    }
    bat_curve_free(curve);
}

static void spots_without_memory(void **state) {
    (void)state;
    bat_curve *bent = polyline(3, (const double[]){0, 0, 1, 0, 1, 1}, false);
    const long live = alloc_live();
    for (int n = 1, kind = 0; kind < 2; n++) {
        const bat_nib nib = {1000, kind ? BAT_CAP_BUTT : BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
        size_t count = 7;
        bat_curve **out = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_curve_outline(bent, &nib, 1e-3, CORNER, &count, &out, NULL);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            bat_curves_free(count, out);
            n = 0, kind++;
            continue;
        }
        assert_true(status == BAT_MEMORY && count == 7 && !out && alloc_live() == live);
    }
    bat_curve_free(bent);
}

/* Strokes far wider than their curves are large, at any size: one outline, the half width from the curve everywhere, which has all
 * directions once; it takes few allocations, and turning the curve round or moving it changes nothing. */
static void spots(void **state) {
    (void)state;
    enum { FEW = 1000, PLACES = 60 };
    random_source r = {64};
    static const double sizes[] = {1, 1e-6, 1e6, 1e30, 1e-120};
    for (int round = 0; round < DOTS; round++) {
        const int degree = random_int(&r, 1, 5), knots = random_int(&r, 0, 60);
        bat_curve *plain = random_curve(&r, degree, 2, round % 3, knots), *curve;
        const double scale = sizes[round % 5], size = bat_curve_size(plain) * scale,
                     half = size * bat_exp(random_between(&r, 1.9, 7) * LN_10), tolerance = 1e-4 * size;
        const double rows[6] = {scale, 0, 0, 0, scale, 0};
        assert_int_equal(bat_curve_transform(plain, rows, &curve), BAT_OK);
        const bat_nib nib = {2 * half, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
        size_t count = 0;
        bat_curve **out;
        double error, u[PLACES], turned = 0, before = 0;
        alloc_fail_at(FEW);
        assert_int_equal(bat_curve_outline(curve, &nib, tolerance, CORNER, &count, &out, &error), BAT_OK);
        assert_false(alloc_fail_reached());
        assert_int_equal(count, 1);
        assert_true(bat_curve_is_closed(out[0]) && error <= tolerance);
        assert_true(bat_curve_count(out[0]) < 1000);
        bat_curve_spread(out[0], PLACES, u);
        for (int i = 0; i < PLACES; i++) {
            double x[4];
            bat_near near;
            bat_curve_eval(out[0], u[i], 1, x);
            assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
            assert_true(fabs(near.distance - half) <= error + 1e-12 * half);
            const double angle = bat_atan2(x[3], x[2]);
            double turn = i ? angle - before : 0;
            turned += turn - 2 * BAT_PI * rint(turn / (2 * BAT_PI)), before = angle;
        }
        assert_true(turned > 2 * BAT_PI * (PLACES - 2) / PLACES && turned <= 2 * BAT_PI + 1e-9);
        bat_curves_free(count, out);
        bat_curve_free(curve), bat_curve_free(plain);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_of_caps),
        cmocka_unit_test(areas_of_joins),
        cmocka_unit_test(inside_is_near),
        cmocka_unit_test(hard_strokes),
        cmocka_unit_test(dots),
        cmocka_unit_test(retracted_ends),
        cmocka_unit_test(an_end_upon_the_stem),
        cmocka_unit_test(bad_data),
        cmocka_unit_test(spots),
        cmocka_unit_test(spots_of_all_kinds),
        cmocka_unit_test(scribbles),
        cmocka_unit_test(spots_without_memory),
        cmocka_unit_test(regions_grow_and_shrink),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
