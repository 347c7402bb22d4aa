/* Batten: changes of representation, and surgery: knots in and out, degree, split, join, reverse. */
#ifndef BATTEN_REFINE_H
#define BATTEN_REFINE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Inserts u `times` times (Boehm 1980; P&T A5.1). The shape does not change. BAT_KNOTS when the multiplicity would
 * exceed p, BAT_PARAMETER outside the domain (closed: any u). The ends of an open curve take up to p + 1; an
 * unclamped end then drops its outermost knot and point, so that the domain stays. */
BAT_API bat_status bat_curve_insert_knot(const bat_curve *curve, double u, int times, bat_curve **out);
/* Inserts many knots at once, sorted ascending, repeats allowed: one blossom for each new point, and untouched
 * points are copied. BAT_PARAMETER: outside, or not sorted; BAT_KNOTS, BAT_COUNT, BAT_NUMBER: as for one. O(count
 * + knot_count * p^2). */
BAT_API bat_status bat_curve_insert_knots(const bat_curve *curve, int knot_count, const double *knots,
                                          bat_curve **out);
/* Refinement to a superset: knots are all the knots of the result (open: the domain's ends as in the curve).
 * BAT_KNOTS: not a superset. O(knot_count * p^2). */
BAT_API bat_status bat_curve_refine(const bat_curve *curve, int knot_count, const double *knots,
                                    bat_curve **out);
/* Removes u up to `times` times while the curve moves by no more than tolerance (a proven bound, document units).
 * *removed says how often (0 where u is no interior knot), *error the bound on the distance; both may be NULL. A
 * closed curve whose only seam knot is removed starts its period at the next knot; one with too few points for the
 * window of the removal keeps its knots. P&T A5.8. */
BAT_API bat_status bat_curve_remove_knot(const bat_curve *curve, double u, int times, double tolerance,
                                         bat_curve **out, int *removed, double *error);
/* Removes as many interior knots as tolerance (total, measured) permits, cheapest first; corners (multiplicity
 * p knots whose tangents turn by more than corner radians) stay. The seam of a closed curve stays a knot. *error
 * (may be NULL): a proven bound on the distance, at most tolerance. About twenty rounds of O(n log n). */
BAT_API bat_status bat_curve_simplify(const bat_curve *curve, double tolerance, double corner,
                                      bat_curve **out, double *error);

/* To a higher degree, O(count * p^2); BAT_DEGREE: a lower one, or above 7. P&T A5.9. Clamp and reverse: O(count).
 * A closed curve cannot be clamped: BAT_ARGUMENT. */
BAT_API bat_status bat_curve_elevate(const bat_curve *curve, int degree, bat_curve **out); /* exact */
BAT_API bat_status bat_curve_clamp(const bat_curve *curve, bat_curve **out); /* open: end knots p + 1 fold */
BAT_API bat_status bat_curve_reverse(const bat_curve *curve, bat_curve **out);
/* Affine map of the parameters onto [start, end]; BAT_PARAMETER unless start < end. Reversing keeps the domain.
 * Both return BAT_KNOTS when distinct knots would become the same double. */
BAT_API bat_status bat_curve_reparametrise(const bat_curve *curve, double start, double end, bat_curve **out);

/* Cuts an open curve at u (strictly inside the domain). Both pieces are clamped and keep their
 * parameters. BAT_PARAMETER: not inside; BAT_ARGUMENT: a closed curve. O(count). */
BAT_API bat_status bat_curve_split(const bat_curve *curve, double u, bat_curve **left, bat_curve **right);
/* The piece over [start, end], clamped. Closed curves: start in any period, end - start at most one
 * period. BAT_PARAMETER: beyond that, or not start < end. O(count). */
BAT_API bat_status bat_curve_piece(const bat_curve *curve, double start, double end, bat_curve **out);
/* Opens a closed curve at u (any period); the domain starts at u reduced into the domain. BAT_ARGUMENT: an
 * open one. O(count). */
BAT_API bat_status bat_curve_open_at(const bat_curve *curve, double u, bat_curve **out);
/* Makes an open curve whose ends meet (within tolerance) periodic, and keeps the continuity 0..p-1 that is
 * measured at the seam; the seam is a knot of multiplicity p (less where removal is exact). BAT_ARGUMENT: it is
 * closed, or its ends do not meet. */
BAT_API bat_status bat_curve_close(const bat_curve *curve, double tolerance, bat_curve **out);
/* Same shape, start of the period moved to u reduced into the domain, a knot from now on. BAT_ARGUMENT: an open one. */
BAT_API bat_status bat_curve_move_seam(const bat_curve *curve, double u, bat_curve **out);
/*
 * Appends b to the end of a; degrees are raised to the greater. continuity 0: a's end and b's start are merged into
 * their midpoint when within gap, else BAT_ARGUMENT. 1, 2: the parameters of b are scaled and the control points next
 * to the joint moved as little as can be so that the joint is C1 / C2. The change is least in the sum of the squared
 * displacements of A2 A1 J B1 B2 around the joint (C1: A1 J B1); the joint's knot then has multiplicity p -
 * continuity, and degrees not above the continuity are raised above it. *moved (may be NULL): how far the curve moved
 * at most. BAT_ARGUMENT: a closed curve, or another continuity; BAT_DIMENSION: the dimensions differ. O(count).
 */
BAT_API bat_status bat_curve_join(const bat_curve *a, const bat_curve *b, int continuity, double gap,
                                  bat_curve **out, double *moved);

#ifdef __cplusplus
}
#endif
#endif
