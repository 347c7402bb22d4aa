/* Edits of a shape: each is made on a copy, which takes the shape's place when all has gone well. */
#include "hands/levels/shape.h"

#include "curve/curve.h"
#include "curve/frames/walk.h"

#include <stdlib.h>

static bat_status check(const bat_shape *shape, int level) {
    return !shape || level < 0 || level > shape->count ? BAT_ARGUMENT : BAT_OK;
}

static bool nothing(const double *v, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (v[i] != 0) return false;
    return true;
}

bat_status bat_shape_move_all(bat_shape *shape, int level, int first, int count, const double *deltas) {
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    if (edited->turned) status = bat_shape_fold(edited, true);
    if (status == BAT_OK) status = bat_level_add(edited, level, first, count, deltas, 1);
    if (status == BAT_OK) status = bat_points_check(edited->base);
    if (status == BAT_OK) status = bat_shape_rebuild(edited, level);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

bat_status bat_level_check(const bat_shape *shape, int level, int first, size_t many, const double *deltas,
                           bool *idle) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    if (many > BAT_POINTS_MAX) return BAT_COUNT;
    const bat_curve *curve = bat_shape_curve(shape, level);
    int count = (int)many;
    if (!deltas || first < 0 || first >= curve->count || count < 1 || count > curve->count ||
        (!curve->closed && first + count > curve->count))
        return BAT_ARGUMENT;
    size_t numbers = (size_t)count * (size_t)curve->dimension;
    if (!bat_are_coordinates(deltas, numbers)) return BAT_NUMBER;
    if (level > 0 && bat_level_gain(&shape->levels[level - 1]) == 0) return BAT_STATE;
    *idle = nothing(deltas, numbers);
    return BAT_OK;
}

bat_status bat_shape_move_many(bat_shape *shape, int level, int first, size_t many, const double *deltas) {
    bool idle;
    bat_touch *touch;
    bat_status status = bat_level_check(shape, level, first, many, deltas, &idle);
    if (status != BAT_OK || idle) return status;
    int count = (int)many;
    status = bat_touch_begin(shape, level, first, count, &touch);
    if (status != BAT_OK) return status;
    status = touch ? bat_touch_apply(touch, deltas) : bat_shape_move_all(shape, level, first, count, deltas);
    bat_touch_free(touch);
    return status;
}

bat_status bat_shape_move(bat_shape *shape, int level, int index, const double *delta) {
    return bat_shape_move_many(shape, level, index, 1, delta);
}

bat_status bat_level_pull(const bat_shape *shape, int level, double u, const double *delta, int *first,
                          int *count, double *deltas) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    if (!delta) return BAT_ARGUMENT;
    const bat_curve *curve = bat_shape_curve(shape, level);
    int p = curve->degree, size = curve->dimension, n = curve->count;
    if (!isfinite(u) || !bat_are_coordinates(delta, (size_t)size)) return BAT_NUMBER;
    double basis[BAT_DEGREE_MAX + 1], weight[BAT_DEGREE_MAX + 1] = {0}, square = 0;
    bat_curve_basis(curve, u, first, basis);
    /* A closed curve of few points meets one of them more than once. */
    *count = p + 1 < n ? p + 1 : n;
    for (int i = 0; i <= p; i++) weight[i % *count] += basis[i];
    for (int i = 0; i < *count; i++) square += weight[i] * weight[i];
    for (int i = 0; i < *count; i++)
        for (int d = 0; d < size; d++) deltas[i * size + d] = weight[i] / square * delta[d];
    return BAT_OK;
}

