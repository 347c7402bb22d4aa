/* The overlay: the live list, rebuilt for every frame by the tool in force. */
#ifndef BATTEN_EDITOR_SHOW_OVERLAY_H
#define BATTEN_EDITOR_SHOW_OVERLAY_H

#include "editor/scene/path.h"

struct bat_stage;

enum { BAT_OVERLAY_ITEMS = 48, BAT_OVERLAY_LABELS = 128, BAT_LABEL_ROOM = 96 };

typedef struct bat_overlay {
    bat_path path; /* of all items in sequence */
    bat_item items[BAT_OVERLAY_ITEMS];
    size_t starts[BAT_OVERLAY_ITEMS];
    uint32_t count;
    bat_label labels[BAT_OVERLAY_LABELS];
    char texts[BAT_OVERLAY_LABELS][BAT_LABEL_ROOM];
    uint32_t label_count;
} bat_overlay;

void bat_overlay_free(bat_overlay *overlay);
/* Empties the list, keeps the memory. map: as of bat_path, and as long as the overlay. */
void bat_overlay_begin(bat_overlay *overlay, const double origin[2], const double *map, double tolerance);
/* Starts a new item; what is added to overlay->path from now on is its path. width: view pixels. */
void bat_overlay_item(bat_overlay *overlay, bat_role role, uint32_t flags, float width);
void bat_overlay_polyline(bat_overlay *overlay, size_t count, const double *points);
/* Adds the box between two of its corners, in view pixels. */
void bat_overlay_window_box(bat_overlay *overlay, const struct bat_stage *stage, const double from[2],
                            const double to[2]);
/* Adds the straight line between two points of the page. */
void bat_overlay_page_line(bat_overlay *overlay, double x0, double y0, double x1, double y1);
/* Adds the stretch u0..u1 of the curve; nothing if it cannot be cut out. */
void bat_overlay_stretch(bat_overlay *overlay, const bat_curve *curve, double u0, double u1);
/* Adds a small diamond around a point; radius in document units. */
void bat_overlay_mark(bat_overlay *overlay, const double point[2], double radius);
void bat_overlay_square(bat_overlay *overlay, const double point[2], double radius);
/* Adds a circle; and the arc of it from angle a0 to a1 (radians from x towards y), which begins a new subpath or,
 * with `on`, continues the path with a line to its start. */
void bat_overlay_circle(bat_overlay *overlay, const double centre[2], double radius);
void bat_overlay_arc(bat_overlay *overlay, const double centre[2], double radius, double a0, double a1,
                     bool on);
/* Adds a text beside a point; dx, dy: view pixels. The text is copied, and cut when too long. */
void bat_overlay_label(bat_overlay *overlay, bat_role role, const double point[2], double dx, double dy,
                       const char *text);
/* Sets pointers and bounds; drops items without a path. pixel: a view pixel in document units. */
void bat_overlay_end(bat_overlay *overlay, double pixel);

#endif
