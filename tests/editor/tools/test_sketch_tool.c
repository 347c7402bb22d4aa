/* The sketch tool, state by state: its texts, previews and changes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/blend.h>
#include <batten/editor.h>
#include <batten/nearest.h>

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static bool journal_has(const bat_editor *editor, const char *text) {
    return strstr(bat_editor_journal(editor, NULL), text) != NULL;
}

static void hover_lights_the_curve_up(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    const struct {
        double y;
        bool near;
    } places[] = {{200, true},  {211.9, true}, {212.1, false}, {188.2, true},
                  {187, false}, {400, false},  {601, true}};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        pen_event(&p, BAT_POINTER_HOVER, 500, places[i].y);
        const bat_frame *frame = bat_editor_frame(editor);
        const bat_item *item = pen_live(frame, BAT_ROLE_HIGHLIGHT);
        assert_int_equal(item != NULL, places[i].near);
        assert_string_equal(frame->hint,
                            places[i].near ? "Draw over to redraw this curve" : "Draw a new curve");
        if (item) { /* the nearest of the two, whole */
            double y = places[i].y < 400 ? 200 : 600;
            assert_true(fabs((item->bounds[1] + item->bounds[3]) / 2 + frame->origin[1] - y) < 0.01);
            assert_true(fabs(item->bounds[2] - item->bounds[0] - item->width - 600) < 0.1);
        }
    }
    pen_event(&p, BAT_POINTER_HOVER, 500, 200);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
    pen_event(&p, BAT_POINTER_LEAVE, 500, 200);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
    bat_editor_free(editor);
}

/* After a stroke the curve under the pen is the one that lights up, not the one it came from. */
static void highlight_follows_the_stroke(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 500, 200);
    pen_line(&p, 500, 230, 500, 400, 10);
    pen_event(&p, BAT_POINTER_HOVER, 500, 200);
    pen_line(&p, 400, 300, 400, 598, 10);
    const bat_item *item = pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT);
    assert_non_null(item);
    assert_true(item->bounds[3] + bat_editor_frame(editor)->origin[1] > 590);
    bat_editor_free(editor);
}

static void reach_is_in_pixels(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_wheel(editor, 500, 200, 0, -138.6294, BAT_CTRL, 0); /* twice as large about the curve */
    assert_true(fabs(bat_editor_frame(editor)->view[2] - 2) < 1e-5);
    pen_event(&p, BAT_POINTER_HOVER, 500, 211);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
    pen_event(&p, BAT_POINTER_HOVER, 500, 213);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
    bat_editor_free(editor);
}

static void redraw_is_one_step(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const bat_document *document = bat_editor_document(editor);
    uint64_t before = digest(editor);
    const bat_object *other = bat_document_at(document, 1);
    bat_id id = bat_object_id(bat_document_at(document, 0));
    pen p = pen_for(editor);
    pen_line(&p, 350, 200, 650, 200, 40);
    check(editor);
    assert_int_equal(count(editor), 2);
    const bat_object *after = bat_document_at(document, 0);
    assert_true(bat_object_id(after) == id);
    assert_string_equal(bat_object_name(after), "line");
    assert_true(bat_document_at(document, 1) == other);
    uint64_t changed = digest(editor);
    assert_true(changed != before);
    bat_near near;
    assert_int_equal(bat_curve_nearest(bat_object_curve(after, 0), (double[]){500, 160}, &near), BAT_OK);
    assert_true(near.distance < 4); /* it has followed the pen */
    assert_true(journal_has(editor, "\"do\":\"sketch-redraw\""));

    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->can_undo && !frame->can_redo && frame->unsaved);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    frame = bat_editor_frame(editor);
    assert_true(!frame->can_undo && frame->can_redo && !frame->unsaved);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == changed);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_STATE);
    check(editor);
    bat_editor_free(editor);
}

