/*
 * Splines of even curvature: they pass through their points, curvature is greatest there and nowhere else, equal on
 * both sides of every joint, and nothing that somebody places makes them fail.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include <batten/tangents.h>
#include "base/real.h"
#include "base/vec.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 40 };

typedef struct made {
    bat_joint joints[MOST + 1];
    double *bezier;
    bat_curve *curve;
    int pieces;
} made;

static const bat_tangents_options EVEN = {sizeof EVEN, BAT_TANGENTS_EVEN, BAT_TANGENTS_CENTRIPETAL};

static bat_spline spline(int dimension, bool closed, int count, const double *points) {
    return (bat_spline){.dimension = dimension, .closed = closed, .count = (size_t)count, .points = points};
}

static made make(const bat_spline *s) {
    made m;
    assert_int_equal(bat_tangents(s, &EVEN, m.joints, &m.pieces, &m.bezier, &m.curve), BAT_OK);
    return m;
}

static void end(made *m) {
    bat_free(m->bezier);
    bat_curve_free(m->curve);
}

/* A piece as the quadratic that it is. */
static void quadratic(const made *m, int dimension, int piece, vec out[3]) {
    const double *b = m->bezier + 4 * dimension * piece;
    out[0] = vec_load(b, dimension);
    out[2] = vec_load(b + 3 * dimension, dimension);
    out[1] = vec_scale(vec_sub(vec_scale(vec_load(b + dimension, dimension), 3), out[0]), 0.5);
}

static double curvature(const vec q[3], double t) {
    const vec a = vec_sub(q[1], q[0]), b = vec_sub(q[2], q[1]);
    const vec d = vec_add(vec_scale(a, 2 * (1 - t)), vec_scale(b, 2 * t)), dd = vec_scale(vec_sub(b, a), 2);
    const double speed = vec_norm(d);
    return vec_norm(vec_cross(d, dd)) / (speed * speed * speed);
}

/* Where the curvature of a quadratic is greatest, in closed form: where its speed is least. */
static double summit(const vec q[3]) {
    const vec a = vec_sub(q[0], q[1]), b = vec_add(a, vec_sub(q[2], q[1]));
    return vec_dot(a, b) / vec_dot(b, b);
}

/* The square of how much a quadratic bends, over that of its length: nothing is at its summit where it does not. */
static double bend(const vec q[3]) {
    const vec a = vec_sub(q[1], q[0]), b = vec_sub(q[2], q[1]), c = vec_sub(b, a);
    return vec_dot(c, c) / (vec_dot(a, a) + vec_dot(b, b));
}

static double own_t(const bat_joint *j) {
    const double left = vec_norm(vec_load(j->left, 3)), right = vec_norm(vec_load(j->right, 3));
    return left / (left + right);
}

/* The point of a piece. */
static int point_of(const bat_spline *s, int piece) { return s->closed ? piece : piece + 1; }

static void through_points(const bat_spline *s, const made *m, double size) {
    const double *knots = bat_curve_knots(m->curve);
    const int count = bat_curve_knot_count(m->curve);
    int piece = 0;
    for (int i = 0; i + 1 < count; i++) {
        if (!(knots[i] < knots[i + 1])) continue;
        const double t = own_t(&m->joints[point_of(s, piece)]);
        double at[3];
        bat_curve_eval(m->curve, knots[i] + t * (knots[i + 1] - knots[i]), 0, at);
        const vec off = vec_sub(vec_load(at, s->dimension),
                                vec_load(s->points + s->dimension * point_of(s, piece), s->dimension));
        assert_true(vec_norm(off) <= 1e-12 * size);
        piece++;
    }
    assert_int_equal(piece, m->pieces);
    if (s->closed) return;
    const size_t bytes = (size_t)s->dimension * sizeof(double);
    assert_memory_equal(m->bezier, s->points, bytes);
    assert_memory_equal(m->bezier + (4 * m->pieces - 1) * s->dimension,
                        s->points + ((int)s->count - 1) * s->dimension, bytes);
}

