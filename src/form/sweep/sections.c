#include "form/sweep/sections.h"
#include "base/order.h"
#include "base/real.h"

#include <batten/refine.h>
#include <stdlib.h>
#include <string.h>

static const double same = 1e-10; /* of the domain: knots this close are one */

void bat_sections_free(int count, bat_curve **curves) {
    for (int i = 0; i < count; i++) {
        bat_curve_free(curves[i]);
        curves[i] = NULL;
    }
}

/* Replaces the curve by the result of a change; frees it in any case. */
static bat_status step(bat_status status, bat_curve **changed, bat_curve **curve) {
    bat_curve_free(*curve);
    *curve = status == BAT_OK ? *changed : NULL;
    return status;
}

/* In space, clamped or with all copies of the seam at the start, of that degree, over that domain. */
static bat_status prepare(const bat_curve *curve, int degree, const double domain[2], bat_curve **out) {
    bat_curve *now = NULL, *next = NULL;
    bat_status status = bat_curve_to_dimension(curve, 3, &now);
    if (status != BAT_OK) return status;
    status = step(now->closed ? bat_curve_gather_seam(now, &next) : bat_curve_clamp(now, &next), &next, &now);
    if (status == BAT_OK) status = step(bat_curve_elevate(now, degree, &next), &next, &now);
    if (status == BAT_OK && now->closed) status = step(bat_curve_gather_seam(now, &next), &next, &now);
    if (status == BAT_OK)
        status = step(bat_curve_reparametrise(now, domain[0], domain[1], &next), &next, &now);
    *out = now;
    return status;
}

/* All knots of all curves, ascending, each once: knots that are nearly the same are replaced by the least of them, those
 * nearly at the domain's ends by the ends. Returns how many. */
static int gather(int count, bat_curve *const *curves, const double domain[2], double *values) {
    const double near = same * (domain[1] - domain[0]);
    int total = 0, kept = 1;
    for (int i = 0; i < count; i++) {
        const int size = bat_curve_knot_count(curves[i]);
        memcpy(values + total, bat_curve_knots(curves[i]), (size_t)size * sizeof *values);
        total += size;
    }
    qsort(values, (size_t)total, sizeof *values, bat_ascending); /* no ties that can be told apart */
    values[0] = domain[0];
    for (int i = 1; i < total; i++)
        if (values[i] - values[kept - 1] > near) values[kept++] = values[i];
    if (kept > 1 && domain[1] - values[kept - 1] <= near) kept--;
    values[kept++] = domain[1];
    return kept;
}

/* The index of the value that the knot becomes: the last one that is not above it by more than rounding. */
static int find(double knot, int total, const double *values, double near) {
    int low = 0, high = total - 1;
    if (knot >= values[high] - near) return high;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (knot < values[middle])
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* Moves every knot onto its value, and raises `times`, how often each value stands in the merged knots. */
static void snap(bat_curve *curve, int total, const double *values, int *times) {
    double *knots = bat_curve_own_knots(curve);
    const int size = bat_curve_knot_count(curve);
    const double near = same * (values[total - 1] - values[0]);
    for (int i = 0; i < size;) {
        const int place = find(knots[i], total, values, near);
        int here = 0;
        for (; i < size && find(knots[i], total, values, near) == place; i++, here++)
            knots[i] = values[place];
        if (here > times[place]) times[place] = here;
    }
    bat_curve_unroll(curve);
}

static bat_status merge(int count, bat_curve **curves, int total, const double *values, const int *times) {
    size_t size = 0;
    for (int i = 0; i < total; i++) size += (size_t)times[i];
    double *knots = size <= BAT_POINTS_MAX ? malloc(size * sizeof *knots) : NULL;
    if (!knots) return size <= BAT_POINTS_MAX ? BAT_MEMORY : BAT_COUNT;
    int filled = 0;
    for (int i = 0; i < total; i++)
        for (int k = 0; k < times[i]; k++) knots[filled++] = values[i];
    bat_status status = BAT_OK;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        bat_curve *fine = NULL;
        status = step(bat_curve_refine(curves[i], filled, knots, &fine), &fine, &curves[i]);
    }
    free(knots);
    return status;
}

static bat_status share_knots(int count, bat_curve **curves, const double domain[2]) {
    size_t size = 0;
    for (int i = 0; i < count; i++) size += (size_t)bat_curve_knot_count(curves[i]);
    if (size > 2 * BAT_POINTS_MAX) return BAT_COUNT;
    double *values = malloc((size + 1) * sizeof *values);
    int *times = calloc(size + 1, sizeof *times);
    bat_status status = values && times ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        const int total = gather(count, curves, domain, values);
        for (int i = 0; i < count; i++) snap(curves[i], total, values, times);
        status = merge(count, curves, total, values, times);
    }
    free(values), free(times);
    return status;
}

bat_status bat_sections_match(int count, const bat_curve *const *curves, const double domain[2],
                              bat_curve **out, int *most) {
    int degree = 1, largest = 0;
    bat_status status = BAT_OK;
    for (int i = 0; i < count; i++) {
        out[i] = NULL;
        if (curves[i]->degree > degree) degree = curves[i]->degree;
    }
    for (int i = 0; i < count && status == BAT_OK; i++) {
        status = prepare(curves[i], degree, domain, &out[i]);
        if (status == BAT_OK && out[i]->count > largest) largest = out[i]->count;
    }
    if (status == BAT_OK) status = share_knots(count, out, domain);
    if (status != BAT_OK) bat_sections_free(count, out);
    if (status == BAT_OK && most) *most = largest;
    return status;
}

static void at_share(const bat_curve *line, double share, double out[3]) {
    double domain[2];
    bat_curve_domain(line, domain);
    bat_curve_eval(line, domain[0] + share * (domain[1] - domain[0]), 0, out);
}

double bat_sections_apart(const bat_curve *a, const bat_curve *b, int shares, bool turned) {
    double sum = 0, p[3], q[3];
    for (int i = 0; i < shares; i++) {
        const double share = (i + 0.5) / shares;
        at_share(a, share, p), at_share(b, turned ? 1 - share : share, q);
        sum += bat_distance(p, q, 3) / shares;
    }
    return sum;
}
