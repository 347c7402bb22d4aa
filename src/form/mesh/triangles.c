/* Faces as triangles: convex ones as fans, others by cutting off ears (Meisters 1975). */
#include "form/mesh/mesh.h"

#include <math.h>
#include <stdlib.h>

enum { EARS_MOST = 4096 };

size_t bat_polymesh_triangle_count(const bat_polymesh *mesh) {
    return mesh->corner_count - 2 * mesh->face_count;
}

/* A face seen along its normal: corner k is at flat[2k], flat[2k + 1]; next and before link the corners left. */
typedef struct outline {
    const int *corners;
    size_t count;
    double *flat;
    int *next, *before;
} outline;

static double turn(const outline *o, int a, int b, int c) {
    const double *p = o->flat + 2 * a, *q = o->flat + 2 * b, *r = o->flat + 2 * c;
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

static void flatten(const bat_polymesh *mesh, size_t face, outline *o) {
    double normal[3];
    int axis = 2;
    bat_face_normal(mesh, face, normal);
    for (int c = 1; c >= 0; c--)
        if (fabs(normal[c]) > fabs(normal[axis])) axis = c;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const bool over = normal[axis] < 0;
    for (size_t k = 0; k < o->count; k++) {
        const double *p = mesh->vertices + 3 * (size_t)o->corners[k];
        o->flat[2 * k] = over ? p[y] : p[x];
        o->flat[2 * k + 1] = over ? p[x] : p[y];
    }
    for (int k = 0, n = (int)o->count; k < n; k++) o->next[k] = (k + 1) % n, o->before[k] = (k + n - 1) % n;
}

/* No corner turns back, and together they turn once: a fan fits. */
static bool is_convex(const outline *o) {
    int turns = 0; /* of the edges' direction from left to right: two in one round */
    for (int k = 0; k < (int)o->count; k++) {
        const int a = o->before[k], b = o->next[k];
        if (turn(o, a, k, b) < 0) return false;
        turns += (o->flat[2 * k] > o->flat[2 * a]) != (o->flat[2 * b] > o->flat[2 * k]);
    }
    return turns <= 2;
}

static bool is_ear(const outline *o, int k) {
    const int a = o->before[k], b = o->next[k];
    if (!(turn(o, a, k, b) > 0)) return false;
    for (int p = o->next[b]; p != a; p = o->next[p]) {
        if (o->corners[p] == o->corners[a] || o->corners[p] == o->corners[k] ||
            o->corners[p] == o->corners[b])
            continue; /* a bridge to a hole names its ends twice */
        if (turn(o, a, k, p) >= 0 && turn(o, k, b, p) >= 0 && turn(o, b, a, p) >= 0) return false;
    }
    return true;
}

/* Cuts off ears; where there is none left (an outline that crosses itself), any corner. */
static void cut_ears(outline *o, int *out) {
    int at = 0;
    size_t left = o->count, tried = 0;
    while (left > 3) {
        if (!is_ear(o, at) && tried++ < left) {
            at = o->next[at];
            continue;
        }
        const int a = o->before[at], b = o->next[at];
        *out++ = o->corners[a], *out++ = o->corners[at], *out++ = o->corners[b];
        o->next[a] = b, o->before[b] = a;
        at = b, tried = 0, left--;
    }
    *out++ = o->corners[o->before[at]], *out++ = o->corners[at], *out++ = o->corners[o->next[at]];
}

static void fan(const outline *o, int *out) {
    for (size_t k = 1; k + 1 < o->count; k++)
        *out++ = o->corners[0], *out++ = o->corners[k], *out++ = o->corners[k + 1];
}

bat_status bat_polymesh_triangles(const bat_polymesh *mesh, int *out) {
    if (!mesh || !out) return BAT_ARGUMENT;
    size_t most = 0;
    outline o;
    for (size_t f = 0; f < mesh->face_count; f++) {
        (void)bat_polymesh_face(mesh, f, &o.count);
        if (o.count > most) most = o.count;
    }
    double *block = malloc((2 * most + 1) * sizeof *block + 2 * most * sizeof(int));
    if (!block) return BAT_MEMORY;
    o.flat = block, o.next = (int *)(void *)(block + 2 * most), o.before = o.next + most;
    for (size_t f = 0; f < mesh->face_count; f++) {
        o.corners = bat_polymesh_face(mesh, f, &o.count);
        flatten(mesh, f, &o);
        if (o.count == 3 || is_convex(&o) || o.count > EARS_MOST)
            fan(&o, out);
        else
            cut_ears(&o, out);
        out += 3 * (o.count - 2);
    }
    free(block);
    return BAT_OK;
}
