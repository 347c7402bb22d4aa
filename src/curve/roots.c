#include "curve/roots.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { DEPTH = 45 };

typedef struct piece {
    double a[BAT_BERNSTEIN_MAX + 1];
    double x0, x1;
    int depth;
} piece;

static double value(int degree, const double *a, double x) {
    double b[BAT_BERNSTEIN_MAX + 1];
    memcpy(b, a, (size_t)(degree + 1) * sizeof *b);
    for (int r = degree; r > 0; r--)
        for (int i = 0; i < r; i++) b[i] += (b[i + 1] - b[i]) * x;
    return b[0];
}

static void halve(int degree, piece *left, piece *right) {
    for (int r = 0; r <= degree; r++) {
        right->a[degree - r] = left->a[degree];
        for (int i = degree; i > r; i--) left->a[i] = 0.5 * (left->a[i - 1] + left->a[i]);
    }
    const double middle = 0.5 * (left->x0 + left->x1);
    right->x0 = middle, right->x1 = left->x1, left->x1 = middle;
    right->depth = ++left->depth;
}

/* The only sign change of a0 s^2 + 2 a1 s t + a2 t^2 with s = 1 - x, t = x; no difference of like numbers is taken. */
static double quadratic(const double *a, int first) {
    /* As below, a zero at an end has the sign of the inside: it is no crossing. */
    const double a0 = first * a[0] > 0 ? a[0] : 0, a2 = first * a[2] < 0 ? a[2] : 0;
    const double scale = fmax(fabs(a[1]), fmax(fabs(a0), fabs(a2))), b = a[1] / scale;
    const double root = sqrt(b * b - a0 / scale * (a2 / scale)), q = -(b < 0 ? b - root : b + root);
    const bool near_end = a0 * q > 0;
    const double s = fabs(near_end ? q : a2 / scale), t = fabs(near_end ? a0 / scale : q);
    return t / (s + t);
}

/* Regula falsi in the Illinois variant, for quadratics at once; f goes from the sign `first` to the other one. */
static double bracketed(int degree, const double *a, int first) {
    if (degree == 2) return quadratic(a, first);
    double x0 = 0, x1 = 1, f0 = first * a[0], f1 = first * a[degree];
    /* A zero at an end is given the sign of the inside; a great value there keeps the secant away from it. */
    double greatest = 0;
    for (int i = 0; i <= degree; i++) greatest = fmax(greatest, fabs(a[i]));
    if (f0 <= 0) f0 = greatest;
    if (f1 >= 0) f1 = -greatest;
    int side = 0;
    for (int step = 0; step < 100 && x1 - x0 > 1e-16; step++) {
        double x = step % 4 == 3 ? 0.5 * (x0 + x1) : x0 + (x1 - x0) * (f0 / (f0 - f1));
        if (!(x > x0 && x < x1)) x = 0.5 * (x0 + x1);
        if (!(x > x0 && x < x1)) break;
        const double f = first * value(degree, a, x);
        if (f == 0) return x;
        if (f > 0) {
            x0 = x, f0 = f;
            if (side == 1) f1 *= 0.5;
            side = 1;
        } else {
            x1 = x, f1 = f;
            if (side == -1) f0 *= 0.5;
            side = -1;
        }
    }
    return 0.5 * (x0 + x1);
}

int bat_bernstein_crossings(int degree, const double *coefficients, double zero, bat_signs *signs,
                            double *x) {
    piece stack[DEPTH + 2];
    int top = 0, found = 0;
    memcpy(stack[0].a, coefficients, (size_t)(degree + 1) * sizeof(double));
    stack[0].x0 = 0, stack[0].x1 = 1, stack[0].depth = 0;
    while (top >= 0) {
        piece *now = stack + top;
        int first = 0, final = 0, changes = 0;
        for (int i = 0; i <= degree; i++) {
            const int sign = (now->a[i] > zero) - (now->a[i] < -zero);
            if (!sign) continue;
            if (!first) first = sign;
            if (final && sign != final) changes++;
            final = sign;
        }
        if (changes > 1 && now->depth < DEPTH) {
            piece left = *now;
            halve(degree, &left, now);
            stack[++top] = left;
            continue;
        }
        top--;
        if (!first) continue;
        if (!signs->opening) signs->opening = first;
        if (signs->before == -first && found <= degree) x[found++] = now->x0;
        if (first != final && found <= degree)
            x[found++] = now->x0 + (now->x1 - now->x0) * bracketed(degree, now->a, first);
        signs->before = final;
    }
    return found;
}

void bat_bernstein_turning(int p, const double *points, double *out) {
    static const double binomial[7][7] = {{1},
                                          {1, 1},
                                          {1, 2, 1},
                                          {1, 3, 3, 1},
                                          {1, 4, 6, 4, 1},
                                          {1, 5, 10, 10, 5, 1},
                                          {1, 6, 15, 20, 15, 6, 1}};
    const double *b = points;
    double weight[BAT_BERNSTEIN_MAX] = {0};
    for (int k = 0; k <= 2 * p - 3; k++) out[k] = 0;
    for (int j = 0; j < p; j++) {
        const double dx = b[2 * j + 2] - b[2 * j], dy = b[2 * j + 3] - b[2 * j + 1];
        for (int k = 0; k + 2 <= p; k++) {
            const double ex = b[2 * k + 4] - 2 * b[2 * k + 2] + b[2 * k];
            const double ey = b[2 * k + 5] - 2 * b[2 * k + 3] + b[2 * k + 1];
            const double w = binomial[p - 1][j] * binomial[p - 2][k];
            out[j + k] += w * (dx * ey - dy * ex), weight[j + k] += w;
        }
    }
    for (int k = 0; k <= 2 * p - 3; k++) out[k] /= weight[k];
}
