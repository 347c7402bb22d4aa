/* Any curve, any point: no point of the curve is nearer than the reported closest one; minima are sorted. */
#include <batten/measure.h>
#include <batten/nearest.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A finder gives the same as a single query; no step of a projection moves away; a curve lies on itself. */
static void find(const bat_curve *curve, const double *point, const bat_near *near) {
    bat_finder *finder;
    bat_near same;
    double domain[2], at[3], there = 0, back = 0, before = 0, after = 0;
    if (bat_finder_create(curve, &finder) != BAT_OK) abort();
    bat_finder_nearest(finder, point, &same);
    if (same.u != near->u || same.distance != near->distance) abort();
    bat_finder_free(finder);
    bat_curve_domain(curve, domain);
    const double u = 0.3 * domain[0] + 0.7 * domain[1], v = bat_curve_project_near(curve, point, u, 4);
    bat_curve_eval(curve, u, 0, at);
    for (int c = 0; c < bat_curve_dimension(curve); c++) before = hypot(before, at[c] - point[c]);
    bat_curve_eval(curve, v, 0, at);
    for (int c = 0; c < bat_curve_dimension(curve); c++) after = hypot(after, at[c] - point[c]);
    if (!(after <= before * (1 + 1e-12))) abort();
    if (bat_curve_distance(curve, curve, 2, &there, &back) != BAT_OK) abort();
    if (!(there <= 1e-9 * (bat_curve_size(curve) + hypot(hypot(at[0], at[1]), before))) || there != back)
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { MOST = 24 };
    double knots[MOST + 8], points[MOST * 3], point[3], t = 0;
    if (size < 8) return 0;
    const int m = data[0] & 1 ? 3 : 2, p = 1 + data[1] % 7;
    const bool closed = data[0] & 2, wide = data[0] & 4;
    const int n = p + 1 + data[2] % (MOST - 7), count = closed ? n + 1 : n + p + 1;
    for (int c = 0; c < 3; c++) point[c] = (double)data[3 + c] - 128;
    data += 6, size -= 6;
    for (int i = 0; i < count; i++) {
        knots[i] = t;
        if (size > 0) t += *data % 4 ? 0.25 * (*data % 16) : 0, data++, size--;
    }
    for (int i = 0; i < n * m; i++) {
        points[i] = 0;
        if (wide && size >= 8)
            memcpy(points + i, data, 8), data += 8, size -= 8;
        else if (size > 0)
            points[i] = (double)*data - 128, data++, size--;
    }
    bat_curve *curve;
    if (bat_curve_create(m, p, closed, (size_t)n, points, closed ? n + 1 : n + p + 1, knots, &curve) !=
        BAT_OK)
        return 0;
    bat_near near, all[8];
    size_t found;
    double domain[2], at[3], u[8], low[3], high[3];
    if (bat_curve_nearest(curve, point, &near) != BAT_OK) abort();
    if (bat_curve_nearest_all(curve, point, INFINITY, 8, all, &found) != BAT_OK) abort();
    for (size_t i = 1; i < found && i < 8; i++)
        if (all[i].distance < all[i - 1].distance) abort();
    bat_curve_domain(curve, domain);
    bat_curve_bounds(curve, low, high); /* rounding also grows with the distance from the origin */
    const double scale = bat_curve_size(curve) + near.distance + fabs(high[0]) + fabs(high[1]) +
                         (m == 3 ? fabs(high[2]) : 0);
    for (int i = 0; i <= 64; i++) {
        double d = 0;
        const double v = domain[0] + (domain[1] - domain[0]) * i / 64;
        bat_curve_eval(curve, v, 0, at);
        for (int c = 0; c < m; c++) d = hypot(d, at[c] - point[c]);
        if (d < near.distance - 1e-9 * scale) abort();
        for (int c = 0; c < m; c++)
            if (at[c] < low[c] - 1e-9 * scale || at[c] > high[c] + 1e-9 * scale) abort();
    }
    const double length = bat_curve_length(curve, domain[0], domain[1], 1e-6);
    if (!(length >= 0)) abort();
    (void)bat_curve_at_length(curve, domain[0], 0.5 * length, 1e-6);
    (void)bat_curve_inflections(curve, 8, u);
    (void)bat_curve_extremes(curve, 0, 8, u);
    if (!isfinite(bat_curve_curvature(curve, near.u))) abort();
    find(curve, point, &near);
    bat_curve_free(curve);
    return 0;
}
