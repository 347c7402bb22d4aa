/*
 * How economical refitting is, against the least number of cubics that path fitters can reach at the same error.
 * Least: pieces whose ends lie on the curve with its tangents (G1), each as long as the tolerance allows. Since any part
 * of a piece that fits also fits, taking the longest each time is optimal. The two handle lengths of a piece are found
 * by Gauss-Newton on the distances, far samples weighted up, from several starts. label: slow
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/bezier.h>
#include "support/sketch_cases.h"

enum { SAMPLES = 48, ROUNDS = 14 };

typedef struct piece {
    double end[2][2], way[2][2]; /* ends, and tangents into the piece */
    double x[SAMPLES][2], weight[SAMPLES], t[SAMPLES];
    double chord;
} piece;

static void at(const piece *q, const double *handle, double t, double *p, double *d) {
    const double s = 1 - t, b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    const double e[3] = {3 * s * s, 6 * s * t, 3 * t * t};
    for (int c = 0; c < 2; c++) {
        const double p0 = q->end[0][c], p1 = p0 + handle[0] * q->way[0][c], p3 = q->end[1][c],
                     p2 = p3 + handle[1] * q->way[1][c];
        p[c] = b[0] * p0 + b[1] * p1 + b[2] * p2 + b[3] * p3;
        d[c] = e[0] * (p1 - p0) + e[1] * (p2 - p1) + e[2] * (p3 - p2);
    }
}

/* The greatest distance of samples, across the cubic, once their parameters have been corrected. */
static double correct(piece *q, const double *handle, int steps) {
    double worst = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double p[2], d[2];
        for (int k = 0; k < steps; k++) {
            at(q, handle, q->t[i], p, d);
            const double along = (q->x[i][0] - p[0]) * d[0] + (q->x[i][1] - p[1]) * d[1];
            const double square = d[0] * d[0] + d[1] * d[1];
            if (square > 0) q->t[i] = fmin(1, fmax(0, q->t[i] + along / square));
        }
        at(q, handle, q->t[i], p, d);
        worst = fmax(worst, hypot(q->x[i][0] - p[0], q->x[i][1] - p[1]));
    }
    return worst;
}

/* One Gauss-Newton step for both handles on the weighted distances across. */
static void step(const piece *q, double *handle) {
    double a = 1e-12, b = 0, c = 1e-12, f = 0, g = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double p[2], d[2];
        const double t = q->t[i], s = 1 - t, w = q->weight[i];
        at(q, handle, t, p, d);
        const double speed = hypot(d[0], d[1]);
        if (!(speed > 0)) continue;
        const double n[2] = {-d[1] / speed, d[0] / speed};
        const double off = (q->x[i][0] - p[0]) * n[0] + (q->x[i][1] - p[1]) * n[1];
        const double u = 3 * s * s * t * (q->way[0][0] * n[0] + q->way[0][1] * n[1]);
        const double v = 3 * s * t * t * (q->way[1][0] * n[0] + q->way[1][1] * n[1]);
        a += w * u * u, b += w * u * v, c += w * v * v, f += w * u * off, g += w * v * off;
    }
    const double det = a * c - b * b;
    if (!(fabs(det) > 1e-14 * a * c)) return;
    const double move[2] = {(c * f - b * g) / det, (a * g - b * f) / det};
    for (int k = 0; k < 2; k++) handle[k] = fmin(2 * q->chord, fmax(0.02 * q->chord, handle[k] + move[k]));
}

/* Whether one cubic stays within the tolerance of the curve from u to v. */
static bool fits(const bat_curve *curve, double u, double v, double tolerance) {
    static const double starts[][2] = {{0.33, 0.33}, {0.5, 0.5}, {0.2, 0.5}, {0.5, 0.2}, {0.8, 0.8}};
    piece q;
    double jet[4], length = 0, along[SAMPLES + 1];
    for (int k = 0; k < 2; k++) {
        (k ? bat_curve_eval_left : bat_curve_eval)(curve, k ? v : u, 1, jet);
        const double speed = hypot(jet[2], jet[3]) * (k ? -1 : 1);
        for (int c = 0; c < 2; c++) q.end[k][c] = jet[c], q.way[k][c] = jet[2 + c] / speed;
    }
    double last[2] = {q.end[0][0], q.end[0][1]};
    for (int i = 0; i <= SAMPLES; i++) {
        double x[2];
        bat_curve_eval_left(curve, u + (v - u) * (i + 1) / (SAMPLES + 1), 0, x);
        length += hypot(x[0] - last[0], x[1] - last[1]);
        along[i] = length;
        last[0] = x[0], last[1] = x[1];
        if (i < SAMPLES) q.x[i][0] = x[0], q.x[i][1] = x[1];
    }
    q.chord = length;
    for (size_t n = 0; n < sizeof starts / sizeof *starts; n++) {
        double handle[2] = {starts[n][0] * length, starts[n][1] * length};
        for (int i = 0; i < SAMPLES; i++) q.t[i] = along[i] / length, q.weight[i] = 1;
        for (int k = 0; k < ROUNDS; k++) {
            const double worst = correct(&q, handle, 2);
            if (worst <= tolerance) return true;
            for (int i = 0; i < SAMPLES && k > 2; i++) {
                double p[2], d[2];
                at(&q, handle, q.t[i], p, d);
                q.weight[i] *= 0.2 + hypot(q.x[i][0] - p[0], q.x[i][1] - p[1]) / worst;
            }
            step(&q, handle);
        }
    }
    return false;
}

