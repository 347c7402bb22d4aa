/* label: slow. A thousand strokes over the timing, one after the other: time never runs back; and as a hand draws them: met where they
 * rise, with few knots, and nothing moves that is far from them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/camera.h>
#include "support/rounds.h"
#include "support/timing.h"

enum { RUNS = ROUNDS_OF(1000) };

static void a_thousand_strokes_never_run_back(void **state) {
    (void)state;
    random_source r = {3};
    bat_camera *camera = along(&r, false);
    for (int n = 0; n < RUNS; n++) {
        double stroke[16];
        const size_t count = (size_t)random_int(&r, 2, 8);
        for (size_t i = 0; i < 2 * count; i++) stroke[i] = random_between(&r, -0.2, 1.2);
        assert_int_equal(bat_camera_retime(camera, count, stroke), BAT_OK);
        never_falls(camera);
        if (n % 100) continue;
        double last = 0;
        for (int i = 0; i <= 500; i++) {
            const double now = share_at(camera, i / 500.0);
            assert_true(now >= last - 1e-15);
            last = now;
        }
    }
    bat_camera_free(camera);
}

/* Strokes as a hand draws them, one after the other: never falling, met where they rise, with few knots, and what is
 * far from the last one stays. */
static void a_thousand_drawn_strokes(void **state) {
    (void)state;
    random_source r = {33};
    bat_camera *camera = along(&r, false);
    enum { N = 40, FEW = 30 };
    int few = 0;
    double worst = 0, moved = 0;
    for (int n = 0; n < RUNS; n++) {
        double stroke[2 * N], before[101];
        if (n % 4 == 0) assert_int_equal(bat_camera_set_timing(camera, 4, &(bat_function){0, NULL}), BAT_OK);
        for (int i = 0; i <= 100; i++) before[i] = share_at(camera, 0.01 * i);
        const double from = random_between(&r, 0, 0.7), width = random_between(&r, 0.1, 0.95 - from);
        const double aside = random_between(&r, -0.05, 0.05), start = share_at(camera, from) + aside;
        const double rise = random_between(&r, 0, 1.5), bow = random_between(&r, -0.5, 0.5);
        for (int i = 0; i < N; i++) {
            const double x = (double)i / (N - 1);
            stroke[2 * i] = from + width * x;
            stroke[2 * i + 1] = start + width * rise * (x + bow * x * (1 - x));
            stroke[2 * i + 1] += random_between(&r, -0.001, 0.001);
        }
        assert_int_equal(bat_camera_retime(camera, N, stroke), BAT_OK);
        never_falls(camera);
        for (int i = N / 5; i < N - N / 5; i++) {
            const double wanted = fmin(fmax(stroke[2 * i + 1], 0), 1);
            worst = fmax(worst, fabs(share_at(camera, stroke[2 * i]) - wanted));
        }
        few += bat_curve_knot_count(bat_camera_timing(camera)->curve) <= FEW;
        const double end = stroke[2 * N - 1];
        for (int i = 0; i <= 100; i++) {
            const double t = 0.01 * i, now = share_at(camera, t);
            const bool far = t < from - 0.12           ? before[i + 12] < start - 0.01
                             : t > from + width + 0.12 ? before[i - 12] > end + 0.01
                                                       : false;
            if (far) moved = fmax(moved, fabs(now - before[i]));
        }
    }
    print_message("off by %g at most; %d of %d with few knots; aside moved by %g\n", worst, few, RUNS, moved);
    assert_true(worst < 0.01 && few >= 0.85 * RUNS && moved < 1e-12);
    bat_camera_free(camera);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_thousand_strokes_never_run_back),
                                       cmocka_unit_test(a_thousand_drawn_strokes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
