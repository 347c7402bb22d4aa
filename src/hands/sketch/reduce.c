/* Which knots of a fit may go (docs/math sketch 5.7, step 2). Knots are removed in batches; where a batch
 * breaks the tolerance only the knots next to the failing samples are put back, so that the number of solves
 * grows with the logarithm of the length, not with it. */
#include "hands/sketch/fit_interval.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { KEEP = 0, GONE = 1, MERGED = 2 }; /* MERGED: this knot and the next become their middle */
enum { REPAIRS = 8 };
static const double work_most = 2e6;     /* some 40 ms; ordinary strokes need a tenth of it */
static const double work_missed = 2.5e5; /* less than the dense fit may take: then nothing is removed */

typedef struct reduction {
    bat_local_machine *machine;
    unsigned char *fate, *tried; /* one for each knot of best */
    int *order;
    int budget;
} reduction;

static bool affordable(const reduction *r) {
    const bat_local_machine *k = r->machine;
    return k->solves < r->budget && !bat_local_enough(k, k->missed ? work_missed : work_most);
}

static void assemble_trial(reduction *r) {
    const bat_knot_set *now = &r->machine->best;
    bat_knot_set *next = &r->machine->trial;
    next->count = 0;
    for (int i = 0; i < now->count; i++) {
        if (r->fate[i] == GONE) continue;
        next->w[next->count] = r->fate[i] == MERGED ? 0.5 * (now->w[i] + now->w[i + 1]) : now->w[i];
        next->fixed[next->count++] = now->fixed[i];
        if (r->fate[i] == MERGED) i++;
    }
}

static bool anything(const reduction *r) {
    for (int i = 0; i < r->machine->best.count; i++)
        if (r->fate[i] != KEEP) return true;
    return false;
}

/* Puts back the change nearest to w on each side. */
static void put_back(reduction *r, double w) {
    const bat_knot_set *now = &r->machine->best;
    int low = 0, high = now->count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (now->w[middle] < w)
            low = middle + 1;
        else
            high = middle;
    }
    int left = low - 1, right = low;
    while (left >= 0 && r->fate[left] == KEEP) left--;
    while (right < now->count && r->fate[right] == KEEP) right++;
    const bool has_left = left >= 0, has_right = right < now->count;
    const double a = has_left ? w - now->w[left] : INFINITY, b = has_right ? now->w[right] - w : INFINITY;
    /* The farther one only when it is about as near. */
    if (has_left && a <= 1.5 * b) r->fate[left] = KEEP, r->tried[left] = 1;
    if (has_right && b <= 1.5 * a) r->fate[right] = KEEP, r->tried[right] = 1;
}

/* Tries the fates; repairs until they hold or nothing is left of them. Returns whether best changed. */
static bool settle(reduction *r, bat_status *status) {
    bat_local_machine *k = r->machine;
    const bat_local_problem *q = k->problem;
    for (int repair = 0; repair < REPAIRS && anything(r); repair++) {
        if (!affordable(r)) return false;
        assemble_trial(r);
        const bool fine = k->trial.count >= bat_local_fewest(q) && bat_local_try(k, &k->trial, status);
        if (*status == BAT_SINGULAR) *status = BAT_OK;
        if (*status != BAT_OK) return false;
        if (fine) {
            const bat_knot_set swap = k->best;
            k->best = k->trial, k->trial = swap;
            k->holds_best = true;
            return true;
        }
        bool local = false;
        /* Only the worst sample of each failing run counts. */
        for (size_t i = 0; i < q->count;) {
            if (!bat_local_fails(k, i)) {
                i++;
                continue;
            }
            size_t worst = i;
            for (; i < q->count && bat_local_fails(k, i); i++)
                if (k->distance[i] / k->limit[i] > k->distance[worst] / k->limit[worst]) worst = i;
            put_back(r, q->w[worst]);
            local = true;
        }
        for (int i = 0; i < k->slow_count; i++) {
            put_back(r, k->slow[i]);
            local = true;
        }
        if (!local) { /* too few knots, or no solution: halve */
            bool toggle = true;
            for (int i = 0; i < k->best.count; i++)
                if (r->fate[i] != KEEP) {
                    if (toggle) r->fate[i] = KEEP, r->tried[i] = 1;
                    toggle = !toggle;
                }
        }
    }
    for (int i = 0; i < k->best.count; i++)
        if (r->fate[i] != KEEP) r->tried[i] = 1;
    return false;
}

