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
    assert_int_equal(bat_curve_create(dimension, p, closed, (size_t)count, points, total, knots, &curve),
                     BAT_OK);
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
        assert_int_equal(bat_frames(curve, 1, &domain[1], &options, &exact, NULL), BAT_OK);
        for (int i = 0; i < 2; i++) {
            options.substeps = 64 << i;
            assert_int_equal(bat_frames(curve, 1, &domain[1], &options, &f, NULL), BAT_OK);
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
        assert_int_equal(bat_frames(curve, 9, u, &options, before, &phi0), BAT_OK);
        assert_int_equal(bat_frames(moved, 9, u, &turned, after, &phi1), BAT_OK);
        assert_true(fabs(remainder(phi0 - phi1, 2 * PI)) < 1e-12);
        for (int i = 0; i < 9; i++)
            for (int d = 0; d < 3; d++) {
                double s_d = 0;
                for (int e = 0; e < 3; e++) s_d += m[4 * d + e] * before[i].s[e];
                assert_true(fabs(s_d - after[i].s[d]) < 1e-12);
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
        assert_int_equal(bat_frames(curve, 2, ends, NULL, f, &phi), BAT_OK);
        for (int d = 0; d < 3; d++) assert_true(fabs(f[0].s[d] - f[1].s[d]) < 1e-12);
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
    assert_int_equal(bat_curve_create(2, 3, false, 4, points, 8, knots, &curve), BAT_OK);
    bat_frame_options options = bat_frame_defaults();
    bat_frame3 f[2];
    assert_int_equal(bat_frames(curve, 2, u, &options, f, NULL), BAT_OK);
    assert_true(dot(f[0].s, f[1].s) > 0.9);
    options.rule = BAT_FRAMES_FRENET;
    assert_int_equal(bat_frames(curve, 2, u, &options, f, NULL), BAT_OK);
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
            assert_int_equal(bat_curve_create(3, 3, false, 4, sets[i], 8, knots, &curve), BAT_OK);
            assert_int_equal(bat_frames(curve, 3, u, &options, f, NULL), BAT_OK);
            for (int j = 0; j < 3; j++) assert_orthonormal(&f[j]);
            bat_curve_free(curve);
        }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(3, 3, false, 4, sets[1], 8, knots, &curve), BAT_OK);
    bat_frame3 f;
    double bad = NAN;
    assert_int_equal(bat_frames(curve, 1, &bad, NULL, &f, NULL), BAT_NUMBER);
    bat_frame_options options = bat_frame_defaults();
    options.substeps = -1;
    assert_int_equal(bat_frames(curve, 1, u, &options, &f, NULL), BAT_ARGUMENT);
    bat_curve_free(curve);
}

/* A curve of degree 7 that has positions and three derivatives of `at` at every breakpoint: 1e-12 from it. */
static bat_curve *osculating(void (*at)(double t, double d[4][3]), double end, int spans) {
    enum { P = 7, MOST = 40 };
    double points[(P * MOST + 1) * 3], knots[P * MOST + P + 2], d[2][4][3], h = end / spans;
    for (int i = 0; i < spans; i++) {
        at(i * h, d[0]), at((i + 1) * h, d[1]);
        for (int c = 0; c < 3; c++) {
            double b[8];
            for (int side = 0; side < 2; side++) { /* Bézier points from either end */
                double w = side ? -h : h, p0 = d[side][0][c], p1 = p0 + w / 7 * d[side][1][c],
                       p2 = 2 * p1 - p0 + w * w / 42 * d[side][2][c],
                       p3 = 3 * p2 - 3 * p1 + p0 + w * w * w / 210 * d[side][3][c];
                const double side_points[4] = {p0, p1, p2, p3};
                for (int k = 0; k < 4; k++) b[side ? 7 - k : k] = side_points[k];
            }
            for (int k = 0; k <= P; k++) points[(P * i + k) * 3 + c] = b[k];
        }
    }
    int n = P * spans + 1;
    for (int i = 0; i < n + P + 1; i++) knots[i] = i == 0 ? 0 : fmin((i - 1) / P, spans) * h;
    bat_curve *curve;
    assert_int_equal(bat_curve_create(3, P, false, (size_t)n, points, n + P + 1, knots, &curve), BAT_OK);
    return curve;
}

