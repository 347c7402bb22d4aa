#include "curve/collocate.h"

#include <math.h>
#include <stdlib.h>

enum { WIDTH = 2 * BAT_DEGREE_MAX + 1 };

/* Row k holds the columns k - p .. k + p; those beyond the matrix are 0. */
static bool assemble(const bat_curve *space, const double *u, double (*a)[WIDTH]) {
    const int p = space->degree;
    for (int k = 0; k < space->count; k++) {
        double basis[BAT_DEGREE_MAX + 1];
        int first;
        bat_curve_basis(space, u[k], &first, basis);
        if (first > k || k > first + p || !(basis[k - first] > 0)) return false;
        for (int r = 0; r <= p; r++) a[k][first + r - k + p] = basis[r];
    }
    return true;
}

/* Elimination downwards, then substitution upwards. */
static bool solve(int p, int count, double (*a)[WIDTH], int columns, double *b) {
    for (int k = 0; k < count; k++) {
        if (!(fabs(a[k][p]) > 1e-14)) return false;
        for (int i = k + 1; i <= k + p && i < count; i++) {
            const double factor = a[i][k - i + p] / a[k][p];
            if (factor == 0) continue;
            for (int c = k; c <= k + p && c < count; c++) a[i][c - i + p] -= factor * a[k][c - k + p];
            for (int c = 0; c < columns; c++)
                b[(size_t)i * (size_t)columns + (size_t)c] -= factor *
                                                              b[(size_t)k * (size_t)columns + (size_t)c];
        }
    }
    for (int k = count - 1; k >= 0; k--) {
        double *to = b + (size_t)k * (size_t)columns;
        for (int j = k + 1; j <= k + p && j < count; j++)
            for (int c = 0; c < columns; c++)
                to[c] -= a[k][j - k + p] * b[(size_t)j * (size_t)columns + (size_t)c];
        for (int c = 0; c < columns; c++) to[c] /= a[k][p];
    }
    return true;
}

bat_status bat_collocate(const bat_curve *space, const double *u, int columns, double *values) {
    double(*a)[WIDTH] = calloc((size_t)space->count, sizeof *a);
    if (!a) return BAT_MEMORY;
    const bool solved = assemble(space, u, a) && solve(space->degree, space->count, a, columns, values);
    free(a);
    return solved ? BAT_OK : BAT_SINGULAR;
}
