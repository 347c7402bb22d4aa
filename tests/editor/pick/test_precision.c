/* Snapping, grid, guides, rulers, units, isolation, outlines: places known in closed form, and what must not change. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "base/real.h"
#include "editor/edit/affine.h"
#include "editor/editor.h"
#include "editor/show/ruler.h"
#include "support/alloc_fail.h"
#include "support/session.h"
#include <batten/bezier.h>
#include "editor/tools/modes/guides.h"
#include "support/editing.h"

/* A polyline of degree 1. */
static bat_curve *polyline(int count, const double *points) {
    double knots[16];
    bat_curve *curve = NULL;
    for (int i = 0; i < count + 2; i++) knots[i] = i == 0 ? 0 : i > count ? count - 1 : i - 1;
    assert_int_equal(bat_curve_create(2, 1, false, (size_t)count, points, count + 2, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *segment(double x0, double y0, double x1, double y1) {
    return polyline(2, (double[]){x0, y0, x1, y1});
}

static void at_once(const bat_snap *snap, bat_snap_kind kind, double x, double y) {
    if (snap->kind != kind || !(bat_hypot(snap->point[0] - x, snap->point[1] - y) < 1e-9))
        fail_msg("kind %d at %.12g %.12g, not %d at %.12g %.12g", (int)snap->kind, snap->point[0],
                 snap->point[1], (int)kind, x, y);
}

static bat_snap snap(bat_editor *editor, double x, double y) {
    double point[2] = {x, y};
    bat_snap_point(&editor->context, 0, NULL, point);
    assert_null(bat_editor_check(editor));
    return editor->snap;
}

/* Ends, crossings of two lines, of a line and a parabola, of a curve with itself: all known. */
static void snaps_to_known_places(void **state) {
    (void)state;
    /* y = 300 - (x - 500)^2 / 100 for x in 400..600: the control points of a parabola in Bézier form. */
    bat_curve *parabola = NULL, *loop = NULL;
    bat_curve_create(2, 2, false, 3, (double[]){400, 200, 500, 400, 600, 200}, 6,
                     (double[]){0, 0, 0, 1, 1, 1}, &parabola);
    /* Symmetric about x = 800, so it meets itself there: x(t) - 800 = 600 (t - 1/2) (1 - 6 t (1 - t)) ... solved
     * below by halving. */
    bat_curve_create(2, 3, false, 4, (double[]){700, 600, 1000, 300, 600, 300, 900, 600}, 8,
                     (double[]){0, 0, 0, 0, 1, 1, 1, 1}, &loop);
    bat_curve *curves[] = {segment(100, 100, 300, 300), segment(100, 300, 300, 100), parabola,
                           segment(350, 250, 650, 250), loop};
    bat_editor *editor = editor_with(5, curves);
    bat_snap found = snap(editor, 103, 96);
    at_once(&found, BAT_SNAP_END, 100, 100);
    found = snap(editor, 203, 204);
    at_once(&found, BAT_SNAP_CROSSING, 200, 200);
    /* y = 400 t (1 - t) + 200 = 250: t = (1 - sqrt(1/2)) / 2, x = 400 + 200 t */
    found = snap(editor, 432, 253);
    at_once(&found, BAT_SNAP_CROSSING, 500 - 100 * sqrt(0.5), 250);
    found = snap(editor, 567, 248);
    at_once(&found, BAT_SNAP_CROSSING, 500 + 100 * sqrt(0.5), 250);
    double low = 0, high = 0.4; /* the parameter of the crossing with itself */
    const bat_curve *own = bat_object_curve(bat_document_at(editor->session.document, 4), 0);
    for (int i = 0; i < 60; i++) {
        double t = (low + high) / 2, at[2];
        bat_curve_eval(own, t, 0, at);
        if (at[0] < 800)
            low = t;
        else
            high = t;
    }
    double at[2];
    bat_curve_eval(own, low, 0, at);
    found = snap(editor, at[0] + 3, at[1] - 2);
    at_once(&found, BAT_SNAP_CROSSING, 800, at[1]);
    /* An end within reach comes before a crossing that is nearer. */
    found = snap(editor, 296, 298);
    at_once(&found, BAT_SNAP_END, 300, 300);
    /* Out of reach, switched off, held off. */
    assert_int_equal(snap(editor, 320, 300).kind, BAT_SNAP_NONE);
    bat_editor_set(editor, "snap-ends", 0);
    assert_int_equal(snap(editor, 103, 96).kind, BAT_SNAP_NONE);
    bat_editor_set(editor, "snap-curves", 1);
    found = snap(editor, 153, 147);
    at_once(&found, BAT_SNAP_CURVE, 150, 150);
    editor->context.modifiers = BAT_CTRL;
    assert_int_equal(snap(editor, 153, 147).kind, BAT_SNAP_NONE);
    editor->context.modifiers = 0;
    bat_editor_command(editor, "snap");
    assert_int_equal(snap(editor, 203, 204).kind, BAT_SNAP_NONE);
    bat_editor_command(editor, "snap");
    bat_editor_set(editor, "snap-curves", 0);
    /* The reach is in pixels. */
    bat_editor_command(editor, "zoom-in");
    bat_editor_command(editor, "zoom-in");
    assert_int_equal(snap(editor, 205, 204.5).kind, BAT_SNAP_NONE);
    found = snap(editor, 202, 201);
    at_once(&found, BAT_SNAP_CROSSING, 200, 200);
    bat_editor_free(editor);
}

static void guides_and_grid_draw(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 500, 500, 700)};
    bat_editor *editor = editor_with(1, curves);
    uint64_t first = digest(editor);
    assert_int_equal(bat_guide_put(&editor->context, 0, 0, 320.5), BAT_OK);
    assert_int_equal(bat_guide_put(&editor->context, 0, 1, 150.25), BAT_OK);
    bat_snap found = snap(editor, 323, 400);
    at_once(&found, BAT_SNAP_GUIDE, 320.5, 400);
    found = snap(editor, 325, 147);
    at_once(&found, BAT_SNAP_CROSSING, 320.5, 150.25);
    found = snap(editor, 317, 612); /* the line is at y = 500 + 220.5 / 2 there */
    at_once(&found, BAT_SNAP_CROSSING, 320.5, 610.25);
    /* The grid draws while it is shown; a guide keeps its coordinate. */
    bat_editor_set(editor, "grid-spacing", 25);
    assert_int_equal(snap(editor, 402, 277).kind, BAT_SNAP_NONE);
    bat_editor_command(editor, "show-grid");
    found = snap(editor, 402, 277);
    at_once(&found, BAT_SNAP_GRID, 400, 275);
    found = snap(editor, 322, 277);
    at_once(&found, BAT_SNAP_GUIDE, 320.5, 275);
    /* Never nearer than 8 px, always a part of the finer one, never finer than asked. */
    double spacings[] = {0.001, 1, 3.7, 10, 1000}, before = 0;
    for (int i = 0; i < 5; i++) {
        bat_editor_set(editor, "grid-spacing", spacings[i]);
        before = 0;
        for (int k = 0; k < 60; k++) {
            double step = bat_grid_step(&editor->context), whole = step / spacings[i];
            assert_true(step * editor->stage.view.zoom >= 8 && fabs(whole - round(whole)) < 1e-9 * whole);
            if (before > 0) {
                double times = step / before;
                assert_true(fabs(times - round(times)) < 1e-9 * times);
                assert_true(step == before || before * editor->stage.view.zoom < 8);
            }
            before = step;
            bat_view_zoom(&editor->stage.view, (double[]){0, 0}, 0.8);
        }
        bat_editor_command(editor, "zoom-100");
    }
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GRID));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDELINE));
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDELINE));
    bat_editor_free(editor);
}

