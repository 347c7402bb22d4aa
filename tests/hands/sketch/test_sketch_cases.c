/* Every case listed in the table of docs/math/sketch.md has one decided behaviour, tested here. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "curve/curve.h"
#include "support/sketch_cases.h"

#include <batten/refine.h>

enum { COUNT = 160 };
static const double pi = 3.14159265358979;

typedef void shape(double f, double *q);

static bat_status draw(const bat_curve *curve, shape *f, const bat_sketch_options *options, bat_curve **out,
                       bat_sketch_report *report) {
    double points[2 * COUNT];
    for (int i = 0; i < COUNT; i++) f(i / (COUNT - 1.0), points + 2 * i);
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = points};
    *out = NULL;
    const bat_status status = bat_sketch(curve, &stroke, options, out, report);
    if (status == BAT_OK) {
        assert_true(report->replaced || kept_moves(curve, *out, report) <= 1e-12);
        assert_true(worst_jump(*out) <= 1e-9);
        assert_true(report->max_error <= (options && options->tolerance > 0 ? options->tolerance : 1));
        assert_int_equal(report->knots_after, bat_curve_knot_count(*out));
    }
    return status;
}

/* Straight from (0, 0) to (600, 0), eleven control points. */
static bat_curve *line(void) {
    double points[22], knots[15];
    for (int i = 0; i < 11; i++) points[2 * i] = 60 * i, points[2 * i + 1] = 0;
    for (int i = 0; i < 15; i++) knots[i] = i < 4 ? 0 : i > 10 ? 8 : i - 3;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 11, points, 15, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *circle(void) {
    double points[24], knots[13];
    for (int i = 0; i < 12; i++)
        points[2 * i] = 200 * cos(pi * i / 6), points[2 * i + 1] = 200 * sin(pi * i / 6);
    for (int i = 0; i < 13; i++) knots[i] = i;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 12, points, 13, knots, &curve), BAT_OK);
    return curve;
}

static double distance_to(const bat_curve *curve, double x, double y) {
    const double q[2] = {x, y};
    bat_near near;
    assert_int_equal(bat_curve_nearest(curve, q, &near), BAT_OK);
    return near.distance;
}

static void end_points(const bat_curve *curve, double ends[4]) {
    double d[2];
    bat_curve_domain(curve, d);
    bat_curve_eval(curve, d[0], 0, ends);
    bat_curve_eval(curve, d[1], 0, ends + 2);
}

static void bump(double f, double *q) { q[0] = 200 + 200 * f, q[1] = 40 * sin(pi * f) * sin(pi * f); }
static void bump_back(double f, double *q) { bump(1 - f, q); }
static void past_end(double f, double *q) { q[0] = 450 + 300 * f, q[1] = 60 * f * f; }
static void past_start(double f, double *q) { q[0] = -150 + 300 * f, q[1] = 60 * (1 - f) * (1 - f); }
static void off_midway(double f, double *q) { q[0] = 120 + 180 * f, q[1] = 50 * f * f; }
static void off_late(double f, double *q) { q[0] = 300 + 150 * f, q[1] = 130 * f * f; }
static void shorten(double f, double *q) { q[0] = 400 + 150 * f, q[1] = 130 * f * f; }
static void off_by_far(double f, double *q) { q[0] = 200 + 100 * f, q[1] = 420 * f; }
static void past_both(double f, double *q) { q[0] = -40 + 680 * f, q[1] = 30 * sin(pi * f); }
static void far_away(double f, double *q) { q[0] = 200 + 100 * f, q[1] = 300; }
static void looped(double f, double *q) {
    q[0] = 200 + 200 * f + 70 * sin(2 * pi * f), q[1] = 50 * (1 - cos(2 * pi * f));
}
static void alpha(double f, double *q) {
    q[0] = 330 - 60 * f + 90 * sin(2 * pi * f), q[1] = 50 * (1 - cos(2 * pi * f));
}

static void redraw_either_way(void **state) {
    (void)state;
    bat_curve *curve = line(), *a, *b;
    bat_sketch_report ra, rb;
    assert_int_equal(draw(curve, bump, NULL, &a, &ra), BAT_OK);
    assert_int_equal(draw(curve, bump_back, NULL, &b, &rb), BAT_OK);
    assert_false(ra.reversed);
    assert_true(rb.reversed);
    assert_true(distance_to(a, 300, 40) <= 1 && distance_to(b, 300, 40) <= 1);
    double d[2], there, back;
    bat_curve_domain(a, d);
    assert_int_equal(bat_curve_distance(a, b, 16, &there, &back), BAT_OK);
    assert_true(there <= 2 && back <= 2); /* both within tolerance of one shape, transitions twice that */
    bat_curve_free(a);
    bat_curve_free(b);
    bat_curve_free(curve);
}

