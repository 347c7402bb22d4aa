#include "curve/pieces_run.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = BAT_RUN_FREE * BAT_DIMENSION_MAX, USED = 40, ROUNDS = 60 };

/* v (1 - v) Legendre_k(2 v - 1), and derivatives. */
static void shapes(int free, double v, double *value, double *slope) {
    const double t = 2 * v - 1, w = v * (1 - v), w1 = 1 - 2 * v;
    double a = 1, b = t, a1 = 0, b1 = 2;
    for (int k = 0; k < free; k++) {
        value[k] = w * a, slope[k] = w1 * a + w * a1;
        const double c = ((2 * k + 3) * t * b - (k + 1) * a) / (k + 2);
        const double c1 = ((2 * k + 3) * (2 * b + t * b1) - (k + 1) * a1) / (k + 2);
        a = b, b = c, a1 = b1, b1 = c1;
    }
}

void bat_run_look(const bat_run *c, double v, double *at, double *slope) {
    double value[BAT_RUN_FREE], change[BAT_RUN_FREE];
    shapes(c->free, v, value, change);
    for (int i = 0; i < c->m; i++) {
        at[i] = c->start[i] + v * c->way[i], slope[i] = c->way[i];
        for (int k = 0; k < c->free; k++)
            at[i] += value[k] * c->part[k][i], slope[i] += change[k] * c->part[k][i];
    }
}

double bat_run_dot(const double *a, const double *b, int m) {
    double sum = 0;
    for (int i = 0; i < m; i++) sum += a[i] * b[i];
    return sum;
}

