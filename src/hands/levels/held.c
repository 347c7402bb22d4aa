/*
 * A drag under constraints (math 3.9): of all moves of the level's control points that bring the finest curve where it is dragged to
 * and hold what is to stay, the least. Each round linearises the constraints with the details carried along as they are, and takes the
 * shortest move that satisfies them; where that leads nowhere, the drag is made in smaller steps. With symmetry, all rows are those of
 * symmetric moves.
 */
#include "hands/levels/shape.h"

#include "base/real.h"
#include "curve/curve.h"
#include "curve/mirror.h"

#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 3 * (1 + 2 * BAT_HELD_MAX) + 2, ROUNDS = 40, GAUSS = 5 };

static const double NEAR = 1e-10; /* of the size: how well constraints are met, and below which rounds end */
static const double PRECISE = 1e-13;   /* of lengths */
static const double SMALLEST = 0.0625; /* of the drag: its smallest step */
static const double ALIKE = 1e-12;     /* constraints that say the same twice */
static const double EVEN = 1e-5;       /* of the size: as symmetric as a file with few digits says it */

/* Gauss-Legendre on [-1, 1]. */
static const double NODE[GAUSS] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                                   0.906179845938664};
static const double WEIGHT[GAUSS] = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                     0.478628670499366, 0.236926885056189};

typedef struct holding {
    const bat_shape *before;
    const bat_shape_held *held;
    int level, dimension, count; /* control points of the level */
    int index;                   /* the control point that is moved; -1: the finest curve, at u */
    double u, size, length, area;
    double from[3], goal[3];           /* of the dragged place, now and in the end */
    double place[BAT_HELD_MAX][3];     /* of held points */
    double normal[BAT_HELD_MAX][2][3]; /* at right angles to held directions; planar curves have one */
    bat_mirror mirror;                 /* on: symmetry is held */
    int turn, level_turn;              /* of the finest curve's control points, of the level's (mirror.h) */
    double uneven;                     /* the finest curve, before */
    int rows;
    double *jacobian; /* rows * count * dimension */
    double *moved;    /* count * dimension: the whole move so far */
    double *trial;
    double residual[ROWS];
    bat_shape *shape; /* before, moved */
} holding;

static const bat_curve *finest(const bat_shape *shape) { return bat_shape_curve(shape, shape->count); }

static double *row_at(const holding *h, int row) {
    return h->jacobian + (size_t)row * (size_t)(h->count * h->dimension);
}

/* Adds weight * way times the derivative of that order of the level's basis at u to a row. */
static void add_basis(const holding *h, double *row, double u, int order, double weight, const double *way) {
    const bat_curve *curve = bat_shape_curve(h->shape, h->level);
    double values[2 * (BAT_DEGREE_MAX + 1)], ignored[BAT_DEGREE_MAX + 1];
    int first;
    const double at = bat_curve_reduce(curve, u);
    bat_curve_basis(curve, at, &first, ignored);
    bat_basis(curve, bat_span(curve, at, -1), at, order, values);
    const double *basis = values + order * (curve->degree + 1);
    for (int i = 0; i <= curve->degree; i++)
        for (int d = 0; d < h->dimension; d++)
            row[(first + i) % h->count * h->dimension + d] += weight * basis[i] * way[d];
}

/* The rows of length and area: integrals over the finest curve. */
static void add_integrals(const holding *h, double *length, double *area) {
    const bat_curve *curve = finest(h->shape);
    const double *t = curve->knots;
    for (int s = curve->degree; s < curve->spread; s++)
        for (int k = 0; k < GAUSS && t[s + 1] > t[s]; k++) {
            const double half = (t[s + 1] - t[s]) / 2, u = t[s] + half * (1 + NODE[k]);
            double d[2 * BAT_DIMENSION_MAX], speed = 0;
            bat_curve_eval(curve, u, 1, d);
            double *way = d + h->dimension;
            for (int c = 0; c < h->dimension; c++) speed = bat_hypot(speed, way[c]);
            if (area) add_basis(h, area, u, 0, half * WEIGHT[k] / h->size, (double[]){way[1], -way[0]});
            if (length && speed > 0) add_basis(h, length, u, 1, half * WEIGHT[k] / speed, way);
        }
}

