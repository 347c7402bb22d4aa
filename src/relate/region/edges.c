/* The pieces of boundaries between their cuts, and which of them run along each other. */
#include "base/real.h"
#include "curve/curve.h"
#include "relate/region/arrangement.h"

#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Gaps: a piece that stays so near its node is none; pieces that stay so near each other are one. */
static const double SPECK = 8, ALONG = 4;

static int by_u(const void *a, const void *b) {
    const bat_cut *x = a, *y = b;
    if (x->u != y->u) return x->u < y->u ? -1 : 1;
    return (x->spot > y->spot) - (x->spot < y->spot);
}

/* From u[0] on, enough of the curve that its piece up to `end` depends on nothing behind it: some knots more, or the whole. */
static bat_status open_before(const bat_curve *curve, double from, double end, bat_curve **out) {
    const double *t = bat_curve_knots(curve);
    const int count = bat_curve_knot_count(curve) - 1, degree = bat_curve_degree(curve);
    const double period = t[count] - t[0], lap = end >= t[count] ? period : 0;
    int low = 0, high = count; /* the last knot that is not behind the end */
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t[middle] + lap <= end)
            low = middle;
        else
            high = middle;
    }
    int after = low, more = 2 * degree + 2;
    for (; after < count && more > 0; after++) more -= t[after + 1] > t[after];
    const double last = lap > 0 ? t[count] + (t[after] - t[0])
                                : t[after]; /* as such a knot is computed elsewhere */
    return more > 0 || !(last - from < period) || from < t[0] || from > t[count]
               ? bat_curve_open_at(curve, from, out)
               : bat_curve_piece(curve, from, last, out);
}

/* The piece, out of all of the curve or of what is enough. */
static bat_status piece_of(const bat_curve *curve, const double u[2], bool whole, bat_curve **out) {
    double domain[2];
    bat_curve *round;
    bat_curve_domain(curve, domain);
    const double wanted = u[1] > u[0] ? u[1] : u[1] + (domain[1] - domain[0]);
    bat_status status = whole ? bat_curve_open_at(curve, u[0], &round)
                              : open_before(curve, u[0], wanted, &round);
    if (status != BAT_OK) return status;
    bat_curve_domain(round, domain);
    const double end = bat_nearest_knot(round, wanted);
    status = bat_curve_piece(round, domain[0], fmin(end, domain[1]), out);
    bat_curve_free(round);
    return status;
}

bat_status bat_region_piece(const bat_curve *curve, const double u[2], const double *from, const double *to,
                            bat_curve **out) {
    bat_status status = piece_of(curve, u, false, out);
    if (status == BAT_KNOTS)
        status = piece_of(curve, u, true, out); /* no curve ends there: out of the whole */
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(*out);
    memcpy(points, from, 2 * sizeof *points);
    memcpy(points + 2 * (bat_curve_count(*out) - 1), to, 2 * sizeof *points);
    return BAT_OK;
}

/* Whether it does not leave the neighbourhood of a point. */
static bool is_speck(const bat_curve *piece, const double *at, double reach) {
    const double *p = bat_curve_points(piece);
    for (size_t i = 0; i < bat_curve_count(piece); i++)
        if (bat_hypot(p[2 * i] - at[0], p[2 * i + 1] - at[1]) > reach) return false;
    return true;
}

/* Its spans and their box. */
static bat_status take_spans(bat_region_edge *e, const bat_curve *curve) {
    const int degree = bat_curve_degree(curve), row = 2 * (degree + 1);
    e->spans = bat_curve_segment_count(curve);
    e->bezier = malloc((size_t)(e->spans * row) * sizeof *e->bezier);
    const bat_status status = e->bezier ? bat_curve_to_bezier(curve, e->bezier, NULL) : BAT_MEMORY;
    if (status != BAT_OK) return status;
    for (int i = 1; i < e->spans; i++) /* the ends of spans agree bit for bit */
        memcpy(e->bezier + i * row, e->bezier + i * row - 2, 2 * sizeof *e->bezier);
    if (bat_curve_is_closed(curve)) memcpy(e->bezier + e->spans * row - 2, e->bezier, 2 * sizeof *e->bezier);
    e->box[0] = e->box[1] = INFINITY, e->box[2] = e->box[3] = -INFINITY;
    for (int i = 0; i < e->spans * row; i++) {
        e->box[i % 2] = fmin(e->box[i % 2], e->bezier[i]);
        e->box[2 + i % 2] = fmax(e->box[2 + i % 2], e->bezier[i]);
    }
    return BAT_OK;
}

/* Takes the piece over. */
static bat_status add_edge(bat_arrangement *a, const bat_region_edge *made) {
    if (a->edge_count == a->edge_room) {
        const size_t room = 2 * a->edge_room + 16;
        bat_region_edge *more = realloc(a->edges, room * sizeof *more);
        if (!more) {
            bat_curve_free(made->own);
            return BAT_MEMORY;
        }
        a->edges = more, a->edge_room = room;
    }
    bat_region_edge *e = a->edges + a->edge_count;
    *e = *made;
    e->same_as = a->edge_count++;
    e->sign = 1;
    e->next = BAT_NO_NODE;
    return take_spans(e, made->own);
}

