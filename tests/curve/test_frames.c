/*
 * Frames against closed forms: a helix (the rotation-minimising angle turns against the Frenet frame by the
 * torsion), curves on a sphere (double reflection is exact there), rigid motion, inflections, closed loops.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/frames.h>

static const double PI = 3.14159265358979323846;

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}
static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void cross(const double *a, const double *b, double *c) {
    c[0] = a[1] * b[2] - a[2] * b[1], c[1] = a[2] * b[0] - a[0] * b[2], c[2] = a[0] * b[1] - a[1] * b[0];
}

static bat_curve *random_curve(int dimension, bool closed, int count) {
    double points[192], knots[80], t = 0;
    int p = 3, total = closed ? count + 1 : count + p + 1;
    for (int i = 0; i < count * dimension; i++) points[i] = uniform(-100, 100);
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        if (closed || (i >= p && i < count)) t += uniform(0.5, 2);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(p, dimension, closed, count, knots, points, &curve), BAT_OK);
    return curve;
}

static void assert_orthonormal(const bat_frame3 *f) {
    double r[3];
    cross(f->t, f->s, r);
    assert_true(fabs(dot(f->t, f->t) - 1) < 1e-14 && fabs(dot(f->s, f->s) - 1) < 1e-14);
    assert_true(fabs(dot(f->t, f->s)) < 1e-14);
    for (int d = 0; d < 3; d++) assert_true(fabs(r[d] - f->r[d]) < 1e-14);
}

static void random_frames_are_frames(void **state) {
    (void)state;
    seed = 1;
    for (int round = 0; round < 120; round++) {
        bat_curve *curve = random_curve(2 + round % 2, round % 4 > 1, 5 + round % 20);
        double domain[2];
        bat_curve_domain(curve, domain);
        for (int rule = 0; rule < 3; rule++) {
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            bat_frame_chain *chain;
            assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
            for (int i = 0; i <= 50; i++) {
                bat_frame3 f;
                double u = domain[0] + (domain[1] - domain[0]) * i / 50, at[6];
                bat_frame_chain_at(chain, u, &f);
                assert_orthonormal(&f);
                bat_curve_eval(curve, u, 1, at);
                int n = bat_curve_dimension(curve);
                for (int d = 0; d < n; d++) assert_true(fabs(f.point[d] - at[d]) < 1e-13);
                if (rule == BAT_FRAMES_FIXED) continue;
                double speed = n == 3 ? sqrt(dot(at + n, at + n)) : hypot(at[n], at[n + 1]);
                for (int d = 0; d < n; d++) assert_true(fabs(f.t[d] - at[n + d] / speed) < 1e-12);
                if (n == 2 && rule == BAT_FRAMES_RMF)
                    assert_true(f.s[0] == -f.t[1] && f.s[1] == f.t[0] && f.s[2] == 0);
            }
            bat_frame_chain_free(chain);
        }
        bat_curve_free(curve);
    }
}

/* The rotation of s against a frame of known twist must vanish: s' is along t. By finite differences of the
 * chain itself: (s(u+h) - s(u-h)) . r = O(h^2) small against the turning of Frenet's. */
static void no_spin(void **state) {
    (void)state;
    seed = 2;
    for (int round = 0; round < 40; round++) {
        bat_curve *curve = random_curve(3, false, 12);
        bat_frame_options options = bat_frame_defaults();
        options.substeps = 64;
        bat_frame_chain *chain;
        assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
        double domain[2], h = 1e-4;
        bat_curve_domain(curve, domain);
        for (int i = 1; i < 40; i++) {
            bat_frame3 a, b, m;
            double u = domain[0] + (domain[1] - domain[0]) * i / 40;
            bat_frame_chain_at(chain, u - h, &a);
            bat_frame_chain_at(chain, u, &m);
            bat_frame_chain_at(chain, u + h, &b);
            double spin[3] = {b.s[0] - a.s[0], b.s[1] - a.s[1], b.s[2] - a.s[2]};
            double turn[3] = {b.t[0] - a.t[0], b.t[1] - a.t[1], b.t[2] - a.t[2]};
            assert_true(fabs(dot(spin, m.r)) < 2e-3 * sqrt(dot(turn, turn)) + 1e-9);
        }
        bat_frame_chain_free(chain);
        bat_curve_free(curve);
    }
}

