#include "editor/scene/scene.h"
#include "editor/scene/image.h"
#include "editor/scene/paint.h"
#include "curve/curve.h"
#include "document/paint.h"
#include "document/kind.h"
#include "document/markers.h"
#include "document/nesting.h"
#include "editor/scene/solid.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const float PALE = 0.2F;          /* factor on the opacity of what is not isolated, or a ghost */
static const uint32_t BARE = 0x707880ff; /* of surfaces without a stroke */
static const uint32_t ITEM_PAGE = 0xffffffff;

void bat_scene_init(bat_scene *scene) {
    *scene = (bat_scene){.revision = UINT64_MAX};
    bat_box_clear(scene->dirty);
}

static void free_lines(bat_scene_entry *entry) {
    for (int i = 0; entry->lines && i < bat_object_curve_count(entry->object); i++) {
        bat_finder_free(entry->lines[i].finder);
        bat_curve_free(entry->lines[i].picture);
    }
    free(entry->lines);
    entry->lines = NULL;
}

static void drop_marks(bat_scene_entry *entry) {
    if (entry->marks) bat_scene_marks_free(entry->marks);
    entry->marks = NULL;
}

static void free_entry(bat_scene_entry *entry) {
    free_lines(entry);
    if (entry->solid) bat_solid_free(entry->solid);
    free(entry->path);
    free(entry->paint);
    bat_scene_wide_free(entry->wide);
    drop_marks(entry);
    bat_scene_regions_free(entry->regions, bat_object_clip(entry->object));
    bat_object_release(entry->posed);
    bat_object_release(entry->object);
}

void bat_scene_free(bat_scene *scene) {
    for (int i = 0; i < scene->count; i++) free_entry(&scene->entries[i]);
    free(scene->entries);
    free(scene->items);
    if (scene->space) bat_space_free(scene->space);
    if (scene->lens) bat_space_free(scene->lens);
    bat_scene_init(scene);
}

static bool is_ghost(const bat_scene *scene, const bat_scene_entry *entry) {
    return scene->ghost && bat_object_id(entry->object) == scene->ghost;
}

/* What is painted of an entry: of the ghost what it is, since something else shows how it stands. */
static const bat_object *shown(const bat_scene *scene, const bat_scene_entry *entry) {
    return entry->posed && !is_ghost(scene, entry) ? entry->posed : entry->object;
}

static const double *map_of(const bat_scene *scene) { return scene->tilted ? scene->map : NULL; }

/* The entry's box: tilted, that of its control points. */
static void find_box(const bat_scene *scene, bat_scene_entry *entry) {
    const bat_object *object = shown(scene, entry);
    double *box = entry->box, at[2], corners[8];
    bat_object_bounds(object, box);
    if (!scene->tilted || !(box[0] <= box[2])) return;
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    const int curves = bat_object_curve_count(object);
    const bool picture = bat_object_picture(object) != NULL;
    if (picture) bat_object_corners(object, corners);
    for (int i = 0; i < curves + picture; i++) {
        const bat_curve *curve = i < curves ? bat_object_curve(object, i) : NULL;
        const int count = curve ? bat_point_count(curve) : 4, size = curve ? bat_curve_dimension(curve) : 2;
        const double *points = curve ? bat_curve_points(curve) : corners;
        for (int j = 0; j < count; j++, points += size) {
            const bool seen = bat_map_look(scene->map, size, points, at);
            for (int k = 0; k < 2; k++) { /* what reaches behind the eye can be seen anywhere */
                box[k] = fmin(box[k], seen ? at[k] : -BAT_NOWHERE);
                box[k + 2] = fmax(box[k + 2], at[k]);
            }
        }
    }
}

/* Else it would only be seen where it is shaded. */
static void show_bare(bat_item *item) {
    item->flags |= BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH;
    item->stroke = BARE;
    item->width = 1;
}

/* Whether it paints anything but widths. */
static bool paints(const bat_paint *paint) {
    bat_paint rest = *paint;
    rest.width_count = 0;
    return !bat_paint_is_plain(&rest);
}

