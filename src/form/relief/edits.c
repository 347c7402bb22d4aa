/* Edits of a relief: each is made on a copy, which takes the relief's place when all has gone well. */
#include "form/relief/relief.h"

#include "curve/curve.h"

#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 20 };

static bat_status check(const bat_relief *relief, int level) {
    if (!relief || level < 0 || level > relief->count) return BAT_ARGUMENT;
    return level > 0 && bat_relief_loudness(&relief->levels[level - 1]) == 0 ? BAT_STATE : BAT_OK;
}

/* A change of what is not in the points: `change` is made on a copy, then levels from `from` on are built. */
static bat_status settle(bat_relief *relief, bat_relief *edited, int from, bat_status status) {
    if (status == BAT_OK) status = bat_relief_rebuild(edited, from);
    if (status == BAT_OK)
        bat_relief_adopt(relief, edited);
    else
        bat_relief_free(edited);
    return status;
}

static bat_status move_base(bat_relief *relief, const double *deltas) {
    const size_t n = 3 * bat_relief_points(relief->base);
    double *points = malloc(n * sizeof *points);
    bat_surface *made = NULL;
    if (!points) return BAT_MEMORY;
    bat_surface_gather(relief->base, points);
    for (size_t i = 0; i < n; i++) points[i] += deltas[i];
    bat_status status = bat_surface_remade(relief->base, points, &made);
    free(points);
    if (status != BAT_OK) return status;
    bat_surface_free(relief->base);
    relief->base = made;
    return BAT_OK;
}

static void move_details(bat_relief_level *level, const double *deltas) {
    const size_t n = bat_relief_points(level->surface);
    const double gain = bat_relief_loudness(level);
    for (size_t i = 0; i < n; i++) {
        double local[3];
        const vec delta = vec_load(deltas + 3 * i, 3);
        if (delta.x == 0 && delta.y == 0 && delta.z == 0) continue;
        bat_triad_to_local(&level->frames[i], delta, local);
        for (int c = 0; c < 3; c++) level->details[3 * i + (size_t)c] += local[c] / gain;
    }
}

/* deltas: one for each control point of the level; those of a pole become their mean. */
static bat_status move_all(bat_relief *relief, int level, double *deltas) {
    bat_relief *edited = NULL;
    bat_status status = bat_relief_copy(relief, &edited);
    if (status != BAT_OK) return status;
    bat_pole_mean(bat_relief_at(edited, level), edited->pole, deltas);
    if (level == 0)
        status = move_base(edited, deltas);
    else
        move_details(&edited->levels[level - 1], deltas);
    if (status == BAT_OK && level > 0 &&
        !bat_are_coordinates(edited->levels[level - 1].details,
                             3 * bat_relief_points(edited->levels[level - 1].surface)))
        status = BAT_NUMBER;
    return settle(relief, edited, level, status);
}

static bat_status no_deltas(const bat_relief *relief, int level, double **out) {
    *out = calloc(3 * bat_relief_points(bat_relief_at(relief, level)), sizeof **out);
    return *out ? BAT_OK : BAT_MEMORY;
}

bat_status bat_relief_move(bat_relief *relief, int level, size_t count, const size_t *index,
                           const double *deltas) {
    bat_status status = check(relief, level);
    if (status != BAT_OK) return status;
    if (count == 0) return BAT_OK;
    if (count > BAT_POINTS_MAX) return BAT_COUNT;
    if (!index || !deltas) return BAT_ARGUMENT;
    const size_t n = bat_relief_points(bat_relief_at(relief, level));
    for (size_t i = 0; i < count; i++)
        if (index[i] >= n) return BAT_ARGUMENT;
    if (!bat_are_coordinates(deltas, 3 * count)) return BAT_NUMBER;
    double *all;
    status = no_deltas(relief, level, &all);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++) all[3 * index[i] + c] += deltas[3 * i + c];
    status = move_all(relief, level, all);
    free(all);
    return status;
}

/* ---- a point ---- */

/* N_i(u) M_k(v) of each control point, in `weights`, all 0 at first; a pole is one control point, whose sum of weights
 * all its copies get. Returns the sum of squares over control points. */
