/* Lengths, boxes, curvature, inflections and the distance of two curves. */
#include <batten/measure.h>

#include <batten/nearest.h>
#include "curve/hodograph.h"
#include "base/gauss.h"
#include "base/real.h"
#include "curve/roots.h"

#include <float.h>
#include <math.h>

enum { ORDERS = BAT_DEGREE_MAX + 1 };

/* ---- Length ---- */

static double sane(double relative) { return !(relative > 1e-14) ? 1e-14 : relative > 1 ? 1 : relative; }

/* Within the domain, a <= b. */
static double length_inside(const bat_curve *curve, double a, double b, double relative) {
    if (!(b > a)) return 0;
    const double *t = curve->knots;
    const double density = bat_hodograph_density(curve, relative);
    double sum = 0;
    bat_hodograph h;
    for (int i = bat_span(curve, a, -1); i < curve->spread && t[i] < b; i++) {
        if (!(t[i + 1] > t[i])) continue;
        bat_hodograph_of(curve, i - curve->degree, density, &h);
        sum += h.scale * bat_hodograph_length(&h, a > t[i] ? a : t[i], b < t[i + 1] ? b : t[i + 1], relative);
    }
    return sum;
}

double bat_curve_length(const bat_curve *curve, double u0, double u1, double relative) {
    if (isnan(u0) || isnan(u1)) return (double)NAN;
    if (u1 < u0) return -bat_curve_length(curve, u1, u0, relative);
    const double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    relative = sane(relative);
    if (!curve->closed) return length_inside(curve, fmax(u0, start), fmin(u1, end), relative);
    const double period = end - start, turns = floor((u1 - u0) / period);
    if (!isfinite(turns)) return turns;
    const double a = bat_curve_reduce(curve, u0), b = a + fmin(fmax((u1 - u0) - turns * period, 0), period);
    double sum = turns > 0 ? turns * length_inside(curve, start, end, relative) : 0;
    sum += length_inside(curve, a, fmin(b, end), relative);
    if (b > end) sum += length_inside(curve, start, b - period, relative);
    return sum;
}

double bat_curve_at_length(const bat_curve *curve, double u0, double s, double relative) {
    if (isnan(u0) || isnan(s)) return (double)NAN;
    const int p = curve->degree;
    const double *t = curve->knots, start = t[p], end = t[curve->spread], period = end - start;
    const double from = bat_curve_reduce(curve, u0);
    if (isnan(from)) return from;
    if (s == 0) return curve->closed ? u0 : from;
    relative = sane(relative);
    const double density = bat_hodograph_density(curve, relative);
    double shift = curve->closed ? u0 - from : 0; /* the turn in which the result lies */
    if (curve->closed) {
        const double all = length_inside(curve, start, end, relative);
        if (!(all > 0) || !isfinite(s / all)) return u0;
        const double turns = trunc(s / all);
        shift += turns * period, s -= turns * all;
        if (s == 0) return from + shift;
    }
    double u = from, rest = fabs(s);
    bat_hodograph h;
    if (s > 0) {
        for (int i = bat_span(curve, u, -1);; i++) {
            if (i >= curve->spread) {
                if (!curve->closed) return end;
                i = p, u = start, shift += period;
            }
            if (!(t[i + 1] > t[i])) continue;
            bat_hodograph_of(curve, i - p, density, &h);
            const double all = bat_hodograph_length(&h, u, t[i + 1], relative), left = rest / h.scale;
            if (left < all) return bat_hodograph_at_length(&h, u, t[i + 1], left, all, relative) + shift;
            rest -= h.scale * all, u = t[i + 1];
            if (rest <= 0) return u + shift;
        }
    }
    for (int i = bat_span_left(curve, u, -1);; i--) {
        if (i < p || u == start) {
            if (!curve->closed) return start;
            i = curve->spread - 1, u = end, shift -= period;
        }
        if (!(t[i + 1] > t[i])) continue;
        bat_hodograph_of(curve, i - p, density, &h);
        const double all = bat_hodograph_length(&h, t[i], u, relative), left = rest / h.scale;
        if (left < all) return bat_hodograph_at_length(&h, t[i], u, all - left, all, relative) + shift;
        rest -= h.scale * all, u = t[i];
        if (rest <= 0) return u + shift;
    }
}

/* ---- Box ---- */

