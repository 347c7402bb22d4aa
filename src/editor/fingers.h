/*
 * Fingers give way. A pen or a mouse that comes down takes over: whatever fingers are doing is taken back, and until
 * they lift they do nothing. A palm, a contact too large for a finger, does nothing from the start.
 */
#ifndef BATTEN_EDITOR_FINGERS_H
#define BATTEN_EDITOR_FINGERS_H

#include "editor/input/contacts.h"

/* What the contact does is taken back, and it is ignored from here on. */
void bat_finger_stop(bat_context *c, int index);
/* A pen or a mouse comes down: all stop. */
void bat_fingers_yield(bat_context *c);
/* The first event of a pen: a finger that draws, or dabbed a moment ago, is the hand that holds it. */
void bat_fingers_meet_pen(bat_context *c, double time);

/* A finger that drove the tool has been lifted. */
void bat_fingers_step(bat_context *c, const bat_contact *contact);

/* Around what fingers do to the view, so that it can be taken back. What others do to it stays. */
void bat_fingers_rest(bat_context *c); /* the first one navigates */
void bat_fingers_before(bat_context *c);
void bat_fingers_after(bat_context *c);

#endif
