/* Regions against grids that can be counted, and against points asked one by one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/rounds.h"
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/region.h>
#include <batten/relate.h>

#include <math.h>

enum { MOST = 8 };

typedef struct owned {
    bat_curve *curves[MOST];
    bat_region is;
} owned;

static void own(owned *o, bool even_odd) {
    o->is = (bat_region){0, (const bat_curve *const *)o->curves, even_odd};
}

static void add(owned *o, bat_curve *curve) { o->curves[o->is.count++] = curve; }

static void drop(owned *o) {
    for (size_t i = 0; i < o->is.count; i++) bat_curve_free(o->curves[i]);
}

static bat_curve *closed_curve(int degree, size_t count, const double *points) {
    double knots[64];
    bat_curve *curve;
    assert_in_range(count, 3, 60);
    for (size_t i = 0; i <= count; i++) knots[i] = (double)i;
    assert_int_equal(bat_curve_create(2, degree, true, count, points, (int)count + 1, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *box(double x0, double y0, double x1, double y1, bool back, bool cubic) {
    const double round[8] = {x0, y0, x1, y0, x1, y1, x0, y1}, other[8] = {x0, y0, x0, y1, x1, y1, x1, y0};
    bat_curve *curve = closed_curve(1, 4, back ? other : round), *raised;
    if (!cubic) return curve;
    assert_int_equal(bat_curve_elevate(curve, 3, &raised), BAT_OK);
    bat_curve_free(curve);
    return raised;
}

static bat_curve *disc(double x, double y, double radius) {
    double points[24];
    for (int i = 0; i < 12; i++) {
        points[2 * i] = x + radius * cos(i * 0.5235987755982988);
        points[2 * i + 1] = y + radius * sin(i * 0.5235987755982988);
    }
    return closed_curve(3, 12, points);
}

/* How often a polyline runs round a point. */
static int winding(const bat_curve *curve, const double *at, double tolerance) {
    double *p;
    size_t count;
    int sum = 0;
    assert_int_equal(bat_curve_flatten(curve, tolerance, &count, &p, NULL), BAT_OK);
    for (size_t i = 0; i + 1 < count; i++) {
        const double *a = p + 2 * i, *b = a + 2;
        const double side = (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]);
        if (a[1] <= at[1] && b[1] > at[1] && side > 0) sum++;
        if (b[1] <= at[1] && a[1] > at[1] && side < 0) sum--;
    }
    bat_free(p);
    return sum;
}

static int all_windings(size_t count, bat_curve *const *curves, const double *at, double tolerance) {
    int sum = 0;
    for (size_t i = 0; i < count; i++) sum += winding(curves[i], at, tolerance);
    return sum;
}

static bool expected(bat_region_operation op, bool a, bool b) {
    return op == BAT_REGION_UNION          ? a || b
           : op == BAT_REGION_DIFFERENCE   ? a && !b
           : op == BAT_REGION_INTERSECTION ? a && b
                                           : a != b;
}

static bool is_in(const owned *o, const double *at, double tolerance) {
    const int w = all_windings(o->is.count, o->curves, at, tolerance);
    return o->is.even_odd ? w % 2 != 0 : w != 0;
}

static double area_of(size_t count, bat_curve *const *curves) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) sum += bat_curve_area(curves[i]);
    return sum;
}

/* ---- boxes on a grid: edges and corners shared in every way ---- */

enum { GRID = 7 };

static void boxes(random_source *r, owned *o) {
    own(o, random_int(r, 0, 1));
    const bool cubic = random_int(r, 0, 3) == 0;
    const int count = random_int(r, 1, 3);
    for (int i = 0; i < count; i++) {
        const int x = random_int(r, 0, GRID - 1), y = random_int(r, 0, GRID - 1);
        const int w = random_int(r, 1, GRID - x), h = random_int(r, 1, GRID - y);
        add(o, box(x, y, x + w, y + h, random_int(r, 0, 1), cubic));
    }
}

