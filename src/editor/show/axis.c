#include "editor/show/axis.h"
#include "base/real.h"
#include "editor/edit/symmetry.h"
#include "editor/scene/path.h"
#include "editor/view/stage.h"

static const float WIDTH = 1, GHOST_WIDTH = 1.5F;

void bat_axis_show(bat_context *c, bat_overlay *overlay) {
    const bat_mirror axis = bat_symmetry(c);
    double box[4];
    if (!axis.on || !bat_stage_page_box(c->stage, box)) return;
    const double middle[2] = {(box[0] + box[2]) / 2, (box[1] + box[3]) / 2};
    double from[2], to[2];
    /* From the point nearest to the window's middle, as far as the window reaches. */
    const double far = bat_hypot(box[2] - box[0], box[3] - box[1]);
    const double s = bat_mirror_along(&axis, middle);
    bat_mirror_place(&axis, s - far, from);
    bat_mirror_place(&axis, s + far, to);
    bat_overlay_item(overlay, BAT_ROLE_GUIDELINE, BAT_ITEM_STROKED | BAT_ITEM_DASHED, WIDTH);
    bat_overlay_page_line(overlay, from[0], from[1], to[0], to[1]);
}

void bat_axis_show_ghost(const bat_mirror *mirror, bat_overlay *overlay, size_t count, const double *points,
                         const bat_curve *curve) {
    double at[2];
    bat_overlay_item(overlay, BAT_ROLE_GHOST, BAT_ITEM_STROKED, GHOST_WIDTH);
    if (curve) bat_path_curve(&overlay->path, curve);
    for (size_t i = 0; i < count && count > 1 && !curve; i++) {
        bat_mirror_point(mirror, points + 2 * i, at);
        bat_map_look(overlay->path.map, 2, (double[]){at[0], at[1]}, at);
        (i ? bat_path_line : bat_path_move)(&overlay->path, at[0], at[1]);
    }
}
