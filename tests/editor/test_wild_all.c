/* label: slow. Long random sessions with everything that the editor can do, including every command and property of the
 * tables: the invariants hold after every event, the journal replays to the same drawing and the same journal, undo
 * leads back to the first drawing and redo to the last. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/wild.h"
#include <batten/base.h>
#include <batten/document.h>
#include <batten/editor.h>
#include "support/editing.h"

static void wild_sessions(void **state) {
    (void)state;
    enum { SIZE = 3600, SESSIONS = 40 };
    static uint8_t data[SIZE];
    int undone = 0, shapes = 0, images = 0, guides = 0, surfaces = 0;
    for (uint64_t seed = 1; seed <= SESSIONS; seed++) {
        session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed * 31337});
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        double time = 0;
        while (bytes.at < bytes.size) {
            size_t at = bytes.at;
            wild_event(editor, &bytes, &time);
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, at, wrong);
        }
        wild_settle(editor);
        size_t size = 0, size_again = 0;
        const char *text = bat_editor_journal(editor, &size);
        shapes += strstr(text, "\"kind\":\"shape\"") != NULL;
        images += strstr(text, "\"kind\":\"image\"") != NULL;
        guides += strstr(text, "\"kind\":\"guide\"") != NULL;
        surfaces += strstr(text, "\"kind\":\"surface\"") != NULL;
        bat_editor *again = replay_of(editor, seed);
        const char *text_again = bat_editor_journal(again, &size_again);
        assert_true(size == size_again && !memcmp(text, text_again, size));
        bat_editor_free(again);

        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        uint64_t top = digest(editor);
        int steps = 0;
        for (; bat_editor_command(editor, "undo") == BAT_OK; steps++) assert_null(bat_editor_check(editor));
        if (steps < 250) assert_true(digest(editor) == first); /* as many as a journal made short keeps */
        while (bat_editor_command(editor, "redo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == top);
        undone += steps;
        bat_editor_free(editor);
    }
    /* Sessions that do something, of every kind. */
    if (undone < 20 * SESSIONS || shapes < 3 || images < SESSIONS / 4 || guides < SESSIONS / 4 ||
        surfaces < SESSIONS / 4)
        fail_msg("%d steps; sessions with levels %d, pictures %d, guides %d, surfaces %d", undone, shapes,
                 images, guides, surfaces);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(wild_sessions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