/* Order four: against a chain of 1,024 steps a span, twice the steps leave a sixteenth of the error. */
static void fourth_order(void **state) {
    (void)state;
    seed = 3;
    double sum = 0;
    int rounds = 0;
    for (int round = 0; round < 12; round++) {
        bat_curve *curve = random_curve(3, false, 6);
        double domain[2], error[2];
        bat_curve_domain(curve, domain);
        bat_frame_options options = bat_frame_defaults();
        bat_frame3 exact, f;
        options.substeps = 1024;
        assert_int_equal(bat_frames(curve, &options, 1, &domain[1], &exact, NULL), BAT_OK);
        for (int i = 0; i < 2; i++) {
            options.substeps = 64 << i;
            assert_int_equal(bat_frames(curve, &options, 1, &domain[1], &f, NULL), BAT_OK);
            double c[3];
            cross(exact.s, f.s, c);
            error[i] = sqrt(dot(c, c));
        }
        if (error[1] > 1e-13) sum += log2(error[0] / error[1]), rounds++;
        bat_curve_free(curve);
    }
    assert_true(rounds > 4 && sum / rounds > 3.8);
}

/* A curve's frames move with it: s(0) by the persistent pair. */
static void rigid_motion(void **state) {
    (void)state;
    seed = 4;
    for (int round = 0; round < 40; round++) {
        bat_curve *curve = random_curve(3, round % 2 == 1, 9), *moved;
        double a[3] = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}, angle = uniform(0, 6), m[12];
        double length = sqrt(dot(a, a)), c = cos(angle), s = sin(angle);
        for (int d = 0; d < 3; d++) a[d] /= length;
        const double skew[9] = {0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                m[4 * i + j] = (i == j ? c : 0) + (1 - c) * a[i] * a[j] + s * skew[3 * i + j];
            m[4 * i + 3] = uniform(-50, 50);
        }
        assert_int_equal(bat_curve_transform(curve, m, &moved), BAT_OK);
        double u[9], domain[2];
        bat_curve_domain(curve, domain);
        for (int i = 0; i < 9; i++) u[i] = domain[0] + (domain[1] - domain[0]) * i / 8;
        bat_frame_options options = bat_frame_defaults(), turned;
        options.has_reference = true;
        for (int d = 0; d < 3; d++) options.reference_t[d] = d == 0, options.reference_s[d] = d == 1;
        turned = options;
        for (int d = 0; d < 3; d++) turned.reference_t[d] = m[4 * d], turned.reference_s[d] = m[4 * d + 1];
        bat_frame3 before[9], after[9];
        double phi0, phi1;
        assert_int_equal(bat_frames(curve, &options, 9, u, before, &phi0), BAT_OK);
        assert_int_equal(bat_frames(moved, &turned, 9, u, after, &phi1), BAT_OK);
        assert_true(fabs(phi0 - phi1) < 1e-11 || fabs(fabs(phi0 - phi1) - 2 * PI) < 1e-11);
        for (int i = 0; i < 9; i++)
            for (int d = 0; d < 3; d++) {
                double s_d = 0;
                for (int e = 0; e < 3; e++) s_d += m[4 * d + e] * before[i].s[e];
                assert_true(fabs(s_d - after[i].s[d]) < 1e-11);
            }
        bat_curve_free(curve);
        bat_curve_free(moved);
    }
}

/* A closed loop's frames meet; its holonomy is, by Gauss-Bonnet, the area that the tangent's image encloses
 * on the unit sphere, modulo 2 pi. The area is summed here from spherical triangles. */
