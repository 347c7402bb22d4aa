#include "editor/tools/gazes/fade.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/scene/seen.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "editor/tables/settings.h"
#include "editor/tools/gazes/joint.h"
#include "editor/tools/gazes/state.h"
#include "editor/tools/toolbox.h"
#include "form/camera/camera.h"
#include "form/motion/motion.h"
#include "hands/levels/shape.h"

#include <math.h>

static const double EASE = 0.5, EASE_SHARE = 0.25; /* seconds, of the duration at most: one tap */

/* ---- what is changed ---- */

/* The camera, or the curve that it follows; or the skeleton, whatever of it. NULL: none that can be changed. */
static const bat_object *object_of(const bat_context *c, bool path) {
    const bat_document *document = c->session->document;
    int at = c->moves->camera ? bat_document_find(document, c->moves->camera) : -1;
    const bat_motion *motion = at >= 0 ? bat_object_motion(bat_document_at(document, at), NULL) : NULL;
    if (motion)
        return bat_seen_out_of_reach(c, at) || (path && !bat_motion_path(motion))
                   ? NULL
                   : bat_document_at(document, at);
    if (at >= 0 && path) at = bat_document_find(document, bat_object_followed(bat_document_at(document, at)));
    if (at < 0 || bat_seen_out_of_reach(c, at)) return NULL;
    const bat_object *object = bat_document_at(document, at);
    return path && !bat_object_shape(object, 0) ? NULL : object;
}

/* The path whose levels are changed. */
static const bat_shape *path_of(const bat_object *object) {
    const bat_motion *motion = bat_object_motion(object, NULL);
    return motion ? motion->first : bat_object_shape(object, 0);
}

/* Levels of a gaze or of a shape, alike. */
typedef struct stack {
    bat_camera *camera; /* else: */
    bat_shape *shape;
} stack;

static int top_of(const stack *s) {
    return s->camera ? bat_camera_levels(s->camera) : bat_shape_levels(s->shape);
}
static bool muted(const stack *s, int level) {
    return s->camera ? bat_camera_is_muted(s->camera, level) : bat_shape_is_muted(s->shape, level);
}
static bat_status mute(const stack *s, int level, bool silent) {
    return s->camera ? bat_camera_set_muted(s->camera, level, silent)
                     : bat_shape_set_muted(s->shape, level, silent);
}

/* Whether this level is the last one that is not muted, with none muted below it. */
static bool solo(const stack *s, int level) {
    const int top = top_of(s);
    for (int l = 1; l <= top; l++)
        if (muted(s, l) != (l > level)) return false;
    return level < top;
}

static bat_status set_solo(const stack *s, int level) {
    const int top = top_of(s);
    const bool alone = level == top || solo(s, level); /* again: all sound */
    bat_status status = BAT_OK;
    for (int l = 1; l <= top && status == BAT_OK; l++)
        if (muted(s, l) != (!alone && l > level)) status = mute(s, l, !alone && l > level);
    return status;
}

static bat_status set_level(const stack *s, bat_move_act act, int level, double value) {
    if (level < (act == BAT_MOVE_SOLO ? 0 : 1) || level > top_of(s)) return BAT_ARGUMENT;
    if (act == BAT_MOVE_SOLO) return set_solo(s, level);
    if (act == BAT_MOVE_MUTE) return mute(s, level, value != 0);
    if (!(fabs(value) <= 1e6)) return BAT_ARGUMENT;
    return s->camera ? bat_camera_set_gain(s->camera, level, value)
                     : bat_shape_set_gain(s->shape, level, value);
}

static bat_status set_time(bat_camera *camera, bat_move_act act, double value) {
    if (act == BAT_MOVE_DURATION) return bat_camera_set_timing(camera, value, NULL);
    const double in = act == BAT_MOVE_EASE_OUT ? 0 : value, out = act == BAT_MOVE_EASE_IN ? 0 : value;
    return bat_camera_ease(camera, in, out);
}

/* ---- the active level ---- */