static void fit_shows_while_the_pen_is_down(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    uint32_t still = bat_editor_frame(editor)->still_version;
    pen_begin(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 60);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_version, still);
    assert_true(frame->dirty[0] > frame->dirty[2]);
    assert_true(frame->busy && frame->knots_after > 0 && frame->knots_before > 0);
    bat_role roles[] = {BAT_ROLE_INK, BAT_ROLE_FIT, BAT_ROLE_STRETCH};
    for (int i = 0; i < 3; i++) assert_non_null(pen_live(frame, roles[i]));
    assert_null(pen_live(frame, BAT_ROLE_KNOT)); /* until they are asked for */
    assert_int_equal(bat_editor_set(editor, "show-knots", 1), BAT_OK);
    pen_event(&p, BAT_POINTER_MOVE, 650, 201);
    frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_KNOT));
    check(editor);
    pen_event(&p, BAT_POINTER_UP, 650, 200);
    frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_version, still + 1);
    assert_true(frame->dirty[0] < frame->dirty[2]);
    assert_true(!frame->busy && !pen_live(frame, BAT_ROLE_INK) && !pen_live(frame, BAT_ROLE_FIT));
    bat_editor_free(editor);
}

static void away_from_curves_a_new_one(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_set(editor, "stroke-width", 7);
    bat_editor_set(editor, "stroke-colour", 0x336699ffu);
    pen_begin(&p, pen_arch, (double[]){200, 400, 700, 380, 60}, 60);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_FIT));
    assert_null(pen_live(frame, BAT_ROLE_STRETCH));
    assert_string_equal(frame->hint, "Drawing a new curve. Esc cancels");
    pen_event(&p, BAT_POINTER_UP, 700, 380);
    assert_int_equal(count(editor), 3);
    const bat_style *style = bat_object_style(bat_document_at(bat_editor_document(editor), 2));
    assert_true(style->width == 7 && style->stroke == 0x336699ffu && style->stroked && !style->filled);
    check(editor);
    bat_editor_free(editor);
}

/* Escape, a cancelled pointer, undo: each drops the stroke; the pen still down draws nothing more. */
/* From a closed curve into its middle: it stays as it is, and there is a new line. */
static void into_a_closed_curve_a_new_one(void **state) {
    (void)state;
    double points[32], knots[17];
    for (int i = 0; i < 17; i++) knots[i] = i;
    for (int i = 0; i < 16; i++) {
        points[2 * i] = 400 + 200 * cos(i * 0.39269908169872414);
        points[2 * i + 1] = 400 + 200 * sin(i * 0.39269908169872414);
    }
    bat_curve *ring = NULL, *before = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 16, points, 17, knots, &ring), BAT_OK);
    bat_curve_copy(ring, &before);
    bat_document *drawing = NULL;
    bat_editor *editor = pen_editor();
    bat_document_create(&drawing);
    bat_document_set_page(drawing, (double[]){0, 0, 1000, 800});
    pen_add(drawing, ring);
    bat_editor_open(editor, drawing, "ring");
    bat_editor_command(editor, "zoom-100");
    pen p = pen_for(editor);
    pen_line(&p, 592, 404, 410, 398, 3);
    check(editor);
    const bat_document *document = bat_editor_document(editor);
    assert_int_equal(bat_document_count(document), 2);
    assert_true(bat_curve_is_equal(before, bat_object_curve(bat_document_at(document, 0), 0)));
    bat_curve_free(before);
    bat_editor_free(editor);
}

static void cancel_changes_nothing(void **state) {
    (void)state;
    for (int way = 0; way < 3; way++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        pen_line(&p, 350, 600, 650, 600, 30);
        uint64_t before = digest(editor);
        size_t journal = 0, after = 0;
        bat_editor_journal(editor, &journal);
        pen_begin(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 30);
        if (way == 0) assert_true(bat_editor_key(editor, "Escape", true, 0, 2000));
        if (way == 1) pen_event(&p, BAT_POINTER_CANCEL, 650, 200);
        if (way == 2) assert_true(bat_editor_key(editor, "z", true, BAT_CTRL, 2000));
        const bat_frame *frame = bat_editor_frame(editor);
        assert_string_equal(frame->notice, way == 1 ? "The system interrupted the stroke" : "Cancelled");
        assert_false(frame->busy);
        assert_null(pen_live(frame, BAT_ROLE_INK));
        pen_event(&p, BAT_POINTER_MOVE, 700, 300);
        pen_event(&p, BAT_POINTER_UP, 700, 300);
        assert_true(digest(editor) == before);
        bat_editor_journal(editor, &after);
        assert_true(journal == after);
        check(editor);
        pen_line(&p, 350, 200, 650, 200, 40);
        assert_true(digest(editor) != before);
        bat_editor_free(editor);
    }
}

