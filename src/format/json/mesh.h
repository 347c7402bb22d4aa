/* MESH as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_MESH_H
#define BATTEN_FORMAT_JSON_MESH_H

#include "text/json.h"
#include "text/text.h"
#include <batten/mesh.h>

bat_status bat_polymesh_from_json(const bat_json *json, uint32_t node, bat_polymesh **out,
                                  bat_problem *problem);
void bat_polymesh_to_json(const bat_polymesh *mesh, bat_text *text);

#endif