static pen mouse(bat_editor *editor) {
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_MOUSE;
    return p;
}

static int guides(const bat_editor *editor, int axis, double *at) {
    int found = 0;
    double place;
    for (int i = 0; i < bat_document_count(editor->session.document); i++)
        if (bat_object_guide(bat_document_at(editor->session.document, i), &place) == axis) {
            *at = place;
            found++;
        }
    return found;
}

/* Out of the rulers, moved, dragged back, deleted by the key; each one step. */
static void guides_by_hand(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    uint64_t first = digest(editor);
    pen p = mouse(editor);
    double at = 0;
    drag(&p, 500, 10, 500, 233); /* no rulers: this is a stroke of the tool */
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "show-rulers");
    drag(&p, 500, 10, 500, 233);
    assert_true(guides(editor, 1, &at) == 1 && at == 233);
    drag(&p, 8, 400, 340, 400);
    assert_true(guides(editor, 0, &at) == 1 && at == 340);
    drag(&p, 8, 400, 12, 500); /* not out of it */
    assert_int_equal(bat_document_count(editor->session.document), 2);
    drag(&p, 10, 10, 300, 300); /* the corner is nobody's */
    bat_editor_command(editor, "tool-select");
    drag(&p, 340, 600, 355, 610);
    assert_true(guides(editor, 0, &at) == 1 && at == 355);
    pen_event(&p, BAT_POINTER_DOWN, 355, 600);
    pen_event(&p, BAT_POINTER_MOVE, 500, 600);
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    pen_event(&p, BAT_POINTER_UP, 500, 600);
    assert_true(guides(editor, 0, &at) == 1 && at == 355);
    drag(&p, 700, 233, 700, 9); /* back into the ruler */
    assert_int_equal(guides(editor, 1, &at), 0);
    bat_editor_command(editor, "undo");
    assert_true(guides(editor, 1, &at) == 1 && at == 233);
    drag(&p, 355, 600, 355, 600); /* a tap chooses */
    assert_int_equal(guides(editor, 0, &at), 1);
    assert_true(bat_editor_key(editor, "Delete", true, 0, p.time));
    assert_int_equal(guides(editor, 0, &at), 0);
    assert_int_equal(bat_editor_command(editor, "guide-upright"), BAT_OK);
    assert_true(guides(editor, 0, &at) == 1 && at == 500); /* the middle of the window */
    replays(editor, 0);
    /* A drawing with guides survives both formats. */
    char *text = NULL;
    size_t size = 0;
    bat_document *again = NULL;
    assert_int_equal(bat_document_write(editor->session.document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
    assert_true(bat_document_digest(again) == digest(editor));
    bat_document_free(again);
    bat_free(text);
    while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
    assert_true(digest(editor) == first);
    bat_object *none = NULL, *guide = NULL, *moved = NULL;
    assert_int_equal(bat_object_create_guide(5, 1, 40, &guide), BAT_OK);
    assert_int_equal(bat_affine_object(guide, (double[]){2, 0, 0, 3, 10, -7}, false, &moved), BAT_OK);
    assert_true(bat_object_guide(moved, &at) == 1 && at == 113);
    bat_object_release(guide);
    bat_object_release(moved);
    /* A guide is never selected: not by what undo brings back, nor by its id. */
    bat_editor_command(editor, "tool-select");
    bat_guide_put(&editor->context, 0, 0, 10);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "redo");
    bat_editor_select(editor, bat_guiding_of(&editor->context)->chosen, false);
    assert_int_equal(editor->choice.selection.count, 0);
    assert_null(bat_editor_check(editor));
    assert_int_equal(bat_object_create_guide(1, 0, NAN, &none), BAT_NUMBER);
    assert_int_equal(bat_object_create_guide(1, 2, 0, &none), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_guide(0, 0, 0, &none), BAT_ARGUMENT);
    bat_editor_free(editor);
}

