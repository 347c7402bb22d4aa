/*
 * Ellipses: the conic A x² + B x y + (1 - A) y² + D x + E y + F = 0, fitted by least squares. Its trace is
 * fixed so that lines do not pass for ellipses. Each sample is then weighted by the slope of the form there,
 * which turns values into distances (Sampson).
 */
#include "hands/figures/trace.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 10 };
static const double THINNEST = 0.06; /* ratio of the shorter axis to the longer one */
static const double LEAST_SWEEP = 1.7,
                    LARGEST = 2.5; /* radians of a part; longer half axis over the stroke's size */

static double value(const double q[5], double x, double y) {
    return q[0] * (x * x - y * y) + q[1] * x * y + y * y + q[2] * x + q[3] * y + q[4];
}

static double slope(const double q[5], double x, double y) {
    const double gx = 2 * q[0] * x + q[1] * y + q[2], gy = 2 * (1 - q[0]) * y + q[1] * x + q[3];
    return fmax(bat_hypot(gx, gy), 1e-3);
}

static bool conic(const bat_trace *trace, double q[5]) {
    for (int round = 0; round < ROUNDS; round++) {
        double a[25] = {0}, b[5] = {0};
        for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
            const double x = trace->at[2 * i], y = trace->at[2 * i + 1], g = round ? slope(q, x, y) : 1;
            bat_small_add(5, (double[]){x * x - y * y, x * y, x, y, 1}, -y * y, 1 / (g * g), a, b);
        }
        if (!bat_small_solve(5, a, b)) return false;
        memcpy(q, b, sizeof b);
    }
    return true;
}

/* Numbers: middle x y, half axes, turn. */
static bool axes(const double q[5], double number[5]) {
    const double half = q[1] / 2, det = q[0] * (1 - q[0]) - half * half;
    if (!(det > 1e-6)) return false;
    const double x = (half * q[3] - (1 - q[0]) * q[2]) / (2 * det),
                 y = (half * q[2] - q[0] * q[3]) / (2 * det);
    const double level = -(q[4] + (q[2] * x + q[3] * y) / 2);
    const double split = bat_hypot(2 * q[0] - 1, q[1]), steep = (1 + split) / 2, flat = (1 - split) / 2;
    if (!(level > 0) || !(flat > 0)) return false;
    number[0] = x, number[1] = y;
    number[2] = sqrt(level / steep), number[3] = sqrt(level / flat);
    number[4] = bat_atan2(q[1], 2 * q[0] - 1) / 2; /* the steep direction: the shorter half axis */
    return true;
}

static void local(const double number[5], const double *at, double out[2]) {
    const double x = at[0] - number[0], y = at[1] - number[1], c = bat_cos(number[4]), s = bat_sin(number[4]);
    out[0] = (c * x + s * y) / number[2];
    out[1] = (c * y - s * x) / number[3];
}

/* Numbers: as axes(), then the angle at the start and the sweep. */
bool bat_trace_ellipse(const bat_trace *trace, bat_found *out) {
    double q[5], number[8] = {0}, from[2], to[2], sum = 0, sweep = 0;
    if (!conic(trace, q) || !axes(q, number)) return false;
    if (number[2] < THINNEST * number[3] || number[3] > LARGEST) return false;
    local(number, trace->at, from);
    number[5] = bat_atan2(from[1], from[0]);
    for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
        const double *p = trace->at + 2 * i, d = value(q, p[0], p[1]) / slope(q, p[0], p[1]);
        local(number, p, to);
        sweep += bat_atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
        memcpy(from, to, sizeof from);
        sum += d * d;
    }
    number[6] = trace->closed ? copysign(2 * BAT_PI, sweep) : sweep;
    *out = (bat_found){.kind = trace->closed ? BAT_FIGURE_ELLIPSE : BAT_FIGURE_ELLIPSE_ARC,
                       .miss = sqrt(sum / BAT_TRACE_POINTS)};
    memcpy(out->number, number, sizeof number);
    return fabs(number[6]) >= LEAST_SWEEP && fabs(number[6]) <= 2 * BAT_PI;
}
