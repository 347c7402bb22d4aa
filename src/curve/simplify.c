/*
 * Fewer knots within a tolerance. Rounds, each with a higher price limit: every knot's removal is priced, and
 * the cheapest are taken whose windows do not meet. Each span remembers how far it may have moved by now (the
 * sum of the bounds: the triangle inequality), which must stay within the tolerance. Now and then the sum is
 * replaced by a measurement: the curve refined to the original knots has control points as far from the
 * original ones as the curves can be apart at most. Cost O(n log n) a round, about twenty rounds.
 */
#include "curve/remove.h"

#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool bat_curve_corner_at(const bat_curve *curve, int r, double angle) {
    int p = curve->degree, size = curve->dimension;
    const double *at = curve->points + (size_t)(r - p) * (size_t)size, *side[2] = {at, at};
    for (int k = 0; k < 2; k++)
        for (int i = 1; i <= p && bat_distance(side[k], at, size) == 0; i++) {
            int j = r - p + (k == 0 ? -i : i);
            if (curve->closed) /* stored points repeat with the period */
                j = j < 0 ? j + curve->count : j >= curve->spread ? j - curve->count : j;
            if (j < 0 || j >= curve->spread) break;
            side[k] = curve->points + (size_t)j * (size_t)size;
        }
    return bat_turn(side[0], at, side[1], size) > angle;
}

typedef struct work {
    const bat_curve *original; /* seam gathered */
    bat_curve *now;
    double tolerance;
    double *moved;      /* by interval i, between the user's knots i and i + 1: bound on the distance */
    bool *corner;       /* by knot: must stay */
    bool *busy;         /* by knot: in the window of a removal of this round */
    bat_removal *plans; /* room for one a knot */
} work;

static int by_bound(const void *a, const void *b) {
    const bat_removal *x = a, *y = b;
    if (x->bound != y->bound) return x->bound < y->bound ? -1 : 1;
    return (x->r > y->r) - (x->r < y->r);
}

/* Index of an interval or knot; closed curves wrap. -1 when outside. */
static int wrap(const bat_curve *curve, int i) {
    int n = curve->closed ? curve->count : bat_curve_knot_count(curve);
    if (curve->closed) return (i % n + n) % n;
    return i >= 0 && i < n ? i : -1;
}

static double moved_near(const work *w, int r, int s) {
    double most = 0;
    for (int i = r - w->now->degree; i <= r - s + w->now->degree; i++) {
        int j = wrap(w->now, i);
        if (j >= 0) most = fmax(most, w->moved[j]);
    }
    return most;
}

/* Plans of all knots that cost at most `limit` and stay within the tolerance; returns how many. */
static int plan_all(work *w, double limit) {
    const bat_curve *now = w->now;
    const double *t = bat_curve_knots(now);
    int p = now->degree, found = 0, first = now->closed ? 0 : p + 1, last = now->count - 1;
    for (int r = first; r <= last;) {
        int s = 1;
        while (r + 1 <= last && t[r + 1] == t[r]) r++, s++;
        bool seam = now->closed && r - s < 0;
        if (!w->corner[r] && !(seam && s == 1) && bat_removal_fits(now, s)) {
            bat_removal *plan = &w->plans[found];
            bat_removal_plan(now, r, s, plan);
            if (plan->bound <= limit && moved_near(w, r, s) + plan->bound <= w->tolerance) found++;
        }
        r++;
    }
    return found;
}

/* Keeps the plans whose windows do not meet, cheapest first; returns how many. */
static int choose(work *w, int count) {
    const bat_curve *now = w->now;
    int p = now->degree, kept = 0, least = now->closed ? now->degree + 3 : 0;
    qsort(w->plans, (size_t)count, sizeof(bat_removal), by_bound); /* no ties */
    memset(w->busy, 0, (size_t)bat_curve_knot_count(now) * sizeof(bool));
    for (int k = 0; k < count; k++) {
        int r = w->plans[k].r;
        bool free_here = kept == 0 || now->count - kept > least;
        for (int i = r - p - 1; i <= r + p + 1 && free_here; i++) {
            int j = wrap(now, i);
            if (j >= 0 && w->busy[j]) free_here = false;
        }
        if (!free_here) continue;
        for (int i = r - p - 1; i <= r + p + 1; i++) {
            int j = wrap(now, i);
            if (j >= 0) w->busy[j] = true;
        }
        w->plans[kept++] = w->plans[k];
    }
    return kept;
}

