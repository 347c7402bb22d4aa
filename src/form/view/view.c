/* Views: their checks, the rays of pixels, and the pixels of points. */
#include "form/view/view.h"
#include "curve/curve.h"
#include "text/json.h"

static const double parallel = 1e-9; /* sine of the least angle between up and the gaze */

static bat_status check_window(const bat_viewpoint *view, bat_problem *problem) {
    for (size_t i = 0; i < 2; i++)
        if (!(view->size[i] > 0))
            return bat_problem_found(problem, BAT_ARGUMENT, "size[%zu]", i, "more than 0", view->size[i]);
    if (!(view->fov >= 0 && view->fov < 180))
        return bat_problem_found(problem, BAT_ARGUMENT, "fov", 0, "0 to less than 180", view->fov);
    if (!(view->height >= 0))
        return bat_problem_found(problem, BAT_ARGUMENT, "height", 0, "0 or more", view->height);
    if (view->fov > 0 && view->height > 0)
        return bat_problem_found(problem, BAT_ARGUMENT, "height", 0, "0 beside a fov", view->height);
    return view->fov > 0 || view->height > 0
               ? BAT_OK
               : bat_problem_set(problem, BAT_ARGUMENT, "fov",
                                 "expected a fov or a height above 0, found none");
}

static bat_status work_out(const bat_viewpoint *view, bat_gaze *out, bat_problem *problem) {
    if (!view || !out) return bat_problem_set(problem, BAT_ARGUMENT, "view", "expected a view, found none");
    const struct {
        const char *place;
        size_t count;
        const double *numbers;
    } members[] = {{"eye[%zu]", 3, view->eye}, {"target[%zu]", 3, view->target},
                   {"up[%zu]", 3, view->up},   {"size[%zu]", 2, view->size},
                   {"fov", 1, &view->fov},     {"height", 1, &view->height}};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++)
        if (bat_coordinates_check(problem, members[i].place, members[i].count, members[i].numbers) != BAT_OK)
            return BAT_NUMBER;
    const bat_status status = check_window(view, problem);
    if (status != BAT_OK) return status;
    bat_gaze gaze = {.eye = vec_load(view->eye, 3)};
    gaze.ahead = vec_unit(vec_sub(vec_load(view->target, 3), gaze.eye));
    const vec across = vec_cross(gaze.ahead, vec_unit(vec_load(view->up, 3)));
    if (!(vec_norm(across) > parallel))
        return bat_problem_set(
            problem, BAT_SINGULAR, "up",
            "expected a target other than the eye, and up beside the gaze, found them in line");
    gaze.right = vec_unit(across);
    gaze.above = vec_cross(gaze.right, gaze.ahead);
    for (int d = 0; d < 2; d++) gaze.middle[d] = 0.5 * view->size[d];
    if (view->fov > 0)
        gaze.focus = gaze.middle[1] / bat_tan(view->fov * (BAT_PI / 360));
    else
        gaze.pixel = view->height / view->size[1];
    const double scale = fmax(gaze.focus, gaze.pixel);
    if (bat_problem_outside(problem, view->fov > 0 ? "fov" : "height", 0, 1 / BAT_COORDINATE_MAX,
                            BAT_COORDINATE_MAX, scale))
        return BAT_ARGUMENT;
    *out = gaze;
    return BAT_OK;
}

bat_status bat_gaze_of(const bat_viewpoint *view, bat_gaze *out) { return work_out(view, out, NULL); }

bat_status bat_gaze_through(const bat_viewpoint *view, const bat_stroke *stroke, bat_gaze *out) {
    if (!stroke || (stroke->count > 0 && !stroke->points)) return BAT_ARGUMENT;
    bat_status status = bat_gaze_of(view, out);
    if (status != BAT_OK) return status;
    if (stroke->dimension != 2) return BAT_DIMENSION;
    if (stroke->count > BAT_POINTS_MAX) return BAT_COUNT;
    return bat_are_coordinates(stroke->points, 2 * stroke->count) ? BAT_OK : BAT_NUMBER;
}

bat_status bat_viewpoint_check(const bat_viewpoint *view, bat_problem *problem) {
    bat_gaze gaze;
    return work_out(view, &gaze, problem);
}

bat_sight bat_gaze_ray(const bat_gaze *gaze, const double pixel[2]) {
    const double x = pixel[0] - gaze->middle[0], y = gaze->middle[1] - pixel[1];
    const vec across = vec_add(vec_scale(gaze->right, x), vec_scale(gaze->above, y));
    if (gaze->focus > 0)
        return (bat_sight){gaze->eye, vec_unit(vec_add(across, vec_scale(gaze->ahead, gaze->focus)))};
    return (bat_sight){vec_add(gaze->eye, vec_scale(across, gaze->pixel)), gaze->ahead};
}

double bat_gaze_pixel(const bat_gaze *gaze, vec point) {
    if (!(gaze->focus > 0)) return gaze->pixel;
    return fmax(vec_dot(vec_sub(point, gaze->eye), gaze->ahead), 0) / gaze->focus;
}

vec bat_gaze_towards(const bat_gaze *gaze, vec point) {
    return gaze->focus > 0 ? vec_unit(vec_sub(point, gaze->eye)) : gaze->ahead;
}

bat_status bat_viewpoint_ray(const bat_viewpoint *view, const double pixel[2], double origin[3],
                             double direction[3]) {
    if (!pixel || !origin || !direction) return BAT_ARGUMENT;
    bat_gaze gaze;
    bat_status status = bat_gaze_of(view, &gaze);
    if (status != BAT_OK) return status;
    if (!bat_are_coordinates(pixel, 2)) return BAT_NUMBER;
    const bat_sight ray = bat_gaze_ray(&gaze, pixel);
    vec_store(ray.from, origin);
    vec_store(ray.along, direction);
    return BAT_OK;
}

bat_status bat_viewpoint_project(const bat_viewpoint *view, const double point[3], double pixel[2],
                                 double *depth) {
    if (!point || !pixel) return BAT_ARGUMENT;
    bat_gaze gaze;
    bat_status status = bat_gaze_of(view, &gaze);
    if (status != BAT_OK) return status;
    if (!bat_are_coordinates(point, 3)) return BAT_NUMBER;
    const vec way = vec_sub(vec_load(point, 3), gaze.eye);
    const double far = vec_dot(way, gaze.ahead);
    if (gaze.focus > 0 && !(far > 0)) return BAT_FAR;
    const double scale = gaze.focus > 0 ? gaze.focus / far : 1 / gaze.pixel;
    pixel[0] = gaze.middle[0] + scale * vec_dot(way, gaze.right);
    pixel[1] = gaze.middle[1] - scale * vec_dot(way, gaze.above);
    if (depth) *depth = far;
    return BAT_OK;
}