/* Frames know no size. A curve times a power of two has the same ones, down to where its coordinates are a few units of
 * the smallest number: tangents to the last bits, the rest as near as the chain is to the truth, for very small curves take
 * more steps. Loops close by the same angle. Nothing is ever NaN. */
static void tiny_and_huge(void **state) {
    (void)state;
    const int powers[] = {-200, -340, -500, -540, -900, -1000, -1029, -1040, -1060, -1072, -1080, 200, 240};
    seed = 21;
    for (int round = 0; round < 156; round++) {
        int dimension = 2 + round % 2, power = powers[round % 13], count = 4 + round % 7;
        bool closed = round / 2 % 2;
        bat_curve *curve = random_curve(dimension, closed, count), *scaled;
        double points[64], least = ldexp(1, -1074);
        for (int i = 0; i < count * dimension; i++) points[i] = ldexp(bat_curve_points(curve)[i], power);
        assert_int_equal(bat_curve_create(dimension, 3, closed, (size_t)count, points,
                                          bat_curve_knot_count(curve), bat_curve_knots(curve), &scaled),
                         BAT_OK);
        /* what a unit of the smallest number is of the curve */
        double blur = least / ldexp(100, power), near = 1e-11 + 1e6 * blur, domain[2];
        bat_curve_domain(curve, domain);
        for (int rule = 0; rule < 3; rule++) {
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            enum { COUNT = 40 };
            double u[COUNT], angle[2];
            bat_frame3 a[COUNT], b[COUNT];
            for (int i = 0; i < COUNT; i++) u[i] = domain[0] + (domain[1] - domain[0]) * i / (COUNT - 1);
            assert_int_equal(bat_frames(curve, COUNT, u, &options, a, &angle[0]), BAT_OK);
            assert_int_equal(bat_frames(scaled, COUNT, u, &options, b, &angle[1]), BAT_OK);
            assert_true(isfinite(angle[1]));
            if (near < 0.01) assert_true(fabs(remainder(angle[0] - angle[1], 2 * PI)) < 0.01);
            for (int i = 0; i < COUNT; i++) {
                assert_orthonormal(&b[i]);
                for (int d = 0; d < 3; d++) {
                    assert_true(isfinite(b[i].point[d]));
                    if (near < 0.01)
                        assert_true(fabs(a[i].t[d] - b[i].t[d]) < near && fabs(a[i].s[d] - b[i].s[d]) < 0.01);
                }
            }
        }
        bat_curve_free(scaled);
        bat_curve_free(curve);
    }
}

/* A curve all of whose points are one, also as a loop, has frames, and the same everywhere. */
static void all_points_equal(void **state) {
    (void)state;
    const double places[] = {0, 1e-310, 3, -1e75};
    for (int round = 0; round < 16; round++) {
        int dimension = 2 + round % 2;
        double points[18], knots[10];
        for (int i = 0; i < 18; i++) points[i] = places[round / 4];
        for (int i = 0; i < 10; i++) knots[i] = round / 2 % 2 ? i : i < 4 ? 0 : i > 5 ? 3 : i - 3;
        bat_curve *curve;
        assert_int_equal(
            bat_curve_create(dimension, 3, round / 2 % 2, 6, points, (round / 2 % 2) ? 7 : 10, knots, &curve),
            BAT_OK);
        for (int rule = 0; rule < 3; rule++) {
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            double u[7] = {0, 0.5, 1, 1.5, 2.2, 2.9, 3}, angle;
            bat_frame3 f[7];
            assert_int_equal(bat_frames(curve, 7, u, &options, f, &angle), BAT_OK);
            assert_true(angle == 0);
            for (int i = 0; i < 7; i++) {
                assert_orthonormal(&f[i]);
                for (int d = 0; d < dimension; d++) assert_true(f[i].point[d] == places[round / 4]);
                assert_memory_equal(f[i].t, f[0].t, sizeof f[0].t);
                assert_memory_equal(f[i].s, f[0].s, sizeof f[0].s);
            }
        }
        bat_curve_free(curve);
    }
}