/* The least number of cubics, from the curve's start. */
static int least_cubics(const bat_curve *curve, double tolerance) {
    double domain[2];
    int count = 0;
    bat_curve_domain(curve, domain);
    for (double u = domain[0]; u < domain[1]; count++) {
        double low = u, stride = (domain[1] - domain[0]) / 1000, high = u + stride;
        while (high < domain[1] && fits(curve, u, high, tolerance))
            low = high, stride *= 1.4, high = low + stride;
        if (high >= domain[1]) {
            high = domain[1];
            if (fits(curve, u, high, tolerance)) return count + 1;
        }
        for (int k = 0; k < 14; k++) {
            const double middle = 0.5 * (low + high);
            *(fits(curve, u, middle, tolerance) ? &low : &high) = middle;
        }
        if (!(low > u)) return -1;
        u = low;
    }
    return count;
}

/* One cubic needs one; the more tolerance, the fewer; never more than a curve that is G1 has spans. */
static void the_bound_is_plausible(void **state) {
    (void)state;
    const double points[8] = {0, 0, 30, 90, 110, -40, 150, 20};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &curve), BAT_OK);
    assert_int_equal(least_cubics(curve, 1e-6), 1);
    bat_curve_free(curve);
    random_source r = {3};
    curve = wavy_curve(&r, 20, 30);
    int last = 18; /* one more than its spans: a piece may end a little before a knot */
    for (double tolerance = 1e-4; tolerance < 30; tolerance *= 10) {
        const int least = least_cubics(curve, tolerance);
        assert_true(least >= 1 && least <= last);
        last = least;
    }
    bat_curve_free(curve);
}

static bat_curve *wandering(random_source *r, double bend) {
    enum { POINTS = 100 };
    double points[2 * POINTS], way = 0, at[2] = {0, 0};
    bat_curve *curve = NULL;
    for (int i = 0; i < POINTS; i++) {
        way += random_between(r, -bend, bend);
        at[0] += 14 * cos(way), at[1] += 14 * sin(way);
        points[2 * i] = at[0], points[2 * i + 1] = at[1];
    }
    assert_int_equal(bat_curve_create_clamped(2, 3, POINTS, points, &curve), BAT_OK);
    return curve;
}

/* Six curves that wander, two waves and two rings. */
static bat_curve *example(random_source *r, int n) {
    return n < 6 ? wandering(r, n < 3 ? 1.2 : 0.4) : n < 8 ? wavy_curve(r, 60, 3) : ring_curve(r, 60, 4);
}

/* A C2 joint has two freedoms fewer than a G1 joint, so there are more of them. */
static void refitting_against_the_least(void **state) {
    (void)state;
    random_source r = {97};
    int spans = 0, cubics = 0, points = 0;
    for (int n = 0; n < 10; n++) {
        bat_curve *curve = example(&r, n), *again = NULL;
        double there, back;
        assert_int_equal(bat_curve_refit(curve, n % 2 ? 0.45 : 1, 0.05, &again, NULL), BAT_OK);
        assert_int_equal(bat_curve_distance(curve, again, 40, &there, &back), BAT_OK);
        const int least = least_cubics(curve, fmax(there, back));
        assert_true(least > 0);
        cubics += least;
        points += (int)bat_curve_count(again);
        spans += (int)bat_curve_count(again) - (bat_curve_is_closed(again) ? 0 : 3);
        bat_curve_free(curve), bat_curve_free(again);
    }
    const int stored = 2 * cubics + 2 * 10; /* of the same pieces as B-splines with double knots */
    print_message("C2: %d spans, %d points; G1, least: %d cubics, %d points\n", spans, points, cubics,
                  stored);
    assert_true(spans <= 2.75 * cubics && points <= 1.4 * stored);
}

/* Refitting with G1 joints takes at most a tenth more than the least, on each curve. */
static void g1_refitting_comes_near_the_least(void **state) {
    (void)state;
    int refitted = 0, cubics = 0, points = 0;
    for (uint64_t seed = 97; seed < 99; seed++) {
        random_source r = {seed};
        for (int n = 0; n < 10; n++) {
            bat_curve *curve = example(&r, n), *again = NULL;
            double there, back;
            assert_int_equal(bat_curve_refit_g1(curve, n % 2 ? 0.45 : 1, 0.05, &again, NULL), BAT_OK);
            assert_int_equal(bat_curve_distance(curve, again, 40, &there, &back), BAT_OK);
            assert_true(fmax(there, back) <= (n % 2 ? 0.45 : 1));
            const int least = least_cubics(curve, fmax(there, back)), count = bat_curve_segment_count(again);
            assert_true(least > 0 && count <= fmax(1.1 * least, least + 1));
            refitted += count, cubics += least, points += (int)bat_curve_count(again);
            bat_curve_free(curve), bat_curve_free(again);
        }
    }
    print_message("G1: %d cubics, %d points; least: %d cubics\n", refitted, points, cubics);
    assert_true(refitted <= 1.03 * cubics && points <= 2.25 * refitted);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_bound_is_plausible),
                                       cmocka_unit_test(refitting_against_the_least),
                                       cmocka_unit_test(g1_refitting_comes_near_the_least)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
