/* On which side of an edge the result lies: winding numbers by a ray from a point of it. */
#include "base/real.h"
#include "relate/region/arrangement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 60, PLACES = 7, PIECE = 2 * (BAT_DEGREE_MAX + 1) };

/* Where an edge is asked, in the order in which places are tried; gaps: so far from every other edge is far enough. */
static const double PLACE[PLACES] = {0.5, 0.27, 0.73, 0.14, 0.86, 0.06, 0.94};
static const double CLEAR = 64;

/* A ray along +x from a point; across: x and y have changed places. */
typedef struct ray {
    double x, y;
    bool across;
    double
        near; /* how near to the point a box was that it lies in: no more than a few times the distance of the edge */
} ray;

static void turn(const ray *r, const double *p, double q[2]) { q[0] = p[r->across], q[1] = p[!r->across]; }

/* Upwards across the height of the ray or downwards, by the ends alone: so pieces that follow each other agree. */
static int step(const ray *r, double y0, double y1) { return (y1 > r->y) - (y0 > r->y); }

/* Cuts a segment at t: q keeps what is behind it. */
static void cut(double *q, int degree, double t, double *left) {
    for (int k = 0; k <= degree; k++) { /* de Casteljau */
        left[2 * k] = q[0], left[2 * k + 1] = q[1];
        for (int i = 0; i < degree - k; i++)
            for (int c = 0; c < 2; c++) q[2 * i + c] = (1 - t) * q[2 * i + c] + t * q[2 * i + 2 + c];
    }
}

/* How often a Bézier segment crosses the ray upwards, less how often downwards. q: turned, used up. */
static int crossings(ray *r, double *q, int degree, int depth) {
    double low[2] = {q[0], q[1]}, high[2] = {q[0], q[1]}, left[PIECE];
    for (int i = 1; i <= degree; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], q[2 * i + c]);
            high[c] = fmax(high[c], q[2 * i + c]);
        }
    if (high[0] <= r->x || low[1] > r->y || high[1] < r->y) return 0;
    const int both = step(r, q[1], q[2 * degree + 1]);
    if (low[0] > r->x) return both;
    r->near = fmin(r->near, fmax(high[0] - low[0], high[1] - low[1]));
    if (depth == DEPTH_MAX) return q[0] + q[2 * degree] > 2 * r->x ? both : 0;
    cut(q, degree, 0.5, left);
    return crossings(r, left, degree, depth + 1) + crossings(r, q, degree, depth + 1);
}

static void span_of(const ray *r, const bat_edge *e, int degree, int i, double q[PIECE]) {
    for (int k = 0; k <= degree; k++) turn(r, e->bezier + 2 * ((degree + 1) * i + k), q + 2 * k);
}

/* skip: a span that is not looked at. */
static int winding_of(ray *r, const bat_edge *e, int degree, int skip) {
    double low[2], high[2];
    turn(r, e->box, low), turn(r, e->box + 2, high);
    if (high[0] <= r->x || low[1] > r->y || high[1] < r->y) return 0;
    const double *last = e->bezier + 2 * ((degree + 1) * e->spans - 1);
    if (low[0] > r->x && skip < 0) return step(r, e->bezier[!r->across], last[!r->across]);
    int sum = 0;
    for (int i = 0; i < e->spans; i++) {
        double q[PIECE];
        if (i == skip) continue;
        span_of(r, e, degree, i, q);
        sum += crossings(r, q, degree, 0);
    }
    return sum;
}

/* Whether it goes up all the way, or down. */
static bool is_steep(const double *q, int degree) {
    const bool up = q[2 * degree + 1] > q[1];
    for (int k = 0; k < degree; k++)
        if (up ? !(q[2 * k + 3] > q[2 * k + 1]) : !(q[2 * k + 3] < q[2 * k + 1])) return false;
    return true;
}

/* The ray from a place of the edge, and how often the rest of the edge crosses it: all but a piece round the place, which
 * crosses it once there. False: it cannot be told there. */
static bool cast(const bat_edge *e, int degree, double place, ray *r, bool *up, int *rest) {
    const double x = place * e->spans;
    const int i = (int)fmin(x, e->spans - 1);
    const double t = fmin(fmax(x - i, 0.1), 0.9);
    double q[PIECE], left[PIECE];
    *r = (ray){.near = INFINITY};
    span_of(r, e, degree, i, q);
    cut(q, degree, t, left);
    const double dx = q[2] - left[2 * degree - 2], dy = q[3] - left[2 * degree - 1];
    const double p[2] = {q[0], q[1]};
    r->across = fabs(dx) > fabs(dy);
    r->x = p[r->across], r->y = p[!r->across];
    for (double width = 0.5 * fmin(t, 1 - t); width > 1e-5; width *= 0.5) {
        double middle[PIECE];
        span_of(r, e, degree, i, q);
        cut(q, degree, t - width, left);
        cut(q, degree, 2 * width / (1 - t + width), middle);
        if (!is_steep(middle, degree) || step(r, middle[1], middle[2 * degree + 1]) == 0) continue;
        *up = middle[2 * degree + 1] > middle[1];
        *rest = winding_of(r, e, degree, i) + crossings(r, left, degree, 0) + crossings(r, q, degree, 0);
        return true;
    }
    return false;
}

