/*
 * The levels of the width in the editor: what the strip has, pulls and keys at a level, faders that are dragged, let go, taken back and
 * silenced; each one step, replayed; only in the tool for widths, and only where there are stops enough. With any allocation failing.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "base/real.h"
#include "editor/edit/breadth_levels.h"
#include "editor/editor.h"
#include "editor/session/transaction.h"
#include "support/selecting.h"
#include <batten/paint.h>
#include <batten/panels.h>

#include <math.h>
#include <string.h>

enum { WIDTH = 20, STOPS = 17 };

/* A wave on a swell, never thin. */
static bat_breadths wavy(void) {
    bat_breadths b = {.count = STOPS};
    for (int i = 0; i < STOPS; i++) {
        const double at = i / (STOPS - 1.0);
        b.stops[i] = (bat_width_stop){at, 2 + at + 0.5 * bat_sin(9 * at) + (i % 2 ? 0.2 : -0.2)};
    }
    return b;
}

static bat_curve *line(double x0, double x1, double y) {
    const double points[4] = {x0, y, x1, y};
    bat_curve *made;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &made), BAT_OK);
    return made;
}

/* A line along y = 300 from 100 to 900 with those stops, one below without any; 20 wide. */
static bat_editor *strokes(void) {
    bat_curve *curves[2] = {line(100, 900, 300), line(100, 900, 600)};
    bat_editor *editor = editor_with(2, curves);
    bat_context *c = &editor->context;
    const bat_breadths b = wavy();
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-width", WIDTH), BAT_OK);
    assert_int_equal(bat_transaction_begin(c), BAT_OK);
    assert_int_equal(bat_transaction_end(c, bat_breadths_put(c, 1, b.count, b.stops), BAT_STRING_STEP_WIDTHS),
                     BAT_OK);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "tool-width"), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static bat_breadths now(const bat_editor *editor) {
    bat_breadths b;
    bat_breadths_load(object(editor, 1), false, &b);
    return b;
}

static void says(bat_editor *editor, const char *words) {
    const char *levels = bat_editor_levels(editor);
    if (!strstr(levels, words)) fail_msg("%s, not %s", levels, words);
}

static void acts(bat_editor *editor, bat_level_act act, int level, double value, bool done) {
    assert_int_equal(bat_editor_level(editor, act, level, value, done), BAT_OK);
    bat_editor_frame(editor);
    check(editor);
}

static bool same(const bat_breadths *a, const bat_breadths *b) {
    return a->count == b->count && !memcmp(a->stops, b->stops, a->count * sizeof *a->stops);
}

static void detail(const bat_breadths *b, int level, double *out) {
    double gains[BAT_BREADTH_LEVELS + 1];
    bat_breadths without;
    for (int l = 0; l <= BAT_BREADTH_LEVELS; l++) gains[l] = l != level;
    assert_int_equal(bat_breadths_scale(b, gains, &without), BAT_OK);
    for (size_t i = 0; i < b->count; i++) out[i] = b->stops[i].share - without.stops[i].share;
}

static void the_strip(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    assert_int_not_equal(bat_editor_frame(editor)->levels, 0);
    static const char expected[] =
        "{\"rows\":[{\"points\":4,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":0},"
        "{\"points\":7,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":0},"
        "{\"points\":17,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}],"
        "\"points\":17,\"apart\":0,\"copying\":0,\"of\":\"width\",\"pictures\":[\"M2 ";
    const char *strip = bat_editor_levels(editor);
    assert_memory_equal(strip, expected, sizeof expected - 1);
    int pictures = 0;
    for (const char *next = strip; (next = strstr(next, "\"M2 ")); next++) pictures++;
    assert_int_equal(pictures, 3);
    const uint32_t shown = bat_editor_frame(editor)->levels;
    assert_int_equal(bat_editor_frame(editor)->levels, shown);
    acts(editor, BAT_LEVEL_CHOOSE, 0, 0, true);
    assert_int_not_equal(bat_editor_frame(editor)->levels, shown);
    says(editor, "{\"rows\":[{\"points\":4,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}");
    bat_editor_command(editor, "level-up");
    says(editor, "{\"points\":7,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}");
    assert_string_equal(bat_editor_frame(editor)->notice, "Level 1 / 2");
    for (int i = 0; i < 3; i++) bat_editor_key(editor, "]", true, 0, 0);
    says(editor, "{\"points\":17,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}");
    for (int i = 0; i < 3; i++) bat_editor_key(editor, "[", true, 0, 0);
    says(editor, "{\"points\":4,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}");
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, NAN, true), BAT_NUMBER);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, INFINITY, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 0, 1, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 3, 1, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_CHOOSE, -1, 1, true), BAT_ARGUMENT);
    only(editor, 2, 0); /* two stops: no levels */
    assert_int_equal(bat_editor_frame(editor)->levels, 0);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 2, true), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "level-up"), BAT_STATE);
    only(editor, 1, 0);
    assert_int_not_equal(bat_editor_frame(editor)->levels, 0);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_frame(editor)->levels, 0);
    bat_editor_free(editor);
}

