/*
 * A stroke over a part of a level: beyond its ends the level stays. Measured by the largest displacement that the
 * stroke asks for: beyond two spans at most 6 % of it, nowhere outside more than all of it, and exactly none beyond the
 * supports that the stroke meets. Open and closed, plane and space, every degree, even and uneven knots, strokes over 5
 * to 100 % of the curve, of any shape; given by parameters, and drawn.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "curve/curve.h"
#include "support/sketch_cases.h"

#include <batten/levels.h>

enum { SAMPLES = 160, PLACES = 800, POINTS_MOST = 40 };

typedef enum knot_kind { EVEN, UNEVEN, WILD, KNOT_KINDS } knot_kind;

/* Some 900 units long, gently bent; a closed one is a ring. */
static bat_curve *base(random_source *r, int degree, int dimension, bool closed, int count, knot_kind kind) {
    double points[3 * 64], knots[80], t = random_between(r, -3, 3);
    for (int i = 0; i < count; i++) {
        double a = 2 * 3.14159265358979 * i / count, x[3];
        x[0] = closed ? 150 * cos(a) : 900.0 * i / count, x[1] = closed ? 150 * sin(a) : 0, x[2] = 0;
        for (int d = 0; d < dimension; d++)
            points[i * dimension + d] = x[d] + random_between(r, -200, 200) / count;
    }
    int total = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        if (closed || (i >= degree && i < count))
            t += kind == EVEN     ? 1
                 : kind == UNEVEN ? random_between(r, 0.3, 1.7)
                                  : exp(random_between(r, -3, 3));
    }
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(dimension, degree, closed, (size_t)count, points, total, knots, &curve),
                     BAT_OK);
    return curve;
}

/* Spans between the start of the domain and u (closed: unrolled). */
static double spans_to(const bat_curve *curve, double u) {
    const double *t = bat_curve_knots(curve);
    int p = bat_curve_degree(curve), n = bat_point_count(curve), first = bat_curve_is_closed(curve) ? 0 : p;
    double place = 0, turns = 0;
    if (bat_curve_is_closed(curve)) turns = floor((u - t[0]) / (t[n] - t[0]));
    u -= turns * (t[n] - t[0]);
    for (int i = first; i < n; i++) {
        if (!(t[i + 1] > t[i])) continue;
        place += fmin(fmax((u - t[i]) / (t[i + 1] - t[i]), 0), 1);
        if (bat_curve_is_closed(curve)) place += turns;
    }
    return place;
}

/* How far a stroke lies from the curve at f = 0..1 along it: at most 1. */
typedef struct course {
    int kind;
    double phase, waves, row[6];
} course;

static course any_course(random_source *r) {
    course c = {
        .kind = random_int(r, 0, 4), .phase = random_between(r, 0, 6), .waves = random_between(r, 1, 9)};
    for (int k = 0; k < 6; k++) c.row[k] = random_between(r, -1, 1);
    return c;
}

static double height(const course *c, double f) {
    const double pi = 3.14159265358979;
    double sum = 0, most = 0;
    switch (c->kind) {
    case 0: return sin(pi * f) * sin(pi * f); /* comes back to the curve at both ends */
    case 1: return 1;
    case 2: return f;
    case 3: return sin(pi * f) * sin(c->waves * f + c->phase);
    default: /* any */
        for (int k = 0; k < 6; k++) sum += c->row[k] * cos(k * pi * f), most += fabs(c->row[k]);
        return sum / most;
    }
}

typedef struct found {
    double far, outside;
} found;

