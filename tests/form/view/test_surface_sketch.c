/* A stroke redraws a line of a surface: the new line passes by the stroke, in either direction, on open and closed
 * surfaces of every degree; what is beyond the reach stays; knots do not pile up; what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/nearest.h>
#include "support/random_surface.h"
#include "support/views.h"

enum { SIDE = 12, SAMPLES = 120, ROWS = 400 };

/* A flat sheet, x along u and y along v, both from 0 to 11. */
static bat_surface *sheet(int degree) {
    double knots[SIDE + 8], points[SIDE * SIDE * 3];
    const int n = SIDE + degree + 1;
    for (int i = 0; i < n; i++) knots[i] = fmin(fmax(i - degree, 0), SIDE - degree);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *p = points + 3 * (SIDE * i + j);
            p[0] = i, p[1] = j, p[2] = 0;
        }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){degree, degree}, (const bool[2]){false, false},
                                        (const size_t[2]){SIDE, SIDE}, points, (const int[2]){n, n}, knots,
                                        knots, &s),
                     BAT_OK);
    return s;
}

/* A tube round the z axis of radius 4, closed in u, open in v with z from 0 to 11. */
static bat_surface *tube(void) {
    double around[SIDE + 1], up[SIDE + 4], points[SIDE * SIDE * 3];
    for (int i = 0; i <= SIDE; i++) around[i] = i;
    for (int i = 0; i < SIDE + 4; i++) up[i] = fmin(fmax(i - 3, 0), SIDE - 3);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *p = points + 3 * (SIDE * i + j);
            p[0] = 4 * cos(i * 6.283185307179586 / SIDE), p[1] = 4 * sin(i * 6.283185307179586 / SIDE),
            p[2] = j;
        }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, false},
                                        (const size_t[2]){SIDE, SIDE}, points,
                                        (const int[2]){SIDE + 1, SIDE + 4}, around, up, &s),
                     BAT_OK);
    return s;
}

/* Raises points of the line between shares `from` and `to` of its domain by a smooth hump along d, as seen in the view.
 * places: where they are in space. */
static void draw_hump(const bat_surface *s, bat_direction direction, double at, const bat_viewpoint *view,
                      double from, double to, double height, const double d[3], double *pixels,
                      double *places) {
    bat_curve *line = NULL;
    double domain[2];
    assert_int_equal(bat_surface_isocurve(s, direction, at, &line), BAT_OK);
    bat_curve_domain(line, domain);
    for (int i = 0; i < SAMPLES; i++) {
        const double x = i / (SAMPLES - 1.0), h = height * pow(sin(3.141592653589793 * x), 3);
        double *p = places + 3 * i;
        bat_curve_eval(line, domain[0] + (domain[1] - domain[0]) * (from + (to - from) * x), 0, p);
        for (int c = 0; c < 3; c++) p[c] += h * d[c];
        assert_int_equal(bat_viewpoint_project(view, p, pixels + 2 * i, NULL), BAT_OK);
    }
    bat_curve_free(line);
}

/* The greatest distance of the places from the line of the surface; a tenth at either end, where the line leaves its old
 * course, is left out. */
static double off_line(const bat_surface *s, bat_direction direction, double at, const double *places) {
    bat_curve *line = NULL;
    double most = 0;
    assert_int_equal(bat_surface_isocurve(s, direction, at, &line), BAT_OK);
    for (int i = SAMPLES / 10; i < SAMPLES - SAMPLES / 10; i++) {
        bat_near near;
        assert_int_equal(bat_curve_nearest(line, places + 3 * i, &near), BAT_OK);
        most = fmax(most, near.distance);
    }
    bat_curve_free(line);
    return most;
}

static const bat_viewpoint tilted = {
    .eye = {-20, -30, 25}, .target = {5, 5, 0}, .up = {0, 0, 1}, .size = {1000, 800}, .height = 22};
static const double up[3] = {0, 0, 1};

static void the_line_passes_by_the_stroke(void **state) {
    (void)state;
    for (int number = 0; number < 10; number++) {
        const int degree = 1 + number % 5;
        const bat_direction d = number % 2 ? BAT_V : BAT_U, e = number % 2 ? BAT_U : BAT_V;
        bat_surface *s = sheet(degree), *made = NULL;
        const double at = 0.45 * (SIDE - degree), tolerance = 0.004;
        double pixels[2 * SAMPLES], places[3 * SAMPLES], weights[ROWS], domain[2];
        bat_surface_sketch_options options = bat_surface_sketch_defaults();
        bat_surface_sketch_report report;
        options.tolerance = tolerance;
        draw_hump(s, d, at, &tilted, 0.2, 0.8, 2.5, up, pixels, places);
        const bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
        assert_int_equal(bat_surface_sketch(s, d, at, &tilted, &stroke, &options, &made, weights, &report),
                         BAT_OK);
        assert_true(report.landed == SAMPLES && report.dropped == 0 && !report.turned);
        assert_true(fabs(fabs(report.along[2]) - 1) < 1e-12 && report.max_error <= tolerance);
        assert_true(off_line(made, d, at, places) < 1.2 * tolerance);
        assert_int_equal(bat_surface_degree(made, e), degree < 3 ? 3 : degree);
        assert_int_equal(bat_surface_degree(made, d), degree);
        assert_true(report.redraw.knots_after[d] == report.redraw.knots_before[d]);
        /* beyond the reach nothing moves by more than rounding */
        bat_surface_domain(s, d, domain);
        for (int k = 0; k < 40; k++) {
            const double a = domain[0] + (domain[1] - domain[0]) * k / 39, b = 0.3 * (SIDE - degree);
            double x[3], y[3];
            bat_surface_eval(s, d == BAT_U ? a : b, d == BAT_U ? b : a, 0, x);
            bat_surface_eval(made, d == BAT_U ? a : b, d == BAT_U ? b : a, 0, y);
            const bool out = a < report.redraw.moved[0] || a > report.redraw.moved[1];
            for (int c = 0; out && c < 3; c++) assert_true(fabs(x[c] - y[c]) < 1e-8);
        }
        bat_surface_free(s), bat_surface_free(made);
    }
}

