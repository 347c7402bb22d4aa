/*
 * Careless strokes over one line in quick succession: they converge (hands/sketch/converge.h) instead of the last one
 * winning. Each is an undo step of its own; the first is an ordinary stroke.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_HAIRS_H
#define BATTEN_EDITOR_TOOLS_SKETCH_HAIRS_H

#include "editor/edit/pressing.h"
#include "editor/edit/stroke.h"
#include "hands/sketch/converge.h"

enum { BAT_HAIRS_MOST = 32 };

typedef struct bat_hairs {
    int count;                           /* strokes over the line so far; 0: none */
    bat_samples strokes[BAT_HAIRS_MOST]; /* owned */
    bat_id object;
    int curve;
    bool fresh;        /* the object consists of them alone; otherwise they redraw a stretch of it */
    uint64_t revision; /* of the document after the last one */
    double time;       /* when that stroke ended, ms */
} bat_hairs;

/* The line that some strokes together mean. */
typedef struct bat_together {
    bat_average line;  /* owned; no points: there is none */
    bool fresh;        /* as in bat_hairs */
    size_t stop_count; /* the width along it that their pressure means; 0: it stays */
    bat_width_stop stops[BAT_PRESSED_STOPS];
} bat_together;

/* What all of them together mean, including the edit's stroke, which may still be under way. BAT_STATE: that stroke is
 * not one of them. */
bat_status bat_hairs_join(const bat_context *c, const bat_hairs *hairs, const bat_edit *edit,
                          bat_together *out);
/* The line as a curve that takes the place of `target`, or of a stretch of it. closeness: factor on the distance from
 * the line that is allowed. report: what bat_sketch says, as far as it is known. */
bat_status bat_together_shape(const bat_together *together, const bat_edit *edit, double closeness,
                              const bat_curve *target, bat_curve **out, bat_sketch_report *report);
/* Puts that curve, which it takes over whatever it returns, in the place of the edit's, as an undo step. */
bat_status bat_together_commit(bat_context *c, const bat_together *together, const bat_edit *edit,
                               bat_curve *curve);
void bat_together_drop(bat_together *together);
/* The edit is done: its stroke becomes one more of them if it has joined, otherwise the first of a new series, if it
 * can be. */
void bat_hairs_note(const bat_context *c, bat_hairs *hairs, const bat_edit *edit, bool joined);
void bat_hairs_free(bat_hairs *hairs);

#endif
