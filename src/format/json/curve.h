/* CURVE as part of other JSON. */
#ifndef BATTEN_FORMAT_JSON_CURVE_H
#define BATTEN_FORMAT_JSON_CURVE_H

#include "text/json.h"
#include "text/text.h"
#include <batten/curve.h>

bat_status bat_curve_from_json(const bat_json *json, uint32_t node, bat_curve **out, bat_problem *problem);
/* indent: spaces before the members, for readability; 0: everything on one line. */
void bat_curve_to_json(const bat_curve *curve, int indent, bat_text *text);

/* Reads a list of numbers; *out is malloc'ed. */
bat_status bat_numbers_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                 size_t *count, bat_problem *problem);
/* Reads a list of points, all of one dimension (2 or 3); *out is malloc'ed. */
bat_status bat_points_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                size_t *count, int *dimension, bat_problem *problem);

/* "[1,2]" and "[[1,2],[3,4]]". */
void bat_numbers_to_json(const double *numbers, size_t count, bat_text *text);
void bat_points_to_json(const double *points, size_t count, int dimension, bat_text *text);

/* The basis of a curve, or of one direction of a surface, as it was read, with the nodes it was read from. */
typedef struct bat_axis_text {
    double degree;
    bool closed;
    size_t count, knot_count;
    const double *knots;
    uint32_t degree_node, knot_node, point_node;
} bat_axis_text;

/* Checks that the degree is valid, the counts match, and the kernel accepts the knots. */
bat_status bat_axis_check(const bat_json *json, const bat_axis_text *axis, bat_problem *problem);
/* Says what is wrong with points whose knots are valid. */
bat_status bat_points_complain(const bat_json *json, uint32_t list, bat_status status, bat_problem *problem);
/* Reads true or false into *out; returns false when the node is neither. */
bool bat_flag_from_json(const bat_json *json, uint32_t node, bool *out);

/* Reads exactly `size` numbers (2 or 3) into out. */
bat_status bat_vector_from_json(const bat_json *json, uint32_t list, const char *what, int size, double *out,
                                bat_problem *problem);

#endif
