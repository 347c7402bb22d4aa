/* What of a drawing is in space, as a model of another program: in its unit, upright, normals outward. */
#include "model_file.h"

#include <batten/mesh.h>
#include <batten/surface.h>
#include <stdlib.h>
#include <string.h>

/* Rows of a rotation: where x, y and z of the file come from. The page is x right, y down, z away from the eye. */
static const double WAYS[2][2][9] = {{{1, 0, 0, 0, 0, 1, 0, -1, 0}, {1, 0, 0, 0, -1, 0, 0, 0, -1}},
                                     {{1, 0, 0, 0, -1, 0, 0, 0, -1}, {1, 0, 0, 0, 0, -1, 0, 1, 0}}};

typedef struct gathering {
    bat_model *model;
    double matrix[12];
    size_t room;
    size_t vertex_count, face_count, corner_count; /* of all meshes */
    double *vertices;
    int *sizes, *corners;
} gathering;

/* Six times the volume between the triangles and their middle: its sign says which way they face, also of a tube. */
static bat_status signed_volume(const bat_surface *surface, double *out) {
    bat_tessellation *made = NULL;
    bat_mesh mesh;
    double middle[3] = {0, 0, 0}, sum = 0;
    bat_status status = bat_surface_tessellate(surface, NULL, &made, NULL);
    if (status != BAT_OK) return status;
    bat_tessellation_mesh(made, &mesh);
    const size_t count = mesh.rows * mesh.columns;
    for (size_t i = 0; i < 3 * count; i++) middle[i % 3] += mesh.points[i] / (double)count;
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        double p[3][3];
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                p[k][c] = mesh.points[3 * mesh.triangles[3 * t + (size_t)k] + c] - middle[c];
        sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
               p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    bat_tessellation_free(made);
    *out = sum;
    return BAT_OK;
}

/* The same surface with u and v exchanged: its normals point the other way. */
static bat_status exchanged(const bat_surface *surface, bat_surface **out) {
    int degree[2], knot_count[2];
    bool closed[2];
    size_t count[2];
    const double *knots[2];
    for (int k = 0; k < 2; k++) {
        const bat_direction from = k ? BAT_U : BAT_V;
        degree[k] = bat_surface_degree(surface, from);
        closed[k] = bat_surface_is_closed(surface, from);
        count[k] = bat_surface_count(surface, from);
        knot_count[k] = bat_surface_knot_count(surface, from);
        knots[k] = bat_surface_knots(surface, from);
    }
    double *points = malloc(count[0] * count[1] * 3 * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < count[1]; i++) {
        const double *row = bat_surface_row(surface, (int)i);
        for (size_t j = 0; j < count[0]; j++)
            memcpy(points + 3 * (j * count[1] + i), row + 3 * j, 3 * sizeof *points);
    }
    const bat_status status = bat_surface_create(degree, closed, count, points, knot_count, knots[0],
                                                 knots[1], out);
    free(points);
    return status;
}

static bat_status add_surface(gathering *g, const bat_surface *surface) {
    bat_surface *placed = NULL, *turned = NULL;
    double volume = 0;
    bat_status status = bat_surface_transform(surface, g->matrix, &placed);
    const bool closed = bat_surface_is_closed(surface, BAT_U) || bat_surface_is_closed(surface, BAT_V);
    if (status == BAT_OK && closed) status = signed_volume(placed, &volume);
    if (status == BAT_OK && volume < 0) status = exchanged(placed, &turned);
    if (turned) {
        bat_surface_free(placed);
        placed = turned;
    }
    if (status != BAT_OK)
        bat_surface_free(placed);
    else
        g->model->surfaces[g->model->surface_count++] = placed;
    return status;
}

