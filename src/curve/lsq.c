/* Normal equations of spline fits by moments: in one slot the samples enter only through sum w s^k and
 * sum w s^k X, so that the work per sample is a handful of multiply-adds whatever the basis. The coordinate s
 * runs from -1 to 1, which keeps the moments well scaled up to degree 7. */
#include "curve/lsq.h"
#include "base/lanes.h"

#include <math.h>
#include <string.h>

enum { ORDERS = BAT_DEGREE_MAX + 1 };

static double middle_of(const double *t) { return t[0] + 0.5 * (t[1] - t[0]); }

/* Cox-de Boor with polynomials instead of numbers (see bat_basis). t: knots + span. */
static inline void transform(const double *t, const int p, double *out) {
    const double middle = middle_of(t), half = 0.5 * (t[1] - t[0]);
    double row[ORDERS][ORDERS]; /* row[j][k]: coefficient of s^k of the j-th function */
    row[0][0] = 1;
    for (int q = 1; q <= p; q++) {
        double saved[ORDERS] = {0};
        for (int j = 0; j < q; j++) {
            const double right = t[j + 1], left = t[j + 1 - q];
            const double inverse = 1 / (right - left);
            const double fall = (right - middle) * inverse, rise = (middle - left) * inverse;
            const double slope = half * inverse;
            double old[ORDERS + 1];
            for (int k = 0; k < q; k++) old[k] = row[j][k];
            row[j][0] = saved[0] + fall * old[0];
            for (int k = 1; k < q; k++) row[j][k] = saved[k] + fall * old[k] - slope * old[k - 1];
            row[j][q] = saved[q] - slope * old[q - 1];
            saved[0] = rise * old[0];
            for (int k = 1; k < q; k++) saved[k] = rise * old[k] + slope * old[k - 1];
            saved[q] = slope * old[q - 1];
        }
        for (int k = 0; k <= q; k++) row[q][k] = saved[k];
    }
    for (int k = 0; k <= p; k++)
        for (int j = 0; j <= p; j++) out[k * (p + 1) + j] = row[j][k];
}

void bat_lsq_transform(const bat_curve *space, int slot, double *out) {
    const double *t = space->knots + space->degree + slot;
    if (space->degree == 3) /* the usual case, unrolled */
        transform(t, 3, out);
    else
        transform(t, space->degree, out);
}

void bat_lsq_ranges(const bat_curve *space, size_t count, const double *u, size_t *first) {
    const int slots = bat_lsq_slots(space);
    const double *t = space->knots + space->degree;
    size_t i = 0;
    for (int s = 0; s < slots; s++) {
        first[s] = i;
        if (t[s + 1] > t[s])
            while (i < count && u[i] < t[s + 1]) i++;
    }
    /* What lies at the end of the domain belongs to the last non-empty slot. */
    int s = slots;
    first[s--] = count;
    while (s > 0 && !(t[s + 1] > t[s])) first[s--] = count;
}

BAT_INLINE void moments_of(const int p, const int dimension, double middle, double inverse, size_t count,
                           const double *u, const double *x, const double *weight, double *out) {
    double m[2 * BAT_DEGREE_MAX + 1] = {0}, v[ORDERS * BAT_DIMENSION_MAX] = {0};
    for (size_t i = 0; i < count; i++) {
        const double s = (u[i] - middle) * inverse;
        double power = weight ? weight[i] : 1;
        for (int k = 0; k <= p; k++) {
            m[k] += power;
            for (int c = 0; c < dimension; c++)
                v[k * dimension + c] += power * x[i * (size_t)dimension + (size_t)c];
            power *= s;
        }
        for (int k = p + 1; k <= 2 * p; k++) {
            m[k] += power;
            power *= s;
        }
    }
    memcpy(out, m, (size_t)(2 * p + 1) * sizeof *out);
    memcpy(out + 2 * p + 1, v, (size_t)((p + 1) * dimension) * sizeof *out);
}

void bat_lsq_moments(const bat_curve *space, int slot, int dimension, size_t count, const double *u,
                     const double *x, const double *weight, double *out) {
    const double *t = space->knots + space->degree + slot;
    const double middle = middle_of(t), inverse = 2 / (t[1] - t[0]);
    if (space->degree == 3 && dimension == 2)
        moments_of(3, 2, middle, inverse, count, u, x, weight, out);
    else
        moments_of(space->degree, dimension, middle, inverse, count, u, x, weight, out);
}

