/* The reach of a wire: its radii, by the wall of its tube and by numbers, and the curve that bounds it on one side, which it
 * follows. */
#include <batten/batten.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/editing.h"
#include "support/xml.h"
#include "support/bound.h"

/* The wall of the tube, at a stop and between stops, by pen, mouse and finger; in every frame it is bound again. */
static void the_wall_of_the_tube_is_dragged(void **state) {
    (void)state;
    const bat_device devices[] = {BAT_DEVICE_PEN, BAT_DEVICE_MOUSE, BAT_DEVICE_TOUCH};
    for (int k = 0; k < 3; k++) {
        bat_editor *editor = open(A_SHEET, 1);
        double *rest = rest_of(editor);
        const uint64_t first = digest(editor);
        bat_editor_command(editor, "wire-bind"); /* radius 75; the wire is selected */
        pen p = pen_for(editor);
        p.device = devices[k];
        drag(&p, 475, 325, 520, 325);
        assert_true(fabs(radius_at(editor, 0.25) - 120) < 1e-9 && fabs(radius_at(editor, 0) - 120) < 1e-9);
        assert_true(fabs(radius_at(editor, 0.75) - 75) < 1e-9 && fabs(radius_at(editor, 1) - 75) < 1e-9);
        drag(&p, 475, 475, 440, 475); /* the other stop: narrower */
        assert_true(fabs(radius_at(editor, 0.75) - 40) < 1e-9);
        for (int i = 0; i <= 100; i++) { /* it never leaves the range of the stops */
            const double r = radius_at(editor, i / 100.0);
            assert_true(r >= 40 - 1e-9 && r <= 120 + 1e-9);
        }
        drag(&p, 320, 400, 310, 400); /* between them, on the left wall: another stop */
        assert_true(fabs(radius_at(editor, 0.5) - 90) < 3);
        assert_true(fabs(radius_at(editor, 0.25) - 120) < 1e-9);
        is_fresh(editor, rest);
        assert_true(farthest(editor, rest) == 0);
        redraw(editor, rest);
        assert_int_equal(round_trip(editor, first), 5);
        free(rest);
        bat_editor_free(editor);
    }
}

static void a_drag_is_cancelled(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 1);
    bat_editor_command(editor, "wire-bind");
    const uint64_t bound = digest(editor);
    pen p = mouse(editor);
    drag_to(&p, 475, 325, 520, 325);
    assert_true(digest(editor) != bound); /* it shows already */
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == bound);
    check(editor);
    bat_editor_free(editor);
}

static void radii_are_numbers(void **state) {
    (void)state;
    bat_editor *editor = open(A_SHEET, 1);
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "wire-bind");
    assert_int_equal(bat_editor_enter(editor, "wire-radius", "50"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "wire-radius-end", "110"), BAT_OK);
    assert_true(fabs(radius_at(editor, 0.1) - 50) < 1e-9 && fabs(radius_at(editor, 0.9) - 110) < 1e-9);
    assert_int_equal(bat_editor_enter(editor, "wire-radius", "0"), BAT_NUMBER);
    assert_string_equal(bat_editor_frame(editor)->notice, "The radius has to be above 0");
    assert_int_equal(bat_editor_enter(editor, "wire-radius", "-3"), BAT_NUMBER);
    assert_int_equal(round_trip(editor, first), 3);
    assert_int_equal(bat_editor_select(editor, SHEET, false), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "wire-radius", "50"), BAT_STATE); /* no wire */
    bat_editor_free(editor);
}

