/* The tangent of an angle's eighth is at most .2, where the series of atan is short: it takes three halvings, tan(x / 2) =
 * tan x / (1 + sqrt(1 + tan^2 x)). Sine and cosine are those of the half, from their series, doubled. */
#include "form/wire/turns.h"

#include "base/real.h"

#include <float.h>
#include <math.h>

static inline double atan_small(double t) {
    const double z = -t * t;
    double sum = 1.0 / 23;
    sum = 1.0 / 21 + z * sum, sum = 1.0 / 19 + z * sum, sum = 1.0 / 17 + z * sum;
    sum = 1.0 / 15 + z * sum, sum = 1.0 / 13 + z * sum, sum = 1.0 / 11 + z * sum;
    sum = 1.0 / 9 + z * sum, sum = 1.0 / 7 + z * sum, sum = 1.0 / 5 + z * sum;
    sum = 1.0 / 3 + z * sum;
    return t + t * (z * sum);
}

/* Of x from 0 to pi / 2. */
static inline double sine_of(double x) {
    const double z = -x * x;
    double sum = 1 + z * (1.0 / 342);
    sum = 1 + z * (1.0 / 272) * sum, sum = 1 + z * (1.0 / 210) * sum, sum = 1 + z * (1.0 / 156) * sum;
    sum = 1 + z * (1.0 / 110) * sum, sum = 1 + z * (1.0 / 72) * sum, sum = 1 + z * (1.0 / 42) * sum;
    sum = 1 + z * (1.0 / 20) * sum, sum = 1 + z * (1.0 / 6) * sum;
    return x * sum;
}

static inline double cosine_of(double x) {
    const double z = -x * x;
    double sum = 1 + z * (1.0 / 380);
    sum = 1 + z * (1.0 / 306) * sum, sum = 1 + z * (1.0 / 240) * sum, sum = 1 + z * (1.0 / 182) * sum;
    sum = 1 + z * (1.0 / 132) * sum, sum = 1 + z * (1.0 / 90) * sum, sum = 1 + z * (1.0 / 56) * sum;
    sum = 1 + z * (1.0 / 30) * sum, sum = 1 + z * (1.0 / 12) * sum, sum = 1 + z * (1.0 / 2) * sum;
    return sum;
}

void bat_turns(size_t count, const double *parts, double *sine, double *cosine) {
    for (size_t i = 0; i < count; i++) {
        const double s = sine[i], c = cosine[i], a = fabs(c);
        const double half = s / (sqrt(s * s + c * c) + a + DBL_MIN);
        const double quarter = half / (1 + sqrt(1 + half * half));
        const double eighth = quarter / (1 + sqrt(1 + quarter * quarter));
        const double acute = 8 * atan_small(eighth), angle = c < 0 ? BAT_PI - acute : acute;
        const double x = 0.5 * parts[i] * angle, sx = sine_of(x), cx = cosine_of(x);
        sine[i] = 2 * sx * cx;
        cosine[i] = 1 - 2 * sx * sx;
    }
}
