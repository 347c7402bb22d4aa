/* Takes a curve apart into levels (math 3.7): knots are thinned, coarse points fitted, details read off. */
#include "hands/levels/shape.h"

#include "curve/banded.h"
#include "curve/curve.h"
#include "curve/mirror.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SLOW = 0.5;  /* a coarse curve slower than this carries no frame */
static const double EVEN = 1e-5; /* of the size: as symmetric as a file with few digits says it */

/* How knots are left out of a curve: of one that is its own mirror image so that what is left is, too, if it can be. */
typedef struct thinning {
    bool even, off; /* off: the seam of a closed curve is not on the axis, but has its image at */
    double image;
} thinning;

static int evenly(int i, int total, int kept) { return (int)((i + 0.5) * total / kept); }

/* Whether the at-th of `total` is among the first `count` of `kept` that are evenly spaced. */
static bool is_among(int at, int total, int kept, int count) {
    const int near = kept > 0 ? (int)((at + 0.5) * kept / total) : 0;
    for (int i = near > 0 ? near - 1 : 0; i <= near + 1 && i < count; i++)
        if (evenly(i, total, kept) == at) return true;
    return false;
}

static bool is_kept(bool even, int at, int total, int kept) {
    if (!even) return is_among(at, total, kept, kept);
    return is_among(at, total, kept, kept - kept / 2) || is_among(total - 1 - at, total, kept, kept / 2);
}

/* How many of `kept` lie before the seam's image, of `total` of which `before` do: in proportion, and so that both parts can be
 * symmetric, if they can; else -1. */
static int share(int total, int before, int kept) {
    const int after = total - before, wish = total > 0 ? (int)((double)kept * before / total + 0.5) : 0;
    for (int i = 0; i <= 4; i++) { /* 0, 1, -1, 2, -2 from it */
        const int mine = wish + (i % 2 ? (i + 1) / 2 : -i / 2), rest = kept - mine;
        const bool can = (mine % 2 == 0 || before % 2) && (rest % 2 == 0 || after % 2);
        if (mine >= 0 && mine <= before && rest >= 0 && rest <= after && can) return mine;
    }
    return -1;
}

/* Lists the knots that are the rank-th repeat of their value (0: its first copy); `before` is the knot before the first. How many. */
static int list_copies(const double *knots, int count, double before, int rank, int *list) {
    int copy = 0, total = 0;
    for (int i = 0; i < count; i++) {
        copy = knots[i] == (i ? knots[i - 1] : before) ? copy + 1 : 0;
        if (copy == rank) list[total++] = i;
    }
    return total;
}

/* Marks `kept` of `total` listed knots on both sides of the seam's image, which stays with the seam's own copy (own: the first of the
 * list), or goes with it. False: they cannot be symmetric. */
static bool keep_around(const int *list, int total, int kept, int own, int image, bool *stays) {
    const int before = image - own, rest = total - own - 1;
    int first = -1, both = own ? 0 : 1;
    for (; both < 2 && first < 0; both++) {
        const int left = kept - (both ? own + 1 : 0);
        first = left >= 0 && left <= rest ? share(rest, before, left) : -1;
    }
    if (first < 0) return false;
    const bool with = both == 2;
    const int left = kept - (with ? own + 1 : 0);
    for (int at = 0; at < total; at++)
        stays[list[at]] = at == image || at < own ? with
                          : at < image            ? is_kept(true, at - own, before, first)
                                       : is_kept(true, at - image - 1, rest - before, left - first);
    return true;
}

/* Marks `kept` of `total` listed knots, evenly spaced. */
static void keep(const double *knots, const int *list, int total, int kept, double before, thinning how,
                 bool *stays) {
    int own = how.even && total > 0 && knots[list[0]] == before, image = -1;
    for (int at = 0; at < total && how.off; at++)
        if (knots[list[at]] == how.image) image = at;
    if (image >= 0 && keep_around(list, total, kept, own, image, stays)) return;
    if (image >= 0) own = 0, how.even = false;
    const int rest = total - own;
    const bool with = own && (kept > rest ||
                              (kept % 2 && rest % 2 == 0)); /* the seam's copy, for want of another middle */
    for (int at = 0; at < total; at++)
        stays[list[at]] = at < own ? with : is_kept(how.even, at - own, rest, kept - with);
}