/* A curve on the right of the wire bounds its reach there, and only there. */
static void a_curve_bounds_the_reach(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 1);
    double *rest = rest_of(editor), now[3];
    bat_editor_command(editor, "wire-bind");
    bat_document *document = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    add_line(document, OTHER, 420);
    bat_editor_free(editor);
    editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, WIRE, false);
    bat_editor_select(editor, OTHER, true);
    bat_editor_frame(editor);
    assert_true(offers(editor, "wire-domain"));
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "wire-domain"), BAT_OK);
    const bat_wire *wires;
    bat_object_wires(found(editor, SHEET), &wires, NULL);
    assert_true(bat_curve_is_equal(wires[0].domain, bat_object_curve(found(editor, OTHER), 0)));
    const uint64_t bounded = digest(editor);
    bat_editor_command(editor, "select-none");
    redraw(editor, rest);
    bool left = false;
    for (int i = 0; i < SIDE * SIDE; i++) {
        point_at(editor, i, now);
        if (rest[3 * i] > 421) assert_true(now[0] == rest[3 * i]);
        left = left || (rest[3 * i] < 379 && now[0] != rest[3 * i]);
    }
    assert_true(left);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == bounded);
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, WIRE, false);
    assert_int_equal(bat_editor_command(editor, "wire-domain"), BAT_OK); /* off again */
    assert_true(digest(editor) == before);
    replays(editor, 1);
    free(rest);
    bat_editor_free(editor);
}

/* A switch of the wire that is selected; all that is bound to it is taken where it goes now, as one step. */
static void a_wire_turns_by_frames(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_MESH; thing++) {
        bat_editor *editor = open((what)thing, 1);
        double *rest = rest_of(editor), *plain;
        const uint64_t first = digest(editor);
        const bat_wire *wires;
        assert_false(offers(editor, "wire-frames"));
        bat_editor_command(editor, "wire-bind");
        assert_true(offers(editor, "wire-frames"));
        assert_null(strstr(bat_editor_actions(editor), "wire-frames*"));
        bat_editor_command(editor, "select-none");
        redraw(editor, rest);
        bat_editor_command(editor, "tool-select");
        bat_editor_select(editor, WIRE, false);
        const uint64_t by_tangents = digest(editor);
        plain = rest_of(editor);
        assert_int_equal(bat_editor_command(editor, "wire-frames"), BAT_OK);
        assert_non_null(strstr(bat_editor_actions(editor), "wire-frames*"));
        assert_string_equal(bat_editor_frame(editor)->notice, "What is bound turns with the wire's twist");
        bat_object_wires(found(editor, SHEET), &wires, NULL);
        assert_int_equal(wires[0].turn, BAT_TURN_FRAMES);
        assert_true(digest(editor) != by_tangents);
        double far = 0, now[3];
        for (size_t i = 0; i < points_of(editor); i++) {
            point_at(editor, (int)i, now);
            for (int k = 0; k < 3; k++) far = fmax(far, fabs(now[k] - plain[3 * i + (size_t)k]));
        }
        assert_true(far < 5); /* in the plane both turn alike, but for the side of the straight wire */
        check(editor);
        replays(editor, 1);
        assert_int_equal(bat_editor_command(editor, "wire-frames"), BAT_OK);
        assert_true(digest(editor) == by_tangents);
        assert_int_equal(round_trip(editor, first), 4);
        free(rest), free(plain);
        bat_editor_free(editor);
    }
}

/* A copy with a line at x as OTHER. */
static bat_editor *with_other(bat_editor *editor, double x) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    add_line(document, OTHER, x);
    bat_editor_free(editor);
    return editor_of(document);
}

static const bat_curve *domain_of(const bat_editor *editor) {
    const bat_wire *wires;
    assert_true(bat_object_wires(found(editor, SHEET), &wires, NULL) > 0);
    return wires[0].domain;
}

/* The wire bent by 28 to the right, bounded on that side by OTHER at x = 420. */
static bat_editor *bounded(what thing, double **rest, uint64_t *first) {
    bat_editor *editor = open(thing, 1);
    *rest = rest_of(editor);
    bat_editor_command(editor, "wire-bind");
    editor = with_other(editor, 420);
    *first = digest(editor);
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, WIRE, false);
    bat_editor_select(editor, OTHER, true);
    assert_int_equal(bat_editor_command(editor, "wire-domain"), BAT_OK);
    bat_editor_command(editor, "select-none");
    redraw(editor, *rest);
    return editor;
}