static stack stack_of(const bat_context *c, bool path) {
    const bat_document *document = c->session->document;
    const int at = c->moves->camera ? bat_document_find(document, c->moves->camera) : -1;
    const bat_object *object = at < 0 ? NULL : bat_document_at(document, at),
                     *way = path ? object_of(c, true) : NULL;
    return (stack){path || !object ? NULL : (bat_camera *)bat_turner_of(c, object),
                   way ? (bat_shape *)path_of(way) : NULL};
}

static int top_level(const stack *s) { return s->camera || s->shape ? top_of(s) : -1; }

int bat_move_level(const bat_context *c, bool path) {
    const stack s = stack_of(c, path);
    return (int)fmin(c->moves->level[!path], fmax(top_level(&s), 0));
}

static bat_status choose(bat_context *c, bool path, int level) {
    bat_moves_sync(c);
    const stack s = stack_of(c, path);
    if (!c->moves->camera) return BAT_STATE;
    if (level < 0 || level > top_level(&s)) return BAT_ARGUMENT;
    c->moves->level[!path] = level;
    c->moves->version++;
    return BAT_OK;
}

/* ---- as a step ---- */

typedef struct change {
    bat_move_act act;
    int level;
    double value;
    size_t count; /* above 0: a stroke over the graph */
    const double *points;
} change;

static bat_status apply(const bat_context *c, const change *what, bool path, const bat_object *from,
                        bat_object **out) {
    const bat_camera *camera = path ? NULL : bat_turner_of(c, from);
    const bool skeleton = bat_object_motion(from, NULL) != NULL;
    stack s = {NULL, NULL};
    if (!path && !camera) return BAT_ARGUMENT;
    if (skeleton && what->act >= BAT_MOVE_DURATION) return BAT_ARGUMENT;
    if (skeleton && what->count)
        return bat_joint_redrawn(c, from, bat_move_level(c, false), what->count, what->points, out);
    bat_status status = camera ? bat_camera_copy(camera, &s.camera) : bat_shape_copy(path_of(from), &s.shape);
    if (status == BAT_OK)
        status = what->count                     ? bat_camera_retime(s.camera, what->count, what->points)
                 : what->act < BAT_MOVE_DURATION ? set_level(&s, what->act, what->level, what->value)
                                                 : set_time(s.camera, what->act, what->value);
    if (status == BAT_OK && skeleton)
        status = camera ? bat_joint_put(c, from, s.camera, out) : bat_joint_put_path(from, s.shape, out);
    else if (status == BAT_OK && camera)
        status = bat_object_with_camera(from, s.camera, bat_object_followed(from), out);
    else if (status == BAT_OK)
        status = bat_object_with_shape(from, 0, s.shape, out), s.shape = NULL;
    bat_shape_free(s.shape);
    bat_camera_free(s.camera);
    return status;
}

void bat_move_forget(bat_context *c) {
    bat_gazing *g = bat_gazing_of(c);
    bat_object_release(g->fading);
    bat_object_release(g->bending);
    g->fading = g->bending = NULL;
    g->correcting = false;
}

bool bat_move_let_go(bat_context *c) {
    const bat_gazing *g = bat_gazing_of(c);
    if (!g->fading) return false;
    if (g->correcting) c->moves->at = g->time;
    bat_move_forget(c);
    bat_transaction_cancel(c);
    return true;
}

static bat_status begin(bat_context *c, bool path) {
    bat_gazing *g = bat_gazing_of(c);
    if (g->fading) return !g->correcting && g->path == path ? BAT_OK : BAT_STATE;
    bat_moves_sync(c);
    if (bat_toolbox_busy(c) || c->session->transaction.open) return BAT_STATE;
    if (bat_session_refuses(c)) return BAT_STATE;
    const bat_object *object = object_of(c, path);
    if (!object) return BAT_STATE;
    const bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) g->fading = bat_object_retain(object), g->path = path;
    return status;
}