/* One at a time, many at once and without a chain: the same bits, zeros with their signs. */
static void all_ways_give_the_same_bits(void **state) {
    (void)state;
    enum { COUNT = 90 };
    seed = 22;
    for (int round = 0; round < 96; round++) {
        int dimension = 2 + round % 2, count = 4 + round % 9;
        bool closed = round / 2 % 2;
        double points[64], knots[24];
        for (int i = 0; i < count * dimension; i++) /* many lie on one line, with zeros of both signs */
            points[i] = round % 3 ? uniform(-2, 2) : i % dimension == 0 ? 3 - i : round % 4 ? 0.0 : -0.0;
        for (int i = dimension; i < 4 * dimension && round % 5 == 4; i++)
            points[i] = points[i % dimension]; /* a span that is a point, beside others that are not */
        for (int i = 0; i < count + 4; i++) knots[i] = closed ? i : fmin(fmax(i - 3, 0), count - 3);
        bat_curve *curve;
        assert_int_equal(bat_curve_create(dimension, 3, closed, (size_t)count, points,
                                          closed ? count + 1 : count + 4, knots, &curve),
                         BAT_OK);
        for (int rule = 0; rule < 3; rule++) {
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            double u[COUNT], domain[2];
            double x[3 * COUNT], t[3 * COUNT], s[3 * COUNT], r[3 * COUNT];
            bat_frame3 all[COUNT];
            bat_frame_chain *chain;
            bat_curve_domain(curve, domain);
            for (int i = 0; i < COUNT; i++) u[i] = uniform(domain[0], domain[1]);
            for (int i = 0; i < COUNT / 2; i++) u[i] = domain[0] + (domain[1] - domain[0]) * i / (COUNT / 2);
            assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
            assert_int_equal(bat_frames(curve, COUNT, u, &options, all, NULL), BAT_OK);
            for (int with_r = 0; with_r < 2; with_r++) {
                const bat_frame_arrays out = {x, t, s, with_r ? r : NULL};
                assert_int_equal(bat_frame_chain_many(chain, COUNT, u, &out), BAT_OK);
                for (int i = 0; i < COUNT; i++) {
                    bat_frame3 one;
                    bat_frame_chain_at(chain, u[i], &one);
                    assert_memory_equal(one.point, x + 3 * i, sizeof one.point);
                    assert_memory_equal(one.t, t + 3 * i, sizeof one.t);
                    assert_memory_equal(one.s, s + 3 * i, sizeof one.s);
                    if (with_r) assert_memory_equal(one.r, r + 3 * i, sizeof one.r);
                    assert_memory_equal(&one, &all[i], sizeof one);
                }
            }
            bat_frame_chain_free(chain);
        }
        bat_curve_free(curve);
    }
}

static void helix_at(double t, double d[4][3]) {
    const double rows[4][3] = {{2 * cos(t), 2 * sin(t), 0.7 * t},
                               {-2 * sin(t), 2 * cos(t), 0.7},
                               {-2 * cos(t), -2 * sin(t), 0},
                               {2 * sin(t), -2 * cos(t), 0}};
    memcpy(d, rows, sizeof rows);
}

/* On a helix the rotation-minimising s turns against Frenet's normal by minus the torsion times the length. Twice
 * the steps leave a sixteenth of the error. */
