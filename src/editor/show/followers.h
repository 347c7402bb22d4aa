/* What follows a curve while it is being redrawn: computed as it is when the stroke is kept, and shown as lines. */
#ifndef BATTEN_EDITOR_SHOW_FOLLOWERS_H
#define BATTEN_EDITOR_SHOW_FOLLOWERS_H

#include "editor/show/overlay.h"
#include "editor/session/context.h"

#include <batten/document.h>
#include <batten/recipe.h>

enum { BAT_FOLLOWERS = 16, BAT_FOLLOWERS_ROOM = 128 };

typedef struct bat_follow_numbers {
    size_t moved;       /* control points and vertices that a wire has moved */
    double farthest;    /* how far the one that was moved most */
    size_t torn, folds; /* edges, stretches */
    size_t freed;       /* things that follow no longer */
    bool made;          /* a surface made from curves is among them: */
    bat_recipe recipe;  /* that of the first one */
} bat_follow_numbers;

typedef struct bat_followers {
    int count;
    bat_object *objects[BAT_FOLLOWERS]; /* as they would be */
    bat_follow_numbers numbers;         /* torn: once they have been shown */
} bat_followers;

/* An object, and what its first curve would be. */
typedef struct bat_follow_change {
    bat_id id;
    const bat_curve *curve;
} bat_follow_change;

/* What would become of those that follow objects if these changed; they stay at most BAT_FOLLOWERS. What cannot be made is
 * left out. To be cleared. */
void bat_followers_of(const bat_context *c, int count, const bat_follow_change *changes, bat_followers *out);
void bat_followers_clear(bat_followers *f);
void bat_followers_show(const bat_context *c, bat_followers *f, bat_overlay *overlay);
/* The numbers of what has followed in the transaction that is open; zeros: nothing has. */
void bat_follow_numbers_now(const bat_context *c, bat_follow_numbers *out);
/* Those of the surface that is selected, if it is made from curves; zeros: it is not. */
void bat_follow_numbers_selected(const bat_context *c, bat_follow_numbers *out);
/* As text: "84 points move, by up to 28 px", "twist 90°, scale 0.5"; empty: nothing follows. */
void bat_follow_numbers_write(const bat_context *c, const bat_follow_numbers *numbers,
                              char text[BAT_FOLLOWERS_ROOM]);

/* Hatches the stretches in which the surface is folded over. */
void bat_folds_show(const bat_context *c, const bat_object *object, bat_overlay *overlay);
/* Those of the surfaces that are selected, or made from a curve that is. */
void bat_folds_show_chosen(const bat_context *c, bat_overlay *overlay);

#endif
