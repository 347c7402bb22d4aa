/* SPLINE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_SPLINE_H
#define BATTEN_FORMAT_JSON_SPLINE_H

#include "text/json.h"
#include "text/text.h"

#include <batten/tangents.h>

/* *spline's arrays lie in one block, freed with bat_free(*block). Its tangents are never NULL. options: set
 * from "mode" and "default", unchanged where these are missing; NULL: these members are ignored. */
bat_status bat_spline_from_json(const bat_json *json, uint32_t node, bat_spline *spline, void **block,
                                bat_tangents_options *options, bat_problem *problem);
/* bat_spline_read, with how the text says that it is made; options: NULL, or what holds where it says nothing. */
bat_status bat_spline_read_as(const char *text, size_t size, bat_spline *spline, void **block,
                              bat_tangents_options *options, bat_problem *problem);
/* Members with default values are left out, but for the mode, which is written wherever options are given. */
void bat_spline_to_json(const bat_spline *spline, const bat_tangents_options *options, bat_text *text);

#endif
