/* A rational surface becomes a grid of bicubic patches: each has the positions, the first derivatives and the mixed one of
 * the rational surface at its corners (a Hermite interpolant). Lines are added to the grid until all patches are near. */
#include "base/real.h"
#include "format/model/full.h"
#include "format/model/rational.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TESTS = 6, CELLS_MAX = 1 << 14, ROUNDS = 16 };
static const double SMOOTH = 1e-8;

typedef struct net {
    bat_surface *over, *under; /* the sum of weights times points; the sum of weights, with zeros beside it */
    double tolerance, size, begun; /* begun: cells at first */
    bat_numbers lines[2];          /* the parameters of the grid's lines, ascending */
} net;

/* S, S_u, S_v, S_uv, 3 numbers each. */
static void evaluate(const net *n, double u, double v, double out[12]) {
    double a[18], w[18];
    bat_surface_eval(n->over, u, v, 2, a);
    bat_surface_eval(n->under, u, v, 2, w);
    for (int k = 0; k < 3; k++) {
        out[k] = a[k] / w[0];
        out[3 + k] = (a[3 + k] - w[3] * out[k]) / w[0];
        out[6 + k] = (a[6 + k] - w[6] * out[k]) / w[0];
        out[9 + k] = (a[12 + k] - w[3] * out[6 + k] - w[6] * out[3 + k] - w[12] * out[k]) / w[0];
    }
}

static void find_cell(const net *n, size_t i, size_t j, double range[4]) {
    memcpy(range, n->lines[0].list + i, 2 * sizeof *range);
    memcpy(range + 2, n->lines[1].list + j, 2 * sizeof *range);
}

/* Just before the line, where the surface is as the patch before it has it. */
static double before(const net *n, int d, double line) {
    return line < n->lines[d].list[n->lines[d].count - 1] ? nextafter(line, -INFINITY) : line;
}

/* The 4 by 4 Bézier points of the patch over [u0, u1] x [v0, v1], u slowest. What lies at its far sides is as the patch
 * itself has it there, and not its neighbour. */
static void make_patch(const net *n, const double range[4], double out[48]) {
    const double third[2] = {(range[1] - range[0]) / 3, (range[3] - range[2]) / 3};
    for (int corner = 0; corner < 4; corner++) {
        const int i = corner / 2, j = corner % 2;
        double at[12];
        evaluate(n, i ? before(n, 0, range[1]) : range[0], j ? before(n, 1, range[3]) : range[2], at);
        const double du = i ? -third[0] : third[0], dv = j ? -third[1] : third[1];
        double *p = out + 12 * (3 * i) + 3 * (3 * j), *pu = p + (i ? -12 : 12), *pv = p + (j ? -3 : 3);
        double *puv = pu + (j ? -3 : 3);
        for (int k = 0; k < 3; k++) {
            p[k] = at[k];
            pu[k] = at[k] + du * at[3 + k];
            pv[k] = at[k] + dv * at[6 + k];
            puv[k] = at[k] + du * at[3 + k] + dv * at[6 + k] + du * dv * at[9 + k];
        }
    }
}

static void bernstein(double t, double out[4]) {
    const double s = 1 - t;
    out[0] = s * s * s, out[1] = 3 * s * s * t, out[2] = 3 * s * t * t, out[3] = t * t * t;
}

static double miss(const net *n, const double range[4], const double patch[48], int i, int j) {
    double bu[4], bv[4], here[3] = {0, 0, 0}, there[12];
    const double t = i / (double)TESTS, s = j / (double)TESTS;
    bernstein(t, bu), bernstein(s, bv);
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++)
            for (int k = 0; k < 3; k++) here[k] += bu[a] * bv[b] * patch[12 * a + 3 * b + k];
    evaluate(n, range[0] + t * (range[1] - range[0]), range[2] + s * (range[3] - range[2]), there);
    return bat_hypot(bat_hypot(here[0] - there[0], here[1] - there[1]), here[2] - there[2]);
}

/* Whether the patch needs another line across u, across v. */
static void judge(const net *n, const double range[4], bool more[2]) {
    double patch[48], all = 0, along[2] = {0, 0};
    make_patch(n, range, patch);
    for (int i = 0; i <= TESTS; i++)
        for (int j = 0; j <= TESTS; j++) {
            const double off = miss(n, range, patch, i, j);
            if (!(off <= all)) all = off; /* NaN counts */
            if (j % TESTS == 0) along[0] = fmax(along[0], off);
            if (i % TESTS == 0) along[1] = fmax(along[1], off);
        }
    if (all <= n->tolerance) return;
    const bool u = along[0] > n->tolerance / 4, v = along[1] > n->tolerance / 4;
    more[0] = more[0] || u || !v;
    more[1] = more[1] || v || !u;
}

