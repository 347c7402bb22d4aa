/*
 * IDLE --down on a handle, an edge or the path--> on --up--> IDLE: what was dragged is one step. A press on the path that does
 * not move adds a key; one that moves is handed to the chosen tool. cancel: to IDLE, nothing changed.
 */
#include "editor/tools/gazes/gazes.h"
#include "base/quat.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/moves.h"
#include "editor/tools/gazes/change.h"
#include "editor/tools/gazes/fade.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/gazes/joint.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "form/camera/camera.h"
#include "form/camera/pyramid.h"

#include <math.h>
#include <string.h>

static const double STILL = 4;    /* px that a tap may travel */
static const double ROLL = 60;    /* px across the ray that roll by a radian */
static const double SHORTEST = 8; /* px of a ray that is seen from its end: across it is then anywhere */

/* ---- what a drag makes ---- */

/* How the gaze is turned when the end of its ray is where the pen is; across the gaze of the view, so that a gaze that lies
 * in the page stays in it. */
static bool turned(const bat_context *c, const bat_gazing *g, const bat_camera_pose *pose, double out[4]) {
    double way[3];
    if (!bat_stage_way_in(c->stage, 3, (double[]){0, 0, 0}, g->base, g->start, g->at, false, way))
        return false;
    const vec from = vec_load(pose->position, 3), before = vec_sub(vec_load(g->base, 3), from);
    const vec now = vec_add(before, vec_load(way, 3));
    const double size = vec_norm(before), length = vec_norm(now);
    if (!(length > 1e-6 * size)) return false;
    const vec a = vec_scale(before, 1 / size), b = vec_scale(now, 1 / length), axis = vec_cross(a, b);
    const double sine = vec_norm(axis), angle = bat_atan2(sine, vec_dot(a, b));
    const vec about = sine > 1e-12 ? vec_scale(axis, angle / sine)
                                   : vec_scale(vec_any_normal(a), angle); /* the other way, if anything */
    quat_store(quat_mul(quat_exp(about), quat_load(pose->rotation)), out);
    return true;
}

static bool rolled(const bat_context *c, const bat_gazing *g, const bat_camera_pose *pose, double out[4]) {
    double eye[2], end[2], at[2];
    if (!bat_stage_look(c->stage, 3, pose->position, at)) return false;
    bat_stage_project(c->stage, at, eye);
    if (!bat_stage_look(c->stage, 3, g->base, at)) return false;
    bat_stage_project(c->stage, at, end);
    double x = end[0] - eye[0], y = end[1] - eye[1], length = bat_hypot(x, y);
    if (length < SHORTEST) x = 1, y = 0, length = 1;
    const double across = ((g->at[1] - g->start[1]) * x - (g->at[0] - g->start[0]) * y) / length;
    quat_store(quat_mul(quat_load(pose->rotation), quat_exp((vec){0, 0, across / ROLL})), out);
    return true;
}

/* Of the axes of space the one that is nearest to the camera's own up. */
static void up_of(const bat_camera_pose *pose, double up[3]) {
    double own[3];
    int best = 0;
    vec_store(quat_turn(quat_load(pose->rotation), (vec){0, 1, 0}), own);
    for (int k = 1; k < 3; k++)
        if (fabs(own[k]) > fabs(own[best])) best = k;
    for (int k = 0; k < 3; k++) up[k] = k == best ? (own[k] < 0 ? -1 : 1) : 0;
}

static bat_status drag_end(bat_context *c, const bat_gazing *g, const bat_camera *from, bat_camera **out) {
    bat_camera_pose pose;
    double rotation[4], place[3], up[3];
    bat_camera_at(from, g->u, &pose);
    if (c->modifiers & BAT_ALT) {
        up_of(&pose, up);
        return bat_gazing_over(c, g->at, place) ? bat_camera_aim(from, place, up, out) : BAT_STATE;
    }
    if (!(c->modifiers & BAT_SHIFT ? rolled(c, g, &pose, rotation) : turned(c, g, &pose, rotation)))
        return BAT_STATE;
    return bat_gaze_turned(from, bat_move_level(c, false), g->u, rotation, out);
}

