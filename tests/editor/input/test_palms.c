/* Pens, fingers and palms: the pen always wins, whatever fingers are doing and whenever palms touch or lift. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "editor/editor.h"
#include "support/editing.h"

enum { LARGE = 90, FINGER = 24 }; /* px */

static void touch(bat_editor *editor, bat_pointer_phase phase, uint32_t contact, double x, double y,
                  double size, double time) {
    bat_pointer event = {.phase = phase,
                         .device = BAT_DEVICE_TOUCH,
                         .contact = contact,
                         .buttons = phase == BAT_POINTER_DOWN || phase == BAT_POINTER_MOVE ? 1u : 0u,
                         .x = x,
                         .y = y,
                         .pressure = 0.5,
                         .width = size,
                         .height = size / 2,
                         .time = time};
    bat_editor_pointer(editor, 1, &event);
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
}

/* A finger goes from one place to another in ten steps and stays down. */
static void slide(bat_editor *editor, uint32_t contact, const double from[2], const double to[2], double size,
                  double time) {
    touch(editor, BAT_POINTER_DOWN, contact, from[0], from[1], size, time);
    for (int i = 1; i <= 10; i++)
        touch(editor, BAT_POINTER_MOVE, contact, from[0] + (to[0] - from[0]) * i / 10,
              from[1] + (to[1] - from[1]) * i / 10, size, time + 8 * i);
    bat_editor_frame(editor);
}

/* So many fingers, or palms, tap. */
static void tap_of(bat_editor *editor, int fingers, double size, double time) {
    for (int i = 0; i < fingers; i++)
        touch(editor, BAT_POINTER_DOWN, (uint32_t)i + 10, 300 + 90 * i, 400, size, time + 5 * i);
    for (int i = 0; i < fingers; i++)
        touch(editor, BAT_POINTER_UP, (uint32_t)i + 10, 300 + 90 * i, 400, 0, time + 100 + i);
}

/* What a pen does that comes down on the upper curve at 5,000 ms and goes along and away. */
static void pen_goes(bat_editor *editor) {
    pen p = pen_for(editor);
    p.time = 5000;
    pen_line(&p, 350, 200, 650, 210, 30);
    bat_editor_frame(editor);
}

typedef struct outcome {
    uint64_t document;
    double view[4];
} outcome;

static outcome outcome_of(bat_editor *editor) {
    outcome out = {.document = digest(editor)};
    memcpy(out.view, bat_editor_frame(editor)->view, sizeof out.view);
    return out;
}

static const char *const tools[] = {"tool-sketch",   "tool-select", "tool-points",
                                    "tool-tangents", "tool-levels", "tool-smooth",
                                    "tool-eraser",   "tool-zoom",   "tool-pan"};
enum { TOOLS = sizeof tools / sizeof *tools };

/* The pen does what it does alone: in every tool, beside a finger that rests, has drawn or dragged something, or has
 * moved the view; with and without palm rejection; before the first pen and after it. */
static void a_finger_never_keeps_the_pen_from_working(void **state) {
    (void)state;
    static const double ends[][2] = {{500, 600}, {501, 601}, {520, 580}, {620, 500}, {420, 205}};
    for (int tool = 0; tool < TOOLS; tool++)
        for (int rejects = 0; rejects < 2; rejects++)
            for (int seen = 0; seen < 2; seen++) {
                outcome alone = {0};
                for (int way = -1; way < 5; way++) {
                    bat_editor *editor = pen_editor();
                    bat_editor_set(editor, "palm-rejection", rejects);
                    bat_editor_command(editor, tools[tool]);
                    pen p = pen_for(editor);
                    if (seen) pen_event(&p, BAT_POINTER_HOVER, 900, 700);
                    if (way >= 0) slide(editor, 3, (double[]){500, 600}, ends[way], FINGER, 4000);
                    pen_goes(editor);
                    if (way >= 0) touch(editor, BAT_POINTER_UP, 3, ends[way][0], ends[way][1], 0, 6000);
                    outcome now = outcome_of(editor);
                    if (way < 0)
                        alone = now;
                    else if (memcmp(&now, &alone, sizeof now))
                        fail_msg("%s, palm rejection %d, pen seen %d, finger %d: not what the pen does alone",
                                 tools[tool], rejects, seen, way);
                    bat_editor_free(editor);
                }
            }
}

