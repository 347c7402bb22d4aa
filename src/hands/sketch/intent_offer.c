/* Readings in order: the cheapest first, and of too many the dearest go. */
#include "hands/sketch/intent_parts.h"

#include <math.h>

void bat_intent_offer(bat_intent_list *list, const bat_reading *reading) {
    if (!(reading->cost < INFINITY)) return;
    int at = list->count < BAT_INTENT_READINGS ? list->count++ : BAT_INTENT_READINGS;
    for (; at > 0 && list->reading[at - 1].cost > reading->cost; at--)
        if (at < BAT_INTENT_READINGS) list->reading[at] = list->reading[at - 1];
    if (at < BAT_INTENT_READINGS) list->reading[at] = *reading;
}
