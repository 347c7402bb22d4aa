/* Knots of a fit: in where it fails, out where it can do without (curve/fit.c). */
#include "curve/fitting.h"

#include <math.h>
#include <string.h>

/* Slot that begins at the k-th distinct knot. */
static int slot_of(const bat_fitting *f, const bat_fit_mesh *m, int k) {
    int slot = 0;
    for (int i = f->closed ? 0 : 1; i <= k; i++) slot += m->corner[i] ? f->degree : 1;
    return f->closed ? slot - 1 : slot;
}

/* ---- Knots in ---- */

static void set_knot(bat_fit_mesh *m, int k, double at, bool corner, bool kept) {
    m->at[k] = at, m->corner[k] = corner, m->kept[k] = kept, m->firm[k] = false;
}

/* Counts the samples of each span of the trial, and those that fail. */
static void find_failing(bat_fitting *f) {
    const bat_fit_mesh *m = &f->trial;
    const double limit = f->tolerance * f->tolerance;
    for (int k = 0, slot = f->closed ? -1 : 0; k + 1 < m->count; k++) {
        if (k > 0 || f->closed) slot += m->corner[k] ? f->degree : 1;
        const size_t from = f->first[slot], to = f->first[slot + 1];
        int failing = 0;
        for (size_t i = from; i < to; i++) failing += !(f->distance[i] <= limit);
        f->failing[k] = failing, f->samples[k] = (int)(to - from), f->from[k] = from;
    }
}

static bool can_halve(const bat_fitting *f, int k) {
    const bat_fit_mesh *m = &f->trial;
    return f->samples[k] > 1 && m->at[k + 1] - m->at[k] >= 1e-10 * (m->at[m->count - 1] - m->at[0]);
}

/* The next spans on both sides of failing ones, as many as `reach`, that can be halved count as failing, too: the
 * curve is stiff in them. */
static void pass_on(bat_fitting *f, int reach) {
    const int spans = f->trial.count - 1;
    memcpy(f->place, f->failing, (size_t)spans * sizeof *f->place);
    for (int step = 1; step >= -1; step -= 2) {
        int wanted = 0;
        for (int i = 0; i < (f->closed ? 2 * spans : spans); i++) { /* a closed curve: over its seam, too */
            const int k = step > 0 ? i % spans : spans - 1 - i % spans;
            if (f->place[k]) wanted = reach;
            if (wanted > 0 && !f->place[k] && can_halve(f, k)) f->failing[k] = 1, wanted--;
        }
    }
}

/* Halves every failing span that can be, or between the samples in its middle; false when there is none. */
static bool halve_failing(bat_fitting *f, bool between) {
    bat_fit_mesh *m = &f->trial;
    int *halved = f->place, more = 0;
    for (int k = m->count - 2; k >= 0; k--) {
        halved[k] = f->failing[k] && can_halve(f, k) && m->count + more < f->room;
        more += halved[k];
    }
    for (int k = m->count - 1, to = k + more; to > k; k--, to--) { /* to > k: something goes in before k */
        const double high = m->at[k], low = m->at[k - 1];
        m->at[to] = high, m->corner[to] = m->corner[k], m->kept[to] = m->kept[k], m->firm[to] = m->firm[k];
        if (!halved[k - 1]) continue;
        const double *u = f->u + f->from[k - 1] + f->samples[k - 1] / 2, half = 0.5 * (low + high),
                     middle = between ? 0.5 * (u[-1] + u[0]) : half;
        set_knot(m, --to, middle > low && middle < high ? middle : half, false, false);
    }
    m->count += more;
    return more > 0;
}

/* In a second try, where failing spans cannot be halved those beside them are; when it does not come to an end soon, more
 * and more of them. */
static bool split_failing(bat_fitting *f, int round) {
    const int late = 16;
    find_failing(f);
    if (!f->still) return halve_failing(f, false);
    if (round > late) pass_on(f, 1 << (round - late < 20 ? round - late : 20));
    if (halve_failing(f, round > late)) return true;
    pass_on(f, 1);
    return halve_failing(f, true);
}

