/* STROKE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_STROKE_H
#define BATTEN_FORMAT_JSON_STROKE_H

#include "text/json.h"

#include <batten/format.h>

/* Like bat_stroke_read; node 0: reported as missing. */
bat_status bat_stroke_from_json(const bat_json *json, uint32_t node, bat_stroke *stroke, void **block,
                                bat_problem *problem);

#endif
