/* Lofts (P&T 10.3): the control points of the sections, brought onto the same knots, are interpolated across. */
#include "curve/collocate.h"
#include "form/surface/surface.h"
#include "form/sweep/sections.h"

#include <batten/sweep.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 3, MOST_MORE = 4 };

/* The sections' parameters: chords between control points, averaged over all of them. Chords of length 0 have no share
 * in it. False: two neighbours are the same. */
static bool spread_sections(int count, bat_curve *const *sections, double *v) {
    const int points = sections[0]->count;
    for (int k = 0; k < count; k++) v[k] = 0;
    for (int i = 0; i < points; i++) {
        double whole = 0;
        for (int k = 1; k < count; k++)
            whole += bat_distance(bat_curve_points(sections[k]) + 3 * i,
                                  bat_curve_points(sections[k - 1]) + 3 * i, 3);
        for (int k = 1; k < count && whole > 0; k++)
            v[k] += bat_distance(bat_curve_points(sections[k]) + 3 * i,
                                 bat_curve_points(sections[k - 1]) + 3 * i, 3) /
                    whole;
    }
    for (int k = 1; k < count; k++)
        if (!(v[k] > 0)) return false;
    for (int k = 1; k < count; k++) v[k] += v[k - 1];
    const double whole = v[count - 1];
    for (int k = 1; k < count; k++) v[k] = k + 1 < count ? v[k] / whole : 1;
    for (int k = 1; k < count; k++)
        if (!(v[k] - v[k - 1] > 1e-12)) return false;
    return true;
}

/* Clamped knots at the sections; the second and the last but one have none (degree 3), so that the count fits. */
static void place_knots(int count, const double *v, int degree, double *knots) {
    int filled = 0;
    for (int i = 0; i <= degree; i++) knots[filled++] = 0;
    for (int k = 2; k < count - 2 && degree == DEGREE; k++) knots[filled++] = v[k];
    for (int i = 0; i <= degree; i++) knots[filled++] = 1;
}

/* The spline across, without points. */
static bat_status make_space(int count, const double *v, bat_curve **out) {
    const int degree = count > DEGREE ? DEGREE : count - 1;
    bat_status status = bat_curve_allocate(degree, 2, false, count, out);
    if (status == BAT_OK) place_knots(count, v, degree, bat_curve_own_knots(*out));
    return status;
}

/* A row of the surface along v for every point of the sections. */
static bat_status across(int count, bat_curve *const *sections, const double *v, const bat_curve *space,
                         bat_surface **out) {
    const bat_curve *first = sections[0];
    const int degree[2] = {first->degree, space->degree}, size[2] = {first->count, count};
    const int columns = 3 * first->count;
    bat_surface *made;
    bat_status status = bat_surface_allocate(degree, (const bool[2]){first->closed, false}, size, &made);
    if (status != BAT_OK) return status;
    double *values = malloc((size_t)count * (size_t)columns * sizeof *values);
    status = values ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        for (int k = 0; k < count; k++)
            memcpy(values + (size_t)k * (size_t)columns, bat_curve_points(sections[k]),
                   (size_t)columns * sizeof *values);
        status = bat_collocate(space, v, columns, values);
    }
    if (status == BAT_OK) {
        memcpy(bat_curve_own_knots(&made->axis[0]), bat_curve_knots(first),
               (size_t)bat_curve_knot_count(first) * sizeof(double));
        memcpy(bat_curve_own_knots(&made->axis[1]), bat_curve_knots(space),
               (size_t)bat_curve_knot_count(space) * sizeof(double));
        for (int i = 0; i < first->count; i++)
            for (int k = 0; k < count; k++)
                memcpy(bat_surface_own_row(made, i) + 3 * k, values + (size_t)k * (size_t)columns + 3 * i,
                       3 * sizeof(double));
    }
    free(values);
    if (status == BAT_OK) return bat_surface_finish(made, out);
    bat_surface_free(made);
    return status;
}

static bat_status loft(int count, bat_curve *const *sections, double *v, bat_surface **out) {
    if (!spread_sections(count, sections, v)) return BAT_SINGULAR;
    bat_curve *space = NULL;
    bat_status status = make_space(count, v, &space);
    if (status == BAT_OK) status = across(count, sections, v, space, out);
    bat_curve_free(space);
    return status;
}

bat_status bat_surface_loft(size_t count, const bat_curve *const *sections, bat_surface **out, double *v) {
    if (!sections || !out) return BAT_ARGUMENT;
    const int inside = bat_count_inside(count);
    if (inside < 2 || inside > BAT_POINTS_MAX) return BAT_COUNT;
    for (int i = 0; i < inside; i++)
        if (!sections[i] || sections[i]->closed != sections[0]->closed) return BAT_ARGUMENT;
    bat_curve **matched = malloc(count * sizeof *matched);
    double *places = malloc(count * sizeof *places), domain[2];
    bat_status status = matched && places ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int largest = 0;
        bat_curve_domain(sections[0], domain);
        status = bat_sections_match(inside, sections, domain, matched, &largest);
        if (status == BAT_OK) {
            status = matched[0]->count > MOST_MORE * largest ? BAT_COUNT : loft(inside, matched, places, out);
            bat_sections_free(inside, matched);
        }
    }
    if (status == BAT_OK && v) memcpy(v, places, count * sizeof *v);
    free(matched), free(places);
    return status;
}
