/* Expresses the details in other frames: the curves of all levels go where a matrix takes them, or stay. */
#include "hands/levels/shape.h"

#include "curve/curve.h"

#include <batten/refine.h>

#include <string.h>

/* The image's persistent pair of reference vectors, again at right angles. */
static void turn_reference(bat_shape_options *o, const double *matrix, int size) {
    vec t = vec_unit(bat_affine_turn(matrix, size, vec_load(o->reference_t, 3)));
    vec s = bat_affine_turn(matrix, size, vec_load(o->reference_s, 3));
    vec_store(t, o->reference_t);
    vec_store(vec_unit(vec_sub(s, vec_scale(t, vec_dot(s, t)))), o->reference_s);
    vec_store(vec_unit(bat_affine_turn(matrix, size, vec_load(o->first, 3))), o->first);
}

static bat_status reframe_level(bat_shape *shape, int l, const double *matrix) {
    bat_level *level = &shape->levels[l - 1];
    int size = shape->base->dimension;
    for (int i = 0; i < level->count; i++) { /* for now in the world's axes */
        double *d = level->details + 3 * i;
        vec v = bat_triad_to_world(&level->frames[i], d);
        vec_store(matrix ? bat_affine_turn(matrix, size, v) : v, d);
    }
    bat_status status = bat_shape_frames_of(shape, l, NULL);
    if (status != BAT_OK) return status;
    for (int i = 0; i < level->count; i++) {
        double *d = level->details + 3 * i;
        bat_triad_to_local(&level->frames[i], vec_load(d, 3), d);
        if (bat_shape_flat(shape)) d[2] = 0; /* not -0 */
    }
    return bat_level_build(level, bat_shape_curve(shape, l - 1));
}

bat_status bat_shape_reframe(bat_shape *shape, const double *matrix, bat_frame_rule rule) {
    if (!shape || (unsigned)rule > BAT_FRAMES_FIXED) return BAT_ARGUMENT;
    int size = shape->base->dimension;
    for (int i = 0; matrix && i < size * (size + 1); i++)
        if (!(fabs(matrix[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    if (matrix && !(fabs(bat_affine_determinant(matrix, size)) > 0)) return BAT_SINGULAR;
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    edited->options.frame = rule;
    if (matrix) {
        bat_curve *base;
        status = bat_curve_transform(edited->base, matrix, &base);
        if (status == BAT_OK) {
            bat_curve_free(edited->base);
            edited->base = base;
            turn_reference(&edited->options, matrix, size);
        }
    }
    memset(edited->holonomy, 0, sizeof edited->holonomy); /* the principal ones, whichever the details had */
    for (int l = 1; l <= edited->count && status == BAT_OK; l++) status = reframe_level(edited, l, matrix);
    edited->turned = false;
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

/* The details of `from` seen in the dimension of the shape, in the frames of its level. */
static void see_details(const bat_shape *shape, const bat_level *from, bat_level *level) {
    const bool flat = shape->base->dimension == 2;
    for (int i = 0; i < level->count; i++) {
        double *d = level->details + 3 * i;
        vec way = bat_triad_to_world(&from->frames[i], from->details + 3 * i);
        if (flat) way.z = 0;
        bat_triad_to_local(&level->frames[i], way, d);
        if (bat_shape_flat(shape)) d[2] = 0; /* not -0 */
    }
}

bat_status bat_shape_to_dimension(const bat_shape *shape, int dimension, bat_shape **out) {
    if (!shape || !out) return BAT_ARGUMENT;
    if (dimension != 2 && dimension != 3) return BAT_DIMENSION;
    bat_shape_options options = shape->options;
    bat_curve *base = NULL;
    bat_shape *made = NULL;
    options.has_first = options.has_reference = false;
    bat_status status = bat_curve_to_dimension(shape->base, dimension, &base);
    if (status == BAT_OK) status = bat_shape_create(base, &options, &made);
    bat_curve_free(base);
    for (int l = 0; l < shape->count && status == BAT_OK; l++) {
        const bat_level *from = &shape->levels[l];
        status = bat_shape_add_level(made, bat_curve_knot_count(from->curve), bat_curve_knots(from->curve),
                                     NULL, from->source);
        if (status != BAT_OK) break;
        made->levels[l].gain = from->gain;
        made->levels[l].muted = from->muted;
        see_details(made, from, &made->levels[l]);
        status = bat_level_build(&made->levels[l], bat_shape_curve(made, l));
    }
    if (status == BAT_OK)
        *out = made;
    else
        bat_shape_free(made);
    return status;
}
