/* Each gesture begins from the camera and the path as they were, at the playhead as it was, and is one step. */
#include "editor/tools/gazes/correct.h"
#include "base/quat.h"
#include "document/document.h"
#include "editor/scene/seen.h"
#include "editor/scene/space.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/moves.h"
#include "editor/tools/gazes/bend.h"
#include "editor/tools/gazes/fade.h"
#include "editor/tools/gazes/state.h"
#include "editor/tools/toolbox.h"
#include "form/camera/camera.h"
#include "form/camera/pyramid.h"

#include <math.h>

static const double TWICE = 200;   /* px that bring the camera twice as near */
static const double MIDDLE = 8;    /* px about the middle of the picture: no angle is known there */
static const double FAR = 5;       /* of the pyramid's depth: how far away is what nothing tells */
static const double FARTHEST = 20; /* doublings */

/* ---- where the camera is to be ---- */

typedef struct picture {
    const double *size, *from, *to; /* pixels */
    vec place;
    quat turn;
    double focal; /* pixels from the eye to the picture */
    double far;   /* to what is seen at `from` */
} picture;

typedef struct wish {
    vec place;
    quat turn;
    bool moves, turns;
} wish;

/* The direction of a pixel in the camera's axes, of length 1. */
static vec way_to(const picture *p, const double pixel[2]) {
    return vec_unit(
        (vec){(pixel[0] - 0.5 * p->size[0]) / p->focal, (0.5 * p->size[1] - pixel[1]) / p->focal, -1});
}

static vec place_at(const picture *p, const double pixel[2]) {
    return vec_add(p->place, vec_scale(quat_turn(p->turn, way_to(p, pixel)), p->far));
}

/* The least rotation that takes a to b, of length 1 both. */
static quat between(vec a, vec b) {
    const vec axis = vec_cross(a, b);
    const double sine = vec_norm(axis);
    return sine > 0 ? quat_exp(vec_scale(axis, bat_atan2(sine, vec_dot(a, b)) / sine)) : quat_one;
}

/* The angle about the middle by which the pen has gone, clockwise as it is seen; 0 near the middle. */
static double rolled(const picture *p) {
    const double x = p->from[0] - 0.5 * p->size[0], y = p->from[1] - 0.5 * p->size[1];
    const double a = p->to[0] - 0.5 * p->size[0], b = p->to[1] - 0.5 * p->size[1];
    if (bat_hypot(x, y) < MIDDLE || bat_hypot(a, b) < MIDDLE) return 0;
    return bat_atan2(x * b - y * a, x * a + y * b);
}

/* About what is seen at `from`, or about `pivot`: what is nearer goes with the pen. */
static wish orbited(const picture *p, const double *pivot) {
    const vec right = quat_turn(p->turn, (vec){1, 0, 0}), own = quat_turn(p->turn, (vec){0, 1, 0});
    const vec about = pivot ? vec_load(pivot, 3) : place_at(p, p->from);
    const double radians = BAT_PI / p->size[1];
    const vec up = {0, 0, own.z > 0 ? 1 : -1}; /* as it is seen: of the page's two sides */
    const quat turn = quat_mul(quat_exp(vec_scale(up, -radians * (p->to[0] - p->from[0]))),
                               quat_exp(vec_scale(right, -radians * (p->to[1] - p->from[1]))));
    const vec place = vec_add(about, quat_turn(turn, vec_sub(p->place, about)));
    return (wish){place, quat_mul(turn, p->turn), true, !pivot};
}

static wish panned(const picture *p) {
    const double pixel = p->far * -way_to(p, p->from).z / p->focal;
    const vec way = {-pixel * (p->to[0] - p->from[0]), pixel * (p->to[1] - p->from[1]), 0};
    return (wish){vec_add(p->place, quat_turn(p->turn, way)), p->turn, true, false};
}

static wish brought_nearer(const picture *p) {
    const double doublings = fmin(fmax((p->from[1] - p->to[1]) / TWICE, -FARTHEST), FARTHEST);
    const vec pivot = place_at(p, p->from);
    const vec way = vec_scale(vec_sub(p->place, pivot), bat_exp(-doublings * bat_log(2)));
    return (wish){vec_add(pivot, way), p->turn, true, false};
}

static wish wish_of(bat_correction kind, const picture *p, const double *target) {
    switch (kind) {
    case BAT_CORRECT_TURN:
        return (wish){p->place, quat_mul(p->turn, between(way_to(p, p->to), way_to(p, p->from))), false,
                      true};
    case BAT_CORRECT_ROLL:
        return (wish){p->place, quat_mul(p->turn, quat_exp((vec){0, 0, rolled(p)})), false, true};
    case BAT_CORRECT_ORBIT: return orbited(p, target);
    case BAT_CORRECT_PAN: return panned(p);
    default: return brought_nearer(p);
    }
}

/* ---- the gesture ---- */

/* What the camera follows; *own: it follows nothing, its path is its own. NULL else: it is hidden or locked. */
static const bat_object *path_of(const bat_context *c, const bat_object *camera, bool *own) {
    const bat_id id = bat_object_followed(camera);
    const int at = id ? bat_document_find(c->session->document, id) : -1;
    *own = id == 0;
    return at < 0 || bat_seen_out_of_reach(c, at) ? NULL : bat_document_at(c->session->document, at);
}

