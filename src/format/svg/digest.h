/* A digest of what an SVG shows, to tell whether the native document in the file still matches it. */
#ifndef BATTEN_FORMAT_SVG_DIGEST_H
#define BATTEN_FORMAT_SVG_DIGEST_H

#include "document/markers.h"
#include "document/paint.h"
#include "format/svg/outline.h"

/* Adds one drawn object: its outline in user units and the visible part of its style and paint (NULL: none). */
uint64_t bat_svg_digest(uint64_t digest, const bat_outline *outline, const bat_style *style,
                        const bat_paint *paint);
/* A group that is translucent as a whole; before all that is in it. */
uint64_t bat_svg_digest_group(uint64_t digest, double opacity);
/* A shape of a clip path, in the document's units or those of a box. */
uint64_t bat_svg_digest_region(uint64_t digest, const bat_outline *outline, bool even_odd);
uint64_t bat_svg_digest_image(uint64_t digest, const bat_picture *picture, const double matrix[6],
                              double opacity);
/* What an element of a marker says; before it, from a new digest, each of its shapes with where its inks come from. */
uint64_t bat_svg_digest_marking(uint64_t digest, const bat_marking *marking);
uint64_t bat_svg_digest_inks(uint64_t digest, bat_marker_ink fill, bat_marker_ink stroke);
/* The page as written: the document's own, or, when it has none, the box of the drawing with its strokes. */
void bat_svg_page(const bat_document *document, double page[4]);

#endif