/* A mouth in a rim: the ruled surface runs along the tube, also across the seam. */
static void a_rim_gets_a_mouth(void **state) {
    (void)state;
    static const double eyes[3][3] = {{0, -30, 25}, {15, -26, 25}, {16, -25, 22}};
    for (int turn = 0; turn < 3; turn++) { /* the front is at u = 11, or at the seam */
        bat_viewpoint view = {.target = {0, 0, 8}, .up = {0, 0, 1}, .size = {1000, 800}};
        memcpy(view.eye, eyes[turn], sizeof view.eye);
        *(turn == 2 ? &view.height : &view.fov) = turn == 2 ? 18 : 35;
        bat_surface *s = tube(), *made = NULL;
        double pixels[2 * SAMPLES], places[3 * SAMPLES], weights[ROWS];
        bat_surface_sketch_report report;
        const double first = turn == 0 ? 0.79 : 0.88;
        draw_hump(s, BAT_V, SIDE - 3, &view, first, first + 0.25, 0.8, up, pixels, places);
        const bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
        bat_surface_sketch_options options = bat_surface_sketch_defaults();
        options.tolerance = 0.004;
        assert_int_equal(
            bat_surface_sketch(s, BAT_V, SIDE - 3, &view, &stroke, &options, &made, weights, &report),
            BAT_OK);
        assert_true(report.dropped == 0 && fabs(fabs(report.along[2]) - 1) < 1e-9);
        assert_true(off_line(made, BAT_V, SIDE - 3, places) < 1.2 * options.tolerance);
        assert_true(bat_surface_is_closed(made, BAT_U));
        double a[3], b[3]; /* the far side of the rim stays */
        bat_surface_eval(s, turn == 0 ? 5 : 6, SIDE - 3, 0, a);
        bat_surface_eval(made, turn == 0 ? 5 : 6, SIDE - 3, 0, b);
        for (int c = 0; c < 3; c++) assert_true(fabs(a[c] - b[c]) < 1e-8);
        bat_surface_free(s), bat_surface_free(made);
    }
}

/* Redrawn twenty times, here and there along the line, the surface has at most 1.5 times the knots of the first time. */
static void knots_do_not_pile_up(void **state) {
    (void)state;
    random_source r = {41};
    bat_surface *s = sheet(3), *flat = sheet(3);
    int first = 0;
    for (int k = 0; k < 20; k++) {
        double pixels[2 * SAMPLES], places[3 * SAMPLES];
        bat_surface *made = NULL;
        bat_surface_sketch_options options = bat_surface_sketch_defaults();
        options.tolerance = 0.01;
        const double from = random_between(&r, 0.12, 0.4), to = from + random_between(&r, 0.3, 0.45);
        const double height = random_between(&r, -1, 1);
        draw_hump(flat, BAT_U, 4, &tilted, from, to, height, up, pixels, places);
        const bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
        assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, &options, &made, NULL, NULL),
                         BAT_OK);
        assert_true(off_line(made, BAT_U, 4, places) < 1.2 * options.tolerance);
        if (k == 0) first = bat_surface_knot_count(made, BAT_V);
        assert_true(bat_surface_knot_count(made, BAT_V) <= 1.5 * first);
        bat_surface_free(s);
        s = made;
    }
    bat_surface_free(s), bat_surface_free(flat);
}

/* The sheet seen from its side: its normal lies in the window, but along the line's own direction the ruled surface is
 * seen from its edge; the direction is then across the gaze. */
static void seen_from_its_edge(void **state) {
    (void)state;
    const bat_viewpoint along_y = {
        .eye = {5.5, -40, 4}, .target = {5.5, 0, 0}, .up = {0, 0, 1}, .size = {1000, 800}, .height = 20};
    bat_surface *s = sheet(3), *made = NULL;
    double pixels[2 * SAMPLES], places[3 * SAMPLES];
    bat_surface_sketch_report report;
    const double across[3] = {1, 0, 0};
    draw_hump(s, BAT_U, 4.5, &along_y, 0.25, 0.75, 1, across, pixels, places);
    const bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    options.tolerance = 0.01;
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4.5, &along_y, &stroke, &options, &made, NULL, &report),
                     BAT_OK);
    assert_true(off_line(made, BAT_U, 4.5, places) < 1.2 * options.tolerance);
    assert_true(report.turned && fabs(fabs(report.along[0]) - 1) < 1e-9);
    bat_surface_free(made), bat_surface_free(s);
}

