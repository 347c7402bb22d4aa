/* The edges of a surface, and those that are points; control points as one array. */
#include "form/relief/relief.h"

#include <string.h>

bat_edge bat_edge_of(const bat_surface *surface, int edge) {
    const size_t rows = (size_t)surface->axis[0].count, columns = (size_t)surface->axis[1].count;
    switch (edge) {
    case 0: return (bat_edge){0, 1, columns};
    case 1: return (bat_edge){(rows - 1) * columns, 1, columns};
    case 2: return (bat_edge){0, columns, rows};
    default: return (bat_edge){columns - 1, columns, rows};
    }
}

bool bat_edge_is_point(const bat_surface *surface, int edge, double slack) {
    const bat_curve *axis = &surface->axis[edge / 2];
    const double *t = axis->knots;
    const int end = edge % 2 ? axis->spread : 0, p = axis->degree;
    if (axis->closed || t[end] != t[end + p]) return false;
    const bat_edge e = bat_edge_of(surface, edge);
    const size_t columns = (size_t)surface->axis[1].count;
    const double *first = bat_surface_row(surface, (int)(e.first / columns)) + 3 * (e.first % columns);
    for (size_t k = 1; k < e.count; k++) {
        const size_t at = e.first + k * e.step;
        const double *point = bat_surface_row(surface, (int)(at / columns)) + 3 * (at % columns);
        for (int c = 0; c < 3; c++)
            if (!(fabs(point[c] - first[c]) <= slack)) return false;
    }
    return true;
}

/* One pole: the vectors on the edges of `group`. */
static void mean_of(const bat_surface *surface, const int pole[BAT_EDGES], int group, double *vectors) {
    const double *first = NULL;
    double sum[3] = {0, 0, 0}, total = 0;
    bool equal = true;
    for (int pass = 0; pass < 2; pass++) {
        for (int e = 0; e < BAT_EDGES; e++) {
            if (pole[e] != group) continue;
            const bat_edge edge = bat_edge_of(surface, e);
            for (size_t k = 0; k < edge.count; k++) {
                double *v = vectors + 3 * (edge.first + k * edge.step);
                first = first ? first : v;
                for (int c = 0; c < 3; c++) {
                    equal = equal && v[c] == first[c];
                    if (pass == 0)
                        sum[c] += v[c];
                    else
                        v[c] = sum[c] / total;
                }
                total += pass == 0;
            }
        }
        if (equal) return; /* also bit for bit as they were */
    }
}

void bat_pole_mean(const bat_surface *surface, const int pole[BAT_EDGES], double *vectors) {
    for (int e = 0; e < BAT_EDGES; e++)
        if (pole[e] == e) mean_of(surface, pole, e, vectors);
}

/* ---- points as one array ---- */

void bat_surface_gather(const bat_surface *surface, double *out) {
    const size_t width = 3 * (size_t)surface->axis[1].count;
    for (int i = 0; i < surface->axis[0].count; i++)
        memcpy(out + (size_t)i * width, bat_surface_row(surface, i), width * sizeof *out);
}

bat_status bat_surface_remade(const bat_surface *surface, const double *points, bat_surface **out) {
    bat_surface *made = NULL;
    bat_status status = bat_surface_copy(surface, &made);
    if (status != BAT_OK) return status;
    const size_t width = 3 * (size_t)surface->axis[1].count;
    for (int i = 0; i < surface->axis[0].count; i++)
        memcpy(bat_surface_own_row(made, i), points + (size_t)i * width, width * sizeof *points);
    return bat_surface_finish(made, out);
}
