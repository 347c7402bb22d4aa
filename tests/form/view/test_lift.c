/* Lifting a curve by a stroke in a second view: heights against known ones, the first view stays, what the stroke does not
 * cover stays, and what cannot be lifted is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <cmocka.h>
#include "form/view/lift.h"
#include "support/random_curve.h"
#include <batten/refine.h>

enum { SAMPLES = 200 };
static const double pi = 3.14159265358979323846;

/* From the front, 45 degrees above the page; z points down, so the eye is at negative z. */
static bat_viewpoint before(void) {
    return (bat_viewpoint){.eye = {0, 100, -100}, .up = {0, 0, -1}, .size = {1000, 1000}, .height = 50};
}

/* From above the middle of a ring, which is seen from within all round. */
static bat_viewpoint above(void) {
    return (bat_viewpoint){.eye = {0, 0, -20}, .up = {0, 1, 0}, .size = {1000, 1000}, .fov = 80};
}

/* Curves that are seen from the side all along: x goes to and fro, y wanders a little. */
static bat_curve *level_curve(int dimension, int degree, bool closed, int count) {
    double points[3 * 64], knots[72];
    for (int i = 0; i < count; i++) {
        const double t = (double)i / (closed ? count : count - 1);
        double *p = points + dimension * i;
        p[0] = closed ? 10 * cos(2 * pi * t) : 20 * t - 10;
        p[1] = closed ? 8 * sin(2 * pi * t) : 0.5 * sin(9 * t);
        if (dimension == 3) p[2] = 0.3 * cos(4 * t);
    }
    const int size = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < size; i++) knots[i] = closed ? i : fmin(fmax(i - degree, 0), count - degree);
    bat_curve *curve = NULL;
    if (bat_curve_create(dimension, degree, closed, (size_t)count, points, size, knots, &curve) != BAT_OK)
        abort();
    return curve;
}

static double bump(double t) { return t <= 0 || t >= 1 ? 0 : 2 * pow(sin(pi * t), 2); }

/* The place on the curve, `up` above it. */
static void place(const bat_curve *curve, double u, double up, double out[3]) {
    out[2] = 0;
    bat_curve_eval(curve, u, 0, out);
    out[2] -= up;
}

/* The pixels of the curve from share a to b of its domain, lifted by a bump over that range. */
static void draw(const bat_viewpoint *view, const bat_curve *curve, double a, double b, double *pixels) {
    double domain[2], at[3];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1);
        place(curve, domain[0] + (domain[1] - domain[0]) * (a + (b - a) * t), bump(t), at);
        if (bat_viewpoint_project(view, at, pixels + 2 * i, NULL) != BAT_OK) abort();
    }
}

static bat_status lift(const bat_viewpoint *view, const bat_curve *curve, size_t count, double *pixels,
                       double tolerance, bat_curve **out, size_t *dropped) {
    const bat_stroke stroke = {.dimension = 2, .count = count, .points = pixels};
    return bat_lift(view, &stroke, curve, tolerance, out, dropped);
}

static void heights_are_those_of_the_stroke(void **state) {
    (void)state;
    static const struct {
        int dimension, degree, count;
        bool closed;
        double from, to;
    } cases[] = {{2, 3, 8, false, 0, 1},     {3, 3, 8, false, 0, 1},       {2, 1, 5, false, 0, 1},
                 {2, 5, 9, false, 0.3, 0.7}, {3, 2, 7, false, 0.5, 1},     {2, 3, 12, true, 0, 1},
                 {3, 3, 12, true, 0.1, 0.4}, {2, 1, 2, false, 0.31, 0.67}, {2, 3, 60, false, 0.4, 0.6}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        bat_curve *curve = level_curve(cases[k].dimension, cases[k].degree, cases[k].closed, cases[k].count),
                  *made = NULL;
        double pixels[2 * SAMPLES], domain[2], at[3], was[3], most = 0;
        const double tolerance = 0.02;
        size_t dropped = 7;
        bat_curve_domain(curve, domain);
        const bat_viewpoint view = cases[k].closed ? above() : before();
        draw(&view, curve, cases[k].from, cases[k].to, pixels);
        const bat_status status = lift(&view, curve, SAMPLES, pixels, tolerance, &made, &dropped);
        if (status != BAT_OK) fail_msg("case %zu: status %d", k, (int)status);
        assert_int_equal(bat_curve_dimension(made), 3);
        assert_int_equal(bat_curve_is_closed(made), cases[k].closed);
        assert_true(dropped < SAMPLES / 3);
        for (int i = 0; i <= 400; i++) {
            const double share = i / 400.0, u = domain[0] + (domain[1] - domain[0]) * share;
            const double t = (share - cases[k].from) / (cases[k].to - cases[k].from);
            bat_curve_eval(made, u, 0, at);
            place(curve, u, 0, was);
            assert_true(fabs(at[0] - was[0]) < 1e-9 && fabs(at[1] - was[1]) < 1e-9);
            most = fmax(most, fabs(was[2] - at[2] - bump(t)));
        }
        /* a polyline's corners are rounded by nothing; splines come as near as the mean says */
        if (!(most < (cases[k].degree == 1 ? 0.4 : 0.15))) fail_msg("case %zu: off by %g", k, most);
        bat_curve_free(curve);
        bat_curve_free(made);
    }
}

