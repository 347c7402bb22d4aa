/* Winding numbers of what straight edges that meet at nodes alone part the plane into: from face to face across the edges, so
 * that they always fit together (docs/math/relate.md 6). */
#include "relate/region/grid.h"

#include <math.h>
#include <stdlib.h>

/* To the face on the left of a side: across that side; or (hits) to the outer face of what hangs together, which a ray to the
 * left tells. */
typedef struct step {
    size_t side, hits;
    bool outer;
} step;

/* An edge that the ray of a step crosses, and by how much the winding number is then more. */
typedef struct hit {
    size_t edge;
    int more;
} hit;

/* Each edge has two sides: side 2 e is on the left of edge e, 2 e + 1 on its right. A side runs with its face to the left, from
 * node `from` to that of side ^ 1. */
typedef struct faces {
    const bat_arrangement *a;
    size_t count; /* of sides */
    size_t *from, *first, *order,
        *at;                  /* order: sides by the node they leave, anticlockwise; first: of each node */
    size_t face_count, *face; /* of each side; BAT_NO_NODE: an edge that another stands for */
    size_t step_count;
    struct step *steps; /* in which all faces are reached */
    size_t hit_count, hit_room;
    struct hit *hits;
    int *winding; /* of each face, in one region */
    size_t *in;   /* of each face: how many regions it is in */
    bool *in_first;
} faces;

static const double *node_of(const faces *f, size_t side) { return f->a->nodes + 2 * f->from[side]; }

static void way_of(const faces *f, size_t side, double out[2]) {
    for (int c = 0; c < 2; c++) out[c] = (node_of(f, side ^ 1)[c] - node_of(f, side)[c]) / f->a->step;
}

static bool is_edge(const faces *f, size_t side) { return f->a->edges[side / 2].same_as == side / 2; }

/* ---- round the nodes ---- */

typedef struct spoke {
    double way[2];
    size_t side;
} spoke;

/* From -y, not included, anticlockwise. */
static int by_angle(const void *a, const void *b) {
    const spoke *x = a, *y = b;
    const bool left = x->way[0] < 0 || (x->way[0] == 0 && x->way[1] < 0),
               other = y->way[0] < 0 || (y->way[0] == 0 && y->way[1] < 0);
    if (left != other) return left ? 1 : -1;
    return -bat_grid_turn(x->way, y->way);
}

static bat_status sort_round(faces *f) {
    const size_t nodes = f->a->node_count;
    for (size_t s = 0; s < f->count; s++)
        if (is_edge(f, s)) f->first[f->from[s] + 1]++;
    for (size_t n = 0; n < nodes; n++) f->first[n + 1] += f->first[n];
    spoke *all = malloc((f->first[nodes] + 1) * sizeof *all);
    size_t *next = malloc((nodes + 1) * sizeof *next);
    if (!all || !next) {
        free(all), free(next);
        return BAT_MEMORY;
    }
    for (size_t n = 0; n < nodes; n++) next[n] = f->first[n];
    for (size_t s = 0; s < f->count; s++) {
        if (!is_edge(f, s)) continue;
        spoke *to = all + next[f->from[s]]++;
        to->side = s;
        way_of(f, s, to->way);
    }
    for (size_t n = 0; n < nodes; n++)
        qsort(all + f->first[n], f->first[n + 1] - f->first[n], sizeof *all, by_angle); /* no ties */
    for (size_t i = 0; i < f->first[nodes]; i++) f->order[i] = all[i].side, f->at[all[i].side] = i;
    free(all), free(next);
    return BAT_OK;
}

/* The side that goes on along the same face. */
static size_t next_of(const faces *f, size_t side) {
    const size_t twin = side ^ 1, node = f->from[twin], i = f->at[twin];
    return f->order[i > f->first[node] ? i - 1 : f->first[node + 1] - 1];
}

static void find_faces(faces *f) {
    for (size_t s = 0; s < f->count; s++) f->face[s] = BAT_NO_NODE;
    for (size_t s = 0; s < f->count; s++) {
        if (!is_edge(f, s) || f->face[s] != BAT_NO_NODE) continue;
        for (size_t k = s; f->face[k] == BAT_NO_NODE; k = next_of(f, k)) f->face[k] = f->face_count;
        f->face_count++;
    }
}

/* ---- from face to face ---- */

static bat_status add_hit(faces *f, size_t edge, int more) {
    if (f->hit_count == f->hit_room) {
        const size_t room = 2 * f->hit_room + 64;
        hit *all = realloc(f->hits, room * sizeof *all);
        if (!all) return BAT_MEMORY;
        f->hits = all, f->hit_room = room;
    }
    f->hits[f->hit_count++] = (hit){edge, more};
    return BAT_OK;
}

