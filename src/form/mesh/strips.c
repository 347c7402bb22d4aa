#include "form/mesh/strips.h"

#include <stdlib.h>
#include <string.h>

enum { CROWD = 64 /* corners of a vertex; at others strips end */ };

/* A corner of a face, kept with its vertex: the next and the previous vertex of the face. */
typedef struct corner {
    int next, before;
    bool used; /* the edge to the next vertex is in a strip */
} corner;

typedef struct net {
    const bat_polymesh *mesh;
    int *first; /* of each vertex: its corners begin there */
    corner *corners;
    int *way; /* room for the strip under way */
    size_t room, length;
} net;

static void count_corners(net *n) {
    for (size_t f = 0; f < bat_polymesh_face_count(n->mesh); f++) {
        size_t count;
        const int *face = bat_polymesh_face(n->mesh, f, &count);
        for (size_t k = 0; k < count; k++) n->first[face[k] + 1]++;
    }
    for (size_t i = 0; i < bat_polymesh_vertex_count(n->mesh); i++) n->first[i + 1] += n->first[i];
}

static bat_status prepare(net *n) {
    const size_t vertices = bat_polymesh_vertex_count(n->mesh);
    n->first = calloc(vertices + 2, sizeof *n->first);
    if (!n->first) return BAT_MEMORY;
    count_corners(n);
    const size_t total = (size_t)n->first[vertices];
    int *filled = calloc(vertices + 1, sizeof *filled);
    n->corners = calloc(total + 1, sizeof *n->corners);
    n->room = total + 2;
    n->way = calloc(n->room, sizeof *n->way);
    for (size_t f = 0; filled && n->corners && n->way && f < bat_polymesh_face_count(n->mesh); f++) {
        size_t count;
        const int *face = bat_polymesh_face(n->mesh, f, &count);
        for (size_t k = 0; k < count; k++)
            n->corners[n->first[face[k]] + filled[face[k]]++] = (corner){
                face[(k + 1) % count], face[(k + count - 1) % count], false};
    }
    const bool made = filled && n->corners && n->way;
    free(filled);
    return made ? BAT_OK : BAT_MEMORY;
}

static int corner_count(const net *n, int vertex) { return n->first[vertex + 1] - n->first[vertex]; }

/* The corner at a vertex whose face goes on to `next`; NULL: none, or too many to look at. */
static corner *leaving(const net *n, int vertex, int next) {
    if (corner_count(n, vertex) > CROWD) return NULL;
    for (int i = n->first[vertex]; i < n->first[vertex + 1]; i++)
        if (n->corners[i].next == next) return &n->corners[i];
    return NULL;
}

static bool is_used(const net *n, int a, int b) {
    const corner *there = leaving(n, a, b), *back = leaving(n, b, a);
    return (!there && !back) || (there && there->used) || (back && back->used);
}

static void use(const net *n, int a, int b) {
    corner *there = leaving(n, a, b), *back = leaving(n, b, a);
    if (there) there->used = true;
    if (back) back->used = true;
}

/* The other end of the border at a vertex where the edge from `from` is on it; -1: none, or several. */
static int along_border(const net *n, int vertex, int from) {
    int found = -1;
    for (int i = n->first[vertex]; i < n->first[vertex + 1]; i++) {
        const int ends[2] = {n->corners[i].next, n->corners[i].before};
        for (int k = 0; k < 2; k++) {
            const bool border = !(leaving(n, vertex, ends[k]) && leaving(n, ends[k], vertex));
            if (!border || ends[k] == from || ends[k] == found) continue;
            if (found >= 0) return -1;
            found = ends[k];
        }
    }
    return found;
}

/* Where a strip that comes from `from` runs on; -1: it ends. */
static int onwards(const net *n, int from, int vertex) {
    const int count = corner_count(n, vertex);
    if (count > CROWD) return -1;
    if (!leaving(n, vertex, from) || !leaving(n, from, vertex)) return along_border(n, vertex, from);
    if (count % 2) return -1;
    int spoke = from;
    for (int i = 0; i < count / 2; i++) {
        const corner *at = leaving(n, vertex, spoke);
        if (!at) return -1; /* the faces do not surround it */
        spoke = at->before;
    }
    return spoke == from ? -1 : spoke;
}

static void walk(net *n) {
    for (;;) {
        const int from = n->way[n->length - 2], at = n->way[n->length - 1], next = onwards(n, from, at);
        if (next < 0 || n->length == n->room || is_used(n, at, next)) return;
        use(n, at, next);
        n->way[n->length++] = next;
    }
}

static void turn_round(net *n) {
    for (size_t i = 0, k = n->length - 1; i < k; i++, k--) {
        const int kept = n->way[i];
        n->way[i] = n->way[k], n->way[k] = kept;
    }
}

