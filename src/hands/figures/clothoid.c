/* Clothoids: the direction is a quadratic in the arc length. Fitted to evenly spaced places on the stroke. */
#include "hands/figures/trace.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 12, FREE = 4, CHORD = 8 /* places on either side of a first direction */ };
static const double NUDGE = 1e-6, MOST = 4 * BAT_PI; /* that it may turn in all */

/* Numbers: direction in the middle, turn along the figure, change of that turn, length; middle x y.
 * Integrated by Simpson's rule between places. */
void bat_found_clothoid(const double number[8], size_t count, double *points) {
    const double step = 1 / (double)(count - 1);
    double x = 0, y = 0, mean[2] = {0, 0};
    for (size_t i = 0; i < count; i++) {
        points[2 * i] = x, points[2 * i + 1] = y;
        mean[0] += x / (double)count, mean[1] += y / (double)count;
        for (int k = 0; k < 3; k++) {
            const double g = ((double)i + k / 2.0) * step - 0.5,
                         part = (k == 1 ? 4 : 1) / 6.0 * step * number[3];
            const double angle = number[0] + number[1] * g + number[2] * g * g / 2;
            x += part * bat_cos(angle), y += part * bat_sin(angle);
        }
    }
    for (size_t i = 0; i < 2 * count; i++) points[i] += number[4 + (i & 1)] - mean[i & 1];
}

/* Fits a quadratic to the directions of long chords, in polynomials that are orthogonal over the places. */
static void begin(const bat_trace *trace, double number[8]) {
    double angle = 0, a[9] = {0}, b[3] = {0};
    for (size_t i = 0; i + CHORD < BAT_TRACE_POINTS; i++) {
        const double *p = trace->at + 2 * i, *q = p + 2 * CHORD;
        const double dx = q[0] - p[0], dy = q[1] - p[1], now = bat_atan2(dy, dx);
        angle = i ? angle + bat_atan2(bat_sin(now - angle), bat_cos(now - angle)) : now;
        const double g = ((double)i + CHORD / 2.0) / (BAT_TRACE_POINTS - 1) - 0.5;
        bat_small_add(3, (double[]){1, g, g * g / 2}, angle, 1, a, b);
    }
    bat_small_solve(3, a, b);
    memcpy(number, b, sizeof b);
    number[3] = trace->length;
    number[4] = number[5] = 0;
}

static double square(const bat_trace *trace, const double number[8], double *points) {
    double sum = 0;
    bat_found_clothoid(number, BAT_TRACE_POINTS, points);
    for (size_t i = 0; i < 2 * BAT_TRACE_POINTS; i++) {
        const double d = trace->at[i] - points[i];
        sum += d * d;
    }
    return sum;
}

/* One Levenberg-Marquardt step; false: it brings no improvement. */
static bool improve(const bat_trace *trace, double number[8], double *damping) {
    double now[2 * BAT_TRACE_POINTS], moved[FREE][2 * BAT_TRACE_POINTS], a[FREE * FREE] = {0}, b[FREE] = {0};
    const double sum = square(trace, number, now);
    for (int k = 0; k < FREE; k++) {
        double trial[8];
        memcpy(trial, number, sizeof trial);
        trial[k] += NUDGE;
        bat_found_clothoid(trial, BAT_TRACE_POINTS, moved[k]);
    }
    for (size_t i = 0; i < 2 * BAT_TRACE_POINTS; i++) {
        double row[FREE];
        for (int k = 0; k < FREE; k++) row[k] = (moved[k][i] - now[i]) / NUDGE;
        bat_small_add(FREE, row, trace->at[i] - now[i], 1, a, b);
    }
    for (int k = 0; k < FREE; k++) a[k * FREE + k] *= 1 + *damping;
    double trial[8];
    if (!bat_small_solve(FREE, a, b)) return false;
    memcpy(trial, number, sizeof trial);
    for (int k = 0; k < FREE; k++) trial[k] += b[k];
    const double better = square(trace, trial, now);
    *damping *= better < sum ? 0.2 : 10;
    if (!(better < sum)) return *damping < 1e3;
    memcpy(number, trial, sizeof trial);
    return better < sum * (1 - 1e-6);
}

/* The rms distance across the figure; along it the places only drift. */
static double across(const bat_trace *trace, const double number[8]) {
    double points[2 * BAT_TRACE_POINTS], sum = 0;
    square(trace, number, points);
    for (size_t i = 0; i < BAT_TRACE_POINTS; i++) {
        const double g = (double)i / (BAT_TRACE_POINTS - 1) - 0.5;
        const double angle = number[0] + number[1] * g + number[2] * g * g / 2;
        const double d = (trace->at[2 * i + 1] - points[2 * i + 1]) * bat_cos(angle) -
                         (trace->at[2 * i] - points[2 * i]) * bat_sin(angle);
        sum += d * d;
    }
    return sqrt(sum / BAT_TRACE_POINTS);
}

bool bat_trace_clothoid(const bat_trace *trace, bat_found *out) {
    *out = (bat_found){.kind = BAT_FIGURE_CLOTHOID};
    double damping = 1e-3;
    begin(trace, out->number);
    for (int round = 0; round < ROUNDS; round++)
        if (!improve(trace, out->number, &damping)) break;
    out->miss = across(trace, out->number);
    return out->number[3] > 0 && fabs(out->number[1]) + fabs(out->number[2]) / 2 < MOST;
}