/* Greatest at the point: at a thousandth of its piece beside it where it would lie at the end. */
static void greatest_at_points(const bat_spline *s, const made *m) {
    for (int i = 0; i < m->pieces; i++) {
        vec q[3];
        quadratic(m, s->dimension, i, q);
        const double t = own_t(&m->joints[point_of(s, i)]), best = summit(q);
        const bool first = t<1.0001e-3, last = t> 1 - 1.0001e-3;
        if (first)
            assert_true(best < 1.01e-3);
        else if (last)
            assert_true(best > 1 - 1.01e-3);
        else
            assert_true(fabs(best - t) * bend(q) < 1e-9);
        const double most = curvature(q, first ? 0 : last ? 1 : t);
        for (int k = 0; k <= 32; k++) assert_true(curvature(q, k / 32.0) <= most * (1 + 1e-6));
    }
}

static void equal_at_joints(const bat_spline *s, const made *m) {
    for (int i = 0; i + (s->closed ? 0 : 1) < m->pieces; i++) {
        vec a[3], b[3];
        quadratic(m, s->dimension, i, a);
        quadratic(m, s->dimension, (i + 1) % m->pieces, b);
        const double before = curvature(a, 1), after = curvature(b, 0);
        assert_true(fabs(before - after) <= 1e-6 * (before + after));
        assert_true(vec_angle(vec_sub(a[2], a[1]), vec_sub(b[1], b[0])) < 1e-6);
    }
}

static void random_polygons(void **state) {
    (void)state;
    random_source r = {16};
    for (int round = 0; round < 1500; round++) {
        double p[3 * 20];
        const int count = 3 + round % 16, dimension = round % 5 == 4 ? 3 : 2;
        for (int i = 0; i < 3 * count; i++) p[i] = random_between(&r, 0, 1);
        const bat_spline s = spline(dimension, round % 3 != 0, count, p);
        made m = make(&s);
        assert_int_equal(m.pieces, s.closed ? count : count - 2);
        through_points(&s, &m, 1);
        greatest_at_points(&s, &m);
        equal_at_joints(&s, &m);
        end(&m);
    }
}

/* Three points: one parabola. A regular polygon: middle points on a circle that is R (8 / (6 + 2 cos)) wide, and a
 * B-spline with as many control points as points, without a seam. */
static void closed_forms(void **state) {
    (void)state;
    const double three[] = {-1, 0, 0, 1, 1, 0};
    bat_spline s = spline(2, false, 3, three);
    made m = make(&s);
    assert_int_equal(m.pieces, 1);
    assert_int_equal(bat_curve_degree(m.curve), 2);
    assert_true(hypot(bat_curve_points(m.curve)[2], bat_curve_points(m.curve)[3] - 2) < 1e-12);
    end(&m);
    for (int n = 3; n < 20; n++) {
        double p[2 * MOST];
        for (int i = 0; i < n; i++)
            p[2 * i] = 5 * bat_cos(2 * i * BAT_PI / n), p[2 * i + 1] = 5 * bat_sin(2 * i * BAT_PI / n);
        s = spline(2, true, n, p);
        m = make(&s);
        assert_int_equal(bat_curve_count(m.curve), n);
        for (int i = 0; i < n; i++) {
            const double *q = bat_curve_points(m.curve) + 2 * i;
            assert_true(fabs(hypot(q[0], q[1]) - 40 / (6 + 2 * bat_cos(2 * BAT_PI / n))) < 1e-9);
        }
        end(&m);
    }
}

static void two_points(void **state) {
    (void)state;
    const double p[] = {1, 2, 5, 9}, same[] = {1, 2, 1, 2}, bad[] = {1, 2, NAN, 3, 4, 5};
    bat_spline s = spline(2, false, 2, p);
    made m = make(&s);
    double at[2];
    bat_curve_eval(m.curve, 0.25, 0, at);
    assert_true(hypot(at[0] - 2, at[1] - 3.75) < 1e-12);
    end(&m);
    s.closed = true; /* the oval of the other mode */
    m = make(&s);
    bat_curve *oval = NULL;
    assert_int_equal(bat_tangents(&s, NULL, NULL, NULL, NULL, &oval), BAT_OK);
    assert_true(bat_curve_is_equal(oval, m.curve));
    bat_curve_free(oval);
    end(&m);
    s = spline(2, false, 2, same);
    assert_int_equal(bat_tangents(&s, &EVEN, NULL, NULL, NULL, NULL), BAT_COUNT);
    s = spline(2, false, 3, bad);
    assert_int_equal(bat_tangents(&s, &EVEN, NULL, NULL, NULL, NULL), BAT_NUMBER);
}

