/* A curve as the cubics that its path data are written from, with the rounding that nobody sees. */
#ifndef BATTEN_FORMAT_SVG_CUBICS_H
#define BATTEN_FORMAT_SVG_CUBICS_H

#include "text/text.h"

#include <batten/curve.h>

/* "x y" */
void bat_svg_write_pair(bat_text *text, const double *p);

typedef struct bat_svg_cubics {
    double *points; /* 4 of each, with `dimension` numbers, of which 2 are written */
    int count, dimension;
    bool lines; /* the curve has straight legs only */
    double extent, fine;
} bat_svg_cubics;

/* Exact up to degree 3; of the curve mapped by m (NULL: as it is). precision: as of bat_svg_write_within. */
bat_status bat_svg_cubics_make(const bat_curve *curve, const double m[6], double precision,
                               bat_svg_cubics *out);
void bat_svg_cubics_free(bat_svg_cubics *cubics);
static inline const double *bat_svg_cubic(const bat_svg_cubics *cubics, int i) {
    return cubics->points + (ptrdiff_t)4 * cubics->dimension * i;
}
/* The point as it is written. */
void bat_svg_round(const bat_svg_cubics *cubics, const double *point, double out[2]);
/* Whether the cubic is what a reader makes of a line. */
bool bat_svg_cubic_is_line(const bat_svg_cubics *cubics, int i);
/* Whether it is a line from there that Z draws, which draws none of no length. */
bool bat_svg_is_closing(const bat_svg_cubics *cubics, int i, const double from[2], const double start[2]);
/* The command of a cubic or line that ends there. */
void bat_svg_write_cubic(bat_text *text, const bat_svg_cubics *cubics, int i, const double end[2]);

#endif
