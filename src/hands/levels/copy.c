/* Puts the levels of one shape onto another curve. The domains are mapped onto each other; the details are
 * splines of three coordinates that go along, and they stay exactly the same where the knots allow it. */
#include "hands/levels/shape.h"

#include "curve/curve.h"

#include <batten/refine.h>

#include <stdlib.h>
#include <string.h>

static const double NEAR = 1e-9; /* of the domain: knots this close are one */

double bat_knot_map_at(const bat_knot_map *map, double u) {
    int k = 0, last = map->count - 1;
    double turns = 0, whole = map->from[last] - map->from[0];
    if (map->closed) turns = floor((u - map->from[0]) / whole);
    u -= turns * whole;
    while (k + 1 < last && u >= map->from[k + 1]) k++;
    double a = map->from[k], h = map->from[k + 1] - a, slope = h > 0 ? (map->to[k + 1] - map->to[k]) / h : 1;
    return map->to[k] + (u - a) * slope + turns * (map->to[last] - map->to[0]);
}

/* A closed detail curve, turned so that it begins where the period of `below` does. */
static bat_status begin_at_seam(bat_curve **detail, const bat_curve *below) {
    const double *knots = bat_curve_knots(*detail);
    int n = (*detail)->count, first = 0;
    double period = knots[n] - knots[0], u = below->knots[below->degree];
    u -= floor((u - knots[0]) / period) * period;
    if (u - knots[0] <= NEAR * period || knots[n] - u <= NEAR * period) return BAT_OK;
    for (first = 0; knots[first] < u - NEAR * period; first++) {
    }
    bool there = knots[first] <= u + NEAR * period;
    bat_curve *cut, *turned;
    bat_status status = bat_curve_insert_knot(*detail, u, !there, &cut);
    if (status != BAT_OK) return status;
    status = bat_curve_rotate(cut, first, &turned);
    bat_curve_free(cut);
    if (status != BAT_OK) return status;
    bat_curve_free(*detail);
    *detail = turned;
    return BAT_OK;
}

/* Brings the first knot of a closed curve to that of `below`; knots near those of `below` become equal to
 * them. */
static bat_status snap(const bat_curve *detail, const bat_curve *below, bat_curve **out) {
    const double *from = bat_curve_knots(detail), *near = bat_curve_knots(below);
    int count = bat_curve_knot_count(detail), others = bat_curve_knot_count(below);
    double domain[2], shift = 0;
    bat_curve_domain(below, domain);
    double *knots = malloc((size_t)count * sizeof *knots), period = domain[1] - domain[0],
           reach = NEAR * period;
    if (!knots) return BAT_MEMORY;
    if (detail->closed) shift = rint((domain[0] - from[0]) / period) * period;
    for (int i = 0, k = 0; i < count; i++) {
        double u = from[i] + shift;
        while (k + 1 < others && fabs(near[k + 1] - u) <= fabs(near[k] - u)) k++;
        knots[i] = fabs(near[k] - u) <= reach ? near[k] : u;
    }
    bat_status status = bat_curve_create(3, detail->degree, detail->closed, (size_t)detail->count,
                                         bat_curve_points(detail), count, knots, out);
    free(knots);
    return status;
}

