/* The outline of a stroke of varying width: what its sheets cover together (docs/math/relate.md 8). */
#include "relate/widen.h"

#include <batten/bezier.h>
#include <batten/region.h>

#include <stdlib.h>
#include <string.h>

enum { TRIES = 6 };

static const double FIT = 0.4;   /* of the tolerance: what the sides may take */
static const double JOINT = 0.1; /* what the regions may take */
static const double FINER = 0.5; /* where the pieces did not fit together */

typedef struct covering {
    bool closed; /* the curve */
    size_t count;
    double *points;
} covering;

/* One chain as a closed curve; *out NULL: it has no length. */
static bat_status curve_of(const double *cubics, size_t count, double corner, bat_curve **out) {
    double *points = malloc((6 * count + 2) * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, cubics, 2 * sizeof *points);
    for (size_t i = 0; i < count; i++) memcpy(points + 2 + 6 * i, cubics + 8 * i + 2, 6 * sizeof *points);
    *out = NULL;
    const bat_status status = bat_curve_from_bezier(2, 3, true, (int)count, points, corner, 0, out, NULL);
    free(points);
    return status == BAT_COUNT ? BAT_OK : status; /* a point */
}

/* Nothing is simplified: where two sheets have a side in common, its cubics stay the same in both, which is soon seen. */
static bat_status chains_of(const covering *k, double corner, size_t *count, bat_curve ***out) {
    const double *p = k->points;
    bat_curve **all = malloc((k->count + 1) * sizeof(bat_curve *));
    bat_status status = all ? BAT_OK : BAT_MEMORY;
    *count = 0;
    for (size_t from = 0, to; from < k->count && status == BAT_OK; from = to) {
        bat_curve *made = NULL;
        for (to = from + 1; to < k->count && !memcmp(p + 8 * to, p + 8 * to - 2, 2 * sizeof *p); to++) {
        }
        status = curve_of(p + 8 * from, to - from, corner, &made);
        if (made) all[(*count)++] = made;
    }
    *out = all;
    return status;
}

/* apart: the sheets that are turned over are regions of their own. */
static bat_status combine(const covering *k, double corner, double tolerance, bool apart, size_t *count,
                          bat_curve ***out) {
    size_t chains = 0;
    bat_curve **all = NULL;
    bat_status status = chains_of(k, corner, &chains, &all);
    const size_t sides = k->closed && chains > 1 ? 2 : 1, first = apart && chains > sides ? sides : chains;
    bat_region *regions = calloc(chains + 1, sizeof *regions);
    if (!regions) status = BAT_MEMORY;
    *count = 0, *out = NULL;
    if (status == BAT_OK && chains) {
        const bat_curve *const *curves = (const bat_curve *const *)all;
        regions[0] = (bat_region){first, curves, false};
        for (size_t i = first; i < chains; i++) regions[i - first + 1] = (bat_region){1, curves + i, false};
        status = bat_regions_combine(BAT_REGION_UNION, chains - first + 1, regions, JOINT * tolerance, count,
                                     out);
    }
    free(regions);
    bat_curves_free(chains, all);
    return status == BAT_KNOTS ? BAT_SINGULAR : status;
}

/* BAT_SINGULAR: what is left of the parallels does not close; the sheets may. */
static bat_status outline_even(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                               double tolerance, double corner, size_t *count, bat_curve ***out,
                               double *max_error) {
    bat_nib even = *nib;
    double share[2];
    bat_width_eval(profile, false, 0, share);
    even.width = nib->width * share[0];
    if (even.width > 0) return bat_curve_outline(curve, &even, tolerance, corner, count, out, max_error);
    *count = 0, *out = NULL;
    if (max_error) *max_error = 0;
    return BAT_OK;
}

bat_status bat_curve_outline_width(const bat_curve *curve, const bat_nib *nib,
                                   const bat_width_profile *profile, double tolerance, double corner,
                                   size_t *count, bat_curve ***out, double *max_error) {
    if (!count || !out) return BAT_ARGUMENT;
    const bat_status status = bat_width_check(profile);
    if (status != BAT_OK) return status;
    if (!curve || !nib) return BAT_ARGUMENT;
    bat_status made = BAT_SINGULAR;
    if (bat_width_is_even(profile))
        made = outline_even(curve, nib, profile, tolerance, corner, count, out, max_error);
    const bool closed = bat_curve_is_closed(curve);
    for (int i = 0; i < TRIES && made == BAT_SINGULAR; i++, tolerance *= FINER) {
        covering k = {.closed = closed};
        double error;
        made = bat_widen_cover(curve, nib, profile, FIT * tolerance, corner, &k.count, &k.points, &error);
        if (made != BAT_OK) break;
        made = combine(&k, corner, tolerance, i % 2 == 1, count, out);
        if (made == BAT_OK && max_error) *max_error = error + 2 * JOINT * tolerance;
        bat_free(k.points);
    }
    return made;
}
