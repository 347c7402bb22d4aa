/*
 * An outline as type designers keep it: cubics that meet at extremes, with level and upright handles there, at corners and at ends,
 * all points on a grid. Between two such nodes lies the one cubic of least distance (curve/hermite.h); where that is too far off,
 * another node is put where half of the turn between them is made.
 */
#include "base/real.h"
#include "curve/curve.h"
#include "curve/hermite.h"

#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 48, SAMPLES_SPAN = 4, HALVINGS = 10, CHECKED = 12, FREE = -1 };

static const double ROUNDED = 0.75;  /* of the grid: what rounding may move beyond the tolerance */
static const double SAME = 1e-9;     /* of the domain: two places that are one */
static const double STRAIGHT = 1e-9; /* of the size */
static const double SIDEWARDS =
    1e-3; /* of a piece: where its direction is seen when the curve stands still at its end */

/* Where cubics meet. Arrived at with the first of the two values, left with the second: they differ where two nodes
 * have become one. */
typedef struct node {
    double u[2], at[2];
    int axis[2]; /* in which it is an extreme, or FREE */
    bool fixed;  /* a corner or an end */
} node;

typedef struct outline {
    const bat_curve *curve;
    double domain[2], tolerance, grid, size;
    int spans;
    node *nodes;
    int count, room;
    bat_hermite h;
    double *points; /* of `cubics` cubics, 6 each: without the last point of the one before */
    int cubics, room_cubics;
} outline;

static double on_grid(const outline *o, double x) {
    return o->grid > 0 ? floor(x / o->grid + 0.5) * o->grid : x;
}

static void place(const outline *o, double u, double at[2]) {
    bat_curve_eval(o->curve, u, 0, at);
    for (int c = 0; c < 2; c++) at[c] = on_grid(o, at[c]);
}

