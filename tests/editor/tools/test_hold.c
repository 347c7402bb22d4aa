/*
 * A stroke held at its end offers a figure, which is another reading of it: for pens that tremble and mice that send
 * nothing while at rest. Lifted, the stroke is as it was drawn; drawn on, nothing is left of the offer. The figure is
 * one undo step that replays without a clock. Too short a rest, the setting switched off, palms and second pens offer
 * nothing; cancelling leaves nothing behind.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "support/editing.h"

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_curve *curve(const bat_editor *editor, int object) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), object), 0);
}

/* A careless line between two places: a bow and a tremor. x0 y0 x1 y1 */
static void careless(double t, const double *n, double out[2]) {
    for (int k = 0; k < 2; k++) out[k] = n[k] + t * (n[2 + k] - n[k]);
    out[1] += 4 * t * (1 - t) * 4 + 0.6 * sin(90 * t);
}

/* x y radius */
static void round_and_back(double t, const double *n, double out[2]) {
    const double angle = 6.1 * t + 0.3, r = n[2] * (1 + 0.03 * sin(11 * t));
    out[0] = n[0] + r * cos(angle), out[1] = n[1] + r * sin(angle);
}

/* Rests where it is for so many milliseconds; trembling or mute. */
static void rest(pen *p, double x, double y, int milliseconds, bool trembles) {
    if (!trembles) p->time += milliseconds - 4;
    if (!trembles) pen_event(p, BAT_POINTER_MOVE, x, y);
    for (int i = 4; i <= milliseconds && trembles; i += 4)
        pen_event(p, BAT_POINTER_MOVE, x + 1.2 * sin(i), y + 1.1 * cos(1.7 * i));
    bat_editor_frame(p->editor);
}

/* Greatest distance from the line through two places, and their difference in length from the curve's. */
static double bent(const bat_curve *of, const double *n) {
    double worst = 0, domain[2], at[2];
    const double dx = n[2] - n[0], dy = n[3] - n[1], length = hypot(dx, dy);
    bat_curve_domain(of, domain);
    double first[2], last[2];
    bat_curve_eval(of, domain[0], 0, first);
    bat_curve_eval(of, domain[1], 0, last);
    for (int i = 0; i <= 100; i++) {
        bat_curve_eval(of, domain[0] + (domain[1] - domain[0]) * i / 100, 0, at);
        const double d = ((at[0] - first[0]) * (last[1] - first[1]) -
                          (at[1] - first[1]) * (last[0] - first[0])) /
                         hypot(last[0] - first[0], last[1] - first[1]);
        worst = fmax(worst, fabs(d));
    }
    assert_true(fabs(hypot(last[0] - first[0], last[1] - first[1]) - length) < 6);
    return worst;
}

/* Takes the stroke as the last of its readings: the figure. */
static void take(bat_editor *editor, const char *word) {
    const char *readings = bat_editor_readings(editor);
    char wanted[80];
    snprintf(wanted, sizeof wanted, "\"%s\"]", word);
    if (!strstr(readings, wanted)) fail_msg("%s is not offered: %s", word, readings);
    int last = 0;
    for (const char *at = strstr(readings, "words"); *at; at++) last += *at == ',';
    assert_int_equal(bat_editor_read_as(editor, last), BAT_OK);
    check(editor);
}

static bool offers(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    return pen_live(frame, BAT_ROLE_GHOST) && frame->label_count > 0;
}

static bool same(const bat_curve *a, const bat_curve *b) {
    const size_t n = (size_t)bat_curve_count(a);
    return (size_t)bat_curve_count(b) == n &&
           !memcmp(bat_curve_points(a), bat_curve_points(b), 2 * n * sizeof(double));
}

