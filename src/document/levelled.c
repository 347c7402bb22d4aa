#include "document/levelled.h"
#include "curve/curve.h"

#include "document/digest.h"

#include <math.h>

static uint64_t digest_doubles(uint64_t digest, const double *numbers, int count) {
    for (int i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

uint64_t bat_digest_shape(uint64_t digest, const bat_shape *shape) {
    const bat_shape_options *o = bat_shape_options_of(shape);
    digest = bat_digest_number(digest, (uint64_t)o->frame | (uint64_t)o->nodes << 8 |
                                           (uint64_t)o->propagation << 16 | (uint64_t)o->has_first << 24 |
                                           (uint64_t)o->has_reference << 25);
    if (o->has_reference) {
        digest = digest_doubles(digest, o->reference_t, 3);
        digest = digest_doubles(digest, o->reference_s, 3);
    } else {
        digest = digest_doubles(digest, o->first, 3);
    }
    digest = bat_digest_curve(digest, bat_shape_curve(shape, 0));
    digest = bat_digest_number(digest, (uint64_t)bat_shape_levels(shape));
    for (int l = 1; l <= bat_shape_levels(shape); l++) {
        const bat_curve *curve = bat_shape_curve(shape, l);
        int count = bat_point_count(curve), knots = bat_curve_knot_count(curve);
        digest = bat_digest_number(digest, (uint64_t)knots);
        digest = digest_doubles(digest, bat_curve_knots(curve), knots);
        digest = digest_doubles(digest, bat_shape_details(shape, l), 3 * count);
        for (int i = 0; i < count; i++)
            digest = bat_digest_number(digest, (uint64_t)bat_shape_source(shape, l)[i]);
        digest = bat_digest_double(digest, bat_shape_gain(shape, l));
        digest = bat_digest_number(digest, bat_shape_is_muted(shape, l));
    }
    return digest;
}

static bat_status again(const bat_shape *shape, bat_shape **out) {
    bat_status status = bat_shape_create(bat_shape_curve(shape, 0), bat_shape_options_of(shape), out);
    for (int l = 1; l <= bat_shape_levels(shape) && status == BAT_OK; l++) {
        const bat_curve *curve = bat_shape_curve(shape, l);
        status = bat_shape_add_level(*out, bat_curve_knot_count(curve), bat_curve_knots(curve),
                                     bat_shape_details(shape, l), bat_shape_source(shape, l));
        if (status == BAT_OK && bat_shape_gain(shape, l) != 1)
            status = bat_shape_set_gain(*out, l, bat_shape_gain(shape, l));
        if (status == BAT_OK && bat_shape_is_muted(shape, l)) status = bat_shape_set_muted(*out, l, true);
    }
    return status;
}

const char *bat_shape_check_kept(const bat_shape *shape) {
    bat_shape *made = NULL;
    const char *wrong = NULL;
    bat_status status = again(shape, &made);
    if (status != BAT_OK && status != BAT_MEMORY) wrong = "a shape is not valid";
    if (status == BAT_OK) {
        const bat_curve *a = bat_shape_curve(shape, bat_shape_levels(shape)),
                        *b = bat_shape_curve(made, bat_shape_levels(made));
        double near = 1e-9 * bat_curve_size(b);
        bool same = bat_point_count(a) == bat_point_count(b);
        for (int i = 0; same && i < bat_point_count(a) * bat_curve_dimension(a); i++)
            same = fabs(bat_curve_points(a)[i] - bat_curve_points(b)[i]) <= near;
        if (!same) wrong = "the curve of a shape is not the one its levels give";
    }
    bat_shape_free(made);
    return wrong;
}
