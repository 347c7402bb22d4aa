/* Internal to USD. */
#ifndef BATTEN_FORMAT_USD_H
#define BATTEN_FORMAT_USD_H

#include "format/model/model.h"

/* Text of USD (.usda): meshes with normals, lines as linear curves, clouds as points; millimetres, z up. Statuses as of
 * bat_gltf_write. */
bat_status bat_usd_put_parts(const bat_parts *parts, char **bytes, size_t *size);

#endif