static void past_an_end_extends_or_shortens(void **state) {
    (void)state;
    bat_curve *curve = line(), *now;
    bat_sketch_report report;
    double ends[4];
    assert_int_equal(draw(curve, past_end, NULL, &now, &report), BAT_OK);
    assert_true(!report.extended[0] && report.extended[1] && !report.replaced);
    end_points(now, ends);
    assert_true(hypot(ends[2] - 750, ends[3] - 60) <= 1.5);
    assert_true(hypot(ends[0], ends[1]) <= 1e-9);
    bat_curve_free(now);
    assert_int_equal(draw(curve, past_start, NULL, &now, &report), BAT_OK);
    assert_true(report.extended[0] && !report.extended[1]);
    end_points(now, ends);
    assert_true(hypot(ends[0] + 150, ends[1] - 60) <= 1.5);
    assert_true(hypot(ends[2] - 600, ends[3]) <= 1e-9);
    bat_curve_free(now);
    /* One end far from the curve, and little left of it beyond: the stroke becomes that side's end. */
    assert_int_equal(draw(curve, shorten, NULL, &now, &report), BAT_OK);
    assert_true(report.extended[1]);
    end_points(now, ends);
    assert_true(hypot(ends[2] - 550, ends[3] - 130) <= 1.5);
    assert_true(distance_to(now, 590, 0) > 100);
    bat_curve_free(now);
    assert_int_equal(draw(curve, past_both, NULL, &now, &report), BAT_OK);
    assert_true(report.replaced && !report.extended[0] && !report.extended[1]);
    assert_true(report.knots_after < report.knots_before);
    end_points(now, ends);
    assert_true(hypot(ends[0] + 40, ends[1]) <= 1.5 && hypot(ends[2] - 640, ends[3]) <= 1.5);
    bat_curve_free(now);
    bat_curve_free(curve);
}

/* A stroke that ends off the curve, with much of it beyond: the rest blends back over three times the offset where there
 * is so much, and in any case keeps its end; or the stroke is refused. Never does it vanish. */
static void the_rest_stays(void **state) {
    (void)state;
    bat_curve *curve = line(), *now = NULL;
    bat_sketch_report report;
    double ends[4];
    assert_int_equal(draw(curve, off_midway, NULL, &now, &report), BAT_OK);
    assert_true(!report.extended[0] && !report.extended[1] && !report.replaced);
    assert_true(report.transition[1] >= 150 && distance_to(now, 300, 50) <= 6);
    for (int x = 300 + 200; x <= 600; x += 20) assert_true(distance_to(now, x, 0) <= 0.01);
    end_points(now, ends);
    assert_true(hypot(ends[2] - 600, ends[3]) <= 1e-9);
    bat_curve_free(now);
    assert_int_equal(draw(curve, off_late, NULL, &now, &report), BAT_OK);
    end_points(now, ends);
    assert_true(!report.extended[1] && hypot(ends[2] - 600, ends[3]) <= 1e-9);
    bat_curve_free(now);
    now = NULL;
    assert_int_equal(draw(curve, off_by_far, NULL, &now, &report), BAT_FAR);
    assert_null(now);
    bat_curve_free(curve);
}

