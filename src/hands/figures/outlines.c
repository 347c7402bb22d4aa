#include "hands/figures/outlines.h"

#include "base/real.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDES_MAX = 1000, EIGHTHS = 8 };

static const double CORNER = 1e-3;   /* radians: tangents that turn by more are a corner */
static const double NOTHING = 1e-12; /* of the sides: what rounding leaves of one */

/* Cubics one after another; each begins where the one before ended. */
typedef struct outline {
    double *points;
    int segments;
} outline;

static void line_to(outline *o, double x, double y) {
    double *p = o->points + 6 * o->segments++;
    for (int k = 1; k <= 3; k++) {
        p[2 * k] = k == 3 ? x : p[0] + (x - p[0]) * k / 3;
        p[2 * k + 1] = k == 3 ? y : p[1] + (y - p[1]) * k / 3;
    }
}

/* An eighth of an ellipse from `from` eighths on, about a middle. */
static void eighth(outline *o, const double middle[2], const double half[2], int from) {
    const double handle = 4.0 / 3 * bat_sin(BAT_PI / 16) / bat_cos(BAT_PI / 16);
    double *p = o->points + 6 * o->segments++;
    for (int k = 0; k < 2; k++) {
        const double angle = (from + k) * BAT_PI / 4, c = bat_cos(angle), s = bat_sin(angle);
        const double turn = k == 0 ? handle : -handle;
        double *end = p + 6 * k, *other = p + 2 + 2 * k;
        if (k == 1) end[0] = middle[0] + half[0] * c, end[1] = middle[1] + half[1] * s;
        other[0] = middle[0] + half[0] * (c - turn * s), other[1] = middle[1] + half[1] * (s + turn * c);
    }
}

static bat_status finish(outline *o, bat_curve **out) {
    memcpy(o->points + 6 * o->segments, o->points, 2 * sizeof *o->points);
    const bat_status status = bat_curve_from_bezier(2, 3, true, o->segments, o->points, CORNER, 0, out, NULL);
    free(o->points);
    return status;
}

static bool begin(outline *o, int segments, double x, double y) {
    *o = (outline){.points = malloc((6 * (size_t)segments + 2) * sizeof *o->points)};
    if (o->points) o->points[0] = x, o->points[1] = y;
    return o->points != NULL;
}

bat_status bat_figure_rectangle(const double box[4], double radius, bat_curve **out) {
    const double w = fabs(box[2] - box[0]), h = fabs(box[3] - box[1]);
    const double x[2] = {fmin(box[0], box[2]), fmax(box[0], box[2])};
    const double y[2] = {fmin(box[1], box[3]), fmax(box[1], box[3])};
    outline o;
    if (!(w > 0 && h > 0)) return BAT_COUNT;
    const double r = fmin(fmax(radius, 0), 0.5 * fmin(w, h));
    if (!begin(&o, 4 + EIGHTHS, x[0] + r, y[0])) return BAT_MEMORY;
    for (int k = 0; k < 4; k++) { /* the corner at which side k ends, clockwise on the screen */
        const int right = k == 0 || k == 1, low = k == 1 || k == 2;
        const double middle[2] = {x[right] + (right ? -r : r), y[low] + (low ? -r : r)}, half[2] = {r, r};
        const double *at = o.points + 6 * o.segments;
        const double to[2] = {k % 2 == 0 ? middle[0] : x[right], k % 2 == 0 ? y[low] : middle[1]};
        if (bat_hypot(at[0] - to[0], at[1] - to[1]) > NOTHING * (w + h)) line_to(&o, to[0], to[1]);
        for (int i = 0; i < 2 && r > 0; i++) eighth(&o, middle, half, 6 + 2 * k + i);
    }
    return finish(&o, out);
}

bat_status bat_figure_ellipse(const double box[4], bat_curve **out) {
    const double half[2] = {0.5 * fabs(box[2] - box[0]), 0.5 * fabs(box[3] - box[1])};
    const double middle[2] = {0.5 * box[0] + 0.5 * box[2], 0.5 * box[1] + 0.5 * box[3]};
    outline o;
    if (!(half[0] > 0 && half[1] > 0)) return BAT_COUNT;
    if (!begin(&o, EIGHTHS, middle[0] + half[0], middle[1])) return BAT_MEMORY;
    for (int i = 0; i < EIGHTHS; i++) eighth(&o, middle, half, i);
    return finish(&o, out);
}

bat_status bat_figure_polygon(const double middle[2], const double corner[2], int sides, bat_curve **out) {
    const double x = corner[0] - middle[0], y = corner[1] - middle[1];
    outline o;
    if (sides < 3 || sides > SIDES_MAX || !(bat_hypot(x, y) > 0)) return BAT_COUNT;
    if (!begin(&o, sides, corner[0], corner[1])) return BAT_MEMORY;
    for (int i = 1; i <= sides; i++) {
        const double c = bat_cos(2 * BAT_PI * i / sides), s = bat_sin(2 * BAT_PI * i / sides);
        line_to(&o, i < sides ? middle[0] + c * x - s * y : corner[0],
                i < sides ? middle[1] + s * x + c * y : corner[1]);
    }
    return finish(&o, out);
}
