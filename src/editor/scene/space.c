#include "editor/scene/space.h"
#include "base/real.h"
#include "document/kind.h"
#include "form/shade/colour.h"
#include "form/shade/curving.h"
#include "form/view/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const float pixels_before =
    2; /* by so many pixels a line may lie behind a surface and is not hidden */

bool bat_space_shows_surface(const bat_scene *scene) { return scene->surfaces; }

/* ---- the camera ---- */

/* Distances along the gaze between which everything lies. */
static void depths(const bat_scene *scene, const bat_gaze *gaze, const double origin[3], double range[2]) {
    range[0] = INFINITY, range[1] = -INFINITY;
    for (int i = 0; i < scene->count; i++) {
        const bat_solid *s = scene->entries[i].solid;
        if (!s || scene->entries[i].hidden || !(s->low[0] <= s->high[0])) continue;
        for (int k = 0; k < 8; k++) {
            const vec corner = {k & 1 ? s->low[0] : s->high[0], k & 2 ? s->low[1] : s->high[1],
                                k & 4 ? s->low[2] : s->high[2]};
            const double far = vec_dot(vec_add(corner, vec_sub(vec_load(origin, 3), gaze->eye)), gaze->ahead);
            range[0] = fmin(range[0], far), range[1] = fmax(range[1], far);
        }
    }
}

/* A row of a matrix that takes points about the origin to scale * (way from the eye . axis) + shift. */
static void put_row(float *matrix, int row, vec axis, vec eye, double scale, double shift) {
    double parts[3];
    vec_store(axis, parts);
    for (int d = 0; d < 3; d++) matrix[4 * d + row] = (float)(scale * parts[d]);
    matrix[12 + row] = (float)(shift - scale * vec_dot(eye, axis));
}

/* How many device pixels there are to a pixel of a canvas, which has a whole number of them. */
static double stretch(double pixels, double ratio) {
    const double all = pixels * ratio;
    return all / fmax(1, round(all));
}

static bat_status look_at(const bat_scene *scene, const bat_stage *stage, const bat_viewpoint *through,
                          bat_space_kept *kept) {
    bat_space *space = &kept->space;
    bat_viewpoint view;
    bat_gaze gaze;
    bat_status status = through ? BAT_OK : bat_stage_viewpoint(stage, &view);
    if (through) view = *through;
    if (status == BAT_OK) kept->seen = view;
    if (status == BAT_OK) status = bat_gaze_of(&view, &gaze);
    if (status != BAT_OK) return status;
    const vec eye = vec_sub(gaze.eye, vec_load(kept->origin, 3)), back = vec_scale(gaze.ahead, -1);
    const double target = vec_dot(vec_sub(vec_load(view.target, 3), gaze.eye), gaze.ahead);
    const bool deep = gaze.focus > 0; /* perspective */
    const double pixel = deep ? target / gaze.focus : gaze.pixel;
    double range[2];
    depths(scene, &gaze, kept->origin, range);
    if (!(range[0] < INFINITY)) range[0] = range[1] = target;
    const double spare = 0.01 * (range[1] - range[0]) + 16 * pixel;
    const double low = deep ? fmax(range[0] - spare, BAT_VIEW_NEAR * target) : range[0] - spare;
    const double high = fmax(range[1] + spare, low * (1 + 1e-6)), deeper = high - low;
    const double wide = stretch(view.size[0], stage->view.ratio),
                 tall = stretch(view.size[1], stage->view.ratio);
    /* The canvas begins at the window's top left corner. */
    const double x = 1 / (pixel * gaze.middle[0]), y = 1 / (pixel * gaze.middle[1]);
    const double w = deep ? 1 / target : 0, still = deep ? 0 : 1;
    memset(space->clip, 0, sizeof space->clip);
    put_row(space->clip, 0, vec_add(vec_scale(gaze.right, x * wide), vec_scale(gaze.ahead, (wide - 1) * w)),
            eye, 1, (wide - 1) * still);
    put_row(space->clip, 1, vec_add(vec_scale(gaze.above, y * tall), vec_scale(gaze.ahead, (1 - tall) * w)),
            eye, 1, (1 - tall) * still);
    put_row(space->clip, 2, gaze.ahead, eye, deep ? (high + low) / (deeper * target) : 2 / deeper,
            deep ? -2 * high * low / (deeper * target) : -(high + low) / deeper);
    put_row(space->clip, 3, gaze.ahead, eye, w, still);
    memset(space->eye, 0, sizeof space->eye);
    put_row(space->eye, 0, gaze.right, eye, 1, 0);
    put_row(space->eye, 1, gaze.above, eye, 1, 0);
    put_row(space->eye, 2, back, eye, 1, 0);
    space->perspective = deep;
    space->scale = (float)(1 / pixel);
    space->before[0] = (float)(-pixels_before * pixel *
                               (deep ? (high + low) / (deeper * target) : 2 / deeper));
    space->before[1] = (float)(-pixels_before * pixel * w);
    return BAT_OK;
}

