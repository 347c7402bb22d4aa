/* The eraser, lines and spans in tilted views: on what is seen, on the page, and on planes in space. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/pictures.h"
#include "support/space_wave.h"
#include <batten/batten.h>
#include <math.h>

static const int VIEWS[][2] = {{0, 0}, {3, 0}, {4, 2}, {8, -1}};
enum { VIEW_COUNT = sizeof VIEWS / sizeof *VIEWS };

static bat_editor *with(bat_curve *curve, int view, const char *tool) {
    bat_editor *editor = tilted_with(curve, VIEWS[view][0], VIEWS[view][1]);
    assert_int_equal(bat_editor_command(editor, tool), BAT_OK);
    bat_editor_set(editor, "snap", 0);
    if (view == 2) assert_int_equal(bat_editor_set(editor, "perspective", 1), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static const bat_curve *curve_at(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

static void seen(const bat_editor *editor, int dimension, const double *point, double pixel[2]) {
    double at[2];
    bat_stage_look(&editor->stage, dimension, point, at);
    bat_stage_project(&editor->stage, at, pixel);
}

static double off_segment(const double at[2], const double a[2], const double b[2]) {
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double t = fmin(fmax(((at[0] - a[0]) * x + (at[1] - a[1]) * y) / (x * x + y * y), 0), 1);
    return hypot(at[0] - a[0] - t * x, at[1] - a[1] - t * y);
}

/* What is left, by the parameters that pieces keep. */
static bool left_at(const bat_editor *editor, double u) {
    for (int i = 0; i < bat_document_count(bat_editor_document(editor)); i++) {
        double domain[2];
        bat_curve_domain(curve_at(editor, i), domain);
        if (domain[0] <= u && u <= domain[1]) return true;
    }
    return false;
}

/* Every place that is seen within the circle's path goes, every other stays where it was in space. */
static void what_is_seen_under_the_eraser_goes(void **state) {
    (void)state;
    for (int v = 0; v < VIEW_COUNT; v++)
        for (int end = 0; end < 2; end++) { /* with the tool, and with the pen's other end */
            double place[3], at[2], now[3], half = 0;
            bat_editor *editor = with(wave(40, 60, 1.3), v, end ? "tool-points" : "tool-eraser");
            const uint64_t first = digest(editor);
            bat_curve *was = NULL;
            pen p = pen_for(editor);
            bat_editor_set(editor, "pressure", 0);
            bat_editor_get(editor, "eraser-size", &half);
            bat_curve_copy(curve_at(editor, 0), &was);
            bat_curve_eval(was, 3.6, 0, place);
            seen(editor, 3, place, at);
            if (end) p.buttons = BAT_BUTTON_ERASER;
            const double a[2] = {round(at[0]) - 20, round(at[1]) - 60}, b[2] = {a[0] + 40, a[1] + 120};
            drag(&p, a[0], a[1], b[0], b[1]);
            assert_true(bat_document_count(bat_editor_document(editor)) >= 2);
            int gone = 0;
            for (int i = 0; i <= 400; i++) {
                const double u = 8.0 * i / 400;
                bat_curve_eval(was, u, 0, place);
                seen(editor, 3, place, at);
                const double distance = off_segment(at, a, b);
                if (fabs(distance - half) < 0.5) continue;
                assert_int_equal(left_at(editor, u), distance > half);
                gone += distance < half;
            }
            assert_true(gone > 3);
            for (int i = 0; i < bat_document_count(bat_editor_document(editor)); i++) {
                const bat_curve *piece = curve_at(editor, i);
                double domain[2];
                assert_int_equal(bat_curve_dimension(piece), 3);
                bat_curve_domain(piece, domain);
                for (int k = 0; k <= 20; k++) {
                    const double u = domain[0] + (domain[1] - domain[0]) * k / 20;
                    bat_curve_eval(piece, u, 0, now), bat_curve_eval(was, u, 0, place);
                    for (int c = 0; c < 3; c++) assert_true(fabs(now[c] - place[c]) < 1e-9);
                }
            }
            assert_int_equal(round_trip(editor, first), 1);
            bat_curve_free(was);
            bat_editor_free(editor);
        }
}

