/* Internal to STL. */
#ifndef BATTEN_FORMAT_STL_H
#define BATTEN_FORMAT_STL_H

#include "format/model/model.h"

/* As bat_stl_write, of parts that are there already. */
bat_status bat_stl_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
