/* A point put on a spline of even curvature: the curve has a summit more, and moves. */
#include "hands/tangents/even_insert.h"
#include "curve/curve.h"
#include "base/vec.h"
#include "hands/tangents/spline.h"
#include <batten/bezier.h>
#include <batten/relate.h>

#include <stdlib.h>
#include <string.h>

static vec mix(vec a, vec b, double t) { return vec_add(vec_scale(a, 1 - t), vec_scale(b, t)); }

/* Where among the points a new one belongs that lies at t on a piece: before or after the point of the piece. */
static int place_of(const bat_spline *s, const bat_joint *joints, int segment, double t) {
    int kept = -1, last = 0, of = s->closed ? segment : segment + 1, total = 0;
    for (int i = 0; i < bat_spline_count(s); i++) total += !joints[i].dropped;
    for (int i = 0; i < bat_spline_count(s); i++) {
        if (joints[i].dropped) continue;
        if (++kept == of) last = i;
    }
    if (total == 2) return s->closed ? last + 1 : last; /* between the two */
    /* The joint's derivatives are t and 1 - t times the same. */
    const double left = vec_norm(vec_load(joints[last].left, 3)),
                 right = vec_norm(vec_load(joints[last].right, 3));
    const bool before = t * (left + right) < left;
    if (!before) return last + 1;
    return s->closed && last == 0 ? bat_spline_count(s) : last;
}

static bat_spline with_point(const bat_spline *s, int at, vec point, double *block) {
    const size_t size = (size_t)s->dimension, count = s->count + 1, n = count * size;
    double *points = block, *tangents = block + n, *tension = block + 2 * n;
    for (size_t i = 0; i < s->count; i++) {
        const size_t to = i < (size_t)at ? i : i + 1;
        memcpy(points + to * size, s->points + i * size, size * sizeof(double));
        if (s->tangents) memcpy(tangents + to * size, s->tangents + i * size, size * sizeof(double));
        for (size_t k = 0; k < 2; k++) tension[2 * to + k] = s->tension ? s->tension[2 * i + k] : 1;
    }
    double all[3];
    vec_store(point, all);
    memcpy(points + (size_t)at * size, all, size * sizeof *all);
    tension[2 * at] = tension[2 * at + 1] = 1;
    return (bat_spline){s->dimension, s->closed, count, points, tangents, tension};
}

bat_status bat_even_insert(const bat_spline *spline, int segment, double t,
                           const bat_tangents_options *options, bat_spline *out, void **block, int *index,
                           double *deviation) {
    bat_joint *joints = malloc((spline->count + 1) * sizeof *joints);
    double *cubics = NULL, *room = NULL;
    int segments = 0;
    bat_curve *before = NULL, *after = NULL;
    bat_apart apart = {0};
    bat_spline longer = *spline;
    bat_status status = joints ? bat_tangents(spline, options, joints, &segments, &cubics, &before)
                               : BAT_MEMORY;
    if (status == BAT_OK && segment >= segments) status = BAT_ARGUMENT;
    if (status == BAT_OK) {
        const size_t count = spline->count + 1;
        room = calloc(2 * count * (size_t)spline->dimension + 2 * count, sizeof *room);
        if (!room) status = BAT_MEMORY;
    }
    if (status == BAT_OK) {
        vec c[4];
        for (int j = 0; j < 4; j++)
            c[j] = vec_load(cubics + (4 * segment + j) * spline->dimension, spline->dimension);
        const vec a = mix(c[0], c[1], t), b = mix(c[1], c[2], t), d = mix(c[2], c[3], t);
        *index = place_of(spline, joints, segment, t);
        longer = with_point(spline, *index, mix(mix(a, b, t), mix(b, d, t), t), room);
        status = bat_tangents(&longer, options, joints, NULL, NULL, &after);
    }
    if (status == BAT_OK && joints[*index].dropped) status = BAT_ARGUMENT; /* too near to another point */
    if (status == BAT_OK && deviation) {
        status = bat_curve_hausdorff(before, after, 1e-6 * bat_curve_size(before), &apart);
        if (status == BAT_TOLERANCE) status = BAT_OK; /* the best found */
        *deviation = apart.distance;
    }
    if (status == BAT_OK)
        *out = longer, *block = room;
    else
        free(room);
    free(joints);
    bat_free(cubics);
    bat_curve_free(before);
    bat_curve_free(after);
    return status;
}