/* Of |after - before|, relative to `largest`; the stroke goes from u0 to u1. */
static found compare(const bat_curve *before, const bat_curve *after, double u0, double u1, double largest) {
    found w = {0, 0};
    double domain[2], a[3], b[3], from = spans_to(before, u0), to = spans_to(before, u1);
    int size = bat_curve_dimension(before);
    bool closed = bat_curve_is_closed(before);
    bat_curve_domain(before, domain);
    double all = spans_to(before, domain[1]);
    for (int i = 0; i <= PLACES; i++) {
        double u = domain[0] + (domain[1] - domain[0]) * i / PLACES, moved = 0;
        if (i == PLACES) u = domain[1];
        double at = spans_to(before, u), away = fmax(from - at, at - to);
        if (closed) { /* in the gap: the nearer end */
            while (at < to) at += all;
            while (at - all >= to) at -= all;
            away = fmin(at - to, from + all - at);
        }
        if (away <= 1e-9) continue;
        bat_curve_eval(before, u, 0, a);
        bat_curve_eval(after, u, 0, b);
        for (int d = 0; d < size; d++) moved = hypot(moved, b[d] - a[d]);
        w.outside = fmax(w.outside, moved / largest);
        if (away > 2) w.far = fmax(w.far, moved / largest);
    }
    return w;
}

/* Control points whose support the stretch misses are the same bits. */
static void assert_supports(const bat_curve *before, const bat_curve *after, double u0, double u1) {
    const double *t = bat_curve_knots(before);
    int p = bat_curve_degree(before), n = bat_point_count(before), size = bat_curve_dimension(before);
    if (bat_curve_is_closed(before)) return;
    for (int i = 0; i < n; i++)
        if (t[i + p + 1] <= u0 || t[i] >= u1)
            for (int d = 0; d < size; d++)
                assert_true(bat_curve_points(before)[i * size + d] == bat_curve_points(after)[i * size + d]);
}

static const double SHARES[] = {0.05, 0.08, 0.12, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1};

static void by_parameters(void **state) {
    (void)state;
    random_source r = {17};
    found worst[KNOT_KINDS] = {{0, 0}};
    for (int round = 0; round < 1500; round++) {
        int degree = round % 3 ? 3 : random_int(&r, 1, 7), dimension = 2 + round % 2;
        bool closed = round / 2 % 2;
        knot_kind kind = (knot_kind)(round / 4 % KNOT_KINDS);
        bat_curve *curve = base(&r, degree, dimension, closed, random_int(&r, degree + 5, POINTS_MOST), kind);
        double domain[2], u[SAMPLES], q[3 * SAMPLES], jet[6], largest = 0;
        bat_curve_domain(curve, domain);
        double share = SHARES[random_int(&r, 0, (int)(sizeof SHARES / sizeof *SHARES) - 1)],
               width = domain[1] - domain[0],
               u0 = domain[0] + random_between(&r, 0, closed ? 1 : 1 - share) * width;
        course c = any_course(&r);
        double lift = random_between(&r, 1, 90),
               way[3] = {random_normal(&r), random_normal(&r), random_normal(&r)};
        for (int i = 0; i < SAMPLES; i++) {
            double f = i / (SAMPLES - 1.0), moved = 0;
            u[i] = fmin(u0 + share * width * f, closed ? INFINITY : domain[1]);
            bat_curve_eval(curve, u[i], 0, jet);
            for (int d = 0; d < dimension; d++) {
                q[i * dimension + d] = jet[d] + lift * height(&c, f) * way[d];
                moved = hypot(moved, lift * height(&c, f) * way[d]);
            }
            largest = fmax(largest, moved);
        }
        bat_shape *shape;
        assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
        assert_int_equal(bat_shape_sketch(shape, 0, SAMPLES, u, q), BAT_OK);
        found w = compare(curve, bat_shape_curve(shape, 0), u[0], u[SAMPLES - 1], largest);
        assert_true(w.far <= 0.06 && w.outside <= 1);
        assert_supports(curve, bat_shape_curve(shape, 0), u[0], u[SAMPLES - 1]);
        worst[kind].far = fmax(worst[kind].far, w.far),
        worst[kind].outside = fmax(worst[kind].outside, w.outside);
        bat_shape_free(shape);
        bat_curve_free(curve);
    }
    for (int k = 0; k < KNOT_KINDS; k++)
        printf("knots %d: %.3f beyond two spans, %.3f outside\n", k, worst[k].far, worst[k].outside);
}