static void put(bat_document *document, bat_object *object, bat_id parent, bool hidden, bool locked) {
    bat_object *made = NULL, *placed = NULL;
    assert_int_equal(bat_object_with_parent(object, parent, &made), BAT_OK);
    assert_int_equal(bat_object_with_state(made, hidden, locked, &placed), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), placed), BAT_OK);
    bat_object_release(object);
    bat_object_release(made);
    bat_object_release(placed);
}

/* A layer is moved with the guides in it; a guide that is dragged is the one that it was. */
static void a_layer_moves_with_its_guides(void **state) {
    (void)state;
    static const bool flags[][2] = {{false, false}, {true, false}, {false, true}};
    for (int i = 0; i < 3; i++) {
        bat_document *document = NULL;
        bat_object *layer = NULL, *guide = NULL, *named = NULL, *line = NULL;
        bat_style style = bat_style_defaults();
        bat_curve *curve = segment(400, 300, 600, 320);
        bat_document_create(&document);
        bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        assert_int_equal(bat_object_create_group(1, "Roof", true, &layer), BAT_OK);
        put(document, layer, 0, false, false);
        assert_int_equal(bat_object_create_guide(2, 0, 250, &guide), BAT_OK);
        assert_int_equal(bat_object_with_name(guide, "axle", &named), BAT_OK);
        bat_object_release(guide);
        put(document, named, 1, flags[i][0], flags[i][1]);
        assert_int_equal(bat_object_create_path(3, NULL, &style, 1, &curve, &line), BAT_OK);
        put(document, line, 1, false, false);
        bat_editor *editor = NULL;
        bat_editor_create(&editor);
        bat_editor_resize(editor, 1000, 800, 1);
        assert_int_equal(bat_editor_open(editor, document, "test"), BAT_OK);
        bat_editor_command(editor, "zoom-100");
        bat_editor_command(editor, "tool-select");
        uint64_t first = digest(editor);
        double at = 0, box[4];
        bat_editor_select(editor, 1, false);
        assert_int_equal(editor->choice.selection.count, 1);
        assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
        bat_object_bounds(bat_document_at(editor->session.document, 2), box);
        assert_true(guides(editor, 0, &at) == 1 && at == 251 && box[0] == 401);
        if (!flags[i][0] && !flags[i][1]) {
            bat_editor_select(editor, 0, false);
            pen p = mouse(editor);
            drag(&p, 251, 700, 300, 700);
            assert_true(guides(editor, 0, &at) == 1 && at == 300);
        }
        const bat_object *now = bat_document_at(editor->session.document, 1);
        assert_string_equal(bat_object_name(now), "axle");
        assert_true(bat_object_id(now) == 2 && bat_object_parent(now) == 1);
        assert_true(bat_object_is_hidden(now) == flags[i][0] && bat_object_is_locked(now) == flags[i][1]);
        replays(editor, 0);
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* A moved line's end lands on the end of another to the last bit; the picture says so while it is held. */
static void moves_snap(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 100, 200, 150), segment(400, 333.25, 600, 500)};
    bat_editor *editor = editor_with(2, curves);
    pen p = mouse(editor);
    bat_editor_command(editor, "tool-select");
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 300, 300);
    pen_event(&p, BAT_POINTER_MOVE, 352, 306); /* its right end comes to 402, 331 */
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_GUIDE));
    assert_string_equal(frame->labels[0].text, "end");
    pen_event(&p, BAT_POINTER_UP, 352, 306);
    double box[4];
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    assert_true(box[2] == 400 && box[3] == 333.25);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDE));
    replays(editor, 0);
    bat_editor_command(editor, "undo");
    p.modifiers = BAT_CTRL;
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 352, 306);
    pen_event(&p, BAT_POINTER_UP, 352, 306);
    p.modifiers = 0;
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    assert_true(fabs(box[2] - 402) < 1e-9);
    bat_editor_command(editor, "undo");
    /* Shift: 15 degrees. The pen goes 100, -30 (16.7 degrees); what moves goes along 15. */
    p.modifiers = BAT_SHIFT;
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 250, 95);
    frame = bat_editor_frame(editor);
    assert_string_equal(frame->labels[0].text, "15°");
    pen_event(&p, BAT_POINTER_UP, 250, 95);
    p.modifiers = 0;
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double c = cos(BAT_PI / 12), s = sin(BAT_PI / 12), along = 100 * c + 30 * s;
    assert_true(fabs(box[0] - 100 - along * c) < 1e-9 && fabs(box[1] - 100 + along * s) < 1e-9);
    /* A control point goes to the crossing of guides. */
    bat_guide_put(&editor->context, 0, 0, 700);
    bat_guide_put(&editor->context, 0, 1, 600);
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "tool-points");
    pen_event(&p, BAT_POINTER_HOVER, 500, 416.6);
    pen_event(&p, BAT_POINTER_DOWN, 500, 416.6);
    pen_event(&p, BAT_POINTER_UP, 500, 416.6);
    drag(&p, 600, 500, 703, 605);
    const bat_object *moved = bat_document_at(editor->session.document,
                                              bat_document_find(editor->session.document, 2));
    const double *points = bat_curve_points(bat_object_curve(moved, 0));
    assert_true(fabs(points[2] - 700) < 1e-12 && fabs(points[3] - 600) < 1e-12);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void units_are_read_and_written(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    static const struct {
        const char *text;
        double unit, value; /* px */
    } good[] = {{"12", 0, 12},
                {"12mm", 0, 12 * 96 / 25.4},
                {" 1in + 3 mm ", 0, 96 + 3 * 96 / 25.4},
                {"25.4", 1, 96},
                {"2", 2, 192},
                {"(2+3)*4,5", 0, 22.5},
                {"-.5cm", 0, -48 / 2.54},
                {"3 * 1in / 2", 1, 144},
                {"1in/1px", 0, 96},
                {"72pt", 2, 96},
                {"1\"", 1, 96},
                {"--4", 0, 4},
                {"1/4in", 0, 24},
                {"1in - 1/4in", 1, 72},
                {"10mm - 1", 1, 9 * 96 / 25.4}};
    static const char *const bad[] = {"",
                                      " ",
                                      "mm",
                                      "1 2",
                                      "2mm*3mm",
                                      "1+",
                                      "(1",
                                      "1)",
                                      "1e5",
                                      "x",
                                      "1..2",
                                      "1/",
                                      "((((((((((((((((((((1))))))))))))))))))))",
                                      "0x10",
                                      "nan",
                                      "inf"};
    double value = 7;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        bat_editor_set(editor, "unit", good[i].unit);
        if (bat_unit_read(&editor->context, good[i].text, false, &value) != BAT_OK ||
            !(fabs(value - good[i].value) <= 1e-12 * (1 + fabs(value))))
            fail_msg("\"%s\" is %.17g", good[i].text, value);
    }
    value = 7;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        if (bat_unit_read(&editor->context, bad[i], false, &value) != BAT_SYNTAX)
            fail_msg("\"%s\" is taken", bad[i]);
        assert_true(value == 7);
    }
    assert_int_equal(bat_unit_read(&editor->context, "1/0", false, &value), BAT_NUMBER);
    assert_int_equal(bat_unit_read(&editor->context, "30°", true, &value), BAT_OK);
    assert_true(value == 30);
    assert_int_equal(bat_unit_read(&editor->context, "30mm", true, &value), BAT_SYNTAX);
    char text[BAT_UNIT_ROOM];
    static const char *const written[] = {"96 px", "25.4 mm", "1 in"};
    for (int i = 0; i < 3; i++) {
        bat_editor_set(editor, "unit", i);
        bat_unit_write(&editor->context, 96, text);
        assert_string_equal(text, written[i]);
    }
    /* What is written reads back to within its last digit. */
    for (int i = 0; i < 200; i++) {
        double length = (i - 100) * 1.2345;
        bat_unit_write(&editor->context, length, text);
        assert_int_equal(bat_unit_read(&editor->context, text, false, &value), BAT_OK);
        assert_true(fabs(value - length) <= 0.0005001 * 96);
    }
    bat_unit_number(-0.0001, text);
    assert_string_equal(text, "0");
    bat_unit_number(1e300, text);
    assert_true(strlen(text) < BAT_UNIT_ROOM);
    bat_editor_free(editor);
}