static bat_string step_of(const change *what, bool skeleton) {
    if (what->count && skeleton) return BAT_STRING_STEP_ANGLE;
    if (what->count || what->act >= BAT_MOVE_DURATION) return BAT_STRING_STEP_TIMING;
    return what->act == BAT_MOVE_GAIN   ? BAT_STRING_STEP_GAIN
           : what->act == BAT_MOVE_MUTE ? BAT_STRING_STEP_MUTE
                                        : BAT_STRING_STEP_SOLO;
}

static bat_status make(bat_context *c, const change *what, bool path, bool done) {
    bat_gazing *g = bat_gazing_of(c);
    bat_object *after = NULL;
    bat_status status = begin(c, path);
    if (status != BAT_OK) return status;
    status = apply(c, what, path, g->fading, &after);
    if (status == BAT_OK)
        status = bat_transaction_replace(c, bat_document_find(c->session->document, bat_object_id(g->fading)),
                                         after);
    bat_object_release(after);
    if (status != BAT_OK) {
        bat_move_let_go(c);
        if (status != BAT_ARGUMENT) bat_notice_failure(c, status);
        return status;
    }
    if (!done) return BAT_OK;
    const bool skeleton = bat_object_motion(g->fading, NULL) != NULL;
    bat_move_forget(c);
    return bat_transaction_commit(c, step_of(what, skeleton), NULL);
}

bat_status bat_move_set(bat_context *c, bat_move_act act, bool path, int level, double value, bool done) {
    const change what = {.act = act, .level = level, .value = value};
    if (act == BAT_MOVE_CHOOSE) return choose(c, path, level);
    if (act == BAT_MOVE_JOINT) return bat_joint_choose(c, level);
    if (act == BAT_MOVE_ANGLE) return bat_joint_choose_angle(c, level);
    if ((unsigned)act > BAT_MOVE_EASE || (path && act >= BAT_MOVE_DURATION)) return BAT_ARGUMENT;
    if (isnan(value)) return BAT_NUMBER;
    return make(c, &what, path, done);
}

bat_status bat_move_retime(bat_context *c, size_t count, const double *points, bool done) {
    const change what = {.count = count, .points = points};
    if (count < 2 || !points) return BAT_ARGUMENT;
    return make(c, &what, false, done);
}

/* ---- commands ---- */

bat_status bat_command_move_ease(bat_context *c, bat_command_id id) {
    (void)id;
    bat_moves_sync(c);
    const bat_camera *camera = bat_flight_camera(c);
    if (!camera || !(bat_camera_length(camera) > 0)) return BAT_STATE;
    const double seconds = fmin(EASE, EASE_SHARE * bat_camera_duration(camera));
    return bat_move_set(c, BAT_MOVE_EASE, false, 0, seconds, true);
}

/* Puts an object in the place of another as one step; takes it over. */
static bat_status replace(bat_context *c, const bat_object *object, bat_status status, bat_object *after,
                          bat_string step) {
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        const int at = bat_document_find(c->session->document, bat_object_id(object));
        status = bat_transaction_end(c, bat_transaction_replace(c, at, after), step);
    }
    bat_object_release(after);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

/* The same with another camera. */
static bat_status put(bat_context *c, const bat_object *object, bat_status status, bat_camera *camera,
                      bat_string step) {
    bat_object *after = NULL;
    if (status == BAT_OK)
        status = bat_object_with_camera(object, camera, bat_object_followed(object), &after);
    bat_camera_free(camera);
    return replace(c, object, status, after, step);
}

/* The seed is the camera's own, and how many levels it has, so that each shake differs and every replay agrees; the level keeps
 * it. */
bat_status bat_command_shake(bat_context *c, bat_command_id id) {
    bat_camera *camera = NULL;
    (void)id;
    bat_moves_sync(c);
    const bat_object *object = object_of(c, false);
    if (!object || !bat_object_camera(object)) return BAT_STATE;
    const double amount = c->settings->values[BAT_PROPERTY_SHAKE_AMOUNT] * BAT_PI / 180,
                 rate = c->settings->values[BAT_PROPERTY_SHAKE_RATE];
    bat_status status = bat_camera_copy(bat_object_camera(object), &camera);
    if (status == BAT_OK) {
        const uint64_t seed = (uint64_t)bat_object_id(object) << 8 | (uint64_t)bat_camera_levels(camera);
        status = bat_camera_add_shake(camera, seed, amount, rate);
    }
    return put(c, object, status, camera, BAT_STRING_STEP_SHAKE);
}

