/*
 * Round splines: as near to smooth curves as their own directions allow, without hooks; curvature is continuous where no
 * direction is given; a given one stops every influence; nothing that somebody places makes them fail.
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
#include <batten/tangents.h>
#include "base/real.h"
#include "base/vec.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 24, NINE = 9, SAMPLES = 100 };

static const bat_tangents_options ROUND = {sizeof ROUND, BAT_TANGENTS_ROUND, BAT_TANGENTS_CENTRIPETAL};

typedef struct made {
    bat_joint joints[MOST + 1];
    double *bezier;
    bat_curve *curve;
    int segments;
} made;

static made make(const bat_spline *s) {
    made m;
    assert_int_equal(bat_tangents(s, &ROUND, m.joints, &m.segments, &m.bezier, &m.curve), BAT_OK);
    return m;
}

static void end(made *m) {
    bat_free(m->bezier);
    bat_curve_free(m->curve);
}

static vec control(const made *m, int dimension, int segment, int j) {
    return vec_load(m->bezier + (4 * segment + j) * dimension, dimension);
}

static vec cubic(const vec b[4], double t) {
    const double s = 1 - t, w[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    vec sum = {0, 0, 0};
    for (int j = 0; j < 4; j++) sum = vec_add(sum, vec_scale(b[j], w[j]));
    return sum;
}

/* Curvature as a vector at b0 of a cubic that begins b0, b1, b2. */
static vec curvature(vec b0, vec b1, vec b2) {
    const vec handle = vec_sub(b1, b0);
    return vec_scale(vec_reject(vec_sub(b2, b1), vec_unit(handle)), 2 / (3 * vec_dot(handle, handle)));
}

/* ---- near to smooth curves ---- */

typedef struct figure {
    int kind;
    double a, b;
    double points[12];
} figure;

/* A smooth curve at u from 0 to 1, in drawing units. */
static vec place(const figure *f, double u) {
    if (f->kind == 0) return (vec){600 * u, f->a * sin(5 + f->b * u), 0};
    if (f->kind == 1) return vec_scale((vec){cos(f->b * u), sin(f->b * u), 0}, 100 * exp(f->a * u));
    if (f->kind == 2) return (vec){200 * cos(2 * BAT_PI * u), f->a * sin(2 * BAT_PI * u), 0};
    if (f->kind == 5) { /* a clothoid, by Simpson's rule */
        vec sum = {0, 0, 0};
        for (int i = 0; i <= 400; i++) {
            const double s = u * i / 400, w = (i == 0 || i == 400 ? 1 : i % 2 ? 4 : 2) * u / 1200;
            const double turn = f->a * s + f->b * s * s;
            sum = vec_add(sum, vec_scale((vec){cos(turn), sin(turn), 0}, 300 * w));
        }
        return sum;
    }
    const int degree = f->kind == 3 ? 3 : 5; /* a Bézier curve, by de Casteljau */
    vec b[6];
    for (int i = 0; i <= degree; i++) b[i] = (vec){f->points[2 * i], f->points[2 * i + 1], 0};
    for (int n = degree; n > 0; n--)
        for (int i = 0; i < n; i++) b[i] = vec_add(vec_scale(b[i], 1 - u), vec_scale(b[i + 1], u));
    return b[0];
}

static figure random_figure(random_source *r, int round) {
    static const double low[6][2] = {{50, 5}, {0.3, 3}, {80, 0}, {0, 0}, {0, 0}, {-3, -8}};
    static const double high[6][2] = {{150, 9}, {2, 8}, {200, 0}, {0, 0}, {0, 0}, {3, 8}};
    figure f = {.kind = round % 6};
    f.a = random_between(r, low[f.kind][0], high[f.kind][0]);
    f.b = random_between(r, low[f.kind][1], high[f.kind][1]);
    for (int i = 0; i < 12; i++)
        f.points[i] = i % 2 ? random_between(r, 0, 300) : 60 * i + random_between(r, -30, 30);
    return f;
}

static double turn_of(const vec *p, int count) {
    double sum = 0;
    for (int i = 2; i < count; i++) sum += vec_angle(vec_sub(p[i - 1], p[i - 2]), vec_sub(p[i], p[i - 1]));
    return sum;
}

