/*
 * SHAPE and EDITS as JSON:
 *   SHAPE {"base":CURVE, "levels":[{"knots":[...], "details":[[a,b,c],...], "gain":1, "muted":false,
 *          "source":[...]}, ...],
 *          "frame":"rmf", "nodes":"greville", "propagation":"local", "first":{"t":[...],"s":[...]}}
 *   EDITS [{"type":"move","level":j,"index":i,"delta":[...]}, ...]
 */
#include "format/json/curve.h"
#include "format/json/word.h"
#include "curve/curve.h"
#include "format/json/stroke.h"

#include "format/json/shape.h"
#include "hands/levels/shape.h"
#include "text/number.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is(const bat_json *json, uint32_t node, bat_json_type type) {
    return bat_json_type_of(json, node) == type;
}

static const char *const FRAMES[] = {"rmf", "frenet", "fixed", NULL};
static const char *const NODES[] = {"greville", "argmax", NULL};
static const char *const PROPAGATION[] = {"local", "plain", NULL};

/* ---- SHAPE ---- */

static bat_status read_first(const bat_json *json, uint32_t object, bat_shape_options *options,
                             bat_problem *problem) {
    if (!object) return BAT_OK;
    uint32_t t = bat_json_member(json, object, "t"), s = bat_json_member(json, object, "s");
    if (!s)
        return bat_json_complain(json, object, BAT_SYNTAX, "first", "an object with \"s\", and \"t\" or not",
                                 problem);
    double *to = t ? options->reference_s : options->first;
    bat_status status = bat_vector_from_json(json, s, "first.s", 3, to, problem);
    if (status == BAT_OK && t)
        status = bat_vector_from_json(json, t, "first.t", 3, options->reference_t, problem);
    options->has_reference = t != 0;
    options->has_first = t == 0;
    return status;
}

static bat_status read_options(const bat_json *json, uint32_t object, bat_shape_options *options,
                               bat_problem *problem) {
    int frame = 0, nodes = 0, propagation = 0;
    bat_status status = bat_word_from_json(json, object, "frame", FRAMES, "\"rmf\", \"frenet\" or \"fixed\"",
                                           &frame, problem);
    if (status == BAT_OK)
        status = bat_word_from_json(json, object, "nodes", NODES, "\"greville\" or \"argmax\"", &nodes,
                                    problem);
    if (status == BAT_OK)
        status = bat_word_from_json(json, object, "propagation", PROPAGATION, "\"local\" or \"plain\"",
                                    &propagation, problem);
    *options = bat_shape_defaults();
    options->frame = (bat_frame_rule)frame;
    options->nodes = (bat_node_rule)nodes;
    options->propagation = (bat_propagation)propagation;
    if (status == BAT_OK) status = read_first(json, bat_json_member(json, object, "first"), options, problem);
    return status;
}

/* Details: lists of 2 or 3 numbers; a missing third number is zero. */
static bat_status read_details(const bat_json *json, uint32_t list, double **out, size_t *count,
                               bat_problem *problem) {
    double *raw;
    int size;
    bat_status status = bat_points_from_json(json, list, "details", &raw, count, &size, problem);
    if (status != BAT_OK) return status;
    *out = calloc(3 * *count + 1, sizeof **out);
    if (*out)
        for (size_t i = 0; i < *count; i++)
            memcpy(*out + 3 * i, raw + i * (size_t)size, (size_t)size * sizeof **out);
    free(raw);
    return *out ? BAT_OK : bat_json_say(json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), problem);
}

static bat_status read_source(const bat_json *json, uint32_t list, size_t count, int level, int **out,
                              bat_problem *problem) {
    double *numbers;
    size_t found;
    bat_status status = bat_numbers_from_json(json, list, "source", &numbers, &found, problem);
    if (status != BAT_OK) return status;
    *out = malloc((found + 1) * sizeof **out);
    if (!*out) status = BAT_MEMORY;
    if (status == BAT_OK && found != count)
        status = bat_json_complain(json, list, BAT_COUNT, "source", "one a detail", problem);
    for (size_t i = 0; i < found && status == BAT_OK; i++) {
        if (!(numbers[i] >= 0 && numbers[i] < level))
            status = bat_json_complain(json, list, BAT_ARGUMENT, "source", "levels below this one", problem);
        else
            (*out)[i] = (int)numbers[i];
    }
    free(numbers);
    if (status != BAT_OK) {
        free(*out);
        *out = NULL;
    }
    return status;
}

