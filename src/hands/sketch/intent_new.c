/* A new curve: it costs the length of the stroke. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

static const double gap_most = 0.1; /* of the stroke: so near its ends close it */

static bool closes(const bat_intent *intent) {
    const double *first = intent->stroke.x, *last = first + 2 * (size_t)(intent->stroke.count - 1);
    const double gap = bat_hypot(first[0] - last[0], first[1] - last[1]);
    if (gap > gap_most * bat_polyline_length(&intent->stroke)) return false;
    double all;
    const double degrees = bat_intent_winding(intent, &all);
    return degrees >= 230 && degrees <= 470;
}

/* Of the smaller of stroke and line: so near to it lies an end that is meant to meet it. */
static const double meets = 0.03;

/* How far from the line the tip is, and how far it may be: at a steep angle, or beside an end of the line, farther than
 * where both run side by side. */
static double off_line(const bat_intent *intent, const bat_intent_near *near, const double tip[2],
                       const double way[2], double *most) {
    const double size = fmin(intent->size, bat_intent_size(near)), length = bat_polyline_length(&near->line);
    const bat_foot foot = bat_intent_foot(near, tip, &(bat_foot){0}, INFINITY, -INFINITY, INFINITY);
    double along[2];
    *most = fmin(INTENT_ON, meets * size);
    if (near->line.closed || (foot.s > *most && foot.s < length - *most)) {
        bat_polyline_chord(&near->line, foot.s, 0.05 * size, along);
        const double m = bat_hypot(along[0], along[1]);
        if (m > 0) *most *= fabs(way[0] * along[1] - way[1] * along[0]) / m;
    }
    return foot.d;
}

/* Where the stroke starts or ends: as far as its hook leads on along it. way: the direction there, outwards. */
static void tip_of(const bat_intent *intent, int side, double tip[2], double way[2]) {
    const double fine = fmin(1, intent->size / INTENT_FULL), hook = fine * intent->hook;
    const double whole = bat_polyline_length(&intent->stroke), h = fmin(6 * fine, intent->length / 4);
    const double *end = intent->stroke.x + (side ? 2 * (size_t)(intent->stroke.count - 1) : 0);
    bat_intent_heading(intent, side ? whole - hook - h : hook + h, h, way);
    if (!side) way[0] = -way[0], way[1] = -way[1];
    bat_polyline_at(&intent->stroke, side ? whole - hook : hook, tip);
    const double on = fmax(0, (end[0] - tip[0]) * way[0] + (end[1] - tip[1]) * way[1]);
    for (int k = 0; k < 2; k++) tip[k] += on * way[k];
}

/* The line that this end of the stroke is put on: the nearest of those that are near enough. */
static void put_on(const bat_intent *intent, int side, bat_intent_reading *reading) {
    const double on = fmin(INTENT_ON, meets * intent->size);
    double way[2], least = INFINITY, *tip = reading->tip[side];
    tip_of(intent, side, tip, way);
    reading->onto[side] = -1;
    for (int i = 0; i < intent->line_count; i++) {
        const bat_intent_near *near = &intent->line[i];
        if (!bat_intent_long(near) || bat_box_distance2(near->box, tip) > 1.01 * on * on) continue;
        double most;
        const double d = off_line(intent, near, tip, way, &most);
        if (d <= most && d < least) least = d, reading->onto[side] = i;
    }
}

bat_status bat_intent_new(bat_intent *intent, bat_intent_list *list) {
    bat_intent_reading reading = {.kind = BAT_INTENT_NEW, .onto = {-1, -1}, .cost = intent->length};
    reading.closed = closes(intent);
    for (int side = 0; side < 2 && !reading.closed; side++) put_on(intent, side, &reading);
    bat_intent_offer(list, &reading);
    return BAT_OK;
}
