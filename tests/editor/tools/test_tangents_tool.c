/*
 * The tangents tool, state by state: the effect of taps and drags on the document, what is shown meanwhile, that every
 * step undoes, and that the journal replays to the same.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include "support/session.h"
#include <batten/bezier.h>
#include "editor/tools/tangents/state.h"

static const double PI = 3.14159265358979323846;

static pen begin(bat_editor **editor) {
    *editor = pen_editor();
    assert_int_equal(bat_editor_command(*editor, "tool-tangents"), BAT_OK);
    return pen_for(*editor);
}

static const bat_frame *show(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    check(editor);
    return frame;
}

static void twice(pen *p, double x, double y) {
    tap(p, x, y);
    p->time += 100;
    pen_event(p, BAT_POINTER_DOWN, x, y);
    pen_event(p, BAT_POINTER_UP, x, y);
    show(p->editor);
}

/* Shortcut keys without modifiers, or with. */
static bool key(bat_editor *editor, const char *name, uint32_t modifiers) {
    bool used = bat_editor_key(editor, name, true, modifiers, 0);
    bat_editor_key(editor, name, false, 0, 0);
    show(editor);
    return used;
}

static int objects(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }
static const bat_object *newest(const bat_editor *editor) {
    return bat_document_at(bat_editor_document(editor), objects(editor) - 1);
}
static const bat_spline *spline_of(const bat_editor *editor) { return bat_object_spline(newest(editor)); }
/* A zigzag of four points, y 300 and 500, placed and ended. */
static void four_points(pen *p) {
    for (int i = 0; i < 4; i++) tap(p, 200 + 150 * i, i % 2 ? 500 : 320);
    assert_true(key(p->editor, "Enter", 0));
}

