/* The width that a pen's pressure gives a line: where the pen pressed, whichever side of a closed figure it began on and whichever
 * way it went; open ends run out to a point; strokes over one line are averaged. Measured values are printed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/edit/pressing.h"
#include "support/random_curve.h"
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/sketch.h>

#include <string.h>

static const double pi = 3.14159265358979324;
enum { SAMPLES = 2000, FIGURES = 40, LOOKS = 48 };

static double places[2 * SAMPLES], pressure[SAMPLES];

static bat_samples samples_of(size_t count) {
    return (bat_samples){.dimension = 2, .count = count, .places = places, .pressure = pressure};
}

/* A figure of straight sides: its corners lie round the origin. */
typedef struct figure {
    int sides;
    double corner[7][2], length;
} figure;

static figure random_figure(random_source *r) {
    figure f = {.sides = random_int(r, 3, 6)};
    const double size = random_between(r, 30, 200), turn = random_between(r, 0, 6);
    for (int i = 0; i < f.sides; i++) {
        const double a = turn + 2 * pi * (i + random_between(r, -0.15, 0.15)) / f.sides;
        f.corner[i][0] = size * cos(a), f.corner[i][1] = 0.8 * size * sin(a);
    }
    memcpy(f.corner[f.sides], f.corner[0], sizeof f.corner[0]);
    for (int i = 0; i < f.sides; i++)
        f.length += hypot(f.corner[i + 1][0] - f.corner[i][0], f.corner[i + 1][1] - f.corner[i][1]);
    return f;
}

static void place_on(const figure *f, double share, double p[2]) {
    double left = (share - floor(share)) * f->length;
    for (int i = 0; i < f->sides; i++) {
        const double *a = f->corner[i], *b = f->corner[i + 1], side = hypot(b[0] - a[0], b[1] - a[1]);
        if (left <= side || i + 1 == f->sides) {
            for (int c = 0; c < 2; c++) p[c] = a[c] + left / side * (b[c] - a[c]);
            return;
        }
        left -= side;
    }
}

static double pressed_at(double share) { return 0.5 + 0.3 * sin(2 * pi * share); }

/* Draws it from `begin` on, once round and `over` of it more, with a hand that trembles; slower at first. */
static size_t draw(random_source *r, const figure *f, double begin, double sense, double over, double scale) {
    const double rate = random_between(r, 8, 12), tremor = random_between(r, 0, 0.4);
    size_t count = 0;
    for (double gone = 0; gone < (1 + over) * f->length && count < SAMPLES; count++) {
        const double share = begin + sense * gone / f->length, t = (double)count / 240;
        double p[2];
        place_on(f, share, p);
        places[2 * count] = scale * (p[0] + tremor * sin(2 * pi * rate * t) + random_between(r, -0.2, 0.2));
        places[2 * count + 1] = scale *
                                (p[1] + tremor * cos(2 * pi * (rate + 1) * t) + random_between(r, -0.2, 0.2));
        pressure[count] = pressed_at(share);
        gone += fmin(2, 0.4 + gone / 20);
    }
    return count;
}

static double share_at(const bat_curve *curve, const double *p, const bat_width_profile *profile) {
    double domain[2], value[2];
    bat_near near;
    bat_curve_domain(curve, domain);
    assert_int_equal(bat_curve_nearest(curve, p, &near), BAT_OK);
    const double at = bat_curve_length(curve, domain[0], near.u, 1e-4) /
                      bat_curve_length(curve, domain[0], domain[1], 1e-4);
    bat_width_eval(profile, bat_curve_is_closed(curve), at, value);
    return value[0];
}

