/*
 * Batten: the curve. A non-uniform B-spline of degree 1 to 7 in the plane or in space.
 *
 * Open: n points P_0..P_{n-1}, n + p + 1 knots t_0..t_{n+p}, domain [t_p, t_n]; clamped or not.
 * Closed: n distinct points and one period of knots t_0..t_n, domain [t_0, t_n]; the rest follows from
 * t_{j+n} = t_j + T and P_{i+n} = P_i. N_i has support [t_i, t_{i+p+1}]. There is no seam.
 * Interior knots (closed: all knots) repeat at most p times; end knots of open curves at most p + 1. The first and the
 * last span of an open domain are not empty. A closed curve has at least two points; n may be below p.
 * Knots are equal only when their doubles are; there is no knot tolerance.
 * So that no later arithmetic overflows, coordinates and knots are bounded, and distinct knots are no closer than
 * BAT_SPAN_MIN; those of a closed curve must still be distinct doubles one period away. Otherwise the status is
 * BAT_NUMBER.
 *
 * A curve is a value: it never changes after it is made. Operations return new curves, which the caller frees
 * (bat_curve_free). Each curve is one allocation. Source: Piegl and Tiller (P&T), The NURBS Book; docs/references.md.
 */
#ifndef BATTEN_CURVE_H
#define BATTEN_CURVE_H

#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BAT_COORDINATE_MAX 1e75
#define BAT_KNOT_MAX 1e30
#define BAT_SPAN_MIN 1e-30

typedef struct bat_curve bat_curve;

/* Makes a curve after checking all the conditions above. points: count * dimension doubles, x y [z] each; knots:
 * knot_count of them, which must be count + degree + 1 (open) or count + 1 (closed), else BAT_KNOTS. Both are
 * copied. Cost O(count). */
BAT_API bat_status bat_curve_create(int dimension, int degree, bool closed, size_t count,
                                    const double *points, int knot_count, const double *knots,
                                    bat_curve **out);
/* The same, open and clamped, with uniform knots: spans of length 1, domain [0, count - degree], so that the curve
 * begins at the first point and ends at the last. */
BAT_API bat_status bat_curve_create_clamped(int dimension, int degree, size_t count, const double *points,
                                            bat_curve **out);
/* O(count). */
BAT_API bat_status bat_curve_copy(const bat_curve *curve, bat_curve **out);
BAT_API void bat_curve_free(bat_curve *curve); /* NULL is fine */

BAT_API int bat_curve_degree(const bat_curve *curve);                    /* 1 to 7 */
BAT_API int bat_curve_dimension(const bat_curve *curve);                 /* 2 or 3 */
BAT_API bool bat_curve_is_closed(const bat_curve *curve);                /* whether it is periodic */
BAT_API size_t bat_curve_count(const bat_curve *curve);                  /* control points, n */
BAT_API int bat_curve_knot_count(const bat_curve *curve);                /* n + p + 1, or n + 1 when closed */
BAT_API const double *bat_curve_knots(const bat_curve *curve);           /* owned by the curve */
BAT_API const double *bat_curve_points(const bat_curve *curve);          /* owned by the curve */
BAT_API void bat_curve_domain(const bat_curve *curve, double domain[2]); /* first and last parameter */
/* Length of the diagonal of the control points' box: the "size" that relative bounds refer to. O(count). */
BAT_API double bat_curve_size(const bat_curve *curve);
/* Bitwise equality of shape and representation. O(count). */
BAT_API bool bat_curve_is_equal(const bat_curve *a, const bat_curve *b);

/*
 * Position and derivatives up to `order` at u: out[(order + 1) * dimension], position first. Orders above the degree
 * are zero. Open curves clamp u to the domain, closed ones take it modulo the period; a NaN u gives NaN. At a knot it
 * is the limit from the right (at the end of an open domain, from the left). O(log count + order * p^2); no
 * allocation.
 */
BAT_API void bat_curve_eval(const bat_curve *curve, double u, int order, double *out);
/* The same limit from the left at knots. */
BAT_API void bat_curve_eval_left(const bat_curve *curve, double u, int order, double *out);
/*
 * Bulk evaluation at count parameters, sorted ascending (closed: any ascending run will do; it need not lie within
 * one period). out: count blocks of (order + 1) * dimension. Linear in count plus the number of spans touched; no
 * allocation. BAT_PARAMETER if unsorted, BAT_NUMBER if one is NaN.
 */
BAT_API bat_status bat_curve_eval_many(const bat_curve *curve, size_t count, const double *u, int order,
                                       double *out);
/* u: count parameters spread evenly over the domain, ends included (closed: the end excluded). */
BAT_API void bat_curve_spread(const bat_curve *curve, size_t count, double *u);

/* Blossom (polar form) of the polynomial piece just to the right of u (left: just to the left of it), at p
 * arguments. P&T 5, Ramshaw 1987. out: dimension doubles. */
BAT_API void bat_curve_blossom(const bat_curve *curve, double u, const double *arguments, bool left,
                               double *out);

/* Greville abscissae, means of p knots: out has bat_curve_count doubles. */
BAT_API void bat_curve_greville(const bat_curve *curve, double *out);
/* Non-zero basis functions at u (treated as in bat_curve_eval): values[p + 1]; *first is the index of the first
 * control point that they apply to (closed: modulo n). P&T A2.2. */
BAT_API void bat_curve_basis(const bat_curve *curve, double u, int *first, double *values);

/* Affine image: matrix is dimension rows of (dimension + 1), row major, translation last. BAT_NUMBER: a point
 * would lie beyond BAT_COORDINATE_MAX. O(count). */
BAT_API bat_status bat_curve_transform(const bat_curve *curve, const double *matrix, bat_curve **out);
/* The planar curve in space (z = 0), or the space curve's x, y. BAT_DIMENSION: neither 2 nor 3. O(count). */
BAT_API bat_status bat_curve_to_dimension(const bat_curve *curve, int dimension, bat_curve **out);

#ifdef __cplusplus
}
#endif
#endif
