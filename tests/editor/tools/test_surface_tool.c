/* The surface tool: which line a marking, a tap and the keyboard light, how it slides and how it is let go; a stroke
 * redraws it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "base/real.h"
#include "editor/editor.h"
#include "editor/tools/surface/state.h"
#include "editor/tools/toolbox.h"
#include "support/editing.h"
#include "support/sheet.h"

enum { SHEET = 7 };

static bat_editor *with(const bat_surface *surface) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(sheet_add(document, SHEET, surface), BAT_OK);
    bat_editor *editor = editor_of(document);
    assert_int_equal(bat_editor_command(editor, "tool-surface"), BAT_OK);
    return editor;
}

static bat_editor *with_sheet(void) {
    bat_surface *surface = sheet_create();
    bat_editor *editor = with(surface);
    bat_surface_free(surface);
    return editor;
}

static const bat_line *lit(bat_editor *editor) {
    return &((bat_surfacing *)bat_toolbox_state(&editor->context, bat_tool_surface()))->lit;
}

static void expect(bat_editor *editor, bat_direction direction, double value, double within) {
    const bat_line *line = lit(editor);
    check(editor);
    assert_int_equal(line->object, SHEET);
    assert_int_equal(line->direction, direction);
    if (!(fabs(line->at[direction] - value) <= within)) fail_msg("at %g, not %g", line->at[direction], value);
}

/* The sheet lies over 300..700 x 200..600; u runs along x over 0..4, v along y over 0..3, nearly evenly inside. */
static void a_marking_lights_its_line(void **state) {
    (void)state;
    for (int i = 0; i < 6; i++) { /* the view turned, too */
        bat_editor *editor = with_sheet();
        const uint64_t first = digest(editor);
        for (int k = 0; k < i; k++) bat_editor_command(editor, "view-left");
        bat_viewpoint view;
        double from[2], to[2];
        assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
        bat_viewpoint_project(&view, (double[]){500, 330, 0}, from, NULL);
        bat_viewpoint_project(&view, (double[]){500, 460, 0}, to, NULL);
        pen p = pen_for(editor);
        drag(&p, from[0], from[1], to[0], to[1]);
        expect(editor, BAT_U, 2, 0.05);
        bat_viewpoint_project(&view, (double[]){340, 400, 0}, from, NULL);
        bat_viewpoint_project(&view, (double[]){450, 400, 0}, to, NULL);
        drag(&p, to[0], to[1], from[0], from[1]);
        expect(editor, BAT_V, 1.5, 0.05);
        assert_true(digest(editor) == first);
        assert_int_equal(round_trip(editor, first), 0);
        bat_editor_free(editor);
    }
}

static void an_edge_is_meant_near_it(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    drag(&p, 302, 300, 302, 480);
    expect(editor, BAT_U, 0, 0);
    drag(&p, 400, 598, 560, 598);
    expect(editor, BAT_V, 3, 0);
    drag(&p, 50, 50, 200, 60); /* beside the surface */
    assert_int_equal(lit(editor)->object, 0);
    assert_true(strstr(bat_editor_frame(editor)->notice, "no surface") != NULL);
    bat_editor_free(editor);
}

static void taps_choose_flip_and_let_go(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430); /* the line at u = 2 is seen 3 px beside, none of the other direction as near */
    expect(editor, BAT_U, 2.03, 0.05);
    const double v = lit(editor)->at[1];
    tap(&p, 640, 431); /* on the other line through that point */
    expect(editor, BAT_V, v, 0);
    tap(&p, 600, 430); /* on the lit one: nothing happens */
    expect(editor, BAT_V, v, 0);
    tap(&p, 503, 330); /* on the first again */
    expect(editor, BAT_U, 2.03, 0.05);
    tap(&p, 600, 300);
    assert_int_equal(lit(editor)->object, 0);
    tap(&p, 100, 100);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

static void the_grip_slides_the_line(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430);
    const double u = lit(editor)->at[0];
    drag(&p, 503, 430, 560, 440);
    const double there = lit(editor)->at[0];
    if (!(there > 2.7 && there < 2.95)) fail_msg("at %g", there);
    drag(&p, 560, 430, 502, 430); /* stops at the middle, a knot */
    expect(editor, BAT_U, 2, 0);
    drag(&p, 500, 430, 305, 430); /* and at the edge */
    expect(editor, BAT_U, 0, 0);
    drag_to(&p, 300, 430, 503, 430);
    assert_true(lit(editor)->at[0] > 1);
    bat_editor_command(editor, "cancel");
    expect(editor, BAT_U, 0, 0);
    pen_event(&p, BAT_POINTER_UP, 503, 430);
    expect(editor, BAT_U, 0, 0);
    bat_editor_command(editor, "cancel");
    assert_int_equal(lit(editor)->object, 0);
    assert_true(u > 2);
    bat_editor_free(editor);
}