/* A stroke along the curve, off it by lift in the plane of x and y; truth: how far at most. */
static double draw(const bat_curve *curve, double u0, double u1, const course *c, double lift, double *out) {
    int size = bat_curve_dimension(curve);
    double jet[6], largest = 0, domain[2];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < SAMPLES; i++) {
        double f = i / (SAMPLES - 1.0), moved = lift * height(c, f), u = u0 + (u1 - u0) * f;
        bat_curve_eval(curve, bat_curve_is_closed(curve) ? u : fmin(u, domain[1]), 1, jet);
        double speed = hypot(jet[size], jet[size + 1]);
        for (int d = 0; d < size; d++) out[i * size + d] = jet[d];
        out[i * size] -= moved * jet[size + 1] / speed, out[i * size + 1] += moved * jet[size] / speed;
        largest = fmax(largest, fabs(moved));
    }
    return largest;
}

/* The same of strokes as a pen draws them. What is far from the curve (math 5.3) is left out. */
static void drawn_strokes(void **state) {
    (void)state;
    random_source r = {18};
    found worst = {0, 0};
    for (int round = 0; round < 600; round++) {
        int size = 2 + round % 2;
        bool closed = round / 2 % 2;
        bat_curve *curve = base(&r, 3, size, closed, random_int(&r, 8, POINTS_MOST),
                                round / 4 % 2 ? EVEN : UNEVEN);
        double domain[2], q[3 * SAMPLES];
        bat_curve_domain(curve, domain);
        double share = SHARES[random_int(&r, 0, (int)(sizeof SHARES / sizeof *SHARES) - 1)],
               width = domain[1] - domain[0],
               u0 = domain[0] + random_between(&r, 0, closed ? 1 : 1 - share) * width,
               lift = random_between(&r, 3, 39) * (random_int(&r, 0, 1) ? 1 : -1) * fmin(1, 4 * share);
        course c = any_course(&r);
        double largest = draw(curve, u0, u0 + share * width, &c, lift, q);
        bat_shape *shape;
        bat_sketch_report report;
        assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
        bat_stroke stroke = {.dimension = size, .count = SAMPLES, .points = q};
        assert_int_equal(bat_shape_redraw_level(shape, 0, &stroke, NULL, &report), BAT_OK);
        found w = compare(curve, bat_shape_curve(shape, 0), u0, u0 + share * width, largest);
        assert_true(w.far <= 0.06 && w.outside <= 1);
        worst.far = fmax(worst.far, w.far), worst.outside = fmax(worst.outside, w.outside);
        bat_shape_free(shape);
        bat_curve_free(curve);
    }
    printf("drawn: %.3f beyond two spans, %.3f outside\n", worst.far, worst.outside);
}

/* A calm stroke over many spans is met, but for a span at its ends; over fewer than three it is not, and the report
 * says by how much. */
static void long_strokes_are_met(void **state) {
    (void)state;
    random_source r = {19};
    for (int round = 0; round < 300; round++) {
        int size = 2 + round % 2, count = random_int(&r, 12, POINTS_MOST);
        bool closed = round / 2 % 2, longer = round / 4 % 2;
        bat_curve *curve = base(&r, 3, size, closed, count, EVEN);
        double domain[2], q[3 * SAMPLES], spans = closed ? count : count - 3, at[3], worst = 0;
        bat_curve_domain(curve, domain);
        double over = longer ? random_between(&r, 7, spans - 1) : random_between(&r, 0.8, 1.5),
               u0 = domain[0] + random_between(&r, 0, spans - over);
        course c = {.kind = 0};
        double largest = draw(curve, u0, u0 + over, &c, 30, q);
        bat_shape *shape;
        bat_sketch_report report;
        assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
        bat_stroke stroke = {.dimension = size, .count = SAMPLES, .points = q};
        assert_int_equal(bat_shape_redraw_level(shape, 0, &stroke, NULL, &report), BAT_OK);
        assert_true(fabs(report.spans - over) <
                    0.1 + 0.05 * over); /* the foot of the pen is found as on any curve */
        for (int i = 0; i < SAMPLES; i++) {
            double u = bat_curve_project_near(bat_shape_curve(shape, 0), q + i * size,
                                              u0 + over * i / (SAMPLES - 1), 4),
                   off = 0;
            bat_curve_eval(bat_shape_curve(shape, 0), u, 0, at);
            for (int d = 0; d < size; d++) off = hypot(off, at[d] - q[i * size + d]);
            worst = fmax(worst, off);
        }
        assert_true(fabs(worst - report.max_error) < 1); /* the stroke is resampled */
        if (longer) assert_true(report.spans >= BAT_LEVEL_SPANS_LEAST && worst < 0.1 * largest);
        if (!longer) assert_true(report.spans < BAT_LEVEL_SPANS_LEAST && worst > 0.1 * largest);
        bat_shape_free(shape);
        bat_curve_free(curve);
    }
}

