/*
 * The least squares of a sketch at a level (math 3.6): rows that pull C^level to the stroke, and rows of no
 * displacement beyond both of its ends. Without the latter, coefficients that the stroke barely meets have
 * almost no equation and swing. Lengths along the curve are counted in spans, so that short and long spans
 * count alike.
 */
#include "hands/levels/fit.h"

#include "base/bisect.h"
#include "base/order.h"
#include "curve/banded.h"
#include "curve/curve.h"

#include <stdlib.h>
#include <string.h>

enum { ROWS = 16, ROWS_LEAST = 8, TRIES = 24 }; /* rows of no displacement: per span; least per side */
static const double MU = 1e-6, NU = 1e-3;
static const double FIRM = 1000; /* what a row weighs at two spans from the stroke; 1 at one span */
/* How much of the stroke's largest displacement is let through beyond its ends, and beyond two spans: a
 * little less than the bars of math 3.6, since the rows lie some way apart. */
static const double MOST_OUTSIDE = 0.995, MOST_FAR = 0.055;
static const double FIRMER = 4; /* factor on the rows' weight where more than that comes through */

/* One side: from an end of the stroke outwards, to where the curve ends or the other side's half of the gap
 * begins. */
typedef struct side {
    double from, sign, length; /* in spans */
    int rows;
} side;

typedef struct fit {
    const bat_curve *curve;
    int band, spans;
    double *breaks; /* spans + 1: the distinct knots of the domain */
    double covered; /* spans that the stroke covers */
    double weight;  /* of the stroke's rows in one span */
    double largest; /* displacement that the stroke asks for */
    side sides[2];
    bool *met;                  /* coefficients that the stroke meets */
    double *pull, *hold, *work; /* normal matrices: of the stroke, of what is to stay, of both */
    double *border, *right, *deltas, *places;
} fit;

static void fit_free(fit *f) {
    free(f->breaks);
    free(f->met);
    free(f->pull);
    free(f->border);
    free(f->right);
    free(f->places);
}

static bat_status fit_make(const bat_curve *curve, size_t count, fit *f) {
    int p = curve->degree, n = curve->count,
        band = p > 2 ? p : 2; /* second differences reach two neighbours */
    size_t cells = (size_t)n * (size_t)(band + 1), numbers = (size_t)n * (size_t)curve->dimension;
    *f = (fit){.curve = curve, .band = band};
    f->breaks = malloc((size_t)(curve->spread - p + 1) * sizeof(double));
    f->met = calloc((size_t)n, sizeof(bool));
    f->pull = calloc(3 * cells, sizeof(double));
    f->border = malloc((bat_cyclic_room(n, band) + 1) * sizeof(double));
    f->right = calloc(2 * numbers, sizeof(double));
    f->places = malloc(count * sizeof(double));
    if (!f->breaks || !f->met || !f->pull || !f->border || !f->right || !f->places) {
        fit_free(f);
        return BAT_MEMORY;
    }
    f->hold = f->pull + cells, f->work = f->hold + cells, f->deltas = f->right + numbers;
    f->breaks[0] = curve->knots[p];
    for (int i = p + 1; i <= curve->spread; i++)
        if (curve->knots[i] > f->breaks[f->spans]) f->breaks[++f->spans] = curve->knots[i];
    return BAT_OK;
}

/* ---- where the stroke lies ---- */

/* The number of spans before u, and the inverse. */
static double place_of(const fit *f, double u) {
    const size_t i = bat_bisect(f->breaks, (size_t)f->spans + 1, u);
    return (double)i + (u - f->breaks[i]) / (f->breaks[i + 1] - f->breaks[i]);
}

static double parameter_at(const fit *f, double place) {
    if (f->curve->closed) place -= floor(place / f->spans) * f->spans;
    int i = (int)place;
    if (i >= f->spans) return f->breaks[f->spans];
    return f->breaks[i] + (place - i) * (f->breaks[i + 1] - f->breaks[i]);
}

/* An open curve is covered from the first parameter to the last, a closed one all round except for the
 * longest gap. */
