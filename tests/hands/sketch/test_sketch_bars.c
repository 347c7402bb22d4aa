/* The acceptance limits of the sketch hand (docs/math/sketch.md), each over many random cases and two seeds: the one
 * used in development and one held out. Measured values are printed. label: slow */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "support/rounds.h"
#include "support/sketch_cases.h"

static const uint64_t seeds[] = {101, 90210};
enum { SEEDS = ROUNDS_OF((int)(sizeof seeds / sizeof *seeds)) };

/* Draws along the curve once and takes the result. */
static void redraw(bat_curve **curve, const drawn *d) {
    bat_curve *now = NULL;
    assert_int_equal(bat_sketch(*curve, &d->stroke, NULL, &now, NULL), BAT_OK);
    bat_curve_free(*curve);
    *curve = now;
}

/* Knots of a fresh fit of the same shape: the curve drawn anew without noise. */
static int fresh_knots(const bat_curve *curve) {
    enum { COUNT = 1200 };
    static double points[2 * COUNT];
    double domain[2];
    bat_curve_domain(curve, domain);
    const bool closed = bat_curve_is_closed(curve);
    for (int i = 0; i < COUNT; i++)
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / (closed ? COUNT : COUNT - 1), 0,
                       points + 2 * i);
    bat_curve *fresh = NULL;
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = points};
    const bat_status status = bat_sketch_new(&stroke, closed, NULL, &fresh, NULL);
    assert_true(status == BAT_OK);
    const int count = bat_curve_knot_count(fresh);
    bat_curve_free(fresh);
    return count;
}

/* A random stretch, a stroke along it; no steeper than a hand would draw it. */
static drawn random_stroke(random_source *r, const bat_curve *curve, double height, double noise) {
    double domain[2];
    bat_curve_domain(curve, domain);
    const double T = domain[1] - domain[0], part = T * random_between(r, 0.1, 0.35);
    const double u0 = domain[0] + random_unit(r) * (bat_curve_is_closed(curve) ? T : T - part);
    const bool back = random_unit(r) < 0.5;
    const double length = bat_curve_length(curve, u0, u0 + part, 1e-3);
    return draw_calmly(r, curve, back ? u0 + part : u0, back ? u0 : u0 + part, 150,
                       fmin(height, 0.25 * length), noise);
}

static void fifty_redraws(void **state) {
    (void)state;
    enum { RUNS = 6, REDRAWS = 50 };
    for (int kind = 0; kind < 4; kind++) { /* open mild, closed mild, open strong, closed strong */
        double worst_speed = 0, worst_knots = 0, mean_knots = 0;
        for (int s = 0; s < SEEDS; s++) {
            random_source r = {seeds[s] + (uint64_t)kind};
            for (int run = 0; run < RUNS; run++) {
                bat_curve *curve = kind % 2 ? ring_curve(&r, 10, 20) : wavy_curve(&r, 10, 40);
                for (int n = 0; n < REDRAWS; n++) {
                    drawn d = random_stroke(&r, curve, kind < 2 ? 20 : 60, 0.5);
                    redraw(&curve, &d);
                    drawn_free(&d);
                }
                const int fresh = fresh_knots(curve);
                const double knots = (double)bat_curve_knot_count(curve) / fresh, speed = speed_ratio(curve);
                worst_speed = fmax(worst_speed, speed), worst_knots = fmax(worst_knots, knots);
                mean_knots += (double)bat_curve_knot_count(curve) / (RUNS * SEEDS);
                bat_curve_free(curve);
            }
        }
        print_message(
            "50 redraws, kind %d: speed ratio %.2f at most, knots %.2f of a fresh fit at most, %.1f mean\n",
            kind, worst_speed, worst_knots, mean_knots);
        assert_true(worst_speed <= 3);
        assert_true(worst_knots <= 1.6);
    }
}

static void one_stretch_twenty_times(void **state) {
    (void)state;
    double worst = 0;
    for (int s = 0; s < SEEDS; s++) {
        random_source r = {seeds[s]};
        for (int run = 0; run < 20; run++) {
            bat_curve *curve = run % 2 ? ring_curve(&r, 12, 30) : wavy_curve(&r, 12, 40);
            double domain[2];
            bat_curve_domain(curve, domain);
            const double T = domain[1] - domain[0];
            double from[2], to[2];
            bat_curve_eval(curve, domain[0] + 0.3 * T, 0, from);
            bat_curve_eval(curve, domain[0] + 0.6 * T, 0, to);
            for (int n = 0; n < 20; n++) {
                bat_near a, b;
                assert_int_equal(bat_curve_nearest(curve, from, &a), BAT_OK);
                assert_int_equal(bat_curve_nearest(curve, to, &b), BAT_OK);
                if (!(b.u > a.u)) b.u += bat_curve_is_closed(curve) ? T : 0;
                drawn d = draw_calmly(&r, curve, a.u, b.u, 150, 25, 0.5);
                redraw(&curve, &d);
                drawn_free(&d);
            }
            worst = fmax(worst, (double)bat_curve_knot_count(curve) / fresh_knots(curve));
            bat_curve_free(curve);
        }
    }
    print_message("20 redraws of one stretch: %.2f of a fresh fit's knots at most\n", worst);
    assert_true(worst <= 1.5);
}

