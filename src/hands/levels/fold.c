/* Details take over the frames that the curves alone give (math 3.4). */
#include "hands/levels/shape.h"

#include <stdlib.h>
#include <string.h>

bat_status bat_shape_fold(bat_shape *shape, bool near) {
    bool moved = false;
    for (int l = 1; l <= shape->count; l++) {
        bat_level *at = &shape->levels[l - 1];
        bat_triad *fresh = malloc((size_t)at->count * sizeof *fresh);
        if (!fresh) return BAT_MEMORY;
        if (!near) shape->holonomy[l - 1] = 0;
        bat_status status = bat_shape_frames_of(shape, l, fresh);
        for (int i = 0; i < at->count && status == BAT_OK; i++)
            moved = bat_triad_turn_back(&at->frames[i], &fresh[i], at->details + 3 * i) || moved;
        if (status == BAT_OK) memcpy(at->frames, fresh, (size_t)at->count * sizeof *fresh);
        free(fresh);
        if (status == BAT_OK && moved) status = bat_level_build(at, bat_shape_curve(shape, l - 1));
        if (status != BAT_OK) return status;
    }
    shape->turned = false;
    return BAT_OK;
}
