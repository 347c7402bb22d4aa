/* A program written for 0.1 means the same with 0.2: the old names, and the pointer's arguments in either order. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/batten.h>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

static const double POINTS[] = {0, 0, 10, 0, 10, 10, 0, 10};

static void names_of_0_1_ask_the_same(void **state) {
    (void)state;
    bat_curve *curve = NULL, *same = NULL;
    bat_object *object = NULL;
    bat_document *document = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, POINTS, &curve), BAT_OK);
    assert_int_equal(bat_curve_copy(curve, &same), BAT_OK);
    assert_false(bat_curve_closed(curve));
    assert_true(bat_curve_equal(curve, same));
    bat_curve_free(same);
    bat_curve *curves[] = {curve};
    const bat_style style = bat_style_defaults();
    assert_int_equal(bat_object_create_path(1, "", &style, 1, curves, &object), BAT_OK);
    assert_false(bat_object_hidden(object) || bat_object_locked(object));
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_put(document, 0, object), BAT_OK);
    assert_int_equal(bat_document_count(document), 1);
    bat_object_release(object);
    bat_document_free(document);
}

/* What a stroke leaves in an editor that is told of it in one order or the other. */
static int drawn(bool before) {
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 400, 300, 1);
    bat_pointer events[40];
    for (int i = 0; i < 40; i++)
        events[i] = (bat_pointer){.phase = i == 0    ? BAT_POINTER_DOWN
                                           : i == 39 ? BAT_POINTER_UP
                                                     : BAT_POINTER_MOVE,
                                  .device = BAT_DEVICE_PEN,
                                  .buttons = i < 39,
                                  .x = 50 + 5 * i,
                                  .y = 100,
                                  .pressure = 0.5,
                                  .time = 10 * i};
    const bat_pointer *same = events;
    if (before)
        bat_editor_pointer(editor, events, 20), bat_editor_pointer(editor, same + 20, 20);
    else
        bat_editor_pointer(editor, 20, events), bat_editor_pointer(editor, 20, same + 20);
    bat_editor_frame(editor);
    const int count = bat_document_count(bat_editor_document(editor));
    bat_editor_free(editor);
    return count;
}

static void events_come_in_either_order(void **state) {
    (void)state;
    assert_int_equal(drawn(false), 1);
    assert_int_equal(drawn(true), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(names_of_0_1_ask_the_same),
                                       cmocka_unit_test(events_come_in_either_order)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
