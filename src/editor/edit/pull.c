#include "editor/edit/pull.h"
#include "base/real.h"
#include <batten/drag.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SMOOTH = 0.06; /* tangent of the turn */

static bool looks_smooth(const bat_curve *curve, double u) {
    double a[4], b[4];
    bat_curve_eval_left(curve, u, 1, a);
    bat_curve_eval(curve, u, 1, b);
    double along = a[2] * b[2] + a[3] * b[3], across = a[2] * b[3] - a[3] * b[2];
    return along > 0 && fabs(across) < SMOOTH * along;
}

/* The knots less one copy of each that looks smooth; those go to `dropped`. Returns how many are dropped. */
static int thin(const bat_curve *curve, double *kept, double *dropped) {
    const double *knots = bat_curve_knots(curve);
    int count = bat_curve_knot_count(curve), p = bat_curve_degree(curve), gone = 0, left = 0;
    double domain[2];
    bat_curve_domain(curve, domain);
    for (int i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count && knots[next] == knots[i]; next++) {
        }
        bool inside = knots[i] > domain[0] && knots[i] < domain[1];
        bool one_less = inside && p > 1 && next - i == p && looks_smooth(curve, knots[i]);
        if (one_less) dropped[gone++] = knots[i];
        for (int k = i + one_less; k < next; k++) kept[left++] = knots[i];
    }
    return gone;
}

/* A curve of the same kind with fewer points, all at the origin. */
static bat_status nowhere(const bat_curve *curve, int count, const double *knots, bat_curve **out) {
    double *points = count > 0 ? calloc(2 * (size_t)count, sizeof *points) : NULL;
    if (!points) return BAT_MEMORY;
    bat_status status = bat_curve_create(bat_curve_degree(curve), 2, bat_curve_closed(curve), count, knots,
                                         points, out);
    free(points);
    return status;
}

static bat_status sum(const bat_curve *a, const bat_curve *b, bat_curve **out) {
    int count = bat_curve_count(a), knots = bat_curve_knot_count(a);
    if (bat_curve_count(b) != count || bat_curve_knot_count(b) != knots ||
        memcmp(bat_curve_knots(a), bat_curve_knots(b), (size_t)knots * sizeof(double)) != 0)
        return BAT_SINGULAR; /* numbered otherwise */
    double *points = malloc(2 * (size_t)count * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (int i = 0; i < 2 * count; i++) points[i] = bat_curve_points(a)[i] + bat_curve_points(b)[i];
    bat_status status = bat_curve_create(bat_curve_degree(a), 2, bat_curve_closed(a), count,
                                         bat_curve_knots(a), points, out);
    free(points);
    return status;
}

bat_status bat_pull(const bat_curve *curve, int count, const double *u, const double *delta,
                    bat_curve **out) {
    int knots = bat_curve_knot_count(curve);
    double *kept = malloc(2 * (size_t)knots * sizeof *kept);
    if (!kept) return BAT_MEMORY;
    double *dropped = kept + knots;
    int gone = thin(curve, kept, dropped);
    bat_curve *still = NULL, *thinned = NULL, *move = NULL;
    bat_status status = gone ? nowhere(curve, bat_curve_count(curve) - gone, kept, &still) : BAT_SINGULAR;
    if (status == BAT_OK) status = bat_curve_drag(still, count, u, delta, &thinned);
    if (status == BAT_OK) status = bat_curve_insert_knots(thinned, gone, dropped, &move);
    if (status == BAT_OK) status = sum(curve, move, out);
    bat_curve_free(still);
    bat_curve_free(thinned);
    bat_curve_free(move);
    free(kept);
    return status == BAT_OK || status == BAT_MEMORY ? status : bat_curve_drag(curve, count, u, delta, out);
}
