/* Taps of several fingers: two undo, three redo. All are down and up again within TAP_TIME and hardly move; a pen
 * or a mouse at work, or a pen that was there just now, is no company for a tap: that touch is a palm. Nor is a
 * contact as large as one. */
#ifndef BATTEN_EDITOR_INPUT_TAPS_H
#define BATTEN_EDITOR_INPUT_TAPS_H

#include "editor/input/contacts.h"
#include "editor/session/context.h"
#include "editor/view/stage.h"
#include <batten/editor.h>

typedef struct bat_taps {
    int fingers; /* that came down since none was; 0: none has */
    bool spoiled;
    double began;    /* ms */
    bat_stage stage; /* as it was then: what fingers shift while they tap is put back */
    bool
        waited; /* something waited for a yes then, which the first finger may take back: that was the undo */
} bat_taps;

typedef enum bat_tapped { BAT_TAPPED_NOTHING, BAT_TAPPED_UNDO, BAT_TAPPED_REDO } bat_tapped;

/* Told of every contact: before it gets its duty, as it moves, and after it is gone. */
void bat_taps_down(bat_context *c, const bat_pointer *event, bool waits); /* something waits for a yes */
void bat_taps_move(bat_context *c, const bat_pointer *event, const bat_contact *contact);
bat_tapped bat_taps_end(bat_context *c, const bat_pointer *event, bool waits);

#endif
