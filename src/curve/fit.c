/*
 * Least-squares fit of points to a tolerance in true distance (math 5.7, without its constraints).
 *
 * Points of a spline show its knots, and even its parameters (hidden.c, pieces.c): these are tried first.
 * Parameters begin as chord length. Knots go into every failing span until all points are within tolerance;
 * then knots go out again, a third at a time, cheapest first, those that turn out to be needed put back where
 * the curve fails; then neighbouring pairs are merged. After each accepted solve, parameters follow the
 * points' projections; only then, because correction far from the curve diverges. A step that fails leaves
 * the accepted state as it was, so the result is within tolerance from the first time it is.
 */
#include <batten/fit.h>

#include "curve/banded.h"
#include "curve/fit.h"
#include "curve/hidden.h"
#include "base/options.h"
#include "curve/lsq.h"
#include "curve/pieces.h"
#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Distinct knots of the domain, both ends included; closed: the last is the first, one period on. */
typedef struct mesh {
    int count;
    double *at;
    bool *corner; /* multiplicity degree instead of 1 */
    bool *kept;   /* known to be needed */
    bool *firm;   /* was needed when knots last went, and nothing near has changed since */
} mesh;

/* What a round of removal does with a knot of the accepted mesh. */
enum plan { KEEP, DROP, MERGE /* with the next one, into their middle */ };

typedef struct fitting {
    const bat_fit_options *options;
    int degree, dimension;
    bool closed;
    size_t count;
    double *x, *u, *weight;          /* points, their parameters, half the chords beside them */
    double *near, *distance, *spare; /* of the trial: parameters of the projections, squared distances */
    mesh accepted, trial;
    int room; /* distinct knots at most */
    bat_curve space;
    double *knots, *a, *b, *border, *local, *rank, *points; /* points: of the accepted state */
    void *pieces;                                           /* room to look for them */
    size_t *first;                                          /* samples of the trial's slots */
    bat_lsq_memo memo[2];                                   /* of the last solve, and of the one before */
    bool moved;                                             /* parameters are not those of the last solve */
    int *order, *failing, *samples, *place;
    enum plan *plan;
    double tolerance, worst; /* worst: greatest distance in the accepted state */
    double mu;
    int solves, budget;
    bool plain;            /* pieces are not looked for */
    const double *ends[2]; /* the first and the last point as they were given */
    bool fits;             /* the accepted state is within tolerance */
} fitting;

/* ---- One solve ---- */

static void copy_mesh(mesh *to, const mesh *from) {
    to->count = from->count;
    memcpy(to->at, from->at, (size_t)from->count * sizeof *to->at);
    memcpy(to->corner, from->corner, (size_t)from->count * sizeof *to->corner);
    memcpy(to->kept, from->kept, (size_t)from->count * sizeof *to->kept);
    memcpy(to->firm, from->firm, (size_t)from->count * sizeof *to->firm);
}

/* The unrolled knots of a mesh, as struct bat_curve wants them. */
static void set_space(fitting *f, const mesh *m) {
    const int p = f->degree;
    double *t = f->knots;
    bat_curve *s = &f->space;
    int n = 0;
    if (!f->closed) {
        for (int i = 0; i <= p; i++) t[n++] = m->at[0];
        for (int k = 1; k + 1 < m->count; k++)
            for (int i = 0; i < (m->corner[k] ? p : 1); i++) t[n++] = m->at[k];
        for (int i = 0; i <= p; i++) t[n++] = m->at[m->count - 1];
        s->count = s->spread = n - p - 1;
    } else {
        t += p;
        for (int k = 0; k + 1 < m->count; k++)
            for (int i = 0; i < (m->corner[k] ? p : 1); i++) t[n++] = m->at[k];
        t[n] = m->at[m->count - 1];
        for (int j = -1; j >= -p; j--) t[j] = t[0] + (t[j + n] - t[n]);
        for (int j = n + 1; j <= n + p; j++) t[j] = t[n] + (t[j - n] - t[0]);
        s->count = n, s->spread = n + p;
    }
    s->degree = p, s->dimension = f->dimension, s->closed = f->closed, s->knots = f->knots, s->points = NULL;
}

