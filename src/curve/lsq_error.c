/* Distances of samples from a curve by Newton's method, each from its own parameter. */
#include "curve/lsq.h"
#include "base/lanes.h"

#include <math.h>

/* Side by side is quicker only in registers that hold many numbers; the results are the same. */
#if !defined(__OPTIMIZE_SIZE__) && !defined(__wasm__)
#define SIDE_BY_SIDE
#endif

/* Position, and first and second derivative by s. */
static inline void horner(const double *local, const int p, const int dimension, double s, double *c0,
                          double *c1, double *c2) {
    for (int c = 0; c < dimension; c++) {
        double f = local[p * dimension + c], f1 = 0, f2 = 0;
        for (int k = p - 1; k >= 0; k--) {
            f2 = f2 * s + f1;
            f1 = f1 * s + f;
            f = f * s + local[k * dimension + c];
        }
        c0[c] = f, c1[c] = f1, c2[c] = 2 * f2;
    }
}

static double middle_of(const double *t) { return t[0] + 0.5 * (t[1] - t[0]); }

enum { NEAR = 8 }; /* slots: those farther away are not walked to */

/* The last slot that begins at v or before it. */
static inline int slot_of(const double *t, int slots, double v) {
    int low = 0;
    for (int high = slots; high - low > 1;) {
        const int between = (low + high) / 2;
        if (t[between] <= v)
            low = between;
        else
            high = between;
    }
    return low;
}

static inline double error_pass(const bat_curve *space, const int p, const int dimension, const double *local,
                                size_t count, const double *u, const double *x, int steps, double *near,
                                double *distance) {
    const double *t = space->knots + p;
    const int slots = bat_lsq_slots(space);
    const double start = t[0], end = t[slots];
    double worst = 0, middle = 0, half = 1;
    int slot = 0, prepared = -1;
    if (count > 0) slot = slot_of(t, slots, u[0]);
    for (size_t i = 0; i < count; i++) {
        const double *X = x + i * (size_t)dimension;
        double v = u[i], best = INFINITY, best_u = v;
        for (int step = 0;; step++) {
            if (v < t[slot > NEAR ? slot - NEAR : 0] || v > t[slot < slots - NEAR ? slot + NEAR : slots])
                slot = slot_of(t, slots, v);
            while (slot > 0 && v < t[slot]) slot--;
            while (slot < slots - 1 && (v >= t[slot + 1] || !(t[slot + 1] > t[slot]))) slot++;
            while (!(t[slot + 1] > t[slot])) slot--; /* only when the last slots are empty */
            if (slot != prepared) {
                middle = middle_of(t + slot), half = 0.5 * (t[slot + 1] - t[slot]);
                prepared = slot;
            }
            double c0[BAT_DIMENSION_MAX], c1[BAT_DIMENSION_MAX], c2[BAT_DIMENSION_MAX];
            horner(local + (size_t)slot * (size_t)((p + 1) * dimension), p, dimension, (v - middle) / half,
                   c0, c1, c2);
            double d = 0, g = 0, speed = 0, bend = 0;
            for (int c = 0; c < dimension; c++) {
                const double r = c0[c] - X[c];
                d += r * r, g += r * c1[c], speed += c1[c] * c1[c], bend += r * c2[c];
            }
            if (d < best) best = d, best_u = v;
            if (step >= steps || d > best) break; /* a step that leads away ends the search */
            const double h = speed + bend;
            const double move = -g / (h > 0.25 * speed ? h : speed) * half;
            if (!(fabs(move) < end - start)) break; /* also where the curve stands still */
            v += move;
            if (v < start) v = space->closed ? v + (end - start) : start;
            if (v > end) v = space->closed ? v - (end - start) : end;
        }
        if (near) near[i] = best_u;
        if (distance) distance[i] = best;
        if (!(best <= worst)) worst = best;
    }
    return worst;
}

#ifdef SIDE_BY_SIDE
enum { MANY = 64 }; /* samples at a time */

/* Samples of one slot, side by side. */
typedef struct searching {
    double v[MANY], best[MANY], best_u[MANY];
    long long going[MANY];  /* all bits or none */
    long long leaves[MANY]; /* a step went beyond the slot: what is found there does not count */
} searching;

