/* A skeleton that goes along a curve of the drawing: laid out it changes nothing; where the curve goes the walk goes, feet and all, and
 * bones keep their length; deleted, it stays; kept in files; undone; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "document/document.h"
#include "document/follow.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/walking.h"

enum { FRAMES = 40, TIMES = 23, BODY = 5, NUMBERS = 3 * WALKER_JOINTS * TIMES };

static bat_document *walk(double tolerance) { return walking(6, FRAMES, tolerance, BODY); }

static bat_editor *opened(double tolerance) {
    bat_editor *editor = editor_of(walk(tolerance));
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, BODY, 0);
    bat_editor_frame(editor);
    return editor;
}

static const bat_object *body_in(const bat_document *document) {
    return bat_document_at(document, bat_document_find(document, BODY));
}

/* All joints at many times, in the drawing. */
static void joints(const bat_document *document, double *out) {
    double place[12];
    const bat_motion *motion = bat_object_motion(body_in(document), place);
    for (int t = 0; t < TIMES; t++) {
        double at[3 * WALKER_JOINTS];
        assert_int_equal(bat_motion_positions(motion, bat_motion_duration(motion) * t / (TIMES - 1), at),
                         BAT_OK);
        for (int i = 0; i < WALKER_JOINTS; i++)
            for (int k = 0; k < 3; k++)
                *out++ = place[4 * k] * at[3 * i] + place[4 * k + 1] * at[3 * i + 1] +
                         place[4 * k + 2] * at[3 * i + 2] + place[4 * k + 3];
    }
}