static void refused(void **state) {
    (void)state;
    bat_curve *curve = line(), *now = NULL;
    bat_sketch_report report = {.solves = -7};
    assert_int_equal(draw(curve, far_away, NULL, &now, &report), BAT_FAR);
    const double nan = NAN, dot[] = {300, 1, 300.5, 1, 301, 1.5, 300, 2},
                 bad[] = {nan, nan, INFINITY, 0, nan, 1};
    double tremble[2 * COUNT];
    random_source r = {5};
    for (int i = 0; i < 2 * COUNT; i++) tremble[i] = 300 * (1 - i % 2) + 0.4 * random_normal(&r);
    const bat_stroke strokes[] = {{2, 4, dot, NULL, NULL},
                                  {2, 3, bad, NULL, NULL},
                                  {2, 0, dot, NULL, NULL},
                                  {2, 1, dot, NULL, NULL},
                                  {2, COUNT, tremble, NULL, NULL}};
    for (size_t i = 0; i < sizeof strokes / sizeof *strokes; i++)
        assert_int_equal(bat_sketch(curve, &strokes[i], NULL, &now, &report), BAT_DOT);
    assert_int_equal(report.solves, -7);
    assert_null(now);
    const bat_stroke space = {3, 1, bad, NULL, NULL}, fine = {2, 4, dot, NULL, NULL};
    assert_int_equal(bat_sketch(curve, &space, NULL, &now, NULL), BAT_DIMENSION);
    assert_int_equal(bat_sketch(NULL, &fine, NULL, &now, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_sketch(curve, NULL, NULL, &now, NULL), BAT_ARGUMENT);
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = nan;
    assert_int_equal(bat_sketch(curve, &fine, &options, &now, NULL), BAT_NUMBER);
    options.pixel = 0;
    assert_int_equal(bat_sketch(curve, &fine, &options, &now, NULL), BAT_ARGUMENT);
    options.pixel = 1, options.pins = 4;
    assert_int_equal(bat_sketch(curve, &fine, &options, &now, NULL), BAT_ARGUMENT);
    bat_curve_free(curve);
}

static void loops(void **state) {
    (void)state;
    bat_curve *curve = line(), *now;
    bat_sketch_report report;
    assert_int_equal(draw(curve, looped, NULL, &now, &report), BAT_OK);
    assert_true(distance_to(now, 300, 100) <= 1.5);
    bat_curve_free(now);
    /* The stroke ends before it began: what lies between is passed twice. */
    assert_int_equal(draw(curve, alpha, NULL, &now, &report), BAT_OK);
    assert_false(report.reversed);
    assert_true(distance_to(now, 300, 100) <= 1.5);
    assert_true(distance_to(now, 100, 0) <= 1e-9 && distance_to(now, 500, 0) <= 1e-9);
    bat_curve_free(now);
    bat_curve_free(curve);
}

static void very_short(double f, double *q) { q[0] = 300 + 12 * f, q[1] = 5; }
static void a_very_short_stroke_is_a_bump(void **state) {
    (void)state;
    bat_curve *curve = line(), *now;
    bat_sketch_report report;
    assert_int_equal(draw(curve, very_short, NULL, &now, &report), BAT_OK);
    assert_true(distance_to(now, 306, 5) <= 1);
    assert_true(report.transition[0] > 10 && report.transition[1] > 10);
    bat_curve_free(now);
    bat_curve_free(curve);
}

static double seam_angle;
static void over_seam(double f, double *q) {
    const double a = seam_angle - 0.7 + 1.4 * f, radius = 200 + 40 * sin(pi * f);
    q[0] = radius * cos(a), q[1] = radius * sin(a);
}
static void all_round(double f, double *q) {
    const double a = 1 - 6.25 * f;
    q[0] = 150 * cos(a) * (1 + 0.1 * cos(3 * a)), q[1] = 170 * sin(a);
}
/* The result must not know where the seam is: the same stroke turned round the circle in thirty places. */
static void closed_curves_have_no_seam(void **state) {
    (void)state;
    bat_curve *curve = circle(), *now;
    bat_sketch_report report;
    for (int i = 0; i < 30; i++) {
        seam_angle = 2 * pi * i / 30;
        assert_int_equal(draw(curve, over_seam, NULL, &now, &report), BAT_OK);
        assert_true(bat_curve_is_closed(now) && !report.reversed && !report.replaced);
        assert_true(distance_to(now, 240 * cos(seam_angle), 240 * sin(seam_angle)) <= 1.5);
        bat_curve_free(now);
    }
    assert_int_equal(draw(curve, all_round, NULL, &now, &report), BAT_OK);
    assert_true(bat_curve_is_closed(now) && report.replaced && report.reversed);
    double jet[4], d[2];
    bat_curve_domain(now, d);
    bat_curve_eval(now, d[0], 1, jet);
    assert_true(jet[0] * jet[3] - jet[1] * jet[2] > 0); /* keeps its orientation */
    assert_true(distance_to(now, 165, 0) <= 2);
    bat_curve_free(now);
    bat_curve_free(curve);
}

static double reach_in; /* how far the stroke goes towards the middle */
static void into_the_middle(double f, double *q) { q[0] = 200 - reach_in * f, q[1] = 3 * sin(4 * f); }
static void out_of_it(double f, double *q) { q[0] = 200 + 150 * f, q[1] = 40 * f; }
static void along_then_in(double f, double *q) {
    const double a = 2.5 * f, radius = 200 - 195 * fmax(0, 3 * f - 2);
    q[0] = radius * cos(a), q[1] = radius * sin(a);
}
static void round_and_in(double f, double *q) {
    const double a = 2 * pi * f, radius = 205 - 4 * f - 196 * fmax(0, 10 * f - 9);
    q[0] = radius * cos(a), q[1] = radius * sin(a);
}
static void dent(double f, double *q) {
    const double a = 0.6 * f, radius = 200 - 90 * sin(pi * f);
    q[0] = radius * cos(a), q[1] = radius * sin(a);
}
/* A closed curve has no end that the stroke could become. Were the curve brought back from the far end of the stroke, the
 * arc between would be lost: the stroke is not meant for it. */
static void closed_curves_lose_no_arc(void **state) {
    (void)state;
    bat_curve *curve = circle(), *now = NULL;
    bat_sketch_report report;
    void (*const far_ends[])(double, double *) = {into_the_middle, out_of_it, along_then_in, round_and_in};
    reach_in = 195;
    for (int i = 0; i < 4; i++) {
        assert_int_equal(draw(curve, far_ends[i], NULL, &now, &report), BAT_FAR);
        assert_null(now);
    }
    /* Near ends, however deep the stroke goes between them, and ends that are not far, are meant. */
    assert_int_equal(draw(curve, dent, NULL, &now, &report), BAT_OK);
    assert_true(bat_curve_is_closed(now) && distance_to(now, 110 * cos(0.3), 110 * sin(0.3)) <= 1.5);
    bat_curve_free(now);
    reach_in = 30;
    assert_int_equal(draw(curve, into_the_middle, NULL, &now, &report), BAT_OK);
    bat_curve_free(now);
    bat_curve_free(curve);
}

/* A corner at (300, 0): two straight runs, knot of multiplicity 3. */
static bat_curve *cornered(void) {
    double points[2 * 7] = {0, 0, 100, 0, 200, 0, 300, 0, 300, 100, 300, 200, 300, 300};
    double knots[11] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 7, points, 11, knots, &curve), BAT_OK);
    return curve;
}
static void near_corner(double f, double *q) { q[0] = 303 + 30 * sin(pi * f), q[1] = 4 + 140 * f; }
static void before_corner(double f, double *q) { q[0] = 60 + 220 * f, q[1] = 14; }
static void over_corner(double f, double *q) {
    const double a = pi / 2 * f;
    q[0] = 100 + 200 * sin(a), q[1] = 200 - 200 * cos(a);
}
static void angle(double f, double *q) {
    q[0] = f < 0.5 ? 100 + 380 * f : 290, q[1] = f < 0.5 ? 10 : 10 + 300 * (f - 0.5);
}
static int corners_of(const bat_curve *curve) {
    const double *t = bat_curve_knots(curve);
    double d[2];
    int found = 0;
    bat_curve_domain(curve, d);
    for (int i = 0; i + 2 < bat_curve_knot_count(curve); i++)
        found += t[i] == t[i + 2] && t[i] > d[0] && t[i] < d[1];
    return found;
}

