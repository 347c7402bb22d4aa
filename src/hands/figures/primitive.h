/* Shapes that stay shapes: a rectangle with round corners, an ellipse or a part of one, a regular polygon or a star. A few numbers
 * give the curve, and a place of each on the drawing can be dragged. */
#ifndef BATTEN_HANDS_FIGURES_PRIMITIVE_H
#define BATTEN_HANDS_FIGURES_PRIMITIVE_H

#include <batten/curve.h>
#include <stdbool.h>

typedef enum bat_primitive_kind {
    BAT_RECTANGLE,
    BAT_ELLIPSE,
    BAT_POLYGON,
    BAT_PRIMITIVE_KINDS
} bat_primitive_kind;

/* How a part of an ellipse is closed: over its middle, straight, not at all. */
typedef enum bat_arc_ends { BAT_ARC_PIE, BAT_ARC_CHORD, BAT_ARC_OPEN, BAT_ARC_ENDS } bat_arc_ends;

enum { BAT_SIDES_MIN = 3, BAT_SIDES_MAX = 1000 };

typedef struct bat_primitive {
    bat_primitive_kind kind;
    /* {a, b, c, d, e, f}: own (s, t) lies at (a s + c t + e, b s + d t + f). A rectangle is the square from 0 to 1, and its axes are
     * at right angles; an ellipse is the circle of radius 1 about 0, in which a polygon has its corners, one of them at (1, 0). */
    double place[6];
    double radii[2]; /* of a rectangle's corners along its axes, document units: at most half the sides */
    double start,
        sweep; /* of an ellipse: degrees, from the first axis away from the second one, 0 <= start < 360; 360: all of it */
    bat_arc_ends ends;
    int sides; /* of a polygon */
    double
        depth; /* how far the middles of its sides are drawn in, as a share of their distance; above 0: a star */
    double roundness; /* of its corners: the share of half a side that is round */
} bat_primitive;

/* A rectangle or an ellipse in the box x0 y0 x1 y1; a polygon about a middle with a corner there. */
bat_primitive bat_primitive_rectangle(const double box[4], double radius);
bat_primitive bat_primitive_ellipse(const double box[4]);
bat_primitive bat_primitive_polygon(const double middle[2], const double corner[2], int sides);

/* BAT_COUNT: it has no width or no height, or too few or too many sides; BAT_NUMBER: another number is out of range. */
bat_status bat_primitive_check(const bat_primitive *p);
/* Its curve, cubics: a quarter of an ellipse or a round corner is one, off it by at most 3e-4 of the radius. */
bat_status bat_primitive_curve(const bat_primitive *p, bat_curve **out);
/* The image under a matrix {a, b, c, d, e, f}. False: it is none of these shapes any longer. */
bool bat_primitive_map(const bat_primitive *p, const double matrix[6], bat_primitive *out);

/* ---- its numbers ---- */
typedef enum bat_primitive_number {
    BAT_PRIMITIVE_RADIUS,    /* document units */
    BAT_PRIMITIVE_START,     /* degrees, counterclockwise as an unturned one is seen */
    BAT_PRIMITIVE_END,       /* up to 360 */
    BAT_PRIMITIVE_SIDES,     /* from 3 to 1000 */
    BAT_PRIMITIVE_DEPTH,     /* percent */
    BAT_PRIMITIVE_ROUNDNESS, /* percent */
    BAT_PRIMITIVE_NUMBERS
} bat_primitive_number;
/* False: it has no such number. */
bool bat_primitive_get(const bat_primitive *p, bat_primitive_number number, double *value);
/* Sets it, as far as it goes. False as above, or the value is not finite. */
bool bat_primitive_set(bat_primitive *p, bat_primitive_number number, double value);

/* ---- the same on the drawing ---- */
/* Where the number is dragged, document units; inset: how far within the outline, at least. False: nowhere. */
bool bat_primitive_handle(const bat_primitive *p, bat_primitive_number number, double inset, double at[2]);
/* Sets it as if its handle had been dragged from one place to another; degrees and percents are whole then. */
void bat_primitive_drag(bat_primitive *p, bat_primitive_number number, const double from[2],
                        const double to[2]);

#endif
