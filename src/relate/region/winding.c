#include "relate/region/winding.h"

#include "base/box.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { CELLS = 1 << 16 }; /* along each side */

/* Edges that run along another are where that is. */
static const bat_region_edge *shape_of(const bat_arrangement *a, size_t edge) {
    return a->edges + a->edges[edge].same_as;
}

static const double *points_of(const void *things, size_t i, size_t *count) {
    const bat_winding *w = things;
    const bat_region_edge *e = shape_of(w->a, w->order[i]);
    *count = (size_t)e->spans * (size_t)(bat_edge_degree(w->a, e) + 1);
    return e->bezier;
}

/* ---- the order ---- */

/* The edges of a curve. */
typedef struct loop {
    size_t first, count;
    double box[4];
    uint32_t cell; /* of Morton's curve */
} loop;

static int by_cell(const void *a, const void *b) {
    const loop *x = a, *y = b;
    if (x->cell != y->cell) return x->cell < y->cell ? -1 : 1;
    return (x->first > y->first) - (x->first < y->first);
}

static size_t find_loops(const bat_arrangement *a, loop *all, double box[4]) {
    size_t count = 0;
    bat_box_nothing(box);
    for (size_t i = 0; i < a->edge_count; i++) {
        if (i == 0 || a->edges[i].curve != a->edges[i - 1].curve) {
            all[count] = (loop){.first = i};
            bat_box_nothing(all[count++].box);
        }
        all[count - 1].count++;
        bat_box_hold(all[count - 1].box, a->edges[i].box), bat_box_hold(box, a->edges[i].box);
    }
    return count;
}

static uint32_t cell_of(const loop *l, const double box[4]) {
    const double side = fmax(fmax(box[2] - box[0], box[3] - box[1]), 1e-300);
    uint32_t cell = 0;
    for (int c = 0; c < 2; c++) {
        const double share = (0.5 * l->box[c] + 0.5 * l->box[2 + c] - box[c]) / side;
        const uint32_t at = (uint32_t)fmin(fmax(share, 0) * CELLS, CELLS - 1);
        for (int bit = 0; bit < 16; bit++) cell |= (at >> bit & 1) << (2 * bit + c);
    }
    return cell;
}

static bat_status put_in_order(bat_winding *w) {
    loop *all = malloc((w->count + 1) * sizeof *all);
    if (!all) return BAT_MEMORY;
    double box[4];
    const size_t count = find_loops(w->a, all, box);
    for (size_t i = 0; i < count; i++) all[i].cell = cell_of(all + i, box);
    qsort(all, count, sizeof *all, by_cell); /* no ties: loops differ */
    size_t at = 0;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < all[i].count; k++) w->order[at++] = all[i].first + k;
    free(all);
    return BAT_OK;
}

/* ---- runs ---- */

static bool goes_on(const bat_region_edge *x, const bat_region_edge *y) {
    return x->curve == y->curve && x->node[1] != BAT_NO_NODE && x->node[1] == y->node[0];
}

static void find_runs(bat_winding *w) {
    const bat_region_edge *edges = w->a->edges;
    w->open[0] = 0;
    for (size_t from = 0, to; from < w->count; from = to) {
        for (to = from + 1; to < w->count && goes_on(edges + w->order[to - 1], edges + w->order[to]); to++) {
        }
        const bool open = edges[w->order[from]].node[0] != edges[w->order[to - 1]].node[1];
        for (size_t i = from; i < to; i++)
            w->run_start[i] = from, w->run_end[i] = to, w->open[i + 1] = w->open[from] + open;
    }
}

bat_status bat_winding_create(const bat_arrangement *a, bat_winding *out) {
    const size_t n = a->edge_count;
    *out = (bat_winding){.a = a, .count = n};
    if (n == 0) return BAT_OK;
    out->order = malloc(n * sizeof *out->order);
    out->run_start = malloc(n * sizeof *out->run_start);
    out->run_end = malloc(n * sizeof *out->run_end);
    out->open = malloc((n + 1) * sizeof *out->open);
    if (!out->order || !out->run_start || !out->run_end || !out->open) return BAT_MEMORY;
    const bat_status status = put_in_order(out);
    if (status != BAT_OK) return status;
    find_runs(out);
    return bat_hulls_create(2, n, points_of, out, &out->hulls);
}

void bat_winding_free(bat_winding *w) {
    free(w->order), free(w->run_start), free(w->run_end), free(w->open), free(w->hulls);
    *w = (bat_winding){0};
}

/* ---- rays ---- */

typedef struct counting {
    const bat_winding *w;
    bat_region_ray *r;
    size_t skip;
    double near, start[2];
    bat_winding_add add;
    void *to;
} counting;

/* A stretch of a run whose hull the ray does not start in crosses it as its chord does. */
static void add_chord(const counting *c, size_t from, size_t to) {
    const bat_arrangement *a = c->w->a;
    const bat_region_edge *first = a->edges + c->w->order[from], *last = a->edges + c->w->order[to - 1];
    if (first->node[0] == last->node[1]) return; /* all the way round */
    const double *end = last->bezier + 2 * ((bat_edge_degree(a, last) + 1) * last->spans - 1);
    const int crossed = bat_ray_chord(c->r, first->bezier, end);
    if (crossed) c->add(c->to, a->curves[first->curve].region, crossed);
}

/* False: there are whole runs in it that are open. */
static bool add_outside(const counting *c, bat_hull_part s) {
    const bat_winding *w = c->w;
    const size_t end = s.first + s.count, left = w->run_end[s.first], right = w->run_start[end - 1];
    if (left >= end) {
        add_chord(c, s.first, end);
        return true;
    }
    if (w->open[right] > w->open[left]) return false;
    add_chord(c, s.first, left), add_chord(c, right, end);
    return true;
}

static void count_in(const counting *c, bat_hull_part s) {
    const bat_winding *w = c->w;
    if (!bat_hull_beside(w->hulls + s.node, c->start, c->near) && add_outside(c, s)) return;
    if (s.count == 1) {
        const bat_region_edge *e = w->a->edges + w->order[s.first],
                              *shape = shape_of(w->a, w->order[s.first]);
        if (e->same_as == c->skip) return;
        const int crossed = e->sign * bat_ray_crossings(c->r, shape, bat_edge_degree(w->a, shape));
        if (crossed) c->add(c->to, w->a->curves[e->curve].region, crossed);
        return;
    }
    bat_hull_part half[2];
    bat_hull_halve(s, half);
    count_in(c, half[0]), count_in(c, half[1]);
}

void bat_winding_count(const bat_winding *w, bat_region_ray *r, size_t skip, double near, bat_winding_add add,
                       void *to) {
    counting c = {.w = w, .r = r, .skip = skip, .near = near, .add = add, .to = to};
    c.start[r->across] = r->x, c.start[!r->across] = r->y;
    if (w->count) count_in(&c, (bat_hull_part){0, 0, w->count});
}