/* ---- what is seen ---- */

/* The origin of all buffers: moved when rounding to single precision would become visible. */
static void settle_origin(bat_space_kept *kept, const bat_stage *stage, const bat_viewpoint *through) {
    double middle[2];
    if (through) {
        double far = 0;
        for (int d = 0; d < 3; d++) far = fmax(far, fabs(through->eye[d] - kept->origin[d]));
        if (far * bat_stage_scale(stage) * 0x1p-24 > 0.1)
            memcpy(kept->origin, through->eye, sizeof kept->origin);
        return;
    }
    bat_stage_middle(stage, middle);
    bat_ray ray = bat_view_ray(&stage->view, middle);
    double away = 0;
    for (int d = 0; d < 3; d++) {
        ray.from[d] += bat_view_away(&stage->view) * ray.along[d]; /* from the eye, in perspective */
        away = fmax(away, fabs(ray.from[d] - kept->origin[d]));
    }
    if (away * bat_stage_scale(stage) * 0x1p-24 > 0.1) memcpy(kept->origin, ray.from, sizeof kept->origin);
}

static void add_triangles(bat_space *space, bat_space_item *to, const bat_scene_entry *entry) {
    const bat_solid *s = entry->solid;
    const bat_style *style = bat_object_style(entry->object);
    bat_mesh mesh = {.rows = s->facets.corner_count,
                     .columns = 1,
                     .triangle_count = s->facets.triangle_count,
                     .triangles = s->facets.triangles};
    if (s->mesh) bat_tessellation_mesh(s->mesh, &mesh);
    *to = (bat_space_item){.id = (uint32_t)bat_object_id(entry->object),
                           .version = s->version,
                           .kind = BAT_SPACE_TRIANGLES,
                           .colour = style->filled ? style->fill : 0,
                           .opacity = entry->pale ? 0.2F : (float)style->opacity * entry->around,
                           .rows = (uint32_t)mesh.rows,
                           .columns = (uint32_t)mesh.columns,
                           .index_count = (uint32_t)(3 * mesh.triangle_count),
                           .indices = mesh.triangles,
                           .vertices = s->corners};
    memcpy(to->moved, s->moved, sizeof to->moved);
    space->count++;
}

/* Lines of an object, painted like it: count points, as the shader takes them. */
static void put_lines(bat_space *space, bat_space_item *to, const bat_item *item, uint32_t version,
                      const float *points, uint32_t count) {
    *to = (bat_space_item){.id = item->id,
                           .version = version,
                           .kind = BAT_SPACE_LINES,
                           .colour = item->stroke,
                           .width = item->width * (item->flags & BAT_ITEM_SCREEN_WIDTH ? 1 : space->scale),
                           .opacity = item->opacity,
                           .cap = item->cap,
                           .rows = count,
                           .columns = 1,
                           .moved = {0, count, 0, 1},
                           .vertices = points};
    space->count++;
}

static void add_lines(bat_space *space, bat_space_item *to, const bat_scene *scene,
                      const bat_scene_entry *entry) {
    const bat_solid *s = entry->solid;
    const bat_item item = bat_scene_painted(scene, entry);
    if (!(item.flags & BAT_ITEM_STROKED) || s->point_count < 4) return;
    if (bat_scene_is_bare(entry->object) && space->look != BAT_LOOK_LINES) return; /* it is shaded */
    put_lines(space, to, &item, s->line_version, s->points, s->point_count);
}

/* The outline of a surface is of one view: it is found when the view has come to rest, and not while a stroke changes the
 * surface. */
