/* Inside the room: the sides of a stroke of varying width. A side is the curve moved along its normals by half the width there;
 * where the half width is greater than the radius of curvature, a side runs backwards: there the stroke ends at the
 * evolute for one sheet, and a second sheet, turned over, lies between the evolute and the side (docs/math/relate.md 8). */
#ifndef BATTEN_SRC_RELATE_WIDEN_H
#define BATTEN_SRC_RELATE_WIDEN_H

#include <batten/width.h>

/* Cubics one after another, each with its four points. */
typedef struct bat_border {
    size_t count, room;
    double *points;
    bool begun; /* `at` is set */
    double at[2];
    bat_status status; /* the first failure; nothing is added after it */
} bat_border;

void bat_border_move(bat_border *border, const double to[2]);
void bat_border_line(bat_border *border, const double to[2]); /* nothing where it is already */
void bat_border_cubic(bat_border *border, const double cubic[8]);
/* Round a centre by an angle, from where the border is, in cubics within tolerance. */
void bat_border_arc(bat_border *border, const double centre[2], double angle, double tolerance);
/* Appends the other, the other way round; the other may be empty. */
void bat_border_append(bat_border *border, const bat_border *other, bool reversed);
void bat_border_free(bat_border *border);

enum { BAT_STRETCH_STEPS = 8 };

/* A cubic of the curve, and where it lies along it. */
typedef struct bat_wide_stretch {
    double b[8];
    double before, length;               /* of the curve in front of it, and of itself */
    double steps[BAT_STRETCH_STEPS + 1]; /* its length up to each eighth of its parameter */
    bool cusp;                           /* behind it the curve turns back on the spot */
} bat_wide_stretch;

typedef struct bat_widening {
    const bat_width_profile *profile;
    double half, tolerance; /* of the nib */
    bool closed;
    double length; /* of the curve */
    int count;
    bat_wide_stretch *stretches; /* those without a length are left out */
    double error;                /* measured */
} bat_widening;

/* A place on the curve: its point, tangent and signed curvature times the half width there. */
typedef struct bat_wide {
    double point[2], tangent[2];
    double speed, half, slope; /* slope: of the half width, by length */
    double bend;               /* curvature; infinite at a cusp */
} bat_wide;

void bat_widening_at(const bat_widening *w, const bat_wide_stretch *s, double t, bat_wide *out);
/* Point of a side, 1 left, -1 right. */
void bat_wide_side(const bat_wide *at, int side, double out[2]);
/* Adds the side along a stretch; what is turned over goes to `over` as closed loops that run as the stroke's outline does. */
void bat_widening_side(bat_widening *w, const bat_wide_stretch *s, int side, bat_border *border,
                       bat_border *over);

/* bat_curve_cover_width, with the greatest error that was measured. The chains of the plain sides come first: one of an open
 * curve, two of a closed one. */
bat_status bat_widen_cover(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                           double tolerance, double corner, size_t *cubics, double **points, double *error);

#endif
