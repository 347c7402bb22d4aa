/* Internal to 3MF. */
#ifndef BATTEN_FORMAT_THREEMF_H
#define BATTEN_FORMAT_THREEMF_H

#include "format/model/model.h"

/* A package of 3MF (core specification 1.3) in millimetres: an object for each part that has triangles, whose vertices at one
 * place are one. Lines and clouds are left out. Statuses as of bat_stl_write. */
bat_status bat_threemf_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
