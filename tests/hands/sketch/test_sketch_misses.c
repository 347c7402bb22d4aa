/* Redraws of bends by strokes whose ends miss the curve by a little, at three scales: what the blends add to the curve's
 * inflections and to its greatest curvature. Measured values are printed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

#include "support/known_strokes.h"
#include "support/rounds.h"

enum { CIRCLE, OPEN_ARC, ELLIPSE, ESS, SHAPES };          /* what is redrawn */
enum { OUTSIDE, INSIDE, TILTED, BOWED, ONE_END, MISSES }; /* how the stroke misses it */
enum { ALL = 900, TRIES = ROUNDS_OF(40), SIZES = 6 };
static const double sizes[SIZES] = {0.5, 1, 2, 3, 5, 8}, bars[SIZES] = {0.94, 0.94, 0.94, 0.94, 0.76, 0.45};

typedef struct bend {
    int shape;
    double R, height;  /* ellipse: of R; ess: px, a quarter of its wave is R */
    double from, to;   /* places of the whole curve */
    double begin, end; /* of the stroke */
} bend;

static void place(const bend *b, double t, double p[2], double normal[2]) {
    const double a = t / b->R, k = pi / (2 * b->R);
    if (b->shape == ESS) {
        p[0] = t, p[1] = b->height * sin(k * t);
        normal[0] = -b->height * k * cos(k * t), normal[1] = 1;
    } else {
        p[0] = b->R * cos(a), p[1] = b->height * b->R * sin(a);
        normal[0] = b->height * cos(a), normal[1] = sin(a);
    }
    const double h = hypot(normal[0], normal[1]);
    normal[0] /= h, normal[1] /= h;
}

static bend random_bend(random_source *r, int shape) {
    bend b = {.shape = shape, .R = random_between(r, 80, 300), .height = 1};
    double length = random_between(r, 0.8, 2.6) * b.R, middle = random_between(r, 0, 6) * b.R;
    b.to = 2 * pi * b.R;
    if (shape == OPEN_ARC) {
        b.R = random_between(r, 150, 500), b.to = fmin(450, 2.6 * b.R), b.from = -b.to;
        length = fmin(random_between(r, 150, 400), b.to), middle = 0;
    } else if (shape == ELLIPSE) {
        b.height = random_between(r, 0.5, 0.9);
    } else if (shape == ESS) {
        b.height = b.R * random_between(r, 0.25, 0.6), b.to = 4 * b.R, b.from = -b.to;
        length = random_between(r, 1.2, 3.2) * b.R, middle = random_between(r, -1, 1) * b.R;
    }
    b.begin = middle - length / 2, b.end = middle + length / 2;
    return b;
}

static double share_of_miss(int how, double f, double sign) {
    switch (how) {
    case OUTSIDE: return 1;
    case INSIDE: return -1;
    case TILTED: return 1 - 2 * f;
    case BOWED: return sign * (2 * f - 1) * (2 * f - 1);
    default: return sign * (1 - f);
    }
}

/* Greatest curvature, and inflections between stretches that bend by over `least`. */
static double peak_of(const bat_curve *curve, double least, int *inflections) {
    static double k[PLACES];
    double range[2], peak = 0, before = 0;
    bat_curve_domain(curve, range);
    curvatures(curve, range, k);
    *inflections = 0;
    for (int i = 0; i < PLACES; i++) {
        peak = fmax(peak, fabs(k[i]));
        if (fabs(k[i]) < least) continue;
        *inflections += k[i] * before < 0;
        before = k[i];
    }
    return peak;
}

static bat_curve *whole_curve(const bend *b, double scale) {
    static double x[2 * ALL];
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = scale, options.tolerance = 0.05 * scale;
    for (int i = 0; i < ALL; i++) {
        double normal[2];
        place(b, b->from + (b->to - b->from) * i / (ALL - 1), x + 2 * i, normal);
        x[2 * i] *= scale, x[2 * i + 1] *= scale;
    }
    const bat_stroke stroke = {.dimension = 2, .count = ALL, .points = x};
    const bool closed = b->shape == CIRCLE || b->shape == ELLIPSE;
    bat_curve *curve = NULL;
    assert_int_equal(bat_sketch_new(&stroke, closed, &options, &curve, NULL), BAT_OK);
    return curve;
}

/* Whether a redraw leaves at most one inflection more than the curve has, and 1.5 times its greatest curvature. */
static bool is_calm(random_source *r, int shape, int how, double miss, double scale) {
    static double x[2 * ALL], time[ALL];
    const bend b = random_bend(r, shape);
    const double sign = random_unit(r) < 0.5 ? -1 : 1, rate = random_between(r, 8, 12), tremor = 0.3;
    const size_t count = (size_t)((b.end - b.begin) / SPEED * RATE) + 1;
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1), w = miss * share_of_miss(how, f, sign);
        double p[2], normal[2];
        place(&b, b.begin + (b.end - b.begin) * f, p, normal);
        for (size_t c = 0; c < 2; c++) {
            const double shake = tremor * sin(2 * pi * (rate + (double)c) * (double)i / RATE + (double)c);
            x[2 * i + c] = scale * (p[c] + w * normal[c] + shake + 0.12 * random_normal(r));
        }
        time[i] = 1000.0 * (double)i / RATE;
    }
    const bat_stroke stroke = {.dimension = 2, .count = count, .points = x, .time = time};
    bat_sketch_options options = bat_sketch_defaults();
    options.pixel = options.tolerance = scale;
    bat_curve *before = whole_curve(&b, scale), *after = NULL;
    assert_int_equal(bat_sketch(before, &stroke, &options, &after, NULL), BAT_OK);
    int had, has;
    const double peak = peak_of(before, 0, &had);
    peak_of(before, 0.02 * peak, &had);
    const double now = peak_of(after, 0.02 * peak, &has);
    bat_curve_free(before);
    bat_curve_free(after);
    return has <= had + 1 && now <= 1.5 * peak;
}

static void count_calm(double scale) {
    int calm[SIZES] = {0};
    for (int i = 0; i < SIZES; i++)
        for (int n = 0; n < SHAPES * TRIES; n++) {
            random_source r = {1000 + (uint64_t)n};
            calm[i] += is_calm(&r, n % SHAPES, n / SHAPES % MISSES, sizes[i], scale);
        }
    print_message(
        "scale %g: without a bump, of %d whose ends miss by 0.5, 1, 2, 3, 5, 8 px: %d, %d, %d, %d, %d, %d\n",
        scale, SHAPES * TRIES, calm[0], calm[1], calm[2], calm[3], calm[4], calm[5]);
    if (FEWER) return; /* a sixth is too few for a share */
    for (int i = 0; i < SIZES; i++) assert_true(calm[i] >= (int)(bars[i] * SHAPES * TRIES));
}

static void small_misses_leave_no_bump(void **state) {
    (void)state;
    count_calm(1);
}

static void at_any_scale(void **state) {
    (void)state;
    count_calm(1e-6);
    count_calm(1e6);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(small_misses_leave_no_bump),
                                       cmocka_unit_test(at_any_scale)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
