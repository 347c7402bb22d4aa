/* Edits of a shape: each is made on a copy, which takes the shape's place when all has gone well. */
#include "shape/levels.h"

#include "curve/banded.h"
#include "curve/curve.h"
#include "curve/lsq.h"

#include <stdlib.h>
#include <string.h>

enum { FINEST_STEPS = 20 };
static const double MU = 1e-6, NU = 1e-3; /* math 3.6 */

static bool finite_all(const double *v, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (!(fabs(v[i]) <= BAT_COORDINATE_MAX)) return false;
    return true;
}

static bat_status check(const bat_shape *shape, int level) {
    return !shape || level < 0 || level > shape->count ? BAT_ARGUMENT : BAT_OK;
}

static bat_status move_base(bat_shape *shape, int first, int count, const double *deltas) {
    int size = shape->base->dimension, n = shape->base->count;
    double *points = bat_curve_own_points(shape->base);
    for (int i = 0; i < count; i++)
        for (int d = 0; d < size; d++) points[((first + i) % n) * size + d] += deltas[i * size + d];
    bat_status status = bat_curve_validate(shape->base);
    bat_curve_unroll(shape->base);
    return status;
}

static bat_status move_details(bat_level *level, int first, int count, const double *deltas) {
    int size = level->curve->dimension;
    double gain = bat_level_gain(level);
    if (gain == 0) return BAT_STATE; /* a muted level shows no change */
    for (int i = 0; i < count; i++) {
        int k = (first + i) % level->count;
        double local[3];
        bat_triad_to_local(&level->frames[k], vec_load(deltas + i * size, size), local);
        for (int d = 0; d < 3; d++) level->details[3 * k + d] += local[d] / gain;
    }
    return BAT_OK;
}

bat_status bat_shape_move_many(bat_shape *shape, int level, int first, int count, const double *deltas) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    const bat_curve *curve = bat_shape_curve(shape, level);
    if (!deltas || first < 0 || first >= curve->count || count < 1 || count > curve->count ||
        (!curve->closed && first + count > curve->count))
        return BAT_ARGUMENT;
    if (!finite_all(deltas, (size_t)count * (size_t)curve->dimension)) return BAT_NUMBER;
    bat_stretch touched = bat_stretch_of(curve, first, count);
    bat_shape *edited;
    status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    status = level == 0 ? move_base(edited, first, count, deltas)
                        : move_details(&edited->levels[level - 1], first, count, deltas);
    if (status == BAT_OK) status = bat_shape_rebuild(edited, level, touched);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

bat_status bat_shape_move(bat_shape *shape, int level, int index, const double *delta) {
    return bat_shape_move_many(shape, level, index, 1, delta);
}

bat_status bat_shape_drag(bat_shape *shape, int level, double u, const double *delta) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    if (!delta) return BAT_ARGUMENT;
    const bat_curve *curve = bat_shape_curve(shape, level);
    int p = curve->degree, size = curve->dimension, n = curve->count, first;
    if (!isfinite(u)) return BAT_NUMBER;
    double basis[BAT_DEGREE_MAX + 1], weight[BAT_DEGREE_MAX + 1] = {0}, square = 0;
    double deltas[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    bat_curve_basis(curve, u, &first, basis);
    /* A closed curve of few points meets one of them more than once. */
    int count = p + 1 < n ? p + 1 : n;
    for (int i = 0; i <= p; i++) weight[i % count] += basis[i];
    for (int i = 0; i < count; i++) square += weight[i] * weight[i];
    for (int i = 0; i < count; i++)
        for (int d = 0; d < size; d++) deltas[i * size + d] = weight[i] / square * delta[d];
    return bat_shape_move_many(shape, level, first, count, deltas);
}

bat_status bat_shape_drag_finest(bat_shape *shape, int level, double u, const double *delta, double tolerance,
                                 double *left) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    if (!delta || !(tolerance > 0)) return BAT_ARGUMENT;
    int size = shape->base->dimension;
    if (!isfinite(u) || !finite_all(delta, (size_t)size)) return BAT_NUMBER;
    bat_shape *edited;
    status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    double target[3], at[3], step[3], miss = INFINITY;
    bat_curve_eval(bat_shape_curve(shape, shape->count), u, 0, target);
    for (int d = 0; d < size; d++) target[d] += delta[d], step[d] = delta[d];
    for (int i = 0; i < FINEST_STEPS && status == BAT_OK && miss > tolerance; i++) {
        status = bat_shape_drag(edited, level, u, step);
        if (status != BAT_OK) break;
        bat_curve_eval(bat_shape_curve(edited, edited->count), u, 0, at);
        miss = 0;
        for (int d = 0; d < size; d++) step[d] = target[d] - at[d], miss = bat_hypot(miss, step[d]);
    }
    if (status == BAT_OK && miss > tolerance) status = BAT_TOLERANCE;
    if (status != BAT_OK) {
        bat_shape_free(edited);
        return status;
    }
    if (left) *left = miss;
    bat_shape_adopt(shape, edited);
    return BAT_OK;
}

