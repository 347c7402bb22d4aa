/* The choices that commands act on; never part of the document, the history or the journal. */
#ifndef BATTEN_EDITOR_CHOICE_CHOICE_H
#define BATTEN_EDITOR_CHOICE_CHOICE_H

#include "editor/choice/isolation.h"
#include "editor/choice/repetition.h"
#include "editor/choice/selection.h"
#include "editor/choice/writing.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"

typedef struct bat_choice {
    bat_selection selection;
    bat_id entered; /* the group whose members a click selects; 0: none */
    bat_id layer;   /* the active layer, where new curves go; 0: none */
    bat_isolation isolation;
    bat_repetition repetition;
    bat_writing writing;
    bat_tool_id tool; /* the chosen tool */
    unsigned wanted;  /* trait of a tool to be chosen when the event is over; 0: none */
} bat_choice;

void bat_choice_free(bat_choice *choice);
/* When another document is opened: resets all choices. */
void bat_choice_forget(bat_context *c);
/* After a step: removes what is gone from the selection, and as active layer. */
void bat_choice_follow(bat_context *c);

#endif
