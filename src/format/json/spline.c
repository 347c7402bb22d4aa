/*
 * SPLINE as JSON:
 *   {"points":[...], "tangents":[null or [dx,dy], ...], "closed":false,
 *    "tension":[t or [in,out] or null, ...], "mode":"round", "default":"centripetal"}
 */
#include "format/json/spline.h"

#include "format/json/curve.h"
#include "format/json/word.h"

#include <batten/format.h>

#include <stdlib.h>
#include <string.h>

static const char *const MODES[] = {"faithful", "paper", "even", "round", NULL};
static const char *const DEFAULTS[] = {"centripetal", "uniform", "chordal", NULL};

static bool is(const bat_json *json, uint32_t node, bat_json_type type) {
    return bat_json_type_of(json, node) == type;
}

static bat_status read_tangents(const bat_json *json, uint32_t list, int dimension, size_t count, double *out,
                                bat_problem *problem) {
    if (!list || is(json, list, BAT_JSON_NULL)) return BAT_OK;
    if (bat_json_count(json, list) != count)
        return bat_json_complain(json, list, BAT_COUNT, "tangents", "one a point, null where none is given",
                                 problem);
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next, out += dimension) {
        if (is(json, at, BAT_JSON_NULL)) continue;
        bat_status status = bat_vector_from_json(json, at, "tangents", dimension, out, problem);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bat_status read_tension(const bat_json *json, uint32_t list, size_t count, double *out,
                               bat_problem *problem) {
    if (bat_json_count(json, list) != count)
        return bat_json_complain(json, list, BAT_COUNT, "tension", "one a point, null where none is given",
                                 problem);
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next, out += 2) {
        bat_status status = BAT_OK;
        if (is(json, at, BAT_JSON_NUMBER))
            out[0] = out[1] = json->nodes[at].value.number;
        else if (is(json, at, BAT_JSON_LIST))
            status = bat_vector_from_json(json, at, "tension", 2, out, problem);
        else if (!is(json, at, BAT_JSON_NULL))
            status = bat_json_complain(json, at, BAT_SYNTAX, "tension", "a number, a pair, or null", problem);
        if (status == BAT_OK && !(out[0] >= 0 && out[0] <= 1e6 && out[1] >= 0 && out[1] <= 1e6))
            status = bat_json_complain(json, at, BAT_NUMBER, "tension", "numbers from 0 to 1e6", problem);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bat_status read_closed(const bat_json *json, uint32_t object, bool *out, bat_problem *problem) {
    uint32_t node = bat_json_member(json, object, "closed");
    if (node && !is(json, node, BAT_JSON_TRUE) && !is(json, node, BAT_JSON_FALSE))
        return bat_json_complain(json, node, BAT_SYNTAX, "closed", "true or false", problem);
    *out = is(json, node, BAT_JSON_TRUE);
    return BAT_OK;
}

static bat_status read_options(const bat_json *json, uint32_t object, bat_tangents_options *options,
                               bat_problem *problem) {
    int mode = (int)options->mode, missing = (int)options->missing;
    bat_status status = bat_word_from_json(json, object, "mode", MODES, "faithful, paper, even or round",
                                           &mode, problem);
    if (status == BAT_OK)
        status = bat_word_from_json(json, object, "default", DEFAULTS, "centripetal, uniform or chordal",
                                    &missing, problem);
    if (status == BAT_OK)
        options->mode = (bat_tangents_mode)mode, options->missing = (bat_tangents_default)missing;
    return status;
}

bat_status bat_spline_from_json(const bat_json *json, uint32_t node, bat_spline *out, void **block,
                                bat_tangents_options *options, bat_problem *problem) {
    if (!is(json, node, BAT_JSON_OBJECT))
        return bat_json_complain(json, node, BAT_SYNTAX, "spline", "an object", problem);
    uint32_t list = bat_json_member(json, node, "points"), tension = bat_json_member(json, node, "tension");
    double *points = NULL;
    size_t count = 0;
    int dimension = 2;
    bool closed = false;
    if (!list)
        return bat_json_say(json, node, BAT_SYNTAX, "points: expected a list of points, found none", problem);
    bat_status status = bat_points_from_json(json, list, "points", &points, &count, &dimension, problem);
    if (status != BAT_OK) return status;
    size_t size = count * (size_t)dimension;
    double *all = NULL;
    if (count > BAT_POINTS_MAX / 4)
        status = bat_json_say(json, list, BAT_COUNT, "points: expected fewer", problem);
    else if (!(all = calloc(2 * size + 2 * count + 1, sizeof *all)))
        status = bat_json_say(json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
    if (!all) {
        free(points);
        return status;
    }
    if (size) memcpy(all, points, size * sizeof *all);
    for (size_t i = 0; i < 2 * count; i++) all[2 * size + i] = 1;
    status = read_closed(json, node, &closed, problem);
    if (status == BAT_OK)
        status = read_tangents(json, bat_json_member(json, node, "tangents"), dimension, count, all + size,
                               problem);
    bool tense = tension && !is(json, tension, BAT_JSON_NULL);
    if (status == BAT_OK && tense) status = read_tension(json, tension, count, all + 2 * size, problem);
    if (status == BAT_OK && options) status = read_options(json, node, options, problem);
    free(points);
    if (status != BAT_OK) {
        free(all);
        return status;
    }
    *out = (bat_spline){.dimension = dimension,
                        .closed = closed,
                        .count = count,
                        .points = all,
                        .tangents = all + size,
                        .tension = tense ? all + 2 * size : NULL};
    *block = all;
    return BAT_OK;
}

bat_status bat_spline_read_as(const char *text, size_t size, bat_spline *out, void **block,
                              bat_tangents_options *options, bat_problem *problem) {
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_spline_from_json(&json, 1, out, block, options, problem);
    bat_json_free(&json);
    return status;
}

bat_status bat_spline_read(const char *text, size_t size, bat_spline *out, void **block,
                           bat_problem *problem) {
    if (!text || !out || !block)
        return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    return bat_spline_read_as(text, size, out, block, NULL, problem);
}

/* ---- and back ---- */

static void write_vector(bat_text *text, const double *v, int size) {
    for (int d = 0; d < size; d++) {
        bat_text_string(text, d ? "," : "[");
        bat_text_number(text, v[d]);
    }
    bat_text_string(text, "]");
}

static bool all_are(const double *v, size_t count, double value) {
    for (size_t i = 0; i < count; i++)
        if (v[i] != value) return false;
    return true;
}

static void write_vectors(bat_text *text, const char *name, const double *v, size_t count, int size,
                          bool zero_is_null) {
    bat_text_string(text, name);
    for (size_t i = 0; i < count; i++, v += size) {
        if (i) bat_text_string(text, ",");
        if (zero_is_null && all_are(v, (size_t)size, 0))
            bat_text_string(text, "null");
        else
            write_vector(text, v, size);
    }
    bat_text_string(text, "]");
}

void bat_spline_to_json(const bat_spline *spline, const bat_tangents_options *options, bat_text *text) {
    size_t count = spline->count;
    write_vectors(text, "{\"points\":[", spline->points, count, spline->dimension, false);
    if (spline->tangents && !all_are(spline->tangents, count * (size_t)spline->dimension, 0))
        write_vectors(text, ",\"tangents\":[", spline->tangents, count, spline->dimension, true);
    if (spline->tension && !all_are(spline->tension, 2 * count, 1))
        write_vectors(text, ",\"tension\":[", spline->tension, count, 2, false);
    bat_text_string(text, spline->closed ? ",\"closed\":true" : ",\"closed\":false");
    if (options) {
        bat_text_string(text, ",\"mode\":\"");
        bat_text_string(text, MODES[options->mode]);
        bat_text_string(text, "\"");
    }
    if (options && options->missing != BAT_TANGENTS_CENTRIPETAL) {
        bat_text_string(text, ",\"default\":\"");
        bat_text_string(text, DEFAULTS[options->missing]);
        bat_text_string(text, "\"");
    }
    bat_text_string(text, "}");
}
