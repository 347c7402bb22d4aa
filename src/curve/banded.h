/*
 * Inside the kernel: symmetric positive definite band matrices and their factors, open and cyclic.
 *
 * Storage, both kinds: row i holds a[i * (band + 1) + d] = A(i, i - d), d = 0..band; only the lower triangle.
 * Open: entries left of column 0 are not read. Cyclic: columns are modulo n, so that the first rows hold the
 * couplings with the last columns. A basis that is non-zero on indices k..k+p (cyclic: modulo n) is therefore
 * assembled without a special case: for every pair r >= s of them, a[row r][r - s] += w N_r N_s. This holds
 * even when n <= band and indices coincide.
 *
 * Factors are L D Lᵀ, L unit lower triangular, in place; the diagonal then holds 1 / D. No square roots.
 */
#ifndef BATTEN_SRC_BANDED_H
#define BATTEN_SRC_BANDED_H

#include <batten/base.h>

enum { BAT_BAND_MAX = 15 };

/* BAT_SINGULAR when a pivot is not positive, relative to its diagonal entry (this includes NaN); a is then
 * spoilt. Cost n * band^2; no allocation. 0 <= band <= BAT_BAND_MAX, n >= 1. */
bat_status bat_banded_factor(double *a, int n, int band);
/* Solves in place for `columns` interleaved right-hand sides: b[n * columns]. Cost n * band * columns. */
void bat_banded_solve(const double *a, int n, int band, double *b, int columns);

/*
 * The cyclic pair. border: room for n * band doubles, filled by the factorisation, needed by the solve. The
 * last `band` unknowns are the border of a bordered Cholesky factorisation; when n <= 2 * band the matrix is
 * dense (border then needs BAT_CYCLIC_DENSE doubles). Cost and errors as above, times about three. columns <=
 * BAT_BAND_MAX.
 */
enum { BAT_CYCLIC_DENSE = 4 * BAT_BAND_MAX * BAT_BAND_MAX };
bat_status bat_cyclic_factor(double *a, int n, int band, double *border);
void bat_cyclic_solve(const double *a, int n, int band, const double *border, double *b, int columns);
/* Doubles that `border` needs. */
size_t bat_cyclic_room(int n, int band);

#endif
