#include "editor/scene/clips.h"

#include "editor/scene/path.h"

#include <stdlib.h>

bat_scene_region *bat_scene_regions(const bat_clip *clip, const double origin[2]) {
    int at = bat_clip_count(clip);
    bat_scene_region *made = calloc((size_t)at, sizeof *made);
    for (const bat_clip *region = clip; region && made; region = bat_clip_within(region)) {
        bat_path path = {.origin = {origin[0], origin[1]}};
        for (int i = 0; i < bat_clip_curve_count(region); i++)
            bat_path_curve(&path, bat_clip_curve(region, i));
        made[--at] = (bat_scene_region){path.data, (uint32_t)path.count,
                                        bat_clip_is_even_odd(region) ? BAT_ITEM_EVEN_ODD : 0};
        if (!path.failed) continue;
        bat_scene_regions_free(made, clip);
        return NULL;
    }
    return made;
}

void bat_scene_regions_free(bat_scene_region *regions, const bat_clip *clip) {
    for (int i = 0; regions && i < bat_clip_count(clip); i++) free(regions[i].path);
    free(regions);
}
