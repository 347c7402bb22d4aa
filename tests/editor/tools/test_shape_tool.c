/* The shape tools: rectangles, ellipses, polygons. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/measure.h>

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* An empty page of 1000 x 800, nothing of which snaps, with the tool. */
static bat_editor *drawing(const char *tool) {
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    bat_editor *editor = editor_of(document);
    bat_editor_set(editor, "snap", 0);
    assert_int_equal(bat_editor_command(editor, tool), BAT_OK);
    return editor;
}

static const bat_curve *only_curve(const bat_editor *editor) {
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    const bat_object *made = bat_document_at(bat_editor_document(editor), 0);
    assert_int_equal(bat_object_curve_count(made), 1);
    assert_true(has(editor, bat_object_id(made)) && selected(editor) == 1);
    assert_true(bat_curve_is_closed(bat_object_curve(made, 0)));
    return bat_object_curve(made, 0);
}

static void is_in(const bat_curve *curve, double x0, double y0, double x1, double y1) {
    double low[2], high[2];
    bat_curve_bounds(curve, low, high);
    assert_true(fabs(low[0] - x0) < 1e-9 && fabs(low[1] - y0) < 1e-9);
    assert_true(fabs(high[0] - x1) < 1e-9 && fabs(high[1] - y1) < 1e-9);
}

