#include "editor/tools/gazes/change.h"
#include "base/quat.h"
#include "document/document.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/moves.h"
#include "editor/tools/gazes/fade.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/gazes/words.h"
#include "editor/view/stage.h"
#include "form/camera/camera.h"

#include <math.h>
#include <stdio.h>

static const double TURN = BAT_PI / 180; /* of an arrow key; with Shift ten of it */
static const double FOV = 1;             /* degrees */

bat_status bat_gaze_turned(const bat_camera *from, int level, double u, const double rotation[4],
                           bat_camera **out) {
    bat_camera *made = NULL;
    bat_status status = bat_camera_copy(from, &made);
    if (status == BAT_OK && level == 0) status = bat_camera_give_base(made);
    if (status == BAT_OK) status = bat_camera_turn(made, level, u, rotation);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}

bool bat_gaze_silent(bat_context *c, const bat_camera *camera) {
    const int level = bat_move_level(c, false);
    if (level == 0 || (!bat_camera_is_muted(camera, level) && bat_camera_gain(camera, level) != 0))
        return false;
    bat_notice(c, BAT_STRING_NOTICE_MUTED);
    return true;
}

/* The camera becomes another one, which is taken over, as one step. */
static bat_status put(bat_context *c, const bat_object *object, bat_status status, bat_camera *camera,
                      bat_string step) {
    bat_object *after = NULL;
    const int at = bat_document_find(c->session->document, bat_object_id(object));
    if (status == BAT_OK)
        status = bat_object_with_camera(object, camera, bat_object_followed(object), &after);
    bat_camera_free(camera);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) status = bat_transaction_end(c, bat_transaction_replace(c, at, after), step);
    bat_object_release(after);
    return status;
}

static void choose(bat_context *c, long key) {
    bat_gazing *g = bat_gazing_of(c);
    g->camera = c->moves->camera;
    g->chosen = key;
}

void bat_gaze_say(bat_context *c, size_t key) {
    char text[BAT_KEY_ROOM];
    const bat_object *object = bat_gazing_object(c);
    if (!object) return;
    bat_key_in_words(c, bat_object_camera(object), key, text);
    bat_notice_value(c, BAT_STRING_NOTICE_KEY, text);
}

bat_status bat_gaze_add(bat_context *c, double u) {
    const bat_object *object = bat_gazing_object(c);
    bat_camera *camera = NULL;
    size_t key = 0;
    if (!object) return BAT_STATE;
    bat_status status = bat_camera_copy(bat_object_camera(object), &camera);
    if (status == BAT_OK) status = bat_camera_add_key(camera, u, &key);
    if (status == BAT_COUNT || status == BAT_UNSUPPORTED) {
        bat_notice(c, status == BAT_COUNT ? BAT_STRING_NOTICE_KEY_THERE : BAT_STRING_NOTICE_NO_KEYS);
        bat_camera_free(camera);
        return BAT_STATE;
    }
    status = put(c, object, status, camera, BAT_STRING_STEP_KEY_ADD);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    choose(c, (long)key);
    bat_gaze_say(c, key);
    return BAT_OK;
}

/* ---- commands ---- */

bat_status bat_command_gaze_choose(bat_context *c, bat_command_id id) {
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    if (!object) return BAT_STATE;
    const bat_camera *camera = bat_object_camera(object);
    const long count = (long)bat_gazing_keys(camera), now = bat_gazing_chosen(c);
    if (count == 0) return BAT_STATE;
    const long key = id == BAT_COMMAND_GAZE_NEXT ? (now + 1) % count : now <= 0 ? count - 1 : now - 1;
    choose(c, key);
    c->moves->at = bat_camera_time_of(camera, bat_gazing_place(camera, (size_t)key));
    c->moves->playing = false;
    c->moves->version++;
    bat_gaze_say(c, (size_t)key);
    return BAT_OK;
}

bat_status bat_command_gaze_add(bat_context *c, bat_command_id id) {
    bat_camera_pose pose;
    (void)id;
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    if (!object) return BAT_STATE;
    bat_camera_at_time(bat_object_camera(object), c->moves->at, &pose);
    return bat_gaze_add(c, pose.u);
}