static void boxes_on_a_grid_can_be_counted(void **state) {
    (void)state;
    random_source r = {81};
    int failed = 0;
    for (int i = 0; i < ROUNDS_OF(2000); i++) {
        owned o[2];
        boxes(&r, o), boxes(&r, o + 1);
        const bat_region both[2] = {o[0].is, o[1].is};
        const bat_region_operation op = (bat_region_operation)(i % BAT_REGION_OPERATION_COUNT);
        size_t count;
        bat_curve **out;
        const bat_status status = bat_regions_combine(op, 2, both, 1e-3, &count, &out);
        if (status != BAT_OK) {
            print_message("%d: status %d\n", i, status);
            failed++;
        } else {
            int cells = 0;
            for (int x = 0; x < GRID; x++)
                for (int y = 0; y < GRID; y++) {
                    const double at[2] = {x + 0.5, y + 0.43};
                    const bool in = expected(op, is_in(o, at, 1e-3), is_in(o + 1, at, 1e-3));
                    cells += in;
                    assert_int_equal(all_windings(count, out, at, 1e-3), in);
                }
            assert_true(fabs(area_of(count, out) - cells) < 1e-9);
            bat_curves_free(count, out);
        }
        drop(o), drop(o + 1);
    }
    assert_int_equal(failed, 0);
}

/* ---- curves ---- */

static void blobs(random_source *r, owned *o) {
    own(o, random_int(r, 0, 1));
    const int count = random_int(r, 1, 2);
    for (int i = 0; i < count; i++) {
        double points[40];
        const int n = random_int(r, 4, 12), kind = random_int(r, 0, 2), degree = random_int(r, 1, 3);
        const double x = random_between(r, -3, 3), y = random_between(r, -3, 3);
        for (int k = 0; k < n; k++) {
            const double angle = 2 * 3.141592653589793 * k / n, far = kind == 0 ? 4 : random_between(r, 1, 5);
            points[2 * k] = kind == 2 ? random_between(r, -5, 5) : x + far * cos(angle);
            points[2 * k + 1] = kind == 2 ? random_between(r, -5, 5) : y + far * sin(angle);
        }
        add(o, closed_curve(degree, (size_t)n, points));
    }
}

static double distance_to(const owned *o, const double *at) {
    double least = INFINITY;
    for (size_t i = 0; i < o->is.count; i++) {
        bat_near near;
        assert_int_equal(bat_curve_nearest(o->curves[i], at, &near), BAT_OK);
        least = fmin(least, near.distance);
    }
    return least;
}

static void curves_are_right_point_by_point(void **state) {
    (void)state;
    const double tolerance = 1e-4;
    random_source r = {82};
    int failed = 0;
    for (int i = 0; i < ROUNDS_OF(300); i++) {
        owned o[2];
        blobs(&r, o), blobs(&r, o + 1);
        const bat_region both[2] = {o[0].is, o[1].is};
        const bat_region_operation op = (bat_region_operation)(i % BAT_REGION_OPERATION_COUNT);
        size_t count;
        bat_curve **out;
        const bat_status status = bat_regions_combine(op, 2, both, tolerance, &count, &out);
        if (status != BAT_OK) {
            print_message("%d: status %d\n", i, status);
            failed++;
            drop(o), drop(o + 1);
            continue;
        }
        for (int k = 0; k < 60; k++) {
            double at[2];
            at[0] = random_between(&r, -8, 8);
            at[1] = random_between(&r, -8, 8);
            if (fmin(distance_to(o, at), distance_to(o + 1, at)) < 4 * tolerance) continue;
            assert_int_equal(all_windings(count, out, at, tolerance),
                             expected(op, is_in(o, at, tolerance), is_in(o + 1, at, tolerance)));
        }
        for (size_t c = 0; c < count; c++) { /* nothing of it is off the boundaries */
            double u[24];
            bat_curve_spread(out[c], 24, u);
            for (int k = 0; k < 24; k++) {
                double at[2];
                bat_curve_eval(out[c], u[k], 0, at);
                assert_true(fmin(distance_to(o, at), distance_to(o + 1, at)) <= tolerance);
            }
        }
        bat_curves_free(count, out);
        drop(o), drop(o + 1);
    }
    assert_int_equal(failed, 0);
}

/* ---- what is decided ---- */

/* The result of two curves; returns how many. */
static size_t combined(bat_region_operation op, const bat_curve *a, const bat_curve *b, bat_curve ***out) {
    const bat_region both[2] = {{1, &a, false}, {1, &b, false}};
    size_t count;
    assert_int_equal(bat_regions_combine(op, b ? 2 : 1, both, 1e-3, &count, out), BAT_OK);
    return count;
}

static void expect_area(bat_region_operation op, const bat_curve *a, const bat_curve *b, size_t curves,
                        double area) {
    bat_curve **out;
    const size_t count = combined(op, a, b, &out);
    assert_int_equal(count, curves);
    assert_true(fabs(area_of(count, out) - area) <= 1e-9 * (1 + area));
    bat_curves_free(count, out);
}

