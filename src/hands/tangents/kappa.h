/* Inside: the kappa-curve of points, as quadratic pieces. docs/math/tangents.md, math 1.5. */
#ifndef BATTEN_SRC_KAPPA_H
#define BATTEN_SRC_KAPPA_H

#include "base/vec.h"
#include <batten/base.h>

/* A quadratic Bézier, and the parameter at which it passes through its point. */
typedef struct bat_kappa_piece {
    vec start, middle, end;
    double t;
    double share; /* end = (1 - share) middle + share middle of the next piece */
} bat_kappa_piece;

/* How many pieces n points have: each point one, except the ends of an open curve; of two points one. */
static inline int bat_kappa_count(int n, bool closed) { return closed ? n : n > 2 ? n - 2 : 1; }

/*
 * Fills the pieces of a curve through n points, each different from the one before: two at least, three of a closed
 * one. Neighbouring pieces share their joint bit for bit. The curve always passes through its points; curvature is as
 * even as a bounded number of steps makes it, which is to rounding for all but points in wild disorder. Cost O(n) a step,
 * and 4,000 steps at most (fewer with more than 1,000 points).
 */
bat_status bat_kappa(int n, bool closed, const vec *points, bat_kappa_piece *pieces);

#endif
