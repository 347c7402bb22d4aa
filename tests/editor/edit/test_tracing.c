/* Pictures to trace in the editor: placed, moved, locked, undone; the journal contains their bytes once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/pictures.h"

static const bat_object *last(const bat_editor *editor) {
    return bat_document_at(bat_editor_document(editor), 0);
}

static bat_status add(bat_editor *editor, uint32_t width, uint32_t height) {
    unsigned char bytes[HEAD_ROOM];
    size_t size = head_png(bytes, width, height);
    return bat_editor_add_picture(editor, bytes, size, "car.png");
}

static int times(const char *text, const char *what) {
    int count = 0;
    for (const char *at = text; (at = strstr(at, what)); at++) count++;
    return count;
}

/* In the middle of an 800 x 600 view, four fifths of it at most; small ones pixel by pixel. */
static void placed_in_the_middle(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    bat_view view = editor->stage.view;
    double box[4], screen[4];
    assert_int_equal(add(editor, 4000, 1000), BAT_OK);
    bat_object_bounds(last(editor), box);
    bat_view_to_screen(&view, box, screen);
    bat_view_to_screen(&view, box + 2, screen + 2);
    assert_true(fabs(screen[0] + screen[2] - view.width) < 1e-9 &&
                fabs(screen[1] + screen[3] - view.height) < 1e-9);
    assert_true(fabs(screen[2] - screen[0] - 0.8 * view.width) < 1e-9);
    assert_true(fabs((screen[2] - screen[0]) - 4 * (screen[3] - screen[1])) < 1e-9);
    assert_int_equal(editor->choice.selection.count, 1);
    assert_int_equal(editor->choice.tool, BAT_TOOL_SELECT);
    assert_int_equal(add(editor, 20, 10), BAT_OK);
    bat_object_bounds(last(editor), box);
    assert_true(fabs((box[2] - box[0]) * view.zoom - 20) < 1e-9);
    const bat_frame *frame = bat_editor_frame(editor);
    uint32_t first = frame->still_count > 2 ? frame->still[0].role == BAT_ROLE_PAGE : 0;
    assert_int_equal(frame->still[first].role, BAT_ROLE_IMAGE);
    assert_int_equal(frame->still[first].path_count, 13);
    assert_non_null(bat_editor_picture(editor, frame->still[first].picture));
    assert_null(bat_editor_picture(editor, frame->still[first].picture ^ 1));
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

/* The journal of the replay is as good as the first. */
static void keeps_the_data(const bat_editor *editor) {
    bat_editor *again = replay_of(editor, 0);
    size_t size, size_again;
    const char *journal = bat_editor_journal(editor, &size);
    const char *journal_again = bat_editor_journal(again, &size_again);
    assert_int_equal(times(journal, "\"data\""), times(journal_again, "\"data\""));
    bat_editor_free(again);
}

static void moved_undone_and_replayed(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    uint64_t fresh = digest(editor);
    double before[4], after[4];
    bat_editor_resize(editor, 800, 600, 1);
    assert_int_equal(add(editor, 200, 100), BAT_OK);
    uint64_t placed = digest(editor);
    bat_object_bounds(last(editor), before);
    drag(&p, 400, 300, 430, 340);
    bat_object_bounds(last(editor), after);
    double pixel = bat_view_pixel(&editor->stage.view);
    assert_true(fabs(after[0] - before[0] - 30 * pixel) < 1e-9 &&
                fabs(after[1] - before[1] - 40 * pixel) < 1e-9);
    uint64_t moved = digest(editor);
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == moved);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == placed);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == fresh);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == placed);
    /* The same file again: its bytes are there already. */
    assert_int_equal(add(editor, 200, 100), BAT_OK);
    size_t size;
    assert_int_equal(times(bat_editor_journal(editor, &size), "\"data\""), 1);
    keeps_the_data(editor);
    bat_editor_free(editor);
}

/* A locked picture is never hit; a free one is, where nothing lies before it. */
static void locked_out_of_the_way(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_resize(editor, 800, 600, 1);
    assert_int_equal(add(editor, 200, 100), BAT_OK);
    bat_id id = bat_object_id(last(editor));
    bat_editor_command(editor, "deselect");
    pen_event(&p, BAT_POINTER_DOWN, 400, 300);
    pen_event(&p, BAT_POINTER_UP, 400, 300);
    assert_true(bat_selection_has(&editor->choice.selection, id));
    assert_int_equal(bat_editor_set_state(editor, id, false, true), BAT_OK);
    assert_int_equal(editor->choice.selection.count, 0);
    pen_event(&p, BAT_POINTER_DOWN, 400, 300);
    pen_event(&p, BAT_POINTER_UP, 400, 300);
    assert_int_equal(editor->choice.selection.count, 0);
    bat_editor_command(editor, "select-all");
    assert_false(bat_selection_has(&editor->choice.selection, id));
    keeps_the_data(editor);
    bat_editor_free(editor);
}