static bat_status drag_target(bat_context *c, const bat_gazing *g, const bat_camera *from, bat_camera **out) {
    double way[3], place[3];
    if (c->modifiers & BAT_ALT) {
        if (!bat_gazing_over(c, g->at, place)) return BAT_STATE;
    } else {
        if (!bat_stage_way_in(c->stage, 3, (double[]){0, 0, 0}, g->base, g->start, g->at, false, way))
            return BAT_STATE;
        for (int k = 0; k < 3; k++) place[k] = g->base[k] + way[k];
    }
    return bat_camera_aim(from, place, from->options.up, out);
}

/* The edge goes with the pen: away from the middle of the picture is wider. */
static bat_status drag_edge(bat_context *c, const bat_gazing *g, const bat_camera *from, bat_camera **out) {
    bat_camera_pose pose;
    double at[2], middle[2], centre[3];
    bat_camera_at(from, g->u, &pose);
    const vec ahead = quat_turn(quat_load(pose.rotation), (vec){0, 0, -bat_pyramid_depth(from)});
    vec_store(vec_add(vec_load(pose.position, 3), ahead), centre);
    if (!bat_stage_look(c->stage, 3, centre, at)) return BAT_STATE;
    bat_stage_project(c->stage, at, middle);
    const double before = bat_hypot(g->start[0] - middle[0], g->start[1] - middle[1]);
    const double now = bat_hypot(g->at[0] - middle[0], g->at[1] - middle[1]);
    const double half = 0.5 * pose.fov * BAT_PI / 180;
    const double wide = bat_sin(half) / bat_cos(half) * now / fmax(before, 1);
    bat_status status = bat_camera_copy(from, out);
    if (status == BAT_OK) status = bat_camera_set_fov(*out, g->u, 2 * bat_atan2(wide, 1) * 180 / BAT_PI);
    return status;
}

static void apply(bat_context *c, bat_gazing *g) {
    const bat_camera *from = bat_object_camera(g->before);
    bat_camera *made = NULL;
    bat_object *after = NULL;
    g->due = false;
    bat_status status = g->part == BAT_GAZE_END      ? drag_end(c, g, from, &made)
                        : g->part == BAT_GAZE_TARGET ? drag_target(c, g, from, &made)
                                                     : drag_edge(c, g, from, &made);
    if (status == BAT_OK)
        status = bat_object_with_camera(g->before, made, bat_object_followed(g->before), &after);
    if (status == BAT_OK)
        status = bat_transaction_replace(c, bat_document_find(c->session->document, bat_object_id(g->before)),
                                         after);
    g->failed = status != BAT_OK && status != BAT_STATE;
    bat_camera_free(made);
    bat_object_release(after);
}

/* ---- events ---- */

bool bat_gazes_take(bat_context *c, const bat_pointer *event) {
    bat_gazing *g = bat_gazing_of(c);
    const double pixel[2] = {event->x, event->y};
    long key = -1;
    double u = 0;
    bat_moves_sync(c);
    if (bat_toolbox_tool(c) != bat_toolbox_chosen(c)) return false;
    const bat_gaze_hold part = bat_gazing_find(c, pixel, event->device, &key, &u);
    if (part == BAT_GAZE_NOTHING) {
        g->chosen = -1;
        return false;
    }
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    *g = (bat_gazing){.on = true,
                      .part = part,
                      .camera = c->moves->camera,
                      .chosen = key,
                      .key = key,
                      .u = u,
                      .start = {pixel[0], pixel[1]},
                      .at = {pixel[0], pixel[1]},
                      .pressed = *event};
    return true;
}

static void stop(bat_gazing *g) {
    bat_object_release(g->before);
    *g = (bat_gazing){.camera = g->camera, .chosen = g->chosen};
}

static void begin_drag(bat_context *c, bat_gazing *g) {
    const int at = bat_document_find(c->session->document, g->camera);
    bat_camera_pose pose;
    if (at >= 0 && g->part == BAT_GAZE_END &&
        bat_gaze_silent(c, bat_object_camera(bat_document_at(c->session->document, at)))) {
        stop(g);
        return;
    }
    bat_status status = at < 0 ? BAT_STATE : bat_transaction_begin(c);
    if (status != BAT_OK) {
        stop(g);
        bat_notice_failure(c, status);
        return;
    }
    bat_object *object = (bat_object *)bat_document_at(c->session->document, at);
    g->before = bat_object_retain(object);
    if (g->part == BAT_GAZE_END)
        bat_gazing_end(c, bat_object_camera(object), (size_t)g->key, &pose, g->base);
    else
        bat_camera_target(bat_object_camera(object), g->base);
}

