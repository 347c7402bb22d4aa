#include "curve/collocate.h"

#include <stdlib.h>

enum { WIDTH = 2 * BAT_DEGREE_MAX + 1 };

/* Row k holds the columns k - p .. k + p; those beyond the matrix are 0. */
static void assemble(const bat_curve *space, const double *u, double (*a)[WIDTH]) {
    const int p = space->degree;
    for (int k = 0; k < space->count; k++) {
        double basis[BAT_DEGREE_MAX + 1];
        int first;
        bat_curve_basis(space, u[k], &first, basis);
        for (int r = 0; r <= p; r++) a[k][first + r - k + p] = basis[r];
    }
}

/* Elimination downwards, then substitution upwards. */
static void solve(int p, int count, double (*a)[WIDTH], int columns, double *b) {
    for (int k = 0; k < count; k++) {
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
}

bat_status bat_collocate(const bat_curve *space, const double *u, int columns, double *values) {
    double(*a)[WIDTH] = calloc((size_t)space->count, sizeof *a);
    if (!a) return BAT_MEMORY;
    assemble(space, u, a);
    solve(space->degree, space->count, a, columns, values);
    free(a);
    return BAT_OK;
}
