/* The surface as a value: creation, checks, access, copy, comparison, transformation. */
#include "form/surface/surface.h"
#include "base/pose.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD = (sizeof(bat_surface) + sizeof(double) - 1) / sizeof(double) };

static size_t knots_stored(const bat_curve *axis) { return (size_t)axis->spread + (size_t)axis->degree + 1; }

static size_t numbers_stored(const bat_surface *surface) {
    return (size_t)surface->axis[0].spread * (size_t)surface->axis[1].spread * 3;
}

static void place_arrays(bat_surface *surface) {
    surface->axis[0].knots = (double *)(void *)surface + HEAD;
    surface->axis[1].knots = surface->axis[0].knots + knots_stored(&surface->axis[0]);
    surface->points = surface->axis[1].knots + knots_stored(&surface->axis[1]);
}

bat_status bat_surface_allocate(const int degree[2], const bool closed[2], const int count[2],
                                bat_surface **out) {
    bat_surface head = {.size = 0};
    for (int d = 0; d < 2; d++) {
        const int p = degree[d], n = count[d];
        if (p < 1 || p > BAT_DEGREE_MAX) return BAT_DEGREE;
        if (n < (closed[d] ? 2 : p + 1) || n > BAT_POINTS_MAX) return BAT_COUNT;
        head.axis[d] = (bat_curve){
            .degree = p, .dimension = 3, .closed = closed[d], .count = n, .spread = closed[d] ? n + p : n};
    }
    if (count[0] > BAT_POINTS_MAX / count[1]) return BAT_COUNT;
    const size_t knots = knots_stored(&head.axis[0]) + knots_stored(&head.axis[1]);
    double *block = malloc((HEAD + knots + numbers_stored(&head)) * sizeof(double));
    if (!block) return BAT_MEMORY;
    bat_surface *surface = (bat_surface *)(void *)block;
    *surface = head;
    place_arrays(surface);
    *out = surface;
    return BAT_OK;
}

bat_curve bat_surface_stored_row(const bat_surface *surface, int i) {
    bat_curve row = surface->axis[1];
    row.points = surface->points + (size_t)i * (size_t)row.spread * 3;
    return row;
}

bat_curve bat_surface_whole(const bat_surface *surface) {
    bat_curve whole = surface->axis[0];
    whole.dimension = 3 * surface->axis[1].spread;
    whole.points = surface->points;
    return whole;
}

double *bat_surface_own_row(bat_surface *surface, int i) {
    const bat_curve *u = &surface->axis[0];
    bat_curve row = bat_surface_stored_row(surface, i + (u->closed ? u->degree : 0));
    return bat_curve_own_points(&row);
}

static bool all_equal(const bat_surface *surface) {
    const double *first = bat_surface_row(surface, 0);
    for (int i = 0; i < surface->axis[0].count; i++) {
        const double *row = bat_surface_row(surface, i);
        for (int j = 0; j < 3 * surface->axis[1].count; j++)
            if (row[j] != first[j % 3]) return false;
    }
    return true;
}

static bat_status validate(const bat_surface *surface) {
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &surface->axis[d];
        bat_status status = bat_knots_check(axis->degree, axis->closed, axis->count, bat_curve_knots(axis));
        if (status != BAT_OK) return status;
    }
    const int lead = surface->axis[0].closed ? surface->axis[0].degree : 0;
    for (int i = 0; i < surface->axis[0].count; i++) {
        const bat_curve row = bat_surface_stored_row(surface, lead + i);
        if (bat_points_check(&row) != BAT_OK) return BAT_NUMBER;
    }
    return all_equal(surface) ? BAT_SINGULAR : BAT_OK;
}

bat_status bat_surface_finish(bat_surface *surface, bat_surface **out) {
    bat_status status = validate(surface);
    if (status != BAT_OK) {
        free(surface);
        return status;
    }
    const int lead = surface->axis[0].closed ? surface->axis[0].degree : 0;
    for (int i = 0; i < surface->axis[0].count; i++) {
        bat_curve row = bat_surface_stored_row(surface, lead + i);
        bat_curve_unroll(&row);
    }
    bat_curve whole = bat_surface_whole(surface);
    bat_curve_unroll(&whole);
    double low[3], high[3];
    bat_surface_box(surface, low, high);
    surface->size = 0;
    for (int c = 0; c < 3; c++) surface->size = bat_hypot(surface->size, high[c] - low[c]);
    *out = surface;
    return BAT_OK;
}

