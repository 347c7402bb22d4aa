/*
 * Deviation: circles, planes and meshes against closed forms, in the unit in force; the drawing, its digest, its steps and its journal
 * stay; edits and undo are followed, coarsely during a drag; what is missing is said; Esc ends; each allocation may fail.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "editor/editor.h"
#include "support/alloc_fail.h"
#include "support/selecting.h"
#include "support/solids.h"

static bat_curve *circle(double x, double y, double radius) {
    enum { N = 64 };
    double points[2 * N], knots[N + 1];
    bat_curve *curve = NULL;
    for (int i = 0; i < N; i++) {
        points[2 * i] = x + solid_out(N) * radius * cos(2 * solid_pi * i / N);
        points[2 * i + 1] = y + solid_out(N) * radius * sin(2 * solid_pi * i / N);
    }
    solid_uniform(N, knots);
    assert_int_equal(bat_curve_create(2, 3, true, N, points, N + 1, knots, &curve), BAT_OK);
    return curve;
}

/* Circles about (500, 400): 1 of radius 100, 2 of radius 130, 3 of radius 150 that is 20 to the right. */
static bat_editor *rings(void) {
    bat_curve *curves[] = {circle(500, 400, 100), circle(500, 400, 130), circle(520, 400, 150)};
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static void compare(bat_editor *editor, bat_id measured, bat_id reference) {
    only(editor, measured, reference);
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_OK);
    bat_editor_frame(editor);
    check(editor);
}

static const bat_deviation *found(const bat_editor *editor) { return &editor->insight.deviating.found; }

static void near_to(double value, double expected, double within) {
    if (!(fabs(value - expected) <= within)) fail_msg("%.17g, not %.17g", value, expected);
}

static bool says(const bat_frame *frame, const char *part) {
    for (uint32_t i = 0; i < frame->label_count; i++)
        if (strstr(frame->labels[i].text, part)) return true;
    return false;
}

/* How many items have the colours of the scale, the legend among them. */
static int coloured(const bat_frame *frame) {
    int count = 0;
    for (uint32_t i = 0; i < frame->live_count; i++) count += frame->live[i].stroke != 0;
    return count;
}

static void circles(void **state) {
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        bat_editor *editor = rings();
        compare(editor, turned ? 2 : 1, turned ? 1 : 2);
        assert_int_equal(editor->insight.deviating.reference, turned ? 1 : 2);
        near_to(found(editor)->greatest, 30, 1e-3), near_to(found(editor)->mean, 30, 1e-3);
        near_to(found(editor)->rms, 30, 1e-3);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_true(says(frame, "30 px") && says(frame, "15 px") && says(frame, "greatest"));
        assert_true(says(frame, "Distance from line") && strstr(frame->notice, "rms"));
        assert_true(coloured(frame) >= 9);
        bat_editor_free(editor);
    }
    /* Of radius 150, 20 aside, from radius 100: from 30 to 70 away, furthest at the right. */
    bat_editor *editor = rings();
    compare(editor, 3, 1);
    near_to(found(editor)->greatest, 70, 1e-3), near_to(found(editor)->at[0], 670, 1e-3);
    near_to(found(editor)->to[0], 600, 1e-3), near_to(found(editor)->at[1], 400, 0.1);
    double least = INFINITY;
    const bat_deviating *d = &editor->insight.deviating;
    for (size_t i = 0; i < d->sample_count; i++) least = fmin(least, d->samples[i].distance);
    near_to(least, 30, 0.02);
    assert_int_equal(bat_editor_set(editor, "unit", 1), BAT_OK); /* mm */
    assert_true(says(bat_editor_frame(editor), "18.5 mm"));
    bat_editor_free(editor);
}

/* Planes 1 (z = 0) and 2 (z = 40); 3: a mesh of two triangles at z = 25. */
static bat_editor *planes(void) {
    const double up[3] = {0, 0, 1}, middle[3] = {500, 400, 0}, over[3] = {500, 400, 40};
    const double corners[12] = {400, 300, 25, 600, 300, 25, 600, 500, 25, 400, 500, 25};
    const int sizes[2] = {3, 3}, faces[6] = {0, 1, 2, 0, 2, 3};
    const bat_style style = bat_style_defaults();
    bat_surface *low = solid_plane(middle, up, 100), *high = solid_plane(over, up, 50);
    bat_polymesh *mesh = NULL;
    bat_document *document = NULL;
    bat_object *objects[3];
    assert_int_equal(bat_polymesh_create(4, corners, 2, sizes, faces, &mesh, NULL), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(
        bat_object_create_surface(bat_document_new_id(document), "floor", &style, low, &objects[0]), BAT_OK);
    assert_int_equal(
        bat_object_create_surface(bat_document_new_id(document), "roof", &style, high, &objects[1]), BAT_OK);
    assert_int_equal(bat_object_create_mesh(bat_document_new_id(document), "scan", &style, mesh, &objects[2]),
                     BAT_OK);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(bat_document_insert(document, i, objects[i]), BAT_OK);
        bat_object_release(objects[i]);
    }
    bat_surface_free(low), bat_surface_free(high), bat_polymesh_free(mesh);
    return editor_of(document);
}