static void lines_are_straight(void **state) {
    (void)state;
    for (int mute = 0; mute < 2; mute++) {
        const double ends[] = {220, 330, 620, 450};
        bat_editor *editor = pen_editor();
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        if (mute) p.device = BAT_DEVICE_MOUSE;
        pen_begin(&p, careless, ends, 120);
        assert_false(offers(editor));
        rest(&p, ends[2], ends[3], 850, !mute);
        assert_true(offers(editor));
        pen_event(&p, BAT_POINTER_UP, ends[2], ends[3]);
        assert_int_equal(count(editor), 3);
        assert_true(bent(curve(editor, 2), ends) > 1.5); /* as it was drawn */
        take(editor, "Straight line");
        const double off = bent(curve(editor, 2), ends);
        if (!(off < 0.2)) fail_msg("bent by %g", off);
        assert_int_equal(bat_curve_count(curve(editor, 2)), 4);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

/* A pause changes nothing of a stroke that goes on: it is the one that was drawn without it. */
static void drawn_on_it_is_whole(void **state) {
    (void)state;
    const double where[] = {500, 400, 120};
    for (int pauses = 0; pauses < 3; pauses++) {
        bat_editor *editors[2] = {pen_editor(), pen_editor()};
        for (int k = 0; k < 2; k++) {
            pen p = pen_for(editors[k]);
            double at[2];
            pen_event(&p, BAT_POINTER_DOWN, 220, 330);
            for (int i = 1; i <= 160; i++) {
                round_and_back(i / 160.0, where, at);
                pen_event(&p, BAT_POINTER_MOVE, at[0], at[1]);
                if (k == 0 || i % 50 != 10 * pauses) continue;
                rest(&p, at[0], at[1], 1200, false);
                bat_editor_frame(editors[k]);
            }
            assert_false(offers(editors[k]));
            pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
        }
        assert_int_equal(count(editors[0]), 3);
        assert_int_equal(count(editors[1]), 3);
        assert_true(same(curve(editors[0], 2), curve(editors[1], 2)));
        assert_null(strstr(bat_editor_readings(editors[1]), "ircle"));
        for (int k = 0; k < 2; k++) bat_editor_free(editors[k]);
    }
}

static void short_rests_mean_nothing(void **state) {
    (void)state;
    const double ends[] = {220, 330, 620, 450};
    for (int way = 0; way < 3; way++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        if (way == 1) bat_editor_set(editor, "hold-time", 0);
        if (way == 2) bat_editor_set(editor, "hold-time", 1.5);
        pen_begin(&p, careless, ends, 120);
        rest(&p, ends[2], ends[3], way ? 1200 : 300, true);
        pen_event(&p, BAT_POINTER_UP, ends[2], ends[3]);
        assert_true(bent(curve(editor, 2), ends) > 1.5);
        check(editor);
        bat_editor_free(editor);
    }
}

static void circles_close(void **state) {
    (void)state;
    const double where[] = {500, 400, 60};
    double end[2];
    round_and_back(1, where, end);
    bat_editor *editor = pen_editor();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_begin(&p, round_and_back, where, 160);
    rest(&p, end[0], end[1], 850, true);
    pen_event(&p, BAT_POINTER_UP, end[0], end[1]);
    assert_int_equal(count(editor), 3);
    take(editor, "Circle");
    const bat_curve *made = curve(editor, 2);
    assert_true(bat_curve_is_closed(made));
    double domain[2], at[2], low = 1e9, high = 0;
    bat_curve_domain(made, domain);
    for (int i = 0; i < 200; i++) {
        bat_curve_eval(made, domain[0] + (domain[1] - domain[0]) * i / 200, 0, at);
        low = fmin(low, hypot(at[0] - where[0], at[1] - where[1]));
        high = fmax(high, hypot(at[0] - where[0], at[1] - where[1]));
    }
    if (!(high - low < 4.5)) fail_msg("from %g to %g", low, high); /* its middle is a little off the truth */
    assert_true(fabs((high + low) / 2 - 60) < 3);
    assert_true(bat_curve_count(made) <= 16);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* The other readings, and the stroke as it was drawn: all of it one step. */
static void drawn_again(void **state) {
    (void)state;
    const double ends[] = {220, 330, 620, 450};
    bat_editor *raw = pen_editor(), *editor = pen_editor();
    pen q = pen_for(raw), p = pen_for(editor);
    pen_begin(&q, careless, ends, 120);
    pen_event(&q, BAT_POINTER_UP, ends[2], ends[3]);
    const uint64_t first = digest(editor);
    pen_begin(&p, careless, ends, 120);
    rest(&p, ends[2], ends[3], 850, false);
    pen_event(&p, BAT_POINTER_UP, ends[2], ends[3]);
    bat_curve *held = NULL;
    assert_int_equal(bat_curve_copy(curve(editor, 2), &held), BAT_OK);
    const char *readings = bat_editor_readings(editor);
    assert_non_null(strstr(readings, "\"chosen\":0"));
    assert_non_null(strstr(readings, "[\"New line\",\"Straight line\"]"));
    assert_true(same(held, curve(raw, 2)));
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    check(editor);
    assert_false(same(curve(editor, 2), held));
    assert_int_equal(bat_editor_read_as(editor, 0), BAT_OK);
    assert_true(same(curve(editor, 2), held));
    bat_curve_free(held);
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
    bat_editor_free(raw);
}

/* Over a curve the stretch becomes the figure, and the rest stays. */
static void stretches_become_figures(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){350, 203, 650, 197, 34}, 120);
    rest(&p, 650, 197, 850, true);
    pen_event(&p, BAT_POINTER_UP, 650, 197);
    take(editor, "Arc");
    assert_int_equal(count(editor), 2);
    assert_true(digest(editor) != first);
    double domain[2], at[2];
    bat_curve_domain(curve(editor, 0), domain);
    for (int i = 0; i <= 200; i++) {
        bat_curve_eval(curve(editor, 0), domain[0] + (domain[1] - domain[0]) * i / 200, 0, at);
        if (at[0] < 240 || at[0] > 760) assert_true(fabs(at[1] - 200) < 0.01);
    }
    assert_true(bat_curve_count(curve(editor, 0)) < 22);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void cancelled_nothing_is_left(void **state) {
    (void)state;
    const double ends[] = {220, 330, 620, 450};
    for (int way = 0; way < 3; way++) {
        bat_editor *editor = pen_editor();
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        pen_begin(&p, careless, ends, 120);
        rest(&p, ends[2], ends[3], 850, true);
        pen_event(&p, BAT_POINTER_MOVE, 640, 470);
        pen palm = p, other = p;
        palm.device = BAT_DEVICE_TOUCH, other.contact = 2;
        pen_event(&palm, BAT_POINTER_DOWN, 700, 600);
        pen_event(&other, BAT_POINTER_DOWN, 300, 300);
        check(editor);
        if (way == 0) pen_event(&p, BAT_POINTER_CANCEL, 640, 470);
        if (way == 1) bat_editor_key(editor, "Escape", true, 0, p.time);
        if (way == 2) bat_editor_command(editor, "undo");
        pen_event(&p, BAT_POINTER_MOVE, 660, 480);
        pen_event(&p, BAT_POINTER_UP, 660, 480);
        pen_event(&palm, BAT_POINTER_UP, 700, 600);
        pen_event(&other, BAT_POINTER_UP, 300, 300);
        bat_editor_frame(editor);
        check(editor);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_straight),
        cmocka_unit_test(short_rests_mean_nothing),
        cmocka_unit_test(drawn_on_it_is_whole),
        cmocka_unit_test(circles_close),
        cmocka_unit_test(drawn_again),
        cmocka_unit_test(stretches_become_figures),
        cmocka_unit_test(cancelled_nothing_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
