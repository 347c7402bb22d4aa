#include "editor/edit/view_record.h"
#include "editor/session/journal_line.h"
#include <math.h>
#include <string.h>

/* x, y, zoom; the angle; the tilt and the pivot; the perspective and the window; the roll. */
enum { FLAT = 3, TURNED = 4, TILTED = 8, DEEP = 11, ROLLED = 12, FOV = 8 };

void bat_view_write(const bat_view *view, bat_text *text, bool whole) {
    bat_line_numbers(text,
                     (double[]){view->x, view->y, view->zoom, view->angle, view->tilt, view->pivot[0],
                                view->pivot[1], view->pivot[2], view->fov, view->width, view->height,
                                view->roll},
                     whole || view->roll != 0 ? ROLLED
                     : view->tilt != 0        ? (view->fov > 0 ? DEEP : TILTED)
                     : view->angle != 0       ? TURNED
                                              : FLAT,
                     1);
}

bat_status bat_view_read(const bat_json *json, bat_view *view, bat_problem *problem) {
    const double far = BAT_COORDINATE_MAX, size = BAT_PIXELS_MAX, wide = 170; /* degrees */
    const double low[ROLLED] =
        {-BAT_VIEW_REACH, -BAT_VIEW_REACH, BAT_ZOOM_MIN, -180, 0, -far, -far, -far, 1, 0, 0, -180},
                 high[ROLLED] = {BAT_VIEW_REACH, BAT_VIEW_REACH, BAT_ZOOM_MAX, 180, 180, far, far, far,
                                 wide,           size,           size,         180};
    const uint32_t list = bat_json_member(json, 1, "view"), count = bat_json_count(json, list);
    uint32_t node = bat_json_first(json, list);
    double numbers[ROLLED] = {0};
    bool good = count == FLAT || count == TURNED || count == TILTED || count == DEEP || count == ROLLED;
    for (uint32_t k = 0; k < count && good; k++, node = json->nodes[node].next) {
        numbers[k] = bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number : NAN;
        good = numbers[k] >= low[k] && numbers[k] <= high[k];
        good = good || (k == FOV && count == ROLLED && numbers[k] == 0); /* parallel */
    }
    if (!good)
        return bat_json_complain(
            json, list ? list : 1, BAT_SYNTAX, "view",
            "[x, y, zoom], [x, y, zoom, angle] or the 8, 11 or 12 numbers of a tilted view", problem);
    *view = bat_view_defaults();
    memcpy(view->pivot, numbers + 5, sizeof view->pivot);
    view->fov = numbers[FOV];
    view->width = numbers[9];
    view->height = numbers[10];
    bat_view_pose(view, numbers[3], numbers[4], numbers[11]);
    view->x = numbers[0];
    view->y = numbers[1];
    view->zoom = numbers[2];
    return BAT_OK;
}