static void the_keyboard_does_the_same(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    bat_editor_key(editor, "Tab", true, 0, 10);
    expect(editor, BAT_U, 2, 0);
    bat_editor_key(editor, "ArrowRight", true, 0, 20);
    expect(editor, BAT_U, 2.04, 1e-12);
    bat_editor_key(editor, ".", true, 0, 30);
    expect(editor, BAT_U, 3, 0);
    bat_editor_key(editor, ",", true, 0, 40);
    expect(editor, BAT_U, 2, 0);
    bat_editor_key(editor, "Tab", true, 0, 50);
    expect(editor, BAT_V, 1.5, 0);
    for (int i = 0; i < 20; i++) bat_editor_key(editor, "ArrowLeft", true, BAT_SHIFT, 60 + i);
    expect(editor, BAT_V, 0, 0);
    bat_editor_key(editor, "Escape", true, 0, 90);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

/* The lit line is shown with its name, and goes with its surface. */
static void the_line_goes_with_its_surface(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->label_count, 1);
    assert_non_null(strstr(frame->labels[0].text, "line at u = 2.0"));
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    bat_editor_command(editor, "tool-surface");
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_command(editor, "point-previous"); /* the copy, which lies in front */
    assert_true(lit(editor)->object > SHEET);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_frame(editor);
    check(editor);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

static bat_surfacing *state_of(bat_editor *editor) {
    return bat_toolbox_state(&editor->context, bat_tool_surface());
}

static const bat_surface *sheet_in(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_object_surface(bat_document_at(document, bat_document_find(document, SHEET)));
}

/* Draws a bump of that height over the line at u = 2, which lies at x = 500, between y = 250 and 550. */
static void draw_bump(pen *p, double height, bool lift) {
    p->time += 1000;
    pen_event(p, BAT_POINTER_HOVER, 500, 250);
    bat_editor_frame(p->editor);
    pen_event(p, BAT_POINTER_DOWN, 500, 250);
    for (int i = 1; i <= 30; i++) {
        const double t = i / 30.0, w = 16 * t * t * (1 - t) * (1 - t);
        pen_event(p, BAT_POINTER_MOVE, 500 + height * w, 250 + 300 * t);
        if (i % 5 == 0) bat_editor_frame(p->editor);
        check(p->editor);
    }
    if (!lift) return;
    pen_event(p, BAT_POINTER_UP, 500, 550);
    bat_editor_frame(p->editor);
    check(p->editor);
}

/* Lights the line at u = 2. */
static pen at_the_middle(bat_editor *editor) {
    pen p = pen_for(editor);
    bat_editor_key(editor, "Tab", true, 0, 10);
    expect(editor, BAT_U, 2, 0);
    return p;
}

/* The line passes through the stroke, the surface moves as far as was shown and no further, in one step that the journal
 * repeats, and what was shown last is what is committed. */
static void a_stroke_redraws_the_lit_line(void **state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        bat_editor *editor = with_sheet();
        const uint64_t first = digest(editor);
        bat_surface *before = NULL, *shown = NULL;
        bat_surface_copy(sheet_in(editor), &before);
        pen p = at_the_middle(editor);
        bat_editor_frame(editor);
        const bat_line_reach reach = state_of(editor)->reach;
        assert_true(reach.known && reach.moved[0] < 2 && reach.moved[1] > 2);
        draw_bump(&p, 40 - 30 * turn, false);
        assert_true(digest(editor) == first);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_true(frame->busy && frame->knots_before == 10 && frame->knots_after >= 10);
        assert_non_null(state_of(editor)->made.surface);
        bat_surface_copy(state_of(editor)->made.surface, &shown);
        pen_event(&p, BAT_POINTER_UP, 500, 550);
        frame = bat_editor_frame(editor);
        assert_true(strstr(frame->notice, "Knots: 11") == frame->notice);
        const bat_surface *after = sheet_in(editor);
        assert_true(bat_surface_is_equal(after, shown));
        double off = 0, point[3], was[3];
        for (int i = 0; i <= 100; i++) { /* the bump, seen from before the page */
            bat_surface_eval(after, 2, 0.03 * i, 0, point);
            const double t = fmin(fmax((point[1] - 250) / 300, 0), 1), w = 16 * t * t * (1 - t) * (1 - t);
            off = fmax(off, fabs(point[0] - 500 - (40 - 30 * turn) * w));
        }
        if (!(off < 3)) fail_msg("the line is %g from the stroke", off);
        for (int i = 0; i <= 100; i++) {
            const double v = 0.03 * i, outside[2] = {reach.moved[0] - 1e-9, reach.moved[1] + 1e-9};
            for (int k = 0; k < 2; k++) {
                if (outside[k] < 0 || outside[k] > 4) continue;
                bat_surface_eval(after, outside[k], v, 0, point);
                bat_surface_eval(before, outside[k], v, 0, was);
                for (int d = 0; d < 3; d++) assert_true(fabs(point[d] - was[d]) < 1e-6);
            }
        }
        expect(editor, BAT_U, 2, 0); /* still lit */
        assert_int_equal(round_trip(editor, first), 1);
        bat_surface_free(before);
        bat_surface_free(shown);
        bat_editor_free(editor);
    }
}

