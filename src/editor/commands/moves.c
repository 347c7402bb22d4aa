/* Commands that make cameras and play their moves. */
#include "base/quat.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/pick/pivot.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include "form/camera/views.h"
#include "document/kind.h"
#include <math.h>
#include <stdio.h>

/* ---- making ---- */

/* Puts it into the drawing, selected; takes the camera over. */
static bat_status put(bat_context *c, bat_camera *camera, bat_id follows) {
    const bat_style style = bat_style_defaults();
    const bat_id id = bat_document_new_id(c->session->document);
    bat_object *object = NULL;
    bat_status status = bat_object_create_camera(id, "", &style, camera, follows, &object);
    bat_camera_free(camera);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_arrange_insert(c, object), BAT_STRING_STEP_CAMERA);
    bat_object_release(object);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    if (bat_tool_at(c->choice->tool)->traits & BAT_DRAWS) c->choice->wanted = BAT_CHOOSES;
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, id); /* out of memory: not selected */
    bat_moves_sync(c);
    return BAT_OK;
}

/* The selected object, when its first curve can be a path. */
static const bat_object *path_of(const bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    const bat_object *object = selection->count == 1
                                   ? bat_document_at(document, bat_document_find(document, selection->ids[0]))
                                   : NULL;
    return object && bat_object_is_made_of_curves(object) && bat_object_curve_count(object) ? object : NULL;
}

bat_status bat_command_camera_along(bat_context *c, bat_command_id id) {
    const bat_object *object = path_of(c);
    bat_camera_options options = bat_camera_defaults();
    bat_camera *camera = NULL;
    (void)id;
    if (!object) {
        bat_notice(c, BAT_STRING_NOTICE_SELECT_PATH);
        return BAT_STATE;
    }
    options.mode = BAT_CAMERA_ALONG;
    options.has_first = true;
    options.first[2] = -1; /* up from the page */
    bat_status status = bat_camera_create(bat_object_curve(object, 0), &options, &camera);
    if (status == BAT_SINGULAR) { /* it begins straight up */
        options.has_first = false;
        status = bat_camera_create(bat_object_curve(object, 0), &options, &camera);
    }
    if (status == BAT_OK) return put(c, camera, bat_object_id(object));
    bat_notice_failure(c, status);
    return status;
}

/* The pose of the view as it is; in parallel projection, where the eye may be anywhere along the gaze, one that sees the middle of
 * everything as large as it is seen. */
static void pose_of(bat_context *c, double place[3], double rotation[4], double *fov) {
    bat_view seen = c->stage->view;
    const bat_view *view = &seen;
    double middle[2], right[3], down[3], ahead[3], all[3];
    const bool deep = bat_stage_deep(c->stage);
    if (!deep && bat_pivot_of_all(c, all)) bat_view_set_pivot(&seen, all);
    bat_stage_middle(c->stage, middle);
    bat_view_axes(view, right, down, ahead);
    const bat_ray ray = bat_view_ray(view, middle);
    *fov = deep ? view->fov : BAT_FOV;
    const double half = *fov * BAT_PI / 360, tall = fmax(view->height, 1) / view->zoom;
    const double back = deep ? 0 : 0.5 * tall * bat_cos(half) / bat_sin(half);
    const vec x = vec_load(right, 3), y = vec_scale(vec_load(down, 3), -1),
              z = vec_scale(vec_load(ahead, 3), -1);
    vec_store(vec_add(vec_load(ray.from, 3), vec_scale(z, back)), place);
    quat_store(quat_of_axes(x, y, z), rotation);
}

/* The selected camera, when it can go through another view; *at: where it is. */
static const bat_object *taking_views(const bat_context *c, int *at) {
    const bat_selection *selection = &c->choice->selection;
    if (selection->count != 1) return NULL;
    *at = bat_document_find(c->session->document, selection->ids[0]);
    const bat_object *object = bat_document_at(c->session->document, *at);
    const bat_camera *camera = object ? bat_object_camera(object) : NULL;
    const bool own = camera && bat_object_followed(object) == 0 && !bat_seen_out_of_reach(c, *at);
    return own && bat_camera_takes_views(camera) ? object : NULL;
}

