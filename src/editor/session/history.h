/*
 * History: what undo and redo need. A step is the list of replacements that one committed change made, in order; undo
 * swaps the objects back, last first. Objects are shared, never copied, so a step costs no more than what it changed.
 */
#ifndef BATTEN_EDITOR_SESSION_HISTORY_H
#define BATTEN_EDITOR_SESSION_HISTORY_H

#include "document/sheet.h"

/* The least number of steps kept, and the most; the oldest are dropped when there is no more room. They are dropped
 * earlier where the steps are large: above so many bytes, of which a quarter is then freed; but some are always kept. */
enum { BAT_HISTORY_STEPS = 1000, BAT_HISTORY_ROOM = 1250, BAT_HISTORY_FEWEST = 8 };
enum { BAT_HISTORY_BYTES = 8 << 20 };

/* At `index`. before NULL: after was inserted; after NULL: before was removed; otherwise it was replaced. */
typedef struct bat_delta {
    int index;
    bat_object *before, *after; /* retained, or NULL */
} bat_delta;

/* Another page: what the step of one change of it takes back. */
typedef struct bat_page_change {
    bat_sheet before, after;
    int shown_before, shown_after; /* the unit that numbers are given in: the property's value */
} bat_page_change;

typedef struct bat_step {
    int label; /* what the step did: a number of the string table */
    int count;
    bat_delta *deltas;      /* owned */
    bat_page_change *page;  /* owned; NULL: the page stayed as it was */
    size_t bytes;           /* of its change as a line of a compacted journal: what it costs to keep it */
    uint64_t before, after; /* serial numbers of the states before and after it */
} bat_step;

typedef struct bat_history {
    bat_step *steps;
    int count, done, room; /* steps[0..done) can be undone, steps[done..count) redone */
    size_t bytes;          /* of all steps */
    uint64_t state;        /* serial number of the present state; equal numbers mean equal documents */
    uint64_t states;       /* serial numbers given out so far */
} bat_history;

/* All zero is an empty history. */
void bat_history_clear(bat_history *history);
/* Makes room for one more step, so that the push that follows cannot fail. */
bat_status bat_history_reserve(bat_history *history);
/* Takes ownership of the deltas; drops the steps that could have been redone. Call reserve first. */
void bat_history_push(bat_history *history, int label, int count, bat_delta *deltas, size_t bytes);
/* The same for a step that changes the page alone; takes ownership of the change. */
void bat_history_push_page(bat_history *history, int label, bat_page_change *page, size_t bytes);
/* BAT_STATE: nothing to undo. BAT_MEMORY: nothing changed. */
bat_status bat_history_undo(bat_history *history, bat_document *document);
bat_status bat_history_redo(bat_history *history, bat_document *document);
/* A copy of the document as it was before the last step. */
bat_status bat_history_before(const bat_history *history, const bat_document *document, bat_document **out);
bool bat_history_can_undo(const bat_history *history);
bool bat_history_can_redo(const bat_history *history);

/* Applies a delta forwards or backwards. */
bat_status bat_delta_apply(const bat_delta *delta, bat_document *document, bool forwards);
/* Applies `count` deltas (backwards: last first); when one fails, those already applied are reverted. */
bat_status bat_deltas_apply(const bat_delta *deltas, int count, bat_document *document, bool forwards);
/* The same for all that a step changed. */
bat_status bat_step_apply(const bat_step *step, bat_document *document, bool forwards);
void bat_deltas_free(bat_delta *deltas, int count);
/* Whether the document's groups are well formed, given that they were before these deltas were applied. O(count) for
 * the changes of a stroke, which are checked alone; otherwise O(objects). */
bool bat_deltas_hold(const bat_delta *deltas, int count, const bat_document *document);

#endif
