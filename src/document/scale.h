/* The physical size of a document. */
#ifndef BATTEN_SRC_SCALE_H
#define BATTEN_SRC_SCALE_H

#include "document/unit.h"

/* Millimetres from its lower left corner, y up: x = scale (X - corner[0]), y = scale (corner[1] - Y). The corner is the
 * page's, or without a page the document's origin. Returns the scale. */
double bat_unit_corner(const bat_document *document, double corner[2]);
/* Whether files of the document say its size. */
bool bat_unit_is_said(const bat_document *document);
/* Whether the native format says it: also that numbers are bare. */
bool bat_unit_is_kept(const bat_document *document);
/* Whether two documents are the same size and say so in the same unit, up to what rounding to ten digits changes. */
bool bat_unit_same(const bat_document *a, const bat_document *b);

#endif
