/* Internal to 3MF: one file of XML of the archive, with objects that are meshes or made of others. */
#ifndef BATTEN_FORMAT_THREEMF_PART_H
#define BATTEN_FORMAT_THREEMF_PART_H

#include "format/model/unzip.h"

/* An object where it is put; file: of the archive, where it is described. */
typedef struct bat_threemf_use {
    size_t file;
    uint32_t id;
    double pose[12]; /* base/pose.h */
} bat_threemf_use;

typedef struct bat_threemf_object {
    uint32_t id;
    char *name; /* owned; NULL: none */
    size_t vertex, vertex_count, triangle, triangle_count, component, component_count;
    bool busy; /* it is being placed */
} bat_threemf_object;

typedef struct bat_threemf_part {
    double unit; /* millimetres */
    size_t vertex_count, triangle_count, component_count, item_count, object_count;
    size_t vertex_room, triangle_room, component_room, item_room, object_room;
    double *vertices;
    int *triangles; /* three vertices of the object each */
    bat_threemf_use *components, *items;
    bat_threemf_object *objects; /* in order of their ids */
} bat_threemf_part;

/* *left_out: shapes that are neither meshes nor made of others. */
bat_status bat_threemf_read_part(const bat_unzip *zip, size_t file, const char *text, size_t size,
                                 bat_threemf_part *out, int *left_out, bat_problem *problem);
void bat_threemf_clear_part(bat_threemf_part *part);
/* NULL: there is none of that id. O(log objects). */
bat_threemf_object *bat_threemf_object_of(const bat_threemf_part *part, uint32_t id);

#endif