/* The pen, the arrows and a typed number at the base: a swell around the place, with all the detail on it. */
static void a_swell(void **state) {
    (void)state;
    for (int way = 0; way < 3; way++) {
        bat_editor *editor = strokes();
        const bat_breadths before = now(editor);
        const uint64_t first = digest(editor);
        const int steps = editor->session.history.done;
        const double half = WIDTH / 2.0 * before.stops[8].share;
        pen p = pen_for(editor);
        acts(editor, BAT_LEVEL_CHOOSE, 0, 0, true);
        if (way == 0) {
            drag_to(&p, 500, 300 + half, 500, 300 + half + 15);
            assert_true(digest(editor) != first);
            bat_editor_key(editor, "Escape", true, 0, 0);
            assert_true(digest(editor) == first);
            pen_event(&p, BAT_POINTER_UP, 500, 300 + half + 15);
            drag(&p, 500, 300 + half, 500, 300 + half + 15);
        } else {
            for (int i = 0; i <= 8; i++) bat_editor_command(editor, "point-next");
            if (way == 1) bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT, 0);
            if (way == 2) assert_int_equal(bat_editor_enter(editor, "width-here", "90"), BAT_OK);
        }
        const bat_breadths after = now(editor);
        assert_int_equal(after.count, STOPS);
        const double by = after.stops[8].share - before.stops[8].share;
        const double wanted = way == 0 ? 1.5 : way == 1 ? 1 : 4.5 - before.stops[8].share;
        if (!(fabs(by - wanted) < 1e-3)) fail_msg("%d: %g, not %g", way, by, wanted);
        for (int i = 0; i < STOPS; i++) {
            const double x = i / (STOPS - 1.0), y = 1 - x;
            const double bell = (y * y * y + 9 * x * y * y + 9 * x * x * y + x * x * x) / 2.5; /* Bernstein */
            const double moved = after.stops[i].share - before.stops[i].share;
            if (!(fabs(moved - by * bell) < 1e-9)) fail_msg("%d: %d moved by %g", way, i, moved);
        }
        for (int l = 1; l <= 2; l++) {
            double a[STOPS], b[STOPS];
            detail(&before, l, a);
            detail(&after, l, b);
            for (int i = 0; i < STOPS; i++) assert_true(fabs(a[i] - b[i]) < 1e-12);
        }
        assert_int_equal(editor->session.history.done, steps + 1);
        replays(editor, 0);
        bat_editor_command(editor, "undo");
        assert_true(digest(editor) == first);
        /* the finest: this stop alone */
        acts(editor, BAT_LEVEL_CHOOSE, 2, 0, true);
        drag(&p, 500, 300 + half, 500, 300 + half + 15);
        const bat_breadths fine = now(editor);
        for (int i = 0; i < STOPS; i++)
            assert_true((fine.stops[i].share != before.stops[i].share) == (i == 8));
        bat_editor_free(editor);
    }
}

