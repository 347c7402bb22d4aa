/*
 * A motion and its frames as JSON: {"joints":[{"name":"Hips", "parent":i, "offset":[x,y,z], "end":true, "channels":["Xposition",
 * ...], "orientation":ORIENTATION}, ...], "path":SHAPE, "onto":CURVE, "levels":N, "frame_time":seconds, "frames":count,
 * "values":[numbers of all frames]}. A joint that turns has an orientation; a root that moves has a path, and where it was bent
 * the curve that it goes along.
 */
#include "format/json/camera.h"
#include "format/json/curve.h"
#include "format/json/fields.h"
#include "format/json/motion.h"
#include "format/json/shape.h"

#include "form/motion/motion.h"

#include <stdlib.h>
#include <string.h>

enum { CHANNELS = 6, LEVELS_MOST = 12 };
static const char *const NAMES[CHANNELS] = {"Xposition", "Yposition", "Zposition",
                                            "Xrotation", "Yrotation", "Zrotation"};
static const char CHANNEL[] = "Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation, each once";

/* ---- written ---- */

static void put_joint(const bat_motion *motion, int index, bat_text *text) {
    const bat_bone *joint = &motion->take->joints[index];
    bat_text_string(text, "{\"name\":");
    bat_text_json_string(text, joint->name);
    if (joint->parent >= 0) {
        bat_text_string(text, ",\"parent\":");
        bat_text_integer(text, (uint64_t)joint->parent);
    }
    bat_text_string(text, ",\"offset\":");
    bat_numbers_to_json(joint->offset, 3, text);
    if (joint->end) bat_text_string(text, ",\"end\":true");
    for (int k = 0; k < joint->channel_count; k++) {
        bat_text_string(text, k ? ",\"" : ",\"channels\":[\"");
        bat_text_string(text, NAMES[joint->channels[k]]);
        bat_text_string(text, "\"");
    }
    if (joint->channel_count) bat_text_string(text, "]");
    if (motion->joints[index]) {
        bat_text_string(text, ",\n    \"orientation\":");
        bat_orientation_to_json(motion->joints[index], text);
    }
    bat_text_string(text, "}");
}

void bat_motion_to_json(const bat_motion *motion, bat_text *text) {
    const bat_take *take = motion->take;
    bat_text_string(text, "{\"joints\":[");
    for (int i = 0; i < take->joint_count; i++) {
        bat_text_string(text, i > 0 ? ",\n   " : "\n   ");
        put_joint(motion, i, text);
    }
    bat_text_string(text, "]");
    if (motion->first) {
        bat_text_string(text, ",\n   \"path\":");
        bat_shape_to_json(motion->first, text);
    }
    if (motion->bent) {
        bat_text_string(text, ",\n   \"onto\":");
        bat_curve_to_json(bat_shape_curve(motion->bent, 0), 0, text);
    }
    bat_text_string(text, ",\n   \"levels\":");
    bat_text_integer(text, (uint64_t)motion->levels);
    bat_text_string(text, ",\"frame_time\":");
    bat_text_number(text, take->frame_time);
    bat_text_string(text, ",\"frames\":");
    bat_text_integer(text, take->frames);
    bat_text_string(text, ",\"values\":");
    bat_numbers_to_json(take->values, take->frames * take->channels, text);
    bat_text_string(text, "}");
}

/* ---- read ---- */

static bat_status read_channels(const bat_fields *f, uint32_t node, bat_bone *joint) {
    const uint32_t list = bat_json_member(f->json, node, "channels");
    if (!list) return BAT_OK;
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST || bat_json_count(f->json, list) > CHANNELS)
        return bat_fields_complain(f, list, "channels", "a list of six words at most");
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        const char *word = bat_json_text(f->json, at);
        int k = 0;
        while (k < CHANNELS && (!word || strcmp(word, NAMES[k]) != 0)) k++;
        for (int i = 0; i < joint->channel_count && k < CHANNELS; i++)
            if ((int)joint->channels[i] == k) k = CHANNELS;
        if (k == CHANNELS) return bat_fields_complain(f, at, "channels", CHANNEL);
        joint->channels[joint->channel_count++] = (bat_channel)k;
    }
    return BAT_OK;
}

static bat_status read_joint(const bat_fields *f, uint32_t node, int index, const bat_bone *before,
                             bat_bone *out) {
    double parent = -1;
    const uint32_t name = bat_json_member(f->json, node, "name"),
                   above = bat_json_member(f->json, node, "parent");
    *out = (bat_bone){.name = bat_json_text(f->json, name), .parent = -1};
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "joints", "objects");
    if (!out->name) return bat_fields_complain(f, name ? name : node, "name", "a text");
    if (index > 0 && !above) return bat_fields_complain(f, node, "parent", "the number of an earlier joint");
    bat_status status = bat_fields_number(f, node, "parent", 0, index - 1, "the number of an earlier joint",
                                          &parent);
    out->parent = (int)parent;
    if (status == BAT_OK && (out->parent != parent || (index > 0 && before[out->parent].end)))
        status = bat_fields_complain(f, above, "parent", "the number of an earlier joint that is no end");
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "offset", 3, "three numbers", out->offset);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "end", &out->end);
    if (status == BAT_OK) status = read_channels(f, node, out);
    if (status == BAT_OK && out->end && out->channel_count)
        status = bat_fields_complain(f, node, "end", "a joint without channels");
    return status;
}