/* After a change the marks of the knots that stay move with them. */
static void carry_marks(reduction *r, int before) {
    int n = 0;
    for (int i = 0; i < before; i++) {
        if (r->fate[i] == GONE) continue;
        const bool merged = r->fate[i] == MERGED;
        r->tried[n++] = merged ? 0 : r->tried[i];
        if (merged) i++;
    }
}

/* Brings the machine back to the state of best: ranks need its local polynomials. */
static bool rank_best(reduction *r, bat_status *status) {
    bat_local_machine *k = r->machine;
    if (!k->holds_best) bat_local_try(k, &k->best, status);
    k->holds_best = *status == BAT_OK;
    if (!k->holds_best) return false;
    bat_lsq_rank(&k->space, k->problem->dimension, k->local, k->rank);
    return true;
}

/* Stable order by rank (bottom-up merge sort: n log n, no recursion). */
static void sort_by_rank(const double *rank, int *order, int *spare, int count) {
    for (int width = 1; width < count; width *= 2) {
        for (int i = 0; i < count; i += 2 * width) {
            int a = i, b = i + width < count ? i + width : count;
            const int a_end = b, b_end = i + 2 * width < count ? i + 2 * width : count;
            for (int n = i; n < b_end; n++)
                spare[n] = a < a_end && (b >= b_end || rank[order[a]] <= rank[order[b]]) ? order[a++]
                                                                                         : order[b++];
        }
        memcpy(order, spare, (size_t)count * sizeof *order);
    }
}

/* One batch: the cheapest `share` of the untried knots, none nearer than `apart` places. */
static bool remove_batch(reduction *r, double share, int apart, bat_status *status) {
    bat_local_machine *k = r->machine;
    const int n = k->best.count;
    if (n <= bat_local_fewest(k->problem) || !affordable(r) || !rank_best(r, status)) return false;
    int candidates = 0;
    for (int i = 0; i < n; i++)
        if (!k->best.fixed[i] && !r->tried[i]) r->order[candidates++] = i;
    if (candidates == 0) return false;
    sort_by_rank(k->rank + 1, r->order, r->order + k->room, candidates);
    memset(r->fate, KEEP, (size_t)n);
    int take = (int)ceil(share * candidates), most = n - bat_local_fewest(k->problem);
    if (take > most) take = most;
    for (int c = 0; c < candidates && take > 0; c++) {
        const int i = r->order[c];
        bool clear = true;
        for (int j = i - apart; j <= i + apart && clear; j++)
            if (j >= 0 && j < n && r->fate[j] != KEEP) clear = false;
        if (!clear) continue;
        r->fate[i] = GONE;
        take--;
    }
    if (!settle(r, status)) return *status == BAT_OK;
    carry_marks(r, n);
    return true;
}

/* Neighbouring pairs into their middles, every fourth pair at once. */
static int merge_sweep(reduction *r, bat_status *status) {
    bat_local_machine *k = r->machine;
    int merged = 0;
    for (int phase = 0; phase < 4 && *status == BAT_OK; phase++) {
        const int n = k->best.count;
        if (n - 1 < bat_local_fewest(k->problem)) break;
        memset(r->fate, KEEP, (size_t)n);
        int most = n - bat_local_fewest(k->problem);
        for (int i = phase; i + 1 < n && most > 0; i += 4)
            if (!k->best.fixed[i] && !k->best.fixed[i + 1]) r->fate[i] = MERGED, most--;
        if (settle(r, status)) merged += n - k->best.count;
    }
    return merged;
}

bat_status bat_local_reduce(bat_local_machine *k) {
    const size_t n = (size_t)(k->room + 2 * k->problem->degree + 4);
    reduction r = {.machine = k};
    r.fate = calloc(n, 1);
    r.tried = calloc(n, 1);
    r.order = malloc(2 * n * sizeof *r.order);
    bat_status status = r.fate && r.tried && r.order ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        /* Batches need few solves; a scribble of thousands of knots must not take seconds. */
        r.budget = k->solves + 40 + (k->best.count < 140 ? k->best.count : 140);
        /* First cheap thirds; then each knot that failed in company once more, well apart; then pairs. */
        while (remove_batch(&r, 1.0 / 3, 1, &status) && affordable(&r)) {
        }
        for (int round = 0; round < 4 && status == BAT_OK && affordable(&r); round++) {
            const int before = k->best.count;
            memset(r.tried, 0, n);
            while (status == BAT_OK && remove_batch(&r, 1, 3, &status) && affordable(&r)) {
            }
            if (status == BAT_OK) merge_sweep(&r, &status);
            if (k->best.count == before) break;
        }
    }
    free(r.fate);
    free(r.tried);
    free(r.order);
    return status;
}
