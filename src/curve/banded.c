/* Square-root-free Cholesky of band matrices, Golub & Van Loan 4.3.5, and its bordered form for cyclic ones.
 */
#include "curve/banded.h"

#include <float.h>

/* A pivot this far below its diagonal is rounding, not information. NaN fails, too. */
static bool pivot_holds(double pivot, double diagonal) { return pivot > 32 * DBL_EPSILON * diagonal; }

/* Written once; called with constant bands below so that the compiler unrolls the usual cases. */
static inline bat_status factor(double *a, int n, int band) {
    const int width = band + 1;
    for (int i = 0; i < n; i++) {
        double *row = a + (size_t)i * (size_t)width;
        const int reach = i < band ? i : band;
        const double diagonal = row[0];
        double pivot = diagonal;
        double v[BAT_BAND_MAX + 1]; /* v[d] = L(i, i-d) D(i-d) */
        for (int d = reach; d >= 1; d--) {
            const double *other = row - d * width;
            double sum = row[d];
            for (int e = reach; e > d; e--) sum -= v[e] * other[e - d];
            v[d] = sum;
            row[d] = sum * other[0];
            pivot -= sum * row[d];
        }
        if (!pivot_holds(pivot, diagonal)) return BAT_SINGULAR;
        row[0] = 1.0 / pivot;
    }
    return BAT_OK;
}

bat_status bat_banded_factor(double *a, int n, int band) {
    switch (band) {
    case 1: return factor(a, n, 1);
    case 2: return factor(a, n, 2);
    case 3: return factor(a, n, 3);
    default: return factor(a, n, band);
    }
}

/* b := L⁻¹ b */
static inline void forward(const double *a, int n, int band, double *b, int columns) {
    const int width = band + 1;
    for (int i = 0; i < n; i++) {
        const double *row = a + (size_t)i * (size_t)width;
        double *out = b + (size_t)i * (size_t)columns;
        const int reach = i < band ? i : band;
        for (int d = 1; d <= reach; d++)
            for (int c = 0; c < columns; c++) out[c] -= row[d] * out[c - d * columns];
    }
}

static void scale(const double *a, int n, int band, double *b, int columns) {
    for (int i = 0; i < n; i++)
        for (int c = 0; c < columns; c++)
            b[(size_t)i * (size_t)columns + (size_t)c] *= a[(size_t)i * (size_t)(band + 1)];
}

/* b := L⁻ᵀ b */
static inline void backward(const double *a, int n, int band, double *b, int columns) {
    const int width = band + 1;
    for (int i = n - 1; i >= 0; i--) {
        const double *row = a + (size_t)i * (size_t)width;
        const double *in = b + (size_t)i * (size_t)columns;
        double *out = b + (size_t)i * (size_t)columns;
        const int reach = i < band ? i : band;
        for (int d = 1; d <= reach; d++)
            for (int c = 0; c < columns; c++) out[c - d * columns] -= row[d] * in[c];
    }
}

static inline void solve(const double *a, int n, int band, double *b, int columns) {
    forward(a, n, band, b, columns);
    scale(a, n, band, b, columns);
    backward(a, n, band, b, columns);
}

void bat_banded_solve(const double *a, int n, int band, double *b, int columns) {
    if (band == 3 && columns == 2)
        solve(a, n, 3, b, 2);
    else if (band == 3 && columns == 3)
        solve(a, n, 3, b, 3);
    else
        solve(a, n, band, b, columns);
}

size_t bat_cyclic_room(int n, int band) {
    if (n <= 2 * band) return BAT_CYCLIC_DENSE;
    return (size_t)n * (size_t)band;
}

/* Dense matrix of n rows as a band matrix of band n - 1, at most 2 * BAT_BAND_MAX rows. */
static bat_status dense_factor(double *m, int n) {
    for (int i = 0; i < n; i++) {
        const double diagonal = m[i * n + i];
        double pivot = diagonal;
        double v[2 * BAT_BAND_MAX];
        for (int j = 0; j < i; j++) {
            double sum = m[i * n + j];
            for (int k = 0; k < j; k++) sum -= v[k] * m[j * n + k];
            v[j] = sum;
            m[i * n + j] = sum * m[j * n + j];
            pivot -= sum * m[i * n + j];
        }
        if (!pivot_holds(pivot, diagonal)) return BAT_SINGULAR;
        m[i * n + i] = 1.0 / pivot;
    }
    return BAT_OK;
}

