/* What tools end with, called by itself: curves put into the document and taken out, stretches to be faired, and strokes
 * over levels that the journal asks for. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "editor/edit/affine.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/fair.h"
#include "editor/edit/stroke_record.h"
#include "editor/editor.h"
#include "editor/session/transaction.h"
#include "editor/tools/tangents/draft.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/random_curve.h"
#include "support/sheet.h"
#include <batten/measure.h>
#include <batten/nearest.h>

static void curves_of_objects(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_context *c = &editor->context;
    const bat_document *document = bat_editor_document(editor);
    const uint64_t before = digest(editor);
    const bat_style style = bat_style_defaults();
    assert_non_null(bat_edit_target(document, 1, 0));
    assert_null(bat_edit_target(document, 1, -1));
    assert_null(bat_edit_target(document, 1, 1));
    assert_null(bat_edit_target(document, 9, 0));
    assert_null(bat_edit_target_in(document, 3, 1, 0));
    assert_int_equal(bat_commit_curve(c, 9, 0, pen_curve(0, 0, 10, 5, 7), BAT_STRING_STEP_CHANGE),
                     BAT_ARGUMENT);
    assert_int_equal(bat_commit_curve(c, 1, 5, pen_curve(0, 0, 10, 5, 7), BAT_STRING_STEP_CHANGE),
                     BAT_ARGUMENT);
    assert_int_equal(bat_transaction_begin(c), BAT_OK);
    assert_int_equal(bat_insert_curve(c, 77, &style, 9, pen_curve(0, 0, 10, 5, 7)), BAT_ARGUMENT);
    assert_int_equal(bat_remove_curve(c, 9, 0), BAT_ARGUMENT);
    bat_transaction_cancel(c);
    assert_true(digest(editor) == before);
    check(editor);
    bat_editor_free(editor);
}

/* A curve taken out of three, with each allocation failing: as before, or without it. */
static void taken_out_of_three(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    bat_curve *curves[3];
    bat_object *object = NULL;
    for (int i = 0; i < 3; i++) curves[i] = pen_curve(100 * i, 300, 10, 5, 7);
    assert_int_equal(bat_object_create_path(1, "", &style, 3, curves, &object), BAT_OK);
    const long held = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_object *after = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_without_curve(object, 1, &after);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_true((after == NULL) == reached);
        if (after) {
            assert_int_equal(bat_object_curve_count(after), 2);
            assert_true(bat_curve_is_equal(bat_object_curve(after, 0), bat_object_curve(object, 0)));
            assert_true(bat_curve_is_equal(bat_object_curve(after, 1), bat_object_curve(object, 2)));
        }
        bat_object_release(after);
        assert_true(alloc_live() == held);
    }
    bat_object_release(object);
    bat_editor *editor = pen_editor();
    bat_context *c = &editor->context;
    const uint64_t before = digest(editor);
    for (long n = 1; digest(editor) == before; n++) { /* the last curve of an object goes with the object */
        assert_int_equal(bat_transaction_begin(c), BAT_OK);
        alloc_fail_at(n);
        bat_status status = bat_transaction_end(c, bat_remove_curve(c, 1, 0), BAT_STRING_STEP_REMOVE);
        assert_int_equal(status, alloc_fail_reached() ? BAT_MEMORY : BAT_OK);
        check(editor);
    }
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    bat_editor_free(editor);
}

