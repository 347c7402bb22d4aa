#include "editor/input/arrivals.h"
#include <stdlib.h>

static const double TIME_MAX = 1e13; /* ms */

bool bat_arrival_timed(double time) { return time >= 0 && time <= TIME_MAX; }

size_t bat_arrivals_run(const bat_pointer *events, size_t count) {
    size_t run = 0;
    while (run < count && events[run].phase == BAT_POINTER_MOVE && !events[run].predicted &&
           events[run].device == events->device && events[run].contact == events->contact)
        run++;
    return run ? run : 1;
}

static int came_first(const void *a, const void *b) {
    const bat_arrival *one = a, *other = b;
    if (one->time != other->time) return one->time < other->time ? -1 : 1;
    return one->event < other->event ? -1 : 1;
}

bat_arrival *bat_arrivals_sort(const bat_pointer *events, size_t count) {
    bool ordered = true;
    double time = 0;
    for (size_t i = 0; i < count; i++) {
        if (!bat_arrival_timed(events[i].time)) continue;
        ordered = ordered && events[i].time >= time;
        time = events[i].time;
    }
    bat_arrival *list = ordered ? NULL : malloc(count * sizeof *list);
    if (!list) return NULL;
    time = 0;
    for (size_t i = 0; i < count; i++) {
        if (bat_arrival_timed(events[i].time)) time = events[i].time;
        list[i] = (bat_arrival){time, &events[i]};
    }
    qsort(list, count, sizeof *list, came_first); /* no ties */
    return list;
}
