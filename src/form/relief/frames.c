/* Frames of a surface at the nodes of a level, and which surface carries them (math 8). */
#include "form/relief/relief.h"

#include <stdlib.h>

static const double INSIDE = 0.01;   /* of a span: how far beside a pole its normals are taken */
static const double FOLDED = 0.1;    /* of level 0's area: a surface that has less carries no frame */
static const double PARALLEL = 1e-9; /* sine of the angle between S_u and S_v that counts as none */

void bat_relief_nodes(const bat_surface *surface, int direction, double *out) {
    bat_curve_greville(&surface->axis[direction], out);
}

/* The symmetric frame of two tangents. False: they span no plane. */
static bool frame_of(const double *tangents, bat_triad *out) {
    const vec a = vec_unit(vec_load(tangents, 3)), b = vec_unit(vec_load(tangents + 3, 3));
    const vec cross = vec_cross(a, b);
    if (!(vec_norm(cross) > PARALLEL)) return false;
    const vec n = vec_unit(cross), t = vec_unit(vec_sub(a, vec_cross(n, b)));
    *out = (bat_triad){t, vec_cross(n, t), n};
    return true;
}

static double area_of(const double *tangents) {
    return vec_norm(vec_cross(vec_load(tangents, 3), vec_load(tangents + 3, 3)));
}

/* u or v moved a little towards the middle of the domain; closed: onwards. */
static double inward(const bat_surface *surface, int direction, double at) {
    const bat_curve *axis = &surface->axis[direction];
    double domain[2];
    bat_curve_domain(axis, domain);
    int spans = 0;
    for (int i = axis->degree; i < axis->spread; i++) spans += axis->knots[i + 1] > axis->knots[i];
    const double step = INSIDE * (domain[1] - domain[0]) / spans;
    return axis->closed || at < domain[0] + (domain[1] - domain[0]) / 2 ? at + step : at - step;
}

/* The frame at a place; where the tangents span no plane, that just beside it, or else the world's. */
static bat_triad frame_at(const bat_surface *surface, double u, double v, const double *tangents) {
    bat_triad frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double beside[9];
    if (frame_of(tangents, &frame)) return frame;
    bat_surface_eval(surface, inward(surface, 0, u), inward(surface, 1, v), 1, beside);
    frame_of(beside + 3, &frame);
    return frame;
}

/* The nodes of a level, and what a surface below gives there. */
typedef struct nodes {
    size_t count[2];
    double *at[2];  /* u, v: one block with `values` */
    double *values; /* S, S_u, S_v of each pair */
} nodes;

static bat_status nodes_make(const bat_surface *fine, nodes *out) {
    for (int d = 0; d < 2; d++) out->count[d] = (size_t)fine->axis[d].count;
    const size_t pairs = out->count[0] * out->count[1];
    out->at[0] = malloc((out->count[0] + out->count[1] + 9 * pairs) * sizeof(double));
    if (!out->at[0]) return BAT_MEMORY;
    out->at[1] = out->at[0] + out->count[0];
    out->values = out->at[1] + out->count[1];
    for (int d = 0; d < 2; d++) bat_relief_nodes(fine, d, out->at[d]);
    return BAT_OK;
}

static bat_status nodes_eval(const bat_surface *surface, const nodes *n) {
    return bat_surface_eval_grid(surface, n->count[0], n->at[0], n->count[1], n->at[1], 1, n->values);
}

/* Along the edges of a pole, just inside: the mean of the normals, and the first frame's leg. */
static bat_triad pole_frame(const bat_relief *relief, int level, int group, const nodes *n) {
    const bat_relief_level *at = &relief->levels[level - 1];
    bat_triad first = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vec sum = {0, 0, 0};
    bool any = false;
    for (int e = 0; e < BAT_EDGES; e++) {
        if (relief->pole[e] != group) continue;
        const size_t corner = bat_edge_of(at->surface, e).first;
        const bat_surface *surface = bat_relief_at(relief, at->source[corner]);
        const int across = e / 2, along = 1 - across;
        const double edge = n->at[across][e % 2 ? n->count[across] - 1 : 0];
        const double inside = inward(surface, across, edge);
        for (size_t k = 0; k < n->count[along]; k++) {
            double values[9];
            bat_triad frame;
            const double place = n->at[along][k];
            bat_surface_eval(surface, across ? place : inside, across ? inside : place, 1, values);
            if (!frame_of(values + 3, &frame)) continue;
            if (!any) first = frame, any = true;
            sum = vec_add(sum, frame.r);
        }
    }
    if (!(vec_norm(sum) > PARALLEL)) return first;
    const vec normal = vec_unit(sum);
    vec leg = vec_reject(first.t, normal);
    leg = vec_norm(leg) > PARALLEL ? vec_unit(leg) : vec_any_normal(normal);
    return (bat_triad){leg, vec_cross(normal, leg), normal};
}

static void set_poles(const bat_relief *relief, int level, const nodes *n, bat_triad *out) {
    const bat_surface *surface = relief->levels[level - 1].surface;
    for (int group = 0; group < BAT_EDGES; group++) {
        if (relief->pole[group] != group) continue;
        const bat_triad frame = pole_frame(relief, level, group, n);
        for (int e = 0; e < BAT_EDGES; e++) {
            if (relief->pole[e] != group) continue;
            const bat_edge edge = bat_edge_of(surface, e);
            for (size_t k = 0; k < edge.count; k++) out[edge.first + k * edge.step] = frame;
        }
    }
}

bat_status bat_relief_frames(const bat_relief *relief, int level, bat_triad *out) {
    const bat_relief_level *at = &relief->levels[level - 1];
    nodes n;
    bat_status status = nodes_make(at->surface, &n);
    if (status != BAT_OK) return status;
    const size_t pairs = n.count[0] * n.count[1];
    for (int l = 0; l < level && status == BAT_OK; l++) {
        bool used = false;
        for (size_t i = 0; i < pairs && !used; i++) used = at->source[i] == l;
        if (!used) continue;
        const bat_surface *surface = bat_relief_at(relief, l);
        status = nodes_eval(surface, &n);
        for (size_t i = 0; i < pairs && status == BAT_OK; i++)
            if (at->source[i] == l)
                out[i] = frame_at(surface, n.at[0][i / n.count[1]], n.at[1][i % n.count[1]],
                                  n.values + 9 * i + 3);
    }
    if (status == BAT_OK) set_poles(relief, level, &n, out);
    free(n.at[0]);
    return status;
}

bat_status bat_relief_sources(const bat_relief *relief, int level, int *out) {
    nodes n;
    bat_status status = nodes_make(relief->levels[level - 1].surface, &n);
    if (status != BAT_OK) return status;
    const size_t pairs = n.count[0] * n.count[1];
    double *least = malloc(pairs * sizeof *least);
    if (!least) status = BAT_MEMORY;
    for (int l = 0; l < level && status == BAT_OK; l++) {
        status = nodes_eval(bat_relief_at(relief, l), &n);
        for (size_t i = 0; i < pairs && status == BAT_OK; i++) {
            const double area = area_of(n.values + 9 * i + 3);
            if (l == 0) least[i] = FOLDED * area;
            if (l == 0 || area >= least[i]) out[i] = l;
        }
    }
    free(least);
    free(n.at[0]);
    return status;
}
