/* Rulers show the position of the window. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/show/ruler.h"
#include "support/editing.h"

/* Every label of the rulers stands at its own place, whatever zoom and unit; turned, there are none. */
static void rulers_tell_places(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    bat_editor_command(editor, "show-rulers");
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 5}), 1);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){5, 300}), 0);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){5, 5}), -1);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 300}), -1);
    for (int unit = 0; unit < 3; unit++)
        for (int k = 0; k < 40; k++) {
            bat_editor_set(editor, "unit", unit);
            bat_view_zoom(&editor->stage.view, (double[]){200, 300}, k < 20 ? 0.7 : 1.9);
            const bat_frame *frame = bat_editor_frame(editor);
            int labels = 0;
            for (uint32_t i = 0; i < frame->label_count; i++) {
                const bat_label *label = &frame->labels[i];
                if (label->role != BAT_ROLE_RULER) continue;
                labels++;
                int axis = label->turn != 0;
                double place = (frame->origin[axis] + (double)label->at[axis]) /
                               bat_unit_size(&editor->context);
                double pixel = 1 / (editor->stage.view.zoom * bat_unit_size(&editor->context));
                assert_true(fabs(strtod(label->text, NULL) - place) <= fmax(0.6 * pixel, 0.000501));
            }
            assert_true(labels >= 8 && labels < 40);
        }
    bat_editor_command(editor, "view-left");
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 5}), -1);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_RULER));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rulers_tell_places),
    };
    return cmocka_run_group_tests_name("rulers", tests, NULL, NULL);
}
