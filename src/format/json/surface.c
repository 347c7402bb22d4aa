/* SURFACE as JSON: {"degree":[p,q], "closed":[false,false], "knots":[[..],[..]], "points":[[[x,y,z],..],..]},
 * with the points row by row: rows follow each other along u, the points of a row along v. */
#include "format/json/surface.h"
#include "format/json/curve.h"
#include <batten/format.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The parts of a surface read so far; the arrays are malloc'ed. */
typedef struct reading {
    bat_axis_text axis[2];
    double *knots[2], *points;
} reading;

/* The two items of a member that holds one for each direction. */
static bat_status both(const bat_json *json, uint32_t node, const char *name, const char *expected,
                       uint32_t items[2], bat_problem *problem) {
    const uint32_t list = bat_json_member(json, node, name);
    if (bat_json_count(json, list) != 2)
        return bat_json_complain(json, list ? list : node, BAT_SYNTAX, name, expected, problem);
    items[0] = bat_json_first(json, list);
    items[1] = json->nodes[items[0]].next;
    return BAT_OK;
}

static bat_status read_axes(const bat_json *json, uint32_t node, reading *read, bat_problem *problem) {
    uint32_t degree[2], closed[2] = {0, 0}, knots[2];
    bat_status status = both(json, node, "degree", "two degrees, of u and v", degree, problem);
    if (status == BAT_OK && bat_json_member(json, node, "closed"))
        status = both(json, node, "closed", "two flags, of u and v", closed, problem);
    if (status == BAT_OK)
        status = both(json, node, "knots", "two lists of numbers, of u and v", knots, problem);
    for (int d = 0; d < 2 && status == BAT_OK; d++) {
        bat_axis_text *axis = &read->axis[d];
        if (bat_json_type_of(json, degree[d]) != BAT_JSON_NUMBER)
            return bat_json_complain(json, degree[d], BAT_SYNTAX, "degree", "a number", problem);
        if (closed[d] && !bat_flag_from_json(json, closed[d], &axis->closed))
            return bat_json_complain(json, closed[d], BAT_SYNTAX, "closed", "true or false", problem);
        axis->degree = json->nodes[degree[d]].value.number;
        axis->degree_node = degree[d], axis->knot_node = knots[d];
        status = bat_numbers_from_json(json, knots[d], "knots", &read->knots[d], &axis->knot_count, problem);
        axis->knots = read->knots[d];
    }
    return status;
}

/* Reads one row into `to`; points with 2 numbers get z = 0. */
static bat_status read_row(const bat_json *json, uint32_t row, size_t count, double *to,
                           bat_problem *problem) {
    double *points;
    size_t found;
    int dimension;
    bat_status status = bat_points_from_json(json, row, "points", &points, &found, &dimension, problem);
    if (status != BAT_OK) return status;
    if (found != count) {
        char message[160];
        snprintf(message, sizeof message, "points: expected %zu in each row, as in the first, found %zu",
                 count, found);
        status = bat_json_say(json, row, BAT_COUNT, message, problem);
    }
    for (size_t j = 0; j < count && status == BAT_OK; j++) {
        to[3 * j + 2] = 0;
        memcpy(to + 3 * j, points + j * (size_t)dimension, (size_t)dimension * sizeof *to);
    }
    free(points);
    return status;
}

static bat_status read_points(const bat_json *json, uint32_t node, reading *read, bat_problem *problem) {
    const uint32_t list = bat_json_member(json, node, "points");
    uint32_t row = bat_json_first(json, list);
    if (bat_json_type_of(json, list) != BAT_JSON_LIST)
        return bat_json_complain(json, list ? list : node, BAT_SYNTAX, "points", "a list of rows of points",
                                 problem);
    read->axis[0].count = bat_json_count(json, list), read->axis[1].count = bat_json_count(json, row);
    read->axis[0].point_node = list, read->axis[1].point_node = row ? row : list;
    for (int d = 0; d < 2; d++) {
        bat_status status = bat_axis_check(json, &read->axis[d], problem);
        if (status != BAT_OK) return status;
    }
    const size_t count = read->axis[1].count;
    if (read->axis[0].count > BAT_POINTS_MAX / count)
        return bat_json_say(json, list, BAT_COUNT, "points: expected 16777216 at most, found more", problem);
    read->points = malloc(read->axis[0].count * count * 3 * sizeof *read->points);
    if (!read->points) return bat_json_say(json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    double *to = read->points;
    for (; row; row = json->nodes[row].next, to += 3 * count) {
        bat_status status = read_row(json, row, count, to, problem);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bat_status make(const bat_json *json, const reading *read, bat_surface **out, bat_problem *problem) {
    const bat_axis_text *a = &read->axis[0], *b = &read->axis[1];
    const int degree[2] = {(int)a->degree, (int)b->degree};
    const int knot_count[2] = {(int)a->knot_count, (int)b->knot_count};
    const bool closed[2] = {a->closed, b->closed};
    const size_t count[2] = {a->count, b->count};
    bat_status status = bat_surface_create(degree, closed, count, read->points, knot_count, a->knots,
                                           b->knots, out);
    if (status == BAT_SINGULAR)
        return bat_json_say(json, a->point_node, status, "points: expected a surface, found all points equal",
                            problem);
    return status == BAT_OK ? BAT_OK : bat_points_complain(json, a->point_node, status, problem);
}

bat_status bat_surface_from_json(const bat_json *json, uint32_t node, bat_surface **out,
                                 bat_problem *problem) {
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_json_complain(json, node, BAT_SYNTAX, "surface", "an object", problem);
    reading read = {.points = NULL};
    bat_status status = read_axes(json, node, &read, problem);
    if (status == BAT_OK) status = read_points(json, node, &read, problem);
    if (status == BAT_OK) status = make(json, &read, out, problem);
    free(read.knots[0]);
    free(read.knots[1]);
    free(read.points);
    return status;
}

void bat_surface_to_json(const bat_surface *surface, bat_text *text) {
    bat_text_string(text, "{\"degree\":[");
    bat_text_integer(text, (uint64_t)bat_surface_degree(surface, BAT_U));
    bat_text_string(text, ",");
    bat_text_integer(text, (uint64_t)bat_surface_degree(surface, BAT_V));
    bat_text_string(text, "],\"closed\":[");
    bat_text_string(text, bat_surface_is_closed(surface, BAT_U) ? "true," : "false,");
    bat_text_string(text, bat_surface_is_closed(surface, BAT_V) ? "true]" : "false]");
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        bat_text_string(text, d == BAT_U ? ",\n \"knots\":[" : ",\n  ");
        bat_numbers_to_json(bat_surface_knots(surface, d), (size_t)bat_surface_knot_count(surface, d), text);
    }
    bat_text_string(text, "],\n \"points\":[");
    const int rows = (int)bat_surface_count(surface, BAT_U);
    for (int i = 0; i < rows; i++) {
        if (i > 0) bat_text_string(text, ",\n  ");
        bat_points_to_json(bat_surface_row(surface, i), bat_surface_count(surface, BAT_V), 3, text);
    }
    bat_text_string(text, "]}");
}

bat_status bat_surface_read(const char *text, size_t size, bat_surface **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_surface_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

bat_status bat_surface_write(const bat_surface *surface, char **text, size_t *size) {
    if (!surface || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_surface_to_json(surface, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
