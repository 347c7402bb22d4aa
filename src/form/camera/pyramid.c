#include "form/camera/pyramid.h"
#include "base/quat.h"
#include "curve/curve.h"

#include <math.h>

static const double depth_share = 0.1, depth_alone = 24;

double bat_pyramid_depth(const bat_camera *camera) {
    const double size = bat_curve_size(bat_camera_path(camera));
    return size > 0 ? depth_share * size : depth_alone;
}

void bat_pyramid_of(const bat_camera_pose *pose, double depth, double points[3 * BAT_PYRAMID_CORNERS]) {
    /* c0 c1 (tip) c2 c3 c0 eye c2 c1 eye c3, the corners being those of the picture: bottom right, top right, top left, bottom
     * left */
    static const double sides[BAT_PYRAMID_CORNERS][3] = {{1, -1, 1},  {1, 1, 1},  {0, 1.5, 1}, {-1, 1, 1},
                                                         {-1, -1, 1}, {1, -1, 1}, {0, 0, 0},   {-1, 1, 1},
                                                         {1, 1, 1},   {0, 0, 0},  {-1, -1, 1}};
    const double half = 0.5 * fmin(fmax(pose->fov, 1), 150) * BAT_PI / 180;
    const double tall = depth * bat_sin(half) / bat_cos(half), wide = tall * 16 / 9;
    const quat q = quat_load(pose->rotation);
    for (int i = 0; i < BAT_PYRAMID_CORNERS; i++) {
        const double *s = sides[i];
        const vec v = quat_turn(q, (vec){s[0] * wide, s[1] * tall, -s[2] * depth});
        vec_store(vec_add(v, vec_load(pose->position, 3)), points + 3 * i);
    }
}
