/*
 * Contours with exact topology (docs/math/surfaces.md). A cell whose coefficients have one sign is dropped. Where the
 * polynomial is monotone in one variable, and changes its sign at most once along each edge, the contour is a graph over
 * the other variable; its ends are the roots on the edges, in order, in pairs. Any other cell is halved; what is
 * left at the smallest size is a crossing. Values near zero count as positive, so that a contour along an edge of spans
 * is found once.
 */
#include "form/trace/contour.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS = 13, STACK = 2 * LEVELS + 2, DEPTH_LEAST = 2, DEPTH_MOST = 18, CELLS_MAX = 1 << 20 };

typedef struct cell {
    bat_poly f;
    double low[2], high[2]; /* in the span's [0, 1] */
} cell;

typedef struct tracing {
    const bat_contour *contour;
    bat_tracks pieces;
    bat_cell span_cell;
    cell stack[STACK];
    int span[2], cells;
    double tiny;
    bat_status status;
} tracing;

/* ---- one graph ---- */

static bat_track_point point_at(const tracing *t, const cell *c, const double x[2]) {
    bat_track_point p = {.uv = {0, 0}};
    for (int d = 0; d < 2; d++) {
        const double at = x[d] == 1 ? c->high[d] : c->low[d] + x[d] * (c->high[d] - c->low[d]);
        p.uv[d] = bat_span_parameter(t->contour->surface, d, t->span[d], at);
    }
    bat_surface_eval_spans(t->contour->surface, t->span, p.uv[0], p.uv[1], 0, p.point);
    return p;
}

/* How far the middle is from the chord, as measured. */
static double off_chord(const tracing *t, const bat_track_point *a, const bat_track_point *m,
                        const bat_track_point *b) {
    double at[3][3], along = 0, length = 0, off = 0;
    t->contour->place(t->contour->user, a->point, at[0]);
    t->contour->place(t->contour->user, m->point, at[1]);
    t->contour->place(t->contour->user, b->point, at[2]);
    for (int c = 0; c < 3; c++) {
        along += (at[1][c] - at[0][c]) * (at[2][c] - at[0][c]);
        length += (at[2][c] - at[0][c]) * (at[2][c] - at[0][c]);
    }
    const double s = length > 0 ? fmin(fmax(along / length, 0), 1) : 0;
    for (int c = 0; c < 3; c++) {
        const double d = at[1][c] - at[0][c] - s * (at[2][c] - at[0][c]);
        off += d * d;
    }
    return sqrt(off);
}

/* The point of the graph at x[over], by a bracketed Newton's method. */
static void solve(const tracing *t, const cell *c, int over, double x[2]) {
    double line[BAT_POLY_SIDE];
    const int up = 1 - over, degree = c->f.degree[up];
    bat_poly_line(&c->f, up, x[over], line);
    if ((line[0] >= -t->tiny) != (line[degree] >= -t->tiny))
        x[up] = bat_line_root(line, degree, t->tiny);
    else
        x[up] = fabs(line[0]) <= fabs(line[degree]) ? 0 : 1;
}

/* Adds the points after a, up to b. */
static void refine(tracing *t, const cell *c, bat_track *track, int over, const double a[2],
                   const bat_track_point *from, const double b[2], int depth) {
    const bat_track_point to = point_at(t, c, b);
    double x[2];
    x[over] = 0.5 * (a[over] + b[over]);
    solve(t, c, over, x);
    const bat_track_point middle = point_at(t, c, x);
    const bool halve = depth < DEPTH_MOST && x[over] != a[over] && x[over] != b[over] &&
                       (depth < DEPTH_LEAST || off_chord(t, from, &middle, &to) > t->contour->chord);
    if (halve && t->status == BAT_OK) {
        refine(t, c, track, over, a, from, x, depth + 1);
        refine(t, c, track, over, x, &middle, b, depth + 1);
    } else if (t->status == BAT_OK) {
        t->status = bat_track_add(track, &to);
    }
}

static void add_graph(tracing *t, const cell *c, int over, const double a[2], const double b[2]) {
    bat_track *track = bat_tracks_begin(&t->pieces);
    if (!track) {
        t->status = BAT_MEMORY;
        return;
    }
    const bat_track_point from = point_at(t, c, a);
    t->status = bat_track_add(track, &from);
    if (t->status == BAT_OK) refine(t, c, track, over, a, &from, b, 0);
}

/* ---- one cell ---- */

static bool positive(const tracing *t, double value) { return value >= -t->tiny; }

static bool has_one_sign(const tracing *t, const bat_poly *f) {
    const bool first = positive(t, f->c[0]);
    for (int i = 1; i < (f->degree[0] + 1) * (f->degree[1] + 1); i++)
        if (positive(t, f->c[i]) != first) return false;
    return true;
}

static bool is_monotone(const tracing *t, const bat_poly *f, int direction) {
    const int n = f->degree[1] + 1, step = direction == 0 ? n : 1;
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i <= f->degree[0] - (direction == 0); i++)
        for (int j = 0; j <= f->degree[1] - (direction == 1); j++) {
            const double d = f->c[i * n + j + step] - f->c[i * n + j];
            least = fmin(least, d), most = fmax(most, d);
        }
    return (least >= -t->tiny && most > t->tiny) || (most <= t->tiny && least < -t->tiny);
}