static void refused_in_one_line(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    uint64_t fresh = digest(editor);
    assert_int_equal(bat_editor_add_picture(editor, "GIF89a", 6, "x.gif"), BAT_UNSUPPORTED);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "PNG"));
    unsigned char *large = calloc(1, BAT_PICTURE_SIZE + 1);
    head_png(large, 5, 5);
    assert_int_equal(bat_editor_add_picture(editor, large, BAT_PICTURE_SIZE + 1, NULL), BAT_COUNT);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "16 MB"));
    assert_int_equal(bat_editor_add_picture(editor, NULL, 5, NULL), BAT_ARGUMENT);
    assert_true(digest(editor) == fresh);
    free(large);
    bat_editor_free(editor);
}

/* Two places 100 px apart on the picture are said to be 250 units: it grows by 2.5 pixels about the first, and what
 * lies under the second is 250 units from there. Locked as it is. */
static void scaled_by_two_points(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    double before[6], now, pixel = bat_view_pixel(&editor->stage.view), first[2], second[2];
    assert_int_equal(add(editor, 200, 100), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "picture-lock"), BAT_OK);
    assert_true(bat_object_is_locked(last(editor)));
    memcpy(before, bat_object_matrix(last(editor)), sizeof before);
    assert_int_equal(bat_editor_set(editor, "picture-span", 250), BAT_STATE); /* no places yet */
    assert_int_equal(bat_editor_command(editor, "tool-span"), BAT_OK);
    pen_event(&p, BAT_POINTER_DOWN, 450, 400);
    pen_event(&p, BAT_POINTER_UP, 450, 400);
    assert_int_equal(bat_editor_frame(editor)->requests, 0);
    pen_event(&p, BAT_POINTER_DOWN, 500, 470);
    pen_event(&p, BAT_POINTER_MOVE, 510, 480);                               /* 60 across, 80 down */
    assert_int_equal(bat_editor_command(editor, "picture-hide"), BAT_STATE); /* in the middle of it */
    pen_event(&p, BAT_POINTER_UP, 510, 480);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->requests, BAT_ASK_SPAN);
    assert_int_equal(frame->label_count, 1);
    bat_editor_get(editor, "picture-span", &now);
    assert_true(fabs(now - 100 * pixel) < 1e-9);
    bat_view_to_document(&editor->stage.view, (double[]){450, 400}, first);
    bat_view_to_document(&editor->stage.view, (double[]){510, 480}, second);
    assert_int_equal(bat_editor_set(editor, "picture-span", 250), BAT_OK);
    const double *m = bat_object_matrix(last(editor));
    double factor = 250 / (100 * pixel);
    assert_true(fabs(m[0] - factor * before[0]) < 1e-9 && fabs(m[3] - factor * before[3]) < 1e-9);
    /* The pixel under the first place stays, that under the second is 250 units away. */
    for (int k = 0; k < 2; k++) {
        double of_first = (first[k] - before[4 + k]) / before[0],
               of_second = (second[k] - before[4 + k]) / before[0];
        assert_true(fabs(m[0] * of_first + m[4 + k] - first[k]) < 1e-9);
        second[k] = m[0] * of_second + m[4 + k] - first[k];
    }
    assert_true(fabs(hypot(second[0], second[1]) - 250) < 1e-9);
    bat_editor_get(editor, "picture-span", &now);
    assert_true(fabs(now - 250) < 1e-9);
    assert_true(bat_object_is_locked(last(editor)));
    for (int i = 0; i < 3; i++) { /* 96 units an inch */
        assert_int_equal(bat_editor_set(editor, "unit", i), BAT_OK);
        frame = bat_editor_frame(editor);
        assert_string_equal(frame->labels[0].text, ((const char *[]){"250 px", "66.146 mm", "2.604 in"})[i]);
    }
    for (int i = 0; i < 3; i++)
        assert_int_not_equal(bat_editor_set(editor, "picture-span", (double[]){0, NAN, -1}[i]), BAT_OK);
    keeps_the_data(editor);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK); /* the places go */
    assert_int_equal(bat_editor_set(editor, "picture-span", 100), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_memory_equal(bat_object_matrix(last(editor)), before, sizeof before);
    bat_editor_free(editor);
}