/* What a ray from a node to the left crosses. */
static bat_status cast(faces *f, size_t node) {
    const double *x = f->a->nodes + 2 * node;
    bat_status status = BAT_OK;
    for (size_t e = 0; e < f->a->edge_count && status == BAT_OK; e++) {
        if (!is_edge(f, 2 * e)) continue;
        const double *p = node_of(f, 2 * e), *q = node_of(f, 2 * e + 1);
        if ((p[1] <= x[1]) == (q[1] <= x[1]) || (p[0] > x[0] && q[0] > x[0])) continue;
        const bool up = q[1] > p[1];
        const double w[2] = {(x[0] - p[0]) / f->a->step, (x[1] - p[1]) / f->a->step};
        double way[2];
        way_of(f, 2 * e, way);
        if (bat_grid_turn(way, w) == (up ? -1 : 1)) status = add_hit(f, e, up ? -1 : 1);
    }
    return status;
}

/* Nodes are in order of x, then y: the first that is not seen is the leftmost of what hangs together, and the last of the sides
 * that leave it has the outer face to its left. */
static bat_status find_steps(faces *f, size_t *queue, bool *seen) {
    bat_status status = BAT_OK;
    for (size_t n = 0; n < f->a->node_count && status == BAT_OK; n++) {
        if (f->first[n + 1] == f->first[n]) continue;
        const size_t outer = f->order[f->first[n + 1] - 1];
        if (seen[f->face[outer]]) continue;
        size_t head = 0, tail = 0;
        status = cast(f, n);
        seen[f->face[outer]] = true;
        f->steps[f->step_count++] = (step){outer, f->hit_count, true};
        for (queue[tail++] = outer; head < tail;) {
            const size_t start = queue[head++];
            size_t s = start;
            do {
                const size_t beyond = s ^ 1;
                if (!seen[f->face[beyond]]) {
                    seen[f->face[beyond]] = true;
                    f->steps[f->step_count++] = (step){beyond, f->hit_count, false};
                    queue[tail++] = beyond;
                }
                s = next_of(f, s);
            } while (s != start);
        }
    }
    return status;
}

/* By how much the winding number in a region is more on the left of an edge than on its right. */
static int rise_of(const faces *f, size_t edge, size_t region) {
    const bat_arrangement *a = f->a;
    int sum = 0;
    for (size_t i = edge; i != BAT_NO_NODE; i = a->edges[i].next)
        if (a->curves[a->edges[i].curve].region == region) sum += a->edges[i].sign;
    return sum;
}

static void wind(faces *f, size_t region) {
    size_t h = 0;
    for (size_t i = 0; i < f->step_count; i++) {
        const step *s = f->steps + i;
        int *at = f->winding + f->face[s->side];
        if (s->outer)
            for (*at = 0; h < s->hits; h++) *at += f->hits[h].more * rise_of(f, f->hits[h].edge, region);
        else
            *at = f->winding[f->face[s->side ^ 1]] + (s->side % 2 ? -1 : 1) * rise_of(f, s->side / 2, region);
    }
    const bool even_odd = f->a->regions[region].even_odd;
    for (size_t i = 0; i < f->face_count; i++) {
        const bool inside = even_odd ? f->winding[i] % 2 != 0 : f->winding[i] != 0;
        f->in[i] += inside;
        if (region == 0) f->in_first[i] = inside;
    }
}

static bool holds(const faces *f, size_t side) {
    const size_t face = f->face[side];
    return bat_arrangement_holds(f->a, f->in[face], f->in_first[face]);
}

static bat_status reach_all(faces *f) {
    size_t *queue = malloc((f->face_count + 1) * sizeof *queue);
    bool *seen = calloc(f->face_count + 1, sizeof *seen);
    f->steps = malloc((f->face_count + 1) * sizeof *f->steps);
    f->winding = malloc((f->face_count + 1) * sizeof *f->winding);
    f->in = calloc(f->face_count + 1, sizeof *f->in);
    f->in_first = calloc(f->face_count + 1, sizeof *f->in_first);
    const bool enough = queue && seen && f->steps && f->winding && f->in && f->in_first;
    const bat_status status = enough ? find_steps(f, queue, seen) : BAT_MEMORY;
    free(queue), free(seen);
    return status;
}

static bat_status judge(faces *f, bat_arrangement *to) {
    bat_status status = sort_round(f);
    if (status != BAT_OK) return status;
    find_faces(f);
    status = reach_all(f);
    if (status != BAT_OK) return status;
    for (size_t r = 0; r < to->region_count; r++) wind(f, r);
    for (size_t e = 0; e < to->edge_count; e++)
        if (is_edge(f, 2 * e)) to->edges[e].keep = holds(f, 2 * e) - holds(f, 2 * e + 1);
    return BAT_OK;
}

bat_status bat_arrangement_faces(bat_arrangement *a) {
    faces f = {.a = a, .count = 2 * a->edge_count};
    size_t *room = calloc(4 * f.count + a->node_count + 2, sizeof *room);
    if (!room) return BAT_MEMORY;
    f.from = room, f.order = room + f.count, f.at = room + 2 * f.count, f.face = room + 3 * f.count;
    f.first = room + 4 * f.count;
    for (size_t s = 0; s < f.count; s++) f.from[s] = a->edges[s / 2].node[s % 2];
    const bat_status status = judge(&f, a);
    free(room), free(f.steps), free(f.hits), free(f.winding), free(f.in), free(f.in_first);
    return status;
}
