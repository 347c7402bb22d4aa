/* Degree elevation, exact: F(u_1..u_{p+1}) is the mean of f over the p + 1 ways to leave one argument out
 * (Ramshaw 1987, P&T 5.5). The multiplicity of every knot grows by one. */
#include "curve/curve.h"

#include <batten/refine.h>
#include <stdlib.h>
#include <string.h>

/* A knot value among the old knots: its copies are t[last - copies + 1..last]. */
typedef struct group {
    double value;
    int copies, last;
} group;

/* The blossom of degree p at a window of groups with `held[g]` arguments each. All old knots between the ends
 * of the window are among the arguments, so the old ones are consecutive and the rest is new. */
static void blossom_at(const bat_curve *old, const group *groups, int skip, const int *held, int count,
                       double *out) {
    double x[BAT_DEGREE_MAX + 1];
    int m = 0, k = 0;
    bool found = false;
    for (int g = 0; g < count; g++) {
        int kept = held[g] < groups[g].copies ? held[g] : groups[g].copies;
        /* The window's first group gives its last copies; any later one begins with its first. */
        if (held[g] > 0 && !found) k = groups[g].last - (g == 0 ? kept : groups[g].copies), found = true;
        for (int i = kept; i < held[g]; i++) x[m++] = groups[g].value;
    }
    if (count == 1) { /* p + 1 equal end knots: the window says which p of them */
        int spare = groups[0].copies - old->degree;
        k = groups[0].last - groups[0].copies + (skip < spare ? skip : spare);
    }
    bat_refined_point(old, k, m, x, out);
}

/* New point whose window of p + 1 new knots starts `skip` copies into groups[0]. */
static void elevated_point(const bat_curve *old, const group *groups, int skip, double *out) {
    int p = old->degree, size = old->dimension, held[BAT_DEGREE_MAX + 1], count = 0;
    for (int left = p + 1; left > 0; count++) {
        int room = groups[count].copies + 1 - (count == 0 ? skip : 0);
        held[count] = room < left ? room : left;
        left -= held[count];
    }
    double sum[BAT_DIMENSION_MAX] = {0}, point[BAT_DIMENSION_MAX];
    for (int g = 0; g < count; g++) {
        held[g]--;
        blossom_at(old, groups, skip, held, count, point);
        held[g]++;
        for (int c = 0; c < size; c++) sum[c] += held[g] * point[c];
    }
    for (int c = 0; c < size; c++) out[c] = sum[c] / (p + 1);
}

/* old: an open spline whose groups are given; from..to are the groups of the domain's ends. */
static bat_status elevate_groups(const bat_curve *old, const group *groups, int count, int from, int to,
                                 bool closed, bat_curve **out) {
    int q = old->degree + 1, size = old->dimension;
    /* The last copy of the start is knot q of an open curve; the first copy is knot 0 of a closed one. */
    int before = closed ? 0 : q + 1, total = 0;
    for (int g = from + 1; g < to; g++) total += groups[g].copies + 1;
    total += closed ? groups[from].copies + 1 : q + 1;
    bat_curve *up;
    bat_status status = bat_curve_allocate(q, size, closed, total, &up);
    if (status != BAT_OK) return status;
    int g = from, skip = 0;
    if (!closed)
        for (; before > groups[g].copies + 1; g--) before -= groups[g].copies + 1;
    if (!closed) skip = groups[g].copies + 1 - before;
    double *knots = bat_curve_own_knots(up), *points = bat_curve_own_points(up);
    int last = bat_curve_knot_count(up) - 1;
    for (int i = 0; i <= last; i++) {
        knots[i] = groups[g].value;
        if (++skip > groups[g].copies) skip = 0, g++; /* the next knot opens the window of point i */
        if (i < up->count) elevated_point(old, groups + g, skip, points + (size_t)i * (size_t)size);
        if (g >= count) break;
    }
    return bat_curve_finish(up, out);
}

static bat_status elevate_once(const bat_curve *curve, bat_curve **out) {
    int p = curve->degree, n = curve->count;
    bat_curve *old = NULL;
    bat_status status = BAT_OK;
    /* Windows of a closed curve reach up to p + 1 knots over its ends. */
    if (curve->closed) status = bat_curve_unwind(curve, -2 * p - 2, n + 2 * p + 2, &old);
    if (status != BAT_OK) return status;
    const bat_curve *source = old ? old : curve;
    int knots = source->spread + p + 1, count = 0, from = 0, to = 0;
    group *groups = malloc((size_t)knots * sizeof(group));
    if (groups) {
        double start = curve->knots[p], end = curve->knots[curve->spread];
        for (int i = 0; i < knots; i++) {
            double t = source->knots[i];
            if (count > 0 && groups[count - 1].value == t) {
                groups[count - 1].copies++, groups[count - 1].last = i;
                continue;
            }
            if (t == start) from = count;
            if (t == end) to = count;
            groups[count++] = (group){t, 1, i};
        }
        status = elevate_groups(source, groups, count, from, to, curve->closed, out);
    } else {
        status = BAT_MEMORY;
    }
    free(groups);
    bat_curve_free(old);
    return status;
}

bat_status bat_curve_elevate(const bat_curve *curve, int degree, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    if (degree < curve->degree || degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    bat_curve *now;
    bat_status status = bat_curve_copy(curve, &now);
    while (status == BAT_OK && now->degree < degree) {
        bat_curve *next = NULL;
        status = elevate_once(now, &next);
        bat_curve_free(now);
        now = next;
    }
    if (status == BAT_OK) *out = now;
    return status;
}
