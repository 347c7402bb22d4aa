#include "editor/edit/affine.h"
#include "base/real.h"
#include "format/svg/svg.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void bat_affine_translation(double dx, double dy, double out[6]) {
    memcpy(out, (double[]){1, 0, 0, 1, dx, dy}, 6 * sizeof *out);
}

void bat_affine_scaling(double sx, double sy, const double about[2], double out[6]) {
    memcpy(out, (double[]){sx, 0, 0, sy, about[0] - sx * about[0], about[1] - sy * about[1]},
           6 * sizeof *out);
}

void bat_affine_rotation(double radians, const double about[2], double out[6]) {
    double c = bat_cos(radians), s = bat_sin(radians);
    memcpy(out,
           (double[]){c, s, -s, c, about[0] - c * about[0] + s * about[1],
                      about[1] - s * about[0] - c * about[1]},
           6 * sizeof *out);
}

/* The rows of the matrix for a curve of that dimension. */
static void rows(const double *m, int dimension, double out[12]) {
    const double plane[12] = {m[0], m[2], m[4], m[1], m[3], m[5]};
    const double space[12] = {m[0], m[2], 0, m[4], m[1], m[3], 0, m[5], 0, 0, 1, 0};
    memcpy(out, dimension == 3 ? space : plane, sizeof space);
}

static bat_status image_path(const bat_object *object, const double *m, bat_object **out) {
    int count = bat_object_curve_count(object), made = 0;
    bat_curve **curves = calloc((size_t)count + 1, sizeof *curves);
    bat_status status = curves ? BAT_OK : BAT_MEMORY;
    double matrix[12];
    rows(m, bat_curve_dimension(bat_object_curve(object, 0)), matrix);
    while (made < count && status == BAT_OK) {
        status = bat_curve_transform(bat_object_curve(object, made), matrix, &curves[made]);
        if (status == BAT_OK) made++;
    }
    if (status == BAT_OK) status = bat_object_with_curves(object, count, curves, out);
    if (status != BAT_OK)
        while (made > 0) bat_curve_free(curves[--made]);
    free(curves);
    return status;
}

/* Levels go along with their curves; those that a matrix flattens stay plain curves. *path is replaced. */
static bat_status image_shapes(const bat_object *object, const double *m, bat_object **path) {
    double matrix[12], area = fabs(m[0] * m[3] - m[1] * m[2]), square = 0;
    for (int i = 0; i < 4; i++) square += m[i] * m[i];
    bool similar = fabs(square - 2 * area) <= 1e-12 * square; /* details need not be measured anew */
    rows(m, bat_curve_dimension(bat_object_curve(object, 0)), matrix);
    if (bat_curve_dimension(bat_object_curve(object, 0)) != 2) similar = false;
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        bat_shape *shape = NULL;
        bat_object *next = NULL;
        if (!bat_object_shape(object, i)) continue;
        bat_status status = bat_shape_copy(bat_object_shape(object, i), &shape);
        if (status == BAT_OK)
            status = similar ? bat_shape_transform(shape, matrix)
                             : bat_shape_reframe(shape, bat_shape_options_of(shape)->frame, matrix);
        if (status == BAT_OK) status = bat_object_with_shape(*path, i, shape, &next);
        if (status == BAT_OK) {
            bat_object_release(*path);
            *path = next;
            continue;
        }
        bat_shape_free(shape);
        if (status == BAT_MEMORY) return status;
    }
    return BAT_OK;
}

/* Same knots and points, but for rounding. */
static bool alike(const bat_curve *a, const bat_curve *b) {
    if (bat_curve_count(a) != bat_curve_count(b) || bat_curve_knot_count(a) != bat_curve_knot_count(b) ||
        bat_curve_closed(a) != bat_curve_closed(b))
        return false;
    double near = 1e-9 * bat_curve_size(b);
    for (int i = 0; i < 2 * bat_curve_count(a); i++)
        if (!(fabs(bat_curve_points(a)[i] - bat_curve_points(b)[i]) <= near)) return false;
    return true;
}

/* BAT_OK with *out NULL: its points do not give the image. */
static bat_status image_spline(const bat_object *object, const double *m, const bat_object *path,
                               bat_object **out) {
    bat_spline spline = *bat_object_spline(object);
    *out = NULL;
    if (spline.dimension != 2) return BAT_OK;
    size_t n = (size_t)spline.count;
    double *numbers = malloc(4 * n * sizeof *numbers);
    if (!numbers) return BAT_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const double *p = spline.points + 2 * i, *t = spline.tangents ? spline.tangents + 2 * i : NULL;
        numbers[2 * i] = m[0] * p[0] + m[2] * p[1] + m[4];
        numbers[2 * i + 1] = m[1] * p[0] + m[3] * p[1] + m[5];
        numbers[2 * (n + i)] = t ? m[0] * t[0] + m[2] * t[1] : 0;
        numbers[2 * (n + i) + 1] = t ? m[1] * t[0] + m[3] * t[1] : 0;
    }
    spline.points = numbers;
    if (spline.tangents) spline.tangents = numbers + 2 * n;
    bat_status status = bat_object_with_spline(object, &spline, out);
    free(numbers);
    if (status == BAT_MEMORY) return status;
    if (status != BAT_OK) *out = NULL; /* flattened to less than two points */
    if (*out && !alike(bat_object_curve(*out, 0), bat_object_curve(path, 0))) {
        bat_object_release(*out);
        *out = NULL;
    }
    return BAT_OK;
}

bat_status bat_affine_object(const bat_object *object, const double matrix[6], bool strokes,
                             bat_object **out) {
    if (bat_object_is_group(object)) return BAT_ARGUMENT;
    double at;
    int axis = bat_object_guide(object, &at);
    if (axis >= 0) /* upright or level whatever turns */
        return bat_object_with_guide(object, at * matrix[3 * axis] + matrix[4 + axis], out);
    if (bat_object_picture(object)) {
        double placed[6];
        bat_svg_compose(matrix, bat_object_matrix(object), placed);
        return bat_object_with_matrix(object, placed, out);
    }
    bat_object *made = NULL, *other = NULL;
    bat_status status = image_path(object, matrix, &made);
    if (status == BAT_OK && bat_object_spline(object)) {
        status = image_spline(object, matrix, made, &other);
        if (other) {
            bat_object_release(made);
            made = other;
        }
    }
    if (status == BAT_OK && bat_object_kind(object) == BAT_KIND_SHAPE)
        status = image_shapes(object, matrix, &made);
    double area = fabs(matrix[0] * matrix[3] - matrix[1] * matrix[2]);
    if (status == BAT_OK && strokes && area > 0 && fabs(area - 1) > 1e-12) {
        bat_style style = *bat_object_style(made);
        style.width = fmin(style.width * sqrt(area), BAT_COORDINATE_MAX);
        status = bat_object_with_style(made, &style, &other);
        if (status == BAT_OK) {
            bat_object_release(made);
            made = other;
        }
    }
    if (status != BAT_OK)
        bat_object_release(made);
    else
        *out = made;
    return status;
}
