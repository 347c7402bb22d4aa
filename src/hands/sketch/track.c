#include "hands/sketch/track.h"
#include "base/bisect.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_track_create(const bat_curve *curve, bat_stroke_track *out) {
    memset(out, 0, sizeof *out);
    const int p = curve->degree, per = 2 * p + 2, last = curve->spread;
    const size_t m = (size_t)curve->dimension;
    const double *t = curve->knots;
    int spans = 0;
    for (int i = p; i < last; i++) spans += t[i + 1] > t[i];
    const size_t count = (size_t)spans * (size_t)per + 1;
    double *block = malloc(count * (3 + m) * sizeof *block);
    double *jet = malloc(count * 2 * m * sizeof *jet);
    bat_status status = block && jet ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        double *u = block, *s = u + count, *speed = s + count, *points = speed + count;
        size_t n = 0;
        for (int i = p; i < last; i++)
            if (t[i + 1] > t[i])
                for (int j = 0; j < per; j++) u[n++] = t[i] + (t[i + 1] - t[i]) * j / per;
        u[n] = t[last];
        for (size_t i = 1; i < count; i++)
            if (u[i] < u[i - 1]) u[i] = u[i - 1];
        status = bat_curve_eval_many(curve, count, u, 1, jet);
        if (status == BAT_OK && curve->closed)
            bat_curve_eval_left(curve, t[last], 1, jet + (count - 1) * 2 * m);
        s[0] = 0;
        for (size_t i = 0; status == BAT_OK && i < count; i++) {
            const double *c = jet + i * 2 * m, *d = c + m;
            double v = 0;
            for (size_t k = 0; k < m; k++) points[i * m + k] = c[k], v += d[k] * d[k];
            speed[i] = sqrt(v);
            if (i == 0) continue;
            const double h = u[i] - u[i - 1];
            double middle = 0, chord = 0;
            for (size_t k = 0; k < m; k++) {
                const double step = c[k] - points[(i - 1) * m + k];
                const double f = h > 0 ? 1.5 * step / h - 0.25 * (d[k] + jet[(i - 1) * 2 * m + m + k]) : 0;
                middle += f * f, chord += step * step;
            }
            const double simpson = h / 6 * (speed[i - 1] + 4 * sqrt(middle) + speed[i]);
            s[i] = s[i - 1] + fmax(simpson, sqrt(chord));
        }
        out->curve = curve, out->count = (int)count;
        out->u = u, out->s = s, out->speed = speed, out->points = points;
        out->length = s[count - 1], out->start = t[p], out->end = t[last];
        out->mean = out->length / (out->end - out->start);
        if (status == BAT_OK && !(out->length < 1e150)) status = BAT_NUMBER;
    }
    free(jet);
    if (status != BAT_OK) {
        free(block);
        memset(out, 0, sizeof *out);
    }
    return status;
}

void bat_track_free(bat_stroke_track *track) {
    free(track->u);
    memset(track, 0, sizeof *track);
}

/* Cubic Hermite value on [0, 1] between y0 and y1, slopes limited so that it stays monotone. */
static double hermite(double f, double y0, double y1, double d0, double d1) {
    const double rise = y1 - y0;
    d0 = fmin(fmax(d0, 0), 3 * rise), d1 = fmin(fmax(d1, 0), 3 * rise);
    const double g = 1 - f;
    return y0 * g * g * (1 + 2 * f) + y1 * f * f * (1 + 2 * g) + f * g * (d0 * g - d1 * f);
}

double bat_track_s(const bat_stroke_track *k, double u) {
    double base = 0;
    const double period = k->end - k->start;
    if (k->curve->closed) {
        const double turns = floor((u - k->start) / period);
        u -= turns * period, base = turns * k->length;
    }
    if (u <= k->start) return base;
    if (u >= k->end) return base + k->length;
    const size_t i = bat_bisect(k->u, (size_t)k->count, u);
    const double h = k->u[i + 1] - k->u[i];
    if (!(h > 0)) return base + k->s[i];
    return base + hermite((u - k->u[i]) / h, k->s[i], k->s[i + 1], h * k->speed[i], h * k->speed[i + 1]);
}

double bat_track_u(const bat_stroke_track *k, double s) {
    double base = 0;
    if (k->curve->closed && k->length > 0) {
        const double turns = floor(s / k->length);
        s -= turns * k->length, base = turns * (k->end - k->start);
    }
    if (s <= 0) return base + k->start;
    if (s >= k->length) return base + k->end;
    const size_t i = bat_bisect(k->s, (size_t)k->count, s);
    const double h = k->s[i + 1] - k->s[i], rise = k->u[i + 1] - k->u[i];
    if (!(h > 0)) return base + k->u[i];
    const double d0 = k->speed[i] > 0 ? h / k->speed[i] : 3 * rise;
    const double d1 = k->speed[i + 1] > 0 ? h / k->speed[i + 1] : 3 * rise;
    return base + hermite((s - k->s[i]) / h, k->u[i], k->u[i + 1], d0, d1);
}

