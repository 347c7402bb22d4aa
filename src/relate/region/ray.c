/* How often edges cross a ray. */
#include "base/real.h"
#include "relate/region/ray.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 60, PIECE = 2 * (BAT_DEGREE_MAX + 1) };

static void turn(const bat_region_ray *r, const double *p, double q[2]) {
    q[0] = p[r->across], q[1] = p[!r->across];
}

/* Upwards across the height of the ray or downwards, by the ends alone: so pieces that follow each other agree. */
static int step(const bat_region_ray *r, double y0, double y1) { return (y1 > r->y) - (y0 > r->y); }

/* Cuts a segment at t: q keeps what is behind it. */
static void cut(double *q, int degree, double t, double *left) {
    for (int k = 0; k <= degree; k++) { /* de Casteljau */
        left[2 * k] = q[0], left[2 * k + 1] = q[1];
        for (int i = 0; i < degree - k; i++)
            for (int c = 0; c < 2; c++) q[2 * i + c] = (1 - t) * q[2 * i + c] + t * q[2 * i + 2 + c];
    }
}

/* How often a Bézier segment crosses the ray upwards, less how often downwards. q: turned, used up. */
static int crossings(bat_region_ray *r, double *q, int degree, int depth) {
    double low[2] = {q[0], q[1]}, high[2] = {q[0], q[1]}, left[PIECE];
    for (int i = 1; i <= degree; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], q[2 * i + c]);
            high[c] = fmax(high[c], q[2 * i + c]);
        }
    if (high[0] <= r->x || low[1] > r->y || high[1] < r->y) return 0;
    const int both = step(r, q[1], q[2 * degree + 1]);
    if (low[0] > r->x) return both;
    r->near = fmin(r->near, fmax(high[0] - low[0], high[1] - low[1]));
    if (depth == DEPTH_MAX) return q[0] + q[2 * degree] > 2 * r->x ? both : 0;
    cut(q, degree, 0.5, left);
    return crossings(r, left, degree, depth + 1) + crossings(r, q, degree, depth + 1);
}

static void span_of(const bat_region_ray *r, const bat_region_edge *e, int degree, int i, double q[PIECE]) {
    for (int k = 0; k <= degree; k++) turn(r, e->bezier + 2 * ((degree + 1) * i + k), q + 2 * k);
}

/* skip: a span that is not looked at. */
static int winding_of(bat_region_ray *r, const bat_region_edge *e, int degree, int skip) {
    double low[2], high[2];
    turn(r, e->box, low), turn(r, e->box + 2, high);
    if (high[0] <= r->x || low[1] > r->y || high[1] < r->y) return 0;
    const double *last = e->bezier + 2 * ((degree + 1) * e->spans - 1);
    if (low[0] > r->x && skip < 0) return step(r, e->bezier[!r->across], last[!r->across]);
    int sum = 0;
    for (int i = 0; i < e->spans; i++) {
        double q[PIECE];
        if (i == skip) continue;
        span_of(r, e, degree, i, q);
        sum += crossings(r, q, degree, 0);
    }
    return sum;
}

int bat_ray_chord(const bat_region_ray *r, const double *from, const double *to) {
    double p[2], q[2];
    turn(r, from, p), turn(r, to, q);
    const int both = step(r, p[1], q[1]);
    return both != 0 && p[0] + (r->y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) > r->x ? both : 0;
}

/* Whether it goes up all the way, or down. */
static bool is_steep(const double *q, int degree) {
    const bool up = q[2 * degree + 1] > q[1];
    for (int k = 0; k < degree; k++)
        if (up ? !(q[2 * k + 3] > q[2 * k + 1]) : !(q[2 * k + 3] < q[2 * k + 1])) return false;
    return true;
}

int bat_ray_crossings(bat_region_ray *r, const bat_region_edge *e, int degree) {
    return winding_of(r, e, degree, -1);
}

bool bat_ray_cast(const bat_region_edge *e, int degree, double place, bat_region_ray *r, bool *up,
                  int *rest) {
    const double x = place * e->spans;
    const int i = (int)fmin(x, e->spans - 1);
    const double t = fmin(fmax(x - i, 0.1), 0.9);
    double q[PIECE], left[PIECE];
    *r = (bat_region_ray){.near = INFINITY};
    span_of(r, e, degree, i, q);
    cut(q, degree, t, left);
    const double dx = q[2] - left[2 * degree - 2], dy = q[3] - left[2 * degree - 1];
    const double p[2] = {q[0], q[1]};
    r->across = fabs(dx) > fabs(dy);
    r->x = p[r->across], r->y = p[!r->across];
    for (double width = 0.5 * fmin(t, 1 - t); width > 1e-5; width *= 0.5) {
        double middle[PIECE];
        span_of(r, e, degree, i, q);
        cut(q, degree, t - width, left);
        cut(q, degree, 2 * width / (1 - t + width), middle);
        if (!is_steep(middle, degree) || step(r, middle[1], middle[2 * degree + 1]) == 0) continue;
        *up = middle[2 * degree + 1] > middle[1];
        *rest = winding_of(r, e, degree, i) + crossings(r, left, degree, 0) + crossings(r, q, degree, 0);
        return true;
    }
    return false;
}
