/*
 * A stroke held at its end offers the figure that it is nearest to (hands/figures); one that travels on withdraws it.
 * The figure is another reading of the stroke (again.h): its samples lie along the figure, so that its record needs
 * neither clock nor figure. A resting pen is detected by the times of events; a host repeats the last event for
 * devices that send none.
 */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H
#define BATTEN_EDITOR_TOOLS_SKETCH_HOLD_H

#include "editor/edit/stroke.h"
#include "hands/figures/figures.h"

typedef struct bat_sketch_hold {
    double at[2], since; /* where the pen has come to rest, view pixels, and when, ms */
    size_t count;        /* samples of the stroke at that time */
    bool spent;          /* this rest has been handled */
    bat_figure figure;   /* offered; of the kind NONE: none is */
} bat_sketch_hold;

void bat_hold_begin(bat_sketch_hold *hold, const bat_pointer *event);
/* Call for each event with all samples so far. True when it offers a figure from here on: once per rest, when it has
 * lasted `seconds` (0: never). */
bool bat_hold_rests(bat_sketch_hold *hold, const bat_pointer *event, const bat_samples *samples,
                    double seconds);
/* What *drawn would be with samples along the figure offered; samples: gets them, and the edit refers to them. */
bat_status bat_hold_edit(const bat_sketch_hold *hold, const bat_edit *drawn, bat_samples *samples,
                         bat_edit *out);
bat_string bat_hold_word(bat_figure_kind kind);

#endif
