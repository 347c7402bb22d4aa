#include "editor/tools/levels/ladder.h"

#include "curve/curve.h"
#include <batten/levels.h>
#include <batten/relief.h>

int bat_ladder_levels(bat_ladder ladder) {
    if (ladder.relief) return bat_relief_levels(ladder.relief);
    return ladder.shape ? bat_shape_levels(ladder.shape) : 0;
}

double bat_ladder_points(bat_ladder ladder, int level) {
    if (!ladder.relief) return bat_point_count(bat_shape_curve(ladder.shape, level));
    const bat_surface *surface = bat_relief_surface(ladder.relief, level);
    return (double)(bat_surface_count(surface, BAT_U) * bat_surface_count(surface, BAT_V));
}

double bat_ladder_gain(bat_ladder ladder, int level) {
    return ladder.relief ? bat_relief_gain(ladder.relief, level) : bat_shape_gain(ladder.shape, level);
}

bool bat_ladder_is_muted(bat_ladder ladder, int level) {
    return ladder.relief ? bat_relief_is_muted(ladder.relief, level)
                         : bat_shape_is_muted(ladder.shape, level);
}

bat_status bat_ladder_copy(bat_ladder from, bat_ladder *out) {
    bat_relief *relief = NULL;
    bat_shape *shape = NULL;
    bat_status status = from.relief  ? bat_relief_copy(from.relief, &relief)
                        : from.shape ? bat_shape_copy(from.shape, &shape)
                                     : BAT_STATE;
    if (status == BAT_OK) *out = (bat_ladder){shape, relief};
    return status;
}

bat_status bat_ladder_set_gain(bat_ladder ladder, int level, double gain) {
    return ladder.relief ? bat_relief_set_gain((bat_relief *)ladder.relief, level, gain)
                         : bat_shape_set_gain((bat_shape *)ladder.shape, level, gain);
}

bat_status bat_ladder_set_muted(bat_ladder ladder, int level, bool muted) {
    return ladder.relief ? bat_relief_set_muted((bat_relief *)ladder.relief, level, muted)
                         : bat_shape_set_muted((bat_shape *)ladder.shape, level, muted);
}

void bat_ladder_free(bat_ladder *ladder) {
    bat_relief_free((bat_relief *)ladder->relief);
    bat_shape_free((bat_shape *)ladder->shape);
    *ladder = (bat_ladder){NULL, NULL};
}
