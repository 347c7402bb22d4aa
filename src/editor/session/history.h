/*
 * History: what undo and redo need. A step is the list of replacements that one committed change made, in
 * order; undoing it exchanges the objects back, last first. Objects are shared, never copied, so a step costs
 * what it changed.
 */
#ifndef BATTEN_EDITOR_SESSION_HISTORY_H
#define BATTEN_EDITOR_SESSION_HISTORY_H

#include <batten/document.h>

/* Steps kept, at least; older ones are forgotten when there is no more room. */
enum { BAT_HISTORY_STEPS = 1000, BAT_HISTORY_ROOM = 1250 };

/* At `index`: before NULL: after was inserted; after NULL: before was removed; else replaced. */
typedef struct bat_delta {
    int index;
    bat_object *before, *after; /* retained, or NULL */
} bat_delta;

typedef struct bat_step {
    int label; /* what the step did, as the engine numbers its texts */
    int count;
    bat_delta *deltas;      /* owned */
    uint64_t before, after; /* serial numbers of the states it leads from and to */
} bat_step;

typedef struct bat_history {
    bat_step *steps;
    int count, done, room; /* steps[0..done) can be undone, steps[done..count) redone */
    uint64_t state;        /* serial number of the present state; equal numbers, equal documents */
    uint64_t states;       /* numbers given so far */
} bat_history;

/* All zero is an empty history. */
void bat_history_clear(bat_history *history);
/* Makes room for one more step, so that the push that follows cannot fail. */
bat_status bat_history_reserve(bat_history *history);
/* Takes the deltas over; forgets what could have been redone. Needs a reserve before it. */
void bat_history_push(bat_history *history, int label, int count, bat_delta *deltas);
/* BAT_STATE: nothing to undo. BAT_MEMORY: nothing changed. */
bat_status bat_history_undo(bat_history *history, bat_document *document);
bat_status bat_history_redo(bat_history *history, bat_document *document);
bool bat_history_can_undo(const bat_history *history);
bool bat_history_can_redo(const bat_history *history);

/* Applies a delta forwards or backwards. */
bat_status bat_delta_apply(const bat_delta *delta, bat_document *document, bool forwards);
/* Applies count deltas (backwards: last first); when one fails, those before it are taken back. */
bat_status bat_deltas_apply(const bat_delta *deltas, int count, bat_document *document, bool forwards);
void bat_deltas_free(bat_delta *deltas, int count);
/* Whether the groups of a document hold together, if they did before these deltas were applied to it. What a stroke
 * changes is looked at alone: O(count) then, else O(objects). */
bool bat_deltas_hold(const bat_delta *deltas, int count, const bat_document *document);

#endif