/* The joints, and the numbers of their frames. */
static bat_status read_take(const bat_fields *f, uint32_t node, bat_take **out) {
    const uint32_t list = bat_json_member(f->json, node, "joints"),
                   numbers = bat_json_member(f->json, node, "values");
    const uint32_t count = bat_json_count(f->json, list);
    double frames = 0, time = 0, *values = NULL;
    size_t found = 0, channels = 0;
    if (count < 1 || count > BAT_JOINTS_MAX)
        return bat_fields_complain(f, list ? list : node, "joints", "a list of 1 to 10000 objects");
    bat_bone *joints = calloc(count, sizeof *joints);
    bat_status status = BAT_OK;
    int i = 0;
    if (!joints) return bat_fields_say(f, node, BAT_MEMORY);
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next) {
        status = read_joint(f, at, i, joints, &joints[i]);
        channels += (size_t)joints[i++].channel_count;
    }
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "frame_time", 0, 1e9, "seconds above 0, up to 1e9", &time);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "frames", 1, BAT_POINTS_MAX, "how many frames there are",
                                   &frames);
    if (status == BAT_OK && !(time > 0))
        status = bat_fields_complain(f, node, "frame_time", "seconds above 0, up to 1e9");
    if (status == BAT_OK && numbers)
        status = bat_numbers_from_json(f->json, numbers, "values", &values, &found, f->problem);
    if (status == BAT_OK && (double)found != frames * (double)channels)
        status = bat_fields_complain(f, numbers ? numbers : node, "values",
                                     "a number for each channel of each frame");
    if (status == BAT_OK)
        status = bat_fields_say(f, node,
                                bat_take_create((int)count, joints, (size_t)frames, time, values, out));
    free(joints), free(values);
    return status;
}

static bat_status still_path(double last, bat_curve **out) {
    const double still[4] = {0, 0, 0, 0}, ends[4] = {0, 0, last, last};
    return bat_curve_create(2, 1, false, 2, still, 4, ends, out);
}

static bat_status read_turns(const bat_fields *f, uint32_t node, const bat_take *take, bat_camera **joints) {
    const double last = take->frames > 1 ? (double)(take->frames - 1) : 1;
    const double duration = take->frame_time * last < 1e9 ? take->frame_time * last : 1e9;
    bat_curve *path = NULL;
    bat_status status = still_path(last, &path);
    int i = 0;
    for (uint32_t at = bat_json_first(f->json, bat_json_member(f->json, node, "joints"));
         at && status == BAT_OK; at = f->json->nodes[at].next, i++) {
        const uint32_t turns = bat_json_member(f->json, at, "orientation");
        if ((turns != 0) != (bat_bone_turns(&take->joints[i]) > 0))
            status = bat_fields_complain(f, turns ? turns : at, "orientation",
                                         turns ? "none, since it does not turn"
                                               : "an object, since it turns");
        else if (turns)
            status = bat_camera_from_orientation(f->json, turns, path, duration, &joints[i], f->problem);
    }
    bat_curve_free(path);
    return status == BAT_MEMORY ? bat_fields_say(f, node, status) : status;
}

static bat_status read_way(const bat_fields *f, uint32_t node, bat_shape **path, bat_curve **onto) {
    const uint32_t way = bat_json_member(f->json, node, "path"),
                   bent = bat_json_member(f->json, node, "onto");
    bat_status status = way ? bat_shape_from_json(f->json, way, path, f->problem) : BAT_OK;
    if (status == BAT_OK && bent) status = bat_curve_from_json(f->json, bent, onto, f->problem);
    if (status == BAT_OK && *path && bat_curve_dimension(bat_shape_curve(*path, 0)) != 3)
        status = bat_fields_complain(f, way, "path", "a shape in space");
    return status;
}

bat_status bat_motion_from_json(const bat_json *json, uint32_t node, bat_motion **out, bat_problem *problem) {
    const bat_fields f = {.json = json, .problem = problem};
    bat_take *take = NULL;
    bat_shape *path = NULL;
    bat_curve *onto = NULL;
    bat_camera **joints = NULL;
    double levels = 0;
    int count = 0;
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(&f, node ? node : 1, "motion", "an object");
    bat_status status = bat_fields_number(&f, node, "levels", 0, LEVELS_MOST, "0 to 12", &levels);
    if (status == BAT_OK && levels != (int)levels)
        status = bat_fields_complain(&f, bat_json_member(json, node, "levels"), "levels", "a whole number");
    if (status == BAT_OK) status = read_take(&f, node, &take);
    if (take) {
        count = take->joint_count; /* 1 to BAT_JOINTS_MAX */
        joints = calloc((size_t)(unsigned)count, sizeof *joints);
        status = joints ? read_turns(&f, node, take, joints) : bat_fields_say(&f, node, BAT_MEMORY);
    }
    if (status == BAT_OK) status = read_way(&f, node, &path, &onto);
    if (status == BAT_OK) {
        status = bat_motion_assemble(take, (int)levels, joints, path, onto, out);
        if (status == BAT_ARGUMENT || status == BAT_UNSUPPORTED)
            bat_fields_complain(&f, node, "motion",
                                "free orientations, and a path where the root has places");
        else
            bat_fields_say(&f, node, status);
    } else {
        for (int i = 0; i < count && joints; i++) bat_camera_free(joints[i]);
        bat_shape_free(path);
    }
    bat_curve_free(onto);
    free(joints);
    bat_take_free(take);
    return status;
}
