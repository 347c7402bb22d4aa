/* CURVE as JSON: {"degree":3, "closed":false, "knots":[...], "points":[[x,y],...]}. */
#include "format/json/curve.h"
#include "curve/curve.h"
#include "format/json/pack.h"
#include "text/number.h"
#include <batten/curve.h>
#include <batten/format.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_numbers_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                 size_t *count, bat_problem *problem) {
    if (bat_json_type_of(json, list) != BAT_JSON_LIST)
        return bat_json_complain(json, list, BAT_SYNTAX, what, "a list of numbers", problem);
    size_t n = bat_json_count(json, list), i = 0;
    double *numbers = malloc((n + 1) * sizeof *numbers);
    if (!numbers) return bat_json_say(json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next) {
        if (bat_json_type_of(json, at) != BAT_JSON_NUMBER) {
            free(numbers);
            return bat_json_complain(json, at, BAT_SYNTAX, what, "a number", problem);
        }
        numbers[i++] = json->nodes[at].value.number;
    }
    *out = numbers;
    *count = n;
    return BAT_OK;
}

bat_status bat_points_from_json(const bat_json *json, uint32_t list, const char *what, double **out,
                                size_t *count, int *dimension, bat_problem *problem) {
    if (bat_json_type_of(json, list) != BAT_JSON_LIST)
        return bat_json_complain(json, list, BAT_SYNTAX, what, "a list of points", problem);
    size_t n = bat_json_count(json, list), i = 0;
    uint32_t at = bat_json_first(json, list), size = at ? bat_json_count(json, at) : 2;
    if (size < 2 || size > BAT_DIMENSION_MAX)
        return bat_json_complain(json, at, BAT_DIMENSION, what, "a point of 2 or 3 numbers", problem);
    double *points = malloc((n * size + 1) * sizeof *points);
    if (!points) return bat_json_say(json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    bat_status status = BAT_OK;
    for (; at && status == BAT_OK; at = json->nodes[at].next) {
        if (bat_json_count(json, at) != size) {
            status = bat_json_complain(json, at, BAT_DIMENSION, what,
                                       size == 2 ? "a point of 2 numbers, as the first"
                                                 : "a point of 3 numbers, as the first",
                                       problem);
            break;
        }
        for (uint32_t k = bat_json_first(json, at); k; k = json->nodes[k].next) {
            if (bat_json_type_of(json, k) != BAT_JSON_NUMBER) {
                status = bat_json_complain(json, k, BAT_SYNTAX, what, "a number", problem);
                break;
            }
            points[i++] = json->nodes[k].value.number;
        }
    }
    if (status != BAT_OK) {
        free(points);
        return status;
    }
    *out = points;
    *count = n;
    *dimension = (int)size;
    return BAT_OK;
}

bat_status bat_vector_from_json(const bat_json *json, uint32_t list, const char *what, int size, double *out,
                                bat_problem *problem) {
    if (bat_json_count(json, list) != (uint32_t)size)
        return bat_json_complain(json, list, BAT_SYNTAX, what, size == 2 ? "2 numbers" : "3 numbers",
                                 problem);
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next) {
        if (bat_json_type_of(json, at) != BAT_JSON_NUMBER)
            return bat_json_complain(json, at, BAT_SYNTAX, what, "a number", problem);
        *out++ = json->nodes[at].value.number;
    }
    return BAT_OK;
}

static uint32_t item(const bat_json *json, uint32_t list, size_t index) {
    uint32_t at = bat_json_first(json, list);
    for (; index > 0; index--) at = json->nodes[at].next;
    return at;
}

