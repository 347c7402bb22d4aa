/*
 * Fingers give way. When a pen or a mouse comes down it takes over: whatever fingers are doing is reverted, and they
 * do nothing until they are lifted. A palm, a contact too large for a finger, does nothing from the start.
 */
#ifndef BATTEN_EDITOR_FINGERS_H
#define BATTEN_EDITOR_FINGERS_H

#include "editor/input/contacts.h"

/* Reverts what the contact does, and ignores it from here on. */
void bat_finger_stop(bat_context *c, int index);
/* A pen or a mouse comes down: stops all fingers. */
void bat_fingers_yield(bat_context *c);
/* On a pen's first event: a finger that is drawing, or dabbed a moment ago, belongs to the hand that holds the pen. */
void bat_fingers_meet_pen(bat_context *c, double time);

/* A finger that drove the tool has been lifted. */
void bat_fingers_step(bat_context *c, const bat_contact *contact);

/* Brackets what fingers do to the view, so that it can be reverted. What others do to the view stays. */
void bat_fingers_rest(bat_context *c); /* the first finger begins to navigate */
void bat_fingers_before(bat_context *c);
void bat_fingers_after(bat_context *c);

#endif
