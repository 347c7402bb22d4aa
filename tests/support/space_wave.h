/* A curve in space that the tests of strokes share, in a view that is tilted and turned. */
#ifndef BATTEN_TESTS_SPACE_WAVE_H
#define BATTEN_TESTS_SPACE_WAVE_H

#include "support/editing.h"

#include <math.h>

enum { POINTS = 11 };

/* Along x at y = 400, with waves: y to its sides, z up and down; both in step, it is planar. */
static inline bat_curve *wave(double sides, double heights, double late) {
    double points[3 * POINTS], knots[POINTS + 4];
    bat_curve *curve = NULL;
    for (int i = 0; i < POINTS; i++) {
        const double at[3] = {200 + 60 * i, 400 + sides * sin(i), heights * sin(i + late)};
        memcpy(points + 3 * i, at, sizeof at);
    }
    for (int i = 0; i < POINTS + 4; i++) knots[i] = i < 4 ? 0 : i >= POINTS ? POINTS - 3 : i - 3;
    assert_int_equal(bat_curve_create(3, 3, false, POINTS, points, POINTS + 4, knots, &curve), BAT_OK);
    return curve;
}

/* The curve alone, in a view that is tilted and turned so often by 15 degrees. */
static inline bat_editor *tilted_with(bat_curve *curve, int tilts, int turns) {
    bat_editor *editor = editor_with(1, &curve);
    for (int i = 0; i < tilts; i++) assert_int_equal(bat_editor_command(editor, "orbit-up"), BAT_OK);
    for (int i = 0; i < turns; i++) assert_int_equal(bat_editor_command(editor, "orbit-left"), BAT_OK);
    return editor;
}

#endif
