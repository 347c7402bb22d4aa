/* A new curve: it costs the length of the stroke. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

enum { WINDING_PLACES = 48 };

/* The signed winding of the stroke, in degrees; by chords, for a hook at either end may turn any way. */
static double winding(const bat_intent *intent) {
    const double whole = intent->length + 2 * intent->hook, h = whole / 12;
    double sum = 0, last[2], now[2];
    bat_intent_heading(intent, 0, h, last);
    for (int i = 1; i <= WINDING_PLACES; i++) {
        bat_intent_heading(intent, whole * i / WINDING_PLACES, h, now);
        sum += bat_atan2(last[0] * now[1] - last[1] * now[0], last[0] * now[0] + last[1] * now[1]);
        last[0] = now[0], last[1] = now[1];
    }
    return fabs(sum) * 180 / BAT_PI;
}

static bool closes(const bat_intent *intent) {
    const double *first = intent->stroke.x, *last = first + 2 * (size_t)(intent->stroke.count - 1);
    const double gap = bat_hypot(first[0] - last[0], first[1] - last[1]), L = intent->length;
    if (!(L > 12) || gap > fmax(4, 0.1 * L)) return false;
    const double degrees = winding(intent);
    return degrees >= 230 && degrees <= 470;
}

/* The line that the stroke's start is put on: the nearest of those that are near enough. */
static bat_status put_on(bat_intent *intent, bat_intent_reading *reading) {
    double near = intent->on * fmin(1, intent->length / 60);
    for (int i = 0; i < intent->line_count; i++) {
        bat_intent_near *line = &intent->line[i];
        const double within = near + intent->hook;
        if (!bat_intent_long(line) || bat_box_distance2(line->box, intent->p) > 1.01 * within * within)
            continue;
        if (bat_intent_seed(intent, line) != BAT_OK) return BAT_MEMORY;
        /* The first seed is the nearest. */
        const bat_foot *seed = &line->track[0].foot[0];
        if (seed->d >= within) continue;
        const bat_foot foot = bat_intent_foot(line, reading->start, seed, intent->hook, -INFINITY, INFINITY);
        if (foot.d >= near) continue;
        near = foot.d;
        reading->onto = i;
    }
    return BAT_OK;
}

bat_status bat_intent_new(bat_intent *intent, bat_intent_list *list) {
    bat_intent_reading reading = {.kind = BAT_INTENT_NEW, .onto = -1, .cost = intent->length};
    reading.closed = closes(intent);
    double way[2], ahead = fmin(12, intent->length / 2);
    bat_intent_heading(intent, intent->hook + ahead / 2, ahead / 2, way);
    for (int k = 0; k < 2; k++) reading.start[k] = intent->p[k] - intent->hook * way[k];
    const bat_status status = reading.closed ? BAT_OK : put_on(intent, &reading);
    bat_intent_offer(list, &reading);
    return status;
}
