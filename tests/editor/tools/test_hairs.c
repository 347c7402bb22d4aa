/*
 * Careless strokes over one line converge: against a known truth, with offsets, tilts and wobbles of a hand, in any
 * order and direction, and over parts of it. After eight strokes there are no more inflections than in the truth, and
 * the control points are at most 60 % of those left when the last stroke simply wins; each stroke is a step that undoes
 * and replays; a stroke that is late, far off, or drawn with the setting off is an ordinary stroke.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tools/sketch/sketching.h"
#include "support/editing.h"
#include "support/rounds.h"

enum { STROKES = 8, SCENES = ROUNDS_OF(12) };

static uint64_t seed;

static double chance(void) { /* 0..1 */
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static double normal(void) {
    double sum = -6;
    for (int i = 0; i < 12; i++) sum += chance();
    return sum;
}

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_curve *newest(const bat_editor *editor) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), count(editor) - 1), 0);
}

/* A sweep with one or two waves. */
typedef struct truth {
    double length, wave[2], phase[2];
} truth;

static truth some_truth(void) {
    truth t = {.length = 500 + 200 * chance()};
    for (int k = 0; k < 2; k++) t.wave[k] = (k ? 14 : 45) * (1 + chance()), t.phase[k] = 6 * chance();
    return t;
}

static void at(const truth *t, double f, double out[2]) {
    out[0] = 130 + t->length * f;
    out[1] = 400;
    for (int k = 0; k < 2; k++) out[1] += t->wave[k] * sin(3.14159265 * (k + 1) * f + t->phase[k]);
}

static int turns_over(double *last, double curvature) {
    if (fabs(curvature) < 1e-4) return 0; /* flatter than a circle of ten metres is straight */
    const int turned = *last * curvature < 0;
    *last = curvature;
    return turned;
}

static int true_inflections(const truth *t) {
    int found = 0;
    double last = 0, a[2], b[2], d[2];
    for (int i = 1; i < 400; i++) {
        at(t, (i - 1) / 400.0, a), at(t, i / 400.0, b), at(t, (i + 1) / 400.0, d);
        const double step = hypot(b[0] - a[0], b[1] - a[1]);
        found += turns_over(&last, ((b[0] - a[0]) * (d[1] - b[1]) - (b[1] - a[1]) * (d[0] - b[0])) /
                                       (step * step * step));
    }
    return found;
}

static int inflections(const bat_curve *curve) {
    double domain[2], last = 0, d[6];
    int found = 0;
    bat_curve_domain(curve, domain);
    for (int i = 1; i < 800; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 800, 2, d);
        const double speed = hypot(d[2], d[3]);
        found += turns_over(&last, (d[2] * d[5] - d[3] * d[4]) / (speed * speed * speed));
    }
    return found;
}

static double rms(const bat_curve *curve, const truth *t) {
    double domain[2], sum = 0, p[2], q[2];
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 100; i++) {
        double least = INFINITY;
        at(t, i / 100.0, p);
        for (int k = 0; k <= 400; k++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / 400, 0, q);
            least = fmin(least, hypot(p[0] - q[0], p[1] - q[1]));
        }
        sum += least * least;
    }
    return sqrt(sum / 101);
}

/* One stroke over f0..f1 of the truth (f1 < f0: backwards), beside it by `off` and its own tilt and wobble. */
static void careless(pen *p, const truth *t, double f0, double f1, double off) {
    const double tilt = 2 * normal(), phase = 6 * chance(), other = 6 * chance();
    const int samples = (int)(fabs(f1 - f0) * t->length / 2);
    for (int i = 0; i <= samples; i++) {
        const double g = (double)i / samples, f = f0 + (f1 - f0) * g;
        double a[2], b[2];
        at(t, f, a), at(t, f + 0.001, b);
        const double x = b[0] - a[0], y = b[1] - a[1], length = hypot(x, y);
        const double d = off + tilt * (2 * g - 1) + 1.7 * sin(5 * g + phase) + sin(9 * g + other) +
                         0.25 * normal();
        pen_event(p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, a[0] - d * y / length, a[1] + d * x / length);
        if (i == samples) pen_event(p, BAT_POINTER_UP, a[0] - d * y / length, a[1] + d * x / length);
    }
    bat_editor_frame(p->editor);
    p->time += 300;
}

