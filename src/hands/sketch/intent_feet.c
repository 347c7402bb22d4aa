/* Feet: where each place of the stroke belongs on a line. They move along it with the stroke and never restart at the
 * nearest place, or they would hop between branches. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double hurry = 0.1; /* price of a jump along the line beyond three steps */

/* Segment k of a closed line of n may lie in any turn. */
static int turn_of(int k, int n) { return k >= 0 ? k / n : -((n - 1 - k) / n); }

static const double *segment_at(const bat_polyline *line, int k, double *s0, double *s1) {
    const int n = line->count - 1, turn = line->closed ? turn_of(k, n) : 0, i = k - turn * n;
    const double base = turn * line->s[n];
    *s0 = base + line->s[i], *s1 = base + line->s[i + 1];
    return line->x + 2 * (size_t)i;
}

/* The best place of segment k for p; its price decides. */
static void try_segment(const bat_polyline *line, int k, const double p[2], double from, double easy,
                        double low, double high, bat_foot *best, double *price) {
    double s0, s1;
    const double *a = segment_at(line, k, &s0, &s1), h = s1 - s0;
    const double v[2] = {a[2] - a[0], a[3] - a[1]};
    const double t = h > 0 ? ((p[0] - a[0]) * v[0] + (p[1] - a[1]) * v[1]) / h : 0; /* length along it */
    double s = s0 + t;
    if (s > from + easy)
        s = (s + hurry * (from + easy)) / (1 + hurry);
    else if (s < from - easy)
        s = (s + hurry * (from - easy)) / (1 + hurry);
    low = s0 > low ? s0 : low,
    high = s1 < high ? s1 : high; /* not fmin and fmax: calls, in the innermost loop */
    s = s > low ? s : low, s = s < high ? s : high;
    const double f = h > 0 ? (s - s0) / h : 0, x[2] = {a[0] + f * v[0], a[1] + f * v[1]};
    const double d2 = (p[0] - x[0]) * (p[0] - x[0]) + (p[1] - x[1]) * (p[1] - x[1]);
    const double beyond = fabs(s - from) - easy, jump = beyond > 0 ? beyond : 0,
                 now = d2 + hurry * jump * jump;
    if (!(now < *price)) return;
    *price = now;
    *best = (bat_foot){.s = s, .d = sqrt(d2), .x = {x[0], x[1]}, .segment = k};
}

/* The next segment from k on, or the last up to k, that may be cheaper; none is passed over beyond the line's seam. */
static int ahead(const bat_intent_near *near, int k, const double p[2], double price) {
    const int n = near->line.count - 1, turn = near->line.closed ? turn_of(k, n) : 0;
    const int found = bat_runs_next(&near->runs, k - turn * n, p, price);
    return turn * n + (found < n ? found : n);
}

static int behind(const bat_intent_near *near, int k, const double p[2], double price) {
    const int n = near->line.count - 1, turn = near->line.closed ? turn_of(k, n) : 0;
    return turn * n + bat_runs_last(&near->runs, k - turn * n, p, price);
}

bat_foot bat_intent_foot(const bat_intent_near *near, const double p[2], const bat_foot *from, double step,
                         double low, double high) {
    const bat_polyline *line = &near->line;
    bat_foot best = *from;
    double price = INFINITY, s0, s1;
    const double easy = 3 * step, window = easy + 2 * from->d;
    const int last = line->count - 2;
    double upto = from->s + window, since = from->s - window;
    upto = upto < high ? upto : high, since = since > low ? since : low;
    for (int k = from->segment; line->closed || k <= last; k = ahead(near, k + 1, p, price)) {
        segment_at(line, k, &s0, &s1);
        if (s0 > upto || k - from->segment > last) break;
        try_segment(line, k, p, from->s, easy, low, high, &best, &price);
    }
    for (int k = behind(near, from->segment - 1, p, price); line->closed || k >= 0;
         k = behind(near, k - 1, p, price)) {
        segment_at(line, k, &s0, &s1);
        if (s1 < since || from->segment - k > last) break;
        try_segment(line, k, p, from->s, easy, low, high, &best, &price);
    }
    best.settled = false;
    return best;
}

static double distance_to(const bat_polyline *line, int k, const double p[2], bat_foot *out) {
    double price = INFINITY;
    try_segment(line, k, p, 0, INFINITY, -INFINITY, INFINITY, out, &price);
    return out->d;
}

