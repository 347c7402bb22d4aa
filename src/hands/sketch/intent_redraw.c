/* The redraw of one curve. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

static double cost_of(const bat_intent *intent, const bat_intent_near *near) {
    const bat_foot *foot = near->track[near->best].foot, *last = &foot[intent->places - 1];
    const double lost = fabs(last->s - foot->s);
    return near->sum + bat_intent_off(intent, foot->d) + bat_intent_off(intent, last->d) +
           bat_intent_leave(intent, foot, 0) + bat_intent_leave(intent, last, 1) +
           fmax(0, lost - 1.5 * intent->length - 2 * near->reach);
}

bool bat_intent_held(bat_intent *intent, int index, bool against, int side) {
    const bat_intent_near *near = &intent->line[index];
    const bat_foot *f = &near->track[near->best].foot[side ? intent->places - 1 : 0];
    const int end = side ^ against;
    const double stub = end ? bat_polyline_length(&near->line) - f->s : f->s;
    return !near->line.closed && stub < fmax(INTENT_AT_END, f->d) && !bat_intent_open(intent, index, end);
}

void bat_intent_redraws(bat_intent *intent, bat_intent_list *list) {
    const double L = intent->length;
    double least = INFINITY, next = INFINITY; /* of all costs */
    for (int i = 0; i < intent->line_count; i++) {
        bat_intent_near *near = &intent->line[i];
        near->cost = near->usable && near->meant ? cost_of(intent, near) : INFINITY;
        next = fmin(next, fmax(least, near->cost));
        least = fmin(least, near->cost);
    }
    for (int i = 0; i < intent->line_count; i++) {
        if (!(intent->line[i].cost < INFINITY)) continue;
        /* Two curves that explain it equally well explain it badly. */
        double cost = intent->line[i].cost, rival = cost > least ? least : next;
        if (rival < INFINITY) cost += 0.5 * L * bat_exp(-fmax(0, rival - cost) / (0.2 * L));
        bat_intent_reading reading = {.kind = BAT_INTENT_REDRAW,
                                      .count = 1,
                                      .part = {{.line = i,
                                                .sense = intent->line[i].ran < 0 ? -1 : 1,
                                                .along = {intent->hook, intent->hook + L}}},
                                      .onto = -1,
                                      .cost = intent->chosen ? cost * INTENT_MARGIN : cost / INTENT_MARGIN};
        if (!bat_intent_wants(list, reading.cost)) continue;
        for (int side = 0; side < 2; side++)
            reading.part[0].held[side] = bat_intent_held(intent, i, intent->line[i].ran < 0, side);
        bat_intent_offer(list, &reading);
    }
}
