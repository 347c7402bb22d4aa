/* label: slow. Random sessions of strokes that are redrawn, refitted and read otherwise, with and without symmetry, over twins,
 * curves that are their own images, objects of several curves, curves in space, splines, levels and pictures, with and
 * without failing allocations: the invariants hold after each event, the journal replays to the same drawing, and undo
 * leads back to the first. Steps of more objects than are mirrored change what they change. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "editor/editor.h"
#include "support/editing.h"
#include "support/pictures.h"
#include "support/random_curve.h"
#include <batten/batten.h>

/* A wavy line of 6 points; mirrored about x = 500 for side -1. */
static bat_curve *line_at(int side, double x, double y, double step) {
    double points[12];
    bat_curve *curve = NULL;
    for (int i = 0; i < 6; i++) {
        points[2 * i] = 500 - side * (500 - x - step * i);
        points[2 * i + 1] = y + 15 * sin(1.7 * i + y);
    }
    if (bat_curve_create_clamped(2, 3, 6, points, &curve) != BAT_OK) abort();
    return curve;
}

/* Its own image: over the axis from one side to the other. */
static bat_curve *across_at(double y, bool ring) {
    double points[16], knots[9];
    bat_curve *curve = NULL;
    for (int i = 0; i < 8; i++) {
        const double angle = 6.283185307179586 * (i + 0.5) / 8, t = (i - 3.5) / 3.5;
        points[2 * i] = 500 + (ring ? 60 * sin(angle) : 150 * t);
        points[2 * i + 1] = y + (ring ? 40 * cos(angle) : 30 * t * t);
    }
    for (int i = 0; i < 9; i++) knots[i] = i;
    const bat_status status = ring ? bat_curve_create(2, 3, true, 8, points, 9, knots, &curve)
                                   : bat_curve_create_clamped(2, 3, 8, points, &curve);
    if (status != BAT_OK) abort();
    return curve;
}

static void add_object(bat_document *document, int count, bat_curve **curves) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    if (bat_object_create_path(bat_document_new_id(document), "", &style, count, curves, &object) != BAT_OK)
        abort();
    bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
}

static void add_spline(bat_document *document, int side) {
    const double points[] = {500 - side * 350, 650, 500 - side * 250, 600, 500 - side * 150, 660};
    const bat_spline spline = {.dimension = 2, .count = 3, .points = points};
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    if (bat_object_create_spline(bat_document_new_id(document), "", &style, &spline, NULL, &object) != BAT_OK)
        abort();
    bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
}

static uint64_t first; /* drawing, without the picture, which is a step */

static bat_editor *drawing(int pairs, bool symmetric) {
    bat_document *document = NULL;
    if (bat_document_create(&document) != BAT_OK) abort();
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < 2 * pairs; i++)
        pen_add(document, line_at(i % 2 ? -1 : 1, 120 + 3 * i, 80 + 500.0 / pairs * (i / 2), 50));
    pen_add(document, across_at(150, false));
    pen_add(document, across_at(330, true));
    add_object(document, 2, (bat_curve *[]){line_at(1, 60, 450, 50), line_at(-1, 60, 450, 50)});
    add_object(document, 2, (bat_curve *[]){line_at(1, 90, 520, 50), across_at(560, false)});
    bat_curve *flat = line_at(1, 130, 700, 40), *space = NULL;
    if (bat_curve_to_dimension(flat, 3, &space) != BAT_OK) abort();
    bat_curve_free(flat);
    pen_add(document, space);
    add_spline(document, 1), add_spline(document, -1);
    bat_editor *editor = editor_of(document);
    unsigned char head[HEAD_ROOM];
    first = digest(editor);
    if (bat_editor_add_picture(editor, head, head_png(head, 200, 90), NULL) != BAT_OK) abort();
    if (symmetric) bat_editor_command(editor, "symmetry");
    return editor;
}

