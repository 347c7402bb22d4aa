/* Turning the view: what it turns about, what stays to be seen from every side, which of two gestures wins, what a dot and an
 * empty drawing do there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/pick/pivot.h"
#include "support/editing.h"
#include "support/sheet.h"

static double tilt_of(bat_editor *editor) { return bat_editor_frame(editor)->tilt; }

static void turn(bat_editor *editor, const char *words, int times) {
    for (int i = 0; i < times; i++) assert_int_equal(bat_editor_command(editor, words), BAT_OK);
    bat_editor_glide(editor, 1);
    bat_editor_frame(editor);
}

static pen button(bat_editor *editor, uint32_t buttons) {
    pen p = mouse(editor);
    p.buttons = buttons;
    return p;
}

/* Where a point in space is seen. */
static void pixel_of(const bat_editor *editor, const double at[3], double pixel[2]) {
    double seen[2];
    bat_stage_look(editor->context.stage, 3, at, seen);
    bat_stage_project(editor->context.stage, seen, pixel);
}

static void is_pivot(const bat_editor *editor, const double at[3], double within) {
    for (int k = 0; k < 3; k++) assert_true(fabs(editor->context.stage->view.pivot[k] - at[k]) < within);
}

/* Turns by a short drag of the right button that begins there. */
static void orbit_from(bat_editor *editor, double x, double y) {
    pen p = button(editor, BAT_BUTTON_SECONDARY);
    drag(&p, x, y, x + 20, y - 30);
}

/* A curve of the page, one high above it, and a sheet with hills: the point under the pen, on a curve or within the sheet; beside
 * all of them the middle of the selection; without one the middle of everything. */
static void what_it_turns_about(void **state) {
    (void)state;
    const double high[] = {50, 700, -60, 350, 700, -60, 650, 700, -60, 950, 700, -60};
    bat_document *document = NULL;
    bat_curve *curve = NULL;
    bat_surface *surface = sheet_create();
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(60, 60, 40, 0, 8));
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, high, &curve), BAT_OK);
    pen_add(document, curve);
    assert_int_equal(sheet_add(document, bat_document_new_id(document), surface), BAT_OK);
    bat_editor *editor = editor_of(document);
    turn(editor, "orbit-up", 2);
    double pixel[2], place[3];
    pixel_of(editor, (const double[]){500, 700, -60}, pixel);
    orbit_from(editor, pixel[0], pixel[1] + 3);
    is_pivot(editor, (const double[]){500, 700, -60}, 4);
    turn(editor, "view-upright", 1);
    turn(editor, "orbit-up", 2);
    turn(editor, "zoom-in", 4); /* so that lines of the sheet are far apart */
    bat_surface_eval(surface, 1.5, 1.5, 0, place);
    pixel_of(editor, place, pixel);
    for (int k = 0; k < 2; k++) { /* the middle of a patch, brought into the window */
        bat_editor_wheel(editor, pixel[0] - 500, pixel[1] - 400, 500, 400, 0, 1e6);
        pixel_of(editor, place, pixel);
    }
    orbit_from(editor, pixel[0], pixel[1]);
    is_pivot(editor, place, 0.01); /* pixels are rounded to hundredths */
    turn(editor, "view-upright", 1);
    turn(editor, "view-fit", 1);
    turn(editor, "orbit-up", 2);
    /* Beside everything, in a corner of the window. */
    orbit_from(editor, 990, 10);
    double all[3];
    memcpy(all, editor->context.stage->view.pivot, sizeof all);
    assert_true(fabs(all[0] - 500) < 1e-9 && fabs(all[1] - 400) < 1e-9 && all[2] < 0);
    bat_editor_command(editor, "tool-select");
    pixel_of(editor, (const double[]){200, 60, 0}, pixel);
    pen p = mouse(editor);
    tap(&p, pixel[0], pixel[1]);
    assert_int_equal(bat_editor_frame(editor)->selected, 1);
    orbit_from(editor, 990, 10);
    is_pivot(editor, (const double[]){200, 60, 0}, 1e-9);
    bat_surface_free(surface);
    bat_editor_free(editor);
}

/* At every fifteen degrees but edge-on: the page, from behind its back, and the grid on it, within the window. */
static void page_and_grid_are_seen_from_every_side(void **state) {
    (void)state;
    for (int perspective = 0; perspective < 2; perspective++) {
        bat_editor *editor = pen_editor();
        bat_editor_set(editor, "show-grid", 1);
        bat_editor_set(editor, "perspective", perspective);
        for (int steps = 1; steps < 12; steps++) {
            turn(editor, "orbit-up", 1);
            const bat_frame *frame = bat_editor_frame(editor);
            assert_true(fabs(frame->tilt - 15 * steps) < 1e-9);
            assert_int_equal(frame->still[0].role, steps > 6 ? BAT_ROLE_PAGE_BACK : BAT_ROLE_PAGE);
            const bat_item *strong = pen_live(frame, BAT_ROLE_GRID_STRONG),
                           *fine = pen_live(frame, BAT_ROLE_GRID);
            assert_true(steps == 6 || (strong && strong->path_count > 6) || (fine && fine->path_count > 6));
        }
        bat_editor_free(editor);
    }
}

