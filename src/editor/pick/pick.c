#include "editor/pick/pick.h"
#include "document/kind.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static bool box_near(const double box[4], const double point[2], double within) {
    double dx = fmax(fmax(box[0] - point[0], point[0] - box[2]), 0);
    double dy = fmax(fmax(box[1] - point[1], point[1] - box[3]), 0);
    return bat_hypot(dx, dy) <= within;
}

/* Whether the object can be picked, and its box is close enough. */
static bool within_reach(const bat_scene_entry *entry, const double point[2], double within) {
    return !entry->hidden && !entry->locked && box_near(entry->box, point, within);
}

bat_pick bat_pick_curve(bat_scene *scene, int dimension, const double point[2], double within) {
    bat_pick best = {0};
    for (int i = 0; i < scene->count; i++) {
        const bat_object *object = scene->entries[i].object;
        if (!within_reach(&scene->entries[i], point, within)) continue;
        if (!bat_object_is_made_of_curves(object)) continue;
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            if (dimension && bat_curve_dimension(bat_object_curve(object, j)) != dimension) continue;
            const bat_finder *finder = bat_scene_finder(scene, i, j);
            if (!finder) continue;
            bat_near near;
            bat_finder_nearest(finder, point, &near);
            if (near.distance <= within) {
                best = (bat_pick){bat_object_id(object), i, j, near};
                within = near.distance;
            }
        }
    }
    return best;
}

bool bat_pick_on(bat_scene *scene, bat_id object, int curve, const double point[2], bat_near *near) {
    for (int i = 0; i < scene->count; i++) {
        if (bat_object_id(scene->entries[i].object) != object) continue;
        const bat_finder *finder = curve < bat_object_curve_count(scene->entries[i].object)
                                       ? bat_scene_finder(scene, i, curve)
                                       : NULL;
        if (finder) bat_finder_nearest(finder, point, near);
        return finder != NULL;
    }
    return false;
}

bat_pick bat_pick_nearest(bat_scene *scene, const double point[2], double within) {
    return bat_pick_curve(scene, 2, point, within);
}

bat_pick bat_pick_end(bat_scene *scene, const double point[2], double within, bat_id but_object,
                      int but_curve) {
    bat_pick best = {0};
    for (int i = 0; i < scene->count; i++) {
        const bat_object *object = scene->entries[i].object;
        if (!within_reach(&scene->entries[i], point, within)) continue;
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            const bat_curve *curve = bat_object_curve(object, j);
            if (bat_curve_dimension(curve) != 2 || bat_curve_is_closed(curve)) continue;
            if (bat_object_id(object) == but_object && j == but_curve) continue;
            double domain[2];
            bat_curve_domain(curve, domain);
            for (int k = 0; k < 2; k++) {
                bat_near near = {.u = domain[k]};
                bat_curve_eval(curve, domain[k], 0, near.point);
                near.distance = bat_hypot(near.point[0] - point[0], near.point[1] - point[1]);
                if (near.distance <= within) {
                    best = (bat_pick){bat_object_id(object), i, j, near};
                    within = near.distance;
                }
            }
        }
    }
    return best;
}
