/* Strokes whose width changes along them, as what covers them, for what knows no such strokes. */
#ifndef BATTEN_FORMAT_SVG_COVERED_H
#define BATTEN_FORMAT_SVG_COVERED_H

#include <batten/paint.h>

/* The stroke of an object with a profile, as a path filled by the non-zero rule with what paints the stroke; it is hidden, clipped and in
 * its group as the object is. *out NULL: nothing of it is to be seen. BAT_ARGUMENT: no profile. */
bat_status bat_object_stroke_path(const bat_object *object, bat_object **out);
/* The object without its stroke. */
bat_status bat_object_fill_path(const bat_object *object, bat_object **out);
/* Both in the order in which they are painted, NULL where there is nothing to be seen; *group: they are translucent as a whole, and
 * opaque themselves. */
bat_status bat_object_parts(const bat_object *object, bat_object *parts[2], bool *group);

#endif