static bat_status begin(bat_context *c) {
    bat_gazing *g = bat_gazing_of(c);
    bool own = false;
    if (g->fading) return g->correcting ? BAT_OK : BAT_STATE;
    bat_moves_sync(c);
    if (bat_toolbox_busy(c) || c->session->transaction.open || bat_session_refuses(c)) return BAT_STATE;
    const int at = c->moves->camera ? bat_document_find(c->session->document, c->moves->camera) : -1;
    if (at < 0 || bat_seen_out_of_reach(c, at)) return BAT_STATE;
    const bat_object *object = bat_document_at(c->session->document, at);
    if (!bat_object_camera(object)) return BAT_STATE;
    const bat_object *path = path_of(c, object, &own);
    const bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    g->fading = bat_object_retain(object);
    g->bending = path ? bat_object_retain(path) : NULL;
    g->correcting = true;
    g->time = fmin(c->moves->at, bat_camera_duration(bat_object_camera(object)));
    g->far = 0;
    return BAT_OK;
}

/* How far away is what is seen in a direction: the target, else what stands there. */
static double far_of(const bat_context *c, const bat_camera *camera, const picture *p) {
    double target[3], from[3], along[3], far = 0;
    if (bat_camera_target(camera, target)) return vec_norm(vec_sub(vec_load(target, 3), p->place));
    vec_store(p->place, from);
    vec_store(quat_turn(p->turn, way_to(p, p->from)), along);
    return bat_space_reach(c->scene, from, along, &far) ? far : FAR * bat_pyramid_depth(camera);
}

static bat_status replace(bat_context *c, const bat_object *after) {
    const int at = bat_document_find(c->session->document, bat_object_id(after));
    return bat_transaction_replace(c, at, (bat_object *)after);
}

/* The camera as it was, carried and turned; *path: what it follows, when that is another one now. */
static bat_status carried(const bat_context *c, const bat_gazing *g, const wish *w,
                          const bat_camera_pose *pose, bat_camera **out, bat_object **path) {
    const bat_camera *from = bat_object_camera(g->fading);
    double delta[3], rotation[4];
    bat_camera *made = NULL;
    if (w->moves && !g->bending && bat_object_followed(g->fading)) return BAT_STATE; /* it is out of reach */
    vec_store(vec_sub(w->place, vec_load(pose->position, 3)), delta);
    bat_status status = w->moves ? bat_camera_bend(from, g->bending, bat_move_level(c, true), pose->u, delta,
                                                   &made, path)
                                 : bat_camera_copy(from, &made);
    const int level = bat_move_level(c, false);
    quat_store(w->turn, rotation);
    if (status == BAT_OK && w->turns && level == 0) status = bat_camera_give_base(made);
    if (status == BAT_OK && w->turns) status = bat_camera_turn(made, level, pose->u, rotation);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}

static bat_status apply(bat_context *c, bat_correction kind, picture *p) {
    bat_gazing *g = bat_gazing_of(c);
    const bat_camera *from = bat_object_camera(g->fading);
    bat_camera *made = NULL;
    bat_object *path = NULL, *after = NULL;
    bat_camera_pose pose;
    double target[3];
    bat_camera_at_time(from, g->time, &pose);
    const double half = 0.5 * fmin(fmax(pose.fov, 1), 170) * BAT_PI / 180;
    p->place = vec_load(pose.position, 3);
    p->turn = quat_load(pose.rotation);
    p->focal = 0.5 * p->size[1] * bat_cos(half) / bat_sin(half);
    if (g->far == 0) g->far = far_of(c, from, p);
    p->far = g->far;
    const wish w = wish_of(kind, p, bat_camera_target(from, target) ? target : NULL);
    bat_status status = carried(c, g, &w, &pose, &made, &path);
    if (status == BAT_OK)
        status = bat_object_with_camera(g->fading, made, bat_object_followed(g->fading), &after);
    if (status == BAT_OK && path) status = replace(c, path);
    if (status == BAT_OK) status = replace(c, after);
    if (status == BAT_OK) c->moves->at = bat_camera_time_of(made, pose.u); /* the path may be longer now */
    bat_camera_free(made);
    bat_object_release(path);
    bat_object_release(after);
    return status;
}

static void tell(bat_context *c, bat_status status) {
    if (status == BAT_UNSUPPORTED)
        bat_notice(c, BAT_STRING_NOTICE_NO_KEYS);
    else if (status == BAT_ARGUMENT)
        bat_notice(c, BAT_STRING_NOTICE_MUTED);
    else if (status == BAT_STATE)
        bat_notice(c, BAT_STRING_NOTICE_PATH_HELD);
    else
        bat_notice_failure(c, status);
}

bat_status bat_correct(bat_context *c, bat_correction kind, const double size[2], const double from[2],
                       const double to[2], bool done) {
    picture p = {.size = size, .from = from, .to = to};
    if (!size || !from || !to || (unsigned)kind > BAT_CORRECT_DOLLY) return BAT_ARGUMENT;
    for (int k = 0; k < 2; k++) {
        if (!isfinite(size[k]) || !(fabs(from[k]) <= BAT_PIXELS_MAX) || !(fabs(to[k]) <= BAT_PIXELS_MAX))
            return BAT_NUMBER;
        if (!(size[k] >= 1 && size[k] <= BAT_PIXELS_MAX)) return BAT_ARGUMENT;
    }
    bat_status status = begin(c);
    if (status != BAT_OK) return status;
    status = apply(c, kind, &p);
    if (status != BAT_OK) {
        bat_move_let_go(c);
        tell(c, status);
        return status;
    }
    if (!done) return BAT_OK;
    bat_move_forget(c);
    return bat_transaction_commit(
        c, kind <= BAT_CORRECT_ROLL ? BAT_STRING_STEP_GAZE : BAT_STRING_STEP_CORRECT, NULL);
}