bat_status bat_command_gaze_delete(bat_context *c, bat_command_id id) {
    bat_camera *camera = NULL;
    double change = 0;
    char text[32];
    (void)id;
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    const long key = object ? bat_gazing_chosen(c) : -1;
    if (key < 0) return BAT_STATE;
    bat_status status = bat_camera_copy(bat_object_camera(object), &camera);
    if (status == BAT_OK) status = bat_camera_give_base(camera);
    if (status == BAT_OK) status = bat_camera_remove_key(camera, (size_t)key, &change);
    if (status == BAT_COUNT) {
        bat_notice(c, BAT_STRING_NOTICE_KEYS_NEEDED);
        bat_camera_free(camera);
        return BAT_STATE;
    }
    status = put(c, object, status, camera, BAT_STRING_STEP_KEY_DELETE);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    choose(c, -1);
    snprintf(text, sizeof text, "%.2g", change * 180 / BAT_PI);
    bat_notice_value(c, BAT_STRING_NOTICE_KEY_GONE, text);
    return BAT_OK;
}

/* About the camera's own axes: up and down, left and right, rolling. */
static vec turn_of(bat_command_id id, double by) {
    switch (id) {
    case BAT_COMMAND_GAZE_LEFT: return (vec){0, by, 0};
    case BAT_COMMAND_GAZE_RIGHT: return (vec){0, -by, 0};
    case BAT_COMMAND_GAZE_UP: return (vec){by, 0, 0};
    case BAT_COMMAND_GAZE_DOWN: return (vec){-by, 0, 0};
    case BAT_COMMAND_GAZE_ROLL_LEFT: return (vec){0, 0, by};
    default: return (vec){0, 0, -by};
    }
}

static bat_status widen(const bat_camera *from, const bat_camera_pose *pose, double by, bat_camera **out) {
    bat_camera *made = NULL;
    bat_status status = bat_camera_copy(from, &made);
    if (status == BAT_OK) status = bat_camera_set_fov(made, pose->u, pose->fov + by);
    *out = made;
    return status;
}

bat_status bat_command_gaze_turn(bat_context *c, bat_command_id id) {
    const double many = c->modifiers & BAT_SHIFT ? 10 : 1;
    bat_camera_pose pose;
    bat_camera *camera = NULL;
    double rotation[4];
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    const long key = object ? bat_gazing_chosen(c) : -1;
    if (key < 0) return BAT_STATE;
    const bat_camera *from = bat_object_camera(object);
    const bool wide = id == BAT_COMMAND_GAZE_WIDER, narrow = id == BAT_COMMAND_GAZE_NARROWER;
    if (!wide && !narrow && bat_gaze_silent(c, from)) return BAT_STATE;
    bat_camera_at(from, bat_gazing_place(from, (size_t)key), &pose);
    quat_store(quat_mul(quat_load(pose.rotation), quat_exp(turn_of(id, many * TURN))), rotation);
    bat_status status = wide || narrow
                            ? widen(from, &pose, wide ? many * FOV : -many * FOV, &camera)
                            : bat_gaze_turned(from, bat_move_level(c, false), pose.u, rotation, &camera);
    status = put(c, object, status, camera, wide || narrow ? BAT_STRING_STEP_FOV : BAT_STRING_STEP_GAZE);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_gaze_say(c, (size_t)key);
    return status;
}

bat_status bat_command_gaze_at(bat_context *c, bat_command_id id) {
    double pixel[2], place[3], up[3] = {0, 0, -1};
    bat_camera *camera = NULL;
    (void)id;
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    if (!object) return BAT_STATE;
    bat_stage_middle(c->stage, pixel);
    if (c->input->pen_near) pixel[0] = c->input->pen[0], pixel[1] = c->input->pen[1];
    if (!bat_gazing_over(c, pixel, place)) return BAT_STATE;
    bat_status status = bat_camera_aim(bat_object_camera(object), place, up, &camera);
    status = put(c, object, status, camera, BAT_STRING_STEP_LOOK_AT);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

bat_status bat_command_gaze_along(bat_context *c, bat_command_id id) {
    static const double up[3] = {0, 0, -1};
    bat_camera *camera = NULL;
    (void)id;
    bat_moves_sync(c);
    const bat_object *object = bat_gazing_object(c);
    if (!object || bat_camera_length(bat_object_camera(object)) == 0) return BAT_STATE;
    const bat_camera *from = bat_object_camera(object);
    bat_status status = bat_camera_let_go(from, up, &camera);
    if (status == BAT_SINGULAR) status = bat_camera_let_go(from, NULL, &camera); /* it begins straight up */
    status = put(c, object, status, camera, BAT_STRING_STEP_GAZE);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