/* The lines with the middles of the marked intervals. */
static bat_status halve(bat_numbers *lines, const bool *marked) {
    bat_numbers out = {0};
    bool fits = true;
    for (size_t i = 0; i < lines->count && fits; i++) {
        const double at = lines->list[i];
        fits = bat_numbers_add(&out, at);
        if (i + 1 == lines->count || !marked[i]) continue;
        const double middle = at + (lines->list[i + 1] - at) / 2;
        if (fits && at < middle && middle < lines->list[i + 1]) fits = bat_numbers_add(&out, middle);
    }
    bat_numbers_clear(fits ? lines : &out);
    if (!fits) return BAT_MEMORY;
    *lines = out;
    return BAT_OK;
}

/* Adds lines once. *done: none was needed. */
static bat_status refine(net *n, bool *done) {
    const size_t nu = n->lines[0].count - 1, nv = n->lines[1].count - 1;
    bool *marks = calloc(nu + nv, sizeof *marks);
    if (!marks) return BAT_MEMORY;
    *done = true;
    for (size_t i = 0; i < nu; i++)
        for (size_t j = 0; j < nv; j++) {
            double range[4];
            bool more[2] = {false, false};
            find_cell(n, i, j, range);
            judge(n, range, more);
            marks[i] = marks[i] || more[0];
            marks[nu + j] = marks[nu + j] || more[1];
            *done = *done && !more[0] && !more[1];
        }
    bat_status status = *done ? BAT_OK : halve(&n->lines[0], marks);
    if (status == BAT_OK && !*done) status = halve(&n->lines[1], marks + nu);
    free(marks);
    const double cells = (double)n->lines[0].count * (double)n->lines[1].count;
    return status == BAT_OK && cells > CELLS_MAX + 4 * n->begun ? BAT_COUNT : status;
}

static bat_status begin_lines(net *n, int d, int degree, size_t count, const double *knots) {
    for (size_t i = (size_t)degree; i <= count; i++)
        if ((n->lines[d].count == 0 || knots[i] > n->lines[d].list[n->lines[d].count - 1]) &&
            !bat_numbers_add(&n->lines[d], knots[i]))
            return BAT_MEMORY;
    return n->lines[d].count > 1 ? BAT_OK : BAT_KNOTS;
}

static bat_status begin(net *n, const int degree[2], const size_t count[2], const double *points,
                        const double *weights, const double *const knots[2]) {
    const size_t total = count[0] * count[1];
    const bool open[2] = {false, false};
    const int knot_count[2] = {(int)count[0] + degree[0] + 1, (int)count[1] + degree[1] + 1};
    double *over = malloc(6 * total * sizeof *over), *under = over ? over + 3 * total : NULL;
    bat_status status = over ? bat_weigh(total, points, weights, over, 3, under) : BAT_MEMORY;
    n->size = bat_full_side(total, points);
    if (status == BAT_OK)
        status = bat_surface_create(degree, open, count, over, knot_count, knots[0], knots[1], &n->over);
    if (status == BAT_OK)
        status = bat_surface_create(degree, open, count, under, knot_count, knots[0], knots[1], &n->under);
    for (int d = 0; d < 2 && status == BAT_OK; d++) status = begin_lines(n, d, degree[d], count[d], knots[d]);
    n->begun = (double)n->lines[0].count * (double)n->lines[1].count;
    free(over);
    return status;
}

/* ---- the patches as one surface ---- */

/* All Bézier points: rows[0] rows of rows[1], neighbours sharing theirs. */
typedef struct quilt {
    size_t rows[2];
    double *points;
} quilt;

static const double *point_at(const quilt *q, int d, size_t along, size_t across) {
    return q->points + 3 * (d == 0 ? along * q->rows[1] + across : across * q->rows[1] + along);
}

/* Whether the surface is smooth where line `at` of the quilt meets what is before `before`: then its points follow from
 * their neighbours. after, before: the widths of the patches there. */
static bool is_smooth(const net *n, const quilt *q, int d, const size_t at[2], const double width[2]) {
    for (size_t j = 0; j < q->rows[1 - d]; j++) {
        const double *left = point_at(q, d, at[0] - 1, j), *a = point_at(q, d, at[0], j);
        const double *b = point_at(q, d, at[1], j), *right = point_at(q, d, at[1] + 1, j);
        for (int k = 0; k < 3; k++) {
            const double middle = (left[k] * width[1] + right[k] * width[0]) / (width[0] + width[1]);
            if (!(fabs(middle - a[k]) <= SMOOTH * n->size && fabs(b[k] - a[k]) <= SMOOTH * n->size))
                return false;
        }
    }
    return true;
}

/* What of a direction of the quilt the surface keeps: its rows, and all knots, as bat_full_surface wants them. */
typedef struct strip {
    size_t *rows, count;
    double *knots;
} strip;

static bool begin_strip(strip *s, size_t lines) {
    *s = (strip){malloc((3 * lines + 8) * sizeof *s->rows), 0, malloc((3 * lines + 16) * sizeof *s->knots)};
    return s->rows && s->knots;
}