double bat_run_apart(const double *a, const double *b, int m) {
    double sum = 0;
    for (int c = 0; c < m; c++) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

/* The parameter nearest to a point from a guess on; the distance. */
double bat_run_foot(const bat_run *c, const double *x, double *v) {
    double at[BAT_DIMENSION_MAX], slope[BAT_DIMENSION_MAX], off[BAT_DIMENSION_MAX];
    for (int round = 0; round < 5; round++) {
        bat_run_look(c, *v, at, slope);
        for (int i = 0; i < c->m; i++) off[i] = x[i] - at[i];
        const double speed2 = bat_run_dot(slope, slope, c->m);
        if (!(speed2 > 0)) return INFINITY;
        const double step = bat_run_dot(off, slope, c->m) / speed2;
        *v += step;
        if (fabs(step) < 1e-14) break;
    }
    bat_run_look(c, *v, at, slope);
    for (int i = 0; i < c->m; i++) off[i] = x[i] - at[i];
    return sqrt(bat_run_dot(off, off, c->m));
}

double bat_run_next(const bat_run *c, const double *x, double v) {
    double at[BAT_DIMENSION_MAX], slope[BAT_DIMENSION_MAX], step = 0;
    bat_run_look(c, v, at, slope);
    for (int i = 0; i < c->m; i++) step += (x[i] - at[i]) * slope[i];
    return v + step / fmax(bat_run_dot(slope, slope, c->m), DBL_MIN);
}

/* Least squares by Householder's reflections: rows of columns + 1 numbers, the last is the right-hand side. */
void bat_run_least_squares(double *a, int rows, int columns, double *x) {
    const int wide = columns + 1;
    double most = 0;
    for (int k = 0; k < columns; k++) {
        double norm = 0;
        for (int i = k; i < rows; i++) norm += a[i * wide + k] * a[i * wide + k];
        norm = sqrt(norm);
        most = fmax(most, norm);
        if (!(norm > 1e-13 * most)) {
            for (int i = k; i < rows; i++) a[i * wide + k] = 0;
            continue;
        }
        const double head = a[k * wide + k] > 0 ? -norm : norm, pivot = a[k * wide + k] - head;
        for (int j = k + 1; j < wide; j++) {
            double sum = pivot * a[k * wide + j];
            for (int i = k + 1; i < rows; i++) sum += a[i * wide + k] * a[i * wide + j];
            const double f = sum / (head * pivot);
            a[k * wide + j] += f * pivot;
            for (int i = k + 1; i < rows; i++) a[i * wide + j] += f * a[i * wide + k];
        }
        a[k * wide + k] = head;
        for (int i = k + 1; i < rows; i++) a[i * wide + k] = 0;
    }
    for (int k = columns; k-- > 0;) {
        double sum = a[k * wide + columns];
        for (int j = k + 1; j < columns; j++) sum -= a[k * wide + j] * x[j];
        x[k] = a[k * wide + k] != 0 ? sum / a[k * wide + k] : 0;
    }
}

const double *bat_run_sample(const bat_pieces *h, size_t i) {
    return h->points + i % h->count * (size_t)h->dimension;
}

/* The rows of one sample: what moves the curve towards it, along the curve left out. */
static double *put_rows(const bat_run *c, const double *x, double v, bool across, double *row) {
    const int m = c->m, columns = c->free * m;
    double at[BAT_DIMENSION_MAX], t[BAT_DIMENSION_MAX], value[BAT_RUN_FREE], change[BAT_RUN_FREE];
    bat_run_look(c, v, at, t);
    shapes(c->free, v, value, change);
    const double length2 = bat_run_dot(t, t, m), keep = across && length2 > 0 ? 1 / length2 : 0;
    for (int i = 0; i < m; i++, row += columns + 1) {
        row[columns] = 0;
        for (int j = 0; j < m; j++) {
            const double part = (i == j ? 1 : 0) - keep * t[i] * t[j];
            for (int k = 0; k < c->free; k++) row[k * m + j] = part * value[k];
            row[columns] += part * (x[j] - at[j]);
        }
    }
    return row;
}

typedef struct chosen { /* samples that a piece is fitted to */
    int count;
    const double *at[USED];
    double v[USED];
} chosen;

/* By lengths of chords; false: all are one. */
static bool choose(const bat_pieces *h, size_t from, size_t count, chosen *s) {
    const double *before = bat_run_sample(h, from);
    double length = 0;
    s->count = count < USED ? (int)count : USED;
    if (s->count < 2) return false;
    for (int i = 0; i < s->count; i++) {
        s->at[i] = bat_run_sample(h, from + (size_t)i * (count - 1) / (size_t)(s->count - 1));
        s->v[i] = length += bat_run_apart(s->at[i], before, h->dimension), before = s->at[i];
    }
    for (int i = 0; i < s->count && length > 0; i++) s->v[i] /= length;
    return length > 0;
}

/* The sum of the squared distances; parameters become those of the nearest places. */
static double approach(const bat_run *c, chosen *s, double *worst) {
    double sum = 0;
    *worst = 0;
    for (int i = 1; i + 1 < s->count; i++) {
        const double off = bat_run_foot(c, s->at[i], &s->v[i]);
        sum += off * off, *worst = fmax(*worst, off);
    }
    return isfinite(sum) ? sum : INFINITY;
}

/* Moves by a step if that comes nearer. */
static bool move(bat_run *c, chosen *s, const double *step, double *sum, double *worst) {
    bat_run trial = *c;
    chosen there = *s;
    double off;
    for (int k = 0; k < c->free; k++)
        for (int i = 0; i < c->m; i++) trial.part[k][i] += step[k * c->m + i];
    const double found = approach(&trial, &there, &off);
    if (!(found < *sum)) return false;
    *c = trial, *s = there, *sum = found, *worst = off;
    return true;
}

/* The piece through count samples from `from` on; the greatest distance of those that are used. */
static double fit_from(const bat_pieces *h, size_t from, size_t count, const double lean[2], bat_run *c) {
    const int m = h->dimension, columns = (h->degree - 1) * m;
    double rows[(USED * BAT_DIMENSION_MAX + COLUMNS) * (COLUMNS + 1)], x[COLUMNS], worst = INFINITY,
                                                                                   sum = INFINITY;
    double before = INFINITY;
    double held = 0; /* Levenberg's: steps are short at first, for most of what is free hardly matters */
    chosen s;
    *c = (bat_run){.free = h->degree - 1, .m = m};
    if (!choose(h, from, count, &s)) return INFINITY;
    for (int i = 0; i < s.count; i++)
        s.v[i] += s.v[i] * (1 - s.v[i]) * (lean[0] + lean[1] * (1 - 2 * s.v[i]));
    for (int i = 0; i < m; i++) c->start[i] = s.at[0][i], c->way[i] = s.at[s.count - 1][i] - s.at[0][i];
    for (int round = 0; round < ROUNDS && !(worst <= 0.1 * BAT_RUN_SURE * h->noise); round++) {
        double *row = rows;
        for (int i = 1; i + 1 < s.count; i++) row = put_rows(c, s.at[i], s.v[i], round > 0, row);
        int count_rows = (s.count - 2) * m;
        for (int k = 0; k < columns && round > 0; k++, row += columns + 1, count_rows++) {
            memset(row, 0, (size_t)(columns + 1) * sizeof *row);
            row[k] = held;
        }
        bat_run_least_squares(rows, count_rows, columns, x);
        const bool better = move(c, &s, x, &sum, &worst);
        held = round == 0 ? 1e-2 : better ? 0.1 * held : 3 * held;
        if (!isfinite(sum) || (round % 6 == 5 && sum > 0.95 * before)) break;
        if (round % 6 == 5) before = sum;
    }
    return worst;
}

/* Keeps the nearer of two. */
static void try_from(const bat_pieces *h, size_t from, size_t count, double a, double b, double *best,
                     bat_run *c) {
    const double lean[2] = {a, b};
    bat_run trial;
    const double off = *best <= BAT_RUN_SURE * h->noise ? INFINITY : fit_from(h, from, count, lean, &trial);
    if (off < *best) *best = off, *c = trial;
}

/* How the parameter's speed along the curve changes at an end of a piece, of itself, a px: the neighbour's does, too. */
static double change_at(const bat_run *c, double end) {
    const double step = end > 0 ? -1e-4 : 1e-4;
    double at[BAT_DIMENSION_MAX], here[BAT_DIMENSION_MAX], inside[BAT_DIMENSION_MAX];
    bat_run_look(c, end, at, here), bat_run_look(c, end + step, at, inside);
    const double speed2 = bat_run_dot(here, here, c->m);
    return -(bat_run_dot(here, inside, c->m) - speed2) / (step * speed2 * sqrt(speed2));
}

static double chords(const bat_pieces *h, size_t from, size_t count) {
    double length = 0;
    for (size_t i = 1; i < count; i++)
        length += bat_run_apart(bat_run_sample(h, from + i - 1), bat_run_sample(h, from + i), h->dimension);
    return length;
}

/* From parameters that change as the neighbours' do: v = s + s (1 - s) (a + b (1 - 2 s)). */
static void try_beside(const bat_pieces *h, size_t from, size_t count, const bat_run *const beside[2],
                       double *best, bat_run *c) {
    const double length = chords(h, from, count);
    const double r = beside[0] ? fmax(length * change_at(beside[0], 1), -1.5) : 0;
    if (beside[0] && beside[1]) {
        const double q = length * change_at(beside[1], 0), k[4] = {-2 - r, -6 - r, q - 2, 6 - q};
        const double whole = k[0] * k[3] - k[1] * k[2];
        try_from(h, from, count, (r * k[3] - k[1] * q) / whole, (k[0] * q - r * k[2]) / whole, best, c);
    }
    for (int i = 0; i < 7 && beside[0]; i++) {
        const double b = 0.2 * (i % 2 ? (i + 1) / 2 : -i / 2);
        try_from(h, from, count, -(r + b * (r + 6)) / (2 + r), b, best, c);
    }
}

/* Curves that touch a piece to the same order come in several branches: from other parameters others are found. beside:
 * the piece before it and the one after it, or NULL. */
static double fit(const bat_pieces *h, size_t from, size_t count, const bat_run *const beside[2],
                  bat_run *c) {
    double best = INFINITY;
    try_beside(h, from, count, beside, &best, c);
    for (int ring = 0; ring < 4 && !beside[1]; ring++)
        for (int i = -ring; i <= ring; i++) {
            const double a = 0.3 * i, b = 0.3 * (ring - abs(i));
            try_from(h, from, count, a, b, &best, c);
            if (b > 0) try_from(h, from, count, a, -b, &best, c);
        }
    return best;
}

/* As many samples as a fit needs to be a test. */
size_t bat_run_least(const bat_pieces *h) {
    const int m = h->dimension;
    return (size_t)(3 + ((h->degree - 1) * m + m - 2) / (m - 1));
}

/* Between samples range[0] and range[1] - 1, without those beside a knot: a peak tells its place but for a sample or
 * two. c: kept, if it is nearer than what is found. */
double bat_run_fit(const bat_pieces *h, const size_t range[2], const bool knots[2],
                   const bat_run *const beside[2], double best, bat_run *c) {
    for (size_t off = 1; off < 3 && !(best <= BAT_RUN_SURE * h->noise); off++) {
        const size_t from = range[0] + (knots[0] ? off : 0), to = range[1] - (knots[1] ? off : 0);
        bat_run trial;
        const double found = to >= from + bat_run_least(h) ? fit(h, from, to - from, beside, &trial)
                                                           : INFINITY;
        if (found < best) best = found, *c = trial;
    }
    return best;
}
