/* Any samples, any options: a status; within the tolerance when it reports so; and in limited time. */
#include <batten/interpolate.h>
#include <batten/nearest.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What has to pass through every point does; a fit that has to be within the tolerance is, or says so. */
static void through(int dimension, size_t count, const double *x, const bat_fit_options *options) {
    bat_curve *curve = NULL;
    bat_fit_report report;
    bat_status status = bat_fit_within(dimension, count, x, options, &curve, &report);
    if (status == BAT_OK && !(report.max_error <= options->tolerance)) abort();
    bat_curve_free(curve);
    curve = NULL;
    status = bat_interpolate(dimension, options->closed, count, x, NULL, &curve);
    if (status != BAT_OK) {
        if (curve) abort();
        return;
    }
    double most = 0;
    for (size_t i = 0; i < count * (size_t)dimension; i++) most = fmax(most, fabs(x[i]));
    for (size_t i = 0; i < count && most < 1e60 && most > 1e-60; i++) {
        bat_near near;
        if (bat_curve_nearest(curve, x + i * (size_t)dimension, &near) != BAT_OK) abort();
        if (!(near.distance <= 1e-6 * most)) abort();
    }
    bat_curve_free(curve);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { MOST = 120 };
    double x[MOST * 3];
    int corners[4];
    if (size < 8) return 0;
    bat_fit_options options;
    bat_fit_options_init(&options, sizeof options);
    const int dimension = data[0] & 1 ? 3 : 2, wide = data[0] & 2;
    options.degree = 1 + data[1] % 7, options.closed = data[0] & 4;
    options.tolerance = ldexp(1, (int)(data[2] % 40) - 20), options.smoothing = data[0] & 8 ? data[3] : 0;
    options.corner_count = data[0] & 16 ? data[4] % 4 : 0, options.corners = corners;
    for (int i = 0; i < 4; i++) corners[i] = data[5] % 8 + i * (1 + data[6] % 16);
    options.solves_max = data[7] % 64, options.hold_ends = data[7] & 64;
    data += 8, size -= 8;
    size_t numbers = 0;
    if (wide) /* raw doubles, including every special value */
        for (; size >= 8 && numbers < MOST * 3; size -= 8, data += 8) memcpy(x + numbers++, data, 8);
    else
        for (; size >= 1 && numbers < MOST * 3; size--, data++) x[numbers++] = (double)*data - 128;
    const size_t count = numbers / (size_t)dimension;
    through(dimension, count, x, &options);
    bat_curve *curve = NULL;
    bat_fit_report report;
    const bat_status status = bat_fit(dimension, count, x, &options, &curve, &report);
    if (status != BAT_OK && status != BAT_TOLERANCE) {
        if (curve) abort();
        return 0;
    }
    if (status == BAT_OK && !(report.max_error <= options.tolerance)) abort();
    const double extent = bat_curve_size(curve) + fabs(x[0]);
    for (size_t i = 0; i < count && extent < 1e70; i++) {
        bat_near near;
        if (bat_curve_nearest(curve, x + i * (size_t)dimension, &near) != BAT_OK) abort();
        if (!(near.distance <= report.max_error + 1e-9 * extent)) abort();
    }
    bat_curve_free(curve);
    return 0;
}
