/*
 * One stroke over several curves that touch end to end: the cheapest way through curves and senses, stepping from one to
 * the next only where they touch (Viterbi 1967).
 */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHAIN_MOST = 12, STATES = 2 * CHAIN_MOST, STAY = 255 };
static const double step_price = 3, part_least = 10, part_share = 0.08,
                    cut_reach = 24; /* px; by the size of the stroke */

/* Curves that touch one another near the stroke. State: curve and sense, 2 i + against. */
typedef struct chain {
    int count, line[CHAIN_MOST];
    double end[CHAIN_MOST][2][2]; /* points */
    double coarse;                /* how many times as large as most */
    double reach, least;          /* of a part: length */
} chain;

typedef struct cell {
    double cost, since; /* since: length along the stroke where this part began */
    unsigned used;      /* curves so far, bits */
    int parts;
} cell;

static bool touches(const chain *c, int i, int j, int ei, int ej) {
    return bat_hypot(c->end[i][ei][0] - c->end[j][ej][0], c->end[i][ei][1] - c->end[j][ej][1]) <=
           c->coarse * INTENT_JOINT;
}

static bool touches_any(const chain *c, int i) {
    for (int j = 0; j < c->count; j++)
        for (int k = 0; k < 4 && j != i; k++)
            if (touches(c, i, j, k & 1, k >> 1)) return true;
    return false;
}

static void drop(chain *c, int i) {
    const size_t after = (size_t)(--c->count - i);
    memmove(&c->line[i], &c->line[i + 1], after * sizeof c->line[0]);
    memmove(&c->end[i], &c->end[i + 1], after * sizeof c->end[0]);
}

/* Takes the line, the last so far in the drawing's order; of too many, those that come nearest to the stroke stay. */
static void take(const bat_intent *intent, chain *c, int line) {
    const bat_intent_near *near = &intent->line[line];
    if (c->count == CHAIN_MOST) {
        int farthest = 0;
        for (int i = 1; i < c->count; i++)
            if (intent->line[c->line[i]].least >= intent->line[c->line[farthest]].least) farthest = i;
        if (near->least >= intent->line[c->line[farthest]].least) return;
        drop(c, farthest);
    }
    const double *x = near->line.x;
    memcpy(c->end[c->count][0], x, 2 * sizeof *x);
    memcpy(c->end[c->count][1], x + 2 * (size_t)(near->line.count - 1), 2 * sizeof *x);
    c->line[c->count++] = line;
}

static bat_status gather(bat_intent *intent, chain *c) {
    c->count = 0;
    c->coarse = bat_intent_coarse(intent->size);
    c->reach = bat_intent_reach_whole(intent);
    c->least = fmax(part_least * bat_intent_coarse(intent->size), part_share * intent->length);
    for (int i = 0; i < intent->line_count; i++) {
        const bat_intent_near *near = &intent->line[i];
        if (!near->meant || near->line.closed) continue;
        const bat_status status = bat_intent_ask_late(intent, i);
        if (status != BAT_OK) return status;
        if (near->usable && near->least <= c->reach) take(intent, c, i);
    }
    for (int i = c->count - 1; i >= 0; i--)
        if (!touches_any(c, i)) drop(c, i);
    return BAT_OK;
}

static const bat_foot *foot_of(const bat_intent *intent, const chain *c, int state, int place) {
    const bat_intent_near *near = &intent->line[c->line[state / 2]];
    return &near->track[near->best].foot[place];
}

/* A part in this sense ends at end 1, against it at end 0, and begins at the other. */
static double step_cost(const bat_intent *intent, const chain *c, int from, int to, int place) {
    const int leaves = from & 1 ? 0 : 1, enters = to & 1 ? 1 : 0;
    if (from / 2 == to / 2 || !touches(c, from / 2, to / 2, leaves, enters)) return INFINITY;
    const double *p = intent->p + 2 * (size_t)place, *j = c->end[to / 2][enters];
    const double d = bat_hypot(p[0] - j[0], p[1] - j[1]);
    return d > 2 * c->reach ? INFINITY : step_price + 0.5 * fmax(0, d - c->reach / 2);
}

static double edge(const bat_intent *intent, const chain *c, int state, int side) {
    const bat_foot *foot = foot_of(intent, c, state, side ? intent->places - 1 : 0);
    return bat_intent_off(intent, &intent->line[c->line[state / 2]], foot->d) +
           bat_intent_leave(intent, foot, side);
}