/* However short a mark is, and at any zoom, it stays: one that moves as a curve along it, and a dot as a line that is
 * no longer than its ends are round. Undo takes it back, and a replay makes the same. */
static void marks_stay(void **state) {
    (void)state;
    static const double lengths[] = {0, 0.4, 1, 2, 4, 7};
    static const double zooms[] = {0.05, 1, 20};
    for (size_t z = 0; z < sizeof zooms / sizeof *zooms; z++)
        for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
            bat_editor *editor = pen_editor();
            for (int i = 0; i < 400 && bat_editor_frame(editor)->view[2] < zooms[z]; i++)
                bat_editor_wheel(editor, 500, 400, 0, -20, BAT_CTRL, i);
            for (int i = 0; i < 400 && bat_editor_frame(editor)->view[2] > zooms[z]; i++)
                bat_editor_wheel(editor, 500, 400, 0, 20, BAT_CTRL, i);
            const uint64_t before = digest(editor);
            pen p = pen_for(editor);
            pen_event(&p, BAT_POINTER_DOWN, 500, 402);
            for (int i = 1; i <= 8; i++) pen_event(&p, BAT_POINTER_MOVE, 500 + lengths[k] * i / 8, 402);
            pen_event(&p, BAT_POINTER_UP, 500 + lengths[k], 402);
            assert_int_equal(count(editor), 3);
            assert_false(bat_editor_frame(editor)->pending);
            const bat_object *object = bat_document_at(bat_editor_document(editor), 2);
            const double long_as = bat_curve_size(bat_object_curve(object, 0)) *
                                   bat_editor_frame(editor)->view[2];
            assert_true(long_as > 0 && long_as <= lengths[k] + 0.5 &&
                        long_as >= (lengths[k] < 2 ? 0 : lengths[k] - 1));
            assert_int_equal(bat_object_style(object)->cap, BAT_CAP_ROUND);
            check(editor);
            assert_int_equal(round_trip(editor, before), 1);
            bat_editor_free(editor);
        }
}

static void alt_smooths(void **state) {
    (void)state;
    for (int held_from_start = 0; held_from_start < 2; held_from_start++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        pen_line(&p, 350, 200, 650, 200, 30);
        double numbers[] = {400, 178, 600, 178, 10};
        if (held_from_start) p.modifiers = BAT_ALT;
        pen_begin(&p, pen_arch, numbers, 20);
        p.modifiers = BAT_ALT;
        pen_event(&p, BAT_POINTER_MOVE, 605, 178);
        assert_string_equal(bat_editor_frame(editor)->hint, "Smoothing. Esc cancels");
        p.modifiers = 0; /* let go a moment early */
        pen_event(&p, BAT_POINTER_UP, 606, 178);
        assert_true(journal_has(editor, "\"do\":\"sketch-smooth\""));
        assert_int_equal(count(editor), 2);
        check(editor);
        bat_editor_free(editor);
    }
}

