/* SHAPE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_SHAPE_H
#define BATTEN_FORMAT_JSON_SHAPE_H

#include "text/json.h"
#include "text/text.h"

#include <batten/levels.h>

/* Reads a SHAPE, or an object that has one as its member "shape". */
bat_status bat_shape_from_json(const bat_json *json, uint32_t node, bat_shape **out, bat_problem *problem);
void bat_shape_to_json(const bat_shape *shape, bat_text *text);

#endif