/* A removal adds its bound to the spans it reaches; then knot r goes, and its two intervals become one. */
static bat_status carry_out(work *w, int count) {
    bat_curve *now = w->now, *next;
    int p = now->degree, knots = bat_curve_knot_count(now);
    bat_status status = bat_removal_apply(now, count, w->plans, &next);
    if (status != BAT_OK) return status;
    memset(w->busy, 0, (size_t)knots * sizeof(bool));
    for (int k = 0; k < count; k++) {
        int r = w->plans[k].r, s = w->plans[k].s;
        for (int i = r - p; i <= r - s + p; i++) {
            int j = wrap(now, i);
            /* Each interval once, when the window is longer than the period. */
            if (j >= 0 && (!now->closed || i < r - p + now->count)) w->moved[j] += w->plans[k].bound;
        }
        w->busy[r] = true;
    }
    int to = 0;
    for (int i = 0; i < knots; i++) {
        if (w->busy[i] && to > 0) {
            w->moved[to - 1] = fmax(w->moved[to - 1], w->moved[i]);
        } else {
            w->moved[to] = w->moved[i], w->corner[to++] = w->corner[i];
        }
    }
    bat_curve_free(now);
    w->now = next;
    return BAT_OK;
}

/* Replaces the sums by the distance of control points over the original knots; *worst is the largest. */
static bat_status measure(work *w, double *worst) {
    const bat_curve *original = w->original, *now = w->now;
    bat_curve *fine;
    bat_status status = bat_curve_refine(now, bat_curve_knot_count(original), bat_curve_knots(original),
                                         &fine);
    if (status != BAT_OK) return status;
    int p = now->degree, size = now->dimension, interval = now->closed ? now->degree : 0,
        spread = original->spread;
    int offset = interval;
    *worst = 0;
    int knots = bat_curve_knot_count(now);
    for (int i = 0; i < knots; i++) w->moved[i] = 0;
    for (int span = p; span < spread; span++) {
        while (interval + 1 < now->spread + p && now->knots[interval + 1] <= original->knots[span])
            interval++;
        double most = 0;
        for (int i = span - p; i <= span; i++) {
            size_t k = (size_t)i * (size_t)size;
            most = fmax(most, bat_distance(fine->points + k, original->points + k, size));
        }
        int j = interval - offset;
        if (j >= 0 && j < knots) w->moved[j] = fmax(w->moved[j], most);
        *worst = fmax(*worst, most);
    }
    bat_curve_free(fine);
    return BAT_OK;
}

static bat_status run(work *w, double *error) {
    bat_status status = BAT_OK;
    bool measured = true;
    int halvings = 6;
    for (;;) {
        int count = choose(w, plan_all(w, ldexp(w->tolerance, -halvings)));
        if (count > 0) {
            status = carry_out(w, count);
            measured = false;
        } else if (halvings > 0) {
            halvings--;
        } else if (!measured) {
            status = measure(w, error); /* tighter than the sums: perhaps there is room again */
            measured = true;
        } else {
            return BAT_OK;
        }
        if (status != BAT_OK) return status;
    }
}

bat_status bat_curve_simplify(const bat_curve *curve, double tolerance, double corner, bat_curve **out,
                              double *error) {
    if (!curve || !out || !(tolerance >= 0) || !(corner >= 0)) return BAT_ARGUMENT;
    bat_curve *original;
    bat_status status = bat_curve_gather_seam(curve, &original);
    if (status != BAT_OK) return status;
    size_t knots = (size_t)bat_curve_knot_count(curve);
    work w = {.original = original, .tolerance = tolerance};
    w.moved = calloc(knots + 1, sizeof(double));
    w.corner = calloc(knots, sizeof(bool));
    w.busy = calloc(knots, sizeof(bool));
    w.plans = malloc(knots * sizeof(bat_removal));
    double worst = 0;
    status = w.moved && w.corner && w.busy && w.plans ? bat_curve_copy(original, &w.now) : BAT_MEMORY;
    if (status == BAT_OK) {
        const double *t = bat_curve_knots(original);
        int p = original->degree, stored = original->closed ? p : 0;
        for (int i = 0; i < (int)knots;) {
            int s = 1;
            while (i + s < (int)knots && t[i + s] == t[i]) s++;
            bool inside = original->closed ? i + s <= original->count : i > p && i + s <= original->count;
            bool sharp = inside && s >= p && bat_curve_corner_at(original, i + s - 1 + stored, corner);
            for (int k = 0; k < s; k++) w.corner[i + k] = sharp;
            i += s;
        }
        status = run(&w, &worst);
    }
    if (status == BAT_OK) {
        if (w.now->count == curve->count) { /* nothing went: the curve as it was */
            bat_curve *same;
            status = bat_curve_copy(curve, &same);
            if (status == BAT_OK) *out = same;
            bat_curve_free(w.now);
        } else {
            *out = w.now;
        }
        if (status == BAT_OK && error) *error = worst;
    } else {
        bat_curve_free(w.now);
    }
    free(w.moved), free(w.corner), free(w.busy), free(w.plans);
    bat_curve_free(original);
    return status;
}