static void same_stroke_five_times(void **state) {
    (void)state;
    double worst = 0, sum = 0, total = 0;
    for (int s = 0; s < SEEDS; s++) {
        random_source r = {seeds[s]};
        for (int run = 0; run < 40; run++) {
            bat_curve *curve = run % 2 ? ring_curve(&r, 12, 30) : wavy_curve(&r, 12, 40);
            drawn d = random_stroke(&r, curve, 40, 0.5);
            int second = 0;
            for (int n = 0; n < 5; n++) {
                redraw(&curve, &d);
                if (n == 1) second = bat_curve_knot_count(curve);
            }
            /* One stroke is a dozen knots: two or three knots are more than a tenth. */
            const int more = bat_curve_knot_count(curve) - second;
            worst = fmax(worst, more <= 3 ? 0 : (double)more / second);
            sum += more, total += second;
            drawn_free(&d);
            bat_curve_free(curve);
        }
    }
    print_message("one stroke five times: %.1f %% more knots than after the second on average\n",
                  100.0 * sum / total);
    assert_true(worst <= 0.10);
    assert_true(sum <= 0.03 * total);
}

static void plain_stroke_over_busy_stretch(void **state) {
    (void)state;
    int worst = -1000;
    for (int s = 0; s < SEEDS; s++) {
        random_source r = {seeds[s]};
        for (int run = 0; run < 30; run++) {
            bat_curve *curve = wavy_curve(&r, 60, 12);
            const double y = 300 + random_between(&r, -4, 4);
            double points[2 * 120];
            for (int i = 0; i < 120; i++) {
                points[2 * i] = 160 + 400.0 * i / 119 + 0.5 * random_normal(&r);
                points[2 * i + 1] = y + 10 * sin(i * 0.02) + 0.5 * random_normal(&r);
            }
            const bat_stroke stroke = {.dimension = 2, .count = 120, .points = points};
            bat_curve *now = NULL;
            bat_sketch_report report;
            assert_int_equal(bat_sketch(curve, &stroke, NULL, &now, &report), BAT_OK);
            const int change = report.knots_after - report.knots_before;
            worst = change > worst ? change : worst;
            bat_curve_free(now);
            bat_curve_free(curve);
        }
    }
    print_message("plain stroke over a busy stretch: %d knots at least gone\n", -worst);
    assert_true(worst < -20);
}

/* A noisy stroke's curve against the shape the hand meant, between the transitions. */
static void noise_is_not_drawn(void **state) {
    (void)state;
    static const double sigmas[] = {0, 0.3, 0.6, 1, 1.5};
    for (int n = 0; n < 5; n++) {
        double worst = 0, worst_rms = 0, worst_raw = 0;
        for (int s = 0; s < SEEDS; s++) {
            random_source r = {seeds[s]};
            for (int run = 0; run < 30; run++) {
                bat_curve *curve = wavy_curve(&r, 12, 40);
                drawn d = draw_calmly(&r, curve, 2, 7, 240, 40, sigmas[n]);
                bat_curve *now = NULL;
                bat_sketch_report report;
                assert_int_equal(bat_sketch(curve, &d.stroke, NULL, &now, &report), BAT_OK);
                assert_true(report.max_error <= 1);
                bat_finder *finder;
                assert_int_equal(bat_finder_create(now, &finder), BAT_OK);
                double sum = 0;
                for (size_t i = 72; i < 168; i++) {
                    bat_near near;
                    bat_finder_nearest(finder, d.truth + 2 * i, &near);
                    worst = fmax(worst, near.distance / (1.25 + 2.2 * sigmas[n]));
                    sum += near.distance * near.distance / 96;
                    bat_finder_nearest(finder, d.points + 2 * i, &near);
                    /* 3 sigma a coordinate; of 10,800 samples a few are farther out than that. */
                    worst_raw = fmax(worst_raw, near.distance / (1 + 4.5 * fmax(sigmas[n], report.noise)));
                }
                bat_finder_free(finder);
                worst_rms = fmax(worst_rms, sqrt(sum) / (0.8 + 0.6 * sigmas[n]));
                bat_curve_free(now);
                bat_curve_free(curve);
                drawn_free(&d);
            }
        }
        print_message("noise %.1f px: to the true shape %.2f of the bar at most, rms %.2f of its bar, "
                      "samples %.3f of theirs\n",
                      sigmas[n], worst, worst_rms, worst_raw);
        assert_true(worst <= 1);
        assert_true(worst_rms <= 1);
        assert_true(worst_raw <= 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fifty_redraws), cmocka_unit_test(one_stretch_twenty_times),
        cmocka_unit_test(same_stroke_five_times), cmocka_unit_test(plain_stroke_over_busy_stretch),
        cmocka_unit_test(noise_is_not_drawn)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
