/* The change of curvature (docs/math sketch 5.7). With speed near 1, C''' = k' N - k^2 T, so C''' + k^2 C' = k' N: with the
 * curvature k of the last solve the change of curvature is linear in the unknowns, and circles and straight lines cost
 * nothing. */
#include "hands/sketch/machine.h"
#include "base/lanes.h"

#include <math.h>

static const double tightest = 0.2; /* no heed is paid to curvature beyond it, 1/px */
static const double peak_slack = 1.08;
static const double straight = 1e-4; /* curvature that has no side, 1/px */

/* Position and the first three derivatives by w of a slot's polynomial at x in -1..1. */
BAT_INLINE void jet_at(const double *local, const int p, const int m, double half, double x, double *jet) {
    const double by = 1 / half;
    for (int c = 0; c < m; c++) {
        double f0 = 0, f1 = 0, f2 = 0, f3 = 0;
        for (int k = p; k >= 0; k--) {
            f3 = f3 * x + f2, f2 = f2 * x + f1, f1 = f1 * x + f0;
            f0 = f0 * x + local[k * m + c];
        }
        jet[c] = f0, jet[m + c] = f1 * by;
        jet[2 * m + c] = 2 * f2 * by * by, jet[3 * m + c] = 6 * f3 * by * by * by;
    }
}

/* Squared curvature, and squared speed. */
BAT_INLINE double bend_of(const double *jet, const int m, double *speed2) {
    double v2 = 0, a2 = 0, va = 0;
    for (int c = 0; c < m; c++) {
        const double v = jet[m + c], a = jet[2 * m + c];
        v2 += v * v, a2 += a * a, va += v * a;
    }
    *speed2 = v2;
    const double area2 = v2 * a2 - va * va;
    return v2 > 0 && area2 > 0 ? area2 / (v2 * v2 * v2) : 0;
}

/* One slot's part: a few places, a row each. */
BAT_INLINE void slot_energy(bat_local_machine *k, int s, const int p, const int m) {
    const bat_fairing *fair = &k->fairing;
    const int w = p + 1;
    const double *t = k->space.knots + p;
    const double half = 0.5 * (t[s + 1] - t[s]), first = 1 / half, third = first * first * first;
    const double *T = k->memo[0].transforms + (size_t)s * (size_t)(w * w);
    const size_t count = k->first[s + 1] - k->first[s], last = k->problem->count - 1;
    const size_t from = k->first[s] < last ? k->first[s] : last;
    const int places = count > 18 ? (int)(count / 6) : 3;
    const double part = fair->lambda * k->factor[s] * 2 * half / places;
    double gram[(BAT_DEGREE_MAX + 1) * (BAT_DEGREE_MAX + 1)] = {0};
    double right[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX] = {0};
    for (int g = 0; g < places; g++) {
        const double f = (g + 0.5) / places, x = 2 * f - 1;
        const size_t i = from + (count > 0 ? (size_t)(f * (double)count) : 0);
        const double bend = fair->bend[i] * first;
        double row[BAT_DEGREE_MAX + 1];
        for (int j = 0; j <= p; j++) {
            double d1 = 0, d3 = 0;
            for (int n = p; n >= 1; n--) d1 = d1 * x + n * T[n * w + j];
            for (int n = p; n >= 3; n--) d3 = d3 * x + n * (n - 1) * (n - 2) * T[n * w + j];
            row[j] = d3 * third + bend * d1;
        }
        for (int r = 0; r <= p; r++)
            for (int j = 0; j <= r; j++) gram[r * w + j] += row[r] * row[j];
        for (int r = 0; r <= p && fair->aimed; r++)
            for (int c = 0; c < m; c++) right[r * m + c] += row[r] * fair->change[i * (size_t)m + (size_t)c];
    }
    for (int r = 0; r <= p; r++) {
        const size_t unknown = (size_t)bat_lsq_unknown(&k->space, s + r);
        double *a = k->a + unknown * (size_t)w, *b = k->b + unknown * (size_t)m;
        for (int j = 0; j <= r; j++) a[r - j] += part * gram[r * w + j];
        for (int c = 0; c < m; c++) b[c] += part * right[r * m + c];
    }
}

void bat_energy_add(bat_local_machine *k) {
    const int p = k->problem->degree, m = k->problem->dimension;
    const double *t = k->space.knots + p;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        if (!(t[s + 1] > t[s])) continue;
        if (p == 3 && m == 2) /* the usual case, unrolled */
            slot_energy(k, s, 3, 2);
        else
            slot_energy(k, s, p, m);
    }
}

