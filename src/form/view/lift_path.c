/* The shortest way through the places that the samples of a stroke can mean, by dynamic programming (docs/math/surfaces.md). */
#include "form/view/lift_path.h"
#include "base/real.h"
#include "base/vec.h"
#include "form/view/cast.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>

enum { OPEN = 64, SHARES = 16, WAYS = 2 };
static const double LEFT_OUT = 6; /* steps that a sample costs which is left out */
static const double STEEP =
    8; /* what a height counts of a length: of two ways that look alike the more level one is meant */
static const double TURN = 50;   /* steps that it costs to run along the curve the other way from now on */
static const double LEVEL = 0.5; /* of the height at the start: of two ways as short, the lower is meant */

/* A place that a sample can mean, come to along the curve or against it. */
typedef struct node {
    double u, h, along; /* along: the length of the curve up to it */
    double cost[WAYS];  /* of the best way to it, but for samples left out after it */
    int before[WAYS];   /* the state before on that way; -1: none */
    size_t sample;
} node;

typedef struct search {
    node *nodes;
    int count, room;
    double *at, *length; /* of the curve up to some parameters */
    int shares;
    double period, step; /* period 0: open */
} search;

/* Lengths at even shares of each span, by which places between are told. */
static bat_status measure(search *s, const bat_curve *curve) {
    const int pieces = bat_curve_segment_count(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    s->shares = pieces * SHARES;
    s->at = malloc(2 * ((size_t)s->shares + 1) * sizeof *s->at);
    if (!s->at) return BAT_MEMORY;
    s->length = s->at + s->shares + 1;
    for (int i = 0; i <= s->shares; i++) {
        double place[2][3] = {{0}};
        s->at[i] = domain[0] + (domain[1] - domain[0]) * i / s->shares;
        bat_curve_eval(curve, s->at[i], 0, place[0]);
        if (i) bat_curve_eval(curve, s->at[i - 1], 0, place[1]);
        s->length[i] = i ? s->length[i - 1] + bat_distance(place[0], place[1], bat_curve_dimension(curve))
                         : 0;
    }
    s->period = bat_curve_is_closed(curve) ? s->length[s->shares] : 0;
    return BAT_OK;
}

static double length_at(const search *s, double u) {
    const double share = (u - s->at[0]) / (s->at[s->shares] - s->at[0]) * s->shares;
    const int i = share < 0 ? 0 : share >= s->shares ? s->shares - 1 : (int)share;
    return s->length[i] + (share - i) * (s->length[i + 1] - s->length[i]);
}

/* The way from a to b, and which way along the curve; -1: neither. */
static double way(const search *s, const node *a, const node *b, int *which) {
    double along = b->along - a->along;
    if (s->period > 0) along -= s->period * floor(along / s->period + 0.5);
    *which = along > 0 ? 0 : along < 0 ? 1 : -1;
    return bat_hypot(along, STEEP * (a->h - b->h));
}

/* The places of one sample. */
static bat_status add(search *s, size_t sample, size_t count, const bat_cast_point *places) {
    if (s->count + (int)count > s->room) {
        const int room = 2 * s->room + (int)count + 256;
        node *more = realloc(s->nodes, (size_t)room * sizeof *more);
        if (!more) return BAT_MEMORY;
        s->nodes = more, s->room = room;
    }
    for (size_t i = 0; i < count; i++)
        s->nodes[s->count++] = (node){.u = places[i].own[0],
                                      .h = places[i].own[1],
                                      .along = length_at(s, places[i].own[0]),
                                      .sample = sample};
    return BAT_OK;
}

static bat_status gather(search *s, const bat_viewpoint *view, const bat_stroke *stroke,
                         const bat_curve *curve) {
    const bat_canvas canvas = {.curve = (bat_curve *)curve, .along = {0, 0, -1}};
    bat_caster *caster = NULL;
    bat_cast_point *places = NULL;
    size_t room = 0;
    bat_status status = bat_caster_create(&canvas, &caster);
    for (size_t i = 0; i < stroke->count && status == BAT_OK; i++) {
        double from[3], along[3];
        size_t count = 0, ahead = 0;
        status = bat_viewpoint_ray(view, stroke->points + 2 * i, from, along);
        if (status == BAT_OK) status = bat_caster_places(caster, from, along, &places, &room, &count);
        for (size_t k = 0; k < count && status == BAT_OK; k++) { /* behind the eye nothing is meant */
            const vec to = vec_sub(vec_load(places[k].point, 3), vec_load(from, 3));
            if (vec_dot(to, vec_load(along, 3)) > 0) places[ahead++] = places[k];
        }
        if (status == BAT_OK) status = add(s, i, ahead, places);
    }
    bat_caster_free(caster);
    free(places);
    return status;
}

/* The first node of the sample after that of node i. */
static int after(const search *s, int i) {
    const size_t sample = s->nodes[i].sample;
    while (i < s->count && s->nodes[i].sample == sample) i++;
    return i;
}

/* The mean of the shortest ways from a sample's places to those of the next: what the pen goes in a step. */
static double step_of(const search *s) {
    double sum = 0;
    int steps = 0, which;
    for (int from = 0, to = s->count ? after(s, 0) : 0; to < s->count;) {
        const int end = after(s, to);
        double least = INFINITY;
        for (int i = from; i < to; i++)
            for (int j = to; j < end; j++) least = fmin(least, way(s, &s->nodes[i], &s->nodes[j], &which));
        sum += least, steps++;
        from = to, to = end;
    }
    return steps ? sum / steps : 0;
}

/* What a state, a node and a way along the curve, costs as seen from a later sample. */
static double cost_at(const search *s, int state, size_t sample) {
    const node *n = &s->nodes[state / WAYS];
    return n->cost[state % WAYS] + LEFT_OUT * s->step * (double)(sample - n->sample - 1);
}

/* Puts a state where it belongs among the `count` before; the last falls out where there is no room. */
static int put(const search *s, int open[OPEN], int count, int state, size_t next) {
    const double cost = cost_at(s, state, next);
    if (count == OPEN && !(cost <= cost_at(s, open[OPEN - 1], next))) return OPEN;
    int at = count < OPEN ? count : OPEN - 1;
    for (; at > 0 && cost <= cost_at(s, open[at - 1], next); at--) open[at] = open[at - 1];
    open[at] = state;
    return count < OPEN ? count + 1 : OPEN;
}

/* The best of the states that are open, and the new ones, are open for the next sample. */
static int keep_open(const search *s, int open[OPEN], int count, int from, int to) {
    const size_t next = s->nodes[from].sample + 1;
    for (int i = from * WAYS; i < to * WAYS; i++) count = put(s, open, count, i, next);
    return count;
}

/* The best way to a node. */
static void reach(const search *s, node *n, int count, const int open[OPEN]) {
    for (int to = 0; to < WAYS; to++) n->cost[to] = INFINITY, n->before[to] = -1;
    for (int k = 0; k < count; k++) {
        int to;
        double cost = cost_at(s, open[k], n->sample) + way(s, &s->nodes[open[k] / WAYS], n, &to);
        if (to < 0) to = open[k] % WAYS;
        if (to != open[k] % WAYS) cost += TURN * s->step;
        if (cost < n->cost[to]) n->cost[to] = cost, n->before[to] = open[k];
    }
    const double start = LEFT_OUT * s->step * (double)n->sample + LEVEL * fabs(n->h);
    for (int to = 0; to < WAYS; to++)
        if (start < n->cost[to]) n->cost[to] = start, n->before[to] = -1;
}

/* Fills costs; returns the last state of the best way; -1: there are no places. */
static int solve(search *s, size_t samples) {
    int open[OPEN], count = 0, best = -1;
    s->step = step_of(s);
    for (int from = 0; from < s->count;) {
        const int to = after(s, from);
        for (int i = from; i < to; i++) reach(s, &s->nodes[i], count, open);
        count = keep_open(s, open, count, from, to);
        from = to;
    }
    for (int k = 0; k < count; k++)
        if (best < 0 || cost_at(s, open[k], samples) < cost_at(s, best, samples)) best = open[k];
    return best;
}

bat_status bat_lift_path(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                         double *u, double *h, size_t *kept) {
    search s = {0};
    *kept = 0;
    if (stroke->count && stroke->dimension != 2) return BAT_DIMENSION;
    bat_status status = measure(&s, curve);
    if (status == BAT_OK) status = gather(&s, view, stroke, curve);
    const int last = status == BAT_OK ? solve(&s, stroke->count) : -1;
    for (int i = last; i >= 0; i = s.nodes[i / WAYS].before[i % WAYS]) ++*kept;
    size_t at = *kept;
    for (int i = last; i >= 0; i = s.nodes[i / WAYS].before[i % WAYS])
        u[--at] = s.nodes[i / WAYS].u, h[at] = s.nodes[i / WAYS].h;
    free(s.nodes), free(s.at);
    return status;
}
