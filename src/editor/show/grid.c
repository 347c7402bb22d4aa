/* The grid: at its spacing, or with fewer lines when they would be too crowded. */
#include "editor/show/snapped.h"
#include "editor/scene/path.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include "editor/pick/snap.h"
#include <math.h>

enum { LINES_MAX = 2000, STRONG = 10 };

void bat_grid_show(const bat_context *c, bat_overlay *overlay) {
    double step = bat_grid_step(c), zero[2], box[4];
    if (!(step > 0)) return;
    bat_unit_origin(c, zero);
    if (!bat_stage_page_box(c->stage, box)) return;
    for (int strong = 0; strong < 2; strong++) {
        bat_overlay_item(overlay, strong ? BAT_ROLE_GRID_STRONG : BAT_ROLE_GRID, BAT_ITEM_STROKED, 1);
        for (int k = 0; k < 2; k++) {
            double first = ceil((box[k] - zero[k]) / step), last = floor((box[k + 2] - zero[k]) / step);
            for (double i = first; i <= last && i - first < LINES_MAX; i++) {
                if ((fmod(i, STRONG) == 0) != strong) continue;
                double at = zero[k] + i * step;
                bat_overlay_page_line(overlay, k ? box[0] : at, k ? at : box[1], k ? box[2] : at,
                                      k ? at : box[3]);
            }
        }
    }
}
