/* VIEW as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_VIEW_H
#define BATTEN_FORMAT_JSON_VIEW_H

#include "text/json.h"
#include "text/text.h"
#include <batten/view.h>

/* Node 0: reported as missing. */
bat_status bat_viewpoint_from_json(const bat_json *json, uint32_t node, bat_viewpoint *out,
                                   bat_problem *problem);
void bat_viewpoint_to_json(const bat_viewpoint *view, bat_text *text);

#endif