static void find_sides(fit *f, size_t count, const double *u) {
    const bat_curve *curve = f->curve;
    double *at = f->places, room[2];
    for (size_t i = 0; i < count; i++) at[i] = bat_curve_reduce(curve, u[i]);
    qsort(at, count, sizeof *at, bat_ascending); /* no ties that could be told apart */
    size_t last = count - 1; /* in the stroke's order, when the longest gap lies behind it */
    double gap = at[0] + curve->knots[curve->spread] - curve->knots[curve->degree] - at[last];
    for (size_t i = 1; i < count && curve->closed; i++)
        if (at[i] - at[i - 1] > gap) gap = at[i] - at[i - 1], last = i - 1;
    double low = place_of(f, at[(last + 1) % count]), high = place_of(f, at[last]);
    if (high < low) high += f->spans;
    f->covered = high - low;
    f->weight = (double)count / fmax(f->covered, 1);
    room[0] = low, room[1] = f->spans - high;
    if (curve->closed) room[0] = room[1] = (f->spans - f->covered) / 2;
    for (int k = 0; k < 2; k++) {
        double length = fmin(room[k], curve->degree + 1); /* beyond all that the stroke meets */
        int rows = length > 0 ? (int)ceil(ROWS * length) : 0;
        f->sides[k] = (side){.from = k == 0 ? low : high,
                             .sign = k == 0 ? -1 : 1,
                             .length = length,
                             .rows = rows > 0 && rows < ROWS_LEAST ? ROWS_LEAST : rows};
    }
}

/* ---- rows ---- */

/* A row of the matrix: basis functions at u. Closed curves of few points may meet one of them twice or
 * more. */
typedef struct row {
    int first;
    double basis[BAT_DEGREE_MAX + 1];
} row;

static row row_at(const fit *f, double u) {
    row r;
    bat_curve_basis(f->curve, u, &r.first, r.basis);
    return r;
}

/* Row k of a side, 0 at the stroke's end; *away: spans from the stroke. */
static row still_row(const fit *f, const side *s, int k, double *away) {
    *away = s->length * k / s->rows;
    return row_at(f, parameter_at(f, s->from + s->sign * *away));
}

/* Adds w (sum_k c_k x_{first + k})^2 to a banded matrix (closed: modulo n). */
static void add_square(const fit *f, double *a, int first, int terms, const double *c, double w) {
    int n = f->curve->count;
    for (int r = 0; r < terms; r++)
        for (int s = 0; s <= r; s++) {
            int at = f->curve->closed ? (first + r) % n : first + r;
            a[at * (f->band + 1) + r - s] += w * c[r] * c[s];
        }
}

static void add_stroke(fit *f, size_t count, const double *u, const double *targets) {
    const bat_curve *curve = f->curve;
    int p = curve->degree, size = curve->dimension, n = curve->count;
    const double none[BAT_DIMENSION_MAX] = {0}, second[3] = {1, -2, 1};
    for (size_t i = 0; i < count; i++) {
        row r = row_at(f, u[i]);
        double at[BAT_DIMENSION_MAX];
        bat_curve_eval(curve, u[i], 0, at);
        for (int d = 0; d < size; d++) at[d] = targets[i * (size_t)size + (size_t)d] - at[d];
        f->largest = fmax(f->largest, bat_distance(at, none, size));
        add_square(f, f->pull, r.first, p + 1, r.basis, 1);
        for (int k = 0; k <= p; k++) {
            int to = (r.first + k) % n;
            if (r.basis[k] != 0) f->met[to] = true;
            for (int d = 0; d < size; d++) f->right[to * size + d] += r.basis[k] * at[d];
        }
    }
    for (int i = 0; i < (curve->closed ? n : n - 2); i++) add_square(f, f->pull, i, 3, second, NU);
    for (int i = 0; i < n; i++) {
        f->pull[i * (f->band + 1)] += MU;
        for (int d = 0; d < size && !f->met[i]; d++) f->right[i * size + d] = 0;
    }
}

/* Their weight per span rises from zero at the stroke's end to that of the stroke's own rows one span away,
 * and goes on rising until it keeps all the rest in place. */
static void add_still(fit *f) {
    for (int i = 0; i < 2; i++)
        for (int k = 1; k <= f->sides[i].rows; k++) {
            double away;
            row r = still_row(f, &f->sides[i], k, &away);
            double firm = away < 1 ? away : 1 + (FIRM - 1) * fmin(away - 1, 1);
            add_square(f, f->hold, r.first, f->curve->degree + 1, r.basis,
                       firm * f->weight * f->sides[i].length / f->sides[i].rows);
        }
}

/* ---- the solution ---- */

/* A coefficient that the stroke misses stays exactly as it is: its row and column become the identity. */
static void leave_out(const fit *f, int i) {
    int n = f->curve->count, band = f->band;
    double *a = f->work;
    for (int k = 1; k <= band; k++) {
        a[i * (band + 1) + k] = 0;
        int right = f->curve->closed ? (i + k) % n : i + k;
        if (right < n) a[right * (band + 1) + k] = 0;
    }
    a[i * (band + 1)] = 1;
}

