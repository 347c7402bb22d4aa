/* Taps of two and three fingers: what counts as one, and what does not. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include "editor/show/handles.h"
#include "editor/tools/points/state.h"

static void touch(bat_editor *editor, bat_device device, bat_pointer_phase phase, uint32_t contact, double x,
                  double y, double time) {
    bat_pointer event = {.phase = phase,
                         .device = device,
                         .contact = contact,
                         .buttons = phase == BAT_POINTER_DOWN || phase == BAT_POINTER_MOVE ? 1u : 0u,
                         .x = x,
                         .y = y,
                         .pressure = 0.5,
                         .time = time};
    bat_editor_pointer(editor, 1, &event);
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
}

/* So many fingers down from `time` on, 15 ms apart, each moved by `travel`, up after `hold` ms. */
static void tap_of(bat_editor *editor, int fingers, double time, double hold, double travel) {
    for (int i = 0; i < fingers; i++)
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, (uint32_t)i + 10, 300 + 90 * i, 400, time + 15 * i);
    bat_editor_frame(editor);
    for (int i = 0; i < fingers; i++)
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_MOVE, (uint32_t)i + 10, 300 + 90 * i, 400 + travel,
              time + 15 * fingers + i);
    for (int i = 0; i < fingers; i++)
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, (uint32_t)i + 10, 300 + 90 * i, 400 + travel,
              time + hold + i - fingers);
}

/* An editor with one stroke that can be undone; *drawn and *plain: digests with and without it. */
static bat_editor *with_a_stroke(uint64_t *drawn, uint64_t *plain) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    *plain = digest(editor);
    pen_line(&p, 350, 200, 650, 200, 30);
    *drawn = digest(editor);
    assert_true(*drawn != *plain);
    return editor;
}

static void two_undo_and_three_redo(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-sketch", "tool-select", "tool-points", "tool-pan",
                                        "tool-tangents"};
    for (int i = 0; i < 5; i++) {
        for (int palm = 0; palm < 2; palm++) {
            uint64_t drawn, plain;
            bat_editor *editor = with_a_stroke(&drawn, &plain);
            bat_editor_set(editor, "palm-rejection", palm);
            bat_editor_command(editor, tools[i]);
            double view[4];
            memcpy(view, bat_editor_frame(editor)->view, sizeof view);
            tap_of(editor, 2, 5000, 120, 3);
            assert_true(digest(editor) == plain);
            tap_of(editor, 3, 6000, 180, 3);
            assert_true(digest(editor) == drawn);
            tap_of(editor, 3, 7000, 180, 3); /* nothing to do again */
            assert_true(digest(editor) == drawn);
            assert_memory_equal(view, bat_editor_frame(editor)->view, sizeof view); /* not a pixel */
            assert_false(bat_editor_frame(editor)->busy);
            bat_editor_free(editor);
        }
    }
}

static void what_is_no_tap(void **state) {
    (void)state;
    static const struct {
        int fingers;
        double hold, travel;
    } none[] = {{1, 100, 2}, {4, 120, 2}, {2, 300, 2}, {2, 120, 14}, {3, 200, 14}};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        uint64_t drawn, plain;
        bat_editor *editor = with_a_stroke(&drawn, &plain);
        tap_of(editor, none[i].fingers, 5000, none[i].hold, none[i].travel);
        assert_true(digest(editor) == drawn);
        bat_editor_free(editor);
    }
}

/* A cancelled contact is the system's gesture. */
static void a_cancelled_tap_is_none(void **state) {
    (void)state;
    uint64_t drawn, plain;
    bat_editor *editor = with_a_stroke(&drawn, &plain);
    touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, 1, 300, 400, 5000);
    touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, 2, 400, 400, 5010);
    touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, 1, 300, 400, 5050);
    touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_CANCEL, 2, 400, 400, 5060);
    assert_true(digest(editor) == drawn);
    bat_editor_free(editor);
}

/* What two fingers come down on is not selected by that, nor is anything else forgotten: by a tap and by a pinch, on
 * an object and beside all, with Shift, after the first finger has begun to drag. */
static void fingers_leave_the_selection(void **state) {
    (void)state;
    static const struct {
        double y, travel;
        uint32_t modifiers;
    } first[] = {{600, 0, 0}, {600, 12, 0}, {400, 0, 0}, {600, 0, BAT_SHIFT}, {200, 12, 0}};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++)
        for (int pinch = 0; pinch < 2; pinch++)
            for (int chosen = 0; chosen < 2; chosen++) {
                bat_editor *editor = pen_editor(); /* lines 1 (y = 200) and 2 (y = 600) */
                uint64_t plain = digest(editor);
                bat_editor_command(editor, "tool-select");
                for (double time = 4000; chosen && time < 4100; time += 50)
                    touch(editor, BAT_DEVICE_TOUCH, time < 4050 ? BAT_POINTER_DOWN : BAT_POINTER_UP, 9, 400,
                          200, time);
                assert_int_equal(editor->choice.selection.count, chosen);
                bat_pointer down = {.phase = BAT_POINTER_DOWN,
                                    .device = BAT_DEVICE_TOUCH,
                                    .contact = 1,
                                    .buttons = 1,
                                    .modifiers = first[i].modifiers,
                                    .x = 400,
                                    .y = first[i].y,
                                    .time = 5000};
                bat_editor_pointer(editor, 1, &down);
                touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_MOVE, 1, 400 + first[i].travel, first[i].y, 5010);
                bat_editor_frame(editor);
                uint32_t version = editor->choice.selection.version;
                touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, 2, 500, first[i].y, 5020);
                assert_true(editor->choice.selection.version >= version);
                if (pinch) touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_MOVE, 2, 540, first[i].y, 5030);
                touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, 1, 400 + first[i].travel, first[i].y, 5100);
                touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, 2, 500, first[i].y, 5110);
                assert_int_equal(editor->choice.selection.count, chosen);
                assert_true(!chosen || editor->choice.selection.ids[0] == 1);
                assert_true(digest(editor) == plain);
                bat_editor_free(editor);
            }
}

