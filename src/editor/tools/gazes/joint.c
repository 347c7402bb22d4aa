#include "editor/tools/gazes/joint.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/scene/seen.h"
#include "editor/session/journal_line.h"
#include "editor/session/session.h"
#include "editor/show/body.h"
#include "editor/show/moves.h"
#include "editor/tools/gazes/state.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "form/motion/motion.h"

#include <math.h>
#include <stdlib.h>

static const double LEAST = 30, STEP = 15; /* degrees: of the graph's range, to which it is rounded */

const bat_camera *bat_turner_of(const bat_context *c, const bat_object *object) {
    const bat_motion *motion = bat_object_motion(object, NULL);
    return motion ? bat_motion_joint(motion, c->moves->joint) : bat_object_camera(object);
}

/* ---- changes ---- */

/* Takes the motion over. */
static bat_status put(const bat_object *object, bat_status status, bat_motion *motion, bat_object **out) {
    if (status == BAT_OK) status = bat_object_with_motion(object, motion, out);
    bat_motion_free(motion);
    return status;
}

bat_status bat_joint_put(const bat_context *c, const bat_object *object, const bat_camera *camera,
                         bat_object **out) {
    bat_motion *motion = NULL;
    bat_camera *copy = NULL;
    bat_status status = bat_motion_copy(bat_object_motion(object, NULL), &motion);
    if (status == BAT_OK) status = bat_camera_copy(camera, &copy);
    if (status == BAT_OK) {
        status = bat_motion_set_joint(motion, c->moves->joint, copy);
        if (status != BAT_OK) bat_camera_free(copy);
    }
    return put(object, status, motion, out);
}

bat_status bat_joint_put_path(const bat_object *object, const bat_shape *path, bat_object **out) {
    bat_motion *motion = NULL;
    bat_shape *copy = NULL;
    bat_status status = bat_motion_copy(bat_object_motion(object, NULL), &motion);
    if (status == BAT_OK) status = bat_shape_copy(path, &copy);
    if (status == BAT_OK) {
        status = bat_motion_set_path(motion, copy);
        if (status != BAT_OK) bat_shape_free(copy);
    }
    return put(object, status, motion, out);
}

/* ---- the graph ---- */

static int angles_of(const bat_motion *motion, int joint) {
    return bat_bone_turns(&motion->take->joints[joint]);
}

static int angle_of(const bat_context *c, const bat_motion *motion) {
    return (int)fmin(c->moves->angle, angles_of(motion, c->moves->joint) - 1);
}

/* The angle at even times, and the range that holds it; both as they were when a change of the strip began, so that the range stays
 * under the pen. */
static void graph_of(const bat_context *c, const bat_motion *motion, double values[BAT_GRAPH]) {
    const double duration = bat_motion_duration(motion);
    for (int i = 0; i < BAT_GRAPH; i++) {
        values[i] = 0;
        bat_motion_angle(motion, c->moves->joint, angle_of(c, motion), duration * i / (BAT_GRAPH - 1),
                         &values[i]);
    }
}

static void range_of(const double values[BAT_GRAPH], double range[2]) {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < BAT_GRAPH; i++) low = fmin(low, values[i]), high = fmax(high, values[i]);
    const double margin = fmax(STEP, 0.25 * (high - low)), lack = fmax(0, 0.5 * (LEAST - (high - low)));
    range[0] = STEP * floor((low - lack - margin) / STEP);
    range[1] = STEP * ceil((high + lack + margin) / STEP);
}

bat_status bat_joint_redrawn(const bat_context *c, const bat_object *object, int level, size_t count,
                             const double *points, bat_object **out) {
    const bat_motion *was = bat_object_motion(object, NULL);
    bat_motion *motion = NULL;
    double values[BAT_GRAPH], range[2], *stroke = malloc(2 * count * sizeof *stroke);
    if (!stroke) return BAT_MEMORY;
    graph_of(c, was, values);
    range_of(values, range);
    for (size_t i = 0; i < count; i++) {
        stroke[2 * i] = points[2 * i] * bat_motion_duration(was);
        stroke[2 * i + 1] = range[0] + (range[1] - range[0]) * points[2 * i + 1];
    }
    bat_status status = bat_motion_copy(was, &motion);
    if (status == BAT_OK)
        status = bat_motion_redraw(motion, c->moves->joint, angle_of(c, was), level, count, stroke);
    free(stroke);
    return put(object, status, motion, out);
}

/* ---- choosing ---- */

static bool turns(const bat_object *object, int joint) {
    const bat_motion *motion = bat_object_motion(object, NULL);
    return motion && bat_motion_joint(motion, joint);
}

bat_status bat_joint_choose(bat_context *c, int joint) {
    bat_moves_sync(c);
    const bat_motion *motion = bat_body_motion(c, NULL);
    if (!motion) return BAT_STATE;
    if (!bat_motion_joint(motion, joint)) return BAT_ARGUMENT;
    c->moves->joint = joint;
    c->moves->version++;
    return BAT_OK;
}

