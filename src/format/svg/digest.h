/* What an SVG shows, as a digest: tells whether the native document beside it still agrees. */
#ifndef BATTEN_FORMAT_SVG_DIGEST_H
#define BATTEN_FORMAT_SVG_DIGEST_H

#include "format/svg/outline.h"

#include <batten/document.h>

/* Adds one drawn object: its outline in user units and its style (only what shows of it). */
uint64_t bat_svg_digest(uint64_t digest, const bat_outline *outline, const bat_style *style);
uint64_t bat_svg_digest_image(uint64_t digest, const bat_picture *picture, const double matrix[6],
                              double opacity);
/* The page as it is written: the document's own, or the drawing's box with the strokes when it has none. */
void bat_svg_page(const bat_document *document, double page[4]);

#endif
