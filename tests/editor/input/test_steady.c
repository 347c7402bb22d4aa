/* The stabiliser: closed forms of the filter, and the bounds on how it may change a stroke. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/pen.h"
#include "editor/input/samples.h"
#include "editor/input/stabiliser.h"
#include "editor/tools/sketch/sketching.h"

static double apart(const double a[2], const double b[2]) { return hypot(a[0] - b[0], a[1] - b[1]); }

/* A noise in -1..1, the same every time. */
static double noise(uint32_t i) {
    i = (i ^ i >> 15) * 2246822519u + 12345u;
    i = (i ^ i >> 13) * 3266489917u;
    return (double)(i >> 16) / 32768 - 1;
}

static void a_straight_path_in_closed_form(void **state) {
    (void)state;
    for (int strength = 1; strength <= 10; strength++) {
        double reach = strength * strength / 2.0;
        bat_steady steady = bat_steady_begin(strength, (double[]){5, 7});
        for (int i = 1; i <= 60; i++) {
            bat_steady_move(&steady, (double[]){5 + 3 * i, 7 + 4 * i}); /* 5 px each */
            double lag = reach * (1 - exp(-5 * i / reach));
            assert_true(fabs(apart(steady.end, steady.pen) - lag) < 1e-9);
            assert_true(fabs((steady.end[0] - 5) * 4 - (steady.end[1] - 7) * 3) < 1e-9);
        }
    }
}

static void how_often_the_pen_is_read_does_not_matter(void **state) {
    (void)state;
    bat_steady coarse = bat_steady_begin(6, (double[]){0, 0}), fine = coarse;
    for (uint32_t i = 1; i <= 200; i++) {
        double from[2] = {coarse.pen[0], coarse.pen[1]}, to[2] = {4 * i, 30 * noise(i)};
        bat_steady_move(&coarse, to);
        int parts = 1 + (int)i % 7;
        for (int k = 1; k <= parts; k++)
            bat_steady_move(&fine, (double[]){from[0] + (to[0] - from[0]) * k / parts,
                                              from[1] + (to[1] - from[1]) * k / parts});
        assert_true(apart(coarse.end, fine.end) < 1e-9);
    }
}

static void the_lag_is_bounded_and_the_end_arrives(void **state) {
    (void)state;
    for (int strength = 0; strength <= 10; strength++) {
        bat_steady steady = bat_steady_begin(strength, (double[]){0, 0});
        for (uint32_t i = 1; i <= 500; i++) {
            double far = i % 50 ? 20 : 1e6;
            bat_steady_move(&steady, (double[]){far * noise(2 * i), far * noise(2 * i + 1)});
            assert_true(apart(steady.end, steady.pen) <= steady.reach + 1e-6);
        }
        int steps = 0;
        while (bat_steady_catch_up(&steady)) assert_true(++steps <= 18);
        assert_true(steady.end[0] == steady.pen[0] && steady.end[1] == steady.pen[1]);
    }
}

/* A trembling line: what is left of the trembling shrinks with the strength. */
static void trembling_is_steadied(void **state) {
    (void)state;
    double before = INFINITY;
    for (int strength = 0; strength <= 10; strength += 2) {
        bat_steady steady = bat_steady_begin(strength, (double[]){0, 0});
        double sum = 0;
        for (uint32_t i = 1; i <= 4000; i++) {
            bat_steady_move(&steady, (double[]){2 * i, noise(i)});
            if (i > 200) sum += steady.end[1] * steady.end[1];
        }
        assert_true(sum < before * 0.85);
        before = sum;
    }
}

/* A circle of radius r becomes one of r / sqrt(1 + (reach / r)^2): low strengths hardly show. */
static void round_stays_round(void **state) {
    (void)state;
    for (int strength = 1; strength <= 10; strength++) {
        double r = 80, reach = strength * strength / 2.0;
        bat_steady steady = bat_steady_begin(strength, (double[]){r, 0});
        for (int i = 1; i <= 40000; i++) {
            bat_steady_move(&steady, (double[]){r * cos(i / 500.0), r * sin(i / 500.0)});
            if (i < 20000) continue;
            double expected = r / sqrt(1 + reach / r * reach / r);
            assert_true(fabs(hypot(steady.end[0], steady.end[1]) - expected) < 1e-3);
        }
    }
    assert_true(80 - 80 / sqrt(1 + 4.0 / 6400) < 0.03); /* the default */
}

