/* What a click picks: by lines, and where the drawing is seen in space by what is in front. */
#ifndef BATTEN_EDITOR_PICK_FRONT_H
#define BATTEN_EDITOR_PICK_FRONT_H

#include "editor/session/context.h"

/* The face of a mesh that is seen at the pixel, before all surfaces there: the place, and the face's normal, of length 1. False: there
 * is none. */
bool bat_pick_face(bat_context *c, const double pixel[2], double at[3], double normal[3]);
/* The index of what a click at the pixel picks; -1: nothing. As bat_pick_object; in a tilted view surfaces and meshes are picked
 * anywhere on them, and what they hide is not picked, nor is a line that lies behind an edge of one within reach. within: view pixels to a line. O(objects), and O(corners) of the meshes
 * there. */
int bat_pick_front(bat_context *c, const double pixel[2], double within);

#endif
