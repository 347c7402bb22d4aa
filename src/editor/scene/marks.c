#include "editor/scene/marks.h"

#include "document/clip.h"
#include "document/markers.h"
#include "document/paint.h"
#include "editor/scene/clips.h"
#include "editor/scene/paint.h"
#include "editor/scene/path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void bat_scene_marks_free(bat_scene_marks *marks) {
    for (int i = 0; i < marks->count; i++) {
        free((void *)marks->items[i].path);
        free((void *)marks->items[i].paint);
    }
    free(marks->items);
    free(marks);
}

/* A path of the marker; false: out of memory. */
static bool make_item(const bat_object *object, const double origin[2], bat_item *out) {
    const bat_style *style = bat_object_style(object);
    bat_path path = {.origin = {origin[0], origin[1]}};
    uint32_t paint_count = 0;
    float *paint = NULL;
    for (int i = 0; i < bat_object_curve_count(object); i++)
        bat_path_curve(&path, bat_object_curve(object, i));
    if (!path.failed && bat_object_paint(object))
        paint = bat_paint_floats(bat_object_paint(object), origin, &paint_count);
    if (path.failed || (bat_object_paint(object) && !paint)) {
        free(path.data);
        return false;
    }
    *out = (bat_item){.role = BAT_ROLE_OBJECT,
                      .flags = (style->stroked ? BAT_ITEM_STROKED : 0u) |
                               (style->filled ? BAT_ITEM_FILLED : 0u) |
                               (style->even_odd ? BAT_ITEM_EVEN_ODD : 0u),
                      .path_count = (uint32_t)path.count,
                      .path = path.data,
                      .paint_count = paint_count,
                      .paint = paint};
    bat_paint_style(style, out);
    if (paint && bat_object_paint(object)->stroke_first) out->flags |= BAT_ITEM_STROKE_FIRST;
    const double more = bat_paint_reach(style, bat_object_paint(object));
    double box[4];
    bat_object_bounds(object, box);
    for (int i = 0; i < 4; i++)
        out->bounds[i] = bat_path_float(box[i] + (i < 2 ? -more : more) - origin[i & 1]);
    return true;
}

/* The path, within its regions. */
static bat_status add(bat_scene_marks *marks, const bat_object *object, const double origin[2]) {
    const bat_clip *clip = bat_object_clip(object);
    const int regions = bat_clip_count(clip);
    bat_scene_region *list = clip ? bat_scene_regions(clip, origin) : NULL;
    bat_item own;
    if (clip && !list) return BAT_MEMORY;
    if (!make_item(object, origin, &own)) {
        bat_scene_regions_free(list, clip);
        return BAT_MEMORY;
    }
    for (int k = 0; k < regions && list; k++) {
        bat_item *item = &marks->items[marks->count++];
        *item = bat_scene_region_item(&list[k]);
        item->picture = (uint32_t)(regions - k);
        memcpy(item->bounds, own.bounds, sizeof own.bounds);
    }
    free(list); /* its paths are the items' */
    marks->items[marks->count++] = own;
    bat_box_add(marks->bounds, own.bounds);
    return BAT_OK;
}

bat_status bat_scene_marks_create(const bat_object *object, const double origin[2], bat_scene_marks **out) {
    bat_object **list = NULL;
    int count = 0, room = 0;
    *out = NULL;
    bat_status status = bat_object_mark(object, &count, &list);
    if (status != BAT_OK || count == 0) return status == BAT_MEMORY ? status : BAT_OK;
    for (int i = 0; i < count; i++) room += 1 + bat_clip_count(bat_object_clip(list[i]));
    bat_scene_marks *made = calloc(1, sizeof *made);
    if (made) made->items = calloc((size_t)room, sizeof *made->items);
    if (!made || !made->items) status = BAT_MEMORY;
    if (status == BAT_OK) {
        made->order = (int)bat_markers_marked(bat_object_markers(object))->order;
        bat_box_clear(made->bounds);
    }
    for (int i = 0; i < count; i++) {
        if (status == BAT_OK) status = add(made, list[i], origin);
        bat_object_release(list[i]);
    }
    free(list);
    if (status == BAT_OK)
        *out = made;
    else if (made)
        bat_scene_marks_free(made);
    return status;
}

static int put(bat_item *items, int count, const bat_item *from, int more) {
    memcpy(items + count, from, (size_t)more * sizeof *from);
    return count + more;
}

int bat_scene_marks_show(const bat_scene_marks *marks, const bat_item *item, const bat_item *own, int count,
                         bat_item *items) {
    const bool group = item->opacity < 1;
    const unsigned both = BAT_ITEM_FILLED | BAT_ITEM_STROKED;
    bat_item halves[2] = {*item, *item};
    int made = 0, before = marks->order == BAT_MARKERS_FIRST ? 0 : count;
    if (marks->order == BAT_MARKERS_BETWEEN && count == 1 && (item->flags & both) == both) {
        const int fill = item->flags & BAT_ITEM_STROKE_FIRST ? 1 : 0;
        halves[fill].flags &= ~(unsigned)(BAT_ITEM_STROKED | BAT_ITEM_STROKE_FIRST);
        halves[1 - fill].flags &= ~(unsigned)(BAT_ITEM_FILLED | BAT_ITEM_STROKE_FIRST);
        halves[1].id = halves[1].version = 0; /* an id names one path */
        own = halves, count = 2, before = 1;
    } else if (marks->order == BAT_MARKERS_BETWEEN && count == 1)
        before = (item->flags & BAT_ITEM_FILLED) || (item->flags & BAT_ITEM_STROKE_FIRST) ? 1 : 0;
    if (group) {
        items[made++] = (bat_item){
            .role = BAT_ROLE_GROUP, .opacity = item->opacity, .picture = (uint32_t)(count + marks->count)};
        memcpy(items[0].bounds, item->bounds, sizeof item->bounds);
    }
    made = put(items, made, own, before);
    made = put(items, made, marks->items, marks->count);
    made = put(items, made, own + before, count - before);
    for (int i = group; i < made && group; i++) {
        const int at = i - group;
        if (at < before || at >= before + marks->count) items[i].opacity = 1;
    }
    return made;
}
