/* The elements of an object's markers, where they are written anew. */
#ifndef BATTEN_FORMAT_SVG_WRITE_MARKERS_H
#define BATTEN_FORMAT_SVG_WRITE_MARKERS_H

#include "format/svg/markup.h"
#include "format/svg/outline.h"

/* Writes the markers of an object (none: nothing), to whose ids its style will then refer. pen: the units that the object is
 * written in; number: to tell the ids from those that are taken. outline: what is in it goes; *digest: what a reader will see of
 * them, 0 without any. */
bat_status bat_svg_write_markers(bat_text *text, const bat_object *object, const double pen[6], int number,
                                 double precision, bat_outline *outline, bat_svg_ids *ids, uint64_t *digest);

#endif
