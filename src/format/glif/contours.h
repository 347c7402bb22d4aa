/* What is drawn as the contours of a glyph (GLIF 2). */
#ifndef BATTEN_FORMAT_GLIF_CONTOURS_H
#define BATTEN_FORMAT_GLIF_CONTOURS_H

#include "text/text.h"

#include <batten/document.h>

/* Adds a contour element for each visible curve, a line a point. extremes: cubics are cut where they are furthest left,
 * right, up and down, as fonts want it. BAT_DIMENSION: a curve lies in space; BAT_NUMBER: a point lies further out than
 * BAT_GLYPH_FARTHEST. O(points). */
bat_status bat_glif_contours(const bat_document *document, bool extremes, bat_text *text);

#endif