/* An affine image: strokes grow by the root of the area, or stay. */
static void images(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults(); /* 2 wide */
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7);
    bat_object *object = NULL, *made = NULL, *stays = NULL;
    assert_int_equal(bat_object_create_path(1, "", &style, 1, &curve, &object), BAT_OK);
    static const struct {
        double matrix[6], width;
    } cases[] = {
        {{3, 0, 0, 3, 0, 0}, 6}, {{4, 0, 0, 1, 5, 5}, 4}, {{0, 1, -1, 0, 9, 9}, 2}, {{-1, 0, 0, 1, 0, 0}, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(bat_affine_object(object, cases[i].matrix, true, &made), BAT_OK);
        assert_int_equal(bat_affine_object(object, cases[i].matrix, false, &stays), BAT_OK);
        assert_true(bat_object_style(made)->width == cases[i].width && bat_object_style(stays)->width == 2);
        bat_object_release(made);
        bat_object_release(stays);
    }
    bat_object_release(object);
    bat_surface *sheet = sheet_create();
    made = object = NULL;
    assert_int_equal(bat_object_create_surface(1, "", &style, sheet, &object), BAT_OK);
    bat_status status = bat_affine_object(object, cases[0].matrix, true, &made);
    assert_true(status == BAT_OK ? made != NULL : status == BAT_ARGUMENT && !made);
    bat_object_release(made);
    bat_object_release(object);
    bat_surface_free(sheet);
}

/* The stretch around u holds u, and its ends lie `reach` along the curve away, or at its ends. */
static void stretches(void **state) {
    (void)state;
    random_source r = {9};
    for (int round = 0; round < 200; round++) {
        const bool closed = round % 2;
        bat_curve *curve = random_curve(&r, 3, 2, closed ? 2 : 0, random_int(&r, 3, 12));
        double domain[2], range[2];
        bat_curve_domain(curve, domain);
        const double all = bat_curve_length(curve, domain[0], domain[1], 1e-9), reach = random_unit(&r) * all;
        const double u = domain[0] + random_unit(&r) * (domain[1] - domain[0]);
        bat_fair_range(curve, u, reach, range);
        assert_true(range[0] <= u && u <= range[1]);
        assert_true(range[1] - range[0] <= (domain[1] - domain[0]) * (1 + 1e-9));
        for (int end = 0; end < 2; end++) {
            const double length = bat_curve_length(curve, fmin(u, range[end]), fmax(u, range[end]), 1e-9);
            const bool whole = closed && 2 * reach >= all;
            const bool stopped = !closed && range[end] == domain[end];
            if (!whole && !stopped && !(fabs(length - reach) <= 1e-3 * all))
                fail_msg("%d: %g of %g: %g %g %g", round, reach, all, u, range[0], range[1]);
        }
        bat_curve_free(curve);
    }
}

static void drafts(void **state) {
    (void)state;
    const double points[] = {0, 0, 10, 5, 20, 0, 3, 3};
    const bat_spline deep = {.dimension = 3, .count = 2, .points = points},
                     bare = {.dimension = 2, .count = 3, .points = points};
    bat_spline endless = bare;
    endless.count = BAT_POINTS_MAX;
    bat_draft draft = {0};
    assert_int_equal(bat_draft_load(&draft, &endless), BAT_COUNT);
    assert_int_equal(bat_draft_load(&draft, &bare), BAT_OK);
    assert_int_equal(draft.count, 3);
    for (int i = 0; i < 3; i++) { /* what is not given */
        assert_true(draft.tangents[2 * i] == 0 && draft.tangents[2 * i + 1] == 0);
        assert_true(draft.tension[2 * i] == 1 && draft.tension[2 * i + 1] == 1);
    }
    assert_int_equal(bat_draft_insert(&draft, 1, points + 6), BAT_OK);
    assert_memory_equal(draft.points + 2, points + 6, 2 * sizeof *points);
    const double tangents[] = {1, 2, 3, 4, 5, 6}, tension[] = {1, 2, 3, 4}; /* in space, with room to grow */
    bat_spline given = deep;
    given.tangents = tangents, given.tension = tension;
    assert_int_equal(bat_draft_load(&draft, &given), BAT_OK);
    for (int i = 0; i < 40; i++)
        assert_int_equal(bat_draft_insert(&draft, 1, (const double[]){i, 7, 8}), BAT_OK);
    assert_int_equal(bat_draft_spline(&draft).dimension, 3);
    assert_int_equal(draft.count, 42);
    for (int i = 40; i > 0; i--) {
        assert_true(draft.points[3] == i - 1 && draft.points[5] == 8 && draft.tangents[5] == 0);
        assert_true(draft.tension[2] == 1 && draft.tension[3] == 1);
        bat_draft_remove(&draft, 1);
    }
    assert_memory_equal(draft.points, points, 6 * sizeof *points);
    assert_memory_equal(draft.tangents, tangents, sizeof tangents);
    assert_memory_equal(draft.tension, tension, sizeof tension);
    bat_draft_free(&draft);
}

