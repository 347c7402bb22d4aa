/* How the surfaces of a relief follow from its base and details. */
#include "form/relief/relief.h"

#include <stdlib.h>
#include <string.h>

/* The points of `below` on the knots of `level`, as a surface. */
static bat_status refine(const bat_surface *below, const bat_surface *level, bat_surface **out) {
    bat_surface *tall = NULL;
    bat_status status = bat_surface_refine(below, BAT_U, bat_surface_knot_count(level, BAT_U),
                                           bat_surface_knots(level, BAT_U), &tall);
    if (status == BAT_OK)
        status = bat_surface_refine(tall, BAT_V, bat_surface_knot_count(level, BAT_V),
                                    bat_surface_knots(level, BAT_V), out);
    bat_surface_free(tall);
    return status;
}

/* A pole stays a point: refinement has moved its copies by rounding. */
static void close_poles(const bat_surface *surface, const int pole[BAT_EDGES], double *points) {
    for (int group = 0; group < BAT_EDGES; group++) {
        if (pole[group] != group) continue;
        const double *point = points + 3 * bat_edge_of(surface, group).first;
        for (int e = 0; e < BAT_EDGES; e++) {
            if (pole[e] != group) continue;
            const bat_edge edge = bat_edge_of(surface, e);
            for (size_t k = 0; k < edge.count; k++) {
                double *to = points + 3 * (edge.first + k * edge.step);
                if (to != point) memcpy(to, point, 3 * sizeof *to);
            }
        }
    }
}

bat_status bat_relief_build(bat_relief *relief, int level) {
    bat_relief_level *at = &relief->levels[level - 1];
    const double gain = bat_relief_loudness(at);
    const size_t n = bat_relief_points(at->surface);
    bat_surface *bare = NULL, *made = NULL;
    double *points = malloc(3 * n * sizeof *points);
    bat_status status = points ? refine(bat_relief_at(relief, level - 1), at->surface, &bare) : BAT_MEMORY;
    if (status == BAT_OK) {
        bat_surface_gather(bare, points);
        for (size_t i = 0; i < n; i++) {
            const double *d = at->details + 3 * i;
            double *p = points + 3 * i;
            if (d[0] == 0 && d[1] == 0 && d[2] == 0) continue;
            const vec v = vec_scale(bat_triad_to_world(&at->frames[i], d), gain);
            p[0] += v.x, p[1] += v.y, p[2] += v.z;
        }
        close_poles(at->surface, relief->pole, points);
        status = bat_surface_remade(at->surface, points, &made);
    }
    if (status == BAT_OK) {
        bat_surface_free(at->surface);
        at->surface = made;
    }
    bat_surface_free(bare);
    free(points);
    return status;
}

bat_status bat_relief_rebuild(bat_relief *relief, int level) {
    for (int l = level > 0 ? level : 1; l <= relief->count; l++) {
        bat_status status = l > level ? bat_relief_frames(relief, l, relief->levels[l - 1].frames) : BAT_OK;
        if (status == BAT_OK) status = bat_relief_build(relief, l);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}
