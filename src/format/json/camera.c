/*
 * MOVE as JSON: {"path":CURVE or SHAPE, "orientation":{"mode":"free"|"along"|"look-at", "base":QCURVE, "first":{"s":..},
 * "target":[x,y,z] or CURVE, "up":[x,y,z], "levels":[{"knots":[..], "details":[..], "gain":1, "shake":{"seed":n,
 * "amount":radians, "rate":a second}}, ..]}, "fov":FUNCTION, "timing":{"duration":seconds, "curve":FUNCTION}}.
 */
#include "format/json/camera.h"

#include "base/real.h"
#include "form/camera/camera.h"
#include "format/json/curve.h"
#include "format/json/function.h"
#include "format/json/shape.h"
#include "format/json/word.h"

#include <batten/format.h>
#include <math.h>
#include <stdlib.h>

static const double SHAKES = 4096; /* the most vectors that are drawn for a level of a file */
static const char *const MODES[] = {"free", "along", "look-at", NULL};

/* What has been read of a move, besides the levels. */
typedef struct move {
    bat_curve *path, *target;
    double *knots, *points, *weights; /* of the base */
    bat_rotation_curve base;
    bat_camera_options options;
    uint32_t node, orientation;
} move;

static void clear(move *m) {
    bat_curve_free(m->path), bat_curve_free(m->target);
    free(m->knots), free(m->points), free(m->weights);
    bat_function_clear(&m->options.fov), bat_function_clear(&m->options.timing);
}

static bat_status read_path(const bat_fields *f, uint32_t move_node, bat_curve **out) {
    const uint32_t node = bat_json_member(f->json, move_node, "path");
    if (!node) return bat_fields_complain(f, move_node, "path", "a curve, or a shape with levels");
    if (!bat_json_member(f->json, node, "base") && !bat_json_member(f->json, node, "shape"))
        return bat_curve_from_json(f->json, node, out, f->problem);
    bat_shape *shape = NULL;
    bat_status status = bat_shape_from_json(f->json, node, &shape, f->problem);
    if (status == BAT_OK) status = bat_fields_say(f, node, bat_shape_flatten(shape, out));
    bat_shape_free(shape);
    return status;
}

/* Lists of `size` numbers; *out is malloc'ed. */
static bat_status read_rows(const bat_fields *f, uint32_t list, const char *name, uint32_t size,
                            const char *expected, double **out, size_t *count) {
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST) return bat_fields_complain(f, list, name, expected);
    const uint32_t n = bat_json_count(f->json, list);
    double *rows = malloc(((size_t)n * size + 1) * sizeof *rows), *at = rows;
    bat_status status = BAT_OK;
    if (!rows) return bat_fields_say(f, list, BAT_MEMORY);
    for (uint32_t row = bat_json_first(f->json, list); row && status == BAT_OK;
         row = f->json->nodes[row].next) {
        if (bat_json_count(f->json, row) != size) status = bat_fields_complain(f, row, name, expected);
        for (uint32_t k = status == BAT_OK ? bat_json_first(f->json, row) : 0; k && status == BAT_OK;
             k = f->json->nodes[k].next) {
            if (bat_json_type_of(f->json, k) != BAT_JSON_NUMBER)
                status = bat_fields_complain(f, k, name, "a number");
            else
                *at++ = f->json->nodes[k].value.number;
        }
    }
    if (status != BAT_OK) {
        free(rows);
        return status;
    }
    *out = rows, *count = n;
    return BAT_OK;
}

static bat_status read_weights(const bat_fields *f, uint32_t node, move *m) {
    size_t count = 0;
    if (!node) return BAT_OK;
    bat_status status = bat_numbers_from_json(f->json, node, "weights", &m->weights, &count, f->problem);
    if (status == BAT_OK && count != m->base.count)
        status = bat_fields_complain(f, node, "weights", "as many numbers as there are points");
    for (size_t i = 0; i < count && status == BAT_OK; i++)
        if (!(m->weights[i] >= 1e-6 && m->weights[i] <= 1e6))
            status = bat_fields_complain(f, node, "weights", "numbers from 1e-6 to 1e6");
    m->base.weights = m->weights;
    return status;
}