static thinning how_to_thin(const bat_curve *fine) {
    static const double upright[2] = {0, 1};
    const double *t = bat_curve_knots(fine);
    thinning how = {false, false, 0};
    bat_mirror mirror;
    int turn;
    how.even = bat_mirror_find(fine, upright, EVEN * bat_curve_size(fine), &mirror, &turn);
    if (!how.even || !fine->closed) return how;
    how.image = t[(turn + fine->degree) % fine->count];
    how.off = how.image != t[0];
    return how;
}

/* Leaves out interior knots until `count` control points are left (closed: the seam stays). Returns a curve
 * with unset points. */
static bat_status thinned(const bat_curve *fine, int count, bat_curve **out) {
    int p = fine->degree, n = fine->count;
    int interior = fine->closed ? n - 1 : n - p - 1, kept = fine->closed ? count - 1 : count - p - 1;
    if (count >= n || kept < 0 || (fine->closed && count < 3)) return BAT_COUNT;
    bool *stays = calloc((size_t)interior, sizeof *stays);
    int *list = malloc((size_t)interior * sizeof *list);
    bat_curve *coarse;
    bat_status status = stays && list ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) status = bat_curve_allocate(p, fine->dimension, fine->closed, count, &coarse);
    if (status != BAT_OK) {
        free(stays), free(list);
        return status;
    }
    const double *from = bat_curve_knots(fine);
    double *to = bat_curve_own_knots(coarse);
    int lead = fine->closed ? 1 : p + 1;
    const thinning how = how_to_thin(fine);
    for (int rank = 0, left = kept; left > 0; rank++) { /* repeats come after all the first copies */
        int total = list_copies(from + lead, interior, from[lead - 1], rank, list);
        int taken = total < left ? total : left;
        keep(from + lead, list, total, taken, from[lead - 1], how, stays);
        left -= taken;
    }
    memcpy(to, from, (size_t)lead * sizeof(double));
    for (int i = 0, k = lead; i < interior; i++)
        if (stays[i]) to[k++] = from[lead + i];
    memcpy(to + lead + kept, from + lead + interior, (size_t)lead * sizeof(double));
    memset(bat_curve_own_points(coarse), 0, (size_t)(count * fine->dimension) * sizeof(double));
    free(stays), free(list);
    return bat_curve_finish(coarse, out);
}

/* Coefficients of the stored fine point i in terms of p + 1 stored coarse points, from *first on: the blossom
 * of the coarse span that holds one of the point's fine spans, at t_{i+1}..t_{i+p} of the fine knots. */
static void refinement_row(const bat_curve *coarse, const bat_curve *fine, int i, int *first, double *row) {
    int p = fine->degree, q = i > p ? i : p;
    while (q + 1 < fine->spread && fine->knots[q] == fine->knots[q + 1]) q++;
    double middle = fine->knots[q] + (fine->knots[q + 1] - fine->knots[q]) / 2;
    int span = bat_span(coarse, middle, -1);
    const double *t = coarse->knots + span;
    double d[BAT_DEGREE_MAX + 1][BAT_DEGREE_MAX + 1] = {{0}};
    for (int j = 0; j <= p; j++) d[j][j] = 1;
    for (int r = 1; r <= p; r++)
        for (int j = 0; j <= p - r; j++) {
            double left = t[j + r - p], right = t[j + 1], w = (fine->knots[i + r] - left) / (right - left);
            for (int c = 0; c <= p; c++) d[j][c] = (1 - w) * d[j][c] + w * d[j + 1][c];
        }
    *first = span - p;
    memcpy(row, d[0], (size_t)(p + 1) * sizeof(double));
}

