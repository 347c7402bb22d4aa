/* Parts become watertight: seams are joined, and rims that lie in a plane or end a tube are filled. */
#include "format/model/fill.h"
#include "format/model/rim.h"

#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SEAM = 1e-7, FLAT = 1e-9; /* of the size */

typedef struct closing {
    const bat_part *part;
    double tolerance, seam;
    bool cap, outward, tube; /* tube: of a surface that is closed in a direction */
    size_t edge_count, open;
    bat_rim_edge *edges;
    int *same, *piece; /* of each vertex: the first at its place; another one that it hangs together with */
    bool *used;        /* of each edge */
    /* the part as it becomes */
    size_t vertex_count, triangle_count;
    double *points, *normals;
    int *triangles;
    /* one rim */
    size_t corner_count;
    int *corners, *next;
    double *flat;
} closing;

static void clear(closing *c) {
    free(c->edges);
    free(c->same);
    free(c->piece);
    free(c->used);
    free(c->corners);
    free(c->next);
    free(c->flat);
}

static vec place(const closing *c, int vertex) { return vec_load(c->part->points + 3 * (size_t)vertex, 3); }

static void find_pieces(closing *c) {
    for (size_t i = 0; i < c->part->vertex_count; i++) c->piece[i] = (int)i;
    for (size_t i = 0; i < 3 * c->part->triangle_count; i++) {
        const int a = bat_rim_root(c->piece, c->same[c->part->triangles[i]]),
                  b = bat_rim_root(c->piece, c->same[c->part->triangles[i - i % 3]]);
        c->piece[a < b ? b : a] = a < b ? a : b;
    }
}

/* ---- rims ---- */

static size_t edge_from(const closing *c, int vertex) {
    size_t low = 0, high = c->edge_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (c->edges[middle].from < vertex)
            low = middle + 1;
        else
            high = middle;
    }
    while (low < c->edge_count && c->edges[low].from == vertex && c->used[low]) low++;
    return low < c->edge_count && c->edges[low].from == vertex ? low : c->edge_count;
}

/* The rim that an edge belongs to; false: it does not come back. Corners are the other way round than the edges. */
static bool walk_rim(closing *c, size_t first) {
    size_t at = first, count = 0;
    do {
        c->used[at] = true;
        c->corners[c->edge_count - ++count] = c->edges[at].from;
        if (c->edges[at].to == c->edges[first].from) break;
        at = edge_from(c, c->edges[at].to);
    } while (at < c->edge_count);
    memmove(c->corners, c->corners + c->edge_count - count, count * sizeof *c->corners);
    c->corner_count = count;
    return at < c->edge_count && count >= 3;
}

typedef struct plane {
    vec origin, normal, x, y;
} plane;

static bool find_plane(const closing *c, plane *out) {
    const vec first = place(c, c->corners[0]);
    vec sum = {0, 0, 0}, middle = {0, 0, 0};
    for (size_t i = 0; i < c->corner_count; i++) {
        const vec a = vec_sub(place(c, c->corners[i]), first),
                  b = vec_sub(place(c, c->corners[(i + 1) % c->corner_count]), first);
        sum = vec_add(sum, vec_cross(a, b));
        middle = vec_add(middle, vec_scale(a, 1 / (double)c->corner_count));
    }
    out->origin = vec_add(first, middle);
    out->normal = vec_unit(sum);
    out->x = vec_any_normal(out->normal);
    out->y = vec_cross(out->normal, out->x);
    return vec_dot(out->normal, out->normal) > 0;
}

static bool is_near(const closing *c, const plane *p, int vertex) {
    return fabs(vec_dot(vec_sub(place(c, vertex), p->origin), p->normal)) <= c->tolerance;
}

static bool is_flat_sheet(closing *c, const plane *p) {
    const int piece = bat_rim_root(c->piece, c->corners[0]);
    for (size_t i = 0; i < c->part->vertex_count; i++)
        if (bat_rim_root(c->piece, c->same[i]) == piece && !is_near(c, p, c->same[i])) return false;
    return true;
}

/* ---- what is put over them ---- */

static void put_vertex(closing *c, vec at, vec normal) {
    vec_store(at, c->points + 3 * c->vertex_count);
    vec_store(normal, c->normals + 3 * c->vertex_count);
    c->vertex_count++;
}

static bool fill_rim(closing *c) {
    plane p;
    double middle[2];
    size_t count;
    bool planar = true;
    if (!find_plane(c, &p)) return false;
    for (size_t i = 0; i < c->corner_count; i++) {
        const vec at = vec_sub(place(c, c->corners[i]), p.origin);
        planar = planar && is_near(c, &p, c->corners[i]);
        c->flat[2 * i] = vec_dot(at, p.x), c->flat[2 * i + 1] = vec_dot(at, p.y);
    }
    int *triangles = c->triangles + 3 * c->triangle_count;
    if (planar ? is_flat_sheet(c, &p) : !c->tube) return false;
    if (!bat_fill(c->corner_count, c->flat, c->next, triangles, &count, middle)) return false;
    for (size_t i = 0; i < 3 * count; i++) triangles[i] += (int)c->vertex_count;
    c->triangle_count += count;
    for (size_t i = 0; i < c->corner_count; i++) put_vertex(c, place(c, c->corners[i]), p.normal);
    if (count == c->corner_count)
        put_vertex(c, vec_add(p.origin, vec_add(vec_scale(p.x, middle[0]), vec_scale(p.y, middle[1]))),
                   p.normal);
    return true;
}

/* ---- the part ---- */