static void helix(void **state) {
    (void)state;
    enum { SPANS = 20 };
    double end = 8, speed = sqrt(4 + 0.49), torsion = 0.7 / 4.49, angle = -torsion * speed * end, error[3];
    bat_curve *curve = osculating(helix_at, end, SPANS);
    double n[3] = {-cos(end), -sin(end), 0},
           b[3] = {0.7 * sin(end) / speed, -0.7 * cos(end) / speed, 2 / speed};
    for (int i = 0; i < 3; i++) {
        bat_frame_options options = bat_frame_defaults();
        options.substeps = 1 << i, options.has_first = true, options.first[0] = -1;
        bat_frame3 f;
        assert_int_equal(bat_frames(curve, 1, &end, &options, &f, NULL), BAT_OK);
        double got = atan2(dot(f.s, b), dot(f.s, n));
        error[i] = fabs(remainder(got - angle, 2 * PI));
    }
    assert_true(error[0] > 1e-7 && error[2] < 1e-6);
    assert_true(log2(error[0] / error[1]) > 3.8 && log2(error[1] / error[2]) > 3.8);
    bat_curve_free(curve);
}

static void sphere_at(double t, double d[4][3]) { /* Viviani's window, on the unit sphere */
    const double c = cos(t), s = sin(t), c2 = cos(2 * t), s2 = sin(2 * t);
    const double rows[4][3] = {
        {(1 + c2) / 2, s2 / 2, s}, {-s2, c2, c}, {-2 * c2, -2 * s2, -s}, {4 * s2, -4 * c2, -c}};
    memcpy(d, rows, sizeof rows);
}

/* On a sphere s = x / R is rotation-minimising, and double reflection keeps it at any sampling. */
static void spheres_are_exact(void **state) {
    (void)state;
    bat_curve *curve = osculating(sphere_at, 6, 30);
    bat_frame_options options = bat_frame_defaults();
    options.substeps = 1, options.has_first = true, options.first[0] = 1;
    for (int i = 0; i <= 30; i++) {
        bat_frame3 f;
        double u = i * (6.0 / 30), x[4][3];
        assert_int_equal(bat_frames(curve, 1, &u, &options, &f, NULL), BAT_OK);
        sphere_at(u, x);
        for (int d = 0; d < 3; d++) assert_true(fabs(f.s[d] - x[0][d]) < 1e-10);
    }
    bat_curve_free(curve);
}

/* The formula as the paper prints it, one step after the other, in plain arithmetic. */
static void serial_step(const double *x0, const double *t0, const double *s0, const double *x1,
                        const double *t1, double *s1) {
    double v1[3], v2[3], t[3], s[3];
    for (int d = 0; d < 3; d++) v1[d] = x1[d] - x0[d];
    for (int d = 0; d < 3; d++) {
        s[d] = s0[d] - 2 / dot(v1, v1) * dot(v1, s0) * v1[d];
        t[d] = t0[d] - 2 / dot(v1, v1) * dot(v1, t0) * v1[d];
    }
    for (int d = 0; d < 3; d++) v2[d] = t1[d] - t[d];
    for (int d = 0; d < 3; d++) s1[d] = s[d] - 2 / dot(v2, v2) * dot(v2, s) * v2[d];
}

