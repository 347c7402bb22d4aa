#include "form/mesh/facets.h"
#include "base/vec.h"

#include <stdlib.h>
#include <string.h>

static const double sharp = 0.766; /* cosine of 40 degrees */

void bat_facets_clear(bat_facets *facets) {
    free(facets->points), free(facets->normals), free(facets->triangles);
    *facets = (bat_facets){.corner_count = 0};
}

/* A corner of its own for the triangle. */
static int add_corner(bat_facets *f, int from, vec normal) {
    const size_t at = f->corner_count++;
    memcpy(f->points + 3 * at, f->points + 3 * (size_t)from, 3 * sizeof *f->points);
    vec_store(normal, f->normals + 3 * at);
    return (int)at;
}

static void sharpen(bat_facets *f) {
    for (size_t t = 0; t < f->triangle_count; t++) {
        int *corner = f->triangles + 3 * t;
        const vec a = vec_load(f->points + 3 * (size_t)corner[0], 3);
        const vec b = vec_sub(vec_load(f->points + 3 * (size_t)corner[1], 3), a);
        const vec c = vec_sub(vec_load(f->points + 3 * (size_t)corner[2], 3), a);
        const vec across = vec_cross(b, c);
        if (!(vec_norm(across) > 0)) continue;
        const vec normal = vec_unit(across);
        for (int k = 0; k < 3; k++)
            if (vec_dot(normal, vec_load(f->normals + 3 * (size_t)corner[k], 3)) < sharp)
                corner[k] = add_corner(f, corner[k], normal);
    }
}

bat_status bat_polymesh_facets(const bat_polymesh *mesh, bat_facets *out) {
    const size_t vertices = bat_polymesh_vertex_count(mesh), triangles = bat_polymesh_triangle_count(mesh);
    const size_t room = vertices + 3 * triangles;
    bat_facets f = {.corner_count = vertices, .triangle_count = triangles};
    f.points = malloc(3 * room * sizeof *f.points);
    f.normals = malloc(3 * room * sizeof *f.normals);
    f.triangles = malloc((3 * triangles + 1) * sizeof *f.triangles);
    bat_status status = f.points && f.normals && f.triangles ? bat_polymesh_triangles(mesh, f.triangles)
                                                             : BAT_MEMORY;
    if (status != BAT_OK) {
        bat_facets_clear(&f);
        return status;
    }
    memcpy(f.points, bat_polymesh_vertices(mesh), 3 * vertices * sizeof *f.points);
    bat_polymesh_normals(mesh, f.normals);
    sharpen(&f);
    *out = f;
    return BAT_OK;
}
