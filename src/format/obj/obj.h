/* Internal to OBJ: what a file holds, with names; and its lines. */
#ifndef BATTEN_FORMAT_OBJ_H
#define BATTEN_FORMAT_OBJ_H

#include "format/model/model.h"
#include "text/text.h"

typedef struct bat_obj {
    bat_model model;
    char **curve_names, **surface_names; /* one each; NULL: none */
} bat_obj;

bat_status bat_obj_parse(const char *text, size_t size, bat_obj *out, bat_problem *problem);
void bat_obj_clear(bat_obj *obj);
/* Whether the text is likely to be in this format: 0 to 100. */
int bat_obj_sniff(const char *text, size_t size);

/* vertices: how many were written before. Return how many are written then. */
uint64_t bat_obj_put_curve(bat_text *text, const bat_curve *curve, uint64_t vertices);
uint64_t bat_obj_put_mesh(bat_text *text, const bat_polymesh *mesh, uint64_t vertices);
uint64_t bat_obj_put_surface(bat_text *text, const bat_surface *surface, uint64_t vertices);
/* Triangles with their normals, lines and clouds. BAT_COUNT: nothing of these. */
bat_status bat_obj_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
