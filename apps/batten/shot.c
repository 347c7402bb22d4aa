#include "shot.h"

#include "program.h"

#include "format/model/model.h"
#include "format/seen/seen.h"
#include <batten/camera.h>
#include <batten/mesh.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_camera *camera_named(const bat_document *document, const char *name, size_t length) {
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const char *own = bat_object_name(object);
        if (bat_object_camera(object) && strlen(own) == length && strncmp(own, name, length) == 0)
            return bat_object_camera(object);
    }
    return NULL;
}

/* The camera, and *time; NULL: it is no camera and time. */
static const bat_camera *shot_of(const bat_document *document, const char *view, double *time) {
    const char *at = strrchr(view, '@');
    char *end = NULL;
    if (!at || at[1] == '\0') return NULL;
    *time = strtod(at + 1, &end);
    if (*end || !isfinite(*time)) return NULL;
    return camera_named(document, view, (size_t)(at - view));
}

bool is_shot(const bat_document *document, const char *view) {
    double time;
    return shot_of(document, view, &time) != NULL;
}

/* Everything that moves by itself stands as it does at that time. */
static bat_status stand(bat_document *document, double time) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        bat_object *posed = NULL;
        if (!bat_object_motion(bat_document_at(document, i), NULL)) continue;
        status = bat_object_at_time(bat_document_at(document, i), time, &posed);
        if (status == BAT_OK) status = bat_document_replace(document, i, posed);
        bat_object_release(posed);
    }
    return status;
}

int shot_view(const char *file, bat_document *document, const char *view, const long size[2],
              bat_viewpoint *out) {
    double time;
    const bat_camera *camera = shot_of(document, view, &time);
    const double window[2] = {size[0] > 0 ? (double)size[0] : 960, size[1] > 0 ? (double)size[1] : 540};
    bat_camera_pose pose;
    bat_camera_at_time(camera, time, &pose);
    const double extent = bat_curve_size(bat_camera_path(camera));
    const bat_status status = bat_camera_view(&pose, extent > 0 ? extent : 1, window, out);
    if (status == BAT_OK && stand(document, time) != BAT_OK) return fail_memory();
    return status == BAT_OK
               ? EXIT_DONE
               : fail_data(file, view, "expected a field of view between 0 and 180 degrees, found %g",
                           pose.fov);
}

/* ---- what a camera sees ---- */

/* What is shown, and its meshes, which become one. */
typedef struct gathering {
    bat_model *model;
    size_t count, vertices, faces, corners;
    const bat_polymesh **meshes;
} gathering;

static bat_status add_mesh(gathering *g, const bat_polymesh *mesh) {
    const bat_polymesh **more = realloc(g->meshes, (g->count + 1) * sizeof *more);
    if (!more) return BAT_MEMORY;
    g->meshes = more;
    g->meshes[g->count++] = mesh;
    g->vertices += bat_polymesh_vertex_count(mesh), g->faces += bat_polymesh_face_count(mesh);
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t n;
        bat_polymesh_face(mesh, f, &n);
        g->corners += n;
    }
    return BAT_OK;
}

static bat_status add_to_model(const bat_object *object, void *user) {
    gathering *g = user;
    const bat_surface *surface = bat_object_surface(object);
    bat_surface *copy = NULL;
    bat_status status = BAT_OK;
    if (bat_object_mesh(object)) return add_mesh(g, bat_object_mesh(object));
    if (surface) {
        status = bat_surface_copy(surface, &copy);
        return status == BAT_OK ? bat_model_add_surface(g->model, copy) : status;
    }
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++) {
        bat_curve *curve = NULL;
        status = bat_curve_copy(bat_object_curve(object, i), &curve);
        if (status == BAT_OK) status = bat_model_add_curve(g->model, curve);
    }
    return status;
}

/* Faces and vertices of all, one after the other. */
static bat_status join(const gathering *g, bat_polymesh **out) {
    double *vertices = malloc((3 * g->vertices + 1) * sizeof *vertices), *to = vertices;
    int *sizes = malloc((g->faces + g->corners + 1) * sizeof *sizes), *size = sizes;
    int first = 0, *corners = sizes ? sizes + g->faces : NULL, *corner = corners;
    for (size_t i = 0; i < g->count && vertices && sizes; i++) {
        const bat_polymesh *mesh = g->meshes[i];
        const size_t count = bat_polymesh_vertex_count(mesh);
        memcpy(to, bat_polymesh_vertices(mesh), 3 * count * sizeof *to);
        to += 3 * count;
        for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
            size_t n;
            const int *face = bat_polymesh_face(mesh, f, &n);
            *size++ = (int)n;
            for (size_t k = 0; k < n; k++) *corner++ = first + face[k];
        }
        first += (int)count;
    }
    const bat_status status = vertices && sizes ? bat_polymesh_create(g->vertices, vertices, g->faces, sizes,
                                                                      corners, out, NULL)
                                                : BAT_MEMORY;
    free(vertices), free(sizes);
    return status;
}

bat_status model_shown(const bat_document *document, bat_model *out) {
    gathering g = {.model = out};
    bat_status status = bat_seen_each(document, add_to_model, &g);
    if (status == BAT_OK && g.vertices > BAT_POINTS_MAX) status = BAT_COUNT;
    if (status == BAT_OK && g.count > 0) status = join(&g, &out->mesh);
    free(g.meshes);
    return status;
}
