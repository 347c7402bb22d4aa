/* Picking by area: fills under a point, drawings within a box. Works on the scene's float paths, flattened. */
#include "base/real.h"
#include "document/nesting.h"
#include "editor/pick/pick.h"
#include <math.h>
#include <stdlib.h>

enum { PIECES = 12 }; /* lines per cubic */

typedef bool line_function(void *user, const double a[2], const double b[2]); /* true: stop */

/* Calls `take` with every line of the path, relative to the origin; with `closing`, open subpaths are closed, as for
 * fills. */
static bool each_line(const float *path, uint32_t count, bool closing, line_function *take, void *user) {
    const float *at = path, *end = at ? at + count : NULL;
    double start[2] = {0, 0}, now[2] = {0, 0}, next[2];
    while (at < end) {
        int kind = (int)*at++;
        if (kind == BAT_PATH_MOVE || kind == BAT_PATH_CLOSE) {
            if ((closing || kind == BAT_PATH_CLOSE) && take(user, now, start)) return true;
            if (kind == BAT_PATH_CLOSE) {
                now[0] = start[0], now[1] = start[1];
                continue;
            }
            start[0] = now[0] = (double)at[0], start[1] = now[1] = (double)at[1];
            at += 2;
        } else if (kind == BAT_PATH_LINE) {
            next[0] = (double)at[0], next[1] = (double)at[1];
            if (take(user, now, next)) return true;
            now[0] = next[0], now[1] = next[1];
            at += 2;
        } else {
            double from[2] = {now[0], now[1]};
            for (int i = 1; i <= PIECES; i++) {
                double t = (double)i / PIECES, s = 1 - t;
                for (int k = 0; k < 2; k++)
                    next[k] = s * s * s * from[k] + 3 * s * s * t * (double)at[k] +
                              3 * s * t * t * (double)at[2 + k] + t * t * t * (double)at[4 + k];
                if (take(user, now, next)) return true;
                now[0] = next[0], now[1] = next[1];
            }
            at += 6;
        }
    }
    return closing && take(user, now, start);
}

typedef struct winding {
    double point[2];
    int turns;
} winding;

static bool count_turns(void *user, const double a[2], const double b[2]) {
    winding *w = user;
    bool up = a[1] <= w->point[1] && b[1] > w->point[1], down = a[1] > w->point[1] && b[1] <= w->point[1];
    if (!up && !down) return false;
    double x = a[0] + (w->point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    if (x > w->point[0]) w->turns += up ? 1 : -1;
    return false;
}

static bool is_within(const float *path, uint32_t count, bool even_odd, const double origin[2],
                      const double point[2]) {
    winding w = {{point[0] - origin[0], point[1] - origin[1]}, 0};
    each_line(path, count, true, count_turns, &w);
    return even_odd ? w.turns & 1 : w.turns != 0;
}

/* point: document units. */
static bool fills(const bat_scene *scene, const bat_scene_entry *entry, const double point[2]) {
    const bat_style *style = bat_object_style(entry->object);
    if (!style->filled || !entry->path || scene->outline) return false;
    return is_within(entry->path, entry->item.path_count, style->even_odd, scene->origin, point);
}

/* ---- what clips leave ---- */

/* The group around each entry, or -1. NULL: nothing is clipped as it is shown now, or memory ran out. The caller frees it. */
static int *find_groups(const bat_scene *scene) {
    int open[BAT_NESTING_MAX], depth = 0;
    bool clipped = false;
    for (int i = 0; i < scene->count && !clipped; i++) clipped = scene->entries[i].regions != NULL;
    int *above = clipped && !scene->tilted && !scene->outline ? malloc((size_t)scene->count * sizeof *above)
                                                              : NULL;
    for (int i = 0; i < scene->count && above; i++) {
        const bat_object *object = scene->entries[i].object;
        const bat_id parent = bat_object_parent(object);
        while (depth > 0 && bat_object_id(scene->entries[open[depth - 1]].object) != parent) depth--;
        above[i] = depth > 0 ? open[depth - 1] : -1;
        if (bat_object_is_group(object) && depth < BAT_NESTING_MAX) open[depth++] = i;
    }
    return above;
}

/* Whether the clips of an entry and of the groups around it leave the point. */
static bool is_left(const bat_scene *scene, const int *above, int index, const double point[2]) {
    for (; above && index >= 0; index = above[index]) {
        const bat_scene_region *regions = scene->entries[index].regions;
        const int count = regions ? bat_clip_count(bat_object_clip(scene->entries[index].object)) : 0;
        for (int k = 0; k < count; k++)
            if (!is_within(regions[k].path, regions[k].count, regions[k].flags & BAT_ITEM_EVEN_ODD,
                           scene->origin, point))
                return false;
    }
    return true;
}

static bool apart(const double box[4], const double other[4], double within) {
    return other[0] > box[2] + within || other[2] < box[0] - within || other[1] > box[3] + within ||
           other[3] < box[1] - within;
}

/* How far from its curves an entry's stroke can be painted. */
static double reach(const bat_scene_entry *entry) {
    const bat_style *style = bat_object_style(entry->object);
    const bat_width_profile profile = bat_object_widths(entry->object);
    double share = 1;
    if (!style->stroked) return 0;
    for (size_t i = 0; i < profile.count; i++) share = fmax(share, profile.stops[i].share);
    return share * style->width / 2;
}

/* A stroke whose width changes along it covers what its outline does, others what is near enough to their curves. */
static bool is_wide(const bat_scene *scene, const bat_scene_entry *entry) {
    return entry->wide && !scene->outline && bat_object_widths(entry->object).count > 0;
}

/* How far the point is from what is painted of the entry's lines, INFINITY: out of reach. What is cut away counts as far. */
static double line_away(bat_scene *scene, const int *above, int index, const double point[2], double within) {
    const bat_scene_entry *entry = &scene->entries[index];
    const bat_style *style = bat_object_style(entry->object);
    const bool wide = is_wide(scene, entry);
    const double half = wide || !style->stroked ? 0 : style->width / 2;
    double best = INFINITY;
    if (wide && is_within(entry->wide->path, entry->wide->count, false, scene->origin, point) &&
        is_left(scene, above, index, point))
        return 0;
    for (int j = 0; j < bat_object_curve_count(entry->object); j++) {
        const bat_finder *finder = bat_scene_finder(scene, index, j);
        bat_near near;
        if (!finder) continue;
        bat_finder_nearest(finder, point, &near);
        if (near.distance > fmax(within, half) || fmax(near.distance - half, 0) >= best) continue;
        if (is_left(scene, above, index, near.point) || is_left(scene, above, index, point))
            best = fmax(near.distance - half, 0);
    }
    return best;
}

int bat_pick_object(bat_scene *scene, const double point[2], double within) {
    double best = INFINITY;
    int found = -1, *above = find_groups(scene);
    for (int i = scene->count - 1; i >= 0; i--) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (entry->hidden || entry->locked || bat_object_is_group(entry->object)) continue;
        double near_box[4] = {point[0], point[1], point[0], point[1]};
        if (apart(entry->box, near_box, fmax(within, reach(entry)))) continue;
        const double away = line_away(scene, above, i, point, within);
        if (away < best) {
            best = away;
            found = i;
        }
        /* What lies behind a fill is not picked, unless a line has been found within reach already. */
        if (fills(scene, entry, point) && is_left(scene, above, i, point)) {
            found = found >= 0 ? found : i;
            break;
        }
    }
    free(above);
    return found;
}

