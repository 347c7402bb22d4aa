/* Internal to 3MF. */
#ifndef BATTEN_FORMAT_THREEMF_H
#define BATTEN_FORMAT_THREEMF_H

#include "format/model/faces.h"

/* A package of 3MF (core specification 1.3) in millimetres: an object for each part that has triangles, whose vertices at one
 * place are one. Lines and clouds are left out. Statuses as of bat_stl_write. */
bat_status bat_threemf_put_parts(const bat_parts *parts, char **bytes, size_t *size);

/* A mesh for each item of the build that has triangles, on top of the drawing; *left_out: what else has a shape. BAT_COUNT also: it
 * unpacks to more than a file of its size may. O(bytes) as a rule: an object that is used often is made as often, up to a bound. */
bat_status bat_threemf_parse(const char *bytes, size_t size, bat_document *out, int *left_out,
                             bat_problem *problem);

#endif
