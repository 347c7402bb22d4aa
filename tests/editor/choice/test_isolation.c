/* Isolation: the tools act as if the isolated objects were the only ones; outline mode draws thin lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/precision.h"

static void isolated_is_all_there_is(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_command(editor, "isolate"), BAT_STATE); /* nothing is meant */
    pen_event(&p, BAT_POINTER_DOWN, 500, 200);
    pen_event(&p, BAT_POINTER_UP, 500, 200);
    assert_true(bat_editor_key(editor, "I", true, BAT_SHIFT, p.time));
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->still[1].opacity == 1 && frame->still[2].opacity < 0.5F);
    bat_editor_command(editor, "select-all");
    assert_int_equal(editor->choice.selection.count, 1);
    drag(&p, 500, 600, 540, 640); /* nothing is there to take hold of */
    assert_true(digest(editor) == first);
    drag(&p, 100, 500, 900, 700);
    assert_int_equal(editor->choice.selection.count, 0);
    assert_int_equal(snap(editor, 201, 601).kind, BAT_SNAP_END); /* but to snap to */
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 300, 400, 700, 400, 10); /* what is drawn meanwhile is within reach */
    frame = bat_editor_frame(editor);
    assert_true(frame->still[3].opacity == 1);
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    frame = bat_editor_frame(editor);
    assert_true(frame->still[2].opacity == 1);
    assert_true(frame->dirty[0] < -1e6F); /* all of it is painted anew */
    bat_editor_command(editor, "tool-select");
    drag(&p, 500, 600, 540, 640);
    assert_int_equal(editor->choice.selection.count, 1);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void outlines_are_thin(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    uint32_t version = bat_editor_frame(editor)->still[1].version;
    bat_editor_set(editor, "filled", 1);
    bat_editor_command(editor, "outline");
    const bat_frame *frame = bat_editor_frame(editor);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(frame->still[i].flags, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH);
        assert_true(frame->still[i].width == 1 && frame->still[i].opacity == 1);
    }
    assert_int_equal(frame->still[1].version, version); /* the same path */
    bat_editor_command(editor, "outline");
    frame = bat_editor_frame(editor);
    assert_true(frame->still[1].width == 2 && !(frame->still[1].flags & BAT_ITEM_SCREEN_WIDTH));
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isolated_is_all_there_is),
        cmocka_unit_test(outlines_are_thin),
    };
    return cmocka_run_group_tests_name("isolation", tests, NULL, NULL);
}