/* A stroke under way is not turned, by no key and by no finger or other button; an orbit under way is not drawn into. */
static void the_first_of_two_gestures_wins(void **state) {
    (void)state;
    static const char *const commands[] = {"orbit-up", "orbit-left", "view-front", "view-upright",
                                           "view-fit"};
    bat_editor *editor = pen_editor();
    turn(editor, "orbit-up", 2);
    const bat_view before = editor->context.stage->view;
    pen p = pen_for(editor), other = button(editor, BAT_BUTTON_SECONDARY);
    other.contact = 9;
    p.time += 1000;
    pen_begin(&p, pen_arch, (double[]){300, 640, 600, 640, 30}, 30);
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        bat_editor_command(editor, commands[i]);
        bat_editor_glide(editor, 1);
        assert_memory_equal(&editor->context.stage->view, &before, sizeof before);
    }
    other.time = p.time;
    pen_event(&other, BAT_POINTER_DOWN, 500, 400);
    pen_event(&other, BAT_POINTER_MOVE, 560, 300);
    pen_event(&other, BAT_POINTER_UP, 560, 300);
    for (uint32_t i = 0; i < 3; i++) {
        pen finger = {editor, BAT_DEVICE_TOUCH, 20 + i, BAT_BUTTON_PRIMARY, 0, other.time};
        pen_event(&finger, BAT_POINTER_DOWN, 300 + 90 * i, 300);
        pen_event(&finger, BAT_POINTER_MOVE, 300 + 90 * i, 200);
        pen_event(&finger, BAT_POINTER_UP, 300 + 90 * i, 200);
        p.time = finger.time;
    }
    assert_memory_equal(&editor->context.stage->view, &before, sizeof before);
    pen_event(&p, BAT_POINTER_UP, 600, 640);
    check(editor);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    const uint64_t drawn = digest(editor);
    other.time = p.time + 1000;
    pen_event(&other, BAT_POINTER_DOWN, 500, 400);
    pen_event(&other, BAT_POINTER_MOVE, 560, 300);
    bat_editor_frame(editor);
    p.time = other.time;
    pen_line(&p, 300, 700, 600, 700, 30);
    assert_true(digest(editor) == drawn);
    other.time = p.time;
    pen_event(&other, BAT_POINTER_UP, 560, 300);
    check(editor);
    assert_true(tilt_of(editor) != before.tilt);
    bat_editor_free(editor);
}

static void alt_with_the_middle_button_turns(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = button(editor, BAT_BUTTON_MIDDLE);
    drag(&p, 500, 400, 540, 300);
    assert_true(tilt_of(editor) == 0); /* it pans */
    p.modifiers = BAT_ALT;
    drag(&p, 500, 400, 540, 300);
    assert_true(tilt_of(editor) > 40);
    bat_editor_free(editor);
}

/* On a tilted page a dot picks the curve that is seen there where the tool picks, and otherwise changes nothing. */
static void a_dot_picks(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-lift", "tool-select"};
    for (int i = 0; i < 2; i++) {
        bat_editor *editor = pen_editor();
        const uint64_t first = digest(editor);
        bat_editor_command(editor, tools[i]);
        turn(editor, "orbit-up", 2);
        double pixel[2];
        pixel_of(editor, (const double[]){500, 600, 0}, pixel);
        pen p = pen_for(editor);
        tap(&p, pixel[0], pixel[1]);
        assert_true(digest(editor) == first);
        assert_int_equal(bat_editor_frame(editor)->selected, 1);
        tap(&p, 500, 400);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* Nothing but a page, or not even that: it turns, shows grid and page, takes a stroke, and comes home. */
static void an_empty_drawing_turns(void **state) {
    (void)state;
    for (int page = 0; page < 2; page++) {
        bat_document *document = NULL;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        if (page) bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        bat_editor *editor = editor_of(document);
        bat_editor_set(editor, "show-grid", 1);
        double before[4];
        memcpy(before, bat_editor_frame(editor)->view, sizeof before);
        orbit_from(editor, 500, 400);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_true(frame->tilt > 10);
        assert_int_equal(frame->still_count, page);
        assert_true(pen_live(frame, BAT_ROLE_GRID) || pen_live(frame, BAT_ROLE_GRID_STRONG));
        pen p = pen_for(editor);
        pen_line(&p, 400, 420, 600, 430, 30);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
        turn(editor, "undo", 1);
        turn(editor, "view-upright", 1);
        assert_memory_equal(before, bat_editor_frame(editor)->view, sizeof before);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_it_turns_about),
        cmocka_unit_test(page_and_grid_are_seen_from_every_side),
        cmocka_unit_test(the_first_of_two_gestures_wins),
        cmocka_unit_test(alt_with_the_middle_button_turns),
        cmocka_unit_test(a_dot_picks),
        cmocka_unit_test(an_empty_drawing_turns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
