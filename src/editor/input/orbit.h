/* Orbiting: contacts that turn the view about its pivot, together. The view begins to turn once they have moved so far
 * that it is no click and no tap. */
#ifndef BATTEN_EDITOR_INPUT_ORBIT_H
#define BATTEN_EDITOR_INPUT_ORBIT_H

#include "editor/session/context.h"
#include <batten/input.h>

typedef struct bat_orbit {
    bool on;          /* the view turns */
    double moved[2];  /* of the contacts' middle, before that */
    double middle[2]; /* of the contacts when they began */
    bool wall, over;  /* room.h; the drag began with the head down */
    double held;      /* room.h */
} bat_orbit;

/* All contacts with this duty begin anew, from where they are. */
void bat_orbit_begin(bat_context *c);
/* Whether the contact's motion to `to` is the one with which the view begins to turn: the pivot can still be set, and
 * bat_orbit_start follows. */
bool bat_orbit_starts(bat_context *c, int index, const double to[2]);
void bat_orbit_start(bat_context *c);
/* The contact has moved to `to`; nothing before the start. */
void bat_orbit_move(bat_context *c, int index, const double to[2]);
/* One of the contacts has ended: the others rest until they are lifted. */
void bat_orbit_end(bat_context *c);
/* Returns to where the view was when it began to turn; false: it does not turn. */
bool bat_orbit_cancel(bat_context *c);

#endif
