/* Redrawn lines of surfaces as lines of the journal (docs/journal.md). */
#include "editor/edit/mirror_record.h"
#include "editor/edit/stroke_record.h"
#include "editor/edit/surface_line.h"
#include "editor/session/journal_line.h"
#include "format/json/curve.h"
#include "format/json/view.h"
#include "format/json/word.h"
#include <math.h>

static const char *const DIRECTIONS[] = {"u", "v", NULL};

static void number(bat_text *line, const char *name, double value) {
    bat_text_string(line, ",\"");
    bat_text_string(line, name);
    bat_text_string(line, "\":");
    bat_line_number(line, value);
}

void bat_line_edit_write(const bat_line_edit *edit, bat_text *line) {
    double locks[BAT_LINE_EDGES], any = 0, ruled = 0;
    for (int k = 0; k < BAT_LINE_EDGES; k++) locks[k] = edit->lock[k], any += locks[k];
    for (int k = 0; k < 3; k++) ruled += fabs(edit->along[k]);
    bat_text_string(line, "{\"do\":\"" BAT_LINE_EDIT "\"");
    number(line, "object", (double)edit->object);
    bat_text_string(line, ",\"direction\":\"");
    bat_text_string(line, DIRECTIONS[edit->direction]);
    bat_text_string(line, "\"");
    number(line, "at", edit->at);
    number(line, "tolerance", edit->tolerance);
    if (edit->reach > 0) number(line, "reach", edit->reach);
    if (edit->level > 0) number(line, "level", edit->level);
    if (any > 0) {
        bat_text_string(line, ",\"locks\":");
        bat_line_numbers(line, locks, BAT_LINE_EDGES, 1);
    }
    if (ruled > 0) {
        bat_text_string(line, ",\"along\":");
        bat_line_numbers(line, edit->along, 3, 1);
    }
    bat_mirror_write(&edit->mirror, line);
    bat_text_string(line, ",\"view\":");
    bat_viewpoint_to_json(&edit->seen, line);
    bat_text_string(line, ",\"stroke\":[");
    for (size_t i = 0; i < edit->count; i++) {
        if (i) bat_text_string(line, ",");
        bat_line_numbers(line, edit->pixels + 2 * i, 2, 1);
    }
    bat_text_string(line, "]");
}

static bat_status read_stroke(const bat_json *json, bat_line_edit *out, double **pixels,
                              bat_problem *problem) {
    int dimension = 0;
    const uint32_t node = bat_json_member(json, 1, "stroke");
    if (bat_json_count(json, node) < 1 || bat_json_count(json, node) > BAT_LINE_PIXELS)
        return bat_json_complain(json, node ? node : 1, BAT_COUNT, "stroke", "a list of one point or more",
                                 problem);
    bat_status status = bat_points_from_json(json, node, "stroke", pixels, &out->count, &dimension, problem);
    if (status == BAT_OK && dimension != 2)
        status = bat_json_complain(json, node, BAT_DIMENSION, "stroke", "points of 2 numbers", problem);
    out->pixels = *pixels;
    return status;
}

static bat_status read_locks(const bat_json *json, bat_line_edit *out, bat_problem *problem) {
    const uint32_t list = bat_json_member(json, 1, "locks");
    uint32_t node = bat_json_first(json, list);
    if (!list) return BAT_OK;
    bool good = bat_json_count(json, list) == BAT_LINE_EDGES;
    for (int k = 0; k < BAT_LINE_EDGES && good; k++, node = json->nodes[node].next) {
        const double value = bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number
                                                                             : -1;
        good = value >= 0 && value <= BAT_LOCK_MOST && value == floor(value);
        if (good) out->lock[k] = (int)value;
    }
    return good ? BAT_OK
                : bat_json_complain(json, list, BAT_ARGUMENT, "locks", "four whole numbers from 0 to 3",
                                    problem);
}

bat_status bat_line_edit_read(const bat_json *json, bat_line_edit *out, double **pixels,
                              bat_problem *problem) {
    static const double none = 0;
    double object = 0, level = 0;
    int direction = -1;
    *out = (bat_line_edit){.object = 0};
    *pixels = NULL;
    bat_status status = bat_edit_number(json, 1, "object", 1, (double)BAT_ID_MAX, NULL, &object, problem);
    out->object = (bat_id)object;
    if (status == BAT_OK)
        status = bat_word_from_json(json, 1, "direction", DIRECTIONS, "\"u\" or \"v\"", &direction, problem);
    if (status == BAT_OK && direction < 0)
        status = bat_json_complain(json, 1, BAT_SYNTAX, "direction", "\"u\" or \"v\"", problem);
    out->direction = direction == 1 ? BAT_V : BAT_U;
    if (status == BAT_OK)
        status = bat_edit_number(json, 1, "at", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, NULL, &out->at,
                                 problem);
    if (status == BAT_OK)
        status = bat_edit_number(json, 1, "tolerance", 1e-12, 1e12, NULL, &out->tolerance, problem);
    if (status == BAT_OK)
        status = bat_edit_number(json, 1, "reach", 0, BAT_COORDINATE_MAX, &none, &out->reach, problem);
    if (status == BAT_OK)
        status = bat_edit_number(json, 1, "level", 0, BAT_RELIEF_LEVELS, &none, &level, problem);
    out->level = (int)level;
    if (status == BAT_OK) status = read_locks(json, out, problem);
    const uint32_t along = bat_json_member(json, 1, "along");
    if (status == BAT_OK && along)
        status = bat_vector_from_json(json, along, "along", 3, out->along, problem);
    if (status == BAT_OK) status = bat_mirror_read(json, 1, &out->mirror, problem);
    if (status == BAT_OK)
        status = bat_viewpoint_from_json(json, bat_json_member(json, 1, "view"), &out->seen, problem);
    return status == BAT_OK ? read_stroke(json, out, pixels, problem) : status;
}