/* What paints the entry beside its style, in place of what did before. */
static bool make_paint(bat_scene *scene, bat_scene_entry *entry, uint32_t *count) {
    const bat_paint *own = scene->tilted ? NULL : bat_object_paint(entry->object);
    float *paint = NULL;
    bat_scene_wide *wide = NULL;
    bool failed = own && bat_object_widths(entry->object).count &&
                  bat_scene_wide_create(entry->object, scene->origin, ++scene->versions, &wide) != BAT_OK;
    if (own && !failed && paints(own)) failed = !(paint = bat_paint_floats(own, scene->origin, count));
    if (failed) {
        bat_scene_wide_free(wide);
        return false;
    }
    free(entry->paint);
    bat_scene_wide_free(entry->wide);
    entry->paint = paint;
    entry->wide = wide;
    return true;
}

/* Its markers, in place of those that it had. */
static bool make_marks(bat_scene *scene, bat_scene_entry *entry) {
    bat_scene_marks *marks = NULL;
    if (!scene->tilted && bat_object_markers(entry->object) &&
        bat_scene_marks_create(entry->object, scene->origin, &marks) != BAT_OK)
        return false;
    drop_marks(entry);
    entry->marks = marks;
    return true;
}

static bool make_path(bat_scene *scene, bat_scene_entry *entry) {
    bat_path path = {
        .origin = {scene->origin[0], scene->origin[1]}, .map = map_of(scene), .tolerance = scene->tolerance};
    const bat_object *object = shown(scene, entry);
    for (int i = 0; i < bat_object_curve_count(object); i++)
        bat_path_curve(&path, bat_object_curve(object, i));
    const bat_picture *picture = bat_object_picture(entry->object);
    if (picture) {
        double corners[8];
        bat_object_corners(entry->object, corners);
        bat_path_polygon(&path, 2, 4, corners, true);
    }
    if (path.failed) {
        free(path.data);
        return false;
    }
    const bat_paint *own = scene->tilted ? NULL : bat_object_paint(entry->object);
    uint32_t paint_count = 0;
    if (!make_marks(scene, entry) || !make_paint(scene, entry, &paint_count)) {
        free(path.data);
        return false;
    }
    free(entry->path);
    entry->path = path.data;

    const bat_style *style = bat_object_style(entry->object);
    bat_item *item = &entry->item;
    *item = (bat_item){.id = (uint32_t)bat_object_id(entry->object),
                       .version = ++scene->versions,
                       .role = BAT_ROLE_OBJECT,
                       .path_count = (uint32_t)path.count,
                       .path = path.data,
                       .paint_count = paint_count,
                       .paint = entry->paint};
    bat_paint_style(style, item);
    if (picture) {
        item->role = BAT_ROLE_IMAGE;
        item->picture = (uint32_t)bat_picture_digest(picture);
    }
    if (style->stroked) item->flags |= BAT_ITEM_STROKED;
    if (bat_scene_is_bare(entry->object)) show_bare(item);
    if (style->filled && !bat_object_is(entry->object, BAT_FIXED)) item->flags |= BAT_ITEM_FILLED;
    if (style->even_odd) item->flags |= BAT_ITEM_EVEN_ODD;
    if (own && entry->paint && own->stroke_first) item->flags |= BAT_ITEM_STROKE_FIRST;
    const double more = bat_paint_reach(style, own);
    for (int i = 0; i < 4; i++)
        item->bounds[i] = bat_path_float(entry->box[i] + (i < 2 ? -more : more) - scene->origin[i & 1]);
    if (entry->marks) bat_box_add(item->bounds, entry->marks->bounds);
    return true;
}

bool bat_scene_is_bare(const bat_object *object) {
    return bat_object_surface(object) && !bat_object_style(object)->stroked;
}

static bat_item page_item(bat_scene *scene) {
    const double *page = scene->page;
    bat_path path = {.origin = {scene->origin[0], scene->origin[1]},
                     .map = map_of(scene),
                     .data = scene->page_path,
                     .room = 16};
    double corners[8];
    for (int i = 0; i < 4; i++) {
        corners[2 * i] = page[0] + (i == 1 || i == 2 ? page[2] : 0);
        corners[2 * i + 1] = page[1] + (i > 1 ? page[3] : 0);
    }
    bat_path_polygon(&path, 2, 4, corners, true); /* at most five corners */
    bat_item item = {.id = ITEM_PAGE,
                     .version = ++scene->versions,
                     .role = scene->behind ? BAT_ROLE_PAGE_BACK : BAT_ROLE_PAGE,
                     .flags = BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH,
                     .width = 1,
                     .opacity = 1,
                     .path_count = (uint32_t)path.count,
                     .path = scene->page_path};
    bat_path_bounds(&path, 0, item.bounds);
    return item;
}

