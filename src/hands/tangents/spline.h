/* Inside: a spline's points, counted as everything inside is. */
#ifndef BATTEN_SRC_SPLINE_H
#define BATTEN_SRC_SPLINE_H

#include "base/count.h"
#include "base/vec.h"
#include <batten/tangents.h>

static inline int bat_spline_count(const bat_spline *spline) { return bat_count_inside(spline->count); }

/* The direction that is given at a point, of length 1; false: none is. */
static inline bool bat_spline_direction(const bat_spline *spline, int point, vec *out) {
    *out = (vec){0, 0, 0};
    if (spline->tangents)
        *out = vec_unit(vec_load(spline->tangents + point * spline->dimension, spline->dimension));
    return vec_norm(*out) > 0;
}

/* The options as this version has them, whatever the caller's; NULL: the defaults. */
bat_status bat_tangents_options_read(const bat_tangents_options *given, bat_tangents_options *own);
/* A cubic curve whose direction is continuous as a spline that is the same to rounding; its arrays are in *block (free). The mode has to
 * honour directions: faithful or round. Where the third coordinate alone has a corner, its slope becomes the mean of both. BAT_DEGREE: another degree; BAT_TOLERANCE: a corner. O(count). */
bat_status bat_spline_through(const bat_curve *cubic, const bat_tangents_options *options, bat_spline *out,
                              void **block);

#endif