/* Ends that are to stay keep place, tangent and curvature; a stroke that moves one is refused. */
static void ends_that_stay(void **state) {
    (void)state;
    for (int direction = 0; direction < 2; direction++) {
        const bat_direction d = direction ? BAT_V : BAT_U;
        bat_surface *s = sheet(3), *made = NULL;
        double pixels[2 * SAMPLES], places[3 * SAMPLES];
        bat_surface_sketch_report report;
        bat_surface_sketch_options options = bat_surface_sketch_defaults();
        options.tolerance = 0.01, options.keep[0] = options.keep[1] = 3;
        bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
        draw_hump(s, d, 4, &tilted, 0.25, 0.75, 2, up, pixels, places);
        assert_int_equal(bat_surface_sketch(s, d, 4, &tilted, &stroke, &options, &made, NULL, &report),
                         BAT_OK);
        for (int i = 0; i < 40; i++) {
            const double at[2] = {i % 20 * 9 / 19.0, i < 20 ? 0 : 9};
            double now[18], was[18];
            bat_surface_eval(made, at[direction], at[1 - direction], 2, now);
            bat_surface_eval(s, at[direction], at[1 - direction], 2, was);
            for (int k = 0; k < 18; k++) assert_true(fabs(now[k] - was[k]) < 1e-9);
        }
        bat_surface_free(made), made = NULL;
        draw_hump(s, d, 4, &tilted, -0.3, 0.4, 2, up, pixels, places);
        stroke.points += 2 * 50, stroke.count -= 50; /* begins over the end */
        options.keep[0] = 0;
        assert_int_equal(bat_surface_sketch(s, d, 4, &tilted, &stroke, &options, &made, NULL, &report),
                         BAT_OK);
        bat_surface_free(made), made = NULL;
        options.keep[0] = 1;
        assert_int_equal(bat_surface_sketch(s, d, 4, &tilted, &stroke, &options, &made, NULL, &report),
                         BAT_STATE);
        options.keep[0] = -1;
        assert_int_equal(bat_surface_sketch(s, d, 4, &tilted, &stroke, &options, &made, NULL, &report),
                         BAT_ARGUMENT);
        assert_null(made);
        bat_surface_free(s);
    }
}

static void what_is_refused(void **state) {
    (void)state;
    bat_surface *s = sheet(3), *made = NULL;
    double pixels[2 * SAMPLES], places[3 * SAMPLES];
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    bat_surface_sketch_report report;
    draw_hump(s, BAT_U, 4, &tilted, 0.2, 0.8, 2, up, pixels, places);
    bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = pixels};
    for (int i = 0; i < SAMPLES * 2 / 5; i++) pixels[2 * i] += 5000; /* beside the ruled surface */
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, NULL, &made, NULL, &report), BAT_FAR);
    assert_true(report.dropped > SAMPLES / 3 && report.redraw.gain == 0 && !made);
    draw_hump(s, BAT_U, 4, &tilted, 0.2, 0.8, 2, up, pixels, places);
    bat_surface_redraw_options held = bat_surface_redraw_defaults();
    const int rows[SIDE] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    held.hold = rows, held.hold_count = SIDE, options.redraw = &held, options.tolerance = 0.01;
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, &options, &made, NULL, &report),
                     BAT_FAR);
    assert_true(isinf(report.redraw.gain) && !made);
    options.along[1] = 1; /* along the line itself: seen from its edge everywhere */
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, &options, &made, NULL, &report),
                     BAT_FAR);
    assert_true(report.dropped == SAMPLES);
    options.along[1] = NAN;
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, &options, &made, NULL, NULL),
                     BAT_NUMBER);
    options = bat_surface_sketch_defaults(), options.tolerance = -1;
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, &options, &made, NULL, NULL),
                     BAT_ARGUMENT);
    assert_int_equal(bat_surface_sketch(s, BAT_U, NAN, &tilted, &stroke, NULL, &made, NULL, NULL),
                     BAT_NUMBER);
    stroke.count = 1;
    assert_int_equal(bat_surface_sketch(s, BAT_U, 4, &tilted, &stroke, NULL, &made, NULL, NULL), BAT_DOT);
    assert_int_equal(bat_surface_sketch(NULL, BAT_U, 4, &tilted, &stroke, NULL, &made, NULL, NULL),
                     BAT_ARGUMENT);
    assert_null(made);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_line_passes_by_the_stroke),
        cmocka_unit_test(a_rim_gets_a_mouth),
        cmocka_unit_test(knots_do_not_pile_up),
        cmocka_unit_test(seen_from_its_edge),
        cmocka_unit_test(ends_that_stay),
        cmocka_unit_test(what_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