/* Its move goes through the view, too, and the playhead stands there. */
static bat_status go_through(bat_context *c, int at, const bat_object *object, const bat_camera_pose *view) {
    char text[24];
    bat_view_report report = {0};
    bat_camera *camera = NULL;
    bat_object *after = NULL;
    bat_status status = bat_camera_with_view(bat_object_camera(object), view, &camera, &report);
    if (status == BAT_STATE || status == BAT_COUNT) {
        bat_notice(c, status == BAT_STATE ? BAT_STRING_NOTICE_VIEW_SAME : BAT_STRING_NOTICE_VIEWS_MANY);
        return BAT_STATE;
    }
    if (status == BAT_OK) status = bat_object_with_camera(object, camera, 0, &after);
    const double end = camera ? bat_camera_duration(camera) : 0;
    bat_camera_free(camera);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_transaction_replace(c, at, after), BAT_STRING_STEP_VIEW_KEY);
    bat_object_release(after);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    bat_moves_sync(c);
    c->moves->at = end;
    c->moves->version++;
    snprintf(text, sizeof text, "%zu", report.views);
    bat_notice_value(c, report.sudden ? BAT_STRING_NOTICE_VIEWS_SUDDEN : BAT_STRING_NOTICE_VIEWS, text);
    return BAT_OK;
}

/* A camera that stands at a pose: a path of no length. */
static bat_status stand(bat_context *c, const bat_camera_pose *view) {
    static const double knots[4] = {0, 0, 1, 1};
    double points[6], keys[8];
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    for (int i = 0; i < 3; i++) points[i] = points[3 + i] = view->position[i];
    for (int i = 0; i < 4; i++) keys[i] = keys[4 + i] = view->rotation[i];
    const bat_rotation_curve base = {
        .degree = 1, .count = 2, .points = keys, .knot_count = 4, .knots = knots};
    bat_camera_options options = bat_camera_defaults();
    options.base = &base;
    options.fov = bat_function_of(view->fov);
    bat_status status = bat_curve_create(3, 1, false, 2, points, 4, knots, &path);
    if (status == BAT_OK) status = bat_camera_create(path, &options, &camera);
    bat_curve_free(path);
    if (status == BAT_OK) return put(c, camera, 0);
    bat_notice_failure(c, status);
    return status;
}

bat_status bat_command_camera_here(bat_context *c, bat_command_id id) {
    bat_camera_pose view = {0};
    int at = -1;
    bat_moves_sync(c);
    const bat_object *object = id == BAT_COMMAND_CAMERA_NEW ? NULL : taking_views(c, &at);
    pose_of(c, view.position, view.rotation, &view.fov);
    return object ? go_through(c, at, object, &view) : stand(c, &view);
}

/* ---- playing ---- */

bat_status bat_command_move_play(bat_context *c, bat_command_id id) {
    (void)id;
    return bat_moves_toggle(c) ? BAT_OK : BAT_STATE;
}

/* By a frame, or to an end; what plays stops. */
bat_status bat_command_move_step(bat_context *c, bat_command_id id) {
    bat_moves *m = c->moves;
    bat_moves_sync(c);
    const double end = bat_flight_duration(c), rate = c->settings->values[BAT_PROPERTY_MOVE_RATE];
    if (!(end > 0)) return BAT_STATE;
    const double frame = floor(m->at * rate + 1e-6), on = m->at * rate - frame > 1e-6 ? 1 : 0;
    const double to = id == BAT_COMMAND_MOVE_START  ? 0
                      : id == BAT_COMMAND_MOVE_END  ? end
                      : id == BAT_COMMAND_MOVE_NEXT ? (frame + 1) / rate
                                                    : (frame - 1 + on) / rate;
    m->at = fmin(fmax(to, 0), end);
    m->playing = false;
    m->version++;
    return BAT_OK;
}

bat_status bat_command_look_through(bat_context *c, bat_command_id id) {
    bat_viewpoint view;
    (void)id;
    bat_moves_sync(c);
    if (bat_moves_leave(c)) return BAT_OK;
    if (!bat_flight_view(c, &view)) {
        bat_notice(c, BAT_STRING_NOTICE_NO_CAMERA);
        return BAT_STATE;
    }
    c->moves->through = true;
    c->moves->version++;
    bat_notice(c, BAT_STRING_NOTICE_THROUGH);
    return BAT_OK;
}
