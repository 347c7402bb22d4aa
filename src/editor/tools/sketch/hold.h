/*
 * A stroke held at its end becomes a figure (hands/figures): its samples are replaced by points along that figure.
 * From then on it is a stroke like any other, and its record needs neither clock nor figure. While it is held, the
 * figure is dragged about its start, or about its middle. A resting pen is detected by the times of events; a host
 * repeats the last event for devices that send none.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H
#define BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H

#include "editor/edit/stroke.h"
#include "hands/figures/figures.h"

typedef struct bat_sketch_hold {
    double at[2], since; /* where the pen has come to rest, view pixels, and when, ms */
    size_t count;        /* samples of the stroke at that time */
    bool spent;          /* this rest has been handled */
    bool on;             /* the stroke is the figure */
    double grip[2];      /* where the pen was when it became the figure */
    bat_figure figure;
    bat_edit drawn; /* the stroke as drawn; its samples are owned */
} bat_sketch_hold;

void bat_hold_begin(bat_sketch_hold *hold, const bat_pointer *event);
/* Call for each event; count: samples so far. True once per rest, when it has lasted `seconds` (0: never). */
bool bat_hold_due(bat_sketch_hold *hold, const bat_pointer *event, size_t count, double seconds);
/* Turns the edit's stroke into the figure nearest to it. BAT_STATE: it is like none; nothing changes. */
bat_status bat_hold_take(bat_sketch_hold *hold, bat_edit *edit);
/* The figure as dragged by the pen, which is now at `to`. */
bat_status bat_hold_drag(bat_sketch_hold *hold, bat_edit *edit, const double to[2]);
/* Resets everything; the memory is kept. */
void bat_hold_end(bat_sketch_hold *hold);
bat_string bat_hold_word(bat_figure_kind kind);

#endif
