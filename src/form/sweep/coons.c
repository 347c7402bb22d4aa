/* Coons patches (Coons 1967; P&T 10.6): lines between opposite sides in both directions, less the bilinear patch of the
 * corners. Linear functions have their Greville abscissae as control points, so that all of it is exact. */
#include "base/vec.h"
#include "form/surface/surface.h"
#include "form/sweep/sections.h"

#include <batten/sweep.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 4 };
static const double rounding =
    1e-13; /* of the sides' size: what raising the degree moves an end by at most */

/* The end of a side that lies in a corner: corners are numbered u + 2 v, and side_of says which side of each direction. */
static const double *end_of(const bat_curve *side, int last) {
    return bat_curve_points(side) + (last ? 3 * (side->count - 1) : 0);
}

/* Where the sides meet in a corner, and how far they are apart. */
static vec corner(bat_curve *const sides[4], int u, int v, double *apart) {
    const bat_curve *along_u = sides[v ? BAT_SIDE_V1 : BAT_SIDE_V0],
                    *along_v = sides[u ? BAT_SIDE_U1 : BAT_SIDE_U0];
    const vec a = vec_load(end_of(along_u, u), 3), b = vec_load(end_of(along_v, v), 3);
    *apart = vec_norm(vec_sub(a, b));
    if (*apart <= rounding * (bat_curve_size(along_u) + bat_curve_size(along_v))) *apart = 0;
    return *apart > 0 ? vec_add(vec_scale(a, 0.5), vec_scale(b, 0.5)) : a;
}

static vec mix(double x, vec a, vec b) { return vec_add(vec_scale(a, 1 - x), vec_scale(b, x)); }

static void fill(bat_curve *const sides[4], const vec corners[CORNERS], const double *xi, const double *eta,
                 bat_surface *made) {
    const bat_curve *v0 = sides[BAT_SIDE_V0], *v1 = sides[BAT_SIDE_V1];
    const bat_curve *u0 = sides[BAT_SIDE_U0], *u1 = sides[BAT_SIDE_U1];
    for (int i = 0; i < v0->count; i++) {
        double *row = bat_surface_own_row(made, i);
        const vec low = vec_load(bat_curve_points(v0) + 3 * i, 3);
        const vec high = vec_load(bat_curve_points(v1) + 3 * i, 3);
        /* What the sides along u add to the lines between the corners. */
        const vec more0 = vec_sub(low, mix(xi[i], corners[0], corners[1]));
        const vec more1 = vec_sub(high, mix(xi[i], corners[2], corners[3]));
        for (int j = 0; j < u0->count; j++) {
            const vec left = vec_load(bat_curve_points(u0) + 3 * j, 3);
            const vec right = vec_load(bat_curve_points(u1) + 3 * j, 3);
            vec_store(vec_add(mix(xi[i], left, right), mix(eta[j], more0, more1)), row + 3 * j);
        }
    }
}

static bat_status patch(bat_curve *const sides[4], double within, bat_surface **out, double apart[4]) {
    double gaps[CORNERS], greatest = 0;
    vec corners[CORNERS];
    for (int k = 0; k < CORNERS; k++) {
        corners[k] = corner(sides, k % 2, k / 2, &gaps[k]);
        greatest = fmax(greatest, gaps[k]);
    }
    if (apart) memcpy(apart, gaps, sizeof gaps);
    if (!(greatest <= within)) return BAT_FAR;
    const bat_curve *along_u = sides[BAT_SIDE_V0], *along_v = sides[BAT_SIDE_U0];
    const int degree[2] = {along_u->degree, along_v->degree}, count[2] = {along_u->count, along_v->count};
    bat_surface *made;
    bat_status status = bat_surface_allocate(degree, (const bool[2]){false, false}, count, &made);
    if (status != BAT_OK) return status;
    double *greville = malloc(((size_t)count[0] + (size_t)count[1]) * sizeof *greville);
    if (!greville) {
        bat_surface_free(made);
        return BAT_MEMORY;
    }
    bat_curve_greville(along_u, greville);
    bat_curve_greville(along_v, greville + count[0]);
    for (int d = 0; d < 2; d++) {
        const bat_curve *from = d == 0 ? along_u : along_v;
        memcpy(bat_curve_own_knots(&made->axis[d]), bat_curve_knots(from),
               (size_t)bat_curve_knot_count(from) * sizeof(double));
    }
    fill(sides, corners, greville, greville + count[0], made);
    free(greville);
    return bat_surface_finish(made, out);
}

bat_status bat_surface_coons(const bat_curve *const sides[4], double within, bat_surface **out,
                             double apart[4]) {
    if (!sides || !out || !(within >= 0) || !isfinite(within)) return BAT_ARGUMENT;
    for (int i = 0; i < 4; i++)
        if (!sides[i] || sides[i]->closed) return BAT_ARGUMENT;
    bat_curve *matched[4] = {NULL, NULL, NULL, NULL};
    const double domain[2] = {0, 1};
    bat_status status = bat_sections_match(2, sides, domain, matched, NULL);
    if (status == BAT_OK) status = bat_sections_match(2, sides + 2, domain, matched + 2, NULL);
    if (status == BAT_OK) status = patch(matched, within, out, apart);
    bat_sections_free(4, matched);
    return status;
}
