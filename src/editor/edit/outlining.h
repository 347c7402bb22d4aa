/* Objects beside objects: offsets, and strokes as filled shapes. */
#ifndef BATTEN_EDITOR_EDIT_OUTLINING_H
#define BATTEN_EDITOR_EDIT_OUTLINING_H

#include <batten/document.h>

/* In the order of the property's choices. */
typedef enum bat_offset_side { BAT_OFFSET_OUTSIDE, BAT_OFFSET_INSIDE, BAT_OFFSET_BOTH } bat_offset_side;

/* Whether it is made of curves, all in the plane. */
bool bat_outlining_is_flat(const bat_object *object);
/* A path in the object's style: its closed curves together, grown or shrunk by the distance, and each open curve's parallel on
 * the left or right; with its joins. *out NULL: nothing is left. BAT_SINGULAR as bat_regions_combine. */
bat_status bat_outlining_offset(const bat_object *object, double distance, bat_offset_side side,
                                bat_object **out);
/* A path filled as the stroke is, which covers what the stroke does. *first: the stroke is painted before the fill. *out
 * NULL: it covers nothing. BAT_COUNT: too many dashes. */
bat_status bat_outlining_stroke(const bat_object *object, bat_object **out, bool *first);

#endif
