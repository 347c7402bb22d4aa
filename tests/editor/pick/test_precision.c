/* Snapping, grid, guides, rulers and isolation all on: random sessions, and failing allocations. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tools/modes/guides.h"
#include "support/alloc_fail.h"
#include "support/session.h"
#include "support/precision.h"

/* Random sessions with all of it on: invariants after every event, undo to the first drawing, replay to the last. */
static void wild_precision(void **state) {
    (void)state;
    static const char *const commands[] = {"tool-select",  "tool-points", "tool-tangents", "show-rulers",
                                           "show-grid",    "isolate",     "outline",       "guide-level",
                                           "guide-delete", "snap",        "select-all",    "guide-upright",
                                           "undo",         "tool-select", "delete",        "duplicate"};
    static const char *const names[] = {"x",       "y",       "width", "height", "turn",
                                        "point-x", "point-y", "guide", "snap",   "grid-spacing"};
    static const char *const texts[] = {"12", "3mm+4", "1/2in", "-7", "0", "1e", "90", "400"};
    enum { SIZE = 1200 };
    static uint8_t data[SIZE];
    int with_guides = 0;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed * 99991});
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        double time = 0;
        bat_editor_set(editor, "snap-curves", 1);
        bat_editor_command(editor, "show-rulers");
        while (bytes.at < bytes.size) {
            if (session_byte(&bytes) < 100) {
                bat_editor_command(editor, commands[session_byte(&bytes) % 16]);
                const char *name = names[session_byte(&bytes) % 10];
                bat_editor_enter(editor, name, texts[session_byte(&bytes) % 8]);
                bat_editor_frame(editor);
            }
            session_event(editor, &bytes, &time);
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, bytes.at, wrong);
        }
        for (int i = 0; i < 4; i++) bat_editor_command(editor, "cancel");
        double at;
        with_guides += guides(editor, 0, &at) + guides(editor, 1, &at) > 0;
        replays(editor, 0);
        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
    assert_true(with_guides > 20);
}

/* Without memory nothing changes, whatever of it fails. */
static void without_memory_nothing_changes(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_select(editor, 1, false);
    bat_editor_frame(editor);
    for (int what = 0; what < 4; what++) {
        uint64_t before = digest(editor);
        bat_status status = BAT_MEMORY;
        for (int n = 1; status == BAT_MEMORY; n++) {
            assert_true(n < 200);
            alloc_fail_at(n);
            status = what == 0   ? bat_guide_put(&editor->context, 0, 1, 55)
                     : what == 1 ? bat_editor_enter(editor, "x", "17")
                     : what == 2 ? bat_editor_command(editor, "isolate")
                                 : bat_command_guide_delete(&editor->context, true);
            alloc_fail_reached();
            if (status == BAT_MEMORY) assert_true(digest(editor) == before);
            assert_null(bat_editor_check(editor));
        }
        assert_int_equal(status, BAT_OK);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wild_precision),
        cmocka_unit_test(without_memory_nothing_changes),
    };
    return cmocka_run_group_tests_name("precision", tests, NULL, NULL);
}
