/* The invariants checked after every event: each part of an editor is damaged by hand, the checker names it, and
 * reports nothing once it is repaired. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "document/object.h"
#include "editor/editor.h"
#include "editor/invariants.h"
#include "editor/tools/brushes/brush.h"
#include "editor/tools/keyed/range.h"
#include "editor/tools/keyed/waypoints.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/modes/guides.h"
#include "editor/tools/points/state.h"
#include "editor/tools/select.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/tools/tangents/state.h"
#include "support/editing.h"

static void named(bat_editor *editor, const char *wanted, const char *what) {
    const char *wrong = bat_editor_check(editor);
    if (!wrong || strcmp(wrong, wanted) != 0) fail_msg("%s: %s", what, wrong ? wrong : "nothing is found");
}

/* Damages a place by a value, and repairs it. */
#define DAMAGED(editor, place, value, wanted)                                                                \
    do {                                                                                                     \
        const __typeof__(place) kept_ = place;                                                               \
        place = value;                                                                                       \
        named(editor, wanted, #place " = " #value);                                                          \
        place = kept_;                                                                                       \
        assert_null(bat_editor_check(editor));                                                               \
    } while (0)

static bat_editor *session(void) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_line(&p, 300, 400, 600, 400, 30);
    bat_editor_frame(editor);
    assert_null(bat_editor_check(editor));
    return editor;
}

static void of_the_view(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_view *view = &e->stage.view;
    static const char zoom[] = "the zoom is out of its limits", reach[] = "the view is out of reach",
                      angle[] = "the view's angle is out of range",
                      size[] = "the window's size is out of range";
    DAMAGED(e, view->zoom, 0, zoom);
    DAMAGED(e, view->zoom, 1e300, zoom);
    DAMAGED(e, view->zoom, NAN, zoom);
    DAMAGED(e, view->x, NAN, reach);
    DAMAGED(e, view->x, -1e300, reach);
    DAMAGED(e, view->y, 1e300, reach);
    DAMAGED(e, view->angle, -180, angle);
    DAMAGED(e, view->angle, 181, angle);
    DAMAGED(e, view->cosine, 0.5, angle);
    DAMAGED(e, view->sine, NAN, angle);
    DAMAGED(e, view->width, -1, size);
    DAMAGED(e, view->width, 1e9, size);
    DAMAGED(e, view->height, -1, size);
    DAMAGED(e, view->height, NAN, size);
    DAMAGED(e, view->height, 1e9, size);
    bat_editor_free(e);
}

static void of_the_scene(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_scene *scene = &e->scene;
    DAMAGED(e, scene->count, scene->count - 1, "the scene has another number of objects");
    DAMAGED(e, scene->entries[0].object, scene->entries[1].object, "the scene shows another object");
    assert_true(scene->entries[0].item.path_count > 0);
    DAMAGED(e, scene->entries[0].path, NULL, "an item has no path");
    /* What is due for the next frame is not looked at. */
    const int count = scene->count;
    scene->stale = true, scene->count = 0;
    assert_null(bat_editor_check(e));
    scene->stale = false, scene->count = count;
    bat_editor_free(e);
}

static void of_contacts(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_contacts *contacts = &e->input.contacts;
    for (uint32_t i = 0; i < 3; i++)
        contacts->list[i] = (bat_contact){.id = i, .device = BAT_DEVICE_TOUCH, .duty = BAT_DUTY_NAVIGATE};
    contacts->count = 2;
    assert_null(bat_editor_check(e));
    DAMAGED(e, contacts->count, 3, "more than two contacts navigate");
    DAMAGED(e, contacts->list[1].id, 0, "a contact is there twice");
    contacts->list[0].duty = BAT_DUTY_TOOL;
    assert_null(bat_editor_check(e));
    DAMAGED(e, contacts->list[1].duty, BAT_DUTY_TOOL, "two contacts drive the tool");
    contacts->list[1].id = 0;
    contacts->list[1].device = BAT_DEVICE_PEN; /* devices number theirs apart */
    assert_null(bat_editor_check(e));
    contacts->count = 0;
    bat_editor_free(e);
}

