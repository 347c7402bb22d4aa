/* The stage: the view, and the ground that the pen draws on. Tools ask it where the pen is and what is there; only
 * this room knows how a pixel becomes a point. "Drawing coordinates" are two coordinates of a point as the window shows
 * it, in document units (view.h): what lies near the pen is found in them. Face-on they are the x y of the page; in
 * a tilted view they are not, and only bat_stage_place tells where the pen is on the page. */
#ifndef BATTEN_EDITOR_VIEW_STAGE_H
#define BATTEN_EDITOR_VIEW_STAGE_H

#include "editor/view/ground.h"
#include "editor/view/view.h"
#include <batten/view.h>

typedef struct bat_stage {
    bat_view view;
    bat_ground ground;
    struct bat_casters
        *casters; /* casters.h: of the document whose curves and surfaces can be grounds; NULL: none */
} bat_stage;

bat_stage bat_stage_defaults(void);
/* The dimension of points: 2 on the page, otherwise 3. */
int bat_stage_dimension(const bat_stage *stage);
/* Where the pen is on the ground. last: where it was before on the same stroke, or NULL. Statuses as in ground.h. */
bat_status bat_stage_place(const bat_stage *stage, const double pixel[2], const bat_hit *last, bat_hit *out);
/* Where the pen is on the page, whatever the ground; false: the page is seen edge-on, or too far away. */
bool bat_stage_on_page(const bat_stage *stage, const double pixel[2], double at[2]);
/* The sine of the angle at which the ground is seen: 1 from straight above, 0 edge-on. */
double bat_stage_slant(const bat_stage *stage);
/* The same where it was hit. */
double bat_stage_slant_at(const bat_stage *stage, const bat_hit *hit);
/* The ground's normal, on the side where the eye looks along it. */
void bat_stage_facing(const bat_stage *stage, double normal[3]);
/* Drawing coordinates under a pixel, and the pixel of drawing coordinates. */
void bat_stage_seen(const bat_stage *stage, const double pixel[2], double at[2]);
void bat_stage_project(const bat_stage *stage, const double at[2], double pixel[2]);
/* Whether the view is tilted; if so, drawing coordinates are map (bat_view_map) applied to x y z 1. */
bool bat_stage_tilted(const bat_stage *stage);
void bat_stage_space_map(const bat_stage *stage, double map[BAT_MAP_NUMBERS]);
/* Whether the tilted view is in perspective; whether the eye is on the page's back. */
bool bat_stage_deep(const bat_stage *stage);
bool bat_stage_behind(const bat_stage *stage);
/* Drawing coordinates of a point of the document; dimension: of the point, 2 or 3. False: it is behind the eye, and far
 * from everything that is seen (BAT_NOWHERE). */
bool bat_stage_look(const bat_stage *stage, int dimension, const double *point, double at[2]);
/* How a small step from a point is seen: drawing coordinates per unit of the way, to first order. */
void bat_stage_look_along(const bat_stage *stage, int dimension, const double *point, const double *way,
                          double seen[2]);
/* bat_stage_seen as an affine map: x' = map[0] x + map[1] y + map[2], y' = map[3] x + map[4] y + map[5] in pixels. */
void bat_stage_map(const bat_stage *stage, double map[6]);
/* The length of a view pixel in document units; pixels per document unit. */
double bat_stage_pixel(const bat_stage *stage);
double bat_stage_scale(const bat_stage *stage);
/* The upward direction of the drawing in pixels, of length 1; the rotation of the view in degrees. */
void bat_stage_up(const bat_stage *stage, double up[2]);
double bat_stage_angle(const bat_stage *stage);
/* The view as the calls of view.h take it: parallel, the page's y downwards and its z away from the eye. Points are
 * seen at the pixels of bat_stage_project. BAT_STATE: the window has no size. */
bat_status bat_stage_viewpoint(const bat_stage *stage, bat_viewpoint *out);
/* Width and height of the window in pixels; its middle; the axis-aligned box around what it shows, in drawing
 * coordinates. */
void bat_stage_window(const bat_stage *stage, double size[2]);
void bat_stage_middle(const bat_stage *stage, double pixel[2]);
void bat_stage_box(const bat_stage *stage, double box[4]);
/* The axis-aligned box, in its own coordinates, around what the window shows of a plane or the page. False: it is seen
 * edge-on. */
bool bat_stage_flat_box(const bat_stage *stage, const bat_ground *flat, double box[4]);
/* The same of the page; face-on it is that of bat_stage_box. */
bool bat_stage_page_box(const bat_stage *stage, double box[4]);
/* Whether both show the same, in the same way. */
bool bat_stage_same(const bat_stage *a, const bat_stage *b);

/* Moves the view; see the functions of view.h. */
void bat_stage_pan(bat_stage *stage, const double from[2], const double to[2]);
void bat_stage_bring(bat_stage *stage, const double at[2], double margin);
void bat_stage_zoom(bat_stage *stage, const double about[2], double factor);
void bat_stage_rotate(bat_stage *stage, const double about[2], double degrees); /* of a page seen face-on */

#endif