/* How far samples of one curve lie from the polygon of another at most. */
static double apart(const vec *from, const vec *to, int count) {
    double most = 0;
    for (int i = 0; i < count; i++) {
        double least = INFINITY;
        for (int j = 0; j + 1 < count; j++) {
            const vec d = vec_sub(to[j + 1], to[j]), e = vec_sub(from[i], to[j]);
            const double t = fmin(fmax(vec_dot(d, e) / vec_dot(d, d), 0), 1);
            least = fmin(least, vec_norm(vec_sub(e, vec_scale(d, t))));
        }
        most = fmax(most, least);
    }
    return most;
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Curves of six kinds, at nine points with their own directions: nowhere a hook, which is a turn by a radian more than
 * that of the curve, and 95 of 100 segments within 1.5 % of their chord. */
static void smooth_curves(void **state) {
    (void)state;
    enum { FIGURES = 120, SEGMENTS = FIGURES * (NINE - 1) };
    static double off[SEGMENTS];
    random_source r = {7};
    for (int round = 0; round < FIGURES; round++) {
        const figure f = random_figure(&r, round);
        double points[2 * NINE], tangents[2 * NINE];
        for (int i = 0; i < NINE; i++) {
            const double u = i / (NINE - 1.0);
            const vec at = place(&f, u), way = vec_sub(place(&f, u + 1e-5), place(&f, u - 1e-5));
            points[2 * i] = at.x, points[2 * i + 1] = at.y;
            tangents[2 * i] = way.x, tangents[2 * i + 1] = way.y;
        }
        const bat_spline s = {2, false, NINE, points, tangents, NULL};
        made m = make(&s);
        for (int i = 0; i + 1 < NINE; i++) {
            vec smooth[SAMPLES], built[SAMPLES], b[4];
            for (int j = 0; j < 4; j++) b[j] = control(&m, 2, i, j);
            for (int k = 0; k < SAMPLES; k++) {
                smooth[k] = place(&f, (i + k / (SAMPLES - 1.0)) / (NINE - 1));
                built[k] = cubic(b, k / (SAMPLES - 1.0));
            }
            assert_true(turn_of(built, SAMPLES) < turn_of(smooth, SAMPLES) + 1);
            off[(NINE - 1) * round + i] = fmax(apart(smooth, built, SAMPLES), apart(built, smooth, SAMPLES)) /
                                          vec_norm(vec_sub(b[3], b[0]));
        }
        end(&m);
    }
    qsort(off, SEGMENTS, sizeof *off, ascending);
    assert_true(off[SEGMENTS / 2] < 0.003);
    assert_true(off[SEGMENTS * 95 / 100] < 0.015);
}

/* An arc of any angle is as good an arc as its two handles make it: 4/3 tan of a quarter of the angle, radii long. */
static void arcs(void **state) {
    (void)state;
    for (double turn = 0.1; turn < 4; turn += 0.1) {
        const double points[4] = {1, 0, cos(turn), sin(turn)}, tangents[4] = {0, 1, -sin(turn), cos(turn)};
        const bat_spline both = {2, false, 2, points, tangents, NULL},
                         one = {2, false, 2, points, NULL, NULL};
        bat_spline first = one;
        double given[4] = {0, 1, 0, 0};
        first.tangents = given;
        made m = make(&both), n = make(&first);
        const double handle = 4.0 / 3 * tan(turn / 4);
        assert_true(fabs(vec_norm(vec_load(m.joints[0].right, 3)) / 3 - handle) < 1e-13);
        assert_true(fabs(vec_norm(vec_load(m.joints[1].left, 3)) / 3 - handle) < 1e-13);
        for (int i = 0; i < 8; i++)
            assert_true(fabs(m.bezier[i] - n.bezier[i]) < 1e-12); /* a free end is an arc's */
        end(&m);
        end(&n);
    }
}

/* Points of a circle, all round it or on a part, give its tangents, in the plane and tilted in space. */
static void circles(void **state) {
    (void)state;
    for (int round = 0; round < 60; round++) {
        const int count = 2 + round % 9, dimension = round % 2 ? 3 : 2;
        const bool closed = round % 3 != 0;
        if (!closed && count < 3) continue;
        const double step = closed ? 2 * BAT_PI / count : 0.3 + 0.1 * (round % 4),
                     tilt = dimension == 3 ? 0.7 : 0;
        double points[3 * MOST];
        for (int i = 0; i < count; i++) {
            double *p = points + dimension * i;
            p[0] = 100 * cos(step * i), p[1] = 100 * sin(step * i) * cos(tilt);
            if (dimension == 3) p[2] = 100 * sin(step * i) * sin(tilt);
        }
        const bat_spline s = {dimension, closed, (size_t)count, points, NULL, NULL};
        made m = make(&s);
        for (int i = 0; i < count && (dimension == 2 || count > 2); i++) {
            const vec way = vec_unit(vec_load(i || closed ? m.joints[i].left : m.joints[i].right, 3));
            const vec tangent = {-sin(step * i), cos(step * i) * cos(tilt), cos(step * i) * sin(tilt)};
            if (count > 2) assert_true(vec_norm(vec_sub(way, tangent)) < 1e-9);
            assert_true(fabs(vec_dot(way, vec_load(points + dimension * i, dimension))) < 1e-9 * 100);
        }
        end(&m);
    }
}

/* ---- directions found together ---- */

typedef struct setup {
    double points[3 * MOST], tangents[3 * MOST];
    bat_spline spline;
} setup;

/* Points around a ring or along a wave, in the plane or in space; some directions given where `given` is above 0. */
static void tame(setup *s, random_source *r, int round, double given) {
    const int count = 3 + round % 10, dimension = 2 + round % 2;
    const bool closed = round % 4 > 1;
    for (int i = 0; i < count; i++) {
        double *p = s->points + dimension * i, *t = s->tangents + dimension * i;
        const double angle = 2 * BAT_PI * i / count, radius = random_between(r, 70, 100);
        const double rise = random_between(r, 0, 60), bend = random_between(r, -0.5, 0.5);
        const bool has = random_between(r, 0, 1) < given;
        p[0] = closed ? radius * cos(angle) : 100 * i, p[1] = closed ? radius * sin(angle) : rise;
        t[0] = closed ? -sin(angle + bend) : cos(bend), t[1] = closed ? cos(angle + bend) : sin(bend);
        if (dimension == 3) p[2] = random_between(r, 0, 40), t[2] = random_between(r, -0.4, 0.4);
        for (int d = 0; d < dimension && !has; d++) t[d] = 0;
    }
    s->spline = (bat_spline){dimension, closed, (size_t)count, s->points, s->tangents, NULL};
}

static bool is_given(const setup *s, int i) {
    return vec_norm(vec_load(s->tangents + s->spline.dimension * i, s->spline.dimension)) > 0;
}

/* Through every point, along every direction that is given; where none is, curvature is the same on both sides. */
static void curvature_is_continuous(void **state) {
    (void)state;
    random_source r = {8};
    for (int round = 0; round < 800; round++) {
        setup s;
        tame(&s, &r, round, round % 3 ? 0.3 : 0);
        const int count = (int)s.spline.count, n = s.spline.dimension;
        made m = make(&s.spline);
        assert_int_equal(m.segments, s.spline.closed ? count : count - 1);
        for (int i = 0; i < count; i++) {
            const vec here = vec_load(s.points + n * i, n);
            if (i < m.segments) assert_true(vec_norm(vec_sub(control(&m, n, i, 0), here)) == 0);
            const bool ends = !s.spline.closed && (i == 0 || i == count - 1);
            const vec way = vec_load(i < m.segments ? m.joints[i].right : m.joints[i].left, 3);
            if (is_given(&s, i)) assert_true(vec_angle(way, vec_load(s.tangents + n * i, n)) < 1e-9);
            if (ends) continue;
            assert_true(vec_angle(way, vec_load(m.joints[i].left, 3)) < 1e-9);
            if (is_given(&s, i)) continue;
            const int last = (i + m.segments - 1) % m.segments;
            const vec before = curvature(here, control(&m, n, last, 2), control(&m, n, last, 1));
            const vec after = curvature(here, control(&m, n, i, 1), control(&m, n, i, 2));
            assert_true(vec_norm(vec_sub(before, after)) <=
                        1e-9 * (vec_norm(before) + vec_norm(after) + 1e-2));
        }
        end(&m);
    }
}

/* Of given directions one is turned: up to the next given one on either side the curve changes, and no bit beyond. */
static void given_directions_stop_it(void **state) {
    (void)state;
    random_source r = {9};
    for (int round = 0; round < 400; round++) {
        setup s;
        tame(&s, &r, round, 0.5);
        const int count = (int)s.spline.count, n = s.spline.dimension;
        int turned = 0;
        while (turned < count && !is_given(&s, turned)) turned++;
        if (turned == count) continue;
        made m = make(&s.spline);
        for (int d = 0; d < n; d++) s.tangents[n * turned + d] += d ? 0.3 : 0.1;
        made after = make(&s.spline);
        bool felt[MOST] = {false};
        for (int step = -1; step <= 1; step += 2) {
            int i = turned;
            do {
                const int segment = step > 0 ? i : i - 1;
                if (!s.spline.closed && (segment < 0 || segment >= m.segments)) break;
                felt[(segment + m.segments) % m.segments] = true;
                i = (i + step + count) % count;
            } while (!is_given(&s, i));
        }
        for (int i = 0; i < m.segments; i++)
            if (!felt[i])
                assert_memory_equal(m.bezier + 4 * n * i, after.bezier + 4 * n * i,
                                    (size_t)n * 4 * sizeof(double));
        end(&m);
        end(&after);
    }
}

/* ---- the same curve, seen otherwise ---- */

static void assert_image(const made *m, const made *image, int n, double size) {
    assert_int_equal(m->segments, image->segments);
    for (int i = 0; i < 4 * n * m->segments; i++)
        assert_true(fabs(m->bezier[i] - image->bezier[i]) < 1e-9 * size);
}

/* A million times larger and smaller, turned, mirrored, backwards; and a plane curve in space. */
static void similar_points(void **state) {
    (void)state;
    random_source r = {10};
    for (int round = 0; round < 300; round++) {
        setup s, other;
        tame(&s, &r, round, round % 2 ? 0.3 : 0);
        const int count = (int)s.spline.count, n = s.spline.dimension;
        made m = make(&s.spline);
        const double scale = round % 2 ? 1e6 : 1e-6, c = cos(round), q = sin(round),
                     flip = round % 3 ? 1 : -1;
        other = s;
        other.spline.points = other.points, other.spline.tangents = other.tangents;
        for (int i = 0; i < count; i++) {
            double *p = other.points + n * i, *t = other.tangents + n * i;
            const double x = p[0], y = flip * p[1], tx = t[0], ty = flip * t[1];
            p[0] = scale * (c * x - q * y), p[1] = scale * (q * x + c * y);
            t[0] = c * tx - q * ty, t[1] = q * tx + c * ty;
            if (n == 3) p[2] *= scale;
        }
        made image = make(&other.spline);
        for (int i = 0; i < 4 * m.segments; i++) {
            double *p = image.bezier + n * i;
            const double x = p[0] / scale, y = p[1] / scale;
            p[0] = c * x + q * y, p[1] = flip * (c * y - q * x);
            if (n == 3) p[2] /= scale;
        }
        assert_image(&m, &image, n, 1000);
        end(&image);
        for (int i = 0; i < count; i++) /* backwards from the same first point */
            for (int d = 0; d < n; d++) {
                const int from = s.spline.closed ? (count - i) % count : count - 1 - i;
                other.points[n * i + d] = s.points[n * from + d];
                other.tangents[n * i + d] = -s.tangents[n * from + d];
            }
        image = make(&other.spline);
        for (int i = 0; i < m.segments; i++)
            for (int j = 0; j < 4; j++)
                assert_true(vec_norm(vec_sub(control(&m, n, i, j),
                                             control(&image, n, m.segments - 1 - i, 3 - j))) < 1e-9 * 1000);
        end(&image);
        if (n == 2) {
            for (int i = 0; i < count; i++) {
                double *p = other.points + 3 * i, *t = other.tangents + 3 * i;
                p[0] = s.points[2 * i], p[1] = 0, p[2] = s.points[2 * i + 1];
                t[0] = s.tangents[2 * i], t[1] = 0, t[2] = s.tangents[2 * i + 1];
            }
            other.spline.dimension = 3;
            image = make(&other.spline);
            for (int i = 0; i < 4 * m.segments; i++) {
                assert_true(fabs(image.bezier[3 * i] - m.bezier[2 * i]) < 1e-9 * 1000);
                assert_true(fabs(image.bezier[3 * i + 1]) < 1e-9 * 1000);
                assert_true(fabs(image.bezier[3 * i + 2] - m.bezier[2 * i + 1]) < 1e-9 * 1000);
            }
            end(&image);
        }
        end(&m);
    }
}

/* ---- the edges ---- */

/* The default of the library. */
static void is_the_default(void **state) {
    (void)state;
    const double points[] = {0, 0, 50, 40, 120, 10};
    const bat_spline s = {2, false, 3, points, NULL, NULL};
    double *bezier;
    int segments;
    made m = make(&s);
    assert_int_equal(bat_tangents(&s, NULL, NULL, &segments, &bezier, NULL), BAT_OK);
    assert_int_equal(bat_tangents_defaults().mode, BAT_TANGENTS_ROUND);
    assert_memory_equal(bezier, m.bezier, 16 * sizeof *bezier);
    bat_free(bezier);
    end(&m);
}

/* Anything is passed through, in finite handles of two chords at most, and along what is given. */
static void anything_goes(void **state) {
    (void)state;
    random_source r = {11};
    for (int round = 0; round < 3000; round++) {
        setup s;
        const int count = 2 + round % 12, n = 2 + round % 2, grid = round % 5;
        for (int i = 0; i < n * count; i++) {
            s.points[i] = random_between(&r, 0, 4), s.tangents[i] = random_between(&r, -1, 1);
            if (grid == 0)
                s.points[i] = floor(s.points[i]), s.tangents[i] = round / 2 % 2 ? floor(s.tangents[i]) : 0;
            if (grid == 1 && i % n) s.points[i] = 0;                  /* there and back on a line */
            if (grid == 2) s.points[i] = ldexp(s.points[i], -i % 40); /* ever shorter chords */
            if (grid == 3) s.tangents[i] = i / n % 3 ? 0 : s.tangents[i];
        }
        s.spline = (bat_spline){n, round / 3 % 2, (size_t)count, s.points, s.tangents, NULL};
        made m;
        const bat_status status = bat_tangents(&s.spline, &ROUND, m.joints, &m.segments, &m.bezier, &m.curve);
        if (status == BAT_COUNT) continue;
        assert_int_equal(status, BAT_OK);
        for (int i = 0, segment = 0; segment < m.segments; i++) {
            if (m.joints[i].dropped) continue;
            const vec a = control(&m, n, segment, 0), b = control(&m, n, segment, 3);
            const double chord = vec_norm(vec_sub(b, a));
            assert_true(vec_norm(vec_sub(a, vec_load(s.points + n * i, n))) == 0);
            assert_true(vec_norm(vec_sub(control(&m, n, segment, 1), a)) <= 2 * chord * (1 + 1e-12));
            assert_true(vec_norm(vec_sub(control(&m, n, segment, 2), b)) <= 2 * chord * (1 + 1e-12));
            if (is_given(&s, i))
                assert_true(vec_angle(vec_load(m.joints[i].right, 3), vec_load(s.tangents + n * i, n)) <
                            1e-9);
            segment++;
        }
        end(&m);
    }
}

/* In space, too, two points alone are a circle's two halves, in some plane through them. */
static void two_in_space(void **state) {
    (void)state;
    random_source source = {11};
    for (int round = 0; round < 100; round++) {
        double points[6];
        for (int i = 0; i < 6; i++) points[i] = random_between(&source, -300, 300);
        const bat_spline s = {3, true, 2, points, NULL, NULL};
        const vec a = vec_load(points, 3), b = vec_load(points + 3, 3),
                  middle = vec_scale(vec_add(a, b), 0.5);
        const double radius = vec_norm(vec_sub(b, a)) / 2;
        made m = make(&s);
        assert_int_equal(m.segments, 2);
        vec half[2];
        for (int i = 0; i < 2; i++) {
            vec c[4];
            for (int j = 0; j < 4; j++) c[j] = control(&m, 3, i, j);
            half[i] = vec_sub(cubic(c, 0.5), middle);
            assert_true(fabs(vec_norm(half[i]) - radius) < 1e-12 * radius);
            assert_true(fabs(vec_dot(half[i], vec_sub(b, a))) < 1e-12 * radius * radius);
        }
        assert_true(vec_norm(vec_add(half[0], half[1])) < 1e-12 * radius);
        end(&m);
    }
}

/* A point that repeats the one before is left out; two points alone are a line, and closed a circle's two halves. */
static void few_points(void **state) {
    (void)state;
    const double repeated[] = {0, 0, 50, 40, 50, 40, 120, 10}, plain[] = {0, 0, 50, 40, 120, 10},
                 two[] = {0, 0, 2, 0};
    const bat_spline s = {2, false, 4, repeated, NULL, NULL}, t = {2, false, 3, plain, NULL, NULL};
    const bat_spline line = {2, false, 2, two, NULL, NULL}, loop = {2, true, 2, two, NULL, NULL};
    const bat_spline one = {2, true, 2, repeated + 2, NULL, NULL};
    made m = make(&s), k = make(&t);
    assert_true(m.joints[2].dropped);
    assert_memory_equal(m.bezier, k.bezier, 16 * sizeof(double));
    end(&m);
    end(&k);
    m = make(&line);
    for (int i = 0; i < 4; i++)
        assert_true(vec_norm(vec_sub(control(&m, 2, 0, i), (vec){2 * i / 3.0, 0, 0})) < 1e-15);
    end(&m);
    m = make(&loop);
    assert_int_equal(m.segments, 2);
    for (int i = 0; i < 2; i++)
        for (int j = 1; j < 3; j++)
            assert_true(fabs(fabs(control(&m, 2, i, j).y) - 4.0 / 3) < 1e-12 &&
                        control(&m, 2, i, j).y * control(&m, 2, 1 - i, j).y < 0);
    end(&m);
    assert_int_equal(bat_tangents(&one, &ROUND, NULL, NULL, NULL, NULL), BAT_COUNT);
}

/* A point put on the curve leaves its shape, and comes back as the direction that the curve has there. */
static void insertion_keeps_the_shape(void **state) {
    (void)state;
    random_source r = {12};
    for (int round = 0; round < 300; round++) {
        setup s;
        tame(&s, &r, round, round % 3 ? 0.4 : 0);
        const int count = (int)s.spline.count, n = s.spline.dimension;
        const double t = random_between(&r, 0.1, 0.9);
        made m = make(&s.spline);
        const int segment = round % m.segments;
        bat_spline longer;
        void *block;
        int index;
        double deviation;
        vec b[4];
        for (int j = 0; j < 4; j++) b[j] = control(&m, n, segment, j);
        assert_int_equal(
            bat_tangents_insert(&s.spline, segment, t, &ROUND, &longer, &block, &index, &deviation), BAT_OK);
        assert_int_equal(longer.count, count + 1);
        assert_true(deviation < 1e-8 * 1000);
        assert_true(vec_norm(vec_sub(vec_load(longer.points + n * index, n), cubic(b, t))) < 1e-10 * 1000);
        bat_free(block);
        end(&m);
    }
}

static void failing_allocations(void **state) {
    (void)state;
    const double points[] = {0, 0, 50, 40, 120, 10, 90, -50};
    const bat_spline s = {2, true, 4, points, NULL, NULL};
    for (long n = 1;; n++) {
        const long before = alloc_live();
        bat_curve *curve = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_tangents(&s, &ROUND, NULL, NULL, NULL, &curve);
        const bool failed = alloc_fail_reached();
        assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
        bat_curve_free(curve);
        assert_int_equal(alloc_live(), before);
        if (!failed) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(smooth_curves),
                                       cmocka_unit_test(arcs),
                                       cmocka_unit_test(circles),
                                       cmocka_unit_test(curvature_is_continuous),
                                       cmocka_unit_test(given_directions_stop_it),
                                       cmocka_unit_test(similar_points),
                                       cmocka_unit_test(is_the_default),
                                       cmocka_unit_test(anything_goes),
                                       cmocka_unit_test(few_points),
                                       cmocka_unit_test(two_in_space),
                                       cmocka_unit_test(insertion_keeps_the_shape),
                                       cmocka_unit_test(failing_allocations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