static double furthest(const double *a, const double *b) {
    double most = 0;
    for (int i = 0; i < NUMBERS; i++) most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

static double length_of(const double *at, int t, int joint) {
    const double *p = at + 3 * (t * WALKER_JOINTS + joint);
    const double *q = at + 3 * (t * WALKER_JOINTS + WALKER_BONES[joint].parent);
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

/* The curve that is followed goes where the matrix takes it. */
static void move_path(bat_document *document, const double matrix[12]) {
    const bat_id id = bat_object_followed(body_in(document));
    const int at = bat_document_find(document, id);
    bat_curve *curve = NULL;
    bat_object *moved = NULL;
    assert_int_equal(bat_curve_transform(bat_object_curve(bat_document_at(document, at), 0), matrix, &curve),
                     BAT_OK);
    assert_int_equal(bat_object_with_curve(bat_document_at(document, at), 0, curve, &moved), BAT_OK);
    assert_int_equal(bat_document_replace(document, at, moved), BAT_OK);
    bat_object_release(moved);
    assert_int_equal(bat_document_follow(document), BAT_OK);
    assert_null(bat_document_check(document));
}

/* The path is a curve of few points, which is selected; nothing moves; one step, which is undone and replayed. */
static void laid_out_it_stands_as_it_did(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++) {
        double before[NUMBERS], after[NUMBERS];
        bat_editor *editor = opened(way ? 0.5 : 0);
        const uint64_t first = digest(editor);
        joints(bat_editor_document(editor), before);
        assert_int_equal(bat_editor_command(editor, "body-path"), BAT_OK);
        bat_editor_frame(editor);
        joints(bat_editor_document(editor), after);
        assert_true(furthest(before, after) < 1e-9);
        const bat_document *document = bat_editor_document(editor);
        assert_int_equal(bat_document_count(document), 2);
        const bat_id path = bat_object_followed(body_in(document));
        assert_true(path != 0 && bat_document_find(document, path) >= 0);
        const bat_object *laid = bat_document_at(document, bat_document_find(document, path));
        assert_int_equal(bat_curve_count(bat_object_curve(laid, 0)), 4); /* of less than a second */
        check(editor);
        assert_int_equal(bat_editor_command(editor, "body-path"),
                         BAT_STATE); /* the curve is selected, alone */
        bat_editor_select(editor, BODY, 0);
        assert_int_equal(bat_editor_command(editor, "body-path"), BAT_STATE); /* it goes along it already */
        replays(editor, 6);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* Shifted, and turned about the upright, the walk goes with its path as a whole; so it does when it is bent, and its bones keep
 * their lengths. */
static void goes_where_the_curve_goes(void **state) {
    (void)state;
    const double shift[12] = {1, 0, 0, 30, 0, 1, 0, -12, 0, 0, 1, 55};
    const double c = cos(0.7), s = sin(0.7), turn[12] = {c, 0, s, 5, 0, 1, 0, 0, -s, 0, c, 9};
    const double bend[12] = {1, 0, 0.8, 0, 0.1, 1, 0.2, 0, 0.3, 0, 1.4, 0};
    const double *const matrices[3] = {shift, turn, bend};
    for (int way = 0; way < 3; way++) {
        double before[NUMBERS], after[NUMBERS], rest[NUMBERS];
        const double *m = matrices[way];
        bat_editor *editor = opened(0.5);
        assert_int_equal(bat_editor_command(editor, "body-path"), BAT_OK);
        bat_document *document = NULL;
        assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
        joints(document, before);
        move_path(document, m);
        joints(document, after);
        for (int i = 0; i < NUMBERS; i += 3)
            for (int k = 0; k < 3; k++)
                rest[i + k] = m[4 * k] * before[i] + m[4 * k + 1] * before[i + 1] +
                              m[4 * k + 2] * before[i + 2] + m[4 * k + 3];
        if (way < 2) assert_true(furthest(after, rest) < 1e-8);
        if (way == 2) assert_true(furthest(after, before) > 1);
        for (int t = 0; t < TIMES; t++)
            for (int i = 1; i < WALKER_JOINTS; i++)
                assert_true(fabs(length_of(after, t, i) - length_of(before, t, i)) <
                            1e-12 * (1 + fabs(after[2]) + length_of(before, t, i)) * 10);
        const uint64_t settled = bat_document_digest(document);
        assert_int_equal(bat_document_follow(document), BAT_OK); /* it is as it has to be */
        assert_true(bat_document_digest(document) == settled);
        bat_document_free(document);
        bat_editor_free(editor);
    }
}

/* Without its curve it stays where it is; undo brings both back. */
static void stays_when_the_curve_is_deleted(void **state) {
    (void)state;
    double before[NUMBERS], after[NUMBERS];
    bat_editor *editor = opened(0.5);
    assert_int_equal(bat_editor_command(editor, "body-path"), BAT_OK);
    const bat_id path = bat_object_followed(body_in(bat_editor_document(editor)));
    const uint64_t led = digest(editor);
    joints(bat_editor_document(editor), before);
    bat_editor_select(editor, path, 0);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    bat_editor_frame(editor);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    assert_true(bat_object_followed(body_in(bat_editor_document(editor))) == 0);
    joints(bat_editor_document(editor), after);
    assert_true(furthest(before, after) == 0);
    check(editor);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == led);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    replays(editor, 6);
    bat_editor_free(editor);
}

static bat_id add_path(bat_document *document, bool closed) {
    const double points[12] = {0, 0, 60, 40, 120, -30, 200, 10}, knots[5] = {0, 1, 2, 3, 4};
    const bat_style style = bat_style_defaults();
    const bat_id id = bat_document_new_id(document);
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    if (closed)
        assert_int_equal(bat_curve_create(2, 3, true, 4, points, 5, knots, &curve), BAT_OK);
    else
        assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &curve), BAT_OK);
    assert_int_equal(bat_object_create_path(id, "", &style, 1, &curve, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 1, object), BAT_OK);
    bat_object_release(object);
    return id;
}

