/* CURVE inside other JSON. */
#ifndef BATTEN_FORMAT_JSON_CURVE_H
#define BATTEN_FORMAT_JSON_CURVE_H

#include "text/json.h"
#include "text/text.h"
#include <batten/curve.h>

bat_status bat_curve_from_json(const bat_json *json, uint32_t node, bat_curve **out, bat_problem *problem);
/* indent: spaces before the members, for people; 0: all on one line. */
void bat_curve_to_json(const bat_curve *curve, int indent, bat_text *text);

/* A list of numbers; *out is malloc'ed. */
bat_status bat_numbers_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                 size_t *count, bat_problem *problem);
/* Lists of points, all of one dimension (2 or 3); *out is malloc'ed. */
bat_status bat_points_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                size_t *count, int *dimension, bat_problem *problem);

/* Exactly `size` numbers (2 or 3) into out. */
bat_status bat_vector_from_json(const bat_json *json, uint32_t list, const char *what, int size, double *out,
                                bat_problem *problem);

#endif
