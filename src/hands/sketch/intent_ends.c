/*
 * Readings at ends of open curves: extend, join, close. A head is how the stroke leaves an end: it starts
 * there, or it runs along the curve first and passes it. A tail is the same from the other side.
 */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

static const double straight = 10, ran_least = 4, least_rest = 10;
static const double bend = 30,
                    corner = 12; /* price of a turn at an end, where it extends and where it joins */

typedef struct head {
    double cost;
    double turn; /* 1 - cosine between curve and stroke, both outwards: turn_at */
    bool ran;    /* along the curve first */
    int place;   /* where it leaves the end */
} head;

/* Out of an end of the line, over so much of it. */
static void outwards(const bat_polyline *line, int end, double over, double way[2]) {
    const double length = bat_polyline_length(line), h = fmin(over, length);
    double inner[2], point[2];
    bat_polyline_at(line, end ? length : 0, point);
    bat_polyline_at(line, end ? length - h : h, inner);
    way[0] = point[0] - inner[0], way[1] = point[1] - inner[1];
    const double size = bat_hypot(way[0], way[1]);
    way[0] /= size > 0 ? size : 1, way[1] /= size > 0 ? size : 1;
}

/* Direction in which the stroke goes on from place i, away from `side`, over so much of it. */
static void going_on(const bat_intent *intent, int i, int side, double over, double way[2]) {
    const double end = intent->hook + (side ? 0 : intent->length),
                 a = intent->a[bat_intent_mirror(intent, i, side)];
    const double h = fmin(over, fabs(end - a)) / 2;
    bat_intent_heading(intent, a + (side ? -h : h), h, way);
    if (side) way[0] = -way[0], way[1] = -way[1];
}

/* 1 - cosine between the line's end and the stroke from place i on: of what is small the greater of a coarse look and a
 * close one, for a coarse one misses the cusp between two bows. */
static double turn_at(const bat_intent *intent, const bat_intent_near *near, int end, int i, int side) {
    const double close = straight * bat_intent_fine(intent, near), looks[2] = {close, fmax(close, straight)};
    double most = 0;
    for (int k = 0; k < 2; k++) {
        double way[2], out_way[2];
        outwards(&near->line, end, looks[k], out_way);
        going_on(intent, i, side, looks[k], way);
        most = fmax(most, 1 - (way[0] * out_way[0] + way[1] * out_way[1]));
    }
    return most;
}

/* An end of the line. */
static void tip_of(const bat_polyline *line, int end, double point[2]) {
    bat_polyline_at(line, end ? bat_polyline_length(line) : 0, point);
}

/* How far from a line all evidence is against it. */
static double far_off(const bat_intent *intent) {
    return INTENT_FAR * bat_intent_reach_most(intent, intent->size);
}

static double beside(const bat_intent *intent) {
    return INTENT_BESIDE * bat_intent_reach_most(intent, intent->size);
}

/* The first place that may lie less than that from the line. */
static int first_beside(const bat_intent *intent, const bat_intent_near *near, int side) {
    const double *box = near->box, centre[2] = {0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])};
    const double within = far_off(intent) + bat_hypot(box[2] - centre[0], box[3] - centre[1]);
    const int last = intent->places - 1;
    return side ? last - bat_runs_last(&intent->runs, last, centre, within * within)
                : bat_runs_next(&intent->runs, 0, centre, within * within);
}

/* Whether half of the stroke up to place k, as far as it lies beside the line, lies on it. */
static bool on_line(const bat_intent *intent, const bat_intent_near *near, int k, int side) {
    const double on = fmax(intent->on * bat_intent_fine(intent, near), bat_intent_astray(intent, near));
    const double parallel = beside(intent);
    double in = 0, along = 0;
    for (int i = first_beside(intent, near, side); i <= k; i++) {
        const double ds = intent->ds[bat_intent_mirror(intent, i, side)];
        if (intent->d[i] < parallel) along += ds;
        if (intent->d[i] <= on) in += ds;
    }
    return in >= 0.5 * along;
}

/* Runs along the curve up to place k at the end: feet are looked for from the end back, on so much of the curve as
 * the stroke is long. */