/* Somewhere on what is shown over the drawing: handles, points, ink. False: nothing is. */
static bool at_something(bat_editor *editor, random_source *r, double pixel[2]) {
    const bat_frame *frame = bat_editor_frame(editor);
    if (frame->live_count == 0) return false;
    const bat_item *item = &frame->live[random_int(r, 0, (int)frame->live_count - 1)];
    if (item->path_count < 3) return false;
    const double at[2] = {(double)item->path[1] + frame->origin[0], (double)item->path[2] + frame->origin[1]};
    bat_stage_project(editor->context.stage, at, pixel);
    return true;
}

static void tap_twice(bat_editor *editor, random_source *r, double *time) {
    pen p = pen_for(editor);
    const double x = random_between(r, 60, 940);
    double at[2] = {x, 80 + 10 * random_int(r, 0, 62)};
    const int taps = random_int(r, 1, 3), apart = random_int(r, 20, 400);
    (void)at_something(editor, r, at);
    p.time = *time += 500;
    p.device = random_int(r, 0, 4) ? BAT_DEVICE_PEN : BAT_DEVICE_MOUSE;
    for (int i = 0; i < taps; i++) {
        pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
        pen_event(&p, BAT_POINTER_DOWN, at[0], at[1]);
        pen_event(&p, BAT_POINTER_UP, at[0] + 0.5 * i, at[1]);
        p.time += apart;
    }
    *time = p.time;
}

static void stroke(bat_editor *editor, random_source *r, double *time) {
    static const uint32_t modifiers[] = {BAT_SHIFT, BAT_ALT, BAT_CTRL, BAT_SHIFT | BAT_ALT};
    pen p = pen_for(editor);
    const double x = random_between(r, 60, 900);
    double at[2] = {x, 80 + 10 * random_int(r, 0, 62)};
    const double length = 20 + 40 * random_int(r, 0, 9),
                 turn = random_int(r, 0, 3) ? 0 : random_between(r, 0, 6);
    const int some = random_int(r, 0, 15), end = random_int(r, 0, 30);
    p.modifiers = some < 4 ? modifiers[some] : 0;
    if (random_int(r, 0, 2) == 0)
        (void)at_something(editor, r, at);
    else if (random_int(r, 0, 3) == 0)
        at[0] = 500 - length / 2; /* across the axis */
    p.time = *time += 500;
    p.device = some > 13 ? BAT_DEVICE_MOUSE : BAT_DEVICE_PEN;
    const double rise = random_int(r, 0, 2) ? 0 : random_between(r, -60, 60);
    const double bulge = random_between(r, -30, 30);
    const int steps = 8 + random_int(r, 0, 30);
    const double to[2] = {at[0] + length * cos(turn), at[1] + length * sin(turn) + rise};
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
    if (random_int(r, 0, 1)) bat_editor_frame(editor);
    pen_begin(&p, pen_arch, (double[]){at[0], at[1], to[0], to[1], bulge}, steps);
    if (random_int(r, 0, 3)) bat_editor_frame(editor);
    if (end < 3) { /* predicted ones make nothing */
        const bat_pointer ahead = {.phase = BAT_POINTER_MOVE,
                                   .device = p.device,
                                   .contact = p.contact,
                                   .buttons = BAT_BUTTON_PRIMARY,
                                   .predicted = true,
                                   .x = to[0] + 5,
                                   .y = to[1],
                                   .pressure = 0.5,
                                   .time = p.time};
        bat_editor_pointer(editor, 1, &ahead);
    }
    if (end == 3) bat_editor_command(editor, "cancel");
    if (end == 4) bat_editor_command(editor, "undo");
    if (end == 5) bat_editor_command(editor, "delete");
    pen_event(&p, end == 6 ? BAT_POINTER_CANCEL : BAT_POINTER_UP, to[0], to[1]);
    *time = p.time;
}