/* a += T^T H T, where H(k, l) = m[k + l], functions of this slot only. */
static inline void add_gram(const bat_curve *space, int slot, const int p, const double *T, const int rows,
                            const double *m, double *a) {
    double ht[ORDERS * ORDERS];
    const int w = p + 1;
    for (int k = 0; k < rows; k++)
        for (int j = 0; j < w; j++) {
            double sum = 0;
            for (int l = 0; l < rows; l++) sum += m[k + l] * T[l * w + j];
            ht[k * w + j] = sum;
        }
    for (int r = 0; r < w; r++) {
        double *row = a + (size_t)bat_lsq_unknown(space, slot + r) * (size_t)w;
        for (int s = 0; s <= r; s++) {
            double sum = 0;
            for (int k = 0; k < rows; k++) sum += T[k * w + r] * ht[k * w + s];
            row[r - s] += sum;
        }
    }
}

static inline void add(const bat_curve *space, int slot, const int p, const int dimension, const double *T,
                       const double *moments, double *a, double *b) {
    const double *v = moments + 2 * p + 1;
    const int w = p + 1;
    add_gram(space, slot, p, T, w, moments, a);
    for (int r = 0; r < w; r++) {
        double *row = b + (size_t)bat_lsq_unknown(space, slot + r) * (size_t)dimension;
        for (int k = 0; k < w; k++)
            for (int c = 0; c < dimension; c++) row[c] += T[k * w + r] * v[k * dimension + c];
    }
}

void bat_lsq_add(const bat_curve *space, int slot, int dimension, const double *T, const double *moments,
                 double *a, double *b) {
    if (space->degree == 3 && dimension == 2)
        add(space, slot, 3, 2, T, moments, a, b);
    else
        add(space, slot, space->degree, dimension, T, moments, a, b);
}

void bat_lsq_assemble(const bat_curve *space, int dimension, size_t count, const double *u, const double *x,
                      const double *weight, double *a, double *b) {
    const double *t = space->knots + space->degree;
    const int slots = bat_lsq_slots(space);
    int last = slots - 1;
    while (last > 0 && !(t[last + 1] > t[last])) last--;
    size_t from = 0;
    for (int s = 0; s <= last; s++) {
        if (!(t[s + 1] > t[s])) continue;
        size_t to = from;
        if (s == last)
            to = count;
        else
            while (to < count && u[to] < t[s + 1]) to++;
        if (to == from) continue;
        double T[ORDERS * ORDERS], moments[2 * BAT_DEGREE_MAX + 1 + ORDERS * BAT_DIMENSION_MAX];
        bat_lsq_transform(space, s, T);
        bat_lsq_moments(space, s, dimension, to - from, u + from, x + from * (size_t)dimension,
                        weight ? weight + from : NULL, moments);
        bat_lsq_add(space, s, dimension, T, moments, a, b);
        from = to;
    }
}

/* transforms: one per slot, or NULL. */
static void add_penalty(const bat_curve *space, int order, double mu, const double *factor,
                        const double *transforms, double *a) {
    const int p = space->degree, w = p + 1, rows = w - order;
    const double *t = space->knots + p;
    for (int s = 0; s < bat_lsq_slots(space); s++) {
        if (!(t[s + 1] > t[s])) continue;
        const double half = 0.5 * (t[s + 1] - t[s]);
        double own[ORDERS * ORDERS], D[ORDERS * ORDERS], m[2 * BAT_DEGREE_MAX + 1];
        const double *T = transforms ? transforms + (size_t)s * (size_t)(w * w) : own;
        if (!transforms) bat_lsq_transform(space, s, own);
        for (int k = 0; k < rows; k++) {
            double f = 1; /* (k + order)! / k! / half^order */
            for (int i = 1; i <= order; i++) f *= (k + i) / half;
            for (int j = 0; j < w; j++) D[k * w + j] = f * T[(k + order) * w + j];
        }
        for (int k = 0; k <= 2 * (rows - 1); k++)
            m[k] = k % 2 ? 0 : 2.0 / (k + 1) * half * mu * (factor ? factor[s] : 1);
        if (p == 3 && rows == 1)
            add_gram(space, s, 3, D, 1, m, a);
        else
            add_gram(space, s, p, D, rows, m, a);
    }
}

