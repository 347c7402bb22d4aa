/* SURFACE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_SURFACE_H
#define BATTEN_FORMAT_JSON_SURFACE_H

#include "text/json.h"
#include "text/text.h"
#include <batten/surface.h>

bat_status bat_surface_from_json(const bat_json *json, uint32_t node, bat_surface **out,
                                 bat_problem *problem);
void bat_surface_to_json(const bat_surface *surface, bat_text *text);

#endif