static void faders(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const bat_breadths before = now(editor);
    const uint64_t first = digest(editor);
    const int steps = editor->session.history.done;
    double fine[STOPS];
    detail(&before, 2, fine);
    acts(editor, BAT_LEVEL_GAIN, 2, 1, true); /* no change, no step */
    assert_int_equal(editor->session.history.done, steps);
    acts(editor, BAT_LEVEL_GAIN, 2, 0.4, false);
    assert_int_not_equal(bat_editor_frame(editor)->busy, 0);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 0, false), BAT_STATE);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_MUTE, 1, 1, true), BAT_STATE);
    acts(editor, BAT_LEVEL_GAIN, 2, 0, false);
    const bat_breadths smooth = now(editor);
    for (int i = 0; i < STOPS; i++)
        assert_true(fabs(smooth.stops[i].share + fine[i] - before.stops[i].share) < 1e-12);
    bat_editor_key(editor, "Escape", true, 0, 0);
    check(editor);
    assert_true(digest(editor) == first);
    assert_int_equal(editor->session.history.done, steps);
    says(editor, "{\"points\":17,\"gain\":1,");
    acts(editor, BAT_LEVEL_GAIN, 2, 1.5, false);
    acts(editor, BAT_LEVEL_GAIN, 2, 2, true);
    assert_int_equal(editor->session.history.done, steps + 1);
    says(editor, "{\"points\":17,\"gain\":2,");
    const bat_breadths loud = now(editor);
    for (int i = 0; i < STOPS; i++)
        assert_true(fabs(loud.stops[i].share - fine[i] - before.stops[i].share) < 1e-12);
    acts(editor, BAT_LEVEL_GAIN, 1, 0.5, true);
    says(editor, "{\"points\":7,\"gain\":0.5,");
    replays(editor, 0);
    /* let go: as the last step left it, and the faders know it */
    const uint64_t then = digest(editor);
    acts(editor, BAT_LEVEL_GAIN, 1, 0, false);
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == then);
    says(editor, "{\"points\":7,\"gain\":0.5,");
    /* back to 1: to the bit */
    acts(editor, BAT_LEVEL_GAIN, 1, 1, true);
    acts(editor, BAT_LEVEL_GAIN, 2, 1, true);
    assert_true(digest(editor) == first);
    /* something else changes the width: the faders begin anew */
    acts(editor, BAT_LEVEL_GAIN, 2, 0.5, true);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    says(editor, "{\"points\":17,\"gain\":1,");
    bat_editor_command(editor, "redo");
    says(editor, "{\"points\":17,\"gain\":0.5,");
    pen p = pen_for(editor);
    drag(&p, 500, 310, 500, 320);
    says(editor, "{\"points\":17,\"gain\":1,");
    replays(editor, 0);
    bat_editor_free(editor);
}

static void silence(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const bat_breadths before = now(editor);
    const uint64_t first = digest(editor);
    acts(editor, BAT_LEVEL_MUTE, 2, 1, true);
    says(editor, "{\"points\":7,\"gain\":1,\"muted\":0,\"solo\":1,");
    says(editor, "{\"points\":17,\"gain\":1,\"muted\":1,");
    acts(editor, BAT_LEVEL_MUTE, 2, 0, true);
    assert_true(digest(editor) == first);
    acts(editor, BAT_LEVEL_SOLO, 0, 1, true);
    says(editor, "{\"rows\":[{\"points\":4,\"gain\":1,\"muted\":0,\"solo\":1,");
    const bat_breadths base = now(editor);
    double gains[BAT_BREADTH_LEVELS + 1] = {0};
    bat_breadths wanted;
    assert_int_equal(bat_breadths_scale(&before, gains, &wanted), BAT_OK);
    assert_true(same(&base, &wanted));
    acts(editor, BAT_LEVEL_SOLO, 0, 1, true);
    assert_true(digest(editor) == first);
    const int steps = editor->session.history.done;
    acts(editor, BAT_LEVEL_SOLO, 2, 1, true); /* all sound already */
    assert_int_equal(editor->session.history.done, steps);
    replays(editor, 0);
    /* another tool while a fader is held lets it go */
    acts(editor, BAT_LEVEL_GAIN, 1, 3, false);
    bat_editor_command(editor, "tool-select");
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 3, true);
    bat_editor_frame(editor);
    check(editor);
    assert_false(editor->session.transaction.open);
    bat_editor_free(editor);
}

static void session(bat_editor *editor) {
    pen p = pen_for(editor);
    bat_editor_levels(editor);
    bat_editor_level(editor, BAT_LEVEL_CHOOSE, 0, 0, true);
    pen_begin(&p, pen_arch, (double[]){500, 310, 520, 340, 0}, 8);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_UP, 520, 340);
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 1.5, false);
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 0.5, true);
    bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true);
    bat_editor_level(editor, BAT_LEVEL_MUTE, 1, 1, true);
    bat_editor_levels(editor);
    bat_editor_frame(editor);
}

static void memory_may_end_anywhere(void **state) {
    (void)state;
    bool ended = false;
    for (long n = 1; !ended; n += 1 + n / 24) {
        const long before = alloc_live();
        bat_editor *editor = strokes();
        const uint64_t first = digest(editor);
        const int steps = editor->session.history.done;
        alloc_fail_at(n);
        session(editor);
        ended = !alloc_fail_reached();
        alloc_fail_at(0);
        bat_editor_command(editor, "cancel");
        bat_editor_frame(editor);
        const char *wrong = bat_editor_check(editor);
        if (wrong) fail_msg("allocation %ld: %s", n, wrong);
        while (editor->session.history.done > steps && bat_editor_command(editor, "undo") == BAT_OK) {
        }
        if (digest(editor) != first) fail_msg("allocation %ld", n);
        bat_editor_free(editor);
        assert_int_equal(alloc_live(), before);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_strip),
        cmocka_unit_test(a_swell),
        cmocka_unit_test(faders),
        cmocka_unit_test(silence),
        cmocka_unit_test(memory_may_end_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