static void taps_place_points(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    tap(&p, 200, 320);
    assert_int_equal(objects(editor), 2); /* one point is no curve yet */
    assert_non_null(pen_live(show(editor), BAT_ROLE_PROMPT));
    tap(&p, 350, 500);
    assert_int_equal(objects(editor), 3);
    tap(&p, 500, 320);
    const bat_spline *s = spline_of(editor);
    assert_int_equal(s->count, 3);
    const double expected[] = {200, 320, 350, 500, 500, 320};
    for (int i = 0; i < 6; i++) {
        assert_true(fabs(s->points[i] - expected[i]) < 1e-9);
        assert_true(s->tangents[i] == 0 && s->tension[i] == 1);
    }
    assert_true(key(editor, "Enter", 0));
    assert_false(key(editor, "Enter", 0));
    /* Every point is a step. */
    bat_editor_command(editor, "undo");
    assert_int_equal(spline_of(editor)->count, 2);
    bat_editor_command(editor, "undo");
    assert_int_equal(objects(editor), 2);
    bat_editor_command(editor, "redo");
    bat_editor_command(editor, "redo");
    assert_int_equal(spline_of(editor)->count, 3);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void undo_while_placing_goes_back_a_point(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    tap(&p, 200, 320);
    tap(&p, 350, 500);
    tap(&p, 500, 320);
    bat_editor_command(editor, "undo");
    assert_int_equal(spline_of(editor)->count, 2);
    tap(&p, 600, 330); /* goes on from there */
    assert_int_equal(spline_of(editor)->count, 3);
    assert_true(fabs(spline_of(editor)->points[4] - 600) < 1e-9);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_int_equal(objects(editor), 2);
    tap(&p, 700, 500); /* the first point still waits for its second */
    assert_int_equal(objects(editor), 3);
    assert_true(fabs(spline_of(editor)->points[0] - 200) < 1e-9);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void backspace_takes_the_last_back(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    tap(&p, 200, 320);
    tap(&p, 350, 500);
    tap(&p, 500, 320);
    assert_true(key(editor, "Backspace", 0));
    assert_int_equal(spline_of(editor)->count, 2);
    assert_true(key(editor, "Backspace", 0));
    assert_int_equal(objects(editor), 2);
    tap(&p, 360, 480);
    assert_int_equal(spline_of(editor)->count, 2);
    assert_true(fabs(spline_of(editor)->points[0] - 200) < 1e-9);
    key(editor, "Backspace", 0);
    assert_true(key(editor, "Backspace", 0)); /* the first point */
    assert_false(key(editor, "Backspace", 0));
    assert_int_equal(objects(editor), 2);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* So does the host's "Done". */
static void a_tap_on_the_last_ends(void **state) {
    (void)state;
    for (int done = 0; done < 2; done++) {
        bat_editor *editor;
        pen p = begin(&editor);
        const int before = bat_document_count(bat_editor_document(editor));
        assert_int_equal(show(editor)->pending, 0);
        tap(&p, 100, 400);
        assert_int_equal(show(editor)->pending, 2);
        tap(&p, 200, 350);
        tap(&p, 300, 420);
        assert_int_equal(show(editor)->pending, 2);
        if (done)
            assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
        else
            tap(&p, 301, 421);
        assert_int_equal(show(editor)->pending, 0);
        tap(&p, 600, 420); /* the first of another */
        tap(&p, 700, 420);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), before + 2);
        const bat_object *made = bat_document_at(bat_editor_document(editor), before);
        assert_int_equal(bat_object_spline(made)->count, 3);
        bat_editor_free(editor);
    }
}

static void a_tap_on_the_first_closes(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    for (int i = 0; i < 3; i++) tap(&p, 200 + 150 * i, i == 1 ? 500 : 320);
    pen_event(&p, BAT_POINTER_HOVER, 201, 321);
    const char *hint = show(editor)->hint;
    assert_string_equal(hint, "Tap to close the curve"); /* a pen does not click */
    tap(&p, 201, 321);
    assert_true(spline_of(editor)->closed);
    assert_true(bat_curve_is_closed(bat_object_curve(newest(editor), 0)));
    assert_int_equal(spline_of(editor)->count, 3);
    assert_false(key(editor, "Enter", 0)); /* placing has ended */
    replays(editor, 0);
    bat_editor_free(editor);
}

static double angle_of(const double v[2]) { return atan2(v[1], v[0]) * 180 / PI; }

static void a_drag_while_placing_gives_the_direction(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    drag(&p, 200, 320, 230, 290);
    drag(&p, 400, 500, 437, 492);
    const bat_spline *s = spline_of(editor);
    assert_int_equal(s->count, 2);
    assert_true(fabs(angle_of(s->tangents) + 45) < 1e-9);
    assert_true(fabs(angle_of(s->tangents + 2) - atan2(-8, 37) * 180 / PI) < 1e-9);
    assert_true(s->tension[2] == 1);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* The built tangent is the asked one, to 1e-9 rad, wherever the arrow points; only the two segments beside move, in the
 * paper's mode always, in the round one where the directions beside are given. */
static void turn_the_arrow(bat_tangents_mode mode) {
    bat_editor *editor;
    pen p = begin(&editor);
    const bat_tangents_options options = {sizeof options, mode, BAT_TANGENTS_CENTRIPETAL};
    assert_int_equal(bat_editor_set(editor, "spline-mode", mode), BAT_OK);
    for (int i = 0; i < 6 && mode == BAT_TANGENTS_ROUND; i++)
        drag(&p, 100 + 150 * i, i % 2 ? 500 : 320, 130 + 150 * i, (i % 2 ? 500 : 320) + 2 * i);
    for (int i = 0; i < 6 && mode == BAT_TANGENTS_FAITHFUL; i++) tap(&p, 100 + 150 * i, i % 2 ? 500 : 320);
    key(editor, "Enter", 0);
    tap(&p, 400, 320);      /* choose the third */
    p.modifiers = BAT_CTRL; /* no snapping */
    for (int round = 0; round < 24; round++) {
        bat_joint before[6], after[6];
        double *b0, *b1, angle = round * 15 + 18, x = 400 + 44 * cos(angle * PI / 180),
                         y = 320 + 44 * sin(angle * PI / 180);
        int n0, n1;
        assert_int_equal(bat_tangents(spline_of(editor), &options, before, &n0, &b0, NULL), BAT_OK);
        double d[3], start[2];
        vec_store(bat_splining_direction(spline_of(editor), before, 2), d);
        for (int k = 0; k < 2; k++) start[k] = (k ? 320 : 400) + 44 * d[k];
        drag_to(&p, start[0], start[1], x, y);
        const bat_frame *frame = show(editor);
        assert_true(frame->busy);
        assert_non_null(pen_live(frame, BAT_ROLE_WEDGE));
        assert_non_null(pen_live(frame, BAT_ROLE_BEYOND));
        assert_non_null(pen_live(frame, BAT_ROLE_GHOST));
        assert_non_null(pen_live(frame, BAT_ROLE_ARROW));
        assert_true(frame->label_count >= 2);
        pen_event(&p, BAT_POINTER_UP, x, y);
        const bat_spline *s = spline_of(editor);
        assert_true(fabs(remainder(angle_of(s->tangents + 4) - angle, 360)) < 0.02); /* pixels are rounded */
        assert_int_equal(bat_tangents(s, &options, after, &n1, &b1, NULL), BAT_OK);
        double cross = after[2].right[0] * s->tangents[5] - after[2].right[1] * s->tangents[4];
        double dot = after[2].right[0] * s->tangents[4] + after[2].right[1] * s->tangents[5];
        assert_true(fabs(atan2(cross, dot)) < 1e-9);
        for (int i = 0; i < n0; i++)
            if (i != 1 && i != 2) assert_memory_equal(b0 + 8 * i, b1 + 8 * i, 8 * sizeof(double));
        bat_free(b0);
        bat_free(b1);
    }
    replays(editor, 0);
    bat_editor_free(editor);
}

static void the_arrow_turns_the_direction(void **state) {
    (void)state;
    turn_the_arrow(BAT_TANGENTS_FAITHFUL);
    turn_the_arrow(BAT_TANGENTS_ROUND);
}

/* The arrow is taken by its shaft as by its head. */
static void the_shaft_takes_the_arrow(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    tap(&p, 350, 500);
    const bat_spline *s = spline_of(editor);
    const size_t count = s->count;
    bat_joint joints[8];
    double d[3];
    assert_int_equal(bat_tangents(s, NULL, joints, NULL, NULL, NULL), BAT_OK);
    vec_store(bat_splining_direction(s, joints, 1), d);
    p.modifiers = BAT_CTRL;
    drag(&p, s->points[2] + 22 * d[0], s->points[3] + 22 * d[1], s->points[2] + 40, s->points[3] + 30);
    s = spline_of(editor);
    assert_int_equal(s->count, count);
    assert_true(fabs(s->tangents[2] - 0.8) < 1e-9 && fabs(s->tangents[3] - 0.6) < 1e-9);
    bat_editor_free(editor);
}

static void directions_snap(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    tap(&p, 350, 500);
    bat_joint joints[4];
    double d[3];
    assert_int_equal(bat_tangents(spline_of(editor), NULL, joints, NULL, NULL, NULL), BAT_OK);
    vec_store(bat_splining_direction(spline_of(editor), joints, 1), d);
    p.modifiers = BAT_SHIFT;
    drag(&p, 350 + 44 * d[0], 500 + 44 * d[1], 350 + 40 * cos(0.5), 500 + 40 * sin(0.5)); /* 28.6 degrees */
    assert_true(fabs(angle_of(spline_of(editor)->tangents + 2) - 30) < 1e-9);
    /* To the outgoing chord, from two degrees beside it; with Ctrl it stays beside. */
    double chord = atan2(-180, 150), beside = chord + 2 * PI / 180, at = 30 * PI / 180;
    for (int held = 0; held < 2; held++) {
        p.modifiers = held ? BAT_CTRL : 0;
        drag(&p, 350 + 44 * cos(at), 500 + 44 * sin(at), 350 + 44 * cos(beside), 500 + 44 * sin(beside));
        double found = angle_of(spline_of(editor)->tangents + 2) * PI / 180;
        assert_true(fabs(found - (held ? beside : chord)) < (held ? 1e-3 : 1e-12));
    }
    bat_editor_free(editor);
}

static void further_out_is_tension(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    tap(&p, 350, 500);
    bat_joint joints[4];
    double d[3];
    assert_int_equal(bat_tangents(spline_of(editor), NULL, joints, NULL, NULL, NULL), BAT_OK);
    vec_store(bat_splining_direction(spline_of(editor), joints, 1), d);
    drag(&p, 350 + 44 * d[0], 500 + 44 * d[1], 350 + 124 * d[0], 500 + 124 * d[1]);
    const double *tension = spline_of(editor)->tension + 2;
    assert_true(fabs(tension[0] - 2) < 1e-3 && tension[0] == tension[1]);
    /* A handle's end follows the pen: the outgoing one to 60 px, the other kept with Alt. */
    assert_int_equal(bat_tangents(spline_of(editor), NULL, joints, NULL, NULL, NULL), BAT_OK);
    double end[2] = {350 + joints[1].right[0] / 3, 500 + joints[1].right[1] / 3};
    p.modifiers = BAT_ALT | BAT_CTRL;
    drag(&p, end[0], end[1], 350 + 70 * d[0], 500 + 70 * d[1]);
    tension = spline_of(editor)->tension + 2;
    assert_true(fabs(tension[0] - 2) < 1e-3);
    assert_int_equal(bat_tangents(spline_of(editor), NULL, joints, NULL, NULL, NULL), BAT_OK);
    assert_true(fabs(hypot(joints[1].right[0], joints[1].right[1]) / 3 - 70) < 0.02);
    /* A double-click gives direction and tension back. */
    p.modifiers = 0;
    twice(&p, 350, 500);
    assert_true(spline_of(editor)->tangents[2] == 0 && spline_of(editor)->tension[3] == 1);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void points_move_and_go(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    uint64_t before = digest(editor);
    drag(&p, 350, 500, 380, 540);
    assert_true(fabs(spline_of(editor)->points[2] - 380) < 1e-9);
    assert_true(fabs(spline_of(editor)->points[3] - 540) < 1e-9);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    tap(&p, 350, 500);
    assert_true(key(editor, "Delete", 0));
    assert_int_equal(spline_of(editor)->count, 3);
    assert_true(fabs(spline_of(editor)->points[2] - 500) < 1e-9);
    key(editor, "Delete", 0);
    key(editor, "Delete", 0);
    assert_int_equal(objects(editor), 2); /* two points less one is no spline */
    replays(editor, 0);
    bat_editor_free(editor);
}

static void cancel_changes_nothing(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    uint64_t before = digest(editor);
    size_t size, later;
    bat_editor_journal(editor, &size);
    drag_to(&p, 350, 500, 380, 540);
    assert_true(digest(editor) != before); /* the drag shows */
    assert_true(key(editor, "Escape", 0));
    assert_true(digest(editor) == before);
    pen_event(&p, BAT_POINTER_UP, 380, 540);
    assert_true(digest(editor) == before);
    bat_editor_journal(editor, &later);
    assert_true(size == later);
    assert_true(key(editor, "Escape", 0)); /* nothing chosen any more */
    assert_false(key(editor, "Escape", 0));
    bat_editor_free(editor);
}

/* A tap on the curve puts a point there, and the curve does not move. */
static void insertion_keeps_the_curve(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    bat_curve *before = NULL;
    assert_int_equal(bat_curve_copy(bat_object_curve(newest(editor), 0), &before), BAT_OK);
    double u[9], at[2];
    bat_curve_spread(before, 9, u);
    bat_curve_eval(before, u[4], 0, at);
    tap(&p, at[0], at[1]);
    assert_int_equal(spline_of(editor)->count, 5);
    assert_non_null(strstr(show(editor)->notice, "0.000 px"));
    bat_finder *finder = NULL;
    assert_int_equal(bat_finder_create(before, &finder), BAT_OK);
    const bat_curve *after = bat_object_curve(newest(editor), 0);
    double v[101], point[2];
    bat_curve_spread(after, 101, v);
    for (int i = 0; i < 101; i++) {
        bat_near near;
        bat_curve_eval(after, v[i], 0, point);
        bat_finder_nearest(finder, point, &near);
        assert_true(near.distance < 1e-7);
    }
    bat_finder_free(finder);
    bat_curve_free(before);
    /* By the keyboard: behind the chosen point. */
    key(editor, "Tab", 0);
    assert_true(key(editor, "Insert", 0));
    assert_int_equal(spline_of(editor)->count, 6);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void keys_do_it_all(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    double view = show(editor)->view[0];
    assert_true(key(editor, "ArrowLeft", 0)); /* nothing chosen: the view moves */
    assert_true(show(editor)->view[0] < view);
    key(editor, "ArrowRight", 0);
    four_points(&p);
    bat_editor_command(editor, "cancel"); /* lets go */
    assert_true(key(editor, "Tab", 0));   /* takes the first spline, its first point */
    assert_true(key(editor, "ArrowRight", 0));
    assert_true(fabs(spline_of(editor)->points[0] - 201) < 1e-9);
    assert_true(key(editor, "ArrowDown", BAT_SHIFT));
    assert_true(fabs(spline_of(editor)->points[1] - 330) < 1e-9);
    assert_true(key(editor, "Tab", 0)); /* its direction */
    bat_joint joints[4];
    double d[3], turned[2];
    assert_int_equal(bat_tangents(spline_of(editor), NULL, joints, NULL, NULL, NULL), BAT_OK);
    vec_store(bat_splining_direction(spline_of(editor), joints, 0), d);
    assert_true(key(editor, "ArrowRight", BAT_SHIFT));
    memcpy(turned, spline_of(editor)->tangents, sizeof turned);
    assert_true(fabs(remainder(angle_of(turned) - angle_of(d) - 15, 360)) < 1e-9);
    assert_true(key(editor, "ArrowUp", 0));
    assert_true(fabs(spline_of(editor)->tension[0] - 1.05) < 1e-12);
    assert_true(show(editor)->label_count >= 2); /* the values are read out */
    assert_true(key(editor, "d", 0));
    assert_true(spline_of(editor)->tangents[0] == 0);
    for (int i = 0; i < 6; i++) assert_true(key(editor, "Tab", 0));
    assert_false(key(editor, "Tab", 0)); /* past the last the focus may go on */
    assert_true(key(editor, "Tab", BAT_SHIFT));
    replays(editor, 0);
    bat_editor_free(editor);
}

static void it_becomes_free(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "free-curve"), BAT_OK);
    assert_int_equal(bat_object_kind(newest(editor)), BAT_KIND_PATH);
    assert_string_equal(show(editor)->notice, bat_string_english(BAT_STRING_NOTICE_FREED));
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    /* The sketch tool redraws a stretch of it: the same step frees it, and says so. */
    bat_editor_command(editor, "tool-sketch");
    double u[9], a[2], b[2];
    const bat_curve *curve = bat_object_curve(newest(editor), 0);
    bat_curve_spread(curve, 9, u);
    bat_curve_eval(curve, u[3], 0, a);
    bat_curve_eval(curve, u[5], 0, b);
    p.time += 1000;
    pen_line(&p, a[0], a[1], b[0], b[1], 12);
    bat_editor_command(editor, "accept");
    assert_int_equal(objects(editor), 3);
    assert_int_equal(bat_object_kind(newest(editor)), BAT_KIND_PATH);
    assert_string_equal(show(editor)->notice, bat_string_english(BAT_STRING_NOTICE_FREED));
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    assert_non_null(spline_of(editor));
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Whatever tool changes the curve: here the points tool, by the keyboard. */
static void other_tools_say_so_too(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    uint64_t before = digest(editor);
    bat_editor_command(editor, "tool-points");
    double u[9], at[2];
    bat_curve_spread(bat_object_curve(newest(editor), 0), 9, u);
    bat_curve_eval(bat_object_curve(newest(editor), 0), u[4], 0, at);
    tap(&p, at[0], at[1]);
    drag(&p, at[0], at[1], at[0] + 30, at[1] + 40);
    assert_true(digest(editor) != before);
    assert_int_equal(bat_object_kind(newest(editor)), BAT_KIND_PATH);
    assert_string_equal(show(editor)->notice, bat_string_english(BAT_STRING_NOTICE_FREED));
    while (bat_object_kind(newest(editor)) == BAT_KIND_PATH) /* the same step took both */
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    tap(&p, 950, 750);
    assert_string_not_equal(show(editor)->notice, bat_string_english(BAT_STRING_NOTICE_FREED));
    bat_editor_free(editor);
}

static void another_tap_chooses(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    bat_editor_command(editor, "cancel");
    double u[9], at[2];
    bat_curve_spread(bat_object_curve(newest(editor), 0), 9, u);
    bat_curve_eval(bat_object_curve(newest(editor), 0), u[4], 0, at);
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
    assert_non_null(pen_live(show(editor), BAT_ROLE_HIGHLIGHT));
    assert_null(pen_live(show(editor), BAT_ROLE_POINT));
    tap(&p, at[0], at[1]);
    assert_int_equal(spline_of(editor)->count, 4);
    assert_non_null(pen_live(show(editor), BAT_ROLE_POINT));
    bat_editor_free(editor);
}

static void two_equal_points_are_no_curve(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    tap(&p, 200, 320);
    uint64_t before = digest(editor);
    tap(&p, 200, 320);
    assert_true(digest(editor) == before);
    assert_int_equal(objects(editor), 2);
    tap(&p, 300, 320);
    drag(&p, 300, 320, 330, 350); /* the last point's own place: moves it */
    assert_true(fabs(spline_of(editor)->points[2] - 330) < 1e-9);
    bat_editor_free(editor);
}

/* Whatever comes in, the invariants hold and the journal replays. */
static void wild_sessions(void **state) {
    (void)state;
    uint64_t seed = 7;
    for (int round = 0; round < 12; round++) {
        uint8_t data[4000];
        bat_editor *editor;
        pen p = begin(&editor);
        bat_editor_set(editor, "spline-mode", round % 4);
        if (round % 2) four_points(&p);
        session_bytes bytes = session_random(data, sizeof data, &seed);
        double time = 1e6;
        while (bytes.at < bytes.size) {
            if (session_byte(&bytes) < 60) {
                static const char *const wild[] = {"Tab", "ArrowUp", "Backspace", "Insert",
                                                   "p",   "d",       "Enter"};
                uint8_t which = session_byte(&bytes);
                bat_editor_key(editor, wild[which % 7], true, which & 1u, time);
            }
            session_event(editor, &bytes, &time);
            check(editor);
        }
        bat_editor_command(editor, "cancel");
        replays(editor, 0);
        bat_editor_free(editor);
    }
}

/* A tap on a selected outline of Béziers puts a point on it, which is one of its own kind, and the shape stays; beside it, and on one that is not
 * selected, a spline begins. */
static void outlines_get_points(void **state) {
    (void)state;
    double points[24], knots[13], at[2], there, back;
    for (int i = 0; i < 12; i++) {
        const double w = 6.283185307179586 * i / 12, far = i % 3 ? 220 : 180;
        points[2 * i] = 500 + far * cos(w), points[2 * i + 1] = 400 + far * sin(w);
    }
    for (int i = 0; i < 13; i++) knots[i] = i / 3;
    bat_curve *ring = NULL, *before = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 12, points, 13, knots, &ring), BAT_OK);
    assert_int_equal(bat_curve_copy(ring, &before), BAT_OK);
    bat_editor *editor = editor_with(1, &ring);
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_command(editor, "tool-tangents"), BAT_OK);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    const uint64_t first = digest(editor);
    bat_curve_eval(before, 1.4, 0, at);
    tap(&p, at[0], at[1]);
    const bat_curve *now = bat_object_curve(newest(editor), 0);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    assert_int_equal(bat_curve_count(now), 15);
    assert_int_equal(bat_curve_distance(before, now, 8, &there, &back), BAT_OK);
    assert_true(fmax(there, back) < 1e-9);
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    p.time += 2000;
    tap(&p, 500, 400);
    assert_true(digest(editor) == first); /* the first point of a spline */
    bat_editor_command(editor, "cancel");
    bat_editor_command(editor, "deselect");
    p.time += 2000;
    tap(&p, at[0], at[1]);
    assert_true(digest(editor) == first);
    bat_curve_free(before);
    bat_editor_free(editor);
}