static bat_status read_level(const bat_json *json, uint32_t object, bat_shape *shape, bat_problem *problem) {
    double *knots = NULL, *details = NULL;
    int *source = NULL, level = bat_shape_levels(shape) + 1;
    size_t knot_count = 0, detail_count = 0;
    const bat_curve *below = bat_shape_curve(shape, level - 1);
    if (!is(json, object, BAT_JSON_OBJECT))
        return bat_json_complain(json, object, BAT_SYNTAX, "level", "an object", problem);
    uint32_t knot_list = bat_json_member(json, object, "knots"),
             detail_list = bat_json_member(json, object, "details"),
             source_list = bat_json_member(json, object, "source"),
             gain = bat_json_member(json, object, "gain"), muted = bat_json_member(json, object, "muted");
    bat_status status = BAT_OK;
    if (knot_list) status = bat_numbers_from_json(json, knot_list, "knots", &knots, &knot_count, problem);
    if (status == BAT_OK && knot_count > BAT_POINTS_MAX)
        status = bat_json_complain(json, knot_list, BAT_COUNT, "knots", "fewer", problem);
    if (status == BAT_OK && detail_list)
        status = read_details(json, detail_list, &details, &detail_count, problem);
    if (status == BAT_OK && details && knots) {
        size_t points = knot_count - (bat_curve_is_closed(below) ? 1 : (size_t)bat_curve_degree(below) + 1);
        if (points != detail_count)
            status = bat_json_complain(json, detail_list, BAT_COUNT, "details",
                                       "one a control point of the level's knots", problem);
    } else if (status == BAT_OK && details) {
        status = bat_json_complain(json, object, BAT_SYNTAX, "knots", "a list of numbers beside the details",
                                   problem);
    }
    if (status == BAT_OK && source_list)
        status = read_source(json, source_list, detail_count, level, &source, problem);
    if (status == BAT_OK) {
        status = bat_shape_add_level(shape, (int)knot_count, knots, details, source);
        if (status == BAT_KNOTS)
            bat_json_complain(json, knot_list, status, "knots", "all the knots of the level below, and more",
                              problem);
        else if (status != BAT_OK)
            bat_json_say(json, object, status, bat_status_message(status), problem);
    }
    if (status == BAT_OK && gain) {
        if (!is(json, gain, BAT_JSON_NUMBER) ||
            bat_shape_set_gain(shape, level, json->nodes[gain].value.number) != BAT_OK)
            status = bat_json_complain(json, gain, BAT_NUMBER, "gain", "a number within 1e6", problem);
    }
    if (status == BAT_OK && muted) {
        if (!is(json, muted, BAT_JSON_TRUE) && !is(json, muted, BAT_JSON_FALSE))
            status = bat_json_complain(json, muted, BAT_SYNTAX, "muted", "true or false", problem);
        else if (is(json, muted, BAT_JSON_TRUE))
            status = bat_shape_set_muted(shape, level, true);
    }
    free(knots);
    free(details);
    free(source);
    return status;
}

bat_status bat_shape_from_json(const bat_json *json, uint32_t node, bat_shape **out, bat_problem *problem) {
    if (!is(json, node, BAT_JSON_OBJECT))
        return bat_json_complain(json, node, BAT_SYNTAX, "shape", "an object", problem);
    uint32_t inner = bat_json_member(json, node, "shape"),
             top = inner ? inner : node; /* as printed by `levels` */
    uint32_t base_node = bat_json_member(json, top, "base"), levels = bat_json_member(json, top, "levels");
    bat_curve *base = NULL;
    bat_shape *shape = NULL;
    bat_shape_options options;
    if (!base_node) return bat_json_say(json, top, BAT_SYNTAX, "base: expected a curve, found none", problem);
    bat_status status = bat_curve_from_json(json, base_node, &base, problem);
    if (status != BAT_OK) return status;
    status = read_options(json, top, &options, problem);
    if (status == BAT_OK) {
        status = bat_shape_create(base, &options, &shape);
        if (status != BAT_OK) bat_json_say(json, top, status, bat_status_message(status), problem);
    }
    bat_curve_free(base);
    if (status == BAT_OK && levels && !is(json, levels, BAT_JSON_LIST))
        status = bat_json_complain(json, levels, BAT_SYNTAX, "levels", "a list", problem);
    for (uint32_t at = bat_json_first(json, levels); at && status == BAT_OK; at = json->nodes[at].next)
        status = read_level(json, at, shape, problem);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    *out = shape;
    return BAT_OK;
}

bat_status bat_shape_read(const char *text, size_t size, bat_shape **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_shape_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}

