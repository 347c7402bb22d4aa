/*
 * Spans walked side by side. A span has nine samples, too few to fill vector registers and to hide the time that a
 * division takes. All but the product of the turns is independent of what comes before, so eight spans are
 * sampled, reflected and measured at once; the product then runs through those that these steps are fine enough for.
 */
#include "curve/frames/ahead.h"

#include "base/lanes.h"
#include "curve/frames/turn.h"
#include "curve/piece.h"

enum {
    LANES = BAT_FRAME_LANES,
    STEPS = BAT_FRAME_STEPS,
    LAST = STEPS * LANES,
    Y = BAT_FRAME_PLANE,
    Z = 2 * BAT_FRAME_PLANE
};

/* As bat_frame_span_make. */
BAT_CLONES static void pieces(const double *restrict t, const double *restrict points,
                              bat_frame_ahead *restrict out) {
    for (int l = 0; l < LANES; l++) {
        bat_piece f;
        bat_piece_cubic(t + l, points + 3 * l, &f, 3);
        double most = 0, half = (t[l + 1] - t[l]) / 2, power = 1;
        for (int k = 1; k <= 3; k++, power *= half)
            for (int d = 0; d < 3; d++) {
                double size = k * power * fabs(f.c[3 * k + d]);
                most = size > most ? size : most;
                out->c[k][d][l] = f.c[3 * k + d];
            }
        double slow = 1e-14 * most * most;
        out->slow[l] = slow > 1e-200 ? slow : 1e-200;
        out->middle[l] = f.middle;
        for (int d = 0; d < 3; d++) out->origin[d][l] = f.c[d], out->c[0][d][l] = 0;
    }
}

static void parameters(const double *t, double *u) {
    for (int j = 0; j < STEPS; j++)
        for (int l = 0; l < LANES; l++) u[j * LANES + l] = t[l] + (t[l + 1] - t[l]) * j / STEPS;
    for (int l = 0; l < LANES; l++) u[LAST + l] = t[l + 1];
}

/* Positions and unit tangents of all spans after a step, as bat_frame_span_eval. */
BAT_INLINE void eval_step(const double *restrict u, const double *restrict middle,
                          const double *restrict slow, const double (*restrict c)[3][LANES],
                          double *restrict x, double *restrict t, long long *restrict wide) {
    for (int l = 0; l < LANES; l++) {
        double s = u[l] - middle[l], v[3], w[3];
        for (int d = 0; d < 3; d++) v[d] = c[3][d][l], w[d] = 3 * c[3][d][l];
        for (int k = 2; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + c[k][d][l], w[d] = w[d] * s + k * c[k][d][l];
        double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], one = 1 / sqrt(square);
        wide[l] |= !(square > slow[l]);
        x[l] = v[0] * s, x[Y + l] = v[1] * s, x[Z + l] = v[2] * s;
        t[l] = w[0] * one, t[Y + l] = w[1] * one, t[Z + l] = w[2] * one;
    }
}

BAT_CLONES static void eval(bat_frame_ahead *a) {
    for (int l = 0; l < LANES; l++) a->wide[l] = 0;
    for (int i = 0; i <= LAST; i += LANES)
        eval_step(a->u + i, a->middle, a->slow, (const double(*)[3][LANES])a->c, a->xs + i, a->ts + i,
                  a->wide);
}

BAT_CLONES static void mark_wide(const double *restrict t, double least, long long *restrict wide) {
    for (int i = 0; i < STEPS * LANES; i += LANES)
        for (int l = 0; l < LANES; l++) {
            int k = i + l, j = k + LANES;
            wide[l] |= !(t[k] * t[j] + t[Y + k] * t[Y + j] + t[Z + k] * t[Z + j] >= least);
        }
}

void bat_frame_ahead_make(bat_frame_ahead *a, const bat_curve *curve, int first, double least) {
    bat_rows s1;
    const double *xs = a->xs, *ts = a->ts, *knots = curve->knots + first;
    pieces(knots, curve->points + (ptrdiff_t)(first - 3) * 3, a);
    parameters(knots, a->u);
    eval(a);
    mark_wide(ts, least, a->wide);
    bat_rows_normals(LAST + LANES, ts, a->es);
    a->useless = !bat_rows_reflect(LAST, xs, ts, a->es, xs + LANES, ts + LANES, s1);
    bat_rows_measure(LAST, LANES, ts, a->es, s1, a->re, a->im);
    a->first = first, a->next = 0, a->waiting = LANES;
}

static void span_of(const bat_frame_ahead *a, int l, bat_frame_span *out) {
    out->span = a->first + l, out->degree = 3, out->middle = a->middle[l], out->slow = a->slow[l];
    for (int d = 0; d < 3; d++) {
        out->origin[d] = a->origin[d][l];
        for (int k = 0; k <= 3; k++) out->c[k][d] = a->c[k][d][l];
    }
}

bool bat_frame_ahead_take(bat_frame_ahead *a, vec t, vec s, bat_frame_span *out, int *lane, bool *wide) {
    const int l = *lane = a->next++;
    const vec start = bat_rows_get(a->ts, l);
    a->waiting--;
    span_of(a, l, out);
    *wide = a->wide[l] != 0;
    if (*wide || a->useless) return false;
    s = bat_square_up(bat_turn_least(s, t, start), start);
    bat_rows_multiply(STEPS + 1, LANES, s, a->ts + l, a->es + l, a->re + l, a->im + l);
    for (int i = l; i <= LAST + l; i += LANES)
        bat_rows_put(a->ss, i, bat_rows_spread_at(i, a->ts, a->es, a->re, a->im));
    return true;
}
