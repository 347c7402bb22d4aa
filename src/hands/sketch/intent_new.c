/* A new curve: costs what the stroke is long. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

/* Degrees that the stroke winds, with sign. */
static double winding(const bat_intent *intent) {
    double sum = 0, last[2] = {0, 0};
    for (int i = 0; i + 1 < intent->places; i++) {
        const double *p = intent->p + 2 * (size_t)i, v[2] = {p[2] - p[0], p[3] - p[1]};
        if (v[0] == 0 && v[1] == 0) continue;
        sum += bat_atan2(last[0] * v[1] - last[1] * v[0], last[0] * v[0] + last[1] * v[1]);
        last[0] = v[0], last[1] = v[1];
    }
    return fabs(sum) * 180 / BAT_PI;
}

static bool closes(const bat_intent *intent) {
    const double *p = intent->p, *q = p + 2 * (size_t)(intent->places - 1), L = intent->length;
    const double *first = intent->stroke.x, *last = first + 2 * (size_t)(intent->stroke.count - 1);
    /* With the hooks or without them. */
    const double gap = fmin(bat_hypot(p[0] - q[0], p[1] - q[1]), bat_hypot(first[0] - last[0], first[1] - last[1]));
    if (!(L > 12) || gap > fmax(4, 0.1 * L)) return false;
    const double degrees = winding(intent);
    return degrees >= 230 && degrees <= 470;
}

void bat_intent_new(bat_intent *intent, bat_intent_list *list) {
    bat_reading reading = {.kind = BAT_INTENT_NEW, .onto = -1, .cost = intent->length};
    reading.closed = closes(intent);
    double near = intent->on * fmin(1, intent->length / 60);
    for (int i = 0; i < intent->line_count && !reading.closed; i++) {
        const bat_intent_near *line = &intent->line[i];
        if (!line->seeds || line->track[0].foot[0].d >= near) continue;
        near = line->track[0].foot[0].d; /* the first seed is the nearest */
        reading.onto = i;
    }
    bat_intent_offer(list, &reading);
}