/* How far the shape is from what is asked, document units: of the dragged place's goal, held points, directions, length, area. */
static bat_status measure(holding *h, const double *goal) {
    const bat_curve *curve = finest(h->shape);
    const int n = h->dimension;
    double at[2 * BAT_DIMENSION_MAX], domain[2];
    int row = 0;
    bat_curve_eval(curve, h->u, 0, at);
    const double *here = h->index < 0 ? at : h->moved + h->index * n;
    for (int d = 0; d < n; d++) h->residual[row++] = goal[d] - here[d];
    for (size_t i = 0; i < h->held->point_count; i++) {
        bat_curve_eval(curve, h->held->points[i], 0, at);
        for (int d = 0; d < n; d++) h->residual[row++] = h->place[i][d] - at[d];
    }
    for (size_t i = 0; i < h->held->direction_count; i++) {
        double speed = 0;
        bat_curve_eval(curve, h->held->directions[i], 1, at);
        for (int d = 0; d < n; d++) speed = bat_hypot(speed, at[n + d]);
        for (int k = 0; k < n - 1; k++, row++) {
            h->residual[row] = 0;
            for (int d = 0; d < n; d++)
                h->residual[row] -= h->size * h->normal[i][k][d] * at[n + d] / (speed > 0 ? speed : 1);
        }
    }
    bat_curve_domain(curve, domain);
    if (h->held->length)
        h->residual[row++] = h->length - bat_curve_length(curve, domain[0], domain[1], PRECISE);
    if (h->held->area) h->residual[row++] = (h->area - bat_curve_area(curve)) / h->size;
    for (int i = 0; i < row; i++)
        if (!isfinite(h->residual[i])) return BAT_NUMBER;
    return BAT_OK;
}

static double worst(const holding *h) {
    double most = 0;
    for (int i = 0; i < h->rows; i++) most = fmax(most, fabs(h->residual[i]));
    return most;
}

/* The symmetric part of a row: the mean of it and its image. */
static void make_even(const holding *h, double *row) {
    const bat_mirror about = {true, {0, 0}, {h->mirror.along[0], h->mirror.along[1]}};
    for (int i = 0; i < h->count; i++) {
        const int j = bat_mirror_image_of(h->count, h->level_turn, i);
        double image[2];
        if (j < i) continue;
        bat_mirror_point(&about, row + 2 * j, image);
        for (int d = 0; d < 2; d++) row[2 * i + d] = (row[2 * i + d] + image[d]) / 2;
        bat_mirror_point(&about, row + 2 * i, row + 2 * j);
    }
}

static void linearise(holding *h) {
    static const double axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int n = h->dimension;
    int row = 0;
    memset(h->jacobian, 0, (size_t)h->rows * (size_t)(h->count * n) * sizeof *h->jacobian);
    for (int d = 0; d < n && h->index >= 0; d++) row_at(h, row++)[h->index * n + d] = 1;
    for (int d = 0; d < n && h->index < 0; d++) add_basis(h, row_at(h, row++), h->u, 0, 1, axis[d]);
    for (size_t i = 0; i < h->held->point_count; i++)
        for (int d = 0; d < n; d++) add_basis(h, row_at(h, row++), h->held->points[i], 0, 1, axis[d]);
    for (size_t i = 0; i < h->held->direction_count; i++) {
        double at[2 * BAT_DIMENSION_MAX], speed = 0;
        bat_curve_eval(finest(h->shape), h->held->directions[i], 1, at);
        for (int d = 0; d < n; d++) speed = bat_hypot(speed, at[n + d]);
        for (int k = 0; k < n - 1; k++)
            add_basis(h, row_at(h, row++), h->held->directions[i], 1, h->size / (speed > 0 ? speed : 1),
                      h->normal[i][k]);
    }
    double *length = h->held->length ? row_at(h, row++) : NULL;
    double *area = h->held->area ? row_at(h, row++) : NULL;
    if (length || area) add_integrals(h, length, area);
    for (int i = 0; i < h->rows && h->mirror.on; i++) make_even(h, row_at(h, i));
}

/* Solves the symmetric system in place; rows that follow from others get a share of zero. */
static void solve(int n, double (*m)[ROWS], double *x) {
    double most = 0;
    bool used[ROWS] = {false};
    for (int i = 0; i < n; i++) most = fmax(most, m[i][i]);
    for (int done = 0; done < n; done++) { /* Gauss-Jordan, the greatest diagonal first */
        int p = -1;
        for (int i = 0; i < n; i++)
            if (!used[i] && (p < 0 || m[i][i] > m[p][p])) p = i;
        if (!(m[p][p] > ALIKE * most)) break;
        used[p] = true;
        const double scale = 1 / m[p][p];
        for (int j = 0; j < n; j++) m[p][j] *= scale;
        x[p] *= scale;
        for (int i = 0; i < n; i++) {
            const double factor = m[i][p];
            if (i == p || factor == 0) continue;
            for (int j = 0; j < n; j++) m[i][j] -= factor * m[p][j];
            x[i] -= factor * x[p];
        }
    }
    for (int i = 0; i < n; i++)
        if (!used[i]) x[i] = 0;
}