/* Eight strokes; the first two between them all along. */
static void tangle(pen *p, const truth *t) {
    for (int i = 0; i < STROKES; i++) {
        double from = i == 0   ? 0
                      : i == 1 ? 0.12
                               : 0.45 * chance(),
               to = i == 1 ? 1 : from + 0.45 + 0.4 * chance();
        if (to > 1) to = 1;
        const bool back = chance() < 0.5;
        careless(p, t, back ? to : from, back ? from : to, 2.5 * normal());
    }
}

static bat_editor *empty(double last_wins) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 1000, 800, 1);
    assert_int_equal(bat_editor_open(editor, document, "test"), BAT_OK);
    bat_editor_command(editor, "zoom-100");
    bat_editor_set(editor, "stabiliser", 0);
    assert_int_equal(bat_editor_set(editor, "many-strokes", last_wins), BAT_OK);
    return editor;
}

static void eight_are_one(void **state) {
    (void)state;
    double points[2] = {0}, off[2] = {0};
    int more = 0, worst = 0, scenes = 0;
    for (int scene = 0; scene < SCENES; scene++) {
        int found[2], least = 0;
        for (int last_wins = 0; last_wins < 2; last_wins++) {
            seed = 91 + 17 * (uint64_t)scene;
            const truth t = some_truth();
            bat_editor *editor = empty(last_wins);
            pen p = pen_for(editor);
            tangle(&p, &t);
            check(editor);
            if (count(editor) != 1) fail_msg("scene %d: %d curves", scene, count(editor));
            points[last_wins] += (double)bat_curve_count(newest(editor));
            off[last_wins] += rms(newest(editor), &t);
            found[last_wins] = inflections(newest(editor));
            least = true_inflections(&t);
            if (!last_wins) replays(editor, 0);
            bat_editor_free(editor);
        }
        scenes++;
        more += found[0] > least;
        worst = found[0] - least > worst ? found[0] - least : worst;
        print_message("scene %d: %d inflections, %d converged, %d last wins\n", scene, least, found[0],
                      found[1]);
    }
    print_message("points %.1f of %.1f, off by %.2f of %.2f px, more inflections in %d of %d\n",
                  points[0] / scenes, points[1] / scenes, off[0] / scenes, off[1] / scenes, more, scenes);
    assert_true(points[0] <= 0.6 * points[1]);
    assert_true(off[0] < 0.75 * off[1]);
    assert_true(more <= 1 && worst <= 2);
}

/* As many as go together: still one line, nearer to the truth than after eight, and no wigglier. */
static void thirty_two_are_one(void **state) {
    (void)state;
    double off[2] = {0};
    int more = 0;
    for (int scene = 0; scene < SCENES; scene++) {
        seed = 3 + 29 * (uint64_t)scene;
        const truth t = some_truth();
        bat_editor *editor = empty(0);
        pen p = pen_for(editor);
        for (int i = 0; i < BAT_HAIRS_MOST / STROKES; i++) {
            tangle(&p, &t);
            if (i == 0) off[0] += rms(newest(editor), &t) / SCENES;
        }
        assert_int_equal(count(editor), 1);
        check(editor);
        off[1] += rms(newest(editor), &t) / SCENES;
        more += inflections(newest(editor)) > true_inflections(&t);
        bat_editor_free(editor);
    }
    print_message("off by %.2f px after eight, %.2f px after %d; more inflections in %d of %d\n", off[0],
                  off[1], (int)BAT_HAIRS_MOST, more, SCENES);
    assert_true(off[1] < 0.8 * off[0] && more <= (SCENES + 5) / 6);
}