static bat_status set_level(bat_shape *shape, int level, double gain, bool muted) {
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    edited->levels[level - 1].gain = gain;
    edited->levels[level - 1].muted = muted;
    status = bat_shape_rebuild(edited, level, BAT_EVERYWHERE);
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

bat_status bat_shape_set_gain(bat_shape *shape, int level, double gain) {
    if (check(shape, level) != BAT_OK || level == 0) return BAT_ARGUMENT;
    if (!(fabs(gain) <= 1e6)) return BAT_NUMBER;
    return set_level(shape, level, gain, shape->levels[level - 1].muted);
}

bat_status bat_shape_set_muted(bat_shape *shape, int level, bool muted) {
    if (check(shape, level) != BAT_OK || level == 0) return BAT_ARGUMENT;
    return set_level(shape, level, shape->levels[level - 1].gain, muted);
}

/* ---- sketch at a level (math 3.6) ---- */

/* Adds w (sum_k c_k x_{at_k})^2 to a banded matrix of unknowns in ascending order (cyclic: modulo n). */
static void add_row(double *a, int band, int n, bool closed, int first, int terms, const double *c,
                    double w) {
    for (int r = 0; r < terms; r++)
        for (int s = 0; s <= r; s++) {
            int row = closed ? (first + r) % n : first + r;
            a[row * (band + 1) + r - s] += w * c[r] * c[s];
        }
}

bat_status bat_shape_sketch(bat_shape *shape, int level, size_t count, const double *u,
                            const double *targets) {
    bat_status status = check(shape, level);
    if (status != BAT_OK) return status;
    if (!u || !targets || count < 1 || count > BAT_POINTS_MAX) return BAT_ARGUMENT;
    const bat_curve *curve = bat_shape_curve(shape, level);
    int p = curve->degree, size = curve->dimension, n = curve->count;
    if (!finite_all(targets, count * (size_t)size)) return BAT_NUMBER;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(u[i])) return BAT_NUMBER;

    int band = p > 2 ? p : 2; /* second differences reach two neighbours */
    size_t cells = (size_t)n * (size_t)(band + 1);
    double *a = calloc(cells, sizeof(double)), *b = calloc((size_t)(n * size), sizeof(double));
    double *border = malloc((bat_cyclic_room(n, band) + 1) * sizeof(double));
    bool *met = calloc((size_t)n, sizeof(bool));
    status = a && b && border && met ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        for (size_t i = 0; i < count; i++) {
            double basis[BAT_DEGREE_MAX + 1], at[3];
            int first;
            bat_curve_basis(curve, u[i], &first, basis);
            bat_curve_eval(curve, u[i], 0, at);
            add_row(a, band, n, curve->closed, first, p + 1, basis, 1);
            for (int k = 0; k <= p; k++) {
                int row = (first + k) % n;
                if (basis[k] != 0) met[row] = true;
                for (int d = 0; d < size; d++)
                    b[row * size + d] += basis[k] * (targets[i * (size_t)size + (size_t)d] - at[d]);
            }
        }
        const double second[3] = {1, -2, 1};
        for (int i = 0; i < (curve->closed ? n : n - 2); i++)
            add_row(a, band, n, curve->closed, i, 3, second, NU);
        for (int i = 0; i < n; i++) a[i * (band + 1)] += MU;
        /* What the stroke misses stays exactly: its row and column become the identity. */
        for (int i = 0; i < n; i++) {
            if (met[i]) continue;
            for (int d = 0; d < size; d++) b[i * size + d] = 0;
            for (int k = 1; k <= band; k++) {
                a[i * (band + 1) + k] = 0;
                int right = curve->closed ? (i + k) % n : i + k;
                if (right < n) a[right * (band + 1) + k] = 0;
            }
            a[i * (band + 1)] = 1;
        }
        status = curve->closed ? bat_cyclic_factor(a, n, band, border) : bat_banded_factor(a, n, band);
    }
    if (status == BAT_OK) {
        if (curve->closed)
            bat_cyclic_solve(a, n, band, border, b, size);
        else
            bat_banded_solve(a, n, band, b, size);
        /* The shortest run that holds all that moves; on a closed curve it begins behind the longest gap. */
        int first = 0, moved = n;
        if (!curve->closed) {
            while (first < n && !met[first]) first++;
            while (moved > 0 && !met[moved - 1]) moved--;
            moved -= first;
        } else {
            int gap = 0, best = 0;
            for (int i = 0; i < 2 * n; i++) {
                gap = met[i % n] ? 0 : gap + 1;
                if (gap > best && gap < n) best = gap, first = (i + 1) % n;
            }
            moved = n - best;
        }
        double *deltas = malloc((size_t)(moved * size) * sizeof(double));
        if (deltas) {
            for (int i = 0; i < moved; i++)
                memcpy(deltas + i * size, b + ((first + i) % n) * size, (size_t)size * sizeof(double));
            status = bat_shape_move_many(shape, level, first, moved, deltas);
            free(deltas);
        } else {
            status = BAT_MEMORY;
        }
    }
    free(a);
    free(b);
    free(border);
    free(met);
    return status;
}