bat_status bat_detail_curve(const bat_curve *curve, const double *details, const bat_curve *below,
                            const bat_knot_map *map, bat_curve **out) {
    int count = bat_curve_knot_count(curve);
    double *knots = malloc((size_t)count * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (int i = 0; i < count; i++) knots[i] = bat_knot_map_at(map, bat_curve_knots(curve)[i]);
    bat_curve *mapped = NULL, *made = NULL;
    bat_status status = bat_curve_create(3, curve->degree, curve->closed, (size_t)curve->count, details,
                                         count, knots, &mapped);
    free(knots);
    if (status == BAT_OK && curve->closed) status = begin_at_seam(&mapped, below);
    if (status == BAT_OK) status = snap(mapped, below, &made);
    bat_curve_free(mapped);
    if (status == BAT_OK && curve->closed && !below->closed) {
        bat_curve *opened = NULL;
        status = bat_curve_open_at(made, below->knots[below->degree], &opened);
        bat_curve_free(made);
        made = opened;
    }
    if (status == BAT_OK) *out = made;
    return status;
}

int bat_detail_knots(const bat_curve *below, const bat_curve *detail, double *out) {
    const double *a = bat_curve_knots(below), *b = bat_curve_knots(detail);
    int p = below->degree, inner_a = bat_curve_knot_count(below), inner_b = bat_curve_knot_count(detail),
        n = 0;
    double domain[2];
    bat_curve_domain(below, domain);
    /* Knots outside the domain, and at the ends of an open one, are those of `below`. */
    for (int i = 0, k = 0; i < inner_a || k < inner_b;) {
        bool own = k == inner_b || (i < inner_a && a[i] <= b[k]);
        if (k < inner_b && (b[k] >= domain[1] || (below->closed ? b[k] < domain[0] : b[k] <= domain[0]) ||
                            (!own && n >= p && out[n - p] == b[k]))) {
            k++; /* outside, or often enough there */
        } else if (own) {
            if (k < inner_b && a[i] == b[k]) k++;
            out[n++] = a[i++];
        } else {
            out[n++] = b[k++];
        }
    }
    return n;
}

/* For each node of a level, the node of `from` that is mapped nearest to it; both ascend, except for a wrap
 * at a seam. */
static bat_status match(const bat_level *level, const bat_level *from, const bat_knot_map *map,
                        int *nearest) {
    const bat_curve *curve = level->curve;
    double *nodes = malloc((size_t)from->count * sizeof *nodes);
    double reach = NEAR * (curve->knots[curve->spread] - curve->knots[curve->degree]);
    int first = 0, low = 0, k = 0, m = from->count;
    if (!nodes) return BAT_MEMORY;
    for (int i = 0; i < m; i++) {
        nodes[i] = bat_curve_reduce(curve, bat_knot_map_at(map, from->nodes[i]));
        if (nodes[i] < nodes[low]) low = i;
    }
    for (int i = 0; i < level->count; i++)
        if (level->nodes[i] < level->nodes[first]) first = i;
    for (int j = 0; j < level->count; j++) {
        int i = (first + j) % level->count;
        double u = level->nodes[i] + reach;
        while (k + 1 < m && fabs(nodes[(low + k + 1) % m] - u) <= fabs(nodes[(low + k) % m] - u)) k++;
        nearest[i] = (low + k) % m;
    }
    free(nodes);
    return BAT_OK;
}

/* Whether a node lies in the piece that was drawn anew, and how far in: 0 to 1. */
static bool redrawn(const bat_knot_map *map, double u, double *depth) {
    double start = map->to[map->drawn], length = map->to[map->drawn + 1] - start, x = u - start;
    double period = map->to[map->count - 1] - map->to[0];
    if (map->closed) x -= floor(x / period) * period;
    *depth = length > 0 ? fmin(fmax(x / length, 0), 1) : 0;
    return x > 0 && x < length;
}

/* In space: outside the piece that was drawn anew, details stay as they lay; on it their turn passes from
 * that of one side to that of the other (math 3.4). */
static void keep_outside(bat_level *level, const bat_level *from, const bat_knot_map *map,
                         const int *nearest) {
    double angle[2] = {0, 0}, gap[2] = {INFINITY, INFINITY}, depth;
    double period = map->to[map->count - 1] - map->to[0];
    for (int i = 0; i < level->count; i++) {
        const bat_triad *old = &from->frames[nearest[i]], *fresh = &level->frames[i];
        if (redrawn(map, level->nodes[i], &depth)) continue;
        double turn = bat_atan2(vec_dot(old->s, fresh->r), vec_dot(old->s, fresh->s));
        for (int side = 0; side < 2; side++) {
            double x = side ? level->nodes[i] - map->to[map->drawn + 1]
                            : map->to[map->drawn] - level->nodes[i];
            if (map->closed) x -= floor(x / period) * period;
            if (x > -NEAR * period && x < gap[side]) gap[side] = x, angle[side] = turn;
        }
        bat_triad_turn_back(old, fresh, level->details + 3 * i);
    }
    if (isinf(gap[0])) angle[0] = angle[1];
    if (isinf(gap[1])) angle[1] = angle[0];
    double difference = remainder(angle[1] - angle[0], 2 * BAT_PI);
    for (int i = 0; i < level->count; i++) {
        if (!redrawn(map, level->nodes[i], &depth)) continue;
        double turn = angle[0] + difference * depth * depth * (3 - 2 * depth), *d = level->details + 3 * i;
        double c = bat_cos(turn), s = bat_sin(turn), b = c * d[1] - s * d[2];
        d[2] = s * d[1] + c * d[2];
        d[1] = b;
    }
}

/* Sets the sources, and does what the piece that was drawn anew asks for. */
static bat_status settle(bat_shape *shape, bat_level *level, const bat_level *from, const bat_knot_map *map) {
    int *nearest = malloc((size_t)level->count * sizeof *nearest);
    bat_status status = nearest ? match(level, from, map, nearest) : BAT_MEMORY;
    if (status == BAT_OK) {
        for (int i = 0; i < level->count; i++) level->source[i] = from->source[nearest[i]];
        status = bat_shape_frames_of(shape, shape->count, NULL);
    }
    if (status == BAT_OK && map->drawn >= 0 && shape->base->dimension == 3 &&
        shape->options.frame == BAT_FRAMES_RMF && shape->options.propagation == BAT_PROPAGATION_LOCAL)
        keep_outside(level, from, map, nearest);
    double depth;
    for (int i = 0; i < level->count && status == BAT_OK && map->drop; i++)
        if (redrawn(map, level->nodes[i], &depth)) memset(level->details + 3 * i, 0, 3 * sizeof(double));
    free(nearest);
    return status;
}

bat_status bat_detail_take(const bat_curve *detail, const bat_curve *fine, const double *nodes,
                           double *details) {
    bat_curve *fitting = NULL;
    bat_status status = BAT_KNOTS;
    if (detail->degree == fine->degree && detail->closed == fine->closed)
        status = bat_curve_refine(detail, bat_curve_knot_count(fine), bat_curve_knots(fine), &fitting);
    if (status == BAT_MEMORY) return status;
    for (int i = 0; i < fine->count && !fitting; i++) bat_curve_eval(detail, nodes[i], 0, details + 3 * i);
    if (fitting) memcpy(details, bat_curve_points(fitting), 3 * (size_t)fine->count * sizeof *details);
    bat_curve_free(fitting);
    return BAT_OK;
}

static bat_status copy_level(bat_shape *shape, const bat_level *from, const bat_knot_map *map) {
    const bat_curve *below = bat_shape_curve(shape, shape->count);
    bat_curve *detail = NULL;
    bat_status status = bat_detail_curve(from->curve, from->details, below, map, &detail);
    if (status != BAT_OK) return status;
    size_t room = (size_t)(bat_curve_knot_count(below) + bat_curve_knot_count(detail));
    double *knots = malloc(room * sizeof *knots);
    status = knots ? bat_shape_add_level(shape, bat_detail_knots(below, detail, knots), knots, NULL, NULL)
                   : BAT_MEMORY;
    if (status == BAT_OK) {
        bat_level *level = &shape->levels[shape->count - 1];
        level->gain = from->gain;
        level->muted = from->muted;
        status = bat_detail_take(detail, level->curve, level->nodes, level->details);
        for (int i = 0; i < level->count && bat_shape_flat(shape); i++) level->details[3 * i + 2] = 0;
        if (status == BAT_OK) status = settle(shape, level, from, map);
        if (status == BAT_OK) status = bat_level_build(level, below);
    }
    free(knots);
    bat_curve_free(detail);
    return status;
}

bat_status bat_shape_copy_mapped(const bat_shape *from, const bat_curve *onto,
                                 const bat_shape_options *options, const bat_knot_map *map, bat_shape **out) {
    bat_shape *shape = NULL;
    bat_status status = bat_shape_create(onto, options, &shape);
    for (int l = 0; l < from->count && status == BAT_OK; l++)
        status = copy_level(shape, &from->levels[l], map);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    *out = shape;
    return BAT_OK;
}

bat_status bat_shape_copy_levels(const bat_shape *from, const bat_curve *onto, bat_shape **out) {
    if (!from || !onto || !out) return BAT_ARGUMENT;
    if (onto->dimension != from->base->dimension) return BAT_DIMENSION;
    bat_shape_options options = from->options;
    options.has_first = options.has_reference = false;
    bat_knot_map map = {.count = 2, .drawn = -1, .closed = from->base->closed};
    bat_curve_domain(from->base, map.from);
    bat_curve_domain(onto, map.to);
    return bat_shape_copy_mapped(from, onto, &options, &map, out);
}
