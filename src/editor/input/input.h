/* What comes in from the hands, as it stands now. */
#ifndef BATTEN_EDITOR_INPUT_INPUT_H
#define BATTEN_EDITOR_INPUT_INPUT_H

#include "editor/input/contacts.h"
#include "editor/input/taps.h"
#include "editor/input/trail.h"

typedef struct bat_input {
    bat_contacts contacts;
    bat_fingers fingers;
    bat_taps taps;
    bat_trail trail; /* of what drives the tool */
    bool holding_pan, pen_seen;
    double pen_time;   /* of the last event of a pen */
    bool pen_near;     /* a pointer is over the drawing */
    double pen[2];     /* where it was last, view pixels */
    bat_device points; /* what kind it is */
    unsigned brush;   /* a trait: the tool that the pen's other end, or its button, is down for; 0: neither */
    bool drawing_new; /* the key that makes each stroke a new curve is held */
    bool calming;     /* the key that calms is held */
} bat_input;

#endif
