/* Hooks of a pen that lands and leaves, drawn at little pressure within some 30 ms, bend no end of a stroke; what is meant,
 * the foot of a bracket or the flag of a 1, is drawn at the pressure of the stroke and stays. Measured values are printed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

#include "support/known_strokes.h"

enum { FINE = 4000, SAMPLES = 4000, TRIES = 150 };

typedef struct pen {
    size_t count;
    double points[2 * SAMPLES], time[SAMPLES], pressure[SAMPLES];
    double tremor, sensor, rate;
    double rise; /* ms until it presses as it will */
} pen;

static void push(random_source *r, pen *p, double x, double y, double pressure) {
    const double t = (double)p->count / RATE;
    p->points[2 * p->count] = x + p->tremor * sin(2 * pi * p->rate * t) + p->sensor * random_normal(r);
    p->points[2 * p->count + 1] = y + p->tremor * cos(2 * pi * (p->rate + 1) * t) +
                                  p->sensor * random_normal(r);
    p->time[p->count] = 1000 * t;
    p->pressure[p->count] = pressure * (p->rise > 0 ? fmin(1, 0.3 + 700 * t / p->rise) : 1), p->count++;
}

static void hold(random_source *r, pen *p) {
    p->count = 0, p->tremor = random_between(r, 0.1, 0.4), p->sensor = random_between(r, 0.02, 0.15);
    p->rate = random_between(r, 8, 12), p->rise = 0;
}

/* True path: x, y and direction at even lengths. */
static void walk(const profile *p, double start, double way[FINE + 1][3]) {
    const double h = p->length / FINE;
    double at[3] = {200, 200, start};
    for (int i = 0; i <= FINE; i++) {
        for (int c = 0; c < 3; c++) way[i][c] = at[c];
        const double k = curvature_of(p, (double)i / FINE);
        at[2] += 0.5 * k * h, at[0] += h * cos(at[2]), at[1] += h * sin(at[2]), at[2] += 0.5 * k * h;
    }
}

/* A hook that leads to a point, or from it. */
static void hook(random_source *r, pen *p, const double *point, double most, bool landing) {
    const double length = random_between(r, 1.5, most), way = random_between(r, 0, 2 * pi);
    const int count = (landing ? 4 : 3) + (int)random_between(r, 0, landing ? 4 : 3);
    for (int i = 0; i < count && most > 0; i++) {
        const double f = landing ? 1 - (double)i / count : (i + 1.0) / count;
        push(r, p, point[0] + f * length * cos(way), point[1] + f * length * sin(way),
             landing ? 0.1 + 0.05 * i : 0.2 * (1 - f) + 0.02);
    }
}

static void draw_with(random_source *r, const profile *q, double way[FINE + 1][3], double most, pen *p) {
    const double speed = random_between(r, 250, 700), ramp = fmin(40, 0.2 * q->length);
    hold(r, p);
    p->rise = fmax(0, random_between(r, -150, 150)); /* half of them press slowly */
    hook(r, p, way[0], most, true);
    for (double s = 0; s < q->length;) {
        const double *at = way[(int)(s / q->length * FINE)];
        push(r, p, at[0], at[1], 0.35 + 0.35 * sin(pi * s / q->length));
        s += speed * fmin(1, 0.18 + 0.82 * fmin(s, q->length - s) / ramp) / RATE;
    }
    hook(r, p, way[FINE], most, false);
}

static bat_curve *curve_of(const pen *p) {
    const bat_stroke stroke = {
        .dimension = 2, .count = p->count, .points = p->points, .pressure = p->pressure, .time = p->time};
    bat_curve *curve = NULL;
    const bat_status status = bat_sketch_new(&stroke, false, NULL, &curve, NULL);
    assert_true(status == BAT_OK || status == BAT_TOLERANCE);
    return curve;
}

/* Whether the curve's direction at that end is over 20 degrees from the true one nearest to it. */
static bool end_is_wrong(const bat_curve *curve, double way[FINE + 1][3], int end) {
    double domain[2], jet[4], least = INFINITY, true_way = 0;
    bat_curve_domain(curve, domain);
    if (end)
        bat_curve_eval_left(curve, domain[1], 1, jet);
    else
        bat_curve_eval(curve, domain[0], 1, jet);
    for (int i = 0; i <= FINE; i++) {
        const double d = hypot(way[i][0] - jet[0], way[i][1] - jet[1]);
        if (d < least) least = d, true_way = way[i][2];
    }
    const double along = (jet[2] * cos(true_way) + jet[3] * sin(true_way)) / hypot(jet[2], jet[3]);
    return along < cos(20 * pi / 180);
}