/* The seam is as smooth as any line: the direction is closed, and the seam's own rows follow from their neighbours. */
static bool wrap(strip *s, double period) {
    enum { CUBIC = 3 };
    const size_t own = s->count - 2;
    double *inner = malloc(own * sizeof *inner); /* a period of knots, the seam's two first */
    if (!inner) return false;
    memcpy(inner, s->knots + 2, own * sizeof *inner);
    for (size_t i = 0; i < own + 2 * CUBIC + 1; i++) {
        const size_t turned = i + own - 2, turn = turned / own;
        s->knots[i] = inner[turned % own] + ((double)turn - 1) * period;
    }
    free(inner);
    s->rows[0] = s->rows[own];
    for (size_t i = 0; i < CUBIC; i++) s->rows[own + i] = s->rows[i];
    s->count = own + CUBIC;
    return true;
}

static bat_status cut_strip(const net *n, const quilt *q, int d, strip *s) {
    const double *lines = n->lines[d].list;
    const size_t count = n->lines[d].count, last = 3 * (count - 1);
    size_t used = 0;
    if (!begin_strip(s, count)) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const bool inner = i > 0 && i + 1 < count;
        const size_t at[2] = {3 * i, 3 * i};
        const bool drops = inner && is_smooth(n, q, d, at,
                                              (double[2]){lines[i] - lines[i - 1], lines[i + 1] - lines[i]});
        for (int k = 0; k < (drops ? 2 : inner ? 3 : 4); k++) s->knots[used++] = lines[i];
        if (!drops) s->rows[s->count++] = 3 * i;
        if (i + 1 < count) s->rows[s->count++] = 3 * i + 1, s->rows[s->count++] = 3 * i + 2;
    }
    const size_t seam[2] = {last, 0};
    const double width[2] = {lines[count - 1] - lines[count - 2], lines[1] - lines[0]};
    const bool closed = count > 2 && is_smooth(n, q, d, seam, width);
    return !closed || wrap(s, lines[count - 1] - lines[0]) ? BAT_OK : BAT_MEMORY;
}

static bat_status sew(const net *n, const quilt *q, bat_surface **out) {
    strip s[2] = {{0}, {0}};
    double *points = NULL;
    bat_status status = cut_strip(n, q, 0, &s[0]);
    if (status == BAT_OK) status = cut_strip(n, q, 1, &s[1]);
    if (status == BAT_OK && !(points = malloc(3 * s[0].count * s[1].count * sizeof *points)))
        status = BAT_MEMORY;
    if (status == BAT_OK) {
        for (size_t i = 0; i < s[0].count; i++)
            for (size_t j = 0; j < s[1].count; j++)
                memcpy(points + 3 * (i * s[1].count + j),
                       q->points + 3 * (s[0].rows[i] * q->rows[1] + s[1].rows[j]), 3 * sizeof *points);
        const int cubic[2] = {3, 3};
        const size_t count[2] = {s[0].count, s[1].count};
        const double *const knots[2] = {s[0].knots, s[1].knots};
        status = bat_full_surface(cubic, count, points, knots, out);
    }
    free(points);
    for (int d = 0; d < 2; d++) free(s[d].rows), free(s[d].knots);
    return status;
}

static bat_status assemble(const net *n, bat_surface **out) {
    const size_t nu = n->lines[0].count - 1, nv = n->lines[1].count - 1;
    quilt q = {{3 * nu + 1, 3 * nv + 1}, NULL};
    if ((double)q.rows[0] * (double)q.rows[1] > BAT_POINTS_MAX) return BAT_COUNT;
    q.points = malloc(3 * q.rows[0] * q.rows[1] * sizeof *q.points);
    if (!q.points) return BAT_MEMORY;
    for (size_t i = 0; i < nu; i++)
        for (size_t j = 0; j < nv; j++) {
            double range[4], patch[48];
            find_cell(n, i, j, range);
            make_patch(n, range, patch);
            for (size_t a = 0; a < 4; a++)
                memcpy(q.points + 3 * ((3 * i + a) * q.rows[1] + 3 * j), patch + 12 * a, 12 * sizeof *patch);
        }
    const bat_status status = sew(n, &q, out);
    free(q.points);
    return status;
}

bat_status bat_rational_surface(const int degree[2], const size_t count[2], const double *points,
                                const double *weights, const double *const knots[2], double tolerance,
                                bat_surface **out) {
    net n = {.tolerance = tolerance};
    for (int d = 0; d < 2; d++)
        if (count[d] <= (size_t)degree[d] || count[d] > BAT_POINTS_MAX) return BAT_COUNT;
    if ((double)count[0] * (double)count[1] > BAT_POINTS_MAX) return BAT_COUNT;
    if (!(tolerance > 0)) return BAT_NUMBER;
    bat_status status = begin(&n, degree, count, points, weights, knots);
    bool done = false;
    for (int round = 0; round < ROUNDS && status == BAT_OK && !done; round++) status = refine(&n, &done);
    if (status == BAT_OK) status = assemble(&n, out);
    bat_surface_free(n.over), bat_surface_free(n.under);
    bat_numbers_clear(&n.lines[0]), bat_numbers_clear(&n.lines[1]);
    return status;
}
