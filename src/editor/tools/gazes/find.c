/* Gaze handles: where they are, and how they look. */
#include "base/quat.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/pick/pick.h"
#include "editor/pick/surface.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/show/body.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "editor/tables/tables.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/gazes/joint.h"
#include "editor/view/stage.h"
#include "form/camera/camera.h"
#include "form/camera/pyramid.h"

#include <math.h>

static const double REACH = 9, REACH_TOUCH = 22, REACH_LINE = 6, REACH_LINE_TOUCH = 16; /* px */
static const double LEAST = 44; /* px: of a ray across the gaze */
static const double TICK = 0.3; /* of the ray */
static const double DOT = 4.5;  /* px */
static const float WIDTH = 1.5F;

const bat_object *bat_gazing_object(const bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    if (selection->count != 1 || selection->ids[0] != c->moves->camera || c->moves->through) return NULL;
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES) || c->session->read_only) return NULL;
    const int at = bat_document_find(document, c->moves->camera);
    const bat_object *object = at < 0 ? NULL : bat_document_at(document, at);
    if (!object || !bat_object_camera(object) || bat_seen_out_of_reach(c, at)) return NULL;
    return object;
}

/* ---- where they are ---- */

size_t bat_gazing_keys(const bat_camera *camera) {
    size_t count = 0;
    if (bat_camera_mode_of(camera) == BAT_CAMERA_LOOK_AT) return 0;
    bat_camera_base(camera, &count);
    return count > 0 ? count : bat_camera_first_keys(camera);
}

double bat_gazing_place(const bat_camera *camera, size_t key) {
    size_t count = 0;
    bat_camera_base(camera, &count);
    return count > 0 ? bat_camera_key_place(camera, key) : bat_camera_first_place(camera, key);
}

long bat_gazing_chosen(const bat_context *c) {
    const bat_gazing *g = bat_gazing_of(c);
    const bat_object *object = bat_gazing_object(c);
    if (!object || bat_object_id(object) != g->camera) return -1;
    return g->chosen < (long)bat_gazing_keys(bat_object_camera(object)) ? g->chosen : -1;
}

bool bat_gazes_leave(bat_context *c) {
    bat_gazing *g = bat_gazing_of(c);
    const bool was = bat_gazing_chosen(c) >= 0;
    g->chosen = -1;
    return was;
}

void bat_gazing_end(const bat_context *c, const bat_camera *camera, size_t key, bat_camera_pose *pose,
                    double end[3]) {
    const double length = fmax(bat_pyramid_depth(camera), LEAST * bat_stage_pixel(c->stage));
    bat_camera_at(camera, bat_gazing_place(camera, key), pose);
    const vec ahead = quat_turn(quat_load(pose->rotation), (vec){0, 0, -length});
    vec_store(vec_add(vec_load(pose->position, 3), ahead), end);
}

static bool pixel_of(const bat_context *c, const double place[3], double pixel[2]) {
    double at[2];
    if (!bat_stage_look(c->stage, 3, place, at)) return false;
    bat_stage_project(c->stage, at, pixel);
    return true;
}

static double away(const bat_context *c, const double place[3], const double pixel[2]) {
    double at[2];
    return pixel_of(c, place, at) ? bat_hypot(at[0] - pixel[0], at[1] - pixel[1]) : INFINITY;
}

/* From a pixel to the line between two others. */
static double off_line(const double a[2], const double b[2], const double p[2]) {
    const double x = b[0] - a[0], y = b[1] - a[1], all = x * x + y * y;
    const double t = all > 0 ? fmin(fmax(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / all, 0), 1) : 0;
    return bat_hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}

/* The edges of the picture at the playhead. */
static bool on_edge(const bat_context *c, const bat_camera *camera, const double pixel[2], double reach) {
    static const int corners[5] = {0, 1, 3, 4, 0};
    double points[3 * BAT_PYRAMID_CORNERS], a[2], b[2];
    bat_camera_pose pose;
    bat_camera_at_time(camera, c->moves->at, &pose);
    bat_pyramid_of(&pose, bat_pyramid_depth(camera), points);
    for (int i = 0; i < 4; i++)
        if (pixel_of(c, points + 3 * corners[i], a) && pixel_of(c, points + 3 * corners[i + 1], b) &&
            off_line(a, b, pixel) <= reach)
            return true;
    return false;
}

static bool on_path(bat_context *c, const bat_object *object, const double pixel[2], double reach,
                    double *u) {
    const bat_id followed = bat_object_followed(object);
    double at[2];
    bat_near near = {.distance = INFINITY};
    if (bat_camera_length(bat_object_camera(object)) == 0) return false;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, at);
    if (!bat_pick_on(c->scene, followed ? followed : bat_object_id(object), 0, at, &near)) return false;
    *u = near.u;
    return near.distance <= reach * bat_stage_pixel(c->stage);
}

/* A skeleton is looked at, whose joints a tap chooses. */
static bool chooses_joints(const bat_context *c) {
    const int at = c->moves->camera ? bat_document_find(c->session->document, c->moves->camera) : -1;
    return at >= 0 && bat_body_motion(c, NULL) && !bat_seen_out_of_reach(c, at) && !c->session->read_only &&
           bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES;
}