/* ---- strokes over levels, as a journal says them ---- */

/* A session in which the upper curve has two levels; muted: the first of them is. */
static bat_editor *with_levels(bool muted) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-levels");
    tap(&p, 500, 200);
    bat_editor_command(editor, "take-apart");
    bat_editor_set(editor, "apart-levels", 1);
    bat_editor_command(editor, "accept");
    if (muted) assert_int_equal(bat_editor_level(editor, BAT_LEVEL_MUTE, 1, 1, true), BAT_OK);
    assert_int_equal(bat_shape_levels(bat_object_shape(bat_document_at(bat_editor_document(editor), 0), 0)),
                     1);
    check(editor);
    return editor;
}

enum { STROKE = 60 };
static void place(int i, double x0, double x1, double rise, double out[2]) {
    const double t = (double)i / STROKE;
    out[0] = x0 + (x1 - x0) * t;
    out[1] = 200 - rise * sin(3.14159265358979 * t) * sin(3.14159265358979 * t);
}

/* Replays the journal with one line more, and gives the session. */
static bat_status with_line(bat_editor *editor, const char *members, double x0, double x1, double rise,
                            bat_editor **again, bat_problem *problem) {
    size_t size;
    const char *journal = bat_editor_journal(editor, &size);
    char *text = malloc(size + 8000), *at = text + size;
    memcpy(text, journal, size);
    at += sprintf(at, "{\"do\":\"sketch-level\",\"curve\":0,\"view\":[0,0,1],%s,\"stroke\":{\"points\":[",
                  members);
    for (int i = 0; i <= STROKE; i++) {
        double on[2];
        place(i, x0, x1, rise, on);
        at += sprintf(at, "%s[%.3f,%.3f]", i ? "," : "", on[0], on[1]);
    }
    at += sprintf(at, "]}}\n");
    assert_int_equal(bat_editor_create(again), BAT_OK);
    const bat_status status = bat_editor_replay(*again, text, (size_t)(at - text), true, problem);
    free(text);
    return status;
}

static void wrong_levels(void **state) {
    (void)state;
    bat_editor *editor = with_levels(false);
    static const char *const cases[] = {
        "\"object\":1,\"level\":2",  /* there is no such level */
        "\"object\":2,\"level\":0",  /* a curve without levels */
        "\"object\":9,\"level\":-1", /* no object */
        "\"object\":1,\"level\":0,\"ground\":{\"plane\":[0,0,0,1,0,0,0,1,0]}"};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *again = NULL;
        bat_problem problem = {"", ""};
        const bat_status status = with_line(editor, cases[i], 300, 700, 20, &again, &problem);
        if (status != BAT_ARGUMENT)
            fail_msg("%s: %s: %s", cases[i], bat_status_message(status), problem.message);
        assert_true(digest(again) == digest(editor)); /* all that was before it is there */
        check(again);
        bat_editor_free(again);
    }
    bat_editor_free(editor);
}

/* Without a level the coarsest follows that comes near enough: the curve is within the tolerance of a long stroke, and
 * a muted level is passed over. */