/* Points on small grids, repeated, on a line, there and back; huge and tiny: finite numbers that meet the points. */
static void degenerate(void **state) {
    (void)state;
    random_source r = {17};
    static const double sizes[] = {1, 1e60, 1e-100};
    for (int round = 0; round < 900; round++) {
        double p[3 * 12];
        const int count = 3 + round % 9, dimension = 2 + round % 2, sides = 1 + round % 4;
        for (int i = 0; i < 3 * count; i++) {
            const bool flat = sides == 1 && i % dimension;
            p[i] = flat ? 0 : floor(random_between(&r, 0, sides + 1)) * sizes[round % 3];
        }
        const bat_spline s = spline(dimension, round / 3 % 2, count, p);
        made m = {.bezier = NULL};
        const bat_status status = bat_tangents(&s, &EVEN, m.joints, &m.pieces, &m.bezier, &m.curve);
        if (status == BAT_COUNT) continue;
        assert_int_equal(status, BAT_OK);
        for (int i = 0; i < 4 * dimension * m.pieces; i++) assert_true(isfinite(m.bezier[i]));
        for (int i = 0; i < count; i++) {
            bat_near near;
            assert_int_equal(bat_curve_nearest(m.curve, p + dimension * i, &near), BAT_OK);
            assert_true(near.distance <= 1e-9 * sizes[round % 3] * 4);
        }
        end(&m);
    }
}

/* Turned, mirrored, scaled, moved or run from the other end, points give the curve that was turned, ... with them. It is
 * no affine image: curvature is not. */
static void similar_points_similar_curves(void **state) {
    (void)state;
    random_source r = {18};
    for (int round = 0; round < 60; round++) {
        double p[2 * 12], q[2 * 12], back[2 * 12];
        const int count = 3 + round % 10;
        const double turn = random_between(&r, 0, 6), factor = random_between(&r, 0.1, 10);
        const double sign = round % 2 ? -1 : 1, c = factor * bat_cos(turn), d = factor * bat_sin(turn);
        for (int i = 0; i < count; i++) {
            double *at = p + 2 * i; /* round a loop, in disorder: one solution */
            const double angle = 2 * BAT_PI * i / count, away = random_between(&r, 50, 100);
            at[0] = away * bat_cos(angle), at[1] = away * bat_sin(angle);
            q[2 * i] = c * at[0] - sign * d * at[1] + 70, q[2 * i + 1] = d * at[0] + sign * c * at[1] - 30;
        }
        for (int i = 0; i < count; i++) memcpy(back + 2 * i, p + 2 * (count - 1 - i), 2 * sizeof *p);
        bat_spline s = spline(2, round % 3 == 0, count, p);
        made a = make(&s), b, reversed;
        s.points = q;
        b = make(&s);
        s.points = back;
        reversed = make(&s);
        for (int i = 0; i < 4 * a.pieces; i++) {
            const double *x = a.bezier + 2 * i, *y = b.bezier + 2 * i;
            const double *z = reversed.bezier + 2 * (4 * a.pieces - 1 - i);
            assert_true(hypot(c * x[0] - sign * d * x[1] + 70 - y[0],
                              d * x[0] + sign * c * x[1] - 30 - y[1]) < 1e-9 * 200 * factor);
            assert_true(hypot(x[0] - z[0], x[1] - z[1]) < 1e-9 * 200);
        }
        end(&a), end(&b), end(&reversed);
    }
}