bat_status bat_joint_choose_of(bat_context *c, bat_id id, int joint) {
    const int at = bat_document_find(c->session->document, id);
    if (at < 0 || !turns(bat_document_at(c->session->document, at), joint)) return BAT_ARGUMENT;
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES))
        bat_toolbox_choose(c, bat_tool_that(BAT_CHOOSES));
    bat_selection_clear(&c->choice->selection);
    if (bat_seen_out_of_reach(c, at) || bat_selection_add(&c->choice->selection, id) != BAT_OK)
        return BAT_STATE;
    return bat_joint_choose(c, joint);
}

bat_status bat_joint_choose_angle(bat_context *c, int angle) {
    bat_moves_sync(c);
    const bat_motion *motion = bat_body_motion(c, NULL);
    if (!motion) return BAT_STATE;
    if (bat_body_chosen(c) < 0 || angle < 0 || angle >= angles_of(motion, c->moves->joint))
        return BAT_ARGUMENT;
    c->moves->angle = angle;
    c->moves->version++;
    return BAT_OK;
}

int bat_joint_near(const bat_context *c, const double pixel[2], double reach) {
    int count = 0, best = -1;
    const bat_motion *motion = bat_body_motion(c, NULL);
    double *at = motion ? bat_body_joints(c, &count) : NULL, seen[2], on[2];
    for (int i = 0; i < count && at; i++) {
        if (!bat_motion_joint(motion, i) || !bat_stage_look(c->stage, 3, at + (ptrdiff_t)3 * i, seen))
            continue;
        bat_stage_project(c->stage, seen, on);
        const double off = bat_hypot(on[0] - pixel[0], on[1] - pixel[1]);
        if (off <= reach) best = i, reach = off;
    }
    free(at);
    return best;
}

/* ---- text ---- */

static void number(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_line_number(text, value);
}

int bat_joints_of(const bat_object *object) {
    const bat_motion *motion = bat_object_motion(object, NULL);
    return motion ? motion->take->joint_count : 0;
}

/* An end has no name of its own: it is told by whose it is. */
void bat_joint_in_words(const bat_object *object, int joint, bat_text *text) {
    const bat_bone *joints = bat_object_motion(object, NULL)->take->joints;
    const bool end = joints[joint].end && !*joints[joint].name;
    bat_text_string(text, end ? joints[joints[joint].parent].name : joints[joint].name);
    if (end) bat_text_string(text, " \xe2\x80\xa2");
}

static void put_joints(const bat_motion *motion, bat_text *text) {
    bool more = false;
    bat_text_string(text, ",\"joints\":[");
    for (int i = 0; i < motion->take->joint_count; i++) {
        if (!motion->joints[i]) continue;
        number(text, more ? ",{\"id\":" : "{\"id\":", i);
        bat_text_string(text, ",\"name\":");
        bat_text_json_string(text, motion->take->joints[i].name);
        bat_text_string(text, "}");
        more = true;
    }
    bat_text_string(text, "]");
}

static void put_angles(const bat_motion *motion, int joint, bat_text *text) {
    static const char *const names[] = {"X", "Y", "Z"};
    const bat_bone *bone = &motion->take->joints[joint];
    bool more = false;
    bat_text_string(text, ",\"angles\":[");
    for (int k = 0; k < bone->channel_count; k++) {
        if (bone->channels[k] < BAT_X_ROTATION) continue;
        bat_text_string(text, more ? ",\"" : "\"");
        bat_text_string(text, names[bone->channels[k] - BAT_X_ROTATION]);
        bat_text_string(text, "\"");
        more = true;
    }
    bat_text_string(text, "]");
}

void bat_joint_rows(const bat_context *c, bat_text *text) {
    const bat_motion *motion = bat_body_motion(c, NULL), *ruled = motion;
    const bat_gazing *g = bat_gazing_of(c);
    double values[BAT_GRAPH], range[2] = {0, 1}, now = 0;
    if (!motion) return;
    put_joints(motion, text);
    number(text, ",\"joint\":", bat_body_chosen(c));
    if (bat_body_chosen(c) < 0) return;
    put_angles(motion, c->moves->joint, text);
    number(text, ",\"angle\":", angle_of(c, motion));
    if (g->fading && bat_object_motion(g->fading, NULL)) ruled = bat_object_motion(g->fading, NULL);
    graph_of(c, ruled, values);
    range_of(values, range);
    if (ruled != motion) graph_of(c, motion, values);
    bat_motion_angle(motion, c->moves->joint, angle_of(c, motion), c->moves->at, &now);
    number(text, ",\"degrees\":", now);
    number(text, ",\"range\":[", range[0]);
    number(text, ",", range[1]);
    bat_text_string(text, "],\"graph\":[");
    for (int i = 0; i < BAT_GRAPH; i++)
        number(text, i ? "," : "", (values[i] - range[0]) / (range[1] - range[0]));
    bat_text_string(text, "]");
}