/* Whether both drawings have the same curves; a dot that was taken back leaves a gap in the numbers of objects. */
static bool alike(const bat_editor *a, const bat_editor *b) {
    const bat_document *one = bat_editor_document(a), *other = bat_editor_document(b);
    bool same = bat_document_count(one) == bat_document_count(other);
    for (int i = 0; same && i < bat_document_count(one); i++)
        same = bat_curve_is_equal(bat_object_curve(bat_document_at(one, i), 0),
                                  bat_object_curve(bat_document_at(other, i), 0));
    return same;
}

/* A palm comes and goes at every time around the first and the second stroke, as large as it is, or as small as a
 * finger, lifted or taken back by the system: the drawing is what it is without it. */
static void palms_come_and_go(void **state) {
    (void)state;
    static const double times[] = {4600, 4960, 5100, 5230, 5300, 5700, 6100, 6300};
    enum { TIMES = sizeof times / sizeof *times };
    for (int size = 0; size < 2; size++)
        for (int from = 0; from < TIMES; from++)
            for (int to = from + 1; to < TIMES; to++)
                for (int cancelled = 0; cancelled < 2; cancelled++) {
                    bat_editor *alone = NULL;
                    for (int palm = 0; palm < 2; palm++) {
                        bat_editor *editor = pen_editor();
                        pen p = pen_for(editor);
                        double at[2];
                        bool down = false, gone = !palm;
                        for (int stroke = 0; stroke < 2; stroke++) {
                            p.time = 5000 + 900 * stroke;
                            for (int i = 0; i <= 60; i++) {
                                double now = p.time + 4;
                                if (!down && !gone && now >= times[from]) {
                                    slide(editor, 3, (double[]){700, 400}, (double[]){702, 401},
                                          size ? LARGE : 0, times[from]);
                                    down = true;
                                }
                                if (down && now >= times[to]) {
                                    touch(editor, cancelled ? BAT_POINTER_CANCEL : BAT_POINTER_UP, 3, 702,
                                          401, 0, times[to]);
                                    down = false;
                                    gone = true;
                                }
                                pen_arch(i / 60.0, (double[]){350, stroke ? 600 : 200, 650, 210, 30}, at);
                                pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1]);
                            }
                            pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
                        }
                        if (palm && (!alike(editor, alone) || editor->session.history.done != 2))
                            fail_msg("a palm of size %d from %g to %g changes something", size, times[from],
                                     times[to]);
                        if (palm) bat_editor_free(editor), bat_editor_free(alone);
                        if (!palm) alone = editor;
                    }
                }
}

/* Contacts as large as a palm: no tap, no stroke, no pan, in no tool; also one that grows, which takes back what it
 * did when it was small. */
static void large_contacts_do_nothing(void **state) {
    (void)state;
    for (int tool = 0; tool < TOOLS; tool++)
        for (int rejects = 0; rejects < 2; rejects++) {
            bat_editor *editor = pen_editor();
            bat_editor_set(editor, "palm-rejection", rejects);
            if (rejects) pen_goes(editor);
            bat_editor_command(editor, tools[tool]);
            outcome before = outcome_of(editor);
            tap_of(editor, 2, LARGE, 9000);
            tap_of(editor, 3, LARGE, 10000);
            slide(editor, 1, (double[]){400, 600}, (double[]){500, 500}, LARGE, 11000);
            slide(editor, 2, (double[]){450, 600}, (double[]){300, 500}, LARGE, 11200);
            touch(editor, BAT_POINTER_UP, 1, 500, 500, 0, 12000);
            touch(editor, BAT_POINTER_UP, 2, 300, 500, 0, 12010);
            outcome after = outcome_of(editor);
            assert_memory_equal(&after, &before, sizeof after);

            slide(editor, 1, (double[]){400, 600}, (double[]){420, 560}, FINGER, 13000);
            touch(editor, BAT_POINTER_MOVE, 1, 425, 555, LARGE, 13090);
            after = outcome_of(editor);
            assert_memory_equal(&after, &before, sizeof after);
            assert_false(bat_editor_frame(editor)->busy);
            touch(editor, BAT_POINTER_UP, 1, 425, 555, 0, 13100);
            after = outcome_of(editor);
            assert_memory_equal(&after, &before, sizeof after);

            /* one of two that tap grows */
            touch(editor, BAT_POINTER_DOWN, 1, 300, 400, FINGER, 14000);
            touch(editor, BAT_POINTER_DOWN, 2, 400, 400, FINGER, 14010);
            touch(editor, BAT_POINTER_MOVE, 2, 401, 400, LARGE, 14020);
            touch(editor, BAT_POINTER_UP, 1, 300, 400, 0, 14090);
            touch(editor, BAT_POINTER_UP, 2, 401, 400, 0, 14100);
            assert_true(digest(editor) == before.document);
            bat_editor_free(editor);
        }
}