bat_gaze_hold bat_gazing_find(bat_context *c, const double pixel[2], bat_device device, long *key,
                              double *u) {
    const bat_object *object = bat_gazing_object(c);
    const bool touch = device == BAT_DEVICE_TOUCH;
    double best = touch ? REACH_TOUCH : REACH, end[3];
    const double line = touch ? REACH_LINE_TOUCH : REACH_LINE;
    bat_gaze_hold part = BAT_GAZE_NOTHING;
    if (!object) {
        const int joint = chooses_joints(c) ? bat_joint_near(c, pixel, best) : -1;
        *key = joint;
        return joint < 0 ? part : BAT_GAZE_JOINT;
    }
    const bat_camera *camera = bat_object_camera(object);
    bat_camera_pose pose;
    for (size_t i = 0; i < bat_gazing_keys(camera); i++) {
        bat_gazing_end(c, camera, i, &pose, end);
        const double off = away(c, end, pixel);
        if (off > best) continue;
        best = off, part = BAT_GAZE_END, *key = (long)i, *u = pose.u;
    }
    if (part == BAT_GAZE_NOTHING && bat_camera_target(camera, end) && away(c, end, pixel) <= best)
        part = BAT_GAZE_TARGET;
    if (part == BAT_GAZE_NOTHING && on_edge(c, camera, pixel, line)) {
        bat_camera_at_time(camera, c->moves->at, &pose);
        *u = pose.u;
        part = BAT_GAZE_EDGE;
    }
    if (part == BAT_GAZE_NOTHING && bat_gazing_keys(camera) && on_path(c, object, pixel, line, u))
        part = BAT_GAZE_PATH;
    return part;
}

bool bat_gazing_over(bat_context *c, const double pixel[2], double place[3]) {
    const bat_object *surface = bat_pick_surface(c, pixel), *own = bat_gazing_object(c);
    bat_stage stage = *c->stage;
    bat_hit hit;
    double at[2];
    if (surface && bat_ground_of(surface, &stage.ground) &&
        bat_stage_place(&stage, pixel, NULL, &hit) == BAT_OK) {
        for (int k = 0; k < 3; k++) place[k] = hit.at[k];
        return true;
    }
    bat_stage_seen(c->stage, pixel, at);
    const bat_pick pick = bat_pick_curve(c->scene, 0, at, REACH * bat_stage_pixel(c->stage));
    if (pick.object && own && pick.object != bat_object_id(own) && pick.object != bat_object_followed(own)) {
        const bat_object *object = bat_scene_shown(c->scene, pick.index);
        double point[BAT_DIMENSION_MAX] = {0};
        bat_curve_eval(bat_object_curve(object, pick.curve), pick.near.u, 0, point);
        for (int k = 0; k < 3; k++) place[k] = point[k];
        return true;
    }
    if (bat_stage_place(c->stage, pixel, NULL, &hit) != BAT_OK) return false;
    for (int k = 0; k < 3; k++) place[k] = hit.at[k];
    return true;
}

/* ---- picture ---- */

static void ray(const bat_context *c, bat_overlay *overlay, const bat_camera *camera, size_t key) {
    bat_camera_pose pose;
    double end[3], up[3], a[2], b[2], tick[2];
    bat_gazing_end(c, camera, key, &pose, end);
    const vec from = vec_load(pose.position, 3), to = vec_load(end, 3);
    const double length = vec_norm(vec_sub(to, from));
    vec_store(vec_add(to, quat_turn(quat_load(pose.rotation), (vec){0, TICK * length, 0})), up);
    if (!bat_stage_look(c->stage, 3, pose.position, a) || !bat_stage_look(c->stage, 3, end, b)) return;
    bat_path_move(&overlay->path, a[0], a[1]);
    bat_path_line(&overlay->path, b[0], b[1]);
    if (bat_stage_look(c->stage, 3, up, tick)) bat_path_line(&overlay->path, tick[0], tick[1]);
}

static void dot(const bat_context *c, bat_overlay *overlay, const double place[3], double radius) {
    double at[2];
    if (bat_stage_look(c->stage, 3, place, at))
        bat_overlay_circle(overlay, at, radius * bat_stage_pixel(c->stage));
}

void bat_gazes_show(const bat_context *c, bat_overlay *overlay) {
    const bat_object *object = bat_gazing_object(c);
    bat_camera_pose pose;
    double end[3];
    if (!object) return;
    const bat_camera *camera = bat_object_camera(object);
    const size_t keys = bat_gazing_keys(camera);
    const long chosen = bat_gazing_chosen(c);
    bat_overlay_item(overlay, BAT_ROLE_ARROW, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH, WIDTH);
    for (size_t i = 0; i < keys; i++) ray(c, overlay, camera, i);
    bat_overlay_item(overlay, BAT_ROLE_POINT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, WIDTH);
    for (size_t i = 0; i < keys; i++) {
        bat_gazing_end(c, camera, i, &pose, end);
        if ((long)i != chosen) dot(c, overlay, end, DOT);
    }
    if (bat_camera_target(camera, end)) dot(c, overlay, end, DOT);
    if (chosen < 0) return;
    bat_overlay_item(overlay, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED | BAT_ITEM_FILLED, WIDTH);
    bat_gazing_end(c, camera, (size_t)chosen, &pose, end);
    dot(c, overlay, end, DOT + 1.5);
    dot(c, overlay, pose.position, DOT - 1);
}
