/* Taps of several fingers: two undo, three redo. All fingers go down and up within TAP_TIME and hardly move. A touch
 * while a pen or a mouse is in use, or a pen was near just now, counts as a palm and not as a tap; so does a contact
 * as large as a palm. */
#ifndef BATTEN_EDITOR_INPUT_TAPS_H
#define BATTEN_EDITOR_INPUT_TAPS_H

#include "editor/input/contacts.h"
#include "editor/session/context.h"
#include "editor/view/stage.h"
#include <batten/editor.h>

typedef struct bat_taps {
    int fingers; /* that have come down since none was down; 0: none */
    bool spoiled;
    double began;    /* ms */
    bat_stage stage; /* as it was then: what fingers shift while tapping is put back */
    bool waited; /* something awaited confirmation then, which the first finger may drop: that was the undo */
} bat_taps;

typedef enum bat_tapped { BAT_TAPPED_NOTHING, BAT_TAPPED_UNDO, BAT_TAPPED_REDO } bat_tapped;

/* Called for every contact: before it gets its duty, as it moves, and after it is gone. */
void bat_taps_down(bat_context *c, const bat_pointer *event,
                   bool waits); /* waits: something awaits confirmation */
void bat_taps_move(bat_context *c, const bat_pointer *event, const bat_contact *contact);
bat_tapped bat_taps_end(bat_context *c, const bat_pointer *event, bool waits);

#endif