/* firmness: a factor on the rows of no displacement. */
static bat_status solve(fit *f, double firmness) {
    int n = f->curve->count, band = f->band, size = f->curve->dimension;
    for (int i = 0; i < n * (band + 1); i++) f->work[i] = f->pull[i] + firmness * f->hold[i];
    for (int i = 0; i < n; i++)
        if (!f->met[i]) leave_out(f, i);
    memcpy(f->deltas, f->right, (size_t)(n * size) * sizeof(double));
    bat_status status = f->curve->closed ? bat_cyclic_factor(f->work, n, band, f->border)
                                         : bat_banded_factor(f->work, n, band);
    if (status != BAT_OK) return status;
    if (f->curve->closed)
        bat_cyclic_solve(f->work, n, band, f->border, f->deltas, size);
    else
        bat_banded_solve(f->work, n, band, f->deltas, size);
    return BAT_OK;
}

/* Whether too much of the stroke's displacement comes through beyond its ends. */
static bool strays(const fit *f) {
    int n = f->curve->count, size = f->curve->dimension;
    const double none[BAT_DIMENSION_MAX] = {0};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k <= f->sides[i].rows && f->sides[i].rows > 0; k++) {
            double away, moved[BAT_DIMENSION_MAX] = {0};
            row r = still_row(f, &f->sides[i], k, &away);
            for (int j = 0; j <= f->curve->degree; j++)
                for (int d = 0; d < size; d++)
                    moved[d] += r.basis[j] * f->deltas[(r.first + j) % n * size + d];
            if (bat_distance(moved, none, size) > (away < 2 ? MOST_OUTSIDE : MOST_FAR) * f->largest)
                return true;
        }
    return false;
}

/* The shortest run of coefficients that holds all that move; on a closed curve it begins behind the longest
 * gap. */
static void moved_run(const fit *f, int *first, int *count) {
    int n = f->curve->count, gap = 0, best = 0;
    *first = 0, *count = n;
    if (!f->curve->closed) {
        while (*first < n && !f->met[*first]) (*first)++;
        while (*count > 0 && !f->met[*count - 1]) (*count)--;
        *count -= *first;
        return;
    }
    for (int i = 0; i < 2 * n; i++) {
        gap = f->met[i % n] ? 0 : gap + 1;
        if (gap > best && gap < n) best = gap, *first = (i + 1) % n;
    }
    *count = n - best;
}

static bat_status move(const fit *f, bat_shape *shape, int level) {
    int first, count, n = f->curve->count;
    size_t size = (size_t)f->curve->dimension;
    moved_run(f, &first, &count);
    double *deltas = malloc((size_t)count * size * sizeof(double));
    if (!deltas) return BAT_MEMORY;
    for (int i = 0; i < count; i++)
        memcpy(deltas + (size_t)i * size, f->deltas + (size_t)((first + i) % n) * size,
               size * sizeof(double));
    bat_status status = bat_shape_move_many(shape, level, first, (size_t)count, deltas);
    free(deltas);
    return status;
}

bat_status bat_level_fit(bat_shape *shape, int level, size_t count, const double *u, const double *targets,
                         double *spans) {
    if (!shape || level < 0 || level > bat_shape_levels(shape)) return BAT_ARGUMENT;
    if (!u || !targets || count < 1) return BAT_ARGUMENT;
    if (count > BAT_POINTS_MAX) return BAT_COUNT;
    const bat_curve *curve = bat_shape_curve(shape, level);
    for (size_t i = 0; i < count * (size_t)curve->dimension; i++)
        if (!(fabs(targets[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(u[i])) return BAT_NUMBER;
    fit f;
    bat_status status = fit_make(curve, count, &f);
    if (status != BAT_OK) return status;
    find_sides(&f, count, u);
    add_stroke(&f, count, u, targets);
    add_still(&f);
    double firmness = 1;
    status = solve(&f, firmness);
    for (int k = 0; k < TRIES && status == BAT_OK && strays(&f); k++) status = solve(&f, firmness *= FIRMER);
    *spans = f.covered;
    if (status == BAT_OK) status = move(&f, shape, level);
    fit_free(&f);
    return status;
}

bat_status bat_shape_sketch(bat_shape *shape, int level, size_t count, const double *u,
                            const double *targets) {
    double spans;
    return bat_level_fit(shape, level, count, u, targets, &spans);
}