/* Of a closed curve one far end is enough to be too far, whatever the other does. */
static void far_ends(void **state) {
    (void)state;
    random_source r = {20};
    bat_curve *ring = base(&r, 3, 2, true, 24, EVEN);
    bat_shape *shape;
    double q[2 * SAMPLES];
    assert_int_equal(bat_shape_create(ring, NULL, &shape), BAT_OK);
    for (int i = 0; i < SAMPLES; i++) q[2 * i] = 150 - 148.0 * i / SAMPLES, q[2 * i + 1] = 5;
    bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = q};
    assert_int_equal(bat_shape_sketch_stroke(shape, 0, &stroke, NULL), BAT_FAR);
    assert_true(bat_curve_is_equal(ring, bat_shape_curve(shape, 0)));
    bat_shape_free(shape);
    bat_curve_free(ring);
}

/* One sample, samples on one place, two far apart, targets on the curve, curves without extent, huge and tiny. */
static void edge_cases(void **state) {
    (void)state;
    random_source r = {21};
    const double sizes[] = {1, 1e-310, 1e-200, 1e70, 0};
    for (int round = 0; round < 80; round++) {
        int size = 2 + round % 2, degree = 1 + round % 4;
        bool closed = round / 2 % 2;
        double scale = sizes[round % 5], points[3 * 12], knots[20], u[3], q[9], domain[2];
        int count = closed ? random_int(&r, 3, 12) : degree + 1 + round % 4,
            total = closed ? count + 1 : count + degree + 1;
        for (int i = 0; i < count * size; i++) points[i] = scale * random_between(&r, -1, 1);
        for (int i = 0; i < total; i++) knots[i] = closed ? i : fmin(fmax(i - degree, 0), count - degree);
        bat_curve *curve;
        assert_int_equal(bat_curve_create(size, degree, closed, (size_t)count, points, total, knots, &curve),
                         BAT_OK);
        bat_curve_domain(curve, domain);
        for (int many = 1; many <= 3; many++) {
            bat_shape *shape;
            assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
            for (int i = 0; i < 3; i++) {
                u[i] = many == 2 ? domain[0] : domain[0] + random_unit(&r) * (domain[1] - domain[0]);
                for (int d = 0; d < size; d++) q[i * size + d] = scale * random_between(&r, -2, 2);
            }
            assert_int_equal(bat_shape_sketch(shape, 0, (size_t)many, u, q), BAT_OK);
            const bat_curve *after = bat_shape_curve(shape, 0);
            for (int i = 0; i < count * size; i++) {
                double moved = bat_curve_points(after)[i] - points[i];
                assert_true(isfinite(moved) && fabs(moved) <= 40 * scale);
            }
            bat_curve *same;
            assert_int_equal(bat_curve_copy(after, &same), BAT_OK);
            for (int i = 0; i < 3; i++) bat_curve_eval(same, u[i], 0, q + i * size);
            assert_int_equal(bat_shape_sketch(shape, 0, (size_t)many, u, q), BAT_OK);
            assert_true(bat_curve_is_equal(same, bat_shape_curve(shape, 0))); /* it lies there already */
            bat_curve_free(same);
            bat_shape_free(shape);
        }
        bat_curve_free(curve);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_parameters),        cmocka_unit_test(drawn_strokes),
        cmocka_unit_test(long_strokes_are_met), cmocka_unit_test(far_ends),
        cmocka_unit_test(edge_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