/* What was pressed is the path, and the pen moves: the chosen tool does what it would have done. */
static void hand_over(bat_context *c, bat_gazing *g, const bat_pointer *event) {
    const bat_pointer pressed = g->pressed;
    stop(g);
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->down) tool->is->down(c, tool->state, &pressed);
    if (tool->is->move) tool->is->move(c, tool->state, event);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_gazing *g = state;
    if (event->predicted) return;
    g->at[0] = event->x, g->at[1] = event->y;
    if (!g->moved && bat_hypot(g->at[0] - g->start[0], g->at[1] - g->start[1]) <= STILL) return;
    if (!g->moved && (g->part == BAT_GAZE_PATH || g->part == BAT_GAZE_JOINT)) {
        hand_over(c, g, event);
        return;
    }
    if (!g->moved) begin_drag(c, g);
    if (!g->on) return;
    g->moved = g->due = true;
}

static void modifiers(bat_context *c, void *state) {
    bat_gazing *g = state;
    (void)c;
    g->due = g->before != NULL;
}

static void update(bat_context *c, void *state) {
    bat_gazing *g = state;
    if (g->on && g->due) apply(c, g);
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)state, (void)event;
    bat_notice(c, BAT_STRING_COUNT);
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_gazing *g = state;
    (void)event; /* its position has already come as a move */
    if (g->on && g->due) apply(c, g);
    const bat_gaze_hold part = g->part;
    const bool began = g->before != NULL, failed = g->failed;
    const double u = g->u;
    const int joint = (int)g->key;
    if (part == BAT_GAZE_JOINT) g->chosen = -1;
    stop(g);
    if (part == BAT_GAZE_JOINT) {
        bat_joint_choose_of(c, g->camera, joint);
    } else if (began) {
        const bat_string step = part == BAT_GAZE_EDGE ? BAT_STRING_STEP_FOV : BAT_STRING_STEP_GAZE;
        const bat_status status = bat_transaction_end(c, failed ? BAT_TOLERANCE : BAT_OK, step);
        if (status != BAT_OK) bat_notice_failure(c, status);
    } else if (part == BAT_GAZE_PATH) {
        bat_gaze_add(c, u);
    } else if (g->chosen >= 0) {
        bat_gaze_say(c, (size_t)g->chosen);
    }
}

static bool cancel(bat_context *c, void *state) {
    bat_gazing *g = state;
    const bool was = g->on;
    if (g->before) bat_transaction_cancel(c);
    stop(g);
    if (was) bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return was;
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_gazing *)state)->on;
}

static bool on(const void *state) { return ((const bat_gazing *)state)->on; }

static void begin(void *state) { ((bat_gazing *)state)->chosen = -1; }
static void end(void *state) {
    bat_object_release(((bat_gazing *)state)->before);
    bat_object_release(((bat_gazing *)state)->fading);
    bat_object_release(((bat_gazing *)state)->bending);
}

static bool held_by_panel(const void *state) { return ((const bat_gazing *)state)->fading != NULL; }
static void let_go(bat_context *c, void *state) {
    (void)state;
    bat_move_let_go(c);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)c;
    switch (((const bat_gazing *)state)->part) {
    case BAT_GAZE_EDGE: return BAT_STRING_HINT_FOV;
    case BAT_GAZE_PATH: return BAT_STRING_HINT_KEY;
    case BAT_GAZE_JOINT: return BAT_STRING_HINT_JOINT;
    case BAT_GAZE_TARGET: return BAT_STRING_HINT_TARGET;
    default: return BAT_STRING_HINT_GAZE;
    }
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)c, (void)state;
    return BAT_CURSOR_MOVE;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_gazing *g = state;
    if (bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a gaze is held without a pen";
    if (bat_document_find(c->session->document, g->camera) < 0) return "the camera that is held is gone";
    return NULL;
}

const bat_tool *bat_tool_gazes(void) {
    static const bat_tool tool = {.size = sizeof(bat_gazing),
                                  .begin = begin,
                                  .end = end,
                                  .on = on,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .held_by_panel = held_by_panel,
                                  .let_go = let_go,
                                  .update = update,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