static void a_stroke_that_cannot_is_refused_in_words(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    const uint64_t first = digest(editor);
    pen p = at_the_middle(editor);
    draw_bump(&p, 40, false);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    pen_event(&p, BAT_POINTER_UP, 500, 550);
    bat_editor_frame(editor);
    check(editor);
    assert_true(digest(editor) == first);
    expect(editor, BAT_U, 2, 0);
    bat_editor_free(editor);

    bat_surface *sheet = sheet_create(), *poled = NULL; /* the edge u = 0 is one point */
    double points[7 * 6 * 3];
    for (int i = 0; i < 7; i++) memcpy(points + 18 * i, bat_surface_row(sheet, i), 18 * sizeof *points);
    for (int j = 1; j < 6; j++) memcpy(points + 3 * j, points, 3 * sizeof *points);
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){7, 6}, points, (const int[2]){11, 10},
                                        bat_surface_knots(sheet, BAT_U), bat_surface_knots(sheet, BAT_V),
                                        &poled),
                     BAT_OK);
    editor = with(poled);
    const uint64_t whole = digest(editor);
    p = pen_for(editor);
    bat_editor_command(editor, "point-next");
    for (int i = 0; i < 2; i++) bat_editor_command(editor, "knot-previous");
    expect(editor, BAT_U, 0, 0);                         /* the pole itself */
    drag(&p, points[0] + 18, points[1], points[0] + 100, /* beside the grip */
         points[1] + 200);
    assert_true(digest(editor) == whole);
    assert_true(strstr(bat_editor_frame(editor)->notice, "pole") != NULL);
    bat_surface_free(sheet);
    bat_surface_free(poled);
    bat_editor_free(editor);
}

/* Redrawn again and again, the surface does not grow. */
static void many_redraws_do_not_add_up(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    const uint64_t first = digest(editor);
    pen p = at_the_middle(editor);
    size_t after_first = 0;
    for (int i = 0; i < 20; i++) {
        draw_bump(&p, 40 * cos(1.7 * i), true);
        const size_t points = bat_surface_count(sheet_in(editor), BAT_V);
        if (i == 0) after_first = points;
        assert_int_equal(bat_surface_count(sheet_in(editor), BAT_U), 7);
        if (2 * points > 3 * after_first) fail_msg("%d points after %d", (int)points, i + 1);
    }
    assert_int_equal(round_trip(editor, first), 20);
    bat_editor_free(editor);
}

