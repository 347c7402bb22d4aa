/*
 * What the stroke under the pen means: the editor's side of the choice (hands/sketch/intent.h). It looks for the curves
 * beside the stroke as the stroke grows, and makes edits of readings.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_MEANING_H
#define BATTEN_EDITOR_TOOLS_SKETCH_MEANING_H

#include "editor/edit/stroke.h"
#include "editor/session/context.h"
#include "hands/sketch/intent.h"
#include <batten/editor.h>

typedef struct bat_meaning_curve {
    bat_id object;
    int entry, curve; /* of the object in the scene, of the curve in the object */
} bat_meaning_curve;

typedef struct bat_meaning {
    bat_intent *intent; /* NULL: none under way */
    size_t fed, asked;  /* samples that the intent has; samples beside which curves were looked for */
    bool restricts;     /* only what is chosen may change */
    double last[2];     /* pixel where they were looked for last */
    int curve_count, curve_room;
    bat_meaning_curve *curves; /* as the intent numbers them */
    int *found;                /* 2 * curve_room: where each of them is, hashed; -1: nothing */
    int count;
    bat_reading readings[BAT_INTENT_READINGS]; /* the best first */
} bat_meaning;

bat_status bat_meaning_begin(bat_context *c, bat_meaning *meaning, bat_device device);
void bat_meaning_end(bat_meaning *meaning);
/* Reads the stroke so far, or the whole. view: of the stroke. BAT_DOT: too short to say. */
bat_status bat_meaning_look(bat_context *c, bat_meaning *meaning, const bat_stage *stage,
                            const bat_samples *samples, bool whole);
/* Sets the edit to what this reading says; everything else in it stays as it is. */
void bat_meaning_apply(bat_context *c, const bat_meaning *meaning, const bat_reading *reading,
                       bat_edit *edit);
/* Whether the curve has levels, and which of them a stroke over it redraws. */
bool bat_meaning_level(const bat_context *c, bat_id object, int curve, int *level);
/* Whether the reading would make that same kind of edit of the same curves. */
bool bat_meaning_is(const bat_meaning *meaning, const bat_reading *reading, const bat_edit *edit);

#endif
