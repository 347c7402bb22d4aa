/* Views that the drawing holds: objects of the document, unlike the views that were left (views.h). */
#ifndef BATTEN_EDITOR_VIEW_SAVED_H
#define BATTEN_EDITOR_VIEW_SAVED_H

#include "editor/session/context.h"
#include "editor/view/view.h"
#include <batten/document.h>
#include <batten/view.h>

/* The window looks from there, and shows all that was seen. An angle of view other than BAT_FOV, which the window can not take,
 * is left out (lengths at the target stay). */
void bat_view_look_from(bat_view *view, const bat_viewpoint *from);
/* The saved view to go to: the one before that which the window shows, or else the last; none that is hidden. Index; -1: there
 * is none. *shown: the index of that which the window shows, or -1. */
int bat_saved_next(const bat_document *document, const bat_view *view, int *shown);
/* Before the view turns away: keeps it (views.h); the saved view in which the drawing opened is then offered. */
void bat_saved_leave(bat_context *c);

#endif
