/*
 * What strokes mean in the editor: each reading is carried out as one step that replays and can be undone; the
 * selection, the setting and the held key decide what may change; a stroke can be reinterpreted without another step.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

/* An editor whose curves are lines between these ends. */
static bat_editor *lines_editor(int lines, const double (*ends)[4]) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < lines; i++) {
        double points[8];
        const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
        bat_curve *curve = NULL;
        for (int k = 0; k < 4; k++)
            for (int d = 0; d < 2; d++)
                points[2 * k + d] = ends[i][d] + (ends[i][2 + d] - ends[i][d]) * k / 3;
        assert_int_equal(bat_curve_create(2, 3, false, 4, points, 8, knots, &curve), BAT_OK);
        pen_add(document, curve);
    }
    editor = editor_of(document);
    return editor;
}

static const bat_curve *curve(const bat_editor *editor, int object) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), object), 0);
}

static void end_of(const bat_curve *of, int end, double out[2]) {
    double domain[2];
    bat_curve_domain(of, domain);
    bat_curve_eval(of, domain[end], 0, out);
}

/* As it is stored: evaluation rounds. */
static void point_of(const bat_curve *of, int end, double out[2]) {
    memcpy(out, bat_curve_points(of) + (end ? 2 * (bat_curve_count(of) - 1) : 0), 2 * sizeof *out);
}

