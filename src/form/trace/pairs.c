/*
 * Pairs of cells of two surfaces that may meet. They are halved until both are small and their normals' cones are
 * disjoint, so that no loop can hide in them, or until both are very small; then a seed is sought by Newton's method, and
 * where cones still overlap a contact (docs/math/surfaces.md).
 */
#include "form/trace/meet.h"
#include "form/trace/poly.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PAIRS_MAX = 1000000, STACK = 2 * BAT_CELL_HALVINGS + 8 };
static const double smallest = 0.004 / 0.03; /* of the leaf */

typedef struct piece {
    bat_cell cell;
    int span[2];
    double low[3], high[3], wide; /* box and its diagonal */
    bool has_cone;
    vec axis;
    double angle; /* of the cone; 4: none */
} piece;

typedef struct pair {
    piece side[2];
} pair;

typedef struct search {
    bat_meet *m;
    pair *stack;
    int degree[2][2];
} search;

static int points_of(const int degree[2]) { return (degree[0] + 1) * (degree[1] + 1); }

static void measure(const int degree[2], piece *p) {
    double square = 0;
    p->has_cone = false;
    for (int c = 0; c < 3; c++) p->low[c] = INFINITY, p->high[c] = -INFINITY;
    for (int i = 0; i < points_of(degree); i++)
        for (int c = 0; c < 3; c++) {
            p->low[c] = fmin(p->low[c], p->cell.net[3 * i + c]);
            p->high[c] = fmax(p->high[c], p->cell.net[3 * i + c]);
        }
    for (int c = 0; c < 3; c++) square += (p->high[c] - p->low[c]) * (p->high[c] - p->low[c]);
    p->wide = sqrt(square);
}

/* A cone that holds all normals, from the coefficients of S_u x S_v; those that vanish (poles) are left out. */
static void find_cone(const int degree[2], piece *p) {
    bat_poly n[3];
    double most = 0, least = 1;
    vec sum = {0, 0, 0};
    if (p->has_cone) return;
    for (int c = 0; c < 3; c++)
        bat_poly_normal(p->cell.net, degree, c, &n[c]), most = fmax(most, bat_poly_most(&n[c]));
    const int count = points_of(n[0].degree);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < count; i++) {
            const vec one = {n[0].c[i], n[1].c[i], n[2].c[i]};
            if (!(vec_norm(one) > 1e-10 * most)) continue;
            if (pass == 0)
                sum = vec_add(sum, vec_unit(one));
            else
                least = fmin(least, vec_dot(vec_unit(one), p->axis));
            if (pass == 0) p->axis = vec_unit(sum);
        }
    p->angle = vec_norm(sum) > 1e-6 && least > 0 ? bat_acos(fmin(least, 1)) : 4;
    p->has_cone = true;
}

static bool boxes_apart(const pair *p, double gap) {
    for (int c = 0; c < 3; c++)
        if (p->side[0].low[c] > p->side[1].high[c] + gap || p->side[1].low[c] > p->side[0].high[c] + gap)
            return true;
    return false;
}

static bool apart_along(const search *s, const pair *p, vec way, double gap) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < points_of(s->degree[side]); i++) {
            const double d = vec_dot(vec_load(p->side[side].cell.net + 3 * i, 3), way);
            low[side] = fmin(low[side], d), high[side] = fmax(high[side], d);
        }
    return low[0] > high[1] + gap || low[1] > high[0] + gap;
}

static bool cones_disjoint(const pair *p) {
    const double sum = p->side[0].angle + p->side[1].angle + 1e-4; /* more than rounding, where cones touch */
    const double between = vec_angle(p->side[0].axis, p->side[1].axis);
    return between > sum && between < BAT_PI - sum;
}

static void middle_of(const search *s, const pair *p, double x[4]) {
    for (int k = 0; k < 4; k++) {
        const piece *one = &p->side[k / 2];
        x[k] = bat_span_parameter(s->m->side[k / 2], k % 2, one->span[k % 2],
                                  0.5 * (one->cell.low[k % 2] + one->cell.high[k % 2]));
    }
}

/* A point of both surfaces near the middle of the pair; where Newton's method leaves the domain, on its edge. */
static bat_status seed(search *s, const pair *p) {
    double x[4], bound;
    int which;
    bat_meet_place place;
    middle_of(s, p, x);
    if (!bat_meet_least(s->m, x)) return BAT_OK;
    for (int i = 0; i < 2 && !bat_meet_inside(s->m, x, &which, &bound); i++)
        if (!bat_meet_on_edge(s->m, which, bound, x)) return BAT_OK;
    if (!bat_meet_inside(s->m, x, NULL, NULL)) return BAT_OK;
    if (!bat_meet_place_at(s->m, x, &place) || place.sine <= 1e-3) return BAT_OK;
    /* what has gone further than the cells are wide is another pair's */
    for (int c = 0; c < 3; c++) {
        const double at[3] = {place.at.x, place.at.y, place.at.z}, slack = p->side[0].wide + p->side[1].wide;
        if (at[c] < p->side[0].low[c] - slack || at[c] > p->side[0].high[c] + slack) return BAT_OK;
    }
    return bat_meet_add_seed(s->m, x);
}