static void surfaces_and_meshes(void **state) {
    (void)state;
    static const struct {
        bat_id measured, reference;
        double apart;
    } pairs[] = {{2, 1, 40}, {3, 1, 25}, {2, 3, 15}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        bat_editor *editor = planes();
        compare(editor, pairs[i].measured, pairs[i].reference);
        near_to(found(editor)->greatest, pairs[i].apart, 1e-9);
        near_to(found(editor)->mean, pairs[i].apart, 1e-9), near_to(found(editor)->rms, pairs[i].apart, 1e-9);
        const bat_deviating *d = &editor->insight.deviating;
        for (size_t k = 0; k < d->sample_count; k++) near_to(d->samples[k].distance, pairs[i].apart, 1e-9);
        bat_editor_free(editor);
    }
    /* Both from the floor: over areas 100 x 100 and 200 x 200. */
    bat_editor *editor = planes();
    only(editor, 2, 3);
    bat_editor_select(editor, 1, true);
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_OK);
    near_to(found(editor)->greatest, 40, 1e-9), near_to(found(editor)->mean, (40 + 4 * 25) / 5.0, 1e-9);
    near_to(found(editor)->rms, sqrt((1600 + 4 * 625) / 5.0), 1e-9);
    bat_editor_free(editor);
}

/* A sphere has no seam where nothing is coloured: as many patches as samples round it. */
static void closed_ones_have_no_gap(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    bat_surface *ball[2] = {solid_sphere(100, 32, 16), solid_sphere(130, 32, 16)};
    bat_document *document = NULL;
    bat_document_create(&document);
    for (int i = 0; i < 2; i++) {
        bat_object *object = NULL;
        assert_int_equal(
            bat_object_create_surface(bat_document_new_id(document), "", &style, ball[i], &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, i, object), BAT_OK);
        bat_object_release(object), bat_surface_free(ball[i]);
    }
    bat_editor *editor = editor_of(document);
    compare(editor, 2, 1);
    near_to(found(editor)->greatest, 30, 0.01), near_to(found(editor)->mean, 30, 0.01);
    const bat_deviating *d = &editor->insight.deviating;
    const size_t side = (size_t)lround(sqrt((double)d->sample_count));
    assert_int_equal(d->patch_count, side * (side - 1));
    bat_editor_free(editor);
}

static void the_drawing_stays(void **state) {
    (void)state;
    bat_editor *editor = rings();
    only(editor, 1, 2);
    size_t before, after;
    const uint64_t was = digest(editor);
    bat_editor_journal(editor, &before);
    compare(editor, 1, 2);
    bat_editor_journal(editor, &after);
    assert_true(before == after && was == digest(editor));
    assert_int_equal(editor->session.history.done, 0);
    assert_int_equal(bat_editor_frame(editor)->unsaved, 0);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_int_equal(selected(editor), 2);
    assert_int_equal(editor->insight.deviating.reference, 0);
    assert_false(says(bat_editor_frame(editor), "greatest"));
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_OK);
    assert_int_equal(editor->insight.deviating.reference, 0);
    bat_editor_free(editor);
}

static void edits_are_followed(void **state) {
    (void)state;
    bat_editor *editor = rings();
    compare(editor, 1, 2);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_enter(editor, "x", "410"), BAT_OK); /* 10 to the right: from 20 to 40 away */
    bat_editor_frame(editor);
    near_to(found(editor)->greatest, 40, 1e-3), near_to(found(editor)->at[0], 410, 0.1);
    pen p = mouse(editor);
    assert_int_equal(bat_editor_set(editor, "snap", 0), BAT_OK);
    drag_to(&p, 610, 400, 580, 400);
    assert_false(editor->insight.deviating.exact);
    assert_true(editor->insight.deviating.sample_count <= 700);
    near_to(found(editor)->greatest, 50, 0.2);
    pen_event(&p, BAT_POINTER_UP, 580, 400);
    bat_editor_frame(editor);
    assert_true(editor->insight.deviating.exact);
    near_to(found(editor)->greatest, 50, 1e-3);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_frame(editor);
    near_to(found(editor)->greatest, 40, 1e-3);
    only(editor, 2, 0); /* the reference goes, and comes again */
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    assert_false(says(bat_editor_frame(editor), "greatest"));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(says(bat_editor_frame(editor), "greatest"));
    near_to(found(editor)->greatest, 40, 1e-3);
    check(editor);
    bat_editor_free(editor);
}

