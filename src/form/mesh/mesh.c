/* The mesh as a value: creation, checks, access, copy, comparison. */
#include "form/mesh/mesh.h"
#include "base/real.h"
#include "curve/curve.h"
#include "text/json.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD = (sizeof(bat_polymesh) + sizeof(double) - 1) / sizeof(double) };

static size_t size_of(const bat_polymesh *m) {
    return (HEAD + 3 * m->vertex_count) * sizeof(double) +
           (m->face_count + 1 + m->corner_count) * sizeof(int);
}

static void place_arrays(bat_polymesh *m) {
    m->vertices = (double *)(void *)m + HEAD;
    m->first = (int *)(void *)(m->vertices + 3 * m->vertex_count);
    m->corners = m->first + m->face_count + 1;
}

/* What is wrong with a mesh, and with which vertex or face. */
typedef struct fault {
    size_t at;
    bat_problem *problem;
} fault;

static bat_status check_vertices(size_t count, const double *vertices, fault *f) {
    static const char *const places[] = {"vertices[%zu][0]", "vertices[%zu][1]", "vertices[%zu][2]"};
    for (size_t i = 0; i < 3 * count; i++) {
        if (fabs(vertices[i]) <= BAT_COORDINATE_MAX) continue;
        f->at = i / 3;
        bat_problem_outside(f->problem, places[i % 3], f->at, -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX,
                            vertices[i]);
        return BAT_NUMBER;
    }
    return BAT_OK;
}

static bat_status check_faces(size_t vertex_count, size_t face_count, const int *sizes, const int *corners,
                              size_t *corner_count, fault *f) {
    size_t total = 0;
    for (size_t i = 0; i < face_count; i++) {
        f->at = i;
        if (bat_problem_outside(f->problem, "faces[%zu]", i, 3, (double)(BAT_CORNERS_MAX - total), sizes[i]))
            return BAT_COUNT;
        for (int k = 0; k < sizes[i]; k++, total++)
            if (corners[total] < 0 || (size_t)corners[total] >= vertex_count)
                return bat_problem_found(f->problem, BAT_PARAMETER, "faces[%zu]", i, "numbers of vertices",
                                         corners[total]);
    }
    *corner_count = total;
    return BAT_OK;
}

/* Also counts the corners. */
static bat_status check_arrays(const bat_polymesh *m, const double *vertices, const int *sizes,
                               const int *corners, size_t *corner_count, fault *f) {
    if (!vertices || (m->face_count > 0 && (!sizes || !corners)))
        return bat_problem_set(f->problem, BAT_ARGUMENT, vertices ? "faces" : "vertices",
                               "expected an array, found none");
    if (bat_problem_outside(f->problem, "vertices", 0, 1, BAT_VERTICES_MAX, (double)m->vertex_count) ||
        bat_problem_outside(f->problem, "faces", 0, 0, BAT_VERTICES_MAX, (double)m->face_count))
        return BAT_COUNT;
    const bat_status status = check_vertices(m->vertex_count, vertices, f);
    return status == BAT_OK ? check_faces(m->vertex_count, m->face_count, sizes, corners, corner_count, f)
                            : status;
}

bat_status bat_polymesh_check(size_t vertex_count, const double *vertices, size_t face_count,
                              const int *sizes, const int *corners, bat_problem *problem) {
    const bat_polymesh head = {.vertex_count = vertex_count, .face_count = face_count};
    size_t corner_count;
    return check_arrays(&head, vertices, sizes, corners, &corner_count, &(fault){.problem = problem});
}

bat_status bat_polymesh_create(size_t vertex_count, const double *vertices, size_t face_count,
                               const int *sizes, const int *corners, bat_polymesh **out, size_t *wrong) {
    fault f = {0};
    bat_polymesh head = {.vertex_count = vertex_count, .face_count = face_count};
    if (!out) return BAT_ARGUMENT;
    const bat_status status = check_arrays(&head, vertices, sizes, corners, &head.corner_count, &f);
    if (status != BAT_OK && status != BAT_ARGUMENT && wrong) *wrong = f.at;
    if (status != BAT_OK) return status;
    double *block = malloc(size_of(&head));
    if (!block) return BAT_MEMORY;
    bat_polymesh *m = (bat_polymesh *)(void *)block;
    *m = head;
    place_arrays(m);
    memcpy(m->vertices, vertices, 3 * vertex_count * sizeof *vertices);
    m->first[0] = 0;
    for (size_t i = 0; i < face_count; i++) m->first[i + 1] = m->first[i] + sizes[i];
    if (m->corner_count) memcpy(m->corners, corners, m->corner_count * sizeof *corners);
    *out = m;
    return BAT_OK;
}

bat_status bat_polymesh_copy(const bat_polymesh *mesh, bat_polymesh **out) {
    if (!mesh || !out) return BAT_ARGUMENT;
    double *block = malloc(size_of(mesh));
    if (!block) return BAT_MEMORY;
    memcpy(block, mesh, size_of(mesh));
    bat_polymesh *copy = (bat_polymesh *)(void *)block;
    place_arrays(copy);
    *out = copy;
    return BAT_OK;
}

