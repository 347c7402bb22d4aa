/* Batten: regions that closed curves bound, and what is made of several: union, difference, intersection, exclusion. */
#ifndef BATTEN_REGION_H
#define BATTEN_REGION_H

#include <batten/relate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What closed planar curves bound together; they may cross each other and themselves. */
typedef struct bat_region {
    size_t count;
    const bat_curve *const *curves; /* borrowed */
    bool even_odd;                  /* fill rule; else non-zero */
} bat_region;

typedef enum bat_region_operation {
    BAT_REGION_UNION,        /* in any of them */
    BAT_REGION_DIFFERENCE,   /* in the first and in no other */
    BAT_REGION_INTERSECTION, /* in all of them */
    BAT_REGION_EXCLUSION,    /* in an odd number of them */
    BAT_REGION_OPERATION_COUNT
} bat_region_operation;

/*
 * The boundary of what the operation makes of the regions, which is everywhere within tolerance (document units, > 0) of
 * curves of theirs: closed curves that do not cross, with the inside to the left where y points up (outer ones run
 * anticlockwise, holes clockwise), so that both fill rules give the same. A curve that no other crosses comes back bit for
 * bit, or reversed; pieces of the others keep their control points but next to where they were cut, which become corners.
 * Boundaries that run together within tolerance count as one, and what is narrower than the tolerance is left out: curves
 * that only touch stay two. One region: its outline without what lies inside.
 *
 * *count curves in an array that the caller frees (bat_curves_free); none where nothing is left. BAT_ARGUMENT: an open
 * curve; BAT_DIMENSION: a curve in space; BAT_TOLERANCE: it is below 1e-12 of the greatest coordinate, so that rounding
 * decides; BAT_COUNT: over BAT_POINTS_MAX pieces. Boundaries may fold back and run over each other as they like. Cost: that of the
 * intersections, and for each piece the logarithm of all and those that lie near its middle, as a rule. docs/math/relate.md 6.
 */
BAT_API bat_status bat_regions_combine(bat_region_operation operation, size_t region_count,
                                       const bat_region *regions, double tolerance, size_t *count,
                                       bat_curve ***out);

/*
 * The region grown by a distance in document units, or (distance < 0) shrunk: all that lies within it of the region, or all
 * of the region that does not lie within it of its boundary. Corners that open are made as the join says. Holes and curves
 * that lie within each other count together; the result is as that of bat_regions_combine, with nothing left where the
 * distance is too great. corner as bat_curve_offset. BAT_ARGUMENT: an open curve, or a distance below 8 tolerances;
 * else as bat_regions_combine and bat_curve_outline.
 */
BAT_API bat_status bat_region_offset(const bat_region *region, double distance, bat_join join,
                                     double miter_limit, double tolerance, double corner, size_t *count,
                                     bat_curve ***out);

#ifdef __cplusplus
}
#endif
#endif