bat_status bat_shape_drag(bat_shape *shape, int level, double u, const double *delta) {
    double deltas[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    int first, count;
    bat_status status = bat_level_pull(shape, level, u, delta, &first, &count, deltas);
    return status == BAT_OK ? bat_shape_move_many(shape, level, first, (size_t)count, deltas) : status;
}

static bat_status set_level(bat_shape *shape, int level, double gain, bool muted) {
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    if (edited->turned) status = bat_shape_fold(edited, true);
    edited->levels[level - 1].gain = gain;
    edited->levels[level - 1].muted = muted;
    if (status == BAT_OK) status = bat_shape_rebuild(edited, level);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

bat_status bat_shape_set_gain(bat_shape *shape, int level, double gain) {
    if (check(shape, level) != BAT_OK || level == 0) return BAT_ARGUMENT;
    if (!(fabs(gain) <= 1e6)) return BAT_NUMBER;
    return set_level(shape, level, gain, shape->levels[level - 1].muted);
}

bat_status bat_shape_set_muted(bat_shape *shape, int level, bool muted) {
    if (check(shape, level) != BAT_OK || level == 0) return BAT_ARGUMENT;
    return set_level(shape, level, shape->levels[level - 1].gain, muted);
}

/* ---- whole-curve transforms ---- */

double bat_affine_determinant(const double *m, int size) {
    if (size == 2) return m[0] * m[4] - m[1] * m[3];
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

vec bat_affine_turn(const double *m, int size, vec v) {
    if (size == 2) return (vec){m[0] * v.x + m[1] * v.y, m[3] * v.x + m[4] * v.y, v.z};
    return (vec){m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
                 m[8] * v.x + m[9] * v.y + m[10] * v.z};
}

static void turn_reference(bat_shape_options *o, const double *m, int size) {
    double *vectors[3] = {o->first, o->reference_t, o->reference_s};
    for (int i = 0; i < 3; i++)
        vec_store(vec_unit(bat_affine_turn(m, size, vec_load(vectors[i], 3))), vectors[i]);
}

bat_status bat_shape_transform(bat_shape *shape, const double *matrix) {
    if (!shape || !matrix) return BAT_ARGUMENT;
    int size = shape->base->dimension;
    if (!bat_are_coordinates(matrix, (size_t)(size * (size + 1)))) return BAT_NUMBER;
    double det = bat_affine_determinant(matrix, size);
    if (!(fabs(det) > 0)) return BAT_SINGULAR;
    double factor = size == 2 ? sqrt(fabs(det)) : bat_exp(bat_log(fabs(det)) / 3);
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    bat_curve *base;
    if (edited->turned) status = bat_shape_fold(edited, true);
    if (status == BAT_OK) status = bat_curve_transform(edited->base, matrix, &base);
    if (status == BAT_OK) {
        bat_curve_free(edited->base);
        edited->base = base;
        turn_reference(&edited->options, matrix, size);
        bat_frame_rule rule = edited->options.frame;
        for (int l = 0; l < edited->count; l++)
            for (int i = 0; i < edited->levels[l].count; i++) {
                double *d = edited->levels[l].details + 3 * i;
                if (rule == BAT_FRAMES_FIXED) { /* the world's axes do not turn: the detail does */
                    vec_store(bat_affine_turn(matrix, size, vec_load(d, 3)), d);
                    continue;
                }
                for (int k = 0; k < 3; k++) d[k] *= factor;
                /* A mirror image: r = t x s changes sides; in the plane s = t turned left does. */
                if (det < 0) {
                    if (size == 3)
                        d[2] = -d[2];
                    else if (rule == BAT_FRAMES_RMF)
                        d[1] = -d[1];
                }
            }
        for (int l = 0; l < BAT_LEVELS_MAX && det < 0; l++) edited->holonomy[l] = -edited->holonomy[l];
        status = bat_shape_rebuild(edited, 0);
    }
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

/* Whether a commit has anything to do; a base that has turned about gets a reference anew. */
static bool unsettled(const bat_shape *shape, bat_shape_options *options) {
    *options = shape->options;
    if (options->has_reference && shape->base->dimension == 3) {
        vec t = bat_frame_tangent(shape->base,
                                  bat_span(shape->base, shape->base->knots[shape->base->degree], -1), false);
        if (vec_dot(t, vec_unit(vec_load(options->reference_t, 3))) < -0.5) {
            bat_frame_options frames = bat_shape_frame_options(options, 0);
            vec_store(bat_frame_first(&frames, 3, t), options->reference_s);
            vec_store(t, options->reference_t);
            return true;
        }
    }
    return shape->turned;
}

bat_status bat_shape_settle(bat_shape *shape) {
    bat_shape_options options;
    if (!unsettled(shape, &options)) return BAT_OK;
    shape->options = options;
    return bat_shape_fold(shape, false);
}

bat_status bat_shape_commit(bat_shape *shape) {
    if (!shape) return BAT_ARGUMENT;
    bat_shape_options options;
    if (!unsettled(shape, &options)) return BAT_OK;
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    status = bat_shape_settle(edited);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}
