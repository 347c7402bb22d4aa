/* Elementary functions from + - * / and sqrt: range reduction, then a Taylor series cut off where the next
 * term is below half a unit in the last place (Muller, Elementary Functions, 3rd ed., ch. 3 and 11). */
#include "base/real.h"

#include <math.h>

/* ln 2 and pi / 2 in parts whose products with small integers are exact (Cody and Waite 1980). */
static const double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
static const double half_pi_1 = 0x1.921fb54400000p+0, half_pi_2 = 0x1.0b4611a600000p-34,
                    half_pi_3 = 0x1.3198a2e037073p-69;

double bat_hypot(double x, double y) {
    if (isinf(x) || isinf(y)) return INFINITY;
    double a = fabs(x), b = fabs(y);
    if (isnan(a) || isnan(b)) return a + b;
    double large = a > b ? a : b;
    if (large == 0) return 0;
    if (large > 0x1p-500 && large < 0x1p500) return sqrt(a * a + b * b);
    double scale = large > 1 ? 0x1p-600 : 0x1p600;
    a *= scale, b *= scale;
    return sqrt(a * a + b * b) / scale;
}

double bat_exp(double x) {
    if (isnan(x)) return x;
    if (x > 709.8) return INFINITY;
    if (x < -745.2) return 0;
    double k = floor(x / (ln2_high + ln2_low) + 0.5);
    double r = (x - k * ln2_high) - k * ln2_low; /* |r| <= 0.347 */
    double sum = 0;
    for (int n = 14; n >= 2; n--) sum = (sum + 1) * r / n;
    return ldexp(1 + (r + r * sum), (int)k);
}

double bat_log(double x) {
    if (isnan(x)) return x;
    if (x < 0) return NAN;
    if (x == 0) return -INFINITY;
    if (isinf(x)) return x;
    int e;
    double m = frexp(x, &e);
    if (m < 0.70710678118654752) m *= 2, e--;
    /* log m = 2 atanh s, s = (m - 1) / (m + 1), |s| <= 0.172 */
    double f = m - 1, s = f / (m + 1), z = s * s, sum = 0;
    for (int n = 23; n >= 3; n -= 2) sum = z * (sum + 1.0 / n);
    /* 2 s (1 + sum) = f - f s + 2 s sum: f is exact, the rest is small. */
    double log_m = f - s * (f - 2 * sum);
    return e * ln2_high + (log_m + e * ln2_low);
}

/* x = quarter * pi / 2 + r, |r| <= pi / 4; the quarter modulo 4. */
static double reduce(double x, int *quarter) {
    if (fabs(x) > 1e6) x = remainder(x, 2 * BAT_PI);
    double n = floor(x / (BAT_PI / 2) + 0.5);
    *quarter = (int)(n - 4 * floor(n / 4));
    return ((x - n * half_pi_1) - n * half_pi_2) - n * half_pi_3;
}

static double sine(double r) {
    double z = r * r, sum = 0;
    for (int n = 19; n >= 3; n -= 2) sum = -z * (1 + sum) / (n * (n - 1));
    return r + r * sum;
}

static double cosine(double r) {
    double z = r * r, sum = 0;
    for (int n = 20; n >= 4; n -= 2) sum = -z * (1 + sum) / (n * (n - 1));
    return 1 - z * (1 + sum) / 2;
}

double bat_sin(double x) {
    if (isnan(x) || isinf(x)) return NAN;
    if (x == 0) return x;
    int quarter;
    double r = reduce(x, &quarter);
    double value = quarter % 2 ? cosine(r) : sine(r);
    return quarter >= 2 ? -value : value;
}

double bat_cos(double x) {
    if (isnan(x) || isinf(x)) return NAN;
    int quarter;
    double r = reduce(x, &quarter);
    double value = quarter % 2 ? sine(r) : cosine(r);
    return quarter == 1 || quarter == 2 ? -value : value;
}

double bat_tan(double x) { return bat_sin(x) / bat_cos(x); }

/* atan of 0 <= a <= 1 from the nearest of five known values: atan a = atan c + atan((a - c) / (1 + a c)). */
static double atan_unit(double a) {
    static const double known[] = {0, 0.24497866312686414, 0.46364760900080609, 0.64350110879328437,
                                   0.78539816339744831};
    int i = (int)(4 * a + 0.5);
    double c = i / 4.0, t = (a - c) / (1 + a * c), z = t * t, sum = 0;
    for (int n = 21; n >= 3; n -= 2) sum = -z * (1.0 / n + sum);
    return known[i] + (t + t * sum);
}

double bat_atan(double x) { return bat_atan2(x, 1); }

double bat_atan2(double y, double x) {
    if (isnan(x) || isnan(y)) return x + y;
    double ax = fabs(x), ay = fabs(y), angle;
    if (ax == 0 && ay == 0) {
        angle = 0;
    } else if (isinf(x) && isinf(y)) {
        angle = BAT_PI / 4;
    } else {
        angle = ay <= ax ? atan_unit(ay / ax) : BAT_PI / 2 - atan_unit(ax / ay);
    }
    return copysign(signbit(x) ? BAT_PI - angle : angle, y);
}

double bat_acos(double x) { return bat_atan2(sqrt((1 - x) * (1 + x)), x); }

double bat_asin(double x) { return bat_atan2(x, sqrt((1 - x) * (1 + x))); }
