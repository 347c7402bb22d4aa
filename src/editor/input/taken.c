#include "editor/input/taken.h"
#include <stdlib.h>

enum { FIRST = 256 }; /* events for which there is room at first */

static void add(bat_taken *taken, const bat_pointer *event) {
    if (taken->count == taken->room) {
        size_t room = taken->room ? 2 * taken->room : FIRST;
        bat_pointer *events = room <= BAT_TAKEN_MAX ? realloc(taken->events, room * sizeof *events) : NULL;
        if (!events) {
            bat_taken_forget(taken);
            return;
        }
        taken->events = events;
        taken->room = room;
    }
    taken->events[taken->count++] = *event;
}

void bat_taken_begin(bat_taken *taken, const bat_stage *stage, int tool, unsigned brush,
                     const bat_pointer *down) {
    bat_taken_forget(taken);
    taken->stage = *stage;
    taken->tool = tool;
    taken->brush = brush;
    add(taken, down);
}

void bat_taken_add(bat_taken *taken, const bat_pointer *event) {
    if (taken->count) add(taken, event);
}

void bat_taken_forget(bat_taken *taken) {
    taken->count = 0;
    taken->offered = false;
}

void bat_taken_free(bat_taken *taken) {
    free(taken->events);
    *taken = (bat_taken){0};
}