/* A wave with trembling, as events. */
enum { EVENTS = 240 };
static void wave(bat_pointer events[EVENTS]) {
    for (uint32_t i = 0; i < EVENTS; i++)
        events[i] = (bat_pointer){.phase = i == 0            ? BAT_POINTER_DOWN
                                           : i == EVENTS - 1 ? BAT_POINTER_UP
                                                             : BAT_POINTER_MOVE,
                                  .device = BAT_DEVICE_PEN,
                                  .contact = 1,
                                  .buttons = i == EVENTS - 1 ? 0 : BAT_BUTTON_PRIMARY,
                                  .x = 100 + 3 * i + noise(2 * i),
                                  .y = 400 + 60 * sin(i / 30.0) + noise(2 * i + 1),
                                  .pressure = 0.5,
                                  .time = 1000 + 4 * i};
}

static bat_editor *steadied(double strength) {
    bat_editor *editor = pen_editor();
    assert_int_equal(bat_editor_set(editor, "stabiliser", strength), BAT_OK);
    return editor;
}

static void off_is_the_pen_itself_and_the_end_is_always(void **state) {
    (void)state;
    bat_pointer events[EVENTS];
    wave(events);
    for (int strength = 0; strength <= 10; strength++) {
        bat_editor *editor = steadied(strength);
        bat_editor_pointer(editor, EVENTS - 1, events);
        const bat_samples *samples = &bat_sketching_of(&editor->context)->edit.samples;
        for (size_t i = 0; i < samples->count && strength == 0; i++) {
            double x = round(events[i].x * 100) / 100, y = round(events[i].y * 100) / 100;
            assert_true(samples->count == EVENTS - 1);
            assert_true(samples->pixels[2 * i] == x && samples->pixels[2 * i + 1] == y);
        }
        /* what is shown reaches the pen, too, though the ink lags */
        const bat_frame *frame = bat_editor_frame(editor);
        const bat_item *ahead = pen_live(frame, BAT_ROLE_PREDICTED);
        assert_int_equal(ahead != NULL, strength > 0);
        if (ahead) {
            double shown = ahead->path[ahead->path_count - 2] + frame->origin[0];
            assert_true(fabs(shown - events[EVENTS - 2].x) < 0.02);
        }
        bat_editor_pointer(editor, 1, events + EVENTS - 1);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
        char last[80]; /* the stroke as the journal has it ends where the pen was lifted */
        snprintf(last, sizeof last, "[%.10g,%.10g]],\"pressure\"", round(events[EVENTS - 1].x * 100) / 100,
                 round(events[EVENTS - 1].y * 100) / 100);
        assert_non_null(strstr(bat_editor_journal(editor, NULL), last));
        assert_null(bat_editor_check(editor));
        bat_editor_free(editor);
    }
}

/* One by one with a frame after each and predictions between, in sevens, or all at once: the same document. */
static void frames_and_batches_do_not_matter(void **state) {
    (void)state;
    bat_pointer events[EVENTS];
    wave(events);
    for (int strength = 0; strength <= 10; strength += 2) {
        uint64_t digests[3];
        for (int way = 0; way < 3; way++) {
            bat_editor *editor = steadied(strength);
            size_t batch = way == 0 ? 1 : way == 1 ? 7 : EVENTS;
            for (size_t i = 0; i < EVENTS; i += batch) {
                bat_editor_pointer(editor, i + batch < EVENTS ? batch : EVENTS - i, events + i);
                if (way == 0 && i > 0 && i < EVENTS - 1) {
                    bat_pointer guess = events[i];
                    guess.predicted = true;
                    guess.x += 9;
                    bat_editor_pointer(editor, 1, &guess);
                }
                if (way < 2) bat_editor_frame(editor);
            }
            digests[way] = bat_document_digest(bat_editor_document(editor));
            size_t size = 0;
            const char *journal = bat_editor_journal(editor, &size);
            bat_editor *other = NULL;
            bat_problem problem;
            bat_editor_create(&other);
            assert_int_equal(bat_editor_replay(other, journal, size, true, &problem), BAT_OK);
            assert_true(bat_document_digest(bat_editor_document(other)) == digests[way]);
            bat_editor_free(other);
            bat_editor_free(editor);
        }
        assert_true(digests[0] == digests[1] && digests[1] == digests[2]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_path_in_closed_form),
        cmocka_unit_test(how_often_the_pen_is_read_does_not_matter),
        cmocka_unit_test(the_lag_is_bounded_and_the_end_arrives),
        cmocka_unit_test(trembling_is_steadied),
        cmocka_unit_test(round_stays_round),
        cmocka_unit_test(off_is_the_pen_itself_and_the_end_is_always),
        cmocka_unit_test(frames_and_batches_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
