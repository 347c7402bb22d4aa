#include "editor/scene/wide.h"

#include "editor/scene/paint.h"
#include "editor/scene/path.h"

#include <batten/bezier.h>

#include <stdlib.h>
#include <string.h>

static bat_status add_cover(bat_path *path, const bat_object *object, int curve) {
    size_t count = 0;
    double *p = NULL;
    const bat_status status = bat_object_cover(object, curve, &count, &p);
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        const double *b = p + 8 * i;
        const bool first = i == 0 || memcmp(b, b - 2, 2 * sizeof *b) != 0;
        if (first && i > 0) bat_path_close(path);
        if (first) bat_path_move(path, b[0], b[1]);
        bat_path_cubic(path, b + 2);
    }
    if (count && status == BAT_OK) bat_path_close(path);
    bat_free(p);
    return path->failed ? BAT_MEMORY : status;
}

bat_status bat_scene_wide_create(const bat_object *object, const double origin[2], uint32_t version,
                                 bat_scene_wide **out) {
    const bat_paint *paint = bat_object_paint(object);
    bat_path path = {.origin = {origin[0], origin[1]}};
    bat_scene_wide *made = calloc(1, sizeof *made);
    bat_status status = made ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = add_cover(&path, object, i);
    if (status == BAT_OK && paint->stroke.count) {
        made->paint = bat_paint_floats(&(bat_paint){.fill = paint->stroke}, origin, &made->paint_count);
        if (!made->paint) status = BAT_MEMORY;
    }
    *out = NULL;
    if (status != BAT_OK) {
        free(path.data);
        bat_scene_wide_free(made);
        return status == BAT_MEMORY ? status : BAT_OK;
    }
    made->path = path.data, made->count = (uint32_t)path.count, made->version = version;
    *out = made;
    return BAT_OK;
}

void bat_scene_wide_free(bat_scene_wide *wide) {
    if (!wide) return;
    free(wide->path);
    free(wide->paint);
    free(wide);
}

int bat_scene_wide_show(const bat_scene_wide *wide, const bat_item *item, bat_item *items) {
    const bool both = item->flags & BAT_ITEM_FILLED, group = both && item->opacity < 1;
    const bool first = item->flags & BAT_ITEM_STROKE_FIRST;
    int count = 0;
    bat_item stroke = *item, fill = *item;
    stroke.id = both ? 0 : item->id; /* an id names one path */
    stroke.version = both ? 0 : wide->version;
    stroke.flags = BAT_ITEM_FILLED;
    stroke.fill = item->stroke;
    stroke.path = wide->path, stroke.path_count = wide->count;
    stroke.paint = wide->paint, stroke.paint_count = wide->paint_count;
    fill.flags &= (uint32_t) ~(BAT_ITEM_STROKED | BAT_ITEM_STROKE_FIRST);
    if (group) {
        items[count++] = (bat_item){.role = BAT_ROLE_GROUP, .opacity = item->opacity, .picture = 2};
        memcpy(items[0].bounds, item->bounds, sizeof item->bounds);
        stroke.opacity = fill.opacity = 1;
    }
    if (both && !first) items[count++] = fill;
    items[count++] = stroke;
    if (both && first) items[count++] = fill;
    return count;
}