/* While line 1 is redrawn, the line that it would become is measured; line 2 is 400 below. */
static void a_stroke_is_followed(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    compare(editor, 1, 2);
    const double before = found(editor)->greatest;
    assert_int_equal(bat_editor_command(editor, "tool-sketch"), BAT_OK);
    pen p = pen_for(editor);
    const uint64_t was = digest(editor);
    double highest = 0;
    pen_event(&p, BAT_POINTER_HOVER, 300, 200);
    pen_event(&p, BAT_POINTER_DOWN, 300, 200);
    for (int i = 1; i <= 80; i++) {
        const double x = 300 + 5 * i, rise = sin(solid_pi * i / 80);
        pen_event(&p, BAT_POINTER_MOVE, x, 200 - 150 * rise * rise);
        bat_editor_frame(editor);
        highest = fmax(highest, found(editor)->greatest);
    }
    assert_true(highest > before + 50 && digest(editor) == was);
    assert_false(editor->insight.deviating.exact);
    pen_event(&p, BAT_POINTER_UP, 700, 200);
    bat_editor_frame(editor);
    assert_true(editor->insight.deviating.exact && digest(editor) != was);
    near_to(found(editor)->greatest, highest, 20);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_frame(editor);
    near_to(found(editor)->greatest, before, 1e-9);
    check(editor);
    bat_editor_free(editor);
}

static void nothing_new_is_measured_at_rest(void **state) {
    (void)state;
    bat_editor *editor = rings();
    compare(editor, 3, 1);
    const long before = alloc_live();
    const bat_reference *being = editor->insight.deviating.being;
    assert_true(editor->insight.deviating.sample_count <= 6000);
    for (int i = 0; i < 20; i++)
        bat_editor_command(editor, i % 2 ? "zoom-in" : "zoom-out"), bat_editor_frame(editor);
    assert_true(editor->insight.deviating.being == being && alloc_live() <= before + 64);
    bat_editor_free(editor);
}

/* From every side, by commands and under a right button that tilts: the colours stay on the surface, the numbers are the same, and
 * nothing is measured anew. */
static void seen_from_other_sides(void **state) {
    (void)state;
    bat_editor *editor = planes();
    compare(editor, 3, 1);
    const bat_reference *being = editor->insight.deviating.being;
    const uint32_t flat = (uint32_t)coloured(bat_editor_frame(editor));
    for (int i = 0; i < 12; i++) {
        assert_int_equal(bat_editor_command(editor, i % 3 ? "orbit-up" : "orbit-left"), BAT_OK);
        bat_editor_set(editor, "perspective", i % 2);
        assert_true((uint32_t)coloured(bat_editor_frame(editor)) >= flat / 2);
        near_to(found(editor)->greatest, 25, 1e-9);
    }
    pen mouse = pen_for(editor);
    mouse.device = BAT_DEVICE_MOUSE, mouse.buttons = BAT_BUTTON_SECONDARY;
    pen_event(&mouse, BAT_POINTER_DOWN, 400, 400);
    for (int i = 0; i < 100; i++) {
        pen_event(&mouse, BAT_POINTER_MOVE, 400 + 3 * i, 400 + 2 * i);
        bat_editor_frame(editor);
    }
    pen_event(&mouse, BAT_POINTER_UP, 700, 600);
    assert_true(coloured(bat_editor_frame(editor)) > 0);
    assert_true(editor->insight.deviating.being == being);
    check(editor);
    bat_editor_free(editor);
}

static void what_is_missing_is_said(void **state) {
    (void)state;
    bat_editor *editor = rings();
    bat_editor_select(editor, 0, false);
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_STATE);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "two or more"));
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_STATE);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "one more"));
    /* All at once: the lowest is the reference. */
    assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "deviation"), BAT_OK);
    assert_int_equal(editor->insight.deviating.reference, 1);
    near_to(found(editor)->greatest, 70, 1e-3);
    bat_document *other = NULL; /* another drawing: off */
    bat_document_create(&other);
    assert_int_equal(bat_editor_open(editor, other, ""), BAT_OK);
    assert_int_equal(editor->insight.deviating.reference, 0);
    bat_editor_frame(editor);
    bat_editor_free(editor);
}

/* Of the first hundred each, then ever fewer: each sample allocates. */
static void some_allocations(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++)
        for (long n = 1, reached = 1; reached; n += 1 + n / 100 * (n / 10)) {
            bat_editor *editor = kind ? rings() : planes();
            only(editor, 2, 1);
            bat_editor_frame(editor);
            alloc_fail_at(n);
            bat_status status = bat_editor_command(editor, "deviation");
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            bat_editor_frame(editor);
            check(editor);
            bat_editor_free(editor);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(circles),
                                       cmocka_unit_test(surfaces_and_meshes),
                                       cmocka_unit_test(closed_ones_have_no_gap),
                                       cmocka_unit_test(the_drawing_stays),
                                       cmocka_unit_test(edits_are_followed),
                                       cmocka_unit_test(a_stroke_is_followed),
                                       cmocka_unit_test(nothing_new_is_measured_at_rest),
                                       cmocka_unit_test(seen_from_other_sides),
                                       cmocka_unit_test(what_is_missing_is_said),
                                       cmocka_unit_test(some_allocations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
