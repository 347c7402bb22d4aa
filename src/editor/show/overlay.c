#include <stdlib.h>
#include "editor/show/overlay.h"
#include "base/real.h"
#include "editor/view/stage.h"
#include <batten/refine.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void bat_overlay_free(bat_overlay *overlay) { free(overlay->path.data); }

void bat_overlay_begin(bat_overlay *overlay, const double origin[2], const double *map, double tolerance) {
    overlay->count = overlay->label_count = 0;
    overlay->path.count = 0;
    overlay->path.failed = false;
    memcpy(overlay->path.origin, origin, sizeof overlay->path.origin);
    overlay->path.map = map;
    overlay->path.tolerance = tolerance;
}

void bat_overlay_item(bat_overlay *overlay, bat_role role, uint32_t flags, float width) {
    if (overlay->count == BAT_OVERLAY_ITEMS) return; /* the last item then takes what follows */
    overlay->starts[overlay->count] = overlay->path.count;
    overlay->items[overlay->count++] = (bat_item){.role = (uint32_t)role,
                                                  .flags = flags | BAT_ITEM_SCREEN_WIDTH,
                                                  .width = width,
                                                  .opacity = 1,
                                                  .cap = BAT_CAP_ROUND,
                                                  .join = BAT_JOIN_ROUND};
}

void bat_overlay_polyline(bat_overlay *overlay, size_t count, const double *points) {
    if (count < 2) return;
    bat_path_move(&overlay->path, points[0], points[1]);
    for (size_t i = 1; i < count; i++) bat_path_line(&overlay->path, points[2 * i], points[2 * i + 1]);
}

void bat_overlay_window_box(bat_overlay *overlay, const bat_stage *stage, const double from[2],
                            const double to[2]) {
    const double pixels[4][2] = {{from[0], from[1]}, {to[0], from[1]}, {to[0], to[1]}, {from[0], to[1]}};
    double corners[8];
    for (int i = 0; i < 4; i++) bat_stage_seen(stage, pixels[i], corners + (ptrdiff_t)2 * i);
    bat_overlay_polyline(overlay, 4, corners);
    bat_path_close(&overlay->path);
}

void bat_overlay_page_line(bat_overlay *overlay, double x0, double y0, double x1, double y1) {
    bat_path_polygon(&overlay->path, 2, 2, (double[]){x0, y0, x1, y1}, false);
}

void bat_overlay_stretch(bat_overlay *overlay, const bat_curve *curve, double u0, double u1) {
    bat_curve *piece = NULL;
    double domain[2];
    bat_curve_domain(curve, domain);
    if (u1 - u0 >= domain[1] - domain[0]) {
        bat_path_curve(&overlay->path, curve);
        return;
    }
    if (bat_curve_piece(curve, u0, u1, &piece) != BAT_OK) return;
    bat_path_curve(&overlay->path, piece);
    bat_curve_free(piece);
}

void bat_overlay_mark(bat_overlay *overlay, const double point[2], double radius) {
    bat_path *path = &overlay->path;
    bat_path_move(path, point[0] - radius, point[1]);
    bat_path_line(path, point[0], point[1] - radius);
    bat_path_line(path, point[0] + radius, point[1]);
    bat_path_line(path, point[0], point[1] + radius);
    bat_path_close(path);
}

void bat_overlay_square(bat_overlay *overlay, const double point[2], double radius) {
    bat_path *path = &overlay->path;
    bat_path_move(path, point[0] - radius, point[1] - radius);
    bat_path_line(path, point[0] + radius, point[1] - radius);
    bat_path_line(path, point[0] + radius, point[1] + radius);
    bat_path_line(path, point[0] - radius, point[1] + radius);
    bat_path_close(path);
}

void bat_overlay_arc(bat_overlay *overlay, const double centre[2], double radius, double a0, double a1,
                     bool on) {
    bat_path *path = &overlay->path;
    double turn = a1 - a0, x = bat_cos(a0), y = bat_sin(a0);
    int pieces = (int)fmin(fmax(ceil(fabs(turn) / (BAT_PI / 4)), 1), 64);
    double step = turn / pieces, reach = 4.0 / 3 * bat_tan(step / 4) * radius;
    (on ? bat_path_line : bat_path_move)(path, centre[0] + radius * x, centre[1] + radius * y);
    for (int i = 1; i <= pieces; i++) {
        double u = bat_cos(a0 + i * step), v = bat_sin(a0 + i * step);
        bat_path_cubic(path,
                       (double[]){centre[0] + radius * x - reach * y, centre[1] + radius * y + reach * x,
                                  centre[0] + radius * u + reach * v, centre[1] + radius * v - reach * u,
                                  centre[0] + radius * u, centre[1] + radius * v});
        x = u, y = v;
    }
}

void bat_overlay_circle(bat_overlay *overlay, const double centre[2], double radius) {
    bat_overlay_arc(overlay, centre, radius, 0, 2 * BAT_PI, false);
    bat_path_close(&overlay->path);
}

void bat_overlay_label(bat_overlay *overlay, bat_role role, const double point[2], double dx, double dy,
                       const char *text) {
    if (overlay->label_count == BAT_OVERLAY_LABELS) return;
    uint32_t i = overlay->label_count++;
    snprintf(overlay->texts[i], BAT_LABEL_ROOM, "%.*s", BAT_LABEL_ROOM - 1, text);
    overlay->labels[i] = (bat_label){.role = (uint32_t)role,
                                     .at = {bat_path_float(point[0] - overlay->path.origin[0]),
                                            bat_path_float(point[1] - overlay->path.origin[1])},
                                     .offset = {bat_path_float(dx), bat_path_float(dy)},
                                     .text = overlay->texts[i]};
}

void bat_overlay_end(bat_overlay *overlay, double pixel) {
    uint32_t kept = 0;
    /* A command cut off by a failed allocation would leave an incomplete item: commands are added whole or not at
     * all. */
    size_t whole = overlay->path.count;
    for (uint32_t i = 0; i < overlay->count; i++) {
        size_t start = overlay->starts[i], end = i + 1 < overlay->count ? overlay->starts[i + 1] : whole;
        if (end <= start) continue;
        bat_item item = overlay->items[i];
        bat_path part = overlay->path;
        part.count = end;
        bat_path_bounds(&part, start, item.bounds);
        const double unit = item.flags & BAT_ITEM_SCREEN_WIDTH ? pixel : 1;
        float more = item.flags & BAT_ITEM_STROKED ? bat_path_float(item.width / 2 * unit) : 0;
        item.bounds[0] -= more;
        item.bounds[1] -= more;
        item.bounds[2] += more;
        item.bounds[3] += more;
        item.path_count = (uint32_t)(end - start);
        item.path = overlay->path.data + start;
        overlay->items[kept++] = item;
    }
    overlay->count = kept;
}