/* Every label of the rulers stands at its own place, whatever zoom and unit; turned, there are none. */
static void rulers_tell_places(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    bat_editor_command(editor, "show-rulers");
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 5}), 1);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){5, 300}), 0);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){5, 5}), -1);
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 300}), -1);
    for (int unit = 0; unit < 3; unit++)
        for (int k = 0; k < 40; k++) {
            bat_editor_set(editor, "unit", unit);
            bat_view_zoom(&editor->stage.view, (double[]){200, 300}, k < 20 ? 0.7 : 1.9);
            const bat_frame *frame = bat_editor_frame(editor);
            int labels = 0;
            for (uint32_t i = 0; i < frame->label_count; i++) {
                const bat_label *label = &frame->labels[i];
                if (label->role != BAT_ROLE_RULER) continue;
                labels++;
                int axis = label->turn != 0;
                double place = (frame->origin[axis] + (double)label->at[axis]) /
                               bat_unit_size(&editor->context);
                double pixel = 1 / (editor->stage.view.zoom * bat_unit_size(&editor->context));
                assert_true(fabs(strtod(label->text, NULL) - place) <= fmax(0.6 * pixel, 0.000501));
            }
            assert_true(labels >= 8 && labels < 40);
        }
    bat_editor_command(editor, "view-left");
    assert_int_equal(bat_ruler_at(&editor->context, (double[]){300, 5}), -1);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_RULER));
    bat_editor_free(editor);
}

