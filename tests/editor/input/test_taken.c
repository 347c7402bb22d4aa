/* A gesture that the system takes away is offered back; brought back, it is what it would have been, to the byte. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "support/alloc_fail.h"
#include "support/editing.h"

typedef struct gesture {
    const char *tool;
    bat_device device;
    uint32_t buttons, modifiers;
    double numbers[5]; /* of pen_arch */
} gesture;

static const gesture gestures[] = {
    {"tool-sketch", BAT_DEVICE_PEN, 1, 0, {300, 560, 700, 560, 60}},       /* a new curve */
    {"tool-sketch", BAT_DEVICE_PEN, 1, 0, {350, 306, 560, 306, 12}},       /* a redraw */
    {"tool-sketch", BAT_DEVICE_MOUSE, 1, 0, {350, 306, 560, 306, 12}},     /* by a mouse */
    {"tool-sketch", BAT_DEVICE_TOUCH, 1, 0, {300, 560, 700, 560, 60}},     /* by a finger */
    {"tool-sketch", BAT_DEVICE_PEN, 1, BAT_ALT, {350, 306, 560, 306, 12}}, /* smooths */
    {"tool-sketch", BAT_DEVICE_PEN, 32, 0, {400, 270, 400, 330, 0}},       /* the eraser's end */
    {"tool-select", BAT_DEVICE_PEN, 1, 0, {400, 300, 460, 360, 0}},        /* moves */
    {"tool-line", BAT_DEVICE_PEN, 1, 0, {300, 560, 700, 590, 0}},
};
enum { GESTURES = sizeof gestures / sizeof *gestures };

static bat_editor *with_line(void) {
    bat_curve *curve = pen_curve(270, 300, 30, 0, 14);
    return editor_with(1, &curve);
}

static pen start(bat_editor *editor, const gesture *g) {
    assert_int_equal(bat_editor_command(editor, g->tool), BAT_OK);
    pen p = pen_for(editor);
    p.device = g->device;
    p.buttons = g->buttons;
    p.modifiers = g->modifiers;
    pen_begin(&p, pen_arch, g->numbers, 60);
    return p;
}

static void finish(pen *p, const gesture *g, bat_pointer_phase phase) {
    p->time -= 4; /* where and as it was last */
    pen_event(p, phase, g->numbers[2], g->numbers[3]);
    bat_editor_frame(p->editor);
    check(p->editor);
}

static void same_journals(const bat_editor *a, const bat_editor *b) {
    assert_string_equal(bat_editor_journal(a, NULL), bat_editor_journal(b, NULL));
}

static void brought_back_it_is_the_same(void **state) {
    (void)state;
    for (int k = 0; k < GESTURES; k++)
        for (int meanwhile = 0; meanwhile < 3; meanwhile++) {
            const gesture *g = &gestures[k];
            bat_editor *lifted = with_line(), *taken = with_line();
            const uint64_t before = digest(taken);
            pen p = start(lifted, g), q = start(taken, g);
            finish(&p, g, BAT_POINTER_UP);
            finish(&q, g, BAT_POINTER_CANCEL);
            assert_true(digest(lifted) != before); /* there is something to lose */
            assert_true(digest(taken) == before);
            assert_string_equal(bat_editor_frame(taken)->offer, "stroke-back");
            if (meanwhile == 1) bat_editor_command(taken, "zoom-in");
            if (meanwhile == 2) bat_editor_command(taken, "tool-zoom");
            double view[3];
            memcpy(view, bat_editor_frame(taken)->view, sizeof view);
            assert_int_equal(bat_editor_command(taken, "stroke-back"), BAT_OK);
            assert_memory_equal(bat_editor_frame(taken)->view, view, sizeof view);
            check(taken);
            same_journals(lifted, taken);
            assert_int_equal(bat_editor_command(taken, "stroke-back"), BAT_STATE); /* once */
            bat_editor_free(lifted);
            bat_editor_free(taken);
        }
}

/* Nothing is offered of what was hardly a stroke, was cancelled by the user, or began a pinch; nor after the next one. */
static void only_what_was_taken(void **state) {
    (void)state;
    bat_editor *editor = with_line();
    const gesture *g = &gestures[0];
    assert_int_equal(bat_editor_command(editor, "stroke-back"), BAT_STATE);
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_DOWN, 300, 560);
    pen_event(&p, BAT_POINTER_MOVE, 302, 560);
    pen_event(&p, BAT_POINTER_CANCEL, 302, 560);
    assert_int_equal(bat_editor_command(editor, "stroke-back"), BAT_STATE);
    p = start(editor, g);
    bat_editor_command(editor, "cancel");
    finish(&p, g, BAT_POINTER_CANCEL);
    assert_int_equal(bat_editor_command(editor, "stroke-back"), BAT_STATE);
    p = start(editor, g);
    finish(&p, g, BAT_POINTER_CANCEL);
    p = start(editor, &gestures[1]);
    finish(&p, &gestures[1], BAT_POINTER_UP);
    assert_int_equal(bat_editor_command(editor, "stroke-back"), BAT_STATE);
    p = start(editor, g);
    finish(&p, g, BAT_POINTER_CANCEL);
    const uint64_t before = digest(editor);
    bat_editor_set_read_only(editor, true);
    assert_int_equal(bat_editor_command(editor, "stroke-back"), BAT_STATE);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* Where memory runs out, a stroke is as it is without: it can be lifted, or is gone. */
static void without_memory(void **state) {
    (void)state;
    const gesture *g = &gestures[0];
    for (long n = 1; n < 400; n += 7) {
        bat_editor *editor = with_line();
        alloc_fail_at(n);
        pen p = start(editor, g);
        finish(&p, g, BAT_POINTER_CANCEL);
        bat_editor_command(editor, "stroke-back");
        const bool reached = alloc_fail_reached();
        check(editor);
        replays(editor, (uint64_t)n);
        bat_editor_free(editor);
        if (!reached) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(brought_back_it_is_the_same),
        cmocka_unit_test(only_what_was_taken),
        cmocka_unit_test(without_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
