/* The pressure curve in closed form, and its effect on eraser and brush. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/pen.h"
#include <batten/editor.h>

static void the_curve(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    for (double gamma = 0.2; gamma <= 5; gamma += 0.4) {
        assert_int_equal(bat_editor_set(editor, "pressure-curve", gamma), BAT_OK);
        double before = 0;
        for (int i = 0; i <= 100; i++) {
            double share = bat_editor_pressure(editor, i / 100.0);
            assert_true(fabs(share - (0.25 + 0.75 * pow(i / 100.0, gamma))) < 1e-12);
            assert_true(share >= before);
            before = share;
        }
        assert_true(before == 1);
    }
    assert_true(bat_editor_pressure(editor, -3) == 0.25 && bat_editor_pressure(editor, INFINITY) == 1);
    assert_true(bat_editor_pressure(editor, NAN) == 1);
    bat_editor_set(editor, "pressure", 0);
    for (int i = 0; i <= 10; i++) assert_true(bat_editor_pressure(editor, i / 10.0) == 1);
    bat_editor_free(editor);
}

static void event(bat_editor *editor, bat_device device, bat_pointer_phase phase, double x, double y,
                  double pressure) {
    bat_pointer one = {.phase = phase,
                       .device = device,
                       .contact = 1,
                       .buttons = phase == BAT_POINTER_DOWN || phase == BAT_POINTER_MOVE,
                       .x = x,
                       .y = y,
                       .pressure = pressure};
    bat_editor_pointer(editor, 1, &one);
    assert_null(bat_editor_check(editor));
}

/* Radius of the circle shown, in pixels; one unit is one. */
static double reach(bat_editor *editor) {
    const bat_item *circle = pen_live(bat_editor_frame(editor), BAT_ROLE_REACH);
    assert_non_null(circle);
    return (double)(circle->bounds[2] - circle->bounds[0]) / 2;
}

/* The length that a straight rub right across the line y = 200 leaves of it: 600 less a chord of the reach. */
static double erased(bat_device device, double pressure, bool on) {
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "eraser-size", 100);
    bat_editor_set(editor, "pressure", on);
    bat_editor_command(editor, "tool-eraser");
    event(editor, device, BAT_POINTER_DOWN, 500, 200, pressure);
    double seen = reach(editor);
    event(editor, device, BAT_POINTER_UP, 500, 200, 0);
    const bat_document *document = bat_editor_document(editor);
    assert_int_equal(bat_document_count(document), 3);
    double left[4], gap = INFINITY;
    for (int i = 0; i < 3; i++) { /* from 500 to the nearest end of what is left */
        bat_object_bounds(bat_document_at(document, i), left);
        if (left[1] < 300) gap = fmin(gap, fmin(fabs(left[0] - 500), fabs(left[2] - 500)));
    }
    assert_true(fabs(gap - seen) < 1);
    bat_editor_free(editor);
    return gap;
}

static void harder_reaches_further(void **state) {
    (void)state;
    assert_true(fabs(erased(BAT_DEVICE_PEN, 0, true) - 25) < 0.5);
    assert_true(fabs(erased(BAT_DEVICE_PEN, 0.5, true) - 62.5) < 0.5);
    assert_true(fabs(erased(BAT_DEVICE_PEN, 1, true) - 100) < 0.5);
    for (int i = 0; i <= 4; i++) { /* switched off, or without a pen: always all of it */
        assert_true(fabs(erased(BAT_DEVICE_PEN, i / 4.0, false) - 100) < 0.5);
        assert_true(fabs(erased(BAT_DEVICE_MOUSE, i / 4.0, true) - 100) < 0.5);
        assert_true(fabs(erased(BAT_DEVICE_TOUCH, i / 4.0, true) - 100) < 0.5);
    }
}

/* The brush finds what was lit under the hovering pen, however light the tap; a firm one smooths more of it. */
static void the_brush_finds_what_was_lit(void **state) {
    (void)state;
    double lengths[2];
    for (int firm = 0; firm < 2; firm++) {
        bat_editor *editor = pen_editor();
        bat_editor_command(editor, "tool-smooth");
        event(editor, BAT_DEVICE_PEN, BAT_POINTER_HOVER, 500, 230,
              0); /* 30 px beside; all of the reach is 40 */
        assert_true(fabs(reach(editor) - 40) < 0.7);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_STRETCH));
        event(editor, BAT_DEVICE_PEN, BAT_POINTER_DOWN, 500, 230, firm ? 1 : 0.02);
        const bat_item *lit = pen_live(bat_editor_frame(editor), BAT_ROLE_STRETCH);
        assert_non_null(lit);
        lengths[firm] = (double)(lit->bounds[2] - lit->bounds[0]);
        event(editor, BAT_DEVICE_PEN, BAT_POINTER_CANCEL, 500, 230, 0);
        bat_editor_free(editor);
    }
    assert_true(lengths[0] > 0 && lengths[1] > 2 * lengths[0]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curve),
        cmocka_unit_test(harder_reaches_further),
        cmocka_unit_test(the_brush_finds_what_was_lit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