static void expect_number(bat_editor *editor, const char *name, const char *text) {
    assert_string_equal(bat_editor_number(editor, name), text);
}

/* Each number becomes what is entered; all else of the box stays. One step each. */
static void numbers_are_entered(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 100, 300, 200), segment(400, 300, 600, 500)};
    bat_editor *editor = editor_with(2, curves);
    uint64_t first = digest(editor);
    double box[4];
    expect_number(editor, "x", "");
    assert_int_equal(bat_editor_enter(editor, "x", "1"), BAT_STATE);
    bat_editor_select(editor, 1, false);
    expect_number(editor, "x", "100 px");
    expect_number(editor, "width", "200 px");
    assert_int_equal(bat_editor_enter(editor, "x", "1in + 4"), BAT_OK);
    expect_number(editor, "x", "100 px"); /* it is there already: no step */
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_enter(editor, "x", "25,4mm"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "width", "50*2"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "height", "40"), BAT_OK);
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double expected[4] = {96, 100, 196, 140};
    for (int k = 0; k < 4; k++) assert_true(fabs(box[k] - expected[k]) < 1e-9);
    /* A quarter turn against the clock about (146, 120): the rising end comes to the upper left. */
    assert_int_equal(bat_editor_enter(editor, "turn", "90°"), BAT_OK);
    const double *p = bat_curve_points(bat_object_curve(bat_document_at(editor->session.document, 0), 0));
    assert_true(bat_hypot(p[0] - 126, p[1] - 170) < 1e-9 && bat_hypot(p[2] - 166, p[3] - 70) < 1e-9);
    static const char *const bad[] = {"", "wide", "1mm*1mm", "0", "-5"};
    uint64_t now = digest(editor);
    for (int i = 0; i < 5; i++) assert_int_not_equal(bat_editor_enter(editor, "width", bad[i]), BAT_OK);
    assert_int_not_equal(bat_editor_enter(editor, "x", "1e300"), BAT_OK);
    assert_int_not_equal(bat_editor_enter(editor, "x", "9999999999999999999999999999999999999999"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "nonsense", "1"), BAT_UNSUPPORTED);
    assert_int_equal(bat_editor_enter(editor, "snap", "1"), BAT_UNSUPPORTED); /* a switch is no number */
    assert_true(digest(editor) == now);
    /* A level line has no height to scale. */
    bat_guide_put(&editor->context, 0, 1, 77);
    bat_editor_set(editor, "unit", 2);
    assert_int_equal(bat_editor_enter(editor, "guide", "2"), BAT_OK);
    expect_number(editor, "guide", "2 in");
    double at = 0;
    assert_true(guides(editor, 1, &at) == 1 && at == 192);
    assert_int_equal(bat_editor_enter(editor, "grid-spacing", "1/4"), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "grid-spacing", &at), BAT_OK);
    assert_true(at == 24);
    expect_number(editor, "grid-spacing", "0.25 in");
    bat_editor_set(editor, "unit", 0);
    /* A control point of the other line. */
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "tool-points");
    pen m = mouse(editor);
    for (int i = 0; i < 2; i++) { /* the line, then its end */
        double x = i ? 600 : 500, y = i ? 500 : 400;
        pen_event(&m, BAT_POINTER_DOWN, x, y);
        pen_event(&m, BAT_POINTER_UP, x, y);
        m.time += 1000;
    }
    expect_number(editor, "point-x", "600 px");
    assert_int_equal(bat_editor_enter(editor, "point-x", "640.5"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "point-y", "480"), BAT_OK);
    int index = bat_document_find(editor->session.document, 2);
    p = bat_curve_points(bat_object_curve(bat_document_at(editor->session.document, index), 0));
    assert_true(p[2] == 640.5 && p[3] == 480 && p[0] == 400 && p[1] == 300);
    /* Not while something is dragged. */
    pen_event(&m, BAT_POINTER_DOWN, 640.5, 480);
    pen_event(&m, BAT_POINTER_MOVE, 700, 480);
    assert_int_equal(bat_editor_enter(editor, "point-x", "1"), BAT_STATE);
    bat_editor_command(editor, "cancel");
    pen_event(&m, BAT_POINTER_UP, 700, 480);
    /* A point of a spline. */
    bat_editor_command(editor, "tool-tangents");
    for (int i = 0; i < 3; i++) {
        pen_event(&m, BAT_POINTER_DOWN, 700 + 60 * i, 700 - 40 * (i & 1));
        pen_event(&m, BAT_POINTER_UP, 700 + 60 * i, 700 - 40 * (i & 1));
        m.time += 1000;
    }
    assert_int_equal(bat_editor_enter(editor, "point-y", "650"), BAT_OK);
    expect_number(editor, "point-y", "650 px");
    replays(editor, 0);
    while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void isolated_is_all_there_is(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_command(editor, "isolate"), BAT_STATE); /* nothing is meant */
    pen_event(&p, BAT_POINTER_DOWN, 500, 200);
    pen_event(&p, BAT_POINTER_UP, 500, 200);
    assert_true(bat_editor_key(editor, "i", true, 0, p.time));
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->still[1].opacity == 1 && frame->still[2].opacity < 0.5F);
    bat_editor_command(editor, "select-all");
    assert_int_equal(editor->choice.selection.count, 1);
    drag(&p, 500, 600, 540, 640); /* nothing is there to take hold of */
    assert_true(digest(editor) == first);
    drag(&p, 100, 500, 900, 700);
    assert_int_equal(editor->choice.selection.count, 0);
    assert_int_equal(snap(editor, 201, 601).kind, BAT_SNAP_END); /* but to snap to */
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 300, 400, 700, 400, 10); /* what is drawn meanwhile is within reach */
    frame = bat_editor_frame(editor);
    assert_true(frame->still[3].opacity == 1);
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    frame = bat_editor_frame(editor);
    assert_true(frame->still[2].opacity == 1);
    assert_true(frame->dirty[0] < -1e6F); /* all of it is painted anew */
    bat_editor_command(editor, "tool-select");
    drag(&p, 500, 600, 540, 640);
    assert_int_equal(editor->choice.selection.count, 1);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void outlines_are_thin(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    uint32_t version = bat_editor_frame(editor)->still[1].version;
    bat_editor_set(editor, "filled", 1);
    bat_editor_command(editor, "outline");
    const bat_frame *frame = bat_editor_frame(editor);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(frame->still[i].flags, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH);
        assert_true(frame->still[i].width == 1 && frame->still[i].opacity == 1);
    }
    assert_int_equal(frame->still[1].version, version); /* the same path */
    bat_editor_command(editor, "outline");
    frame = bat_editor_frame(editor);
    assert_true(frame->still[1].width == 2 && !(frame->still[1].flags & BAT_ITEM_SCREEN_WIDTH));
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Random sessions with all of it on: invariants after every event, undo to the first drawing, replay to the last. */
static void wild_precision(void **state) {
    (void)state;
    static const char *const commands[] = {"tool-select",  "tool-points", "tool-tangents", "show-rulers",
                                           "show-grid",    "isolate",     "outline",       "guide-level",
                                           "guide-delete", "snap",        "select-all",    "guide-upright",
                                           "undo",         "tool-select", "delete",        "duplicate"};
    static const char *const names[] = {"x",       "y",       "width", "height", "turn",
                                        "point-x", "point-y", "guide", "snap",   "grid-spacing"};
    static const char *const texts[] = {"12", "3mm+4", "1/2in", "-7", "0", "1e", "90", "400"};
    enum { SIZE = 1200 };
    static uint8_t data[SIZE];
    int with_guides = 0;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed * 99991});
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        double time = 0;
        bat_editor_set(editor, "snap-curves", 1);
        bat_editor_command(editor, "show-rulers");
        while (bytes.at < bytes.size) {
            if (session_byte(&bytes) < 100) {
                bat_editor_command(editor, commands[session_byte(&bytes) % 16]);
                const char *name = names[session_byte(&bytes) % 10];
                bat_editor_enter(editor, name, texts[session_byte(&bytes) % 8]);
                bat_editor_frame(editor);
            }
            session_event(editor, &bytes, &time);
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, bytes.at, wrong);
        }
        for (int i = 0; i < 4; i++) bat_editor_command(editor, "cancel");
        double at;
        with_guides += guides(editor, 0, &at) + guides(editor, 1, &at) > 0;
        replays(editor, 0);
        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
    assert_true(with_guides > 20);
}

