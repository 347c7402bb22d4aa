/* Copies of objects with all that they hold, with ids of their own, as part of a listing (reorder.h). */
#ifndef BATTEN_EDITOR_EDIT_COPIES_H
#define BATTEN_EDITOR_EDIT_COPIES_H

#include "editor/session/context.h"
#include "editor/session/reorder.h"

/* Lists the document with copies of the roots (arrange.h), each in front of what it is a copy of: one for each matrix, in their
 * order. heads: the ids of the roots' copies, those of each root together. A failure is the listing's. */
void bat_copies_list(bat_context *c, int count, const int *roots, int copies, const double (*matrices)[6],
                     bat_listing *listing, bat_id *heads);

#endif