static void identical_curves_are_one(void **state) {
    (void)state;
    bat_curve *a = disc(1, 2, 5), *back, *seam;
    assert_int_equal(bat_curve_reverse(a, &back), BAT_OK);
    assert_int_equal(bat_curve_move_seam(a, 3.3, &seam), BAT_OK);
    const double area = bat_curve_area(a);
    assert_true(area > 70 && area < 25 * 3.141592653589793);
    const bat_curve *others[] = {a, back, seam};
    for (int i = 0; i < 3; i++) {
        expect_area(BAT_REGION_UNION, a, others[i], 1, area);
        expect_area(BAT_REGION_INTERSECTION, a, others[i], 1, area);
        expect_area(BAT_REGION_DIFFERENCE, a, others[i], 0, 0);
        expect_area(BAT_REGION_EXCLUSION, a, others[i], 0, 0);
    }
    bat_curve_free(a), bat_curve_free(back), bat_curve_free(seam);
}

/* A ring of n points round a place, every other one further out by `high`: spikes whose boxes all overlap. */
static bat_curve *spikes(int n, double high, double phase, double x, double y) {
    double points[2 * 60];
    for (int i = 0; i < n; i++) {
        const double angle = 6.283185307179586 * (i + phase) / n, r = n / 3.0 + (i % 2 ? high : 0);
        points[2 * i] = x + r * cos(angle), points[2 * i + 1] = y + r * sin(angle);
    }
    return closed_curve(1, (size_t)n, points);
}

static double area_combined(bat_region_operation op, const bat_curve *a, const bat_curve *b) {
    bat_curve **out;
    const size_t count = combined(op, a, b, &out);
    const double area = area_of(count, out);
    bat_curves_free(count, out);
    return area;
}

static void long_spikes_add_up(void **state) {
    (void)state;
    for (int n = 8; n <= 58; n += 10)
        for (int k = 0; k < 6; k++) {
            const double high = k % 2 ? n : 9.0 * n, phase = 0.17 + 0.31 * k;
            bat_curve *a = spikes(n, high, 0, 0, 0), *b = spikes(n, high, phase, 0.1 * k, -0.2 * k);
            const double first = bat_curve_area(a), second = bat_curve_area(b),
                         both = area_combined(BAT_REGION_INTERSECTION, a, b);
            const double bound = 1e-9 * (first + second);
            assert_true(both > 0 && both < first);
            assert_true(fabs(area_combined(BAT_REGION_UNION, a, b) + both - first - second) <= bound);
            assert_true(fabs(area_combined(BAT_REGION_DIFFERENCE, a, b) + both - first) <= bound);
            assert_true(fabs(area_combined(BAT_REGION_EXCLUSION, a, b) + 2 * both - first - second) <= bound);
            bat_curve_free(a), bat_curve_free(b);
        }
}

/* Each crossing of two rings of lines is one of two lines, which the signs of four areas tell. */
static double turn_at(const double *p, const double *q, const double *r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

static void long_spikes_meet_as_lines_do(void **state) {
    (void)state;
    const int n = 58;
    for (int k = 0; k < 20; k++) {
        bat_curve *a = spikes(n, n, 0, 0, 0), *b = spikes(n, 2.0 * n, 0.37 + k, 3.3 * k, 1.1 * k);
        const double *p = bat_curve_points(a), *q = bat_curve_points(b);
        size_t expected = 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                const double *p0 = p + 2 * i, *p1 = p + 2 * ((i + 1) % n), *q0 = q + 2 * j,
                             *q1 = q + 2 * ((j + 1) % n);
                expected += turn_at(p0, p1, q0) * turn_at(p0, p1, q1) < 0 &&
                            turn_at(q0, q1, p0) * turn_at(q0, q1, p1) < 0;
            }
        bat_meeting met;
        assert_int_equal(bat_curve_intersect(a, b, 1e-9, &met), BAT_OK);
        assert_int_equal(met.count, expected);
        bat_meeting_free(&met);
        assert_int_equal(bat_curve_self_intersect(a, 1e-9, &met), BAT_OK);
        assert_int_equal(met.count + met.overlap_count, 0);
        bat_meeting_free(&met);
        bat_curve_free(a), bat_curve_free(b);
    }
}

