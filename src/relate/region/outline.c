/* Edges that bound the result, joined to closed curves with the inside to their left. */
#include "base/real.h"
#include "curve/curve.h"
#include "relate/region/arrangement.h"

#include <batten/measure.h>
#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is narrower than this share of the tolerance, in the mean, is left out. */
static const double NARROW = 0.5;

/* An edge that begins at a node, in the direction in which the result lies to its left. */
typedef struct start {
    size_t edge;
    bool used;
} start;

/* A stretch of one curve, from node to node. */
typedef struct stretch {
    size_t curve;
    double u[2]; /* along the curve; u[1] not above u[0]: in the next period */
    bool back;   /* run against the curve */
    size_t from, to;
} stretch;

typedef struct outline {
    const bat_arrangement *a;
    size_t *first; /* of the starts of each node; node_count + 1 */
    start *starts;
    size_t length;
    stretch *loop; /* the one being made */
    size_t count, room;
    bat_curve **out;
} outline;

static size_t begin_of(const bat_region_edge *e) { return e->node[e->keep < 0]; }
static size_t end_of(const bat_region_edge *e) { return e->node[e->keep > 0]; }

/* Kept edges by the node where they begin. */
static void sort_starts(outline *o) {
    const bat_arrangement *a = o->a;
    memset(o->first, 0, (a->node_count + 1) * sizeof *o->first);
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < a->edge_count; i++) {
            const bat_region_edge *e = a->edges + i;
            if (e->same_as != i || !e->keep || e->node[0] == BAT_NO_NODE) continue;
            if (pass == 0)
                o->first[begin_of(e) + 1]++;
            else
                o->starts[o->first[begin_of(e)]++] = (start){i, false};
        }
        if (pass == 0)
            for (size_t n = 0; n < a->node_count; n++) o->first[n + 1] += o->first[n];
    }
    for (size_t n = a->node_count; n > 0; n--) o->first[n] = o->first[n - 1];
    o->first[0] = 0;
}

/* Whither an edge leaves its first node, or its last one, as an angle. */
static double leaves(const outline *o, const bat_region_edge *e, bool last) {
    if (!e->own) {
        const double *from = o->a->nodes + 2 * e->node[last], *to = o->a->nodes + 2 * e->node[!last];
        return bat_atan2(to[1] - from[1], to[0] - from[0]);
    }
    const int count = (int)bat_curve_count(e->own);
    const double *p = bat_curve_points(e->own), *at = p + (last ? 2 * (count - 1) : 0);
    double x = 0, y = 0;
    for (int i = 1; i < count && bat_hypot(x, y) <= 8 * o->a->gap; i++) {
        const double *q = p + 2 * (last ? count - 1 - i : i);
        x = q[0] - at[0], y = q[1] - at[1];
    }
    return bat_atan2(y, x);
}

/* The edge that goes on from where one ends: the next one clockwise, behind which the result does not lie; so outlines that
 * touch in a point stay apart. NULL: none is left. */
static start *next_of(outline *o, const bat_region_edge *e) {
    const size_t node = end_of(e);
    const double back = leaves(o, e, e->keep > 0);
    start *best = NULL;
    double least = INFINITY;
    for (size_t i = o->first[node]; i < o->first[node + 1]; i++) {
        start *s = o->starts + i;
        if (s->used) continue;
        const bat_region_edge *f = o->a->edges + s->edge;
        double angle = back - leaves(o, f, f->keep < 0);
        while (angle <= 0) angle += 2 * BAT_PI;
        if (angle < least) least = angle, best = s;
    }
    return best;
}

/* ---- stretches ---- */

/* Whether the second goes on where the first ends, on the same curve. */
static bool goes_on(const stretch *x, const stretch *y) {
    return x->curve == y->curve && x->back == y->back && x->u[!x->back] == y->u[x->back];
}

/* Its share of the curve's period; 0 where rounding leaves nothing of the way from one node to another. */
static double share_of(const outline *o, const stretch *s) {
    double domain[2];
    bat_curve_domain(o->a->curves[s->curve].curve, domain);
    if (s->u[1] == s->u[0]) return s->from == s->to;
    return (s->u[1] - s->u[0]) / (domain[1] - domain[0]) + (s->u[1] < s->u[0]);
}

/* Whether they are all of a curve: once round, not along one of its loops. */
static bool is_whole(const outline *o) {
    double sum = 0;
    for (size_t i = 0; i < o->length; i++) {
        if (!goes_on(o->loop + i, o->loop + (i + 1) % o->length)) return false;
        sum += share_of(o, o->loop + i);
    }
    return sum > 0.5;
}

/* The other way round. */
static void turn_back(stretch *list, size_t count) {
    for (size_t i = 0; i < count / 2; i++) {
        const stretch first = list[i];
        list[i] = list[count - 1 - i], list[count - 1 - i] = first;
    }
}

/* One stretch for those that follow each other on one curve; the loop then begins where another curve begins. */
static void merge(outline *o) {
    stretch *loop = o->loop;
    size_t at = 0, kept = 0;
    while (at < o->length && goes_on(loop + (at + o->length - 1) % o->length, loop + at)) at++;
    if (at == o->length) return; /* a loop of one curve that meets itself */
    turn_back(loop, at), turn_back(loop + at, o->length - at), turn_back(loop, o->length);
    for (size_t i = 1; i < o->length; i++) {
        stretch *x = loop + kept, *y = loop + i;
        if (goes_on(x, y))
            x->u[!x->back] = y->u[!x->back], x->to = y->to;
        else
            loop[++kept] = *y;
    }
    o->length = kept + 1;
}