static void closed_loops_meet(void **state) {
    (void)state;
    seed = 5;
    for (int round = 0; round < 30; round++) {
        bat_curve *curve = random_curve(3, true, 8);
        double domain[2], phi;
        bat_curve_domain(curve, domain);
        double ends[2] = {domain[0], nextafter(domain[1], 0)};
        bat_frame3 f[2];
        assert_int_equal(bat_frames(curve, NULL, 2, ends, f, &phi), BAT_OK);
        for (int d = 0; d < 3; d++) assert_true(fabs(f[0].s[d] - f[1].s[d]) < 1e-9);
        double area = 0, pole[3] = {0, 0, 1}, previous[3];
        for (int i = 0; i <= 20000; i++) {
            double at[6], t[3];
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (i % 20000) / 20000, 1, at);
            double speed = sqrt(dot(at + 3, at + 3));
            for (int d = 0; d < 3; d++) t[d] = at[3 + d] / speed;
            if (i > 0) {
                double c[3];
                cross(previous, t, c);
                area += 2 * atan2(dot(pole, c), 1 + dot(pole, previous) + dot(previous, t) + dot(t, pole));
            }
            memcpy(previous, t, sizeof t);
        }
        double difference = remainder(phi - area, 2 * PI);
        assert_true(fabs(difference) < 2e-3);
        bat_curve_free(curve);
    }
}

/* A cubic with an inflection: Frenet's s flips there, RMF's does not. */
static void inflection(void **state) {
    (void)state;
    double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1}, points[8] = {0, 0, 1, 2, 2, -2, 3, 0}, u[2] = {0.45, 0.55};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(3, 2, false, 4, knots, points, &curve), BAT_OK);
    bat_frame_options options = bat_frame_defaults();
    bat_frame3 f[2];
    assert_int_equal(bat_frames(curve, &options, 2, u, f, NULL), BAT_OK);
    assert_true(dot(f[0].s, f[1].s) > 0.9);
    options.rule = BAT_FRAMES_FRENET;
    assert_int_equal(bat_frames(curve, &options, 2, u, f, NULL), BAT_OK);
    assert_true(dot(f[0].s, f[1].s) < -0.9);
    bat_curve_free(curve);
}

static void degenerate(void **state) {
    (void)state;
    double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1}, u[3] = {0, 0.5, 1};
    const double sets[3][12] = {{1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3},   /* a point */
                                {0, 0, 0, 0, 0, 0, 1, 1, 0, 2, 1, 1},   /* stops at its start */
                                {0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0}}; /* turns back on itself */
    for (int i = 0; i < 3; i++)
        for (int rule = 0; rule < 3; rule++) {
            bat_curve *curve;
            bat_frame3 f[3];
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            assert_int_equal(bat_curve_create(3, 3, false, 4, knots, sets[i], &curve), BAT_OK);
            assert_int_equal(bat_frames(curve, &options, 3, u, f, NULL), BAT_OK);
            for (int j = 0; j < 3; j++) assert_orthonormal(&f[j]);
            bat_curve_free(curve);
        }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(3, 3, false, 4, knots, sets[1], &curve), BAT_OK);
    bat_frame3 f;
    double bad = NAN;
    assert_int_equal(bat_frames(curve, NULL, 1, &bad, &f, NULL), BAT_NUMBER);
    bat_frame_options options = bat_frame_defaults();
    options.substeps = -1;
    assert_int_equal(bat_frames(curve, &options, 1, u, &f, NULL), BAT_ARGUMENT);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_frames_are_frames),
        cmocka_unit_test(no_spin),
        cmocka_unit_test(fourth_order),
        cmocka_unit_test(rigid_motion),
        cmocka_unit_test(inflection),
        cmocka_unit_test(closed_loops_meet),
        cmocka_unit_test(degenerate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
