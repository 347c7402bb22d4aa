/* The redraw of one curve. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

static const double steep = 0.642787609686539; /* sine of 40 degrees */
/* Times the stretch that it redraws, and degrees; what is longer and winds more is a thing of its own. */
static const double longer = 1.4, turns_most = 220;
static const double shorter = 1.1; /* times itself; a short cut does not swing out */
static const double corner = 40;   /* degrees, of a turn within a sixth of the stroke; a hump is round */
static const double root = 0.2;    /* of the stroke, over which it leaves the curve */

/* The sine of the angle at which the stroke's end leaves the curve; 1: it turns its back on it. */
static double leaves(const bat_intent *intent, const bat_intent_near *near, int side) {
    const bat_foot *foot = near->track[near->best].foot + (side ? intent->places - 1 : 0);
    const double h = root / 2 * intent->length, sense = near->ran < 0 ? -1 : 1, in = side ? -1 : 1;
    double u[2], v[2];
    bat_intent_heading(intent, intent->hook + (side ? intent->length - h : h), h, u);
    bat_polyline_chord(&near->line, foot->s + sense * in * h, h, v);
    const double m = bat_hypot(v[0], v[1]);
    if (!((u[0] * v[0] + u[1] * v[1]) * sense > 0)) return 1;
    return fabs(u[0] * v[1] - u[1] * v[0]) / m;
}

/* How far from the curve that end of the stroke is, its hook taken either way. */
static double tip_off(const bat_intent *intent, const bat_intent_near *near, int side) {
    const bat_foot *foot = near->track[near->best].foot + (side ? intent->places - 1 : 0);
    double tip[2];
    bat_polyline_at(&intent->stroke, side ? bat_polyline_length(&intent->stroke) : 0, tip);
    return fmin(foot->d, bat_intent_foot(near, tip, foot, intent->hook, -INFINITY, INFINITY).d);
}

static bool between(const bat_intent *intent, const bat_intent_near *near) {
    const double fine = bat_intent_fine(intent, near),
                 on = intent->on * fine + 0.5 * intent->hook * fmax(0, 1 - fine);
    return tip_off(intent, near, 0) <= on && tip_off(intent, near, 1) <= on;
}

/* Whether the stroke turns at one corner more than all the way otherwise. */
static bool pointed(const bat_intent *intent) {
    enum { PLACES = 24 };
    const double h = intent->length / 12;
    double all, most = 0;
    bat_intent_winding(intent, &all);
    for (int i = 0; i <= PLACES; i++) {
        const double a = intent->hook + 2 * h + (intent->length - 4 * h) * i / PLACES;
        double u[2], v[2];
        bat_intent_heading(intent, a - h, h, u);
        bat_intent_heading(intent, a + h, h, v);
        most = fmax(most, fabs(bat_atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])));
    }
    most *= 180 / BAT_PI;
    return most > corner && most > 0.5 * all;
}

/* A bold redraw leaves the curve and comes back to it, at no steep angle: however far it swings out, it means the curve.
 * Steeper ones are ears and handles. */
static double bold(const bat_intent *intent, const bat_intent_near *near) {
    const bat_foot *foot = near->track[near->best].foot, *last = &foot[intent->places - 1];
    if (!between(intent, near) || pointed(intent)) return INFINITY;
    const double first = leaves(intent, near, 0) / steep, second = leaves(intent, near, 1) / steep;
    const double stretch = fabs(last->s - foot->s);
    double turns;
    bat_intent_winding(intent, &turns);
    return (0.5 * (first * first + second * second) * INTENT_MARGIN + fmax(0, turns / turns_most - 1)) *
               intent->length +
           fmax(0, intent->length - longer * stretch) + fmax(0, stretch - shorter * intent->length);
}

static double cost_of(const bat_intent *intent, const bat_intent_near *near) {
    const bat_foot *foot = near->track[near->best].foot, *last = &foot[intent->places - 1];
    const double lost = fabs(last->s - foot->s);
    return fmin(near->sum, bold(intent, near)) + bat_intent_off(intent, near, foot->d) +
           bat_intent_off(intent, near, last->d) + bat_intent_leave(intent, foot, 0) +
           bat_intent_leave(intent, last, 1) + fmax(0, lost - 1.5 * intent->length - 2 * near->reach);
}

bool bat_intent_held(bat_intent *intent, int index, bool against, int side) {
    const bat_intent_near *near = &intent->line[index];
    const bat_foot *f = &near->track[near->best].foot[side ? intent->places - 1 : 0];
    const int end = side ^ against;
    const double stub = end ? bat_polyline_length(&near->line) - f->s : f->s;
    return !near->line.closed && stub < fmax(INTENT_AT_END * bat_intent_fine(intent, near), f->d) &&
           !bat_intent_open(intent, index, end);
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
                                      .onto = {-1, -1},
                                      .cost = intent->chosen ? cost * INTENT_MARGIN : cost / INTENT_MARGIN};
        if (!bat_intent_wants(list, reading.cost)) continue;
        reading.between = between(intent, &intent->line[i]);
        for (int side = 0; side < 2; side++)
            reading.part[0].held[side] = bat_intent_held(intent, i, intent->line[i].ran < 0, side);
        bat_intent_offer(list, &reading);
    }
}