/* Fixes an unknown at a value: its column goes to the right-hand side. */
static void fix(double *a, double *b, int n, int band, int size, int k, const double *value) {
    for (int d = 1; d <= band; d++) {
        if (k + d < n) {
            for (int c = 0; c < size; c++) b[(k + d) * size + c] -= a[(k + d) * (band + 1) + d] * value[c];
            a[(k + d) * (band + 1) + d] = 0;
        }
        if (k - d >= 0) {
            for (int c = 0; c < size; c++) b[(k - d) * size + c] -= a[k * (band + 1) + d] * value[c];
            a[k * (band + 1) + d] = 0;
        }
    }
    a[k * (band + 1)] = 1;
    memcpy(b + k * size, value, (size_t)size * sizeof(double));
}

static bool clamped(const bat_curve *curve) {
    const double *t = curve->knots;
    return !curve->closed && t[0] == t[curve->degree] && t[curve->spread] == t[curve->spread + curve->degree];
}

bat_status bat_curve_coarsen(const bat_curve *fine, int count, bat_curve **out) {
    bat_curve *coarse;
    bat_status status = thinned(fine, count, &coarse);
    if (status != BAT_OK) return status;
    int p = fine->degree, n = coarse->count, size = fine->dimension;
    double *a = calloc((size_t)n * (size_t)(p + 1), sizeof(double));
    double *b = calloc((size_t)(n * size), sizeof(double));
    double *border = malloc((bat_cyclic_room(n, p) + 1) * sizeof(double));
    status = a && b && border ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int lead = fine->closed ? p : 0;
        for (int i = lead; i < lead + fine->count; i++) {
            double row[BAT_DEGREE_MAX + 1];
            int first;
            refinement_row(coarse, fine, i, &first, row);
            double w = (fine->knots[i + p + 1] - fine->knots[i]) / (p + 1);
            for (int r = 0; r <= p; r++) {
                int k = coarse->closed ? ((first + r - p) % n + n) % n : first + r;
                for (int s = 0; s <= r; s++) a[k * (p + 1) + r - s] += w * row[r] * row[s];
                for (int c = 0; c < size; c++) b[k * size + c] += w * row[r] * fine->points[i * size + c];
            }
        }
        if (clamped(fine)) {
            fix(a, b, n, p, size, 0, fine->points);
            fix(a, b, n, p, size, n - 1, fine->points + (fine->count - 1) * size);
        }
        status = coarse->closed ? bat_cyclic_factor(a, n, p, border) : bat_banded_factor(a, n, p);
    }
    if (status == BAT_OK) {
        if (coarse->closed)
            bat_cyclic_solve(a, n, p, border, b, size);
        else
            bat_banded_solve(a, n, p, b, size);
        memcpy(bat_curve_own_points(coarse), b, (size_t)(n * size) * sizeof(double));
        status = bat_curve_finish(coarse, out);
        coarse = NULL;
    }
    bat_curve_free(coarse);
    free(a);
    free(b);
    free(border);
    return status;
}

static double speed(const bat_curve *curve, double u) {
    double at[2 * BAT_DIMENSION_MAX];
    int size = curve->dimension;
    bat_curve_eval(curve, u, 1, at);
    return vec_norm(vec_load(at + size, size));
}

/* The finest level below this one whose curve, like all those below it, is not slow at the node. */
static int source_of(const bat_shape *shape, int level, double u) {
    double least = SLOW * speed(shape->base, u);
    int l = 0;
    while (l + 1 < level && speed(bat_shape_curve(shape, l + 1), u) >= least) l++;
    return l;
}

