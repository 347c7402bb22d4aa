/* The view's arithmetic in closed form: the point under the pen stays there; what should be visible is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/view/stage.h"
#include "support/pen.h"
#include <batten/editor.h>

static bat_view window(void) {
    bat_view view = bat_view_defaults();
    view.width = 1000;
    view.height = 600;
    return view;
}

static void pan_moves_by_pixels(void **state) {
    (void)state;
    bat_view view = window();
    view.zoom = 4;
    bat_view_pan(&view, (double[]){100, 50}, (double[]){140, 30});
    assert_true(view.x == -10 && view.y == 5 && view.zoom == 4);
}

static void zoom_keeps_the_point(void **state) {
    (void)state;
    bat_view view = window();
    view.x = 17;
    view.y = -3;
    double about[2] = {700, 100}, before[2], after[2];
    for (int i = 0; i < 40; i++) {
        double factor = i % 3 ? 1.3 : 0.5, zoom = view.zoom;
        bat_view_to_document(&view, about, before);
        bat_view_zoom(&view, about, factor);
        bat_view_to_document(&view, about, after);
        assert_true(fabs(view.zoom - zoom * factor) < 1e-12 * zoom);
        assert_true(fabs(before[0] - after[0]) < 1e-9 && fabs(before[1] - after[1]) < 1e-9);
    }
}

static void zoom_has_limits(void **state) {
    (void)state;
    bat_view view = window();
    double about[2] = {1, 2};
    for (int i = 0; i < 100; i++) bat_view_zoom(&view, about, 1e30);
    assert_true(view.zoom == BAT_ZOOM_MAX);
    for (int i = 0; i < 100; i++) bat_view_zoom(&view, about, 1e-30);
    assert_true(view.zoom == BAT_ZOOM_MIN);
    double factors[] = {0, -1, NAN};
    for (int i = 0; i < 3; i++) bat_view_zoom(&view, about, factors[i]);
    assert_true(view.zoom == BAT_ZOOM_MIN);
}

static void there_and_back(void **state) {
    (void)state;
    bat_view view = bat_view_defaults();
    view.x = -31.5;
    view.y = 8;
    view.zoom = 2.5;
    double screen[2] = {123, -45}, document[2], back[2];
    bat_view_to_document(&view, screen, document);
    assert_true(document[0] == -31.5 + 123 / 2.5 && document[1] == 8 - 18);
    bat_view_to_screen(&view, document, back);
    assert_true(fabs(back[0] - 123) < 1e-12 && fabs(back[1] + 45) < 1e-12);
}

static void fit_shows_the_box_centred(void **state) {
    (void)state;
    bat_view view = window();
    double box[4] = {100, 200, 300, 240}, low[2], high[2];
    assert_true(bat_view_fit(&view, box, 50));
    assert_true(fabs(view.zoom - 900.0 / 200) < 1e-12); /* the width decides */
    bat_view_to_screen(&view, box, low);
    bat_view_to_screen(&view, box + 2, high);
    assert_true(fabs(low[0] - 50) < 1e-9 && fabs(high[0] - 950) < 1e-9);
    assert_true(fabs(low[1] + high[1] - 600) < 1e-9);
}

static void fit_of_odd_boxes(void **state) {
    (void)state;
    bat_view view = window();
    double point[4] = {7, 9, 7, 9}, empty[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY},
           line[4] = {0, 5, 100, 5};
    assert_true(bat_view_fit(&view, point, 10) && view.zoom == 1 && view.x == 7 - 500 && view.y == 9 - 300);
    assert_false(bat_view_fit(&view, empty, 10));
    assert_true(bat_view_fit(&view, line, 0) && view.zoom == 10);
    const double upright[4] = {5, 0, 5, 60};
    assert_true(bat_view_fit(&view, upright, 0) && view.zoom == 10);
    const bat_view before = view;
    static const double endless[][4] = {{0, 0, 5, NAN}, {0, 0, NAN, 5},      {0, 5, 5, 0},
                                        {5, 0, 0, 5},   {0, 0, INFINITY, 5}, {0, 0, 5, INFINITY}};
    for (size_t i = 0; i < sizeof endless / sizeof *endless; i++)
        assert_false(bat_view_fit(&view, endless[i], 10));
    assert_memory_equal(&view, &before, sizeof view);
    view.width = 0;
    assert_false(bat_view_fit(&view, line, 0));
}

