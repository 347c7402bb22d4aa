/* label: slow. Wires: bound, redrawn while what is bound is shown beside them with its torn edges, dragged by the walls of their
 * tubes, bounded, freed, made where surfaces meet; surfaces that fold while their path is redrawn. Each call that allocates sees
 * its allocations fail. The editor stays sound, the drawing is the one before or one after, undo leads back, nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/alloc_paths.h"
#include "support/editing.h"
#include "support/bound.h"

/* Over the line at x, or beside it: moves, frames and the pen lifted; nothing is asserted here. */
static void over(bat_editor *editor, double x, double by) {
    pen p = pen_for(editor);
    p.time += 1000;
    pen_event(&p, BAT_POINTER_HOVER, x, 290);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_DOWN, x, 290);
    for (int i = 1; i <= 24; i++) {
        const double t = i / 24.0;
        pen_event(&p, BAT_POINTER_MOVE, x + by * 16 * t * t * (1 - t) * (1 - t), 290 + 220 * t);
        if (i % 8 == 0) bat_editor_frame(editor);
    }
    pen_event(&p, BAT_POINTER_UP, x, 510);
    bat_editor_frame(editor);
}

static void pull(bat_editor *editor, double x, double y, double to) {
    pen p = mouse(editor);
    p.time += 1000;
    pen_event(&p, BAT_POINTER_HOVER, x, y);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_DOWN, x, y);
    for (int i = 1; i <= 3; i++) {
        pen_event(&p, BAT_POINTER_MOVE, x + (to - x) * i / 3, y);
        bat_editor_frame(editor);
    }
    pen_event(&p, BAT_POINTER_UP, to, y);
    bat_editor_frame(editor);
}

static void command(bat_editor *editor, const char *name) {
    bat_editor_command(editor, name);
    bat_editor_frame(editor);
}

/* ---- scenes ---- */

static bat_editor *loose_mesh(void) { return open(A_MESH, 1); }
static bat_editor *loose_curves(void) { return open(A_CURVE, 1); }

static bat_editor *bound(what thing, int wires) {
    bat_editor *editor = open(thing, wires);
    command(editor, "wire-bind");
    bat_editor_select(editor, WIRE, false);
    bat_editor_frame(editor);
    return editor;
}
static bat_editor *bound_mesh(void) { return bound(A_MESH, 2); }
static bat_editor *bound_sheet(void) { return bound(A_SHEET, 1); }
static bat_editor *bound_curve(void) { return bound(A_CURVE, 1); }

/* A radius so wide that the second line, far to the right, tears what the bent wire reaches. */
static bat_editor *torn_mesh(void) {
    const bat_style style = bat_style_defaults();
    bat_editor *editor = open(A_MESH, 0);
    bat_document *document = NULL;
    bat_curve *pin = NULL;
    bat_object *object = NULL;
    const double points[] = {350, 230, 350, 330, 350, 430, 350, 530, 360, 560, 400,
                             575, 440, 560, 450, 530, 450, 430, 450, 330, 450, 230};
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    bat_editor_free(editor);
    assert_int_equal(bat_curve_create_clamped(2, 3, 11, points, &pin), BAT_OK);
    assert_int_equal(bat_object_create_path(WIRE, "", &style, 1, &pin, &object), BAT_OK);
    add(document, object);
    editor = editor_of(document);
    command(editor, "tool-select"), command(editor, "select-all"), command(editor, "wire-bind");
    return editor;
}

static bat_editor *wire_and_other(void) {
    bat_document *document = NULL;
    bat_editor *editor = bound(A_MESH, 1);
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    add_line(document, OTHER, 440);
    bat_editor_free(editor);
    editor = editor_of(document);
    command(editor, "tool-select");
    bat_editor_select(editor, WIRE, false), bat_editor_select(editor, OTHER, true);
    return editor;
}

static bat_editor *bounded_mesh(void) {
    bat_editor *editor = wire_and_other();
    command(editor, "wire-domain");
    bat_editor_select(editor, OTHER, false);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *two_sheets(void) {
    const bat_style style = bat_style_defaults();
    const double knots[] = {0, 0, 1, 1},
                 corners[] = {380, 150, -90, 380, 150, 90, 420, 650, -90, 420, 650, 90};
    bat_editor *editor = open(A_SHEET, 0);
    bat_document *document = NULL;
    bat_surface *wall = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    bat_editor_free(editor);
    assert_int_equal(bat_surface_create((int[]){1, 1}, (bool[]){false, false}, (size_t[]){2, 2}, corners,
                                        (int[]){4, 4}, knots, knots, &wall),
                     BAT_OK);
    assert_int_equal(bat_object_create_surface(WIRE, "", &style, wall, &object), BAT_OK);
    bat_surface_free(wall);
    add(document, object);
    editor = editor_of(document);
    command(editor, "tool-select"), command(editor, "select-all");
    return editor;
}

/* A path at x = 400 and a wide profile, swept. */
static bat_editor *swept(void) {
    bat_document *document = NULL;
    bat_curve *flat = NULL;
    bat_object *object = NULL;
    const bat_style style = bat_style_defaults();
    const double points[] = {300, 250, 500, 250};
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    add_line(document, WIRE, 400);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &flat), BAT_OK);
    assert_int_equal(bat_object_create_path(OTHER, "", &style, 1, &flat, &object), BAT_OK);
    add(document, object);
    bat_editor *editor = editor_of(document);
    command(editor, "tool-select"), command(editor, "select-all"), command(editor, "surface-sweep");
    return editor;
}

