/* B-splines with weights as files have them, or without. */
#include "format/model/full.h"
#include "format/model/rational.h"

#include <math.h>

static const double SHARE = 1e-6; /* of the size: how far a curve without weights may be from one with them */

static bool is_plain(size_t count, const double *weights) {
    return !weights || (weights[0] != 0 && isfinite(weights[0]) && bat_weights_are_equal(count, weights));
}

static double tolerance_for(size_t count, const double *points) {
    return fmax(SHARE * bat_full_side(count, points), 1e-300);
}

bat_status bat_weighted_curve(int degree, size_t count, double *points, const double *weights,
                              const double *knots, const double range[2], bat_curve **out) {
    if (!is_plain(count, weights))
        return bat_rational_curve(degree, count, points, weights, knots, range, tolerance_for(count, points),
                                  out);
    bat_curve *whole;
    const bat_status status = bat_full_curve(degree, count, points, knots, &whole);
    if (status != BAT_OK || !range) {
        if (status == BAT_OK) *out = whole;
        return status;
    }
    return bat_full_cut(whole, range, out);
}

bat_status bat_weighted_surface(const int degree[2], const size_t count[2], double *points,
                                const double *weights, const double *const knots[2], bat_surface **out) {
    const size_t total = count[0] * count[1];
    if (is_plain(total, weights)) return bat_full_surface(degree, count, points, knots, out);
    return bat_rational_surface(degree, count, points, weights, knots, tolerance_for(total, points), out);
}