static double run_along(bat_intent *intent, const bat_intent_near *near, int end, int k, int side,
                        double *off) {
    const bat_polyline *line = &near->line;
    const double length = bat_polyline_length(line);
    bat_foot foot = {.s = end ? length : 0, .segment = end ? line->count - 2 : 0};
    double ran = 0, sum = 0;
    const double way = fabs(intent->a[bat_intent_mirror(intent, k, side)] -
                            intent->a[bat_intent_mirror(intent, 0, side)]);
    const double most = bat_intent_reach_most(intent, intent->size), far = far_off(intent),
                 parallel = beside(intent);
    const double low = end ? length - way - most : 0, high = end ? length : way + most;
    bat_polyline_at(line, foot.s, foot.x);
    const double *p = intent->p + 2 * (size_t)bat_intent_mirror(intent, k, side);
    foot.d = bat_hypot(p[0] - foot.x[0], p[1] - foot.x[1]);
    /* Before the first place beside the line nothing is asked of the feet. */
    const int since = first_beside(intent, near, side);
    for (int i = k; i >= since; i--) {
        const int m = bat_intent_mirror(intent, i, side);
        bool settled;
        foot = bat_intent_foot(near, intent->p + 2 * (size_t)m, &foot, intent->step, low, high);
        foot.c = 0;
        if (foot.d < far)
            foot.c = bat_intent_cosine(intent, line, intent->a[m], &foot, &settled) *
                     ((side == 0) == (end == 1) ? 1 : -1);
        if (foot.d < parallel) ran += foot.c * intent->ds[m];
        intent->d[i] = foot.d, intent->c[i] = foot.c;
    }
    if (!(ran > ran_least * bat_intent_fine(intent, near)) || !on_line(intent, near, k, side))
        return INFINITY;
    const double reach = bat_intent_reach(intent, near, ran);
    for (int i = k; i >= 0; i--) {
        const bat_foot kept = {.d = intent->d[i], .c = intent->c[i]};
        sum += (i < since ? INTENT_FREE : bat_intent_e(&kept, 1, reach)) *
               intent->ds[bat_intent_mirror(intent, i, side)];
    }
    *off = since > 0 ? far : foot.d;
    return sum;
}

/* How near to the point the stroke begins: somewhere in its hook. */
static double begins_at(const bat_intent *intent, const double point[2], int side) {
    enum { LOOKS = 4 };
    const double whole = intent->length + 2 * intent->hook;
    double least = INFINITY, p[2];
    for (int i = 0; i <= LOOKS; i++) {
        const double a = intent->hook * i / LOOKS;
        bat_polyline_at(&intent->stroke, side ? whole - a : a, p);
        least = fmin(least, bat_hypot(p[0] - point[0], p[1] - point[1]));
    }
    return least;
}

static bool find_head(bat_intent *intent, int index, int end, int side, head *out) {
    const bat_intent_near *near = &intent->line[index];
    const double fine = bat_intent_fine(intent, near), at_end = INTENT_AT_END * fine;
    double point[2], passed = INTENT_PASSING * fine;
    tip_of(&near->line, end, point);
    const double start = begins_at(intent, point, side);
    const int k = bat_intent_nearest(intent, point, side, &passed);
    *out = (head){.cost = INFINITY};
    if (start < at_end) *out = (head){.cost = start - at_end, .turn = turn_at(intent, near, end, 0, side)};
    if (k > 0 && passed < INTENT_PASSING * fine) {
        double off = 0;
        const double sum = run_along(intent, near, end, k, side, &off);
        if (sum < INFINITY) {
            const double cost = sum + bat_intent_off(intent, near, off) + 2 * fmax(0, passed - 0.75 * at_end);
            if (cost < out->cost) *out = (head){cost, turn_at(intent, near, end, k, side), true, k};
        }
    }
    return out->cost < INFINITY;
}

static double rest_of(const bat_intent *intent, const head *h, int side, double *chord) {
    const int i = bat_intent_mirror(intent, h->place, side),
              last = bat_intent_mirror(intent, intent->places - 1, side);
    const double *p = intent->p + 2 * (size_t)i, *q = intent->p + 2 * (size_t)last;
    *chord = bat_hypot(p[0] - q[0], p[1] - q[1]);
    return fabs(intent->a[last] - intent->a[i]);
}

/* What a stroke adds to an end; the price doubles beyond the length of what it adds to, for then it is a thing of its own. */
static double more_than(double added, double length) { return added + fmax(0, added - length); }

/* What winds round more than once is a thing of its own, though it begins along a line. */
static double winds(const bat_intent *intent) {
    double all;
    return intent->length * fmax(0, bat_intent_winding(intent, &all) / 360 - 1);
}

static void offer_extend(bat_intent *intent, bat_intent_list *list, int index, int end, int side,
                         const head *h) {
    double chord;
    const double rest = rest_of(intent, h, side, &chord);
    const bat_intent_near *near = &intent->line[index];
    const double turn_most = h->ran ? 1 - 0.798635510047293 : 0.5; /* cosines of 37 and 60 degrees */
    if (!(h->turn < turn_most) || rest < least_rest * bat_intent_fine(intent, near)) return;
    bat_intent_reading reading = {
        .kind = BAT_INTENT_EXTEND,
        .count = 1,
        .part = {{.line = index, .along = {intent->hook, intent->hook + intent->length}}},
        .onto = {-1, -1},
        .cost = h->cost + more_than(rest, bat_polyline_length(&near->line)) +
                (h->ran ? bend / 2 : bend) * bat_intent_fine(intent, near) * h->turn + 0.3 * (rest - chord) +
                (h->ran ? winds(intent) : 0)};
    reading.part[0].free[1 - side] = true;
    reading.part[0].sense = (side == 0) == (end == 1) ? 1 : -1;
    bat_intent_offer(list, &reading);
}

