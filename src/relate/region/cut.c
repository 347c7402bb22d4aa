/* Where the boundaries of regions meet: each other, and themselves. */
#include "base/real.h"
#include "relate/region/arrangement.h"

#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>

/* Gaps within which cuts are one node. */
static const double NODE = 3;
/* Of the domain: parameters so near are the same. */
static const double SAME = 1e-9;

static bat_status add_cut(bat_cut_curve *to, double u, size_t spot) {
    if (to->count == to->room) {
        const size_t room = 2 * to->room + 8;
        bat_cut *more = realloc(to->cuts, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        to->cuts = more, to->room = room;
    }
    to->cuts[to->count++] = (bat_cut){u, spot};
    return BAT_OK;
}

bool bat_is_same_place(const bat_curve *curve, double u, double v) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return fabs(u - v) <= SAME * (domain[1] - domain[0]);
}

double bat_nearest_knot(const bat_curve *curve, double u) {
    const double *t = bat_curve_knots(curve);
    int low = 0, high = bat_curve_knot_count(curve) - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    const double knot = u - t[low] <= t[high] - u ? t[low] : t[high];
    return bat_is_same_place(curve, u, knot) ? knot : u;
}

/* The knot that it is but for rounding, so that no span is left which rounding makes none; else itself. */
static double at_knot(const bat_curve *curve, double u, double gap) {
    double domain[2], p[2], q[2];
    bat_curve_domain(curve, domain);
    const double knot = bat_nearest_knot(curve, u);
    if (u >= domain[1]) return domain[0];
    if (knot == u) return u;
    bat_curve_eval(curve, u, 0, p);
    bat_curve_eval(curve, knot, 0, q);
    return bat_hypot(p[0] - q[0], p[1] - q[1]) <= gap ? (knot < domain[1] ? knot : domain[0]) : u;
}

static bat_status add(bat_arrangement *a, bat_cut_curve *first, double u, bat_cut_curve *second, double v,
                      const double *point) {
    if (a->spot_count == BAT_POINTS_MAX) return BAT_COUNT;
    if (a->spot_count == a->spot_room) {
        const size_t room = 2 * a->spot_room + 16;
        double *more = realloc(a->spots, 2 * room * sizeof *more);
        if (!more) return BAT_MEMORY;
        a->spots = more, a->spot_room = room;
    }
    const size_t spot = a->spot_count++;
    a->spots[2 * spot] = point[0], a->spots[2 * spot + 1] = point[1];
    const bat_status status = add_cut(first, at_knot(first->curve, u, a->gap), spot);
    return status == BAT_OK ? add_cut(second, at_knot(second->curve, v, a->gap), spot) : status;
}

static bat_status add_all(bat_arrangement *a, bat_cut_curve *first, bat_cut_curve *second,
                          const bat_meeting *met) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < met->count && status == BAT_OK; i++)
        status = add(a, first, met->crossings[i].u, second, met->crossings[i].v, met->crossings[i].point);
    for (size_t i = 0; i < met->overlap_count; i++)
        for (int k = 0; k < 2 && status == BAT_OK; k++) {
            const bat_overlap *o = met->overlaps + i;
            double p[2], q[2];
            bat_curve_eval(first->curve, o->u[k], 0, p);
            bat_curve_eval(second->curve, o->v[k], 0, q);
            for (int c = 0; c < 2; c++) p[c] = 0.5 * p[c] + 0.5 * q[c];
            status = add(a, first, o->u[k], second, o->v[k], p);
        }
    return status;
}

/* A curve and its box. */
typedef struct boxed {
    double low[2], high[2];
    bat_cut_curve *is;
} boxed;

static int by_low(const void *a, const void *b) {
    const boxed *x = a, *y = b;
    if (x->low[0] != y->low[0]) return x->low[0] < y->low[0] ? -1 : 1;
    return (x->is > y->is) - (x->is < y->is);
}

