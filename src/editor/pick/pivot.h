/* What an orbit turns about. */
#ifndef BATTEN_EDITOR_PICK_PIVOT_H
#define BATTEN_EDITOR_PICK_PIVOT_H

#include "editor/session/context.h"

/* The point in space of the nearest curve at the pixel, or else of the surface there; false: nothing is there. */
bool bat_pivot_under(bat_context *c, const double pixel[2], double out[3]);
/* The middle of all that is seen, the page included and without cameras; false: nothing is. */
bool bat_pivot_of_all(bat_context *c, double out[3]);
/* Sets the view's pivot: what is at the pixel, if anything is (pixel may be NULL); else the middle of the
 * selection, without cameras; else of all that is seen. */
void bat_pivot_set(bat_context *c, const double *pixel);
/* The view is in perspective, or not, as the setting says; lengths at the pivot, which is chosen anew, stay. */
void bat_perspective_follow(bat_context *c);

#endif