static void of_the_session(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_session *s = &e->session;
    static const char history[] = "the history is out of step",
                      journal[] = "the journal does not end with a line";
    DAMAGED(e, s->history.done, -1, history);
    DAMAGED(e, s->history.done, s->history.count + 1, history);
    DAMAGED(e, s->history.count, BAT_HISTORY_ROOM + 1, history);
    DAMAGED(e, s->journal.size, 0, journal);
    DAMAGED(e, s->journal.size, s->journal.size - 1, journal);
    DAMAGED(e, s->transaction.open, true, "a transaction is open and nobody holds it");
    DAMAGED(e, e->settings.values[BAT_PROPERTY_TOLERANCE], -1, "a property is out of its range");
    DAMAGED(e, e->settings.values[BAT_PROPERTY_TOLERANCE], 1e9, "a property is out of its range");
    bat_editor_select(e, 1, false);
    bat_document *document = s->document;
    bat_document *none = NULL;
    assert_int_equal(bat_document_create(&none), BAT_OK);
    s->document = none;
    e->scene.stale = true;
    named(e, "the selection has objects that are not in the document", "another document");
    s->document = document;
    e->scene.stale = false;
    assert_null(bat_editor_check(e));
    bat_document_free(none);
    bat_editor_free(e);
}

/* Objects are shared and do not change; what their check finds, and the list's. */
static bat_editor *with(bat_object *object) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    bat_editor *e = editor_of(document);
    bat_editor_frame(e);
    check(e);
    return e;
}

static const bat_object *only(const bat_editor *e) { return bat_document_at(bat_editor_document(e), 0); }

static void of_objects(void **state) {
    (void)state;
    const bat_style usual = bat_style_defaults();
    bat_curve *curve = pen_curve(100, 100, 50, 20, 12);
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_path(1, "name", &usual, 1, &curve, &object), BAT_OK);
    bat_editor *e = with(object);
    bat_style *style = (bat_style *)bat_object_style(only(e));
    bat_curve *inside = (bat_curve *)bat_object_curve(only(e), 0);
    char *name = (char *)bat_object_name(only(e));
    static const char range[] = "a style is out of range", invalid[] = "a curve is not valid";
    DAMAGED(e, style->width, -1, range);
    DAMAGED(e, style->opacity, 2, range);
    DAMAGED(e, style->miter_limit, 0.5, range);
    DAMAGED(e, style->miter_limit, INFINITY, range);
    DAMAGED(e, style->cap, (bat_cap)9, range);
    DAMAGED(e, style->join, (bat_join)9, range);
    DAMAGED(e, inside->knots[5], NAN, invalid);
    DAMAGED(e, inside->points[3], INFINITY, invalid);
    DAMAGED(e, name[0], 'N', "the list and its ids differ");
    bat_editor_free(e);
}

static void of_kinds(void **state) {
    (void)state;
    const bat_style usual = bat_style_defaults();
    bat_object *object = NULL;
    const bat_spline spline = {.dimension = 2, .count = 3, .points = (double[]){0, 0, 99, 50, 200, 0}};
    assert_int_equal(bat_object_create_spline(1, "", &usual, &spline, NULL, &object), BAT_OK);
    bat_editor *e = with(object);
    double *points = ((bat_curve *)bat_object_curve(only(e), 0))->points;
    DAMAGED(e, points[2], 7, "the curve of a spline is not the one its points give");
    bat_spline *own = (bat_spline *)bat_object_spline(only(e));
    DAMAGED(e, own->dimension, 1, "a spline is not valid");
    bat_editor_free(e);
    assert_int_equal(
        bat_object_create_plane(1, "", (double[]){0, 0, 0}, (double[]){1, 0, 0, 0, 1, 0}, &object), BAT_OK);
    e = with(object);
    double *frame = (double *)bat_object_plane(only(e));
    static const char right[] = "the axes of a plane are not at right angles";
    DAMAGED(e, frame[3], 2, right);
    DAMAGED(e, frame[7], 0.5, right);
    DAMAGED(e, frame[6], 1e-3, right);
    bat_editor_free(e);
    bat_curve *curve = pen_curve(100, 100, 50, 20, 12);
    bat_shape *shape = NULL;
    assert_int_equal(bat_shape_decompose(curve, 1, NULL, &shape), BAT_OK);
    assert_int_equal(bat_object_create_path(1, "", &usual, 1, &curve, &object), BAT_OK);
    bat_object *shaped = NULL;
    assert_int_equal(bat_object_with_shape(object, 0, shape, &shaped), BAT_OK);
    bat_object_release(object);
    e = with(shaped);
    points = ((bat_curve *)bat_shape_curve(bat_object_shape(only(e), 0), 1))->points;
    DAMAGED(e, points[4], points[4] + 1, "the curve of a shape is not the one its levels give");
    points = ((bat_curve *)bat_shape_curve(bat_object_shape(only(e), 0), 0))->points;
    DAMAGED(e, points[4], NAN, "a shape is not valid");
    bat_editor_free(e);
}

