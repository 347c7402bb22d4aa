/*
 * A stroke held at its end becomes a figure (hands/figures): its samples are replaced by places along that figure, so that
 * it is a stroke like any other from then on, and its record needs neither clock nor figure. While it is held, the figure
 * is dragged about its start, or its middle. A pen that rests is told by the times of events; a host repeats the last
 * one for those that send none.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H
#define BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H

#include "editor/edit/stroke.h"
#include "hands/figures/figures.h"

typedef struct bat_hold {
    double at[2], since; /* where the pen has come to rest, view pixels, and when, ms */
    size_t count;        /* samples that the stroke had by then */
    bool spent;          /* this rest has had its answer */
    bool on;             /* the stroke is the figure */
    double grip[2];      /* where the pen was when it became that */
    bat_figure figure;
    bat_edit drawn; /* the stroke before; its samples are owned */
} bat_hold;

void bat_hold_begin(bat_hold *hold, const bat_pointer *event);
/* Told of each event; count: samples so far. True once per rest, when it has lasted `seconds` (0: never). */
bool bat_hold_due(bat_hold *hold, const bat_pointer *event, size_t count, double seconds);
/* Turns the edit's stroke into the figure it is nearest to. BAT_STATE: it is like none, all is as it was. */
bat_status bat_hold_take(bat_hold *hold, bat_edit *edit);
/* The figure as the pen, now at `to`, drags it. */
bat_status bat_hold_drag(bat_hold *hold, bat_edit *edit, const double to[2]);
/* Back to nothing; memory is kept. */
void bat_hold_end(bat_hold *hold);
bat_string bat_hold_word(bat_figure_kind kind);

#endif