static double weigh(const bat_relief *relief, const bat_surface *surface, double u, double v,
                    double *weights) {
    const size_t columns = (size_t)surface->axis[1].count;
    double basis[2][BAT_DEGREE_MAX + 1], square = 0, sum[BAT_EDGES] = {0};
    int first[2];
    bat_curve_basis(&surface->axis[0], u, &first[0], basis[0]);
    bat_curve_basis(&surface->axis[1], v, &first[1], basis[1]);
    for (int a = 0; a <= surface->axis[0].degree; a++)
        for (int b = 0; b <= surface->axis[1].degree; b++) {
            const int i = (first[0] + a) % surface->axis[0].count,
                      k = (first[1] + b) % surface->axis[1].count;
            weights[(size_t)i * columns + (size_t)k] += basis[0][a] * basis[1][b];
        }
    for (int e = 0; e < BAT_EDGES; e++) { /* corners that two edges share count once: taken, then cleared */
        if (relief->pole[e] < 0) continue;
        const bat_edge edge = bat_edge_of(surface, e);
        for (size_t k = 0; k < edge.count; k++) {
            double *w = &weights[edge.first + k * edge.step];
            sum[relief->pole[e]] += *w, *w = 0;
        }
    }
    const size_t n = bat_relief_points(surface);
    for (size_t i = 0; i < n; i++) square += weights[i] * weights[i];
    for (int e = 0; e < BAT_EDGES; e++) {
        if (relief->pole[e] < 0) continue;
        const bat_edge edge = bat_edge_of(surface, e);
        for (size_t k = 0; k < edge.count; k++) weights[edge.first + k * edge.step] = sum[relief->pole[e]];
        if (relief->pole[e] == e) square += sum[e] * sum[e];
    }
    return square;
}

static bat_status drag(bat_relief *relief, int level, double u, double v, const double *delta) {
    const bat_surface *surface = bat_relief_at(relief, level);
    const size_t n = bat_relief_points(surface);
    double *deltas, *weights = calloc(n, sizeof *weights);
    bat_status status = weights ? no_deltas(relief, level, &deltas) : BAT_MEMORY;
    if (status == BAT_OK) {
        const double square = weigh(relief, surface, u, v, weights);
        for (size_t i = 0; i < n; i++)
            for (size_t c = 0; c < 3; c++) deltas[3 * i + c] = weights[i] / square * delta[c];
        status = move_all(relief, level, deltas);
        free(deltas);
    }
    free(weights);
    return status;
}

static bat_status check_drag(const bat_relief *relief, int level, double u, double v, const double *delta) {
    bat_status status = check(relief, level);
    if (status != BAT_OK) return status;
    if (!delta) return BAT_ARGUMENT;
    return isfinite(u) && isfinite(v) && bat_are_coordinates(delta, 3) ? BAT_OK : BAT_NUMBER;
}

bat_status bat_relief_drag(bat_relief *relief, int level, double u, double v, const double delta[3]) {
    bat_status status = check_drag(relief, level, u, v, delta);
    return status == BAT_OK ? drag(relief, level, u, v, delta) : status;
}

static double missing(const bat_relief *relief, double u, double v, const double target[3], double gap[3]) {
    double at[3];
    bat_surface_eval(bat_relief_at(relief, relief->count), u, v, 0, at);
    for (int c = 0; c < 3; c++) gap[c] = target[c] - at[c];
    return vec_norm(vec_load(gap, 3));
}

bat_status bat_relief_drag_finest(bat_relief *relief, int level, double u, double v, const double delta[3],
                                  double tolerance, double *left) {
    bat_status status = check_drag(relief, level, u, v, delta);
    if (status != BAT_OK) return status;
    if (!(tolerance >= 0)) return BAT_NUMBER;
    bat_relief *edited = NULL;
    status = bat_relief_copy(relief, &edited);
    if (status != BAT_OK) return status;
    double target[3], gap[3], rest, best = INFINITY;
    bat_surface_eval(bat_relief_at(relief, relief->count), u, v, 0, target);
    for (int c = 0; c < 3; c++) target[c] += delta[c];
    rest = missing(edited, u, v, target, gap);
    for (int round = 0; round < ROUNDS && rest > tolerance && rest < best && status == BAT_OK; round++) {
        best = rest;
        status = drag(edited, level, u, v, gap);
        rest = missing(edited, u, v, target, gap);
    }
    if (status == BAT_OK && rest > tolerance) status = BAT_TOLERANCE;
    if (left && (status == BAT_OK || status == BAT_TOLERANCE)) *left = rest;
    if (status == BAT_OK)
        bat_relief_adopt(relief, edited);
    else
        bat_relief_free(edited);
    return status;
}

