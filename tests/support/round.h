/* Round surfaces: splines so near to a sphere, a torus, a tube that tests can compare with these. */
#ifndef BATTEN_TESTS_ROUND_H
#define BATTEN_TESTS_ROUND_H

#include <batten/surface.h>
#include <math.h>
#include <stdlib.h>

enum { ROUND = 48 }; /* points of a circle */

static const double round_pi = 3.14159265358979323846;

/* The control point of the uniform cubic that passes through a circle of radius 1 at its knots. */
static inline void round_point(int k, double out[2]) {
    const double far = 3 / (2 + cos(2 * round_pi / ROUND));
    out[0] = far * cos(2 * round_pi * k / ROUND), out[1] = far * sin(2 * round_pi * k / ROUND);
}

/* Turns a profile (x from the axis, z) about the z axis: closed along u, normals outwards when the profile goes up the
 * outside. count: profile points; closed: uniform, from knot 0; else clamped. */
static inline bat_surface *round_turn(const double (*profile)[2], size_t count, bool closed) {
    double *points = malloc(ROUND * count * 3 * sizeof *points), u[ROUND + 1], v[ROUND + 8];
    const int spans = closed ? (int)count : (int)count - 3, knots = closed ? (int)count + 1 : (int)count + 4;
    if (!points || count > ROUND) abort();
    for (int i = 0; i <= ROUND; i++) u[i] = i;
    for (int i = 0; i < knots; i++) v[i] = closed ? i : fmin(fmax(i - 3, 0), spans);
    for (int i = 0; i < ROUND; i++) {
        double way[2];
        round_point(i, way);
        for (size_t j = 0; j < count; j++) {
            double *p = points + 3 * ((size_t)i * count + j);
            p[0] = profile[j][0] * way[0], p[1] = profile[j][0] * way[1], p[2] = profile[j][1];
        }
    }
    bat_surface *surface = NULL;
    if (bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, closed},
                           (const size_t[2]){ROUND, count}, points, (const int[2]){ROUND + 1, knots}, u, v,
                           &surface) != BAT_OK)
        abort();
    free(points);
    return surface;
}

/* Radius 1 about the origin; collapsed at both poles. */
static inline bat_surface *round_sphere(void) {
    enum { HALF = ROUND / 2, COUNT = HALF + 3, FIRST = -ROUND / 4 };
    double profile[COUNT][2], a[2], b[2];
    for (int k = 1; k < HALF; k++) round_point(FIRST + k, profile[k + 1]);
    for (int end = 0; end < 2; end++) {
        round_point(end ? -FIRST : FIRST, a), round_point(end ? -FIRST - 1 : FIRST + 1, b);
        double *pole = profile[end ? COUNT - 1 : 0], *next = profile[end ? COUNT - 2 : 1];
        pole[0] = 0, pole[1] = end ? 1 : -1;
        for (int c = 0; c < 2; c++) next[c] = (2 * a[c] + b[c]) / 3;
        next[1] = end ? 1 : -1; /* level at the pole */
    }
    return round_turn((const double(*)[2])profile, COUNT, false);
}

/* Closed in both directions; radii `wide` and 1. */
static inline bat_surface *round_torus(double wide) {
    double profile[ROUND][2];
    for (int k = 0; k < ROUND; k++) {
        round_point(k, profile[k]);
        profile[k][0] += wide;
    }
    return round_turn((const double(*)[2])profile, ROUND, true);
}

/* A tube of radius 1 from z = 0 to `tall`, open at both ends. */
static inline bat_surface *round_tube(double tall) {
    const double profile[4][2] = {{1, 0}, {1, tall / 3}, {1, tall * 2 / 3}, {1, tall}};
    return round_turn(profile, 4, false);
}

#endif
