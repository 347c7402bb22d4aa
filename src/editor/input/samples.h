/* The samples of a stroke: as the pen gave them (view pixels), and where they lie on the ground (document units). */
#ifndef BATTEN_EDITOR_INPUT_SAMPLES_H
#define BATTEN_EDITOR_INPUT_SAMPLES_H

#include "editor/view/stage.h"
#include <batten/editor.h>
#include <batten/sketch.h>

enum { BAT_SAMPLES_MAX = 1 << 20 };

/* Columns that grow together; time counts from the first sample. On the page seen face-on
 * `places` is the same as `points`. */
typedef struct bat_samples {
    int dimension; /* of places: 2 on the page, otherwise 3; set by the first sample's ground */
    bool apart;    /* places are columns of their own */
    size_t count, room;
    double *pixels; /* x y */
    double *points; /* x y, drawing coordinates (stage.h) */
    double *places; /* x y [z], on the ground */
    double *pressure, *time;
    double *tilt; /* x y, degrees */
    double start; /* host's time of the first sample */
    bat_hit last; /* where the last one lies */
} bat_samples;

/* Empties it; the memory is kept. */
void bat_samples_clear(bat_samples *samples);
void bat_samples_free(bat_samples *samples);
/* stage: the stroke's. BAT_COUNT when full, BAT_MEMORY, or as bat_stage_place; nothing is added then. */
bat_status bat_samples_add(bat_samples *samples, const bat_stage *stage, const double pixel[2],
                           double pressure, double time, const double tilt[2]);
/* Into an empty list. BAT_MEMORY: it stays empty. */
bat_status bat_samples_copy(const bat_samples *samples, bat_samples *out);
/* Bytes that so many take. */
size_t bat_samples_size(size_t count);
/* The samples from `first` on as input to the sketch functions; borrowed. */
bat_stroke bat_samples_stroke(const bat_samples *samples, size_t first);
/* Rounds to the journal's precision: 1/100 for pixels, milliseconds and degrees; 1/10000 for pressure. */
double bat_samples_round(double value, double parts);

#endif