static void event(bat_editor *editor, random_source *r, double *time) {
    static const char *const tools[] = {"tool-sketch",   "tool-sketch",   "tool-eraser", "tool-points",
                                        "tool-smooth",   "tool-tangents", "tool-levels", "tool-line",
                                        "tool-tangents", "tool-select"};
    static const char *const commands[] = {
        "undo",          "redo",          "accept",       "cancel",         "delete",         "select-all",
        "calm",          "point-next",    "corner-make",  "curve-simplify", "corner-smooth",  "knot-next",
        "point-add",     "nudge-up",      "point-delete", "free-curve",     "take-apart",     "level-add",
        "nudge-left",    "join",          "meaning-next", "meaning-next",   "tolerance-down", "range",
        "point-default", "knot-previous", "nudge-right",  "place"};
    const bat_document *document = bat_editor_document(editor);
    const int count = bat_document_count(document), what = random_int(r, 0, 19),
              which = random_int(r, 0, 999);
    const bat_id some = count ? bat_object_id(bat_document_at(document, which % count)) : 0;
    if (what < 6) {
        stroke(editor, r, time);
    } else if (what < 8) {
        tap_twice(editor, r, time);
    } else if (what < 9) { /* the last object is chosen, to be refitted */
        bat_editor_command(editor, "tool-select");
        if (count) bat_editor_select(editor, bat_object_id(bat_document_at(document, count - 1)), false);
        for (int i = 0; i < 3; i++)
            bat_editor_refit(editor, (which + i) % 5 / 4.0, i > 0), bat_editor_frame(editor);
    } else if (what < 11) {
        bat_editor_command(editor, tools[(size_t)which % (sizeof tools / sizeof *tools)]);
    } else if (what < 15) {
        bat_editor_command(editor, commands[(size_t)which % (sizeof commands / sizeof *commands)]);
    } else if (what < 17) {
        bat_editor_select(editor, some, which % 3 == 0);
        if (which % 4 == 0) bat_editor_choose(editor, some, which % 7);
    } else if (what < 18) {
        bat_editor_refit(editor, which % 7 / 4.0 - 0.25, which % 2);
    } else if (what < 19) {
        bat_editor_readings(editor);
        bat_editor_read_as(editor, which % 6 - 1);
    } else {
        bat_editor_set_state(editor, some, which % 8 == 1, which % 8 == 2);
    }
}

static int session(uint64_t seed, bool short_of_memory, int *steps) {
    random_source r = {seed * 15485863};
    const long held = alloc_live();
    bat_editor *editor = drawing(3, seed % 3 == 0);
    double time = 0;
    int failed = 0;
    for (int i = 0; i < 100; i++) {
        if (short_of_memory) alloc_fail_new(seed % 4 == 0);
        event(editor, &r, &time);
        if (random_int(&r, 0, 2)) bat_editor_frame(editor);
        if (short_of_memory) failed += alloc_fail_reached();
        const char *wrong = bat_editor_check(editor);
        if (wrong) fail_msg("session %d, event %d: %s", (int)seed, i, wrong);
    }
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "cancel");
    bat_editor_frame(editor);
    replays(editor, seed);
    while (bat_editor_command(editor, "redo") == BAT_OK) check(editor);
    const uint64_t top = digest(editor);
    for (; bat_editor_command(editor, "undo") == BAT_OK; ++*steps) check(editor);
    assert_true(digest(editor) == first);
    while (bat_editor_command(editor, "redo") == BAT_OK) check(editor);
    assert_true(digest(editor) == top);
    bat_editor_free(editor);
    assert_true(alloc_live() == held);
    return failed;
}

static void sessions(void **state) {
    (void)state;
    int failed = 0, steps = 0;
    for (uint64_t seed = 1; seed <= 100; seed++) failed += session(seed, seed % 2, &steps);
    print_message("%d steps, %d events ran out of memory\n", steps, failed);
    assert_true(failed > 300 && steps > 1000);
}

/* Over seventy curves in one step: each changes alone, as without symmetry. */
static void many_at_once_change_alone(void **state) {
    (void)state;
    uint64_t made[2];
    for (int on = 0; on < 2; on++) {
        bat_editor *editor = drawing(36, on);
        bat_editor_command(editor, "tool-select");
        bat_editor_command(editor, "select-all");
        bat_editor_set(editor, "tolerance", 4);
        assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
        bat_editor_command(editor, "accept");
        made[on] = digest(editor);
        assert_true(made[on] != first);
        bat_editor_free(editor);
    }
    assert_true(made[0] == made[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(sessions),
                                       cmocka_unit_test(many_at_once_change_alone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