void bat_lsq_penalty(const bat_curve *space, int order, double mu, const double *factor, double *a) {
    add_penalty(space, order, mu, factor, NULL, a);
}

static inline void local_of(const bat_curve *space, int slot, const int p, const int dimension,
                            const double *T, const double *points, double *local) {
    const int w = p + 1;
    const double *P[ORDERS];
    for (int j = 0; j < w; j++) P[j] = points + (size_t)bat_lsq_unknown(space, slot + j) * (size_t)dimension;
    for (int k = 0; k < w; k++)
        for (int c = 0; c < dimension; c++) {
            double sum = 0;
            for (int j = 0; j < w; j++) sum += T[k * w + j] * P[j][c];
            local[k * dimension + c] = sum;
        }
}

static void find_local(const bat_curve *space, int dimension, const double *points, const double *transforms,
                       double *local) {
    const int p = space->degree, w = p + 1;
    const double *t = space->knots + p;
    for (int s = 0; s < bat_lsq_slots(space); s++, local += w * dimension) {
        if (!(t[s + 1] > t[s])) continue;
        double own[ORDERS * ORDERS];
        const double *T = transforms ? transforms + (size_t)s * (size_t)(w * w) : own;
        if (!transforms) bat_lsq_transform(space, s, own);
        if (p == 3 && dimension == 2)
            local_of(space, s, 3, 2, T, points, local);
        else
            local_of(space, s, p, dimension, T, points, local);
    }
}

void bat_lsq_local(const bat_curve *space, int dimension, const double *points, double *local) {
    find_local(space, dimension, points, NULL, local);
}

/* ---- What one solve leaves to the next ---- */

static size_t gram_size(int degree, int dimension) {
    const size_t w = (size_t)degree + 1;
    return w * (w + 1) / 2 + w * (size_t)dimension;
}

size_t bat_lsq_memo_size(int degree, int dimension, size_t slots) {
    const size_t w = (size_t)degree + 1;
    return slots * (1 + w * w + bat_lsq_moment_size(degree, dimension) + gram_size(degree, dimension)) +
           2 * w;
}

void bat_lsq_memo_place(bat_lsq_memo *memo, int degree, int dimension, size_t slots, double *block) {
    const size_t w = (size_t)degree + 1;
    memo->slots = 0;
    memo->knots = block;
    memo->transforms = memo->knots + slots + 2 * w;
    memo->moments = memo->transforms + slots * w * w;
    memo->grams = memo->moments + slots * bat_lsq_moment_size(degree, dimension);
}

void bat_lsq_memo_fill(const bat_curve *space, int dimension, const size_t *first, const double *u,
                       const double *x, const double *weight, const bat_lsq_memo *old, bool same_samples,
                       bat_lsq_memo *now) {
    const int p = space->degree, w = p + 1, slots = bat_lsq_slots(space);
    const size_t moment_size = bat_lsq_moment_size(p, dimension), gram = gram_size(p, dimension);
    const size_t corner = (size_t)(w * w);
    const double *t = space->knots + p, *before = old->knots + p;
    memcpy(now->knots, space->knots, (size_t)(slots + 2 * p + 1) * sizeof *t);
    now->slots = slots;
    int o = 0;
    for (int s = 0; s < slots; s++) {
        if (!(t[s + 1] > t[s])) continue;
        while (o < old->slots && before[o + 1] <= t[s]) o++;
        double *T = now->transforms + (size_t)s * corner, *m = now->moments + (size_t)s * moment_size;
        double *g = now->grams + (size_t)s * gram;
        bool same = o < old->slots && before[o] == t[s] && before[o + 1] == t[s + 1];
        const bool counted = same && same_samples;
        for (int j = 1 - p; same && j <= p; j++) same = before[o + j] == t[s + j];
        if (same)
            memcpy(T, old->transforms + (size_t)o * corner, corner * sizeof *T);
        else
            bat_lsq_transform(space, s, T);
        if (counted)
            memcpy(m, old->moments + (size_t)o * moment_size, moment_size * sizeof *m);
        else
            bat_lsq_moments(space, s, dimension, first[s + 1] - first[s], u + first[s],
                            x + first[s] * (size_t)dimension, weight ? weight + first[s] : NULL, m);
        if (same && counted) {
            memcpy(g, old->grams + (size_t)o * gram, gram * sizeof *g);
            continue;
        }
        /* As if the slot were a whole space of p + 1 unknowns. */
        double a[ORDERS * ORDERS] = {0}, b[ORDERS * BAT_DIMENSION_MAX] = {0};
        const bat_curve alone = {.degree = p, .count = w};
        bat_lsq_add(&alone, 0, dimension, T, m, a, b);
        for (int r = 0; r < w; r++)
            for (int d = 0; d <= r; d++) *g++ = a[r * w + d];
        memcpy(g, b, (size_t)(w * dimension) * sizeof *g);
    }
}

