/* The rows and columns of vertices: their parameters, creases, seams. */
#include "form/surface/tessellate.h"

#include <math.h>
#include <stdlib.h>

static const double before = 1e-7; /* of a step: how far before a crease */

/* Whether tangents may jump at the end of a span. */
static bool is_crease(const bat_curve *axis, int span) {
    const double at = axis->knots[span + 1];
    if (!axis->closed && at == axis->knots[axis->spread]) return false;
    return bat_knot_multiplicity(axis, at) >= axis->degree;
}

/* Writes the stops of a direction; counts them when `stop` is NULL. */
static size_t put_stops(const bat_curve *axis, const bat_steps *steps, int d, bat_tile_stop *stop, double *at,
                        bool *wraps) {
    size_t count = 0;
    for (int k = 0; k < steps->spans[d]; k++) {
        const double *t = axis->knots + steps->span[d][k];
        const int n = steps->count[d][k];
        const bool last = k == steps->spans[d] - 1, crease = is_crease(axis, steps->span[d][k]);
        const bool end = crease || (last && !axis->closed);
        const double step = (t[1] - t[0]) / n;
        for (int i = 0; i < n + end; i++, count++) {
            if (!stop) continue;
            const double w = (double)i / n;
            at[count] = i == n ? t[1] : fmin(t[0] + w * (t[1] - t[0]), t[1]);
            stop[count] = (bat_tile_stop){.beside = at[count], .span = k};
            if (i < n) continue;
            stop[count].joint = crease;
            if (crease) stop[count].beside = fmax(t[1] - before * step, t[0]);
        }
        if (last) *wraps = axis->closed && !crease;
    }
    return count;
}

bat_status bat_stops_create(const bat_surface *surface, const bat_steps *steps, bat_tessellation *out) {
    size_t total = 0;
    for (int d = 0; d < 2; d++) {
        out->count[d] = put_stops(&surface->axis[d], steps, d, NULL, NULL, &out->wraps[d]);
        total += out->count[d];
        bat_surface_domain(surface, d == 0 ? BAT_U : BAT_V, out->domain[d]);
    }
    out->stop[0] = malloc(total * sizeof *out->stop[0]);
    out->at[0] = malloc(total * sizeof *out->at[0]);
    if (!out->stop[0] || !out->at[0]) return BAT_MEMORY;
    out->stop[1] = out->stop[0] + out->count[0], out->at[1] = out->at[0] + out->count[0];
    for (int d = 0; d < 2; d++)
        put_stops(&surface->axis[d], steps, d, out->stop[d], out->at[d], &out->wraps[d]);
    return BAT_OK;
}