/* All strips, one after the other. */
typedef struct heap {
    size_t count, room, total, total_room;
    size_t *starts;
    int *vertices;
} heap;

static bool grow(void **array, size_t *room, size_t needed, size_t size) {
    if (needed <= *room) return true;
    size_t more = *room ? *room : 64;
    while (more < needed) more *= 2;
    void *grown = realloc(*array, more * size);
    if (!grown) return false;
    *array = grown, *room = more;
    return true;
}

static bat_status keep(heap *h, const net *n) {
    void *starts = h->starts, *vertices = h->vertices;
    bool room = grow(&starts, &h->room, h->count + 2, sizeof *h->starts);
    h->starts = starts;
    room = room && grow(&vertices, &h->total_room, h->total + n->length, sizeof *h->vertices);
    h->vertices = vertices;
    if (!room) return BAT_MEMORY;
    memcpy(h->vertices + h->total, n->way, n->length * sizeof *n->way);
    h->starts[h->count++] = h->total;
    h->starts[h->count] = h->total += n->length;
    return BAT_OK;
}

static bat_status gather(net *n, heap *h) {
    bat_status status = BAT_OK;
    for (int v = 0; v < (int)bat_polymesh_vertex_count(n->mesh) && status == BAT_OK; v++)
        for (int i = n->first[v]; i < n->first[v + 1] && status == BAT_OK; i++) {
            corner *at = &n->corners[i];
            const corner *there = leaving(n, v, at->next), *back = leaving(n, at->next, v);
            if (at->used || (there && there->used) || (back && back->used) || at->next == v) continue;
            at->used = true;
            use(n, v, at->next);
            n->way[0] = v, n->way[1] = at->next, n->length = 2;
            walk(n);
            if (n->way[n->length - 1] != v || n->length < 3) {
                turn_round(n);
                walk(n);
            }
            status = keep(h, n);
        }
    return status;
}

/* ---- the longest ---- */

typedef struct rank {
    size_t length, strip;
} rank;

static int by_length(const void *a, const void *b) {
    const rank *x = a, *y = b;
    if (x->length != y->length) return x->length > y->length ? -1 : 1;
    return x->strip < y->strip ? -1 : x->strip > y->strip;
}

static bat_status choose(const heap *h, bool *chosen) {
    rank *ranks = calloc(h->count + 1, sizeof *ranks);
    size_t points = 0;
    int count = 0;
    if (!ranks) return BAT_MEMORY;
    for (size_t i = 0; i < h->count; i++) ranks[i] = (rank){h->starts[i + 1] - h->starts[i], i};
    if (h->count > 1) qsort(ranks, h->count, sizeof *ranks, by_length); /* no ties: strips differ */
    for (size_t i = 0; i < h->count && count < BAT_STRIPS_MAX; i++) {
        if (points + ranks[i].length > BAT_STRIP_POINTS_MAX) continue;
        points += ranks[i].length, count++;
        chosen[ranks[i].strip] = true;
    }
    free(ranks);
    return BAT_OK;
}

static bat_status hand_over(const heap *h, bat_strips *out) {
    bool *chosen = calloc(h->count + 1, sizeof *chosen);
    bat_status status = chosen ? choose(h, chosen) : BAT_MEMORY;
    size_t total = 0;
    for (size_t i = 0; status == BAT_OK && i < h->count; i++)
        if (chosen[i]) out->count++, total += h->starts[i + 1] - h->starts[i];
    if (status == BAT_OK) {
        out->starts = calloc((size_t)out->count + 1, sizeof *out->starts);
        out->vertices = calloc(total + 1, sizeof *out->vertices);
        if (!out->starts || !out->vertices) status = BAT_MEMORY;
    }
    int made = 0;
    for (size_t i = 0; status == BAT_OK && i < h->count; i++) {
        if (!chosen[i]) continue;
        const size_t length = h->starts[i + 1] - h->starts[i];
        memcpy(out->vertices + out->starts[made], h->vertices + h->starts[i], length * sizeof *h->vertices);
        out->starts[made + 1] = out->starts[made] + (int)length;
        made++;
    }
    free(chosen);
    return status;
}

bat_status bat_polymesh_strips(const bat_polymesh *mesh, bat_strips *out) {
    net n = {.mesh = mesh};
    heap h = {.count = 0};
    *out = (bat_strips){.count = 0};
    bat_status status = prepare(&n);
    if (status == BAT_OK) status = gather(&n, &h);
    if (status == BAT_OK) status = hand_over(&h, out);
    free(n.first), free(n.corners), free(n.way);
    free(h.starts), free(h.vertices);
    return status;
}

void bat_strips_clear(bat_strips *strips) {
    free(strips->starts), free(strips->vertices);
    *strips = (bat_strips){.count = 0};
}
