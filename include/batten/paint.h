/*
 * What paints an object beyond its style: gradients and patterns in place of its colours, dashes, a pen that is not
 * round, a width that changes along the stroke, and the order of fill and stroke.
 *
 * An object keeps its paint through all edits of its curves; maps of the plane map it along. A gradient takes the place of
 * a colour of the style and goes when that colour is changed.
 *
 * Source: SVG 2, 13 (Painting) and 14 (Paint servers).
 */
#ifndef BATTEN_PAINT_H
#define BATTEN_PAINT_H

#include <batten/document.h>
#include <batten/width.h>

/* The most of either. */
enum { BAT_STOPS_MAX = 256, BAT_DASHES_MAX = 64 };

typedef enum bat_spread { BAT_SPREAD_PAD, BAT_SPREAD_REFLECT, BAT_SPREAD_REPEAT } bat_spread;

typedef struct bat_stop {
    double at;       /* 0..1, never less than that of the stop before */
    uint32_t colour; /* 0xRRGGBBAA */
} bat_stop;

/* The colour at a point is that of the stops at t, where the point lies on the circle about from + t (to - from) of radius
 * from[2] + t (to[2] - from[2]), with the largest such t (radial), or on the line through from + t (to - from), across
 * to - from (linear; both radii are 0). Sources as in SVG 2, 14.2. */
typedef struct bat_gradient {
    bool radial;
    bat_spread spread;
    double from[3], to[3]; /* x, y, radius */
    double matrix[6];      /* from the gradient's own units to the document's; not singular */
    size_t count;          /* 2 to BAT_STOPS_MAX; 0: there is no gradient */
    const bat_stop *stops;
    /* NULL, or a pattern: this picture, repeated in both directions of its pixels, is painted in place of the colours, as
     * translucent as the first stop is. matrix: from its pixels. It is linear and repeated, from its left edge, 0 0, to its
     * right edge; its two stops, at 0 and 1, are the same grey, 0x808080, and seen where no picture can be painted. Source: SVG 2, 14.3. */
    const bat_picture *tile;
} bat_gradient;

typedef struct bat_paint {
    bat_gradient fill, stroke;
    size_t dash_count;    /* 0: no dashes; else their lengths and gaps in turn, repeated */
    const double *dashes; /* document units, at least 0, not all 0; at most BAT_DASHES_MAX */
    double dash_offset;   /* where in the pattern the stroke begins */
    double pen[4];        /* {a, b, c, d}: its image of the circle of the style's width; all 0: the circle */
    bool stroke_first;    /* the stroke is painted before the fill, which then covers its inner half */
    size_t width_count;   /* 0: the stroke is as wide everywhere; else at most BAT_WIDTHS_MAX */
    const bat_width_stop *
        widths; /* a profile (width.h): shares of the style's width along each curve. Planar curves are painted so,
                                   * with a round pen and without dashes; the stroke is then a filled outline */
} bat_paint;

/* The statuses of bat_object_with_paint for a paint; problem (may be NULL) says what is wrong: "fill.stops[2].at". */
BAT_API bat_status bat_paint_check(const bat_paint *paint, bat_problem *problem);
/* A copy with that paint, which is copied, its pictures retained; NULL, or a paint with nothing in it: none. BAT_ARGUMENT: the object is not made of
 * curves, or has a kind whose curves only show it; BAT_NUMBER: a number that is not finite or beyond BAT_COORDINATE_MAX, a
 * singular matrix or pen, stops that go back, negative dashes or radii, widths that are no profile, a gradient that is a point or
 * whose outer circle has no radius, a pattern that is not from edge to edge of its picture, or has
 * other stops; BAT_COUNT: too many stops, dashes or widths, or a single stop. O(of them all). */
BAT_API bat_status bat_object_with_paint(const bat_object *object, const bat_paint *paint, bat_object **out);
/* NULL: none, as of most objects. Valid as long as the object. */
BAT_API const bat_paint *bat_object_paint(const bat_object *object);

/* The profile by which the object's strokes are painted, its stops valid as long as the object; without stops there is none: nothing is
 * stroked, or dashed, with a pen that is not round, or not in the plane. */
BAT_API bat_width_profile bat_object_widths(const bat_object *object);
/* What covers the stroke of one of its curves, for the non-zero rule, as bat_curve_cover_width, within 2e-4 of the greatest
 * width. BAT_ARGUMENT: no such curve, or no profile. */
BAT_API bat_status bat_object_cover(const bat_object *object, int curve, size_t *cubics, double **points);

#endif
