/* MESH as JSON: {"vertices":[[x,y,z],...], "faces":[[i,j,k,...],...]}, vertices counted from 0. */
#include "format/json/mesh.h"
#include "format/json/curve.h"
#include <batten/format.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The parts of a mesh read so far; the arrays are malloc'ed. */
typedef struct reading {
    uint32_t vertex_list, face_list;
    double *vertices;
    int *sizes, *corners;
    size_t vertex_count, face_count, corner_count;
} reading;

static bat_status read_vertices(const bat_json *json, uint32_t node, reading *read, bat_problem *problem) {
    int dimension;
    double *points;
    read->vertex_list = bat_json_member(json, node, "vertices");
    if (!read->vertex_list)
        return bat_json_complain(json, node, BAT_SYNTAX, "vertices", "a list of points", problem);
    bat_status status = bat_points_from_json(json, read->vertex_list, "vertices", &points,
                                             &read->vertex_count, &dimension, problem);
    if (status != BAT_OK || dimension == 3) {
        if (status == BAT_OK) read->vertices = points;
        return status;
    }
    read->vertices = calloc(3 * read->vertex_count + 1, sizeof *read->vertices);
    for (size_t i = 0; i < read->vertex_count && read->vertices; i++)
        memcpy(read->vertices + 3 * i, points + 2 * i, 2 * sizeof *points);
    free(points);
    return read->vertices
               ? BAT_OK
               : bat_json_say(json, read->vertex_list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
}

static bat_status read_face(const bat_json *json, uint32_t face, reading *read, bat_problem *problem) {
    for (uint32_t at = bat_json_first(json, face); at; at = json->nodes[at].next) {
        const double number = json->nodes[at].value.number;
        if (bat_json_type_of(json, at) == BAT_JSON_NUMBER && number >= 0 &&
            number < (double)read->vertex_count && number == floor(number)) {
            read->corners[read->corner_count++] = (int)number;
            continue;
        }
        char expected[80];
        snprintf(expected, sizeof expected, "numbers of vertices, from 0 to %zu", read->vertex_count - 1);
        return bat_json_complain(json, at, BAT_PARAMETER, "faces", expected, problem);
    }
    return BAT_OK;
}

/* Checks the kinds and counts of all faces; *corners: of all together. */
static bat_status count_faces(const bat_json *json, reading *read, size_t *corners, bat_problem *problem) {
    *corners = 0;
    for (uint32_t face = bat_json_first(json, read->face_list); face; face = json->nodes[face].next) {
        if (bat_json_count(json, face) < 3)
            return bat_json_complain(json, face, BAT_COUNT, "faces", "lists of 3 vertices or more", problem);
        *corners += bat_json_count(json, face);
    }
    return BAT_OK;
}

static bat_status read_faces(const bat_json *json, uint32_t node, reading *read, bat_problem *problem) {
    size_t corners;
    read->face_list = bat_json_member(json, node, "faces");
    if (bat_json_type_of(json, read->face_list) != BAT_JSON_LIST)
        return bat_json_complain(json, read->face_list ? read->face_list : node, BAT_SYNTAX, "faces",
                                 "a list of faces", problem);
    bat_status status = count_faces(json, read, &corners, problem);
    if (status != BAT_OK) return status;
    read->sizes = malloc((bat_json_count(json, read->face_list) + 1) * sizeof *read->sizes);
    read->corners = malloc((corners + 1) * sizeof *read->corners);
    if (!read->sizes || !read->corners)
        return bat_json_say(json, read->face_list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    for (uint32_t face = bat_json_first(json, read->face_list); face && status == BAT_OK;
         face = json->nodes[face].next) {
        read->sizes[read->face_count++] = (int)bat_json_count(json, face);
        status = read_face(json, face, read, problem);
    }
    return status;
}

static bat_status make(const bat_json *json, const reading *read, bat_polymesh **out, bat_problem *problem) {
    size_t wrong = 0;
    char message[160];
    bat_status status = bat_polymesh_create(read->vertex_count, read->vertices, read->face_count, read->sizes,
                                            read->corners, out, &wrong);
    if (status == BAT_OK) return status;
    snprintf(message, sizeof message, "%s", bat_status_message(status));
    if (status == BAT_COUNT)
        snprintf(message, sizeof message, "vertices: expected 1 to %d, and no more faces, found %zu and %zu",
                 BAT_VERTICES_MAX, read->vertex_count, read->face_count);
    if (status == BAT_NUMBER)
        snprintf(message, sizeof message, "vertices: expected numbers up to 1e75, found greater ones in %zu",
                 wrong);
    return bat_json_say(json, read->vertex_list, status, message, problem);
}

bat_status bat_polymesh_from_json(const bat_json *json, uint32_t node, bat_polymesh **out,
                                  bat_problem *problem) {
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_json_complain(json, node, BAT_SYNTAX, "mesh", "an object", problem);
    reading read = {.vertices = NULL};
    bat_status status = read_vertices(json, node, &read, problem);
    if (status == BAT_OK) status = read_faces(json, node, &read, problem);
    if (status == BAT_OK) status = make(json, &read, out, problem);
    free(read.vertices);
    free(read.sizes);
    free(read.corners);
    return status;
}

void bat_polymesh_to_json(const bat_polymesh *mesh, bat_text *text) {
    const double *at = bat_polymesh_vertices(mesh);
    bat_text_string(text, "{\"vertices\":[");
    for (size_t i = 0; i < bat_polymesh_vertex_count(mesh); i++, at += 3) {
        if (i > 0) bat_text_string(text, ",\n  ");
        bat_numbers_to_json(at, 3, text);
    }
    bat_text_string(text, "],\n \"faces\":[");
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t count;
        const int *corners = bat_polymesh_face(mesh, f, &count);
        bat_text_string(text, f > 0 ? ",\n  [" : "[");
        for (size_t k = 0; k < count; k++) {
            if (k > 0) bat_text_string(text, ",");
            bat_text_integer(text, (uint64_t)corners[k]);
        }
        bat_text_string(text, "]");
    }
    bat_text_string(text, "]}");
}

bat_status bat_polymesh_read(const char *text, size_t size, bat_polymesh **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_polymesh_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

bat_status bat_polymesh_write(const bat_polymesh *mesh, char **text, size_t *size) {
    if (!mesh || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_polymesh_to_json(mesh, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
