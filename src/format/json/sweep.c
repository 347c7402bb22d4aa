/* SWEEP as JSON: {"path":CURVE, "profile":CURVE, "frame":"rmf", "first":{"s":[x,y,z]}, "twist":FUNCTION, "scale":FUNCTION}. */
#include "format/json/curve.h"
#include "format/json/function.h"
#include "format/json/word.h"

#include <batten/format.h>
#include <batten/format_space.h>

static const char *const FRAMES[] = {"rmf", "frenet", "fixed", NULL};

void bat_sweep_source_clear(bat_sweep_source *source) {
    if (!source) return;
    bat_curve_free(source->path), bat_curve_free(source->profile);
    bat_function_clear(&source->options.twist), bat_function_clear(&source->options.scale);
    source->path = source->profile = NULL;
}

static bat_status read_curve(const bat_fields *f, const char *name, bat_curve **out) {
    const uint32_t node = bat_json_member(f->json, 1, name);
    if (!node) return bat_fields_complain(f, 1, name, "a curve");
    return bat_curve_from_json(f->json, node, out, f->problem);
}

static bat_status read_profile(const bat_fields *f, bat_curve **out) {
    bat_status status = read_curve(f, "profile", out);
    if (status != BAT_OK || bat_curve_dimension(*out) == 2) return status;
    return bat_json_complain(f->json, bat_json_member(f->json, 1, "profile"), BAT_DIMENSION, "profile",
                             "points of 2 numbers", f->problem);
}

static bat_status read_options(const bat_fields *f, bat_sweep_options *out) {
    const uint32_t first = bat_json_member(f->json, 1, "first");
    int frame = 0;
    bat_status status = bat_word_from_json(f->json, 1, "frame", FRAMES, "\"rmf\", \"frenet\" or \"fixed\"",
                                           &frame, f->problem);
    out->frame = (bat_frame_rule)frame;
    out->has_first = first != 0;
    if (status == BAT_OK && first) status = bat_fields_vector(f, first, "s", out->first);
    if (status == BAT_OK) status = bat_fields_function(f, 1, "twist", &out->twist);
    if (status == BAT_OK) status = bat_fields_function(f, 1, "scale", &out->scale);
    return status;
}

bat_status bat_sweep_read(const char *text, size_t size, bat_sweep_source *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    const bat_fields f = {.json = &json, .problem = problem};
    bat_sweep_source source = {.path = NULL};
    bat_sweep_options_init(&source.options, sizeof source.options);
    status = bat_json_type_of(&json, 1) == BAT_JSON_OBJECT
                 ? BAT_OK
                 : bat_json_complain(&json, 1, BAT_SYNTAX, "sweep", "an object", problem);
    if (status == BAT_OK) status = read_curve(&f, "path", &source.path);
    if (status == BAT_OK) status = read_profile(&f, &source.profile);
    if (status == BAT_OK) status = read_options(&f, &source.options);
    bat_json_free(&json);
    if (status == BAT_OK)
        *out = source;
    else
        bat_sweep_source_clear(&source);
    return status;
}
