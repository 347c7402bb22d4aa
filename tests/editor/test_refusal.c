/* A command, a property, a number or keys that are refused say which, what was expected and what was found; what is done says nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/editor.h>

static bat_status command(bat_editor *editor, const char *name, const char *value) {
    (void)value;
    return bat_editor_command(editor, name);
}

static bat_status set(bat_editor *editor, const char *name, const char *value) {
    return bat_editor_set(editor, name, strtod(value, NULL));
}

static const struct {
    bat_status (*call)(bat_editor *editor, const char *name, const char *value);
    const char *name, *value, *place, *message;
    bat_status status;
} calls[] = {
    {command, "undoo", "", "name", "expected a command of the table, found \"undoo\"", BAT_UNSUPPORTED},
    {command, NULL, "", "name", "expected a command of the table, found \"\"", BAT_UNSUPPORTED},
    {command, "undo", "", "undo", "it is not possible now", BAT_STATE},
    {set, "opacity", "2", "opacity", "expected 0 to 1, found 2", BAT_ARGUMENT},
    {set, "opacity", "nan", "opacity", "expected 0 to 1, found no number", BAT_NUMBER},
    {set, "language", "0.5", "language", "expected a whole number, found 0.5", BAT_ARGUMENT},
    {set, "opacitee", "1", "property", "expected a property of the table, found \"opacitee\"",
     BAT_UNSUPPORTED},
    {bat_editor_enter, "opacity", "x+", "opacity",
     "expected a number or an expression in its range, found \"x+\"", BAT_SYNTAX},
    {bat_editor_enter, "opacitee", "1", "name", "expected a number of the tables, found \"opacitee\"",
     BAT_UNSUPPORTED},
    {bat_editor_bind, "undoo", "Ctrl+Z", "command", "expected a command of the table, found \"undoo\"",
     BAT_UNSUPPORTED},
    {bat_editor_bind, "undo", "\\", "keys", "expected keys such as \"Ctrl+Shift+Z Ctrl+Y\", found \"\\\"",
     BAT_ARGUMENT},
};

static void what_is_refused_says_why(void **state) {
    (void)state;
    bat_editor *editor;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    const bat_problem *problem = bat_editor_problem(editor);
    assert_string_equal(problem->message, "");
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        assert_int_equal(calls[i].call(editor, calls[i].name, calls[i].value), calls[i].status);
        assert_string_equal(problem->message, calls[i].message);
        assert_string_equal(problem->place, calls[i].place);
        assert_int_equal(bat_editor_set(editor, "opacity", 1), BAT_OK);
        assert_string_equal(problem->message, "");
    }
    bat_problem of_text = {"", ""};
    assert_int_equal(bat_editor_write(editor, "{\"id\":7}", 8, &of_text), BAT_ARGUMENT);
    assert_string_equal(of_text.message, "id: expected that of a text, found number 7");
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_refused_says_why)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