/* Along a curve of the page, selected with it: the root is over the curve's points; a closed one is refused. */
static void goes_along_a_curve_that_is_selected(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++) {
        bat_document *document = walk(0.5);
        const bat_id path = add_path(document, closed);
        bat_editor *editor = editor_of(document);
        bat_editor_command(editor, "tool-select");
        bat_editor_select(editor, BODY, 0);
        bat_editor_select(editor, path, 1);
        bat_editor_frame(editor);
        const uint64_t first = digest(editor);
        assert_non_null(strstr(bat_editor_actions(editor), "body-path"));
        assert_int_equal(bat_editor_command(editor, "body-path"), closed ? BAT_STATE : BAT_OK);
        check(editor);
        const bat_object *body = body_in(bat_editor_document(editor));
        assert_int_equal(bat_object_followed(body), closed ? 0 : path);
        if (closed) assert_true(digest(editor) == first);
        bat_motion *motion = NULL;
        double place[12], at[3 * WALKER_JOINTS], point[3];
        assert_int_equal(bat_motion_copy(bat_object_motion(body, place), &motion), BAT_OK);
        for (int level = 1; level <= bat_motion_levels(motion); level++)
            assert_int_equal(bat_motion_set_gain(motion, -1, level, 0), BAT_OK);
        for (int i = 0; i <= 10 && !closed; i++) { /* without its details the root is on it */
            double domain[2];
            const bat_curve *curve = bat_object_curve(
                bat_document_at(bat_editor_document(editor),
                                bat_document_find(bat_editor_document(editor), path)),
                0);
            bat_curve_domain(curve, domain);
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 10, 0, point);
            assert_int_equal(bat_motion_positions(motion, bat_motion_duration(motion) * i / 10, at), BAT_OK);
            assert_true(fabs(at[0] - point[0]) < 1e-9 && fabs(at[1] + point[1]) < 1e-9 && fabs(at[2]) < 1e-9);
        }
        bat_motion_free(motion);
        bat_editor_free(editor);
    }
}

/* Written and read, it follows what it followed, bit for bit; what follows itself, or nothing that is there, is refused. */
static void is_kept_in_files(void **state) {
    (void)state;
    bat_editor *editor = opened(0.5);
    assert_int_equal(bat_editor_command(editor, "body-path"), BAT_OK);
    bat_document *again = NULL;
    char *text = NULL, *follows;
    size_t size;
    assert_int_equal(bat_document_write(bat_editor_document(editor), &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
    assert_true(bat_document_digest(again) == digest(editor));
    assert_true(bat_object_followed(body_in(again)) ==
                bat_object_followed(body_in(bat_editor_document(editor))));
    bat_document_free(again), again = NULL;
    follows = strstr(text, "\"follows\":");
    assert_non_null(follows);
    for (int i = 0; i < 2; i++) {
        follows[10] = i ? '4' : '0' + BODY;
        assert_true(bat_document_read(text, size, &again, NULL) != BAT_OK);
        assert_null(again);
    }
    bat_free(text);
    bat_editor_free(editor);
}

static bat_status follows_once(const bat_document *from) {
    const double shear[12] = {1, 0, 0.4, 2, 0, 1, 0.1, 0, 0, 0, 1.2, 0};
    bat_document *document = NULL;
    bat_curve *curve = NULL;
    bat_object *moved = NULL;
    bat_status status = bat_document_copy(from, &document);
    const int at = bat_document_find(from, bat_object_followed(body_in(from)));
    const bat_object *path = bat_document_at(from, at);
    if (status == BAT_OK) status = bat_curve_transform(bat_object_curve(path, 0), shear, &curve);
    if (status == BAT_OK) status = bat_object_with_curve(path, 0, curve, &moved);
    if (status == BAT_OK) status = bat_document_replace(document, at, moved);
    if (status == BAT_OK) status = bat_document_follow(document);
    if (status == BAT_OK) status = bat_document_remove(document, at);
    if (status == BAT_OK) status = bat_document_let_go(document);
    bat_object_release(moved);
    bat_document_free(document);
    return status;
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_editor *editor = opened(0.5);
    assert_int_equal(bat_editor_command(editor, "body-path"), BAT_OK);
    bool reached = true;
    for (long n = 1; reached; n += 1 + n / 40) {
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = follows_once(bat_editor_document(editor));
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_int_equal(alloc_live(), before);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(laid_out_it_stands_as_it_did),
                                       cmocka_unit_test(goes_where_the_curve_goes),
                                       cmocka_unit_test(stays_when_the_curve_is_deleted),
                                       cmocka_unit_test(goes_along_a_curve_that_is_selected),
                                       cmocka_unit_test(is_kept_in_files),
                                       cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
