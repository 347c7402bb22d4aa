/* An element as a small SVG file of its own: with the elements around it, what it refers to, and the style sheets, so that it
 * looks as in its place. Nothing in it leads outside: hosts show it as a picture, in which nothing is fetched or run. */
#ifndef BATTEN_FORMAT_SVG_ALONE_H
#define BATTEN_FORMAT_SVG_ALONE_H

#include "format/svg/walk.h"

/* box: what is shown, in units of the document. BAT_UNSUPPORTED: the file's text is not at hand, or the element cannot stand
 * alone; BAT_COUNT: it would be too large. O(size of what is written). */
bat_status bat_svg_alone(bat_svg_walk *w, uint32_t element, const double box[4], bat_picture **out);

/* The same for what an element holds, which is written between two texts, in the pixels of a picture of that size. */
bat_status bat_svg_alone_within(bat_svg_walk *w, uint32_t element, const uint32_t sides[2],
                                const bat_text *before, const char *after, bat_picture **out);

/* Opens elements with the attributes of those around a holder, which what is in it inherits, and closes them: in `before` and
 * `after`. The effects of those elements are none of the holder's, and left out. */
void bat_svg_alone_around(const bat_svg_walk *w, uint32_t holder, bat_text *before, bat_text *after);
/* The attributes of an element that holds something, as far as they say how that looks. */
void bat_svg_alone_attributes(const bat_svg_walk *w, uint32_t element, bat_text *out);
/* The same as bat_svg_alone_within, kept by the walk among its pictures (pattern.c). */
bat_status bat_svg_held(bat_svg_walk *w, uint32_t holder, const uint32_t sides[2], const bat_text *before,
                        const char *after, bat_picture **out);

/* A generous box of a text element, in its own units: fonts are not at hand, so widths are guessed. False: it is empty. */
bool bat_svg_text_box(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, double box[4]);

#endif