/* Far from the stroke every control point keeps its height. */
static void the_rest_stays(void **state) {
    (void)state;
    bat_curve *curve = level_curve(3, 3, false, 40), *made = NULL;
    double pixels[2 * SAMPLES], domain[2], at[3], was[3];
    size_t dropped;
    const bat_viewpoint view = before();
    bat_curve_domain(curve, domain);
    draw(&view, curve, 0.4, 0.6, pixels);
    assert_int_equal(lift(&view, curve, SAMPLES, pixels, 0.01, &made, &dropped), BAT_OK);
    for (int i = 0; i <= 200; i++) {
        const double u = domain[0] + (domain[1] - domain[0]) * i / 200;
        if (i > 60 && i < 140) continue;
        bat_curve_eval(made, u, 0, at);
        bat_curve_eval(curve, u, 0, was);
        assert_true(fabs(at[2] - was[2]) < 1e-12);
    }
    bat_curve_free(curve);
    bat_curve_free(made);
}

/* A hand that trembles is followed in the mean, and the search ends. */
static void a_tolerance_that_cannot_be_met(void **state) {
    (void)state;
    bat_curve *curve = level_curve(2, 3, false, 8), *made = NULL;
    double pixels[2 * SAMPLES];
    size_t dropped;
    const bat_viewpoint view = before();
    draw(&view, curve, 0, 1, pixels);
    for (int i = 0; i < SAMPLES; i++) pixels[2 * i + 1] += i % 2 ? 3 : -3; /* .15 up and down */
    assert_int_equal(lift(&view, curve, SAMPLES, pixels, 1e-6, &made, &dropped), BAT_OK);
    assert_true(bat_curve_count(made) <= 8 + 5 * 64);
    double at[3], domain[2];
    bat_curve_domain(made, domain);
    bat_curve_eval(made, 0.5 * (domain[0] + domain[1]), 0, at);
    assert_true(fabs(-at[2] - 2) < 0.4);
    bat_curve_free(curve);
    bat_curve_free(made);
}

static void what_cannot_be_lifted(void **state) {
    (void)state;
    bat_curve *curve = level_curve(2, 3, false, 8), *made = NULL;
    double pixels[2 * SAMPLES];
    size_t dropped = 0;
    const bat_viewpoint view = before();
    draw(&view, curve, 0, 1, pixels);
    assert_int_equal(lift(&view, curve, 0, pixels, 0.1, &made, &dropped), BAT_DOT);
    assert_int_equal(lift(&view, curve, 1, pixels, 0.1, &made, &dropped), BAT_DOT);
    for (int i = 0; i < SAMPLES; i++) pixels[2 * i] = 500 + 0 * i, pixels[2 * i + 1] = 500;
    assert_int_equal(lift(&view, curve, SAMPLES, pixels, 0.1, &made, &dropped), BAT_DOT);
    for (int i = 0; i < SAMPLES; i++) pixels[2 * i] = 990; /* beside it */
    assert_int_equal(lift(&view, curve, SAMPLES, pixels, 0.1, &made, &dropped), BAT_FAR);
    assert_int_equal(dropped, SAMPLES);
    pixels[7] = NAN;
    assert_int_equal(lift(&view, curve, SAMPLES, pixels, 0.1, &made, &dropped), BAT_NUMBER);
    assert_null(made);
    assert_null(made);
    bat_curve_free(curve);
}