/* The parallel form against the serial one, and one at a time against many, bit for bit, in any order. */
static void bulk_equals_serial(void **state) {
    (void)state;
    enum { STEPS = 8, MANY = 500 };
    seed = 21;
    for (int round = 0; round < 30; round++) {
        bat_curve *curve = random_curve(2 + (round % 3 > 0), round % 4 == 3, 12);
        const double *knots = bat_curve_knots(curve);
        double domain[2], x[2][6], t[2][3], s[2][3], u[MANY], point[3 * MANY], tangent[3 * MANY],
            side[3 * MANY], other[3 * MANY];
        bat_curve_domain(curve, domain);
        bat_frame_options options = bat_frame_defaults();
        options.substeps = STEPS;
        bat_frame_chain *chain;
        assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
        bat_frame3 f;
        bat_frame_chain_at(chain, domain[0], &f);
        memcpy(s[0], f.s, sizeof f.s);
        for (int k = 0;
             k + 1 < bat_curve_knot_count(curve) && bat_curve_dimension(curve) == 3 && round % 4 != 3; k++)
            for (int i = 0; i <= STEPS && knots[k + 1] > knots[k]; i++) {
                bat_curve_eval(curve, knots[k] + (knots[k + 1] - knots[k]) * i / STEPS, 1, x[1]);
                double speed = sqrt(dot(x[1] + 3, x[1] + 3));
                for (int d = 0; d < 3; d++) t[1][d] = x[1][3 + d] / speed;
                if (i > 0) {
                    serial_step(x[0], t[0], s[0], x[1], t[1], s[1]);
                    memcpy(s[0], s[1], sizeof s[0]);
                    bat_frame_chain_at(chain,
                                       fmin(knots[k] + (knots[k + 1] - knots[k]) * i / STEPS, domain[1]), &f);
                    for (int d = 0; d < 3; d++) assert_true(fabs(s[0][d] - f.s[d]) < 1e-12);
                }
                memcpy(x[0], x[1], sizeof x[0]), memcpy(t[0], t[1], sizeof t[0]);
            }
        for (int i = 0; i < MANY; i++)
            u[i] = round % 2 ? uniform(domain[0] - 1, domain[1] + 1)
                             : domain[0] + (domain[1] - domain[0]) * i / (MANY - 1);
        const bat_frame_arrays all = {point, tangent, side, other}, none = {NULL, NULL, NULL, NULL};
        assert_int_equal(bat_frame_chain_many(chain, MANY, u, &none), BAT_OK);
        assert_int_equal(bat_frame_chain_many(chain, MANY, u, &all), BAT_OK);
        for (int i = 0; i < MANY; i++) {
            bat_frame_chain_at(chain, u[i], &f);
            assert_memory_equal(f.point, point + 3 * i, sizeof f.point);
            assert_memory_equal(f.t, tangent + 3 * i, sizeof f.t);
            assert_memory_equal(f.s, side + 3 * i, sizeof f.s);
            assert_memory_equal(f.r, other + 3 * i, sizeof f.r);
        }
        bat_frame_arrays some = {NULL, tangent, side, NULL};
        double copy[3 * MANY];
        memcpy(copy, side, sizeof copy);
        assert_int_equal(bat_frame_chain_many(chain, MANY, u, &some), BAT_OK);
        assert_memory_equal(copy, side, sizeof copy);
        u[3] = NAN;
        assert_int_equal(bat_frame_chain_many(chain, MANY, u, &all), BAT_NUMBER);
        bat_frame_chain_free(chain);
        bat_curve_free(curve);
    }
}

/* Neighbours hardly differ over random curves with RMF; Frenet's flip behind inflections. */
static void flips(void **state) {
    (void)state;
    seed = 22;
    int flipped[2] = {0, 0};
    for (int round = 0; round < 60; round++) {
        bat_curve *curve = random_curve(2 + round % 2, round % 4 > 1, 10);
        double domain[2];
        bat_curve_domain(curve, domain);
        for (int rule = 0; rule < 2; rule++) {
            bat_frame_options options = bat_frame_defaults();
            options.rule = (bat_frame_rule)rule;
            bat_frame_chain *chain;
            bat_frame3 f[2];
            assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
            for (int i = 0; i <= 4000; i++) {
                bat_frame_chain_at(chain, domain[0] + (domain[1] - domain[0]) * i / 4001, &f[i % 2]);
                /* Against what the tangent alone turns. */
                if (i > 0 && dot(f[0].t, f[1].t) > 0.9 && dot(f[0].s, f[1].s) < 0.5) flipped[rule]++;
            }
            bat_frame_chain_free(chain);
        }
        bat_curve_free(curve);
    }
    assert_int_equal(flipped[0], 0);
    assert_true(flipped[1] > 20);
}

/* Straight lines in any direction and far away: nothing turns. Coordinates are multiples of 1/1024, so that the
 * curve moved by 2^30 is the same one. */