/* Local minima of the distance, the nearest first. */
static int find_seeds(const bat_polyline *line, const double p[2], bat_foot out[INTENT_SEEDS]) {
    const int n = line->count - 1;
    int found = 0;
    bat_foot before = {0}, here = {0}, after = {0};
    double d0 = INFINITY, d1 = distance_to(line, 0, p, &here);
    if (line->closed) d0 = distance_to(line, n - 1, p, &before);
    for (int k = 0; k < n; k++, d0 = d1, d1 = after.d, here = after) {
        double d2 = INFINITY;
        if (k + 1 < n || line->closed) d2 = distance_to(line, (k + 1) % n, p, &after);
        if (d1 > d0 || d1 >= d2) continue;
        int at = found < INTENT_SEEDS ? found++ : INTENT_SEEDS;
        while (at > 0 && out[at - 1].d > here.d) {
            if (at < INTENT_SEEDS) out[at] = out[at - 1];
            at--;
        }
        if (at < INTENT_SEEDS) out[at] = here;
    }
    if (!found) out[found++] = here;
    return found;
}

double bat_intent_cosine(const bat_intent *intent, const bat_polyline *line, double a, const bat_foot *foot,
                         bool *settled) {
    const double h = 5 + foot->d / 2, mine = fmin(h, intent->length / 6);
    double u[2], v[2];
    const double way = bat_polyline_chord(&intent->stroke, a, mine, u);
    const double theirs = bat_polyline_chord(line, foot->s, h, v);
    const double m = bat_hypot(u[0], u[1]), n = bat_hypot(v[0], v[1]);
    *settled = mine == h && a + h <= intent->hook + intent->length;
    if (!(m > 0 && n > 0)) return 0;
    return (u[0] * v[0] + u[1] * v[1]) / (m * n) * fmin(1, (m / way) / (n / theirs));
}

static bool room_for(bat_intent_near *near, int places) {
    if (places <= near->room) return true;
    const int room = 2 * places + 64;
    for (int t = 0; t < INTENT_SEEDS; t++) {
        bat_foot *foot = realloc(near->track[t].foot, (size_t)room * sizeof *foot);
        if (!foot) return false;
        near->track[t].foot = foot;
    }
    near->room = room;
    return true;
}

static double priced(const bat_foot *from, const bat_foot *to, double step) {
    const double jump = fmax(0, fabs(to->s - from->s) - 3 * step);
    return to->d * to->d + hurry * jump * jump;
}

/* Tracks that have met go on together: the foot of an earlier track that stood at the same place, or NULL. */
static const bat_foot *met_before(const bat_intent_near *near, int track, int i) {
    const bat_foot *from = &near->track[track].foot[i - 1];
    for (int t = 0; t < track; t++) {
        const bat_foot *other = &near->track[t].foot[i - 1];
        if (other->s == from->s && other->segment == from->segment) return other + 1;
    }
    return NULL;
}

bat_status bat_intent_seed(bat_intent *intent, bat_intent_near *near) {
    bat_foot seeds[INTENT_SEEDS];
    if (near->seeds) return BAT_OK;
    if (!room_for(near, 1)) return BAT_MEMORY;
    near->seeds = find_seeds(&near->line, intent->p, seeds);
    for (int t = 0; t < near->seeds; t++) {
        near->track[t].foot[0] = seeds[t];
        near->track[t].cost = seeds[t].d * seeds[t].d;
    }
    near->done = 1;
    return BAT_OK;
}

bat_status bat_intent_feet(bat_intent *intent, bat_intent_near *near) {
    const int n = intent->places, firm = intent->firm;
    if (!room_for(near, n) || bat_intent_seed(intent, near) != BAT_OK) return BAT_MEMORY;
    double least = INFINITY;
    for (int t = 0; t < near->seeds; t++) {
        bat_feet *track = &near->track[t];
        double last = 0;
        for (int i = near->done; i < n; i++) {
            const bat_foot *from = &track->foot[i - 1], *met = met_before(near, t, i);
            track->foot[i] = met ? *met
                                 : bat_intent_foot(near, intent->p + 2 * (size_t)i, from, intent->step,
                                                   -INFINITY, INFINITY);
            last = priced(from, &track->foot[i], intent->step);
            if (i < firm) track->cost += last;
        }
        if (track->cost + last < least) least = track->cost + last, near->best = t;
    }
    if (firm > near->done) near->done = firm;
    bat_foot *foot = near->track[near->best].foot;
    const double far = INTENT_FAR * bat_intent_reach_most(intent, intent->size);
    for (int i = 0; i < n; i++)
        if (!foot[i].settled && foot[i].d < far)
            foot[i].c = bat_intent_cosine(intent, &near->line, intent->a[i], &foot[i], &foot[i].settled);
    return BAT_OK;
}
