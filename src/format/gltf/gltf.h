/* Internal to glTF. */
#ifndef BATTEN_FORMAT_GLTF_H
#define BATTEN_FORMAT_GLTF_H

#include "format/model/model.h"

/* As bat_gltf_write, of parts that are there already; or as one text of JSON (.gltf), which holds the numbers in base 64. */
bat_status bat_gltf_put_parts(const bat_parts *parts, char **bytes, size_t *size);
bat_status bat_gltf_put_parts_as_text(const bat_parts *parts, char **bytes, size_t *size);

#endif