/* Changes of the bend's side that the true path does not have, where both bend by over 2 % of its greatest curvature. */
static int false_inflections(const bat_curve *curve, const profile *q) {
    static double k[PLACES];
    double range[2], peak = 0, before = 0, had = 0;
    int inflections = 0;
    bat_curve_domain(curve, range);
    curvatures(curve, range, k);
    for (int i = 0; i <= FINE; i++) peak = fmax(peak, fabs(curvature_of(q, (double)i / FINE)));
    for (int i = 0; i < PLACES; i++) {
        if (fabs(k[i]) < 0.02 * peak) continue;
        inflections += k[i] * before < 0, before = k[i];
    }
    for (int i = 0; i <= FINE; i++) {
        const double truth = curvature_of(q, (double)i / FINE);
        if (fabs(truth) < 0.02 * peak) continue;
        inflections -= truth * had < 0, had = truth;
    }
    return inflections > 0 ? inflections : 0;
}

typedef struct count {
    double wrong, inflections; /* ends, percent; false ones a stroke */
} count;

/* share: of the lengths of strokes that are drawn large. */
static count drawn_with_hooks(double share, double most) {
    static double way[FINE + 1][3];
    static pen p;
    count c = {0};
    for (int n = 0; n < TRIES; n++) {
        random_source r = {(uint64_t)(100 + n)};
        profile q = random_profile(&r, n % KINDS);
        q.length *= share, q.a /= share;
        if (q.kind != WAVE) q.b /= share;
        walk(&q, random_between(&r, 0, 6), way);
        draw_with(&r, &q, way, most, &p);
        bat_curve *curve = curve_of(&p);
        for (int end = 0; end < 2; end++) c.wrong += 100.0 / (2 * TRIES) * end_is_wrong(curve, way, end);
        c.inflections += (double)false_inflections(curve, &q) / TRIES;
        bat_curve_free(curve);
    }
    return c;
}

static void landing_and_leaving_bend_no_end(void **state) {
    (void)state;
    const count plain = drawn_with_hooks(1, 0), large = drawn_with_hooks(1, 4),
                small = drawn_with_hooks(0.25, 4), least = drawn_with_hooks(0.25, 0);
    print_message(
        "hooks of 1.5 to 4 px: %.1f %% of ends over 20 degrees wrong (without hooks %.1f %%), %.3f false "
        "inflections a stroke (%.3f); of strokes a quarter as long %.1f %% (%.1f %%), %.3f (%.3f)\n",
        large.wrong, plain.wrong, large.inflections, plain.inflections, small.wrong, least.wrong,
        small.inflections, least.inflections);
    assert_true(plain.wrong <= 1);
    assert_true(large.wrong <= 3 && large.inflections <= 0.1);
    assert_true(small.wrong <= 3 && small.inflections <= 0.1);
}

/* A straight stroke that begins with a short leg across, at the pressure of the stroke but for its first samples. */
static void what_is_meant_stays(void **state) {
    (void)state;
    static pen p;
    int kept = 0;
    for (int n = 0; n < TRIES; n++) {
        random_source r = {(uint64_t)(900 + n)};
        const double foot = random_between(&r, 4, 12), length = random_between(&r, 60, 140);
        const double turn = random_between(&r, 60, 120) * pi / 180, speed = random_between(&r, 150, 450);
        const double tip[2] = {200 + foot * sin(turn), 200 + foot * cos(turn)};
        const int lands = n % 3 * 4; /* samples until it presses; 0: a mouse */
        hold(&r, &p);
        for (double s = 0; s < foot + length; s += speed * fmin(1, 0.2 + 0.8 * s / 30) / RATE) {
            const double f = fmin(1, s / foot), rest = fmax(0, s - foot);
            const double pressure = lands ? 0.1 + 0.45 * fmin(1, (double)(p.count + 1) / lands) : 0.5;
            push(&r, &p, tip[0] + f * (200 - tip[0]), tip[1] + f * (200 - tip[1]) + rest, pressure);
        }
        bat_curve *curve = curve_of(&p);
        double domain[2], begin[2];
        bat_curve_domain(curve, domain);
        bat_curve_eval(curve, domain[0], 0, begin);
        kept += hypot(begin[0] - tip[0], begin[1] - tip[1]) < 0.35 * foot;
        bat_curve_free(curve);
    }
    print_message("feet of 4 to 12 px: %d of %d stay\n", kept, TRIES);
    assert_true(kept >= 0.97 * TRIES);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(landing_and_leaving_bend_no_end),
                                       cmocka_unit_test(what_is_meant_stays)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
