/* Shapes that SVG has elements for: rect, circle, ellipse. */
#ifndef BATTEN_FORMAT_SVG_WRITE_BASIC_H
#define BATTEN_FORMAT_SVG_WRITE_BASIC_H

#include "format/svg/outline.h"
#include "hands/figures/primitive.h"
#include "text/text.h"

#include <batten/document.h>

enum { BAT_SVG_BASIC_NUMBERS = 6 };
typedef struct bat_svg_basic {
    const char *name;
    int count;
    const char *names[BAT_SVG_BASIC_NUMBERS];
    double numbers[BAT_SVG_BASIC_NUMBERS];
    bool elsewhere; /* it begins at another place than the curve, or runs the other way: dashes would, too */
    bool turned;
    double turn[6]; /* its transform; the identity if it is not turned */
} bat_svg_basic;

/* The element that shows the shape, not regarding where it begins. False: there is none. */
bool bat_svg_basic_of(const bat_primitive *p, bat_svg_basic *out);
/* The same for an object that is such a shape, with numbers rounded as those of a path. precision: as of bat_svg_write_within; text: failed when
 * there is no memory. */
bool bat_svg_has_basic(const bat_object *object, double precision, bat_text *text, bat_svg_basic *out);
/* Its attributes, without the transform. */
void bat_svg_write_basic(bat_text *text, const bat_svg_basic *basic);
/* What a reader finds in it, in its own units. */
void bat_svg_basic_outline(const bat_svg_basic *basic, bat_outline *outline);

#endif