/* Between whole checks only what has changed since is looked at. */
static void of_steps(void **state) {
    (void)state;
    bat_editor *e = session();
    pen p = pen_for(e);
    bat_checked checked = {0};
    assert_null(bat_editor_check_since(e, &checked, true));
    const bat_checked before = checked;
    pen_line(&p, 300, 500, 600, 500, 30);
    const int at = bat_document_count(bat_editor_document(e)) - 1;
    bat_style *style = (bat_style *)bat_object_style(bat_document_at(bat_editor_document(e), at));
    pen_line(&p, 300, 700, 600, 700, 30);
    const double width = style->width;
    style->width = NAN;
    assert_string_equal(bat_editor_check_since(e, &checked, false), "a style is out of range");
    style->width = width;
    checked = before;
    assert_null(bat_editor_check_since(e, &checked, false));
    assert_null(bat_editor_check_since(e, &checked, false));
    bat_editor_free(e);
}

/* ---- the tools ---- */

static bat_editor *using(const char *command) {
    bat_editor *e = pen_editor();
    assert_int_equal(bat_editor_command(e, command), BAT_OK);
    bat_editor_frame(e);
    return e;
}

/* Without the pen that holds it. */
#define WITHOUT_PEN(editor, wanted)                                                                          \
    DAMAGED(editor, (editor)->input.contacts.list[0].duty, BAT_DUTY_IGNORED, wanted)
#define WITHOUT_TRANSACTION(editor, wanted) DAMAGED(editor, (editor)->session.transaction.open, false, wanted)

static void of_sketching(void **state) {
    (void)state;
    bat_editor *e = using("tool-sketch");
    bat_sketching *s = bat_toolbox_tool(&e->context)->state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7);
    double number = 0;
    DAMAGED(e, s->edit.samples.count, 1, "samples are left of a stroke that ended");
    DAMAGED(e, s->live, (bat_sketch_live *)&number, "a preview outlived its stroke");
    DAMAGED(e, s->preview.curve, curve, "a preview outlived its stroke");
    DAMAGED(e, s->has_pending, true, "a pending fit without a curve");
    DAMAGED(e, s->state, BAT_SKETCHING_PENDING, "nothing is pending");
    s->has_pending = true, s->pending_result = (bat_edit_result){1, {curve}, NULL};
    named(e, "a pending fit is forgotten", "pending");
    s->has_pending = false, s->pending_result = (bat_edit_result){0};
    pen p = pen_for(e);
    pen_begin(&p, pen_arch, (double[]){300, 300, 500, 380, 20}, 16);
    assert_int_equal(s->state, BAT_SKETCHING_DRAWING);
    check(e);
    DAMAGED(e, s->edit.samples.count, 0, "a stroke under way has no samples");
    WITHOUT_PEN(e, "a stroke without a pen");
    DAMAGED(e, s->fed, s->edit.samples.count + 1, "the session has samples that the stroke has not");
    const bat_edit edit = s->edit;
    s->edit.kind = BAT_EDIT_REDRAW, s->edit.object = 99, s->edit.curve = 0;
    named(e, "the curve under the pen is gone", "edit");
    s->edit = edit;
    check(e);
    bat_curve_free(curve);
    bat_editor_free(e);
}

static void of_points_and_levels(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7);
    bat_editor *e = using("tool-points");
    pen p = pen_for(e);
    tap(&p, 500, 200);
    drag_to(&p, 500, 200, 520, 260);
    bat_pointing *points = bat_pointing_of(&e->context);
    assert_true(points->dragging);
    e->session.transaction.open = points->pressed = false; /* an open one is noticed first */
    named(e, "a drag without a press", "pressed");
    e->session.transaction.open = points->pressed = true;
    DAMAGED(e, points->base, NULL, "a drag without its curve, or a curve without its drag");
    WITHOUT_TRANSACTION(e, "a drag without a transaction");
    WITHOUT_PEN(e, "a press without a pointer");
    bat_editor_free(e);
    e = using("tool-levels");
    p = pen_for(e);
    tap(&p, 500, 200);
    bat_editor_command(e, "take-apart");
    bat_editor_command(e, "accept");
    drag_to(&p, 500, 200, 520, 260);
    bat_leveling *l = bat_toolbox_tool(&e->context)->state;
    assert_true(l->dragging);
    e->session.transaction.open = l->pressed = false; /* an open one is noticed first */
    named(e, "a drag without a press", "pressed");
    e->session.transaction.open = l->pressed = true;
    DAMAGED(e, l->live, NULL, "a drag without its session, or the reverse");
    DAMAGED(e, l->fading, true, "a fader without its shape, or the reverse");
    WITHOUT_TRANSACTION(e, "a drag without a transaction");
    WITHOUT_PEN(e, "a press without a pointer");
    DAMAGED(e, l->level, 99, "a level is dragged that is not there");
    bat_editor_free(e);
    bat_curve_free(curve);
}

