/* The sketch hand survives the failure of any allocation: BAT_MEMORY, no output, nothing leaked. A live session goes on
 * after a failed preview or add, and its commit still equals the one-shot call. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "support/sketch_scenes.h"
#include "support/alloc_fail.h"

static void calls(void **state) {
    (void)state;
    sketch_scene s;
    scene_make(&s);
    const long live = alloc_live();
    for (int i = 0; i < 2 * SKETCH_CALLS; i++) {
        s.options.degree = i < SKETCH_CALLS ? 3 : 5;
        for (long n = 1;; n++) {
            bat_curve *out = NULL;
            alloc_fail_at(n);
            const bat_status status = sketch_calls[i % SKETCH_CALLS](&s, &out);
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
    scene_drop(&s);
}

/* The same stroke through a session in which the nth allocation fails; the call that failed is made again. */
static bool session_with_failure(const sketch_scene *s, bat_sketch_kind kind, long n, bat_curve **committed) {
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
        const bat_stroke part = scene_stroke_of(s->bump + 2 * i, BATCH);
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
    sketch_scene s;
    scene_make(&s);
    const long live = alloc_live();
    for (int kind = BAT_SKETCH_REDRAW; kind <= BAT_SKETCH_SMOOTH; kind++) {
        bat_curve *expected = NULL;
        const bat_stroke whole = scene_stroke_of(s.bump, SAMPLES);
        bat_status status = kind == BAT_SKETCH_REDRAW ? scene_redraw(&s, &expected)
                            : kind == BAT_SKETCH_NEW
                                ? scene_fresh(&s, &expected)
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
    scene_drop(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(calls), cmocka_unit_test(sessions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