/* However many control points there are. */
static void long_curves_are_lifted(void **state) {
    (void)state;
    static const int many[] = {500, 2000, 20000};
    const bat_viewpoint view = before();
    for (int k = 0; k < 3; k++) {
        double *points = malloc((size_t)many[k] * 2 * sizeof *points), pixels[2 * SAMPLES], at[3], domain[2];
        assert_non_null(points);
        bat_curve *curve = NULL, *made = NULL;
        size_t dropped = 0;
        for (int i = 0; i < many[k]; i++) points[2 * i] = 20.0 * i / many[k] - 10, points[2 * i + 1] = 0;
        assert_int_equal(bat_curve_create_clamped(2, 3, (size_t)many[k], points, &curve), BAT_OK);
        draw(&view, curve, 0, 1, pixels);
        assert_int_equal(lift(&view, curve, SAMPLES, pixels, 0.05, &made, &dropped), BAT_OK);
        bat_curve_domain(made, domain);
        bat_curve_eval(made, domain[0] / 2 + domain[1] / 2, 0, at);
        assert_true(fabs(-at[2] - bump(0.5)) < 0.1);
        bat_curve_free(curve), bat_curve_free(made);
        free(points);
    }
}

/* A ring of 10 by 8 in space, so high over the page at an angle. */
static double ring_height(double angle) { return 1.2 + 0.6 * cos(2 * angle) + 0.4 * sin(angle); }

/* Seen from the side, at an angle over the page, a ring is lifted by a stroke that goes round its picture, from wherever
 * it begins and either way: at the sides, where its surface is seen from its edge, the stroke goes on round the bend. */
static void a_ring_is_lifted_from_the_side(void **state) {
    (void)state;
    for (int k = 0; k < 24; k++) {
        const double tilt = (35 + 15 * (k % 3)) * pi / 180, begin = 0.3 + 1.1 * (k % 8),
                     way = k < 12 ? 1 : -1;
        const bat_viewpoint view = {.eye = {0, 100 * sin(tilt), -100 * cos(tilt)},
                                    .up = {0, 0, -1},
                                    .size = {1000, 1000},
                                    .height = 50};
        bat_curve *ring = level_curve(2, 3, true, 24), *made = NULL;
        double pixels[2 * SAMPLES], domain[2], at[3], was[3] = {0};
        size_t dropped = 0;
        bat_curve_domain(ring, domain);
        const double width = domain[1] - domain[0];
        for (int i = 0; i < SAMPLES; i++) {
            const double turn = begin / (2 * pi) + way * i / (SAMPLES - 1), share = turn - floor(turn);
            place(ring, domain[0] + width * share, ring_height(2 * pi * share), at);
            assert_int_equal(bat_viewpoint_project(&view, at, pixels + 2 * i, NULL), BAT_OK);
        }
        assert_true(bat_lift_shows(&view, ring));
        assert_int_equal(lift(&view, ring, SAMPLES, pixels, 0.02, &made, &dropped), BAT_OK);
        assert_true(dropped > 0 && 3 * dropped < SAMPLES);
        for (int i = 0; i < 360; i++) {
            const double u = domain[0] + width * i / 360;
            bat_curve_eval(made, u, 0, at);
            bat_curve_eval(ring, u, 0, was);
            assert_true(fabs(at[0] - was[0]) < 1e-9 && fabs(at[1] - was[1]) < 1e-9);
            const double off = fabs(-at[2] - ring_height(2 * pi * i / 360));
            if (!(off < 0.25)) fail_msg("ring %d at %d degrees: %g off, %zu dropped", k, i, off, dropped);
        }
        bat_curve_free(ring);
        bat_curve_free(made);
    }
}

/* A ring that waves as a flower does, of many spans: round its bends the surface turns away from the eye again and again. */
static bat_curve *wavy_ring(int waves, double depth, double size) {
    enum { MOST = 240 };
    const int count = 10 * waves;
    double points[2 * MOST], knots[MOST + 1];
    bat_curve *curve = NULL;
    assert_true(count <= MOST);
    for (int i = 0; i <= count; i++) {
        const double angle = 2 * pi * i / count, radius = size * (10 + depth * sin(waves * angle));
        knots[i] = i;
        if (i < count) points[2 * i] = radius * cos(angle), points[2 * i + 1] = 0.8 * radius * sin(angle);
    }
    assert_int_equal(bat_curve_create(2, 3, true, (size_t)count, points, count + 1, knots, &curve), BAT_OK);
    return curve;
}

