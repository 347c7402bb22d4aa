/* Samples of what is compared with a reference, and what is painted between them. */
#ifndef BATTEN_EDITOR_SHOW_DEVIATE_SAMPLES_H
#define BATTEN_EDITOR_SHOW_DEVIATE_SAMPLES_H

#include "editor/show/deviate.h"

/* Whether a distance from the object, or of it, can be measured. */
bool bat_deviating_takes(const bat_object *object);
/* Makes the reference of those seen, samples all others, and finds the numbers: with d->exact those of compare.h, else
 * those of the samples. The work is bounded but for a look at each curve, surface and mesh. */
bat_status bat_deviating_measure(bat_deviating *d);

#endif
