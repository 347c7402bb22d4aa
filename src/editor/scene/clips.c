#include "editor/scene/clips.h"

#include "editor/scene/path.h"

#include <stdlib.h>

/* As pictures lie. */
static void go_round(bat_path *path, const bat_clip *mask) {
    double corners[8];
    bat_clip_corners(mask, corners);
    bat_path_polygon(path, 2, 4, corners, true);
}

bat_scene_region *bat_scene_regions(const bat_clip *clip, const double origin[2]) {
    int at = bat_clip_count(clip);
    bat_scene_region *made = calloc((size_t)at, sizeof *made);
    for (const bat_clip *region = clip; region && made; region = bat_clip_within(region)) {
        bat_path path = {.origin = {origin[0], origin[1]}};
        const bat_picture *picture = bat_clip_picture(region);
        if (picture) go_round(&path, region);
        for (int i = 0; i < bat_clip_curve_count(region) && !picture; i++)
            bat_path_curve(&path, bat_clip_curve(region, i));
        made[--at] = (bat_scene_region){path.data, (uint32_t)path.count,
                                        bat_clip_is_even_odd(region) ? BAT_ITEM_EVEN_ODD : 0,
                                        picture ? (uint32_t)bat_picture_digest(picture) : 0};
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

bat_item bat_scene_region_item(const bat_scene_region *region) {
    return (bat_item){.role = BAT_ROLE_CLIP,
                      .flags = region->flags,
                      .fill = region->picture,
                      .opacity = 1,
                      .path_count = region->count,
                      .path = region->path};
}
