/* Subpaths of cubic Béziers, as the SVG reader collects them. A failure to allocate is remembered: check
 * `failed`. */
#ifndef BATTEN_FORMAT_SVG_OUTLINE_H
#define BATTEN_FORMAT_SVG_OUTLINE_H

#include <batten/base.h>

/* Most segments that all subpaths may have together. */
enum { BAT_OUTLINE_MAX = 1 << 22 };

typedef struct bat_subpath {
    size_t first; /* index of its first point */
    int segments; /* 3 * segments + 1 points */
    bool closed;  /* the last point equals the first */
    /* Where in its path data it begins, set by bat_svg_path: with its move, or where there is none with what is drawn; and where
     * what is drawn begins. */
    size_t from, drawn;
    char implied; /* the command that stands for the one that is left out there; 0: there is one */
} bat_subpath;

typedef struct bat_outline {
    double *points; /* x y */
    size_t count, room;
    bat_subpath *subpaths;
    int subpath_count, subpath_room;
    double at[2], start[2]; /* the pen's position, and the start of its subpath */
    bool drawing;           /* the last subpath continues from the pen */
    bool failed, full;      /* out of memory; more than BAT_OUTLINE_MAX segments */
} bat_outline;

void bat_outline_move(bat_outline *outline, double x, double y);
void bat_outline_line(bat_outline *outline, double x, double y); /* handles at the thirds */
void bat_outline_quadratic(bat_outline *outline, double x1, double y1, double x, double y);
void bat_outline_cubic(bat_outline *outline, double x1, double y1, double x2, double y2, double x, double y);
/* SVG's arc (SVG 2, B.2): radii, rotation of the x axis in degrees, flags, end point. One cubic for each 30
 * degrees or less: off the ellipse by at most 4e-7 of the radius. */
void bat_outline_arc(bat_outline *outline, double rx, double ry, double rotation, bool large, bool sweep,
                     double x, double y);
void bat_outline_close(bat_outline *outline);
/* x' = a x + c y + e, y' = b x + d y + f with m = {a, b, c, d, e, f}. */
void bat_outline_transform(bat_outline *outline, const double m[6]);
/* The box of the curves, not of their handles: low x, low y, high x, high y; empty when there is no subpath. */
void bat_outline_box(const bat_outline *outline, double box[4]);
/* Empties the outline but keeps its memory. */
void bat_outline_clear(bat_outline *outline);
void bat_outline_free(bat_outline *outline);

#endif