static bat_status add_whole(bat_arrangement *a, size_t index) {
    const bat_curve *curve = a->curves[index].curve;
    double low[2], high[2];
    bat_region_edge made = {.curve = index, .node = {BAT_NO_NODE, BAT_NO_NODE}};
    bat_curve_bounds(curve, low, high);
    if (bat_hypot(high[0] - low[0], high[1] - low[1]) <= a->gap) return BAT_OK; /* a point */
    bat_curve_domain(curve, made.u);
    const bat_status status = bat_curve_copy(curve, &made.own);
    return status == BAT_OK ? add_edge(a, &made) : status;
}

/* Each cut with the next, round the curve; the pieces that are none are left out. */
static bat_status add_pieces(bat_arrangement *a, size_t index) {
    bat_cut_curve *c = a->curves + index;
    qsort(c->cuts, c->count, sizeof *c->cuts, by_u); /* no ties: spots differ */
    for (size_t i = 1; i < c->count; i++)            /* found twice: there once */
        if (bat_is_same_place(c->curve, c->cuts[i - 1].u, c->cuts[i].u)) c->cuts[i].u = c->cuts[i - 1].u;
    bat_status status = BAT_OK;
    for (size_t i = 0; i < c->count && status == BAT_OK; i++) {
        const bool last = i + 1 == c->count;
        const bat_cut *from = c->cuts + i, *to = c->cuts + (last ? 0 : i + 1);
        bat_region_edge made = {.curve = index, .u = {from->u, to->u}};
        made.node[0] = a->node_of[from->spot], made.node[1] = a->node_of[to->spot];
        if (!last && from->u == to->u) continue;
        const double *start = a->nodes + 2 * made.node[0], *end = a->nodes + 2 * made.node[1];
        status = bat_region_piece(c->curve, made.u, start, end, &made.own);
        if (status != BAT_OK) break;
        if (made.node[0] == made.node[1] && is_speck(made.own, start, SPECK * a->gap))
            bat_curve_free(made.own);
        else
            status = add_edge(a, &made);
    }
    return status;
}

/* ---- pieces along each other ---- */

static bool ends_before(const bat_region_edge *x,
                        const bat_region_edge *y) { /* by their nodes, whatever their direction */
    const size_t low = x->node[0] < x->node[1] ? 0 : 1, low_y = y->node[0] < y->node[1] ? 0 : 1;
    if (x->node[low] != y->node[low_y]) return x->node[low] < y->node[low_y];
    return x->node[1 - low] < y->node[1 - low_y];
}

static bool same_ends(const bat_region_edge *x, const bat_region_edge *y) {
    return !ends_before(x, y) && !ends_before(y, x);
}

typedef struct ordered {
    const bat_region_edge *edges;
    size_t index;
} ordered;

static int by_ends(const void *a, const void *b) {
    const ordered *p = a, *q = b;
    const bat_region_edge *x = p->edges + p->index, *y = q->edges + q->index;
    if (ends_before(x, y)) return -1;
    if (ends_before(y, x)) return 1;
    return (p->index > q->index) - (p->index < q->index);
}

/* Whether y runs along x, at three places: sign 1; -1 when against it; 0: neither. */
static bat_status runs_along(const bat_region_edge *x, const bat_region_edge *y, double reach, int *sign) {
    double domain[2], feet[3];
    bat_curve_domain(y->own, domain);
    *sign = 0;
    for (int i = 0; i < 3; i++) {
        double p[2];
        bat_near near;
        bat_curve_eval(y->own, domain[0] + (domain[1] - domain[0]) * (i + 1) / 4, 0, p);
        const bat_status status = bat_curve_nearest(x->own, p, &near);
        if (status != BAT_OK || !(near.distance <= reach)) return status;
        feet[i] = near.u;
    }
    const bool apart = x->node[0] != x->node[1];
    *sign = (apart ? x->node[0] == y->node[0] : feet[0] < feet[2]) ? 1 : -1;
    return BAT_OK;
}

static bat_status find_same(bat_arrangement *a) {
    ordered *order = malloc((a->edge_count + 1) * sizeof *order);
    if (!order) return BAT_MEMORY;
    for (size_t i = 0; i < a->edge_count; i++) order[i] = (ordered){a->edges, i};
    qsort(order, a->edge_count, sizeof *order, by_ends); /* no ties: edges differ */
    bat_status status = BAT_OK;
    for (size_t i = 0; i < a->edge_count; i++) {
        bat_region_edge *x = a->edges + order[i].index;
        if (x->node[0] == BAT_NO_NODE || x->same_as != order[i].index) continue;
        for (size_t j = i + 1;
             j < a->edge_count && status == BAT_OK && same_ends(x, a->edges + order[j].index); j++) {
            bat_region_edge *y = a->edges + order[j].index;
            int sign, other;
            if (y->same_as != order[j].index) continue;
            status = runs_along(x, y, ALONG * a->gap, &sign);
            if (status == BAT_OK && sign != 0) status = runs_along(y, x, ALONG * a->gap, &other);
            if (status == BAT_OK && sign != 0 && other != 0)
                y->same_as = order[i].index, y->sign = sign, y->next = x->next, x->next = order[j].index;
        }
    }
    free(order);
    return status;
}

bat_status bat_arrangement_edges(bat_arrangement *a) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < a->curve_count && status == BAT_OK; i++)
        status = a->curves[i].count > 0 ? add_pieces(a, i) : add_whole(a, i);
    return status == BAT_OK ? find_same(a) : status;
}