static void corners_kept_or_not(void **state) {
    (void)state;
    bat_curve *curve = cornered(), *now;
    bat_sketch_report report;
    bat_sketch_options options = bat_sketch_defaults();
    options.keep_corners = true;
    assert_int_equal(draw(curve, near_corner, &options, &now, &report), BAT_OK);
    assert_int_equal(corners_of(now), 1);
    assert_true(distance_to(now, 300, 0) <= 1e-9); /* starts exactly there */
    bat_curve_free(now);
    assert_int_equal(draw(curve, before_corner, &options, &now, &report), BAT_OK);
    assert_int_equal(corners_of(now), 1); /* the transition stops at it */
    assert_true(distance_to(now, 300, 0) <= 1e-9);
    bat_curve_free(now);
    assert_int_equal(draw(curve, angle, &options, &now, &report), BAT_OK);
    assert_int_equal(corners_of(now), 1); /* the stroke's own */
    assert_true(distance_to(now, 290, 10) <= 1.5);
    bat_curve_free(now);
    options.keep_corners = false;
    assert_int_equal(draw(curve, over_corner, &options, &now, &report), BAT_OK);
    assert_int_equal(corners_of(now), 0);
    bat_curve_free(now);
    bat_curve_free(curve);
}

/* More corners than a curve can be found for in time: it may miss the tolerance, but not the drawing. */
static void scribbles_stay_near(void **state) {
    (void)state;
    enum { SAMPLES = 2400 };
    static double x[2 * SAMPLES];
    const double sizes[] = {6, 25, 60};
    random_source r = {203};
    for (int n = 0; n < 6; n++) {
        const int each = n % 2 ? 5 : 2; /* samples of a leg */
        double from[2] = {500, 400}, to[2] = {500, 400};
        for (int i = 0; i < SAMPLES; i++) {
            const double turn = random_between(&r, 0, 6.28), way[2] = {cos(turn), sin(turn)};
            for (int k = 0; k < 2; k++) {
                if (i % each == 0) from[k] = to[k], to[k] += sizes[n / 2] * way[k];
                x[2 * i + k] = from[k] + (double)(i % each + 1) / each * (to[k] - from[k]);
            }
        }
        const bat_stroke stroke = {.dimension = 2, .count = SAMPLES, .points = x};
        for (int t = 0; t < 2; t++) {
            bat_sketch_options options = bat_sketch_defaults();
            bat_sketch_report report;
            bat_curve *made = NULL;
            options.tolerance = t ? 0.5 : 0.05;
            const bat_status status = bat_sketch_new(&stroke, false, &options, &made, &report);
            assert_true(status == BAT_OK || status == BAT_TOLERANCE);
            assert_true(report.max_error < 3);
            bat_curve_free(made);
        }
    }
}

