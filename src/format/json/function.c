#include "format/json/function.h"

#include "format/json/curve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The curve whose first coordinates are the values. */
static bat_status make(const bat_axis_text *axis, const double *values, bat_curve **out) {
    double *points = calloc(2 * axis->count, sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < axis->count; i++) points[2 * i] = values[i];
    const bat_status status = bat_curve_create(2, (int)axis->degree, axis->closed, axis->count, points,
                                               (int)axis->knot_count, axis->knots, out);
    free(points);
    return status;
}

static bat_status read_spline(const bat_fields *f, uint32_t node, bat_curve **out) {
    const uint32_t degree = bat_json_member(f->json, node, "degree"),
                   knots = bat_json_member(f->json, node, "knots"),
                   values = bat_json_member(f->json, node, "values");
    bat_axis_text axis = {.degree_node = degree, .knot_node = knots, .point_node = values};
    double *knot_list = NULL, *value_list = NULL;
    if (bat_json_type_of(f->json, degree) != BAT_JSON_NUMBER)
        return bat_fields_complain(f, degree ? degree : node, "degree", "1 to 7");
    axis.degree = f->json->nodes[degree].value.number;
    if (!knots) return bat_fields_complain(f, node, "knots", "a list of numbers");
    if (!values) return bat_fields_complain(f, node, "values", "a list of numbers");
    bat_status status = bat_fields_flag(f, node, "closed", &axis.closed);
    if (status == BAT_OK)
        status = bat_numbers_from_json(f->json, knots, "knots", &knot_list, &axis.knot_count, f->problem);
    if (status == BAT_OK)
        status = bat_numbers_from_json(f->json, values, "values", &value_list, &axis.count, f->problem);
    axis.knots = knot_list;
    if (status == BAT_OK) status = bat_axis_check(f->json, &axis, f->problem);
    if (status == BAT_OK) {
        status = make(&axis, value_list, out);
        if (status != BAT_OK) bat_points_complain(f->json, values, status, f->problem);
    }
    free(knot_list), free(value_list);
    return status;
}

bat_status bat_fields_function(const bat_fields *f, uint32_t object, const char *name, bat_function *out) {
    const uint32_t node = bat_json_member(f->json, object, name);
    bat_function read = {0, NULL};
    if (!node) return BAT_OK;
    bat_status status = BAT_OK;
    if (bat_json_type_of(f->json, node) == BAT_JSON_NUMBER)
        read.constant = f->json->nodes[node].value.number;
    else if (bat_json_type_of(f->json, node) == BAT_JSON_OBJECT)
        status = read_spline(f, node, &read.curve);
    else
        return bat_fields_complain(f, node, name,
                                   "a number, or an object with \"degree\", \"knots\" and \"values\"");
    if (status != BAT_OK) return status;
    status = bat_function_check(&read, NULL);
    if (status == BAT_OK) {
        *out = read;
        return BAT_OK;
    }
    bat_function_clear(&read);
    char message[80];
    snprintf(message, sizeof message, "%s: expected %s", name,
             status == BAT_PARAMETER ? "knots whose domain is 0 to 1, found another"
                                     : "a number up to 1e75, found a greater one");
    return bat_json_say(f->json, node, status, message, f->problem);
}

void bat_function_to_json(const bat_function *function, bat_text *text) {
    const bat_curve *curve = function->curve;
    if (!curve) {
        bat_text_number(text, function->constant);
        return;
    }
    const size_t count = bat_curve_count(curve), width = (size_t)bat_curve_dimension(curve);
    bat_text_string(text, "{\"degree\":");
    bat_text_integer(text, (uint64_t)bat_curve_degree(curve));
    if (bat_curve_is_closed(curve)) bat_text_string(text, ",\"closed\":true");
    bat_text_string(text, ",\"knots\":");
    bat_numbers_to_json(bat_curve_knots(curve), (size_t)bat_curve_knot_count(curve), text);
    bat_text_string(text, ",\"values\":[");
    for (size_t i = 0; i < count; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, bat_curve_points(curve)[i * width]);
    }
    bat_text_string(text, "]}");
}
