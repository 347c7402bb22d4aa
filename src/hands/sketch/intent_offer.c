/* Readings in order, the cheapest first; when there are too many, the dearest go. */
#include "hands/sketch/intent_parts.h"

#include <math.h>

bool bat_intent_wants(const bat_intent_list *list, double cost) {
    return cost < INFINITY &&
           (list->count < BAT_INTENT_READINGS || list->reading[list->count - 1].cost > cost);
}

void bat_intent_offer(bat_intent_list *list, const bat_intent_reading *reading) {
    if (!bat_intent_wants(list, reading->cost)) return;
    int at = list->count < BAT_INTENT_READINGS ? list->count++ : BAT_INTENT_READINGS;
    for (; at > 0 && list->reading[at - 1].cost > reading->cost; at--)
        if (at < BAT_INTENT_READINGS) list->reading[at] = list->reading[at - 1];
    if (at < BAT_INTENT_READINGS) list->reading[at] = *reading;
}