static void put_vectors(bat_text *text, const double *v, int count, int size, int stride) {
    bat_text_string(text, "[");
    for (int i = 0; i < count; i++) {
        bat_text_string(text, i > 0 ? ",[" : "[");
        for (int d = 0; d < size; d++) {
            if (d > 0) bat_text_string(text, ",");
            bat_text_number(text, v[i * stride + d]);
        }
        bat_text_string(text, "]");
    }
    bat_text_string(text, "]");
}

static void put_vector(bat_text *text, const double *v) {
    for (int d = 0; d < 3; d++) {
        bat_text_string(text, d > 0 ? "," : "[");
        bat_text_number(text, v[d]);
    }
    bat_text_string(text, "]");
}

static void put_level(bat_text *text, const bat_shape *shape, int level) {
    const bat_curve *curve = bat_shape_curve(shape, level);
    const int *source = bat_shape_source(shape, level);
    int count = bat_point_count(curve);
    bool usual = true;
    bat_text_string(text, "{\"knots\":[");
    for (int i = 0; i < bat_curve_knot_count(curve); i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, bat_curve_knots(curve)[i]);
    }
    bat_text_string(text, "],\n   \"details\":");
    put_vectors(text, bat_shape_details(shape, level), count, 3, 3);
    for (int i = 0; i < count; i++) usual = usual && source[i] == level - 1;
    if (!usual) {
        bat_text_string(text, ",\n   \"source\":");
        for (int i = 0; i < count; i++) {
            bat_text_string(text, i > 0 ? "," : "[");
            bat_text_integer(text, (uint64_t)source[i]);
        }
        bat_text_string(text, "]");
    }
    if (bat_shape_gain(shape, level) != 1) {
        bat_text_string(text, ",\"gain\":");
        bat_text_number(text, bat_shape_gain(shape, level));
    }
    if (bat_shape_is_muted(shape, level)) bat_text_string(text, ",\"muted\":true");
    bat_text_string(text, "}");
}

void bat_shape_to_json(const bat_shape *shape, bat_text *text) {
    if (shape->turned) { /* files store details only in the frames of the curves themselves */
        bat_shape *folded;
        text->failed = text->failed || bat_shape_copy(shape, &folded) != BAT_OK;
        if (text->failed) return;
        if (bat_shape_fold(folded, false) == BAT_OK)
            bat_shape_to_json(folded, text);
        else
            text->failed = true;
        bat_shape_free(folded);
        return;
    }
    const bat_shape_options *o = bat_shape_options_of(shape);
    bat_text_string(text, "{\"base\":");
    bat_curve_to_json(bat_shape_curve(shape, 0), 2, text);
    bat_text_string(text, ",\n \"levels\":[");
    for (int l = 1; l <= bat_shape_levels(shape); l++) {
        bat_text_string(text, l > 1 ? ",\n  " : "\n  ");
        put_level(text, shape, l);
    }
    bat_text_string(text, "],\n \"frame\":");
    bat_text_json_string(text, FRAMES[o->frame]);
    bat_text_string(text, ",\"nodes\":");
    bat_text_json_string(text, NODES[o->nodes]);
    bat_text_string(text, ",\"propagation\":");
    bat_text_json_string(text, PROPAGATION[o->propagation]);
    bat_text_string(text, ",\"first\":{");
    if (o->has_reference) {
        bat_text_string(text, "\"t\":");
        put_vector(text, o->reference_t);
        bat_text_string(text, ",");
    }
    bat_text_string(text, "\"s\":");
    put_vector(text, o->has_reference ? o->reference_s : o->first);
    bat_text_string(text, "}}");
}