static void closed_figures(double scale) {
    double worst = 0, sum = 0;
    int whole = 0;
    for (int n = 0; n < FIGURES; n++) {
        random_source r = {(uint64_t)(70 + n)};
        const figure f = random_figure(&r);
        const double begin = random_between(&r, 0, 1), sense = n % 2 ? 1 : -1,
                     over = random_between(&r, -0.02, 0.06);
        const bat_samples samples = samples_of(draw(&r, &f, begin, sense, over, scale));
        const bat_stroke stroke = {.dimension = 2, .count = samples.count, .points = places};
        bat_sketch_options options = bat_sketch_defaults();
        options.pixel = options.tolerance = scale, options.keep_corners = true;
        bat_curve *curve = NULL;
        assert_int_equal(bat_sketch_new(&stroke, true, &options, &curve, NULL), BAT_OK);
        bat_pressing pressing;
        bat_width_stop stops[BAT_PRESSED_STOPS];
        assert_true(bat_pressing_curve(&pressing, curve));
        bat_pressing_add(&pressing, &samples);
        const bat_width_profile profile = {bat_pressing_stops(&pressing, 3 * scale, stops), stops};
        assert_int_equal(bat_width_check(&profile, NULL), BAT_OK);
        double most = 0;
        for (int i = 0; i < LOOKS; i++) {
            double p[2];
            place_on(&f, (double)i / LOOKS, p);
            p[0] *= scale, p[1] *= scale;
            const double d = fabs(share_at(curve, p, &profile) - 2 * pressed_at((double)i / LOOKS));
            most = fmax(most, d), sum += d / LOOKS;
        }
        worst = fmax(worst, most), whole += most < 0.2;
        bat_curve_free(curve);
    }
    print_message(
        "scale %g, closed, with corners: width off by %.3f of the style's on average, %.3f at most; %d of %d "
        "within 0.2\n",
        scale, sum / FIGURES, worst, whole, FIGURES);
    assert_true(sum / FIGURES < 0.05);
    assert_true(whole >= 0.95 * FIGURES);
}

static void lies_where_the_pen_pressed(void **state) {
    (void)state;
    closed_figures(1);
    closed_figures(1e-6);
    closed_figures(1e6);
}

/* A straight line from x = 0 to `to`, the other way for from > to. */
static bat_samples straight(double from, double to, double press, double more) {
    const size_t count = 101;
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1);
        places[2 * i] = from + f * (to - from), places[2 * i + 1] = 0;
        pressure[i] = press + more * places[2 * i] / 100;
    }
    return samples_of(count);
}

static void ends_run_out(void **state) {
    (void)state;
    const double line[] = {0, 0, 30, 0, 100, 0}, width = 4;
    bat_width_stop stops[BAT_PRESSED_STOPS];
    bat_pressing pressing;
    double value[2];
    assert_false(bat_pressing_line(&pressing, 2, (const double[]){1, 1, 1, 1}));
    assert_true(bat_pressing_line(&pressing, 3, line));
    bat_samples samples = straight(0, 100, 0.5, 0);
    bat_pressing_add(&pressing, &samples);
    assert_int_equal(bat_pressing_stops(&pressing, width, stops), 0); /* pressed evenly, as by a mouse */
    assert_true(bat_pressing_line(&pressing, 3, line));
    samples = straight(0, 100, 0.3, 0.4);
    bat_pressing_add(&pressing, &samples);
    const bat_width_profile profile = {bat_pressing_stops(&pressing, width, stops), stops};
    assert_int_equal(bat_width_check(&profile, NULL), BAT_OK);
    for (int i = 0; i <= 100; i++) {
        bat_width_eval(&profile, false, i / 100.0, value);
        const double wanted = 0.6 + 0.8 * i / 100, feather = 1.5 * width * (i < 50 ? 0.6 : 1.4);
        if (i >= feather + 1 && i <= 99 - feather)
            assert_true(fabs(value[0] - wanted) < 0.05);
        else
            assert_true(value[0] >= 0 && value[0] <= wanted + 0.05);
    }
    assert_true(stops[0].share == 0 && stops[profile.count - 1].share == 0);
}

static void strokes_are_averaged(void **state) {
    (void)state;
    const double line[] = {0, 0, 100, 0};
    const double press[][4] = {{0, 100, 0.2, 0.2}, {100, 0, 0.4, 0.2}, {60, 0, 0.6, 0.2}, {1, 98, 0.4, 0.2}};
    bat_width_stop stops[BAT_PRESSED_STOPS];
    bat_pressing pressing;
    double value[2];
    assert_true(bat_pressing_line(&pressing, 2, line));
    for (int i = 0; i < 4; i++) {
        const bat_samples samples = straight(press[i][0], press[i][1], press[i][2], press[i][3]);
        bat_pressing_add(&pressing, &samples);
    }
    const bat_width_profile profile = {bat_pressing_stops(&pressing, 1, stops), stops};
    for (int i = 10; i < 95; i++) {
        bat_width_eval(&profile, false, i / 100.0, value);
        const double wanted = 2 * (0.2 * i / 100 + (i < 60 ? 0.4 : 1.0 / 3));
        if (i < 50 || i > 70) assert_true(fabs(value[0] - wanted) < 0.03);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lies_where_the_pen_pressed),
                                       cmocka_unit_test(ends_run_out),
                                       cmocka_unit_test(strokes_are_averaged)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
