/*
 * Careless strokes over one line, soon after each other: they converge (hands/sketch/converge.h) instead of the last one
 * winning. Each is a step of its own; the first is an ordinary stroke.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_HAIRS_H
#define BATTEN_EDITOR_TOOLS_SKETCH_HAIRS_H

#include "editor/edit/stroke.h"

enum { BAT_HAIRS_MOST = 16 };

typedef struct bat_hairs {
    int count;                           /* strokes over the line so far; 0: none */
    bat_samples strokes[BAT_HAIRS_MOST]; /* owned */
    bat_id object;
    int curve;
    bool fresh;        /* the object is theirs alone; else they redraw a stretch of it */
    uint64_t revision; /* of the document after the last one */
    double time;       /* when that ended, ms */
} bat_hairs;

/* The curve as all of them mean it, the edit's stroke included. BAT_STATE: that stroke is not one of them. */
bat_status bat_hairs_join(const bat_context *c, const bat_hairs *hairs, const bat_edit *edit,
                          bat_curve **out);
/* The edit is done: its stroke is one more of them when it has joined, else the first of new ones, if any. */
void bat_hairs_note(const bat_context *c, bat_hairs *hairs, const bat_edit *edit, bool joined);
void bat_hairs_free(bat_hairs *hairs);

#endif