/* A joint of full multiplicity, as files have it, where the outline turns by less than is seen, is no corner: the blend
 * goes past it as if it were not there. */
static void smooth_joints_are_no_corners(void **state) {
    (void)state;
    random_source r = {8};
    for (int n = 0; n < 12; n++) {
        const double y = 100 + random_between(&r, -20, 20), turn = n % 3 * 0.01;
        double points[2 * 7] = {0, 0, 100, 0, 200, 0, 300, 0, 400, 100 * turn, 500, y - 80, 600, y};
        const double many[11] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, few[10] = {0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
        bat_curve *joined = NULL, *smooth = NULL, *now[2] = {NULL};
        bat_sketch_options options = bat_sketch_defaults();
        bat_sketch_report report;
        options.keep_corners = true;
        assert_int_equal(bat_curve_create(2, 3, false, 7, points, 11, many, &joined), BAT_OK);
        points[9] = 0;
        memmove(points + 6, points + 8,
                6 * sizeof *points); /* the joint lies in the middle of its neighbours */
        assert_int_equal(bat_curve_create(2, 3, false, 6, points, 10, few, &smooth), BAT_OK);
        assert_int_equal(draw(joined, before_corner, &options, &now[0], &report), BAT_OK);
        assert_int_equal(draw(smooth, before_corner, &options, &now[1], &report), BAT_OK);
        assert_int_equal(corners_of(now[0]), 0);
        double there, back;
        assert_int_equal(bat_curve_distance(now[0], now[1], 40, &there, &back), BAT_OK);
        assert_true(fmax(there, back) <= 1 + 100 * turn);
        bat_curve_free(joined), bat_curve_free(smooth), bat_curve_free(now[0]), bat_curve_free(now[1]);
    }
}

/* Knots of multiplicity 2 and 3 under the stroke go, beside it they stay. */
static void multiple_knots(void **state) {
    (void)state;
    bat_curve *plain = line(), *curve, *now;
    const double more[] = {1, 1, 3, 4, 4, 7};
    assert_int_equal(bat_curve_insert_knots(plain, 6, more, &curve), BAT_OK);
    bat_sketch_report report;
    assert_int_equal(draw(curve, bump, NULL, &now, &report), BAT_OK);
    const double *t = bat_curve_knots(now);
    int ones = 0, repeats = 0;
    for (int i = 0; i < bat_curve_knot_count(now); i++) {
        ones += t[i] == 1;
        repeats += i > 0 && t[i] == t[i - 1] && t[i] > report.changed_new[0] && t[i] < report.changed_new[1];
    }
    assert_int_equal(ones, 3);
    assert_int_equal(repeats, 0);
    bat_curve_free(now);
    bat_curve_free(curve);
    bat_curve_free(plain);
}

static void a_tolerance_that_cannot_be_met(void **state) {
    (void)state;
    bat_curve *curve = line(), *now = NULL;
    double points[2 * COUNT];
    for (int i = 0; i < COUNT; i++) /* a saw with teeth finer than half a pixel's spans */
        points[2 * i] = 250 + 0.6 * i, points[2 * i + 1] = i % 2 ? 30 : 0;
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = points};
    bat_sketch_options options = bat_sketch_defaults();
    options.tolerance = 1e-3;
    bat_sketch_report report;
    assert_int_equal(bat_sketch(curve, &stroke, &options, &now, &report), BAT_TOLERANCE);
    assert_non_null(now);
    assert_true(report.max_error > options.tolerance);
    assert_true(kept_moves(curve, now, &report) <= 1e-12);
    bat_curve_free(now);
    bat_curve_free(curve);
}

