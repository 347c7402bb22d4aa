/* Commands that cut, mend and simplify the selected curves. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/edit/curves_of.h"
#include "support/selecting.h"
#include <batten/refine.h>

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

/* The selected curves with fewer points, one step; a second time there is nothing left to do. */
static void simplify(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE); /* nothing is selected */
    bat_curve *finer = NULL, *old = NULL;
    double knots[40], domain[2];
    bat_curve_copy(curve(editor, 1), &old);
    bat_curve_domain(old, domain);
    for (int i = 0; i < 40; i++) knots[i] = domain[0] + (domain[1] - domain[0]) * (i + 0.5) / 40;
    assert_int_equal(bat_curve_insert_knots(old, 40, knots, &finer), BAT_OK);
    assert_int_equal(bat_transaction_begin(&editor->context), BAT_OK);
    assert_int_equal(bat_put_curve(&editor->context, 1, 0, finer), BAT_OK);
    assert_int_equal(bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL), BAT_OK);
    const size_t many = bat_curve_count(curve(editor, 1));
    uint64_t before = digest(editor);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    assert_true(bat_curve_count(curve(editor, 1)) + 38 <= many);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Simplified: "));
    double there, back;
    assert_int_equal(bat_curve_distance(old, curve(editor, 1), 20, &there, &back), BAT_OK);
    assert_true(fmax(there, back) <= 1.001);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    bat_editor_command(editor, "redo");
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    bat_curve_free(old);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_are_cut_and_mended),
        cmocka_unit_test(simplify),
    };
    return cmocka_run_group_tests_name("cut and mend", tests, NULL, NULL);
}