static void of_selecting_and_tangents(void **state) {
    (void)state;
    bat_editor *e = using("tool-select");
    pen p = pen_for(e);
    drag_to(&p, 500, 200, 520, 260);
    bat_selecting *s = bat_selecting_of(&e->context);
    DAMAGED(e, s->before, NULL, "a drag and what it changes are out of step");
    WITHOUT_TRANSACTION(e, "a drag without a transaction");
    bat_editor_free(e);
    e = using("tool-tangents");
    p = pen_for(e);
    DAMAGED(e, e->session.transaction.open, true, "a transaction is open and nobody holds it");
    for (int i = 0; i < 3; i++) tap(&p, 300 + 100 * i, 400 + 30 * (i % 2));
    bat_editor_command(e, "accept");
    drag_to(&p, 400, 430, 420, 480);
    bat_splining *t = bat_toolbox_tool(&e->context)->state;
    assert_true(t->object && t->state == BAT_SPLINING_DRAGGING);
    WITHOUT_TRANSACTION(e, "a drag without a transaction");
    WITHOUT_PEN(e, "a point is held without a pen");
    DAMAGED(e, t->press.point, 99, "a point is held that is not there");
    const bool open = e->session.transaction.open;
    DAMAGED(e, t->state, BAT_SPLINING_PRESSED, "a transaction outlived its drag");
    assert_true(open);
    bat_editor_free(e);
}

static void of_brushes_and_modes(void **state) {
    (void)state;
    static const char *const brushes[][2] = {{"tool-smooth", "a preview outlived its brush"},
                                             {"tool-eraser", "an eraser is lifted and has not let go"}};
    for (int i = 0; i < 2; i++) {
        bat_editor *e = using(brushes[i][0]);
        pen p = pen_for(e);
        drag_to(&p, 450, 200, 550, 201);
        bat_brush *brush = bat_toolbox_tool(&e->context)->state;
        assert_true(brush->painting);
        DAMAGED(e, brush->painting, false, brushes[i][1]);
        WITHOUT_PEN(e, "a brush without a pen");
        bat_editor_free(e);
    }
    bat_editor *e = using("tool-smooth");
    bat_editor_select(e, 1, false);
    assert_int_equal(bat_editor_command(e, "range"), BAT_OK);
    bat_range *r = bat_range_of(&e->context);
    check(e);
    DAMAGED(e, r->u[1], r->u[0], "a range without an extent");
    DAMAGED(e, r->u[0], NAN, "a range without an extent");
    DAMAGED(e, r->end, 2, "a range has a third end");
    bat_editor_free(e);
    e = using("tool-sketch");
    assert_int_equal(bat_editor_command(e, "place"), BAT_OK);
    bat_waypoints *w = bat_waypoints_of(&e->context);
    check(e);
    DAMAGED(e, w->count, 0, "waypoints without a point");
    DAMAGED(e, w->count, BAT_WAYPOINTS_MAX + 1, "waypoints without a point");
    DAMAGED(e, w->chosen, -1, "a waypoint is chosen that is not there");
    DAMAGED(e, w->chosen, w->count, "a waypoint is chosen that is not there");
    bat_editor_free(e);
    e = using("guide-upright");
    bat_editor_command(e, "tool-select");
    bat_editor_set(e, "show-rulers", 1);
    pen p = pen_for(e);
    bat_guiding *g = bat_guiding_of(&e->context);
    drag_to(&p, 500, 300, 540, 300);
    assert_true(g->on && g->id);
    DAMAGED(e, g->id, 99, "the guide that is held is gone");
    WITHOUT_PEN(e, "a guide is held without a pen");
    bat_editor_free(e);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_the_view),
                                       cmocka_unit_test(of_the_scene),
                                       cmocka_unit_test(of_contacts),
                                       cmocka_unit_test(of_the_session),
                                       cmocka_unit_test(of_objects),
                                       cmocka_unit_test(of_kinds),
                                       cmocka_unit_test(of_steps),
                                       cmocka_unit_test(of_sketching),
                                       cmocka_unit_test(of_points_and_levels),
                                       cmocka_unit_test(of_selecting_and_tangents),
                                       cmocka_unit_test(of_brushes_and_modes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
