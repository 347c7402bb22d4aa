/* Outlines of strokes: areas of closed forms; membership against the distance to the curve; joins, caps, crossings; bad data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/region.h>
#include "base/real.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { REGIONS = 20 };

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
    for (int round = 0; round < 120; round++) {
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
    assert_true(inside > 500 && outside > 500);
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
    for (int round = 0; round < 60; round++) {
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
    for (int round = 0; round < 24; round++) {
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
    assert_true(inside > 150 && outside > 150 && refused == 0);
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
    assert_true(inside > 100 && outside > 100 && refused == 0);
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

static void spots_without_memory(void **state) {
    (void)state;
    bat_curve *bent = polyline(3, (const double[]){0, 0, 1, 0, 1, 1}, false);
    const bat_nib nib = {1000, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
    const long live = alloc_live();
    for (int n = 1;; n++) {
        size_t count = 7;
        bat_curve **out = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_curve_outline(bent, &nib, 1e-3, CORNER, &count, &out, NULL);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            bat_curves_free(count, out);
            break;
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
    for (int round = 0; round < 60; round++) {
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
        cmocka_unit_test(spots_without_memory),
        cmocka_unit_test(regions_grow_and_shrink),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