static bat_status add_node(outline *o, double u, int axis, bool fixed) {
    if (o->count == o->room) {
        const int room = 2 * o->room + 16;
        node *more = realloc(o->nodes, (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        o->nodes = more, o->room = room;
    }
    node *n = &o->nodes[o->count++];
    *n = (node){{u, u}, {0, 0}, {axis, axis}, fixed};
    bat_curve_eval(o->curve, u, 0, n->at);
    return BAT_OK;
}

static int by_place(const void *a, const void *b) {
    const node *x = a, *y = b;
    if (x->u[0] != y->u[0]) return x->u[0] < y->u[0] ? -1 : 1;
    return x->fixed != y->fixed ? y->fixed - x->fixed : x->axis[0] - y->axis[0];
}

/* Extremes at corners are none, and one place is an extreme of one axis. */
static void drop_doubles(outline *o) {
    const double near = SAME * (o->domain[1] - o->domain[0]);
    int kept = 0;
    for (int i = 0; i < o->count; i++) {
        node *last = kept > 0 ? &o->nodes[kept - 1] : NULL;
        const node now = o->nodes[i];
        if (!last || now.u[0] - last->u[0] > near || (now.fixed && last->fixed))
            o->nodes[kept++] = now;
        else if (now.fixed)
            *last = now;
    }
    o->count = kept;
}

static bat_status add_extremes(outline *o, int axis) {
    const size_t count = bat_curve_extremes(o->curve, axis, 0, NULL);
    double *u = malloc((count + 1) * sizeof *u);
    bat_status status = u ? BAT_OK : BAT_MEMORY;
    if (u) (void)bat_curve_extremes(o->curve, axis, count, u);
    for (size_t i = 0; i < count && status == BAT_OK; i++) status = add_node(o, u[i], axis, false);
    free(u);
    return status;
}

/* Ends, corners, extremes, as they follow each other. */
static bat_status find_nodes(outline *o, double corner) {
    const bat_curve *curve = o->curve;
    const int p = curve->degree, s = curve->spread;
    const double *t = curve->knots;
    bat_status status = BAT_OK;
    for (int i = p; i <= s && status == BAT_OK; i++) {
        const bool end = !curve->closed && (i == p || i == s), last = i == s || t[i + 1] > t[i];
        if (end || (last && i < s && t[i - p + 1] == t[i] && bat_curve_corner_at(curve, i, corner)))
            status = add_node(o, t[i], FREE, true);
    }
    for (int axis = 0; axis < 2 && status == BAT_OK; axis++) status = add_extremes(o, axis);
    const size_t size = sizeof *o->nodes;
    if (status == BAT_OK && o->count > 1)
        qsort(o->nodes, (size_t)o->count, size, by_place); /* no ties: one of a kind at a place */
    drop_doubles(o);
    return status;
}

/* ---- what is too small to be a node ---- */

static bool is_of(const node *n, int axis) { return n->fixed || n->axis[0] == axis; }

/* The nodes of one axis, each with the next and the one before (-1: none), and pairs of them in a heap, the least apart first. */
typedef struct pair {
    double apart;
    int first, second;
} pair;

typedef struct chain {
    int *next, *before;
    bool *gone;
    pair *heap;
    int pairs;
} chain;

static bool is_less(const pair *a, const pair *b) {
    return a->apart < b->apart || (a->apart == b->apart && a->first < b->first);
}

static void push(chain *c, pair one) {
    int at = c->pairs++;
    for (; at > 0 && is_less(&one, &c->heap[(at - 1) / 2]); at = (at - 1) / 2)
        c->heap[at] = c->heap[(at - 1) / 2];
    c->heap[at] = one;
}

static pair pop(chain *c) {
    const pair top = c->heap[0], last = c->heap[--c->pairs];
    int at = 0;
    for (int child = 1; child < c->pairs; child = 2 * at + 1) {
        if (child + 1 < c->pairs && is_less(&c->heap[child + 1], &c->heap[child])) child++;
        if (!is_less(&c->heap[child], &last)) break;
        c->heap[at] = c->heap[child], at = child;
    }
    c->heap[at] = last;
    return top;
}

static void push_from(const outline *o, chain *c, int first, int axis) {
    const int second = first < 0 ? -1 : c->next[first];
    if (second < 0 || second == first || (o->nodes[first].fixed && o->nodes[second].fixed)) return;
    push(c, (pair){fabs(o->nodes[first].at[axis] - o->nodes[second].at[axis]), first, second});
}

/* The nodes of the axis as they follow each other; how many extremes there are. */
static int link_nodes(const outline *o, chain *c, int axis) {
    int last = -1, start = -1, extremes = 0;
    for (int i = 0; i < o->count; i++) {
        c->next[i] = c->before[i] = -1;
        if (!is_of(&o->nodes[i], axis)) continue;
        extremes += !o->nodes[i].fixed;
        if (last >= 0) c->next[last] = i, c->before[i] = last;
        if (start < 0) start = i;
        last = i;
    }
    if (o->curve->closed && start >= 0) c->next[last] = start, c->before[start] = last;
    for (int i = 0; i < o->count; i++)
        if (is_of(&o->nodes[i], axis)) push_from(o, c, i, axis);
    return extremes;
}

static void unlink_node(const outline *o, chain *c, int i, int axis) {
    const int before = c->before[i], next = c->next[i];
    c->gone[i] = true;
    if (before >= 0) c->next[before] = next;
    if (next >= 0) c->before[next] = before;
    if (before != i) push_from(o, c, before, axis);
}

/* Two extremes of an axis that follow each other and are hardly apart go, the least apart first; beside a corner or
 * an end the one goes. O(n log n). */
static bat_status flatten(outline *o, int axis) {
    const size_t n = (size_t)o->count + 1;
    int *links = malloc(2 * n * sizeof *links), kept = 0;
    bool *gone = calloc(n, sizeof *gone);
    pair *heap = malloc(3 * n * sizeof *heap);
    chain c = {links, links ? links + n : NULL, gone, heap, 0};
    const bat_status status = links && gone && heap ? BAT_OK : BAT_MEMORY;
    int extremes = status == BAT_OK ? link_nodes(o, &c, axis) : 0;
    while (status == BAT_OK && c.pairs > 0) {
        const pair least = pop(&c);
        if (gone[least.first] || gone[least.second] || c.next[least.first] != least.second) continue;
        if (!(least.apart <= o->tolerance) || (o->curve->closed && extremes < 3)) break;
        for (int k = 0; k < 2; k++) {
            const int i = k ? least.first : least.second;
            if (o->nodes[i].fixed) continue;
            unlink_node(o, &c, i, axis);
            extremes--;
        }
    }
    for (int i = 0; i < o->count && status == BAT_OK; i++)
        if (!gone[i]) o->nodes[kept++] = o->nodes[i];
    if (status == BAT_OK) o->count = kept;
    free(links), free(gone), free(heap);
    return status;
}

static bool are_one(const node *a, const node *b) { return a->at[0] == b->at[0] && a->at[1] == b->at[1]; }

/* On the grid, nodes that follow each other may be one. */
static void round_nodes(outline *o) {
    int kept = 0;
    for (int i = 0; i < o->count; i++) {
        const node now = o->nodes[i];
        node *last = kept > 0 ? &o->nodes[kept - 1] : NULL, *added = &o->nodes[kept];
        *added = now;
        place(o, now.u[0], added->at);
        if (last && are_one(last, added))
            last->u[1] = now.u[1], last->axis[1] = now.axis[1], last->fixed = last->fixed || now.fixed;
        else
            kept++;
    }
    o->count = kept;
    if (kept < 2 || !o->curve->closed || !are_one(o->nodes, &o->nodes[kept - 1])) return;
    o->nodes[0].u[0] = o->nodes[kept - 1].u[0], o->nodes[0].axis[0] = o->nodes[kept - 1].axis[0];
    o->count--; /* the first takes the last over */
}

/* ---- pieces ---- */

/* Unit vector along the curve at u, seen from the side of `toward`. */
static void way_at(const outline *o, double u, double toward, int axis, double way[2]) {
    double d[4], near[2];
    const double sign = toward > u ? 1 : -1, period = o->domain[1] - o->domain[0];
    double at = u;
    if (o->curve->closed && toward < u && at <= o->domain[0]) at += period;
    (toward > u ? bat_curve_eval : bat_curve_eval_left)(o->curve, at, 1, d);
    if (!(bat_hypot(d[2], d[3]) > 0)) {
        bat_curve_eval(o->curve, u + SIDEWARDS * (toward - u), 0, near);
        for (int c = 0; c < 2; c++) d[2 + c] = sign * (near[c] - d[c]);
    }
    if (axis != FREE && d[3 - axis] != 0) d[2 + axis] = 0;
    const double length = bat_hypot(d[2], d[3]);
    for (int c = 0; c < 2; c++) way[c] = length > 0 ? sign * d[2 + c] / length : 0;
}

static bool sample(outline *o, double u, double v) {
    const double share = (v - u) / (o->domain[1] - o->domain[0]);
    const size_t count = SAMPLES + (size_t)(SAMPLES_SPAN * share * o->spans);
    if (!bat_hermite_room(&o->h, count)) return false;
    o->h.count = count;
    for (size_t i = 0; i < count; i++)
        bat_curve_eval(o->curve, u + (v - u) * (double)(i + 1) / (double)(count + 1), 0, o->h.x + 2 * i);
    return true;
}

static bool is_straight(const outline *o) {
    const bat_hermite *h = &o->h;
    const double chord = bat_distance(h->end[0], h->end[1], 2);
    double way[2];
    if (!(chord > 0)) return false;
    for (int c = 0; c < 2; c++) way[c] = (h->end[1][c] - h->end[0][c]) / chord;
    const double most = fmax(STRAIGHT * o->size, ROUNDED * o->grid);
    for (size_t i = 0; i < h->count; i++) {
        const double *x = h->x + 2 * i;
        if (fabs((x[0] - h->end[0][0]) * way[1] - (x[1] - h->end[0][1]) * way[0]) > most) return false;
    }
    return fabs(h->way[0][0] * way[1] - h->way[0][1] * way[0]) <= SIDEWARDS &&
           fabs(h->way[1][0] * way[1] - h->way[1][1] * way[0]) <= SIDEWARDS;
}

/* Where half of the turn is made, or of the length, where it hardly turns. */
static double half_way(const outline *o, double u, double v) {
    const bat_hermite *h = &o->h;
    double turned = 0;
    for (int round = 0;; round++) {
        double sum = 0;
        for (size_t i = 1; i + 1 < h->count; i++) {
            const double *x = h->x + 2 * i;
            const double angle = bat_turn(x - 2, x, x + 2, 2);
            sum += angle < 4 ? angle : 0;
            if (round > 0 && 2 * sum >= turned) return u + (v - u) * (double)(i + 1) / (double)(h->count + 1);
        }
        if (round > 0 || !(sum > SIDEWARDS)) return (u + v) / 2;
        turned = sum;
    }
}

static bat_status add_cubic(outline *o, const double cubic[8]) {
    if (o->cubics == o->room_cubics) {
        const int room = 2 * o->room_cubics + 16;
        double *more = realloc(o->points, 6 * (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        o->points = more, o->room_cubics = room;
    }
    memcpy(o->points + 6 * (size_t)o->cubics++, cubic + 2, 6 * sizeof *cubic);
    return BAT_OK;
}

/* Handles of an extreme are whole along it, at least one; all others are rounded in both coordinates. */
static void round_cubic(const outline *o, const node *a, const node *b, double handle[2], double cubic[8]) {
    if (a->axis[1] != FREE) handle[0] = fmax(on_grid(o, handle[0]), o->grid);
    if (b->axis[0] != FREE) handle[1] = fmax(on_grid(o, handle[1]), o->grid);
    bat_hermite_points(&o->h, handle, cubic);
    for (int k = 2; k < 6; k++) cubic[k] = on_grid(o, cubic[k]);
}

static bat_status cover(outline *o, const node *a, const node *b, int halvings) {
    bat_hermite *h = &o->h;
    double handle[2], cubic[8];
    double u = a->u[1], v = b->u[0];
    if (v <= u) v += o->domain[1] - o->domain[0];
    memcpy(h->end[0], a->at, sizeof a->at), memcpy(h->end[1], b->at, sizeof b->at);
    way_at(o, u, v, a->axis[1], h->way[0]), way_at(o, v, u, b->axis[0], h->way[1]);
    if (!sample(o, u, v)) return BAT_MEMORY;
    bat_hermite_measure(h);
    if (is_straight(o)) {
        const double third = bat_distance(a->at, b->at, 2) / 3;
        for (int k = 0; k < 2; k++) {
            handle[k] = third;
            for (int c = 0; c < 2; c++) h->way[k][c] = (h->end[1 - k][c] - h->end[k][c]) / (3 * third);
        }
        bat_hermite_points(h, handle, cubic);
        return add_cubic(o, cubic);
    }
    const double limit = o->tolerance + ROUNDED * o->grid;
    if (bat_hermite_fit(h, limit, handle) <= limit || halvings == 0) {
        round_cubic(o, a, b, handle, cubic);
        return add_cubic(o, cubic);
    }
    const double between = half_way(o, u, v);
    node middle = {{between, between}, {0, 0}, {FREE, FREE}, false};
    place(o, between, middle.at);
    if (bat_distance(middle.at, a->at, 2) == 0 || bat_distance(middle.at, b->at, 2) == 0)
        return cover(o, a, b, 0);
    const bat_status status = cover(o, a, &middle, halvings - 1);
    return status == BAT_OK ? cover(o, &middle, b, halvings - 1) : status;
}

/* A knot of multiplicity three at each joint, as far apart as the cubics' ends. */
static bat_status assemble(const outline *o, bat_curve **out) {
    const bool closed = o->curve->closed;
    const int cubics = o->cubics, first = closed ? 0 : 1;
    const size_t count = 3 * (size_t)cubics + (size_t)first, knots = count + (closed ? 1 : 4);
    double *points = malloc((2 * count + knots) * sizeof *points);
    if (!points) return BAT_MEMORY;
    double *t = points + 2 * count, at = 0;
    if (!closed) memcpy(points, o->nodes[0].at, sizeof o->nodes[0].at);
    memcpy(points + 2 * first, o->points, 6 * (size_t)cubics * sizeof *points);
    if (!closed) t[0] = 0;
    for (int i = 0; i <= cubics; i++) {
        for (int k = 0; k < 3 && first + 3 * i + k < (int)knots; k++) t[first + 3 * i + k] = at;
        if (i == cubics) break;
        const double *to = o->points + 6 * (size_t)i + 4, *from = i > 0 ? to - 6
                                                                  : closed
                                                                      ? o->points + 6 * (size_t)cubics - 2
                                                                      : points;
        at += bat_distance(from, to, 2);
    }
    t[knots - 1] = at;
    const bat_status status = bat_curve_create(2, 3, closed, count, points, (int)knots, t, out);
    free(points);
    return status;
}

static bat_status cover_all(outline *o) {
    const int pieces = o->curve->closed ? o->count : o->count - 1;
    bat_status status = o->count < 2 ? BAT_COUNT : BAT_OK;
    for (int i = 0; i < pieces && status == BAT_OK; i++)
        status = cover(o, &o->nodes[i], &o->nodes[(i + 1) % o->count], HALVINGS);
    return status;
}

bat_status bat_curve_refit_extremes(const bat_curve *curve, double tolerance, double corner, double grid,
                                    bat_curve **out, double *error) {
    if (!curve || !out || !(tolerance > 0) || !isfinite(tolerance) || !(corner >= 0) || !(grid >= 0) ||
        !isfinite(grid))
        return BAT_ARGUMENT;
    if (curve->dimension != 2) return BAT_DIMENSION;
    outline o = {.curve = curve, .tolerance = tolerance, .grid = grid, .h = {.dimension = 2}};
    bat_curve *made = NULL;
    double there = 0, back = 0;
    bat_curve_domain(curve, o.domain);
    o.size = bat_curve_size(curve), o.spans = bat_curve_segment_count(curve);
    bat_status status = find_nodes(&o, corner);
    for (int axis = 0; axis < 2 && status == BAT_OK; axis++) status = flatten(&o, axis);
    if (status == BAT_OK) round_nodes(&o), status = cover_all(&o);
    if (status == BAT_OK) status = assemble(&o, &made);
    if (status == BAT_OK) status = bat_curve_distance(curve, made, CHECKED, &there, &back);
    bat_hermite_free(&o.h);
    free(o.nodes), free(o.points);
    if (status != BAT_OK) {
        bat_curve_free(made);
        return status;
    }
    *out = made;
    if (error) *error = fmax(there, back);
    return BAT_OK;
}
