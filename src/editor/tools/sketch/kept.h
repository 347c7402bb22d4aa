/*
 * Strokes that can still be refitted after others were drawn: each with its samples and with what it changed, for as
 * long as the document holds what it made. What happened since is not followed: the curves tell. While a stroke's
 * objects have the curves that it gave them, it is done again from what was before; while only its stretch is as it
 * made it, the stretch is redrawn. Moving the object ends this, undoing that gives it back. Refitting is a step of its
 * own, made anew as long as it is the last.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_KEPT_H
#define BATTEN_EDITOR_TOOLS_SKETCH_KEPT_H

#include "editor/edit/stroke.h"
#include "editor/show/overlay.h"

enum { BAT_KEPT_MOST = 32, BAT_KEPT_BYTES = 1 << 20 /* of samples */, BAT_KEPT_PLACES = 24 };

typedef struct bat_kept_stroke {
    uint32_t serial;
    bat_edit edit; /* with samples of its own */
    double amount, tolerance;
    double end[3]; /* where the stroke ends, document units */
    int count;     /* objects that it changed */
    bat_id object[BAT_EDIT_PARTS];
    bat_object *before[BAT_EDIT_PARTS], *after[BAT_EDIT_PARTS]; /* retained; NULL: not there */
    int places; /* on its stretch of the curve; 0: of no single one */
    double place[2 * BAT_KEPT_PLACES];
} bat_kept_stroke;

typedef struct bat_kept {
    int count;
    bat_kept_stroke *stroke[BAT_KEPT_MOST]; /* the newest last, owned */
    uint32_t serial;                        /* given out last */
    uint64_t revision;                      /* of the document after the newest was refitted; 0: it was not */
    bat_edit_result fit;                    /* what is shown while the amount is being chosen */
    uint32_t shown;                         /* of which stroke */
} bat_kept;

void bat_kept_free(bat_kept *kept);
/* The last step was made by this edit; instead: of the stroke with that serial, when it is the newest. Returns its
 * serial; 0: it is not kept: in space, with symmetry, or without memory. */
uint32_t bat_kept_add(const bat_context *c, bat_kept *kept, const bat_edit *edit, double amount,
                      double tolerance, uint32_t instead);
/* The newest stroke that the only selected object can be refitted by; NULL: none. */
const bat_kept_stroke *bat_kept_offered(const bat_context *c, const bat_kept *kept);
/* As bat_again_refit. */
bat_status bat_kept_refit(bat_context *c, bat_kept *kept, double amount, bool done);
/* The curves that would come, over those that are. */
void bat_kept_show(const bat_context *c, const bat_kept *kept, bat_overlay *overlay);

#endif