static void dense_solve(const double *m, int n, double *b, int columns) {
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            for (int c = 0; c < columns; c++) b[i * columns + c] -= m[i * n + j] * b[j * columns + c];
    for (int i = 0; i < n; i++)
        for (int c = 0; c < columns; c++) b[i * columns + c] *= m[i * n + i];
    for (int i = n - 1; i >= 0; i--)
        for (int j = 0; j < i; j++)
            for (int c = 0; c < columns; c++) b[j * columns + c] -= m[i * n + j] * b[i * columns + c];
}

/* Below 2 * band + 1 unknowns couplings overlap: add them up in a full matrix. */
static bat_status small_factor(const double *a, int n, int band, double *m) {
    for (int i = 0; i < n * n; i++) m[i] = 0;
    for (int i = 0; i < n; i++) {
        m[i * n + i] += a[i * (band + 1)];
        for (int d = 1; d <= band; d++) {
            const int j = ((i - d) % n + n) % n;
            m[i * n + j] += a[i * (band + 1) + d];
            m[j * n + i] += a[i * (band + 1) + d];
        }
    }
    return dense_factor(m, n);
}

bat_status bat_cyclic_factor(double *a, int n, int band, double *border) {
    if (band == 0) return factor(a, n, 0);
    if (n <= 2 * band) return small_factor(a, n, band, border);

    /* Leading m unknowns: a plain band matrix. B: m x band, its couplings with the last `band` unknowns. */
    const int m = n - band, width = band + 1;
    double *corner = border + (size_t)m * (size_t)band; /* band x band */
    for (size_t i = 0; i < (size_t)n * (size_t)band; i++) border[i] = 0;
    for (int i = 0; i < band; i++) /* first rows: wrapped entries */
        for (int d = i + 1; d <= band; d++) border[i * band + band + i - d] = a[i * width + d];
    for (int j = 0; j < band; j++) { /* last rows: entries left of the corner, and the corner itself */
        const double *row = a + (size_t)(m + j) * (size_t)width;
        for (int d = 0; d <= band; d++) {
            if (d <= j)
                corner[j * band + j - d] = row[d];
            else
                border[(size_t)(m + j - d) * (size_t)band + (size_t)j] += row[d];
        }
    }
    if (bat_banded_factor(a, m, band) != BAT_OK) return BAT_SINGULAR;
    forward(a, m, band, border, band); /* W = L⁻¹ B */
    double diagonal[BAT_BAND_MAX];
    for (int j = 0; j < band; j++) diagonal[j] = corner[j * band + j];
    for (int i = 0; i < m; i++) { /* Schur complement: corner - Wᵀ D⁻¹ W */
        const double *w = border + (size_t)i * (size_t)band;
        const double inverse = a[(size_t)i * (size_t)width];
        for (int j = 0; j < band; j++)
            for (int k = 0; k <= j; k++) corner[j * band + k] -= w[j] * inverse * w[k];
    }
    for (int j = 0; j < band; j++)
        if (!pivot_holds(corner[j * band + j], diagonal[j])) return BAT_SINGULAR;
    return dense_factor(corner, band);
}

void bat_cyclic_solve(const double *a, int n, int band, const double *border, double *b, int columns) {
    if (band == 0) {
        solve(a, n, 0, b, columns);
        return;
    }
    if (n <= 2 * band) {
        dense_solve(border, n, b, columns);
        return;
    }
    const int m = n - band, width = band + 1;
    double *tail = b + (size_t)m * (size_t)columns;
    forward(a, m, band, b, columns);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < band; j++) {
            const double factor_ij = border[(size_t)i * (size_t)band + (size_t)j] *
                                     a[(size_t)i * (size_t)width];
            for (int c = 0; c < columns; c++)
                tail[j * columns + c] -= factor_ij * b[(size_t)i * (size_t)columns + (size_t)c];
        }
    dense_solve(border + (size_t)m * (size_t)band, band, tail, columns);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < band; j++)
            for (int c = 0; c < columns; c++)
                b[(size_t)i * (size_t)columns + (size_t)c] -= border[(size_t)i * (size_t)band + (size_t)j] *
                                                              tail[j * columns + c];
    scale(a, m, band, b, columns);
    backward(a, m, band, b, columns);
}
