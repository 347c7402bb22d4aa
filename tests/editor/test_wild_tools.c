/* Random sessions with the points tool, the smooth brush and the eraser: invariants after every event, undo to the
 * first document, and a journal that replays to the same. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/session.h"
#include <batten/base.h>
#include <batten/document.h>
#include <batten/editor.h>
#include "support/editing.h"

static void wild_tools(void **state) {
    (void)state;
    static const char *const commands[] = {"tool-points",   "tool-smooth", "tool-eraser", "corner-make",
                                           "corner-smooth", "knot-next",   "point-add",   "point-delete",
                                           "point-next",    "nudge-left",  "calm",        "show-comb",
                                           "show-knots",    "show-length", "tool-points", "undo"};
    enum { SIZE = 1200 };
    static uint8_t data[SIZE];
    int steps = 0;
    for (uint64_t seed = 1; seed <= 80; seed++) {
        session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed * 77777});
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        double time = 0;
        bat_editor_command(editor, commands[seed % 3]);
        while (bytes.at < bytes.size) {
            if (session_byte(&bytes) < 100) {
                bat_editor_command(editor, commands[session_byte(&bytes) % 16]);
                bat_editor_frame(editor);
            }
            session_event(editor, &bytes, &time);
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, bytes.at, wrong);
        }
        bat_editor_command(editor, "cancel");
        bat_editor_command(editor, "cancel");
        size_t size = 0;
        const char *text = bat_editor_journal(editor, &size);
        for (const char *at = text; (at = strstr(at, "\"do\":\"change\"")); at++) steps++;
        replays(editor, seed);
        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        uint64_t top = digest(editor);
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == first);
        while (bat_editor_command(editor, "redo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == top);
        bat_editor_free(editor);
    }
    if (steps < 60) fail_msg("only %d steps: these sessions do nothing", steps);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(wild_tools)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
