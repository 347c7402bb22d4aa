/* Draws a document in space as SVG or PDF: lines as Bezier curves, split where they become hidden. */
#ifndef BATTEN_APPS_DRAW_SPACE_H
#define BATTEN_APPS_DRAW_SPACE_H

#include <batten/document.h>
#include <batten/view.h>

/* What is hidden is dashed, or left out; pdf: PDF, else SVG. background: 0xRRGGBBAA. Makes the bytes of the file; *data is
 * malloc'ed. *whole: whether all silhouettes and intersections were found. Returns NULL, or what went wrong (static
 * storage). */
const char *draw_space(const bat_document *document, const bat_viewpoint *view, bool dashed,
                       uint32_t background, bool pdf, unsigned char **data, size_t *size, bool *whole);

#endif
