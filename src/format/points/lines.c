#include "format/points/lines.h"

#include <batten/bezier.h>
#include <batten/relate.h>
#include <batten/document.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_line_of_points(int dimension, size_t count, const double *points, bat_curve **out) {
    const size_t width = (size_t)dimension;
    if (count < 2) return BAT_COUNT;
    if (count > (size_t)BAT_POINTS_MAX) return BAT_COUNT;
    const bool closed = count > 3 &&
                        memcmp(points, points + (count - 1) * width, width * sizeof *points) == 0;
    if (closed) count--;
    const size_t knot_count = closed ? count + 1 : count + 2;
    double *knots = malloc(knot_count * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (size_t i = 0; i < knot_count; i++)
        knots[i] = closed ? (double)i : fmin(fmax((double)i - 1, 0), (double)count - 1);
    const bat_status status = bat_curve_create(dimension, 1, closed, count, points, (int)knot_count, knots,
                                               out);
    free(knots);
    return status;
}

bat_status bat_points_of_line(const bat_curve *curve, double tolerance, size_t *count, double **points) {
    if (bat_curve_degree(curve) > 1) return bat_curve_flatten(curve, tolerance, count, points, NULL);
    const size_t given = bat_curve_count(curve), width = (size_t)bat_curve_dimension(curve);
    const bool closed = bat_curve_is_closed(curve);
    double *all = malloc((given + closed) * width * sizeof *all);
    if (!all) return BAT_MEMORY;
    memcpy(all, bat_curve_points(curve), given * width * sizeof *all);
    if (closed) memcpy(all + given * width, all, width * sizeof *all);
    *points = all, *count = given + closed;
    return BAT_OK;
}

double bat_lines_tolerance(const bat_document *document) {
    double box[4];
    bat_document_bounds(document, box);
    const double side = fmax(box[2] - box[0], box[3] - box[1]);
    return side > 0 ? 1e-4 * side : 1e-4;
}

size_t bat_lines_count(const bat_document *document, bool *space) {
    size_t count = 0;
    *space = false;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int k = 0; k < bat_object_curve_count(object); k++, count++)
            *space = *space || bat_curve_dimension(bat_object_curve(object, k)) > 2;
    }
    return count;
}