/* ---- whole-curve transforms ---- */

double bat_affine_determinant(const double *m, int size) {
    if (size == 2) return m[0] * m[4] - m[1] * m[3];
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

vec bat_affine_turn(const double *m, int size, vec v) {
    if (size == 2) return (vec){m[0] * v.x + m[1] * v.y, m[3] * v.x + m[4] * v.y, v.z};
    return (vec){m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
                 m[8] * v.x + m[9] * v.y + m[10] * v.z};
}

static void turn_reference(bat_shape_options *o, const double *m, int size) {
    double *vectors[3] = {o->first, o->reference_t, o->reference_s};
    for (int i = 0; i < 3; i++)
        vec_store(vec_unit(bat_affine_turn(m, size, vec_load(vectors[i], 3))), vectors[i]);
}

bat_status bat_shape_transform(bat_shape *shape, const double *matrix) {
    if (!shape || !matrix) return BAT_ARGUMENT;
    int size = shape->base->dimension;
    if (!finite_all(matrix, (size_t)(size * (size + 1)))) return BAT_NUMBER;
    double det = bat_affine_determinant(matrix, size);
    if (!(fabs(det) > 0)) return BAT_SINGULAR;
    double factor = size == 2 ? sqrt(fabs(det)) : bat_exp(bat_log(fabs(det)) / 3);
    bat_shape *edited;
    bat_status status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    bat_curve *base;
    status = bat_curve_transform(edited->base, matrix, &base);
    if (status == BAT_OK) {
        bat_curve_free(edited->base);
        edited->base = base;
        turn_reference(&edited->options, matrix, size);
        bat_frame_rule rule = edited->options.frame;
        for (int l = 0; l < edited->count; l++)
            for (int i = 0; i < edited->levels[l].count; i++) {
                double *d = edited->levels[l].details + 3 * i;
                if (rule == BAT_FRAMES_FIXED) { /* the world's axes do not turn: the detail does */
                    vec_store(bat_affine_turn(matrix, size, vec_load(d, 3)), d);
                    continue;
                }
                for (int k = 0; k < 3; k++) d[k] *= factor;
                /* A mirror image: r = t x s changes sides; in the plane s = t turned left does. */
                if (det < 0) {
                    if (size == 3)
                        d[2] = -d[2];
                    else if (rule == BAT_FRAMES_RMF)
                        d[1] = -d[1];
                }
            }
        for (int l = 0; l < BAT_LEVELS_MAX && det < 0; l++) edited->holonomy[l] = -edited->holonomy[l];
        status = bat_shape_rebuild(edited, 0, BAT_EVERYWHERE);
    }
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}

bat_status bat_shape_commit(bat_shape *shape) {
    if (!shape) return BAT_ARGUMENT;
    if (!shape->options.has_reference || shape->base->dimension == 2) return BAT_OK;
    bat_frame3 first;
    double domain[2];
    bat_frame_options options = {.has_reference = true};
    memcpy(options.reference_t, shape->options.reference_t, sizeof options.reference_t);
    memcpy(options.reference_s, shape->options.reference_s, sizeof options.reference_s);
    bat_curve_domain(shape->base, domain);
    bat_status status = bat_frames(shape->base, &options, 1, domain, &first, NULL);
    if (status != BAT_OK) return status;
    vec t = vec_load(first.t, 3);
    if (vec_dot(t, vec_unit(vec_load(options.reference_t, 3))) >= -0.5) return BAT_OK;
    bat_shape *edited;
    status = bat_shape_copy(shape, &edited);
    if (status != BAT_OK) return status;
    memcpy(edited->options.reference_t, first.t, sizeof first.t);
    memcpy(edited->options.reference_s, first.s, sizeof first.s);
    /* An empty stretch: details turn back everywhere, so that nothing moves. */
    double middle = domain[0] + (domain[1] - domain[0]) / 2;
    status = bat_shape_rebuild(edited, 0, (bat_stretch){middle, 0});
    if (status == BAT_OK)
        bat_shape_adopt(shape, edited);
    else
        bat_shape_free(edited);
    return status;
}
