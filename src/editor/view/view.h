/*
 * The view: which part of the document the window shows, and at what angle. screen = R(angle) (drawing - (x, y)) *
 * zoom, in view pixels; y points down, so R turns clockwise.
 *
 * Drawing coordinates are what the window shows. Face-on (tilt 0) they are the x y of the page, and a point in space
 * loses its z. Tilted, they are coordinates in the plane through the pivot at right angles to the gaze, in document
 * units: parallel projection onto it. The page lies like a table top, z points down through it, away from an eye
 * above: angle is the turn of the table, tilt how far the eye has come down towards its edge (90) and under it (180). Roll
 * is the turn of the head: the window shows the page turned by angle, of which the table has turned by angle - roll.
 * The pivot has the same drawing coordinates at every angle and tilt: its x y.
 *
 * In perspective the plane through the pivot is seen as it is in parallel projection, so that lengths there stay; the eye
 * is before the middle of the window, at the distance at which its height fills the angle of view. Drawing coordinates
 * are those of the place where the line from the eye meets that plane. Face-on the projection is always parallel.
 */
#ifndef BATTEN_EDITOR_VIEW_VIEW_H
#define BATTEN_EDITOR_VIEW_VIEW_H

#include "editor/view/ground.h"

#define BAT_ZOOM_MIN 1e-6
#define BAT_ZOOM_MAX 1e6
#define BAT_VIEW_REACH 1e12 /* limit on the document coordinates of the view's corner */
#define BAT_PIXELS_MAX 1e6  /* limit on the view pixels of events and sizes */
#define BAT_FOV 40          /* degrees: the vertical angle of view in perspective */
#define BAT_NOWHERE 1e30    /* drawing coordinates of what is behind the eye */
#define BAT_VIEW_NEAR                                                                                        \
    1e-3 /* what is nearer to the eye than this share of the pivot's distance counts as behind it */

enum { BAT_MAP_NUMBERS = 12 };

typedef struct bat_view {
    double x, y, zoom;           /* document coordinates of the top left corner; pixels per unit, > 0 */
    double angle, cosine, sine;  /* degrees, (-180, 180], whole hundredths; bat_view_turn sets all three */
    double width, height, ratio; /* view pixels; device pixels per view pixel */
    bool fit_wanted;             /* show everything as soon as the window has a size */
    double tilt, tilt_cosine, tilt_sine; /* degrees, [0, 180], whole hundredths; 0: face-on */
    double roll, low[2]; /* degrees, as angle; the page's direction that is seen going down, of length 1 */
    double pivot[3];     /* what orbits turn about; without effect face-on */
    double fov; /* perspective: the vertical angle of view in degrees; 0: parallel. Without effect face-on */
} bat_view;

bat_view bat_view_defaults(void);
/* At the origin, upright, at zoom 1; the window keeps its size. */
void bat_view_look_afresh(bat_view *view);
/* Sets the angle, any number of degrees, reduced to its range and rounded to its steps. */
void bat_view_turn(bat_view *view, double degrees);
/* Length of a view pixel in document units. */
double bat_view_pixel(const bat_view *view);
/* The distance of the eye from the plane through the pivot; 0: in parallel projection it has none. */
double bat_view_away(const bat_view *view);
/* The ray through a view pixel, away from the eye; face-on from the point of the page seen there, tilted from the plane
 * through the pivot, in perspective from the eye. */
bat_ray bat_view_ray(const bat_view *view, const double pixel[2]);
/* Right, down and ahead in space, as the window shows them: of length 1, at right angles to each other. */
void bat_view_axes(const bat_view *view, double right[3], double down[3], double ahead[3]);
/* Drawing coordinates of points in space, as three rows of four numbers, the translation last: the first two divided by the
 * third, which in parallel projection is 0 0 0 1, and in perspective the distance from the eye along the gaze over that of
 * the pivot. */
void bat_view_map(const bat_view *view, double map[BAT_MAP_NUMBERS]);
/* Drawing coordinates of a point by a map; NULL: face-on. False: it is behind the eye; they are BAT_NOWHERE. */
bool bat_map_look(const double *map, int dimension, const double *point, double at[2]);
/* How closely curves are covered in perspective: a twentieth of a pixel. */
double bat_view_tolerance(const bat_view *view);
/* The third row: below BAT_VIEW_NEAR the point counts as behind the eye. */
double bat_map_depth(const double *map, int dimension, const double *point);
/* The direction in which a point is seen, of length 1; zero at the eye. */
void bat_view_towards(const bat_view *view, const double point[3], double along[3]);
/* Turns about the pivot, which stays where it is seen, without a roll. The tilt is kept within its range; face-on that is a
 * turn of the page about the pivot. */
void bat_view_orbit(bat_view *view, double angle, double tilt);
/* The same with a roll, which face-on has no effect. */
void bat_view_pose(bat_view *view, double angle, double tilt, double roll);
/* Moves the pivot; the picture stays. In perspective a point behind the eye, or so far away that the zoom would leave its
 * limits, is not taken. */
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

/* What has to be seen, for a view in perspective: how far it lies beyond the sides of the window at an eye in the pivot. */
typedef struct bat_view_extent {
    double room[2]; /* tangents of half the angles within which all is to be */
    double most[4], near;
} bat_view_extent;
/* Begins with nothing, `margin` pixels from the window's border. */
void bat_view_extent_start(const bat_view *view, double margin, bat_view_extent *extent);
void bat_view_extent_add(const bat_view *view, bat_view_extent *extent, const double point[3]);
/* Shows all of it, in the middle, without turning. False: nothing was added, or the window has no size. */
bool bat_view_extent_fit(bat_view *view, const bat_view_extent *extent);

/* The axis-aligned box around what the window shows, document units. */
void bat_view_box(const bat_view *view, double box[4]);

#endif
