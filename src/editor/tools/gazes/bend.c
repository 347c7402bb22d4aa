#include "editor/tools/gazes/bend.h"
#include "curve/curve.h"
#include "kinds/kinds.h"
#include "form/camera/camera.h"
#include "hands/levels/shape.h"

#include <batten/drag.h>

static const double NEAR = 1e-9; /* of the size */

static bat_status move_all(const bat_curve *curve, const double delta[3], bat_curve **out) {
    const double rows[12] = {1, 0, 0, delta[0], 0, 1, 0, delta[1], 0, 0, 1, delta[2]};
    return bat_curve_transform(curve, rows, out);
}

static bat_status drag_curve(const bat_curve *curve, double u, const double delta[3], bat_curve **out) {
    return bat_curve_size(curve) > 0 ? bat_curve_drag(curve, 1, &u, delta, out) : move_all(curve, delta, out);
}

static bat_status drag_shape(const bat_shape *from, int level, double u, const double delta[3],
                             bat_shape **out) {
    bat_shape *made = NULL;
    double left = 0;
    if (level > 0 && (bat_shape_is_muted(from, level) || bat_shape_gain(from, level) == 0))
        return BAT_ARGUMENT;
    bat_status status = bat_shape_copy(from, &made);
    if (status != BAT_OK) return status;
    const double near = NEAR * bat_curve_size(bat_shape_curve(made, 0));
    status = bat_shape_drag_finest(made, level, u, delta, near, &left);
    if (status == BAT_TOLERANCE) status = bat_shape_drag(made, level, u, delta);
    if (status == BAT_OK) status = bat_shape_commit(made);
    if (status == BAT_OK)
        *out = made;
    else
        bat_shape_free(made);
    return status;
}

static bat_status raise(void *context, const bat_curve *curve, bat_curve **out) {
    (void)context;
    return bat_curve_to_dimension(curve, 3, out);
}

/* An object of the page in space, with its levels. */
static bat_status raised(const bat_object *object, bat_object **out) {
    const bat_status status = bat_object_with_each(object, raise, NULL, out);
    return status == BAT_OK ? bat_object_keep_levels(object, 3, out) : status;
}

/* The object that is followed, with its first curve dragged. */
static bat_status drag_object(const bat_object *followed, int level, double u, const double delta[3],
                              bat_object **out) {
    bat_object *space = NULL;
    bat_shape *shape = NULL;
    bat_curve *curve = NULL;
    bat_status status = BAT_OK;
    if (bat_curve_dimension(bat_object_curve(followed, 0)) == 2) status = raised(followed, &space);
    if (status != BAT_OK) return status;
    const bat_object *from = space ? space : followed;
    const bat_shape *levels = bat_object_shape(from, 0);
    status = levels ? drag_shape(levels, level, u, delta, &shape)
                    : drag_curve(bat_object_curve(from, 0), u, delta, &curve);
    if (status == BAT_OK)
        status = shape ? bat_object_with_shape(from, 0, shape, out)
                       : bat_object_with_curve(from, 0, curve, out);
    bat_object_release(space);
    return status;
}

bat_status bat_camera_bend(const bat_camera *camera, const bat_object *followed, int level, double u,
                           const double delta[3], bat_camera **out, bat_object **path) {
    bat_object *object = NULL;
    bat_curve *own = NULL;
    bat_camera *made = NULL;
    bat_status status = followed ? drag_object(followed, level, u, delta, &object)
                                 : drag_curve(bat_camera_path(camera), u, delta, &own);
    if (status == BAT_OK)
        status = bat_camera_with_path(camera, object ? bat_object_curve(object, 0) : own, &made);
    bat_curve_free(own);
    if (status != BAT_OK) {
        bat_object_release(object);
        return status;
    }
    *out = made;
    *path = object;
    return BAT_OK;
}
