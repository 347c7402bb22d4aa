/* What of objects and groups is seen, as hosts get it: items of the role CLIP. */
#ifndef BATTEN_EDITOR_SCENE_CLIPS_H
#define BATTEN_EDITOR_SCENE_CLIPS_H

#include "document/clip.h"

#include <batten/editor.h>

/* A region, from the outermost one inwards; picture: the number of a mask's, whose corners the path goes round, else 0. */
typedef struct bat_scene_region {
    float *path;
    uint32_t count, flags, picture;
} bat_scene_region;

/* One for each region of the clip. NULL: out of memory. */
bat_scene_region *bat_scene_regions(const bat_clip *clip, const double origin[2]);
void bat_scene_regions_free(bat_scene_region *regions, const bat_clip *clip); /* NULL is fine */
bat_item bat_scene_region_item(const bat_scene_region *region);

#endif