bat_status bat_pick_all(bat_scene *scene, const double point[2], double within, int **out, int *count) {
    int *found = malloc(((size_t)scene->count + 1) * sizeof *found), n = 0;
    if (!found) return BAT_MEMORY;
    int *above = find_groups(scene);
    for (int i = scene->count - 1; i >= 0; i--) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (entry->hidden || entry->locked || bat_object_is_group(entry->object)) continue;
        double near_box[4] = {point[0], point[1], point[0], point[1]};
        if (apart(entry->box, near_box, fmax(within, reach(entry)))) continue;
        if (line_away(scene, above, i, point, within) < INFINITY ||
            (fills(scene, entry, point) && is_left(scene, above, i, point)))
            found[n++] = i;
    }
    free(above);
    *out = found;
    *count = n;
    return BAT_OK;
}

typedef struct area {
    const bat_stage *stage;
    const double *origin; /* of the lines' coordinates */
    const double *box;    /* view pixels */
} area;

static bool crosses(void *user, const double from[2], const double to[2]) {
    const area *in_view = user;
    const double *box = in_view->box, *origin = in_view->origin;
    double t0 = 0, t1 = 1, a[2], b[2];
    bat_stage_project(in_view->stage, (double[]){from[0] + origin[0], from[1] + origin[1]}, a);
    bat_stage_project(in_view->stage, (double[]){to[0] + origin[0], to[1] + origin[1]}, b);
    for (int k = 0; k < 2; k++) { /* Liang and Barsky 1984 */
        double d = b[k] - a[k];
        if (d == 0) {
            if (a[k] < box[k] || a[k] > box[k + 2]) return false;
            continue;
        }
        double in = (box[d > 0 ? k : k + 2] - a[k]) / d, out = (box[d > 0 ? k + 2 : k] - a[k]) / d;
        t0 = fmax(t0, in);
        t1 = fmin(t1, out);
    }
    return t0 <= t1;
}

/* The box in the document, axis-aligned, around the box in the view. */
static void around(const bat_stage *stage, const double box[4], double out[4]) {
    for (int i = 0; i < 4; i++) {
        double corner[2];
        bat_stage_seen(stage, (double[]){box[i & 2], box[1 + 2 * (i & 1)]}, corner);
        for (int k = 0; k < 2; k++) {
            out[k] = i ? fmin(out[k], corner[k]) : corner[k];
            out[k + 2] = i ? fmax(out[k + 2], corner[k]) : corner[k];
        }
    }
}

bool bat_pick_touches(const bat_scene *scene, int index, const bat_stage *stage, const double box[4]) {
    const bat_scene_entry *entry = &scene->entries[index];
    double reach[4], corner[2];
    if (entry->hidden || entry->locked || !entry->path) return false;
    around(stage, box, reach);
    if (apart(entry->box, reach, 0)) return false;
    area in_view = {stage, scene->origin, box};
    if (each_line(entry->path, entry->item.path_count, false, crosses, &in_view)) return true;
    bat_stage_seen(stage, box, corner);
    return fills(scene, entry, corner);
}