/* One step of error_pass for all; move: whether a step follows. */
BAT_CLONES static void search_step(const double *restrict local, double middle, double half, double low,
                                   double high, double most, int count, const double *restrict x,
                                   long long move, searching *restrict all) {
    enum { P = 3, SIZE = 2 };
    double *restrict v = all->v, *restrict best = all->best, *restrict best_u = all->best_u;
    long long *restrict going = all->going, *restrict leaves = all->leaves;
    for (int i = 0; i < count; i++) {
        const double s = (v[i] - middle) / half;
        double d = 0, g = 0, speed = 0, bend = 0;
        for (int c = 0; c < SIZE; c++) {
            double f = local[P * SIZE + c], f1 = 0, f2 = 0;
            for (int k = P - 1; k >= 0; k--) {
                f2 = f2 * s + f1;
                f1 = f1 * s + f;
                f = f * s + local[k * SIZE + c];
            }
            const double r = f - x[SIZE * i + c];
            d += r * r, g += r * f1, speed += f1 * f1, bend += r * (2 * f2);
        }
        const double h = speed + bend, way = -g / (h > 0.25 * speed ? h : speed) * half, next = v[i] + way;
        const long long nearer = going[i] & -(long long)(d < best[i]);
        best_u[i] = nearer ? v[i] : best_u[i], best[i] = nearer ? d : best[i];
        const long long on = going[i] & -(long long)!(d > best[i]) & -(long long)(fabs(way) < most) & move;
        leaves[i] |= on & -(long long)!((next >= low) & (next < high));
        going[i] = on, v[i] = on ? next : v[i];
    }
}

/* How many samples from the first on lie in the slot, MANY at most. */
static int run_of(const double *t, int slot, size_t count, const double *u) {
    int n = 0;
    while (n < MANY && (size_t)n < count && u[n] >= t[slot] && u[n] < t[slot + 1]) n++;
    return n;
}

/* error_pass for a planar cubic: those samples that leave their slot are looked at one at a time. */
static double error_planar_cubic(const bat_curve *space, const double *local, size_t count, const double *u,
                                 const double *x, int steps, double *near, double *distance) {
    const double *t = space->knots + 3;
    const int slots = bat_lsq_slots(space);
    double worst = 0;
    searching all;
    for (size_t i = 0; i < count;) {
        const int slot = slot_of(t, slots, u[i]), n = run_of(t, slot, count - i, u + i), some = n > 0 ? n : 1;
        for (int k = 0; k < n; k++) {
            all.v[k] = all.best_u[k] = u[i + (size_t)k], all.best[k] = INFINITY;
            all.going[k] = -1, all.leaves[k] = 0;
        }
        for (int step = 0; step <= steps && n > 0; step++)
            search_step(local + 8 * (size_t)slot, middle_of(t + slot), 0.5 * (t[slot + 1] - t[slot]), t[slot],
                        t[slot + 1], t[slots] - t[0], n, x + 2 * i, step < steps ? -1 : 0, &all);
        for (int k = 0; k < some; k++, i++) {
            if (n == 0 || all.leaves[k])
                error_pass(space, 3, 2, local, 1, u + i, x + 2 * i, steps, all.best_u + k, all.best + k);
            if (near) near[i] = all.best_u[k];
            if (distance) distance[i] = all.best[k];
            if (!(all.best[k] <= worst)) worst = all.best[k];
        }
    }
    return worst;
}
#endif

double bat_lsq_error(const bat_curve *space, int dimension, const double *local, size_t count,
                     const double *u, const double *x, int steps, double *near, double *distance) {
#ifdef SIDE_BY_SIDE
    if (space->degree == 3 && dimension == 2 && count > 8)
        return error_planar_cubic(space, local, count, u, x, steps, near, distance);
#endif
    if (space->degree == 3 && dimension == 2)
        return error_pass(space, 3, 2, local, count, u, x, steps, near, distance);
    if (space->degree == 3 && dimension == 3)
        return error_pass(space, 3, 3, local, count, u, x, steps, near, distance);
    return error_pass(space, space->degree, dimension, local, count, u, x, steps, near, distance);
}
