/* Inside the kernel: a span as its Taylor polynomial about the middle. There |s| <= h / 2, so coefficients are
 * no larger than Chebyshev's bound allows and no digits are lost. */
#ifndef BATTEN_SRC_PIECE_H
#define BATTEN_SRC_PIECE_H

#include "curve/curve.h"
#include "base/lanes.h"

/* c[k * dimension + d]: coefficient of (u - middle)^k. */
typedef struct bat_piece {
    double middle;
    double c[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
} bat_piece;

/* Cubic Taylor coefficients straight from knots and points: six divisions. With f's blossom about m, and the
 * span's ends a, b relative to m: f1(a,b) = f1 + f2 (a+b)/2 + f3 ab/2, f(a,b,m) = f + f1 (a+b)/3 + f2 ab/6
 * (f1 to f3: the derivatives at m). a + b is not quite zero: m is rounded, and counts for what it is. */
BAT_INLINE void bat_piece_cubic(const double *t, const double *points, bat_piece *out, int size) {
    double m = 0.5 * t[0] + 0.5 * t[1], a = t[0] - m, b = t[1] - m, sum = a + b, ab = a * b;
    double r0 = 3 / (t[1] - t[-2]), r1 = 3 / (t[2] - t[-1]), r2 = 3 / (t[3] - t[0]);
    double s0 = 2 / (t[1] - t[-1]), s1 = 2 / (t[2] - t[0]), q = 1 / (t[1] - t[0]);
    double w = (m - t[-1]) * (1.0 / 3), v0 = b * q, v1 = -a * q;
    for (int c = 0; c < size; c++) {
        double p1 = points[size + c], p2 = points[2 * size + c];
        double d0 = (p1 - points[c]) * r0, d1 = (p2 - p1) * r1, d2 = (points[3 * size + c] - p2) * r2;
        double e0 = (d1 - d0) * s0, e1 = (d2 - d1) * s1, third = (e1 - e0) * q;
        double second = v0 * e0 + v1 * e1, first = d1 - 0.5 * (second * sum + third * ab);
        out->c[3 * size + c] = third * (1.0 / 6);
        out->c[2 * size + c] = 0.5 * second;
        out->c[size + c] = first;
        out->c[c] = p1 + w * d1 - first * sum * (1.0 / 3) - second * ab * (1.0 / 6);
    }
    out->middle = m;
}

static inline void bat_piece_any(const bat_curve *curve, int span, bat_piece *out) {
    int p = curve->degree, size = curve->dimension;
    double scale = 1;
    out->middle = 0.5 * curve->knots[span] + 0.5 * curve->knots[span + 1];
    bat_curve_eval_span(curve, span, out->middle, p, out->c);
    for (int k = 2; k <= p; k++) {
        scale /= k;
        for (int c = 0; c < size; c++) out->c[k * size + c] *= scale;
    }
}

static inline void bat_piece_of(const bat_curve *curve, int span, bat_piece *out) {
    const double *points = curve->points + (span - curve->degree) * curve->dimension;
    if (curve->degree == 3 && curve->dimension == 3)
        bat_piece_cubic(curve->knots + span, points, out, 3);
    else if (curve->degree == 3)
        bat_piece_cubic(curve->knots + span, points, out, 2);
    else
        bat_piece_any(curve, span, out);
}

#endif