/* The details of the level that was just added, so that its curve becomes `wanted`. */
static bat_status read_details(bat_shape *shape, const bat_curve *wanted) {
    int level = shape->count, size = wanted->dimension;
    bat_level *at = &shape->levels[level - 1];
    for (int i = 0; i < at->count; i++) at->source[i] = source_of(shape, level, at->nodes[i]);
    bat_status status = bat_shape_frames_of(shape, level, NULL);
    if (status != BAT_OK) return status;
    const double *bare = bat_curve_points(at->curve), *full = bat_curve_points(wanted);
    for (int i = 0; i < at->count; i++) {
        bat_triad_to_local(&at->frames[i],
                           vec_sub(vec_load(full + i * size, size), vec_load(bare + i * size, size)),
                           at->details + 3 * i);
        if (bat_shape_flat(shape)) at->details[3 * i + 2] = 0; /* not -0 */
    }
    return bat_level_build(at, bat_shape_curve(shape, level - 1));
}

int bat_curve_halved(const bat_curve *curve, int n) {
    int fixed = curve->closed ? 1 : curve->degree + 1;
    return n > fixed ? (n - fixed) / 2 + fixed : n;
}

static bat_status decompose(const bat_curve *curve, int levels, const int *counts,
                            const bat_shape_options *options, bat_shape **out) {
    bat_curve *chain[BAT_LEVELS_MAX + 1] = {NULL};
    bat_shape *shape = NULL;
    bat_status status = bat_curve_copy(curve, &chain[levels]);
    for (int j = levels; j > 0 && status == BAT_OK; j--)
        status = bat_curve_coarsen(chain[j], counts[j - 1], &chain[j - 1]);
    if (status == BAT_OK) status = bat_shape_create(chain[0], options, &shape);
    for (int j = 1; j <= levels && status == BAT_OK; j++) {
        status = bat_shape_add_level(shape, bat_curve_knot_count(chain[j]), bat_curve_knots(chain[j]), NULL,
                                     NULL);
        if (status == BAT_OK) status = read_details(shape, chain[j]);
    }
    for (int j = 0; j <= levels; j++) bat_curve_free(chain[j]);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    *out = shape;
    return BAT_OK;
}

bat_status bat_shape_decompose(const bat_curve *curve, int levels, const bat_shape_options *options,
                               bat_shape **out) {
    int counts[BAT_LEVELS_MAX + 1];
    if (!curve || !out) return BAT_ARGUMENT;
    if (levels < 0 || levels > BAT_LEVELS_MAX) return BAT_COUNT;
    counts[levels] = curve->count;
    for (int j = levels; j > 0; j--) counts[j - 1] = bat_curve_halved(curve, counts[j]);
    return decompose(curve, levels, counts, options, out);
}

void bat_levels_counts(int n, int coarsest, int levels, int counts[BAT_LEVELS_MAX + 1]) {
    counts[levels] = n;
    for (int j = levels - 1; j >= 0; j--) {
        double count = coarsest * bat_exp(bat_log((double)n / coarsest) * j / levels);
        counts[j] = (int)fmin(fmax(floor(count + 0.5), coarsest + j), counts[j + 1] - 1);
    }
}

/* Counts between the coarsest and the finest such that knots that stay can be pairs of images. */
static void make_pairs(const bat_curve *curve, int levels, int *counts) {
    const int fixed = curve->closed ? 0 : curve->degree + 1;
    for (int j = 1; j < levels; j++)
        if ((counts[j] - fixed) % 2 && counts[j] - 1 > counts[j - 1]) counts[j]--;
}

bat_status bat_shape_decompose_to(const bat_curve *curve, int levels, size_t least,
                                  const bat_shape_options *options, bat_shape **out) {
    int counts[BAT_LEVELS_MAX + 1];
    if (!curve || !out) return BAT_ARGUMENT;
    int n = curve->count, coarsest = bat_count_inside(least);
    if (levels < 1 || levels > BAT_LEVELS_MAX || coarsest < 1 || coarsest > n - levels) return BAT_COUNT;
    bat_levels_counts(n, coarsest, levels, counts);
    if (how_to_thin(curve).even) make_pairs(curve, levels, counts);
    return decompose(curve, levels, counts, options, out);
}
