/* The pieces of markup that an object is written with. */
#ifndef BATTEN_FORMAT_SVG_MARKUP_H
#define BATTEN_FORMAT_SVG_MARKUP_H

#include "text/text.h"

#include <batten/document.h>

void bat_svg_write_pair(bat_text *text, const double *p);
/* Path data: cubic Béziers, exact up to degree 3. */
bat_status bat_svg_write_curve(bat_text *text, const bat_curve *curve);
/* attribute: with the space before it, and up to the quote behind it: ` width="`. */
void bat_svg_write_number(bat_text *text, const char *attribute, double number);
void bat_svg_write_name(bat_text *text, const char *attribute,
                        const char *name); /* nothing for an empty name */
void bat_svg_write_style(bat_text *text, const bat_style *style);
/* The same as one attribute, which overrules style sheets and says all that something around it could say otherwise. */
void bat_svg_write_style_attribute(bat_text *text, const bat_style *style);
/* The rest of an image element after its name: placed by m, and ended. */
void bat_svg_write_picture(bat_text *text, const bat_picture *picture, const double m[6], double opacity);
void bat_svg_write_state(bat_text *text, const bat_object *object); /* hidden, locked */

#endif