/* trial: the least move that meets the constraints as they are linearised at the present one. */
static void least_move(holding *h) {
    const int numbers = h->count * h->dimension;
    double gram[ROWS][ROWS], share[ROWS];
    for (int i = 0; i < h->rows; i++) {
        const double *a = row_at(h, i);
        share[i] = h->residual[i];
        for (int k = 0; k < numbers; k++) share[i] += a[k] * h->moved[k];
        for (int j = 0; j <= i; j++) {
            const double *b = row_at(h, j);
            double sum = 0;
            for (int k = 0; k < numbers; k++) sum += a[k] * b[k];
            gram[i][j] = gram[j][i] = sum;
        }
    }
    solve(h->rows, gram, share);
    memset(h->trial, 0, (size_t)numbers * sizeof *h->trial);
    for (int i = 0; i < h->rows; i++)
        for (int k = 0; k < numbers; k++) h->trial[k] += share[i] * row_at(h, i)[k];
}

static bat_status put(holding *h, const double *move) {
    bat_shape *shape = NULL;
    bat_status status = bat_shape_copy(h->before, &shape);
    if (status == BAT_OK) status = bat_shape_move_many(shape, h->level, 0, (size_t)h->count, move);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    bat_shape_free(h->shape);
    h->shape = shape;
    return BAT_OK;
}

/* No less symmetric than before; what lies on the axis may have turned what was uneven. */
static bool is_even(const holding *h) {
    return !h->mirror.on ||
           bat_mirror_uneven(&h->mirror, finest(h->shape), h->turn) <= 2 * h->uneven + NEAR * h->size;
}

/* From the present move to one whose dragged place is at the goal. BAT_TOLERANCE: it does not get there; then the move is
 * what it was. */
static bat_status reach(holding *h, const double *goal) {
    const size_t numbers = (size_t)(h->count * h->dimension);
    double *kept = malloc(numbers * sizeof *kept);
    if (!kept) return BAT_MEMORY;
    memcpy(kept, h->moved, numbers * sizeof *kept);
    bat_status status = measure(h, goal);
    double now = worst(h), best = INFINITY;
    for (int round = 0; round < ROUNDS && status == BAT_OK && now > NEAR * h->size; round++) {
        linearise(h);
        least_move(h);
        memcpy(h->moved, h->trial, numbers * sizeof *kept);
        status = put(h, h->moved);
        if (status == BAT_OK) status = measure(h, goal);
        now = worst(h);
        if (round > 3 && now > 4 * best) break;
        best = fmin(best, now);
    }
    if (status == BAT_OK && (!(now <= NEAR * h->size) || !is_even(h))) status = BAT_TOLERANCE;
    if (status == BAT_NUMBER) status = BAT_TOLERANCE;
    if (status == BAT_TOLERANCE) {
        memcpy(h->moved, kept, numbers * sizeof *kept);
        const bat_status back = put(h, h->moved);
        if (back != BAT_OK) status = back;
    }
    free(kept);
    return status;
}

static bat_status walk(holding *h) {
    double done = 0, step = 1, goal[3];
    while (done < 1) {
        const double to = fmin(1, done + step);
        for (int d = 0; d < h->dimension; d++) goal[d] = h->from[d] + to * (h->goal[d] - h->from[d]);
        const bat_status status = reach(h, goal);
        if (status != BAT_OK && (status != BAT_TOLERANCE || step <= SMALLEST)) return status;
        if (status == BAT_OK)
            done = to;
        else
            step /= 2;
    }
    return BAT_OK;
}

/* The parameter that stands for itself, modulo half of the domain, in shares of the domain. */
static double axis_place(const bat_curve *curve, int turn) {
    const double *t = bat_curve_knots(curve);
    const int n = curve->count, last = bat_curve_knot_count(curve) - 1;
    if (!curve->closed) return 0.5;
    const double sum = t[(turn + curve->degree) % n] - t[0];
    return sum / 2 / (t[last] - t[0]);
}

/* The axis of the finest curve, which is that of the level, too. BAT_SINGULAR: there is none. */
static bat_status find_symmetry(holding *h) {
    const bat_curve *curve = finest(h->before), *level = bat_shape_curve(h->before, h->level);
    const double *wish = h->held->upright, upright[2] = {0, 1}, within = EVEN * h->size;
    if (!h->held->symmetry) return BAT_OK;
    if (!bat_mirror_find(curve, wish[0] != 0 || wish[1] != 0 ? wish : upright, within, &h->mirror,
                         &h->turn) ||
        !bat_mirror_turn(&h->mirror, level, within, &h->level_turn))
        return BAT_SINGULAR;
    double apart = fabs(axis_place(curve, h->turn) - axis_place(level, h->level_turn));
    if (apart > EVEN && fabs(apart - 0.5) > EVEN) return BAT_SINGULAR; /* the sweep runs otherwise */
    h->uneven = bat_mirror_uneven(&h->mirror, curve, h->turn);
    return BAT_OK;
}