bat_status bat_shape_write(const bat_shape *shape, char **text, size_t *size) {
    if (!shape || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_shape_to_json(shape, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}

/* ---- EDITS ---- */

typedef enum edit_type { EDIT_MOVE, EDIT_DRAG, EDIT_GAIN, EDIT_SKETCH, EDIT_TRANSFORM } edit_type;
static const char *const EDITS[] = {"move", "drag", "gain", "sketch", "transform", NULL};

static bat_status read_number(const bat_json *json, uint32_t object, const char *name, double *out,
                              bat_problem *problem) {
    uint32_t node = bat_json_member(json, object, name);
    if (!is(json, node, BAT_JSON_NUMBER))
        return bat_json_complain(json, node ? node : object, BAT_SYNTAX, name, "a number", problem);
    *out = json->nodes[node].value.number;
    return BAT_OK;
}

/* A whole number from 0 to most. */
static bat_status read_index(const bat_json *json, uint32_t object, const char *name, int most, int *out,
                             bat_problem *problem) {
    double number = 0;
    bat_status status = read_number(json, object, name, &number, problem);
    if (status != BAT_OK) return status;
    if (!(number >= 0 && number <= most) || number != (int)number)
        return bat_json_complain(
            json, bat_json_member(json, object, name), BAT_ARGUMENT, name,
            strcmp(name, "level") == 0 ? "a level of the shape" : "a control point of the level", problem);
    *out = (int)number;
    return BAT_OK;
}

static bat_status read_matrix(const bat_json *json, uint32_t object, int dimension, double *matrix,
                              bat_problem *problem) {
    uint32_t node = bat_json_member(json, object, "matrix");
    double rows[12];
    int i = 0;
    if (bat_json_count(json, node) != 3)
        return bat_json_complain(json, node ? node : object, BAT_SYNTAX, "matrix", "3 rows of 4 numbers",
                                 problem);
    for (uint32_t row = bat_json_first(json, node); row; row = json->nodes[row].next) {
        if (bat_json_count(json, row) != 4)
            return bat_json_complain(json, row, BAT_SYNTAX, "matrix", "3 rows of 4 numbers", problem);
        for (uint32_t at = bat_json_first(json, row); at; at = json->nodes[at].next) {
            if (!is(json, at, BAT_JSON_NUMBER))
                return bat_json_complain(json, at, BAT_SYNTAX, "matrix", "a number", problem);
            rows[i++] = json->nodes[at].value.number;
        }
    }
    const double planar[6] = {rows[0], rows[1], rows[3], rows[4], rows[5], rows[7]};
    memcpy(matrix, dimension == 2 ? planar : rows, (dimension == 2 ? 6 : 12) * sizeof(double));
    return BAT_OK;
}

/* A sketch that is too short for its level: the first such edit. */
typedef struct short_sketch {
    uint32_t edit; /* 0: there was none */
    int level;
    bat_sketch_report report;
} short_sketch;

static bat_status sketch(const bat_json *json, uint32_t object, bat_shape *shape, int level,
                         short_sketch *told, bat_problem *problem) {
    bat_stroke stroke;
    void *block;
    bat_sketch_report report;
    bat_status status = bat_stroke_from_json(json, bat_json_member(json, object, "stroke"), &stroke, &block,
                                             problem);
    if (status != BAT_OK) return status;
    status = bat_shape_redraw_level(shape, level, &stroke, NULL, &report);
    bat_free(block);
    if (status != BAT_OK) return bat_json_say(json, object, status, bat_status_message(status), problem);
    if (!told->edit && report.spans < BAT_LEVEL_SPANS_LEAST && report.max_error > bat_sketch_defaults().pixel)
        *told = (short_sketch){object, level, report};
    return BAT_OK;
}

static bat_status say_short(const bat_json *json, const short_sketch *told, bat_problem *problem) {
    char spans[BAT_NUMBER_ROOM], miss[BAT_NUMBER_ROOM], message[sizeof problem->message];
    if (!told->edit) return bat_problem_set(problem, BAT_OK, "", "");
    bat_number_print(round(10 * told->report.spans) / 10, spans);
    bat_number_print(round(10 * told->report.max_error) / 10, miss);
    snprintf(message, sizeof message,
             "the stroke is short for level %d (%s of its spans): it is missed by %s", told->level, spans,
             miss);
    return bat_json_say(json, told->edit, BAT_OK, message, problem);
}

/* The parameters listed under a name, BAT_HELD_MAX at most; none when it is left out. */
static bat_status read_parameters(const bat_json *json, uint32_t hold, const char *name, double *out,
                                  size_t *count, bat_problem *problem) {
    uint32_t list = bat_json_member(json, hold, name);
    *count = 0;
    if (!list) return BAT_OK;
    if (is(json, list, BAT_JSON_LIST) && bat_json_count(json, list) <= BAT_HELD_MAX)
        for (uint32_t at = bat_json_first(json, list); at && is(json, at, BAT_JSON_NUMBER);
             at = json->nodes[at].next)
            out[(*count)++] = json->nodes[at].value.number;
    return is(json, list, BAT_JSON_LIST) && *count == bat_json_count(json, list)
               ? BAT_OK
               : bat_json_complain(json, list, BAT_SYNTAX, name, "a list of at most 8 parameters", problem);
}

/* A control point that is moved (index 0 or above), or the level's curve that is dragged; with what is held, the finest one. */
static bat_status pull(const bat_json *json, uint32_t object, bat_shape *shape, int level, int index,
                       bat_problem *problem) {
    double delta[BAT_DIMENSION_MAX], u = 0, points[BAT_HELD_MAX], directions[BAT_HELD_MAX];
    bat_shape_held held = {.points = points, .directions = directions};
    const int dimension = bat_curve_dimension(bat_shape_curve(shape, level));
    const uint32_t hold = bat_json_member(json, object, "hold");
    bat_status status = index < 0 ? read_number(json, object, "u", &u, problem) : BAT_OK;
    if (status == BAT_OK)
        status = bat_vector_from_json(json, bat_json_member(json, object, "delta"), "delta", dimension, delta,
                                      problem);
    if (status == BAT_OK && hold && !is(json, hold, BAT_JSON_OBJECT))
        status = bat_json_complain(json, hold, BAT_SYNTAX, "hold", "an object", problem);
    if (status == BAT_OK) status = read_parameters(json, hold, "points", points, &held.point_count, problem);
    if (status == BAT_OK)
        status = read_parameters(json, hold, "directions", directions, &held.direction_count, problem);
    if (status != BAT_OK) return status;
    held.length = is(json, bat_json_member(json, hold, "length"), BAT_JSON_TRUE);
    held.area = is(json, bat_json_member(json, hold, "area"), BAT_JSON_TRUE);
    held.symmetry = is(json, bat_json_member(json, hold, "symmetry"), BAT_JSON_TRUE);
    if (index >= 0)
        status = hold ? bat_shape_move_held(shape, level, index, delta, &held)
                      : bat_shape_move(shape, level, index, delta);
    else
        status = hold ? bat_shape_drag_held(shape, level, u, delta, &held)
                      : bat_shape_drag(shape, level, u, delta);
    return status == BAT_OK ? BAT_OK
                            : bat_json_say(json, object, status, bat_status_message(status), problem);
}

static bat_status apply(const bat_json *json, uint32_t object, bat_shape *shape, short_sketch *told,
                        bat_problem *problem) {
    int type = -1, level = 0, index = 0, dimension = bat_curve_dimension(bat_shape_curve(shape, 0));
    double value[12];
    if (!is(json, object, BAT_JSON_OBJECT))
        return bat_json_complain(json, object, BAT_SYNTAX, "edit", "an object", problem);
    const char *expected = "\"move\", \"drag\", \"gain\", \"sketch\" or \"transform\"";
    bat_status status = bat_word_from_json(json, object, "type", EDITS, expected, &type, problem);
    if (status == BAT_OK && type < 0)
        status = bat_json_complain(json, object, BAT_SYNTAX, "type", expected, problem);
    if (status == BAT_OK && type != EDIT_TRANSFORM)
        status = read_index(json, object, "level", bat_shape_levels(shape), &level, problem);
    if (status != BAT_OK) return status;
    const bat_curve *curve = bat_shape_curve(shape, level);
    switch ((edit_type)type) {
    case EDIT_MOVE:
        status = read_index(json, object, "index", bat_point_count(curve) - 1, &index, problem);
        if (status == BAT_OK) status = pull(json, object, shape, level, index, problem);
        if (status != BAT_OK) return status;
        break;
    case EDIT_DRAG:
        status = pull(json, object, shape, level, -1, problem);
        if (status != BAT_OK) return status;
        break;
    case EDIT_GAIN:
        status = read_number(json, object, "value", value, problem);
        if (status != BAT_OK) return status;
        status = bat_shape_set_gain(shape, level, value[0]);
        break;
    case EDIT_SKETCH:
        status = sketch(json, object, shape, level, told, problem);
        if (status != BAT_OK) return status;
        break;
    case EDIT_TRANSFORM:
        status = read_matrix(json, object, dimension, value, problem);
        if (status != BAT_OK) return status;
        status = bat_shape_transform(shape, value);
        break;
    }
    if (status == BAT_OK) status = bat_shape_commit(shape);
    return status == BAT_OK ? BAT_OK
                            : bat_json_say(json, object, status, bat_status_message(status), problem);
}

bat_status bat_shape_edit(bat_shape *shape, const char *text, size_t size, bat_problem *problem) {
    if (!shape || !text) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    bat_shape *edited = NULL;
    short_sketch told = {0};
    if (!is(&json, 1, BAT_JSON_LIST))
        status = bat_json_complain(&json, 1, BAT_SYNTAX, "edits", "a list", problem);
    if (status == BAT_OK) status = bat_shape_copy(shape, &edited);
    for (uint32_t at = bat_json_first(&json, 1); at && status == BAT_OK; at = json.nodes[at].next)
        status = apply(&json, at, edited, &told, problem);
    if (status == BAT_OK) say_short(&json, &told, problem);
    bat_json_free(&json);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}
