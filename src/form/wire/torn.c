/*
 * Torn edges. Along an edge the closest point of the reference moves steadily, however fast, or jumps: halving the edge
 * towards the faster half tells them apart, since a steady movement is halved with it.
 */
#include "form/wire/wire.h"

#include <math.h>
#include <stdlib.h>

enum { HALVINGS = 20, SAMPLES = 16 /* of the reference a control point */ };
static const double SUSPICIOUS = 2; /* times the edge's length */

/* Lengths along the reference, at even parameters. */
typedef struct ruler {
    const bat_bound_wire *wire;
    double start, end;
    size_t count; /* of steps */
    double *length;
    bool closed;
} ruler;

static bat_status begin(const bat_bound_wire *wire, ruler *r) {
    double domain[2], before[3], at[3];
    bat_curve_domain(wire->reference, domain);
    *r = (ruler){.wire = wire, .start = domain[0], .end = domain[1]};
    r->closed = bat_curve_is_closed(wire->reference);
    r->count = SAMPLES * bat_curve_count(wire->reference);
    r->length = malloc((r->count + 1) * sizeof *r->length);
    if (!r->length) return BAT_MEMORY;
    r->length[0] = 0;
    for (size_t i = 0; i <= r->count; i++) {
        const double u = i == r->count && !r->closed
                             ? domain[1]
                             : domain[0] + (domain[1] - domain[0]) * (double)i / (double)r->count;
        bat_curve_eval(wire->reference, u, 0, at);
        if (i > 0) r->length[i] = r->length[i - 1] + vec_norm(vec_sub(vec_load(at, 3), vec_load(before, 3)));
        for (int c = 0; c < 3; c++) before[c] = at[c];
    }
    return BAT_OK;
}

static double length_at(const ruler *r, double u) {
    const double x = fmin(fmax((u - r->start) / (r->end - r->start), 0), 1) * (double)r->count;
    const size_t i = (size_t)fmin(floor(x), (double)(r->count - 1));
    return r->length[i] + (r->length[i + 1] - r->length[i]) * (x - (double)i);
}

/* The way along the reference between two of its points; closed: the shorter one. */
static double apart(const ruler *r, double u, double v) {
    const double way = fabs(length_at(r, u) - length_at(r, v));
    return r->closed ? fmin(way, r->length[r->count] - way) : way;
}

static bool is_torn(const ruler *r, vec a, vec b, double at_a, double at_b) {
    const double before = apart(r, at_a, at_b), length = vec_norm(vec_sub(a, b));
    if (!(before > SUSPICIOUS * length)) return false;
    for (int k = 0; k < HALVINGS; k++) {
        const vec middle = vec_scale(vec_add(a, b), 0.5);
        bat_near near;
        bat_finder_nearest(r->wire->finder, (const double[3]){middle.x, middle.y, middle.z}, &near);
        if (apart(r, at_a, near.u) > apart(r, near.u, at_b))
            b = middle, at_b = near.u;
        else
            a = middle, at_a = near.u;
    }
    return apart(r, at_a, at_b) > 0.1 * before;
}

/* Torn edges found so far. */
typedef struct edge {
    int ends[2];
} edge;

typedef struct edges {
    edge *list;
    size_t count, room;
} edges;

static bat_status keep(edges *to, int a, int b) {
    if (to->count == to->room) {
        const size_t room = 2 * to->room + 64;
        edge *list = realloc(to->list, room * sizeof *list);
        if (!list) return BAT_MEMORY;
        to->list = list, to->room = room;
    }
    to->list[to->count++] = (edge){{a < b ? a : b, a < b ? b : a}};
    return BAT_OK;
}

static int by_ends(const void *a, const void *b) {
    const edge *x = a, *y = b;
    for (int k = 0; k < 2; k++)
        if (x->ends[k] != y->ends[k]) return x->ends[k] < y->ends[k] ? -1 : 1;
    return 0;
}

/* at: for each point where it is closest to the wire, NaN: it does not feel it; slot: where it is among those bound. */
static bat_status find(const bat_binding *b, size_t w, size_t edge_count, const int *list, double *at,
                       int *slot, edges *to) {
    ruler r;
    bat_status status = begin(&b->wires[w], &r);
    for (size_t i = 0; i < b->point_count; i++) at[i] = NAN;
    for (size_t i = 0; i < b->wires[w].count; i++) {
        const bat_influence *influence = &b->wires[w].influences[i];
        const int point = b->points[influence->slot];
        at[point] = influence->at, slot[point] = influence->slot;
    }
    for (size_t e = 0; e < edge_count && status == BAT_OK; e++) {
        const int p = list[2 * e], q = list[2 * e + 1];
        if (p == q || isnan(at[p]) || isnan(at[q])) continue;
        if (is_torn(&r, vec_load(b->rest + 3 * slot[p], 3), vec_load(b->rest + 3 * slot[q], 3), at[p], at[q]))
            status = keep(to, p, q);
    }
    free(r.length);
    return status;
}

static size_t hand_over(edges *found, size_t room, int *out) {
    size_t count = 0;
    if (found->count > 1)
        qsort(found->list, found->count, sizeof *found->list, by_ends); /* no ties: equal ones are one */
    for (size_t i = 0; i < found->count; i++) {
        if (i > 0 && by_ends(&found->list[i], &found->list[i - 1]) == 0) continue;
        for (int k = 0; count < room && k < 2; k++) out[2 * count + (size_t)k] = found->list[i].ends[k];
        count++;
    }
    return count;
}

bat_status bat_binding_torn(const bat_binding *binding, size_t edge_count, const int *list, size_t room,
                            int *out, size_t *count) {
    if (!binding || !count || (edge_count > 0 && !list) || (room > 0 && !out)) return BAT_ARGUMENT;
    for (size_t i = 0; i < 2 * edge_count; i++)
        if (list[i] < 0 || (size_t)list[i] >= binding->point_count) return BAT_PARAMETER;
    double *at = malloc((binding->point_count + 1) * sizeof *at);
    int *slot = malloc((binding->point_count + 1) * sizeof *slot);
    edges found = {.list = NULL};
    bat_status status = at && slot ? BAT_OK : BAT_MEMORY;
    for (size_t w = 0; w < binding->wire_count && status == BAT_OK; w++)
        status = find(binding, w, edge_count, list, at, slot, &found);
    if (status == BAT_OK) *count = hand_over(&found, room, out);
    free(at), free(slot), free(found.list);
    return status;
}
