/* The skeleton whose motion is looked at, and how it is shown. */
#ifndef BATTEN_EDITOR_SHOW_BODY_H
#define BATTEN_EDITOR_SHOW_BODY_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include <batten/motion.h>

/* Its motion, and where it lies in the drawing (place: as bat_object_motion; may be NULL); NULL: there is none. */
const bat_motion *bat_body_motion(const bat_context *c, double *place);
/* Where its joints are in the drawing at the playhead, 3 numbers each, *count of them; NULL: there is none, or no memory. The
 * caller frees it. */
double *bat_body_joints(const bat_context *c, int *count);
/* The joint that is chosen; -1: none. */
int bat_body_chosen(const bat_context *c);
/* Its bones at the playhead, and the chosen joint. */
void bat_body_show(const bat_context *c, bat_overlay *overlay);

#endif