/* Two curves and a stroke between any of their ends: one curve, both far ends exact. */
static void joined_by_a_stroke(void **state) {
    (void)state;
    for (int turns = 0; turns < 8; turns++) {
        bat_curve *a = line(), *b, *swap;
        const double move[] = {1, 0, 800, 0, 1, 100};
        assert_int_equal(bat_curve_transform(a, move, &b), BAT_OK);
        if (turns & 1) bat_curve_reverse(a, &swap), bat_curve_free(a), a = swap;
        if (turns & 2) bat_curve_reverse(b, &swap), bat_curve_free(b), b = swap;
        double points[2 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            const double f = turns & 4 ? 1 - i / (COUNT - 1.0) : i / (COUNT - 1.0);
            points[2 * i] = 560 + 280 * f, points[2 * i + 1] = 100 * f * f * (3 - 2 * f);
        }
        const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = points};
        bat_curve *now = NULL;
        bat_sketch_report report;
        assert_int_equal(bat_sketch_join(a, b, &stroke, NULL, &now, &report), BAT_OK);
        double ends[4];
        end_points(now, ends);
        const double forth = fmax(hypot(ends[0], ends[1]), hypot(ends[2] - 1400, ends[3] - 100));
        const double back = fmax(hypot(ends[2], ends[3]), hypot(ends[0] - 1400, ends[1] - 100));
        assert_true(fmin(forth, back) <= 1e-9);
        assert_true(worst_jump(now) <= 1e-9);
        assert_true(farthest(now, points, 40, 120) <= 1);
        assert_true(distance_to(now, 300, 0) <= 1e-9 && distance_to(now, 1100, 100) <= 1e-9);
        assert_true(speed_ratio(now) <= 3 + 1e-9); /* 3 is what the line itself has */
        bat_curve_free(now);
        bat_curve_free(a);
        bat_curve_free(b);
    }
}

static void wobbly(double f, double *q) { q[0] = 60 + 480 * f, q[1] = 0.01 * sin(f); }
static void smoothing(void **state) {
    (void)state;
    random_source r = {77};
    for (int n = 0; n < 30; n++) {
        bat_curve *base = line(), *curve, *now = NULL;
        double points[2 * 64], knots[68];
        for (int i = 0; i < 60; i++)
            points[2 * i] = 600.0 * i / 59, points[2 * i + 1] = random_between(&r, -4, 4);
        for (int i = 0; i < 64; i++) knots[i] = i < 4 ? 0 : i > 59 ? 57 : i - 3;
        assert_int_equal(bat_curve_create(2, 3, false, 60, points, 64, knots, &curve), BAT_OK);
        double stroke_points[2 * COUNT];
        for (int i = 0; i < COUNT; i++) wobbly(i / (COUNT - 1.0), stroke_points + 2 * i);
        const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = stroke_points};
        bat_sketch_report report;
        assert_int_equal(bat_sketch_smooth(curve, &stroke, NULL, &now, &report), BAT_OK);
        assert_true(kept_moves(curve, now, &report) <= 1e-12);
        assert_true(worst_jump(now) <= 1e-9);
        assert_true(report.knots_after < report.knots_before);
        double there, back;
        assert_int_equal(bat_curve_distance(curve, now, 16, &there, &back), BAT_OK);
        assert_true(there <= 5 && back <= 5); /* never by more than the limit */
        double before = 0, after = 0;         /* it bends less in the middle */
        double jet[6], d[2];
        for (int which = 0; which < 2; which++) {
            bat_curve_domain(which ? now : curve, d);
            for (int i = 60; i < 140; i++) {
                bat_curve_eval(which ? now : curve, d[0] + (d[1] - d[0]) * i / 200, 2, jet);
                const double v = hypot(jet[2], jet[3]), k = (jet[2] * jet[5] - jet[3] * jet[4]) / (v * v * v);
                *(which ? &after : &before) += k * k;
            }
        }
        assert_true(after < 0.2 * before);
        bat_curve_free(now);
        bat_curve_free(curve);
        bat_curve_free(base);
    }
}