static void the_coarsest_level(void **state) {
    (void)state;
    for (int muted = 0; muted < 2; muted++) {
        bat_editor *editor = with_levels(muted), *again = NULL;
        bat_problem problem = {"", ""};
        assert_int_equal(with_line(editor, "\"object\":1,\"level\":-1", 230, 770, 30, &again, &problem),
                         BAT_OK);
        const bat_object *object = bat_document_at(bat_editor_document(again), 0);
        assert_true(digest(again) != digest(editor));
        bat_finder *finder = NULL;
        assert_int_equal(bat_finder_create(bat_object_curve(object, 0), &finder), BAT_OK);
        double worst = 0;
        for (int i = 0; i <= STROKE; i++) {
            double on[2];
            bat_near near;
            place(i, 230, 770, 30, on);
            bat_finder_nearest(finder, on, &near);
            worst = fmax(worst, near.distance);
        }
        print_message("%s: %.3f px\n", muted ? "muted" : "whole", worst);
        assert_true(worst < 1);
        bat_finder_free(finder);
        bat_editor_free(again);
        bat_editor_free(editor);
    }
}

/* The edit of a line like that, without a journal. */
static bat_edit edit_of(const char *members, double x0, double x1, double rise) {
    char text[8000], *at = text;
    bat_json json;
    bat_edit edit = {0};
    at += sprintf(at, "{\"do\":\"sketch-level\",\"curve\":0,\"view\":[0,0,1],%s,\"stroke\":{\"points\":[",
                  members);
    for (int i = 0; i <= STROKE; i++) {
        double on[2];
        place(i, x0, x1, rise, on);
        at += sprintf(at, "%s[%.3f,%.3f]", i ? "," : "", on[0], on[1]);
    }
    at += sprintf(at, "]}}");
    assert_int_equal(bat_json_parse(text, (size_t)(at - text), &json, NULL), BAT_OK);
    assert_int_equal(bat_edit_read(&json, NULL, &edit, NULL), BAT_OK);
    bat_json_free(&json);
    return edit;
}

/* A level that memory does not suffice to look at is not taken for one that is too far off: the same shape as with
 * memory, or none. */
static void levels_without_memory(void **state) {
    (void)state;
    for (int muted = 0; muted < 2; muted++) {
        bat_editor *editor = with_levels(muted);
        bat_edit edit = edit_of("\"object\":1,\"level\":-1", 230, 770, 30);
        bat_sketch_report report;
        bat_shape *wanted = NULL;
        assert_int_equal(bat_edit_shape(editor->session.document, &edit, &wanted, &report), BAT_OK);
        const long held = alloc_live();
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_shape *shape = NULL;
            alloc_fail_at(n);
            const bat_status status = bat_edit_shape(editor->session.document, &edit, &shape, &report);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_true((shape == NULL) == reached);
            if (shape) assert_true(bat_curve_is_equal(bat_shape_curve(shape, 1), bat_shape_curve(wanted, 1)));
            bat_shape_free(shape);
            assert_true(alloc_live() == held);
        }
        bat_shape_free(wanted);
        edit.object = 99;
        assert_int_equal(bat_edit_shape(editor->session.document, &edit, &wanted, &report), BAT_ARGUMENT);
        edit.object = 1;
        const double plane[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        assert_true(bat_ground_named("plane", 9, plane, &edit.stage.ground));
        assert_int_equal(bat_edit_shape(editor->session.document, &edit, &wanted, &report), BAT_ARGUMENT);
        bat_samples_free(&edit.samples);
        /* A stroke too short for the base, the finer level silent: the base follows as well as it can. */
        edit = edit_of("\"object\":1,\"level\":-1", 480, 520, 3);
        wanted = NULL;
        assert_int_equal(bat_edit_shape(editor->session.document, &edit, &wanted, &report), BAT_OK);
        assert_non_null(wanted);
        bat_shape_free(wanted);
        bat_samples_free(&edit.samples);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(curves_of_objects),
                                       cmocka_unit_test(taken_out_of_three),
                                       cmocka_unit_test(images),
                                       cmocka_unit_test(levels_without_memory),
                                       cmocka_unit_test(stretches),
                                       cmocka_unit_test(drafts),
                                       cmocka_unit_test(wrong_levels),
                                       cmocka_unit_test(the_coarsest_level)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
