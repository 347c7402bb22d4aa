/* Polylines: each span in as many even steps as Wang's bound asks for, halved first where its bends differ. */
#include <batten/relate.h>

#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EVEN_MAX = 8, DEPTH_MAX = 48 };

typedef struct flat {
    const bat_curve *curve;
    double tolerance;
    int size;
    size_t count, room;
    double *points, *u;
} flat;

static bat_status put(flat *f, double u, const double *point) {
    if (f->count == f->room) {
        if (f->room >= BAT_POINTS_MAX) return BAT_COUNT;
        const size_t room = 2 * f->room + 64, size = (size_t)f->size;
        double *points = realloc(f->points, room * size * sizeof *points);
        if (points) f->points = points;
        double *more = points ? realloc(f->u, room * sizeof *more) : NULL;
        if (!more) return BAT_MEMORY;
        f->u = more, f->room = room;
    }
    f->u[f->count] = u;
    memcpy(f->points + f->count * (size_t)f->size, point, (size_t)f->size * sizeof *point);
    f->count++;
    return BAT_OK;
}

/* The points of a segment but its first. */
static bat_status walk(flat *f, const bat_segment *s, int depth) {
    const double steps = sqrt(bat_segment_bulge(s) / f->tolerance);
    if (steps > EVEN_MAX && depth < DEPTH_MAX) {
        bat_segment left, right;
        bat_segment_halve(s, &left, &right);
        const bat_status status = walk(f, &left, depth + 1);
        return status == BAT_OK ? walk(f, &right, depth + 1) : status;
    }
    const int n = steps > 1 ? (int)ceil(fmin(steps, EVEN_MAX)) : 1;
    for (int i = 1; i < n; i++) {
        bat_segment rest;
        bat_segment_part(s, (double)i / n, 1, &rest);
        const bat_status status = put(f, rest.from, rest.b);
        if (status != BAT_OK) return status;
    }
    return put(f, s->to, s->b + s->degree * s->size);
}

bat_status bat_curve_flatten(const bat_curve *curve, double tolerance, size_t *count, double **points,
                             double **u) {
    if (!curve || !count || !points || !(tolerance > 0)) return BAT_ARGUMENT;
    if (bat_segments_hide(curve, tolerance)) return BAT_TOLERANCE;
    bat_segment *all;
    int segments;
    bat_status status = bat_segments_of(curve, &segments, &all);
    if (status != BAT_OK) return status;
    flat f = {.curve = curve, .tolerance = tolerance, .size = bat_curve_dimension(curve)};
    status = put(&f, all[0].from, all[0].b);
    for (int i = 0; i < segments && status == BAT_OK; i++) status = walk(&f, &all[i], 0);
    free(all);
    if (status != BAT_OK) {
        free(f.points), free(f.u);
        return status;
    }
    *count = f.count, *points = f.points;
    if (u)
        *u = f.u;
    else
        free(f.u);
    return BAT_OK;
}
