/* A compacted journal replays to the same document, with the same steps to undo and redo. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/session.h"
#include "support/alloc_fail.h"
#include <batten/base.h>
#include <batten/document.h>
#include <batten/editor.h>
#include "support/editing.h"

/* Both go the same way to the end of their histories. Returns the steps. */
static int walk(bat_editor *a, bat_editor *b, const char *command, int limit) {
    int steps = 0;
    while (steps < limit && bat_editor_command(b, command) == BAT_OK) {
        assert_int_equal(bat_editor_command(a, command), BAT_OK);
        assert_true(digest(a) == digest(b));
        steps++;
    }
    return steps;
}

static void wild_sessions(void **state) {
    (void)state;
    enum { SIZE = 1500 };
    static uint8_t data[SIZE];
    uint64_t random = 3;
    int steps = 0;
    for (int session = 0; session < 8; session++) {
        session_bytes bytes = session_random(data, SIZE, &random);
        bat_editor *editor = pen_editor();
        double time = 0;
        while (bytes.at < bytes.size) session_event(editor, &bytes, &time);
        bat_editor_command(editor, "cancel");
        bat_editor_command(editor, "cancel");
        if (session % 2) bat_editor_command(editor, "undo");
        uint64_t before = digest(editor);
        assert_int_equal(bat_editor_compact(editor), BAT_OK);
        assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == before);
        bat_editor *again = replay_of(editor, 0);
        assert_true(digest(again) == before);
        walk(editor, again, "redo", 1000);
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_STATE);
        steps += walk(editor, again, "undo", 1000);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE);
        bat_editor_free(again);
        bat_editor_free(editor);
    }
    assert_true(steps > 20);
}

static void long_sessions_become_short(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    for (int i = 0; i < 3000; i++) assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
    for (int i = 0; i < 10; i++) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    size_t size = 0, after = 0;
    bat_editor_journal(editor, &size);
    assert_int_equal(bat_editor_compact(editor), BAT_OK);
    bat_editor_journal(editor, &after);
    assert_true(after < size / 2);
    bat_editor *again = replay_of(editor, 0);
    assert_int_equal(walk(editor, again, "redo", 1000), 10);
    assert_true(walk(editor, again, "undo", 3000) >= 990);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE); /* the living editor knows no more */
    bat_editor_free(again);
    bat_editor_free(editor);
}

static void not_in_the_middle_of_a_stroke(void **state) {
    (void)state;
    assert_int_equal(bat_editor_compact(NULL), BAT_ARGUMENT);
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){100, 100, 200, 120, 10}, 20);
    assert_int_equal(bat_editor_compact(editor), BAT_STATE);
    bat_editor_command(editor, "cancel");
    assert_int_equal(bat_editor_compact(editor), BAT_OK);
    bat_editor_free(editor);
}

static void no_memory_changes_nothing(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    for (int i = 0; i < 3; i++) assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
    size_t size = 0, after = 0;
    const char *text = bat_editor_journal(editor, &size);
    for (int n = 1;; n++) {
        long live = alloc_live();
        alloc_fail_at(n);
        bat_status status = bat_editor_compact(editor);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            assert_true(n > 20);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_int_equal(alloc_live(), live);
        assert_ptr_equal(bat_editor_journal(editor, &after), text);
        assert_int_equal(after, size);
    }
    bat_editor_free(replay_of(editor, 0));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wild_sessions),
        cmocka_unit_test(long_sessions_become_short),
        cmocka_unit_test(not_in_the_middle_of_a_stroke),
        cmocka_unit_test(no_memory_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
