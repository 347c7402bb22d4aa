/* Curves and surfaces in steps that are no longer than the spacing: a bound on the speed in each span says how many. */
#include "form/compare/sums.h"
#include "base/vec.h"
#include "form/surface/surface.h"

#include <math.h>
#include <string.h>

static const double GAUSS = 0.5773502691896257645091488; /* two nodes, at plus and minus this */

/* How many steps of at most the spacing are in a span of parameters. */
static double steps_of(double speed, double span, double spacing) {
    return spacing > 0 ? fmax(ceil(speed * span / spacing), 1) : 1;
}

/* ---- curves ---- */

static void place_on_curve(const void *thing, size_t piece, double x[2], double point[3]) {
    (void)piece;
    x[0] = bat_curve_reduce(thing, x[0]);
    point[2] = 0;
    bat_curve_eval(thing, x[0], 0, point);
}

/* The greatest of p |P_i - P_(i-1)| / (t_(i+p) - t_i) over the span: the speed is not above it. */
static double speed_in(const bat_curve *curve, int span) {
    const int p = curve->degree, m = curve->dimension;
    double most = 0;
    for (int i = span - p + 1; i <= span; i++) {
        const double *at = curve->points + (size_t)i * (size_t)m;
        most = fmax(most, p * bat_distance(at, at - m, m) / (curve->knots[i + p] - curve->knots[i]));
    }
    return most;
}

static bat_status sample_step(bat_sums *sums, const bat_curve *curve, double middle, double half) {
    bat_status status = BAT_OK;
    for (int k = -1; k <= 1 && status == BAT_OK; k += 2) {
        double jet[2 * BAT_DIMENSION_MAX] = {0}, x[2] = {middle + k * GAUSS * half, 0};
        const int m = curve->dimension;
        bat_curve_eval(curve, x[0], 1, jet);
        status = bat_sums_add(sums, x, half * vec_norm(vec_load(jet + m, m)), NULL);
    }
    return status;
}

static bat_status sample_span(bat_sums *sums, const bat_curve *curve, int span) {
    const double low = curve->knots[span], wide = curve->knots[span + 1] - low;
    if (!(wide > 0)) return BAT_OK;
    const double count = steps_of(speed_in(curve, span), wide, sums->found.spacing), step = wide / count;
    bat_status status = count <= BAT_SUMS_MOST ? BAT_OK : BAT_COUNT;
    bat_sums_piece(sums, 0, (const double[2]){step, 0});
    for (double i = 0; i <= count && status == BAT_OK; i++) {
        const double at = i < count ? low + i * step : low + wide;
        status = bat_sums_add(sums, (const double[2]){at, 0}, 0, NULL);
        if (status == BAT_OK && i < count) status = sample_step(sums, curve, at + 0.5 * step, 0.5 * step);
    }
    return status;
}

bat_status bat_curve_deviation(const bat_curve *curve, const bat_reference *reference, double spacing,
                               bat_deviation *out) {
    if (!curve || !reference || !out) return BAT_ARGUMENT;
    bat_sums sums = {.reference = reference, .thing = curve, .place = place_on_curve};
    bat_status status = bat_sums_begin(&sums, spacing, bat_curve_size(curve));
    for (int i = curve->degree; i < curve->spread && status == BAT_OK; i++)
        status = sample_span(&sums, curve, i);
    return status == BAT_OK ? bat_sums_finish(&sums, out) : status;
}

/* ---- surfaces ---- */

static void place_on_surface(const void *thing, size_t piece, double x[2], double point[3]) {
    const bat_surface *surface = thing;
    (void)piece;
    for (int d = 0; d < 2; d++) x[d] = bat_curve_reduce(&surface->axis[d], x[d]);
    bat_surface_eval(surface, x[0], x[1], 0, point);
}

/* Not below the length of the derivative in a direction anywhere in a cell of spans. */
static double speed_across(const bat_surface *surface, const int span[2], int d) {
    const int p = surface->axis[d].degree, q = surface->axis[1 - d].degree;
    const size_t row = 3 * (size_t)surface->axis[1].spread, along = d == 0 ? row : 3,
                 across = d == 0 ? 3 : row;
    const double *t = surface->axis[d].knots;
    double most = 0;
    for (int i = span[d] - p + 1; i <= span[d]; i++)
        for (int j = span[1 - d] - q; j <= span[1 - d]; j++) {
            const double *at = surface->points + (size_t)i * along + (size_t)j * across;
            most = fmax(most, p * bat_distance(at, at - along, 3) / (t[i + p] - t[i]));
        }
    return most;
}

static bat_status sample_cell(bat_sums *sums, const bat_surface *surface, const double middle[2],
                              const double half[2]) {
    bat_status status = BAT_OK;
    for (int k = 0; k < 4 && status == BAT_OK; k++) {
        const double x[2] = {middle[0] + (k & 1 ? GAUSS : -GAUSS) * half[0],
                             middle[1] + (k & 2 ? GAUSS : -GAUSS) * half[1]};
        double jet[9];
        bat_surface_eval(surface, x[0], x[1], 1, jet);
        const double area = vec_norm(vec_cross(vec_load(jet + 3, 3), vec_load(jet + 6, 3)));
        status = bat_sums_add(sums, x, half[0] * half[1] * area, NULL);
    }
    return status;
}

static bat_status sample_spans(bat_sums *sums, const bat_surface *surface, const int span[2]) {
    double low[2], wide[2], count[2], step[2];
    for (int d = 0; d < 2; d++) {
        const double *t = surface->axis[d].knots + span[d];
        low[d] = t[0], wide[d] = t[1] - t[0];
        if (!(wide[d] > 0)) return BAT_OK;
        count[d] = steps_of(speed_across(surface, span, d), wide[d], sums->found.spacing);
        step[d] = wide[d] / count[d];
    }
    bat_status status = count[0] * count[1] <= BAT_SUMS_MOST ? BAT_OK : BAT_COUNT;
    bat_sums_piece(sums, 0, step);
    for (double i = 0; i <= count[0] && status == BAT_OK; i++)
        for (double j = 0; j <= count[1] && status == BAT_OK; j++) {
            const double x[2] = {i < count[0] ? low[0] + i * step[0] : low[0] + wide[0],
                                 j < count[1] ? low[1] + j * step[1] : low[1] + wide[1]};
            status = bat_sums_add(sums, x, 0, NULL);
            const double half[2] = {0.5 * step[0], 0.5 * step[1]};
            if (status == BAT_OK && i < count[0] && j < count[1])
                status = sample_cell(sums, surface, (const double[2]){x[0] + half[0], x[1] + half[1]}, half);
        }
    return status;
}

bat_status bat_surface_deviation(const bat_surface *surface, const bat_reference *reference, double spacing,
                                 bat_deviation *out) {
    if (!surface || !reference || !out) return BAT_ARGUMENT;
    bat_sums sums = {.reference = reference, .thing = surface, .place = place_on_surface};
    const bat_curve *axis = surface->axis;
    bat_status status = bat_sums_begin(&sums, spacing, bat_surface_size(surface));
    for (int i = axis[0].degree; i < axis[0].spread; i++)
        for (int j = axis[1].degree; j < axis[1].spread && status == BAT_OK; j++)
            status = sample_spans(&sums, surface, (const int[2]){i, j});
    return status == BAT_OK ? bat_sums_finish(&sums, out) : status;
}