/* Each stroke is one step, back and forth; after a step back the next stroke is an ordinary one. */
static void each_is_a_step(void **state) {
    (void)state;
    uint64_t before[STROKES + 1];
    seed = 5;
    const truth t = some_truth();
    bat_editor *editor = empty(0);
    pen p = pen_for(editor);
    for (int i = 0; i < STROKES; i++) {
        before[i] = digest(editor);
        careless(&p, &t, i % 2 ? 0.8 : 0.05, i % 2 ? 0.1 : 0.95, 2 * normal());
        assert_true(digest(editor) != before[i]);
        check(editor);
    }
    before[STROKES] = digest(editor);
    for (int i = STROKES; i-- > 0;) {
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == before[i]);
    }
    for (int i = 1; i <= STROKES; i++) {
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        assert_true(digest(editor) == before[i]);
    }
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Where the strokes lie in the end, at the middle of the first. */
static double height(const bat_editor *editor, int object, double x) {
    const bat_curve *curve = bat_object_curve(bat_document_at(bat_editor_document(editor), object), 0);
    double domain[2], p[2], least = INFINITY, y = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 2000; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 2000, 0, p);
        if (fabs(p[0] - x) < least) least = fabs(p[0] - x), y = p[1];
    }
    return y;
}

/* Two strokes 6 px apart meet between, by the pressure of each; late, with the setting off, or after something else, the second wins. */
static void others_win(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) {
        bat_editor *editor = empty(way == 1);
        pen p = pen_for(editor);
        pen_line(&p, 200, 300, 700, 300, 20);
        if (way == 2) p.time += 2500;
        if (way == 3) {
            bat_editor_command(editor, "undo");
            bat_editor_command(editor, "redo");
        }
        pen_line(&p, 700, 306, 200, 306, -20);
        assert_int_equal(count(editor), 1);
        const double y = height(editor, 0, 450);
        if (!(fabs(y - (way ? 286 : 283)) < 2)) fail_msg("%d: %g", way, y);
        check(editor);
        bat_editor_free(editor);
    }
}

/* Over a stretch of a curve that was there: it stays beyond, and the strokes converge between. */
static void a_stretch_is_redrawn(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_set(editor, "stabiliser", 0);
    pen p = pen_for(editor);
    pen_line(&p, 380, 203, 620, 203, 16);
    pen_line(&p, 630, 197, 370, 197, -16);
    assert_int_equal(count(editor), 2);
    const double y = height(editor, 0, 500);
    if (!(fabs(y - 184) < 2.3)) fail_msg("%g", y);
    assert_true(fabs(height(editor, 0, 220) - 200) < 0.01 && fabs(height(editor, 0, 780) - 200) < 0.01);
    check(editor);
    replays(editor, 0);
    bat_editor_free(editor);
}

static bool is_near(const bat_curve *a, const bat_curve *b, double most) {
    double domain[2], p[2];
    bat_near near;
    bat_curve_domain(a, domain);
    for (int i = 0; i <= 200; i++) {
        bat_curve_eval(a, domain[0] + (domain[1] - domain[0]) * i / 200, 0, p);
        assert_int_equal(bat_curve_nearest(b, p, &near), BAT_OK);
        if (near.distance > most) return false;
    }
    return true;
}

/* What is shown last while the pen is down is what is committed, over a line of their own and over a stretch. */
static void what_is_shown_is_what_will_be(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++) {
        bat_editor *editor = over ? pen_editor() : empty(0);
        bat_editor_set(editor, "stabiliser", 0);
        const bat_sketching *s = bat_sketching_of(&editor->context);
        pen p = pen_for(editor);
        for (int i = 0; i < 6; i++) {
            const double y = (over ? 203 : 400) - 5 * i % 7, from = i % 2 ? 630 : 370, to = i % 2 ? 370 : 630;
            const double at[5] = {from, y, to, y + 2, i % 2 ? -16 : 16};
            bat_curve *shown = NULL;
            pen_begin(&p, pen_arch, at, 60);
            pen_event(&p, BAT_POINTER_MOVE, to, y + 2);
            bat_editor_frame(editor);
            check(editor);
            assert_true(s->preview.converges == (i > 0));
            assert_int_equal(bat_curve_copy(s->preview.curve, &shown), BAT_OK);
            pen_event(&p, BAT_POINTER_UP, to, y + 2);
            bat_editor_frame(editor);
            check(editor);
            const bat_curve *now = bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
            if (i > 0) assert_true(bat_curve_is_equal(now, shown));
            bat_curve_free(shown);
            p.time += 300;
        }
        replays(editor, 0);
        bat_editor_free(editor);
    }
}

