/* What a reader will see of what is written, as it adds it to the digest of a drawing. */
#ifndef BATTEN_FORMAT_SVG_WRITE_SEE_H
#define BATTEN_FORMAT_SVG_WRITE_SEE_H

#include "format/svg/outline.h"
#include "text/text.h"

#include <batten/paint.h>

/* Of the clip of an object; m, back: the units that it is written in. outline: what is in it goes, here and below. */
bat_status bat_svg_see_clip(const bat_object *object, const double m[6], const double back[6],
                            bat_outline *outline, uint64_t *digest);
/* Of an outline in the units that an object is written in; pen, back: those, as of bat_svg_pen. */
bat_status bat_svg_see_outline(const bat_object *object, const double pen[6], const double back[6],
                               bat_outline *outline, uint64_t *digest);
/* Of a path whose data begin at `start` of the text. */
bat_status bat_svg_see_path(const bat_text *text, size_t start, const bat_object *object,
                            bat_outline *outline, uint64_t *digest);

#endif
