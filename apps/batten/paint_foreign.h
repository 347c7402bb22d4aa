/* Images, foreign content, patterns and masks: painted by cairo if they are PNG files, else by librsvg where that is installed. */
#ifndef BATTEN_APPS_PAINT_FOREIGN_H
#define BATTEN_APPS_PAINT_FOREIGN_H

#include <batten/document.h>
#include <cairo.h>

/* Whether the picture is painted as it is: not without librsvg, or if that cannot read it or decode what is in it. */
bool paint_is_known(cairo_t *cairo, const bat_picture *picture);
/* Paints an image or foreign content in its place, with the object's opacity. What the content refers to beyond itself is not fetched, and nothing in it is run. */
void paint_placed(cairo_t *cairo, const bat_object *object);

/* Paints the picture over its pixels; false: it cannot be painted. */
bool paint_once(cairo_t *cairo, const bat_picture *picture);
/* The picture repeated, from its pixels; NULL: it cannot be painted. scale: how many pixels of the surface are to be one of the
 * picture; 0: the surface has none. The caller destroys it. */
cairo_pattern_t *paint_tile(cairo_t *cairo, const bat_picture *picture, double opacity, double scale);

#endif
