/*
 * The figure nearest to a stroke: strokes along known lines, arcs, circles, ellipses and clothoids, with the tremor and
 * the bow of a hand, are told apart, and the figure found lies nearer to the truth than the stroke; a stroke unlike any
 * of them stays as it is; a drag is a similarity about the anchor.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/real.h"
#include "hands/figures/figures.h"
#include <math.h>
#include <string.h>

enum { MOST = 4000 };

static uint64_t seed = 7;

static double chance(void) { /* -1..1 */
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 4503599627370496.0 - 1;
}

typedef struct truth {
    bat_figure_kind kind;
    double place[2], turn, size; /* of the whole */
    double a, b;                 /* its own numbers */
} truth;

/* A place of the figure before it is put anywhere, about 1 in size. */
static void plain(const truth *t, double f, double out[2]) {
    switch (t->kind) {
    case BAT_FIGURE_LINE: out[0] = f, out[1] = 0; break;
    case BAT_FIGURE_ARC: /* a: sweep */
        out[0] = cos(t->a * f) / t->a * 1.5, out[1] = sin(t->a * f) / t->a * 1.5;
        break;
    case BAT_FIGURE_CIRCLE: out[0] = 0.5 * cos(2 * BAT_PI * f), out[1] = 0.5 * sin(2 * BAT_PI * f); break;
    case BAT_FIGURE_ELLIPSE: /* a: shorter by longer; of a part, b: sweep */
        out[0] = 0.5 * cos(2 * BAT_PI * f), out[1] = t->a * 0.5 * sin(2 * BAT_PI * f);
        break;
    case BAT_FIGURE_ELLIPSE_ARC:
        out[0] = 0.5 * cos(t->b * (f - 0.5)), out[1] = t->a * 0.5 * sin(t->b * (f - 0.5));
        break;
    default: { /* a: turn in all, b: change of it */
        double x = 0, y = 0;
        for (int i = 0; i < 400; i++) {
            const double g = (i + 0.5) / 400 * f, angle = t->a * g + t->b * g * (g - 1);
            x += f / 400 * cos(angle), y += f / 400 * sin(angle);
        }
        out[0] = x, out[1] = y;
    }
    }
}

static void at(const truth *t, double f, double out[2]) {
    double p[2];
    plain(t, f, p);
    out[0] = t->place[0] + t->size * (p[0] * cos(t->turn) - p[1] * sin(t->turn));
    out[1] = t->place[1] + t->size * (p[0] * sin(t->turn) + p[1] * cos(t->turn));
}

/* A hand: slow wobble of two waves and tremor, both in pixels. */
static size_t drawn(const truth *t, double wobble, double tremor, double *out) {
    const size_t count = 60 + (size_t)(t->size * 0.5);
    const double phase = 3 * chance(), other = 3 * chance();
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1);
        at(t, f, out + 2 * i);
        out[2 * i] += wobble * sin(7 * f + phase) + tremor * chance();
        out[2 * i + 1] += wobble * sin(9 * f + other) + tremor * chance();
    }
    return count;
}

/* Greatest distance of the figure's points from the truth. */
static double off(const truth *t, const bat_figure *figure) {
    enum { BEFORE = 20, ALL = 1200, PLACES = ALL + 2 * BEFORE + 1 }; /* a little beyond the ends, too */
    static double truth_at[2 * PLACES];
    double worst = 0;
    for (int k = 0; k < PLACES; k++) at(t, (double)(k - BEFORE) / ALL, truth_at + 2 * k);
    for (size_t i = 0; i < figure->count; i++) {
        double least = INFINITY;
        for (int k = 0; k < PLACES; k++)
            least = fmin(least, hypot(truth_at[2 * k] - figure->points[2 * i],
                                      truth_at[2 * k + 1] - figure->points[2 * i + 1]));
        worst = fmax(worst, least);
    }
    return worst;
}