static void advance(const bat_intent *intent, const chain *c, int place, const cell *before, cell *now,
                    unsigned char *steps) {
    for (int s = 0; s < 2 * c->count; s++) {
        now[s] = before[s];
        steps[s] = STAY;
        for (int from = 0; from < 2 * c->count; from++) {
            const cell *b = &before[from];
            if (!(b->cost < now[s].cost) || b->used >> (s / 2) & 1 || b->parts == BAT_INTENT_PARTS) continue;
            if (intent->a[place] - b->since < c->least) continue;
            const double cost = b->cost + step_cost(intent, c, from, s, place);
            if (!(cost < now[s].cost)) continue;
            now[s] = (cell){cost, intent->a[place], b->used | 1u << (s / 2), b->parts + 1};
            steps[s] = (unsigned char)from;
        }
        now[s].cost += bat_intent_e(foot_of(intent, c, s, place), s & 1 ? -1 : 1, c->reach) *
                       intent->ds[place];
    }
}

/* Where the stroke is cut: at the place nearest to the joint, within some distance of the step. */
static double cut_at(const bat_intent *intent, const chain *c, int to, int place) {
    const double *j = c->end[to / 2][to & 1 ? 1 : 0];
    double best = INFINITY;
    int at = place;
    for (int i = 1; i + 1 < intent->places; i++) {
        const double *p = intent->p + 2 * (size_t)i, d = bat_hypot(p[0] - j[0], p[1] - j[1]);
        if (fabs(intent->a[i] - intent->a[place]) <= c->coarse * cut_reach && d < best) best = d, at = i;
    }
    return intent->a[at];
}

static void read_back(bat_intent *intent, const chain *c, int state, int parts, bat_intent_reading *reading) {
    const int states = 2 * c->count;
    double to = intent->hook + intent->length;
    int last = state, k = parts - 1;
    for (int i = intent->places - 1; i >= 0 && k >= 0; i--) {
        const int from = i ? intent->steps[(size_t)i * (size_t)states + (size_t)state] : -1;
        if (from == STAY) continue;
        const double at = i ? cut_at(intent, c, state, i) : intent->hook;
        reading->part[k] = (bat_intent_part){.line = c->line[state / 2],
                                             .sense = state & 1 ? -1 : 1,
                                             .along = {at, to},
                                             .free = {k > 0, k + 1 < parts}};
        to = at, k--;
        if (i) state = from;
    }
    reading->part[0].held[0] = bat_intent_held(intent, c->line[state / 2], state & 1, 0);
    reading->part[parts - 1].held[1] = bat_intent_held(intent, c->line[last / 2], last & 1, 1);
}

bat_status bat_intent_several(bat_intent *intent, bat_intent_list *list) {
    chain c;
    cell row[2][STATES];
    const bat_status status = gather(intent, &c);
    const int states = 2 * c.count, n = intent->places;
    if (status != BAT_OK || c.count < 2) return status;
    const size_t size = (size_t)states * (size_t)n;
    if (size > intent->steps_room) {
        unsigned char *steps = realloc(intent->steps, 2 * size);
        if (!steps) return BAT_MEMORY;
        intent->steps = steps, intent->steps_room = 2 * size;
    }
    for (int s = 0; s < states; s++)
        row[0][s] = (cell){edge(intent, &c, s, 0) +
                               bat_intent_e(foot_of(intent, &c, s, 0), s & 1 ? -1 : 1, c.reach) *
                                   intent->ds[0],
                           intent->hook, 1u << (s / 2), 1};
    for (int i = 1; i < n; i++)
        advance(intent, &c, i, row[(i + 1) % 2], row[i % 2], intent->steps + (size_t)i * (size_t)states);
    const cell *end = row[(n - 1) % 2];
    int best = -1;
    double least = INFINITY;
    for (int s = 0; s < states; s++) {
        const double cost = end[s].cost + edge(intent, &c, s, 1);
        if (end[s].parts < 2 || intent->hook + intent->length - end[s].since < c.least || !(cost < least))
            continue;
        least = cost, best = s;
    }
    if (best < 0) return BAT_OK;
    bat_intent_reading reading = {.kind = BAT_INTENT_SEVERAL, .count = end[best].parts, .onto = {-1, -1}};
    reading.cost = intent->chosen ? least * INTENT_MARGIN : least / INTENT_MARGIN;
    read_back(intent, &c, best, end[best].parts, &reading);
    bat_intent_offer(list, &reading);
    return BAT_OK;
}
