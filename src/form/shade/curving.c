#include "form/shade/curving.h"
#include "base/order.h"

#include <math.h>
#include <stdlib.h>

static const double usual = 0.95; /* share of the vertices whose curvature the range of colours holds */

static double curvature_at(const bat_surface *surface, double u, double v, bat_look look) {
    double gauss, mean;
    if (bat_surface_curvature(surface, u, v, &gauss, &mean) != BAT_OK) return NAN;
    return look == BAT_LOOK_GAUSS ? gauss : mean;
}

double bat_curving_value(const bat_surface *surface, const bat_mesh *m, size_t i, size_t j, bat_look look) {
    if (look != BAT_LOOK_GAUSS && look != BAT_LOOK_MEAN) return 0;
    const double u = m->u[i], v = m->v[j];
    const double x = u + 1e-2 * (m->u[i + 1 < m->rows ? i + 1 : i - 1] - u);
    const double y = v + 1e-2 * (m->v[j + 1 < m->columns ? j + 1 : j - 1] - v);
    double value = curvature_at(surface, u, v, look);
    if (!isfinite(value)) value = curvature_at(surface, x, v, look);
    if (!isfinite(value)) value = curvature_at(surface, u, y, look);
    return isfinite(value) ? value : 0;
}

double bat_curving_range(size_t count, double *values) {
    if (count == 0) return 0;
    for (size_t k = 0; k < count; k++) values[k] = fabs(values[k]);
    qsort(values, count, sizeof *values, bat_ascending); /* no ties */
    return values[(size_t)(usual * (double)(count - 1))];
}