/* Slot that begins at the k-th distinct knot. */
static int slot_of(const fitting *f, const mesh *m, int k) {
    int slot = 0;
    for (int i = f->closed ? 0 : 1; i <= k; i++) slot += m->corner[i] ? f->degree : 1;
    return f->closed ? slot - 1 : slot;
}

/* A ridge for knots that the points do not determine: on derivatives of orders one and two, so small that it
 * decides only what nothing else does. */
static void add_ridge(fitting *f, double strength) {
    const double length = f->knots[f->space.spread] - f->knots[f->degree];
    bat_lsq_penalty(&f->space, 1, strength * length * length, NULL, f->a);
    if (f->degree > 1)
        bat_lsq_penalty(&f->space, 2, strength * length * length * length * length, NULL, f->a);
}

/* Solves on f->trial; f->b then holds control points, f->local the local polynomials. */
static bat_status solve(fitting *f) {
    const int p = f->degree, m = f->dimension, order = p < 3 ? p : 3;
    set_space(f, &f->trial);
    bat_lsq_ranges(&f->space, f->count, f->u, f->first);
    const int n = f->space.count;
    const bat_lsq_memo last = f->memo[1];
    f->memo[1] = f->memo[0], f->memo[0] = last;
    bat_lsq_memo_fill(&f->space, m, f->first, f->u, f->x, f->weight, &f->memo[1], !f->moved, &f->memo[0]);
    f->moved = false;
    for (double ridge = 0; ridge <= 1e-4; ridge = ridge > 0 ? ridge * 1e3 : 1e-13) {
        memset(f->a, 0, (size_t)n * (size_t)(p + 1) * sizeof(double));
        memset(f->b, 0, (size_t)n * (size_t)m * sizeof(double));
        bat_lsq_memo_add(&f->space, m, &f->memo[0], f->a, f->b);
        if (f->mu > 0) bat_lsq_memo_penalty(&f->space, order, f->mu, NULL, &f->memo[0], f->a);
        if (ridge > 0) add_ridge(f, ridge);
        f->solves++;
        if (f->closed ? bat_cyclic_factor(f->a, n, p, f->border) == BAT_OK
                      : bat_banded_factor(f->a, n, p) == BAT_OK) {
            if (f->closed)
                bat_cyclic_solve(f->a, n, p, f->border, f->b, m);
            else
                bat_banded_solve(f->a, n, p, f->b, m);
            bat_lsq_memo_local(&f->space, m, &f->memo[0], f->b, f->local);
            return BAT_OK;
        }
    }
    return BAT_SINGULAR;
}

/* A corner's own point is measured at the corner itself: a spike may not overshoot. */
static double corner_error(fitting *f, double worst) {
    const mesh *m = &f->trial;
    const size_t size = (size_t)((f->degree + 1) * f->dimension);
    size_t i = 0;
    for (int k = 0, slot = f->closed ? -1 : 0; k + 1 < m->count; k++) {
        if (k > 0 || f->closed) slot += m->corner[k] ? f->degree : 1;
        if (!m->corner[k]) continue;
        while (i < f->count && f->u[i] < m->at[k]) i++;
        if (i == f->count || f->u[i] > m->at[k]) continue;
        double d = 0;
        for (int c = 0; c < f->dimension; c++) {
            double value = 0;
            for (int j = f->degree; j >= 0; j--)
                value = f->local[(size_t)slot * size + (size_t)(j * f->dimension + c)] -
                        value; /* at s = -1 */
            value -= f->x[i * (size_t)f->dimension + (size_t)c];
            d += value * value;
        }
        f->distance[i] = d;
        if (!(d <= worst)) worst = d;
    }
    return worst;
}