/* The reach that is shown grows with the property; in a tilted view a line is lit and redrawn as face-on. */
static void reach_locks_and_tilt(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    const uint64_t first = digest(editor);
    pen p = at_the_middle(editor);
    bat_editor_frame(editor);
    const bat_line_reach usual = state_of(editor)->reach;
    for (int i = 0; i < 4; i++) bat_editor_key(editor, "[", true, 0, 50);
    bat_editor_frame(editor);
    const bat_line_reach less = state_of(editor)->reach;
    /* half a span: one row moves, and with it all four spans that it lies over */
    assert_true(less.known && less.radius == 0.5 && less.moved[0] == 0 && less.moved[1] == 4);
    for (int i = 0; i < 4; i++) bat_editor_key(editor, "]", true, 0, 60);
    bat_editor_frame(editor);
    assert_memory_equal(state_of(editor)->reach.moved, usual.moved, sizeof usual.moved);

    double at[2]; /* the padlock of the edge u = 0: the edge and then its tangents stay */
    assert_true(bat_surfacing_padlock(&editor->context, state_of(editor), 0, at));
    for (int lock = 1; lock <= 4; lock++) {
        tap(&p, at[0], at[1]);
        double value = -1;
        assert_int_equal(bat_editor_get(editor, "lock-u-low", &value), BAT_OK);
        assert_true(value == lock % 4);
        expect(editor, BAT_U, 2, 0);
    }
    bat_surface *before = NULL;
    bat_surface_copy(sheet_in(editor), &before);
    bat_editor_set(editor, "lock-u-low", 2);
    draw_bump(&p, 30, true);
    assert_true(digest(editor) != first);
    for (int i = 0; i <= 20; i++) {
        double was[9], now[9];
        bat_surface_eval(before, 0, 0.15 * i, 1, was);
        bat_surface_eval(sheet_in(editor), 0, 0.15 * i, 1, now);
        for (int k = 0; k < 9; k++) assert_true(fabs(was[k] - now[k]) < 1e-6);
    }
    bat_editor_set(editor, "lock-v-low", 1);
    const uint64_t locked = digest(editor);
    for (int on = 1; on >= 0;
         on--) { /* beside the end of the line, which the stroke moves: not while it is locked */
        bat_editor_set(editor, "lock-v-low", on);
        p.time += 1000;
        pen_event(&p, BAT_POINTER_DOWN, 520, 202);
        for (int i = 1; i <= 30; i++) pen_event(&p, BAT_POINTER_MOVE, 520 - i * 0.2, 202 + 6 * i);
        pen_event(&p, BAT_POINTER_UP, 514, 382);
        const char *notice = bat_editor_frame(editor)->notice;
        check(editor);
        assert_true((digest(editor) == locked) == on);
        assert_true((strstr(notice, "locked") != NULL) == on);
    }
    assert_true(round_trip(editor, first) >= 1);
    bat_surface_free(before);
    bat_editor_free(editor);

    editor = with_sheet();
    const uint64_t flat = digest(editor);
    for (int i = 0; i < 2; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    assert_true(bat_stage_tilted(editor->context.stage));
    bat_viewpoint view;
    double from[2], to[2];
    assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
    bat_viewpoint_project(&view, (double[]){500, 330, 0}, from, NULL);
    bat_viewpoint_project(&view, (double[]){500, 460, 0}, to, NULL);
    p = pen_for(editor);
    drag(&p, from[0], from[1], to[0], to[1]);
    expect(editor, BAT_U, 2, 0.4);
    bat_editor_key(editor, ".", true, 0, 1e6);
    expect(editor, BAT_U, 3, 1);
    double point[3], along[2];
    bat_surface_eval(sheet_in(editor), lit(editor)->at[0], 1, 0, point);
    bat_viewpoint_project(&view, point, from, NULL);
    bat_surface_eval(sheet_in(editor), lit(editor)->at[0], 2.5, 0, point);
    bat_viewpoint_project(&view, point, to, NULL);
    along[0] = to[0] - from[0], along[1] = to[1] - from[1];
    p.time += 1000;
    pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
    for (int i = 1; i <= 30; i++) {
        const double t = i / 30.0, w = 16 * t * t * (1 - t) * (1 - t) * 0.15;
        pen_event(&p, BAT_POINTER_MOVE, from[0] + along[0] * t - along[1] * w,
                  from[1] + along[1] * t + along[0] * w);
    }
    pen_event(&p, BAT_POINTER_UP, to[0], to[1]);
    bat_editor_frame(editor);
    assert_true(digest(editor) != flat);
    assert_int_equal(round_trip(editor, flat), 1);
    bat_editor_free(editor);
}

/* Beside a locked edge the surface moves farther than the line: told from 1.25 times on, refused over 4 times. */
static void a_gain_is_told(void **state) {
    (void)state;
    static const struct {
        double u;
        const char *says;
    } cases[] = {{0.02, "would move over 4 times"}, {0.2, "times as far as the line"}, {1.5, "Knots: "}};
    for (int i = 0; i < 3; i++) {
        bat_editor *editor = with_sheet();
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        bat_editor_set(editor, "lock-u-low", 1);
        state_of(editor)->lit = (bat_line){SHEET, BAT_U, {cases[i].u, 2.4}};
        bat_editor_frame(editor);
        bat_viewpoint view;
        double point[3], from[2], to[2];
        assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
        bat_surface_eval(sheet_in(editor), cases[i].u, 0.7, 0, point);
        bat_viewpoint_project(&view, point, from, NULL);
        bat_surface_eval(sheet_in(editor), cases[i].u, 2, 0, point);
        bat_viewpoint_project(&view, point, to, NULL);
        pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
        for (int k = 1; k <= 30; k++) {
            const double t = k / 30.0, w = 16 * t * t * (1 - t) * (1 - t);
            pen_event(&p, BAT_POINTER_MOVE, from[0] + (to[0] - from[0]) * t + 8 * w,
                      from[1] + (to[1] - from[1]) * t);
        }
        pen_event(&p, BAT_POINTER_UP, to[0], to[1]);
        const char *notice = bat_editor_frame(editor)->notice;
        const double gain = state_of(editor)->report.redraw.gain;
        if (!strstr(notice, cases[i].says)) fail_msg("%g: %s, gain %g", cases[i].u, notice, gain);
        assert_true(i == 0 ? gain > 4 : i == 1 ? gain > 1.25 && gain <= 4 : gain <= 1.25);
        if (i == 1) { /* the number that is told is the gain */
            const char *digits = notice + strcspn(notice, "0123456789");
            assert_true(fabs(strtod(digits, NULL) - gain) <= 0.0051);
        }
        assert_true((digest(editor) == first) == (i == 0));
        assert_int_equal(round_trip(editor, first), i != 0);
        bat_editor_free(editor);
    }
}

/* A tap shows both lines through the place: each drawn from edge to edge where the surface has it. */
static void a_tap_shows_both_lines(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430);
    const bat_frame *frame = bat_editor_frame(editor);
    static const bat_role roles[2] = {BAT_ROLE_HIGHLIGHT, BAT_ROLE_GHOST};
    for (int d = 0; d < 2; d++) {
        const bat_item *item = pen_live(frame, roles[d]);
        assert_non_null(item);
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, point[3], pixel[2];
        bat_viewpoint view;
        bat_stage_viewpoint(editor->context.stage, &view);
        for (int i = 0; i <= 400; i++) {
            const double *at = lit(editor)->at;
            bat_surface_eval(sheet_in(editor), d ? i * 0.01 : at[0], d ? at[1] : i * 0.0075, 0, point);
            bat_viewpoint_project(&view, point, pixel, NULL);
            double drawn[2];
            bat_stage_seen(editor->context.stage, pixel, drawn);
            for (int k = 0; k < 2; k++) low[k] = fmin(low[k], drawn[k]), high[k] = fmax(high[k], drawn[k]);
        }
        for (int k = 0; k < 2; k++) { /* the picture's box, with the line's width */
            assert_true(fabs(item->bounds[k] + frame->origin[k] - low[k]) < 3);
            assert_true(fabs(item->bounds[2 + k] + frame->origin[k] - high[k]) < 3);
        }
        assert_true(high[d ? 0 : 1] - low[d ? 0 : 1] > 395);
    }
    bat_editor_free(editor);
}

