/* A document painted by cairo: PNG and PDF. Planar only: of points in space, x and y. */
#ifndef BATTEN_APPS_PAINT_CAIRO_H
#define BATTEN_APPS_PAINT_CAIRO_H

#include <batten/document.h>

enum { PAINT_SIZE_MAX = 32767 }; /* pixels a side, cairo's limit */

/* What is shown (x, y, width, height in document units), on how many pixels (points in a PDF). The view is
 * centred, with its proportions kept. */
typedef struct paint_area {
    double view[4];
    int width, height;
} paint_area;

/* The page, or the box of the drawing with its strokes when there is no page. width 0: one pixel a unit of
 * the page; without a page 1000 pixels on the longer side. */
void paint_area_of(const bat_document *document, int width, int height, paint_area *out);

typedef enum paint_kind { PAINT_PNG, PAINT_PDF } paint_kind;

/* background: 0xRRGGBBAA. The file's bytes: *data is malloc'ed. NULL, or what went wrong (static storage). */
const char *paint_document(const bat_document *document, const paint_area *area, paint_kind kind,
                           uint32_t background, unsigned char **data, size_t *size);

#endif
