/* What was last done to the selection as a whole, so that it can be done again. */
#ifndef BATTEN_EDITOR_CHOICE_REPETITION_H
#define BATTEN_EDITOR_CHOICE_REPETITION_H

#include "editor/choice/selection.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"

enum { BAT_REPETITION_MOVES = 32 };

/* From what was selected first to what it was in that state of the history. */
typedef struct bat_repetition_move {
    double matrix[6];
    uint64_t state; /* serial number */
} bat_repetition_move;

typedef struct bat_repetition {
    int count; /* of the moves; 0: nothing was done that can be done again */
    bat_repetition_move moves[BAT_REPETITION_MOVES];
    bool copies;      /* what was moved was copied before: the first move made the copies */
    double box[4];    /* around what was selected, before */
    bat_string label; /* of the step */
    bat_selection of; /* what was moved */
} bat_repetition;

/* After the step that mapped what is selected by the matrix. box: around it, before. Copies that were made just before are then
 * repeated with all that moved them since. Out of memory: nothing can be repeated. */
void bat_repetition_note(bat_context *c, const double matrix[6], const double box[4], bat_string label);
/* After the step that made what is selected: copies, mapped by the matrix. */
void bat_repetition_note_copies(bat_context *c, const double matrix[6], const double box[4]);
/* Whether there is something to repeat. */
bool bat_repetition_is_known(const bat_context *c);
/* Whether what was moved is what is selected. */
bool bat_repetition_is_of_selection(const bat_context *c);
/* How it was moved, as far as that was not undone; when all of it was, as it was last. There must be something to repeat. */
const double *bat_repetition_matrix(const bat_context *c);
/* Whether copies are selected that were made last: how they lie to what they were made from. */
bool bat_repetition_of_copies(const bat_context *c, double matrix[6]);

#endif
