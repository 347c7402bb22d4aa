/* A motion with the frames that it was made of, as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_MOTION_H
#define BATTEN_FORMAT_JSON_MOTION_H

#include "text/json.h"
#include "text/text.h"

#include <batten/motion.h>

bat_status bat_motion_from_json(const bat_json *json, uint32_t node, bat_motion **out, bat_problem *problem);
/* Read back, it is the same bit for bit. */
void bat_motion_to_json(const bat_motion *motion, bat_text *text);

#endif