void bat_lsq_memo_add(const bat_curve *space, int dimension, const bat_lsq_memo *memo, double *a, double *b) {
    const int p = space->degree, w = p + 1, slots = bat_lsq_slots(space);
    const size_t gram = gram_size(p, dimension);
    const double *t = space->knots + p;
    for (int s = 0; s < slots; s++) {
        if (!(t[s + 1] > t[s])) continue;
        const double *g = memo->grams + (size_t)s * gram;
        for (int r = 0; r < w; r++) {
            double *row = a + (size_t)bat_lsq_unknown(space, s + r) * (size_t)w;
            for (int d = 0; d <= r; d++) row[d] += *g++;
        }
        for (int r = 0; r < w; r++) {
            double *row = b + (size_t)bat_lsq_unknown(space, s + r) * (size_t)dimension;
            for (int c = 0; c < dimension; c++) row[c] += *g++;
        }
    }
}

void bat_lsq_memo_penalty(const bat_curve *space, int order, double mu, const double *factor,
                          const bat_lsq_memo *memo, double *a) {
    add_penalty(space, order, mu, factor, memo->transforms, a);
}

void bat_lsq_memo_local(const bat_curve *space, int dimension, const bat_lsq_memo *memo, const double *points,
                        double *local) {
    find_local(space, dimension, points, memo->transforms, local);
}

/* One slot: straight-line code without branches, which compilers turn into vectors. */
BAT_INLINE void measure_slot(const int p, const int dimension, const double *restrict local, double middle,
                             double half, size_t count, const double *restrict u, const double *restrict x,
                             double *restrict near, double *restrict distance, double *restrict expected) {
    const double inverse = 1 / half;
    for (size_t i = 0; i < count; i++) {
        const double s = (u[i] - middle) * inverse;
        double d = 0, g = 0, speed = 0, bend = 0;
        for (int c = 0; c < dimension; c++) {
            double f = local[p * dimension + c], f1 = 0, f2 = 0;
            for (int k = p - 1; k >= 0; k--) {
                f2 = f2 * s + f1;
                f1 = f1 * s + f;
                f = f * s + local[k * dimension + c];
            }
            const double r = f - x[i * (size_t)dimension + (size_t)c];
            d += r * r, g += r * f1, speed += f1 * f1, bend += 2 * r * f2;
        }
        const double h = speed + bend, safe = h > 0.25 * speed ? h : speed;
        const double step = g / (safe > 0 ? safe : 1);
        distance[i] = d;
        expected[i] = d - g * step;
        near[i] = u[i] - step * half;
    }
}

BAT_INLINE void plain_slot(const int p, const int dimension, const double *restrict local, double middle,
                           double half, size_t count, const double *restrict u, const double *restrict x,
                           double *restrict distance) {
    const double inverse = 1 / half;
    for (size_t i = 0; i < count; i++) {
        const double s = (u[i] - middle) * inverse;
        double d = 0;
        for (int c = 0; c < dimension; c++) {
            double f = local[p * dimension + c];
            for (int k = p - 1; k >= 0; k--) f = f * s + local[k * dimension + c];
            f -= x[i * (size_t)dimension + (size_t)c];
            d += f * f;
        }
        distance[i] = d;
    }
}

