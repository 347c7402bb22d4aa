/* What one painting has read of pictures, and the tiles that it has made of them: a picture that is needed again is not read
 * again. It belongs to the cairo_t that paints, and goes with it. */
#ifndef BATTEN_APPS_PAINT_KEPT_H
#define BATTEN_APPS_PAINT_KEPT_H

#include <batten/document.h>
#include <cairo.h>
#include <stdbool.h>

typedef struct paint_kept paint_kept;

/* NULL: no memory. */
paint_kept *paint_kept_of(cairo_t *cairo);
/* Paints the picture over its pixels; false: it cannot be painted: it is no PNG, and librsvg is missing or cannot read it. */
bool paint_picture(paint_kept *kept, cairo_t *cairo, const bat_picture *picture);
/* Whether all of it is painted, as far as that can be told: not if it cannot be read, nor if it holds a picture and shows nothing,
 * since librsvg leaves out what it cannot decode. */
bool paint_is_whole(paint_kept *kept, const bat_picture *picture);
/* The picture in so many pixels; pixels 0: as it is, for a surface that has none. NULL: it cannot be painted, or there is no memory.
 * It is kept: what is made of it refers to it. */
cairo_surface_t *paint_tile_surface(paint_kept *kept, const bat_picture *picture, double opacity,
                                    const int pixels[2]);

#endif
