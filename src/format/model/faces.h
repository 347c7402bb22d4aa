/* Internal to formats: vertices and faces as a file has them, until they are meshes of a drawing. */
#ifndef BATTEN_FORMAT_FACES_H
#define BATTEN_FORMAT_FACES_H

#include "document/format.h"
#include "format/model/drawn.h"
#include "format/model/model.h"

/* The list with room for `more` elements behind `count`, or NULL: no memory; the list is then as it was. */
void *bat_grown(void *list, size_t *room, size_t count, size_t more, size_t size);

typedef struct bat_faces {
    size_t vertex_count, face_count, corner_count;
    double *vertices;
    int *sizes, *corners;
    size_t vertex_room, face_room, corner_room;
} bat_faces;

/* BAT_COUNT: more than a mesh holds; BAT_NUMBER: not finite, or beyond what a mesh holds. O(1) on average. */
bat_status bat_faces_add_vertex(bat_faces *faces, const double at[3]);
/* corners: of vertices that are there or will be. Faces of fewer than three corners are left out. */
bat_status bat_faces_add(bat_faces *faces, const int *corners, size_t count);
/* Vertices at the very same place become the first of them; corners of a face that follow each other at one place become one,
 * and faces of fewer than three such corners go. Without any face nothing changes. O(vertices log vertices + corners). */
bat_status bat_faces_weld(bat_faces *faces);
/* Puts a mesh of them on top of the drawing: from a room whose page is a wall onto that page. Statuses as of
 * bat_polymesh_create. name: what is no UTF-8 is no name. */
bat_status bat_faces_insert(const bat_faces *faces, const bat_room *room, const char *name,
                            bat_document *document);
/* Puts what a file holds on top of a drawing; *left_out: what is not read of it. The problem says what is wrong. */
typedef bat_status bat_faces_reader(const char *bytes, size_t size, bat_document *document, int *left_out,
                                    bat_problem *problem);
/* A drawing of which one unit is a millimetre, with what the reader finds. */
bat_status bat_faces_read(bat_faces_reader *reader, const char *bytes, size_t size, bat_document **out,
                          int *left_out, bat_problem *problem);
/* Takes all out, and keeps the room for more. */
void bat_faces_empty(bat_faces *faces);
void bat_faces_clear(bat_faces *faces);
/* How many vertices and corners a file of that size, in bytes, may give by showing things more than once. */
uint64_t bat_faces_bound(size_t size);

/* What of a drawing is in space, as a file of triangles within 1e-4 of the size; problem says why there is none. */
bat_status bat_faces_write(const bat_document *document, double unit, bool up_is_y, bat_parts_writer *writer,
                           char **bytes, size_t *size, bat_problem *problem);

#endif
