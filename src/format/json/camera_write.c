/* MOVE as JSON, written: read back, it is the same bit for bit. */
#include "format/json/camera.h"

#include "form/camera/camera.h"
#include "format/json/curve.h"
#include "format/json/function.h"

#include <batten/format.h>

static void put_vector(bat_text *text, const char *name, const double vector[3]) {
    bat_text_string(text, name);
    bat_numbers_to_json(vector, 3, text);
}

static void put_base(const bat_rotation_curve *base, bat_text *text) {
    bat_text_string(text, ",\n   \"base\":{\"degree\":");
    bat_text_integer(text, (uint64_t)base->degree);
    if (base->closed) bat_text_string(text, ",\"closed\":true");
    bat_text_string(text, ",\"knots\":");
    bat_numbers_to_json(base->knots, base->knot_count, text);
    bat_text_string(text, ",\"points\":");
    bat_points_to_json(base->points, base->count, 4, text);
    if (base->weights) {
        bat_text_string(text, ",\"weights\":");
        bat_numbers_to_json(base->weights, base->count, text);
    }
    bat_text_string(text, "}");
}

static void put_level(const bat_camera_level *level, bat_text *text) {
    const bat_curve *details = level->details;
    bat_text_string(text, "{\"knots\":");
    bat_numbers_to_json(bat_curve_knots(details), (size_t)bat_curve_knot_count(details), text);
    bat_text_string(text, ",\"details\":");
    bat_points_to_json(bat_curve_points(details), bat_curve_count(details), 3, text);
    if (level->gain != 1) {
        bat_text_string(text, ",\"gain\":");
        bat_text_number(text, level->gain);
    }
    if (level->muted) bat_text_string(text, ",\"muted\":true");
    if (level->shake.rate > 0) {
        bat_text_string(text, ",\"shake\":{\"seed\":");
        bat_text_integer(text, level->shake.seed);
        bat_text_string(text, ",\"amount\":");
        bat_text_number(text, level->shake.amount);
        bat_text_string(text, ",\"rate\":");
        bat_text_number(text, level->shake.rate);
        bat_text_string(text, "}");
    }
    bat_text_string(text, "}");
}

void bat_orientation_to_json(const bat_camera *camera, bat_text *text) {
    static const char *const modes[] = {"free", "along", "look-at"};
    const bat_camera_options *o = &camera->options;
    bat_rotation_curve base;
    bat_text_string(text, "{\"mode\":\"");
    bat_text_string(text, modes[o->mode]);
    bat_text_string(text, "\"");
    if (o->mode == BAT_CAMERA_ALONG && o->has_first) {
        put_vector(text, ",\"first\":{\"s\":", o->first);
        bat_text_string(text, "}");
    }
    if (o->mode == BAT_CAMERA_LOOK_AT) {
        if (o->target_curve) {
            bat_text_string(text, ",\"target\":");
            bat_curve_to_json(o->target_curve, 0, text);
        } else {
            put_vector(text, ",\"target\":", o->target);
        }
        put_vector(text, ",\"up\":", o->up);
    }
    if (bat_camera_base_curve(camera, &base)) put_base(&base, text);
    for (int l = 0; l < camera->levels; l++) {
        bat_text_string(text, l == 0 ? ",\n   \"levels\":[" : ",\n    ");
        put_level(&camera->level[l], text);
    }
    bat_text_string(text, camera->levels > 0 ? "]}" : "}");
}

void bat_camera_to_json(const bat_camera *camera, bat_text *text) {
    const bat_camera_options *o = &camera->options;
    bat_text_string(text, "{\"path\":");
    bat_curve_to_json(camera->given, 0, text);
    bat_text_string(text, ",\n   \"orientation\":");
    bat_orientation_to_json(camera, text);
    bat_text_string(text, ",\n   \"fov\":");
    bat_function_to_json(&o->fov, text);
    bat_text_string(text, ",\"timing\":{\"duration\":");
    bat_text_number(text, o->duration);
    if (o->timing.curve) {
        bat_text_string(text, ",\"curve\":");
        bat_function_to_json(&o->timing, text);
    }
    bat_text_string(text, "}}");
}

bat_status bat_camera_write(const bat_camera *camera, char **text, size_t *size) {
    if (!camera || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_camera_to_json(camera, &buffer);
    bat_text_string(&buffer, "\n");
    return bat_text_finish(&buffer, text, size);
}
