#include "hands/sketch/whittaker.h"
#include "curve/banded.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

bat_status bat_whittaker(size_t count, int dimension, const double *y, const double *weight, double lambda,
                         double *work, double *z) {
    const size_t m = (size_t)dimension;
    if (z != y) memcpy(z, y, count * m * sizeof *z);
    if (count < 5 || !(lambda > 0)) return BAT_OK;
    static const double difference[4] = {-1, 3, -3, 1};
    for (size_t i = 0; i < count; i++) {
        const double w = weight ? weight[i] : 1;
        work[i * 4] = w, work[i * 4 + 1] = work[i * 4 + 2] = work[i * 4 + 3] = 0;
        for (size_t c = 0; c < m; c++) z[i * m + c] *= w;
    }
    for (size_t i = 0; i + 3 < count; i++)
        for (size_t r = 0; r < 4; r++)
            for (size_t s = 0; s <= r; s++)
                work[(i + r) * 4 + (r - s)] += lambda * difference[r] * difference[s];
    bat_status status = bat_banded_factor(work, (int)count, 3);
    if (status != BAT_OK) return status;
    bat_banded_solve(work, (int)count, 3, z, dimension);
    return BAT_OK;
}

/* k-th smallest of values, which are reordered (Hoare's selection). */
static double select_rank(double *values, size_t count, size_t k) {
    size_t low = 0, high = count - 1;
    while (low < high) {
        const double pivot = values[low + (high - low) / 2];
        size_t i = low, j = high;
        for (;;) {
            while (values[i] < pivot) i++;
            while (values[j] > pivot) j--;
            if (i >= j) break;
            const double swap = values[i];
            values[i++] = values[j], values[j--] = swap;
        }
        if (values[j] > pivot && j > low) j--;
        if (k <= j)
            high = j;
        else
            low = j + 1;
    }
    return values[k];
}

double bat_noise(size_t count, int dimension, const double *points, double *work) {
    const size_t m = (size_t)dimension;
    if (count < 16) return 0;
    double worst = 0;
    for (size_t c = 0; c < m; c++) {
        double least = INFINITY;
        double binomial = 6; /* binom(2k, k), k = 2 */
        double *difference = work, *size = work + count;
        for (size_t i = 0; i < count; i++) difference[i] = points[i * m + c];
        for (size_t k = 1; k <= 6; k++) {
            const size_t n = count - k;
            for (size_t i = 0; i < n; i++) difference[i] = difference[i + 1] - difference[i];
            if (k < 3) continue;
            binomial *= (double)(2 * (2 * k - 1)) / (double)k;
            for (size_t i = 0; i < n; i++) size[i] = fabs(difference[i]);
            const double sigma = 1.4826 * select_rank(size, n, n / 2) / sqrt(binomial);
            if (sigma < least) least = sigma;
        }
        worst += least * least;
    }
    return sqrt(worst / (double)m);
}

bat_status bat_whittaker_sigma(size_t count, int dimension, const double *y, double sigma, double *work,
                               double *z, double *lambda) {
    const size_t m = (size_t)dimension;
    /* Above 1e10 the band matrix loses its digits; below 1e-2 nothing is smoothed. */
    double low = bat_log(1e-2), high = bat_log(1e10), middle = bat_log(1e4);
    for (int round = 0; round < 24; round++) {
        bat_status status = bat_whittaker(count, dimension, y, NULL, bat_exp(middle), work, z);
        if (status != BAT_OK) return status;
        double residual = 0;
        for (size_t i = 0; i < count * m; i++) residual += (y[i] - z[i]) * (y[i] - z[i]);
        residual = sqrt(residual / (double)(count * m));
        *lambda = bat_exp(middle);
        if (residual > sigma)
            high = middle;
        else if (residual < 0.95 * sigma)
            low = middle;
        else
            break;
        middle = 0.5 * (low + high);
    }
    return BAT_OK;
}