/* The levels of detail of one walk for another, of the same skeleton. */
static bat_status copy_style(bat_context *c, const bat_object *from, const bat_object *to) {
    bat_motion *motion = NULL;
    bat_object *after = NULL;
    bat_status status = bat_motion_copy(bat_object_motion(to, NULL), &motion);
    if (status == BAT_OK) status = bat_motion_take_style(motion, bat_object_motion(from, NULL));
    if (status == BAT_OK) status = bat_object_with_motion(to, motion, &after);
    bat_motion_free(motion);
    return replace(c, to, status, after, BAT_STRING_STEP_GAZE_COPY);
}

/* From the first selected camera, or skeleton, to the one selected after it. */
bat_status bat_command_gaze_copy(bat_context *c, bat_command_id id) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    const bat_object *both[2] = {NULL, NULL};
    bat_camera *camera = NULL;
    (void)id;
    for (int i = 0; i < 2 && selection->count == 2; i++) {
        const int at = bat_document_find(document, selection->ids[i]);
        const bat_object *object = at < 0 || bat_seen_out_of_reach(c, at) ? NULL
                                                                          : bat_document_at(document, at);
        both[i] = object && (bat_object_camera(object) || bat_object_motion(object, NULL)) ? object : NULL;
    }
    if (both[0] && both[1] && bat_object_motion(both[0], NULL) && bat_object_motion(both[1], NULL))
        return copy_style(c, both[0], both[1]);
    if (both[0] && both[1] && (!bat_object_camera(both[0]) || !bat_object_camera(both[1]))) both[0] = NULL;
    if (!both[0] || !both[1]) {
        bat_notice(c, BAT_STRING_NOTICE_TWO_CAMERAS);
        return BAT_STATE;
    }
    bat_status status = bat_camera_copy(bat_object_camera(both[1]), &camera);
    if (status == BAT_OK) status = bat_camera_take_levels(camera, bat_object_camera(both[0]));
    return put(c, both[1], status, camera, BAT_STRING_STEP_GAZE_COPY);
}

/* ---- text ---- */

static void number(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_line_number(text, value);
}

static void rows(const bat_context *c, bat_text *text, const char *name, bool path) {
    const stack own = stack_of(c, path), *s = &own;
    const int active = bat_move_level(c, path);
    bat_text_string(text, name);
    for (int l = 0; (s->camera || s->shape) && l <= top_of(s); l++) {
        const double gain = l == 0      ? 1
                            : s->camera ? bat_camera_gain(s->camera, l)
                                        : bat_shape_gain(s->shape, l);
        number(text, l ? ",{\"gain\":" : "{\"gain\":", gain);
        number(text, ",\"muted\":", l > 0 && muted(s, l));
        number(text, ",\"solo\":", solo(s, l));
        number(text, ",\"active\":", l == active);
        bat_text_string(text, "}");
    }
    bat_text_string(text, "]");
}

void bat_move_rows(const bat_context *c, bat_text *text) {
    const bat_camera *camera = bat_flight_camera(c);
    rows(c, text, ",\"gaze\":[", false);
    rows(c, text, ",\"path\":[", true);
    if (!camera) {
        bat_joint_rows(c, text);
        return;
    }
    bat_text_string(text, ",\"graph\":[");
    for (int i = 0; i < BAT_GRAPH && bat_camera_length(camera) > 0; i++) {
        double share[3] = {(double)i / (BAT_GRAPH - 1)};
        if (bat_camera_timing(camera)->curve) bat_function_eval(bat_camera_timing(camera), share[0], share);
        number(text, i ? "," : "", share[0]);
    }
    bat_text_string(text, "]");
}
