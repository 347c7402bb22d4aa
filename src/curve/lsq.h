/*
 * Inside the library: the parts of a least-squares spline fit, shared by the free fit (curve/fit.c) and the
 * constrained one of the sketch hand.
 *
 * A `space` is a bat_curve of which only degree, closed, count, spread and knots are read; its points may be
 * anything, also NULL. Unknowns are its `count` control points as the user counts them. Slot s is the stored
 * knot interval [knots[degree + s], knots[degree + s + 1]], s = 0..spread - degree - 1; empty slots are
 * allowed everywhere. In a slot the local coordinate is s = (u - middle) / half, -1..1.
 *
 * Recipe for one solve (p = degree, n = count, m = dimension):
 *     a[n * (p + 1)] = 0, b[n * m] = 0
 *     bat_lsq_assemble(...)        adds   sum w N N^T  to a  and  sum w N X  to b
 *     bat_lsq_penalty(...)         adds   mu * integral of N^(k) N^(k)^T  to a
 *     eliminate pins as you like; then bat_banded_factor/solve, or bat_cyclic_* when closed: a is stored as
 *     banded.h says, with band p
 *     bat_lsq_local(...)           control points -> local polynomials
 *     bat_lsq_error(...)           true distances, by Newton re-projection
 *     bat_lsq_rank(...)            which knots may go
 * Nothing here allocates.
 */
#ifndef BATTEN_SRC_LSQ_H
#define BATTEN_SRC_LSQ_H

#include "curve/curve.h"

/* Slots of a space, empty ones included. */
static inline int bat_lsq_slots(const bat_curve *space) { return space->spread - space->degree; }
/* Unknown that belongs to stored control point i. */
static inline int bat_lsq_unknown(const bat_curve *space, int i) {
    if (!space->closed) return i;
    const int j = (i - space->degree) % space->count;
    return j < 0 ? j + space->count : j;
}

/* Basis functions of a non-empty slot as polynomials of s: N_j = sum over k of out[k * (p + 1) + j] s^k;
 * j-th of the p + 1 functions belongs to stored control point slot + j. */
void bat_lsq_transform(const bat_curve *space, int slot, double *out);

/* u: ascending, inside the domain. first[slots + 1]: samples of slot s are first[s]..first[s + 1] - 1. */
void bat_lsq_ranges(const bat_curve *space, size_t count, const double *u, size_t *first);

/* Moments of samples in one slot: out[2p + 1] = sum w s^k, then out[(p + 1) * dimension] = sum w s^k X, where
 * weight NULL means 1. Doubles needed: */
static inline size_t bat_lsq_moment_size(int degree, int dimension) {
    return (size_t)(2 * degree + 1 + (degree + 1) * dimension);
}
void bat_lsq_moments(const bat_curve *space, int slot, int dimension, size_t count, const double *u,
                     const double *x, const double *weight, double *out);
/* Adds a slot's moments to the normal equations; transform as bat_lsq_transform gives it. */
void bat_lsq_add(const bat_curve *space, int slot, int dimension, const double *transform,
                 const double *moments, double *a, double *b);

/* All of the above at once: adds count samples u (ascending, inside the domain), x[count * dimension],
 * weight[count] or NULL. Cost: some 20 multiply-adds per sample for cubics. */
void bat_lsq_assemble(const bat_curve *space, int dimension, size_t count, const double *u, const double *x,
                      const double *weight, double *a, double *b);

/* Adds mu * factor[slot] * integral of the products of order-th derivatives; factor NULL means 1; exact.
 * order <= degree. */
void bat_lsq_penalty(const bat_curve *space, int order, double mu, const double *factor, double *a);

/* local[slots * (p + 1) * dimension]: coefficients of s^k, all coordinates of k together. points: `count`
 * control points as the user counts them. Empty slots are left alone. */
void bat_lsq_local(const bat_curve *space, int dimension, const double *points, double *local);

/*
 * A memo keeps what belongs to single slots from one solve to the next: where knots are as they were, nothing
 * is computed again. Two are needed, the last solve's and this one's, which then change places.
 *     fill(space, ..., &old, same_samples, &now); add(..., &now, a, b); penalty(...); ... local(...)
 * does what assemble, penalty and local do. An empty memo (slots 0, as placed) remembers nothing.
 */
typedef struct bat_lsq_memo {
    int slots;
    double *knots, *transforms, *moments, *grams;
} bat_lsq_memo;
/* Doubles that a memo for so many slots needs. */
size_t bat_lsq_memo_size(int degree, int dimension, size_t slots);
/* block is borrowed. */
void bat_lsq_memo_place(bat_lsq_memo *memo, int degree, int dimension, size_t slots, double *block);
/* first: of bat_lsq_ranges. same_samples: u, x and weight are those of the old memo. */
void bat_lsq_memo_fill(const bat_curve *space, int dimension, const size_t *first, const double *u,
                       const double *x, const double *weight, const bat_lsq_memo *old, bool same_samples,
                       bat_lsq_memo *now);
void bat_lsq_memo_add(const bat_curve *space, int dimension, const bat_lsq_memo *memo, double *a, double *b);
void bat_lsq_memo_penalty(const bat_curve *space, int order, double mu, const double *factor,
                          const bat_lsq_memo *memo, double *a);
void bat_lsq_memo_local(const bat_curve *space, int dimension, const bat_lsq_memo *memo, const double *points,
                        double *local);

/* Squared distances at the samples' own parameters; first: of bat_lsq_ranges. */
void bat_lsq_plain(const bat_curve *space, int dimension, const double *local, const size_t *first,
                   const double *u, const double *x, double *distance);

/*
 * Distance of samples to the curve: `steps` Newton steps from u[i], never farther than where they start.
 * near: the parameters found, or NULL; distance: squared distances, or NULL. Returns the greatest squared
 * distance. u ascending (otherwise it only takes longer). The true distances are never greater than these.
 */
double bat_lsq_error(const bat_curve *space, int dimension, const double *local, size_t count,
                     const double *u, const double *x, int steps, double *near, double *distance);

/*
 * The quick form for fits: u ascending, inside the domain, first from bat_lsq_ranges. A sample whose squared
 * distance at u[i] is within limit is measured there; one that fails by far, too; only those between are
 * projected, and not even those when another fails by far: then they are taken to be as near as a Newton step
 * expects. near: where one Newton step leads, not clamped to anything, or where the projection ended.
 * scratch: count doubles. Returns the greatest squared distance; when it is within limit the truth is never
 * greater.
 */
double bat_lsq_measure(const bat_curve *space, int dimension, const double *local, const size_t *first,
                       const double *u, const double *x, double limit, double *near, double *distance,
                       double *scratch);

/*
 * rank[slots + 1], one number for each knot: rank[s] belongs to knots[degree + s]: the jump of C^(p) there
 * times (h- h+)^(p/2), h the lengths of the neighbouring non-empty slots; a length in document units that
 * says how much the curve moves when the knot goes. INFINITY for ends of open curves, and for every one of a
 * multiple knot. Closed: rank[slots] is INFINITY, too: the seam's knot is rank[0].
 */
void bat_lsq_rank(const bat_curve *space, int dimension, const double *local, double *rank);

#endif