/* Esc puts back what was marked; a dot beside everything takes nothing. */
static void an_eraser_that_is_given_up(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 1.3), 1, "tool-eraser");
    const uint64_t first = digest(editor);
    double place[3], at[2];
    pen p = pen_for(editor);
    bat_curve_eval(curve_at(editor, 0), 3.6, 0, place);
    seen(editor, 3, place, at);
    drag_to(&p, at[0], at[1] - 50, at[0], at[1] + 50);
    assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
    pen_event(&p, BAT_POINTER_UP, at[0], at[1] + 50);
    check(editor);
    assert_true(digest(editor) == first);
    tap(&p, 5, 5);
    assert_true(digest(editor) == first);
    tap(&p, at[0], at[1]); /* a dot on it takes what it covers */
    assert_true(digest(editor) != first);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* A stretch that keys chose is taken out of a curve in space, too. */
static void a_stretch_in_space_is_erased(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 1.3), 1, "tool-eraser");
    bat_context *c = &editor->context;
    const bat_slot *slot = bat_toolbox_chosen(c);
    const bat_stretch on = {1, 0, {2, 3}};
    assert_int_equal(slot->is->work(c, slot->state, &on), BAT_OK);
    assert_true(left_at(editor, 1.9) && !left_at(editor, 2.5) && left_at(editor, 3.1));
    bat_editor_free(editor);
}

/* ---- lines ---- */

/* The line's corners are seen where the pen was, and it is straight between them. */
static void expect_line(const bat_editor *editor, int dimension, int corners, const double *pixels) {
    const int count = bat_document_count(bat_editor_document(editor));
    const bat_curve *curve = curve_at(editor, count - 1);
    double at[2], middle[3] = {0};
    assert_int_equal(bat_curve_dimension(curve), dimension);
    assert_int_equal(bat_curve_count(curve), 3 * (corners - 1) + 1);
    for (int i = 0; i < corners; i++) {
        const double *point = bat_curve_points(curve) + 3 * dimension * i;
        seen(editor, dimension, point, at);
        assert_true(hypot(at[0] - pixels[2 * i], at[1] - pixels[2 * i + 1]) < 1e-6);
        if (!i) continue;
        const double *knots = bat_curve_knots(curve) + 3 * i;
        bat_curve_eval(curve, knots[0] / 2 + knots[3] / 2, 0, middle);
        for (int k = 0; k < dimension; k++)
            assert_true(fabs(middle[k] - point[k] / 2 - point[k - 3 * dimension] / 2) < 1e-6);
    }
}

static void lines_lie_on_the_page(void **state) {
    (void)state;
    for (int v = 1; v < VIEW_COUNT; v++) {
        bat_editor *editor = with(wave(40, 60, 1.3), v, "tool-line");
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        drag(&p, 300, 300, 500, 340);
        expect_line(editor, 2, 2, (double[]){300, 300, 500, 340});
        tap(&p, 520, 480);
        expect_line(editor, 2, 3, (double[]){300, 300, 500, 340, 520, 480});
        assert_non_null(strstr(bat_editor_frame(editor)->hint, "page"));
        tap(&p, 521, 480); /* on its end: it ends there */
        assert_int_equal(bat_editor_frame(editor)->pending, 0);
        assert_int_equal(round_trip(editor, first), 2);
        bat_editor_free(editor);
    }
}

/* On a plane they lie in it, also when it is left and found again; Shift counts its steps in the plane. */
static void lines_lie_on_a_plane(void **state) {
    (void)state;
    for (int v = 1; v < VIEW_COUNT; v++) {
        bat_editor *editor = with(wave(40, 60, 1.3), v, "tool-line");
        pen p = pen_for(editor);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "orbit-left"), BAT_OK);
        drag(&p, 300, 300, 500, 340);
        tap(&p, 420, 180);
        expect_line(editor, 3, 3, (double[]){300, 300, 500, 340, 420, 180});
        p.modifiers = BAT_SHIFT;
        tap(&p, 250, 210);
        p.modifiers = 0;
        const bat_ground *plane = &editor->stage.ground;
        const bat_curve *curve = curve_at(editor, bat_document_count(bat_editor_document(editor)) - 1);
        double x[3], y[3], own[2] = {0};
        bat_ground_axes(plane, x, y);
        const double *points = bat_curve_points(curve), *last = points + 3 * (bat_curve_count(curve) - 1);
        for (int k = 0; k < 3; k++) {
            own[0] += (last[k] - points[18 + k]) * x[k];
            own[1] += (last[k] - points[18 + k]) * y[k];
        }
        const double turn = atan2(own[1], own[0]) * 180 / acos(-1);
        assert_true(fabs(turn - 15 * round(turn / 15)) < 1e-9);
        for (size_t i = 0; i < bat_curve_count(curve); i++) {
            double off = 0;
            const int next[3] = {1, 2, 0};
            for (int k = 0; k < 3; k++) {
                const int a = next[k], b = next[a];
                off += (points[3 * i + (size_t)k] - plane->numbers[k]) * (x[a] * y[b] - x[b] * y[a]);
            }
            assert_true(fabs(off) < 1e-9);
        }
        assert_int_equal(round_trip(editor, first), 4);
        bat_editor_free(editor);
    }
}

