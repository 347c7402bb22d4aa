#include "hands/levels/follow.h"

#include "base/real.h"
#include "curve/curve.h"

#include <batten/bezier.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 256, SAMPLES_SPAN = 4, SAMPLES_MOST = 2048 };
static const double TOUCHING = 1e-6; /* of the size: distances below are that far */

/* A place of the bent curve: where it was and is, its turn, the length that it stands for. */
typedef struct place {
    double from[2], to[2], cosine, sine, length;
} place;

static size_t count_of(const bat_curve *curve) {
    const size_t wanted = SAMPLES + SAMPLES_SPAN * (size_t)bat_curve_segment_count(curve);
    return wanted < SAMPLES_MOST ? wanted : SAMPLES_MOST;
}

static place place_at(const bat_curve *before, const bat_curve *after, double u, double step) {
    double a[4], b[4];
    bat_curve_eval(before, u, 1, a), bat_curve_eval(after, u, 1, b);
    const double speed[2] = {bat_hypot(a[2], a[3]), bat_hypot(b[2], b[3])}, both = speed[0] * speed[1];
    place p = {{a[0], a[1]}, {b[0], b[1]}, 1, 0, speed[0] * step};
    if (!(both > 0) || (a[2] == b[2] && a[3] == b[3])) return p;
    p.cosine = (a[2] * b[2] + a[3] * b[3]) / both, p.sine = (a[2] * b[3] - a[3] * b[2]) / both;
    return p;
}

static void follow(const place *places, size_t count, double touching, double *point) {
    double sum[2] = {0, 0}, all = 0;
    for (size_t i = 0; i < count; i++) {
        const place *p = places + i;
        const double x = point[0] - p->from[0], y = point[1] - p->from[1];
        const double far = x * x + y * y + touching * touching, weight = p->length / (far * far);
        sum[0] += weight * (p->to[0] - p->from[0] + (p->cosine - 1) * x - p->sine * y);
        sum[1] += weight * (p->to[1] - p->from[1] + p->sine * x + (p->cosine - 1) * y);
        all += weight;
    }
    for (int c = 0; c < 2 && all > 0; c++) point[c] += sum[c] / all;
}

bat_status bat_curve_follow(const bat_curve *curve, const bat_curve *before, const bat_curve *after,
                            bat_curve **out) {
    if (curve->dimension != 2 || before->dimension != 2 || after->dimension != 2) return BAT_DIMENSION;
    const size_t count = count_of(before), points = (size_t)curve->count;
    place *places = malloc(count * sizeof *places);
    double *moved = malloc(2 * points * sizeof *moved), domain[2];
    bat_status status = places && moved ? BAT_OK : BAT_MEMORY;
    bat_curve_domain(before, domain);
    const double step = (domain[1] - domain[0]) / (double)count, touching = TOUCHING * bat_curve_size(before);
    for (size_t i = 0; i < count && status == BAT_OK; i++)
        places[i] = place_at(before, after, domain[0] + step * ((double)i + 0.5), step);
    if (status == BAT_OK) memcpy(moved, bat_curve_points(curve), 2 * points * sizeof *moved);
    for (size_t i = 0; i < points && status == BAT_OK; i++) follow(places, count, touching, moved + 2 * i);
    if (status == BAT_OK)
        status = bat_curve_create(2, curve->degree, curve->closed, points, moved, bat_curve_knot_count(curve),
                                  bat_curve_knots(curve), out);
    free(places), free(moved);
    return status;
}

bool bat_curve_is_inside(const bat_curve *curve, const bat_curve *outline) {
    double domain[2], at[2], last[2], now[2];
    bool inside = false;
    if (!outline->closed || outline->dimension != 2 || curve->dimension != 2) return false;
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, at);
    bat_curve_domain(outline, domain);
    const size_t count = count_of(outline);
    bat_curve_eval(outline, domain[0], 0, last);
    for (size_t i = 1; i <= count; i++) {
        bat_curve_eval(outline, domain[0] + (domain[1] - domain[0]) * (double)(i % count) / (double)count, 0,
                       now);
        if (bat_is_beside(at, last, now)) inside = !inside;
        memcpy(last, now, sizeof last);
    }
    return inside;
}
