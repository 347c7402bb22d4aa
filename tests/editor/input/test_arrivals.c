/* Samples that come out of order or have no place: the stroke is that of the good ones in order, to the byte. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "support/editing.h"

enum { SAMPLES = 200, BAD = 40, BATCH = 25 };

/* A wave, sampled every 4 ms: down, moves, up. */
static bat_pointer sample(int i) {
    return (bat_pointer){.phase = i == 0             ? BAT_POINTER_DOWN
                                  : i == SAMPLES - 1 ? BAT_POINTER_UP
                                                     : BAT_POINTER_MOVE,
                         .device = BAT_DEVICE_PEN,
                         .contact = 3,
                         .buttons = i < SAMPLES - 1,
                         .x = 300 + 2 * i,
                         .y = 400 + 60 * sin(i / 20.0),
                         .pressure = 0.5,
                         .time = 1000 + 4 * i};
}

static bat_editor *told(bat_pointer *events, int count) {
    bat_editor *editor = pen_editor();
    for (int i = 0; i < count; i += BATCH)
        bat_editor_pointer(editor, (size_t)(count - i < BATCH ? count - i : BATCH), events + i);
    check(editor);
    return editor;
}

static void same(const bat_editor *a, const bat_editor *b) {
    assert_non_null(strstr(bat_editor_journal(a, NULL), "sketch-new"));
    assert_string_equal(bat_editor_journal(a, NULL), bat_editor_journal(b, NULL));
}

static void swap(bat_pointer *a, bat_pointer *b) {
    bat_pointer one = *a;
    *a = *b;
    *b = one;
}

static void out_of_order(void **state) {
    (void)state;
    bat_pointer events[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) events[i] = sample(i);
    bat_editor *ordered = told(events, SAMPLES);
    uint64_t random = 5;
    for (int from = 0; from < SAMPLES; from += BATCH)
        for (int i = BATCH - 1; i > 0; i--) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            bat_pointer *a = &events[from + i], *b = &events[from + (int)(random >> 33) % i];
            if (a->phase == BAT_POINTER_MOVE && b->phase == BAT_POINTER_MOVE) swap(a, b);
        }
    bat_editor *shuffled = told(events, SAMPLES);
    same(ordered, shuffled);
    bat_editor_free(ordered);
    bat_editor_free(shuffled);
}

static const double wild[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 1e7};

/* Among the good samples, and in place of the first and the last. */
static void without_a_place(void **state) {
    (void)state;
    bat_pointer good[SAMPLES], bad[SAMPLES + BAD];
    int count = 0;
    for (int i = 0; i < SAMPLES; i++) {
        good[i] = sample(i);
        if (i % 5 == 4 && count - i < BAD) {
            bad[count] = good[i];
            bad[count].phase = BAT_POINTER_MOVE;
            *(i % 2 ? &bad[count].x : &bad[count].y) = wild[i % 6];
            count++;
        }
        bad[count++] = good[i];
    }
    bat_editor *a = told(good, SAMPLES), *b = told(bad, count);
    same(a, b);
    bat_editor_free(a);
    bat_editor_free(b);
    for (int i = 0; i < 6; i++) {
        good[0].x = wild[i]; /* comes down with the next one */
        bad[0] = sample(1), bad[0].phase = BAT_POINTER_DOWN;
        for (int k = 1; k < SAMPLES - 1; k++) bad[k] = sample(k + 1);
        a = told(good, SAMPLES), b = told(bad, SAMPLES - 1);
        same(a, b);
        bat_editor_free(a);
        bat_editor_free(b);
    }
}

/* A time that is none is that of the sample before. */
static void without_a_time(void **state) {
    (void)state;
    static const double none[] = {NAN, INFINITY, -1, 1e308};
    bat_pointer given[SAMPLES], missing[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        given[i] = missing[i] = sample(i);
        if (i % 7 != 6 || i == SAMPLES - 1) continue;
        given[i].time = given[i - 1].time;
        missing[i].time = none[i % 4];
    }
    bat_editor *a = told(given, SAMPLES), *b = told(missing, SAMPLES);
    same(a, b);
    bat_editor_free(a);
    bat_editor_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(out_of_order),
        cmocka_unit_test(without_a_place),
        cmocka_unit_test(without_a_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