static void alt_away_from_curves(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    pen p = pen_for(editor);
    p.modifiers = BAT_ALT;
    pen_event(&p, BAT_POINTER_HOVER, 500, 400);
    assert_string_equal(bat_editor_frame(editor)->hint, "Move the pen over a curve to smooth it");
    pen_event(&p, BAT_POINTER_HOVER, 500, 200);
    assert_string_equal(bat_editor_frame(editor)->hint, "Draw over to smooth this curve");
    pen_line(&p, 300, 400, 600, 400, 10);
    assert_string_equal(bat_editor_frame(editor)->notice, "No curve here to smooth");
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* The same stroke can be a curve of its own between the ends, which goes on as both do; the two stay as they are. */
static void end_to_end_blends(void **state) {
    (void)state;
    for (int one = 0; one < 2; one++) { /* two lines, or both ends of one */
        bat_curve *bow = pen_curve(200, 300, 60, 0, 11);
        bat_editor *editor = one ? editor_with(1, &bow) : pen_editor();
        if (!one) bat_curve_free(bow);
        const uint64_t before = digest(editor);
        const int objects = count(editor);
        pen p = pen_for(editor);
        if (one)
            pen_stroke(&p, pen_arch, (double[]){800, 300, 200, 300, 260}, 120);
        else
            pen_stroke(&p, pen_arch, (double[]){800, 200, 800, 600, 120}, 80);
        const char *words = strstr(bat_editor_readings(editor), "\"words\":["),
                   *blend = strstr(words, "\"Blend\"");
        int reading = 0;
        assert_non_null(blend);
        for (; words < blend; words++) reading += *words == ',';
        assert_int_equal(bat_editor_read_as(editor, reading), BAT_OK);
        assert_int_equal(count(editor), objects + 1);
        const bat_document *document = bat_editor_document(editor);
        const bat_curve *made = bat_object_curve(bat_document_at(document, 1), 0);
        for (int side = 0; side < 2; side++) {
            double least = INFINITY, jump[4];
            for (int k = 0; k < objects; k++)
                for (int end = 0; end < 2; end++) {
                    const bat_curve *line = bat_object_curve(bat_document_at(document, k > 0 ? 2 : 0), 0);
                    assert_int_equal(side ? bat_curve_jump(made, true, line, end, jump)
                                          : bat_curve_jump(line, end, made, false, jump),
                                     BAT_OK);
                    if (jump[0] < 1e-9) least = fmin(least, fmax(jump[1], 100 * jump[2]));
                }
            assert_true(least < 1e-6);
        }
        replays(editor, 0);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == before);
        bat_editor_free(editor);
    }
}

static void end_to_end_joins(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    bat_id id = bat_object_id(bat_document_at(bat_editor_document(editor), 0));
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){800, 200, 800, 600, 120}, 80);
    for (int i = 0; i < 3; i++)
        pen_event(&p, BAT_POINTER_MOVE, 800, 600 + i % 2); /* the stabiliser follows */
    assert_string_equal(bat_editor_frame(editor)->hint, "Lift to join the two curves");
    pen_event(&p, BAT_POINTER_UP, 800, 600);
    assert_int_equal(count(editor), 1);
    assert_true(bat_object_id(bat_document_at(bat_editor_document(editor), 0)) == id);
    assert_string_equal(bat_editor_frame(editor)->notice, "Joined the two curves");
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_int_equal(count(editor), 1);
    check(editor);
    bat_editor_free(editor);
}

static void second_contact_never_ends_a_stroke(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    pen p = pen_for(editor), palm = p;
    palm.device = BAT_DEVICE_TOUCH;
    palm.contact = 9;
    pen_begin(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 30);
    pen_event(&palm, BAT_POINTER_DOWN, 700, 500);
    pen_event(&palm, BAT_POINTER_MOVE, 720, 520);
    pen_event(&palm, BAT_POINTER_UP, 720, 520);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->busy && frame->view[0] == 0 && frame->view[1] == 0);
    pen_event(&p, BAT_POINTER_UP, 650, 200);
    assert_true(digest(editor) != before);
    check(editor);
    bat_editor_free(editor);
}

static void tolerance_is_in_pixels(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    double value = 0;
    assert_int_equal(bat_editor_set(editor, "tolerance", 3), BAT_OK);
    assert_true(bat_editor_frame(editor)->tolerance == 3);
    bat_editor_command(editor, "zoom-in");
    bat_editor_command(editor, "zoom-in");
    assert_true(fabs(bat_editor_frame(editor)->tolerance - 1.5) < 1e-12);
    assert_true(bat_editor_key(editor, "[", true, 0, 0));
    bat_editor_get(editor, "tolerance", &value);
    assert_true(value == 2);
    assert_true(bat_editor_key(editor, "]", true, 0, 0));
    assert_true(bat_editor_key(editor, "]", true, 0, 0));
    bat_editor_get(editor, "tolerance", &value);
    assert_true(value == 5);
    assert_int_equal(bat_editor_set(editor, "tolerance", 0.05), BAT_ARGUMENT);
    assert_int_equal(bat_editor_set(editor, "tolerance", 21), BAT_ARGUMENT);
    assert_int_equal(bat_editor_set(editor, "tolerance", NAN), BAT_NUMBER);
    assert_int_equal(bat_editor_set(editor, "no-such", 1), BAT_UNSUPPORTED);
    assert_int_equal(bat_editor_set(editor, "keep-corners", 0.5), BAT_ARGUMENT);
    bat_editor_get(editor, "tolerance", &value);
    assert_true(value == 5);
    bat_editor_free(editor);
}