/* The index in old[first..count) of the object's former entry, or -1. Looks only a little ahead: changes are local,
 * and a miss merely costs a rebuild. */
static int former(const bat_scene *scene, int first, const bat_object *object, bool same_pointer) {
    for (int i = first; i < scene->count && i < first + 8; i++) {
        const bat_object *other = scene->entries[i].object;
        if (other && (same_pointer ? other == object : bat_object_id(other) == bat_object_id(object)))
            return i;
    }
    return -1;
}

/* What takes an object's place takes over its buffers. */
static bat_solid *take_solid(bat_scene_entry *entry) {
    bat_solid *solid = entry->solid;
    entry->solid = NULL;
    if (solid) solid->old = true;
    return solid;
}

static void dirty_all(bat_scene *scene) {
    for (int i = 0; i < 4; i++) scene->dirty[i] = i < 2 ? -3e38f : 3e38f;
}

/* A group that is painted as one picture. */
static bool is_layer(const bat_object *object) {
    return bat_object_is_group(object) && bat_object_style(object)->opacity < 1;
}

/* A group that changes how what is in it is painted. */
static bool reaches_in(const bat_object *object) {
    return is_layer(object) || (bat_object_is_group(object) && bat_object_clip(object));
}

/* Makes entries for the document's objects: those that still exist are moved over, the rest are dropped and counted
 * dirty. */
static bat_status mirror(bat_scene *scene, const bat_document *document) {
    const bat_isolation *isolation = scene->isolation;
    int count = bat_document_count(document);
    bat_scene_entry *entries = calloc((size_t)count + 1, sizeof *entries);
    if (!entries) return BAT_MEMORY;
    int old = 0;
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(document, i);
        int found = former(scene, old, object, true);
        if (found >= 0) {
            entries[i] = scene->entries[found];
            scene->entries[found].object = NULL; /* moved */
            old = found + 1;
        } else {
            entries[i].object = bat_object_retain(object);
            if (reaches_in(object)) dirty_all(scene);
            find_box(scene, &entries[i]);
            found = former(scene, old, object, false); /* replaced: keeps the two walks in step */
            if (found >= 0) old = found + 1;
            if (found >= 0) entries[i].solid = take_solid(&scene->entries[found]);
        }
    }
    for (int i = 0; i < scene->count; i++)
        if (scene->entries[i].object) {
            if (reaches_in(scene->entries[i].object)) dirty_all(scene);
            if (scene->entries[i].path) bat_box_add(scene->dirty, scene->entries[i].item.bounds);
            free_entry(&scene->entries[i]);
        }
    free(scene->entries);
    scene->entries = entries;
    scene->count = count;
    /* A change to a group affects everything in it. */
    bat_nesting nesting = {0};
    for (int i = 0, end = 0; i < count; i++) {
        bat_nesting_level level = {0};
        bat_id id = bat_object_id(entries[i].object);
        if (isolation && i >= end && (id >= isolation->from || bat_selection_has(&isolation->kept, id)))
            end = bat_document_end(document, i);
        entries[i].pale = isolation && i >= end;
        bat_nesting_next(&nesting, entries[i].object, &level);
        if (entries[i].path && level.hidden != entries[i].hidden)
            bat_box_add(scene->dirty, entries[i].item.bounds);
        entries[i].hidden = level.hidden;
        entries[i].around = (float)level.around;
        entries[i].locked = level.locked || entries[i].pale;
    }
    return BAT_OK;
}

void bat_scene_look(bat_scene *scene, bool outline, const bat_isolation *isolation) {
    uint32_t version = isolation->on ? isolation->kept.version + 1 : 0;
    scene->isolation = isolation->on ? isolation : NULL;
    if (scene->outline == outline && scene->isolated == version) return;
    scene->outline = outline;
    scene->isolated = version;
    scene->revision = UINT64_MAX;
    dirty_all(scene);
}

void bat_scene_ghost(bat_scene *scene, bat_id id) {
    if (scene->ghost == id) return;
    scene->ghost = id;
    for (int i = 0; i < scene->count; i++) scene->entries[i].moved |= scene->entries[i].posed != NULL;
    scene->revision = UINT64_MAX;
    dirty_all(scene);
}

