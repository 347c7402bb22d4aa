/* Surfaces whose shape is known: circles are uniform cubic splines through n points of theirs, off by about
 * (2 pi / n)^4 / 700 of the radius. */
#ifndef BATTEN_TESTS_SOLIDS_H
#define BATTEN_TESTS_SOLIDS_H

#include <batten/refine.h>
#include <batten/surface.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double solid_pi = 3.14159265358979323846;

/* What the control points of a spline through n points of a circle are further out by. */
static inline double solid_out(int n) { return 3 / (2 + cos(2 * solid_pi / n)); }

static inline bat_surface *solid_make(const int degree[2], const bool closed[2], const int count[2],
                                      const double *u, const double *v, const double *points) {
    const size_t n[2] = {(size_t)count[0], (size_t)count[1]};
    int knots[2];
    for (int d = 0; d < 2; d++) knots[d] = closed[d] ? count[d] + 1 : count[d] + degree[d] + 1;
    bat_surface *s = NULL;
    if (bat_surface_create(degree, closed, n, points, knots, u, v, &s) != BAT_OK) abort();
    return s;
}

static inline void solid_uniform(int n, double *knots) {
    for (int i = 0; i <= n; i++) knots[i] = i;
}

/* Round the z axis. */
static inline bat_surface *solid_torus(double large, double small, int n, int m) {
    double *points = malloc((size_t)(n * m * 3) * sizeof *points), u[200], v[200];
    if (!points) abort();
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const double a = 2 * solid_pi * i / n, b = 2 * solid_pi * j / m, out = solid_out(m) * small;
            double *p = points + 3 * (i * m + j);
            p[0] = solid_out(n) * cos(a) * (large + out * cos(b));
            p[1] = solid_out(n) * sin(a) * (large + out * cos(b));
            p[2] = out * sin(b);
        }
    solid_uniform(n, u), solid_uniform(m, v);
    bat_surface *s = solid_make((const int[2]){3, 3}, (const bool[2]){true, true}, (const int[2]){n, m}, u, v,
                                points);
    free(points);
    return s;
}

/* Turns control points (distance from the z axis, z) of a profile round it. */
static inline bat_surface *solid_turn(const double *profile, int degree, int count, const double *knots,
                                      int n) {
    double *points = malloc((size_t)(n * count * 3) * sizeof *points), u[200];
    if (!points) abort();
    for (int i = 0; i < n; i++)
        for (int j = 0; j < count; j++) {
            const double a = 2 * solid_pi * i / n;
            double *p = points + 3 * (i * count + j);
            p[0] = solid_out(n) * profile[2 * j] * cos(a);
            p[1] = solid_out(n) * profile[2 * j] * sin(a);
            p[2] = profile[2 * j + 1];
        }
    solid_uniform(n, u);
    bat_surface *s = solid_make((const int[2]){3, degree}, (const bool[2]){true, false},
                                (const int[2]){n, count}, u, knots, points);
    free(points);
    return s;
}

/* Round the z axis, from z = -half to half. */
static inline bat_surface *solid_cylinder(double radius, double half, int n) {
    const double profile[] = {radius, -half, radius, half}, knots[] = {0, 0, 1, 1};
    return solid_turn(profile, 1, 2, knots, n);
}

/* With poles at the ends of the z axis: n spans round it, m from pole to pole. */
static inline bat_surface *solid_sphere(double radius, int n, int m) {
    double ring[400], knots[200];
    bat_curve *whole = NULL, *half = NULL;
    for (int j = 0; j < 2 * m; j++) {
        const double a = solid_pi * j / m;
        ring[2 * j] = solid_out(2 * m) * radius * sin(a),
                 ring[2 * j + 1] = -solid_out(2 * m) * radius * cos(a);
    }
    solid_uniform(2 * m, knots);
    if (bat_curve_create(2, 3, true, (size_t)(2 * m), ring, 2 * m + 1, knots, &whole) != BAT_OK) abort();
    if (bat_curve_piece(whole, 2, m + 2, &half) != BAT_OK) abort();
    const int count = (int)bat_curve_count(half);
    memcpy(ring, bat_curve_points(half), (size_t)(2 * count) * sizeof(double));
    ring[0] = ring[2 * count - 2] = 0;
    ring[3] = ring[1], ring[2 * count - 3] = ring[2 * count - 1];
    bat_surface *s = solid_turn(ring, 3, count, bat_curve_knots(half), n);
    bat_curve_free(whole);
    bat_curve_free(half);
    return s;
}

/* Moved by (x, y, z) after a turn by `angle` about an axis (0: x, 1: y, 2: z). Frees the surface. */
static inline bat_surface *solid_move(bat_surface *s, int axis, double angle, double x, double y, double z) {
    double m[12] = {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z};
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    m[4 * a + a] = m[4 * b + b] = cos(angle);
    m[4 * a + b] = -sin(angle), m[4 * b + a] = sin(angle);
    bat_surface *moved = NULL;
    if (bat_surface_transform(s, m, &moved) != BAT_OK) abort();
    bat_surface_free(s);
    return moved;
}

/* A sheet z = height(x, y) over [-1, 1]^2, cubic, its control points above their Greville abscissae. */
static inline bat_surface *solid_sheet(int n, double height(double x, double y)) {
    double points[3 * 40 * 40], knots[60];
    for (int i = 0; i < n + 4; i++) knots[i] = fmin(fmax(i - 3, 0), n - 3);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double *p = points + 3 * (i * n + j);
            p[0] = 2 * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / (3 * (n - 3)) - 1;
            p[1] = 2 * (knots[j + 1] + knots[j + 2] + knots[j + 3]) / (3 * (n - 3)) - 1;
            p[2] = height(p[0], p[1]);
        }
    return solid_make((const int[2]){3, 3}, (const bool[2]){false, false}, (const int[2]){n, n}, knots, knots,
                      points);
}

/* The plane through `at` with normal n: a bilinear patch, `half` to each side. */
static inline bat_surface *solid_plane(const double at[3], const double n[3], double half) {
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), knots[] = {0, 0, 1, 1};
    const int least = fabs(n[0]) <= fabs(n[1]) && fabs(n[0]) <= fabs(n[2]) ? 0
                      : fabs(n[1]) <= fabs(n[2])                           ? 1
                                                                           : 2;
    double x[3], y[3], points[12], norm = 0;
    for (int c = 0; c < 3; c++) x[c] = (c == least) - n[c] * n[least] / (length * length);
    for (int c = 0; c < 3; c++) norm += x[c] * x[c];
    for (int c = 0; c < 3; c++) x[c] /= sqrt(norm);
    for (int c = 0; c < 3; c++)
        y[c] = (n[(c + 1) % 3] * x[(c + 2) % 3] - n[(c + 2) % 3] * x[(c + 1) % 3]) / length;
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++)
            points[3 * k + c] = at[c] + half * ((k / 2 ? 1 : -1) * x[c] + (k % 2 ? 1 : -1) * y[c]);
    return solid_make((const int[2]){1, 1}, (const bool[2]){false, false}, (const int[2]){2, 2}, knots, knots,
                      points);
}

#endif
