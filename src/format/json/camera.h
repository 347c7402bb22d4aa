/* MOVE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_CAMERA_H
#define BATTEN_FORMAT_JSON_CAMERA_H

#include "text/json.h"
#include "text/text.h"
#include <batten/camera.h>

/* Node 0: reported as missing. */
bat_status bat_camera_from_json(const bat_json *json, uint32_t node, bat_camera **out, bat_problem *problem);
/* Its ORIENTATION alone. */
void bat_orientation_to_json(const bat_camera *camera, bat_text *text);
/* What is the default is left out. */
void bat_camera_to_json(const bat_camera *camera, bat_text *text);

/* A camera along a given path, of an ORIENTATION alone. */
bat_status bat_camera_from_orientation(const bat_json *json, uint32_t node, const bat_curve *path,
                                       double duration, bat_camera **out, bat_problem *problem);

#endif