/* How far a cell reaches in a direction: the longest step of its net, times the degree. */
static double reach(const int degree[2], const double *net, int direction) {
    const int row = 3 * (degree[1] + 1), step = direction == 0 ? row : 3;
    double most = 0;
    for (int i = 0; i <= degree[0] - (direction == 0); i++)
        for (int j = 0; j <= degree[1] - (direction == 1); j++)
            most = fmax(most, bat_distance(net + i * row + 3 * j + step, net + i * row + 3 * j, 3));
    return most * degree[direction];
}

static void split(const search *s, int side, pair *p, pair *upper) {
    *upper = *p;
    const int *degree = s->degree[side];
    piece *low = &p->side[side], *high = &upper->side[side];
    const int direction = reach(degree, low->cell.net, 0) < reach(degree, low->cell.net, 1);
    bat_cell_halve(degree, direction, &low->cell, &high->cell);
    measure(degree, low);
    measure(degree, high);
}

static bat_status search_pair(search *s) {
    const double leaf = s->m->leaf * s->m->size, tiny = leaf * smallest;
    bat_status status = BAT_OK;
    for (int top = 0; top >= 0 && status == BAT_OK;) {
        pair *p = &s->stack[top--];
        if (++s->m->pairs > PAIRS_MAX) s->m->given_up = true;
        if (s->m->given_up) return BAT_OK;
        if (boxes_apart(p, s->m->gap)) continue;
        for (int side = 0; side < 2; side++) find_cone(s->degree[side], &p->side[side]);
        if (apart_along(s, p, p->side[0].axis, s->m->gap) || apart_along(s, p, p->side[1].axis, s->m->gap))
            continue;
        const double widest = fmax(p->side[0].wide, p->side[1].wide);
        const int larger = p->side[1].wide > p->side[0].wide;
        const bool disjoint = cones_disjoint(p), end = p->side[larger].cell.halvings >= BAT_CELL_HALVINGS;
        if (!end && !(disjoint && widest < leaf) && !(widest < tiny)) {
            split(s, larger, p, p + 1);
            top += 2;
            continue;
        }
        status = seed(s, p);
        double x[4];
        middle_of(s, p, x);
        if (status == BAT_OK && !disjoint) status = bat_meet_touch(s->m, x);
    }
    return status;
}

static bool spans_apart(const bat_box *a, const bat_box *b, double gap) {
    for (int c = 0; c < 3; c++)
        if (a->low[c] > b->high[c] + gap || b->low[c] > a->high[c] + gap) return true;
    return false;
}

/* All spans of the second surface against one of the first. */
static bat_status search_against(search *s, const bat_surface_finder *b, const bat_box *box,
                                 const piece *one) {
    bat_status status = BAT_OK;
    for (int i = 0; i < b->spans[0] && status == BAT_OK; i++)
        for (int j = 0; j < b->spans[1] && status == BAT_OK && !s->m->given_up; j++) {
            piece *other = &s->stack[0].side[1];
            const int block = i / BAT_FINDER_BLOCK * b->blocks[1] + j / BAT_FINDER_BLOCK;
            if (j % BAT_FINDER_BLOCK == 0 && spans_apart(box, &b->block[block], s->m->gap)) {
                j += BAT_FINDER_BLOCK - 1;
                continue;
            }
            if (spans_apart(box, &b->span[i * b->spans[1] + j], s->m->gap)) continue;
            if (!bat_finder_span(b, i, j, other->span)) continue;
            bat_cell_of(s->m->side[1], other->span, &other->cell);
            measure(s->degree[1], other);
            s->stack[0].side[0] = *one;
            status = search_pair(s);
        }
    return status;
}

static bat_status search_all(search *s, const bat_surface_finder *a, const bat_surface_finder *b) {
    bat_status status = BAT_OK;
    piece *one = malloc(sizeof *one);
    if (!one) return BAT_MEMORY;
    for (int i = 0; i < a->spans[0]; i++)
        for (int j = 0; j < a->spans[1] && status == BAT_OK; j++) {
            const bat_box *box = &a->span[i * a->spans[1] + j];
            if (spans_apart(box, &b->whole, s->m->gap) || !bat_finder_span(a, i, j, one->span)) continue;
            bat_cell_of(s->m->side[0], one->span, &one->cell);
            measure(s->degree[0], one);
            status = search_against(s, b, box, one);
        }
    free(one);
    return status;
}

bat_status bat_meet_search(bat_meet *m) {
    search s = {.m = m, .stack = malloc(STACK * sizeof *s.stack)};
    bat_surface_finder *finder[2] = {NULL, NULL};
    bat_status status = s.stack ? BAT_OK : BAT_MEMORY;
    for (int side = 0; side < 2; side++) {
        for (int d = 0; d < 2; d++) s.degree[side][d] = m->side[side]->axis[d].degree;
        if (status == BAT_OK) status = bat_surface_finder_create(m->side[side], &finder[side]);
    }
    if (status == BAT_OK) status = search_all(&s, finder[0], finder[1]);
    for (int side = 0; side < 2; side++) bat_surface_finder_free(finder[side]);
    free(s.stack);
    return status;
}

bat_status bat_meet_add_seed(bat_meet *m, const double x[4]) {
    if (m->seed_count == m->seed_room) {
        const size_t room = 2 * m->seed_room + 64;
        double(*more)[4] = realloc(m->seeds, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        m->seeds = more, m->seed_room = room;
    }
    memcpy(m->seeds[m->seed_count++], x, sizeof m->seeds[0]);
    return BAT_OK;
}