/* Off one end, along all of the curve, off the other. */
static void offer_through(bat_intent *intent, bat_intent_list *list, int index) {
    const bat_intent_near *near = &intent->line[index];
    const double fine = bat_intent_fine(intent, near), passing = INTENT_PASSING * fine,
                 half = 0.75 * INTENT_AT_END * fine;
    double point[2], passed[2] = {passing, passing}, sum = 0;
    int k[2];
    const bool against = near->ran < 0;
    if (near->least > intent->on * fine || fabs(near->ran) < ran_least * fine) return;
    for (int end = 0; end < 2; end++) {
        tip_of(&near->line, end, point);
        k[end ^ against] = bat_intent_nearest(intent, point, 0, &passed[end]);
        if (passed[end] >= passing) return;
    }
    if (k[0] >= k[1]) return;
    const bat_foot *foot = near->track[near->best].foot;
    for (int i = k[0]; i <= k[1]; i++)
        sum += bat_intent_e(&foot[i], against ? -1 : 1, near->reach) * intent->ds[i];
    const double rest = intent->length - (intent->a[k[1]] - intent->a[k[0]]);
    bat_intent_reading reading = {.kind = BAT_INTENT_EXTEND,
                                  .count = 1,
                                  .part = {{.line = index,
                                            .along = {intent->hook, intent->hook + intent->length},
                                            .sense = against ? -1 : 1,
                                            .free = {true, true}}},
                                  .onto = {-1, -1},
                                  .cost = sum + more_than(rest, bat_polyline_length(&near->line)) +
                                          winds(intent) + 2 * fmax(0, passed[0] - half) +
                                          2 * fmax(0, passed[1] - half)};
    bat_intent_offer(list, &reading);
}

typedef struct end_heads {
    int line, end;
    bool is[2];
    head side[2];
} end_heads;

static void offer_bridge(bat_intent *intent, bat_intent_list *list, const end_heads *from,
                         const end_heads *to) {
    const head *h = &from->side[0], *t = &to->side[1];
    if (!from->is[0] || !to->is[1] || (from->line == to->line && from->end == to->end)) return;
    const bool close = from->line == to->line;
    const double gap = intent->a[bat_intent_mirror(intent, t->place, 1)] - intent->a[h->place];
    /* From the one end to the other, a stroke closes though it may run along another line. */
    const double across = close && !h->ran && !t->ran ? 0.5 : 1;
    const double turn_most = 1 + 0.173648177666930; /* cosine of 100 degrees */
    const bat_intent_near *near = &intent->line[from->line], *other = &intent->line[to->line];
    const double length = bat_polyline_length(&near->line) + (close ? 0 : bat_polyline_length(&other->line));
    const double turns = corner * fmin(bat_intent_fine(intent, near), bat_intent_fine(intent, other));
    if (!(gap > 0) || (!close && (h->turn >= turn_most || t->turn >= turn_most))) return;
    bat_intent_reading reading = {.kind = close ? BAT_INTENT_CLOSE : BAT_INTENT_JOIN,
                                  .count = close ? 1 : 2,
                                  .onto = {-1, -1},
                                  .cost = h->cost + across * gap + (2 - across) * fmax(0, gap - length) +
                                          t->cost + winds(intent) +
                                          (close ? 0 : turns * (h->turn + t->turn))};
    const int lines[2] = {from->line, to->line};
    for (int i = 0; i < 2; i++)
        reading.part[i] = (bat_intent_part){.line = lines[i],
                                            .along = {intent->hook, intent->hook + intent->length}};
    bat_intent_offer(list, &reading);
}

enum { ENDS_MOST = 16 };

void bat_intent_ends(bat_intent *intent, bat_intent_list *list) {
    end_heads found[ENDS_MOST];
    int count = 0;
    for (int i = 0; i < intent->line_count; i++) {
        const bat_intent_near *near = &intent->line[i];
        if (near->line.count < 2 || !near->meant || near->line.closed) continue;
        bool open[2];
        for (int end = 0; end < 2; end++) {
            const double passing = INTENT_PASSING * bat_intent_fine(intent, near);
            double point[2], distance = passing;
            tip_of(&near->line, end, point);
            bat_intent_nearest(intent, point, 0, &distance);
            open[end] = distance < passing && bat_intent_open(intent, i, end);
            if (!open[end] || count == ENDS_MOST) continue;
            end_heads *e = &found[count];
            *e = (end_heads){.line = i, .end = end};
            for (int side = 0; side < 2; side++) {
                e->is[side] = find_head(intent, i, end, side, &e->side[side]);
                if (e->is[side]) offer_extend(intent, list, i, end, side, &e->side[side]);
            }
            if (e->is[0] || e->is[1]) count++;
        }
        if (open[0] && open[1] && near->usable) offer_through(intent, list, i);
    }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) offer_bridge(intent, list, &found[i], &found[j]);
}
