/* Internal to OBJ: what a file holds, with names; and its lines. */
#ifndef BATTEN_FORMAT_OBJ_H
#define BATTEN_FORMAT_OBJ_H

#include "format/model/model.h"
#include "text/text.h"

typedef struct bat_obj {
    bat_model model;
    char **curve_names, **surface_names; /* one each; NULL: none */
} bat_obj;

/* way: as of bat_room_way, from which vertices are turned back; NULL: they are as in the file. */
bat_status bat_obj_parse(const char *text, size_t size, const double *way, bat_obj *out,
                         bat_problem *problem);
void bat_obj_clear(bat_obj *obj);
/* Whether the text is likely to be in this format: 0 to 100. */
int bat_obj_sniff(const char *text, size_t size);

/* A coordinate of a point that is turned by right angles: every bit of a number stays but for its sign. */
double bat_obj_turned(const double *way, int row, const double point[3]);
/* way: where x, y and z of the file come from (bat_room_way), NULL: from x, y and z; vertices: how many were written before.
 * Return how many are written then. */
uint64_t bat_obj_put_curve(bat_text *text, const bat_curve *curve, const double *way, uint64_t vertices);
uint64_t bat_obj_put_mesh(bat_text *text, const bat_polymesh *mesh, const double *way, uint64_t vertices);
uint64_t bat_obj_put_surface(bat_text *text, const bat_surface *surface, const double *way,
                             uint64_t vertices);
/* Triangles with their normals, lines and clouds. BAT_COUNT: nothing of these. */
bat_status bat_obj_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
