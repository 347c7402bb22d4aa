/* Internal to PLY. */
#ifndef BATTEN_FORMAT_PLY_H
#define BATTEN_FORMAT_PLY_H

#include "format/model/faces.h"

/* Triangles and vertices with normals as binary PLY 1.0, numbers as 32-bit floats; vertices of a cloud have normals of 0, and
 * lines are left out. Statuses as of bat_stl_write. */
bat_status bat_ply_put_parts(const bat_parts *parts, char **bytes, size_t *size);

typedef enum bat_ply_type {
    BAT_PLY_NONE,
    BAT_PLY_INT8,
    BAT_PLY_UINT8,
    BAT_PLY_INT16,
    BAT_PLY_UINT16,
    BAT_PLY_INT32,
    BAT_PLY_UINT32,
    BAT_PLY_FLOAT32,
    BAT_PLY_FLOAT64
} bat_ply_type;
/* In bytes. */
size_t bat_ply_size(bat_ply_type type);
double bat_ply_number(const char *bytes, bat_ply_type type, bool big_endian);

enum { BAT_PLY_ELEMENTS = 32, BAT_PLY_PROPERTIES = 256, BAT_PLY_CORNERS = 3 };
/* What a property says: x, y, z (0, 1, 2), the corners of a face, or (-1) something else. */
typedef struct bat_ply_property {
    bat_ply_type type, count; /* count: of lists, the type of how many follow */
    int role;
} bat_ply_property;
typedef enum bat_ply_role { BAT_PLY_OTHER, BAT_PLY_VERTEX, BAT_PLY_FACE } bat_ply_role;
typedef struct bat_ply_element {
    bat_ply_role role;
    uint64_t rows;
    int first, properties;
} bat_ply_element;
typedef struct bat_ply_header {
    bool text, big_endian;
    int elements, properties;
    bat_ply_element element[BAT_PLY_ELEMENTS];
    bat_ply_property property[BAT_PLY_PROPERTIES];
    size_t end; /* where the rows begin */
    long lines; /* of the header */
} bat_ply_header;
bat_status bat_ply_read_header(const char *text, size_t size, bat_ply_header *out, bat_problem *problem);
/* Vertices and faces; *left_out: rows of other elements, and faces of fewer than three corners. */
bat_status bat_ply_parse(const char *bytes, size_t size, bat_faces *out, int *left_out, bat_problem *problem);

#endif
