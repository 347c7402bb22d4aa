/* The session while the pen is down: its commit equals the one-shot call bit for bit, and ink once shown stays put. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/nearest.h>

#include "support/sketch_cases.h"

enum { CASES = 24, BATCH = 4 /* samples between previews: 60 frames a second at 240 Hz */ };

static void feed(bat_sketch_live *live, const drawn *d, size_t from, size_t to) {
    bat_stroke part = d->stroke;
    part.points += from * (size_t)part.dimension;
    part.count = to - from;
    assert_int_equal(bat_sketch_live_add(live, &part), BAT_OK);
}

static void commit_is_the_one_shot_call(void **state) {
    (void)state;
    random_source r = {11};
    for (int n = 0; n < CASES; n++) {
        bat_curve *curve = n % 2 ? ring_curve(&r, 12, 40) : wavy_curve(&r, 12, 50);
        double domain[2];
        bat_curve_domain(curve, domain);
        const double T = domain[1] - domain[0], u0 = domain[0] + 0.3 * T * random_unit(&r);
        const bool back = random_unit(&r) < 0.5;
        drawn d = draw_along(&r, curve, back ? u0 + 0.4 * T : u0, back ? u0 : u0 + 0.4 * T, 160, 40, 0.5);
        for (int kind = BAT_SKETCH_REDRAW; kind <= BAT_SKETCH_SMOOTH; kind++) {
            bat_sketch_live *live;
            assert_int_equal(bat_sketch_live_begin(curve, 2, (bat_sketch_kind)kind, NULL, &live), BAT_OK);
            for (size_t i = 0; i < d.stroke.count; i += BATCH) {
                const size_t to = i + BATCH < d.stroke.count ? i + BATCH : d.stroke.count;
                feed(live, &d, i, to);
                bat_curve *shown = NULL;
                const bat_status status = bat_sketch_live_preview(live, &shown, NULL);
                assert_true(status == BAT_OK || status == BAT_DOT || status == BAT_FAR ||
                            status == BAT_TOLERANCE);
                bat_curve_free(shown);
            }
            bat_curve *committed, *at_once;
            bat_sketch_report a, b;
            memset(&a, 0, sizeof a), memset(&b, 0, sizeof b);
            assert_int_equal(bat_sketch_live_commit(live, &committed, &a), BAT_OK);
            bat_status status;
            if (kind == BAT_SKETCH_NEW)
                status = bat_sketch_new(&d.stroke, false, NULL, &at_once, &b);
            else if (kind == BAT_SKETCH_SMOOTH)
                status = bat_sketch_smooth(curve, &d.stroke, NULL, &at_once, &b);
            else
                status = bat_sketch(curve, &d.stroke, NULL, &at_once, &b);
            assert_int_equal(status, BAT_OK);
            assert_true(bat_curve_is_equal(committed, at_once));
            assert_int_equal(a.solves, b.solves);
            assert_true(a.max_error == b.max_error);
            bat_curve_free(committed);
            bat_curve_free(at_once);
        }
        bat_curve_free(curve);
        drawn_free(&d);
    }
}

