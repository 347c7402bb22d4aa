/* Views that the drawing holds: saving one is a step of the history, going to one is not; the window shows again what was
 * seen; opening a drawing with one stays face-on and offers it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/view/saved.h"
#include <batten/format.h>
#include "support/alloc_fail.h"
#include "support/editing.h"

static uint32_t seed;

static double any(double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * ((double)(seed >> 8) / 16777216);
}

static bat_editor *editor_in_space(void) {
    const double points[] = {100, 100, 0, 300, 200, -80, 500, 500, 60, 800, 600, 0};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &curve), BAT_OK);
    return editor_with(1, &curve);
}

static void turn(bat_editor *editor, const char *words) {
    assert_int_equal(bat_editor_command(editor, words), BAT_OK);
    bat_editor_glide(editor, 1);
    bat_editor_frame(editor);
    check(editor);
}

static void project(const bat_view *view, const double at[3], double pixel[2]) {
    double map[BAT_MAP_NUMBERS], seen[2] = {BAT_NOWHERE, BAT_NOWHERE};
    bat_view_map(view, map);
    if (bat_map_look(map, 3, at, seen))
        bat_view_to_screen(view, seen, pixel);
    else
        pixel[0] = pixel[1] = BAT_NOWHERE;
}

/* In the same window every point is seen at the same pixel. */
static void the_window_shows_it_again(void **state) {
    (void)state;
    seed = 4;
    for (int run = 0; run < 500; run++) {
        bat_stage stage = bat_stage_defaults();
        bat_view *view = &stage.view, again = *view;
        view->width = 1000, view->height = 640;
        view->x = any(-500, 500), view->y = any(-500, 500), view->zoom = any(0.2, 5);
        view->fov = run % 2 ? BAT_FOV : 0;
        const double x = any(-300, 300), y = any(-300, 300), z = any(-300, 300);
        bat_view_set_pivot(view, (double[]){x, y, z});
        const double angle = any(-180, 180), tilt = run % 10 == 0 ? 0 : run % 10 == 1 ? 180 : any(1, 179);
        bat_view_orbit(view, angle, tilt);
        bat_viewpoint seen;
        assert_int_equal(bat_stage_viewpoint(&stage, &seen), BAT_OK);
        again.width = 1000, again.height = 640;
        bat_view_look_from(&again, &seen);
        for (int k = 0; k < 20; k++) {
            double at[3], was[2], is[2];
            for (int c = 0; c < 3; c++) at[c] = any(-300, 300);
            if (tilt == 0) at[2] = 0;
            project(view, at, was);
            project(&again, at, is);
            assert_true(hypot(was[0] - is[0], was[1] - is[1]) < 1e-6 * fmax(1000, hypot(was[0], was[1])));
        }
    }
}

/* In another window, from an eye that rolls, with another angle: all of it is in the window, and the target in its middle. */
static void what_the_window_can_not_take(void **state) {
    (void)state;
    const bat_viewpoint seen = {
        .eye = {300, -200, -150}, .target = {10, 20, 30}, .up = {0.3, 1, 0.2}, .size = {400, 900}, .fov = 60};
    bat_view view = bat_view_defaults();
    view.width = 1200, view.height = 500;
    bat_view_look_from(&view, &seen);
    double pixel[2], ahead[3], right[3], down[3];
    project(&view, seen.target, pixel);
    assert_true(hypot(pixel[0] - 600, pixel[1] - 250) < 1e-6);
    bat_view_axes(&view, right, down, ahead);
    const double gaze[3] = {-290, 220, 180}, far = sqrt(290. * 290 + 220. * 220 + 180. * 180);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(ahead[k] - gaze[k] / far) < 2e-4); /* hundredths of a degree */
    const double high = 2 * far * tan(30 * 3.14159265358979323846 / 180);
    assert_true(fabs(view.zoom - 500 / high) < 1e-9 * view.zoom);
    assert_true(view.fov == BAT_FOV);
}

static void saving_is_a_step(void **state) {
    (void)state;
    bat_editor *editor = editor_in_space(), *again = NULL;
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "view-saved"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "view-forget"), BAT_STATE);
    turn(editor, "view-front");
    turn(editor, "orbit-left");
    turn(editor, "orbit-down");
    turn(editor, "view-save");
    const bat_document *document = bat_editor_document(editor);
    assert_int_equal(bat_document_count(document), 2);
    assert_int_equal(bat_editor_command(editor, "view-save"), BAT_STATE); /* it is known */
    assert_int_equal(bat_document_count(document), 2);
    bat_viewpoint seen;
    assert_int_equal(bat_stage_viewpoint(editor->context.stage, &seen), BAT_OK);
    assert_memory_equal(bat_object_view(bat_document_at(document, 1))->eye, seen.eye, sizeof seen.eye);
    const uint64_t saved = digest(editor);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == saved);
    /* Going there changes nothing that undo or the journal know. */
    size_t size, now;
    bat_editor_journal(editor, &size);
    turn(editor, "view-upright");
    assert_true(editor->context.stage->view.tilt == 0);
    turn(editor, "view-saved");
    assert_true(editor->context.stage->view.tilt == 75 && editor->context.stage->view.angle == 15);
    bat_editor_journal(editor, &now);
    assert_int_equal(now, size);
    assert_true(digest(editor) == saved);
    turn(editor, "view-back");
    assert_true(editor->context.stage->view.tilt == 0);
    /* The journal has the view. */
    bat_problem problem;
    assert_int_equal(bat_editor_create(&again), BAT_OK);
    const char *journal = bat_editor_journal(editor, &size);
    assert_int_equal(bat_editor_replay(again, journal, size, true, &problem), BAT_OK);
    assert_true(digest(again) == saved);
    bat_editor_free(again);
    turn(editor, "view-forget");
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* The last one first, then those before it, and round. */
static void one_after_the_other(void **state) {
    (void)state;
    static const char *const views[] = {"view-front", "view-side", "orbit-up"};
    static const double tilts[] = {90, 90, 105}, angles[] = {0, 90, 90};
    bat_editor *editor = editor_in_space();
    for (int k = 0; k < 3; k++) turn(editor, views[k]), turn(editor, "view-save");
    turn(editor, "view-upright");
    for (int k = 0; k < 7; k++) {
        const bat_view *view = &editor->context.stage->view;
        turn(editor, "view-saved");
        assert_true(view->tilt == tilts[2 - k % 3] && view->angle == angles[2 - k % 3]);
    }
    turn(editor, "view-forget"); /* the last is shown */
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    turn(editor, "view-saved");
    assert_true(editor->context.stage->view.tilt == 90 && editor->context.stage->view.angle == 90);
    assert_int_equal(bat_editor_set_state(
                         editor, bat_object_id(bat_document_at(bat_editor_document(editor), 1)), true, false),
                     BAT_OK);
    assert_int_equal(bat_editor_command(editor, "view-saved"), BAT_STATE); /* the other one is hidden */
    bat_editor_free(editor);
}

