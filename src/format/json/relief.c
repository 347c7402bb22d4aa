/* RELIEF as JSON: {"base":SURFACE, "levels":[{"knots":[[..],[..]], "details":[[[a,b,c],..],..], "source":[[..],..],
 * "gain":1, "muted":false}, ..]}; all members of a level may be left out. */
#include "format/json/relief.h"
#include "format/json/curve.h"
#include "format/json/surface.h"
#include <batten/format.h>

#include <stdlib.h>
#include <string.h>

/* A level as it is read; the arrays are malloc'ed. */
typedef struct reading {
    double *knots[2], *details;
    int *source, knot_count[2];
    size_t count[2]; /* control points that its knots make */
} reading;

static bat_status no_memory(const bat_json *json, uint32_t node, bat_problem *problem) {
    return bat_json_say(json, node, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
}

static bat_status read_knots(const bat_json *json, uint32_t level, const bat_surface *below, reading *read,
                             bat_problem *problem) {
    const uint32_t list = bat_json_member(json, level, "knots");
    if (!list) return BAT_OK;
    if (bat_json_count(json, list) != 2)
        return bat_json_complain(json, list, BAT_SYNTAX, "knots", "two lists of numbers, of u and v",
                                 problem);
    uint32_t node = bat_json_first(json, list);
    for (int d = 0; d < 2; d++, node = json->nodes[node].next) {
        size_t found;
        bat_status status = bat_numbers_from_json(json, node, "knots", &read->knots[d], &found, problem);
        if (status != BAT_OK) return status;
        const bool closed = bat_surface_is_closed(below, (bat_direction)d);
        const size_t more = closed ? 1 : (size_t)bat_surface_degree(below, (bat_direction)d) + 1;
        if (found <= more || found > BAT_POINTS_MAX)
            return bat_json_complain(json, node, BAT_COUNT, "knots", "all those of the level below", problem);
        read->knot_count[d] = (int)found, read->count[d] = found - more;
    }
    return BAT_OK;
}

/* Whether the list is read->count[0] rows of read->count[1] items. */
static bat_status check_rows(const bat_json *json, uint32_t list, const char *name, const reading *read,
                             bat_problem *problem) {
    static const char expected[] = "a row for each row of the level's control points, of one item for each";
    if (!read->knots[0]) return bat_json_complain(json, list, BAT_SYNTAX, name, "knots beside them", problem);
    bool right = bat_json_type_of(json, list) == BAT_JSON_LIST &&
                 bat_json_count(json, list) == read->count[0];
    for (uint32_t row = bat_json_first(json, list); row && right; row = json->nodes[row].next)
        right = bat_json_type_of(json, row) == BAT_JSON_LIST && bat_json_count(json, row) == read->count[1];
    return right ? BAT_OK : bat_json_complain(json, list, BAT_COUNT, name, expected, problem);
}

static bat_status read_details(const bat_json *json, uint32_t level, reading *read, bat_problem *problem) {
    const uint32_t list = bat_json_member(json, level, "details");
    if (!list) return BAT_OK;
    bat_status status = check_rows(json, list, "details", read, problem);
    if (status != BAT_OK) return status;
    double *to = read->details = malloc(3 * read->count[0] * read->count[1] * sizeof *to);
    if (!to) return no_memory(json, list, problem);
    for (uint32_t row = bat_json_first(json, list); row; row = json->nodes[row].next)
        for (uint32_t node = bat_json_first(json, row); node; node = json->nodes[node].next, to += 3) {
            status = bat_vector_from_json(json, node, "details", 3, to, problem);
            if (status != BAT_OK) return status;
        }
    return BAT_OK;
}

static bat_status read_source(const bat_json *json, uint32_t level, int number, reading *read,
                              bat_problem *problem) {
    const uint32_t list = bat_json_member(json, level, "source");
    if (!list) return BAT_OK;
    bat_status status = check_rows(json, list, "source", read, problem);
    if (status != BAT_OK) return status;
    int *to = read->source = malloc(read->count[0] * read->count[1] * sizeof *to);
    if (!to) return no_memory(json, list, problem);
    for (uint32_t row = bat_json_first(json, list); row; row = json->nodes[row].next)
        for (uint32_t node = bat_json_first(json, row); node; node = json->nodes[node].next) {
            const bool is_number = bat_json_type_of(json, node) == BAT_JSON_NUMBER;
            const double value = is_number ? json->nodes[node].value.number : -1;
            if (!(value >= 0 && value < number))
                return bat_json_complain(json, node, BAT_ARGUMENT, "source", "a level below this one",
                                         problem);
            *to++ = (int)value;
        }
    return BAT_OK;
}

static bat_status read_loudness(const bat_json *json, uint32_t level, bat_relief *relief,
                                bat_problem *problem) {
    const uint32_t gain = bat_json_member(json, level, "gain"), muted = bat_json_member(json, level, "muted");
    const int number = bat_relief_levels(relief);
    bool silent = false;
    bat_status status = BAT_OK;
    if (gain && bat_json_type_of(json, gain) == BAT_JSON_NUMBER)
        status = bat_relief_set_gain(relief, number, json->nodes[gain].value.number);
    else if (gain)
        status = BAT_NUMBER;
    if (status == BAT_NUMBER)
        return bat_json_complain(json, gain, status, "gain", "a number within 1e6", problem);
    if (status == BAT_OK && muted && !bat_flag_from_json(json, muted, &silent))
        return bat_json_complain(json, muted, BAT_SYNTAX, "muted", "true or false", problem);
    if (status == BAT_OK && silent) status = bat_relief_set_muted(relief, number, true);
    return status == BAT_OK ? BAT_OK : bat_json_say(json, level, status, bat_status_message(status), problem);
}

static bat_status read_level(const bat_json *json, uint32_t level, bat_relief *relief, bat_problem *problem) {
    const int number = bat_relief_levels(relief) + 1;
    reading read = {.source = NULL};
    if (bat_json_type_of(json, level) != BAT_JSON_OBJECT)
        return bat_json_complain(json, level, BAT_SYNTAX, "level", "an object", problem);
    bat_status status = read_knots(json, level, bat_relief_surface(relief, number - 1), &read, problem);
    if (status == BAT_OK) status = read_details(json, level, &read, problem);
    if (status == BAT_OK) status = read_source(json, level, number, &read, problem);
    if (status == BAT_OK) {
        status = bat_relief_add_level(relief, read.knot_count, read.knots[0], read.knots[1], read.details,
                                      read.source);
        if (status == BAT_KNOTS)
            bat_json_complain(json, bat_json_member(json, level, "knots"), status, "knots",
                              "all those of the level below, and more", problem);
        else if (status != BAT_OK)
            bat_json_say(json, level, status, bat_status_message(status), problem);
    }
    free(read.knots[0]), free(read.knots[1]), free(read.details), free(read.source);
    return status == BAT_OK ? read_loudness(json, level, relief, problem) : status;
}

bat_status bat_relief_from_json(const bat_json *json, uint32_t node, bat_relief **out, bat_problem *problem) {
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_json_complain(json, node, BAT_SYNTAX, "relief", "an object", problem);
    const uint32_t given = bat_json_member(json, node, "base"), list = bat_json_member(json, node, "levels");
    bat_surface *base = NULL;
    bat_relief *relief = NULL;
    if (!given) return bat_json_say(json, node, BAT_SYNTAX, "base: expected a surface, found none", problem);
    if (list && bat_json_type_of(json, list) != BAT_JSON_LIST)
        return bat_json_complain(json, list, BAT_SYNTAX, "levels", "a list", problem);
    bat_status status = bat_surface_from_json(json, given, &base, problem);
    if (status != BAT_OK) return status;
    status = bat_relief_create(base, &relief);
    bat_surface_free(base);
    if (status != BAT_OK) return bat_json_say(json, given, status, bat_status_message(status), problem);
    for (uint32_t at = bat_json_first(json, list); at && status == BAT_OK; at = json->nodes[at].next)
        status = read_level(json, at, relief, problem);
    if (status == BAT_OK)
        *out = relief;
    else
        bat_relief_free(relief);
    return status;
}

static void put_source(const int *source, size_t rows, size_t columns, bat_text *text) {
    bat_text_string(text, ",\n   \"source\":[");
    for (size_t i = 0; i < rows; i++) {
        bat_text_string(text, i > 0 ? ",[" : "[");
        for (size_t k = 0; k < columns; k++) {
            if (k > 0) bat_text_string(text, ",");
            bat_text_integer(text, (uint64_t)source[i * columns + k]);
        }
        bat_text_string(text, "]");
    }
    bat_text_string(text, "]");
}

static void put_level(const bat_relief *relief, int level, bat_text *text) {
    const bat_surface *surface = bat_relief_surface(relief, level);
    const size_t rows = bat_surface_count(surface, BAT_U), columns = bat_surface_count(surface, BAT_V);
    const int *source = bat_relief_source(relief, level);
    bool usual = true;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        bat_text_string(text, d == BAT_U ? "{\"knots\":[" : ",\n    ");
        bat_numbers_to_json(bat_surface_knots(surface, d), (size_t)bat_surface_knot_count(surface, d), text);
    }
    bat_text_string(text, "],\n   \"details\":[");
    for (size_t i = 0; i < rows; i++) {
        if (i > 0) bat_text_string(text, ",\n    ");
        bat_points_to_json(bat_relief_details(relief, level) + 3 * i * columns, columns, 3, text);
    }
    bat_text_string(text, "]");
    for (size_t i = 0; i < rows * columns; i++) usual = usual && source[i] == level - 1;
    if (!usual) put_source(source, rows, columns, text);
    if (bat_relief_gain(relief, level) != 1) {
        bat_text_string(text, ",\"gain\":");
        bat_text_number(text, bat_relief_gain(relief, level));
    }
    if (bat_relief_is_muted(relief, level)) bat_text_string(text, ",\"muted\":true");
    bat_text_string(text, "}");
}

void bat_relief_to_json(const bat_relief *relief, bat_text *text) {
    bat_text_string(text, "{\"base\":");
    bat_surface_to_json(bat_relief_surface(relief, 0), text);
    bat_text_string(text, ",\n \"levels\":[");
    for (int l = 1; l <= bat_relief_levels(relief); l++) {
        bat_text_string(text, l > 1 ? ",\n  " : "\n  ");
        put_level(relief, l, text);
    }
    bat_text_string(text, "]}");
}

bat_status bat_relief_read(const char *text, size_t size, bat_relief **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_relief_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

bat_status bat_relief_write(const bat_relief *relief, char **text, size_t *size) {
    if (!relief || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_relief_to_json(relief, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
