#include "format/model/rim.h"

#include "base/vec.h"

#include <stdlib.h>

/* ---- vertices at one place ---- */

typedef struct placed {
    double at[3];
    int index;
} placed;

static int by_place(const void *a, const void *b) {
    const placed *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->at[k] != q->at[k]) return p->at[k] < q->at[k] ? -1 : 1;
    return p->index < q->index ? -1 : 1; /* no ties */
}

static bool is_one_place(const placed *a, const placed *b) {
    return a->at[0] == b->at[0] && a->at[1] == b->at[1] && a->at[2] == b->at[2];
}

bat_status bat_rim_same(const bat_part *part, int *same) {
    const size_t count = part->vertex_count;
    placed *list = malloc((count + 1) * sizeof *list);
    if (!list) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < 3; k++) list[i].at[k] = part->points[3 * i + k];
        list[i].index = (int)i;
    }
    qsort(list, count, sizeof *list, by_place); /* no ties */
    for (size_t i = 0, first = 0; i < count; i++) {
        if (!is_one_place(&list[i], &list[first])) first = i;
        same[list[i].index] = list[first].index;
    }
    free(list);
    return BAT_OK;
}

/* ---- open edges ---- */

typedef struct side {
    int low, high, way; /* way: 1 from low to high, -1 back */
} side;

static int by_ends(const void *a, const void *b) {
    const side *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    if (p->high != q->high) return p->high < q->high ? -1 : 1;
    return p->way - q->way;
}

static int by_from(const void *a, const void *b) {
    const bat_rim_edge *p = a, *q = b;
    if (p->from != q->from) return p->from < q->from ? -1 : 1;
    return p->to == q->to ? 0 : p->to < q->to ? -1 : 1;
}

static bool has_area(const double *points, const int *triangle) {
    vec at[3];
    for (int k = 0; k < 3; k++) at[k] = vec_load(points + 3 * (size_t)triangle[k], 3);
    const vec normal = vec_unit(vec_cross(vec_sub(at[1], at[0]), vec_sub(at[2], at[0])));
    return vec_dot(normal, normal) > 0;
}

static size_t list_sides(const bat_part *part, const int *same, side *out) {
    size_t count = 0;
    for (size_t t = 0; t < part->triangle_count; t++) {
        const int *triangle = part->triangles + 3 * t;
        const int at[3] = {same[triangle[0]], same[triangle[1]], same[triangle[2]]};
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0] || !has_area(part->points, triangle)) continue;
        for (int k = 0; k < 3; k++) {
            const int from = at[k], to = at[(k + 1) % 3];
            out[count++] = from < to ? (side){from, to, 1} : (side){to, from, -1};
        }
    }
    return count;
}

bat_status bat_rim_edges(const bat_part *part, const int *same, size_t *count, bat_rim_edge **out) {
    side *sides = malloc((3 * part->triangle_count + 1) * sizeof *sides);
    bat_rim_edge *edges = malloc((3 * part->triangle_count + 1) * sizeof *edges);
    if (!sides || !edges) {
        free(sides);
        free(edges);
        return BAT_MEMORY;
    }
    const size_t all = list_sides(part, same, sides);
    size_t found = 0;
    qsort(sides, all, sizeof *sides, by_ends); /* no ties but of equals */
    for (size_t i = 0; i < all;) {
        const side *first = &sides[i];
        int sum = 0;
        for (; i < all && sides[i].low == first->low && sides[i].high == first->high; i++)
            sum += sides[i].way;
        for (; sum > 0; sum--) edges[found++] = (bat_rim_edge){first->low, first->high};
        for (; sum < 0; sum++) edges[found++] = (bat_rim_edge){first->high, first->low};
    }
    free(sides);
    qsort(edges, found, sizeof *edges, by_from); /* no ties but of equals */
    *count = found;
    *out = edges;
    return BAT_OK;
}

/* ---- seams ---- */

typedef struct ranked {
    double key;
    int vertex;
} ranked;

static int by_key(const void *a, const void *b) {
    const ranked *p = a, *q = b;
    if (p->key != q->key) return p->key < q->key ? -1 : 1;
    return p->vertex == q->vertex ? 0 : p->vertex < q->vertex ? -1 : 1;
}

bat_status bat_rim_join(const bat_part *part, size_t count, const bat_rim_edge *edges, double within,
                        int *same, size_t *joined) {
    ranked *list = malloc((count + 1) * sizeof *list);
    size_t ends = 0;
    *joined = 0;
    if (!list) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) { /* along a line that rims seldom lie across */
        if (ends && list[ends - 1].vertex == edges[i].from) continue;
        const double *p = part->points + 3 * (size_t)edges[i].from;
        list[ends++] = (ranked){0.48 * p[0] + 0.6 * p[1] + 0.64 * p[2], edges[i].from};
    }
    qsort(list, ends, sizeof *list, by_key); /* no ties but of equals */
    for (size_t i = 0; i < ends; i++)
        for (size_t j = i + 1; j < ends && list[j].key - list[i].key <= within; j++) {
            const vec a = vec_load(part->points + 3 * (size_t)list[i].vertex, 3),
                      b = vec_load(part->points + 3 * (size_t)list[j].vertex, 3);
            const int p = bat_rim_root(same, list[i].vertex), q = bat_rim_root(same, list[j].vertex);
            if (p == q || vec_norm(vec_sub(a, b)) > within) continue;
            same[p < q ? q : p] = p < q ? p : q;
            ++*joined;
        }
    for (size_t i = 0; i < part->vertex_count; i++) same[i] = bat_rim_root(same, (int)i);
    free(list);
    return BAT_OK;
}
