#include "editor/show/disc.h"
#include "base/real.h"
#include <math.h>

enum { SIDES = 32 };
static const double RADIUS = 12;        /* px, seen from straight above */
static const double SLANTED = 0.258819; /* sine of 15 degrees */
static const float PALER = 0.35F;

void bat_disc_show(const bat_stage *stage, const double pixel[2], bat_overlay *overlay) {
    double x[3], y[3], at[2], rim[3];
    bat_hit hit;
    if (!bat_stage_tilted(stage) && bat_stage_dimension(stage) == 2) return;
    if (bat_stage_place(stage, pixel, &hit) != BAT_OK) return;
    bat_ground_axes(&stage->ground, x, y);
    bat_overlay_item(overlay, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
    if (overlay->count && bat_stage_slant(stage) < SLANTED)
        overlay->items[overlay->count - 1].opacity = PALER;
    for (int i = 0; i < SIDES; i++) {
        const double angle = 2 * BAT_PI * i / SIDES, r = RADIUS * hit.pixel;
        for (int k = 0; k < 3; k++) rim[k] = hit.at[k] + r * (bat_cos(angle) * x[k] + bat_sin(angle) * y[k]);
        bat_map_look(overlay->path.map, 3, rim, at);
        (i ? bat_path_line : bat_path_move)(&overlay->path, at[0], at[1]);
    }
    bat_path_close(&overlay->path);
}