static void widen(double x, double *low, double *high) {
    if (x < *low) *low = x;
    if (x > *high) *high = x;
}

void bat_curve_bounds(const bat_curve *curve, double *low, double *high) {
    const int p = curve->degree, m = curve->dimension;
    for (int c = 0; c < m; c++) low[c] = INFINITY, high[c] = -INFINITY;
    for (int i = p; i < curve->spread; i++) {
        if (!(curve->knots[i + 1] > curve->knots[i])) continue;
        double b[ORDERS * BAT_DIMENSION_MAX];
        bat_span_bezier(curve, i, b);
        for (int c = 0; c < m; c++) {
            widen(b[c], low + c, high + c);
            widen(b[p * m + c], low + c, high + c);
            bool inside = true;
            for (int j = 1; j < p; j++) inside = inside && b[j * m + c] >= low[c] && b[j * m + c] <= high[c];
            if (inside) continue;
            double d[ORDERS], x[ORDERS + 1];
            for (int j = 0; j < p; j++) d[j] = b[(j + 1) * m + c] - b[j * m + c];
            bat_signs signs = {0, 0};
            const int count = bat_bernstein_crossings(p - 1, d, 0, &signs, x);
            for (int k = 0; k < count; k++) {
                double f[ORDERS];
                for (int j = 0; j <= p; j++) f[j] = b[j * m + c];
                for (int r = p; r > 0; r--)
                    for (int j = 0; j < r; j++) f[j] += (f[j + 1] - f[j]) * x[k];
                widen(f[0], low + c, high + c);
            }
        }
    }
}

/* ---- Curvature ---- */

double bat_curve_curvature(const bat_curve *curve, double u) {
    const int m = curve->dimension;
    double d[3 * BAT_DIMENSION_MAX];
    bat_curve_eval(curve, u, 2, d);
    const double *a = d + m, *b = d + 2 * m;
    const double v = m == 2 ? bat_hypot(a[0], a[1]) : bat_hypot(bat_hypot(a[0], a[1]), a[2]);
    if (isnan(v)) return v;
    if (!(v > 0)) return 0;
    /* Divided early so that great and small curves neither overflow nor vanish. */
    const double z = (a[0] / v * b[1] - a[1] / v * b[0]) / v / v;
    double k = z;
    if (m == 3) {
        const double x = (a[1] / v * b[2] - a[2] / v * b[1]) / v / v;
        const double y = (a[2] / v * b[0] - a[0] / v * b[2]) / v / v;
        k = bat_hypot(bat_hypot(x, y), z);
    }
    return isfinite(k) ? k : 0;
}

/* The seam of a closed curve: where the last sign and the first differ, the start is such a place, too. */
static size_t add_seam(const bat_curve *curve, const bat_signs *signs, size_t count, size_t room, double *u) {
    if (!curve->closed || signs->before != -signs->opening || signs->before == 0) return count;
    if (room > 0) {
        for (size_t k = count < room ? count : room - 1; k > 0; k--) u[k] = u[k - 1];
        u[0] = curve->knots[curve->degree];
    }
    return count + 1;
}

size_t bat_curve_inflections(const bat_curve *curve, size_t room, double *u) {
    const int p = curve->degree;
    if (curve->dimension != 2 || p < 2) return 0;
    size_t count = 0;
    bat_signs signs = {0, 0};
    for (int i = p; i < curve->spread; i++) {
        const double t0 = curve->knots[i], t1 = curve->knots[i + 1];
        if (!(t1 > t0)) continue;
        double b[ORDERS * 2], cross[2 * ORDERS], x[2 * ORDERS];
        double first = 0, second = 0, size = 0;
        bat_span_bezier(curve, i, b);
        for (int j = 0; j <= p; j++) {
            size = fmax(size, fabs(b[2 * j]) + fabs(b[2 * j + 1]));
            if (j + 1 <= p)
                first = fmax(first, fabs(b[2 * j + 2] - b[2 * j]) + fabs(b[2 * j + 3] - b[2 * j + 1]));
            if (j + 2 <= p)
                second = fmax(second, fabs(b[2 * j + 4] - 2 * b[2 * j + 2] + b[2 * j]) +
                                          fabs(b[2 * j + 5] - 2 * b[2 * j + 3] + b[2 * j + 1]));
        }
        bat_bernstein_turning(p, b, cross);
        const double zero = 32 * DBL_EPSILON * (first * second + size * (first + second));
        const int found = bat_bernstein_crossings(2 * p - 3, cross, zero, &signs, x);
        for (int k = 0; k < found; k++, count++)
            if (count < room) u[count] = t0 + (t1 - t0) * x[k];
    }
    return add_seam(curve, &signs, count, room, u);
}