static void ends_are_extended(void **state) {
    (void)state;
    bat_editor *editor = lines_editor(1, (const double[][4]){{100, 300, 500, 300}});
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_line(&p, 501, 301, 640, 320, 0);
    double at[2];
    assert_int_equal(count(editor), 1);
    end_of(curve(editor, 0), 1, at);
    assert_true(fabs(at[0] - 640) < 4 && fabs(at[1] - 320) < 3);
    end_of(curve(editor, 0), 0, at);
    assert_true(at[0] == 100 && at[1] == 300);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void own_ends_close(void **state) {
    (void)state;
    const double knots[] = {0, 0, 0, 0, 1, 2, 2, 2, 2},
                 points[] = {400, 300, 300, 250, 250, 450, 500, 500, 500, 300};
    bat_curve *cup = NULL;
    bat_editor *editor = lines_editor(0, NULL);
    assert_int_equal(bat_curve_create(2, 3, false, 5, points, 9, knots, &cup), BAT_OK);
    bat_document *document = NULL;
    bat_document_create(&document);
    pen_add(document, cup);
    assert_int_equal(bat_editor_open(editor, document, "test"), BAT_OK);
    bat_editor_command(editor, "zoom-100");
    const double *view = bat_editor_frame(editor)->view;
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_line(&p, 500 - view[0], 300 - view[1], 400 - view[0], 300 - view[1], -12);
    assert_int_equal(count(editor), 1);
    assert_true(bat_curve_is_closed(curve(editor, 0)));
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* Bit for bit together, whichever way the curves run and the stroke goes. */
static void joints_stay_joints(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) {
        const double two[][4] = {{100, 300, 400, 300}, {400, 300, 700, 300}};
        const double turned[][4] = {{100, 300, 400, 300}, {700, 300, 400, 300}};
        bat_editor *editor = lines_editor(2, way & 1 ? turned : two);
        uint64_t first = digest(editor);
        pen p = pen_for(editor);
        if (way & 2)
            pen_line(&p, 600, 301, 200, 301, 14);
        else
            pen_line(&p, 200, 301, 600, 301, 14);
        double a[2], b[2];
        assert_int_equal(count(editor), 2);
        point_of(curve(editor, 0), 1, a);
        point_of(curve(editor, 1), way & 1 ? 1 : 0, b);
        assert_true(a[0] == b[0] && a[1] == b[1]);
        assert_true(fabs(a[1] - 300) > 5); /* it went with the stroke */
        end_of(curve(editor, 0), 0, a);
        assert_true(a[0] == 100 && a[1] == 300);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

static void held_at_the_joint(void **state) {
    (void)state;
    const double two[][4] = {{100, 300, 400, 300}, {400, 300, 500, 500}};
    bat_editor *editor = lines_editor(2, two);
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_line(&p, 180, 300, 394, 303, 10);
    double at[2];
    end_of(curve(editor, 0), 1, at);
    assert_true(at[0] == 400 && at[1] == 300);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void new_lines_start_on_lines(void **state) {
    (void)state;
    bat_editor *editor = lines_editor(1, (const double[][4]){{100, 300, 600, 300}});
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_line(&p, 350, 303, 350, 480, 6);
    double at[2];
    assert_int_equal(count(editor), 2);
    end_of(curve(editor, 1), 0, at);
    assert_true(fabs(at[1] - 300) < 1e-9 && fabs(at[0] - 350) < 3);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* A line as long as another beside it is a second one; one that comes to lie on it redraws it. */
static void a_second_line_beside(void **state) {
    (void)state;
    for (int apart = 8; apart <= 30; apart += 2) {
        bat_editor *editor = lines_editor(1, (const double[][4]){{200, 300, 500, 300}});
        pen p = pen_for(editor);
        pen_line(&p, 205, 300 + apart, 495, 300 + apart, 0);
        if (count(editor) != 2) fail_msg("%d px apart it is no second line", apart);
        bat_editor_free(editor);
        editor = lines_editor(1, (const double[][4]){{200, 300, 500, 300}});
        p = pen_for(editor);
        pen_line(&p, 215, 300, 485, 300, apart);
        assert_int_equal(count(editor), 1);
        bat_editor_free(editor);
    }
}

/* Both ends of a new line meet what they were drawn to; in small writing nothing is pulled. */
static void both_ends_meet(void **state) {
    (void)state;
    for (int small = 0; small < 2; small++) {
        const double k = small ? 0.08 : 1;
        bat_editor *editor = lines_editor(
            2, (const double[][4]){{200, 300, 200 + 300 * k, 300},
                                   {200, 300 + 200 * k, 200 + 300 * k, 300 + 200 * k}});
        double at[2];
        pen p = pen_for(editor);
        pen_line(&p, 200 + 120 * k, 302, 200 + 160 * k, 298 + 200 * k, 0);
        assert_int_equal(count(editor), 3);
        for (int end = 0; end < 2; end++) {
            point_of(curve(editor, 2), end, at);
            const double off = fabs(at[1] - (end ? 300 + 200 * k : 300));
            if (small) assert_true(off > 1);
            if (!small) assert_true(off < 1e-6);
        }
        bat_editor_free(editor);
    }
}

static void only_what_is_selected(void **state) {
    (void)state;
    const double two[][4] = {{100, 300, 600, 300}, {100, 322, 600, 322}};
    bat_editor *editor = lines_editor(2, two);
    assert_int_equal(
        bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false),
        BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tool-sketch"), BAT_OK);
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_line(&p, 160, 316, 540, 316, -2); /* nearer to the other */
    double at[2];
    assert_int_equal(count(editor), 2);
    end_of(curve(editor, 1), 0, at);
    assert_true(at[1] == 322);
    bat_near near;
    assert_int_equal(bat_curve_nearest(curve(editor, 0), (double[]){350, 318}, &near), BAT_OK);
    assert_true(near.distance < 2);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void switch_and_key(void **state) {
    (void)state;
    const double one[][4] = {{100, 300, 600, 300}};
    for (int way = 0; way < 2; way++) {
        bat_editor *editor = lines_editor(1, one);
        uint64_t first = digest(editor);
        pen p = pen_for(editor);
        if (way == 0)
            assert_int_equal(bat_editor_set(editor, "stroke-meaning", 2), BAT_OK);
        else
            assert_true(bat_editor_key(editor, "x", true, 0, 1));
        pen_line(&p, 150, 303, 550, 303, 4);
        assert_int_equal(count(editor), 2);
        if (way) bat_editor_key(editor, "x", false, 0, 2000);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
    bat_editor *editor = lines_editor(1, one);
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_set(editor, "stroke-meaning", 1), BAT_OK);
    pen_line(&p, 150, 600, 550, 600, 4); /* nothing is near */
    assert_true(digest(editor) == first);
    assert_string_equal(bat_editor_frame(editor)->notice, "No curve here to redraw");
    pen_line(&p, 200, 290, 320, 350, 0); /* a new line else */
    assert_int_equal(count(editor), 1);
    assert_true(digest(editor) != first);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void read_again(void **state) {
    (void)state;
    bat_editor *editor = lines_editor(1, (const double[][4]){{100, 300, 600, 300}});
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    assert_false(bat_editor_key(editor, "Tab", true, 0, 1)); /* nothing to read: the host's */
    pen_line(&p, 150, 303, 550, 303, 4);
    uint64_t redrawn = digest(editor);
    assert_int_equal(count(editor), 1);
    assert_true(bat_editor_frame(editor)->readings != 0);
    const char *text = bat_editor_readings(editor);
    assert_non_null(strstr(text, "\"chosen\":0"));
    assert_non_null(strstr(text, "\"Redraw line\""));
    assert_non_null(strstr(text, "\"New line\""));
    uint32_t version = bat_editor_frame(editor)->readings;
    assert_true(bat_editor_key(editor, "Tab", true, 0, 2));
    assert_true(bat_editor_frame(editor)->readings != version);
    assert_int_equal(count(editor), 2);
    check(editor);
    assert_true(bat_editor_key(editor, "Tab", true, BAT_SHIFT, 3));
    assert_true(digest(editor) == redrawn);
    assert_int_equal(bat_editor_read_as(editor, 7), BAT_STATE);
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    assert_int_equal(count(editor), 2);
    pen_event(&p, BAT_POINTER_DOWN, 150, 600); /* the next stroke settles it */
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    assert_int_equal(bat_editor_read_as(editor, 0), BAT_STATE);
    pen_event(&p, BAT_POINTER_CANCEL, 150, 600);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_extended),        cmocka_unit_test(own_ends_close),
        cmocka_unit_test(joints_stay_joints),       cmocka_unit_test(held_at_the_joint),
        cmocka_unit_test(new_lines_start_on_lines), cmocka_unit_test(a_second_line_beside),
        cmocka_unit_test(both_ends_meet),           cmocka_unit_test(only_what_is_selected),
        cmocka_unit_test(switch_and_key),           cmocka_unit_test(read_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