/* ---- acts ---- */

static void bind(bat_editor *editor) { command(editor, "wire-bind"); }
static void redraw_wire(bat_editor *editor) {
    command(editor, "tool-sketch");
    over(editor, 400, 28);
}
static void redraw_hairpin(bat_editor *editor) {
    command(editor, "tool-sketch");
    over(editor, 350, -15);
}
static void bend_hard(bat_editor *editor) {
    command(editor, "tool-sketch");
    over(editor, 400, 120);
}
static void pull_wall(bat_editor *editor) { pull(editor, 475, 325, 520); }
static void pull_between(bat_editor *editor) { pull(editor, 475, 400, 500); }
static void move_wire(bat_editor *editor) { pull(editor, 400, 330, 425); }
static void move_bound(bat_editor *editor) { pull(editor, 440, 330, 465); }
static void enter(bat_editor *editor) {
    bat_editor_enter(editor, "wire-radius", "50");
    bat_editor_enter(editor, "wire-radius-end", "110");
    bat_editor_frame(editor);
}
static void bound_by(bat_editor *editor) { command(editor, "wire-domain"); }
static void erase(bat_editor *editor) { command(editor, "delete"); }
static void bake(bat_editor *editor) { command(editor, "wire-bake"); }
static void revert(bat_editor *editor) { command(editor, "wire-revert"); }
static void meet(bat_editor *editor) { command(editor, "surface-meet"); }
static void meet_bound(bat_editor *editor) { command(editor, "wire-meet"); }
/* Written and read again: a blend, radii, a domain curve and where the points were. */
static void write(bat_editor *editor) {
    char *text = NULL;
    size_t size = 0;
    bat_document *again = NULL;
    if (bat_document_write(bat_editor_document(editor), &text, &size) == BAT_OK &&
        bat_document_read(text, size, &again, NULL) == BAT_OK)
        assert_true(bat_document_digest(again) == digest(editor));
    bat_document_free(again);
    bat_free(text);
}

typedef struct act {
    const char *name;
    bat_editor *(*scene)(void);
    void (*perform)(bat_editor *editor);
    bool changes;
} act;

static const act acts[] = {
    {"a mesh bound", loose_mesh, bind, true},
    {"a curve bound", loose_curves, bind, true},
    {"a wire of a mesh redrawn", bound_mesh, redraw_wire, true},
    {"a wire of a sheet redrawn", bound_sheet, redraw_wire, true},
    {"a wire of a curve redrawn", bound_curve, redraw_wire, true},
    {"a hairpin redrawn, with torn edges", torn_mesh, redraw_hairpin, true},
    {"the path of a sweep bent until it folds", swept, bend_hard, true},
    {"a wall dragged", bound_sheet, pull_wall, true},
    {"a wall dragged between stops", bound_sheet, pull_between, true},
    {"a wire dragged", bound_mesh, move_wire, true},
    {"radii entered", bound_mesh, enter, true},
    {"a domain curve", wire_and_other, bound_by, true},
    {"a domain curve dragged", bounded_mesh, move_bound, true},
    {"a domain curve deleted", bounded_mesh, erase, true},
    {"a wire deleted", bound_mesh, erase, true},
    {"baked", bound_sheet, bake, true},
    {"reverted", bound_curve, revert, true},
    {"where sheets meet", two_sheets, meet, true},
    {"a wire where sheets meet", two_sheets, meet_bound, true},
    {"written and read", bounded_mesh, write, false},
};

static void memory_may_end_in_any_act(void **state) {
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof acts / sizeof acts[0]; i++) {
        const act *a = &acts[i];
        const long held = alloc_live();
        bat_editor *editor = a->scene();
        const uint64_t before = digest(editor);
        a->perform(editor);
        const uint64_t after = digest(editor);
        if ((after != before) != a->changes) fail_msg("%s: changed %d", a->name, after != before);
        bat_editor_free(editor);
        for (bool again = true; again; failed++) {
            editor = a->scene();
            alloc_fail_new(false);
            a->perform(editor);
            again = alloc_fail_reached();
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("%s: %s", a->name, wrong);
            if (!again) assert_true(digest(editor) == after);
            bat_editor_frame(editor); /* what could not be shown is shown now */
            while (bat_editor_command(editor, "undo") == BAT_OK) continue;
            while (bat_editor_command(editor, "redo") == BAT_OK) continue;
            wrong = bat_editor_check(editor);
            if (wrong) fail_msg("%s, undone and done: %s", a->name, wrong);
            bat_editor_free(editor);
            if (alloc_live() != held) fail_msg("%s: a leak", a->name);
        }
    }
    assert_true(failed > 300);
    print_message("%d times out of memory\n", failed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_may_end_in_any_act)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
