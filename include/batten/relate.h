/*
 * Batten: curves beside curves: how far apart they are, where they meet, and what is made of one: polylines and
 * arcs.
 */
#ifndef BATTEN_RELATE_H
#define BATTEN_RELATE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- distance ---- */

typedef struct bat_apart {
    double distance; /* Hausdorff's: no point of either curve is further from the other */
    double u, v;     /* parameters on a and on b of two points that are so far apart */
} bat_apart;

/*
 * The Hausdorff distance of two curves, document units: never above the true one, and below it by no more than
 * `precision` (> 0). Branch and bound: each piece is bounded by the hull of its difference from the piece of the other
 * curve opposite it (docs/math/relate.md 1). BAT_DIMENSION: the dimensions differ. BAT_TOLERANCE, with the best found:
 * the precision was not reached within two million pieces. Cost: some hundred closest-point searches, as a rule.
 */
BAT_API bat_status bat_curve_hausdorff(const bat_curve *a, const bat_curve *b, double precision,
                                       bat_apart *out);

/* ---- where curves meet ---- */

/* What two curves do at a contact, a stretch over which they stay within the tolerance. */
typedef enum bat_contact_kind {
    BAT_CONTACT_CROSSES, /* a goes from one side of b to the other; in space: they meet at an angle */
    BAT_CONTACT_TOUCHES, /* a stays on its side; in space: they meet with parallel tangents */
    BAT_CONTACT_ENDS,    /* an open curve begins or ends within the contact */
    BAT_CONTACT_OVERLAPS /* all of a curve lies within the contact */
} bat_contact_kind;

typedef struct bat_crossing {
    double u, v;                     /* on a and on b */
    double point[BAT_DIMENSION_MAX]; /* halfway between the two */
    bat_contact_kind kind;
    int sign; /* of a crossing in the plane, where y points up: 1 a goes to the left of b, -1 to the right; else 0 */
} bat_crossing;

typedef struct bat_overlap {
    double u[2]; /* ascending */
    double v[2]; /* opposite u[0] and u[1]: descending where b runs the other way */
} bat_overlap;

typedef struct bat_meeting {
    size_t count;
    bat_crossing *crossings; /* ascending in u */
    size_t overlap_count;
    bat_overlap *overlaps; /* ascending in u[0] */
} bat_meeting;

/*
 * Where two curves, in the plane or in space, come within tolerance (document units, > 0; what rounding hides at their
 * coordinates counts as met, too). One contact is one crossing: all places between which the curves stay within the
 * tolerance; where two polynomials are one, an overlap, and no crossings within it. As many whichever curve comes first. A crossing at the seam of a closed
 * curve has the start of its domain. *out is the caller's (bat_meeting_free). BAT_DIMENSION: the dimensions differ;
 * BAT_COUNT: over two million pairs of pieces would have to be looked at. docs/math/relate.md 2.
 */
BAT_API bat_status bat_curve_intersect(const bat_curve *a, const bat_curve *b, double tolerance,
                                       bat_meeting *out);
/* Where one curve meets itself, u < v; where it runs over itself, one way or back, an overlap, as bat_curve_intersect. The ends of
 * a closed curve, and of an open one whose ends meet, do not count. */
BAT_API bat_status bat_curve_self_intersect(const bat_curve *curve, double tolerance, bat_meeting *out);
BAT_API void bat_meeting_free(bat_meeting *meeting); /* NULL is fine; leaves it empty */

/* ---- what is made of a curve ---- */

/*
 * A polyline from which no point of the curve is further than tolerance (document units, > 0), by Wang's bound on second
 * differences. Its points lie on the curve; knots are among them. docs/math/relate.md 4. *points: *count * dimension doubles, *u (may be NULL)
 * their parameters, both the caller's (bat_free); the last point of a closed curve repeats the first. BAT_COUNT: more
 * than BAT_POINTS_MAX points. BAT_TOLERANCE: rounding hides the tolerance.
 */
BAT_API bat_status bat_curve_flatten(const bat_curve *curve, double tolerance, size_t *count, double **points,
                                     double **u);

