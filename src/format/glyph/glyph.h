/* A glyph of a font (GLIF 2 of UFO 3), from the elements of its file: its outline as the path data of SVG, y downwards. */
#ifndef BATTEN_FORMAT_GLYPH_GLYPH_H
#define BATTEN_FORMAT_GLYPH_GLYPH_H

#include "text/text.h"

#include <batten/base.h>

#define BAT_GLYPH_FARTHEST 1e9 /* font units: of all numbers of a glyph */

typedef struct bat_glyph_point {
    double at[2];
    uint8_t type;
} bat_glyph_point;

/* All zeros: nothing read yet. */
typedef struct bat_glyph {
    bat_text path;      /* of all contours so far */
    char name[128];     /* in UTF-8, cut off at a character */
    double advance;     /* width; 0: not given */
    double height;      /* of the advance; 0: not given */
    double top, bottom; /* of all points and of y = 0 */
    int left_out; /* elements that no drawing holds: components, anchors, guidelines, images, notes, libraries */
    int depth, skip; /* open elements; those of an element that is left out */
    bool in_contour;
    bat_glyph_point *points; /* of the contour that is open */
    size_t count, room;
    const char *wrong; /* what was expected and not found (static storage); NULL: nothing */
} bat_glyph;

bool bat_glyph_is_root(const char *name);
/* The beginning of an element, the root among them; attributes as for bat_svg_reader_start. BAT_SYNTAX: glyph->wrong says why. */
bat_status bat_glyph_start(bat_glyph *glyph, const char *name, const char *const *attributes);
bat_status bat_glyph_end(bat_glyph *glyph);
void bat_glyph_free(bat_glyph *glyph);

#endif
