/* The arrangement on a grid: curves as lines between places of the grid, cut until they meet at these alone, so that it holds
 * together whatever the curves do (after Hobby 1999; docs/math/relate.md 6). */
#include "relate/region/grid.h"

#include "base/box.h"
#include "relate/hulls.h"

#include <batten/bezier.h>
#include <batten/relate.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 64 };

static const double FLAT = 1.0 / 8;    /* of the tolerance: lines for curves */
static const double STEP = 1.0 / 16;   /* of the tolerance, at most: from place to place */
static const double NEAR = 0.6;        /* steps: a line goes through a place that is so near */
static const double SPLIT = 134217729; /* 2^27 + 1: the upper half of a number's digits (Dekker 1971) */

typedef struct line {
    double p[2][2]; /* whole numbers of steps */
    double u[2];
    size_t curve;
    bool fresh; /* not compared yet */
} line;

typedef struct lines {
    size_t count, room;
    line *all;
} lines;

/* A place at which a line is cut. */
typedef struct slit {
    size_t line;
    double share, x[2];
} slit;

typedef struct grid {
    bat_arrangement *a;
    lines now;
    size_t *fresh_before; /* of each line: how many in front of it are fresh */
    double (*boxes)[4];   /* of stretches of lines, as bat_hull_halve numbers them */
    size_t count, room;
    slit *slits;
} grid;

/* ---- exact ---- */

/* x * y = high + low. */
static double product(double x, double y, double *low) {
    const double high = x * y, a = SPLIT * x, b = SPLIT * y;
    const double x1 = a - (a - x), x0 = x - x1, y1 = b - (b - y), y0 = y - y1;
    *low = x0 * y0 - (((high - x1 * y1) - x0 * y1) - x1 * y0);
    return high;
}

int bat_grid_turn(const double x[2], const double y[2]) {
    double low[2];
    const double left = product(x[0], y[1], &low[0]), right = product(x[1], y[0], &low[1]);
    if (left != right && fabs(left - right) > 4e-16 * (fabs(left) + fabs(right)))
        return left > right ? 1 : -1;
    const double rest = (left - right) + (low[0] - low[1]);
    return (rest > 0) - (rest < 0);
}

static int side_of(const line *l, const double x[2]) {
    const double d[2] = {l->p[1][0] - l->p[0][0], l->p[1][1] - l->p[0][1]};
    const double w[2] = {x[0] - l->p[0][0], x[1] - l->p[0][1]};
    return bat_grid_turn(d, w);
}

/* ---- lines ---- */

static bool is_at(const double x[2], const double y[2]) { return x[0] == y[0] && x[1] == y[1]; }

