/* View and scene together: what is visible, and where. */
#ifndef BATTEN_EDITOR_SCENE_SEEN_H
#define BATTEN_EDITOR_SCENE_SEEN_H

#include "editor/scene/scene.h"
#include "editor/session/context.h"

enum { BAT_FIT_MARGIN = 32, BAT_FIT_STRIP = 76 /* where a time strip lies over the drawing */ };

/* Brings the scene up to date before it is queried. */
void bat_seen_sync(bat_context *c);
/* Whether the object or a group around it is hidden. at: its index, -1 for none. */
bool bat_seen_hidden(const bat_context *c, int at);
/* Whether the object is hidden or locked, or, as of the last sync, outside the group in isolation: tools do not touch
 * it. at: its index, -1 for none. */
bool bat_seen_out_of_reach(const bat_context *c, int at);
/* Fits the view to everything; the one definition of "everything". False: nothing to fit to. */
bool bat_seen_fit(bat_context *c);
/* In a tilted view the same without the page. */
bool bat_seen_fit_drawn(bat_context *c);
/* The same to what is selected. False: nothing is, or it has no place. */
bool bat_seen_fit_selection(bat_context *c);

#endif