/* ---- a line ---- */

static bool has_knots(const bat_curve *axis, const bat_curve *line) {
    const int count = bat_curve_knot_count(axis);
    return bat_curve_knot_count(line) == count &&
           memcmp(bat_curve_knots(line), bat_curve_knots(axis), (size_t)count * sizeof(double)) == 0;
}

bat_status bat_relief_redraw(bat_relief *relief, int level, bat_direction direction, double at,
                             const bat_curve *line, const bat_surface_redraw_options *options,
                             double *weights, bat_surface_redraw_report *report) {
    bat_status status = check(relief, level);
    if (status != BAT_OK) return status;
    if (!line || (unsigned)direction > BAT_V) return BAT_ARGUMENT;
    const bat_surface *old = bat_relief_at(relief, level);
    const bat_curve *along = &old->axis[direction == BAT_U ? 1 : 0];
    if (bat_curve_degree(line) == along->degree && bat_curve_is_closed(line) == along->closed &&
        !has_knots(along, line))
        return BAT_KNOTS;
    bat_surface *fresh = NULL;
    status = bat_surface_redraw(old, direction, at, line, options, &fresh, weights, report);
    if (status != BAT_OK) return status;
    const size_t n = 3 * bat_relief_points(old);
    double *before = malloc(2 * n * sizeof *before);
    if (before) {
        bat_surface_gather(old, before);
        bat_surface_gather(fresh, before + n);
        for (size_t i = 0; i < n; i++) before[n + i] -= before[i];
    }
    status = before ? move_all(relief, level, before + n) : BAT_MEMORY;
    free(before);
    bat_surface_free(fresh);
    return status;
}

/* ---- the equaliser ---- */

static bat_status set_level(bat_relief *relief, int level, double gain, bool muted) {
    bat_relief *edited = NULL;
    bat_status status = bat_relief_copy(relief, &edited);
    if (status != BAT_OK) return status;
    edited->levels[level - 1].gain = gain;
    edited->levels[level - 1].muted = muted;
    return settle(relief, edited, level, BAT_OK);
}

bat_status bat_relief_set_gain(bat_relief *relief, int level, double gain) {
    if (!relief || level < 1 || level > relief->count) return BAT_ARGUMENT;
    if (!(fabs(gain) <= 1e6)) return BAT_NUMBER;
    return set_level(relief, level, gain, relief->levels[level - 1].muted);
}

bat_status bat_relief_set_muted(bat_relief *relief, int level, bool muted) {
    if (!relief || level < 1 || level > relief->count) return BAT_ARGUMENT;
    return set_level(relief, level, relief->levels[level - 1].gain, muted);
}

/* ---- affine images ---- */

/* The details of a level, turned by the matrix, in the frames that the new surfaces give. */
static bat_status turn_level(bat_relief *relief, int level, const double *matrix) {
    bat_relief_level *at = &relief->levels[level - 1];
    const size_t n = bat_relief_points(at->surface);
    bat_triad *fresh = malloc(n * sizeof *fresh);
    bat_status status = fresh ? bat_relief_frames(relief, level, fresh) : BAT_MEMORY;
    for (size_t i = 0; i < n && status == BAT_OK; i++) {
        double *d = at->details + 3 * i;
        bat_triad_to_local(&fresh[i], bat_affine_turn(matrix, 3, bat_triad_to_world(&at->frames[i], d)), d);
    }
    if (status != BAT_OK) {
        free(fresh);
        return status;
    }
    free(at->frames);
    at->frames = fresh;
    bat_pole_mean(at->surface, relief->pole, at->details);
    return bat_are_coordinates(at->details, 3 * n) ? bat_relief_build(relief, level) : BAT_NUMBER;
}

bat_status bat_relief_transform(bat_relief *relief, const double *matrix) {
    if (!relief || !matrix) return BAT_ARGUMENT;
    bat_relief *edited = NULL;
    bat_surface *image = NULL;
    bat_status status = bat_relief_copy(relief, &edited);
    if (status != BAT_OK) return status;
    status = bat_surface_transform(edited->base, matrix, &image);
    if (status == BAT_OK) {
        bat_surface_free(edited->base);
        edited->base = image;
    }
    for (int l = 1; l <= edited->count && status == BAT_OK; l++) status = turn_level(edited, l, matrix);
    return settle(relief, edited, edited->count, status);
}