static bat_status run_back(bat_curve **curve) {
    bat_curve *turned;
    const bat_status status = bat_curve_reverse(*curve, &turned);
    bat_curve_free(*curve);
    *curve = status == BAT_OK ? turned : NULL;
    return status;
}

/* The stretch as a curve; a straight one where too little of the curve is left for one. */
static bat_status piece_of(const outline *o, const stretch *s, bat_curve **out) {
    const bat_arrangement *a = o->a;
    const double *from = a->nodes + 2 * s->from, *to = a->nodes + 2 * s->to;
    bat_status status = BAT_KNOTS;
    if (share_of(o, s) > 0)
        status = bat_region_piece(a->curves[s->curve].curve, s->u, s->back ? to : from, s->back ? from : to,
                                  out);
    if (status == BAT_OK && s->back) return run_back(out);
    if ((status != BAT_KNOTS && status != BAT_PARAMETER) || s->from == s->to) return status;
    return bat_curve_create_clamped(2, 1, 2, (const double[]){from[0], from[1], to[0], to[1]}, out);
}

static bat_status join(const outline *o, bat_curve **out) {
    bat_curve **pieces = calloc(o->length, sizeof *pieces), *all = NULL;
    bat_status status = pieces ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < o->length && status == BAT_OK; i++) status = piece_of(o, o->loop + i, &pieces[i]);
    if (status == BAT_OK)
        status = bat_curve_chain(o->length, (const bat_curve *const *)pieces, 2 * o->a->gap, &all);
    if (status == BAT_OK) status = bat_curve_close(all, o->a->gap, out);
    if (pieces) bat_curves_free(o->length, pieces);
    bat_curve_free(all);
    return status;
}

/* ---- curves of the result ---- */

/* Takes the curve over, unless it is so narrow that it is nothing. */
static bat_status add(outline *o, bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    const double length = bat_curve_length(curve, domain[0], domain[1], 1e-3);
    if (fabs(bat_curve_area(curve)) <= 0.5 * NARROW * o->a->tolerance * length) {
        bat_curve_free(curve);
        return BAT_OK;
    }
    if (o->count == o->room) {
        const size_t room = 2 * o->room + 4;
        bat_curve **more = realloc(o->out, room * sizeof *more);
        if (!more) {
            bat_curve_free(curve);
            return BAT_MEMORY;
        }
        o->out = more, o->room = room;
    }
    o->out[o->count++] = curve;
    return BAT_OK;
}

static bat_status add_whole(outline *o, size_t index, bool back) {
    bat_curve *curve;
    bat_status status = bat_curve_copy(o->a->curves[index].curve, &curve);
    if (status == BAT_OK && back) status = run_back(&curve);
    return status == BAT_OK ? add(o, curve) : status;
}

/* From one start round to where it goes on with itself. */
static bat_status go_round(outline *o, start *first) {
    const bat_arrangement *a = o->a;
    o->length = 0;
    for (start *s = first;;) {
        const bat_region_edge *e = a->edges + s->edge;
        o->loop[o->length++] = (stretch){e->curve, {e->u[0], e->u[1]}, e->keep < 0, begin_of(e), end_of(e)};
        start *next = next_of(o, e);
        s->used = s != first || next == first;
        if (!next) return BAT_SINGULAR; /* not with a balanced boundary */
        if (next == first) break;
        next->used = true;
        s = next;
    }
    first->used = true;
    if (is_whole(o)) return add_whole(o, o->loop[0].curve, o->loop[0].back);
    merge(o);
    bat_curve *curve;
    const bat_status status = join(o, &curve);
    return status == BAT_OK ? add(o, curve) : status;
}

static bat_status make(outline *o) {
    const bat_arrangement *a = o->a;
    bat_status status = BAT_OK;
    sort_starts(o);
    for (size_t i = 0; i < a->edge_count && status == BAT_OK; i++)
        if (a->edges[i].node[0] == BAT_NO_NODE && a->edges[i].keep)
            status = add_whole(o, a->edges[i].curve, a->edges[i].keep < 0);
    for (size_t i = 0; i < o->first[a->node_count] && status == BAT_OK; i++)
        if (!o->starts[i].used) status = go_round(o, o->starts + i);
    return status;
}

bat_status bat_arrangement_outline(const bat_arrangement *a, size_t *count, bat_curve ***out) {
    outline o = {.a = a};
    o.first = malloc((a->node_count + 1) * sizeof *o.first);
    o.starts = malloc((a->edge_count + 1) * sizeof *o.starts);
    o.loop = malloc((a->edge_count + 1) * sizeof *o.loop);
    const bat_status status = o.first && o.starts && o.loop ? make(&o) : BAT_MEMORY;
    free(o.first), free(o.starts), free(o.loop);
    if (status == BAT_OK)
        *count = o.count, *out = o.out;
    else
        bat_curves_free(o.count, o.out);
    return status;
}
