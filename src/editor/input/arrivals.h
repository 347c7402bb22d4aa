/* The moves of a pointer that a host hands over together, in the order in which they happened. */
#ifndef BATTEN_EDITOR_INPUT_ARRIVALS_H
#define BATTEN_EDITOR_INPUT_ARRIVALS_H

#include <batten/editor.h>

typedef struct bat_arrival {
    double time;
    const bat_pointer *event; /* borrowed */
} bat_arrival;

/* How many of the events, from the first on, are moves of one contact; at least 1. */
size_t bat_arrivals_run(const bat_pointer *events, size_t count);
/* The same events by time, to be freed; NULL: they are in order, or there is no memory. One without a valid time stays
 * behind the one before it. */
bat_arrival *bat_arrivals_sort(const bat_pointer *events, size_t count);
/* A time that a host may give. */
bool bat_arrival_timed(double time);

#endif
