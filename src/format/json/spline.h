/* SPLINE inside other JSON. */
#ifndef BATTEN_FORMAT_JSON_SPLINE_H
#define BATTEN_FORMAT_JSON_SPLINE_H

#include "text/json.h"
#include "text/text.h"

#include <batten/tangents.h>

/* *spline's arrays lie in one block: bat_free(*block). Its tangents are never NULL. options: what "mode" and
 * "default" say; left alone where they are not there; NULL: not looked at. */
bat_status bat_spline_from_json(const bat_json *json, uint32_t node, bat_spline *spline, void **block,
                                bat_tangents_options *options, bat_problem *problem);
/* What is as by default is left out, so that a plain spline is its points. */
void bat_spline_to_json(const bat_spline *spline, const bat_tangents_options *options, bat_text *text);

#endif
