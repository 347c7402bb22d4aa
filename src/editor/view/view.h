/*
 * The view: which part of the document the window shows, and at what angle. screen = R(angle) (drawing - (x, y)) *
 * zoom, in view pixels; y points down, so R turns clockwise.
 *
 * Drawing coordinates are what the window shows. Face-on (tilt 0) they are the x y of the page, and a point in space
 * loses its z. Tilted, they are coordinates in the plane through the pivot at right angles to the gaze, in document
 * units: parallel projection onto it. The page lies like a table top, z points down through it, away from an eye
 * above: angle is the turn of the table, tilt how far the eye has come down towards its edge (90) and under it (180).
 * The pivot has the same drawing coordinates at every angle and tilt: its x y.
 */
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
    double tilt, tilt_cosine, tilt_sine; /* degrees, [0, 180], whole hundredths; 0: face-on */
    double pivot[3];                     /* what orbits turn about; without effect face-on */
} bat_view;

bat_view bat_view_defaults(void);
/* At the origin, upright, at zoom 1; the window keeps its size. */
void bat_view_look_afresh(bat_view *view);
/* Sets the angle, any number of degrees, reduced to its range and rounded to its steps. */
void bat_view_turn(bat_view *view, double degrees);
/* Length of a view pixel in document units. */
double bat_view_pixel(const bat_view *view);
/* The ray through a view pixel, away from the eye; face-on from the point of the page seen there, tilted from the plane
 * through the pivot. */
bat_ray bat_view_ray(const bat_view *view, const double pixel[2]);
/* Right, down and ahead in space, as the window shows them: of length 1, at right angles to each other. */
void bat_view_axes(const bat_view *view, double right[3], double down[3], double ahead[3]);
/* Drawing coordinates of points in space, as two rows of four numbers, the translation last. */
void bat_view_map(const bat_view *view, double map[8]);
/* Turns about the pivot, which stays where it is seen. The tilt is kept within its range; face-on that is a turn of the
 * page about the pivot. */
void bat_view_orbit(bat_view *view, double angle, double tilt);
/* Moves the pivot; the picture stays. */
void bat_view_set_pivot(bat_view *view, const double at[3]);
/* Drawing coordinates of a pixel, and back. */
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
