/* Paths of several curves: changing one curve leaves the others, and the object, as they are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "support/editing.h"
#include <batten/editor.h>
#include <batten/measure.h>

static const bat_object *object_at(const bat_editor *editor, int index) {
    return bat_document_at(bat_editor_document(editor), index);
}

static int objects(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }
static bat_curve *ring(double x, double y) {
    double points[16], knots[9];
    for (int i = 0; i < 8; i++) {
        points[2 * i] = x + 60 * cos(0.785398163397448309 * i);
        points[2 * i + 1] = y + 60 * sin(0.785398163397448309 * i);
    }
    for (int i = 0; i <= 8; i++) knots[i] = i;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 8, points, 9, knots, &curve), BAT_OK);
    return curve;
}

static void add(bat_document *document, int count, bat_curve **curves) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_id id = bat_document_new_id(document);
    assert_int_equal(bat_object_create_path(id, "compound", &style, count, curves, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

/* One object: lines at y = 200 and y = 600, x from 200 to 800, and a ring about (500, 400) between them. */
static bat_editor *compound_editor(void) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    add(document, 3,
        (bat_curve *[]){pen_curve(200, 200, 60, 0, 11), ring(500, 400), pen_curve(200, 600, 60, 0, 11)});
    return editor_of(document);
}

static bool same(const bat_curve *a, const bat_curve *b) {
    return bat_point_count(a) == bat_point_count(b) && bat_curve_is_closed(a) == bat_curve_is_closed(b) &&
           memcmp(bat_curve_points(a), bat_curve_points(b),
                  2 * (size_t)bat_point_count(a) * sizeof(double)) == 0;
}

/* The journal replays, and one undo leads back to what was there. */
static void settle(bat_editor *editor, uint64_t before) {
    check(editor);
    assert_true(digest(editor) != before);
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

static void one_is_redrawn(void **state) {
    (void)state;
    bat_editor *editor = compound_editor(), *fresh = compound_editor();
    const uint64_t before = digest(editor);
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 350, 200);
    bat_editor_frame(editor);
    pen_line(&p, 350, 200, 650, 200, 40);
    const bat_object *now = object_at(editor, 0), *old = object_at(fresh, 0);
    assert_int_equal(objects(editor), 1);
    assert_int_equal(bat_object_curve_count(now), 3);
    assert_false(same(bat_object_curve(now, 0), bat_object_curve(old, 0)));
    for (int i = 1; i < 3; i++) assert_true(same(bat_object_curve(now, i), bat_object_curve(old, i)));
    bat_editor_free(fresh);
    settle(editor, before);
}

/* By a stroke from end to end, and by the command: two lines become one, the ring stays. */
static void two_are_joined(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++) {
        bat_editor *editor = compound_editor(), *fresh = compound_editor();
        const uint64_t before = digest(editor);
        pen p = pen_for(editor);
        if (way == 0) {
            pen_line(&p, 800, 200, 800, 600, 100);
        } else {
            bat_editor_command(editor, "select-all");
            assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
        }
        const bat_object *now = object_at(editor, 0);
        assert_int_equal(objects(editor), 1);
        assert_int_equal(bat_object_curve_count(now), 2);
        int rings = 0;
        for (int i = 0; i < 2; i++)
            rings += same(bat_object_curve(now, i), bat_object_curve(object_at(fresh, 0), 1));
        assert_int_equal(rings, 1);
        bat_editor_free(fresh);
        settle(editor, before);
    }
}

/* The second object gives its line to the first and keeps its ring. */
static void the_rest_stays(void **state) {
    (void)state;
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    add(document, 1, (bat_curve *[]){pen_curve(200, 200, 60, 0, 11)});
    add(document, 2, (bat_curve *[]){ring(500, 400), pen_curve(200, 600, 60, 0, 11)});
    bat_editor *editor = editor_of(document);
    const uint64_t before = digest(editor);
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_int_equal(objects(editor), 2);
    assert_int_equal(bat_object_curve_count(object_at(editor, 0)), 1);
    assert_int_equal(bat_object_curve_count(object_at(editor, 1)), 1);
    assert_true(bat_curve_is_closed(bat_object_curve(object_at(editor, 1), 0)));
    settle(editor, before);
}

/* One is rubbed out whole. */
static void one_is_erased(void **state) {
    (void)state;
    bat_editor *editor = compound_editor(), *fresh = compound_editor();
    const uint64_t before = digest(editor);
    bat_editor_command(editor, "tool-eraser");
    pen p = pen_for(editor);
    pen_line(&p, 150, 200, 850, 200, 0);
    const bat_object *now = object_at(editor, 0), *old = object_at(fresh, 0);
    assert_int_equal(objects(editor), 1);
    assert_int_equal(bat_object_curve_count(now), 2);
    for (int i = 0; i < 2; i++) assert_true(same(bat_object_curve(now, i), bat_object_curve(old, i + 1)));
    bat_editor_free(fresh);
    settle(editor, before);
}

/* Closing, opening and turning round do what applies to each. */
static void all_at_once(void **state) {
    (void)state;
    static const struct {
        const char *command;
        int closed; /* of the three, afterwards */
    } rows[] = {{"curve-close", 3}, {"curve-open", 0}, {"curve-reverse", 1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bat_editor *editor = compound_editor();
        const uint64_t before = digest(editor);
        bat_editor_command(editor, "select-all");
        assert_int_equal(bat_editor_command(editor, rows[i].command), BAT_OK);
        const bat_object *now = object_at(editor, 0);
        assert_int_equal(bat_object_curve_count(now), 3);
        int closed = 0;
        for (int k = 0; k < 3; k++) closed += bat_curve_is_closed(bat_object_curve(now, k));
        assert_int_equal(closed, rows[i].closed);
        settle(editor, before);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_is_redrawn), cmocka_unit_test(two_are_joined),
                                       cmocka_unit_test(the_rest_stays), cmocka_unit_test(one_is_erased),
                                       cmocka_unit_test(all_at_once)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
