/* Inside the kernel: what a curve is made of. Both kinds are stored as one open, unrolled spline, so that
 * evaluation knows no special case. */
#ifndef BATTEN_SRC_CURVE_H
#define BATTEN_SRC_CURVE_H

#include "base/count.h"
#include <batten/curve.h>

struct bat_curve {
    int degree;
    int dimension;
    bool closed;
    int count;      /* control points as the user counts them, n */
    int spread;     /* control points stored: n, or n + degree when closed */
    double *knots;  /* spread + degree + 1; closed: t_{-p}..t_{n+p}, so that t_j is knots[j + p] */
    double *points; /* spread * dimension; closed: P_{-p}..P_{n-1}, stored point i is P_{(i - p) mod n} */
};

/* The domain is [knots[degree], knots[spread]] in both kinds. */

/* One block for header, knots and points; contents of the arrays unset. BAT_MEMORY or BAT_OK. */
bat_status bat_curve_allocate(int degree, int dimension, bool closed, int count, bat_curve **out);
/* Fills the wrapped knots and points of a closed curve from t_0..t_n and P_0..P_{n-1}, already in place at
 * knots + p and points + p * dimension. No-op when open. */
void bat_curve_unroll(bat_curve *curve);
/* Checks knots and numbers of a filled curve (only t_0..t_n and P_0..P_{n-1} are read): the one validator. */
bat_status bat_curve_validate(const bat_curve *curve);
/* Open curves of one dimension, at least one, as bat_curve_join joins them with continuity 0, one behind the other: n in the points of
 * all. BAT_ARGUMENT: an end is further than the gap from the next beginning. */
bat_status bat_curve_chain(size_t count, const bat_curve *const *curves, double gap, bat_curve **out);
/* BAT_NUMBER when one of the numbers is no coordinate; problem (may be NULL) says which: place may have a "%zu" for its index. */
bat_status bat_coordinates_check(bat_problem *problem, const char *place, size_t count,
                                 const double *numbers);
/* Whether all numbers are finite and within BAT_COORDINATE_MAX. */
bool bat_are_coordinates(const double *numbers, size_t count);
/* The half of it that looks at the points. */
bat_status bat_points_check(const bat_curve *curve);
/* Validates and unrolls a filled curve and hands it over; frees it when it is not valid. */
bat_status bat_curve_finish(bat_curve *curve, bat_curve **out);
/* The user's arrays, writable while a curve is being made: t_0.. and P_0.. */
double *bat_curve_own_knots(bat_curve *curve);
double *bat_curve_own_points(bat_curve *curve);

/* The image under three rows of four numbers (base/pose.h); a curve of the plane that leaves it lies in space. */
bat_status bat_curve_posed(const bat_curve *curve, const double rows[12], bat_curve **out);
/* bat_curve_count, as it is counted inside. */
static inline int bat_point_count(const bat_curve *curve) { return curve->count; }
/* How many knots a curve of so many points has. */
static inline int bat_knot_total(int degree, bool closed, int count) {
    return closed ? count + 1 : count + degree + 1;
}
/* Checks `count` points' worth of knots: count + degree + 1, or count + 1 when closed. */
bat_status bat_knots_check(int degree, bool closed, int count, const double *knots);
/* Multiplicity of u as a knot (exact equality; closed: within one period, the seam counted as one knot). */
int bat_knot_multiplicity(const bat_curve *curve, double u);

/* Index i with knots[i] <= u < knots[i+1], degree <= i < spread; `hint` is tried first (any int). u must lie
 * in the domain; at its end the last non-empty span. */
int bat_span(const bat_curve *curve, double u, int hint);
/* Index i with knots[i] < u <= knots[i+1]; at the start of the domain the first non-empty span. */
int bat_span_left(const bat_curve *curve, double u, int hint);
/* Into the domain: clamp (open) or reduce modulo the period, the end excluded (closed). NaN stays NaN;
 * infinity is NaN on a closed curve. */
double bat_curve_reduce(const bat_curve *curve, double u);
/* The same for limits from the left: on a closed curve the start of the domain is excluded, its end is not.
 */