/* A tube over the page, closed round its axis, whose seam is at its row `seam`. */
static bat_surface *tube(int seam) {
    enum { ROUND = 12, LONG = 7 };
    double points[ROUND * LONG * 3], u[ROUND + 1], v[LONG + 4];
    for (int i = 0; i <= ROUND; i++) u[i] = i;
    for (int j = 0; j < LONG + 4; j++) v[j] = fmin(fmax(j - 3, 0), LONG - 3);
    for (int i = 0; i < ROUND; i++)
        for (int j = 0; j < LONG; j++) {
            double *q = points + 3 * (i * LONG + j);
            const int k = (i + seam) % ROUND;
            const double angle = 2 * BAT_PI * k / ROUND, radius = 120 + 6.0 * ((3 * k + 5 * j) % 4);
            q[0] = 300 + 400.0 * j / (LONG - 1), q[1] = 400 + radius * cos(angle), q[2] = radius * sin(angle);
        }
    bat_surface *surface = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, false},
                                        (const size_t[2]){ROUND, LONG}, points,
                                        (const int[2]){ROUND + 1, LONG + 4}, u, v, &surface),
                     BAT_OK);
    return surface;
}

/* A stroke over the tube, from one place to another: k rows round it (wherever its seam is), and along it; it bulges by so
 * many pixels. */
