/* Draws a document in space as SVG, PDF or EPS: lines as Bezier curves, split where they become hidden, over the shading as
 * one picture. */
#ifndef BATTEN_APPS_DRAW_SPACE_H
#define BATTEN_APPS_DRAW_SPACE_H

#include "form/shade/shade.h"
#include "picture.h"

#include <batten/document.h>

/* What is hidden is left out; BAT_LOOK_LINES: dashed, and there is no shading. kind: none of pixels. background:
 * 0xRRGGBBAA. The view's size is in whole pixels. Makes the bytes of the file; *data is malloc'ed. *whole: whether all silhouettes and intersections were found. Returns NULL, or what went wrong (static
 * storage). */
const char *draw_space(const bat_document *document, const bat_viewpoint *view, bat_look look,
                       uint32_t background, picture_kind kind, unsigned char **data, size_t *size,
                       bool *whole);

#endif