/* How many points right of the wire move. */
static size_t moved_right(const bat_editor *editor, const double *rest) {
    size_t moved = 0;
    double now[3];
    for (size_t i = 0; i < points_of(editor); i++) {
        point_at(editor, (int)i, now);
        moved += rest[3 * i] > 405 && now[0] != rest[3 * i];
    }
    return moved;
}

/* The domain curve is redrawn when it bounds already: what is bound follows it, shown with its numbers while the pen is down, one
 * step of undo for both; a file and the journal know it. */
static void a_domain_curve_is_followed(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_MESH; thing++) {
        double *rest = NULL;
        uint64_t first;
        bat_editor *editor = bounded((what)thing, &rest, &first);
        const size_t near = moved_right(editor, rest);
        bat_editor_command(editor, "tool-select");
        assert_int_equal(bat_editor_select(editor, OTHER, false), BAT_OK);
        bat_editor_frame(editor);
        pen p = mouse(editor);
        drag_to(&p, 420, 330, 470, 330); /* away from the wire */
        assert_true(bat_curve_is_equal(domain_of(editor), bat_object_curve(found(editor, OTHER), 0)));
        assert_true(moved_right(editor, rest) > near + 3); /* live: the pen is still down */
        assert_non_null(strstr(bat_editor_frame(editor)->hint, "points move"));
        pen_event(&p, BAT_POINTER_UP, 470, 330);
        bat_editor_frame(editor);
        check(editor);
        is_fresh(editor, rest);
        bend(editor, 470, -20, rest); /* and redrawn with the Sketch hand */
        assert_true(bat_curve_is_equal(domain_of(editor), bat_object_curve(found(editor, OTHER), 0)));
        assert_true(bat_object_sources(found(editor, SHEET), NULL) == 2);
        assert_int_equal(round_trip(editor, first), 4);
        bat_editor_command(editor, "undo"), bat_editor_command(editor, "undo");
        assert_int_equal(moved_right(editor, rest), near);
        bat_editor_command(editor, "redo");
        char *text = NULL;
        size_t size = 0;
        bat_document *again = NULL;
        assert_int_equal(bat_document_write(bat_editor_document(editor), &text, &size), BAT_OK);
        assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
        assert_true(bat_document_digest(again) == bat_document_digest(bat_editor_document(editor)));
        bat_document_free(again);
        bat_free(text);
        free(rest);
        bat_editor_free(editor);
    }
}

/* The sheet, its wire and (all) its domain curve are copied: the copy follows the copies, and nothing else. */
static void copies_follow_copies(bat_editor *editor, bool all) {
    const bat_id *ids = NULL;
    int copies = 0;
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, SHEET, false);
    bat_editor_select(editor, WIRE, true);
    if (all) bat_editor_select(editor, OTHER, true);
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    const bat_document *document = bat_editor_document(editor);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const int sources = bat_object_sources(object, &ids);
        if (bat_object_id(object) == SHEET || sources == 0) continue;
        assert_int_equal(sources, all ? 2 : 1);
        for (int k = 0; k < sources; k++) assert_true(ids[k] > OTHER);
        copies++;
    }
    assert_int_equal(copies, 1);
    check(editor);
}

