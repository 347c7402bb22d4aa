/* A read-only document: whatever pens, keys and commands do, it stays unchanged, and the user is told. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/session.h"
#include <batten/editor.h>
#include "support/editing.h"

static size_t journal_size(const bat_editor *editor) {
    size_t size = 0;
    bat_editor_journal(editor, &size);
    return size;
}

static void wild_sessions_change_nothing(void **state) {
    (void)state;
    enum { SIZE = 1500 };
    static uint8_t data[SIZE];
    uint64_t random = 7;
    for (int session = 0; session < 6; session++) {
        session_bytes bytes = session_random(data, SIZE, &random);
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        size_t written = journal_size(editor);
        double time = 0;
        bat_editor_set_read_only(editor, true);
        while (bytes.at < bytes.size) {
            session_event(editor, &bytes, &time);
            assert_null(bat_editor_check(editor));
        }
        bat_editor_command(editor, "cancel");
        bat_editor_command(editor, "cancel");
        assert_true(digest(editor) == first);
        assert_int_equal(journal_size(editor), written);
        assert_false(bat_editor_frame(editor)->unsaved);
        bat_editor_free(editor);
    }
}

static void a_pen_moves_the_view(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){100, 100, 200, 120, 10}, 20);
    bat_editor_set_read_only(editor, true); /* in the middle of a stroke: it is dropped */
    pen_event(&p, BAT_POINTER_UP, 200, 120);
    size_t written = journal_size(editor);
    bat_frame before = *bat_editor_frame(editor);
    assert_int_equal(before.busy, 0);
    assert_int_equal(before.cursor, BAT_CURSOR_GRAB);
    assert_string_equal(before.hint, "Drag to look around; the drawing is open elsewhere");
    pen_event(&p, BAT_POINTER_DOWN, 300, 200);
    pen_event(&p, BAT_POINTER_MOVE, 340, 180);
    pen_event(&p, BAT_POINTER_UP, 340, 180);
    const bat_frame *after = bat_editor_frame(editor);
    assert_true(fabs(after->view[0] - (before.view[0] - 40 / before.view[2])) < 1e-9);
    assert_true(fabs(after->view[1] - (before.view[1] + 20 / before.view[2])) < 1e-9);
    assert_int_equal(journal_size(editor), written);
    bat_editor_free(editor);
}

static void what_would_change_something_says_why_not(void **state) {
    (void)state;
    static const char *const commands[] = {"delete", "duplicate", "nudge-left", "layer-add",
                                           "undo",   "redo",      "save"};
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_true(bat_editor_frame(editor)->selected > 0);
    assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
    uint64_t first = digest(editor);
    bat_editor_set_read_only(editor, true);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        uint32_t version = bat_editor_frame(editor)->notice_version;
        bat_editor_command(editor, commands[i]);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_true(frame->notice_version > version);
        assert_string_equal(frame->notice, "This drawing can only be looked at here");
        assert_int_equal(frame->requests & BAT_ASK_SAVE, 0);
        assert_true(digest(editor) == first);
    }
    /* A copy may leave, and it may be edited again. */
    bat_editor_command(editor, "download-svg");
    assert_int_equal(bat_editor_frame(editor)->requests & BAT_ASK_DOWNLOAD_SVG, BAT_ASK_DOWNLOAD_SVG);
    bat_editor_set_read_only(editor, false);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) != first);
    bat_editor_free(editor);
}

static void the_host_replays(void **state) {
    (void)state;
    bat_editor *editor = pen_editor(), *other = pen_editor();
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
    size_t size = 0;
    const char *journal = bat_editor_journal(editor, &size);
    bat_editor_set_read_only(other, true);
    assert_int_equal(bat_editor_replay(other, journal, size, true, NULL), BAT_OK);
    assert_true(digest(other) == digest(editor));
    assert_int_equal(bat_editor_command(other, "undo"), BAT_STATE);
    bat_editor_free(editor);
    bat_editor_free(other);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wild_sessions_change_nothing),
        cmocka_unit_test(a_pen_moves_the_view),
        cmocka_unit_test(what_would_change_something_says_why_not),
        cmocka_unit_test(the_host_replays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