static bat_status rest(bat_scene *scene, bat_space_kept *kept) {
    const bool moves = memcmp(&kept->before, &kept->seen, sizeof kept->seen) != 0;
    bat_status status = BAT_OK;
    kept->space.waits = 0;
    if (moves) kept->views++;
    kept->before = kept->seen;
    for (int i = 0; i < scene->count && status == BAT_OK; i++) {
        bat_solid *s = scene->entries[i].solid;
        if (!s || scene->entries[i].hidden || !bat_object_surface(scene->entries[i].object) || s->guised)
            continue;
        if (s->rim_view == kept->views && s->rim_lines == s->line_version) continue;
        if (moves) {
            kept->space.waits = 1;
            continue;
        }
        status = bat_solid_outline(s, scene->entries[i].object, &kept->seen);
        if (status != BAT_OK) break;
        s->rim_version = ++scene->versions;
        s->rim_view = kept->views;
        s->rim_lines = s->line_version;
    }
    return status;
}

static void add_outline(bat_space *space, bat_space_item *to, const bat_space_kept *kept,
                        const bat_scene *scene, const bat_scene_entry *entry) {
    const bat_solid *s = entry->solid;
    const bat_item item = bat_scene_painted(scene, entry);
    if (s->rim_count < 4 || s->guised || s->rim_view != kept->views || s->rim_lines != s->line_version)
        return;
    put_lines(space, to, &item, s->rim_version, s->rim, s->rim_count);
    to->id |= BAT_SPACE_OUTLINE;
}

/* The buffers of every object that is seen; false: some could not be made. */
static bool update(bat_scene *scene, const bat_grain *grain, int guises, const bat_guise *guise) {
    bool all = true;
    for (int i = 0; i < scene->count; i++) {
        bat_scene_entry *entry = &scene->entries[i];
        if (entry->hidden || !bat_object_is_drawn(entry->object) ||
            bat_object_curve_count(entry->object) == 0)
            continue;
        if (!entry->solid) entry->solid = calloc(1, sizeof *entry->solid);
        const bat_guise *own = NULL;
        for (int k = 0; k < guises && grain->look != BAT_LOOK_LINES; k++)
            if (guise[k].object == bat_object_id(entry->object) && bat_object_surface(entry->object))
                own = &guise[k];
        const bat_object *object = bat_scene_standing(scene, entry);
        if (!entry->solid || !object ||
            bat_solid_update(entry->solid, object, grain, own, &scene->versions) != BAT_OK)
            all = false;
    }
    return all;
}

/* The range of curvature of all that is seen; it stays while a line is dragged. */
static bat_status measure(const bat_scene *scene, bat_look look, bat_space_kept *kept) {
    uint32_t newest = 0;
    size_t count = 0;
    bool guised = false;
    bat_mesh mesh;
    for (int i = 0; i < scene->count; i++) {
        const bat_solid *s = scene->entries[i].solid;
        if (!s || !s->mesh || scene->entries[i].hidden) continue;
        bat_tessellation_mesh(s->mesh, &mesh);
        count += mesh.rows * mesh.columns;
        newest = s->line_version > newest ? s->line_version : newest;
        guised = guised || s->guised;
    }
    if (look != BAT_LOOK_GAUSS && look != BAT_LOOK_MEAN) newest = 0;
    if (newest == kept->measured || (guised && kept->measured)) return BAT_OK;
    double *values = newest ? malloc(count * sizeof *values) : NULL;
    if (newest && !values) return BAT_MEMORY;
    count = 0;
    for (int i = 0; i < scene->count && values; i++) {
        const bat_solid *s = scene->entries[i].solid;
        if (!s || !s->mesh || scene->entries[i].hidden) continue;
        bat_tessellation_mesh(s->mesh, &mesh);
        for (size_t k = 0; k < mesh.rows * mesh.columns; k++)
            values[count++] = s->corners[BAT_SOLID_CORNER * k + 6];
    }
    kept->space.range = values ? bat_curving_range(count, values) : 0;
    kept->measured = newest;
    free(values);
    return BAT_OK;
}

static uint32_t legend_at(double share) {
    double colour[3];
    uint32_t rgb = 0;
    bat_shade_legend(share, colour);
    for (int k = 0; k < 3; k++) rgb = rgb << 8 | (uint32_t)(colour[k] * 255 + 0.5);
    return rgb << 8 | 255;
}

