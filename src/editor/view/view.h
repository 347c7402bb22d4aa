/* The view: which part of the document the window shows, and at what angle. screen = R(angle) (document - (x, y)) *
 * zoom, in view pixels; y points down, so R turns clockwise. */
#ifndef BATTEN_EDITOR_VIEW_VIEW_H
#define BATTEN_EDITOR_VIEW_VIEW_H

#include "editor/view/ground.h"

#define BAT_ZOOM_MIN 1e-6
#define BAT_ZOOM_MAX 1e6
#define BAT_VIEW_REACH 1e12 /* limit on the document coordinates of the view's corner */
#define BAT_PIXELS_MAX 1e6  /* limit on the view pixels of events and sizes */

typedef struct bat_view {
    double x, y, zoom;           /* document coordinates of the top left corner; pixels per unit, > 0 */
    double angle, cosine, sine;  /* degrees, (-180, 180], whole hundredths; bat_view_turn sets all three */
    double width, height, ratio; /* view pixels; device pixels per view pixel */
    bool fit_wanted;             /* show everything as soon as the window has a size */
} bat_view;

bat_view bat_view_defaults(void);
/* At the origin, upright, at zoom 1; the window keeps its size. */
void bat_view_look_afresh(bat_view *view);
/* Sets the angle, any number of degrees, reduced to its range and rounded to its steps. */
void bat_view_turn(bat_view *view, double degrees);
/* Length of a view pixel in document units. */
double bat_view_pixel(const bat_view *view);
/* The ray through a view pixel, perpendicular to the page: from the point of the page seen there, away from the eye. */
bat_ray bat_view_ray(const bat_view *view, const double pixel[2]);
void bat_view_to_document(const bat_view *view, const double screen[2], double document[2]);
void bat_view_to_screen(const bat_view *view, const double document[2], double screen[2]);
/* Moves the view so that the document point lies under the view pixel. */
void bat_view_hold(bat_view *view, const double document[2], const double screen[2]);
/* Moves the document point under `from` to `to` (view pixels). */
void bat_view_pan(bat_view *view, const double from[2], const double to[2]);
/* Pans by the least amount that brings the document point inside, `margin` pixels from the window's border. */
void bat_view_show(bat_view *view, const double point[2], double margin);
/* Multiplies the zoom, within its limits, keeping the document point under `about` in place. */
void bat_view_zoom(bat_view *view, const double about[2], double factor);
/* Turns by that many degrees about the document point under `about`. */
void bat_view_rotate(bat_view *view, const double about[2], double degrees);
/* Shows the whole box (x0 y0 x1 y1, document units), centred, with `margin` pixels free around it, rotated as the
 * view is. A box of no extent is centred at the present zoom. False: the box is empty or unbounded, or the window has
 * no size. */
bool bat_view_fit(bat_view *view, const double box[4], double margin);

/* The axis-aligned box around what the window shows, document units. */
void bat_view_box(const bat_view *view, double box[4]);

#endif
