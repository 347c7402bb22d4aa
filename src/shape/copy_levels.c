/* Levels of one shape put onto another curve: the domains are mapped onto each other, the details are splines of
 * three coordinates that go along, and where the knots allow it they are the very same. */
#include "shape/levels.h"

#include "curve/curve.h"

#include <batten/refine.h>

#include <stdlib.h>
#include <string.h>

static const double NEAR = 1e-9; /* of the domain: knots this close are one */

/* The details of a level as a curve over the domain of `onto`, its knots on those of `below` where they are near. */
static bat_status detail_curve(const bat_level *level, const bat_curve *below, bat_curve **out) {
    const bat_curve *curve = level->curve;
    const double *from = bat_curve_knots(curve), *near = bat_curve_knots(below);
    int count = bat_curve_knot_count(curve), others = bat_curve_knot_count(below);
    double a[2], b[2];
    bat_curve_domain(curve, a);
    bat_curve_domain(below, b);
    double *knots = malloc((size_t)count * sizeof *knots), reach = NEAR * (b[1] - b[0]);
    if (!knots) return BAT_MEMORY;
    for (int i = 0, k = 0; i < count; i++) {
        double u = b[0] + (from[i] - a[0]) / (a[1] - a[0]) * (b[1] - b[0]);
        while (k + 1 < others && fabs(near[k + 1] - u) <= fabs(near[k] - u)) k++;
        knots[i] = fabs(near[k] - u) <= reach ? near[k] : u;
    }
    bat_curve *made = NULL;
    bat_status status = bat_curve_create(curve->degree, 3, curve->closed, level->count, knots, level->details,
                                         &made);
    free(knots);
    if (status == BAT_OK && curve->closed && !below->closed) {
        bat_curve *opened = NULL;
        status = bat_curve_open_at(made, b[0], &opened);
        bat_curve_free(made);
        made = opened;
    }
    if (status == BAT_OK) *out = made;
    return status;
}

/* All knots of both, each as often as where it is more often; on a closed curve one period. Returns how many. */
static int united(const bat_curve *below, const bat_curve *detail, double *out) {
    const double *a = bat_curve_knots(below), *b = bat_curve_knots(detail);
    int p = below->degree, inner_a = bat_curve_knot_count(below), inner_b = bat_curve_knot_count(detail),
        n = 0;
    double domain[2];
    bat_curve_domain(below, domain);
    /* What lies outside the domain, and the ends of an open one, are the curve's own. */
    for (int i = 0, k = 0; i < inner_a || k < inner_b;) {
        if (k < inner_b && (b[k] >= domain[1] || (below->closed ? b[k] < domain[0] : b[k] <= domain[0]))) {
            k++;
        } else if (k == inner_b || (i < inner_a && a[i] <= b[k])) {
            if (k < inner_b && a[i] == b[k]) k++;
            out[n++] = a[i++];
        } else if (n >= p && out[n - p] == b[k]) { /* often enough */
            k++;
        } else {
            out[n++] = b[k++];
        }
    }
    return n;
}

static bat_status copy_level(bat_shape *shape, const bat_level *from) {
    const bat_curve *below = bat_shape_curve(shape, shape->count);
    bat_curve *detail = NULL, *fitting = NULL;
    bat_status status = detail_curve(from, below, &detail);
    if (status != BAT_OK) return status;
    size_t room = (size_t)(bat_curve_knot_count(below) + bat_curve_knot_count(detail));
    double *knots = malloc(room * sizeof *knots);
    status = knots ? bat_shape_add_level(shape, united(below, detail, knots), knots, NULL, NULL) : BAT_MEMORY;
    if (status == BAT_OK) {
        bat_level *level = &shape->levels[shape->count - 1];
        int count = bat_curve_knot_count(level->curve);
        bool same = detail->degree == level->curve->degree && detail->closed == level->curve->closed &&
                    bat_curve_refine(detail, count, bat_curve_knots(level->curve), &fitting) == BAT_OK;
        for (int i = 0; i < level->count; i++) {
            double *d = level->details + 3 * i;
            if (same)
                memcpy(d, bat_curve_points(fitting) + 3 * i, 3 * sizeof *d);
            else
                bat_curve_eval(detail, level->nodes[i], 0, d);
            if (bat_shape_flat(shape)) d[2] = 0;
        }
        level->gain = from->gain;
        level->muted = from->muted;
        status = bat_level_build(level, bat_shape_curve(shape, shape->count - 1));
    }
    free(knots);
    bat_curve_free(detail);
    bat_curve_free(fitting);
    return status;
}

bat_status bat_shape_copy_levels(const bat_shape *from, const bat_curve *onto, bat_shape **out) {
    if (!from || !onto || !out) return BAT_ARGUMENT;
    if (onto->dimension != from->base->dimension) return BAT_DIMENSION;
    bat_shape_options options = from->options;
    options.has_first = options.has_reference = false;
    bat_shape *shape = NULL;
    bat_status status = bat_shape_create(onto, &options, &shape);
    for (int l = 0; l < from->count && status == BAT_OK; l++) status = copy_level(shape, &from->levels[l]);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    *out = shape;
    return BAT_OK;
}
