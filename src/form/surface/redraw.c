/* Redraws an iso-curve of a surface; the rows beside it follow (docs/math/surfaces.md; Fowler and Bartels
 * 1993). */
#include "form/surface/surface.h"
#include "base/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = BAT_DEGREE_MAX + 1 };
static const double gain_max = 4, spans_reached = 2.5;
static const double point_size = 1e-12; /* of the surface's size: an iso-curve this short is a point */
static const bat_direction directions[2] = {BAT_U, BAT_V};

static const bat_surface_redraw_options DEFAULTS = {.size = sizeof DEFAULTS};
enum { LEAST = sizeof DEFAULTS }; /* size in version 0.2: the first member added later begins there */

void bat_surface_redraw_options_init(bat_surface_redraw_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

/* Below, the line is an iso-curve at u: it runs along v, and rows are numbered along u. */

static double mean_span(const bat_curve *axis) {
    double domain[2];
    int spans = 0;
    for (int i = axis->degree; i < axis->spread; i++) spans += axis->knots[i] < axis->knots[i + 1];
    bat_curve_domain(axis, domain);
    return (domain[1] - domain[0]) / spans;
}

/* x, or in a closed direction its periodic image nearest to u. */
static double seen_from(const bat_curve *axis, double u, double x) {
    double domain[2];
    bat_curve_domain(axis, domain);
    return axis->closed ? u + remainder(x - u, domain[1] - domain[0]) : x;
}

/* The bump at each row, 0 for rows that are held. greville: one abscissa per row. */
static void bump(const bat_curve *axis, double u, const bat_surface_redraw_options *options, double reach,
                 const double *greville, double *weights) {
    for (int i = 0; i < axis->count; i++) {
        const double x = (seen_from(axis, u, greville[i]) - u) / reach;
        weights[i] = fabs(x) < 1 ? (x * x - 1) * (x * x - 1) : 0;
    }
    for (size_t k = 0; k < options->hold_count; k++) weights[options->hold[k]] = 0;
}

/* Rows that are a single point stay: moved by different amounts along the line, they would open. */
static void hold_points(const bat_surface *surface, double *weights) {
    const int count = surface->axis[1].count;
    for (int i = 0; i < surface->axis[0].count; i++) {
        const double *row = bat_surface_row(surface, i);
        int same = 0;
        while (same < count && bat_distance(row, row + 3 * same, 3) <= point_size * surface->size) same++;
        if (same == count) weights[i] = 0;
    }
}

/* Whether an edge is a point of a surface; size: what its length is compared with. */
static bat_status is_pole(const bat_surface *surface, bat_direction across, int end, double size, bool *out) {
    double domain[2];
    bat_curve *edge;
    *out = false;
    if (bat_surface_is_closed(surface, across)) return BAT_OK;
    bat_surface_domain(surface, across, domain);
    bat_status status = bat_surface_isocurve(surface, across, domain[end], &edge);
    if (status != BAT_OK) return status;
    *out = bat_curve_size(edge) <= point_size * size;
    bat_curve_free(edge);
    return BAT_OK;
}

/* BAT_SINGULAR: an edge that was a point is none any more. */
static bat_status check_poles(const bat_surface *before, const bat_surface *after) {
    bat_status status = BAT_OK;
    for (int k = 0; k < 4 && status == BAT_OK; k++) {
        bool was, is = true;
        status = is_pole(before, directions[k / 2], k % 2, before->size, &was);
        if (status == BAT_OK && was) status = is_pole(after, directions[k / 2], k % 2, before->size, &is);
        if (status == BAT_OK && was && !is) status = BAT_SINGULAR;
    }
    return status;
}

/* Scales the bump so that the line moves by 1; false: the line cannot move. */
static bool scale(const bat_curve *axis, double u, double *weights, double *gain) {
    double basis[MOST], sum = 0;
    int first;
    bat_curve_basis(axis, u, &first, basis);
    for (int k = 0; k <= axis->degree; k++) sum += basis[k] * weights[(first + k) % axis->count];
    *gain = INFINITY;
    if (!(sum > 0)) return false;
    *gain = 0;
    for (int i = 0; i < axis->count; i++) {
        weights[i] /= sum;
        *gain = fmax(*gain, weights[i]);
    }
    return *gain <= gain_max;
}

/* The union of the supports of the rows that move, within the domain. */
static void support(const bat_curve *axis, double u, const double *weights, const double *greville,
                    double moved[2]) {
    const double *t = bat_curve_knots(axis); /* closed: reaches into the next period, which is stored */
    double domain[2];
    bat_curve_domain(axis, domain);
    moved[0] = moved[1] = u;
    for (int i = 0; i < axis->count; i++) {
        if (!(weights[i] > 0)) continue;
        const double shift = seen_from(axis, u, greville[i]) - greville[i];
        moved[0] = fmin(moved[0], t[i] + shift);
        moved[1] = fmax(moved[1], t[i + axis->degree + 1] + shift);
    }
    if (axis->closed) return;
    moved[0] = fmax(moved[0], domain[0]), moved[1] = fmin(moved[1], domain[1]);
}

/* The greatest distance between control points of the surface's line at u and those of the line asked for. */
static bat_status compare(const bat_surface *surface, double u, const bat_curve *line, double *error) {
    bat_curve *now;
    bat_status status = bat_surface_isocurve(surface, BAT_U, u, &now);
    if (status != BAT_OK) return status;
    *error = 0;
    for (int j = 0; j < now->count; j++)
        *error = fmax(*error, bat_distance(bat_curve_points(now) + 3 * j, bat_curve_points(line) + 3 * j, 3));
    bat_curve_free(now);
    return BAT_OK;
}

/* The surface with its rows moved by the weights. */
static bat_status carry(const bat_surface *surface, double u, const bat_curve *line, const double *weights,
                        bat_surface **out) {
    bat_curve *now;
    bat_surface *moved = NULL;
    bat_status status = bat_surface_isocurve(surface, BAT_U, u, &now);
    if (status != BAT_OK) return status;
    status = bat_surface_copy(surface, &moved);
    for (int i = 0; status == BAT_OK && i < moved->axis[0].count; i++) {
        double *row = bat_surface_own_row(moved, i);
        for (int k = 0; weights[i] > 0 && k < 3 * now->count; k++) {
            const double delta = bat_curve_points(line)[k] - bat_curve_points(now)[k];
            if (delta != 0) row[k] += weights[i] * delta;
        }
    }
    bat_curve_free(now);
    return status == BAT_OK ? bat_surface_finish(moved, out) : status;
}

static bat_status check(const bat_surface *surface, double u, const bat_curve *line,
                        const bat_surface_redraw_options *options) {
    const bat_curve *a = &surface->axis[0], *b = &surface->axis[1];
    if (isnan(u)) return BAT_NUMBER;
    if (line->dimension != 3) return BAT_DIMENSION;
    if (line->degree != b->degree) return BAT_DEGREE;
    if (line->closed != b->closed || !(options->reach >= 0) || !isfinite(options->reach)) return BAT_ARGUMENT;
    if (options->hold_count > 0 && !options->hold) return BAT_ARGUMENT;
    for (size_t k = 0; k < options->hold_count; k++)
        if (options->hold[k] < 0 || options->hold[k] >= a->count) return BAT_ARGUMENT;
    bat_curve *now;
    bat_status status = bat_surface_isocurve(surface, BAT_U, u, &now);
    if (status != BAT_OK) return status;
    if (!(bat_curve_size(now) > point_size * surface->size)) status = BAT_DOT;
    bat_curve_free(now);
    return status;
}

/* work: two numbers per row: the weights, then the Greville abscissae. */
static bat_status redraw(const bat_surface *surface, double at, const bat_curve *line,
                         const bat_surface_redraw_options *options, double *work, bat_surface **out,
                         bat_surface_redraw_report *report) {
    const bat_curve *axis = &surface->axis[0];
    double *weights = work, *greville = work + axis->count;
    const double u = bat_curve_reduce(axis, at);
    bat_status status = check(surface, u, line, options);
    if (status != BAT_OK) return status;
    bat_surface *fine = NULL;
    status = bat_surface_refine(surface, BAT_V, bat_curve_knot_count(line), bat_curve_knots(line), &fine);
    if (status != BAT_OK) return status;
    report->value = u;
    report->reach = options->reach > 0 ? options->reach : spans_reached * mean_span(axis);
    for (int d = 0; d < 2; d++) {
        report->knots_before[d] = bat_curve_knot_count(&surface->axis[d]);
        report->knots_after[d] = bat_curve_knot_count(&fine->axis[d]);
    }
    bat_curve_greville(axis, greville);
    bump(axis, u, options, report->reach, greville, weights);
    hold_points(surface, weights);
    const bool moves = scale(axis, u, weights, &report->gain);
    support(axis, u, weights, greville, report->moved);
    status = moves ? carry(fine, u, line, weights, out) : BAT_FAR;
    if (status == BAT_OK) {
        status = compare(*out, u, line, &report->line_error);
        if (status == BAT_OK) status = check_poles(surface, *out);
        if (status != BAT_OK) bat_surface_free(*out);
    }
    bat_surface_free(fine);
    return status;
}

static void exchange(int counts[2]) {
    const int first = counts[0];
    counts[0] = counts[1], counts[1] = first;
}

bat_status bat_surface_redraw(const bat_surface *surface, bat_direction direction, double at,
                              const bat_curve *line, const bat_surface_redraw_options *options,
                              bat_surface **out, double *weights, bat_surface_redraw_report *report) {
    if (!surface || !line || !out) return BAT_ARGUMENT;
    bat_surface_redraw_options own = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof own, &own);
    if (status != BAT_OK) return status;
    bat_surface *turned = NULL, *made = NULL;
    if (direction == BAT_V) status = bat_surface_transpose(surface, &turned);
    if (status != BAT_OK) return status;
    const bat_surface *upright = turned ? turned : surface;
    const size_t rows = bat_curve_count(&upright->axis[0]);
    double *work = malloc(2 * rows * sizeof *work);
    bat_surface_redraw_report found = {.gain = 0};
    status = work ? redraw(upright, at, line, &own, work, &made, &found) : BAT_MEMORY;
    if (status == BAT_OK && turned) {
        bat_surface *back = NULL;
        status = bat_surface_transpose(made, &back);
        bat_surface_free(made);
        made = back;
    }
    if (turned) exchange(found.knots_before), exchange(found.knots_after);
    if (status == BAT_OK) *out = made;
    if (status == BAT_OK || status == BAT_FAR) {
        if (weights) memcpy(weights, work, rows * sizeof *work);
        if (report) *report = found;
    }
    free(work);
    bat_surface_free(turned);
    return status;
}
