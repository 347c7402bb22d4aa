/* Regions that are grown or shrunk: with the outline of a stroke along their boundary, or without it (docs/math/relate.md 7). */
#include <batten/region.h>
#include <batten/width.h>

#include <math.h>
#include <stdlib.h>

/* Of the distance, at most, is the tolerance; of the tolerance, each step takes a share. */
static const double LEAST = 8, SHARE = 0.4;

typedef struct strokes {
    size_t count;
    bat_region *regions; /* the first is the region itself */
    bat_curve ***curves; /* of each stroke; of the region at 0 */
} strokes;

static void clear(strokes *s) {
    for (size_t i = 0; i < s->count; i++) bat_curves_free(s->regions[i].count, s->curves[i]);
    free(s->regions), free(s->curves);
}

static void add(strokes *s, size_t count, bat_curve **curves) {
    s->regions[s->count] = (bat_region){count, (const bat_curve *const *)curves, false};
    s->curves[s->count++] = curves;
}

static bat_status gather(const bat_region *region, const bat_nib *nib, double tolerance, double corner,
                         strokes *s) {
    size_t base_count = 0, count;
    bat_curve **base = NULL, **all;
    bat_status status = bat_regions_combine(BAT_REGION_UNION, 1, region, SHARE * tolerance, &base_count,
                                            &base);
    if (status != BAT_OK) return status;
    s->regions = calloc(base_count + 1, sizeof *s->regions);
    s->curves = calloc(base_count + 1, sizeof *s->curves);
    if (!s->regions || !s->curves) {
        bat_curves_free(base_count, base);
        return BAT_MEMORY;
    }
    add(s, base_count, base);
    for (size_t i = 0; i < base_count && status == BAT_OK; i++) {
        status = bat_curve_outline_width(base[i], nib, &(bat_width_profile){0}, SHARE * tolerance, corner,
                                         &count, &all, NULL);
        if (status == BAT_OK) add(s, count, all);
    }
    return status;
}

bat_status bat_region_offset(const bat_region *region, double distance, bat_join join, double miter_limit,
                             double tolerance, double corner, size_t *count, bat_curve ***out) {
    if (!region || !count || !out || !(tolerance > 0) || !(fabs(distance) >= LEAST * tolerance))
        return BAT_ARGUMENT;
    const bat_nib nib = {2 * fabs(distance), BAT_CAP_ROUND, join, miter_limit};
    strokes s = {0};
    bat_status status = gather(region, &nib, tolerance, corner, &s);
    if (status == BAT_OK)
        status = bat_regions_combine(distance > 0 ? BAT_REGION_UNION : BAT_REGION_DIFFERENCE, s.count,
                                     s.regions, 0.5 * SHARE * tolerance, count, out);
    clear(&s);
    return status;
}