/* A stroke round the picture of such a ring lifts it, from wherever it begins, at any size; its samples are whole pixels, and off by one. */
static void a_wavy_ring_is_lifted(void **state) {
    (void)state;
    enum { MANY = 900 };
    static const double sizes[] = {1, 1e-6, 1e6};
    static double pixels[2 * MANY];
    random_source r = {5};
    for (int k = 0; k < 60; k++) {
        const double size = sizes[k % 3], tilt = (30 + 10 * (k % 4)) * pi / 180, begin = 0.3 + 1.1 * (k % 7);
        const bat_viewpoint view = {.eye = {0, size * 100 * sin(tilt), size * -100 * cos(tilt)},
                                    .up = {0, 0, -1},
                                    .size = {1000, 1000},
                                    .height = 50 * size};
        bat_curve *ring = wavy_ring(5 + k % 12, 0.5 + 0.25 * (k % 3), size), *made = NULL;
        double domain[2], at[3], sum = 0;
        size_t dropped = 0;
        bat_curve_domain(ring, domain);
        const double width = domain[1] - domain[0];
        for (int i = 0; i < MANY; i++) {
            const double turn = begin / (2 * pi) + (double)i / (MANY - 1), share = turn - floor(turn);
            place(ring, domain[0] + width * share, size * ring_height(2 * pi * share), at);
            assert_int_equal(bat_viewpoint_project(&view, at, pixels + 2 * i, NULL), BAT_OK);
            for (int d = 0; d < 2; d++)
                pixels[2 * i + d] = floor(pixels[2 * i + d] + random_unit(&r) + random_unit(&r));
        }
        assert_int_equal(lift(&view, ring, MANY, pixels, 0.05 * size, &made, &dropped), BAT_OK);
        for (int i = 0; i < 720; i++) {
            bat_curve_eval(made, domain[0] + width * i / 720, 0, at);
            const double off = at[2] / size + ring_height(2 * pi * i / 720);
            sum += off * off / 720;
        }
        if (!(sqrt(sum) < 0.35)) fail_msg("ring %d: %g off in the mean, %zu dropped", k, sqrt(sum), dropped);
        assert_true(bat_curve_count(made) < MANY / 2);
        bat_curve_free(ring), bat_curve_free(made);
    }
}

/* A part of a ring over its seam: the rest keeps its height. */
static void a_part_over_the_seam(void **state) {
    (void)state;
    bat_curve *ring = level_curve(2, 3, true, 40), *made = NULL;
    const bat_viewpoint view = above();
    double pixels[2 * SAMPLES], domain[2], at[3];
    size_t dropped = 0;
    bat_curve_domain(ring, domain);
    const double width = domain[1] - domain[0];
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1), share = 0.85 + 0.3 * t;
        place(ring, domain[0] + width * (share - floor(share)), bump(t), at);
        assert_int_equal(bat_viewpoint_project(&view, at, pixels + 2 * i, NULL), BAT_OK);
    }
    assert_int_equal(lift(&view, ring, SAMPLES, pixels, 0.02, &made, &dropped), BAT_OK);
    for (int i = 0; i < 400; i++) {
        const double share = i / 400.0, t = ((share < 0.5 ? share + 1 : share) - 0.85) / 0.3;
        bat_curve_eval(made, domain[0] + width * share, 0, at);
        if (!(fabs(-at[2] - bump(t)) < 0.15)) fail_msg("at %g: %g, not %g", share, -at[2], bump(t));
        if (share > 0.25 && share < 0.75) assert_true(at[2] == 0);
    }
    bat_curve_free(ring);
    bat_curve_free(made);
}

/* From straight above no height can be told, from the side of a straight line neither. */
static void what_shows(void **state) {
    (void)state;
    bat_curve *ring = level_curve(2, 3, true, 12), *line = NULL;
    const double ends[4] = {0, -5, 0, 5}; /* towards the eye of `before` */
    bat_viewpoint view = before();
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, ends, &line), BAT_OK);
    assert_true(bat_lift_shows(&view, ring));
    assert_false(bat_lift_shows(&view, line));
    view = (bat_viewpoint){.eye = {0, 0, -20}, .up = {0, 1, 0}, .size = {1000, 1000}, .height = 50};
    assert_false(bat_lift_shows(&view, ring));
    view.size[0] = 0;
    assert_false(bat_lift_shows(&view, ring));
    bat_curve_free(ring);
    bat_curve_free(line);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_are_those_of_the_stroke),
        cmocka_unit_test(the_rest_stays),
        cmocka_unit_test(a_tolerance_that_cannot_be_met),
        cmocka_unit_test(what_cannot_be_lifted),
        cmocka_unit_test(long_curves_are_lifted),
        cmocka_unit_test(a_ring_is_lifted_from_the_side),
        cmocka_unit_test(a_wavy_ring_is_lifted),
        cmocka_unit_test(a_part_over_the_seam),
        cmocka_unit_test(what_shows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
