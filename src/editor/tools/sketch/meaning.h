/*
 * The meaning of the stroke under the pen: the editor's side of the choice (hands/sketch/intent.h). It looks for
 * curves beside the stroke as the stroke grows, and turns readings into edits.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_MEANING_H
#define BATTEN_EDITOR_TOOLS_SKETCH_MEANING_H

#include "editor/edit/stroke.h"
#include "editor/session/context.h"
#include "hands/sketch/intent.h"
#include <batten/editor.h>

typedef struct bat_meaning_curve {
    bat_id object;
    int entry, curve; /* index of the object in the scene; of the curve in the object */
} bat_meaning_curve;

typedef struct bat_meaning {
    bat_intent *intent; /* NULL: no stroke */
    size_t fed, asked;  /* samples given to the intent; samples at which nearby curves were looked for */
    bool restricts;     /* only the selection may change */
    double last[2];     /* pixel where curves were last looked for */
    double box[4];      /* of the stroke's pixels */
    double within;      /* px from the stroke within which curves were looked for */
    int curve_count, curve_room;
    bat_meaning_curve *curves; /* in the intent's numbering */
    int *found;                /* 2 * curve_room: hash table of their indices; -1: empty */
    int count;
    bat_intent_reading readings[BAT_INTENT_READINGS]; /* the best first */
} bat_meaning;

bat_status bat_meaning_begin(bat_context *c, bat_meaning *meaning, bat_device device);
void bat_meaning_end(bat_meaning *meaning);
/* Reads the stroke so far, or the whole stroke. stage: the stroke's. BAT_DOT: too short to tell. */
bat_status bat_meaning_look(bat_context *c, bat_meaning *meaning, const bat_stage *stage,
                            const bat_samples *samples, bool whole);
/* Sets the edit according to the reading; everything else in it stays as it is. */
void bat_meaning_apply(bat_context *c, const bat_meaning *meaning, const bat_intent_reading *reading,
                       bat_edit *edit);
/* Whether the curve has levels, and which of them a stroke over it redraws. */
bool bat_meaning_level(const bat_context *c, bat_id object, int curve, int *level);
/* Whether the reading would make the same kind of edit of the same curves. */
bool bat_meaning_is(const bat_meaning *meaning, const bat_intent_reading *reading, const bat_edit *edit);

#endif
