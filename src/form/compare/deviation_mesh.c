/* Meshes: triangles in steps that are no longer than the spacing, and the vertices of clouds. */
#include "form/compare/sums.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct faces {
    const double *vertices;
    const int *corners; /* 3 of each triangle */
    double *distances;  /* of the vertices; below 0: not known yet */
} faces;

/* x: shares of the second and the third corner; moved into the triangle. */
static void place_in_triangle(const void *thing, size_t piece, double x[2], double point[3]) {
    const faces *f = thing;
    const int *corner = f->corners + 3 * piece;
    for (int d = 0; d < 2; d++) x[d] = fmin(fmax(x[d], 0), 1);
    const double over = x[0] + x[1];
    if (over > 1) x[0] /= over, x[1] = 1 - x[0];
    for (int c = 0; c < 3; c++) {
        const double a = f->vertices[3 * corner[0] + c];
        point[c] = a + x[0] * (f->vertices[3 * corner[1] + c] - a) +
                   x[1] * (f->vertices[3 * corner[2] + c] - a);
    }
}

static void place_in_cloud(const void *thing, size_t piece, double x[2], double point[3]) {
    (void)x;
    memcpy(point, (const double *)thing + 3 * piece, 3 * sizeof *point);
}

/* Which vertex a place of a triangle that is divided into n steps a side is; -1: none. */
static int vertex_at(const int *corner, double i, double j, double n) {
    return i + j == 0 ? corner[0] : i == n ? corner[1] : j == n ? corner[2] : -1;
}

/* A corner of small triangles. */
static bat_status sample_corner(bat_sums *sums, faces *f, const int *corner, double i, double j, double n,
                                double weight) {
    const int vertex = vertex_at(corner, i, j, n);
    const double x[2] = {i / n, j / n};
    if (vertex < 0 || f->distances[vertex] < 0)
        return bat_sums_add(sums, x, weight, vertex < 0 ? NULL : &f->distances[vertex]);
    bat_sums_weigh(sums, x, f->distances[vertex], weight);
    return BAT_OK;
}

/* How many small triangles meet there. */
static double around(double i, double j, double n) {
    const int sides = (i == 0) + (j == 0) + (i + j == n);
    return sides == 0 ? 6 : sides == 1 ? 3 : 1;
}

/* Each small triangle: three quarters of its middle, and a twelfth of each of its corners. */
static bat_status sample_triangle(bat_sums *sums, faces *f, size_t t) {
    const int *corner = f->corners + 3 * t;
    vec at[3];
    for (int k = 0; k < 3; k++) at[k] = vec_load(f->vertices + 3 * corner[k], 3);
    double longest = 0;
    for (int k = 0; k < 3; k++) longest = fmax(longest, vec_norm(vec_sub(at[k], at[(k + 1) % 3])));
    const double spacing = sums->found.spacing, n = spacing > 0 ? fmax(ceil(longest / spacing), 1) : 1;
    const double area = 0.5 * vec_norm(vec_cross(vec_sub(at[1], at[0]), vec_sub(at[2], at[0]))) / (n * n);
    bat_status status = n * n <= BAT_SUMS_MOST ? BAT_OK : BAT_COUNT;
    bat_sums_piece(sums, t, (const double[2]){1 / n, 1 / n});
    for (double i = 0; i <= n && status == BAT_OK; i++)
        for (double j = 0; i + j <= n && status == BAT_OK; j++) {
            status = sample_corner(sums, f, corner, i, j, n, area * around(i, j, n) / 12);
            for (int k = 1; k <= 2 && status == BAT_OK && i + j + k <= n; k++)
                status = bat_sums_add(sums, (const double[2]){(i + k / 3.0) / n, (j + k / 3.0) / n},
                                      0.75 * area, NULL);
        }
    return status;
}

static bat_status sample_faces(bat_sums *sums, const bat_polymesh *mesh) {
    const size_t vertices = bat_polymesh_vertex_count(mesh), count = bat_polymesh_triangle_count(mesh);
    int *corners = malloc(3 * count * sizeof *corners);
    faces f = {bat_polymesh_vertices(mesh), corners, malloc(vertices * sizeof *f.distances)};
    bat_status status = corners && f.distances ? bat_polymesh_triangles(mesh, corners) : BAT_MEMORY;
    for (size_t i = 0; i < vertices && status == BAT_OK; i++) f.distances[i] = -1;
    sums->thing = &f, sums->place = place_in_triangle;
    for (size_t t = 0; t < count && status == BAT_OK; t++) status = sample_triangle(sums, &f, t);
    if (status == BAT_OK) status = bat_sums_finish(sums, &sums->found);
    sums->thing = NULL;
    free(corners), free(f.distances);
    return status;
}

static bat_status sample_cloud(bat_sums *sums, const bat_polymesh *mesh) {
    bat_status status = BAT_OK;
    sums->thing = bat_polymesh_vertices(mesh), sums->place = place_in_cloud;
    for (size_t i = 0; i < bat_polymesh_vertex_count(mesh) && status == BAT_OK; i++) {
        bat_sums_piece(sums, i, (const double[2]){0, 0});
        status = bat_sums_add(sums, (const double[2]){0, 0}, 1, NULL);
    }
    return status == BAT_OK ? bat_sums_finish(sums, &sums->found) : status;
}

bat_status bat_polymesh_deviation(const bat_polymesh *mesh, const bat_reference *reference, double spacing,
                                  bat_deviation *out) {
    if (!mesh || !reference || !out) return BAT_ARGUMENT;
    bat_sums sums = {.reference = reference};
    bat_status status = bat_sums_begin(&sums, spacing, bat_polymesh_size(mesh));
    if (status == BAT_OK)
        status = bat_polymesh_face_count(mesh) ? sample_faces(&sums, mesh) : sample_cloud(&sums, mesh);
    if (status == BAT_OK) *out = sums.found;
    return status;
}