void bat_fitting_grow(bat_fitting *f) {
    double best = INFINITY;
    for (int round = 0; f->solves < f->budget; round++) {
        const double worst = bat_fitting_attempt(f);
        if (worst < best || worst <= f->tolerance) best = worst, bat_fitting_accept(f, worst);
        if (worst <= f->tolerance) return;
        if (!isfinite(worst)) return;
        const bool finer = split_failing(f, round);
        /* Where knots alone no longer help, the penalty gives way (math 5.7). */
        const double wave = f->options->smoothing, length = f->trial.at[f->trial.count - 1] - f->trial.at[0];
        if (f->mu > 0 && (!finer || length / f->trial.count < 0.25 * wave))
            f->mu = f->mu > 1e-12 * length ? f->mu / 64 : 0;
        else if (!finer)
            return;
    }
}

/* Knots at these samples, or behind them where the degree is even, up to `end`. */
static void fill(bat_fitting *f, bat_fit_mesh *to, int first, int last, double end) {
    for (int i = first; i <= last; i++) {
        const double next = i + 1 < (int)f->count ? f->u[i + 1] : end,
                     at = f->degree % 2 ? f->u[i] : 0.5 * (f->u[i] + next);
        if (at > to->at[to->count - 1] && at < end) set_knot(to, to->count++, at, false, false);
    }
}

void bat_fitting_fill(bat_fitting *f) {
    const bat_fit_mesh from = f->trial, to = f->accepted;
    const int p = f->degree, n = (int)f->count;
    const bool ring = f->closed && !from.corner[0];
    f->trial = to, f->accepted = from, f->trial.count = 0;
    set_knot(&f->trial, f->trial.count++, from.at[0], from.corner[0], from.corner[0]);
    for (int k = 1, first = 0, last = 0; k < from.count; k++) { /* to corners and the end */
        const double end = from.at[k];
        if (!from.corner[k] && k + 1 < from.count) continue;
        while (last < n && f->u[last] < end) last++;
        if (ring)
            fill(f, &f->trial, 1, n - 1, end);
        else
            fill(f, &f->trial, first + (p + 1) / 2, last - (p + 2) / 2, end);
        set_knot(&f->trial, f->trial.count++, end, from.corner[k], true);
        first = last;
    }
}

/* ---- Knots out ---- */

/* Shell sort of indices by key, ties by index: the same everywhere. */
static void sort_by(int *order, int count, const double *key) {
    for (int gap = count / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11)
        for (int i = gap; i < count; i++) {
            const int item = order[i];
            int j = i;
            for (; j >= gap && (key[order[j - gap]] > key[item] ||
                                (key[order[j - gap]] == key[item] && order[j - gap] > item));
                 j -= gap)
                order[j] = order[j - gap];
            order[j] = item;
        }
}

/* The trial mesh that the plan makes of the accepted one; place[k]: the trial span in which a knot that
 * goes lay. */
static void carry_out(bat_fitting *f) {
    const bat_fit_mesh *from = &f->accepted;
    bat_fit_mesh *to = &f->trial;
    int n = 0;
    for (int k = 0; k < from->count; k++) {
        f->place[k] = n - 1;
        if (f->plan[k] == DROP) continue;
        to->at[n] = from->at[k], to->corner[n] = from->corner[k], to->kept[n] = from->kept[k];
        to->firm[n] = from->firm[k];
        for (int d = -2; d <= 3 && to->firm[n]; d++)
            if (k + d >= 0 && k + d < from->count && f->plan[k + d] == MERGE) to->firm[n] = false;
        if (f->plan[k] == MERGE) to->at[n] = 0.5 * (from->at[k] + from->at[k + 1]), k++, f->place[k] = n - 1;
        n++;
    }
    to->count = n;
}