void bat_stroke_track_point(const bat_stroke_track *k, double s, double *point) {
    const size_t m = (size_t)k->curve->dimension;
    if (k->curve->closed && k->length > 0) s -= floor(s / k->length) * k->length;
    const size_t i = bat_bisect(k->s, (size_t)k->count, s);
    const double h = k->s[i + 1] - k->s[i];
    double f = h > 0 ? (s - k->s[i]) / h : 0;
    f = f < 0 ? 0 : f > 1 ? 1 : f;
    const double *a = k->points + i * m, *b = a + m;
    for (size_t c = 0; c < m; c++) point[c] = a[c] + f * (b[c] - a[c]);
}

void bat_track_tangent(const bat_stroke_track *k, double u, double *tangent) {
    const size_t m = (size_t)k->curve->dimension;
    double jet[2 * BAT_DIMENSION_MAX], v = 0;
    bat_curve_eval(k->curve, u, 1, jet);
    for (size_t c = 0; c < m; c++) v += jet[m + c] * jet[m + c];
    v = sqrt(v);
    if (v > 1e-3 * k->mean) {
        for (size_t c = 0; c < m; c++) tangent[c] = jet[m + c] / v;
        return;
    }
    const double s = bat_track_s(k, u), step = fmax(1e-3 * k->length, 1e-300);
    double a[BAT_DIMENSION_MAX], b[BAT_DIMENSION_MAX];
    bat_stroke_track_point(k, k->curve->closed ? s - step : fmax(s - step, 0), a);
    bat_stroke_track_point(k, k->curve->closed ? s + step : fmin(s + step, k->length), b);
    v = 0;
    for (size_t c = 0; c < m; c++) tangent[c] = b[c] - a[c], v += tangent[c] * tangent[c];
    v = sqrt(v);
    for (size_t c = 0; c < m; c++) tangent[c] = v > 0 ? tangent[c] / v : (c == 0);
}

/* Newton on (C - q) . C' = 0 from u, kept between low and high, never farther than the start. */
static double refine(const bat_stroke_track *k, const double *q, double u, double low, double high,
                     double *best) {
    const size_t m = (size_t)k->curve->dimension;
    double found = u;
    *best = INFINITY;
    for (int step = 0; step < 6; step++) {
        double jet[3 * BAT_DIMENSION_MAX], d = 0, g = 0, v = 0, h = 0;
        bat_curve_eval(k->curve, u, 2, jet);
        for (size_t c = 0; c < m; c++) {
            const double r = jet[c] - q[c];
            d += r * r, g += r * jet[m + c], v += jet[m + c] * jet[m + c], h += r * jet[2 * m + c];
        }
        if (!(d < *best)) break;
        *best = d, found = u;
        h = v + h > 0.25 * v ? v + h : v;
        if (!(h > 0)) break;
        u = fmin(fmax(u - g / h, low), high);
    }
    *best = sqrt(*best);
    return found;
}

int bat_track_candidates(const bat_stroke_track *k, const double *q, double slack, int room,
                         bat_track_near *out) {
    const size_t m = (size_t)k->curve->dimension;
    const bool closed = k->curve->closed;
    const int nodes = closed ? k->count - 1 : k->count;
    int found = 0;
    double before = 0, here = 0, after = 0;
    for (int i = -1; i <= nodes; i++) { /* slides a window of three distances */
        const int j = closed ? (i + 1) % nodes : i + 1;
        before = here, here = after;
        after = INFINITY;
        if (i + 1 < nodes || closed) {
            after = 0;
            for (size_t c = 0; c < m; c++) {
                const double r = k->points[(size_t)j * m + c] - q[c];
                after += r * r;
            }
        }
        if (i == -1) {
            here = INFINITY;
            continue;
        }
        if (i == 0 && closed) {
            before = 0;
            for (size_t c = 0; c < m; c++) {
                const double r = k->points[(size_t)(nodes - 1) * m + c] - q[c];
                before += r * r;
            }
        } else if (i == 0) {
            before = INFINITY;
        }
        if (i >= nodes || here > before || here > after) continue;
        const double period = k->end - k->start;
        const double low = i > 0 ? k->u[i - 1] : closed ? k->u[nodes - 1] - period : k->start;
        const double high = i + 1 < k->count ? k->u[i + 1] : k->end;
        bat_track_near hit;
        hit.s = bat_track_s(k, refine(k, q, k->u[i], low, high, &hit.distance));
        if (closed && hit.s < 0) hit.s += k->length;
        bool repeat = false;
        for (int a = 0; a < found; a++)
            if (fabs(out[a].s - hit.s) <= 1e-9 * k->length) repeat = true;
        if (repeat || !(hit.distance < INFINITY)) continue;
        int place = found < room ? found++ : room;
        while (place > 0 && out[place - 1].distance > hit.distance) {
            if (place < room) out[place] = out[place - 1];
            place--;
        }
        if (place < room) out[place] = hit;
    }
    if (found == 0) {
        out[0].s = 0, out[0].distance = 0;
        for (size_t c = 0; c < m; c++) out[0].distance = bat_hypot(out[0].distance, k->points[c] - q[c]);
        return 1;
    }
    while (found > 1 && out[found - 1].distance > 2 * out[0].distance + slack) found--;
    return found;
}