static bat_status read_base(const bat_fields *f, uint32_t node, move *m) {
    const uint32_t degree = bat_json_member(f->json, node, "degree"),
                   knots = bat_json_member(f->json, node, "knots"),
                   points = bat_json_member(f->json, node, "points");
    bat_axis_text axis = {.degree_node = degree, .knot_node = knots, .point_node = points};
    if (bat_json_type_of(f->json, degree) != BAT_JSON_NUMBER)
        return bat_fields_complain(f, degree ? degree : node, "degree", "1 to 7");
    axis.degree = f->json->nodes[degree].value.number;
    if (!knots) return bat_fields_complain(f, node, "knots", "a list of numbers");
    if (!points) return bat_fields_complain(f, node, "points", "a list of quaternions, 4 numbers each");
    bat_status status = bat_fields_flag(f, node, "closed", &axis.closed);
    if (status == BAT_OK)
        status = bat_numbers_from_json(f->json, knots, "knots", &m->knots, &axis.knot_count, f->problem);
    if (status == BAT_OK)
        status = read_rows(f, points, "points", 4, "a list of quaternions, 4 numbers each", &m->points,
                           &axis.count);
    axis.knots = m->knots;
    if (status == BAT_OK) status = bat_axis_check(f->json, &axis, f->problem);
    if (status != BAT_OK) return status;
    m->base = (bat_rotation_curve){.degree = (int)axis.degree,
                                   .closed = axis.closed,
                                   .count = axis.count,
                                   .points = m->points,
                                   .knot_count = axis.knot_count,
                                   .knots = m->knots};
    status = read_weights(f, bat_json_member(f->json, node, "weights"), m);
    m->options.base = &m->base;
    return status;
}

static bat_status read_target(const bat_fields *f, uint32_t object, move *m) {
    const uint32_t node = bat_json_member(f->json, object, "target");
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_vector(f, object, "target", m->options.target);
    const bat_status status = bat_curve_from_json(f->json, node, &m->target, f->problem);
    m->options.target_curve = m->target;
    return status;
}

static bat_status read_orientation(const bat_fields *f, move *m) {
    bat_camera_options *o = &m->options;
    const uint32_t node = m->orientation;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node ? node : m->node, "orientation", "an object");
    if (!bat_json_member(f->json, node, "mode"))
        return bat_fields_complain(f, node, "mode", "\"free\", \"along\" or \"look-at\"");
    int mode = 0;
    bat_status status = bat_word_from_json(f->json, node, "mode", MODES, "\"free\", \"along\" or \"look-at\"",
                                           &mode, f->problem);
    o->mode = (bat_camera_mode)mode;
    const uint32_t base = bat_json_member(f->json, node, "base"),
                   first = bat_json_member(f->json, node, "first");
    if (status == BAT_OK && o->mode == BAT_CAMERA_FREE && !base)
        status = bat_fields_complain(f, node, "base", "a curve of quaternions");
    if (status == BAT_OK && o->mode != BAT_CAMERA_LOOK_AT && base) status = read_base(f, base, m);
    o->has_first = o->mode == BAT_CAMERA_ALONG && first;
    if (status == BAT_OK && o->has_first) status = bat_fields_vector(f, first, "s", o->first);
    if (status == BAT_OK && o->mode == BAT_CAMERA_LOOK_AT) {
        status = read_target(f, node, m);
        if (status == BAT_OK && bat_json_member(f->json, node, "up"))
            status = bat_fields_vector(f, node, "up", o->up);
    }
    return status;
}