/* A new spline is round, which the journal says; directions are offered and taken as ever. */
static void new_splines_are_round(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    const bat_tangents_options *options = bat_object_spline_options(newest(editor));
    assert_int_equal(options->mode, BAT_TANGENTS_ROUND);
    bat_curve *curve = NULL;
    assert_int_equal(bat_tangents(spline_of(editor), options, NULL, NULL, NULL, &curve), BAT_OK);
    assert_true(bat_curve_is_equal(curve, bat_object_curve(newest(editor), 0)));
    bat_curve_free(curve);
    size_t size;
    assert_non_null(strstr(bat_editor_journal(editor, &size), "\"mode\":\"round\""));
    tap(&p, 350, 500);
    assert_non_null(pen_live(show(editor), BAT_ROLE_PROMPT));
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Even curvature: chosen for the spline at hand in one step, for the next one as well; no directions are shown or
 * taken; points are dragged, added and taken away as ever, and the file and the journal keep it. */
static void curvature_is_even(void **state) {
    (void)state;
    bat_editor *editor;
    pen p = begin(&editor);
    four_points(&p);
    tap(&p, 350, 500); /* its second point is chosen */
    assert_non_null(pen_live(show(editor), BAT_ROLE_PROMPT));
    double value = -1;
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_set(editor, "spline-mode", 2), BAT_OK);
    const uint64_t even = digest(editor);
    assert_true(before != even);
    assert_int_equal(bat_object_spline_options(newest(editor))->mode, BAT_TANGENTS_EVEN);
    const bat_curve *curve = bat_object_curve(newest(editor), 0);
    assert_int_equal(bat_curve_degree(curve), 2);
    assert_int_equal(bat_curve_count(curve), 4); /* one control point a point */
    assert_null(pen_live(show(editor), BAT_ROLE_PROMPT));
    assert_int_equal(bat_editor_get(editor, "spline-mode", &value), BAT_OK);
    assert_true(value == 2);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* the setting stays for the next */
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == even);

    pen_event(&p, BAT_POINTER_DOWN, 350, 500); /* a drag shows at once, is one step, and stays even */
    pen_event(&p, BAT_POINTER_MOVE, 360, 480);
    pen_event(&p, BAT_POINTER_MOVE, 380, 450);
    show(editor);
    assert_true(spline_of(editor)->points[2] == 380);
    pen_event(&p, BAT_POINTER_UP, 380, 450);
    show(editor);
    assert_int_equal(bat_object_spline_options(newest(editor))->mode, BAT_TANGENTS_EVEN);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == even);

    for (int i = 0; i < 4; i++) { /* a point more behind each, and off again */
        tap(&p, 200 + 150 * i, i % 2 ? 500 : 320);
        assert_int_equal(bat_editor_command(editor, "point-default"), BAT_STATE);
        assert_int_equal(bat_editor_command(editor, "point-add"), BAT_OK);
        show(editor);
        const double *at = spline_of(editor)->points + 2 * (i < 3 ? i + 1 : 3);
        const double first = i < 3 ? 200 + 150 * i : 500;
        assert_true(at[0] > first && at[0] < first + 150);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == even);
    }

    assert_int_equal(bat_editor_command(editor, "cancel"),
                     BAT_OK); /* the next one is even, too, drawn with the pen down */
    tap(&p, 200, 600);
    pen_event(&p, BAT_POINTER_DOWN, 300, 700);
    pen_event(&p, BAT_POINTER_MOVE, 320, 720);
    pen_event(&p, BAT_POINTER_MOVE, 340, 740);
    show(editor);
    pen_event(&p, BAT_POINTER_UP, 340, 740);
    tap(&p, 500, 600);
    assert_true(key(editor, "Enter", 0));
    assert_int_equal(bat_object_spline_options(newest(editor))->mode, BAT_TANGENTS_EVEN);
    assert_true(spline_of(editor)->points[2] == 340 && spline_of(editor)->points[3] == 740);
    replays(editor, 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(taps_place_points),
        cmocka_unit_test(undo_while_placing_goes_back_a_point),
        cmocka_unit_test(backspace_takes_the_last_back),
        cmocka_unit_test(a_tap_on_the_first_closes),
        cmocka_unit_test(a_tap_on_the_last_ends),
        cmocka_unit_test(a_drag_while_placing_gives_the_direction),
        cmocka_unit_test(the_arrow_turns_the_direction),
        cmocka_unit_test(directions_snap),
        cmocka_unit_test(further_out_is_tension),
        cmocka_unit_test(points_move_and_go),
        cmocka_unit_test(cancel_changes_nothing),
        cmocka_unit_test(insertion_keeps_the_curve),
        cmocka_unit_test(keys_do_it_all),
        cmocka_unit_test(it_becomes_free),
        cmocka_unit_test(other_tools_say_so_too),
        cmocka_unit_test(another_tap_chooses),
        cmocka_unit_test(two_equal_points_are_no_curve),
        cmocka_unit_test(new_splines_are_round),
        cmocka_unit_test(the_shaft_takes_the_arrow),
        cmocka_unit_test(outlines_get_points),
        cmocka_unit_test(curvature_is_even),
        cmocka_unit_test(wild_sessions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