static bat_status meet_itself(bat_arrangement *a, bat_cut_curve *curve) {
    bat_meeting met = {0};
    bat_status status = bat_curve_self_intersect(curve->curve, a->gap, &met);
    if (status == BAT_OK) status = add_all(a, curve, curve, &met);
    bat_meeting_free(&met);
    return status;
}

static bat_status meet_other(bat_arrangement *a, const boxed *x, const boxed *y) {
    const bool ordered = x->is < y->is;
    bat_cut_curve *first = ordered ? x->is : y->is, *second = ordered ? y->is : x->is;
    bat_meeting met = {0};
    if (x->low[1] > y->high[1] + 2 * a->gap || y->low[1] > x->high[1] + 2 * a->gap) return BAT_OK;
    bat_status status = bat_curve_intersect(first->curve, second->curve, a->gap, &met);
    if (status == BAT_OK) status = add_all(a, first, second, &met);
    bat_meeting_free(&met);
    return status;
}

static bat_status meet(bat_arrangement *a) {
    boxed *all = malloc((a->curve_count + 1) * sizeof *all);
    bat_status status = all ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < a->curve_count && status == BAT_OK; i++) {
        all[i].is = a->curves + i;
        bat_curve_bounds(all[i].is->curve, all[i].low, all[i].high);
    }
    if (status == BAT_OK) qsort(all, a->curve_count, sizeof *all, by_low); /* no ties: curves differ */
    for (size_t i = 0; i < a->curve_count && status == BAT_OK; i++) {
        status = meet_itself(a, all[i].is);
        const double reach = all[i].high[0] + 2 * a->gap;
        for (size_t k = i + 1; k < a->curve_count && all[k].low[0] <= reach && status == BAT_OK; k++)
            status = meet_other(a, all + i, all + k);
    }
    free(all);
    return status;
}

/* ---- nodes ---- */

typedef struct placed {
    double x, y;
    size_t spot;
} placed;

static int by_x(const void *a, const void *b) {
    const placed *p = a, *q = b;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    return (p->spot > q->spot) - (p->spot < q->spot);
}

static size_t root_of(size_t *parent, size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* Spots that are near each other are one node, which lies at the first of them. */
static void gather(bat_arrangement *a, placed *all, size_t *parent) {
    const double reach = NODE * a->gap;
    for (size_t i = 0; i < a->spot_count; i++)
        all[i] = (placed){a->spots[2 * i], a->spots[2 * i + 1], i}, parent[i] = i;
    qsort(all, a->spot_count, sizeof *all, by_x); /* no ties: spots differ */
    for (size_t i = 0; i < a->spot_count; i++)
        for (size_t j = i + 1; j < a->spot_count && all[j].x - all[i].x <= reach; j++) {
            if (bat_hypot(all[j].x - all[i].x, all[j].y - all[i].y) > reach) continue;
            const size_t p = root_of(parent, all[i].spot), q = root_of(parent, all[j].spot);
            if (p < q)
                parent[q] = p;
            else
                parent[p] = q;
        }
    for (size_t i = 0; i < a->spot_count; i++) {
        const size_t first = root_of(parent, i);
        if (first == i) {
            a->nodes[2 * a->node_count] = a->spots[2 * i];
            a->nodes[2 * a->node_count + 1] = a->spots[2 * i + 1];
            a->node_of[i] = a->node_count++;
        } else
            a->node_of[i] = a->node_of[first]; /* roots are the least of their kind */
    }
}

bat_status bat_arrangement_cut(bat_arrangement *a) {
    const bat_status status = meet(a);
    if (status != BAT_OK || a->spot_count == 0) return status;
    placed *all = malloc(a->spot_count * sizeof *all);
    size_t *parent = malloc(a->spot_count * sizeof *parent);
    a->node_of = malloc(a->spot_count * sizeof *a->node_of);
    a->nodes = malloc(2 * a->spot_count * sizeof *a->nodes);
    const bool enough = all && parent && a->node_of && a->nodes;
    if (enough) gather(a, all, parent);
    free(all), free(parent);
    return enough ? BAT_OK : BAT_MEMORY;
}
