/* Motions as JSON: {"joints":[{"name","parent","offset","orientation":ORIENTATION}, ...], "path":SHAPE, "frame_time",
 * "report"}. Written, not read. */
#include "format/json/camera.h"
#include "format/json/curve.h"
#include "format/json/shape.h"

#include <batten/format.h>
#include <batten/motion.h>

#include <stdlib.h>

static void put_joint(const bat_motion *motion, const bat_bone *joint, int index, bat_text *text) {
    const bat_camera *turns = bat_motion_joint(motion, index);
    bat_text_string(text, "{\"name\":");
    bat_text_json_string(text, joint->name);
    bat_text_string(text, ",\"parent\":");
    if (joint->parent >= 0)
        bat_text_integer(text, (uint64_t)joint->parent);
    else
        bat_text_string(text, "null");
    bat_text_string(text, ",\"offset\":");
    bat_numbers_to_json(joint->offset, 3, text);
    if (joint->end) bat_text_string(text, ",\"end\":true");
    if (turns) {
        bat_text_string(text, ",\n  \"orientation\":");
        bat_orientation_to_json(turns, text);
    }
    bat_text_string(text, "}");
}

static void put_path(const bat_motion *motion, const bat_take *frames, bat_text *text) {
    if (bat_motion_path(motion)) {
        bat_shape_to_json(bat_motion_path(motion), text);
        return;
    }
    /* it stays where it is */
    double at[6];
    const double knots[4] = {0, 0, 1, 1};
    int count;
    bat_curve *curve = NULL;
    bat_shape *still = NULL;
    double *places = NULL;
    (void)bat_take_joints(frames, &count);
    places = malloc(3 * (size_t)count * sizeof *places);
    bat_status status = places ? bat_take_positions(frames, 0, places) : BAT_MEMORY;
    for (int k = 0; k < 6 && status == BAT_OK; k++) at[k] = places[k % 3];
    if (status == BAT_OK) status = bat_curve_create(3, 1, false, 2, at, 4, knots, &curve);
    if (status == BAT_OK) status = bat_shape_create(curve, NULL, &still);
    if (status == BAT_OK)
        bat_shape_to_json(still, text);
    else
        text->failed = true;
    bat_shape_free(still);
    bat_curve_free(curve);
    free(places);
}

static void put_report(const bat_motion_report *report, bat_text *text) {
    const struct {
        const char *name;
        size_t value;
    } counts[] = {{"keys_before", report->keys_before},
                  {"keys_after", report->keys_after},
                  {"numbers_before", report->numbers_before},
                  {"numbers_after", report->numbers_after}};
    bat_text_string(text, "{\"max_error\":");
    bat_text_number(text, report->max_error);
    bat_text_string(text, ",\"max_distance\":");
    bat_text_number(text, report->max_distance);
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        bat_text_string(text, ",\"");
        bat_text_string(text, counts[i].name);
        bat_text_string(text, "\":");
        bat_text_integer(text, counts[i].value);
    }
    bat_text_string(text, "}");
}

bat_status bat_motion_write(const bat_motion *motion, const bat_motion_report *report, char **text,
                            size_t *size) {
    bat_take *frames = NULL;
    int count;
    if (!motion || !report || !text || !size) return BAT_ARGUMENT;
    const bat_status status = bat_motion_sample(motion, &frames);
    if (status != BAT_OK) return status;
    const bat_bone *joints = bat_take_joints(frames, &count);
    bat_text out = {0};
    bat_text_string(&out, "{\"joints\":[");
    for (int i = 0; i < count; i++) {
        bat_text_string(&out, i > 0 ? ",\n " : "\n ");
        put_joint(motion, &joints[i], i, &out);
    }
    bat_text_string(&out, "],\n\"path\":");
    put_path(motion, frames, &out);
    bat_text_string(&out, ",\n\"frame_time\":");
    bat_text_number(&out, bat_take_frame_time(frames));
    bat_text_string(&out, ",\n\"report\":");
    put_report(report, &out);
    bat_text_string(&out, "}\n");
    bat_take_free(frames);
    return bat_text_finish(&out, text, size);
}