static double volume(const closing *c) {
    const vec origin = vec_load(c->points, 3);
    double sum = 0;
    for (size_t t = 0; t < c->triangle_count; t++) {
        vec at[3];
        for (size_t k = 0; k < 3; k++)
            at[k] = vec_sub(vec_load(c->points + 3 * (size_t)c->triangles[3 * t + k], 3), origin);
        sum += vec_dot(at[0], vec_cross(at[1], at[2]));
    }
    return sum;
}

static void turn_over(closing *c) {
    for (size_t i = 0; i < 3 * c->vertex_count; i++) c->normals[i] = -c->normals[i];
    for (size_t t = 0; t < c->triangle_count; t++) {
        const int kept = c->triangles[3 * t];
        c->triangles[3 * t] = c->triangles[3 * t + 1];
        c->triangles[3 * t + 1] = kept;
    }
}

/* Room for what the part becomes at most: each edge brings a corner and a triangle, each rim a middle. */
static bat_status begin(closing *c, void **block) {
    const bat_part *part = c->part;
    const size_t vertices = part->vertex_count + 2 * c->edge_count,
                 triangles = part->triangle_count + c->edge_count;
    double *numbers = malloc(6 * vertices * sizeof *numbers + 3 * triangles * sizeof *c->triangles);
    if (!numbers) return BAT_MEMORY;
    *block = numbers;
    c->points = numbers, c->normals = numbers + 3 * vertices;
    c->triangles = (int *)(numbers + 6 * vertices);
    c->vertex_count = part->vertex_count, c->triangle_count = part->triangle_count;
    for (size_t i = 0; i < part->vertex_count; i++)
        memcpy(c->points + 3 * i, part->points + 3 * (size_t)c->same[i], 3 * sizeof *c->points);
    memcpy(c->normals, part->normals, 3 * part->vertex_count * sizeof *c->normals);
    memcpy(c->triangles, part->triangles, 3 * part->triangle_count * sizeof *c->triangles);
    return BAT_OK;
}

static bat_status fill_rims(closing *c) {
    const size_t room = c->edge_count + 1;
    c->piece = malloc((c->part->vertex_count + 1) * sizeof *c->piece);
    c->used = calloc(room, sizeof *c->used);
    c->corners = malloc(room * sizeof *c->corners);
    c->next = malloc(room * sizeof *c->next);
    c->flat = malloc(2 * room * sizeof *c->flat);
    if (!c->piece || !c->used || !c->corners || !c->next || !c->flat) return BAT_MEMORY;
    find_pieces(c);
    for (size_t i = 0; i < c->edge_count; i++)
        if (!c->used[i] && walk_rim(c, i) && fill_rim(c)) c->open -= c->corner_count;
    if (c->outward && c->open == 0 && volume(c) < 0) turn_over(c);
    return BAT_OK;
}

/* Edges, with vertices at seams joined. */
static bat_status find_edges(closing *c, size_t *joined) {
    bat_status status = bat_rim_same(c->part, c->same);
    *joined = 0;
    if (status == BAT_OK) status = bat_rim_edges(c->part, c->same, &c->edge_count, &c->edges);
    if (status == BAT_OK && c->edge_count)
        status = bat_rim_join(c->part, c->edge_count, c->edges, c->seam, c->same, joined);
    if (status != BAT_OK || *joined == 0) return status;
    free(c->edges);
    c->edges = NULL;
    return bat_rim_edges(c->part, c->same, &c->edge_count, &c->edges);
}

static bat_status close_part(closing *c, bat_part *part, void **block) {
    size_t joined;
    c->same = malloc((part->vertex_count + 1) * sizeof *c->same);
    if (!c->same) return BAT_MEMORY;
    bat_status status = find_edges(c, &joined);
    if (status != BAT_OK) return status;
    c->open = c->edge_count;
    const bool cap = c->cap && c->edge_count > 0;
    if (!cap && joined == 0) return BAT_OK;
    status = begin(c, block);
    if (status == BAT_OK && cap) status = fill_rims(c);
    if (status != BAT_OK) return status;
    part->vertex_count = c->vertex_count, part->triangle_count = c->triangle_count;
    part->points = c->points, part->normals = c->normals, part->triangles = c->triangles;
    return BAT_OK;
}

/* The surface that a part was made of; NULL: of something else. */
static const bat_surface *surface_of(const bat_model *model, size_t part) {
    const size_t before = model->mesh ? 1 : 0;
    return part >= before && part - before < model->surface_count ? model->surfaces[part - before] : NULL;
}

bat_status bat_parts_close(bat_parts *parts, const bat_model *model, double tolerance, bool cap,
                           size_t *open) {
    const double size = bat_model_size(model);
    bat_status status = BAT_OK;
    *open = 0;
    parts->blocks = calloc(parts->count + 1, sizeof *parts->blocks);
    if (!parts->blocks) return BAT_MEMORY;
    for (size_t i = 0; i < parts->count && status == BAT_OK; i++) {
        bat_part *part = &parts->part[i];
        if (part->kind != BAT_PART_TRIANGLES) continue;
        const bat_part from = *part;
        const bat_surface *surface = surface_of(model, i);
        closing c = {.part = &from, .seam = SEAM * size, .cap = cap, .outward = surface != NULL};
        c.tube = surface && (bat_surface_is_closed(surface, BAT_U) || bat_surface_is_closed(surface, BAT_V));
        c.tolerance = fmax(tolerance > 0 ? tolerance : 1e-4 * size, FLAT * size);
        status = close_part(&c, part, &parts->blocks[i]);
        *open += c.open;
        clear(&c);
    }
    return status;
}