/* Fingers beside a pen that draws, or that is about, are a hand at rest: nothing is undone, the stroke goes on. */
/* The same with a control point that is chosen. */
static void fingers_leave_the_chosen_point(void **state) {
    (void)state;
    for (int pinch = 0; pinch < 2; pinch++) {
        bat_editor *editor = pen_editor();
        bat_editor_command(editor, "tool-points");
        assert_int_equal(bat_editor_command(editor, "point-next"), BAT_OK);
        const bat_handle chosen = bat_pointing_of(&editor->context)->chosen;
        assert_int_equal(chosen.kind, BAT_HANDLE_POINT);
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, 1, 400, 500, 5000);
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_DOWN, 2, 500, 500, 5020);
        if (pinch) touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_MOVE, 2, 540, 500, 5030);
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, 1, 400, 500, 5100);
        touch(editor, BAT_DEVICE_TOUCH, BAT_POINTER_UP, 2, 500, 500, 5110);
        assert_int_equal(bat_pointing_of(&editor->context)->chosen.kind, chosen.kind);
        assert_int_equal(bat_pointing_of(&editor->context)->chosen.index, chosen.index);
        assert_false(bat_pointing_of(&editor->context)->pressed);
        bat_editor_free(editor);
    }
}

static void a_hand_beside_the_pen_is_none(void **state) {
    (void)state;
    uint64_t drawn, plain;
    bat_editor *editor = with_a_stroke(&drawn, &plain);
    bat_editor_set(editor, "palm-rejection", 0);
    pen p = pen_for(editor);
    p.time = 5000;
    pen_begin(&p, pen_arch, (double[]){350, 600, 650, 600, 30}, 30);
    tap_of(editor, 2, p.time, 100, 0);
    assert_true(digest(editor) == drawn && bat_editor_frame(editor)->busy);
    for (int i = 0; i < 5; i++) pen_event(&p, BAT_POINTER_MOVE, 650 + i, 600);
    pen_event(&p, BAT_POINTER_UP, 655, 600);
    uint64_t both = digest(editor);
    assert_true(both != drawn);
    tap_of(editor, 2, p.time + 300, 100, 0);
    assert_true(digest(editor) == both);
    tap_of(editor, 2, p.time + 1300, 100, 0);
    assert_true(digest(editor) == drawn);
    bat_editor_free(editor);
}

/* A finger that draws is joined late by others: the stroke goes on and is the only step. */
static void a_stroke_is_never_ended_by_a_tap(void **state) {
    (void)state;
    uint64_t drawn, plain;
    bat_editor *editor = with_a_stroke(&drawn, &plain);
    bat_editor_set(editor, "palm-rejection", 0);
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_TOUCH;
    p.time = 5000;
    pen_begin(&p, pen_arch, (double[]){350, 600, 650, 600, 30}, 90);
    tap_of(editor, 2, p.time, 100, 0);
    tap_of(editor, 3, p.time + 150, 100, 0);
    assert_true(digest(editor) == drawn && bat_editor_frame(editor)->busy);
    pen_event(&p, BAT_POINTER_UP, 650, 600);
    assert_true(digest(editor) != drawn && digest(editor) != plain);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == drawn);
    bat_editor_free(editor);
}

/* What waits for a yes is taken back first; what was drawn before stays. */
static void a_pending_fit_goes_first(void **state) {
    (void)state;
    uint64_t drawn, plain;
    bat_editor *editor = with_a_stroke(&drawn, &plain);
    bat_editor_set(editor, "palm-rejection", 0);
    bat_editor_set(editor, "tolerance", 0.1);
    bat_editor_set(editor, "stroke-meaning", 1); /* what is new never waits */
    pen p = pen_for(editor);
    p.time = 5000;
    uint32_t noise = 1;
    for (int i = 0; i <= 150; i++) { /* trembling that no curve follows within a tenth of a pixel */
        noise = noise * 1664525 + 1013904223;
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, 240 + 3 * i + (noise >> 24) / 20.0,
                  594 + (noise >> 16 & 255) / 20.0);
    }
    pen_event(&p, BAT_POINTER_UP, 690, 600);
    assert_true(bat_editor_frame(editor)->pending);
    tap_of(editor, 2, p.time + 2000, 120, 0);
    assert_false(bat_editor_frame(editor)->pending);
    assert_true(digest(editor) == drawn);
    tap_of(editor, 2, p.time + 4000, 120, 0);
    assert_true(digest(editor) == plain);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_undo_and_three_redo),          cmocka_unit_test(what_is_no_tap),
        cmocka_unit_test(fingers_leave_the_selection),      cmocka_unit_test(fingers_leave_the_chosen_point),
        cmocka_unit_test(a_cancelled_tap_is_none),          cmocka_unit_test(a_hand_beside_the_pen_is_none),
        cmocka_unit_test(a_stroke_is_never_ended_by_a_tap), cmocka_unit_test(a_pending_fit_goes_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