/* Takes back what was planned near failing spans, and marks it as needed. Returns how much was taken back. */
static int take_back(bat_fitting *f, int reach) {
    const int spans = f->trial.count - 1;
    int count = 0;
    for (int k = 0; k < f->accepted.count; k++) {
        if (f->plan[k] == KEEP) continue;
        bool near = false;
        for (int d = -reach; d <= reach + (f->plan[k] == MERGE); d++) {
            int span = f->place[k] + d;
            if (f->closed) span = (span % spans + spans) % spans;
            if (span >= 0 && span < spans && f->failing[span]) near = true;
        }
        if (near) f->plan[k] = KEEP, f->accepted.kept[k] = true, count++;
    }
    return count;
}

static bool planned(const bat_fitting *f) {
    for (int k = 0; k < f->accepted.count; k++)
        if (f->plan[k] != KEEP) return true;
    return false;
}

/* Carries the plan out as far as the tolerance lets it; what cannot be is marked as needed. */
static void carry_through(bat_fitting *f) {
    for (int round = 0; planned(f) && f->solves < f->budget; round++) {
        carry_out(f);
        const double worst = bat_fitting_attempt(f);
        if (worst <= f->tolerance) {
            bat_fitting_accept(f, worst);
            return;
        }
        int back = 0;
        if (isfinite(worst) && round < 4) {
            find_failing(f);
            for (int reach = round > 1 ? 2 : 1; back == 0 && reach < 8; reach *= 2)
                back = take_back(f, reach);
        }
        if (back == 0) { /* no cause found: all of it */
            for (int k = 0; k < f->accepted.count; k++)
                if (f->plan[k] != KEEP) f->accepted.kept[k] = true, f->plan[k] = KEEP;
            return;
        }
    }
}

/* A plan for at most the share `part` of the knots that may go, cheapest first, never two neighbours. False:
 * nothing left. */
static bool make_plan(bat_fitting *f, enum bat_fit_plan what, double part) {
    const bat_fit_mesh *m = &f->accepted;
    const int last = m->count - 1, least = f->closed ? 4 : 2; /* a closed curve keeps a few knots */
    int candidates = 0;
    double *cost = f->spare; /* room for every knot: see bat_fit */
    for (int k = 0; k < m->count; k++) f->plan[k] = KEEP;
    for (int k = 1, slot = slot_of(f, m, 0); k < last; k++) {
        slot += m->corner[k] ? f->degree : 1;
        cost[k] = f->rank[slot];
    }
    for (int k = 1; k < last; k++) {
        if (m->corner[k] || m->kept[k]) continue;
        if (what == MERGE) {
            if (k + 1 >= last || m->corner[k + 1]) continue;
            const double h = m->at[k + 1] - m->at[k];
            /* near and weak ones first */
            f->distance[k] = (cost[k] + cost[k + 1]) * h;
        } else {
            f->distance[k] = cost[k];
        }
        f->order[candidates++] = k;
    }
    if (candidates == 0) return false;
    sort_by(f->order, candidates, f->distance);
    int most = (int)(part * candidates);
    if (most < 3) most = 3;
    if (most > m->count - least) most = m->count - least;
    const int reach = what == MERGE ? 2 : 1;
    bool any = false;
    for (int i = 0; i < candidates && most > 0; i++) {
        const int k = f->order[i];
        bool free = true;
        for (int d = -reach; d <= reach; d++)
            if (k + d >= 0 && k + d < m->count && f->plan[k + d] != KEEP) free = false;
        if (!free) continue;
        f->plan[k] = what, any = true, most--;
    }
    return any;
}

void bat_fitting_thin(bat_fitting *f) {
    bat_fit_mesh *m = &f->accepted;
    while (f->solves < f->budget && make_plan(f, DROP, 0.5)) carry_through(f);
    memcpy(m->firm, m->kept, (size_t)m->count * sizeof *m->firm);
    for (int k = 0; k < m->count; k++) m->kept[k] = false;
    while (f->solves < f->budget && make_plan(f, MERGE, 0.7)) carry_through(f);
    /* Once more where merging has changed something. */
    memcpy(m->kept, m->firm, (size_t)m->count * sizeof *m->kept);
    while (f->solves < f->budget && make_plan(f, DROP, 0.5)) carry_through(f);
}
