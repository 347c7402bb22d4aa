/* What the page paints of a curve: lines take three numbers a piece, cubics seven, and both are the curve. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include "editor/scene/path.h"

enum { POINTS = 7, LINE = 3, CUBIC = 7 };

static int painted(const double *points, bat_path *path) {
    bat_curve *curve = NULL;
    path->count = 0;
    assert_int_equal(bat_curve_from_bezier(2, 3, false, (POINTS - 1) / 3, points, 0, 0, &curve, NULL),
                     BAT_OK);
    bat_path_curve(path, curve);
    bat_curve_free(curve);
    assert_false(path->failed);
    return (int)path->count;
}

static void lines_are_painted_as_lines(void **unused) {
    (void)unused;
    bat_path path = {0};
    const double corner[POINTS][2] = {{-7.3, 16.1}, {0, 0}, {0, 0},        {3.7, 1e3 / 7},
                                      {0, 0},       {0, 0}, {1e4 / 3, 2.2}};
    for (int k = 0; k < 4; k++) { /* the middle of one piece or the other is moved, by little */
        double points[POINTS][2];
        for (int i = 0; i < POINTS; i++)
            for (int d = 0; d < 2; d++) {
                const double a = corner[i / 3 * 3][d], b = corner[i % 3 ? i / 3 * 3 + 3 : i][d];
                points[i][d] = a + (b - a) * (i % 3) / 3;
            }
        if (k & 1) points[1][0] += 1e-6;
        if (k & 2) points[5][1] -= 1e-6;
        const int expected = LINE + (k & 1 ? CUBIC : LINE) + (k & 2 ? CUBIC : LINE);
        assert_int_equal(painted(points[0], &path), expected);
        assert_true(path.data[expected - 2] == (float)(1e4 / 3) && path.data[expected - 1] == (float)2.2);
    }
    free(path.data);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_are_painted_as_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