/* The last solve at the samples: where it lies, how it bends, and how that changes. */
BAT_INLINE void look_at_slot(bat_local_machine *k, int s, const int p, const int m) {
    const bat_local_problem *q = k->problem;
    bat_fairing *fair = &k->fairing;
    const double *t = k->space.knots + p;
    const double half = 0.5 * (t[s + 1] - t[s]);
    const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
    for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
        double jet[4 * BAT_DIMENSION_MAX], v2;
        jet_at(local, p, m, half, (q->w[i] - t[s]) / half - 1, jet);
        double bend = bend_of(jet, m, &v2);
        if (bend > tightest * tightest) bend = tightest * tightest;
        fair->bend[i] = bend *= v2;
        for (int c = 0; c < m; c++) {
            const size_t at = i * (size_t)m + (size_t)c;
            fair->aim[at] = jet[c], fair->change[at] = jet[3 * m + c] + bend * jet[m + c];
        }
    }
}

void bat_energy_look(bat_local_machine *k) {
    const int p = k->problem->degree, m = k->problem->dimension;
    const double *t = k->space.knots + p;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        if (!(t[s + 1] > t[s])) continue;
        if (p == 3 && m == 2)
            look_at_slot(k, s, 3, 2);
        else
            look_at_slot(k, s, p, m);
    }
}

/* ---- no more extrema, no higher peak ---- */

/* Curvature at the samples; in space it has no sign. */
BAT_INLINE void slot_curvature(const bat_local_machine *k, int s, const int p, const int m, double *out) {
    const bat_local_problem *q = k->problem;
    const double *t = k->space.knots + p;
    const double half = 0.5 * (t[s + 1] - t[s]);
    const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
    for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
        double jet[4 * BAT_DIMENSION_MAX], v2;
        jet_at(local, p, m, half, (q->w[i] - t[s]) / half - 1, jet);
        out[i] = sqrt(bend_of(jet, m, &v2));
        if (m == 2 && jet[2] * jet[5] - jet[3] * jet[4] < 0) out[i] = -out[i];
    }
}

static void curvature(const bat_local_machine *k, double *out) {
    const int p = k->problem->degree, m = k->problem->dimension;
    const double *t = k->space.knots + p;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        if (!(t[s + 1] > t[s])) continue;
        if (p == 3 && m == 2)
            slot_curvature(k, s, 3, 2, out);
        else
            slot_curvature(k, s, p, m, out);
    }
}

/* Extrema that stand out by more than `least`, with the samples they are at; at most `room` are written. */
static int extrema(const double *x, size_t count, double least, int room, size_t *at) {
    size_t low = 0, high = 0;
    int way = 0, found = 0;
    for (size_t i = 1; i < count; i++) {
        if (x[i] < x[low]) low = i;
        if (x[i] > x[high]) high = i;
        const bool falls = way >= 0 && x[i] < x[high] - least, rises = way <= 0 && x[i] > x[low] + least;
        if (!falls && !rises) continue;
        if (way != 0 && found < room) at[found] = falls ? high : low;
        found += way != 0;
        way = falls ? -1 : 1;
        low = high = i;
    }
    return found;
}

static double variation_of(const double *x, size_t count, double *peak) {
    double sum = 0;
    *peak = fabs(x[0]);
    for (size_t i = 1; i < count; i++) sum += fabs(x[i] - x[i - 1]), *peak = fmax(*peak, fabs(x[i]));
    return sum;
}

static int inflections(const double *x, size_t count) {
    int found = 0, side = 0;
    for (size_t i = 0; i < count; i++) {
        if (fabs(x[i]) < straight) continue;
        const int now = x[i] > 0 ? 1 : -1;
        found += side == -now;
        side = now;
    }
    return found;
}

/* What the guard holds later curves to: the extrema of this one that stand out by 4 % of the range. */
void bat_energy_keep(bat_local_machine *k) {
    bat_fairing *fair = &k->fairing;
    const size_t n = k->problem->count;
    const double *x = fair->curvature;
    curvature(k, fair->curvature);
    double low = x[0], high = x[0], mean = 0;
    for (size_t i = 0; i < n; i++)
        low = fmin(low, x[i]), high = fmax(high, x[i]), mean += fabs(x[i]) / (double)n;
    fair->least = fmax(0.04 * (high - low), 0.05 * mean);
    fair->calmest = variation_of(x, n, &fair->peak);
    fair->extrema = extrema(x, n, fair->least, 0, NULL);
    fair->inflections = inflections(x, n);
}

bool bat_energy_guard(bat_local_machine *k) {
    enum { PLACES = 16 };
    bat_fairing *fair = &k->fairing;
    const size_t n = k->problem->count;
    size_t at[PLACES];
    double peak;
    curvature(k, fair->spare);
    fair->variation = variation_of(fair->spare, n, &peak);
    const int found = extrema(fair->spare, n, fair->least, PLACES, at);
    if (found <= fair->extrema && inflections(fair->spare, n) <= fair->inflections &&
        peak <= peak_slack * fair->peak + fair->least)
        return true;
    /* Where it leaves the fair curve's curvature most of all, of these. */
    size_t worst = 0;
    double most = -1;
    for (int i = 0; i < found && i < PLACES; i++) {
        const double off = fabs(fair->spare[at[i]] - fair->curvature[at[i]]);
        if (off > most) most = off, worst = at[i];
    }
    if (most >= 0) k->slow[k->slow_count++] = k->problem->w[worst];
    return false;
}