static void over_tube(pen *p, const bat_surface *surface, int seam, const double from[2], const double to[2],
                      double height) {
    bat_viewpoint view;
    double point[3], at[2], last[2] = {0, 0};
    bat_stage_viewpoint(p->editor->context.stage, &view);
    p->time += 1000;
    for (int i = 0; i <= 30; i++) {
        const double t = i / 30.0, w = 16 * t * t * (1 - t) * (1 - t);
        bat_surface_eval(surface, from[0] + t * (to[0] - from[0]) + 2 - seam, from[1] + t * (to[1] - from[1]),
                         0, point);
        assert_int_equal(bat_viewpoint_project(&view, point, at, NULL), BAT_OK);
        last[0] = at[0] + height * w, last[1] = at[1];
        pen_event(p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, last[0], last[1]);
    }
    pen_event(p, BAT_POINTER_UP, last[0], last[1]);
    check(p->editor);
}

/* Lines cross the seam unseen: wherever it is, the same strokes light the same lines and make the same surface. */
static void the_seam_is_not_felt(void **state) {
    (void)state;
    enum { SEAMS = 12 };
    bat_surface *first_made = NULL;
    double first_at[2] = {0, 0};
    for (int seam = 0; seam < SEAMS; seam++) {
        bat_surface *surface = tube(seam);
        bat_editor *editor = with(surface);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor); /* face-on the back of the tube is seen where its front is */
        over_tube(&p, surface, seam, (double[]){9.3, 1}, (double[]){9.3, 2}, 0); /* along it: the line at u */
        assert_int_equal(lit(editor)->direction, BAT_U);
        const double at = fmod(lit(editor)->at[0] + seam, SEAMS);
        if (seam == 0) first_at[0] = at;
        assert_true(fabs(remainder(at - first_at[0], SEAMS)) < 1e-4);
        bat_editor_command(editor, "cancel");
        over_tube(&p, surface, seam, (double[]){8.4, 1.8}, (double[]){9.6, 1.8}, 0); /* round it */
        assert_int_equal(lit(editor)->direction, BAT_V);
        if (seam == 0) first_at[1] = lit(editor)->at[1];
        assert_true(fabs(lit(editor)->at[1] - first_at[1]) < 1e-4);
        over_tube(&p, surface, seam, (double[]){7.6, first_at[1]}, (double[]){10.4, first_at[1]}, 30);
        const bat_surface *now = sheet_in(editor);
        if (seam == 0) bat_surface_copy(now, &first_made);
        double worst = 0, moved = 0, a[3], b[3], c[3];
        for (int i = 0; i < 48; i++)
            for (int j = 0; j <= 20; j++) {
                bat_surface_eval(now, 0.25 * i, 0.2 * j, 0, a);
                bat_surface_eval(surface, 0.25 * i, 0.2 * j, 0, c);
                bat_surface_eval(first_made, 0.25 * i + seam, 0.2 * j, 0, b);
                for (int k = 0; k < 3; k++) {
                    worst = fmax(worst, fabs(a[k] - b[k]));
                    moved = fmax(moved, fabs(a[k] - c[k]));
                }
            }
        assert_true(moved > 15);
        bat_surface_eval(now, 11 - seam, first_at[1], 0, a);
        bat_surface_eval(surface, 11 - seam, first_at[1], 0, c);
        assert_true(fabs(a[0] - c[0]) > 15); /* in front */
        if (!(worst < 1)) fail_msg("seam %d: %g apart", seam, worst);
        assert_int_equal(round_trip(editor, first), 1);
        bat_surface_free(surface);
        bat_editor_free(editor);
    }
    bat_surface_free(first_made);
}

