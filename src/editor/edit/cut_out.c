#include "editor/edit/cut_out.h"
#include "curve/curve.h"
#include "base/real.h"
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HALVINGS = 60, STEPS_MIN = 8, STEPS_MAX = 600 };

void bat_spans_free(bat_spans *spans) {
    free(spans->list);
    *spans = (bat_spans){0};
}

bat_status bat_spans_add(bat_spans *spans, double u0, double u1) {
    if (!(u0 < u1)) return BAT_OK;
    if (spans->count == spans->room) {
        int room = spans->room ? 2 * spans->room : 8;
        double(*list)[2] = realloc(spans->list, (size_t)room * sizeof *list);
        if (!list) return BAT_MEMORY;
        spans->list = list;
        spans->room = room;
    }
    int kept = 0, at = 0;
    for (int i = 0; i < spans->count; i++) {
        double *old = spans->list[i];
        if (old[1] < u0 || old[0] > u1) {
            if (old[1] < u0) at = kept + 1;
            memmove(spans->list[kept++], old, sizeof *spans->list);
            continue;
        }
        u0 = fmin(u0, old[0]);
        u1 = fmax(u1, old[1]);
    }
    memmove(spans->list + at + 1, spans->list + at, (size_t)(kept - at) * sizeof *spans->list);
    spans->list[at][0] = u0;
    spans->list[at][1] = u1;
    spans->count = kept + 1;
    return BAT_OK;
}

/* Distance of the curve's point at u from the segment ab, minus the radius. */
static double clearance(const bat_curve *curve, double u, const double a[2], const double b[2],
                        double radius) {
    double p[2], x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    bat_curve_eval(curve, u, 0, p);
    double t = square > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return bat_hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y) - radius;
}

/* The parameter between one inside and one outside at which the curve crosses the border. */
static double border(const bat_curve *curve, double inside, double outside, const double a[2],
                     const double b[2], double radius) {
    for (int i = 0; i < HALVINGS; i++) {
        double middle = inside + (outside - inside) / 2;
        if (middle == inside || middle == outside) break;
        if (clearance(curve, middle, a, b, radius) < 0)
            inside = middle;
        else
            outside = middle;
    }
    return inside;
}

/* Whether the box of `count` points is within reach of the segment's box. */
static bool hull_near(const double *hull, int count, const double a[2], const double b[2], double radius) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], hull[2 * i + c]);
            high[c] = fmax(high[c], hull[2 * i + c]);
        }
    for (int c = 0; c < 2; c++)
        if (low[c] > fmax(a[c], b[c]) + radius || high[c] < fmin(a[c], b[c]) - radius) return false;
    return true;
}

bool bat_spans_near(const bat_curve *curve, const double a[2], const double b[2], double radius) {
    return hull_near(bat_curve_points(curve), bat_point_count(curve), a, b, radius);
}

/* Number of samples to take in a Bézier segment: 0 when its hull is out of reach. */
static int steps_of(const double *hull, int count, const double a[2], const double b[2], double radius) {
    double length = 0;
    if (!hull_near(hull, count, a, b, radius)) return 0;
    for (int i = 1; i < count; i++)
        length += bat_hypot(hull[2 * i] - hull[2 * i - 2], hull[2 * i + 1] - hull[2 * i - 1]);
    return (int)fmin(fmax(ceil(20 * length / radius), STEPS_MIN), STEPS_MAX);
}

bat_status bat_spans_erase(bat_spans *spans, const bat_curve *curve, const double a[2], const double b[2],
                           double radius) {
    int segments = bat_curve_segment_count(curve), p = bat_curve_degree(curve);
    size_t hull = 2 * ((size_t)p + 1);
    double *points = malloc(((size_t)segments * hull + (size_t)segments + 1) * sizeof *points);
    if (!points) return BAT_MEMORY;
    double *breaks = points + (size_t)segments * hull;
    bat_status status = bat_curve_to_bezier(curve, points, breaks);
    for (int s = 0; s < segments && status == BAT_OK; s++) {
        int steps = steps_of(points + (size_t)s * hull, p + 1, a, b, radius);
        double from = breaks[s], last = from, start = from;
        bool inside = steps && clearance(curve, from, a, b, radius) < 0;
        for (int i = 1; i <= steps && status == BAT_OK; i++) {
            double u = i == steps ? breaks[s + 1] : from + (breaks[s + 1] - from) * i / steps;
            bool now = clearance(curve, u, a, b, radius) < 0;
            if (now && !inside) start = border(curve, u, last, a, b, radius);
            if (!now && inside) status = bat_spans_add(spans, start, border(curve, last, u, a, b, radius));
            inside = now;
            last = u;
        }
        if (inside && status == BAT_OK) status = bat_spans_add(spans, start, breaks[s + 1]);
    }
    free(points);
    return status;
}

bat_status bat_spans_rest(const bat_spans *spans, const bat_curve *curve, double least, bat_curve ***pieces,
                          int *count) {
    bool closed = bat_curve_is_closed(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    int gaps = spans->count + 1, made = 0;
    bat_curve **list = calloc((size_t)gaps, sizeof *list);
    if (!list) return BAT_MEMORY;
    bat_status status = BAT_OK;
    for (int i = 0; i < gaps && status == BAT_OK; i++) {
        double u0 = i ? spans->list[i - 1][1] : domain[0];
        double u1 = i < spans->count ? spans->list[i][0] : domain[1];
        if (closed && i == 0 && spans->count) continue; /* comes with the last gap, across the seam */
        if (closed && i == spans->count && i) u1 = spans->list[0][0] + (domain[1] - domain[0]);
        if (!(u0 < u1) || !(bat_curve_length(curve, u0, u1, 1e-3) > least)) continue;
        status = bat_curve_piece(curve, u0, u1, &list[made]);
        if (status == BAT_OK) made++;
    }
    if (status != BAT_OK) {
        for (int i = 0; i < made; i++) bat_curve_free(list[i]);
        free(list);
        return status;
    }
    *pieces = list;
    *count = made;
    return BAT_OK;
}
