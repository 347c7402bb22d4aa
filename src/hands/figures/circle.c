/* Lines and circles. */
#include "hands/figures/trace.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 12 };

/* Numbers: start x y, end x y. The direction of greatest spread, through the middle. */
bool bat_trace_line(const bat_trace *trace, bat_found *out) {
    double xx = 0, xy = 0, yy = 0;
    for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
        const double x = trace->at[2 * i], y = trace->at[2 * i + 1];
        xx += x * x, xy += x * y, yy += y * y;
    }
    const double turn = bat_atan2(2 * xy, xx - yy) / 2, c = bat_cos(turn), s = bat_sin(turn);
    const double *last = trace->at + 2 * (BAT_TRACE_POINTS - 1);
    const double from = c * trace->at[0] + s * trace->at[1], to = c * last[0] + s * last[1];
    *out = (bat_found){.kind = BAT_FIGURE_LINE, .number = {c * from, s * from, c * to, s * to}};
    out->miss = sqrt(fmax(s * s * xx - 2 * s * c * xy + c * c * yy, 0) / BAT_TRACE_POINTS);
    return true;
}

/* The first guess: least squares of x² + y² + D x + E y + F. */
static bool begin(const bat_trace *trace, double number[3]) {
    double a[9] = {0}, b[3] = {0};
    for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
        const double x = trace->at[2 * i], y = trace->at[2 * i + 1];
        bat_small_add(3, (double[]){x, y, 1}, -(x * x + y * y), 1, a, b);
    }
    if (!bat_small_solve(3, a, b)) return false;
    number[0] = -b[0] / 2, number[1] = -b[1] / 2;
    number[2] = sqrt(fmax(number[0] * number[0] + number[1] * number[1] - b[2], 0));
    return number[2] > 0 && number[2] < 1e3;
}

static double miss_of(const bat_trace *trace, const double number[3]) {
    double sum = 0;
    for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
        const double d = bat_hypot(trace->at[2 * i] - number[0], trace->at[2 * i + 1] - number[1]) -
                         number[2];
        sum += d * d;
    }
    return sqrt(sum / BAT_TRACE_POINTS);
}

/* Gauss-Newton on the true distances, for as long as it improves. */
static void refine(const bat_trace *trace, double number[3]) {
    for (int round = 0; round < ROUNDS; round++) {
        double a[9] = {0}, b[3] = {0}, trial[3];
        for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
            const double x = trace->at[2 * i] - number[0], y = trace->at[2 * i + 1] - number[1],
                         d = fmax(bat_hypot(x, y), 1e-12);
            bat_small_add(3, (double[]){x / d, y / d, 1}, d - number[2], 1, a, b);
        }
        if (!bat_small_solve(3, a, b)) return;
        for (int k = 0; k < 3; k++) trial[k] = number[k] + b[k];
        if (!(trial[2] > 0) || !(miss_of(trace, trial) < miss_of(trace, number))) return;
        memcpy(number, trial, sizeof trial);
    }
}

/* Numbers: middle x y, radius, angle at the start, sweep. */
bool bat_trace_circle(const bat_trace *trace, bat_found *out) {
    double number[3];
    if (!begin(trace, number)) return false;
    refine(trace, number);
    double sweep = 0;
    for (size_t i = 0; i + 1 < BAT_TRACE_POINTS; i++) {
        const double x = trace->at[2 * i] - number[0], y = trace->at[2 * i + 1] - number[1];
        const double x1 = trace->at[2 * i + 2] - number[0], y1 = trace->at[2 * i + 3] - number[1];
        sweep += bat_atan2(x * y1 - y * x1, x * x1 + y * y1);
    }
    const double start = bat_atan2(trace->at[1] - number[1], trace->at[0] - number[0]);
    if (trace->closed) sweep = copysign(2 * BAT_PI, sweep);
    *out = (bat_found){.kind = trace->closed ? BAT_FIGURE_CIRCLE : BAT_FIGURE_ARC,
                       .miss = miss_of(trace, number),
                       .number = {number[0], number[1], number[2], start, sweep}};
    return fabs(sweep) <= 2 * BAT_PI;
}