/* Without memory nothing changes, whatever of it fails. */
static void without_memory_nothing_changes(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_select(editor, 1, false);
    bat_editor_frame(editor);
    for (int what = 0; what < 4; what++) {
        uint64_t before = digest(editor);
        bat_status status = BAT_MEMORY;
        for (int n = 1; status == BAT_MEMORY; n++) {
            assert_true(n < 200);
            alloc_fail_at(n);
            status = what == 0   ? bat_guide_put(&editor->context, 0, 1, 55)
                     : what == 1 ? bat_editor_enter(editor, "x", "17")
                     : what == 2 ? bat_editor_command(editor, "isolate")
                                 : bat_command_guide_delete(&editor->context, true);
            alloc_fail_reached();
            if (status == BAT_MEMORY) assert_true(digest(editor) == before);
            assert_null(bat_editor_check(editor));
        }
        assert_int_equal(status, BAT_OK);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snaps_to_known_places),
        cmocka_unit_test(guides_and_grid_draw),
        cmocka_unit_test(guides_by_hand),
        cmocka_unit_test(a_layer_moves_with_its_guides),
        cmocka_unit_test(moves_snap),
        cmocka_unit_test(units_are_read_and_written),
        cmocka_unit_test(rulers_tell_places),
        cmocka_unit_test(numbers_are_entered),
        cmocka_unit_test(wild_precision),
        cmocka_unit_test(without_memory_nothing_changes),
        cmocka_unit_test(isolated_is_all_there_is),
        cmocka_unit_test(outlines_are_thin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