/* A point that moves is felt everywhere, but less from piece to piece: by a third or less each on a wave. */
static void what_moves_is_felt_nearby(void **state) {
    (void)state;
    double p[2 * MOST];
    for (int i = 0; i < MOST; i++) p[2 * i] = 10 * i, p[2 * i + 1] = i % 2 ? 6 : -6;
    const bat_spline s = spline(2, false, MOST, p);
    made a = make(&s);
    p[2 * 20 + 1] += 1;
    made b = make(&s);
    double moved[MOST];
    for (int i = 0; i < a.pieces; i++) {
        moved[i] = 0;
        for (int k = 0; k < 4; k++) {
            const double *x = a.bezier + 8 * i + 2 * k, *y = b.bezier + 8 * i + 2 * k;
            moved[i] = fmax(moved[i], hypot(x[0] - y[0], x[1] - y[1]));
        }
    }
    assert_true(moved[19] > 0.9);
    for (int away = 1; away < 12; away++) {
        const double most = 2 * pow(0.34, away);
        assert_true(moved[19 + away] < most && moved[19 - away] < most);
    }
    end(&a), end(&b);
}

/* A point put on the curve lies on it, in its place among the others, and the report says how far the curve goes. */
static void a_point_more(void **state) {
    (void)state;
    random_source r = {19};
    for (int round = 0; round < 40; round++) {
        double p[3 * 10];
        const int count = 2 + round % 8, dimension = 2 + round % 2;
        for (int i = 0; i < 3 * count; i++) p[i] = random_between(&r, 0, 100);
        const bat_spline s = spline(dimension, count > 2 && round % 3 == 0, count, p);
        made m = make(&s), longer;
        bat_spline more;
        void *block = NULL;
        int index = -1;
        double deviation = -1;
        const int piece = (int)random_between(&r, 0, m.pieces);
        const double t = random_between(&r, 0.05, 0.95);
        assert_int_equal(bat_tangents_insert(&s, piece, t, &EVEN, &more, &block, &index, &deviation), BAT_OK);
        assert_int_equal(more.count, s.count + 1);
        bat_near near;
        assert_int_equal(bat_curve_nearest(m.curve, more.points + dimension * index, &near), BAT_OK);
        assert_true(near.distance < 1e-9);
        longer = make(&more);
        bat_apart apart;
        assert_int_equal(bat_curve_hausdorff(m.curve, longer.curve, 1e-4, &apart), BAT_OK);
        assert_true(fabs(apart.distance - deviation) < 1e-3);
        const int own = count == 2
                            ? 1
                            : point_of(&s, piece) + (t < own_t(&m.joints[point_of(&s, piece)]) ? 0 : 1);
        assert_int_equal(index, own == 0 ? count : own);
        bat_free(block);
        end(&m), end(&longer);
    }
    const double line[] = {0, 0, 1, 0};
    const bat_spline two = spline(2, false, 2, line);
    bat_spline more;
    void *block = NULL;
    int index;
    assert_int_equal(bat_tangents_insert(&two, 1, 0.5, &EVEN, &more, &block, &index, NULL), BAT_ARGUMENT);
}

static void memory_runs_out(void **state) {
    (void)state;
    const double p[] = {0, 0, 1, 3, 4, 1, 6, 6};
    const bat_spline s = spline(2, true, 4, p);
    for (int n = 1;; n++) {
        bat_curve *curve = NULL;
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = bat_tangents(&s, &EVEN, NULL, NULL, NULL, &curve);
        const bool failed = alloc_fail_reached();
        assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
        if (failed) assert_null(curve);
        bat_curve_free(curve);
        assert_int_equal(alloc_live(), before);
        if (!failed) break;
    }
    for (int n = 1;; n++) {
        bat_spline more;
        void *block = NULL;
        int index;
        double deviation;
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = bat_tangents_insert(&s, 1, 0.3, &EVEN, &more, &block, &index, &deviation);
        const bool failed = alloc_fail_reached();
        assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
        if (failed) assert_null(block);
        bat_free(block);
        assert_int_equal(alloc_live(), before);
        if (!failed) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_polygons),
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(two_points),
        cmocka_unit_test(degenerate),
        cmocka_unit_test(similar_points_similar_curves),
        cmocka_unit_test(what_moves_is_felt_nearby),
        cmocka_unit_test(a_point_more),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