/* A line of the page does not go on elsewhere, and one in space goes on upon the page. */
static void lines_that_change_their_ground(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 1.3), 1, "tool-line");
    pen p = pen_for(editor);
    drag(&p, 300, 300, 500, 340);
    const int before = bat_document_count(bat_editor_document(editor));
    assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK);
    bat_editor_frame(editor);
    check(editor);
    drag(&p, 520, 480, 600, 500);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), before + 2);
    expect_line(editor, 3, 2, (double[]){520, 480, 600, 500});
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_OK);
    tap(&p, 620, 400);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), before + 2);
    expect_line(editor, 3, 3, (double[]){520, 480, 600, 500, 620, 400});
    const bat_curve *curve = curve_at(editor, before + 1);
    assert_true(bat_curve_points(curve)[3 * 6 + 2] == 0);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void tilt_to_the_edge(bat_editor *editor) {
    for (int i = 0; i < 6; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
}

/* Where the page is seen from its edge nothing begins, and the way to it is offered. */
static void edge_on_nothing_begins(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-line", "tool-span"};
    for (size_t i = 0; i < 2; i++) {
        bat_editor *editor = with(wave(40, 60, 1.3), 0, tools[i]);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        tilt_to_the_edge(editor);
        drag(&p, 300, 300, 500, 340);
        tap(&p, 400, 400);
        assert_true(digest(editor) == first);
        assert_string_equal(bat_editor_frame(editor)->offer, "view-ground");
        assert_int_equal(bat_editor_frame(editor)->pending, 0);
        assert_int_equal(bat_editor_command(editor, "view-ground"), BAT_OK);
        assert_true(bat_editor_frame(editor)->tilt == 0);
        bat_editor_free(editor);
    }
}

/* ---- spans ---- */

/* The distance of two places of the page, wherever they are seen. */
static void spans_are_measured_on_the_page(void **state) {
    (void)state;
    for (int v = 0; v < VIEW_COUNT; v++) {
        unsigned char bytes[HEAD_ROOM];
        double at[2], value = 0;
        bat_curve *curve = pen_curve(200, 400, 60, 20, 11);
        bat_editor *editor = editor_with(1, &curve);
        assert_int_equal(bat_editor_add_picture(editor, bytes, head_png(bytes, 200, 100), "car.png"), BAT_OK);
        bat_editor_command(editor, "zoom-100");
        for (int i = 0; i < VIEWS[v][0]; i++) bat_editor_command(editor, "orbit-up");
        assert_int_equal(bat_editor_command(editor, "tool-span"), BAT_OK);
        pen p = pen_for(editor);
        static const double places[2][2] = {{430, 380}, {520, 500}};
        for (int i = 0; i < 2; i++) {
            seen(editor, 2, places[i], at);
            tap(&p, at[0], at[1]);
        }
        assert_int_equal(bat_editor_get(editor, "picture-span", &value), BAT_OK);
        assert_true(fabs(value - 150) < 0.1); /* pens have hundredths of a pixel */
        drag(&p, at[0], at[1], at[0] + 30, at[1]);
        assert_int_equal(bat_editor_get(editor, "picture-span", &value), BAT_OK);
        assert_true(fabs(value - 150) > 5);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_int_equal(frame->label_count, 1);
        assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
        bat_editor_get(editor, "picture-span", &value);
        assert_true(value == 0);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_seen_under_the_eraser_goes),
        cmocka_unit_test(an_eraser_that_is_given_up),
        cmocka_unit_test(a_stretch_in_space_is_erased),
        cmocka_unit_test(lines_lie_on_the_page),
        cmocka_unit_test(lines_lie_on_a_plane),
        cmocka_unit_test(lines_that_change_their_ground),
        cmocka_unit_test(edge_on_nothing_begins),
        cmocka_unit_test(spans_are_measured_on_the_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