static void commands_during_a_stroke(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 30);
    const char *refused[] = {"redo", "view-fit", "zoom-in", "tool-pan", "accept", "open"};
    for (int i = 0; i < 6; i++) assert_int_equal(bat_editor_command(editor, refused[i]), BAT_STATE);
    bat_editor_wheel(editor, 10, 10, 50, 50, 0, 0);
    assert_int_equal(bat_editor_command(editor, "save"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tolerance-up"), BAT_OK);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->busy && frame->view[0] == 0 && frame->requests == BAT_ASK_SAVE);
    assert_int_equal(bat_editor_frame(editor)->requests, 0);
    pen_event(&p, BAT_POINTER_UP, 650, 200);
    assert_true(bat_editor_frame(editor)->can_undo);
    bat_editor_free(editor);
}

static void saved_is_a_state_not_a_moment(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    assert_false(bat_editor_frame(editor)->unsaved);
    pen_line(&p, 350, 200, 650, 200, 40);
    assert_true(bat_editor_frame(editor)->unsaved);
    bat_editor_command(editor, "save");
    bat_editor_frame(editor); /* the host takes the request, and the document as it is */
    pen_line(&p, 350, 600, 650, 600, 40);
    bat_editor_saved(editor);
    assert_true(bat_editor_frame(editor)->unsaved); /* the second stroke came too late for it */
    bat_editor_command(editor, "undo");
    assert_false(bat_editor_frame(editor)->unsaved);
    bat_editor_command(editor, "undo");
    assert_true(bat_editor_frame(editor)->unsaved);
    bat_editor_command(editor, "redo");
    assert_false(bat_editor_frame(editor)->unsaved);
    bat_editor_free(editor);
}

static void predicted_samples_are_not_part_of_it(void **state) {
    (void)state;
    bat_document *documents[2];
    for (int predicted = 0; predicted < 2; predicted++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        pen_begin(&p, pen_arch, (double[]){350, 200, 650, 200, 40}, 60);
        if (predicted) {
            bat_pointer ahead = {.phase = BAT_POINTER_MOVE,
                                 .device = p.device,
                                 .contact = p.contact,
                                 .x = 900,
                                 .y = 700,
                                 .time = p.time,
                                 .predicted = true};
            bat_editor_pointer(editor, 1, &ahead);
            assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_PREDICTED));
        }
        pen_event(&p, BAT_POINTER_UP, 650, 200);
        assert_int_equal(bat_document_copy(bat_editor_document(editor), &documents[predicted]), BAT_OK);
        bat_editor_free(editor);
    }
    assert_true(bat_document_digest(documents[0]) == bat_document_digest(documents[1]));
    bat_document_free(documents[0]);
    bat_document_free(documents[1]);
}

/* Frames between the events change nothing in what is committed. */
static void frames_do_not_matter(void **state) {
    (void)state;
    uint64_t digests[2];
    for (int often = 0; often < 2; often++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        double numbers[] = {350, 200, 650, 200, 40}, at[2];
        pen_event(&p, BAT_POINTER_DOWN, 350, 200);
        for (int i = 1; i <= 50; i++) {
            pen_arch(i / 50.0, numbers, at);
            pen_event(&p, BAT_POINTER_MOVE, at[0], at[1]);
            if (often) bat_editor_frame(editor);
        }
        pen_event(&p, BAT_POINTER_UP, 650, 200);
        digests[often] = digest(editor);
        bat_editor_free(editor);
    }
    assert_true(digests[0] == digests[1]);
}