/* Beside a palm that rests fingers still tap for nothing, but draw when they may. */
static void a_finger_draws_beside_a_palm(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t plain = digest(editor);
    touch(editor, BAT_POINTER_DOWN, 1, 800, 700, LARGE, 1000);
    pen finger = pen_for(editor);
    finger.device = BAT_DEVICE_TOUCH;
    finger.contact = 2;
    finger.time = 2000;
    pen_line(&finger, 350, 200, 650, 200, 30);
    assert_true(digest(editor) != plain);
    bat_editor_free(editor);
}

/* The view goes back to where it was before the fingers, unless something else has moved it since. */
static void a_pan_is_taken_back(void **state) {
    (void)state;
    for (int zoomed = 0; zoomed < 2; zoomed++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        pen_event(&p, BAT_POINTER_HOVER, 900, 700);
        slide(editor, 1, (double[]){500, 600}, (double[]){560, 640}, FINGER,
              2000); /* a pan, meant and done */
        touch(editor, BAT_POINTER_UP, 1, 560, 640, 0, 2100);
        bat_view meant = editor->stage.view;
        assert_true(meant.x == -60 && meant.y == -40);
        slide(editor, 1, (double[]){500, 600}, (double[]){510, 604}, FINGER, 3000);
        if (zoomed) {
            bat_editor_command(editor, "zoom-in");
            meant = editor->stage.view;
        }
        touch(editor, BAT_POINTER_MOVE, 1, 512, 604, FINGER, 3200);
        p.time = 4000;
        pen_event(&p, BAT_POINTER_DOWN, 400, 300);
        assert_memory_equal(&editor->stage.view, &meant, sizeof meant);
        touch(editor, BAT_POINTER_MOVE, 1, 540, 620, FINGER, 4010);
        assert_memory_equal(&editor->stage.view, &meant, sizeof meant);
        bat_editor_free(editor);
    }
}

/* What a palm dabbed just before the first pen is taken back, and can be had again; what a finger drew is not. */
static void a_dab_before_the_first_pen(void **state) {
    (void)state;
    static const struct {
        double length, wait;
        bool rejects, stays;
    } cases[] = {
        {25, 100, true, false}, {25, 900, true, true}, {25, 100, false, true}, {80, 100, true, true}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = pen_editor();
        bat_editor_set(editor, "palm-rejection", cases[i].rejects);
        uint64_t plain = digest(editor);
        double to[2] = {700, 400 + cases[i].length};
        slide(editor, 1, (double[]){700, 400}, to, FINGER, 1000);
        touch(editor, BAT_POINTER_UP, 1, to[0], to[1], 0, 1090);
        uint64_t dabbed = digest(editor);
        assert_true(dabbed != plain);
        pen p = pen_for(editor);
        p.time = 1090 + cases[i].wait;
        pen_event(&p, BAT_POINTER_HOVER, 400, 300);
        assert_true(digest(editor) == (cases[i].stays ? dabbed : plain));
        if (!cases[i].stays) assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        assert_true(digest(editor) == dabbed);
        pen_event(&p, BAT_POINTER_HOVER, 410, 300);
        assert_true(digest(editor) == dabbed);
        bat_editor_free(editor);
    }
}

/* What is under the pen lights up, and stays what the pen points at, while a hand rests beside it. */
static void the_pen_points_beside_a_hand(void **state) {
    (void)state;
    for (int size = 0; size < 2; size++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        pen_event(&p, BAT_POINTER_HOVER, 500, 300);
        touch(editor, BAT_POINTER_DOWN, 5, 800, 700, size ? LARGE : FINGER, p.time);
        pen_event(&p, BAT_POINTER_HOVER, 500, 202);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
        assert_int_equal(editor->frame.cursor, BAT_CURSOR_PEN);
        touch(editor, BAT_POINTER_MOVE, 5, 800, 700, size ? LARGE : FINGER, p.time);
        touch(editor, BAT_POINTER_UP, 5, 800, 700, 0, p.time);
        touch(editor, BAT_POINTER_LEAVE, 5, 800, 700, 0, p.time);
        assert_true(editor->input.pen_near && editor->input.pen[0] == 500 && editor->input.pen[1] == 202);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
        pen_event(&p, BAT_POINTER_LEAVE, 500, 202);
        assert_false(editor->input.pen_near);
        assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HIGHLIGHT));
        bat_editor_free(editor);
    }
}

/* While a pen hovers, a hand that rests and rolls, however small its contacts, neither moves the view nor draws: also
 * one that came down first. Once the pen has gone, fingers move the view again. */
