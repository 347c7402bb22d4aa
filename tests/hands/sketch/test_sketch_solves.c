/* Any solve on the way to a curve may fail, as those of badly spread samples do: the hand does without it, and what it
 * then gives is near what it gives otherwise; or it says that it could not, and gives nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/sketch_scenes.h"
#include "support/solve_fail.h"
#include "curve/curve.h"
#include "hands/sketch/converge.h"
#include <batten/fit.h>
#include <batten/levels.h>

/* Strokes of this noise are met within a pixel and a half, whatever fails. */
static const double near = 1.5;

/* How many fail from the nth on: one, all. */
static const long lasting[] = {1, 1L << 40};

typedef struct tally {
    int good, refused;
} tally;

static void must_be_good(bat_status status, const bat_curve *out, const bat_curve *wanted, tally *t) {
    if (status == BAT_OK || status == BAT_TOLERANCE) {
        double there, back;
        assert_non_null(out);
        assert_int_equal(bat_curve_validate(out), BAT_OK);
        assert_int_equal(bat_curve_distance(out, wanted, 200, &there, &back), BAT_OK);
        if (status == BAT_OK && !(fmax(there, back) < near)) fail_msg("%g px away", fmax(there, back));
        t->good++;
    } else {
        assert_null(out);
        assert_true(status == BAT_SINGULAR || status == BAT_NUMBER);
        t->refused++;
    }
}

static void strokes(void **state) {
    (void)state;
    sketch_scene s;
    tally t = {0, 0};
    scene_make(&s);
    for (int i = 0; i < 2 * SKETCH_CALLS; i++) {
        bat_curve *wanted = NULL;
        s.options.degree = i < SKETCH_CALLS ? 3 : 5;
        assert_int_equal(sketch_calls[i % SKETCH_CALLS](&s, &wanted), BAT_OK);
        for (int k = 0; k < 2; k++) {
            bool reached = true;
            for (long n = 1; reached; n += 1 + n / 6) {
                bat_curve *out = NULL;
                solve_fail_at(n, lasting[k]);
                const bat_status status = sketch_calls[i % SKETCH_CALLS](&s, &out);
                reached = solve_fail_reached();
                must_be_good(status, out, wanted, &t);
                if (!reached) assert_true(bat_curve_is_equal(out, wanted));
                bat_curve_free(out);
            }
        }
        bat_curve_free(wanted);
    }
    scene_drop(&s);
    print_message("%d good, %d refused\n", t.good, t.refused);
    assert_true(t.good > 100 && t.refused > 100);
}

static void fits_and_means(void **state) {
    (void)state;
    sketch_scene s;
    tally t = {0, 0};
    bat_curve *wanted = NULL;
    scene_make(&s);
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 1;
    for (int closed = 0; closed < 2; closed++) {
        options.closed = closed;
        const double *points = closed ? s.round : s.bump;
        assert_int_equal(bat_fit(2, SAMPLES - 1, points, &options, &wanted, NULL), BAT_OK);
        for (int k = 0; k < 2; k++) {
            bool reached = true;
            for (long n = 1; reached; n++) {
                bat_curve *out = NULL;
                solve_fail_at(n, lasting[k]);
                const bat_status status = bat_fit(2, SAMPLES - 1, points, &options, &out, NULL);
                reached = solve_fail_reached();
                must_be_good(status, out, wanted, &t);
                bat_curve_free(out);
            }
        }
        bat_curve_free(wanted);
    }
    const bat_stroke two[] = {scene_stroke_of(s.bump, SAMPLES), scene_stroke_of(s.bump, SAMPLES - 2)};
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_average mean = {0};
        solve_fail_at(n, 1);
        const bat_status status = bat_converge(2, two, 1, &mean);
        reached = solve_fail_reached();
        assert_int_equal(status, reached ? BAT_SINGULAR : BAT_OK);
        assert_true((mean.points != NULL) == !reached);
        free(mean.points);
    }
    scene_drop(&s);
}

/* A shape that cannot be taken apart, or a level that cannot follow, is left as it was. */
static void levels(void **state) {
    (void)state;
    sketch_scene s;
    scene_make(&s);
    const bat_stroke stroke = scene_stroke_of(s.bump, SAMPLES);
    bat_shape *shape = NULL;
    assert_int_equal(bat_shape_decompose(s.open, 1, NULL, &shape), BAT_OK);
    bat_curve *before = NULL;
    assert_int_equal(bat_curve_copy(bat_shape_curve(shape, 1), &before), BAT_OK);
    for (int ring = 0; ring < 2; ring++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_shape *made = NULL;
            solve_fail_at(n, 1);
            const bat_status status = bat_shape_decompose(ring ? s.ring : s.open, 1, NULL, &made);
            reached = solve_fail_reached();
            assert_int_equal(status, reached ? BAT_SINGULAR : BAT_OK);
            assert_true((made != NULL) == !reached);
            bat_shape_free(made);
        }
    }
    bool reached = true;
    for (long n = 1; reached; n++) {
        solve_fail_at(n, 1);
        const bat_status status = bat_shape_redraw_level(shape, 0, &stroke, &s.options, NULL);
        reached = solve_fail_reached();
        if (reached && status != BAT_OK) {
            assert_int_equal(status, BAT_SINGULAR);
            assert_true(bat_curve_is_equal(bat_shape_curve(shape, 1), before));
        }
        if (!reached) assert_int_equal(status, BAT_OK);
    }
    bat_shape_free(shape);
    bat_curve_free(before);
    scene_drop(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(strokes), cmocka_unit_test(fits_and_means),
                                       cmocka_unit_test(levels)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
