/* Knots and degrees of a surface change row by row, as its rows are curves. For the other
 * direction, u and v are exchanged before and after, which keeps every bit. */
#include "form/surface/surface.h"
#include "hands/levels/shape.h"

#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_surface_transpose(const bat_surface *surface, bat_surface **out) {
    const bat_curve *a = &surface->axis[0], *b = &surface->axis[1];
    const int degree[2] = {b->degree, a->degree}, count[2] = {b->count, a->count};
    const bool closed[2] = {b->closed, a->closed};
    bat_surface *turned;
    bat_status status = bat_surface_allocate(degree, closed, count, &turned);
    if (status != BAT_OK) return status;
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &surface->axis[1 - d];
        memcpy(turned->axis[d].knots, axis->knots,
               ((size_t)axis->spread + (size_t)axis->degree + 1) * sizeof(double));
    }
    const size_t m = (size_t)a->spread, n = (size_t)b->spread;
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++)
            memcpy(turned->points + (j * m + i) * 3, surface->points + (i * n + j) * 3, 3 * sizeof(double));
    turned->size = surface->size;
    *out = turned;
    return BAT_OK;
}

/* A new surface with the axis along u of `surface`, and along v the axis of the first changed row. */
static bat_status begin(const bat_surface *surface, const bat_curve *row, bat_surface **out) {
    const bat_curve *a = &surface->axis[0];
    const int degree[2] = {a->degree, row->degree}, count[2] = {a->count, row->count};
    const bool closed[2] = {a->closed, row->closed};
    bat_status status = bat_surface_allocate(degree, closed, count, out);
    if (status != BAT_OK) return status;
    memcpy(bat_curve_own_knots(&(*out)->axis[0]), bat_curve_knots(a),
           (size_t)bat_curve_knot_count(a) * sizeof(double));
    memcpy(bat_curve_own_knots(&(*out)->axis[1]), bat_curve_knots(row),
           (size_t)bat_curve_knot_count(row) * sizeof(double));
    return BAT_OK;
}

static bat_status change_rows(const bat_surface *surface, bat_row_operation *change, int knot_count,
                              const double *knots, bat_surface **out) {
    const int lead = surface->axis[0].closed ? surface->axis[0].degree : 0;
    bat_surface *fresh = NULL;
    for (int i = 0; i < surface->axis[0].count; i++) {
        const bat_curve row = bat_surface_stored_row(surface, lead + i);
        bat_curve *changed = NULL;
        bat_status status = change(&row, knot_count, knots, &changed);
        if (status == BAT_OK && !fresh) status = begin(surface, changed, &fresh);
        if (status != BAT_OK) {
            bat_curve_free(changed);
            bat_surface_free(fresh);
            return status;
        }
        memcpy(bat_surface_own_row(fresh, i), bat_curve_points(changed),
               bat_curve_count(changed) * 3 * sizeof(double));
        bat_curve_free(changed);
    }
    return bat_surface_finish(fresh, out);
}

bat_status bat_surface_change(const bat_surface *surface, bat_direction direction, bat_row_operation *how,
                              int knot_count, const double *knots, bat_surface **out) {
    if (!surface || !out) return BAT_ARGUMENT;
    if (direction == BAT_V) return change_rows(surface, how, knot_count, knots, out);
    bat_surface *turned, *changed = NULL;
    bat_status status = bat_surface_transpose(surface, &turned);
    if (status != BAT_OK) return status;
    status = change_rows(turned, how, knot_count, knots, &changed);
    bat_surface_free(turned);
    if (status != BAT_OK) return status;
    status = bat_surface_transpose(changed, out);
    bat_surface_free(changed);
    return status;
}

bat_status bat_surface_insert_knots(const bat_surface *surface, bat_direction direction, int knot_count,
                                    const double *knots, bat_surface **out) {
    return bat_surface_change(surface, direction, bat_curve_insert_knots, knot_count, knots, out);
}

/* Whether the knots are those that the surface has. */
static bool has_knots(const bat_surface *surface, bat_direction direction, int count, const double *knots) {
    return knots && count == bat_surface_knot_count(surface, direction) &&
           memcmp(knots, bat_surface_knots(surface, direction), (size_t)count * sizeof *knots) == 0;
}

bat_status bat_surface_refine(const bat_surface *surface, bat_direction direction, int knot_count,
                              const double *knots, bat_surface **out) {
    if (surface && out && has_knots(surface, direction, knot_count, knots))
        return bat_surface_copy(surface, out);
    return bat_surface_change(surface, direction, bat_curve_refine, knot_count, knots, out);
}

static bat_status raise_row(const bat_curve *row, int degree, const double *unused, bat_curve **out) {
    (void)unused;
    return bat_curve_elevate(row, degree, out);
}

bat_status bat_surface_raise(const bat_surface *surface, bat_direction direction, int degree,
                             bat_surface **out) {
    return bat_surface_change(surface, direction, raise_row, degree, NULL, out);
}

static bat_status coarsen_row(const bat_curve *row, int count, const double *unused, bat_curve **out) {
    (void)unused;
    return bat_curve_coarsen(row, count, out);
}

bat_status bat_surface_coarsen(const bat_surface *surface, bat_direction direction, int count,
                               bat_surface **out) {
    return bat_surface_change(surface, direction, coarsen_row, count, NULL, out);
}

static bat_status drop_from_row(const bat_curve *row, int unused, const double *knot, bat_curve **out) {
    (void)unused;
    return bat_curve_remove_knot(row, *knot, 1, BAT_COORDINATE_MAX, out, NULL, NULL);
}

bat_status bat_surface_drop_knot(const bat_surface *surface, double v, const double *allowed,
                                 bat_surface **out, double *error) {
    const int lead = surface->axis[0].closed ? surface->axis[0].degree : 0;
    *error = 0;
    for (int i = 0; i < surface->axis[0].count; i++) {
        const bat_curve row = bat_surface_stored_row(surface, lead + i);
        bat_curve *fewer = NULL;
        int removed = 0;
        double moved = 0;
        const bat_status status = bat_curve_remove_knot(&row, v, 1, allowed[i], &fewer, &removed, &moved);
        bat_curve_free(fewer);
        if (status == BAT_MEMORY) return status;
        if (status != BAT_OK || removed == 0) return BAT_OK;
        *error = fmax(*error, moved);
    }
    return change_rows(surface, drop_from_row, 0, &v, out);
}
