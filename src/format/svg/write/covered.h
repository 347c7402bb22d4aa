/* Strokes whose width changes along them, as what covers them, for what knows no such strokes. */
#ifndef BATTEN_FORMAT_SVG_WRITE_COVERED_H
#define BATTEN_FORMAT_SVG_WRITE_COVERED_H

#include <batten/paint.h>

/* An object with a profile as two: its stroke, as a path filled by the non-zero rule with what paints it, and the object without it;
 * in the order in which they are painted, NULL where there is nothing to be seen. Both are hidden, clipped and in their group as the
 * object is. *group: they are translucent as a whole, and opaque themselves. BAT_ARGUMENT: no profile. */
bat_status bat_object_parts(const bat_object *object, bat_object *parts[2], bool *group);

#endif
