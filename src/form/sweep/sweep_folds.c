/* Where a sweep folds over: the factor 1 + x alpha + y beta is linear in the profile, so at each u its least value
 * is that of the profile's point that lies farthest the other way. */
#include "form/sweep/sweep.h"

#include <math.h>
#include <stdlib.h>

enum { AROUND = 16, ALONG = 16, HALVINGS = 60 }; /* samples of a span of the profile, of the path */

typedef struct folding {
    const bat_sweep *sweep;
    int count;
    double *v, *points; /* of the profile */
} folding;

static double along(const bat_curve *profile, double v, double alpha, double beta) {
    double at[2];
    bat_curve_eval(profile, v, 0, at);
    return alpha * at[0] + beta * at[1];
}

/* The least of a function between two places, which has one minimum there. */
static double least_of(const folding *f, double a, double b, double alpha, double beta) {
    for (int k = 0; k < HALVINGS; k++) {
        const double x = a + (b - a) / 3, y = b - (b - a) / 3;
        if (along(f->sweep->profile, x, alpha, beta) < along(f->sweep->profile, y, alpha, beta))
            b = y;
        else
            a = x;
    }
    return along(f->sweep->profile, 0.5 * (a + b), alpha, beta);
}

/* The least factor at u. */
static double least_factor(const folding *f, double u) {
    bat_sweep_jet j;
    bat_sweep_jet_at(f->sweep, u, &j);
    if (!(j.speed > 0)) return 1;
    const double alpha = vec_dot(j.a1, j.t) / j.speed, beta = vec_dot(j.b1, j.t) / j.speed;
    int best = 0;
    double least = INFINITY;
    for (int i = 0; i < f->count; i++) {
        const double here = alpha * f->points[2 * i] + beta * f->points[2 * i + 1];
        if (here < least) least = here, best = i;
    }
    const double low = f->v[best > 0 ? best - 1 : 0], high = f->v[best + 1 < f->count ? best + 1 : best];
    return 1 + fmin(least, least_of(f, low, high, alpha, beta));
}

/* Samples of every span of a curve, its ends included. Returns how many; 0: no memory. */
static int spread(const bat_curve *curve, int each, double **out) {
    const int p = curve->degree;
    int count = 0;
    *out = malloc(((size_t)(curve->spread - p) * (size_t)each + 1) * sizeof **out);
    if (!*out) return 0;
    for (int i = p; i < curve->spread; i++) {
        const double low = curve->knots[i], high = curve->knots[i + 1];
        for (int k = 0; k < each && low < high; k++) (*out)[count++] = low + (high - low) * k / each;
    }
    (*out)[count++] = curve->knots[curve->spread];
    return count;
}

/* The sign change between a place where the factor is not below 0 and one where it is. */
static double boundary(const folding *f, double good, double folded) {
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = good + 0.5 * (folded - good);
        if (least_factor(f, middle) < 0)
            folded = middle;
        else
            good = middle;
    }
    return folded;
}

/* The place of the least factor between a and b; it has one minimum there. */
static double deepest(const folding *f, double a, double b) {
    for (int k = 0; k < HALVINGS; k++) {
        const double x = a + (b - a) / 3, y = b - (b - a) / 3;
        if (least_factor(f, x) < least_factor(f, y))
            b = y;
        else
            a = x;
    }
    return 0.5 * (a + b);
}

typedef struct found {
    size_t room, count;
    double *out;
} found;

static void add(found *f, double from, double to) {
    if (f->count < f->room) f->out[2 * f->count] = from, f->out[2 * f->count + 1] = to;
    f->count++;
}

/* Walks along the samples: intervals begin and end where the sign changes; a dip between two samples counts, too. */
static void walk(const folding *f, int count, const double *u, const double *value, found *out) {
    double from = u[0];
    bool folded = value[0] < 0;
    for (int i = 1; i < count; i++) {
        const bool now = value[i] < 0;
        if (now && !folded) from = boundary(f, u[i - 1], u[i]);
        if (!now && folded) add(out, from, boundary(f, u[i], u[i - 1]));
        folded = now;
        if (now || i + 1 == count || !(value[i] < value[i - 1] && value[i] <= value[i + 1])) continue;
        const double deep = deepest(f, u[i - 1], u[i + 1]);
        if (value[i + 1] >= 0 && least_factor(f, deep) < 0)
            add(out, boundary(f, u[i - 1], deep), boundary(f, u[i + 1], deep));
    }
    if (folded) add(out, from, u[count - 1]);
}

bat_status bat_sweep_folds(const bat_sweep *sweep, size_t room, double *out, size_t *count) {
    if (!sweep || !count || (room > 0 && !out)) return BAT_ARGUMENT;
    folding f = {.sweep = sweep};
    double *u = NULL, *value = NULL;
    found all = {.room = room, .out = out};
    f.count = spread(sweep->profile, AROUND, &f.v);
    const int steps = f.count > 0 ? spread(sweep->path, ALONG, &u) : 0;
    f.points = malloc(2 * ((size_t)f.count + 1) * sizeof *f.points);
    value = malloc(((size_t)steps + 1) * sizeof *value);
    const bool kept = f.points && value && steps > 0;
    for (int i = 0; i < f.count && kept; i++) bat_curve_eval(sweep->profile, f.v[i], 0, f.points + 2 * i);
    for (int i = 0; i < steps && kept; i++) value[i] = least_factor(&f, u[i]);
    if (kept) walk(&f, steps, u, value, &all);
    free(f.v), free(f.points), free(u), free(value);
    if (kept) *count = all.count;
    return kept ? BAT_OK : BAT_MEMORY;
}
