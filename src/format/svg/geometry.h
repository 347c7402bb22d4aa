/* Where elements are, as far as declarations of style say it: geometry properties and transforms (SVG 2, 8 and 10; CSS
 * Transforms 1 and 2), as browsers obey them. */
#ifndef BATTEN_FORMAT_SVG_GEOMETRY_H
#define BATTEN_FORMAT_SVG_GEOMETRY_H

#include "format/svg/svg.h"
#include "format/svg/walk.h"

/* In the order of their names. */
typedef enum bat_svg_geometry {
    BAT_SVG_GEOMETRY_CX,
    BAT_SVG_GEOMETRY_CY,
    BAT_SVG_GEOMETRY_D,
    BAT_SVG_GEOMETRY_HEIGHT,
    BAT_SVG_GEOMETRY_R,
    BAT_SVG_GEOMETRY_ROTATE,
    BAT_SVG_GEOMETRY_RX,
    BAT_SVG_GEOMETRY_RY,
    BAT_SVG_GEOMETRY_SCALE,
    BAT_SVG_GEOMETRY_TRANSFORM,
    BAT_SVG_GEOMETRY_BOX, /* that percentages refer to */
    BAT_SVG_GEOMETRY_ORIGIN,
    BAT_SVG_GEOMETRY_TRANSLATE,
    BAT_SVG_GEOMETRY_WIDTH,
    BAT_SVG_GEOMETRY_X,
    BAT_SVG_GEOMETRY_Y,
    BAT_SVG_GEOMETRY_COUNT /* no such property */
} bat_svg_geometry;

bat_svg_geometry bat_svg_geometry_of(const char *name);
/* Sets such a property by a declaration's value. False: it has none that is understood here, and nothing is set. */
bool bat_svg_geometry_set(bat_svg_style *style, bat_svg_geometry property, const char *value, size_t size,
                          bool important);
/* What the style says of it, else the attribute; NULL: nothing, or "auto". Path data are without their path(). */
const char *bat_svg_geometry_text(const bat_svg_tree *tree, uint32_t element, const bat_svg_style *style,
                                  const char *name);
/* As bat_svg_length_of, with its own style. */
double bat_svg_geometry_length(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style,
                               const char *name, double whole, double otherwise);
/* BAT_DECLARED_SHAPE, ..., of an element with that style. */
unsigned bat_svg_geometry_declared(const bat_svg_style *style);

/* The shape of an element in the scope at its place, which both must outlive it. */
typedef struct bat_svg_shape_holder {
    const bat_svg_tree *tree;
    uint32_t element;
    const bat_svg_style *style;
} bat_svg_shape_holder;
bat_svg_shape bat_svg_shape_of(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                               bat_svg_shape_holder *holder);

/* What is lost with a shape that could not be read whole: nothing is seen of it where browsers do not understand it either. */
bat_loss bat_svg_shape_loss(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style);

typedef enum bat_svg_moved {
    BAT_SVG_MOVED_NOT,
    BAT_SVG_MOVED_SO,
    BAT_SVG_MOVED_BY_BOX,  /* as its box lies */
    BAT_SVG_MOVED_WRONGLY, /* not, since no browser understands what it says */
    BAT_SVG_MOVED_BADLY /* as nothing that is understood here, or by a box that is not known: m is what was understood */
} bat_svg_moved;
/* From an element's own units to those around it; s: the scope at its place, whose matrix is not used. */
bat_svg_moved bat_svg_matrix_of(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, double m[6]);

/* ---- transform.c: transforms as CSS has them ---- */
/* "name(value, ...) ...", or none; sides: of the box that percentages refer to. */
bool bat_svg_functions(const char *text, const double sides[2], double m[6]);
/* The values of `translate`, `rotate` or `scale`. */
bool bat_svg_function_of(const char *name, const char *values, const double sides[2], double m[6]);
/* The origin in such a box; plain: lengths need no units. */
bool bat_svg_origin(const char *text, const double sides[2], bool plain, double at[2]);

#endif