static void new_curves(void **state) {
    (void)state;
    random_source r = {3};
    double points[2 * 400];
    for (int kind = 0; kind < 3; kind++) { /* an arc, a ring with overlapping ends, a square with corners */
        for (int i = 0; i < 400; i++) {
            const double f = i / 399.0, a = (kind == 0 ? 2.5 : 6.4) * f;
            points[2 * i] = 150 * cos(a), points[2 * i + 1] = 150 * sin(a);
            if (kind == 2) {
                const double s = 4 * f;
                const int side = s >= 3.999 ? 3 : (int)s;
                const double g = s - side, x[5] = {0, 200, 200, 0, 0}, y[5] = {0, 0, 200, 200, 12};
                points[2 * i] = x[side] + g * (x[side + 1] - x[side]);
                points[2 * i + 1] = y[side] + g * (y[side + 1] - y[side]);
            }
            points[2 * i] += 0.4 * random_normal(&r), points[2 * i + 1] += 0.4 * random_normal(&r);
        }
        const bat_stroke stroke = {.dimension = 2, .count = 400, .points = points};
        bat_curve *now = NULL;
        bat_sketch_report report;
        assert_int_equal(bat_sketch_new(&stroke, false, NULL, &now, &report), BAT_OK);
        assert_int_equal(bat_curve_is_closed(now), kind > 0);
        if (kind < 2) assert_true(bat_point_count(now) < 16);
        if (kind == 2) assert_int_equal(corners_of(now), 4); /* the one where its ends meet, too */
        assert_true(farthest(now, points, 30, 370) <= 1 + 3 * 0.4 * 1.5);
        assert_true(worst_jump(now) <= 1e-9);
        bat_curve_free(now);
    }
}

/* Degrees, dimensions, sizes: the same redraw at every scale, and what cannot be computed is refused. */
static void every_degree_dimension_and_scale(void **state) {
    (void)state;
    random_source r = {8};
    static const double pixels[] = {1e-6, 1, 1e6};
    for (int degree = 1; degree <= 7; degree++)
        for (int m = 2; m <= 3; m++)
            for (int closed = 0; closed < 2; closed++)
                for (int scale = 0; scale < 3; scale++) {
                    double points[3 * 14], knots[24];
                    const double px = pixels[scale];
                    for (int i = 0; i < 14; i++) {
                        const double a = 2 * pi * i / (closed ? 14 : 20);
                        points[m * i] = px * 200 * cos(a), points[m * i + 1] = px * 200 * sin(a);
                        if (m == 3) points[m * i + 2] = px * 40 * sin(2 * a);
                    }
                    for (int i = 0; i < 14 + degree + 1; i++)
                        knots[i] = closed ? i : i <= degree ? 0 : i >= 14 ? 14 - degree : i - degree;
                    bat_curve *curve, *now = NULL;
                    assert_int_equal(bat_curve_create(m, degree, closed, 14, points,
                                                      closed ? 15 : degree + 15, knots, &curve),
                                     BAT_OK);
                    double d[2];
                    bat_curve_domain(curve, d);
                    const double T = d[1] - d[0];
                    drawn stroke = draw_along(&r, curve, d[0] + 0.2 * T, d[0] + 0.6 * T, 120, 10 * px,
                                              0.3 * px);
                    bat_sketch_options options = bat_sketch_defaults();
                    options.pixel = px;
                    bat_sketch_report report;
                    assert_int_equal(bat_sketch(curve, &stroke.stroke, &options, &now, &report), BAT_OK);
                    assert_int_equal(bat_curve_degree(now), degree < 3 ? 3 : degree);
                    assert_true(kept_moves(curve, now, &report) <= 1e-12);
                    assert_true(report.max_error <= px);
                    bat_curve_free(now);
                    bat_curve_free(curve);
                    drawn_free(&stroke);
                }
}