/* The eye is put before the whole surface, however far it reaches towards it. */
static void a_deep_surface_is_seen(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_surface *sheet = sheet_create(), *deep = NULL;
    const double rows[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1e9};
    assert_int_equal(bat_surface_transform(sheet, rows, &deep), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(sheet_add(document, SHEET, deep), BAT_OK);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-surface");
    pen p = pen_for(editor);
    drag(&p, 500, 330, 500, 460);
    expect(editor, BAT_U, 2, 0.05);
    bat_surface_free(sheet);
    bat_surface_free(deep);
    bat_editor_free(editor);
}

static double choice_in(bat_editor *editor) {
    double value = -1;
    assert_int_equal(bat_editor_get(editor, "line-ruling", &value), BAT_OK);
    return value;
}

/* A tilted view with the line at u = 2 lit. */
static bat_editor *with_tilted_line(int tilts) {
    bat_editor *editor = with_sheet();
    bat_editor_key(editor, "Tab", true, 0, 10);
    for (int i = 0; i < tilts; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    bat_editor_frame(editor);
    expect(editor, BAT_U, 2, 0);
    return editor;
}

/* Where a direction at the grip is seen to end, so many pixels long in space. */
static void seen_from_grip(bat_editor *editor, const double way[3], double pixels, double out[2]) {
    double at[3], drawn[2];
    bat_surface_eval(sheet_in(editor), 2, lit(editor)->at[1], 0, at);
    for (int k = 0; k < 3; k++) at[k] += pixels * bat_stage_pixel(editor->context.stage) * way[k];
    bat_stage_look(editor->context.stage, 3, at, drawn);
    bat_stage_project(editor->context.stage, drawn, out);
}

/* The handle turns the sheet to any direction across the line, and strokes land on the sheet as it is turned. */
static void a_handle_turns_the_sheet(void **state) {
    (void)state;
    for (int turn = -2; turn <= 2; turn++) {
        bat_editor *editor = with_tilted_line(3);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        double grip[2], at[2], jet[9], out[2], to[2];
        assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
        const double far = hypot(at[0] - grip[0], at[1] - grip[1]), angle = 0.5 * turn + 0.2;
        assert_true(far >= 28 - 1e-9 && far <= 64 + 1e-9);
        for (int k = 0; k < 2; k++) {
            const double x = (at[0] - grip[0]) / far, y = (at[1] - grip[1]) / far;
            to[k] = round(grip[k] +
                          60 * (k ? sin(angle) * x + cos(angle) * y : cos(angle) * x - sin(angle) * y));
        }
        p.modifiers = BAT_SHIFT;
        drag(&p, at[0], at[1], to[0], to[1]);
        p.modifiers = 0;
        assert_true(choice_in(editor) == 4);
        const double *way = state_of(editor)->free;
        bat_surface_eval(sheet_in(editor), 2, lit(editor)->at[1], 1, jet);
        double length = 0, along = 0, speed = 0;
        for (int k = 0; k < 3; k++)
            length += way[k] * way[k], along += way[k] * jet[6 + k], speed += jet[6 + k] * jet[6 + k];
        assert_true(fabs(length - 1) < 1e-9);
        seen_from_grip(editor, way, 60, out);
        assert_true(fabs((out[0] - grip[0]) * (to[1] - grip[1]) - (out[1] - grip[1]) * (to[0] - grip[0])) <
                    1e-6);
        assert_true((out[0] - grip[0]) * (to[0] - grip[0]) + (out[1] - grip[1]) * (to[1] - grip[1]) > 0);
        double right[3], down[3], ahead[3], facing = 0;
        bat_view_axes(&editor->stage.view, right, down, ahead);
        for (int k = 0; k < 3; k++) facing += ahead[k] * jet[6 + k] / sqrt(speed);
        if (fabs(facing) > 0.26) assert_true(fabs(along) < 1e-6 * sqrt(speed));
        assert_true(digest(editor) == first);
        /* a stroke lands on it */
        double a[3], b[3], drawn[2], from[2], end[2], free[3];
        memcpy(free, way, sizeof free);
        bat_surface_eval(sheet_in(editor), 2, 0.6, 0, a);
        bat_surface_eval(sheet_in(editor), 2, 1.3, 0, b);
        bat_stage_look(editor->context.stage, 3, a, drawn),
            bat_stage_project(editor->context.stage, drawn, from);
        bat_stage_look(editor->context.stage, 3, b, drawn),
            bat_stage_project(editor->context.stage, drawn, end);
        p.time += 1000;
        pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
        for (int i = 1; i <= 20; i++)
            pen_event(&p, BAT_POINTER_MOVE, from[0] + (end[0] - from[0]) * i / 20,
                      from[1] + (end[1] - from[1]) * i / 20 + 4 * sin(i * 0.157));
        bat_editor_frame(editor);
        check(editor);
        if (state_of(editor)->made.surface)
            for (int k = 0; k < 3; k++)
                assert_true(fabs(state_of(editor)->report.along[k] - free[k]) < 1e-12);
        pen_event(&p, BAT_POINTER_UP, end[0], end[1]);
        assert_true(round_trip(editor, first) <= 1);
        bat_editor_free(editor);
    }
}

/* Taps take the next choice; a drag stops at the axes; Esc takes a turn back. */
static void the_handle_stops_and_steps(void **state) {
    (void)state;
    bat_editor *editor = with_tilted_line(3);
    pen p = pen_for(editor);
    double grip[2], at[2], to[2];
    static const int without[] = {1, 2, 3, 0}, with_free[] = {0, 1, 2, 3, 4};
    for (size_t i = 0; i < 4; i++) {
        assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
        tap(&p, at[0], at[1]);
        assert_true(choice_in(editor) == without[i]);
        expect(editor, BAT_U, 2, 0);
    }
    assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
    drag_to(&p, at[0], at[1], grip[0] + 50, grip[1] + 31);
    assert_non_null(strstr(bat_editor_frame(editor)->hint, "Turns the drawing plane"));
    assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
    pen_event(&p, BAT_POINTER_UP, grip[0] + 50, grip[1] + 31);
    check(editor);
    assert_true(choice_in(editor) == 0);
    expect(editor, BAT_U, 2, 0);
    seen_from_grip(editor, (double[]){1, 0, 0}, 60, to); /* the line runs along y: x lies across it */
    drag(&p, at[0], at[1], to[0], to[1]);
    assert_true(choice_in(editor) == 1);
    assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
    p.modifiers = BAT_SHIFT;
    drag(&p, at[0], at[1], grip[0] + 20, grip[1] - 55);
    p.modifiers = 0;
    assert_true(choice_in(editor) == 4);
    for (size_t i = 0; i < 5; i++) {
        assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
        tap(&p, at[0], at[1]);
        assert_true(choice_in(editor) == with_free[i]);
    }
    bat_editor_free(editor);
}

/* A finger beside the pen changes nothing: the first gesture wins. */
static void of_two_gestures_the_first_wins(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++) { /* a turn of the handle, a redraw */
        bat_editor *editor = with_tilted_line(2);
        pen p = pen_for(editor), finger = pen_for(editor);
        double grip[2], at[2];
        finger.device = BAT_DEVICE_TOUCH, finger.contact = 9;
        assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
        if (way) at[0] = grip[0] + 3, at[1] = grip[1] + 24;
        drag_to(&p, at[0], at[1], at[0] + 30, at[1] + 40);
        const bat_lining doing = state_of(editor)->doing;
        assert_int_equal(doing, way ? BAT_LINING_DRAW : BAT_LINING_TURN);
        const double angle = bat_editor_frame(editor)->view[3];
        finger.time = p.time;
        drag(&finger, 700, 300, 760, 420);
        assert_int_equal(state_of(editor)->doing, doing);
        assert_true(bat_editor_frame(editor)->view[3] == angle);
        pen_event(&p, BAT_POINTER_UP, at[0] + 30, at[1] + 40);
        check(editor);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_marking_lights_its_line),
        cmocka_unit_test(an_edge_is_meant_near_it),
        cmocka_unit_test(taps_choose_flip_and_let_go),
        cmocka_unit_test(the_grip_slides_the_line),
        cmocka_unit_test(the_keyboard_does_the_same),
        cmocka_unit_test(the_line_goes_with_its_surface),
        cmocka_unit_test(a_deep_surface_is_seen),
        cmocka_unit_test(a_stroke_redraws_the_lit_line),
        cmocka_unit_test(a_stroke_that_cannot_is_refused_in_words),
        cmocka_unit_test(many_redraws_do_not_add_up),
        cmocka_unit_test(reach_locks_and_tilt),
        cmocka_unit_test(a_gain_is_told),
        cmocka_unit_test(a_tap_shows_both_lines),
        cmocka_unit_test(the_seam_is_not_felt),
        cmocka_unit_test(a_handle_turns_the_sheet),
        cmocka_unit_test(the_handle_stops_and_steps),
        cmocka_unit_test(of_two_gestures_the_first_wins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