typedef struct bat_arc {
    double from[2], to[2];
    double centre[2];
    double radius; /* 0: a straight line */
    bool ccw;      /* anticlockwise where y points up */
} bat_arc;

/*
 * A planar curve as arcs of circles and straight lines, from which it is nowhere further than tolerance (document
 * units, > 0); they meet on one tangent wherever the curve does, and its corners (tangents that turn by more than
 * `corner` radians) stay. As few pairs of arcs as reach from point to point of the curve, each as far as it can
 * (biarcs; docs/math/relate.md 3). *max_error (may be NULL): a bound on the distance. *arcs is the caller's (bat_free).
 * BAT_DIMENSION: a space curve; BAT_COUNT: more than BAT_POINTS_MAX arcs; BAT_TOLERANCE: a tolerance below 64 times what
 * rounding may do to the greatest coordinate.
 */
BAT_API bat_status bat_curve_arcs(const bat_curve *curve, double tolerance, double corner, size_t *count,
                                  bat_arc **arcs, double *max_error);

/*
 * The parallels of a planar curve at a distance in document units, above 0 to the left of its direction (where y points
 * up): cubics by least squares (Levien 2022), within tolerance (> 0), smooth where the curve is. Corners (tangents that
 * turn by more than `corner` radians) that open are rounded; what would be nearer to the curve than the distance, as the
 * loops at tight bends, is cut off; pieces are left out that get no further than four tolerances from where they start. So
 * there may be several curves, or none: *count of them, in order along the curve, in an array that the caller frees
 * (bat_curves_free). *max_error (may be NULL): how far points of the result are from
 * being at the distance, measured at 16 places a span. Distance 0: a copy. BAT_DIMENSION: a space curve; BAT_NUMBER: a
 * distance that is not finite or too large; BAT_COUNT: more than 2^18 cubics; BAT_TOLERANCE: a tolerance below 1e-12 of
 * the greatest coordinate and the distance, which rounding hides. docs/math/relate.md 5.
 */
BAT_API bat_status bat_curve_offset(const bat_curve *curve, double distance, double tolerance, double corner,
                                    size_t *count, bat_curve ***out, double *max_error);

typedef enum bat_cap { BAT_CAP_BUTT, BAT_CAP_ROUND, BAT_CAP_SQUARE } bat_cap;
typedef enum bat_join { BAT_JOIN_MITER, BAT_JOIN_ROUND, BAT_JOIN_BEVEL } bat_join;

typedef struct bat_nib {
    double width; /* of the stroke, document units, > 0 */
    bat_cap cap;  /* of open curves */
    bat_join join;
    double miter_limit; /* at least 1: mitres longer than this many widths are bevelled */
} bat_nib;

/*
 * The outline of a stroke along a planar curve: closed curves that do not cross and have the stroke to the left where y
 * points up (both fill rules give the same), smooth where the curve is. The stroke is all that lies within half the width of
 * the curve; caps, mitres and bevels are added or cut off as SVG draws them. tolerance, corner, *max_error, *count and *out as
 * bat_curve_offset. A point with round caps gives a circle; of others no curve is made. Cusps within a span are round whatever the
 * joins are. Where the parallels of the curve do not fit together, or an end with a butt cap bends more than a circle of half the
 * width, the outline is what the lines across the curve cover, as bat_curve_outline_width makes it. A bevel that another stretch of the curve covers in part is cut off all the
 * same, by less than half a width. BAT_ARGUMENT: a width or a limit out of range; BAT_TOLERANCE: the tolerance is below 1e-12 of
 * the greatest coordinate, or of it and what the outline is made of, within a factor of 10. docs/math/relate.md 7.
 */
BAT_API bat_status bat_curve_outline(const bat_curve *curve, const bat_nib *nib, double tolerance,
                                     double corner, size_t *count, bat_curve ***out, double *max_error);
/* The curves and their array; NULL is fine. */
BAT_API void bat_curves_free(size_t count, bat_curve **curves);

#ifdef __cplusplus
}
#endif
#endif