/* Changes of sign along the edge where x[direction] is 0 or 1. */
static int changes(const tracing *t, const bat_poly *f, int direction, int end) {
    const int n = f->degree[1] + 1, count = f->degree[1 - direction];
    const int from = !end ? 0 : direction == 0 ? f->degree[0] * n : f->degree[1];
    const int step = direction == 0 ? 1 : n;
    int found = 0;
    for (int k = 0; k < count; k++)
        found += positive(t, f->c[from + k * step]) != positive(t, f->c[from + (k + 1) * step]);
    return found;
}

/* Roots on the edges; returns how many. Every edge changes its sign at most once. */
static int edge_roots(const tracing *t, const cell *c, double roots[4][2]) {
    int count = 0;
    for (int direction = 0; direction < 2; direction++)
        for (int end = 0; end < 2; end++) {
            double line[BAT_POLY_SIDE];
            if (!changes(t, &c->f, direction, end)) continue;
            bat_poly_line(&c->f, 1 - direction, end, line);
            roots[count][direction] = end;
            roots[count++][1 - direction] = bat_line_root(line, c->f.degree[1 - direction], t->tiny);
        }
    return count;
}

static void add_graphs(tracing *t, const cell *c, const bool monotone[2]) {
    double roots[4][2];
    const int count = edge_roots(t, c, roots);
    int over = monotone[0] ? 1 : 0;
    if (monotone[0] && monotone[1] && count == 2)
        over = fabs(roots[1][1] - roots[0][1]) >= fabs(roots[1][0] - roots[0][0]);
    for (int i = 1; i < count; i++) /* in order */
        for (int k = i; k > 0 && roots[k][over] < roots[k - 1][over]; k--) {
            double swap[2];
            memcpy(swap, roots[k], sizeof swap);
            memcpy(roots[k], roots[k - 1], sizeof swap);
            memcpy(roots[k - 1], swap, sizeof swap);
        }
    for (int i = 0; i + 1 < count && t->status == BAT_OK; i += 2)
        add_graph(t, c, over, roots[i], roots[i + 1]);
}

static void add_crossing(tracing *t, const cell *c) {
    const bat_track_point p = point_at(t, c, (const double[2]){0.5, 0.5});
    t->status = bat_tracks_cross(&t->pieces, &p);
    t->pieces.given_up = t->pieces.crossing_count > BAT_CROSSINGS_MAX;
}

static void halve(cell *lower, int direction, cell *upper) {
    bat_poly_halve(&lower->f, direction, &upper->f);
    memcpy(upper->low, lower->low, sizeof upper->low);
    memcpy(upper->high, lower->high, sizeof upper->high);
    upper->low[direction] = lower->high[direction] = 0.5 * (lower->low[direction] + lower->high[direction]);
}

static void trace_span(tracing *t) {
    const double least = 1.0 / (1 << LEVELS);
    cell *first = t->stack;
    int top = 0;
    if (!t->contour->of_span(t->contour->user, &t->span_cell, &first->f, &t->tiny)) return;
    for (int d = 0; d < 2; d++) first->low[d] = 0, first->high[d] = 1;
    while (top >= 0 && t->status == BAT_OK && !t->pieces.given_up) {
        cell *c = &t->stack[top--];
        if (has_one_sign(t, &c->f)) continue;
        bool graph = true;
        for (int d = 0; d < 2; d++)
            for (int end = 0; end < 2; end++) graph = graph && changes(t, &c->f, d, end) <= 1;
        const bool monotone[2] = {graph && is_monotone(t, &c->f, 0), graph && is_monotone(t, &c->f, 1)};
        const double wide[2] = {c->high[0] - c->low[0], c->high[1] - c->low[1]};
        if (monotone[0] || monotone[1]) {
            add_graphs(t, c, monotone);
        } else if (fmax(wide[0], wide[1]) <= least) {
            add_crossing(t, c);
        } else if (t->cells++ > CELLS_MAX) {
            t->pieces.given_up = true;
        } else {
            halve(c, wide[1] > wide[0], c + 1);
            top += 2;
        }
    }
}

/* ---- all spans ---- */

static bool is_empty(const bat_curve *axis, int span) { return !(axis->knots[span] < axis->knots[span + 1]); }

static void trace_spans(tracing *t) {
    const bat_curve *axis = t->contour->surface->axis;
    for (int i = axis[0].degree; i < axis[0].spread; i++)
        for (int j = axis[1].degree; j < axis[1].spread && t->status == BAT_OK; j++) {
            if (is_empty(&axis[0], i) || is_empty(&axis[1], j) || t->pieces.given_up) continue;
            t->span[0] = i, t->span[1] = j;
            bat_cell_of(t->contour->surface, t->span, &t->span_cell);
            trace_span(t);
        }
}

bat_status bat_contour_trace(const bat_contour *contour, bat_tracks **out) {
    tracing *t = malloc(sizeof *t);
    if (!t) return BAT_MEMORY;
    t->contour = contour, t->cells = 0, t->status = BAT_OK;
    t->pieces = (bat_tracks){.list = NULL};
    trace_spans(t);
    bat_tracks made = {.list = NULL};
    bat_status status = t->status;
    if (t->pieces.given_up)
        made.given_up = true;
    else if (status == BAT_OK)
        status = bat_tracks_join(&t->pieces, contour->surface, &made);
    bat_tracks_clear(&t->pieces);
    free(t);
    if (status != BAT_OK) {
        bat_tracks_clear(&made);
        return status;
    }
    return bat_tracks_finish(&made, out);
}
