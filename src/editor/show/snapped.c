/* Marks what was snapped to, with a label. */
#include "base/real.h"
#include "editor/pick/snap.h"
#include "editor/session/notice.h"
#include "editor/show/snapped.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

void bat_snap_show(const bat_context *c, bat_overlay *overlay) {
    static const bat_string words[] = {
        [BAT_SNAP_END] = BAT_STRING_SNAP_WORD_END,     [BAT_SNAP_CROSSING] = BAT_STRING_SNAP_WORD_CROSSING,
        [BAT_SNAP_GUIDE] = BAT_STRING_SNAP_WORD_GUIDE, [BAT_SNAP_CURVE] = BAT_STRING_SNAP_WORD_CURVE,
        [BAT_SNAP_GRID] = BAT_STRING_SNAP_WORD_GRID,
    };
    const bat_snap *snap = c->snap;
    double at[2], from[2], size = 5 * bat_stage_pixel(c->stage);
    char angle[BAT_UNIT_ROOM];
    if (snap->kind == BAT_SNAP_NONE) return;
    bat_map_look(overlay->path.map, 3, snap->point, at);
    bat_map_look(overlay->path.map, 2, snap->from, from);
    bat_overlay_item(overlay, BAT_ROLE_GUIDE, BAT_ITEM_STROKED, 1.5F);
    if (snap->kind == BAT_SNAP_END) {
        bat_overlay_square(overlay, at, size);
    } else if (snap->kind == BAT_SNAP_CURVE) {
        bat_overlay_circle(overlay, at, size);
    } else if (snap->kind == BAT_SNAP_ANGLE) {
        bat_overlay_polyline(overlay, 2, (double[]){from[0], from[1], at[0], at[1]});
        /* Counterclockwise from the right, as on a protractor; y points down. */
        double degrees = round(bat_atan2(snap->from[1] - snap->point[1], snap->point[0] - snap->from[0]) *
                               180 / BAT_PI);
        bat_unit_number(degrees, angle);
        strcat(angle, "°");
    } else { /* a cross: upright for lines, diagonal for crossings */
        double a = snap->kind == BAT_SNAP_CROSSING ? size : 0,
               b = snap->kind == BAT_SNAP_CROSSING ? -size : 0;
        if (snap->kind != BAT_SNAP_CROSSING) size *= 1.4;
        bat_path_move(&overlay->path, at[0] - size, at[1] - a);
        bat_path_line(&overlay->path, at[0] + size, at[1] + a);
        bat_path_move(&overlay->path, at[0] + b, at[1] + size);
        bat_path_line(&overlay->path, at[0] - b, at[1] - size);
    }
    bat_overlay_label(overlay, BAT_ROLE_GUIDE, at, 30, 16,
                      snap->kind == BAT_SNAP_ANGLE ? angle : bat_word(c, words[snap->kind]));
}
