/*
 * How finely spans are divided. A cell of x by y of a span, as two triangles, is no farther from the surface than
 * (a x^2 + b x y + c y^2) / 8, where a, b, c bound |S_uu|, 2 |S_uv|, |S_vv| over the span (Filip, Magedson and Markot
 * 1986). The bounds are the greatest control points of these derivatives.
 */
#include "form/surface/steps.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = BAT_DEGREE_MAX + 1 };

static int spans_of(const bat_curve *axis, int *out) {
    int count = 0;
    for (int i = axis->degree; i < axis->spread; i++)
        if (axis->knots[i] < axis->knots[i + 1]) {
            if (out) out[count] = i;
            count++;
        }
    return count;
}

/* The control points of the derivative in a direction, in place: `rows` of `columns` points, a point less that way. The
 * span counts as [0, 1]; the knots of a difference lie on both sides of it, so the factors are at most p. */
static void differentiate(const double *t, int degree, int along, int rows, int columns,
                          double net[MOST][MOST][3]) {
    const double width = t[1] - t[0];
    for (int i = 0; i < rows - (along == 0); i++)
        for (int j = 0; j < columns - (along == 1); j++) {
            const int k = along == 0 ? i : j;
            const double scale = degree * (width / (t[k + 1] - t[k + 1 - degree]));
            const double *next = along == 0 ? net[i + 1][j] : net[i][j + 1];
            for (int c = 0; c < 3; c++) net[i][j][c] = (next[c] - net[i][j][c]) * scale;
        }
}

static double greatest(int rows, int columns, double net[MOST][MOST][3]) {
    double most = 0;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) most = fmax(most, vec_norm(vec_load(net[i][j], 3)));
    return most;
}

static void load(const bat_surface *surface, const int span[2], double net[MOST][MOST][3]) {
    const int p = surface->axis[0].degree, q = surface->axis[1].degree;
    for (int i = 0; i <= p; i++) {
        const bat_curve row = bat_surface_stored_row(surface, span[0] - p + i);
        memcpy(net[i], row.points + (size_t)(span[1] - q) * 3, (size_t)(q + 1) * 3 * sizeof(double));
    }
}

static void bends_of(const bat_surface *surface, const int span[2], double out[3]) {
    const int p = surface->axis[0].degree, q = surface->axis[1].degree;
    const double *s = surface->axis[0].knots + span[0], *t = surface->axis[1].knots + span[1];
    double net[MOST][MOST][3];
    load(surface, span, net);
    differentiate(s, p, 0, p + 1, q + 1, net);
    double first[MOST][MOST][3];
    memcpy(first, net, sizeof first);
    out[0] = 0;
    if (p > 1) {
        differentiate(s, p - 1, 0, p, q + 1, net);
        out[0] = greatest(p - 1, q + 1, net);
    }
    differentiate(t, q, 1, p, q + 1, first);
    out[1] = 2 * greatest(p, q, first);
    out[2] = 0;
    if (q > 1) {
        load(surface, span, net);
        differentiate(t, q, 1, p + 1, q + 1, net);
        differentiate(t, q - 1, 1, p + 1, q, net);
        out[2] = greatest(p + 1, q - 1, net);
    }
}

bat_status bat_steps_create(const bat_surface *surface, bat_steps *out) {
    bat_steps steps = {.bend = NULL};
    for (int d = 0; d < 2; d++) steps.spans[d] = spans_of(&surface->axis[d], NULL);
    const size_t m = (size_t)steps.spans[0], n = (size_t)steps.spans[1];
    if (m == 0 || n == 0) return BAT_KNOTS; /* no valid surface */
    int *numbers = malloc(2 * (m + n) * sizeof *numbers);
    steps.bend = numbers ? malloc(3 * m * n * sizeof *steps.bend) : NULL;
    if (!steps.bend) {
        free(numbers);
        return BAT_MEMORY;
    }
    steps.span[0] = numbers, steps.span[1] = numbers + m;
    steps.count[0] = steps.span[1] + n, steps.count[1] = steps.count[0] + m;
    for (int d = 0; d < 2; d++) {
        spans_of(&surface->axis[d], steps.span[d]);
        for (int k = 0; k < steps.spans[d]; k++) steps.count[d][k] = 1;
    }
    for (size_t k = 0; k < m * n; k++)
        bends_of(surface, (const int[2]){steps.span[0][k / n], steps.span[1][k % n]}, steps.bend + 3 * k);
    *out = steps;
    return BAT_OK;
}

void bat_steps_clear(bat_steps *steps) {
    free(steps->span[0]);
    free(steps->bend);
    *steps = (bat_steps){.bend = NULL};
}

/* The least n with a / n^2 + b / n <= rest. */
static int least_count(double a, double b, double rest) {
    if (!(rest > 0)) return BAT_STEPS_MAX;
    const double n = (b + sqrt(b * b + 4 * a * rest)) / (2 * rest);
    if (!(n < BAT_STEPS_MAX)) return BAT_STEPS_MAX;
    return n > 1 ? (int)ceil(n - 1e-9) : 1;
}

/* The counts of a direction with the other direction's steps as they are; each cell has `share` of the bound, less what
 * the other direction uses of it. */
static void settle(bat_steps *steps, int d, double room, bool alone) {
    for (int i = 0; i < steps->spans[d]; i++) {
        int most = 1;
        for (int j = 0; j < steps->spans[1 - d]; j++) {
            const int pair[2] = {d == 0 ? i : j, d == 0 ? j : i};
            const double *bend = steps->bend +
                                 3 * ((size_t)pair[0] * (size_t)steps->spans[1] + (size_t)pair[1]);
            const double y = 1.0 / steps->count[1 - d][j];
            const double rest = alone ? room : room - bend[d == 0 ? 2 : 0] * y * y;
            const int need = least_count(bend[d == 0 ? 0 : 2], alone ? 0 : bend[1] * y, rest);
            if (need > most) most = need;
        }
        steps->count[d][i] = most;
    }
}

/* First each direction gets half of the bound, without the mixed derivative; then the counts of u make up for what v
 * leaves, and those of v for what u leaves. */
void bat_steps_to_chord(bat_steps *steps, double tolerance) {
    const double room = 8 * tolerance;
    settle(steps, 1, room / 2, true);
    settle(steps, 0, room, false);
    settle(steps, 1, room, false);
}

double bat_steps_chord(const bat_steps *steps) {
    double most = 0;
    const double *bend = steps->bend;
    for (int i = 0; i < steps->spans[0]; i++)
        for (int j = 0; j < steps->spans[1]; j++, bend += 3) {
            const double x = 1.0 / steps->count[0][i], y = 1.0 / steps->count[1][j];
            most = fmax(most, bend[0] * x * x + bend[1] * x * y + bend[2] * y * y);
        }
    return most / 8;
}

double bat_steps_triangles(const bat_steps *steps) {
    double total[2] = {0, 0};
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < steps->spans[d]; k++) total[d] += steps->count[d][k];
    return 2 * total[0] * total[1];
}