/* The kernel refused these knots: says which one is wrong, and why. */
static bat_status complain_of_knots(const bat_json *json, uint32_t list, int degree, bool closed,
                                    size_t count, const double *knots, bat_problem *problem) {
    char message[160], low[BAT_NUMBER_ROOM], found[BAT_NUMBER_ROOM];
    size_t run = 1; /* number of equal knots up to this one */
    for (size_t i = 1; i < count; i++) {
        run = knots[i] == knots[i - 1] ? run + 1 : 1;
        bool end = !closed && (knots[i] == knots[0] || knots[i] == knots[count - 1]);
        size_t most = (size_t)degree + end;
        if (knots[i] >= knots[i - 1] && run <= most) continue;
        bat_number_print(knots[i - 1], low);
        bat_number_print(knots[i], found);
        if (run > most)
            snprintf(message, sizeof message, "knots: expected at most %zu knots at %s, found more", most,
                     found);
        else
            snprintf(message, sizeof message, "knots: expected at least %s, found %s", low, found);
        return bat_json_say(json, item(json, list, i), BAT_KNOTS, message, problem);
    }
    return bat_json_say(json, list, BAT_KNOTS,
                        "knots: expected a domain whose first and last span are not empty, and knots neither "
                        "too close nor too large, found others",
                        problem);
}

bat_status bat_axis_check(const bat_json *json, const bat_axis_text *axis, bat_problem *problem) {
    const double degree = axis->degree;
    if (degree != 1 && degree != 2 && degree != 3 && degree != 4 && degree != 5 && degree != 6 && degree != 7)
        return bat_json_complain(json, axis->degree_node, BAT_DEGREE, "degree", "1 to 7", problem);
    char message[160];
    const size_t count = axis->count, least = axis->closed ? 2 : (size_t)degree + 1,
                 fitting = count + (axis->closed ? 1 : (size_t)degree + 1);
    if (count > BAT_POINTS_MAX || count < least) {
        snprintf(message, sizeof message, "points: expected %zu to %d, found %zu", least, BAT_POINTS_MAX,
                 count);
        return bat_json_say(json, axis->point_node, BAT_COUNT, message, problem);
    }
    if (axis->knot_count != fitting) {
        snprintf(message, sizeof message, "knots: expected %zu for %zu points%s, found %zu", fitting, count,
                 axis->closed ? " of a closed curve" : "", axis->knot_count);
        return bat_json_say(json, axis->knot_node, BAT_KNOTS, message, problem);
    }
    bat_status status = bat_knots_check((int)degree, axis->closed, (int)count, axis->knots);
    if (status == BAT_KNOTS)
        return complain_of_knots(json, axis->knot_node, (int)degree, axis->closed, axis->knot_count,
                                 axis->knots, problem);
    if (status != BAT_OK)
        return bat_json_say(json, axis->knot_node, status,
                            "knots: expected numbers up to 1e30, none of them too close, found others",
                            problem);
    return BAT_OK;
}

bat_status bat_points_complain(const bat_json *json, uint32_t list, bat_status status, bat_problem *problem) {
    return bat_json_say(json, list, status,
                        status == BAT_NUMBER ? "points: expected numbers up to 1e75, found greater ones"
                                             : bat_status_message(status),
                        problem);
}

bool bat_flag_from_json(const bat_json *json, uint32_t node, bool *out) {
    const bat_json_type type = bat_json_type_of(json, node);
    *out = type == BAT_JSON_TRUE;
    return type == BAT_JSON_TRUE || type == BAT_JSON_FALSE;
}

