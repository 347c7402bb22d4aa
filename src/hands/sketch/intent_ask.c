/* Which lines are asked for feet at all: by their boxes, for feet are dear where a stroke passes many lines. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

static const double nothing = 2.5, too_short = 40;

/* Whether a line with this sum of evidence, or more, explains next to nothing. */
static bool hopeless(const bat_intent *intent, double sum) {
    return sum > nothing * intent->length && intent->length > too_short;
}

/* What the line's box tells: the least that its evidence can add up to, and whether the line may lie within reach. */
static void bound(const bat_intent *intent, bat_intent_near *near, double reach) {
    const double most = bat_intent_reach_most(intent, intent->size) * (intent->chosen ? INTENT_CHOSEN : 1),
                 scale = 1 / (most * most);
    double least = INFINITY;
    near->bound = 0;
    for (int i = 0; i < intent->places; i++) {
        const double d2 = bat_box_distance2(near->box, intent->p + 2 * (size_t)i), e = d2 * scale;
        near->bound += (e < INTENT_FREE ? e : INTENT_FREE) * intent->ds[i];
        least = d2 < least ? d2 : least;
    }
    near->within = least <= 1.01 * reach * reach;
}

/* Whether the stroke passes both ends, so that it may run all along and extend the line both ways. */
static bool passes_both(const bat_intent *intent, const bat_intent_near *near) {
    const bat_polyline *line = &near->line;
    const double most = INTENT_PASSING * bat_intent_fine(intent, near);
    double distance[2] = {most, most};
    if (line->closed) return false;
    for (int end = 0; end < 2; end++)
        bat_intent_nearest(intent, line->x + (end ? 2 * (size_t)(line->count - 1) : 0), 0, &distance[end]);
    return distance[0] < most && distance[1] < most;
}

/* The bound up to which as many lines lie as there can be readings. */
static double bound_of_readings(const bat_intent *intent) {
    double least[BAT_INTENT_READINGS];
    int count = 0;
    for (int i = 0; i < intent->line_count; i++) {
        const bat_intent_near *near = &intent->line[i];
        if (!near->awake) continue;
        int at = count < BAT_INTENT_READINGS ? count++ : BAT_INTENT_READINGS;
        for (; at > 0 && least[at - 1] > near->bound; at--)
            if (at < BAT_INTENT_READINGS) least[at] = least[at - 1];
        if (at < BAT_INTENT_READINGS) least[at] = near->bound;
    }
    return count ? least[count - 1] : 0;
}

/* Brings its feet up to date and evaluates them. A line that explains nothing sleeps until the stroke is a quarter
 * longer. */
static bat_status ask(bat_intent *intent, int index) {
    bat_intent_near *near = &intent->line[index];
    bat_status status = bat_intent_feet(intent, near);
    if (status != BAT_OK) return status;
    bat_intent_evidence(intent, index);
    if (hopeless(intent, near->sum)) near->asleep = 1.25 * intent->length;
    near->usable = true;
    return BAT_OK;
}

/* Of those awake, the ones whose boxes say that they can explain next to nothing are left for later, once there are
 * better ones for all readings; but not what the stroke may extend both ways. */
bat_status bat_intent_ask(bat_intent *intent, bool whole) {
    const double reach = bat_intent_reach_whole(intent);
    intent->whole = whole;
    for (int i = 0; i < intent->line_count; i++) {
        bat_intent_near *near = &intent->line[i];
        near->usable = false;
        near->awake = bat_intent_long(near) && (whole || intent->length >= near->asleep);
        if (near->awake) bound(intent, near, reach);
    }
    const double least = whole ? bound_of_readings(intent) : 0;
    bat_status status = BAT_OK;
    for (int i = 0; i < intent->line_count && status == BAT_OK; i++) {
        bat_intent_near *near = &intent->line[i];
        if (!near->awake) continue;
        if (near->bound <= least || !hopeless(intent, near->bound) || passes_both(intent, near))
            status = ask(intent, i);
        else
            near->asleep = 1.25 * intent->length;
    }
    return status;
}

bat_status bat_intent_ask_late(bat_intent *intent, int index) {
    const bat_intent_near *near = &intent->line[index];
    return near->awake && near->within && !near->usable ? ask(intent, index) : BAT_OK;
}
