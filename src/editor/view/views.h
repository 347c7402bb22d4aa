/* Views that were left: the face-on page to return to, and the way back through them. They belong to the window, not to
 * the document: neither the history nor the journal knows them. */
#ifndef BATTEN_EDITOR_VIEW_VIEWS_H
#define BATTEN_EDITOR_VIEW_VIEWS_H

#include "editor/view/view.h"

enum { BAT_VIEWS_KEPT = 50 };

typedef struct bat_views {
    bat_view left[BAT_VIEWS_KEPT]; /* oldest first; the oldest gives way */
    int count;
    bat_view home; /* the last face-on view, once `away` */
    bool away;
    bool saved;        /* the drawing opened in one that it holds, which has not been left since */
    bat_view from, to; /* of the last jump */
    bool gliding;      /* the view is on its way there */
    uint32_t jumps;    /* so far */
} bat_views;

/* Before the view turns away: keeps it. */
void bat_views_leave(bat_views *views, const bat_view *view);
/* The view has jumped from `from` to where it is now: the way there can be shown. */
void bat_views_jump(bat_views *views, const bat_view *from, const bat_view *view);
/* Shows the view at the share, 0 to 1, of the last jump's way; at 1, or by bat_views_arrive, it ends
 * where it leads. */
void bat_views_glide(bat_views *views, bat_view *view, double share);
void bat_views_arrive(bat_views *views, bat_view *view);
/* Steps back to the view that was left last; the window keeps its size. False: there is none. */
bool bat_views_back(bat_views *views, bat_view *view);
/* Returns to the last face-on view. False: none has been left. */
bool bat_views_home(bat_views *views, bat_view *view);

#endif
