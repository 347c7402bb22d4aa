/* Commands that cut and mend the selected curves. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static void curves_are_cut_and_mended(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    double at[2], domain[2];
    bat_curve *old = NULL;
    bat_curve_copy(curve(editor, 1), &old);
    /* reverse */
    only(editor, 1, 0);
    bat_editor_command(editor, "curve-reverse");
    bat_curve_domain(curve(editor, 1), domain);
    for (int i = 0; i <= 10; i++) {
        double expected[2], u = i / 10.0;
        bat_curve_eval(old, domain[0] + u * (domain[1] - domain[0]), 0, expected);
        bat_curve_eval(curve(editor, 1), domain[1] - u * (domain[1] - domain[0]), 0, at);
        assert_true(fabs(at[0] - expected[0]) < 1e-9 && fabs(at[1] - expected[1]) < 1e-9);
    }
    bat_editor_command(editor, "undo");
    /* split where it was clicked */
    click(&p, 400, 200, 0);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 3);
    expect_box(editor, 1, 200, 200, 400, 200);
    expect_box(editor, 3, 400, 200, 800, 200);
    /* and joined again: the very same way */
    only(editor, 1, 3);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 2);
    expect_box(editor, 1, 200, 200, 800, 200);
    /* joined to the other line: by a straight one between the nearest ends */
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 1);
    expect_box(editor, 1, 200, 200, 800, 600);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    /* one curve: joining closes it */
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_true(bat_curve_is_closed(curve(editor, 1)));
    expect_box(editor, 1, 200, 200, 800, 600);
    assert_int_equal(bat_editor_command(editor, "curve-close"), BAT_STATE);
    /* a closed curve is opened at the place that was clicked */
    click(&p, 700, 200, 0);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_OK);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    bat_curve_domain(curve(editor, 1), domain);
    for (int k = 0; k < 2; k++) {
        bat_curve_eval(curve(editor, 1), domain[k], 0, at);
        assert_true(fabs(at[0] - 700) < 1e-6 && fabs(at[1] - 200) < 1e-6);
    }
    assert_int_equal(bat_editor_command(editor, "curve-open"), BAT_STATE);
    bat_editor_command(editor, "undo");
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-open"), BAT_OK);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    only(editor, 0, 0);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_STATE);
    goes_back_and_replays(editor, first);
    bat_curve_free(old);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_are_cut_and_mended),
    };
    return cmocka_run_group_tests_name("cut and mend", tests, NULL, NULL);
}