/* Many rings beside each other, in whatever order: as many areas. */
static void scattered_rings_stay_apart(void **state) {
    (void)state;
    enum { SIDE = 9, RINGS = SIDE * SIDE };
    bat_curve *rings[RINGS];
    double area = 0;
    for (int i = 0; i < RINGS; i++) {
        const int at = i * 37 % RINGS;
        rings[i] = spikes(8, 3, 0.1 * i, 20 * (at % SIDE), 20 * (at / SIDE));
        area += bat_curve_area(rings[i]);
    }
    const bat_region all = {RINGS, (const bat_curve *const *)rings, false};
    size_t count;
    bat_curve **out;
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &all, 1e-3, &count, &out), BAT_OK);
    assert_int_equal(count, RINGS);
    assert_true(fabs(area_of(count, out) - area) <= 1e-9 * area);
    bat_curves_free(count, out);
    for (int i = 0; i < RINGS; i++) bat_curve_free(rings[i]);
}

static void what_does_not_meet_comes_back(void **state) {
    (void)state;
    bat_curve *a = disc(0, 0, 5), *inner = disc(1, 0, 2), *far = disc(20, 0, 3), **out, *back;
    assert_int_equal(combined(BAT_REGION_UNION, a, far, &out), 2);
    assert_true(bat_curve_is_equal(out[0], a) && bat_curve_is_equal(out[1], far));
    bat_curves_free(2, out);
    assert_int_equal(combined(BAT_REGION_DIFFERENCE, a, inner, &out), 2); /* a hole runs the other way */
    assert_true(bat_curve_is_equal(out[0], a));
    assert_int_equal(bat_curve_reverse(inner, &back), BAT_OK);
    assert_true(bat_curve_is_equal(out[1], back));
    bat_curves_free(2, out);
    assert_int_equal(combined(BAT_REGION_UNION, back, a, &out), 1);
    assert_true(bat_curve_is_equal(out[0], a));
    bat_curves_free(1, out);
    assert_int_equal(combined(BAT_REGION_INTERSECTION, a, far, &out), 0);
    bat_curves_free(0, out);
    assert_int_equal(combined(BAT_REGION_DIFFERENCE, inner, a, &out), 0);
    bat_curves_free(0, out);
    bat_curve_free(a), bat_curve_free(inner), bat_curve_free(far), bat_curve_free(back);
}

static void touching_curves_stay_two(void **state) {
    (void)state;
    bat_curve *a = box(0, 0, 2, 2, false, true), *corner = box(2, 2, 3, 3, false, true);
    bat_curve *beside = box(2, 0, 3, 2, false, true), *within = box(1, 0, 2, 1, false, true);
    expect_area(BAT_REGION_UNION, a, corner, 2, 5);
    expect_area(BAT_REGION_INTERSECTION, a, corner, 0, 0);
    expect_area(BAT_REGION_UNION, a, beside, 1, 6);
    expect_area(BAT_REGION_INTERSECTION, a, beside, 0, 0);
    expect_area(BAT_REGION_DIFFERENCE, a, beside, 1, 4);
    expect_area(BAT_REGION_DIFFERENCE, a, within, 1, 3);
    expect_area(BAT_REGION_UNION, a, within, 1, 4);
    bat_curve_free(a), bat_curve_free(corner), bat_curve_free(beside), bat_curve_free(within);
    bat_curve *left = disc(-4, 0, 4), *right;
    double low[2], high[2];
    bat_curve_bounds(left, low, high);
    right = disc(high[0] + 4 - (low[0] + 8), 0,
                 4); /* as far to the right as left is to the left of where they touch */
    const double area = bat_curve_area(left);
    bat_curve **out;
    const size_t count = combined(BAT_REGION_UNION, left, right, &out);
    assert_true(fabs(area_of(count, out) - 2 * area) < 1e-2);
    bat_curves_free(count, out);
    bat_curve_free(left), bat_curve_free(right);
}

/* Control points of a cut curve that no cut is near are those it had. */
static void pieces_keep_their_points(void **state) {
    (void)state;
    bat_curve *a = disc(0, 0, 5), *b = disc(4, 0, 5), **out;
    assert_int_equal(combined(BAT_REGION_UNION, a, b, &out), 1);
    const bat_curve *both[] = {a, b};
    int kept = 0;
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < 12; i++)
            for (size_t j = 0; j < bat_curve_count(out[0]); j++)
                if (memcmp(bat_curve_points(both[k]) + 2 * i, bat_curve_points(out[0]) + 2 * j,
                           2 * sizeof(double)) == 0) {
                    kept++;
                    break;
                }
    assert_in_range(kept, 10, 24); /* five of each have no cut among the spans that they shape */
    bat_curves_free(1, out);
    bat_curve_free(a), bat_curve_free(b);
}