size_t bat_curve_extremes(const bat_curve *curve, int axis, size_t room, double *u) {
    const int p = curve->degree;
    size_t count = 0;
    bat_signs signs = {0, 0};
    if (curve->dimension != 2 || axis < 0 || axis > 1) return 0;
    for (int i = p; i < curve->spread; i++) {
        const double t0 = curve->knots[i], t1 = curve->knots[i + 1];
        double b[ORDERS * 2], rise[ORDERS], x[ORDERS], size = 0;
        if (!(t1 > t0)) continue;
        bat_span_bezier(curve, i, b);
        for (int j = 0; j <= p; j++) size = fmax(size, fabs(b[2 * j + axis]));
        for (int j = 0; j < p; j++) rise[j] = b[2 * j + 2 + axis] - b[2 * j + axis];
        const int found = bat_bernstein_crossings(p - 1, rise, 32 * DBL_EPSILON * size, &signs, x);
        for (int k = 0; k < found; k++, count++)
            if (count < room) u[count] = t0 + (t1 - t0) * x[k];
    }
    return add_seam(curve, &signs, count, room, u);
}

/* ---- Two curves ---- */

static double gap_at(const bat_curve *curve, const bat_finder *finder, double u) {
    double point[BAT_DIMENSION_MAX];
    bat_near near;
    bat_curve_eval(curve, u, 0, point);
    bat_finder_nearest(finder, point, &near);
    return near.distance;
}

static double one_way(const bat_curve *a, const bat_finder *finder, int per_span) {
    const double *t = a->knots;
    double worst = -1, best_u = 0, step = 0;
    for (int i = a->degree; i < a->spread; i++) {
        if (!(t[i + 1] > t[i])) continue;
        for (int k = 0; k <= per_span; k++) {
            const double u = t[i] + (t[i + 1] - t[i]) * k / per_span, gap = gap_at(a, finder, u);
            if (gap > worst) worst = gap, best_u = u, step = (t[i + 1] - t[i]) / per_span;
        }
    }
    /* Golden section between the neighbours of the worst sample. */
    double low = best_u - step, high = best_u + step;
    for (int k = 0; k < 40; k++) {
        const double u0 = high - 0.6180339887498949 * (high - low),
                     u1 = low + 0.6180339887498949 * (high - low);
        const double g0 = gap_at(a, finder, u0), g1 = gap_at(a, finder, u1);
        worst = fmax(worst, fmax(g0, g1));
        if (g0 > g1)
            high = u1;
        else
            low = u0;
    }
    return worst;
}

bat_status bat_curve_distance(const bat_curve *a, const bat_curve *b, int per_span, double *a_to_b,
                              double *b_to_a) {
    if (!a || !b || !a_to_b || !b_to_a || per_span < 1 || per_span > 1 << 20) return BAT_ARGUMENT;
    if (a->dimension != b->dimension) return BAT_DIMENSION;
    bat_finder *on_a, *on_b;
    bat_status status = bat_finder_create(a, &on_a);
    if (status != BAT_OK) return status;
    status = bat_finder_create(b, &on_b);
    if (status == BAT_OK) {
        *a_to_b = one_way(a, on_b, per_span), *b_to_a = one_way(b, on_a, per_span);
        bat_finder_free(on_b);
    }
    bat_finder_free(on_a);
    return status;
}

static double sweep(const void *context, double u) {
    double p[4];
    bat_curve_eval(context, u, 1, p);
    return 0.5 * (p[0] * p[3] - p[1] * p[2]);
}

double bat_curve_area(const bat_curve *curve) {
    if (!curve || !bat_curve_is_closed(curve) || bat_curve_dimension(curve) != 2) return 0;
    const double *t = bat_curve_knots(curve);
    double sum = 0;
    for (int i = 0; i + 1 < bat_curve_knot_count(curve); i++)
        if (t[i] < t[i + 1]) sum += bat_gauss(sweep, curve, t[i], t[i + 1]);
    return sum;
}
