/* The grid: at its spacing, or with fewer lines when they would be too crowded. */
#include "editor/show/snapped.h"
#include "editor/pick/isometric.h"
#include "editor/scene/path.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/view/stage.h"
#include "editor/pick/snap.h"
#include <math.h>

enum { LINES_MAX = 2000, STRONG = 10 };

/* Of a family of parallel lines, `gap` apart along the unit normal, those that meet the box. */
static void show_family(bat_overlay *overlay, const bat_grid *grid, double gap, const double normal[2],
                        const double box[4], bool strong) {
    const double *zero = grid->zero;
    const double middle[2] = {(box[0] + box[2]) / 2 - zero[0], (box[1] + box[3]) / 2 - zero[1]};
    const double size[2] = {(box[2] - box[0]) / 2, (box[3] - box[1]) / 2};
    const double across = middle[0] * normal[0] + middle[1] * normal[1],
                 along = middle[1] * normal[0] - middle[0] * normal[1],
                 wide = size[0] * fabs(normal[0]) + size[1] * fabs(normal[1]),
                 reach = size[0] * fabs(normal[1]) + size[1] * fabs(normal[0]);
    const double first = ceil((across - wide) / gap), last = floor((across + wide) / gap);
    for (double i = first; i <= last && i - first < LINES_MAX; i++) {
        if ((fmod(i, STRONG) == 0) != strong) continue;
        double ends[6];
        for (int k = 0; k < 2; k++) {
            const double t = along + (k ? reach : -reach);
            const double own[2] = {zero[0] + i * gap * normal[0] - t * normal[1],
                                   zero[1] + i * gap * normal[1] + t * normal[0]};
            bat_ground_at(&grid->ground, own, ends + 3 * k);
        }
        bat_path_polygon(&overlay->path, 3, 2, ends, false);
    }
}

void bat_grid_show(const bat_context *c, bat_overlay *overlay) {
    static const double square[2][2] = {{1, 0}, {0, 1}};
    const bat_grid grid = bat_grid_shown(c);
    double box[4];
    if (!(grid.step > 0) || !bat_stage_flat_box(c->stage, &grid.ground, box)) return;
    for (int strong = 0; strong < 2; strong++) {
        bat_overlay_item(overlay, strong ? BAT_ROLE_GRID_STRONG : BAT_ROLE_GRID, BAT_ITEM_STROKED, 1);
        for (int i = 0; i < (grid.triangles ? BAT_ISOMETRIC_FAMILIES : 2); i++)
            show_family(overlay, &grid, grid.triangles ? bat_isometric_gap(grid.step) : grid.step,
                        grid.triangles ? bat_isometric_normal(i) : square[i], box, strong);
    }
}