static void a_hand_rests_while_the_pen_hovers(void **state) {
    (void)state;
    for (int before = 0; before < 2; before++)
        for (int hands = 1; hands <= 2; hands++) {
            bat_editor *editor = pen_editor();
            const outcome plain = outcome_of(editor);
            pen p = pen_for(editor);
            p.time = 2000;
            if (!before) pen_event(&p, BAT_POINTER_HOVER, 400, 300);
            for (int i = 0; i < hands; i++)
                touch(editor, BAT_POINTER_DOWN, (uint32_t)i + 1, 500 + 90 * i, 600, FINGER, 2005);
            for (int k = 1; k <= 20; k++) {
                p.time = 2005 + 8 * k;
                pen_event(&p, BAT_POINTER_HOVER, 400 + k, 300);
                for (int i = 0; i < hands; i++)
                    touch(editor, BAT_POINTER_MOVE, (uint32_t)i + 1, 500 + 90 * i + 3 * k,
                          600 + 2 * k * (i + 1), FINGER, 2006 + 8 * k);
            }
            const outcome now = outcome_of(editor);
            assert_memory_equal(&now, &plain, sizeof now);
            for (int i = 0; i < hands; i++)
                touch(editor, BAT_POINTER_UP, (uint32_t)i + 1, 560 + 90 * i, 640, 0, 2200);
            pen_event(&p, BAT_POINTER_LEAVE, 420, 300);
            slide(editor, 1, (double[]){500, 600}, (double[]){560, 640}, FINGER, 2300);
            assert_true(editor->stage.view.x == -60 && editor->stage.view.y == -40);
            bat_editor_free(editor);
        }
}

/* Contacts whose ends were lost fill every place: the pen finds one. */
static void the_pen_finds_a_place(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t plain = digest(editor);
    for (uint32_t i = 0; i < 40; i++)
        touch(editor, BAT_POINTER_DOWN, i, 20.0 * i, 700, i % 2 ? LARGE : 0, 100);
    pen_goes(editor);
    assert_true(digest(editor) != plain && editor->session.history.done == 1);
    bat_editor_free(editor);
}

/* A palm that comes down while the pen moves the view does not pinch with it. */
static void a_palm_does_not_pinch_with_the_pen(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-pan");
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 400);
    touch(editor, BAT_POINTER_DOWN, 2, 700, 600, 0, p.time);
    pen_event(&p, BAT_POINTER_MOVE, 530, 380);
    assert_true(editor->stage.view.zoom == 1 && editor->stage.view.x == -30 && editor->stage.view.y == 20);
    bat_editor_free(editor);
}

/* A fit that waits for a yes goes on waiting when a finger that lay on it gives way. */
static void what_waits_goes_on_waiting(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "tolerance", 0.1);
    bat_editor_set(editor, "stroke-meaning", 1); /* what is new never waits */
    bat_editor_set(editor, "palm-rejection", 0);
    pen p = pen_for(editor);
    uint32_t noise = 1;
    for (int i = 0; i <= 150; i++) { /* trembling that no curve follows within a tenth of a pixel */
        noise = noise * 1664525 + 1013904223;
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, 240 + 3 * i + (noise >> 24) / 20.0,
                  594 + (noise >> 16 & 255) / 20.0);
    }
    pen_event(&p, BAT_POINTER_UP, 690, 600);
    assert_true(bat_editor_frame(editor)->pending);
    touch(editor, BAT_POINTER_DOWN, 4, 800, 700, FINGER, p.time);
    uint64_t before = digest(editor);
    pen_event(&p, BAT_POINTER_DOWN, 300, 300);
    pen_event(&p, BAT_POINTER_UP, 300, 300); /* the pen says yes */
    assert_true(digest(editor) != before);
    bat_editor_free(editor);
}

/* Sizes stand in journals too. */
static void a_journal_holds_sizes(void **state) {
    (void)state;
    for (int large = 0; large < 2; large++) {
        char text[800];
        snprintf(text, sizeof text,
                 "{\"journal\":\"batten\",\"version\":1}\n{\"resize\":[800,600,1]}\n"
                 "{\"pointer\":\"down\",\"device\":\"touch\",\"id\":1,\"buttons\":1,\"x\":100,\"y\":300,"
                 "\"width\":%d,\"height\":20,\"time\":0}\n"
                 "{\"pointer\":\"move\",\"device\":\"touch\",\"id\":1,\"buttons\":1,\"x\":300,\"y\":320,"
                 "\"width\":%d,\"time\":90}\n"
                 "{\"pointer\":\"up\",\"device\":\"touch\",\"id\":1,\"x\":400,\"y\":310,\"time\":120}\n",
                 large ? LARGE : FINGER, large ? LARGE : FINGER);
        bat_editor *editor = NULL;
        bat_problem problem;
        bat_editor_create(&editor);
        assert_int_equal(bat_editor_replay(editor, text, strlen(text), true, &problem), BAT_OK);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), !large);
        bat_editor_free(editor);
    }
}