bat_status bat_surface_create(const int degree[2], const bool closed[2], const size_t count[2],
                              const double *points, const int knot_count[2], const double *u_knots,
                              const double *v_knots, bat_surface **out) {
    if (!degree || !closed || !count || !points || !knot_count || !u_knots || !v_knots || !out)
        return BAT_ARGUMENT;
    const int inside[2] = {bat_count_inside(count[0]), bat_count_inside(count[1])};
    bat_surface *surface;
    bat_status status = bat_surface_allocate(degree, closed, inside, &surface);
    if (status != BAT_OK) return status;
    for (int d = 0; d < 2; d++) {
        bat_curve *axis = &surface->axis[d];
        if (knot_count[d] != bat_curve_knot_count(axis)) {
            free(surface);
            return BAT_KNOTS;
        }
        memcpy(bat_curve_own_knots(axis), d == 0 ? u_knots : v_knots, (size_t)knot_count[d] * sizeof(double));
    }
    for (size_t i = 0; i < count[0]; i++)
        memcpy(bat_surface_own_row(surface, (int)i), points + i * count[1] * 3,
               count[1] * 3 * sizeof(double));
    return bat_surface_finish(surface, out);
}

bat_status bat_surface_copy(const bat_surface *surface, bat_surface **out) {
    if (!surface || !out) return BAT_ARGUMENT;
    const size_t size = (size_t)(surface->points - (const double *)(const void *)surface) +
                        numbers_stored(surface);
    double *block = malloc(size * sizeof(double));
    if (!block) return BAT_MEMORY;
    memcpy(block, surface, size * sizeof(double));
    bat_surface *copy = (bat_surface *)(void *)block;
    place_arrays(copy);
    *out = copy;
    return BAT_OK;
}

void bat_surface_free(bat_surface *surface) { free(surface); }

static const bat_curve *axis_of(const bat_surface *surface, bat_direction direction) {
    return &surface->axis[direction == BAT_V];
}

int bat_surface_degree(const bat_surface *surface, bat_direction direction) {
    return axis_of(surface, direction)->degree;
}
bool bat_surface_is_closed(const bat_surface *surface, bat_direction direction) {
    return axis_of(surface, direction)->closed;
}
size_t bat_surface_count(const bat_surface *surface, bat_direction direction) {
    return bat_curve_count(axis_of(surface, direction));
}
int bat_surface_knot_count(const bat_surface *surface, bat_direction direction) {
    return bat_curve_knot_count(axis_of(surface, direction));
}
const double *bat_surface_knots(const bat_surface *surface, bat_direction direction) {
    return bat_curve_knots(axis_of(surface, direction));
}
void bat_surface_domain(const bat_surface *surface, bat_direction direction, double domain[2]) {
    bat_curve_domain(axis_of(surface, direction), domain);
}
void bat_surface_spread(const bat_surface *surface, bat_direction direction, size_t count, double *out) {
    bat_curve_spread(axis_of(surface, direction), count, out);
}
double bat_surface_size(const bat_surface *surface) { return surface->size; }

double bat_surface_least_chord(const bat_surface *surface) {
    const size_t count = 3 * (size_t)surface->axis[0].spread * (size_t)surface->axis[1].spread;
    double most = 0;
    for (size_t i = 0; i < count; i++) most = fmax(most, fabs(surface->points[i]));
    return 1e-12 * most;
}

const double *bat_surface_row(const bat_surface *surface, int i) {
    const bat_curve *u = &surface->axis[0];
    if (i < 0 || i >= u->count) return NULL;
    const bat_curve row = bat_surface_stored_row(surface, i + (u->closed ? u->degree : 0));
    return bat_curve_points(&row);
}

void bat_surface_box(const bat_surface *surface, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) low[c] = INFINITY, high[c] = -INFINITY;
    for (int i = 0; i < surface->axis[0].count; i++) {
        const double *row = bat_surface_row(surface, i);
        for (int j = 0; j < surface->axis[1].count; j++)
            for (int c = 0; c < 3; c++) { /* finite numbers: no call of fmin is needed */
                const double x = row[3 * j + c];
                low[c] = x < low[c] ? x : low[c];
                high[c] = x > high[c] ? x : high[c];
            }
    }
}

bool bat_surface_is_equal(const bat_surface *a, const bat_surface *b) {
    for (int d = 0; d < 2; d++) {
        const bat_curve *x = &a->axis[d], *y = &b->axis[d];
        if (x->degree != y->degree || x->closed != y->closed || x->count != y->count) return false;
        if (memcmp(x->knots, y->knots, knots_stored(x) * sizeof(double)) != 0) return false;
    }
    return memcmp(a->points, b->points, numbers_stored(a) * sizeof(double)) == 0;
}

bat_status bat_surface_transform(const bat_surface *surface, const double *matrix, bat_surface **out) {
    if (!surface || !matrix || !out) return BAT_ARGUMENT;
    bat_surface *image;
    bat_status status = bat_surface_copy(surface, &image);
    if (status != BAT_OK) return status;
    for (int i = 0; i < surface->axis[0].count; i++)
        bat_pose_apply(matrix, (size_t)surface->axis[1].count, bat_surface_row(surface, i),
                       bat_surface_own_row(image, i));
    return bat_surface_finish(image, out);
}