/* Distance from a point to the polyline. */
static double to_polyline(const double *q, const double *x, size_t count) {
    double best = INFINITY;
    for (size_t i = 0; i + 1 < count; i++) {
        const double *a = x + 2 * i, *b = a + 2;
        const double dx = b[0] - a[0], dy = b[1] - a[1], l = dx * dx + dy * dy;
        double f = l > 0 ? ((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / l : 0;
        f = f < 0 ? 0 : f > 1 ? 1 : f;
        best = fmin(best, hypot(q[0] - a[0] - f * dx, q[1] - a[1] - f * dy));
    }
    return best;
}

/* Ink shown for 100 ms (24 samples) moves no more than half a pixel until the pen lifts: every preview's
 * target is compared with the next ones', up to the place the pen was 100 ms before. */
static void shown_ink_stays(void **state) {
    (void)state;
    random_source r = {12};
    double worst = 0;
    for (int n = 0; n < CASES; n++) {
        bat_curve *curve = n % 2 ? ring_curve(&r, 12, 40) : wavy_curve(&r, 12, 50);
        double domain[2];
        bat_curve_domain(curve, domain);
        const double T = domain[1] - domain[0], u0 = domain[0] + 0.3 * T * random_unit(&r);
        const bool back = random_unit(&r) < 0.5;
        drawn d = draw_along(&r, curve, back ? u0 + 0.4 * T : u0, back ? u0 : u0 + 0.4 * T, 240, 40,
                             random_between(&r, 0.3, 1));
        bat_sketch_live *live;
        assert_int_equal(bat_sketch_live_begin(curve, 2, BAT_SKETCH_REDRAW, NULL, &live), BAT_OK);
        double *shown = NULL; /* the first target that showed a place older than 100 ms keeps it */
        size_t shown_count = 0;
        for (size_t i = 0; i < d.stroke.count; i += BATCH) {
            feed(live, &d, i, i + BATCH);
            bat_sketch_live_info info;
            const bat_status status = bat_sketch_live_preview(live, NULL, &info);
            if (status != BAT_OK && status != BAT_TOLERANCE) continue;
            if (shown_count > 0)
                for (size_t j = 0; j < shown_count; j++)
                    worst = fmax(worst, to_polyline(shown + 2 * j, info.target, info.target_count));
            if (i < 48) continue;
            /* Settled: the stroke proper up to where the pen was 24 samples ago. */
            const double *past = d.truth + 2 * (i + BATCH - 24 - 1);
            size_t first = info.stroke_first, last = info.stroke_last, best = first;
            for (size_t j = first; j <= last; j++)
                if (hypot(info.target[2 * j] - past[0], info.target[2 * j + 1] - past[1]) <
                    hypot(info.target[2 * best] - past[0], info.target[2 * best + 1] - past[1]))
                    best = j;
            if (back)
                first = best;
            else
                last = best;
            free(shown);
            shown_count = last - first + 1;
            shown = malloc(shown_count * 2 * sizeof *shown);
            assert_non_null(shown);
            memcpy(shown, info.target + 2 * first, shown_count * 2 * sizeof *shown);
        }
        free(shown);
        bat_sketch_live_cancel(live);
        bat_curve_free(curve);
        drawn_free(&d);
    }
    print_message("shown ink moved by %.3f px at most\n", worst);
    assert_true(worst <= 0.5);
}

/* A preview of a long stroke costs no more than that of a short one: its target stays small. It still shows the
 * stroke, and what will be committed. */
static void long_strokes(void **state) {
    (void)state;
    enum { LONG = 6000, STEP = 60 };
    random_source r = {13};
    double *points = malloc(2 * LONG * sizeof *points);
    assert_non_null(points);
    double angle = 0;
    for (int i = 0; i < LONG; i++) { /* a spiral, 1.5 px a sample */
        const double radius = 40 + 12 * angle;
        points[2 * i] = radius * cos(angle) + 0.5 * random_between(&r, -1, 1);
        points[2 * i + 1] = radius * sin(angle) + 0.5 * random_between(&r, -1, 1);
        angle += 1.5 / radius;
    }
    bat_sketch_live *live;
    assert_int_equal(bat_sketch_live_begin(NULL, 2, BAT_SKETCH_NEW, NULL, &live), BAT_OK);
    double middle[2] = {0, 0}, moved = 0;
    bat_sketch_live_info info = {0};
    for (int i = 0; i < LONG; i += STEP) {
        const bat_stroke part = {.dimension = 2, .count = STEP, .points = points + 2 * i};
        assert_int_equal(bat_sketch_live_add(live, &part), BAT_OK);
        assert_int_equal(bat_sketch_live_preview(live, NULL, &info), BAT_OK);
        assert_true(info.target_count <= 2000);
        if (i == LONG / 2) memcpy(middle, info.target + 2 * (info.target_count / 2), sizeof middle);
        if (i > LONG / 2) moved = fmax(moved, to_polyline(middle, info.target, info.target_count));
    }
    assert_true(moved <= 0.5);
    double raw = 0, away = 0;
    for (int i = 30; i < LONG - 30; i += 7)
        raw = fmax(raw, to_polyline(points + 2 * i, info.target, info.target_count));
    double *ink = malloc(2 * info.target_count * sizeof *ink);
    const size_t count = info.target_count;
    assert_non_null(ink);
    memcpy(ink, info.target, 2 * count * sizeof *ink);
    bat_curve *committed;
    assert_int_equal(bat_sketch_live_commit(live, &committed, NULL), BAT_OK);
    for (size_t i = 0; i < count; i++) {
        bat_near near;
        assert_int_equal(bat_curve_nearest(committed, ink + 2 * i, &near), BAT_OK);
        away = fmax(away, near.distance);
    }
    print_message("long stroke: ink %.2f px from the samples, %.2f px from the committed curve\n", raw, away);
    assert_true(raw <= 1.5);  /* three times the noise */
    assert_true(away <= 1.5); /* the tolerance, and what smoothing differs by */
    bat_curve_free(committed);
    free(ink);
    free(points);
}

static void calls_out_of_order(void **state) {
    (void)state;
    bat_sketch_live *live;
    assert_int_equal(bat_sketch_live_begin(NULL, 2, BAT_SKETCH_REDRAW, NULL, &live), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_live_begin(NULL, 2, BAT_SKETCH_NEW, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_live_begin(NULL, 4, BAT_SKETCH_NEW, NULL, &live), BAT_DIMENSION);
    assert_int_equal(bat_sketch_live_begin(NULL, 2, BAT_SKETCH_NEW, NULL, &live), BAT_OK);
    bat_curve *out = NULL;
    assert_int_equal(bat_sketch_live_preview(live, &out, NULL), BAT_DOT);
    const double space[3] = {0};
    assert_int_equal(bat_sketch_live_add(live, &(bat_stroke){.dimension = 3, .count = 1, .points = space}),
                     BAT_DIMENSION);
    assert_int_equal(bat_sketch_live_commit(live, &out, NULL), BAT_DOT);
    assert_null(out);
    bat_sketch_live_cancel(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(commit_is_the_one_shot_call),
                                       cmocka_unit_test(shown_ink_stays), cmocka_unit_test(long_strokes),
                                       cmocka_unit_test(calls_out_of_order)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