static void perspective_is_saved(void **state) {
    (void)state;
    bat_editor *editor = editor_in_space();
    double value;
    turn(editor, "view-front");
    turn(editor, "orbit-down");
    turn(editor, "perspective");
    turn(editor, "view-save");
    const bat_view deep = editor->context.stage->view;
    turn(editor, "perspective");
    turn(editor, "view-upright");
    turn(editor, "view-saved");
    bat_editor_get(editor, "perspective", &value);
    assert_true(value == 1 && editor->context.stage->view.fov == BAT_FOV);
    double was[2], is[2];
    project(&deep, (double[]){300, 200, -40}, was);
    project(&editor->context.stage->view, (double[]){300, 200, -40}, is);
    assert_true(hypot(was[0] - is[0], was[1] - is[1]) < 1e-6);
    bat_editor_free(editor);
}

/* Face-on, with the page as large as without a view; the offer leads there. */
static void opening(void **state) {
    (void)state;
    bat_editor *editor = editor_in_space(), *again = NULL, *without = NULL;
    char *text, *bare;
    size_t size, bare_size;
    bat_document *document = NULL, *flat = NULL;
    assert_int_equal(bat_document_write(bat_editor_document(editor), &bare, &bare_size), BAT_OK);
    turn(editor, "view-front");
    turn(editor, "view-save");
    assert_int_equal(bat_document_write(bat_editor_document(editor), &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &document, NULL), BAT_OK);
    assert_int_equal(bat_document_read(bare, bare_size, &flat, NULL), BAT_OK);
    assert_int_equal(bat_editor_create(&again), BAT_OK);
    assert_int_equal(bat_editor_create(&without), BAT_OK);
    bat_editor_resize(again, 1000, 800, 1), bat_editor_resize(without, 1000, 800, 1);
    assert_int_equal(bat_editor_open(again, document, "test"), BAT_OK);
    assert_int_equal(bat_editor_open(without, flat, "test"), BAT_OK);
    const bat_frame *frame = bat_editor_frame(again), *plain = bat_editor_frame(without);
    assert_true(frame->tilt == 0);
    assert_memory_equal(frame->view, plain->view, sizeof frame->view);
    assert_string_equal(frame->offer, "view-saved");
    assert_true(!plain->notice || !*plain->notice);
    const uint32_t said = frame->notice_version;
    turn(again, frame->offer);
    assert_true(again->context.stage->view.tilt == 90);
    frame = bat_editor_frame(again); /* taken up, it is not offered any longer */
    assert_true(frame->notice_version > said);
    assert_string_equal(frame->offer, "");
    assert_string_equal(frame->notice, "");
    turn(again, "view-upright");
    const uint32_t before = bat_editor_frame(again)->notice_version;
    assert_int_equal(bat_editor_enter(again, "view", ""), BAT_OK);
    bat_editor_glide(again, 1);
    frame = bat_editor_frame(again); /* where a host opens it so, it is offered */
    assert_true(frame->tilt == 90 && frame->notice_version > before);
    assert_string_equal(frame->offer, "");
    turn(again, "orbit-left"); /* once one has turned away */
    assert_string_equal(bat_editor_frame(again)->offer, "view-saved");
    turn(again, "view-saved");
    turn(again, "orbit-left"); /* and knows it */
    assert_string_equal(bat_editor_frame(again)->offer, "");
    bat_free(text), bat_free(bare);
    bat_editor_free(editor), bat_editor_free(again), bat_editor_free(without);
}

static void no_memory(void **state) {
    (void)state;
    bat_editor *editor = editor_in_space();
    turn(editor, "view-front");
    const uint64_t before = digest(editor);
    bool reached = true;
    for (long n = 1; reached; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_editor_command(editor, "view-save");
        reached = alloc_fail_reached();
        assert_true(status == BAT_OK || (reached && status == BAT_MEMORY));
        check(editor);
        if (status == BAT_OK) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == before);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_window_shows_it_again),
                                       cmocka_unit_test(what_the_window_can_not_take),
                                       cmocka_unit_test(saving_is_a_step),
                                       cmocka_unit_test(one_after_the_other),
                                       cmocka_unit_test(perspective_is_saved),
                                       cmocka_unit_test(opening),
                                       cmocka_unit_test(no_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
