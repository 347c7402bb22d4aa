/* Inside the kernel: symmetric positive definite band matrices, and their Cholesky factors.
 * Row i holds a[i][0..band]: the diagonal and `band` entries left of it, a[i][d] = A(i, i - d). */
#ifndef BATTEN_SRC_BANDED_H
#define BATTEN_SRC_BANDED_H

#include <batten/base.h>

/* In place L Lᵀ; BAT_SINGULAR when a pivot is not positive. Cost n * band^2. */
bat_status bat_banded_factor(double *a, int n, int band);
/* Solves in place for `columns` interleaved right-hand sides: b[n * columns]. */
void bat_banded_solve(const double *a, int n, int band, double *b, int columns);
/* Cyclic case (closed curves): corner[i][j] couples the last `band` rows with the first; see banded.c. */
bat_status bat_cyclic_solve(double *a, int n, int band, double *b, int columns);

#endif
