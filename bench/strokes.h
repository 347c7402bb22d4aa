/* Workload: strokes like recorded ones, made from formulas and a seeded generator, the same in every program. */
#ifndef BATTEN_BENCH_STROKES_H
#define BATTEN_BENCH_STROKES_H

#include <math.h>
#include <stdint.h>

static inline double stroke_noise(uint64_t *state) { /* bell-shaped, -1..1: sum of three uniforms */
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        *state = *state * 6364136223846793005u + 1442695040888963407u;
        sum += (double)(*state >> 11) / 9007199254740992.0 - 0.5;
    }
    return sum / 1.5;
}

/* kind 0: eight bends, 1: spiral, 2: car line. noise: greatest offset of each coordinate, px. out: 2 * count.
 */
static inline void stroke_make(int kind, int count, double noise, double *out) {
    uint64_t state = 12345 + (uint64_t)kind;
    const double pi = 3.14159265358979323846;
    for (int i = 0; i < count; i++) {
        const double t = (double)i / (count - 1);
        double x, y;
        if (kind == 0) {
            x = 1000 * t, y = 120 * sin(8 * pi * t) * (0.6 + 0.4 * cos(3 * t));
        } else if (kind == 1) {
            const double a = 5 * pi * t, r = 30 + 200 * t;
            x = r * cos(a), y = r * sin(a);
        } else { /* bonnet, screen, roof, tail: smooth steps between slopes */
            x = 900 * t;
            y = 40 * sin(1.2 * pi * t) + 90 / (1 + exp(-(t - 0.33) * 28)) + 30 * sin(pi * t) -
                85 / (1 + exp(-(t - 0.8) * 22));
        }
        out[2 * i] = x + noise * stroke_noise(&state), out[2 * i + 1] = y + noise * stroke_noise(&state);
    }
}

#endif