/* One region: a figure of eight, filled by both rules. */
static void one_region_loses_what_lies_inside(void **state) {
    (void)state;
    const double eight[8] = {0, 0, 4, 4, 4, 0, 0, 4},
                 twice[16] = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 3, 0, 3, 3, 0, 3};
    bat_curve *a = closed_curve(1, 4, eight), *b = closed_curve(1, 8, twice);
    expect_area(BAT_REGION_UNION, a, NULL, 2, 8);
    expect_area(BAT_REGION_UNION, b, NULL, 1, 16);
    const bat_curve *in = b;
    const bat_region odd = {1, &in, true};
    size_t count;
    bat_curve **out;
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &odd, 1e-3, &count, &out), BAT_OK);
    assert_true(fabs(area_of(count, out) - 7) < 1e-9);
    bat_curves_free(count, out);
    bat_curve_free(a), bat_curve_free(b);
}

static void bad_calls_are_refused(void **state) {
    (void)state;
    bat_curve *a = disc(0, 0, 5), *space, *line, **out = NULL;
    const double ends[4] = {0, 0, 1, 1};
    assert_int_equal(bat_curve_to_dimension(a, 3, &space), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, ends, &line), BAT_OK);
    const bat_curve *const bad[] = {NULL, space, line}, *good = a;
    const bat_status status[] = {BAT_ARGUMENT, BAT_DIMENSION, BAT_ARGUMENT};
    size_t count = 7;
    for (int i = 0; i < 3; i++) {
        const bat_region r = {1, bad + i, false};
        assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &r, 1e-3, &count, &out), status[i]);
    }
    const bat_region r = {1, &good, false}, empty = {0, NULL, false};
    const double tolerances[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++)
        assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &r, tolerances[i], &count, &out),
                         BAT_ARGUMENT);
    assert_int_equal(bat_regions_combine(BAT_REGION_OPERATION_COUNT, 1, &r, 1, &count, &out), BAT_ARGUMENT);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 0, &r, 1, &count, &out), BAT_ARGUMENT);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, NULL, 1, &count, &out), BAT_ARGUMENT);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &r, 1, NULL, &out), BAT_ARGUMENT);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &r, 1, &count, NULL), BAT_ARGUMENT);
    assert_true(count == 7 && !out);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &empty, 1, &count, &out), BAT_OK);
    assert_int_equal(count, 0);
    bat_curves_free(count, out);
    assert_int_equal(bat_regions_combine(BAT_REGION_UNION, 1, &r, 100, &count, &out),
                     BAT_OK); /* smaller than that */
    assert_int_equal(count, 0);
    bat_curves_free(count, out);
    assert_true(bat_curve_area(NULL) == 0 && bat_curve_area(space) == 0 && bat_curve_area(line) == 0);
    bat_curve_free(a), bat_curve_free(space), bat_curve_free(line);
}

static void memory_may_run_out(void **state) {
    (void)state;
    bat_curve *a = disc(0, 0, 5), *b = disc(4, 0, 5);
    const bat_curve *one = a, *two = b;
    const bat_region both[2] = {{1, &one, false}, {1, &two, false}};
    const long live = alloc_live();
    for (long n = 1;; n++) {
        size_t count = 7;
        bat_curve **out = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_regions_combine(BAT_REGION_UNION, 2, both, 1e-3, &count, &out);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        if (!reached) {
            assert_int_equal(status, BAT_OK);
            bat_curves_free(count, out);
            break;
        }
        assert_true(status == BAT_MEMORY && count == 7 && !out);
        assert_int_equal(alloc_live(), live);
    }
    assert_int_equal(alloc_live(), live);
    bat_curve_free(a), bat_curve_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_on_a_grid_can_be_counted), cmocka_unit_test(curves_are_right_point_by_point),
        cmocka_unit_test(identical_curves_are_one),       cmocka_unit_test(long_spikes_add_up),
        cmocka_unit_test(long_spikes_meet_as_lines_do),   cmocka_unit_test(scattered_rings_stay_apart),
        cmocka_unit_test(what_does_not_meet_comes_back),  cmocka_unit_test(touching_curves_stay_two),
        cmocka_unit_test(pieces_keep_their_points),       cmocka_unit_test(one_region_loses_what_lies_inside),
        cmocka_unit_test(bad_calls_are_refused),          cmocka_unit_test(memory_may_run_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
