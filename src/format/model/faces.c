#include "format/model/faces.h"

#include "format/model/rim.h"
#include "text/json.h"
#include "text/utf8.h"

#include <batten/mesh.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

void *bat_grown(void *list, size_t *room, size_t count, size_t more, size_t size) {
    if (list && more <= *room - count) return list;
    size_t wanted = *room ? 2 * *room : 16;
    while (wanted - count < more) wanted *= 2;
    void *larger = realloc(list, wanted * size);
    if (larger) *room = wanted;
    return larger;
}

bat_status bat_faces_add_vertex(bat_faces *faces, const double at[3]) {
    for (int k = 0; k < 3; k++)
        if (!(fabs(at[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    if (faces->vertex_count == BAT_VERTICES_MAX) return BAT_COUNT;
    double *vertices = bat_grown(faces->vertices, &faces->vertex_room, faces->vertex_count, 1,
                                 3 * sizeof *vertices);
    if (!vertices) return BAT_MEMORY;
    faces->vertices = vertices;
    memcpy(faces->vertices + 3 * faces->vertex_count++, at, 3 * sizeof *at);
    return BAT_OK;
}

bat_status bat_faces_add(bat_faces *faces, const int *corners, size_t count) {
    if (count < 3) return BAT_OK;
    if (faces->face_count == BAT_VERTICES_MAX || count > BAT_CORNERS_MAX - faces->corner_count)
        return BAT_COUNT;
    int *sizes = bat_grown(faces->sizes, &faces->face_room, faces->face_count, 1, sizeof *sizes);
    if (sizes) faces->sizes = sizes;
    int *all = bat_grown(faces->corners, &faces->corner_room, faces->corner_count, count, sizeof *all);
    if (all) faces->corners = all;
    if (!sizes || !all) return BAT_MEMORY;
    faces->sizes[faces->face_count++] = (int)count;
    memcpy(faces->corners + faces->corner_count, corners, count * sizeof *corners);
    faces->corner_count += count;
    return BAT_OK;
}

/* Moves what is kept of the vertices to the front; same becomes where each is then. */
static void keep_first(bat_faces *faces, int *same) {
    size_t kept = 0;
    for (size_t i = 0; i < faces->vertex_count; i++) {
        if (same[i] != (int)i) { /* the first at a place comes before the others */
            same[i] = same[same[i]];
            continue;
        }
        memmove(faces->vertices + 3 * kept, faces->vertices + 3 * i, 3 * sizeof *faces->vertices);
        same[i] = (int)kept++;
    }
    faces->vertex_count = kept;
}

/* The corners of one face, without those that repeat the one before; returns how many. */
static size_t take_corners(const int *from, size_t count, const int *same, int *to) {
    size_t kept = 0;
    for (size_t k = 0; k < count; k++)
        if (kept == 0 || to[kept - 1] != same[from[k]]) to[kept++] = same[from[k]];
    while (kept > 1 && to[kept - 1] == to[0]) kept--;
    return kept;
}

bat_status bat_faces_weld(bat_faces *faces) {
    if (faces->face_count == 0) return BAT_OK;
    for (size_t i = 0; i < faces->corner_count; i++)
        if (faces->corners[i] < 0 || (size_t)faces->corners[i] >= faces->vertex_count) return BAT_PARAMETER;
    int *same = malloc((faces->vertex_count + 1) * sizeof *same);
    const bat_part part = {.vertex_count = faces->vertex_count, .points = faces->vertices};
    const bat_status status = same ? bat_rim_same(&part, same) : BAT_MEMORY;
    if (status == BAT_OK) {
        size_t read = 0, corners = 0, kept = 0;
        keep_first(faces, same);
        for (size_t f = 0; f < faces->face_count; f++) {
            const size_t all = (size_t)faces->sizes[f],
                         count = take_corners(faces->corners + read, all, same, faces->corners + corners);
            read += all;
            if (count < 3) continue;
            faces->sizes[kept++] = (int)count;
            corners += count;
        }
        faces->face_count = kept, faces->corner_count = corners;
    }
    free(same);
    return status;
}

bat_status bat_faces_read(bat_faces_reader *reader, const char *bytes, size_t size, bat_document **out,
                          int *left_out, bat_problem *problem) {
    bat_document *document = NULL;
    bat_status status = bat_document_create(&document);
    if (status == BAT_OK) status = bat_document_set_scale(document, 1, BAT_UNIT_MM);
    if (status != BAT_OK)
        bat_problem_set(problem, status, "", bat_status_message(status));
    else
        status = reader(bytes, size, document, left_out, problem);
    if (status == BAT_OK)
        *out = document;
    else
        bat_document_free(document);
    return status;
}

static bat_status insert(const bat_polymesh *mesh, const char *name, bat_document *document) {
    bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    const double size = bat_polymesh_size(mesh);
    if (size > 1e-9 && size < 1e9) style.width = size / 1000; /* small meshes would be all lines */
    if (!bat_utf8_valid(name, strlen(name))) name = "";
    bat_status status = bat_object_create_mesh(bat_document_new_id(document), name, &style, mesh, &object);
    if (status == BAT_OK) status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return status;
}

bat_status bat_faces_insert(const bat_faces *faces, const bat_room *room, const char *name,
                            bat_document *document) {
    const double scale = room->unit / bat_document_scale(document);
    double way[9];
    bat_polymesh *mesh = NULL;
    double *vertices = malloc((3 * faces->vertex_count + 1) * sizeof *vertices);
    if (!vertices) return BAT_MEMORY;
    bat_room_way(room, way);
    for (size_t i = 0; i < faces->vertex_count; i++) /* back: rows and columns of a rotation exchanged */
        for (size_t k = 0; k < 3; k++) {
            const double *at = faces->vertices + 3 * i;
            vertices[3 * i + k] = scale * (way[k] * at[0] + way[3 + k] * at[1] + way[6 + k] * at[2]);
        }
    bat_status status = bat_polymesh_create(faces->vertex_count, vertices, faces->face_count, faces->sizes,
                                            faces->corners, &mesh, NULL);
    free(vertices);
    if (status == BAT_OK) status = insert(mesh, name, document);
    bat_polymesh_free(mesh);
    return status;
}

void bat_faces_empty(bat_faces *faces) { faces->vertex_count = faces->face_count = faces->corner_count = 0; }

uint64_t bat_faces_bound(size_t size) {
    enum { FEWEST = 1 << 16, EACH = 1000, MOST = 1 << 23 };
    const uint64_t bound = FEWEST + EACH * (uint64_t)size;
    return bound < MOST ? bound : MOST > size ? MOST : size;
}

void bat_faces_clear(bat_faces *faces) {
    free(faces->vertices);
    free(faces->sizes);
    free(faces->corners);
    *faces = (bat_faces){.vertices = NULL};
}

bat_status bat_faces_write(const bat_document *document, double unit, bool up_is_y, bat_parts_writer *writer,
                           char **bytes, size_t *size, bat_problem *problem) {
    const bat_room room = {bat_stand_of(document), unit, up_is_y};
    bat_model model = {.mesh = NULL};
    bat_parts parts = {.count = 0};
    int flat;
    size_t open;
    bat_status status = bat_model_of_drawing(document, &room, &model, &flat);
    if (status == BAT_OK) status = bat_parts_create(&model, 0, &parts);
    if (status == BAT_OK) status = bat_parts_close(&parts, &model, 0, false, &open);
    if (status == BAT_OK) status = writer(&parts, bytes, size);
    bat_parts_clear(&parts);
    bat_model_clear(&model);
    if (status == BAT_OK) return status;
    return bat_problem_set(problem, status, "",
                           status == BAT_COUNT ? "expected a mesh or a surface in space, found none"
                                               : bat_status_message(status));
}
