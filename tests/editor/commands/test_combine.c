/* One object of several curves, and several of one; mirrors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static void combined_and_released_is_what_it_was(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    const uint64_t first = digest(editor);
    bat_curve *old[2];
    for (int i = 0; i < 2; i++)
        assert_int_equal(bat_curve_copy(curve(editor, (bat_id)i + 1), &old[i]), BAT_OK);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "combine"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "release"), BAT_STATE);
    only(editor, 2, 1);
    assert_int_equal(bat_editor_command(editor, "combine"), BAT_OK);
    assert_string_equal(order(editor), "1");
    assert_int_equal(bat_object_curve_count(object(editor, 1)), 2);
    assert_true(bat_object_style(object(editor, 1))->even_odd);
    assert_true(has(editor, 1) && selected(editor) == 1);
    for (int i = 0; i < 2; i++)
        assert_true(bat_curve_is_equal(bat_object_curve(object(editor, 1), i), old[i]));
    assert_int_equal(bat_editor_command(editor, "release"), BAT_OK);
    assert_string_equal(order(editor), "1 3");
    assert_int_equal(selected(editor), 2);
    assert_true(bat_curve_is_equal(curve(editor, 1), old[0]) && bat_curve_is_equal(curve(editor, 3), old[1]));
    goes_back_and_replays(editor, first);
    for (int i = 0; i < 2; i++) bat_curve_free(old[i]);
    bat_editor_free(editor);
}

static void levels_stay(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    only(editor, 1, 0);
    bat_editor_command(editor, "tool-levels");
    assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK);
    bat_editor_command(editor, "tool-select");
    const bat_shape *shape = bat_object_shape(object(editor, 1), 0);
    assert_non_null(shape);
    const int levels = bat_shape_levels(shape);
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "combine"), BAT_OK);
    assert_non_null(bat_object_shape(object(editor, 1), 0));
    assert_null(bat_object_shape(object(editor, 1), 1));
    assert_int_equal(bat_editor_command(editor, "release"), BAT_OK);
    assert_int_equal(bat_shape_levels(bat_object_shape(object(editor, 1), 0)), levels);
    assert_null(bat_object_shape(object(editor, 3), 0));
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

static void expect_image(const bat_curve *now, const bat_curve *old, const double m[6]) {
    for (size_t i = 0; i < bat_curve_count(old); i++) {
        const double *p = bat_curve_points(old) + 2 * i, *q = bat_curve_points(now) + 2 * i;
        for (int k = 0; k < 2; k++)
            assert_true(fabs(m[k] * p[0] + m[2 + k] * p[1] + m[4 + k] - q[k]) <= 1e-9);
    }
}

static void mirrors(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    bat_curve *old;
    const uint64_t first = digest(editor);
    assert_int_equal(bat_curve_copy(curve(editor, 1), &old), BAT_OK);
    bat_editor_select(editor, 1, false);
    assert_int_equal(bat_editor_command(editor, "deselect"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "mirror-across"), BAT_STATE);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "mirror-across"), BAT_OK);
    expect_image(curve(editor, 1), old, (double[]){-1, 0, 0, 1, 1000, 0});
    assert_int_equal(bat_editor_command(editor, "mirror-across"), BAT_OK);
    expect_image(curve(editor, 1), old, (double[]){1, 0, 0, 1, 0, 0});
    assert_int_equal(bat_editor_command(editor, "mirror-down"), BAT_OK);
    expect_image(curve(editor, 1), old, (double[]){1, 0, 0, -1, 0, 400});
    only(editor, 1, 2); /* both change places */
    assert_int_equal(bat_editor_command(editor, "mirror-down"), BAT_OK);
    expect_image(curve(editor, 1), old, (double[]){1, 0, 0, 1, 0, 400});
    /* about the other line */
    only(editor, 2, 0);
    assert_int_equal(bat_editor_command(editor, "symmetry-axis"), BAT_OK);
    bat_editor_set(editor, "symmetry", 0);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "mirror-axis"), BAT_OK);
    expect_image(curve(editor, 1), old, (double[]){1, 0, 0, -1, 0, 0});
    /* a negative width mirrors in place */
    const double m[6] = {-0.5, 0, 0, -1, 700 - 200 * 0.5, 0};
    double box[4];
    box_of(editor, 1, box);
    assert_int_equal(bat_editor_enter(editor, "width", "-300"), BAT_OK);
    expect_box(editor, 1, box[0], box[1], box[0] + 300, box[3]);
    expect_image(curve(editor, 1), old, m);
    assert_int_not_equal(bat_editor_enter(editor, "width", "0"), BAT_OK);
    goes_back_and_replays(editor, first);
    bat_curve_free(old);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(combined_and_released_is_what_it_was),
        cmocka_unit_test(levels_stay),
        cmocka_unit_test(mirrors),
    };
    return cmocka_run_group_tests_name("combine", tests, NULL, NULL);
}
