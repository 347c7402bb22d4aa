/* A stroke as the events it was made of, so that one which the system takes away can be brought back. */
#ifndef BATTEN_EDITOR_INPUT_TAKEN_H
#define BATTEN_EDITOR_INPUT_TAKEN_H

#include "editor/view/stage.h"
#include <batten/editor.h>

enum { BAT_TAKEN_MAX = 1 << 16 }; /* events: a longer stroke cannot be brought back */

typedef struct bat_taken {
    bat_pointer *events; /* owned; the first is the down */
    size_t count, room;
    bat_stage stage; /* whose pixels they are in */
    int tool;        /* that was chosen */
    unsigned brush;  /* as bat_input's */
    bool offered;    /* it was taken away */
} bat_taken;

/* A stroke begins. */
void bat_taken_begin(bat_taken *taken, const bat_stage *stage, int tool, unsigned brush,
                     const bat_pointer *down);
/* It goes on. Where memory runs out it is forgotten, as if none had begun. */
void bat_taken_add(bat_taken *taken, const bat_pointer *event);
/* It has ended, or was brought back. */
void bat_taken_forget(bat_taken *taken);
void bat_taken_free(bat_taken *taken);

#endif
