#ifndef BATTEN_EDITOR_PICK_STACK_H
#define BATTEN_EDITOR_PICK_STACK_H

#include "editor/session/context.h"

/* What a click at a place could select, one below the other. 0: none. */
typedef struct bat_stack {
    bat_id front;
    bat_id selected; /* the lowest that is selected */
    bat_id below;    /* the next one below that, or else the front one */
} bat_stack;

/* point: as bat_pick_all takes it. deep: what groups hold, not the groups. */
bat_status bat_stack_at(bat_context *c, const double point[2], double within, bool deep, bat_stack *out);

#endif
