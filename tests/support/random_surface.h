/* Seeded random surfaces of every kind, for property tests. */
#ifndef BATTEN_TESTS_RANDOM_SURFACE_H
#define BATTEN_TESTS_RANDOM_SURFACE_H

#include <batten/surface.h>

#include "support/random_curve.h"

/* Kinds and extra points of each direction as in random_curve. Exits on failure. */
static inline bat_surface *random_surface(random_source *r, const int degree[2], const int kind[2],
                                          const int extra[2]) {
    bat_curve *axis[2];
    for (int d = 0; d < 2; d++) axis[d] = random_curve(r, degree[d], 2, kind[d], extra[d]);
    const size_t count[2] = {bat_curve_count(axis[0]), bat_curve_count(axis[1])};
    const int knots[2] = {bat_curve_knot_count(axis[0]), bat_curve_knot_count(axis[1])};
    const bool closed[2] = {kind[0] == 2, kind[1] == 2};
    double *points = malloc(count[0] * count[1] * 3 * sizeof *points);
    if (!points) abort();
    for (size_t i = 0; i < count[0] * count[1] * 3; i++) points[i] = random_between(r, -10, 10);
    bat_surface *surface = NULL;
    if (bat_surface_create(degree, closed, count, points, knots, bat_curve_knots(axis[0]),
                           bat_curve_knots(axis[1]), &surface) != BAT_OK)
        abort();
    free(points);
    for (int d = 0; d < 2; d++) bat_curve_free(axis[d]);
    return surface;
}

/* A surface by number: cycles through degrees, kinds and sizes. */
static inline bat_surface *some_surface(random_source *r, int number) {
    const int degree[2] = {1 + number % 7, 1 + number * 3 % 7}, kind[2] = {number % 3, number / 3 % 3};
    const int extra[2] = {random_int(r, 0, 6), random_int(r, 0, 6)};
    return random_surface(r, degree, kind, extra);
}

static inline double random_parameter(random_source *r, const bat_surface *surface, bat_direction direction) {
    double domain[2];
    bat_surface_domain(surface, direction, domain);
    return random_between(r, domain[0], domain[1]);
}

#endif
