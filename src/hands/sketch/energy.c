/* The penalty of the fit is the change of curvature (docs/math sketch 5.7). With a speed near 1, C''' + k^2 C' is the
 * change of curvature times the normal, for the curvature k of the last solve: lines and circles cost nothing, and the
 * problem stays quadratic. */
#include "hands/sketch/fit_interval.h"
#include "base/lanes.h"

#include <math.h>
#include <string.h>

static const double tightest = 0.2; /* curvature, 1/px: beyond it the term would only do harm */

/* The point of a slot's local polynomials at x in -1..1, and its derivatives by x up to order 3. */
BAT_INLINE void jet_at(const double *local, const int p, const int m, double x,
                       double jet[4][BAT_DIMENSION_MAX]) {
    for (int c = 0; c < m; c++) {
        double f[4] = {0};
        for (int j = p; j >= 0; j--) {
            for (int d = 3; d > 0; d--) f[d] = f[d] * x + f[d - 1];
            f[0] = f[0] * x + local[j * m + c];
        }
        jet[0][c] = f[0], jet[1][c] = f[1], jet[2][c] = 2 * f[2], jet[3][c] = 6 * f[3];
    }
}

BAT_INLINE double dot(const double *a, const double *b, const int m) {
    double sum = 0;
    for (int c = 0; c < m; c++) sum += a[c] * b[c];
    return sum;
}

static double half_of(const bat_local_machine *k, int slot) {
    const double *t = k->space.knots + k->problem->degree;
    return 0.5 * (t[slot + 1] - t[slot]);
}

/* The factor on C' at sample i. */
static double turn_at(const bat_local_machine *k, size_t i) {
    const double v = k->problem->law[i];
    return k->bend[i] * v * v;
}

/* The square of the curvature. */
BAT_INLINE double bend_of(double jet[4][BAT_DIMENSION_MAX], const int m) {
    const double v2 = dot(jet[1], jet[1], m), va = dot(jet[1], jet[2], m);
    const double area = v2 * dot(jet[2], jet[2], m) - va * va; /* not fmax: a call, in an inner loop */
    return v2 > 0 ? (area > 0 ? area : 0) / (v2 * v2 * v2) : 0;
}

/* What is known of the last solve at the samples of slot s. */
BAT_INLINE void read_slot(bat_local_machine *k, const int p, const int m, int s, double *points) {
    const bat_local_problem *q = k->problem;
    const double *t = k->space.knots + q->degree, half = half_of(k, s);
    const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
    for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
        double jet[4][BAT_DIMENSION_MAX];
        jet_at(local, p, m, half > 0 ? (q->w[i] - t[s]) / half - 1 : 0, jet);
        const double bend = bend_of(jet, m);
        k->bend[i] = bend < tightest * tightest ? bend : tightest * tightest;
        const double turn = turn_at(k, i);
        for (int c = 0; c < m; c++) {
            points[i * (size_t)m + (size_t)c] = jet[0][c];
            k->pull[i * (size_t)m + (size_t)c] =
                half > 0 ? jet[3][c] / (half * half * half) + turn * jet[1][c] / half : 0;
        }
    }
}

BAT_INLINE void curve_slot(bat_local_machine *k, const int p, const int m, int s) {
    const bat_local_problem *q = k->problem;
    const double *t = k->space.knots + q->degree, half = half_of(k, s);
    const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
    for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
        double jet[4][BAT_DIMENSION_MAX];
        jet_at(local, p, m, half > 0 ? (q->w[i] - t[s]) / half - 1 : 0, jet);
        const bool right = m == 2 && jet[1][0] * jet[2][1] < jet[1][1] * jet[2][0];
        k->curvature[i] = (right ? -1 : 1) * sqrt(bend_of(jet, m));
    }
}

/* Numbers in the place of degree and dimension let compilers unroll the loops. */
static bool is_plane_cubic(const bat_local_machine *k) {
    return k->problem->degree == 3 && k->problem->dimension == 2;
}

void bat_local_read(bat_local_machine *k, double *points) {
    const bool plain = is_plane_cubic(k);
    for (int s = 0; s < bat_lsq_slots(&k->space); s++)
        if (plain)
            read_slot(k, 3, 2, s, points);
        else
            read_slot(k, k->problem->degree, k->problem->dimension, s, points);
    k->bent = true;
}

void bat_local_curvature(bat_local_machine *k) {
    const bool plain = is_plane_cubic(k);
    for (int s = 0; s < bat_lsq_slots(&k->space); s++)
        if (plain)
            curve_slot(k, 3, 2, s);
        else
            curve_slot(k, k->problem->degree, k->problem->dimension, s);
}

/* C''' + turn C' at x of a slot, as numbers for its basis functions. */
BAT_INLINE void energy_row(const double *T, const int p, double x, double half, double turn, double *row) {
    const int w = p + 1;
    for (int j = 0; j < w; j++) {
        double first = 0, third = 0;
        for (int n = p; n >= 1; n--) first = first * x + n * T[n * w + j];
        for (int n = p; n >= 3; n--) third = third * x + n * (n - 1) * (n - 2) * T[n * w + j];
        row[j] = third / (half * half * half) + turn * first / half;
    }
}

BAT_INLINE void add_row(bat_local_machine *k, const int p, const int m, int slot, double scale,
                        const double *row, const double *pull) {
    const int w = p + 1;
    for (int r = 0; r < w; r++) {
        const size_t unknown = (size_t)bat_lsq_unknown(&k->space, slot + r);
        double *a = k->a + unknown * (size_t)w, *b = k->b + unknown * (size_t)m;
        for (int d = 0; d <= r; d++) a[d] += scale * row[r] * row[r - d];
        for (int c = 0; c < m && k->pulled; c++) b[c] += scale * row[r] * pull[c];
    }
}

BAT_INLINE void energy_of(bat_local_machine *k, const int p, const int m, double mu) {
    static const double place[3] = {-0.774596669241483377, 0, 0.774596669241483377};
    static const double share[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    const bat_local_problem *q = k->problem;
    const int w = p + 1;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        const double half = half_of(k, s);
        if (!(half > 0)) continue;
        const double *T = k->memo[0].transforms + (size_t)s * (size_t)(w * w);
        const size_t from = k->first[s], count = k->first[s + 1] - from;
        for (int g = 0; g < 3; g++) {
            size_t i = from + (size_t)(0.5 * (1 + place[g]) * (double)count);
            if (i >= q->count) i = q->count - 1;
            double row[BAT_DEGREE_MAX + 1];
            energy_row(T, p, place[g], half, turn_at(k, i), row);
            add_row(k, p, m, s, mu * k->factor[s] * share[g] * half, row, k->pull + i * (size_t)m);
        }
    }
}

void bat_local_energy(bat_local_machine *k, double mu) {
    if (is_plane_cubic(k))
        energy_of(k, 3, 2, mu);
    else
        energy_of(k, k->problem->degree, k->problem->dimension, mu);
}
