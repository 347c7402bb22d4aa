/* Internal to PLY. */
#ifndef BATTEN_FORMAT_PLY_H
#define BATTEN_FORMAT_PLY_H

#include "format/model/model.h"

/* Triangles and vertices with normals as binary PLY 1.0, numbers as 32-bit floats; vertices of a cloud have normals of 0, and
 * lines are left out. Statuses as of bat_stl_write. */
bat_status bat_ply_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
