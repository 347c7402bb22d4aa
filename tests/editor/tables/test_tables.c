/* The tables: complete, consistent, and JSON that a shell can read. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tables/keys.h"
#include "text/json.h"
#include "support/pen.h"

static void names_differ_and_defaults_fit(void **state) {
    (void)state;
    for (int i = 0; i < BAT_COMMAND_COUNT; i++) {
        const bat_command_row *row = bat_command_at((bat_command_id)i);
        assert_int_equal(bat_command_named(row->name), i);
        assert_true(bat_keys_valid(row->keys));
        /* sections are runs of commands: each word comes up once */
        bat_string word = bat_command_section((bat_command_id)i);
        assert_memory_equal(bat_string_key(word), "shell.", 6);
        for (int j = 0; i && word != bat_command_section((bat_command_id)(i - 1)) && j < i; j++)
            assert_int_not_equal(bat_command_section((bat_command_id)j), word);
    }
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++) {
        const bat_property_row *row = bat_property_at((bat_property_id)i);
        assert_int_equal(bat_property_named(row->name), i);
        assert_true(row->low <= row->standard && row->standard <= row->high && row->step > 0);
    }
    for (int i = 0; i < BAT_STRING_COUNT; i++) {
        assert_true(strlen(bat_string_english((bat_string)i)) > 0);
        for (int j = 0; j < i; j++)
            assert_string_not_equal(bat_string_key((bat_string)i), bat_string_key((bat_string)j));
    }
    assert_int_equal(bat_command_named("nonsense"), BAT_COMMAND_COUNT);
    assert_int_equal(bat_command_named(NULL), BAT_COMMAND_COUNT);
}

/* No two commands answer to the same key, but that those of tools go before those of the view. */
static void shortcuts_do_not_clash(void **state) {
    (void)state;
    static const char *const keys[] = {
        "a",         "b",         "c",          "d",       "e",         "f",     "g",      "h",
        "i",         "j",         "k",          "l",       "m",         "n",     "o",      "p",
        "q",         "r",         "s",          "t",       "u",         "v",     "w",      "x",
        "y",         "z",         "0",          "1",       "2",         "3",     "+",      "-",
        "=",         "[",         "]",          "?",       " ",         "Enter", "Escape", "Delete",
        "Backspace", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Tab"};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        for (uint32_t modifiers = 0; modifiers < 8; modifiers++) {
            int answers = 0;
            for (int i = 0; i < BAT_COMMAND_COUNT; i++)
                answers += bat_keys_match(bat_command_at((bat_command_id)i)->keys, keys[k], modifiers) &&
                           /* these find nothing to do where the other means something */
                           !(i >= BAT_COMMAND_NUDGE_LEFT && i <= BAT_COMMAND_NUDGE_DOWN) &&
                           i != BAT_COMMAND_POINT_DELETE && i != BAT_COMMAND_GUIDE_DELETE &&
                           i != BAT_COMMAND_PLACE && i != BAT_COMMAND_TEXT_EDIT &&
                           i != BAT_COMMAND_READING_NEXT && i != BAT_COMMAND_READING_PREVIOUS &&
                           i != BAT_COMMAND_LEVEL_DOWN && i != BAT_COMMAND_LEVEL_UP &&
                           i != BAT_COMMAND_DRAW_ON_PAGE && i != BAT_COMMAND_LOOK_NEXT &&
                           i != BAT_COMMAND_REACH_DOWN && i != BAT_COMMAND_REACH_UP &&
                           !(i >= BAT_COMMAND_GAZE_NEXT && i <= BAT_COMMAND_GAZE_ALONG);
            assert_true(answers <= 1);
        }
}

static void json_is_complete(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const char *text = bat_editor_tables(editor);
    bat_json json;
    assert_int_equal(bat_json_parse(text, strlen(text), &json, NULL), BAT_OK);
    assert_int_equal(bat_json_count(&json, bat_json_member(&json, 1, "commands")), BAT_COMMAND_COUNT);
    assert_int_equal(bat_json_count(&json, bat_json_member(&json, 1, "properties")), BAT_PROPERTY_COUNT);
    assert_int_equal(bat_json_count(&json, bat_json_member(&json, 1, "tools")), BAT_TOOL_COUNT);
    uint32_t strings = bat_json_member(&json, 1, "strings");
    for (int i = 0; i < BAT_STRING_COUNT; i++) {
        const char *found = bat_json_text(&json,
                                          bat_json_member(&json, strings, bat_string_key((bat_string)i)));
        assert_string_equal(found, bat_string_english((bat_string)i));
    }
    /* every command and property of the JSON is one that the engine takes */
    uint32_t node = bat_json_first(&json, bat_json_member(&json, 1, "properties"));
    for (; node; node = json.nodes[node].next) {
        double standard = json.nodes[bat_json_member(&json, node, "default")].value.number, value = -1;
        const char *name = bat_json_text(&json, bat_json_member(&json, node, "name"));
        assert_int_equal(bat_editor_get(editor, name, &value), BAT_OK);
        assert_true(value == standard);
    }
    node = bat_json_first(&json, bat_json_member(&json, 1, "commands"));
    for (; node; node = json.nodes[node].next) {
        const char *name = bat_json_text(&json, bat_json_member(&json, node, "name"));
        assert_int_not_equal(bat_editor_command(editor, name), BAT_UNSUPPORTED);
        assert_null(bat_editor_check(editor));
    }
    bat_json_free(&json);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_differ_and_defaults_fit),
        cmocka_unit_test(shortcuts_do_not_clash),
        cmocka_unit_test(json_is_complete),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