static void odd_curves_and_strokes(void **state) {
    (void)state;
    /* A curve that is a point, one with coincident points, small closed ones, two-sample and NaN-ridden strokes. */
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, ring[] = {0, 1, 2, 3},
                 still[8] = {300, 0, 300, 0, 300, 0, 300, 0};
    const double triangle[6] = {100, 0, -50, 86, -50, -86}, two[4] = {200, 0, 400, 3};
    const double doubled[22] = {0, 0,   60, 0,   60, 0,   60, 0,   60, 0,   300,
                                0, 300, 0,  420, 0,  480, 0,  540, 0,  600, 0};
    double far_knots[15], spotty[2 * COUNT];
    for (int i = 0; i < 15; i++) far_knots[i] = i < 4 ? 0 : i > 10 ? 8 : i - 3;
    for (int i = 0; i < COUNT; i++) {
        bump(i / (COUNT - 1.0), spotty + 2 * i);
        if (i % 7 == 3) spotty[2 * i + i % 2] = i % 3 ? NAN : INFINITY;
    }
    bat_curve *curves[4], *now;
    assert_int_equal(bat_curve_create(2, 3, false, 4, still, 8, knots, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create(2, 3, false, 11, doubled, 15, far_knots, &curves[1]), BAT_OK);
    assert_int_equal(bat_curve_create(2, 3, true, 3, triangle, 4, ring, &curves[2]), BAT_OK);
    curves[3] = line();
    const bat_stroke strokes[] = {{2, COUNT, spotty, NULL, NULL}, {2, 2, two, NULL, NULL}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++) {
            now = NULL;
            const bat_status status = bat_sketch(curves[i], &strokes[j], NULL, &now, NULL);
            assert_true(status == BAT_OK || status == BAT_FAR || status == BAT_TOLERANCE);
            assert_true((now != NULL) == (status != BAT_FAR));
            if (i == 3) assert_int_equal(status, BAT_OK);
            bat_curve_free(now);
        }
    for (int i = 0; i < 4; i++) bat_curve_free(curves[i]);
    /* A stroke of a million samples, one longer than the curve many times over. */
    const size_t many = 1000000;
    double *dense = malloc(2 * many * sizeof *dense);
    assert_non_null(dense);
    for (size_t i = 0; i < many; i++) bump((double)i / (double)(many - 1), dense + 2 * i);
    bat_curve *curve = line();
    bat_sketch_report report;
    assert_int_equal(bat_sketch(curve, &(bat_stroke){2, many, dense, NULL, NULL}, NULL, &now, &report),
                     BAT_OK);
    assert_true(distance_to(now, 300, 40) <= 1);
    bat_curve_free(now);
    free(dense);
    bat_curve_free(curve);
}

static void the_same_input_gives_the_same_bits(void **state) {
    (void)state;
    random_source r = {21};
    for (int n = 0; n < 20; n++) {
        bat_curve *curve = n % 2 ? ring_curve(&r, 10, 30) : wavy_curve(&r, 10, 40), *a, *b;
        drawn d = draw_along(&r, curve, 1, 5, 150, 20, 0.7);
        assert_int_equal(bat_sketch(curve, &d.stroke, NULL, &a, NULL), BAT_OK);
        assert_int_equal(bat_sketch(curve, &d.stroke, NULL, &b, NULL), BAT_OK);
        assert_true(bat_curve_is_equal(a, b));
        bat_curve_free(a);
        bat_curve_free(b);
        bat_curve_free(curve);
        drawn_free(&d);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(redraw_either_way),
                                       cmocka_unit_test(past_an_end_extends_or_shortens),
                                       cmocka_unit_test(the_rest_stays),
                                       cmocka_unit_test(refused),
                                       cmocka_unit_test(loops),
                                       cmocka_unit_test(a_very_short_stroke_is_a_bump),
                                       cmocka_unit_test(closed_curves_have_no_seam),
                                       cmocka_unit_test(closed_curves_lose_no_arc),
                                       cmocka_unit_test(corners_kept_or_not),
                                       cmocka_unit_test(scribbles_stay_near),
                                       cmocka_unit_test(smooth_joints_are_no_corners),
                                       cmocka_unit_test(multiple_knots),
                                       cmocka_unit_test(a_tolerance_that_cannot_be_met),
                                       cmocka_unit_test(joined_by_a_stroke),
                                       cmocka_unit_test(smoothing),
                                       cmocka_unit_test(new_curves),
                                       cmocka_unit_test(every_degree_dimension_and_scale),
                                       cmocka_unit_test(odd_curves_and_strokes),
                                       cmocka_unit_test(the_same_input_gives_the_same_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
