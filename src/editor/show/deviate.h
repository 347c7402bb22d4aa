/*
 * How far objects are from a reference object, shown over the drawing, which does not change: they are coloured by distance, the
 * greatest one is marked, and a legend says what the colours mean. Follows changes: coarsely during a drag, exactly after it.
 */
#ifndef BATTEN_EDITOR_SHOW_DEVIATE_H
#define BATTEN_EDITOR_SHOW_DEVIATE_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include <batten/compare.h>

enum { BAT_DEVIATION_ROOM = 128 };

/* A point that was measured. */
typedef struct bat_deviation_sample {
    double at[3], distance;
} bat_deviation_sample;

/* What is painted in one colour: a point, a line, a triangle or a quadrangle between samples. */
typedef struct bat_deviation_patch {
    int corners;
    size_t corner[4];
} bat_deviation_patch;

typedef struct bat_deviating {
    bat_id reference, *ids; /* 0: it is off; what is measured, `count` of them */
    int count;
    bat_object **seen; /* for what the rest was made: those of the reference first */
    int seen_count, seen_of_reference;
    bool exact;           /* false: during a drag */
    bat_deviation found;  /* over all that is measured; samples 0: nothing could be */
    bat_reference *being; /* of the objects seen */
    bat_deviation_sample *samples;
    bat_deviation_patch *patches;
    size_t sample_count, sample_room, patch_count, patch_room;
} bat_deviating;

/* Measures all selected objects but the one that was selected last (several at once: but the lowest), from it. Says what is
 * missing, and returns BAT_STATE, where fewer than two can be measured. */
bat_status bat_deviating_begin(bat_context *c);
/* Frees everything; false: it was off. */
bool bat_deviating_end(bat_deviating *d);
/* A curve of an object as it would become. */
typedef struct bat_deviation_change {
    bat_id object; /* 0: nothing changes */
    int number;
    const bat_curve *curve;
} bat_deviation_change;

/* Measures anew what has changed; false: there is nothing to show. change: may be NULL. */
bool bat_deviating_follow(bat_context *c, const bat_deviation_change *change);
/* Once per frame while it is on. */
void bat_deviating_show(bat_context *c, const bat_deviation_change *change, bat_overlay *overlay);
/* "greatest 2 mm, mean 1 mm, rms 1.2 mm". */
void bat_deviating_write(const bat_context *c, char out[BAT_DEVIATION_ROOM]);

#endif
