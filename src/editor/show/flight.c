#include "editor/show/flight.h"
#include "editor/scene/scene.h"
#include "editor/session/session.h"
#include "editor/show/body.h"
#include "editor/show/moves.h"
#include "editor/view/stage.h"
#include "form/camera/pyramid.h"

#include <math.h>

enum { GHOSTS = 240 };                /* at most */
static const double GHOST_STEP = 0.5; /* seconds */
static const float GHOST_WIDTH = 1, WIDTH = 2;
static const double HEAD = 4; /* px: the radius of the dot at the eye */

const bat_camera *bat_flight_camera(const bat_context *c) {
    const bat_document *document = c->session->document;
    const int at = c->moves->camera ? bat_document_find(document, c->moves->camera) : -1;
    return at < 0 ? NULL : bat_object_camera(bat_document_at(document, at));
}

double bat_flight_duration(const bat_context *c) {
    const bat_camera *camera = bat_flight_camera(c);
    const bat_motion *motion = bat_body_motion(c, NULL);
    return camera ? bat_camera_duration(camera) : motion ? bat_motion_duration(motion) : 0;
}

void bat_flight_stand(const bat_context *c) {
    bat_scene_stand(c->scene, c->moves->camera ? c->moves->at : 0);
}

bool bat_flight_view(const bat_context *c, bat_viewpoint *out) {
    double size[2];
    bat_stage_window(c->stage, size);
    return bat_flight_sees(c, size, out);
}

bool bat_flight_sees(const bat_context *c, const double size[2], bat_viewpoint *out) {
    const bat_camera *camera = bat_flight_camera(c);
    bat_camera_pose pose;
    if (!camera) return false;
    bat_camera_at_time(camera, c->moves->at, &pose);
    return bat_camera_view(&pose, 5 * bat_pyramid_depth(camera), size, out) == BAT_OK &&
           bat_viewpoint_check(out, NULL) == BAT_OK;
}

static void line(const bat_context *c, bat_overlay *overlay, int count, const double *points) {
    bool on = false;
    double at[2];
    for (int i = 0; i < count; i++, points += 3) {
        const bool seen = bat_stage_look(c->stage, 3, points, at);
        if (seen) (on ? bat_path_line : bat_path_move)(&overlay->path, at[0], at[1]);
        on = seen;
    }
}

static void pyramid(const bat_context *c, bat_overlay *overlay, const bat_camera *camera, double time,
                    double share) {
    double points[3 * BAT_PYRAMID_CORNERS];
    bat_camera_pose pose;
    bat_camera_at_time(camera, time, &pose);
    bat_pyramid_of(&pose, share * bat_pyramid_depth(camera), points);
    line(c, overlay, BAT_PYRAMID_CORNERS, points);
}

void bat_flight_show(const bat_context *c, bat_overlay *overlay) {
    const bat_camera *camera = bat_flight_camera(c);
    bat_camera_pose pose;
    double eye[2];
    if (!camera) return;
    const double duration = bat_camera_duration(camera);
    const double step = GHOST_STEP * fmax(1, ceil(duration / GHOST_STEP / GHOSTS));
    bat_overlay_item(overlay, BAT_ROLE_GHOST, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH, GHOST_WIDTH);
    for (double time = 0; time <= duration * (1 + 1e-12); time += step)
        pyramid(c, overlay, camera, time, 0.5);
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH, WIDTH);
    pyramid(c, overlay, camera, c->moves->at, 1);
    bat_camera_at_time(camera, c->moves->at, &pose);
    if (!bat_stage_look(c->stage, 3, pose.position, eye)) return;
    bat_overlay_item(overlay, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    bat_overlay_circle(overlay, eye, HEAD * bat_stage_pixel(c->stage));
}