/* Two stages are the same when nothing about them differs. */
static void stages_compare_all(void **state) {
    (void)state;
    const bat_stage stage = {.view = window(), .ground = bat_ground_page()};
    bat_stage other = stage;
    assert_true(bat_stage_same(&stage, &other));
    double *const members[] = {&other.view.x,     &other.view.y,      &other.view.zoom, &other.view.angle,
                               &other.view.width, &other.view.height, &other.view.ratio};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        const double kept = *members[i];
        *members[i] = kept + 0.5;
        assert_false(bat_stage_same(&stage, &other));
        *members[i] = kept;
    }
    const double plane[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    assert_true(bat_ground_named("plane", 9, plane, &other.ground));
    assert_false(bat_stage_same(&stage, &other));
}

/* What is not a ground. */
static void grounds_by_name(void **state) {
    (void)state;
    static const double good[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    bat_ground ground = bat_ground_page();
    assert_string_equal(bat_ground_name(0), "page");
    assert_string_equal(bat_ground_name(1), "plane");
    assert_string_equal(bat_ground_name(2), "view");
    assert_string_equal(bat_ground_name(3), "ruled");
    assert_string_equal(bat_ground_name(4), "surface");
    assert_null(bat_ground_name(5));
    assert_null(bat_ground_name(-1));
    assert_false(bat_ground_named("lake", 0, NULL, &ground));
    assert_false(bat_ground_named("plane", 8, good, &ground));
    static const struct {
        int at;
        double value;
    } spoilt[] = {{0, NAN}, {2, 1e300}, {3, 1.1}, {7, 0.9}, {6, 1e-3}, {8, INFINITY}};
    for (size_t i = 0; i < sizeof spoilt / sizeof *spoilt; i++) {
        double numbers[9];
        memcpy(numbers, good, sizeof numbers);
        numbers[spoilt[i].at] = spoilt[i].value;
        assert_false(bat_ground_named("plane", 9, numbers, &ground));
    }
    assert_string_equal(ground.type->name, "page");
    assert_true(bat_ground_named("plane", 9, good, &ground));
    assert_string_equal(ground.type->name, "plane");
}

/* A large drawing far from the origin is painted precisely where one looks closely. */
static void far_away_is_precise(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    pen_add(document, pen_curve(4e6, 3e6, 0.05, 0.2, 9));
    bat_editor_create(&editor);
    bat_editor_resize(editor, 1000, 800, 1);
    assert_int_equal(bat_editor_open(editor, document, NULL), BAT_OK);
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_curve *curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
    assert_int_equal(frame->still_count, 1);
    const float *path = frame->still[0].path;
    assert_true(path[0] == BAT_PATH_MOVE);
    for (int k = 0; k < 2; k++) {
        double shown = (path[1 + k] + frame->origin[k] - frame->view[k]) * frame->view[2];
        double exact = (bat_curve_points(curve)[k] - frame->view[k]) * frame->view[2];
        assert_true(fabs(shown - exact) < 0.01);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pan_moves_by_pixels),       cmocka_unit_test(zoom_keeps_the_point),
        cmocka_unit_test(zoom_has_limits),           cmocka_unit_test(there_and_back),
        cmocka_unit_test(fit_shows_the_box_centred), cmocka_unit_test(fit_of_odd_boxes),
        cmocka_unit_test(stages_compare_all),        cmocka_unit_test(grounds_by_name),
        cmocka_unit_test(far_away_is_precise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
