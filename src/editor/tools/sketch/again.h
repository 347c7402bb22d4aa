/*
 * A stroke read again: after it was committed, for as long as the next one has not begun, it can be taken as something
 * else, or fitted closer or fairer. The step is taken back and the other one made, so the history has one step for the
 * stroke all the while.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_AGAIN_H
#define BATTEN_EDITOR_TOOLS_SKETCH_AGAIN_H

#include "editor/edit/stroke.h"
#include "editor/tools/sketch/hold.h"
#include "editor/tools/sketch/meaning.h"

enum { BAT_AGAIN_MOST = 4 }; /* that the choice of meaning offers */

typedef struct bat_again {
    int count, at;                     /* readings, the cheapest first; the one carried out. count 0: none */
    bat_edit edit[BAT_AGAIN_MOST + 1]; /* their samples are those below */
    bat_samples samples;               /* owned */
    bat_figure_kind figure;            /* the figure that the samples are of, or none */
    int raw;           /* the reading as the stroke that was drawn, not the figure; -1: none */
    bat_samples drawn; /* its samples, owned */
    double amount;     /* from raw, 0, to fair, 1; as it was drawn: 1/2 */
    double tolerance;  /* of the stroke as drawn, document units */
    bat_curve *before; /* what the reading carried out has redrawn, owned; NULL: nothing, or several curves */
    bat_curve *fit;    /* as it would be, while the amount is being chosen; owned */
    uint64_t revision; /* of the document after the stroke */
    double place[2];   /* the stroke's end, document units */
    uint32_t version;  /* changes whenever the readings change or another is carried out */
} bat_again;

/* Gathers what else the stroke could mean: readings not much dearer than the best, and a new line in any
 * case. The edits lack samples until bat_again_keep. */
void bat_again_gather(bat_context *c, const bat_meaning *meaning, const bat_edit *edit, bat_again *again);
/* The stroke is committed as `edit`. Its samples are taken over (*samples gets other memory in exchange);
 * when the stroke was held, so are the samples that it was drawn with. */
void bat_again_keep(bat_context *c, bat_again *again, const bat_edit *edit, bat_samples *samples,
                    bat_hold *hold);
void bat_again_drop(bat_again *again);
/* Whether the stroke is still the last thing done. */
bool bat_again_holds(const bat_context *c, const bat_again *again);
/* Takes the stroke as the reading `at`. BAT_STATE: it no longer has readings; other errors come from
 * computing or committing, and leave everything as it was. */
bat_status bat_again_read(bat_context *c, bat_again *again, int at);
/* Fits it with another amount. done: for good; otherwise only `fit` is made, where that is one curve. Errors
 * as in bat_again_read. */
bat_status bat_again_refit(bat_context *c, bat_again *again, double amount, bool done);
void bat_again_free(bat_again *again);
/* A reading as the user calls it. */
bat_string bat_again_word(const bat_again *again, int reading);

#endif
