/* The outline of a stroke of varying width: what its sheets cover together (docs/math/relate.md 8). */
#include "relate/outline.h"
#include "relate/region/grid.h"
#include "relate/widen.h"

#include <batten/bezier.h>
#include <batten/region.h>

#include <stdlib.h>
#include <string.h>

static const double FIT = 0.4;   /* of the tolerance: what the sides may take */
static const double JOINT = 0.3; /* what the regions may take, at most twice */

typedef struct covering {
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

/* What the chains cover together. Sides run over each other wherever the stroke does. */
static bat_status combine(const covering *k, double corner, double tolerance, size_t *count,
                          bat_curve ***out) {
    size_t chains = 0;
    bat_curve **all = NULL;
    bat_status status = chains_of(k, corner, &chains, &all);
    *count = 0, *out = NULL;
    if (status == BAT_OK && chains)
        status = bat_regions_combine_on_grid(1, &(bat_region){chains, (const bat_curve *const *)all, false},
                                             JOINT * tolerance, count, out);
    bat_curves_free(chains, all);
    return status;
}

/* What the sheets cover. */
static bat_status outline_sheets(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                                 double tolerance, double corner, size_t *count, bat_curve ***out,
                                 double *max_error) {
    covering k = {0};
    double error;
    bat_status status = bat_widen_cover(curve, nib, profile, FIT * tolerance, corner, &k.count, &k.points,
                                        &error);
    if (status != BAT_OK) return status;
    status = combine(&k, corner, tolerance, count, out);
    bat_free(k.points);
    if (status == BAT_OK && max_error) *max_error = error + 2 * JOINT * tolerance;
    return status;
}

static const bat_width_profile EVEN = {0};

bat_status bat_curve_outline(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner,
                             size_t *count, bat_curve ***out, double *max_error) {
    const bat_status status = bat_outline_parallels(curve, nib, tolerance, corner, count, out, max_error);
    return status == BAT_SINGULAR
               ? outline_sheets(curve, nib, &EVEN, tolerance, corner, count, out, max_error)
               : status;
}

/* With the width that the profile has everywhere; nothing, where it is 0. */
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
    const bat_status status = bat_width_check(profile, NULL);
    if (status != BAT_OK) return status;
    if (!curve || !nib) return BAT_ARGUMENT;
    return bat_width_is_even(profile)
               ? outline_even(curve, nib, profile, tolerance, corner, count, out, max_error)
               : outline_sheets(curve, nib, profile, tolerance, corner, count, out, max_error);
}
