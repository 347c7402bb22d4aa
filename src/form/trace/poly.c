/* Polynomials in two variables in Bernstein form: products, halving, roots along a line. */
#include "form/trace/poly.h"

#include <math.h>
#include <string.h>

static double binomial(int n, int k) {
    double value = 1;
    for (int i = 1; i <= k; i++) value = value * (n - k + i) / i; /* exact at every step */
    return value;
}

static void binomials(int n, double out[BAT_POLY_SIDE]) {
    for (int k = 0; k <= n; k++) out[k] = binomial(n, k);
}

void bat_poly_of_net(const double *net, const int degree[2], int coordinate, bat_poly *out) {
    out->degree[0] = degree[0], out->degree[1] = degree[1];
    for (int i = 0; i < (degree[0] + 1) * (degree[1] + 1); i++) out->c[i] = net[3 * i + coordinate];
}

void bat_poly_derivative(const bat_poly *a, int direction, bat_poly *out) {
    const int m = a->degree[0], n = a->degree[1], step = direction == 0 ? n + 1 : 1;
    const int rows = m + (direction == 1), columns = n + (direction == 0);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const double *c = a->c + i * (n + 1) + j;
            out->c[i * columns + j] = a->degree[direction] * (c[step] - c[0]);
        }
    out->degree[0] = rows - 1, out->degree[1] = columns - 1;
}

void bat_poly_add_product(const bat_poly *a, const bat_poly *b, double factor, bat_poly *sum) {
    const int p = a->degree[0], q = a->degree[1], r = b->degree[0], s = b->degree[1], m = p + r, n = q + s;
    double up[BAT_POLY_SIDE], uq[BAT_POLY_SIDE], ur[BAT_POLY_SIDE], us[BAT_POLY_SIDE], um[BAT_POLY_SIDE],
        un[BAT_POLY_SIDE], product[BAT_POLY_SIDE * BAT_POLY_SIDE] = {0};
    binomials(p, up), binomials(q, uq), binomials(r, ur), binomials(s, us), binomials(m, um),
        binomials(n, un);
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= q; j++) {
            const double x = a->c[i * (q + 1) + j] * up[i] * uq[j];
            for (int k = 0; k <= r; k++) {
                double *to = product + (i + k) * (n + 1) + j;
                const double *from = b->c + k * (s + 1);
                for (int l = 0; l <= s; l++) to[l] += x * ur[k] * (us[l] * from[l]);
            }
        }
    const bool empty = sum->degree[0] < 0;
    sum->degree[0] = m, sum->degree[1] = n;
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++) {
            const int at = i * (n + 1) + j;
            sum->c[at] = (empty ? 0 : sum->c[at]) + factor * (product[at] / (um[i] * un[j]));
        }
}

void bat_poly_normal(const double *net, const int degree[2], int coordinate, bat_poly *out) {
    bat_poly one, u[2], v[2];
    for (int k = 0; k < 2; k++) {
        bat_poly_of_net(net, degree, (coordinate + 1 + k) % 3, &one);
        bat_poly_derivative(&one, 0, &u[k]);
        bat_poly_derivative(&one, 1, &v[k]);
    }
    out->degree[0] = -1;
    bat_poly_add_product(&u[0], &v[1], 1, out);
    bat_poly_add_product(&u[1], &v[0], -1, out);
}

void bat_poly_divide(bat_poly *a, int direction, bool end) {
    const int m = a->degree[0], n = a->degree[1], d = a->degree[direction];
    const int rows = m + (direction == 1), columns = n + (direction == 0);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const int k = direction == 0 ? i : j; /* of the quotient, of degree d - 1 */
            const int from = end ? k : k + 1;
            const int at = direction == 0 ? from * (n + 1) + j : i * (n + 1) + from;
            a->c[i * columns + j] = a->c[at] * d / (end ? d - k : k + 1);
        }
    a->degree[direction] = d - 1;
}

void bat_poly_halve(bat_poly *a, int direction, bat_poly *upper) {
    const int m = a->degree[0], n = a->degree[1], d = a->degree[direction];
    const int step = direction == 0 ? n + 1 : 1, lines = direction == 0 ? n + 1 : m + 1;
    upper->degree[0] = m, upper->degree[1] = n;
    for (int k = 0; k < lines; k++) {
        const int first = direction == 0 ? k : k * (n + 1);
        double *low = a->c + first, *high = upper->c + first;
        high[d * step] = low[d * step];
        for (int r = 1; r <= d; r++) {
            for (int i = d; i >= r; i--) low[i * step] = 0.5 * (low[(i - 1) * step] + low[i * step]);
            high[(d - r) * step] = low[d * step];
        }
    }
}

double bat_poly_most(const bat_poly *a) {
    double most = 0;
    for (int i = 0; i < (a->degree[0] + 1) * (a->degree[1] + 1); i++) most = fmax(most, fabs(a->c[i]));
    return most;
}

/* De Casteljau's algorithm; slope may be NULL. */
double bat_line_value(const double *line, int degree, double x, double *slope) {
    double b[BAT_POLY_SIDE];
    memcpy(b, line, (size_t)(degree + 1) * sizeof(double));
    if (slope) *slope = 0;
    for (int r = degree; r > 0; r--) {
        if (r == 1 && slope) *slope = degree * (b[1] - b[0]);
        for (int i = 0; i < r; i++) b[i] = (1 - x) * b[i] + x * b[i + 1];
    }
    return b[0];
}

void bat_poly_line(const bat_poly *a, int direction, double at, double line[BAT_POLY_SIDE]) {
    const int m = a->degree[0], n = a->degree[1];
    double across[BAT_POLY_SIDE];
    for (int k = 0; k <= a->degree[direction]; k++) {
        for (int i = 0; i <= a->degree[1 - direction]; i++)
            across[i] = direction == 0 ? a->c[k * (n + 1) + i] : a->c[i * (n + 1) + k];
        line[k] = bat_line_value(across, direction == 0 ? n : m, at, NULL);
    }
}

/* Whether the sign changes within 1e-9 of x. */
static bool changes_at(const double *line, int degree, double tiny, double x) {
    const double a = bat_line_value(line, degree, fmax(0, x - 1e-9), NULL);
    const double b = bat_line_value(line, degree, fmin(1, x + 1e-9), NULL);
    return (a >= -tiny) != (b >= -tiny);
}

double bat_line_root(const double *line, int degree, double tiny) {
    const bool first = line[0] >= -tiny;
    double low = 0, high = 1, x = 0.5;
    const double ends = line[0] - line[degree];
    if (ends != 0 && fabs(ends) < INFINITY) x = fmin(fmax(line[0] / ends, 0), 1);
    for (int i = 0; i < 80 && high - low > 1e-15; i++) {
        double slope;
        const double value = bat_line_value(line, degree, x, &slope);
        if ((value >= -tiny) == first)
            low = x;
        else
            high = x;
        const double next = x - value / slope;
        const bool settled = fabs(next - x) <= 1e-16;
        /* a value near zero with no change of sign is not the root */
        if (settled && changes_at(line, degree, tiny, x)) break;
        x = !settled && next > low && next < high && i % 8 < 6 ? next : 0.5 * (low + high);
    }
    return x;
}
