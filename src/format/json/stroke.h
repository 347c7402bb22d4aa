/* STROKE inside other JSON. */
#ifndef BATTEN_FORMAT_JSON_STROKE_H
#define BATTEN_FORMAT_JSON_STROKE_H

#include "text/json.h"

#include <batten/format.h>

/* As bat_stroke_read; node 0: nothing there, told as such. */
bat_status bat_stroke_from_json(const bat_json *json, uint32_t node, bat_stroke *stroke, void **block,
                                bat_problem *problem);

#endif
