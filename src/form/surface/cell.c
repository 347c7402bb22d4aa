#include "form/surface/cell.h"
#include "base/lanes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = BAT_DEGREE_MAX + 1 };

bool bat_cells_hold(bat_cells *cells, int wanted) {
    if (wanted <= cells->room) return true;
    const int room = wanted < 4 ? 8 : 2 * wanted;
    bat_cell *at = realloc(cells->at, (size_t)room * sizeof *at);
    if (!at) return false;
    *cells = (bat_cells){at, room};
    return true;
}

/* Converts the points of one span of an axis to a Bézier segment, in place; they lie `stride` points apart. */
static void to_bezier(const bat_curve *axis, int span, double *points, int stride) {
    const int p = axis->degree;
    double in[MOST * 3], out[MOST * 3];
    for (int i = 0; i <= p; i++) memcpy(in + 3 * i, points + 3 * i * stride, 3 * sizeof(double));
    bat_curve one = *axis; /* only this span */
    one.knots = axis->knots + (span - p), one.points = in;
    bat_span_bezier(&one, p, out);
    for (int i = 0; i <= p; i++) memcpy(points + 3 * i * stride, out + 3 * i, 3 * sizeof(double));
}

void bat_cell_gather(const bat_surface *surface, const int span[2], double *net) {
    const int p = surface->axis[0].degree, q = surface->axis[1].degree;
    for (int i = 0; i <= p; i++) {
        const bat_curve row = bat_surface_stored_row(surface, span[0] - p + i);
        memcpy(net + 3 * i * (q + 1), row.points + (size_t)(span[1] - q) * 3,
               (size_t)(q + 1) * 3 * sizeof(double));
    }
}

void bat_cell_shares(const bat_curve *axis, int span, double *out) {
    const int p = axis->degree;
    double unit[MOST], bezier[MOST];
    bat_curve one = *axis; /* only this span */
    one.dimension = 1, one.knots = axis->knots + (span - p), one.points = unit;
    for (int i = 0; i <= p; i++) {
        for (int k = 0; k <= p; k++) unit[k] = k == i;
        bat_span_bezier(&one, p, bezier);
        for (int k = 0; k <= p; k++) out[k * (p + 1) + i] = bezier[k];
    }
}

/* For `lines` lines of p + 1 points, `stride` numbers apart. */
BAT_INLINE void share_lines(const int p, int lines, int apart, int stride, const double *shares,
                            double *net) {
    for (int k = 0; k < lines; k++) {
        double *line = net + k * apart, old[3 * MOST];
        for (int i = 0; i <= p; i++)
            for (int c = 0; c < 3; c++) old[3 * i + c] = line[i * stride + c];
        for (int i = 0; i <= p; i++)
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int j = 0; j <= p; j++) sum += shares[i * (p + 1) + j] * old[3 * j + c];
                line[i * stride + c] = sum;
            }
    }
}

void bat_cell_share(const int degree[2], const double *const shares[2], double *net) {
    const int p = degree[0], q = degree[1], row = 3 * (q + 1);
    if (p == 3 && q == 3) { /* the usual case, unrolled */
        share_lines(3, 4, 12, 3, shares[1], net);
        share_lines(3, 4, 3, 12, shares[0], net);
    } else {
        share_lines(q, p + 1, row, 3, shares[1], net);
        share_lines(p, q + 1, 3, row, shares[0], net);
    }
}

void bat_cell_of(const bat_surface *surface, const int span[2], bat_cell *out) {
    const bat_curve *a = &surface->axis[0], *b = &surface->axis[1];
    const int p = a->degree, q = b->degree;
    bat_cell_gather(surface, span, out->net);
    for (int i = 0; i <= p; i++) to_bezier(b, span[1], out->net + 3 * i * (q + 1), 1);
    for (int j = 0; j <= q; j++) to_bezier(a, span[0], out->net + 3 * j, q + 1);
    out->low[0] = out->low[1] = 0, out->high[0] = out->high[1] = 1;
    out->halvings = 0;
}

/* De Casteljau's algorithm at the middle, for p + 1 points that lie `stride` numbers apart. */
static void halve_line(int p, int stride, double *lower, double *upper) {
    memcpy(upper + p * stride, lower + p * stride, 3 * sizeof(double));
    for (int r = 1; r <= p; r++) {
        for (int i = p; i >= r; i--)
            for (int c = 0; c < 3; c++)
                lower[i * stride + c] = 0.5 * (lower[(i - 1) * stride + c] + lower[i * stride + c]);
        memcpy(upper + (p - r) * stride, lower + p * stride, 3 * sizeof(double));
    }
}

void bat_cell_halve(const int degree[2], int direction, bat_cell *cell, bat_cell *upper) {
    const int row = 3 * (degree[1] + 1), lines = degree[1 - direction] + 1;
    for (int k = 0; k < lines; k++) {
        const int at = direction == 0 ? 3 * k : k * row;
        halve_line(degree[direction], direction == 0 ? row : 3, cell->net + at, upper->net + at);
    }
    cell->halvings++;
    upper->halvings = cell->halvings;
    memcpy(upper->low, cell->low, sizeof cell->low);
    memcpy(upper->high, cell->high, sizeof cell->high);
    upper->low[direction] = cell->high[direction] = 0.5 * (cell->low[direction] + cell->high[direction]);
}

double bat_span_parameter(const bat_surface *surface, int direction, int span, double x) {
    const double *t = surface->axis[direction].knots + span;
    return x == 1 ? t[1] : t[0] + x * (t[1] - t[0]);
}