bat_status bat_polymesh_with(const bat_polymesh *mesh, const double *vertices, bat_polymesh **out,
                             size_t *wrong) {
    if (!mesh || !vertices || !out) return BAT_ARGUMENT;
    bat_polymesh *copy;
    fault f = {0};
    bat_status status = check_vertices(mesh->vertex_count, vertices, &f);
    if (status != BAT_OK && wrong) *wrong = f.at;
    if (status == BAT_OK) status = bat_polymesh_copy(mesh, &copy);
    if (status != BAT_OK) return status;
    memcpy(copy->vertices, vertices, 3 * mesh->vertex_count * sizeof *vertices);
    *out = copy;
    return BAT_OK;
}

bat_status bat_polymesh_flip(const bat_polymesh *mesh, bat_polymesh **out) {
    bat_polymesh *copy;
    const bat_status status = bat_polymesh_copy(mesh, &copy);
    if (status != BAT_OK) return status;
    for (size_t f = 0; f < copy->face_count; f++)
        for (int low = copy->first[f] + 1, high = copy->first[f + 1] - 1; low < high; low++, high--) {
            const int kept = copy->corners[low];
            copy->corners[low] = copy->corners[high], copy->corners[high] = kept;
        }
    *out = copy;
    return BAT_OK;
}

void bat_polymesh_free(bat_polymesh *mesh) { free(mesh); }

size_t bat_polymesh_vertex_count(const bat_polymesh *mesh) { return mesh->vertex_count; }
const double *bat_polymesh_vertices(const bat_polymesh *mesh) { return mesh->vertices; }
size_t bat_polymesh_face_count(const bat_polymesh *mesh) { return mesh->face_count; }

const int *bat_polymesh_face(const bat_polymesh *mesh, size_t i, size_t *count) {
    *count = 0;
    if (i >= mesh->face_count) return NULL;
    *count = (size_t)(mesh->first[i + 1] - mesh->first[i]);
    return mesh->corners + mesh->first[i];
}

void bat_polymesh_box(const bat_polymesh *mesh, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) low[c] = INFINITY, high[c] = -INFINITY;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], mesh->vertices[3 * i + (size_t)c]);
            high[c] = fmax(high[c], mesh->vertices[3 * i + (size_t)c]);
        }
}

double bat_polymesh_size(const bat_polymesh *mesh) {
    double low[3], high[3], size = 0;
    bat_polymesh_box(mesh, low, high);
    for (int c = 0; c < 3; c++) size = bat_hypot(size, high[c] - low[c]);
    return size;
}

bool bat_polymesh_is_equal(const bat_polymesh *a, const bat_polymesh *b) {
    if (a->vertex_count != b->vertex_count || a->face_count != b->face_count ||
        a->corner_count != b->corner_count)
        return false;
    return memcmp(a->vertices, b->vertices, 3 * a->vertex_count * sizeof(double)) == 0 &&
           memcmp(a->first, b->first, (a->face_count + 1) * sizeof(int)) == 0 &&
           memcmp(a->corners, b->corners, a->corner_count * sizeof(int)) == 0;
}

void bat_face_normal(const bat_polymesh *mesh, size_t face, double out[3]) {
    size_t count;
    const int *corners = bat_polymesh_face(mesh, face, &count);
    const double *origin = mesh->vertices + 3 * (size_t)corners[0];
    out[0] = out[1] = out[2] = 0;
    for (size_t k = 1; k + 1 < count; k++) {
        const double *p = mesh->vertices + 3 * (size_t)corners[k],
                     *q = mesh->vertices + 3 * (size_t)corners[k + 1];
        for (int c = 0; c < 3; c++) {
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            out[c] += (p[a] - origin[a]) * (q[b] - origin[b]) - (p[b] - origin[b]) * (q[a] - origin[a]);
        }
    }
}

/* One of no length becomes (0, 0, 1); what has lost bits at the lower end of what a double holds is first made long. */
static void normalise(double n[3]) {
    double length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
    if (length < DBL_MIN / DBL_EPSILON) {
        for (int c = 0; c < 3; c++) n[c] *= 0x1p600;
        length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
    }
    const bool none = !(length > 0 && length < INFINITY);
    for (int c = 0; c < 3; c++) n[c] = none ? c == 2 : n[c] / length;
}

void bat_polymesh_normals(const bat_polymesh *mesh, double *out) {
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++) out[i] = 0;
    for (size_t f = 0; f < mesh->face_count; f++) {
        double normal[3];
        size_t count;
        const int *corners = bat_polymesh_face(mesh, f, &count);
        bat_face_normal(mesh, f, normal);
        for (size_t k = 0; k < count; k++)
            for (int c = 0; c < 3; c++) out[3 * (size_t)corners[k] + (size_t)c] += normal[c];
    }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        normalise(out + 3 * i);
    }
}
