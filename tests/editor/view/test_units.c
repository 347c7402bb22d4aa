/* Lengths and angles with their units, read and written. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"

static void units_are_read_and_written(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    static const struct {
        const char *text;
        double unit, value; /* px */
    } good[] = {{"12", 0, 12},
                {"12mm", 0, 12 * 96 / 25.4},
                {" 1in + 3 mm ", 0, 96 + 3 * 96 / 25.4},
                {"25.4", 1, 96},
                {"2", 2, 192},
                {"(2+3)*4,5", 0, 22.5},
                {"-.5cm", 0, -48 / 2.54},
                {"3 * 1in / 2", 1, 144},
                {"1in/1px", 0, 96},
                {"72pt", 2, 96},
                {"1\"", 1, 96},
                {"--4", 0, 4},
                {"1/4in", 0, 24},
                {"1in - 1/4in", 1, 72},
                {"10mm - 1", 1, 9 * 96 / 25.4},
                {"+4", 0, 4},
                {"\t5px\t", 0, 5},
                {"-+-4", 0, 4},
                {"1in*3", 0, 288},
                {"1 + 1in", 0, 97}};
    static const char *const bad[] = {"",
                                      " ",
                                      "mm",
                                      "1 2",
                                      "2mm*3mm",
                                      "1+",
                                      "(1",
                                      "1)",
                                      "1e5",
                                      "x",
                                      "1..2",
                                      "1/",
                                      "((((((((((((((((((((1))))))))))))))))))))",
                                      "0x10",
                                      "nan",
                                      "inf"};
    double value = 7;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        bat_editor_set(editor, "unit", good[i].unit);
        if (bat_unit_read(&editor->context, good[i].text, false, &value) != BAT_OK ||
            !(fabs(value - good[i].value) <= 1e-12 * (1 + fabs(value))))
            fail_msg("\"%s\" is %.17g", good[i].text, value);
    }
    value = 7;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        if (bat_unit_read(&editor->context, bad[i], false, &value) != BAT_SYNTAX)
            fail_msg("\"%s\" is taken", bad[i]);
        assert_true(value == 7);
    }
    assert_int_equal(bat_unit_read(&editor->context, "1/0", false, &value), BAT_NUMBER);
    assert_int_equal(bat_unit_read(&editor->context, "30°", true, &value), BAT_OK);
    assert_true(value == 30);
    assert_int_equal(bat_unit_read(&editor->context, "30mm", true, &value), BAT_SYNTAX);
    char text[BAT_UNIT_ROOM];
    static const char *const written[] = {"96 px", "25.4 mm", "1 in"};
    for (int i = 0; i < 3; i++) {
        bat_editor_set(editor, "unit", i);
        bat_unit_write(&editor->context, 96, text);
        assert_string_equal(text, written[i]);
    }
    /* What is written reads back to within its last digit. */
    for (int i = 0; i < 200; i++) {
        double length = (i - 100) * 1.2345;
        bat_unit_write(&editor->context, length, text);
        assert_int_equal(bat_unit_read(&editor->context, text, false, &value), BAT_OK);
        assert_true(fabs(value - length) <= 0.0005001 * 96);
    }
    bat_unit_number(-0.0001, text);
    assert_string_equal(text, "0");
    bat_unit_number(1e300, text);
    assert_true(strlen(text) < BAT_UNIT_ROOM);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_are_read_and_written),
    };
    return cmocka_run_group_tests_name("units", tests, NULL, NULL);
}
