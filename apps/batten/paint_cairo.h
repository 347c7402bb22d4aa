/* Paints a document with cairo, as PNG, PDF or EPS. Planar only: for points in space, x and y are used. */
#ifndef BATTEN_APPS_PAINT_CAIRO_H
#define BATTEN_APPS_PAINT_CAIRO_H

#include "picture.h"

#include <batten/document.h>

enum { PAINT_SIZE_MAX = 32767 }; /* pixels per side, cairo's limit */

/* What is shown (x, y, width, height in document units), and the size of the output in pixels (PDF, EPS: points).
 * The view is centred and keeps its proportions. */
typedef struct paint_area {
    double view[4];
    int width, height;
} paint_area;

/* The page, or without a page the box of the drawing with its strokes. width 0: one pixel per unit of the
 * page; without a page 1000 pixels for the longer side. */
void paint_area_of(const bat_document *document, int width, int height, paint_area *out);

/* How many things could not be painted: there is no librsvg, or it cannot read them. What has such a mask is painted whole, and in
 * place of such a pattern a colour. */
typedef struct paint_left {
    int images, foreign, patterns, masks;
} paint_left;

/* Makes the bytes of the file, a PNG, a PDF or an EPS; *data is malloc'ed. background: 0xRRGGBBAA. *left: zeros before. Returns NULL, or what went wrong
 * (static storage). */
const char *paint_document(const bat_document *document, const paint_area *area, picture_kind kind,
                           uint32_t background, unsigned char **data, size_t *size, paint_left *left);

#endif