static const truth KINDS[] = {
    {.kind = BAT_FIGURE_LINE},
    {.kind = BAT_FIGURE_ARC, .a = 1},
    {.kind = BAT_FIGURE_ARC, .a = 2.5},
    {.kind = BAT_FIGURE_ARC, .a = 4.2},
    {.kind = BAT_FIGURE_CIRCLE},
    {.kind = BAT_FIGURE_ELLIPSE, .a = 0.6},
    {.kind = BAT_FIGURE_ELLIPSE, .a = 0.25},
    {.kind = BAT_FIGURE_ELLIPSE_ARC, .a = 0.45, .b = 3.1},
    {.kind = BAT_FIGURE_ELLIPSE_ARC, .a = 0.5, .b = 4.2},
    {.kind = BAT_FIGURE_CLOTHOID, .a = 0, .b = 5},
    {.kind = BAT_FIGURE_CLOTHOID, .a = 2.5, .b = 3},
};

static void known_figures_are_found(void **state) {
    (void)state;
    static double stroke[2 * MOST];
    static const double sizes[] = {60, 200, 700};
    int right = 0, all = 0;
    for (size_t k = 0; k < sizeof KINDS / sizeof *KINDS; k++)
        for (int s = 0; s < 3; s++)
            for (int turn = 0; turn < 10; turn++, all++) {
                truth t = KINDS[k];
                t.size = sizes[s], t.turn = turn * 0.63;
                t.place[0] = 400 + 100 * chance(), t.place[1] = 300;
                const double wobble = 0.006 * t.size;
                const size_t count = drawn(&t, wobble, 0.4, stroke);
                bat_figure figure;
                bat_figure_nearest(count, stroke, &figure);
                if (figure.kind != t.kind) {
                    print_message("kind %d of size %g: %d\n", t.kind, t.size, figure.kind);
                    continue;
                }
                right++;
                assert_true(figure.miss < 2 * wobble + 0.6);
                const double d = off(&t, &figure);
                if (!(d < 4 * wobble + 1.5)) fail_msg("kind %d of size %g is %g off", t.kind, t.size, d);
            }
    print_message("%d of %d\n", right, all);
    assert_true(right >= 0.97 * all);
}

/* Without a hand, to the rounding of places. */
static void exact_ones_stay(void **state) {
    (void)state;
    static double stroke[2 * MOST];
    for (size_t k = 0; k < sizeof KINDS / sizeof *KINDS; k++) {
        truth t = KINDS[k];
        t.size = 300, t.turn = 0.4, t.place[0] = t.place[1] = 500;
        bat_figure figure;
        bat_figure_nearest(drawn(&t, 0, 0, stroke), stroke, &figure);
        assert_int_equal(figure.kind, t.kind);
        const double d = off(&t, &figure);
        if (!(d < 1)) fail_msg("kind %zu is %g off", k, d);
    }
}

static void others_are_left_alone(void **state) {
    (void)state;
    static double stroke[2 * MOST];
    bat_figure figure;
    for (int i = 0; i < 200; i++) { /* a zigzag */
        stroke[2 * i] = 2 * i, stroke[2 * i + 1] = 80 * fabs(remainder(i, 50)) / 25;
    }
    bat_figure_nearest(200, stroke, &figure);
    assert_int_equal(figure.kind, BAT_FIGURE_NONE);
    bat_figure_nearest(0, stroke, &figure);
    assert_int_equal(figure.kind, BAT_FIGURE_NONE);
    bat_figure_nearest(1, stroke, &figure);
    assert_int_equal(figure.kind, BAT_FIGURE_NONE);
    for (int i = 0; i < 200; i++) stroke[2 * i] = stroke[2 * i + 1] = i % 3 ? 5.0 : 5.4;
    bat_figure_nearest(100, stroke, &figure); /* a hand at rest */
    assert_int_equal(figure.kind, BAT_FIGURE_NONE);
    for (int i = 0; i < 200; i++) stroke[i] = i % 4 ? NAN : INFINITY;
    bat_figure_nearest(100, stroke, &figure);
    assert_int_equal(figure.kind, BAT_FIGURE_NONE);
    const double two[] = {0, 0, NAN, 3, 100, 50};
    bat_figure_nearest(3, two, &figure);
    assert_int_equal(figure.kind, BAT_FIGURE_LINE);
    assert_true(fabs(figure.points[0]) < 1e-9 && fabs(figure.points[2 * figure.count - 2] - 100) < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(known_figures_are_found),
                                       cmocka_unit_test(exact_ones_stay),
                                       cmocka_unit_test(others_are_left_alone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