static void opacity_lock_and_hide(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    double value;
    assert_int_equal(bat_editor_set(editor, "picture-opacity", 0.3), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "picture-lock"), BAT_STATE);
    assert_int_equal(add(editor, 20, 10), BAT_OK);
    assert_int_equal(add(editor, 30, 10), BAT_OK); /* this one is selected, and behind */
    assert_int_equal(bat_editor_set(editor, "picture-opacity", 0.3), BAT_OK);
    assert_true(bat_object_style(last(editor))->opacity == 0.3);
    assert_true(bat_object_style(bat_document_at(bat_editor_document(editor), 1))->opacity == 0.5);
    bat_editor_get(editor, "picture-opacity", &value);
    assert_true(value == 0.3);
    assert_int_equal(bat_editor_command(editor, "picture-lock"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "picture-opacity", 0.25), BAT_OK); /* locked ones, too */
    for (int i = 0; i < 2; i++) {
        const bat_object *object = bat_document_at(bat_editor_document(editor), i);
        assert_true(bat_object_is_locked(object) && bat_object_style(object)->opacity == 0.25);
    }
    assert_int_equal(bat_editor_command(editor, "picture-hide"), BAT_OK);
    for (int i = 0; i < 2; i++)
        assert_true(bat_object_is_hidden(bat_document_at(bat_editor_document(editor), i)));
    assert_int_equal(bat_editor_command(editor, "picture-hide"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "picture-lock"), BAT_OK);
    for (int i = 0; i < 2; i++) {
        const bat_object *object = bat_document_at(bat_editor_document(editor), i);
        assert_true(!bat_object_is_hidden(object) && !bat_object_is_locked(object));
    }
    assert_null(bat_editor_check(editor));
    keeps_the_data(editor);
    bat_editor_free(editor);
}

static void failing_allocations(void **unused) {
    (void)unused;
    for (int n = 1;; n++) {
        long live = alloc_live();
        bat_editor *editor = pen_editor();
        uint64_t fresh = digest(editor);
        alloc_fail_at(n);
        bat_status status = add(editor, 200, 100);
        bool reached = alloc_fail_reached();
        if (reached && status != BAT_OK) {
            assert_int_equal(status, BAT_MEMORY);
            assert_true(digest(editor) == fresh);
        }
        assert_null(bat_editor_check(editor));
        keeps_the_data(editor);
        bat_editor_free(editor);
        assert_int_equal(alloc_live(), live);
        if (!reached) {
            assert_int_equal(status, BAT_OK);
            return;
        }
    }
}

static double span_of(bat_editor *editor) {
    double value = -1;
    assert_int_equal(bat_editor_get(editor, "picture-span", &value), BAT_OK);
    return value / bat_view_pixel(&editor->stage.view);
}

/* A place that is pressed is moved, from further away by a finger; both on one spot ask for no distance; a third press
 * begins anew. */
static void places_are_moved_and_set_anew(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    assert_int_equal(add(editor, 200, 100), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tool-span"), BAT_OK);
    pen p = mouse(editor);
    pen_event(&p, BAT_POINTER_MOVE, 300, 300); /* nothing is held yet */
    tap(&p, 300, 300);
    tap(&p, 300 + 8, 300); /* the same place, moved there */
    assert_true(span_of(editor) == 0);
    tap(&p, 408, 300);
    assert_true(fabs(span_of(editor) - 100) < 1e-9);
    pen finger = p;
    finger.device = BAT_DEVICE_TOUCH;
    finger.contact = 5;
    drag(&finger, 408, 318, 408, 340); /* 18 px from it */
    assert_true(fabs(span_of(editor) - hypot(100, 40)) < 1e-9);
    drag(&p, 408, 340, 308, 300);
    assert_true(span_of(editor) == 0);
    assert_int_equal(bat_editor_frame(editor)->requests, 0);
    assert_int_equal(bat_editor_set(editor, "picture-span", 10), BAT_STATE);
    tap(&p, 600, 600); /* a third */
    assert_true(span_of(editor) == 0);
    pen_event(&p, BAT_POINTER_DOWN, 600, 650);
    pen_event(&p, BAT_POINTER_UP, 600, 650);
    assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_SPAN);
    assert_true(fabs(span_of(editor) - 50) < 1e-9);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(placed_in_the_middle),  cmocka_unit_test(moved_undone_and_replayed),
        cmocka_unit_test(locked_out_of_the_way), cmocka_unit_test(refused_in_one_line),
        cmocka_unit_test(scaled_by_two_points),  cmocka_unit_test(places_are_moved_and_set_anew),
        cmocka_unit_test(opacity_lock_and_hide), cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests_name("tracing", tests, NULL, NULL);
}
