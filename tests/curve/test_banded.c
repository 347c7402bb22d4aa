/* Band solves, open and cyclic, agree with dense Gaussian elimination; singular matrices are reported. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include "curve/banded.h"

static uint64_t seed = 1;
static double uniform(void) { /* -1..1 */
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 4503599627370496.0 - 1.0;
}

/* Partial pivoting; the oracle. */
static void dense(double *m, int n, double *b, int columns) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(m[i * n + k]) > fabs(m[best * n + k])) best = i;
        for (int j = 0; j < n; j++) {
            double t = m[k * n + j];
            m[k * n + j] = m[best * n + j];
            m[best * n + j] = t;
        }
        for (int j = 0; j < columns; j++) {
            double t = b[k * columns + j];
            b[k * columns + j] = b[best * columns + j];
            b[best * columns + j] = t;
        }
        for (int i = k + 1; i < n; i++) {
            double f = m[i * n + k] / m[k * n + k];
            for (int j = k; j < n; j++) m[i * n + j] -= f * m[k * n + j];
            for (int j = 0; j < columns; j++) b[i * columns + j] -= f * b[k * columns + j];
        }
    }
    for (int i = n - 1; i >= 0; i--)
        for (int j = 0; j < columns; j++) {
            for (int k = i + 1; k < n; k++) b[i * columns + j] -= m[i * n + k] * b[k * columns + j];
            b[i * columns + j] /= m[i * n + i];
        }
}

/* Sum of w v vᵀ over random rows v that are non-zero on band + 1 neighbouring indices: a least-squares
 * matrix, assembled as banded.h says and, independently, as a full matrix. */
static void assemble(int n, int band, bool cyclic, double *a, double *full) {
    for (int i = 0; i < n * (band + 1); i++) a[i] = 0;
    for (int i = 0; i < n * n; i++) full[i] = 0;
    for (int sample = 0; sample < 4 * n + 8; sample++) {
        int first = cyclic ? sample % n : (n > band ? sample % (n - band) : 0);
        double v[BAT_BAND_MAX + 1];
        int last = cyclic || n > band ? band : n - 1;
        for (int k = 0; k <= last; k++) v[k] = uniform();
        for (int r = 0; r <= last; r++)
            for (int s = 0; s <= last; s++) {
                full[(first + r) % n * n + (first + s) % n] += v[r] * v[s];
                if (s <= r) a[(first + r) % n * (band + 1) + r - s] += v[r] * v[s];
            }
    }
    for (int i = 0; i < n; i++) {
        a[i * (band + 1)] += 0.5;
        full[i * n + i] += 0.5;
    }
}

static void compare(bool cyclic) {
    for (int band = 0; band <= 8; band++)
        for (int n = 1; n <= 40; n += n < 20 ? 1 : 7)
            for (int columns = 1; columns <= 3; columns++) {
                double *a = malloc(sizeof *a * (size_t)(n * (band + 1)));
                double *full = malloc(sizeof *full * (size_t)(n * n));
                double *border = malloc(sizeof *border * bat_cyclic_room(n, band) + 1);
                double b[120], x[120];
                assemble(n, band, cyclic, a, full);
                for (int i = 0; i < n * columns; i++) b[i] = x[i] = uniform();
                dense(full, n, x, columns);
                if (cyclic) {
                    assert_int_equal(bat_cyclic_factor(a, n, band, border), BAT_OK);
                    bat_cyclic_solve(a, n, band, border, b, columns);
                } else {
                    assert_int_equal(bat_banded_factor(a, n, band), BAT_OK);
                    bat_banded_solve(a, n, band, b, columns);
                }
                for (int i = 0; i < n * columns; i++) assert_true(fabs(b[i] - x[i]) < 1e-10);
                free(a), free(full), free(border);
            }
}

static void open_agrees_with_dense(void **state) {
    (void)state;
    compare(false);
}

static void cyclic_agrees_with_dense(void **state) {
    (void)state;
    compare(true);
}

/* The cyclic Laplacian has the constant in its kernel; so has every leading block with a zero row. */
static void singular_is_told(void **state) {
    (void)state;
    for (int n = 2; n < 30; n++) {
        double a[60], border[BAT_CYCLIC_DENSE];
        for (int i = 0; i < n; i++) a[2 * i] = 2, a[2 * i + 1] = -1;
        assert_int_equal(bat_cyclic_factor(a, n, 1, border), BAT_SINGULAR);
        for (int i = 0; i < n; i++) a[2 * i] = 2, a[2 * i + 1] = -1;
        assert_int_equal(bat_banded_factor(a, n, 1), BAT_OK);
        for (int i = 0; i < n; i++) a[2 * i] = i == n / 2 ? 0 : 2, a[2 * i + 1] = 0;
        assert_int_equal(bat_banded_factor(a, n, 1), BAT_SINGULAR);
        for (int i = 0; i < n; i++) a[2 * i] = i == n / 2 ? (double)NAN : 2, a[2 * i + 1] = 0;
        assert_int_equal(bat_banded_factor(a, n, 1), BAT_SINGULAR);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(open_agrees_with_dense),
                                       cmocka_unit_test(cyclic_agrees_with_dense),
                                       cmocka_unit_test(singular_is_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