static void rectangles(void **state) {
    (void)state;
    static const struct {
        double from[2], to[2];
        uint32_t keys;
        double box[4];
    } cases[] = {{{100, 100}, {400, 300}, 0, {100, 100, 400, 300}},
                 {{400, 300}, {100, 100}, 0, {100, 100, 400, 300}},
                 {{100, 100}, {400, 300}, BAT_SHIFT, {100, 100, 400, 400}},
                 {{400, 400}, {300, 100}, BAT_SHIFT, {100, 100, 400, 400}},
                 {{400, 400}, {500, 450}, BAT_ALT, {300, 350, 500, 450}},
                 {{400, 400}, {500, 450}, BAT_ALT | BAT_SHIFT, {300, 300, 500, 500}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = drawing("tool-rectangle");
        const uint64_t first = digest(editor);
        pen p = mouse(editor);
        drag_holding(&p, cases[i].from[0], cases[i].from[1], cases[i].to[0], cases[i].to[1], cases[i].keys);
        const bat_curve *curve = only_curve(editor);
        const double *b = cases[i].box;
        is_in(curve, b[0], b[1], b[2], b[3]);
        assert_true(fabs(fabs(bat_curve_area(curve)) - (b[2] - b[0]) * (b[3] - b[1])) < 1e-6);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

static void round_corners(void **state) {
    (void)state;
    static const double radii[] = {1, 40, 100, 5000};
    for (int i = 0; i < 4; i++) {
        bat_editor *editor = drawing("tool-rectangle");
        bat_editor_set(editor, "corner-radius", radii[i]);
        pen p = mouse(editor);
        drag(&p, 100, 100, 400, 300);
        const double r = fmin(radii[i], 100); /* half the shorter side */
        is_in(only_curve(editor), 100, 100, 400, 300);
        assert_true(fabs(fabs(bat_curve_area(only_curve(editor))) - 60000 + (4 - PI) * r * r) < 2e-3 * r * r);
        bat_editor_free(editor);
    }
}

static void ellipses(void **state) {
    (void)state;
    bat_editor *editor = drawing("tool-ellipse");
    pen p = mouse(editor);
    drag(&p, 100, 100, 500, 300);
    const bat_curve *curve = only_curve(editor);
    is_in(curve, 100, 100, 500, 300);
    double u[200];
    bat_curve_spread(curve, 200, u);
    for (int i = 0; i < 200; i++) {
        double x[6];
        bat_curve_eval(curve, u[i], 2, x);
        const double away = hypot((x[0] - 300) / 200, (x[1] - 200) / 100);
        assert_true(fabs(away - 1) < 3e-4);
    }
    bat_editor_command(editor, "undo");
    drag_holding(&p, 300, 300, 380, 310, BAT_SHIFT | BAT_ALT);
    is_in(only_curve(editor), 220, 220, 380, 380);
    bat_editor_free(editor);
}

static void polygons(void **state) {
    (void)state;
    static const int sides[] = {3, 6, 7, 40};
    for (int i = 0; i < 4; i++) {
        bat_editor *editor = drawing("tool-polygon");
        bat_editor_set(editor, "polygon-sides", sides[i]);
        pen p = mouse(editor);
        drag(&p, 500, 400, 620, 490); /* 150 away */
        const bat_curve *curve = only_curve(editor);
        assert_true(fabs(fabs(bat_curve_area(curve)) - 0.5 * sides[i] * 150 * 150 * sin(2 * PI / sides[i])) <
                    1e-6);
        double domain[2];
        bat_curve_domain(curve, domain);
        assert_true(fabs(bat_curve_length(curve, domain[0], domain[1], 1e-12) -
                         300 * sides[i] * sin(PI / sides[i])) < 1e-6);
        bat_editor_command(editor, "undo");
        drag_holding(&p, 500, 400, 600, 401, BAT_SHIFT); /* to the right */
        double low[2], high[2];
        bat_curve_bounds(only_curve(editor), low, high);
        assert_true(fabs(high[0] - 500 - hypot(100, 1)) < 1e-9);
        bat_editor_free(editor);
    }
}

/* A click makes one whose corner, or of a polygon whose middle, is there; its width is asked for. */
static void a_click_asks_for_the_size(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-rectangle", "tool-ellipse", "tool-polygon"};
    for (int i = 0; i < 3; i++) {
        bat_editor *editor = drawing(tools[i]);
        const uint64_t first = digest(editor);
        pen p = mouse(editor);
        click(&p, 300, 200, 0);
        assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_SIZE);
        if (i < 2) is_in(only_curve(editor), 300, 200, 460, 360); /* a fifth of 800 */
        assert_int_equal(bat_editor_enter(editor, "width", "400"), BAT_OK);
        assert_int_equal(bat_editor_enter(editor, "height", "100"), BAT_OK);
        if (i < 2) is_in(only_curve(editor), 300, 200, 700, 300);
        bat_editor_command(editor, "undo");
        bat_editor_command(editor, "undo");
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* A drag without a height, and one that is cancelled leave the drawing as it was. */
static void nothing_is_drawn(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-rectangle", "tool-ellipse", "tool-polygon"};
    for (int i = 0; i < 3; i++) {
        bat_editor *editor = drawing(tools[i]);
        const uint64_t first = digest(editor);
        pen p = mouse(editor);
        if (i < 2) drag(&p, 300, 300, 500, 300);
        drag_to(&p, 300, 300, 500, 450);
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        pen_event(&p, BAT_POINTER_UP, 500, 450);
        check(editor);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
        assert_true(digest(editor) == first);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE);
        bat_editor_free(editor);
    }
}

/* Twice as large a radius by dragging its handle; then by its number; then it is moved, turned, and stays a rectangle; a point of it
 * that is moved makes it a curve without a word, and undo a rectangle. */
static void a_rectangle_stays_one(void **state) {
    (void)state;
    bat_editor *editor = drawing("tool-rectangle");
    const uint64_t first = digest(editor);
    pen p = mouse(editor);
    drag(&p, 100, 100, 400, 300);
    bat_editor_command(editor, "tool-select");
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "0 px");
    assert_string_equal(bat_editor_number(editor, "shape-sides"), "");
    drag(&p, 385, 115, 365, 135); /* 15 within the corner */
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "20 px");
    is_in(only_curve(editor), 100, 100, 400, 300);
    drag(&p, 380, 120, 360, 140);
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "40 px");
    assert_int_equal(bat_editor_enter(editor, "shape-radius", "500"), BAT_OK);
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "100 px"); /* no more than fits */
    assert_int_equal(bat_editor_enter(editor, "shape-radius", "25"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "turn", "30"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "x", "50"), BAT_OK);
    const bat_object *made = bat_document_at(bat_editor_document(editor), 0);
    assert_int_equal(bat_object_kind(made), BAT_KIND_PRIMITIVE);
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "25 px");
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_enter(editor, "width", "500"), BAT_OK); /* of the turned one: skewed */
    assert_int_equal(bat_object_kind(bat_document_at(bat_editor_document(editor), 0)), BAT_KIND_PATH);
    assert_string_equal(bat_editor_number(editor, "shape-radius"), "");
    assert_string_equal(bat_editor_frame(editor)->notice, "");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void a_polygon_becomes_a_star(void **state) {
    (void)state;
    bat_editor *editor = drawing("tool-polygon");
    const uint64_t first = digest(editor);
    pen p = mouse(editor);
    drag(&p, 500, 400, 700, 400); /* six sides, a corner to the right */
    bat_editor_command(editor, "tool-select");
    const double near = 200 * cos(PI / 6);
    drag(&p, 500 + near * cos(PI / 6), 400 + near * sin(PI / 6), 500 + near / 2 * cos(PI / 6),
         400 + near / 2 * sin(PI / 6));
    assert_string_equal(bat_editor_number(editor, "shape-depth"), "50");
    assert_true(fabs(fabs(bat_curve_area(only_curve(editor))) - 12 * 0.5 * 200 * (near / 2) * sin(PI / 6)) <
                10);
    assert_int_equal(bat_editor_enter(editor, "shape-sides", "5"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "shape-roundness", "40"), BAT_OK);
    assert_string_equal(bat_editor_number(editor, "shape-sides"), "5");
    assert_string_equal(bat_editor_number(editor, "shape-roundness"), "40");
    assert_int_equal(bat_editor_enter(editor, "width", "500"), BAT_OK); /* stretched, it is one */
    assert_int_equal(bat_object_kind(bat_document_at(bat_editor_document(editor), 0)), BAT_KIND_PRIMITIVE);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void an_ellipse_becomes_a_pie(void **state) {
    (void)state;
    bat_editor *editor = drawing("tool-ellipse");
    const uint64_t first = digest(editor);
    pen p = mouse(editor);
    drag(&p, 300, 200, 700, 600);
    bat_editor_command(editor, "tool-select");
    assert_string_equal(bat_editor_number(editor, "shape-end"), "360°");
    drag(&p, 685, 400, 500, 300); /* a quarter, counterclockwise */
    assert_string_equal(bat_editor_number(editor, "shape-end"), "90°");
    is_in(only_curve(editor), 500, 200, 700, 400);
    assert_true(fabs(fabs(bat_curve_area(only_curve(editor))) - PI * 1e4) < 3e-4 * PI * 1e4);
    assert_non_null(strstr(bat_editor_actions(editor), "arc-chord"));
    assert_int_equal(bat_editor_command(editor, "arc-chord"), BAT_OK);
    assert_null(strstr(bat_editor_actions(editor), "arc-chord"));
    assert_true(fabs(fabs(bat_curve_area(only_curve(editor))) - (PI - 2) * 1e4) < 3e-4 * PI * 1e4);
    assert_int_equal(bat_editor_command(editor, "arc-open"), BAT_OK);
    assert_false(bat_curve_is_closed(bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0)));
    assert_int_equal(bat_editor_command(editor, "arc-pie"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "shape-start", "45"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "shape-end", "405"), BAT_OK); /* all of it */
    assert_string_equal(bat_editor_number(editor, "shape-end"), "360°");
    assert_int_equal(bat_editor_command(editor, "arc-pie"), BAT_STATE); /* it is none */
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles),
        cmocka_unit_test(round_corners),
        cmocka_unit_test(ellipses),
        cmocka_unit_test(polygons),
        cmocka_unit_test(a_click_asks_for_the_size),
        cmocka_unit_test(nothing_is_drawn),
        cmocka_unit_test(a_rectangle_stays_one),
        cmocka_unit_test(a_polygon_becomes_a_star),
        cmocka_unit_test(an_ellipse_becomes_a_pie),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