void bat_lsq_plain(const bat_curve *space, int dimension, const double *local, const size_t *first,
                   const double *u, const double *x, double *distance) {
    const int p = space->degree, slots = bat_lsq_slots(space);
    const double *t = space->knots + p;
    for (int s = 0; s < slots; s++) {
        const size_t from = first[s], count = first[s + 1] - from;
        if (count == 0) continue;
        const double middle = middle_of(t + s), half = 0.5 * (t[s + 1] - t[s]);
        const double *piece = local + (size_t)s * (size_t)((p + 1) * dimension);
        if (p == 3 && dimension == 2)
            plain_slot(3, 2, piece, middle, half, count, u + from, x + 2 * from, distance + from);
        else
            plain_slot(p, dimension, piece, middle, half, count, u + from, x + from * (size_t)dimension,
                       distance + from);
    }
}

/* The usual case, for every instruction set there is. */
BAT_CLONES static void measure_planar_cubic(const double *local, double middle, double half, size_t count,
                                            const double *u, const double *x, double *near, double *distance,
                                            double *expected) {
    measure_slot(3, 2, local, middle, half, count, u, x, near, distance, expected);
}

double bat_lsq_measure(const bat_curve *space, int dimension, const double *local, const size_t *first,
                       const double *u, const double *x, double limit, double *near, double *distance,
                       double *scratch) {
    const int p = space->degree, slots = bat_lsq_slots(space);
    const double *t = space->knots + p;
    double worst = 0;
    for (int s = 0; s < slots; s++) {
        const size_t from = first[s], count = first[s + 1] - from;
        if (count == 0) continue;
        const double middle = middle_of(t + s), half = 0.5 * (t[s + 1] - t[s]);
        const double *piece = local + (size_t)s * (size_t)((p + 1) * dimension);
        const double *X = x + from * (size_t)dimension;
        if (p == 3 && dimension == 2)
            measure_planar_cubic(piece, middle, half, count, u + from, X, near + from, distance + from,
                                 scratch + from);
        else
            measure_slot(p, dimension, piece, middle, half, count, u + from, X, near + from, distance + from,
                         scratch + from);
    }
    const size_t all = first[slots];
    bool hopeless = false;
    for (size_t i = 0; i < all && !hopeless; i++)
        hopeless = !(distance[i] <= limit || scratch[i] < 2.25 * limit);
    for (size_t i = 0; i < all; i++) {
        /* Only where the outcome is open: a sample that fails by far fails anyway, and then one step's
         * expectation says enough about the others. */
        if (!(distance[i] <= limit) && scratch[i] < 2.25 * limit) {
            if (hopeless) {
                if (scratch[i] <= limit) distance[i] = fmax(scratch[i], 0);
                continue;
            }
            const double before = distance[i];
            double end = near[i], v = near[i] < t[0] ? t[0] : near[i] > t[slots] ? t[slots] : near[i], d;
            if (space->closed) v = bat_curve_reduce(space, near[i]);
            if (!(fabs(v) < INFINITY)) continue;
            bat_lsq_error(space, dimension, local, 1, &v, x + i * (size_t)dimension, 1, &end, &d);
            if (d < before) distance[i] = d, near[i] = end;
        }
        if (!(distance[i] <= worst)) worst = distance[i];
    }
    return worst;
}

void bat_lsq_rank(const bat_curve *space, int dimension, const double *local, double *rank) {
    const int p = space->degree, slots = bat_lsq_slots(space);
    const double *t = space->knots + p;
    for (int s = 0; s <= slots; s++) rank[s] = INFINITY;
    for (int s = space->closed ? 0 : 1; s < slots; s++) {
        const int before = s > 0 ? s - 1 : slots - 1;
        const double left = t[before + 1] - t[before], right = t[s + 1] - t[s];
        if (!(left > 0 && right > 0)) continue;
        const double *A = local + (size_t)before * (size_t)((p + 1) * dimension) + p * dimension;
        const double *B = local + (size_t)s * (size_t)((p + 1) * dimension) + p * dimension;
        double jump = 0, factorial = 1, scale_left = 1, scale_right = 1, spread = 1;
        for (int k = 1; k <= p; k++)
            factorial *= k, scale_left *= 2 / left, scale_right *= 2 / right, spread *= left * right;
        for (int c = 0; c < dimension; c++) {
            const double d = factorial * (B[c] * scale_right - A[c] * scale_left);
            jump += d * d;
        }
        rank[s] = sqrt(jump * spread);
    }
}