/* What is held, as it is now. BAT_SINGULAR: a direction that there is not, or no symmetry. */
static bat_status remember(holding *h) {
    const bat_curve *curve = finest(h->before);
    const int n = h->dimension;
    double at[2 * BAT_DIMENSION_MAX], domain[2];
    bat_curve_domain(curve, domain);
    h->size = bat_curve_size(curve);
    h->length = h->held->length ? bat_curve_length(curve, domain[0], domain[1], PRECISE) : 0;
    h->area = h->held->area ? bat_curve_area(curve) : 0;
    if (h->index < 0) bat_curve_eval(curve, h->u, 0, h->from);
    for (size_t i = 0; i < h->held->point_count; i++)
        bat_curve_eval(curve, h->held->points[i], 0, h->place[i]);
    for (size_t i = 0; i < h->held->direction_count; i++) {
        bat_curve_eval(curve, h->held->directions[i], 1, at);
        const vec way = vec_unit(vec_load(at + n, n));
        if (!(vec_norm(way) > 0)) return BAT_SINGULAR;
        const vec across = n == 2 ? (vec){-way.y, way.x, 0} : vec_any_normal(way);
        vec_store(across, h->normal[i][0]);
        vec_store(vec_cross(way, across), h->normal[i][1]);
    }
    h->rows = n + n * (int)h->held->point_count + (n - 1) * (int)h->held->direction_count + h->held->length +
              h->held->area;
    return find_symmetry(h);
}

static bat_status check(const bat_shape *shape, int level, double u, const double *delta,
                        const bat_shape_held *held) {
    if (!shape || level < 0 || level > shape->count || !delta || !held ||
        (held->point_count && !held->points) || (held->direction_count && !held->directions))
        return BAT_ARGUMENT;
    if (held->point_count > BAT_HELD_MAX || held->direction_count > BAT_HELD_MAX) return BAT_COUNT;
    if (!bat_are_coordinates(delta, (size_t)shape->base->dimension) || !isfinite(u) ||
        !bat_are_coordinates(held->points, held->point_count) ||
        !bat_are_coordinates(held->directions, held->direction_count))
        return BAT_NUMBER;
    if (held->symmetry && shape->base->dimension != 2) return BAT_DIMENSION;
    if (!bat_are_coordinates(held->upright, 2)) return BAT_NUMBER;
    if (held->area && !(shape->base->closed && shape->base->dimension == 2)) return BAT_DIMENSION;
    return BAT_OK;
}

static bat_status change(bat_shape *shape, int level, int index, double u, const double *delta,
                         const bat_shape_held *held) {
    bat_status status = check(shape, level, u, delta, held);
    if (status != BAT_OK) return status;
    const bat_curve *curve = bat_shape_curve(shape, level);
    if (index >= curve->count) return BAT_ARGUMENT;
    holding h = {.before = shape,
                 .held = held,
                 .level = level,
                 .dimension = curve->dimension,
                 .count = curve->count,
                 .index = index,
                 .u = u};
    status = remember(&h);
    if (status != BAT_OK) return status;
    for (int d = 0; d < h.dimension; d++) h.goal[d] = h.from[d] + delta[d];
    const size_t numbers = (size_t)(h.count * h.dimension);
    h.jacobian = calloc(((size_t)h.rows + 2) * numbers, sizeof *h.jacobian);
    if (!h.jacobian) return BAT_MEMORY;
    h.moved = row_at(&h, h.rows), h.trial = row_at(&h, h.rows + 1);
    status = bat_shape_copy(shape, &h.shape);
    if (status == BAT_OK) status = walk(&h);
    free(h.jacobian);
    if (status == BAT_OK)
        bat_shape_adopt(shape, h.shape);
    else
        bat_shape_free(h.shape);
    return status;
}

bat_status bat_shape_drag_held(bat_shape *shape, int level, double u, const double *delta,
                               const bat_shape_held *held) {
    return change(shape, level, -1, u, delta, held);
}

bat_status bat_shape_move_held(bat_shape *shape, int level, int index, const double *delta,
                               const bat_shape_held *held) {
    return index < 0 ? BAT_ARGUMENT : change(shape, level, index, 0, delta, held);
}