static void lines_and_far_places(void **state) {
    (void)state;
    seed = 23;
    for (int round = 0; round < 60; round++) {
        double way[3] = {round % 3 == 0, round % 3 == 1, round % 3 == 2}, points[30], far[30], knots[14];
        for (int d = 0; d < 3 && round > 5; d++) way[d] = uniform(-3, 3);
        for (int i = 0; i < 10; i++)
            for (int d = 0; d < 3; d++) points[3 * i + d] = way[d] * (i + 0.3 * (i % 3)) / 7;
        for (int i = 0; i < 14; i++) knots[i] = fmin(fmax(i - 3, 0), 7);
        bat_curve *curve, *moved;
        bat_frame3 f[2], g;
        assert_int_equal(bat_curve_create(3, 3, false, 10, points, 14, knots, &curve), BAT_OK);
        for (int i = 0; i <= 100; i++) {
            double u = 7.0 * i / 100;
            assert_int_equal(bat_frames(curve, 1, &u, NULL, &f[i > 0], NULL), BAT_OK);
            for (int d = 0; d < 3 && i > 0; d++) assert_true(fabs(f[0].s[d] - f[1].s[d]) < 1e-11);
        }
        bat_curve_free(curve);
        for (int i = 0; i < 30; i++) {
            points[i] = floor(uniform(-100, 100) * 1024) / 1024;
            far[i] = points[i] + 1073741824.0;
        }
        assert_int_equal(bat_curve_create(3, 3, false, 10, points, 14, knots, &curve), BAT_OK);
        assert_int_equal(bat_curve_create(3, 3, false, 10, far, 14, knots, &moved), BAT_OK);
        for (int i = 0; i <= 20; i++) {
            double u = 7.0 * i / 20;
            assert_int_equal(bat_frames(curve, 1, &u, NULL, &f[0], NULL), BAT_OK);
            assert_int_equal(bat_frames(moved, 1, &u, NULL, &g, NULL), BAT_OK);
            for (int d = 0; d < 3; d++) assert_true(fabs(f[0].s[d] - g.s[d]) < 1e-12);
        }
        bat_curve_free(curve);
        bat_curve_free(moved);
    }
}

/* Pictures of an animation in which the start tangent goes round and a loop winds up: s(0) never turns by more than
 * the tangent does, and the holonomy does not jump. */
static void animation(void **state) {
    (void)state;
    bat_frame_options options = bat_frame_defaults();
    double knots[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, last[3] = {0}, before[3] = {0}, angle = 0, widest = 0;
    for (int k = 0; k <= 400; k++) {
        double points[24], w = 2 * PI * k / 100, lift = 3.0 * k / 400;
        for (int i = 0; i < 8; i++) { /* a figure that turns, and is drawn out of its plane */
            double a = 2 * PI * i / 8, x = cos(a), y = sin(a), z = lift * sin(2 * a + 0.3);
            points[3 * i] = x * cos(w) - z * sin(w);
            points[3 * i + 1] = y + 0.2 * lift * cos(3 * a);
            points[3 * i + 2] = x * sin(w) + z * cos(w);
        }
        bat_curve *curve;
        bat_frame_chain *chain;
        bat_frame3 f;
        assert_int_equal(bat_curve_create(3, 3, true, 8, points, 9, knots, &curve), BAT_OK);
        assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
        bat_frame_chain_at(chain, 0, &f);
        if (k > 0) {
            double turn = acos(fmin(dot(last, f.t), 1)), spin = acos(fmin(dot(before, f.s), 1));
            assert_true(turn < 0.5 && spin <= turn + 1e-7);
            assert_true(fabs(bat_frame_chain_holonomy(chain) - angle) < 0.5);
        }
        memcpy(last, f.t, sizeof last), memcpy(before, f.s, sizeof before);
        angle = bat_frame_chain_holonomy(chain);
        widest = fmax(widest, fabs(angle));
        bat_frame_chain_follow(chain, &options);
        bat_frame_chain_free(chain);
        bat_curve_free(curve);
    }
    assert_true(widest > 1);
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
        cmocka_unit_test(tiny_and_huge),
        cmocka_unit_test(all_points_equal),
        cmocka_unit_test(all_ways_give_the_same_bits),
        cmocka_unit_test(helix),
        cmocka_unit_test(spheres_are_exact),
        cmocka_unit_test(bulk_equals_serial),
        cmocka_unit_test(flips),
        cmocka_unit_test(lines_and_far_places),
        cmocka_unit_test(animation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
