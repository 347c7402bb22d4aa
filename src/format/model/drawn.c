/* What of a drawing is in space, as a model of another program: in its unit and upright. */
#include "format/model/drawn.h"
#include "base/pose.h"
#include "document/kind.h"

#include <batten/mesh.h>
#include <batten/surface.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double UPRIGHT = 1e-6; /* radians that a plane at right angles may lean by */

/* Rows of a rotation: where x, y and z of the file come from. The page is x right, y down, z away from the eye. */
static const double WAYS[2][2][9] = {{{1, 0, 0, 0, 0, 1, 0, -1, 0}, {1, 0, 0, 0, -1, 0, 0, 0, -1}},
                                     {{1, 0, 0, 0, -1, 0, 0, 0, -1}, {1, 0, 0, 0, 0, -1, 0, 1, 0}}};

void bat_room_way(const bat_room *room, double way[9]) {
    memcpy(way, WAYS[room->stand == BAT_STAND_FLOOR][room->up_is_y], 9 * sizeof *way);
}

typedef struct gathering {
    bat_model *model;
    double matrix[12];
    size_t room;
    size_t vertex_count, face_count, corner_count; /* of all meshes */
    double *vertices;
    int *sizes, *corners;
} gathering;

static bat_status add_surface(gathering *g, const bat_surface *surface) {
    bat_model *model = g->model;
    const bat_status status = bat_surface_transform(surface, g->matrix,
                                                    &model->surfaces[model->surface_count]);
    model->surface_count += status == BAT_OK;
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
    bat_pose_apply(g->matrix, vertices, bat_polymesh_vertices(mesh), g->vertices + 3 * g->vertex_count);
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

bat_stand bat_stand_of(const bat_document *document) {
    if (bat_document_stand(document)) return bat_document_stand(document);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_kind_type *kind = bat_object_type(object);
        int count = 0;
        const double *flat = kind->ground ? kind->ground(object, &count) : NULL; /* origin, two unit axes */
        if (flat && count == 9 && fabs(flat[3] * flat[7] - flat[4] * flat[6]) < UPRIGHT)
            return BAT_STAND_FLOOR;
    }
    return BAT_STAND_WALL;
}

bat_status bat_model_of_drawing(const bat_document *document, const bat_room *room, bat_model *out,
                                int *flat) {
    const double scale = bat_document_scale(document) / room->unit;
    double way[9];
    const int count = bat_document_count(document);
    gathering g = {.model = out};
    *out = (bat_model){.mesh = NULL};
    *flat = 0;
    bat_room_way(room, way);
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
    if (status == BAT_OK) status = bat_model_face_outward(out);
    free(g.vertices);
    free(g.sizes);
    free(g.corners);
    if (status != BAT_OK) bat_model_clear(out);
    return status;
}
