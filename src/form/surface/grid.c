/* Evaluation on a grid. For each u the rows become the control points of the iso-curve at u and of its
 * derivatives by u; these are curves along v, and are evaluated in bulk. */
#include "form/surface/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = BAT_DEGREE_MAX + 1 };

/* Evaluates the k-th derivative by u of the iso-curve along v, into the blocks of one row of the grid. */
static bat_status along(const bat_curve *line, int k, size_t count, const double *v, int order, double *work,
                        double *out) {
    const size_t block = (size_t)(3 * (order + 1) * (order + 2) / 2), size = (size_t)(3 * (order - k + 1));
    bat_status status = bat_curve_eval_many(line, count, v, order - k, order == 0 ? out : work);
    if (status != BAT_OK || order == 0) return status;
    for (int l = 0; l <= order - k; l++) {
        const int n = k + l;
        double *to = out + 3 * (n * (n + 1) / 2 + l);
        const double *from = work + 3 * l;
        for (size_t j = 0; j < count; j++, from += size, to += block) memcpy(to, from, 3 * sizeof(double));
    }
    return BAT_OK;
}

bat_status bat_surface_eval_grid(const bat_surface *surface, size_t u_count, const double *u, size_t v_count,
                                 const double *v, int order, double *out) {
    if (!surface || order < 0 || order > 2) return BAT_ARGUMENT;
    if (u_count == 0 || v_count == 0) return BAT_OK;
    if (!u || !v || !out) return BAT_ARGUMENT;
    const bat_curve whole = bat_surface_whole(surface);
    const int p = whole.degree, size = whole.dimension;
    const size_t net = (size_t)(p + 1) * (size_t)size, lines = (size_t)(order + 1) * (size_t)size;
    if (v_count > SIZE_MAX / 256) return BAT_COUNT;
    double *work = malloc((net + lines + v_count * 9) * sizeof *work);
    if (!work) return BAT_MEMORY;
    bat_status status = BAT_OK;
    int span = -1;
    for (size_t i = 0; i < u_count && status == BAT_OK; i++) {
        const double at = bat_curve_reduce(&whole, u[i]);
        if (isnan(at)) {
            status = BAT_NUMBER;
            break;
        }
        double rows[MOST][MOST];
        span = bat_span(&whole, at, span);
        memcpy(work, whole.points + (size_t)(span - p) * (size_t)size, net * sizeof *work);
        bat_basis_rows(&whole, span, at, rows);
        bat_eval_local(whole.knots + span, p, size, 0, order, rows, work, work + net);
        bat_curve line = surface->axis[1];
        for (int k = 0; k <= order && status == BAT_OK; k++) {
            line.points = work + net + (size_t)k * (size_t)size;
            status = along(&line, k, v_count, v, order, work + net + lines, out);
        }
        out += v_count * (size_t)(3 * (order + 1) * (order + 2) / 2);
    }
    free(work);
    return status;
}