/* Fills the list of what is painted. aids: cameras and the like, too; kept: outlines, too, when it is of the stage. */
static bool gather(const bat_scene *scene, bat_space_kept *kept, bat_look look, bool aids, bool outlines) {
    bat_space_item *items = realloc(kept->items, (size_t)(3 * scene->count + 1) * sizeof *items);
    if (!items) return false;
    bat_space *space = &kept->space;
    space->items = kept->items = items;
    space->count = 0;
    space->look = (uint32_t)look;
    for (int k = 0; k < 3; k++) space->legend[k] = legend_at(k - 1);
    for (int i = 0; i < scene->count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (entry->hidden || !entry->solid || !bat_object_is_drawn(entry->object)) continue;
        if (!aids && bat_object_is(entry->object, BAT_AID)) continue; /* a camera sees no cameras */
        if (entry->solid->mesh || entry->solid->facets.triangle_count)
            add_triangles(space, items + space->count, entry);
        add_lines(space, items + space->count, scene, entry);
        if (outlines) add_outline(space, items + space->count, kept, scene, entry);
    }
    return true;
}

static bat_grain grain_of(const bat_space_kept *kept, const bat_stage *stage, bat_look look) {
    bat_grain grain = {.scale = (int)ceil(bat_log(bat_stage_scale(stage)) / bat_log(2)), .look = look};
    memcpy(grain.origin, kept->origin, sizeof grain.origin);
    return grain;
}

/* A picture's memory, made when it is first asked for. */
static bat_space_kept *kept_in(bat_space_kept **place) {
    if (!*place) *place = calloc(1, sizeof **place);
    return *place;
}

const bat_space *bat_space_of(bat_scene *scene, const bat_stage *stage, const bat_viewpoint *through,
                              bat_look look, int guises, const bat_guise *guise) {
    if (!bat_stage_tilted(stage) && !through) return NULL;
    bat_space_kept *kept = kept_in(&scene->space);
    if (!kept) return NULL;
    settle_origin(kept, stage, through);
    const bat_grain grain = grain_of(kept, stage, look);
    if (!update(scene, &grain, guises, guise) || look_at(scene, stage, through, kept) != BAT_OK ||
        measure(scene, look, kept) != BAT_OK || rest(scene, kept) != BAT_OK)
        return NULL;
    return gather(scene, kept, look, !through, true) ? &kept->space : NULL;
}

const bat_space *bat_space_lens(bat_scene *scene, const bat_stage *stage, const bat_viewpoint *view,
                                bool room, bat_look look, int guises, const bat_guise *guise) {
    bat_space_kept *first = kept_in(&scene->space), *kept = kept_in(&scene->lens);
    if (!first || !kept) return NULL;
    if (!bat_stage_tilted(stage) && !room) settle_origin(first, stage, view); /* nobody else has */
    memcpy(kept->origin, first->origin, sizeof kept->origin);
    const bat_grain grain = grain_of(kept, stage, look);
    if (!update(scene, &grain, guises, guise) || look_at(scene, stage, view, kept) != BAT_OK ||
        measure(scene, look, kept) != BAT_OK)
        return NULL;
    return gather(scene, kept, look, room, false) ? &kept->space : NULL;
}

/* Where a ray is within a box, as a share of its direction; false: nowhere before its start. */
static bool within(const float low[3], const float high[3], const double from[3], const double along[3],
                   double range[2]) {
    range[0] = 0, range[1] = INFINITY;
    for (int d = 0; d < 3; d++) {
        if (along[d] == 0) {
            if (from[d] < low[d] || from[d] > high[d]) return false;
            continue;
        }
        const double a = (low[d] - from[d]) / along[d], b = (high[d] - from[d]) / along[d];
        range[0] = fmax(range[0], fmin(a, b)), range[1] = fmin(range[1], fmax(a, b));
    }
    return range[0] <= range[1];
}

bool bat_space_reach(const bat_scene *scene, const double from[3], const double along[3], double *far) {
    const bat_space_kept *kept = scene->space;
    double nearest = INFINITY, range[2], start[3];
    if (!kept) return false;
    for (int d = 0; d < 3; d++) start[d] = from[d] - kept->origin[d];
    for (int i = 0; i < scene->count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        const bat_solid *s = entry->solid;
        if (!s || entry->hidden || !(s->low[0] <= s->high[0]) || !(s->mesh || s->facets.triangle_count))
            continue;
        if (!within(s->low, s->high, start, along, range) || range[0] == 0 || range[0] >= nearest) continue;
        nearest = range[0], *far = 0.5 * (range[0] + range[1]);
    }
    return nearest < INFINITY;
}
