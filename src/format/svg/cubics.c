#include "format/svg/cubics.h"

#include "base/matrix.h"
#include "base/real.h"

#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/refine.h>

#include <math.h>

/* Relative to the curve's size: the error allowed in the cubics for a curve above degree 3. */
static const double CUBICS = 1e-7;
/* The same: how far handles may be off the thirds of a line, which is rounding. */
static const double THIRDS = 1e-12;
/* Where no precision is asked for: how far points may move in document units, of the curve's size and of its shortest leg; legs below that share
 * of the size are rounding. */
static const double UNSEEN = 1e-3, SHARE = 1e-5, LEG = 1e-3, NOTHING = 1e-9;

void bat_svg_write_pair(bat_text *text, const double *p) {
    bat_text_number(text, p[0]);
    bat_text_string(text, " ");
    bat_text_number(text, p[1]);
}

/* The shortest leg of the cubics' control polygons that is no rounding. */
static double shortest_leg(const double *points, int count, int dimension, double extent) {
    double least = INFINITY;
    for (int i = 0; i < count; i++, points += 4 * dimension)
        for (int k = 0; k < 3; k++) {
            const double *p = points + k * dimension, *q = p + dimension;
            const double leg = bat_hypot(q[0] - p[0], q[1] - p[1]);
            if (leg > NOTHING * extent && leg < least) least = leg;
        }
    return least;
}

/* How many times a number is finer than the units when it is rounded: so coarse a power of ten that no point moves by more
 * than `precision`; 0: numbers stay as they are. */
static double fineness(double precision) {
    if (!(precision > 0)) return 0;
    double fine = 1;
    while (fine <= 1e15 && sqrt(0.5) > precision * fine) fine *= 10;
    return fine <= 1e15 ? fine : 0;
}

/* The least factor by which the matrix scales a distance. */
static double least_scale(const double m[6]) {
    const double area = bat_matrix_area(m), sum = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
    const double most = sqrt(0.5 * (sum + sqrt(fmax(0, (sum - 2 * area) * (sum + 2 * area)))));
    return most > 0 ? area / most : 0;
}

bat_status bat_svg_cubics_make(const bat_curve *curve, const double m[6], double precision,
                               bat_svg_cubics *out) {
    bat_curve *own = NULL;
    double rows[12], scale = 1; /* of its units, a document unit in them */
    bat_status status = BAT_OK;
    if (m) {
        bat_matrix_rows(m, bat_curve_dimension(curve), rows);
        status = bat_curve_transform(curve, rows, &own);
        if (status != BAT_OK) return status;
        curve = own;
        scale = least_scale(m);
    }
    bat_svg_cubics made = {.dimension = bat_curve_dimension(curve),
                           .lines = bat_curve_degree(curve) == 1,
                           .extent = bat_curve_size(curve)};
    const double tolerance = CUBICS * made.extent;
    status = bat_curve_to_cubics(curve, tolerance > 0 ? tolerance : 1, &made.count, &made.points);
    bat_curve_free(own);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    if (precision < 0)
        precision = fmin(fmin(UNSEEN, SHARE * made.extent / scale),
                         LEG * shortest_leg(made.points, made.count, made.dimension, made.extent) / scale);
    made.fine = fineness(precision * scale);
    *out = made;
    return BAT_OK;
}

void bat_svg_cubics_free(bat_svg_cubics *cubics) { bat_free(cubics->points); }

void bat_svg_round(const bat_svg_cubics *cubics, const double *point, double out[2]) {
    const double fine = cubics->fine;
    for (int i = 0; i < 2; i++) {
        const double large = point[i] * fine;
        out[i] = fine > 0 && fabs(large) < 1e15 ? round(large) / fine + 0.0
                                                : point[i]; /* + 0.0: no negative zero */
    }
}

bool bat_svg_cubic_is_line(const bat_svg_cubics *cubics, int i) {
    const int dimension = cubics->dimension;
    const double *p = bat_svg_cubic(cubics, i), *end = p + (ptrdiff_t)3 * dimension;
    if (cubics->lines) return true;
    for (int k = 1; k < 3; k++) /* its handles at the thirds */
        for (int c = 0; c < 2; c++)
            if (!(fabs(p[k * dimension + c] - (p[c] + k * (end[c] - p[c]) / 3)) <= THIRDS * cubics->extent))
                return false;
    return true;
}

bool bat_svg_is_closing(const bat_svg_cubics *cubics, int i, const double from[2], const double start[2]) {
    return bat_svg_cubic_is_line(cubics, i) && (from[0] != start[0] || from[1] != start[1]);
}

void bat_svg_write_cubic(bat_text *text, const bat_svg_cubics *cubics, int i, const double end[2]) {
    const double *p = bat_svg_cubic(cubics, i);
    const bool line = bat_svg_cubic_is_line(cubics, i);
    bat_text_string(text, line ? "L" : "C");
    for (int k = 1; k < 3 && !line; k++) {
        double handle[2];
        bat_svg_round(cubics, p + (ptrdiff_t)k * cubics->dimension, handle);
        bat_svg_write_pair(text, handle);
        bat_text_string(text, " ");
    }
    bat_svg_write_pair(text, end);
}
