/* Which edges bound the result: those that have it on one side only. */
#include "relate/region/winding.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 7 };

/* Where an edge is asked, in the order in which places are tried; gaps: so far from every other edge is far enough. */
static const double PLACE[PLACES] = {0.5, 0.27, 0.73, 0.14, 0.86, 0.06, 0.94};
static const double CLEAR = 64;

typedef struct judging {
    const bat_arrangement *a;
    bat_winding winding;
    /* Of each region: */
    int *others; /* winding numbers right of the place, but for the edge's own share */
    int *own;    /* what the edge, and those along it, add to the left */
    bool *seen;  /* it is in the list */
    size_t seen_count;
    size_t *list; /* regions that are not 0 everywhere above */
    double near;
} judging;

/* ---- sides ---- */

static void see(judging *j, size_t region) {
    if (j->seen[region]) return;
    j->seen[region] = true;
    j->list[j->seen_count++] = region;
}

static void forget(judging *j) {
    for (size_t i = 0; i < j->seen_count; i++) {
        const size_t region = j->list[i];
        j->seen[region] = false;
        j->others[region] = j->own[region] = 0;
    }
    j->seen_count = 0;
}

/* Adds so many crossings of an edge, and of those along it, to their regions. */
static void count(judging *j, size_t first, int crossed, int *to) {
    const bat_arrangement *a = j->a;
    for (size_t i = first; i != BAT_NO_NODE && crossed != 0; i = a->edges[i].next) {
        const size_t region = a->curves[a->edges[i].curve].region;
        see(j, region);
        to[region] += a->edges[i].sign * crossed;
    }
}

static void put_to(void *judged, size_t region, int crossed) {
    judging *j = judged;
    see(j, region);
    j->others[region] += crossed;
}
static void take_away(void *judged, size_t region, int crossed) { put_to(judged, region, -crossed); }

bool bat_arrangement_holds(const bat_arrangement *a, size_t in, bool first) {
    switch (a->operation) {
    case BAT_REGION_UNION: return in > 0;
    case BAT_REGION_DIFFERENCE: return first && in == 1;
    case BAT_REGION_INTERSECTION: return in == a->region_count;
    default: return in % 2 == 1;
    }
}

/* Whether the result lies left of the place, less whether it lies right of it. */
static int side(const judging *j, bool others_are_right) {
    size_t in[2] = {0, 0};
    bool first[2] = {false, false};
    for (size_t i = 0; i < j->seen_count; i++) {
        const size_t region = j->list[i];
        const int right = j->others[region] - (others_are_right ? 0 : j->own[region]);
        for (int k = 0; k < 2; k++) {
            const int winding = right + k * j->own[region];
            const bool inside = j->a->regions[region].even_odd ? winding % 2 != 0 : winding != 0;
            in[k] += inside;
            if (region == 0) first[k] = inside;
        }
    }
    return bat_arrangement_holds(j->a, in[1], first[1]) - bat_arrangement_holds(j->a, in[0], first[0]);
}

/* The side of a place on an edge; edges that run along another count as being where that is. False: it cannot be told. */
static bool look(judging *j, size_t index, double place, int *out) {
    const bat_arrangement *a = j->a;
    bat_region_ray r;
    bool up;
    int rest;
    if (!bat_ray_cast(a->edges + index, bat_edge_degree(a, a->edges + index), place, &r, &up, &rest))
        return false;
    forget(j);
    count(j, index, 1, j->own);
    /* With x and y changed, left is right, and all signs turn. */
    count(j, index, r.across ? -rest : rest, j->others);
    bat_winding_count(&j->winding, &r, index, CLEAR * a->gap, r.across ? take_away : put_to, j);
    /* What goes up is crossed by rays from its left only, what goes down by those from its right. */
    *out = side(j, up != r.across);
    j->near = r.near;
    return true;
}

static void judge(judging *j, bat_region_edge *e, size_t index) {
    double best = -1;
    for (int i = 0; i < PLACES && best < CLEAR * j->a->gap; i++) {
        int keep;
        if (!look(j, index, PLACE[i], &keep) || !(j->near > best)) continue;
        best = j->near;
        e->keep = keep;
    }
}

/* At each node as many edges must begin as end. */
static bool is_boundary(const bat_arrangement *a, int *balance) {
    for (size_t i = 0; i < a->edge_count; i++) {
        const bat_region_edge *e = a->edges + i;
        if (e->node[0] == BAT_NO_NODE) continue;
        balance[e->node[0]] += e->keep, balance[e->node[1]] -= e->keep;
    }
    for (size_t i = 0; i < a->node_count; i++)
        if (balance[i] != 0) return false;
    return true;
}

bat_status bat_arrangement_judge(bat_arrangement *a) {
    const size_t regions = a->region_count;
    judging j = {.a = a};
    int *balance = calloc(a->node_count + 1, sizeof *balance);
    j.others = calloc(2 * regions, sizeof *j.others);
    j.seen = calloc(regions, sizeof *j.seen);
    j.list = malloc(regions * sizeof *j.list);
    bat_status status = balance && j.others && j.seen && j.list ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) status = bat_winding_create(a, &j.winding);
    if (status == BAT_OK) {
        j.own = j.others + regions;
        for (size_t i = 0; i < a->edge_count; i++)
            if (a->edges[i].same_as == i) judge(&j, a->edges + i, i);
        if (!is_boundary(a, balance)) status = BAT_SINGULAR;
    }
    bat_winding_free(&j.winding);
    free(balance), free(j.others), free(j.seen), free(j.list);
    return status;
}
