/* Internal: a spline of quaternions. */
#ifndef BATTEN_FORM_CAMERA_ROTATION_H
#define BATTEN_FORM_CAMERA_ROTATION_H

#include "base/quat.h"
#include "curve/curve.h"

#include <batten/camera.h>

/* Its keys, unit and with aligned signs, and the spline of them as two curves. One that comes back as -q after a period is
 * stored over two of them: the keys, and the keys opposed. */
typedef struct bat_rotation {
    size_t count;
    double *keys;    /* count * 4 */
    double *weights; /* of the keys; NULL: all are 1 */
    bool antiperiodic;
    bat_curve *xyz, *w; /* w: the first coordinate */
    double domain[2];   /* of one period */
    double least;       /* how short the spline becomes */
} bat_rotation;

/* BAT_SINGULAR: a quaternion is zero, or the spline is shorter than 1e-6 somewhere. Clear it whatever happens. */
bat_status bat_rotation_make(const bat_rotation_curve *given, bat_rotation *out);
bat_status bat_rotation_copy(const bat_rotation *from, bat_rotation *out);
void bat_rotation_clear(bat_rotation *rotation);
/* The unit quaternion at a share of the domain, 0 to 1. */
quat bat_rotation_at(const bat_rotation *rotation, double share);
/* The same before it is made unit. */
quat bat_rotation_spline(const bat_rotation *rotation, double share);
/* Makes the spline again after keys have changed, which keep their signs, without `least`. */
bat_status bat_rotation_rebuild(bat_rotation *rotation);
/* Finds `least`. BAT_SINGULAR: the spline cancels. */
bat_status bat_rotation_measure(bat_rotation *rotation);
/* Both. */
bat_status bat_rotation_remake(bat_rotation *rotation);

#endif
