/* The outline of a stroke of varying width: what its sheets cover together (docs/math/relate.md 8). */
#include "relate/outline.h"
#include "relate/widen.h"

#include <batten/bezier.h>
#include <batten/region.h>

#include <stdlib.h>
#include <string.h>

enum { TRIES = 10 };

static const double FIT = 0.4;   /* of the tolerance: what the sides may take */
static const double JOINT = 0.1; /* what the regions may take */
/* Of the tolerance: how fine the tries are, and by how much they move the curve. */
static const double SHARES[TRIES] = {1, 0.5, 0.5, 0.5, 0.25, 0.125, 0.0625, 0.03125, 4, 16};
static const double SHAKEN[TRIES] = {0, 0, 0.2, 0.3, 0, 0, 0.2, 0, 1, 2};

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

/* The curve with its control points moved by up to `far`, each another way: sides that run over each other part. */
static bat_status shake(const bat_curve *curve, double far, bat_curve **out) {
    const size_t n = 2 * bat_curve_count(curve);
    const double *from = bat_curve_points(curve);
    double *points = malloc(n * sizeof *points);
    if (!points) return BAT_MEMORY;
    unsigned state = 1;
    for (size_t i = 0; i < n; i++) {
        state = state * 1103515245u + 12345u;
        points[i] = from[i] + far * ((double)(state >> 16 & 1023) / 511.5 - 1);
    }
    const bat_status status = bat_curve_create(2, bat_curve_degree(curve), bat_curve_is_closed(curve), n / 2,
                                               points, bat_curve_knot_count(curve), bat_curve_knots(curve),
                                               out);
    free(points);
    return status;
}

typedef struct sheets_asked {
    const bat_nib *nib;
    const bat_width_profile *profile;
    double corner;
} sheets_asked;

static bat_status try_sheets(const bat_curve *curve, const sheets_asked *asked, double tolerance, bool apart,
                             size_t *count, bat_curve ***out, double *error) {
    covering k = {.closed = bat_curve_is_closed(curve)};
    bat_status status = bat_widen_cover(curve, asked->nib, asked->profile, FIT * tolerance, asked->corner,
                                        &k.count, &k.points, error);
    if (status != BAT_OK) return status;
    status = combine(&k, asked->corner, tolerance, apart, count, out);
    bat_free(k.points);
    *error += 2 * JOINT * tolerance;
    return status;
}

/* What the sheets cover; where the pieces do not fit together, in other ways. */
static bat_status outline_sheets(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                                 double tolerance, double corner, size_t *count, bat_curve ***out,
                                 double *max_error) {
    const sheets_asked asked = {nib, profile, corner};
    bat_status made = BAT_SINGULAR;
    for (int i = 0; i < TRIES && made == BAT_SINGULAR; i++) {
        bat_curve *shaken = NULL;
        double error = 0;
        const double far = SHAKEN[i] * tolerance;
        if (far > 0 && shake(curve, far, &shaken) != BAT_OK) return BAT_MEMORY;
        made = try_sheets(shaken ? shaken : curve, &asked, SHARES[i] * tolerance, i % 2 == 1, count, out,
                          &error);
        bat_curve_free(shaken);
        if (made == BAT_OK && max_error) *max_error = error + 1.5 * far;
    }
    return made;
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
    const bat_status status = bat_width_check(profile);
    if (status != BAT_OK) return status;
    if (!curve || !nib) return BAT_ARGUMENT;
    return bat_width_is_even(profile)
               ? outline_even(curve, nib, profile, tolerance, corner, count, out, max_error)
               : outline_sheets(curve, nib, profile, tolerance, corner, count, out, max_error);
}
