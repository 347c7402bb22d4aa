/* Details take over the frames that the curves alone give (math 3.4). */
#include "hands/levels/shape.h"

bat_status bat_shape_fold(bat_shape *shape, bool near) {
    bool moved = false;
    for (int l = 1; l <= shape->count; l++) {
        bool folded;
        if (!near) shape->holonomy[l - 1] = 0;
        bat_status status = bat_shape_frames_of(shape, l, &folded);
        moved = folded || moved;
        if (status == BAT_OK && moved)
            status = bat_level_build(&shape->levels[l - 1], bat_shape_curve(shape, l - 1));
        if (status != BAT_OK) return status;
    }
    shape->turned = false;
    return BAT_OK;
}