static bat_status add_line(lines *to, const line *made) {
    if (to->count == to->room) {
        if (to->room >= BAT_POINTS_MAX) return BAT_COUNT;
        const size_t room = 2 * to->room + 64;
        line *more = realloc(to->all, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        to->all = more, to->room = room;
    }
    to->all[to->count++] = *made;
    return BAT_OK;
}

/* The lines of a curve; what goes nowhere is a part of the next one. */
static bat_status take_curve(grid *g, size_t index) {
    const bat_curve *curve = g->a->curves[index].curve;
    size_t n;
    double *points, *u, domain[2];
    bat_curve_domain(curve, domain);
    bat_status status = bat_curve_flatten(curve, FLAT * g->a->tolerance, &n, &points, &u);
    if (status != BAT_OK) return status;
    const size_t first = g->now.count;
    for (size_t i = 0; i < 2 * n; i++) points[i] = nearbyint(points[i] / g->a->step);
    line made = {.curve = index, .fresh = true, .p = {{points[0], points[1]}}, .u = {domain[0], 0}};
    for (size_t i = 1; i <= n && status == BAT_OK; i++) {
        const double *to = points + 2 * (i % n); /* a closed curve ends where it began */
        if (is_at(made.p[0], to)) continue;
        memcpy(made.p[1], to, sizeof made.p[1]), made.u[1] = i < n ? u[i] : domain[1];
        status = add_line(&g->now, &made);
        memcpy(made.p[0], to, sizeof made.p[0]), made.u[0] = made.u[1];
    }
    if (g->now.count > first) g->now.all[g->now.count - 1].u[1] = domain[0];
    bat_free(points), bat_free(u);
    return status;
}

/* ---- cuts ---- */

static bat_status cut(grid *g, const line *l, const double x[2]) {
    if (is_at(x, l->p[0]) || is_at(x, l->p[1])) return BAT_OK;
    if (g->count == g->room) {
        const size_t room = 2 * g->room + 64;
        slit *more = realloc(g->slits, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        g->slits = more, g->room = room;
    }
    const double d[2] = {l->p[1][0] - l->p[0][0], l->p[1][1] - l->p[0][1]};
    const double along = (x[0] - l->p[0][0]) * d[0] + (x[1] - l->p[0][1]) * d[1];
    g->slits[g->count++] = (slit){
        (size_t)(l - g->now.all), along / (d[0] * d[0] + d[1] * d[1]), {x[0], x[1]}};
    return BAT_OK;
}

/* Whether a line goes through a place but for little. Seen from there its ends are more than a right angle apart, so the sum
 * of the squares of all lengths, a whole number, becomes less when it is cut: that ends. */
static bool goes_through(const line *l, const double x[2]) {
    const double d[2] = {l->p[1][0] - l->p[0][0], l->p[1][1] - l->p[0][1]};
    const double v[2] = {x[0] - l->p[0][0], x[1] - l->p[0][1]}, w[2] = {x[0] - l->p[1][0], x[1] - l->p[1][1]};
    if (!(v[0] * w[0] + v[1] * w[1] < 0)) return false;
    const double off = d[0] * v[1] - d[1] * v[0];
    return off * off <= NEAR * NEAR * (d[0] * d[0] + d[1] * d[1]);
}

static bat_status compare_ends(grid *g, const line *l, const line *other, bool *met) {
    bat_status status = BAT_OK;
    for (int e = 0; e < 2 && status == BAT_OK; e++)
        if (goes_through(l, other->p[e])) *met = true, status = cut(g, l, other->p[e]);
    return status;
}

static bat_status compare(grid *g, const line *a, const line *b) {
    bool met = false;
    bat_status status = compare_ends(g, a, b, &met);
    if (status == BAT_OK) status = compare_ends(g, b, a, &met);
    if (status != BAT_OK || met) return status;
    if (side_of(a, b->p[0]) * side_of(a, b->p[1]) >= 0 || side_of(b, a->p[0]) * side_of(b, a->p[1]) >= 0)
        return BAT_OK;
    const double d[2] = {a->p[1][0] - a->p[0][0], a->p[1][1] - a->p[0][1]},
                 e[2] = {b->p[1][0] - b->p[0][0], b->p[1][1] - b->p[0][1]},
                 w[2] = {b->p[0][0] - a->p[0][0], b->p[0][1] - a->p[0][1]};
    const double share = (w[0] * e[1] - w[1] * e[0]) / (d[0] * e[1] - d[1] * e[0]);
    const double x[2] = {nearbyint(a->p[0][0] + share * d[0]), nearbyint(a->p[0][1] + share * d[1])};
    status = cut(g, a, x);
    return status == BAT_OK ? cut(g, b, x) : status;
}

/* By more than a step. */
static bool are_apart(const double a[4], const double b[4]) {
    return a[0] > b[2] + 1 || b[0] > a[2] + 1 || a[1] > b[3] + 1 || b[1] > a[3] + 1;
}

static bool is_fresh(const grid *g, bat_hull_part s) {
    return g->fresh_before[s.first + s.count] > g->fresh_before[s.first];
}

static bat_status compare_parts(grid *g, bat_hull_part s, bat_hull_part t) {
    if (!is_fresh(g, s) && !is_fresh(g, t)) return BAT_OK;
    const bool same = s.node == t.node;
    if (!same && are_apart(g->boxes[s.node], g->boxes[t.node])) return BAT_OK;
    if (s.count == 1 && t.count == 1)
        return same ? BAT_OK : compare(g, g->now.all + s.first, g->now.all + t.first);
    bat_hull_part half[2];
    bat_hull_halve(s.count >= t.count ? s : t, half);
    if (!same) {
        const bat_hull_part other = s.count >= t.count ? t : s;
        const bat_status status = compare_parts(g, half[0], other);
        return status == BAT_OK ? compare_parts(g, half[1], other) : status;
    }
    bat_status status = compare_parts(g, half[0], half[0]);
    if (status == BAT_OK) status = compare_parts(g, half[1], half[1]);
    return status == BAT_OK ? compare_parts(g, half[0], half[1]) : status;
}

static void make_boxes(const grid *g, bat_hull_part s) {
    double *box = g->boxes[s.node];
    if (s.count == 1) {
        const double *p = g->now.all[s.first].p[0], *q = g->now.all[s.first].p[1];
        for (int c = 0; c < 2; c++) box[c] = fmin(p[c], q[c]), box[2 + c] = fmax(p[c], q[c]);
        return;
    }
    bat_hull_part half[2];
    bat_hull_halve(s, half);
    make_boxes(g, half[0]), make_boxes(g, half[1]);
    memcpy(box, g->boxes[half[0].node], sizeof *g->boxes);
    bat_box_hold(box, g->boxes[half[1].node]);
}

static bat_status find_slits(grid *g) {
    const size_t n = g->now.count;
    g->fresh_before = malloc((n + 1) * sizeof *g->fresh_before);
    g->boxes = malloc((2 * n - 1) * sizeof *g->boxes);
    bat_status status = g->fresh_before && g->boxes ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        make_boxes(g, (bat_hull_part){0, 0, n});
        g->fresh_before[0] = 0;
        for (size_t i = 0; i < n; i++) g->fresh_before[i + 1] = g->fresh_before[i] + g->now.all[i].fresh;
        status = compare_parts(g, (bat_hull_part){0, 0, n}, (bat_hull_part){0, 0, n});
    }
    free(g->fresh_before), free(g->boxes);
    g->fresh_before = NULL, g->boxes = NULL;
    return status;
}

static int along(const void *a, const void *b) {
    const slit *x = a, *y = b;
    if (x->line != y->line) return x->line < y->line ? -1 : 1;
    if (x->share != y->share) return x->share < y->share ? -1 : 1;
    if (x->x[0] != y->x[0]) return x->x[0] < y->x[0] ? -1 : 1;
    return (x->x[1] > y->x[1]) - (x->x[1] < y->x[1]);
}

/* The lines between the places at which they are cut. */
static bat_status take_apart(grid *g) {
    lines next = {0};
    bat_status status = BAT_OK;
    qsort(g->slits, g->count, sizeof *g->slits, along); /* no ties that differ */
    for (size_t i = 0, k = 0; i < g->now.count && status == BAT_OK; i++) {
        const line whole = g->now.all[i];
        double domain[2];
        bat_curve_domain(g->a->curves[whole.curve].curve, domain);
        const double end = whole.u[1] > whole.u[0] ? whole.u[1] : domain[1];
        line made = whole;
        made.fresh = k < g->count && g->slits[k].line == i;
        for (; k < g->count && g->slits[k].line == i && status == BAT_OK; k++) {
            const slit *s = g->slits + k;
            if (is_at(s->x, made.p[0])) continue;
            memcpy(made.p[1], s->x, sizeof s->x);
            made.u[1] = fmax(made.u[0], whole.u[0] + (end - whole.u[0]) * fmin(s->share, 1));
            status = add_line(&next, &made);
            memcpy(made.p[0], s->x, sizeof s->x), made.u[0] = made.u[1];
        }
        memcpy(made.p[1], whole.p[1], sizeof made.p[1]), made.u[1] = whole.u[1];
        if (status == BAT_OK) status = add_line(&next, &made);
    }
    free(g->now.all);
    g->now = next, g->count = 0;
    return status;
}

/* ---- nodes and edges ---- */

typedef struct ending {
    double x[2];
    size_t line;
    int end;
} ending;

static int by_place(const void *a, const void *b) {
    const ending *p = a, *q = b;
    for (int c = 0; c < 2; c++)
        if (p->x[c] != q->x[c]) return p->x[c] < q->x[c] ? -1 : 1;
    if (p->line != q->line) return p->line < q->line ? -1 : 1;
    return p->end - q->end;
}

/* Each place where lines end is a node. */
static bat_status make_nodes(const grid *g) {
    bat_arrangement *a = g->a;
    const size_t n = 2 * g->now.count;
    ending *all = malloc((n + 1) * sizeof *all);
    a->nodes = malloc(2 * (n + 1) * sizeof *a->nodes);
    if (!all || !a->nodes) {
        free(all);
        return BAT_MEMORY;
    }
    for (size_t i = 0; i < n; i++) {
        const line *l = g->now.all + i / 2;
        all[i] = (ending){{l->p[i % 2][0], l->p[i % 2][1]}, i / 2, (int)(i % 2)};
    }
    qsort(all, n, sizeof *all, by_place); /* no ties */
    for (size_t i = 0; i < n; i++) {
        if (i == 0 || !is_at(all[i].x, all[i - 1].x)) {
            for (size_t c = 0; c < 2; c++) a->nodes[2 * a->node_count + c] = all[i].x[c] * a->step;
            a->node_count++;
        }
        a->edges[all[i].line].node[all[i].end] = a->node_count - 1;
    }
    free(all);
    return BAT_OK;
}

typedef struct between {
    size_t low, high, edge;
} between;

static int by_nodes(const void *a, const void *b) {
    const between *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    if (p->high != q->high) return p->high < q->high ? -1 : 1;
    return (p->edge > q->edge) - (p->edge < q->edge);
}

/* Lines between the same nodes are one; the first stands for all. */
static bat_status find_same(bat_arrangement *a) {
    between *all = malloc((a->edge_count + 1) * sizeof *all);
    if (!all) return BAT_MEMORY;
    for (size_t i = 0; i < a->edge_count; i++) {
        const size_t *node = a->edges[i].node;
        all[i] = node[0] < node[1] ? (between){node[0], node[1], i} : (between){node[1], node[0], i};
    }
    qsort(all, a->edge_count, sizeof *all, by_nodes); /* no ties: edges differ */
    for (size_t i = 0, first = 0; i < a->edge_count; i++) {
        if (all[i].low != all[first].low || all[i].high != all[first].high) first = i;
        bat_region_edge *e = a->edges + all[i].edge, *f = a->edges + all[first].edge;
        e->same_as = all[first].edge;
        e->sign = e->node[0] == f->node[0] ? 1 : -1;
        if (i > first) e->next = f->next, f->next = all[i].edge;
    }
    free(all);
    return BAT_OK;
}

static bat_status make_edges(const grid *g) {
    bat_arrangement *a = g->a;
    a->edges = calloc(g->now.count + 1, sizeof *a->edges);
    if (!a->edges) return BAT_MEMORY;
    a->edge_count = g->now.count;
    for (size_t i = 0; i < g->now.count; i++) {
        const line *l = g->now.all + i;
        a->edges[i] = (bat_region_edge){.curve = l->curve, .u = {l->u[0], l->u[1]}, .next = BAT_NO_NODE};
    }
    const bat_status status = make_nodes(g);
    return status == BAT_OK ? find_same(a) : status;
}

bat_status bat_arrangement_grid(bat_arrangement *a) {
    grid g = {.a = a};
    int exponent;
    (void)frexp(STEP * a->tolerance, &exponent);
    a->step = ldexp(1, exponent - 1);
    bat_status status = BAT_OK;
    for (size_t i = 0; i < a->curve_count && status == BAT_OK; i++) status = take_curve(&g, i);
    bool meet = g.now.count > 0; /* elsewhere than at places of the grid, as far as is known */
    for (int i = 0; i < ROUNDS && status == BAT_OK && meet; i++) {
        status = find_slits(&g);
        meet = g.count > 0;
        if (status == BAT_OK && meet) status = take_apart(&g);
    }
    if (status == BAT_OK && meet) status = BAT_TOLERANCE; /* never seen */
    if (status == BAT_OK) status = make_edges(&g);
    free(g.now.all), free(g.slits);
    return status;
}
