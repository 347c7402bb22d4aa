#include "editor/show/disc.h"
#include "base/vec.h"
#include "editor/view/curve_ground.h"
#include <math.h>

enum { SIDES = 32 };
static const double RADIUS = 12;        /* px, seen from straight above */
static const double SLANTED = 0.258819; /* sine of 15 degrees */
static const double SHARE = 0.35;       /* of the window: half the side of a plane as shown */
static const double TALL = 0.25;        /* of a curve's size: its ruled surface, to either side */
static const float PALER = 0.35F;

void bat_disc_show(const bat_stage *stage, const double pixel[2], bat_overlay *overlay) {
    double x[3], y[3], rim[3 * SIDES];
    bat_hit hit;
    if (!bat_stage_tilted(stage) && bat_stage_dimension(stage) == 2) return;
    if (bat_stage_place(stage, pixel, NULL, &hit) != BAT_OK) return;
    const vec normal = vec_load(hit.normal, 3), across = vec_any_normal(normal);
    vec_store(across, x);
    vec_store(vec_cross(normal, across), y);
    bat_overlay_item(overlay, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    if (overlay->count && bat_stage_slant_at(stage, &hit) < SLANTED)
        overlay->items[overlay->count - 1].opacity = PALER;
    for (int i = 0; i < SIDES; i++) {
        const double angle = 2 * BAT_PI * i / SIDES, r = RADIUS * hit.pixel;
        for (int k = 0; k < 3; k++)
            rim[3 * i + k] = hit.at[k] + r * (bat_cos(angle) * x[k] + bat_sin(angle) * y[k]);
    }
    bat_path_polygon(&overlay->path, 3, SIDES, rim, true);
}

void bat_ruled_show(const bat_curve *curve, const double along[3], bat_overlay *overlay) {
    double points[2 * BAT_RULED_POINTS * 3];
    bat_ruled_outline(curve, along, TALL * bat_curve_size(curve), points);
    bat_overlay_item(overlay, BAT_ROLE_MARQUEE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    bat_path_polygon(&overlay->path, 3, 2 * BAT_RULED_POINTS, points, true);
}

void bat_plane_show(const bat_stage *stage, bat_overlay *overlay) {
    double x[3], y[3], size[2], corners[12];
    if (stage->ground.type->numbers != BAT_GROUND_NUMBERS) return;
    bat_stage_window(stage, size);
    const double half = SHARE * fmin(size[0], size[1]) * bat_stage_pixel(stage);
    const double *origin = stage->ground.numbers;
    bat_ground_axes(&stage->ground, x, y);
    bat_overlay_item(overlay, BAT_ROLE_MARQUEE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    for (int i = 0; i < 4; i++) {
        const double a = i == 1 || i == 2 ? half : -half, b = i > 1 ? half : -half;
        for (int k = 0; k < 3; k++) corners[3 * i + k] = origin[k] + a * x[k] + b * y[k];
    }
    bat_path_polygon(&overlay->path, 3, 4, corners, true);
}