/* A deleted domain curve stays as it was, and what is bound stays bound: no point moves. Copies follow the copies. */
static void a_deleted_domain_curve_stays(void **state) {
    (void)state;
    double *rest = NULL, before[3], after[3];
    uint64_t first;
    bat_editor *editor = bounded(A_MESH, &rest, &first);
    bat_curve *was = NULL;
    double(*all)[3] = malloc((size_t)SIDE * SIDE * sizeof *all);
    for (int i = 0; i < SIDE * SIDE; i++) point_at(editor, i, all[i]);
    assert_int_equal(bat_curve_copy(domain_of(editor), &was), BAT_OK);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_select(editor, OTHER, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    check(editor);
    assert_int_equal(bat_object_sources(found(editor, SHEET), NULL), 1);
    assert_true(bat_curve_is_equal(domain_of(editor), was));
    for (int i = 0; i < SIDE * SIDE; i++) {
        point_at(editor, i, after);
        memcpy(before, all[i], sizeof before);
        assert_memory_equal(before, after, sizeof before);
    }
    is_fresh(editor, rest);
    bend(editor, 424, -20, rest); /* the wire still leads */
    assert_int_equal(round_trip(editor, first), 4);
    bat_editor_command(editor, "undo"), bat_editor_command(editor, "undo");
    copies_follow_copies(editor, false);
    bat_editor_command(editor, "undo");
    copies_follow_copies(editor, true);
    check(editor);
    bat_curve_free(was);
    free(all), free(rest);
    bat_editor_free(editor);
}

static void add_loop(bat_document *document, bat_id id) {
    const bat_style style = bat_style_defaults();
    bat_curve *loop = NULL;
    bat_object *object = NULL;
    double points[32], knots[17];
    for (int i = 0; i < 16; i++) {
        const double a = 6.283185307179586 * i / 16;
        points[2 * i] = 400 + 130 * cos(a), points[2 * i + 1] = 400 + 130 * sin(a);
    }
    for (int k = 0; k <= 16; k++) knots[k] = k;
    assert_int_equal(bat_curve_create(2, 3, true, 16, points, 17, knots, &loop), BAT_OK);
    assert_int_equal(bat_object_create_path(id, "", &style, 1, &loop, &object), BAT_OK);
    add(document, object);
}

/* The radius of a closed wire at two, three and four places: by numbers, and by the wall of its tube. Each keeps the others. */
static void a_closed_wire_has_several_radii(void **state) {
    (void)state;
    bat_editor *editor = open(A_MESH, 0);
    bat_document *document = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    add_loop(document, WIRE);
    bat_editor_free(editor);
    editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
    double *rest = rest_of(editor), at[2], way[4];
    assert_int_equal(bat_editor_enter(editor, "wire-radius", "40"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "wire-radius-end", "70"), BAT_OK);
    assert_true(fabs(radius_at(editor, 0) - 40) < 1e-9 && fabs(radius_at(editor, 1) - 40) < 1e-9);
    assert_true(fabs(radius_at(editor, 0.5) - 70) < 1e-9);
    const bat_curve *loop = bat_object_curve(found(editor, WIRE), 0);
    pen p = mouse(editor);
    for (int k = 1; k < 4; k += 2) { /* a quarter and three quarters round: between the stops */
        const double part = k / 4.0, now = radius_at(editor, part), wanted = k == 1 ? 25 : 90;
        bat_curve_eval(loop, 16 * part, 1, way);
        at[0] = way[3] / hypot(way[2], way[3]), at[1] = -way[2] / hypot(way[2], way[3]);
        drag(&p, way[0] + now * at[0], way[1] + now * at[1], way[0] + wanted * at[0],
             way[1] + wanted * at[1]);
        if (!(fabs(radius_at(editor, part) - wanted) < 1))
            fail_msg("%g at %g", radius_at(editor, part), part);
    }
    drag(&p, way[0] + 90 * at[0], way[1] + 90 * at[1], way[0] + 60 * at[0], way[1] + 60 * at[1]);
    assert_true(fabs(radius_at(editor, 0.75) - 60) < 1 && fabs(radius_at(editor, 0.25) - 25) < 1);
    assert_true(fabs(radius_at(editor, 0) - 40) < 1e-9 && fabs(radius_at(editor, 0.5) - 70) < 1e-9);
    is_fresh(editor, rest);
    assert_int_equal(round_trip(editor, first), 6);
    free(rest);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_wall_of_the_tube_is_dragged),
        cmocka_unit_test(a_drag_is_cancelled),
        cmocka_unit_test(radii_are_numbers),
        cmocka_unit_test(a_wire_turns_by_frames),
        cmocka_unit_test(a_curve_bounds_the_reach),
        cmocka_unit_test(a_domain_curve_is_followed),
        cmocka_unit_test(a_deleted_domain_curve_stays),
        cmocka_unit_test(a_closed_wire_has_several_radii),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