bat_item bat_scene_painted(const bat_scene *scene, const bat_scene_entry *entry) {
    bat_item item = entry->item;
    if (scene->outline && item.role == BAT_ROLE_OBJECT) {
        item.flags = BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH;
        item.paint = NULL;
        item.paint_count = 0;
        item.stroke = 0x000000ff;
        item.width = item.opacity = 1;
    }
    if (scene->tilted && !scene->outline) item.opacity *= entry->around;
    if (entry->pale) item.opacity *= PALE;
    return item;
}

void bat_scene_stand(bat_scene *scene, double time) {
    if (scene->time == time) return;
    scene->time = time;
    scene->stale = scene->stale || scene->bodies;
}

const bat_object *bat_scene_standing(bat_scene *scene, bat_scene_entry *entry) {
    bat_object *posed = NULL;
    if (!bat_object_motion(entry->object, NULL)) return entry->object;
    if (entry->posed ? entry->posed_at == scene->time : scene->time == 0)
        return entry->posed ? entry->posed : entry->object;
    if (bat_object_at_time(entry->object, scene->time, &posed) != BAT_OK) return NULL;
    bat_object_release(entry->posed);
    entry->posed = posed;
    entry->posed_at = scene->time;
    if (!is_ghost(scene, entry)) entry->moved = scene->stale = true;
    if (entry->solid) entry->solid->old = true;
    return posed;
}

const bat_object *bat_scene_shown(const bat_scene *scene, int index) {
    return shown(scene, &scene->entries[index]);
}

/* The path of an entry as it is now; false: memory ran out, and it is as it was. */
static bool renew(bat_scene *scene, bat_scene_entry *entry) {
    const bool made = is_ghost(scene, entry) || bat_scene_standing(scene, entry);
    if (entry->path && !entry->moved) return made;
    if (entry->path) bat_box_add(scene->dirty, entry->item.bounds);
    if (entry->moved) {
        free_lines(entry);
        find_box(scene, entry);
    }
    if (!make_path(scene, entry)) return false;
    entry->moved = false;
    bat_box_add(scene->dirty, entry->item.bounds);
    return made;
}

enum { LAYERS = (BAT_NESTING_MAX + 1) * (BAT_CLIP_REGIONS_MAX + 1) };

/* The items of groups that are painted as one picture, and of clips: where they are in the list, until their objects end. */
typedef struct layers {
    int item[LAYERS], end[LAYERS];
    int depth;
} layers;

/* Counts what is in the groups that end before the object of that index. */
static void end_layers(layers *l, bat_item *items, int index, int count) {
    for (; l->depth > 0 && l->end[l->depth - 1] <= index; l->depth--) {
        bat_item *group = &items[l->item[l->depth - 1]];
        group->picture = (uint32_t)(count - l->item[l->depth - 1] - 1);
        bat_box_clear(group->bounds);
        for (uint32_t i = 1; i <= group->picture; i++) bat_box_add(group->bounds, group[i].bounds);
    }
}

static bat_item layer_item(bat_scene *scene, const bat_object *object) {
    return (bat_item){.id = (uint32_t)bat_object_id(object),
                      .version = ++scene->versions,
                      .role = BAT_ROLE_GROUP,
                      .opacity = (float)bat_object_style(object)->opacity};
}

static void begin_layer(layers *l, int item, int end) {
    l->item[l->depth] = item;
    l->end[l->depth++] = end;
}

static bat_item region_item(bat_scene *scene, const bat_scene_entry *entry, int region) {
    /* Behind the numbers of objects. */
    const uint32_t id = region == 0 ? 1u << 31 | (uint32_t)bat_object_id(entry->object) : 0;
    bat_item item = bat_scene_region_item(&entry->regions[region]);
    item.id = id;
    item.version = id ? ++scene->versions : 0;
    return item;
}

/* Adds the items that a group or an object begins with; returns how many there are in all. */
static int show_around(bat_scene *scene, bat_scene_entry *entry, int end, layers *open, bat_item *items,
                       int count) {
    const bat_clip *clip = bat_object_clip(entry->object);
    if (scene->tilted || scene->outline || open->depth + BAT_CLIP_REGIONS_MAX >= LAYERS) return count;
    if (clip && !entry->regions && !(entry->regions = bat_scene_regions(clip, scene->origin)))
        scene->stale = true; /* retried with the next frame */
    for (int k = 0; k < bat_clip_count(clip) && entry->regions; k++) {
        begin_layer(open, count, end);
        items[count++] = region_item(scene, entry, k);
    }
    if (!is_layer(entry->object)) return count;
    begin_layer(open, count, end);
    items[count++] = layer_item(scene, entry->object);
    return count;
}

