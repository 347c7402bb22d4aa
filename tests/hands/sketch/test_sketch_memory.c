/* The sketch hand survives the failure of any allocation: BAT_MEMORY, no output, nothing leaked. A live session goes on
 * after a failed preview or add, and its commit still equals the one-shot call. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "support/sketch_cases.h"
#include "support/alloc_fail.h"

enum { SAMPLES = 60 };
static const double pi = 3.14159265358979324;

typedef struct scene {
    bat_curve *open, *ring, *right;
    double bump[2 * SAMPLES], round[2 * SAMPLES], bridge[2 * SAMPLES];
    bat_sketch_options options;
} scene;

static bat_stroke stroke_of(const double *points, size_t count) {
    return (bat_stroke){.dimension = 2, .count = count, .points = points};
}

/* Degree 3 clamped, or degree 2 closed; even knots. */
static bat_curve *even(bool closed, int count, const double *points) {
    double knots[32];
    const int p = closed ? 2 : 3;
    for (int i = 0; i <= count + p; i++) knots[i] = closed ? i : fmin(fmax(i - p, 0), count - p);
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, p, closed, (size_t)count, points, closed ? count + 1 : count + p + 1,
                                      knots, &curve),
                     BAT_OK);
    return curve;
}

static bat_curve *wave(double x0, double y0) {
    double points[20];
    for (int i = 0; i < 10; i++) points[2 * i] = x0 + 30 * i, points[2 * i + 1] = y0 + 12 * sin(i);
    return even(false, 10, points);
}

static void make(scene *s) {
    double points[20];
    s->options = bat_sketch_defaults();
    s->open = wave(0, 0), s->right = wave(330, 20);
    for (int i = 0; i < 10; i++)
        points[2 * i] = 100 * cos(i * pi / 5), points[2 * i + 1] = 100 * sin(i * pi / 5);
    s->ring = even(true, 10, points); /* is raised to degree 3 */
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1), a = 2 * pi * t, noise = 0.3 * sin(71.0 * i);
        s->bump[2 * i] = 80 + 100 * t, s->bump[2 * i + 1] = 14 * sin(pi * t) + noise;
        s->round[2 * i] = 112 * cos(a), s->round[2 * i + 1] = 108 * sin(a) + noise;
        s->bridge[2 * i] = 240 + 120 * t, s->bridge[2 * i + 1] = 15 * sin(2 * pi * t) + noise;
    }
}

static void drop(scene *s) { bat_curve_free(s->open), bat_curve_free(s->ring), bat_curve_free(s->right); }

static bat_status redraw(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->bump, SAMPLES);
    return bat_sketch(s->open, &stroke, &s->options, out, NULL);
}
static bat_status redraw_arc(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->round, SAMPLES / 3);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static bat_status redraw_most(const scene *s, bat_curve **out) { /* the kept arc is given knots */
    const bat_stroke stroke = stroke_of(s->round, SAMPLES - 9);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static bat_status redraw_all(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->round, SAMPLES);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static bat_status fresh(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->bump, SAMPLES);
    return bat_sketch_new(&stroke, false, &s->options, out, NULL);
}
static bat_status fresh_cornered(const scene *s, bat_curve **out) {
    double points[2 * SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        points[2 * i] = 3 * i, points[2 * i + 1] = 3 * fabs(i - SAMPLES / 2.0) + 0.3 * sin(71.0 * i);
    const bat_stroke stroke = stroke_of(points, SAMPLES);
    return bat_sketch_new(&stroke, false, &s->options, out, NULL);
}
static bat_status fresh_ring(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->round, SAMPLES);
    return bat_sketch_new(&stroke, true, &s->options, out, NULL);
}
static bat_status smooth(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->bump, SAMPLES);
    return bat_sketch_smooth(s->open, &stroke, &s->options, out, NULL);
}
static bat_status join(const scene *s, bat_curve **out) {
    const bat_stroke stroke = stroke_of(s->bridge, SAMPLES);
    return bat_sketch_join(s->open, s->right, &stroke, &s->options, out, NULL);
}