/* ---- guesses ---- */

static void guess(bat_editor *editor, double x, double y, double time) {
    bat_pointer event = {.phase = BAT_POINTER_MOVE,
                         .device = BAT_DEVICE_PEN,
                         .contact = 1,
                         .buttons = 1,
                         .x = x,
                         .y = y,
                         .pressure = 0.5,
                         .time = time,
                         .predicted = true};
    bat_editor_pointer(editor, 1, &event);
}

/* How far the painted guess reaches from the place. */
static double guessed(bat_editor *editor, const double from[2]) {
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = pen_live(frame, BAT_ROLE_PREDICTED);
    double far = 0;
    if (!item) return 0;
    for (uint32_t i = 0; i < item->path_count; i += 3) {
        double x = (double)item->path[i + 1] + frame->origin[0] - from[0];
        double y = (double)item->path[i + 2] + frame->origin[1] - from[1];
        far = fmax(far, sqrt(x * x + y * y));
    }
    return far;
}

/* However wild a guess is, the grey line reaches no further from the pen than the pen went in the last 30 ms; a
 * moderate one is shown as it is. At any rate of samples, at any speed, and when the pen stops. */
static void guesses_stay_near_the_pen(void **state) {
    (void)state;
    static const double periods[] = {1, 4, 8, 17, 40}, speeds[] = {0, 0.02, 0.3, 2};
    for (int r = 0; r < 5; r++)
        for (int v = 0; v < 4; v++) {
            bat_editor *editor = pen_editor();
            bat_editor_set(editor, "stabiliser", 0);
            bat_pointer event = {.phase = BAT_POINTER_DOWN,
                                 .device = BAT_DEVICE_PEN,
                                 .contact = 1,
                                 .buttons = 1,
                                 .x = 100,
                                 .y = 400,
                                 .time = 1000};
            bat_editor_pointer(editor, 1, &event);
            guess(editor, 600, 100, 1020);
            assert_true(guessed(editor, (double[]){100, 400}) < 1e-3);
            event.phase = BAT_POINTER_MOVE;
            for (int i = 0; i < 200 && event.x < 900; i++) {
                event.x += speeds[v] * periods[r];
                event.time += periods[r];
                bat_editor_pointer(editor, 1, &event);
                double from[2] = {editor->input.pen[0], editor->input.pen[1]};
                double way = speeds[v] * fmin(30, event.time - 1000);
                guess(editor, event.x + 300, event.y - 400, event.time + 16);
                guess(editor, 0, 0, event.time + 32);
                assert_true(guessed(editor, from) <= way + 0.02);
                bat_editor_pointer(editor, 1, &event);
                if (event.time < 1040) continue;
                guess(editor, event.x + 10 * speeds[v], event.y, event.time + 10);
                assert_true(fabs(guessed(editor, from) - 10 * speeds[v]) < 0.03);
            }
            for (int i = 0; i < 40; i++) { /* it rests */
                event.time += 1;
                bat_editor_pointer(editor, 1, &event);
            }
            guess(editor, event.x + 300, event.y, event.time + 16);
            assert_true(guessed(editor, (double[]){event.x, event.y}) < 0.02);
            assert_null(bat_editor_check(editor));
            bat_editor_free(editor);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_never_keeps_the_pen_from_working),
        cmocka_unit_test(palms_come_and_go),
        cmocka_unit_test(large_contacts_do_nothing),
        cmocka_unit_test(a_finger_draws_beside_a_palm),
        cmocka_unit_test(a_pan_is_taken_back),
        cmocka_unit_test(a_dab_before_the_first_pen),
        cmocka_unit_test(the_pen_points_beside_a_hand),
        cmocka_unit_test(a_hand_rests_while_the_pen_hovers),
        cmocka_unit_test(the_pen_finds_a_place),
        cmocka_unit_test(a_palm_does_not_pinch_with_the_pen),
        cmocka_unit_test(what_waits_goes_on_waiting),
        cmocka_unit_test(a_journal_holds_sizes),
        cmocka_unit_test(guesses_stay_near_the_pen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