/* The most items that there can be. */
static size_t item_room(const bat_document *document) {
    size_t room = (size_t)bat_document_count(document) + 1;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        room += (size_t)bat_clip_count(bat_object_clip(object));
        if (bat_object_paint(object)) room += BAT_WIDE_ITEMS - 1;
    }
    return room;
}

/* Empties the scene: better than stale entries, whose indices belong to other objects now. */
static void drop(bat_scene *scene) {
    for (int i = 0; i < scene->count; i++) free_entry(&scene->entries[i]);
    free(scene->entries);
    scene->entries = NULL;
    scene->count = scene->item_count = 0;
    scene->still_version++;
    dirty_all(scene);
}

/* The page's item, if there is a page. Returns how many items that makes. */
static int show_page(bat_scene *scene, const bat_document *document, bat_item *items) {
    double page[4];
    bat_document_page(document, page);
    if (!(page[2] > 0)) return 0;
    const bool same = scene->item_count && scene->items[0].id == ITEM_PAGE &&
                      !memcmp(page, scene->page, sizeof page) && scene->items[0].version;
    memcpy(scene->page, page, sizeof page);
    if (same)
        items[0] = scene->items[0];
    else {
        items[0] = page_item(scene);
        bat_box_add(scene->dirty, items[0].bounds);
    }
    return 1;
}

/* Adds what is painted of an entry, as the item says; returns how many items there are in all. Markers may need more room; without
 * memory for it they are not shown. */
static int show_entry(const bat_scene *scene, const bat_scene_entry *entry, const bat_item *item,
                      bat_item **items, size_t *room, int count) {
    bat_item own[BAT_WIDE_ITEMS] = {*item};
    const bool marked = entry->marks && !scene->outline;
    if (marked) own[0].opacity = 1;
    const bat_item base = own[0];
    const int made = entry->wide && !scene->outline ? bat_scene_wide_show(entry->wide, &base, own) : 1;
    const size_t more = marked ? (size_t)entry->marks->count + BAT_MARKS_ITEMS : 0;
    bat_item *grown = more ? realloc(*items, (*room + more) * sizeof *grown) : NULL;
    if (grown) {
        *items = grown;
        *room += more;
        return count + bat_scene_marks_show(entry->marks, item, own, made, grown + count);
    }
    memcpy(*items + count, own, (size_t)made * sizeof *own);
    return count + made;
}

bat_status bat_scene_sync(bat_scene *scene, const bat_document *document, uint64_t revision) {
    if (scene->revision == revision && !scene->stale) return BAT_OK;
    int count = bat_document_count(document);
    size_t room = item_room(document);
    bat_item *items = calloc(room, sizeof *items);
    bat_status status = items ? BAT_OK : BAT_MEMORY;
    if (scene->revision != revision) {
        if (status == BAT_OK) status = mirror(scene, document);
        if (status != BAT_OK) drop(scene);
    }
    if (status != BAT_OK) {
        free(items);
        return status;
    }
    scene->surfaces = scene->bodies = false;
    bool again = false;
    int item_count = show_page(scene, document, items);
    layers open = {.depth = 0};
    for (int i = 0; i < count; i++) {
        bat_scene_entry *entry = &scene->entries[i];
        end_layers(&open, items, i, item_count);
        if (!entry->hidden)
            item_count = show_around(scene, entry, bat_document_end(document, i), &open, items, item_count);
        if (entry->hidden || !bat_object_is_drawn(entry->object)) continue;
        scene->surfaces = scene->surfaces || bat_object_surface(entry->object) ||
                          bat_object_mesh(entry->object);
        scene->bodies = scene->bodies || (bat_object_motion(entry->object, NULL) && !is_ghost(scene, entry));
        if (!renew(scene, entry)) {
            again = true; /* with the next frame */
            status = BAT_MEMORY;
        }
        bat_item item = bat_scene_painted(scene, entry);
        if (is_ghost(scene, entry) && !entry->pale) item.opacity *= PALE;
        item_count = show_entry(scene, entry, &item, &items, &room, item_count);
    }
    end_layers(&open, items, count, item_count);
    free(scene->items);
    scene->items = items;
    scene->item_count = item_count;
    scene->still_version++;
    scene->revision = revision;
    scene->stale = again;
    return status;
}

