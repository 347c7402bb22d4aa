/* RELIEF as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_RELIEF_H
#define BATTEN_FORMAT_JSON_RELIEF_H

#include "text/json.h"
#include "text/text.h"
#include <batten/relief.h>

bat_status bat_relief_from_json(const bat_json *json, uint32_t node, bat_relief **out, bat_problem *problem);
void bat_relief_to_json(const bat_relief *relief, bat_text *text);

#endif