static void calls(void **state) {
    (void)state;
    bat_status (*const all[])(const scene *, bat_curve **) = {
        redraw, redraw_arc, redraw_most, redraw_all, fresh, fresh_cornered, fresh_ring, smooth, join};
    scene s;
    make(&s);
    const long live = alloc_live();
    const size_t count = sizeof all / sizeof all[0];
    for (size_t i = 0; i < 2 * count; i++) {
        s.options.degree = i < count ? 3 : 5;
        for (long n = 1;; n++) {
            bat_curve *out = NULL;
            alloc_fail_at(n);
            const bat_status status = all[i % count](&s, &out);
            if (!alloc_fail_reached()) {
                assert_int_equal(status, BAT_OK);
                assert_non_null(out);
                assert_true(n > 20);
                bat_curve_free(out);
                break;
            }
            assert_int_equal(status, BAT_MEMORY);
            assert_null(out);
            assert_true(alloc_live() == live);
        }
        assert_true(alloc_live() == live);
    }
    drop(&s);
}

/* The same stroke through a session in which the nth allocation fails; the call that failed is made again. */
static bool session_with_failure(const scene *s, bat_sketch_kind kind, long n, bat_curve **committed) {
    enum { BATCH = 12 };
    bat_sketch_live *live = NULL;
    bool hit = false;
    alloc_fail_at(n);
    bat_status status = bat_sketch_live_begin(s->open, 2, kind, &s->options, &live);
    if (status == BAT_MEMORY) {
        assert_true(alloc_fail_reached());
        assert_null(live);
        hit = true;
        status = bat_sketch_live_begin(s->open, 2, kind, &s->options, &live);
    }
    assert_int_equal(status, BAT_OK);
    for (size_t i = 0; i < SAMPLES; i += BATCH) {
        const bat_stroke part = stroke_of(s->bump + 2 * i, BATCH);
        status = bat_sketch_live_add(live, &part);
        if (status == BAT_MEMORY) {
            hit = true;
            assert_true(alloc_fail_reached());
            status = bat_sketch_live_add(live, &part);
        }
        assert_int_equal(status, BAT_OK);
        bat_curve *shown = NULL;
        bat_sketch_live_info info;
        status = bat_sketch_live_preview(live, &shown, &info);
        if (status == BAT_MEMORY) {
            hit = true;
            assert_true(alloc_fail_reached());
            assert_null(shown);
            status = bat_sketch_live_preview(live, &shown, &info);
        }
        assert_true(status == BAT_OK || status == BAT_DOT);
        if (status == BAT_OK) assert_true(info.target_count > 0 && isfinite(info.target[0]));
        bat_curve_free(shown);
    }
    status = bat_sketch_live_commit(live, committed, NULL);
    if (status == BAT_MEMORY) {
        assert_true(alloc_fail_reached());
        assert_null(*committed);
        return true;
    }
    assert_int_equal(status, BAT_OK);
    return alloc_fail_reached() || hit;
}

static void sessions(void **state) {
    (void)state;
    scene s;
    make(&s);
    const long live = alloc_live();
    for (int kind = BAT_SKETCH_REDRAW; kind <= BAT_SKETCH_SMOOTH; kind++) {
        bat_curve *expected = NULL;
        const bat_stroke whole = stroke_of(s.bump, SAMPLES);
        bat_status status = kind == BAT_SKETCH_REDRAW ? redraw(&s, &expected)
                            : kind == BAT_SKETCH_NEW
                                ? fresh(&s, &expected)
                                : bat_sketch_smooth(s.open, &whole, &s.options, &expected, NULL);
        assert_int_equal(status, BAT_OK);
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_curve *committed = NULL;
            reached = session_with_failure(&s, (bat_sketch_kind)kind, n, &committed);
            if (committed) assert_true(bat_curve_is_equal(expected, committed));
            assert_true(reached || committed);
            bat_curve_free(committed);
        }
        bat_curve_free(expected);
        assert_true(alloc_live() == live);
    }
    drop(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(calls), cmocka_unit_test(sessions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
