/* Paints a document with cairo, as PNG, PDF or EPS. Planar only: for points in space, x and y are used. */
#ifndef BATTEN_APPS_PAINT_CAIRO_H
#define BATTEN_APPS_PAINT_CAIRO_H

#include "picture.h"

#include <batten/document.h>

#include <cairo.h>

enum { PAINT_SIZE_MAX = 32767 }; /* pixels per side, cairo's limit */

/* What is shown (x, y, width, height in document units), and the size of the output in pixels (PDF, EPS: points).
 * The view is centred and keeps its proportions. */
typedef struct paint_area {
    double view[4];
    double width, height; /* whole numbers of pixels */
} paint_area;

/* The page, or without a page the box of the drawing with its strokes, in the size that is asked for. Without one PDF and EPS
 * have the drawing's own size, and pictures in pixels that at wanted->dpi; without that, 96 pixels an inch where the
 * document says its size in mm or the like, one a unit of the page where it does not, and without a page 1000 for the longer side. */
void paint_area_of(const bat_document *document, const picture_wanted *wanted, paint_area *out);

/* How many things could not be painted: there is no librsvg, or it cannot read them. What has such a mask is painted whole, and in
 * place of such a pattern a colour. */
typedef struct paint_left {
    int images, foreign, patterns, masks;
} paint_left;

/* Paints what is shown of the document where cairo's origin is, and as far as it is not clipped. The matrix is changed. */
bat_status paint_area_onto(cairo_t *cairo, const bat_document *document, const paint_area *area,
                           uint32_t background, paint_left *left);

/* Makes the bytes of the file, a PNG, a PDF or an EPS; *data is malloc'ed. *left: zeros before. A PNG says how large it is where
 * the document does, or its resolution was asked for. Returns NULL, or what went wrong (static storage). */
const char *paint_document(const bat_document *document, const paint_area *area, const picture_wanted *wanted,
                           unsigned char **data, size_t *size, paint_left *left);

#endif