static bat_status read_timing(const bat_fields *f, uint32_t move_node, bat_camera_options *out) {
    const uint32_t node = bat_json_member(f->json, move_node, "timing");
    if (!node) return BAT_OK;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "timing", "an object with \"duration\"");
    bat_status status = bat_fields_number(f, node, "duration", 1e-9, 1e9, "seconds above 0, up to 1e9",
                                          &out->duration);
    return status == BAT_OK ? bat_fields_function(f, node, "curve", &out->timing) : status;
}

/* What a shake is drawn from; rate 0: there is none. */
static bat_status read_shake(const bat_fields *f, uint32_t level, bat_camera_shake *out) {
    const uint32_t node = bat_json_member(f->json, level, "shake");
    double seed = -1;
    *out = (bat_camera_shake){0, -1, -1};
    if (!node) {
        out->rate = 0;
        return BAT_OK;
    }
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "shake", "an object with \"seed\", \"amount\" and \"rate\"");
    bat_status status = bat_fields_number(f, node, "seed", 0, (double)BAT_CAMERA_SEED_MAX,
                                          "a whole number from 0 to 2^53", &seed);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "amount", 1e-300, BAT_PI, "radians above 0, up to pi",
                                   &out->amount);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "rate", 1e-300, 1e300, "a number above 0", &out->rate);
    if (status != BAT_OK) return status;
    if (!(seed >= 0) || seed != floor(seed))
        return bat_fields_complain(f, node, "seed", "a whole number from 0 to 2^53");
    if (!(out->amount > 0)) return bat_fields_complain(f, node, "amount", "radians above 0, up to pi");
    if (!(out->rate > 0)) return bat_fields_complain(f, node, "rate", "a number above 0");
    out->seed = (uint64_t)seed;
    return BAT_OK;
}

/* The level as numbers. */
static bat_status read_details(const bat_fields *f, uint32_t node, bat_camera *camera) {
    double *knots = NULL, *details = NULL;
    size_t knot_count = 0, count = 0;
    const uint32_t knot_list = bat_json_member(f->json, node, "knots"),
                   detail_list = bat_json_member(f->json, node, "details");
    if (!knot_list) return bat_fields_complain(f, node, "knots", "a list of numbers");
    if (!detail_list)
        return bat_fields_complain(f, node, "details", "a list of rotation vectors, 3 numbers each");
    bat_status status = bat_numbers_from_json(f->json, knot_list, "knots", &knots, &knot_count, f->problem);
    if (status == BAT_OK)
        status = read_rows(f, detail_list, "details", 3, "a list of rotation vectors, 3 numbers each",
                           &details, &count);
    if (status == BAT_OK) {
        status = knot_count > BAT_POINTS_MAX
                     ? BAT_COUNT
                     : bat_camera_add_level(camera, (int)knot_count, knots, count, details);
        if (status == BAT_KNOTS)
            bat_json_complain(f->json, knot_list, status, "knots", "as many as the details need, ascending",
                              f->problem);
        else
            bat_fields_say(f, detail_list, status);
    }
    free(knots), free(details);
    return status;
}

/* Numbers count before what they were drawn from, which alone is enough. */
static bat_status read_level(const bat_fields *f, uint32_t node, bat_camera *camera) {
    bat_camera_shake shake;
    double gain = 1;
    bool muted = false;
    bat_status status = read_shake(f, node, &shake);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "gain", -1e6, 1e6, "a number within 1e6", &gain);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "muted", &muted);
    if (status != BAT_OK) return status;
    const bool drawn = shake.rate > 0 && !bat_json_member(f->json, node, "knots") &&
                       !bat_json_member(f->json, node, "details");
    if (!drawn)
        status = read_details(f, node, camera);
    else if (!(shake.rate * bat_camera_duration(camera) <= SHAKES))
        return bat_fields_complain(f, bat_json_member(f->json, node, "shake"), "rate",
                                   "up to 4096 vectors in all, or details");
    else
        status = bat_fields_say(f, bat_json_member(f->json, node, "shake"),
                                bat_camera_add_shake(camera, shake.seed, shake.amount, shake.rate));
    if (status != BAT_OK) return status;
    camera->level[camera->levels - 1].shake = shake;
    status = bat_camera_set_gain(camera, camera->levels, gain);
    return status == BAT_OK ? bat_camera_set_muted(camera, camera->levels, muted) : status;
}

