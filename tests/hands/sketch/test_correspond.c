/* Which stretch a stroke is meant for: closed curves, figure eights, hairpins, where the points nearest to the stroke's
 * ends are often wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "support/sketch_cases.h"

#include "hands/sketch/correspond.h"

static bat_curve *eight(void) {
    double points[2 * 24], knots[25];
    for (int i = 0; i < 24; i++) {
        const double a = 2 * 3.14159265358979 * i / 24;
        points[2 * i] = 300 * sin(a), points[2 * i + 1] = 160 * sin(2 * a);
    }
    for (int i = 0; i < 25; i++) knots[i] = i;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 24, points, 25, knots, &curve), BAT_OK);
    return curve;
}

/* Two long sides 24 px apart, and the bend. */
static bat_curve *hairpin(void) {
    double points[2 * 23], knots[27];
    for (int i = 0; i < 23; i++) {
        points[2 * i] = i < 11 ? 40 * i : i == 11 ? 420 : 40 * (22 - i);
        points[2 * i + 1] = i < 11 ? 0 : i == 11 ? 12 : 24;
    }
    for (int i = 0; i < 27; i++) knots[i] = i < 4 ? 0 : i > 22 ? 20 : i - 3;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 23, points, 27, knots, &curve), BAT_OK);
    return curve;
}

/* Strokes of which the stretch and direction are known; how many come back right. */
static int right_ones(const bat_curve *curve, uint64_t seed, int cases, double height) {
    random_source r = {seed};
    bat_stroke_track track;
    assert_int_equal(bat_track_create(curve, &track), BAT_OK);
    int right = 0;
    for (int n = 0; n < cases; n++) {
        const double T = track.end - track.start, part = T * random_between(&r, 0.1, 0.5);
        const double u0 = track.start + random_unit(&r) * (bat_curve_is_closed(curve) ? T : T - part);
        const bool back = random_unit(&r) < 0.5;
        drawn d = draw_along(&r, curve, back ? u0 + part : u0, back ? u0 : u0 + part, 150, height, 0.5);
        const double origin[2] = {0, 0};
        const bat_clean_options options = {.scale = 1, .origin = origin, .tolerance = 1};
        bat_clean clean;
        assert_int_equal(bat_clean_stroke(&d.stroke, &options, &clean), BAT_OK);
        const bat_correspondence found = bat_correspond(&track, &clean, 0);
        const double from = bat_track_s(&track, u0), to = bat_track_s(&track, u0 + part);
        double off0 = fabs(found.start - from), off1 = fabs(found.end - to);
        if (bat_curve_is_closed(curve)) {
            off0 = fabs(remainder(off0, track.length)), off1 = fabs(remainder(off1, track.length));
            if (fabs(found.end - found.start - (to - from)) > 0.3 * track.length) off0 = INFINITY;
        }
        right += found.reversed == back && off0 < 40 && off1 < 40;
        bat_clean_free(&clean);
        drawn_free(&d);
    }
    bat_track_free(&track);
    return right;
}

static void closed_curves_and_eights(void **state) {
    (void)state;
    random_source r = {1};
    int right = 0;
    for (int i = 0; i < 6; i++) {
        bat_curve *curve = ring_curve(&r, 12, 40);
        right += right_ones(curve, 50 + (uint64_t)i, 10, 20);
        bat_curve_free(curve);
    }
    bat_curve *curve = eight();
    const int eights = right_ones(curve, 70, 60, 20);
    print_message("right: %d of 60 on closed curves, %d of 60 on a figure eight\n", right, eights);
    assert_int_equal(right, 60);
    assert_int_equal(eights, 60);
    bat_curve_free(curve);
}

static void hairpins(void **state) {
    (void)state;
    bat_curve *curve = hairpin();
    const int right = right_ones(curve, 90, 60, 8);
    print_message("right: %d of 60 on a hairpin\n", right);
    assert_true(right >= 54);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(closed_curves_and_eights),
                                       cmocka_unit_test(hairpins)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