static void many_steps_are_undone(void **state) {
    (void)state;
    enum { STEPS = 230 };
    bat_editor *editor = pen_editor();
    static uint64_t digests[STEPS + 1];
    pen p = pen_for(editor);
    digests[0] = digest(editor);
    for (int i = 1; i <= STEPS; i++) {
        double y = 300 + (i * 37) % 200;
        pen_stroke(&p, pen_arch, (double[]){20, y, 120, y + 30, 10 + i % 7}, 6);
        digests[i] = digest(editor);
    }
    for (int i = STEPS - 1; i >= 0; i--) {
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == digests[i]);
    }
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE);
    for (int i = 1; i <= STEPS; i++) {
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        assert_true(digest(editor) == digests[i]);
    }
    check(editor);
    bat_editor_free(editor);
}

/* A stroke that no curve follows within a tenth of a pixel. */
static void trembling(double t, double out[2]) {
    uint32_t noise = (uint32_t)(t * 1000 + 1) * 2654435761u;
    noise = (noise ^ noise >> 15) * 2246822519u;
    noise = (noise ^ noise >> 13) * 3266489917u;
    out[0] = 240 + 450 * t + (noise >> 16 & 255) / 20.0;
    out[1] = 594 + (noise >> 24) / 20.0;
}

static bat_editor *pending_editor(pen *p) {
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "tolerance", 0.1);
    bat_editor_set(editor, "stroke-meaning", 1); /* what is new never waits */
    *p = pen_for(editor);
    double at[2];
    for (int i = 0; i <= 150; i++) {
        trembling(i / 150.0, at);
        pen_event(p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1]);
    }
    pen_event(p, BAT_POINTER_UP, at[0], at[1]);
    return editor;
}

static void yes_or_no(void **state) {
    (void)state;
    pen p;
    for (int way = 0; way < 5; way++) {
        bat_editor *editor = pending_editor(&p);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_true(frame->pending && !frame->busy && !frame->can_undo && frame->error > frame->tolerance);
        assert_non_null(pen_live(frame, BAT_ROLE_PENDING));
        assert_string_equal(frame->hint, "This is the closest fit. Enter or a tap keeps it, Esc discards it");
        check(editor);
        assert_int_equal(count(editor), 2);
        if (way == 0) assert_true(bat_editor_key(editor, "Enter", true, 0, 0));
        if (way == 1) {
            pen_event(&p, BAT_POINTER_DOWN, 500, 500);
            assert_true(bat_editor_frame(editor)->pending);
            pen_event(&p, BAT_POINTER_UP, 501, 500);
        }
        if (way == 2) assert_true(bat_editor_key(editor, "Escape", true, 0, 0));
        if (way == 3) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        if (way == 4) { /* another try: the first goes */
            bat_editor_set(editor, "tolerance", 2);
            pen_line(&p, 300, 600, 600, 600, 20);
        }
        check(editor);
        frame = bat_editor_frame(editor);
        assert_true(!frame->pending && !pen_live(frame, BAT_ROLE_PENDING));
        assert_int_equal(count(editor), 2);
        assert_int_equal(journal_has(editor, "\"accepted\":true"), way < 2);
        assert_int_equal(frame->can_undo, way != 2 && way != 3);

        replays(editor, 0);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hover_lights_the_curve_up),
        cmocka_unit_test(highlight_follows_the_stroke),
        cmocka_unit_test(reach_is_in_pixels),
        cmocka_unit_test(redraw_is_one_step),
        cmocka_unit_test(fit_shows_while_the_pen_is_down),
        cmocka_unit_test(away_from_curves_a_new_one),
        cmocka_unit_test(into_a_closed_curve_a_new_one),
        cmocka_unit_test(cancel_changes_nothing),
        cmocka_unit_test(marks_stay),
        cmocka_unit_test(alt_smooths),
        cmocka_unit_test(alt_away_from_curves),
        cmocka_unit_test(end_to_end_joins),
        cmocka_unit_test(end_to_end_blends),
        cmocka_unit_test(second_contact_never_ends_a_stroke),
        cmocka_unit_test(tolerance_is_in_pixels),
        cmocka_unit_test(commands_during_a_stroke),
        cmocka_unit_test(saved_is_a_state_not_a_moment),
        cmocka_unit_test(predicted_samples_are_not_part_of_it),
        cmocka_unit_test(frames_do_not_matter),
        cmocka_unit_test(many_steps_are_undone),
        cmocka_unit_test(yes_or_no),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