/* Solves and measures; the greatest distance. INFINITY when there is no solution. */
static double attempt(fitting *f) {
    if (solve(f) != BAT_OK) return INFINITY;
    double d = bat_lsq_measure(&f->space, f->dimension, f->local, f->first, f->u, f->x,
                               f->tolerance * f->tolerance, f->near, f->distance, f->spare);
    d = corner_error(f, d);
    return isfinite(d) ? sqrt(d) : INFINITY;
}

/* The trial becomes the accepted state; parameters follow when the curve is near enough. */
static void accept(fitting *f, double worst) {
    copy_mesh(&f->accepted, &f->trial);
    memcpy(f->points, f->b, (size_t)f->space.count * (size_t)f->dimension * sizeof(double));
    f->worst = worst;
    f->fits = worst <= f->tolerance;
    bat_lsq_rank(&f->space, f->dimension, f->local, f->rank);
    if (!(worst <= 4 * f->tolerance)) return;
    /* At most half way to its neighbours, so that the order stays; ends and corners stay where they are. */
    const mesh *m = &f->accepted;
    const size_t n = f->count;
    const double period = m->at[m->count - 1] - m->at[0];
    int k = 0;
    for (size_t i = 0; i < n; i++) {
        while (k + 1 < m->count && f->u[i] >= m->at[k + 1]) k++;
        double v = f->near[i];
        if (i == 0 || (i + 1 == n && !f->closed) || (m->corner[k] && f->u[i] == m->at[k]) ||
            fabs(v - f->u[i]) > 0.5 * period)
            v = f->u[i];
        const double low = i > 0 ? 0.5 * (f->u[i - 1] + f->u[i]) : v;
        const double high = i + 1 < n ? 0.5 * (f->u[i] + f->u[i + 1]) : 0.5 * (f->u[i] + m->at[m->count - 1]);
        f->spare[i] = v < low ? low : v > high ? high : v;
    }
    memcpy(f->u, f->spare, n * sizeof *f->u);
    f->moved = true;
}

/* ---- Knots in ---- */

static void insert_at(mesh *m, int k, double value) { /* becomes the k-th */
    memmove(m->at + k + 1, m->at + k, (size_t)(m->count - k) * sizeof *m->at);
    memmove(m->corner + k + 1, m->corner + k, (size_t)(m->count - k) * sizeof *m->corner);
    memmove(m->kept + k + 1, m->kept + k, (size_t)(m->count - k) * sizeof *m->kept);
    memmove(m->firm + k + 1, m->firm + k, (size_t)(m->count - k) * sizeof *m->firm);
    m->at[k] = value, m->corner[k] = m->kept[k] = m->firm[k] = false, m->count++;
}

/* Counts the samples of each span of the trial, and those that fail. */
static void find_failing(fitting *f) {
    const mesh *m = &f->trial;
    const double limit = f->tolerance * f->tolerance;
    for (int k = 0, slot = f->closed ? -1 : 0; k + 1 < m->count; k++) {
        if (k > 0 || f->closed) slot += m->corner[k] ? f->degree : 1;
        const size_t from = f->first[slot], to = f->first[slot + 1];
        int failing = 0;
        for (size_t i = from; i < to; i++) failing += !(f->distance[i] <= limit);
        f->failing[k] = failing, f->samples[k] = (int)(to - from);
    }
}

/* Halves every failing span that has enough samples for it; false when there is none. */
static bool split_failing(fitting *f) {
    mesh *m = &f->trial;
    find_failing(f);
    const double length = m->at[m->count - 1] - m->at[0];
    bool any = false;
    for (int k = m->count - 2; k >= 0; k--) {
        const double middle = 0.5 * (m->at[k] + m->at[k + 1]);
        if (!f->failing[k] || f->samples[k] < 2 || m->count >= f->room ||
            m->at[k + 1] - m->at[k] < 1e-10 * length)
            continue;
        insert_at(m, k + 1, middle);
        any = true;
    }
    return any;
}

