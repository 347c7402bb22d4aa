/*
 * Reading a stroke again: after it was committed, and until the next one begins, it can be taken as something else,
 * or fitted closer or fairer. The step is undone and the other one made, so the history always has exactly one step
 * for the stroke.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_AGAIN_H
#define BATTEN_EDITOR_TOOLS_SKETCH_AGAIN_H

#include "editor/edit/stroke.h"
#include "editor/tools/sketch/hairs.h"
#include "editor/tools/sketch/hold.h"
#include "editor/tools/sketch/meaning.h"

enum { BAT_AGAIN_MOST = 4 }; /* readings that are offered at most */

typedef struct bat_again {
    int count, at;                     /* readings, the cheapest first; the one in force. count 0: none */
    bat_edit edit[BAT_AGAIN_MOST + 3]; /* all but the figure share the samples below */
    bat_samples samples;               /* owned */
    int figure;                        /* the reading as the figure that was offered; -1: none */
    bat_figure_kind kind;              /* of that */
    bat_samples along;                 /* its samples, owned */
    int converged;                     /* the reading as one of several careless strokes; -1: none */
    bat_together together;             /* what they mean, owned */
    double amount;                     /* from raw, 0, to fair, 1; as drawn: 1/2 */
    double tolerance;                  /* of the stroke as drawn, document units */
    bat_curve *before;   /* what the reading in force has redrawn, owned; NULL: nothing, or several curves */
    bat_edit_result fit; /* the preview while the amount is being chosen */
    uint64_t revision;   /* of the document after the stroke */
    double place[3];     /* the stroke's end, document units */
    uint32_t selection;  /* its version then */
    uint32_t kept;       /* kept.h: the serial number of the stroke, or 0 */
    uint32_t version;    /* changes whenever the readings change or another is put in force */
} bat_again;

/* Gathers the other possible meanings of the stroke: readings not much dearer than the best, and always a new line.
 * The edits have no samples until bat_again_keep. */
void bat_again_gather(bat_context *c, const bat_meaning *meaning, const bat_edit *edit, bat_again *again);
/* The stroke has been committed as `edit`. Takes ownership of its samples (*samples gets other memory in exchange).
 * The figure that it offers, when it was held, is one reading more. */
void bat_again_keep(bat_context *c, bat_again *again, const bat_edit *edit, bat_samples *samples,
                    const bat_sketch_hold *hold);
/* After bat_again_keep: the stroke has been committed as one of several, which takes the first place among its readings.
 * Takes over what they mean. */
void bat_again_converged(bat_again *again, bat_together *together);
void bat_again_drop(bat_again *again);
/* Whether the stroke is still the last thing that was done. */
bool bat_again_holds(const bat_context *c, const bat_again *again);
/* Takes the stroke as the reading `at`. BAT_STATE: its readings are no longer available; other errors come from
 * computing or committing, and leave everything unchanged. */
bat_status bat_again_read(bat_context *c, bat_again *again, int at);
/* Fits it with another amount. done: commits; otherwise only makes the preview. Errors as in
 * bat_again_read. */
bat_status bat_again_refit(bat_context *c, bat_again *again, double amount, bool done);
/* The edit with the tolerance and fairness of that amount; tolerance: as drawn. */
void bat_again_amount(bat_edit *edit, double tolerance, double amount);
void bat_again_free(bat_again *again);
/* The name of a reading for the user. */
bat_string bat_again_word(const bat_again *again, int reading);

#endif
