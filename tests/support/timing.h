/* A camera along a random path, and what is asked of its timing. */
#ifndef BATTEN_TESTS_TIMING_H
#define BATTEN_TESTS_TIMING_H

#include <cmocka.h>
#include <batten/camera.h>
#include "support/random_curve.h"

static inline bat_camera *along(random_source *r, bool closed) {
    bat_curve *path = random_curve(r, 3, 3, closed ? 2 : 0, 8);
    bat_camera *camera = NULL;
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_ALONG;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    bat_curve_free(path);
    return camera;
}

/* The share of the distance after a share of the time. */
static inline double share_at(const bat_camera *camera, double time) {
    bat_camera_pose pose;
    bat_camera_at_time(camera, time * bat_camera_duration(camera), &pose);
    return pose.distance / bat_camera_length(camera);
}

static inline void never_falls(const bat_camera *camera) {
    const bat_curve *curve = bat_camera_timing(camera)->curve;
    const double *points = bat_curve_points(curve);
    const int size = bat_curve_dimension(curve);
    const size_t count = bat_curve_count(curve);
    assert_true(points[0] == 0 && points[(count - 1) * (size_t)size] == 1);
    for (size_t i = 1; i < count; i++)
        assert_true(points[i * (size_t)size] >= points[(i - 1) * (size_t)size]);
}

#endif
