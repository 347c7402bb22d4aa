/* A span in three coordinates: its samples, and how long it is. */
#include "curve/frames/span.h"

#include "curve/piece.h"

#include <string.h>

void bat_frame_span_make(const bat_curve *curve, int span, bat_frame_span *out) {
    bat_piece piece;
    int p = curve->degree, size = curve->dimension;
    bat_piece_of(curve, span, &piece);
    out->span = span, out->degree = p, out->middle = piece.middle;
    double most = 0, half = (curve->knots[span + 1] - curve->knots[span]) / 2, power = 1;
    for (int d = 0; d < 3; d++) out->origin[d] = d < size ? piece.c[d] : 0, out->c[0][d] = 0;
    for (int k = 1; k <= p; k++, power *= half)
        for (int d = 0; d < 3; d++) {
            out->c[k][d] = d < size ? piece.c[k * size + d] : 0;
            const double reach = k * power * fabs(out->c[k][d]);
            most = reach > most ? reach : most;
        }
    const double slow = 1e-14 * most * most;
    out->slow = slow > 1e-200 ? slow : 1e-200;
}

BAT_INLINE bool eval_rows(const bat_frame_span *f, int p, int count, const double *restrict u,
                          double *restrict x, double *restrict t) {
    double m = f->middle, slow = f->slow, c[BAT_DEGREE_MAX + 1][3];
    long long fault = 0;
    memcpy(c, f->c, sizeof c);
    for (int i = 0; i < count; i++) {
        double s = u[i] - m, v[3], w[3];
        for (int d = 0; d < 3; d++) v[d] = c[p][d], w[d] = p * c[p][d];
        for (int k = p - 1; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + c[k][d], w[d] = w[d] * s + k * c[k][d];
        double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], one = 1 / sqrt(square);
        fault |= !(square > slow);
        x[i] = v[0] * s, x[BAT_FRAME_PLANE + i] = v[1] * s, x[2 * BAT_FRAME_PLANE + i] = v[2] * s;
        t[i] = w[0] * one, t[BAT_FRAME_PLANE + i] = w[1] * one, t[2 * BAT_FRAME_PLANE + i] = w[2] * one;
    }
    return !fault;
}

#ifdef __OPTIMIZE_SIZE__ /* the same operations; degree 3 needs no code of its own */
bool bat_frame_span_eval(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return eval_rows(f, f->degree, count, u, x, t);
}
#else
BAT_CLONES static bool eval_cubic(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return eval_rows(f, 3, count, u, x, t);
}

bool bat_frame_span_eval(const bat_frame_span *f, int count, const double *u, double *x, double *t) {
    return f->degree == 3 ? eval_cubic(f, count, u, x, t) : eval_rows(f, f->degree, count, u, x, t);
}
#endif

void bat_rows_turn_left(int count, const double *t, double *s) {
    for (int i = 0; i < count; i++) bat_rows_put(s, i, (vec){-t[BAT_FRAME_PLANE + i], t[i], 0});
}

bool bat_frame_steps(const bat_frame_span *piece, int dimension, int count, const double *u,
                     const double *from_x, const double *from_t, const double *from_s, double *xs, double *ts,
                     double *ss) {
    if (!bat_frame_span_eval(piece, count, u, xs, ts)) return false;
    if (dimension == 2) {
        bat_rows_turn_left(count, ts, ss);
        return true;
    }
    return bat_rows_reflect(count, from_x, from_t, from_s, xs, ts, ss);
}

double bat_frame_length(const bat_frame_span *f, double a, double b) {
    static const double x[5] = {-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                0.90617984593866399},
                        w[5] = {0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                0.47862867049936647, 0.23692688505618909};
    double sum = 0;
    for (int i = 0; i < 5; i++) {
        double s = (a + b) / 2 + x[i] * (b - a) / 2 - f->middle, v[3] = {0, 0, 0}, square = 0;
        for (int k = f->degree; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + k * f->c[k][d];
        for (int d = 0; d < 3; d++) square += v[d] * v[d];
        sum += w[i] * (square > 1e-280 ? sqrt(square) : vec_norm(vec_load(v, 3)));
    }
    return sum * (b - a) / 2;
}