static bat_status read_levels(const bat_fields *f, uint32_t list, bat_camera *camera) {
    if (!list) return BAT_OK;
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list, "levels", "a list");
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = read_level(f, at, camera);
    return status;
}

/* Why there is no such camera. */
static bat_status complain(const bat_fields *f, const move *m, bat_status status) {
    const uint32_t orientation = m->orientation;
    const bool looks = m->options.mode == BAT_CAMERA_LOOK_AT;
    const uint32_t up = bat_json_member(f->json, orientation, "up"),
                   timing = bat_json_member(f->json, m->node, "timing");
    switch (status) {
    case BAT_SINGULAR:
        if (!looks)
            return bat_json_say(f->json, bat_json_member(f->json, orientation, "base"), status,
                                "base: expected quaternions that do not cancel, found some that do",
                                f->problem);
        if (m->options.up[0] != 0 || m->options.up[1] != 0 || m->options.up[2] != 0)
            return bat_json_say(f->json, orientation, status,
                                "target: expected one that the path is not always at, found such a one",
                                f->problem);
        return bat_json_say(f->json, up, status, "up: expected a direction, found none", f->problem);
    case BAT_PARAMETER:
        return bat_json_say(f->json, timing, status,
                            "curve: expected values that run from 0 to 1 and never fall, found others",
                            f->problem);
    default: return bat_fields_say(f, orientation, status);
    }
}

bat_status bat_camera_from_json(const bat_json *json, uint32_t node, bat_camera **out, bat_problem *problem) {
    const bat_fields f = {.json = json, .problem = problem};
    move m = {.node = node, .options = bat_camera_defaults()};
    bat_camera *camera = NULL;
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(&f, node ? node : 1, "move", "an object");
    m.orientation = bat_json_member(json, node, "orientation");
    bat_status status = read_path(&f, node, &m.path);
    if (status == BAT_OK) status = read_orientation(&f, &m);
    if (status == BAT_OK) status = bat_fields_function(&f, node, "fov", &m.options.fov);
    if (status == BAT_OK) status = read_timing(&f, node, &m.options);
    if (status == BAT_OK) {
        status = bat_camera_create(m.path, &m.options, &camera);
        if (status != BAT_OK) complain(&f, &m, status);
    }
    if (status == BAT_OK) status = read_levels(&f, bat_json_member(json, m.orientation, "levels"), camera);
    clear(&m);
    if (status == BAT_OK)
        *out = camera;
    else
        bat_camera_free(camera);
    return status;
}

bat_status bat_camera_from_orientation(const bat_json *json, uint32_t node, const bat_curve *path,
                                       double duration, bat_camera **out, bat_problem *problem) {
    const bat_fields f = {.json = json, .problem = problem};
    move m = {.node = node, .orientation = node, .options = bat_camera_defaults()};
    bat_camera *camera = NULL;
    m.options.duration = duration;
    bat_status status = read_orientation(&f, &m);
    if (status == BAT_OK) {
        status = bat_camera_create(path, &m.options, &camera);
        if (status != BAT_OK) complain(&f, &m, status);
    }
    if (status == BAT_OK) status = read_levels(&f, bat_json_member(json, node, "levels"), camera);
    clear(&m);
    if (status == BAT_OK)
        *out = camera;
    else
        bat_camera_free(camera);
    return status;
}

bat_status bat_camera_read(const char *text, size_t size, bat_camera **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_camera_from_json(&json, 1, out, problem);
    bat_json_free(&json);
    return status;
}
