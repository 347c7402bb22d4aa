/* Levels with any allocation failing: nothing leaks, the invariants hold, undo leads back to the beginning. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "support/pen.h"
#include <batten/document.h>
#include <batten/editor.h>

static void session(bat_editor *editor) {
    pen p = pen_for(editor);
    bat_editor_command(editor, "take-apart");
    bat_editor_set(editor, "apart-levels", 2);
    bat_editor_command(editor, "accept");
    bat_editor_set(editor, "show-levels", 1);
    bat_editor_set(editor, "show-frames", 1);
    bat_editor_frame(editor);
    pen_begin(&p, pen_arch, (double[]){500, 200, 520, 260, 0}, 8);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_UP, 520, 260);
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 1.5, false);
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 0.5, true);
    bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true);
    bat_editor_levels(editor);
    bat_editor_set(editor, "frame-rule", 2);
    bat_editor_command(editor, "levels-copy");
    pen_event(&p, BAT_POINTER_DOWN, 500, 600);
    pen_event(&p, BAT_POINTER_UP, 500, 600);
    bat_editor_command(editor, "level-add");
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 300, 600, 700, 600, 30);
    bat_editor_frame(editor);
}

static void memory_may_end_anywhere(void **state) {
    (void)state;
    bool ended = false;
    for (long n = 1; !ended; n += 1 + n / 24) {
        long before = alloc_live();
        bat_editor *editor = pen_editor();
        uint64_t first = bat_document_digest(bat_editor_document(editor));
        bat_editor_command(editor, "tool-levels");
        bat_editor_select(editor, 1, false);
        bat_editor_frame(editor);
        alloc_fail_at(n);
        session(editor);
        ended = !alloc_fail_reached();
        alloc_fail_at(0);
        bat_editor_frame(editor);
        const char *wrong = bat_editor_check(editor);
        if (wrong) fail_msg("allocation %ld: %s", n, wrong);
        if (ended) { /* the session does what it is for */
            assert_int_equal(bat_object_kind(bat_document_at(bat_editor_document(editor), 0)),
                             BAT_KIND_SHAPE);
            assert_int_equal(bat_object_kind(bat_document_at(bat_editor_document(editor), 1)),
                             BAT_KIND_SHAPE);
            assert_true(n > 300);
        }
        bat_editor_command(editor, "cancel");
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(bat_document_digest(bat_editor_document(editor)) == first);
        bat_editor_free(editor);
        assert_int_equal(alloc_live(), before);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_may_end_anywhere)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