typedef struct sides {
    int *left, *right; /* winding numbers of each region */
    int *own;          /* what the edge, and those along it, add to the left */
    int *crossed;      /* by each first edge */
    double near;
} sides;

static int degree_of(const bat_arrangement *a, const bat_edge *e) {
    return bat_curve_degree(a->curves[e->curve].curve);
}

/* Winding numbers left and right of a place on an edge; edges that run along another count as being where that is. */
static bool look(const bat_arrangement *a, size_t index, double place, sides *s) {
    ray r;
    bool up;
    if (!cast(a->edges + index, degree_of(a, a->edges + index), place, &r, &up, s->crossed + index))
        return false;
    for (size_t i = 0; i < a->edge_count; i++)
        if (i != index && a->edges[i].same_as == i)
            s->crossed[i] = winding_of(&r, a->edges + i, degree_of(a, a->edges + i), -1);
    memset(s->right, 0, a->region_count * sizeof *s->right);
    for (size_t i = 0; i < a->edge_count; i++)
        s->right[a->curves[a->edges[i].curve].region] += a->edges[i].sign * s->crossed[a->edges[i].same_as];
    /* What goes up is crossed by rays from its left only, what goes down by those from its right. With x and y changed,
     * left is right, and all signs turn. */
    for (size_t k = 0; k < a->region_count; k++) {
        const int others = r.across ? -s->right[k] : s->right[k];
        s->right[k] = up != r.across ? others : others - s->own[k];
        s->left[k] = s->right[k] + s->own[k];
    }
    s->near = r.near;
    return true;
}

static bool is_inside(const bat_arrangement *a, const int *winding) {
    size_t in = 0;
    bool first = false;
    for (size_t k = 0; k < a->region_count; k++) {
        const bool inside = a->regions[k].even_odd ? winding[k] % 2 != 0 : winding[k] != 0;
        if (k == 0) first = inside;
        in += inside;
    }
    switch (a->operation) {
    case BAT_REGION_UNION: return in > 0;
    case BAT_REGION_DIFFERENCE: return first && in == 1;
    case BAT_REGION_INTERSECTION: return in == a->region_count;
    default: return in % 2 == 1;
    }
}

static void judge(const bat_arrangement *a, size_t index, sides *s) {
    bat_edge *e = a->edges + index;
    double best = -1;
    memset(s->own, 0, a->region_count * sizeof *s->own);
    for (size_t i = 0; i < a->edge_count; i++)
        if (a->edges[i].same_as == index) s->own[a->curves[a->edges[i].curve].region] += a->edges[i].sign;
    for (int i = 0; i < PLACES && best < CLEAR * a->gap; i++) {
        if (!look(a, index, PLACE[i], s) || !(s->near > best)) continue;
        best = s->near;
        e->keep = is_inside(a, s->left) - is_inside(a, s->right);
    }
}

/* At each node as many edges must begin as end. */
static bool is_boundary(const bat_arrangement *a, int *balance) {
    memset(balance, 0, (a->node_count + 1) * sizeof *balance);
    for (size_t i = 0; i < a->edge_count; i++) {
        const bat_edge *e = a->edges + i;
        if (e->node[0] == BAT_NO_NODE) continue;
        balance[e->node[0]] += e->keep, balance[e->node[1]] -= e->keep;
    }
    for (size_t i = 0; i < a->node_count; i++)
        if (balance[i] != 0) return false;
    return true;
}

bat_status bat_arrangement_judge(bat_arrangement *a) {
    const size_t regions = a->region_count;
    int *memory = malloc((3 * regions + a->node_count + a->edge_count + 1) * sizeof *memory);
    if (!memory) return BAT_MEMORY;
    sides s = {.left = memory, .right = memory + regions, .own = memory + 2 * regions};
    s.crossed = memory + 3 * regions;
    for (size_t i = 0; i < a->edge_count; i++)
        if (a->edges[i].same_as == i) judge(a, i, &s);
    const bool whole = is_boundary(a, s.crossed + a->edge_count);
    free(memory);
    return whole ? BAT_OK : BAT_SINGULAR;
}