/* The chips: all the strokes together, or what this one means by itself. */
static void each_can_be_read_alone(void **state) {
    (void)state;
    bat_editor *editor = empty(0);
    const bat_sketching *s = bat_sketching_of(&editor->context);
    pen p = pen_for(editor);
    bat_curve *both = NULL;
    pen_line(&p, 200, 300, 700, 300, 20);
    const uint64_t first = digest(editor);
    pen_line(&p, 700, 306, 200, 306, -20);
    assert_int_equal(bat_curve_copy(newest(editor), &both), BAT_OK);
    assert_non_null(strstr(bat_editor_readings(editor), "All strokes"));
    assert_true(s->again.count >= 3 && s->again.at == s->again.converged);
    const int all = s->again.converged;
    int alone = -1, fresh = -1;
    for (int i = 0; i < s->again.count; i++) {
        if (i != all && s->again.edit[i].kind == BAT_EDIT_REDRAW) alone = i;
        if (s->again.edit[i].kind == BAT_EDIT_NEW) fresh = i;
    }
    assert_int_equal(bat_editor_read_as(editor, alone), BAT_OK);
    assert_int_equal(count(editor), 1);
    assert_true(fabs(height(editor, 0, 450) - 286) < 2);
    assert_int_equal(bat_editor_read_as(editor, fresh), BAT_OK);
    assert_int_equal(count(editor), 2);
    assert_int_equal(bat_editor_read_as(editor, all), BAT_OK);
    assert_int_equal(count(editor), 1);
    assert_true(bat_curve_is_equal(newest(editor), both));
    check(editor);
    /* Closer to the line or fairer, and more strokes go on from there. */
    int points[2];
    for (int i = 0; i < 2; i++) {
        assert_int_equal(bat_editor_refit(editor, i, false), BAT_OK);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        assert_int_equal(bat_editor_refit(editor, i, true), BAT_OK);
        assert_true(is_near(newest(editor), both, 3));
        points[i] = (int)bat_curve_count(newest(editor));
        check(editor);
    }
    assert_true(points[0] >= points[1]);
    pen_line(&p, 200, 303, 700, 303, 20);
    assert_int_equal(count(editor), 1);
    assert_non_null(strstr(bat_editor_readings(editor), "All strokes"));
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    bat_curve_free(both);
    bat_editor_free(editor);
}

/* A wiggly stroke over a line, and one that only touches its end, are no careless strokes over it: they are not averaged. */
static void what_is_unlike_is_not_averaged(void **state) {
    (void)state;
    for (int size = 0; size < 3; size++)
        for (int kind = 0; kind < 2; kind++) {
            const double length = size == 0 ? 30 : size == 1 ? 120 : 480;
            bat_editor *editor = empty(0);
            pen p = pen_for(editor);
            pen_line(&p, 300, 400, 300 + length, 400, 0.02 * length);
            p.time += 300;
            for (int i = 0; i <= 120; i++) {
                const double f = i / 120.0, x = 300 + (kind ? 0.97 + 0.5 * f : f) * length;
                const double y = 400 + (kind ? -0.5 * f : 0.04 * sin(40 * f)) * length;
                pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, x, y);
                if (i == 120) pen_event(&p, BAT_POINTER_UP, x, y);
            }
            bat_editor_frame(editor);
            const char *text = bat_editor_readings(editor);
            if (text && strstr(text, "All strokes")) fail_msg("%g px, kind %d: averaged", length, kind);
            bat_editor_free(editor);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eight_are_one),          cmocka_unit_test(thirty_two_are_one),
        cmocka_unit_test(each_is_a_step),         cmocka_unit_test(others_win),
        cmocka_unit_test(a_stretch_is_redrawn),   cmocka_unit_test(what_is_shown_is_what_will_be),
        cmocka_unit_test(each_can_be_read_alone), cmocka_unit_test(what_is_unlike_is_not_averaged)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