/* A model has one mesh: the faces of all, one mesh after the other. */
static bat_status add_mesh(gathering *g, const bat_polymesh *mesh) {
    const size_t vertices = bat_polymesh_vertex_count(mesh), faces = bat_polymesh_face_count(mesh);
    size_t corners = 0, n;
    for (size_t i = 0; i < faces; i++) bat_polymesh_face(mesh, i, &n), corners += n;
    double *places = realloc(g->vertices, 3 * (g->vertex_count + vertices) * sizeof *places);
    if (places) g->vertices = places;
    int *sizes = realloc(g->sizes, (g->face_count + faces + 1) * sizeof *sizes);
    if (sizes) g->sizes = sizes;
    int *all = realloc(g->corners, (g->corner_count + corners + 1) * sizeof *all);
    if (all) g->corners = all;
    if (!places || !sizes || !all) return BAT_MEMORY;
    const double *from = bat_polymesh_vertices(mesh), *m = g->matrix;
    for (size_t i = 0; i < vertices; i++)
        for (int k = 0; k < 3; k++)
            g->vertices[3 * (g->vertex_count + i) + (size_t)k] = m[4 * k] * from[3 * i] +
                                                                 m[4 * k + 1] * from[3 * i + 1] +
                                                                 m[4 * k + 2] * from[3 * i + 2];
    for (size_t i = 0; i < faces; i++) {
        const int *face = bat_polymesh_face(mesh, i, &n);
        g->sizes[g->face_count++] = (int)n;
        for (size_t k = 0; k < n; k++) g->corners[g->corner_count++] = face[k] + (int)g->vertex_count;
    }
    g->vertex_count += vertices;
    return BAT_OK;
}

static bat_status add_curve(gathering *g, const bat_curve *curve, int *flat) {
    if (bat_curve_dimension(curve) != 3) {
        ++*flat;
        return BAT_OK;
    }
    bat_model *model = g->model;
    if (model->curve_count == g->room) {
        const size_t room = g->room ? 2 * g->room : 16;
        bat_curve **more = realloc(model->curves, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        model->curves = more;
        g->room = room;
    }
    const bat_status status = bat_curve_transform(curve, g->matrix, &model->curves[model->curve_count]);
    model->curve_count += status == BAT_OK;
    return status;
}

static bat_status add(gathering *g, const bat_object *object, int *flat) {
    if (bat_object_surface(object)) return add_surface(g, bat_object_surface(object));
    if (bat_object_mesh(object)) return add_mesh(g, bat_object_mesh(object));
    bat_status status = BAT_OK;
    const int count = bat_object_is_made_of_curves(object) ? bat_object_curve_count(object) : 0;
    for (int i = 0; i < count && status == BAT_OK; i++)
        status = add_curve(g, bat_object_curve(object, i), flat);
    return status;
}

bat_status model_of_drawing(const bat_document *document, const model_kind *kind, page_stand stand,
                            bat_model *out, int *flat) {
    const double scale = bat_document_scale(document) / kind->unit;
    const double *way = WAYS[stand == PAGE_IS_FLOOR][kind->up_is_y];
    const int count = bat_document_count(document);
    gathering g = {.model = out};
    *out = (bat_model){.mesh = NULL};
    *flat = 0;
    for (int i = 0; i < 9; i++) g.matrix[4 * (i / 3) + i % 3] = scale * way[i];
    out->surfaces = calloc((size_t)count + 1, sizeof *out->surfaces);
    bat_status status = out->surfaces ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK;) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_object_is_hidden(object)) { /* and what is in it */
            i = bat_document_end(document, i);
            continue;
        }
        status = add(&g, object, flat);
        i++;
    }
    if (status == BAT_OK && g.vertex_count)
        status = bat_polymesh_create(g.vertex_count, g.vertices, g.face_count, g.sizes, g.corners, &out->mesh,
                                     NULL);
    if (status == BAT_OK && !out->mesh && out->surface_count + out->curve_count == 0) status = BAT_COUNT;
    free(g.vertices);
    free(g.sizes);
    free(g.corners);
    if (status != BAT_OK) bat_model_clear(out);
    return status;
}