/* All paths have to be made anew. */
static void lose_paths(bat_scene *scene) {
    for (int i = 0; i < scene->count; i++) {
        free(scene->entries[i].path);
        free(scene->entries[i].paint);
        bat_scene_regions_free(scene->entries[i].regions, bat_object_clip(scene->entries[i].object));
        bat_scene_wide_free(scene->entries[i].wide);
        drop_marks(&scene->entries[i]);
        scene->entries[i].path = scene->entries[i].paint = NULL;
        scene->entries[i].wide = NULL;
        scene->entries[i].regions = NULL;
        scene->entries[i].item = (bat_item){0};
    }
    scene->item_count = 0;
    scene->stale = true;
    dirty_all(scene);
}

void bat_scene_face(bat_scene *scene, const bat_stage *stage) {
    const bool tilted = bat_stage_tilted(stage);
    double map[BAT_MAP_NUMBERS];
    bat_stage_space_map(stage, map);
    if (tilted == scene->tilted && (!tilted || !memcmp(map, scene->map, sizeof map))) return;
    scene->tilted = tilted;
    scene->behind = bat_stage_behind(stage);
    scene->tolerance = bat_stage_deep(stage) ? bat_view_tolerance(&stage->view) : 0;
    memcpy(scene->map, map, sizeof map);
    lose_paths(scene);
    for (int i = 0; i < scene->count; i++) {
        free_lines(&scene->entries[i]);
        find_box(scene, &scene->entries[i]);
    }
}

void bat_scene_rebase(bat_scene *scene, const bat_stage *stage) {
    double middle[2];
    bat_stage_seen(stage, (double[]){stage->view.width / 2, stage->view.height / 2}, middle);
    double away = fmax(fabs(middle[0] - scene->origin[0]), fabs(middle[1] - scene->origin[1]));
    if (away * stage->view.zoom * 0x1p-24 <= 0.25) return;
    memcpy(scene->origin, middle, sizeof middle);
    lose_paths(scene);
}

/* The curve as it is seen in a tilted view, in the plane. */
static bat_status image_of(const bat_curve *curve, const bat_scene *scene, bat_curve **out) {
    const double *map = scene->map;
    if (scene->tolerance > 0) return bat_image_create(curve, map, scene->tolerance, out);
    const bool space = bat_curve_dimension(curve) == 3;
    const double flat[6] = {map[0], map[1], map[3], map[4], map[5], map[7]};
    double deep[12] = {0};
    bat_curve *image = NULL;
    memcpy(deep, map, 8 * sizeof *map);
    bat_status status = bat_curve_transform(curve, space ? deep : flat, space ? &image : out);
    if (status == BAT_OK && space) status = bat_curve_to_dimension(image, 2, out);
    bat_curve_free(image);
    return status;
}

static bat_scene_line *line_of(bat_scene *scene, int index, int curve) {
    bat_scene_entry *entry = &scene->entries[index];
    if (!entry->lines)
        entry->lines = calloc((size_t)bat_object_curve_count(entry->object), sizeof *entry->lines);
    return entry->lines ? &entry->lines[curve] : NULL;
}

const bat_curve *bat_scene_seen(bat_scene *scene, int index, int curve) {
    const bat_curve *own = bat_object_curve(shown(scene, &scene->entries[index]), curve);
    if (!scene->tilted && bat_curve_dimension(own) == 2) return own;
    bat_scene_line *line = line_of(scene, index, curve);
    if (!line) return NULL;
    if (!line->picture && scene->tilted) image_of(own, scene, &line->picture);
    if (!line->picture && !scene->tilted) bat_curve_to_dimension(own, 2, &line->picture);
    return line->picture;
}

const bat_finder *bat_scene_finder(bat_scene *scene, int index, int curve) {
    bat_scene_line *line = line_of(scene, index, curve);
    if (!line || line->finder) return line ? line->finder : NULL;
    const bat_curve *seen = bat_scene_seen(scene, index, curve);
    if (seen) bat_finder_create(seen, &line->finder);
    return line->finder;
}