static void grow(fitting *f) {
    double best = INFINITY;
    while (f->solves < f->budget) {
        const double worst = attempt(f);
        if (worst < best || worst <= f->tolerance) best = worst, accept(f, worst);
        if (worst <= f->tolerance) return;
        if (!isfinite(worst)) return;
        const bool finer = split_failing(f);
        /* Where knots alone no longer help, the penalty gives way (math 5.7). */
        const double wave = f->options->smoothing, length = f->trial.at[f->trial.count - 1] - f->trial.at[0];
        if (f->mu > 0 && (!finer || length / f->trial.count < 0.25 * wave))
            f->mu = f->mu > 1e-12 * length ? f->mu / 64 : 0;
        else if (!finer)
            return;
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
static void carry_out(fitting *f) {
    const mesh *from = &f->accepted;
    mesh *to = &f->trial;
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
static int take_back(fitting *f, int reach) {
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

static bool planned(const fitting *f) {
    for (int k = 0; k < f->accepted.count; k++)
        if (f->plan[k] != KEEP) return true;
    return false;
}

/* Carries the plan out as far as the tolerance lets it; what cannot be is marked as needed. */
static void carry_through(fitting *f) {
    for (int round = 0; planned(f) && f->solves < f->budget; round++) {
        carry_out(f);
        const double worst = attempt(f);
        if (worst <= f->tolerance) {
            accept(f, worst);
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
static bool make_plan(fitting *f, enum plan what, double part) {
    const mesh *m = &f->accepted;
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

static void thin(fitting *f) {
    mesh *m = &f->accepted;
    while (f->solves < f->budget && make_plan(f, DROP, 0.5)) carry_through(f);
    memcpy(m->firm, m->kept, (size_t)m->count * sizeof *m->firm);
    for (int k = 0; k < m->count; k++) m->kept[k] = false;
    while (f->solves < f->budget && make_plan(f, MERGE, 0.7)) carry_through(f);
    /* Once more where merging has changed something. */
    memcpy(m->kept, m->firm, (size_t)m->count * sizeof *m->kept);
    while (f->solves < f->budget && make_plan(f, DROP, 0.5)) carry_through(f);
}

/* ---- The whole ---- */

static const double held = 1e8; /* factor on the weight of an end that has to be met */

static const bat_fit_options DEFAULTS = {sizeof DEFAULTS, .tolerance = 1, .degree = 3};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_fit_options_init(bat_fit_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

static bat_status check(int dimension, size_t count, const double *points, const bat_fit_options *options) {
    if (!points) return BAT_ARGUMENT;
    if (dimension != 2 && dimension != 3) return BAT_DIMENSION;
    if (count < 2 || count > BAT_POINTS_MAX) return BAT_COUNT;
    if (options->degree < 1 || options->degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    if (!(options->tolerance > 0) || !(options->smoothing >= 0) || !isfinite(options->smoothing))
        return BAT_ARGUMENT;
    if (options->solves_max < 0) return BAT_ARGUMENT;
    if (options->corner_count > count) return BAT_COUNT;
    if (options->corner_count > 0 && !options->corners) return BAT_ARGUMENT;
    for (size_t i = 0; i < options->corner_count; i++)
        if (options->corners[i] < 0 || (size_t)options->corners[i] >= count ||
            (i > 0 && options->corners[i] <= options->corners[i - 1]))
            return BAT_ARGUMENT;
    for (size_t i = 0; i < count * (size_t)dimension; i++)
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return BAT_OK;
}

static void set_weights(fitting *f, double closing) {
    const size_t n = f->count;
    for (size_t i = 0; i < n; i++) {
        const double before = i > 0 ? f->u[i] - f->u[i - 1] : closing;
        const double after = i + 1 < n ? f->u[i + 1] - f->u[i] : closing;
        f->weight[i] = 0.5 * (before + after);
    }
    if (f->options->hold_ends && !f->closed) f->weight[0] *= held, f->weight[n - 1] *= held;
}

/* Takes the points over, without repeats; closed with corners: from the first corner on. Sets u, weight and
 * the first mesh. */
static bat_status take_points(fitting *f, size_t count, const double *points, const double *origin) {
    const bat_fit_options *o = f->options;
    const int m = f->dimension;
    const size_t first = f->closed && o->corner_count > 0 ? (size_t)o->corners[0] : 0;
    size_t n = 0;
    size_t corner = 0;
    int corners = 0;
    double length = 0;
    for (size_t i = 0; i < count; i++) {
        const size_t j = (first + i) % count;
        double *to = f->x + n * (size_t)m;
        for (int c = 0; c < m; c++) to[c] = points[j * (size_t)m + (size_t)c] - origin[c];
        const bool is_corner = corner < o->corner_count && (size_t)o->corners[corner] == j;
        if (is_corner) corner++;
        const double step = n > 0 ? bat_distance(to, to - m, m) : 1;
        if (n > 0 && length + step > length)
            length += step;
        else if (n > 0) { /* a repeat; a corner among them is the one that stays */
            if (is_corner && n > 1 && (corners == 0 || f->order[corners - 1] != (int)n - 1))
                f->order[corners++] = (int)n - 1;
            continue;
        }
        if (is_corner && (n > 0 || f->closed)) f->order[corners++] = (int)n;
        f->u[n++] = length;
    }
    double closing = f->closed && n > 1 ? bat_distance(f->x, f->x + (n - 1) * (size_t)m, m) : 0;
    while (f->closed && n > 1 && !(length + closing > length)) { /* the first point repeated */
        if (corners > 0 && f->order[corners - 1] == (int)n - 1) corners--;
        n--, length = f->u[n - 1], closing = bat_distance(f->x, f->x + (n - 1) * (size_t)m, m);
    }
    if (n < 2 || !(length > 0)) return BAT_COUNT;
    if (!f->closed && corners > 0 && f->order[corners - 1] == (int)n - 1) corners--;
    f->count = n;
    const double end = length + closing;
    set_weights(f, closing);
    /* Few spans at first; more come where needed, and go again. */
    mesh *t = &f->trial;
    t->count = 0;
    const double stride = end / (double)(1 + n / 40);
    const bool seam = f->closed && corners > 0; /* then the first corner is the seam */
    for (int k = seam ? 1 : 0; k <= corners; k++) {
        const double from = k == 0 ? 0 : f->u[f->order[k - 1]], to = k < corners ? f->u[f->order[k]] : end;
        int spans = (int)ceil((to - from) / stride);
        if (f->closed && !seam && spans < 4) spans = 4;
        if (spans < 1) spans = 1;
        for (int i = 0; i < spans; i++) {
            t->at[t->count] = from + (to - from) * i / spans;
            t->corner[t->count] = t->kept[t->count] = i == 0 && k > 0;
            t->firm[t->count] = false;
            t->count++;
        }
    }
    t->at[t->count] = end, t->corner[t->count] = t->firm[t->count] = false, t->kept[t->count] = true;
    t->count++;
    return BAT_OK;
}

static bat_status hand_over(fitting *f, const double *origin, bat_curve **out, bat_fit_report *report) {
    const int m = f->dimension;
    set_space(f, &f->accepted);
    const int n = f->space.count;
    const bool held_ends = f->options->hold_ends && !f->closed;
    if (held_ends) { /* all but the last digits are there already */
        memcpy(f->points, f->x, (size_t)m * sizeof *f->points);
        memcpy(f->points + (n - 1) * m, f->x + (f->count - 1) * (size_t)m, (size_t)m * sizeof *f->points);
    }
    /* The rounds only asked whether samples are within tolerance; now find how near they truly are. */
    bat_lsq_local(&f->space, m, f->points, f->local);
    const double worst = sqrt(bat_lsq_error(&f->space, m, f->local, f->count, f->u, f->x, 3, NULL, NULL));
    if (held_ends) f->worst = worst, f->fits = f->fits && worst <= f->tolerance;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < m; c++) f->points[i * m + c] += origin[c];
    for (int c = 0; c < m && held_ends; c++) { /* the difference to the origin may have been rounded */
        f->points[c] = f->ends[0][c];
        f->points[(n - 1) * m + c] = f->ends[1][c];
    }
    const double *knots = f->closed ? f->knots + f->degree : f->knots;
    const bat_status status = bat_curve_create(m, f->degree, f->closed, (size_t)n, f->points,
                                               bat_knot_total(f->degree, f->closed, n), knots, out);
    if (status != BAT_OK) return status;
    if (report) {
        /* Where a round failed by far it did not measure every sample (bat_lsq_measure). */
        report->max_error = f->fits && f->worst < worst ? f->worst : worst;
        report->knots = f->closed ? n : n - f->degree - 1;
        report->solves = f->solves;
    }
    return f->fits ? BAT_OK : BAT_TOLERANCE;
}

/* Parts of one block, in order; NULL base: only counts. */
static void *part(char *base, size_t *used, size_t count, size_t size) {
    char *at = base ? base + *used : NULL;
    *used += (count * size + 15) / 16 * 16;
    return at;
}

static size_t lay_out(fitting *f, char *base, size_t count) {
    size_t used = 0;
    const size_t p = (size_t)f->degree, m = (size_t)f->dimension, room = (size_t)f->room;
    const size_t unknowns = room + f->options->corner_count * p + 2 * p + 2,
                 wide = count > room ? count : room;
    f->x = part(base, &used, count * m, sizeof(double));
    f->u = part(base, &used, count, sizeof(double));
    f->weight = part(base, &used, count, sizeof(double));
    f->near = part(base, &used, count, sizeof(double));
    f->distance = part(base, &used, wide, sizeof(double));
    f->pieces = part(base, &used, 1, bat_hidden_pieces_work(count));
    f->spare = part(base, &used, wide, sizeof(double));
    mesh *meshes[2] = {&f->accepted, &f->trial};
    for (int i = 0; i < 2; i++) {
        meshes[i]->at = part(base, &used, room, sizeof(double));
        meshes[i]->corner = part(base, &used, room, sizeof(bool));
        meshes[i]->kept = part(base, &used, room, sizeof(bool));
        meshes[i]->firm = part(base, &used, room, sizeof(bool));
    }
    f->knots = part(base, &used, unknowns + 2 * p + 2, sizeof(double));
    f->a = part(base, &used, unknowns * (p + 1), sizeof(double));
    f->b = part(base, &used, unknowns * m, sizeof(double));
    f->points = part(base, &used, unknowns * m, sizeof(double));
    f->border = part(base, &used, f->closed ? unknowns * p + BAT_CYCLIC_DENSE : 0, sizeof(double));
    f->local = part(base, &used, (unknowns + p) * (p + 1) * m, sizeof(double));
    f->rank = part(base, &used, unknowns + p + 1, sizeof(double));
    f->first = part(base, &used, unknowns + p + 1, sizeof(size_t));
    for (int i = 0; i < 2; i++) {
        double *block = part(base, &used, bat_lsq_memo_size(f->degree, f->dimension, unknowns),
                             sizeof(double));
        if (base) bat_lsq_memo_place(&f->memo[i], f->degree, f->dimension, unknowns, block);
    }
    f->order = part(base, &used, wide, sizeof(int));
    f->failing = part(base, &used, room, sizeof(int));
    f->samples = part(base, &used, room, sizeof(int));
    f->place = part(base, &used, room, sizeof(int));
    f->plan = part(base, &used, room, sizeof(enum plan));
    return used;
}

static void reverse(double *x, size_t m, size_t from, size_t to) {
    for (; from + 1 < to; from++, to--)
        for (size_t c = 0; c < m; c++) {
            const double kept = x[from * m + c];
            x[from * m + c] = x[(to - 1) * m + c], x[(to - 1) * m + c] = kept;
        }
}

static void turn_round(double *x, size_t m, size_t n, size_t first) {
    reverse(x, m, 0, first);
    reverse(x, m, first, n);
    reverse(x, m, 0, n);
}

/* Even parameters for a closed curve whose domain begins at this knot, `at` samples from the first point. */
static void begin_at(fitting *f, double at, double step) {
    const size_t n = f->count, m = (size_t)f->dimension, first = (size_t)ceil(at);
    turn_round(f->x, m, n, first % n);
    for (size_t i = 0; i < n; i++) f->u[i] = ((double)i + ((double)first - at)) * step;
}

/* Solves with these knots, in units of samples, and even parameters; false: that is not what the points are. Closed: the
 * points are turned round. */
static bool try_hidden(fitting *f, const double *knots, size_t found) {
    const double close = 0.05; /* of the tolerance */
    const size_t n = f->count;
    if ((f->closed && found < 4) || found + 2 > (size_t)f->room) return false;
    const double step = f->u[n - 1] / (double)(n - 1), start = f->closed ? knots[0] : 0;
    if (f->closed)
        begin_at(f, start, step);
    else
        for (size_t i = 0; i < n; i++) f->u[i] = (double)i * step;
    mesh *t = &f->trial;
    const int inner = (int)found - f->closed;
    t->count = inner + 2;
    for (int k = 0; k < t->count; k++) {
        t->at[k] = k == 0 ? 0 : (knots[k - 1 + f->closed] - start) * step;
        t->corner[k] = t->firm[k] = false, t->kept[k] = k + 1 == t->count;
    }
    t->at[inner + 1] = f->closed ? (double)n * step : f->u[n - 1];
    const double worst = attempt(f);
    if (!(worst <= close * f->tolerance)) return false;
    accept(f, worst);
    return true;
}

/* Points sampled from a spline at even parameters show its knots. These are tried first, for no search finds them. */
static bool start_hidden(fitting *f, size_t count, const double *points, const double *origin) {
    const double noise = 1e-3; /* of the tolerance */
    const bat_fit_options *o = f->options;
    if (f->degree < 2 || o->corner_count > 0 || o->smoothing > 0) return false;
    bat_hidden h = {f->degree, f->dimension, f->closed, f->count, 1, f->x};
    for (size_t found; bat_hidden_knots(&h, noise * f->tolerance, f->distance, f->spare, &found);
         h.stride *= 2) {
        if (try_hidden(f, f->spare, found)) return true;
        if (take_points(f, count, points, origin) != BAT_OK) return false;
    }
    return false;
}

/* Points of a spline at parameters that nobody knows: its pieces give them, and the knots. */
static bool start_pieces(fitting *f) {
    const double noise = 1e-5; /* of the tolerance */
    const bat_fit_options *o = f->options;
    const size_t n = f->count, m = (size_t)f->dimension;
    if (f->plain || o->corner_count > 0 || o->smoothing > 0) return false;
    const bat_pieces h = {f->degree, f->dimension, f->closed, n, f->x, noise * f->tolerance};
    bat_pieced p = {.u = f->near, .knots = f->spare};
    if (!bat_hidden_pieces(&h, f->pieces, &p) || (f->closed && p.found < 4) || p.found + 2 > (size_t)f->room)
        return false;
    turn_round(f->x, m, n, p.first);
    memcpy(f->u, p.u, n * sizeof *f->u);
    mesh *t = &f->trial;
    const int inner = (int)p.found - f->closed;
    t->count = inner + 2;
    for (int k = 0; k < t->count; k++) {
        t->at[k] = k == 0 ? 0 : p.knots[k - 1 + f->closed];
        t->corner[k] = t->firm[k] = false, t->kept[k] = k + 1 == t->count;
    }
    t->at[inner + 1] = p.end;
    return true;
}

static bat_status fit_points(fitting *f, size_t count, const double *points, bat_curve **out,
                             bat_fit_report *report) {
    double origin[BAT_DIMENSION_MAX];
    memcpy(origin, points, (size_t)f->dimension * sizeof *origin);
    bat_curve *first = NULL;
    bat_fit_report reports[2];
    bat_status status = take_points(f, count, points, origin);
    if (status == BAT_OK && start_hidden(f, count, points, origin)) {
        thin(f);
        status = hand_over(f, origin, &first, &reports[0]);
    } else if (status == BAT_OK && start_pieces(f)) {
        f->mu = 0, f->worst = INFINITY, f->fits = false, f->moved = true;
        grow(f);
        if (f->fits) thin(f);
        if (f->fits) status = hand_over(f, origin, &first, &reports[0]);
    }
    if (status == BAT_OK) status = take_points(f, count, points, origin);
    if (status != BAT_OK) {
        bat_curve_free(first);
        return status;
    }
    const double wave = f->options->smoothing / (2 * BAT_PI);
    const int order = f->degree < 3 ? f->degree : 3;
    f->mu = 1; /* chord length is the parameter, so the speed is one */
    for (int i = 0; i < 2 * order; i++) f->mu *= wave;
    f->worst = INFINITY, f->fits = false, f->moved = true, f->budget += f->solves;
    grow(f);
    if (f->fits) thin(f);
    bat_curve *second = NULL;
    status = isfinite(f->worst) ? hand_over(f, origin, &second, &reports[1]) : BAT_SINGULAR;
    const bool better = first && (status != BAT_OK || bat_curve_count(first) <= bat_curve_count(second));
    if (first && status != BAT_MEMORY) status = better ? BAT_OK : status;
    if (status == BAT_OK || status == BAT_TOLERANCE) {
        *out = better ? first : second;
        if (report) *report = reports[better ? 0 : 1], report->solves = f->solves;
        bat_curve_free(better ? second : first);
    } else {
        bat_curve_free(first);
        bat_curve_free(second);
    }
    return status;
}

static bat_status fit_any(int dimension, size_t count, const double *points, const bat_fit_options *given,
                          bool plain, bat_curve **out, bat_fit_report *report) {
    if (!out) return BAT_ARGUMENT;
    bat_fit_options chosen = DEFAULTS, *options = &chosen;
    bat_status status = bat_options_read(given, LEAST, sizeof chosen, &chosen);
    if (status == BAT_OK) status = check(dimension, count, points, options);
    if (status != BAT_OK) return status;
    fitting f = {.options = options,
                 .degree = options->degree,
                 .dimension = dimension,
                 .closed = options->closed,
                 .plain = plain,
                 .ends = {points, points + (count - 1) * (size_t)dimension}};
    f.tolerance = options->tolerance, f.budget = options->solves_max > 0 ? options->solves_max : 120;
    f.worst = INFINITY;
    f.room = (int)(count + options->corner_count) + 8;
    char *block = malloc(lay_out(&f, NULL, count));
    if (!block) return BAT_MEMORY;
    lay_out(&f, block, count);
    status = fit_points(&f, count, points, out, report);
    free(block);
    return status;
}

bat_status bat_fit(int dimension, size_t count, const double *points, const bat_fit_options *options,
                   bat_curve **out, bat_fit_report *report) {
    return fit_any(dimension, count, points, options, false, out, report);
}

bat_status bat_fit_plain(int dimension, size_t count, const double *points, const bat_fit_options *options,
                         bat_curve **out, bat_fit_report *report) {
    return fit_any(dimension, count, points, options, true, out, report);
}