bat_status bat_curve_from_json(const bat_json *json, uint32_t node, bat_curve **out, bat_problem *problem) {
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_json_complain(json, node, BAT_SYNTAX, "curve", "an object", problem);
    uint32_t degree = bat_json_member(json, node, "degree"), closed = bat_json_member(json, node, "closed");
    if (bat_json_type_of(json, degree) != BAT_JSON_NUMBER)
        return bat_json_complain(json, degree ? degree : node, BAT_SYNTAX, "degree", "a number", problem);
    bool is_closed = false;
    if (closed && !bat_flag_from_json(json, closed, &is_closed))
        return bat_json_complain(json, closed, BAT_SYNTAX, "closed", "true or false", problem);
    const uint32_t packed = bat_json_member(json, node, "packed");
    if (packed) {
        const char *text = bat_json_text(json, packed);
        const double number = json->nodes[degree].value.number;
        const bool whole = number >= 1 && number <= BAT_DEGREE_MAX && number == floor(number);
        const bat_status status = text ? bat_curve_unpack(text, whole ? (int)number : 0, is_closed, out)
                                       : BAT_SYNTAX;
        if (status == BAT_OK) return status;
        if (status == BAT_MEMORY)
            return bat_json_say(json, packed, status, bat_status_message(status), problem);
        return bat_json_complain(json, packed, status, "packed", "a curve in base 64", problem);
    }
    double *knots = NULL, *points = NULL;
    size_t knot_count, count;
    int dimension;
    uint32_t knot_list = bat_json_member(json, node, "knots"),
             point_list = bat_json_member(json, node, "points");
    bat_status status = bat_numbers_from_json(json, knot_list, "knots", &knots, &knot_count, problem);
    if (status == BAT_OK)
        status = bat_points_from_json(json, point_list, "points", &points, &count, &dimension, problem);
    if (status == BAT_OK) {
        const bat_axis_text axis = {json->nodes[degree].value.number,
                                    is_closed,
                                    count,
                                    knot_count,
                                    knots,
                                    degree,
                                    knot_list,
                                    point_list};
        status = bat_axis_check(json, &axis, problem);
    }
    if (status == BAT_OK) {
        status = bat_curve_create(dimension, (int)json->nodes[degree].value.number, is_closed, count, points,
                                  (int)knot_count, knots, out);
        if (status != BAT_OK) bat_points_complain(json, point_list, status, problem);
    }
    free(knots);
    free(points);
    /* A missing member has no position of its own. */
    if (status != BAT_OK && status != BAT_MEMORY && (!knot_list || !point_list) && problem)
        bat_json_say(json, node, status,
                     knot_list ? "points: expected a list of points, found none"
                               : "knots: expected a list of numbers, found none",
                     problem);
    return status;
}

static void new_line(bat_text *text, int indent) {
    if (indent == 0) return;
    bat_text_string(text, "\n");
    for (int i = 0; i < indent; i++) bat_text_string(text, " ");
}

void bat_numbers_to_json(const double *numbers, size_t count, bat_text *text) {
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, i > 0 ? "," : "[");
        bat_text_number(text, numbers[i]);
    }
    bat_text_string(text, count > 0 ? "]" : "[]");
}

void bat_points_to_json(const double *points, size_t count, int dimension, bat_text *text) {
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, i > 0 ? "," : "[");
        bat_numbers_to_json(points + i * (size_t)dimension, (size_t)dimension, text);
    }
    bat_text_string(text, count > 0 ? "]" : "[]");
}

void bat_curve_to_json(const bat_curve *curve, int indent, bat_text *text) {
    int dimension = bat_curve_dimension(curve), count = bat_point_count(curve);
    const double *knots = bat_curve_knots(curve), *points = bat_curve_points(curve);
    bat_text_string(text, "{\"degree\":");
    bat_text_integer(text, (uint64_t)bat_curve_degree(curve));
    bat_text_string(text, bat_curve_is_closed(curve) ? ",\"closed\":true," : ",\"closed\":false,");
    if (text->packed && count >= BAT_PACK_LEAST) {
        bat_text_string(text, "\"packed\":");
        bat_curve_pack(curve, text);
        bat_text_string(text, "}");
        return;
    }
    new_line(text, indent);
    bat_text_string(text, "\"knots\":");
    bat_numbers_to_json(knots, (size_t)bat_curve_knot_count(curve), text);
    bat_text_string(text, ",");
    new_line(text, indent);
    bat_text_string(text, "\"points\":");
    bat_points_to_json(points, (size_t)count, dimension, text);
    bat_text_string(text, "}");
}

bat_status bat_curve_read(const char *text, size_t size, bat_curve **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_curve_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

bat_status bat_curve_write(const bat_curve *curve, char **text, size_t *size) {
    if (!curve || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_curve_to_json(curve, 1, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