double bat_curve_reduce_left(const bat_curve *curve, double u);
/* Basis functions of every degree q <= p: rows[q][0..q]. */
void bat_basis_rows(const bat_curve *curve, int span, double u, double rows[][BAT_DEGREE_MAX + 1]);
/* Basis functions and derivatives of span i at u: out[(order + 1) * (degree + 1)]. */
void bat_basis(const bat_curve *curve, int span, double u, int order, double *out);
/* Value and derivatives in a given span, u may lie outside it (the polynomial is continued). */
void bat_curve_eval_span(const bat_curve *curve, int span, double u, int order, double *out);
/* Derivatives first..order (first 0 or 1) of the p + 1 points of one span, each of any size; t: the span's first knot;
 * rows: from bat_basis_rows. The points are used up when order is above 0. */
void bat_eval_local(const double *t, int p, int size, int first, int order, double rows[][BAT_DEGREE_MAX + 1],
                    double *points, double *out);
/* BAT_NUMBER: a NaN; BAT_PARAMETER: not ascending. */
bat_status bat_parameters_check(size_t count, const double *u);
/* bat_curve_eval_many for parameters that pass that check. */
void bat_curve_eval_sorted(const bat_curve *curve, size_t count, const double *u, int order, double *out);
/* Blossom of the piece of a stored span. */
void bat_curve_blossom_span(const bat_curve *curve, int span, const double *arguments, double *out);
/* The piece of a stored span (degree <= span < spread, not empty) as a Bézier segment: out[(p + 1) * dimension], the blossoms at
 * p - j times its start and j times its end. */
void bat_span_bezier(const bat_curve *curve, int span, double *out);

/* The blossom at old knots t_{k+1}..t_{k+p-m} and m new arguments x between t_k and t_{k+p-m+1}, ascending
 * (stored indices): m levels of de Boor's triangle over P_{k-m}..P_k. m = 0 copies P_k. */
void bat_refined_point(const bat_curve *old, int k, int m, const double *x, double *out);
/* How a curve whose knots contain those of `old` follows from it. rank: for each stored knot of `fresh`, how
 * many of the old ones lie up to it; false when the knots are not nested. Points from..to-1 (stored) are then
 * filled in, each by itself. */
bool bat_refine_rank(const bat_curve *old, const bat_curve *fresh, int *rank);
void bat_refine_points(const bat_curve *old, bat_curve *fresh, const int *rank, int from, int to);
/* The points first..last-1 of a closed curve's periodic sequence, and their knots, as an open curve for
 * reading only (its ends need not be valid). */
bat_status bat_curve_unwind(const bat_curve *curve, int first, int last, bat_curve **out);
/* Closed: the same curve numbered from knot and point `shift` (-n < shift < n). */
bat_status bat_curve_rotate(const bat_curve *curve, int shift, bat_curve **out);
/* Closed: the same curve with all copies of the seam at the start of the period. Open: a copy. */
bat_status bat_curve_gather_seam(const bat_curve *curve, bat_curve **out);
/* bat_curve_from_bezier with joints that stay knots, if their tangents turn or not. */
typedef enum bat_seams {
    BAT_SEAMS_MERGED, /* none: those that are not needed go */
    BAT_SEAMS_ENDS,   /* where a closed path begins */
    BAT_SEAMS_KEPT    /* all */
} bat_seams;
bat_status bat_curve_from_seams(int dimension, int degree, bool closed, int segments, const double *points,
                                double corner, double tolerance, bat_seams joints, bat_curve **out,
                                double *error);
/* bat_curve_from_bezier with a range of its own: the speed leaves 1/range..range times that of the segments' lengths
 * nowhere, at the price of joints of multiplicity p. */
bat_status bat_curve_from_chain(int dimension, int degree, bool closed, int segments, const double *points,
                                double corner, double range, double tolerance, bat_curve **out,
                                double *error);
/* Euclidean distance of two points. */
double bat_distance(const double *a, const double *b, int size);
/* Whether the line between two points of the plane crosses what lies to the right of `at`, which is inside a polygon where an
 * odd number of its sides do. */
bool bat_is_beside(const double at[2], const double from[2], const double to[2]);
/* Angle by which a polygon turns at a point, 0..pi; 4 when a side has no length. */
double bat_turn(const double *before, const double *at, const double *after, int size);
/* Does the curve's tangent turn by more than `angle` at the knot whose last copy is stored knot r
 * (multiplicity p or more)? Tangents that vanish count as turning. */
bool bat_curve_corner_at(const bat_curve *curve, int r, double angle);

#endif
