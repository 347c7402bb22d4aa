/* Polylines with lengths: the stroke as the pen drew it, and curves flattened. */
#include "hands/sketch/intent_parts.h"
#include "curve/curve.h"
#include "base/bisect.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { INTERVALS = 8, INTERVALS_MOST = 256 };
static const double flatness = 0.15;

double bat_polyline_length(const bat_polyline *line) { return line->count ? line->s[line->count - 1] : 0; }

void bat_polyline_free(bat_polyline *line) {
    free(line->x);
    free(line->s);
    *line = (bat_polyline){0};
}

bat_status bat_polyline_add(bat_polyline *line, const double point[2]) {
    if (line->count == line->room) {
        const int room = line->room ? 2 * line->room : 64;
        double *x = realloc(line->x, 2 * (size_t)room * sizeof *x);
        if (!x) return BAT_MEMORY;
        line->x = x;
        double *s = realloc(line->s, (size_t)room * sizeof *s);
        if (!s) return BAT_MEMORY;
        line->s = s;
        line->room = room;
    }
    const size_t n = (size_t)line->count;
    memcpy(line->x + 2 * n, point, 2 * sizeof *point);
    line->s[n] = n ? line->s[n - 1] + bat_hypot(point[0] - line->x[2 * n - 2], point[1] - line->x[2 * n - 1])
                   : 0;
    line->count++;
    return BAT_OK;
}

void bat_polyline_at(const bat_polyline *line, double s, double out[2]) {
    const double length = bat_polyline_length(line);
    if (line->count < 2 || !(length > 0)) {
        memcpy(out, line->x, 2 * sizeof *out);
        return;
    }
    if (line->closed) s -= floor(s / length) * length;
    s = fmin(fmax(s, 0), length);
    const size_t low = bat_bisect(line->s, (size_t)line->count, s);
    const double h = line->s[low + 1] - line->s[low], f = h > 0 ? (s - line->s[low]) / h : 0;
    const double *a = line->x + 2 * low;
    for (int k = 0; k < 2; k++) out[k] = a[k] + f * (a[2 + k] - a[k]);
}

double bat_polyline_chord(const bat_polyline *line, double s, double h, double out[2]) {
    double from = s - h, to = s + h, a[2], b[2];
    if (!line->closed) {
        from = fmax(from, 0);
        to = fmin(to, bat_polyline_length(line));
    }
    bat_polyline_at(line, from, a);
    bat_polyline_at(line, to, b);
    out[0] = b[0] - a[0], out[1] = b[1] - a[1];
    return fmax(to - from, 0);
}

static void place(const double map[6], const double *point, double out[2]) {
    out[0] = map[0] * point[0] + map[1] * point[1] + map[2];
    out[1] = map[3] * point[0] + map[4] * point[1] + map[5];
}

/* Into how many intervals the span [u0, u1] is to be cut. */
static int intervals(const bat_curve *curve, int span, const double map[6]) {
    const int p = curve->degree;
    const double u0 = curve->knots[span], u1 = curve->knots[span + 1];
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, x[INTERVALS + 1][2], worst = 0;
    if (p == 1) return 1;
    for (int i = span - p; i <= span; i++) {
        double q[2];
        place(map, curve->points + 2 * (size_t)i, q);
        for (int k = 0; k < 2; k++) low[k] = fmin(low[k], q[k]), high[k] = fmax(high[k], q[k]);
    }
    if (high[0] - low[0] < 1 && high[1] - low[1] < 1) return 1;
    for (int i = 0; i <= INTERVALS; i++) {
        double q[2];
        bat_curve_eval(curve, u0 + (u1 - u0) * i / INTERVALS, 0, q);
        place(map, q, x[i]);
    }
    for (int i = 1; i < INTERVALS; i++)
        for (int k = 0; k < 2; k++) worst = fmax(worst, fabs(x[i][k] - 0.5 * (x[i - 1][k] + x[i + 1][k])));
    const double wanted = ceil(INTERVALS * sqrt(worst / 4 / flatness));
    return wanted > INTERVALS_MOST ? INTERVALS_MOST : wanted > 1 ? (int)wanted : 1;
}

bat_status bat_polyline_flatten(const bat_curve *curve, const double map[6], bat_polyline *out) {
    *out = (bat_polyline){.closed = curve->closed};
    double q[2], x[2];
    bat_status status = BAT_OK;
    for (int i = curve->degree; i < curve->spread && status == BAT_OK; i++) {
        const double u0 = curve->knots[i], u1 = curve->knots[i + 1];
        if (!(u1 > u0)) continue;
        const int count = intervals(curve, i, map);
        for (int j = 0; j < count && status == BAT_OK; j++) {
            bat_curve_eval(curve, u0 + (u1 - u0) * j / count, 0, q);
            place(map, q, x);
            status = bat_polyline_add(out, x);
        }
    }
    if (status == BAT_OK && curve->closed)
        memcpy(x, out->x, sizeof x);
    else if (status == BAT_OK) {
        bat_curve_eval(curve, curve->knots[curve->spread], 0, q);
        place(map, q, x);
    }
    if (status == BAT_OK) status = bat_polyline_add(out, x);
    if (status == BAT_OK && !(bat_polyline_length(out) < 1e12)) status = BAT_NUMBER;
    if (status != BAT_OK) bat_polyline_free(out);
    return status;
}
