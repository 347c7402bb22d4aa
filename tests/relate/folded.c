/* Regions whose sides fold back on handles of no length or along lines, run there and back, or over each other, in whole or in
 * part, beside the winding numbers of points. Usage: folded FROM TO [SCALE [FAR]]: so many times as large, moved away by FAR times
 * their size. Ends with 1 where one was refused, but for BAT_TOLERANCE far away, or where a point is on the wrong side. */
#include <batten/batten.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CUBICS_MAX = 40, STEPS = 200, POINTS = 40 };

static const double SIZE = 100,
                    LINES = 2e-3; /* LINES: how far STEPS lines are from a cubic here, at most, of a unit */
static uint64_t state;

static double chance(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) / 9007199254740992.0;
}
static int any_of(int n) { return (int)(chance() * n); }

typedef struct chain {
    int count;
    double b[8 * CUBICS_MAX];
} chain;

/* Handles: as a line's; anywhere on its line, even beyond its ends; anywhere; and of no length at one end or both. */
static void add(chain *to, const double *p, const double *q, int handles) {
    if (p[0] == q[0] && p[1] == q[1]) return;
    double *b = to->b + 8 * to->count++;
    const double from = handles == 1 ? 3 * chance() - 1 : 1.0 / 3,
                 until = handles == 1 ? 3 * chance() - 1 : 2.0 / 3;
    for (int c = 0; c < 2; c++) {
        b[c] = p[c], b[6 + c] = q[c];
        b[2 + c] = handles >= 2 ? SIZE * chance() : p[c] + (q[c] - p[c]) * from;
        b[4 + c] = handles >= 2 ? SIZE * chance() : p[c] + (q[c] - p[c]) * until;
    }
    if (handles == 2 || handles == 4) memcpy(b + 2, b, 2 * sizeof *b);
    if (handles == 3 || handles == 4) memcpy(b + 4, b + 6, 2 * sizeof *b);
}

static void draw(chain *out) {
    const int n = 2 + any_of(4), style = any_of(4), curved = any_of(3);
    const bool gridded = any_of(3) == 0;
    double at[16][2];
    int m = 0;
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < 2; c++) at[m][c] = gridded ? 25.0 * any_of(4) : SIZE * chance();
        m++;
        if (style != 1 || m < 2 || any_of(2))
            continue; /* back along the line, not so far, as far, or further */
        const double back = any_of(3) == 0 ? 1 : 2 * chance();
        for (int c = 0; c < 2; c++) at[m][c] = at[m - 1][c] + (at[m - 2][c] - at[m - 1][c]) * back;
        m++;
    }
    for (int i = m - 2; i > 0 && style == 2; i--) memcpy(at[m++], at[i], sizeof at[i]); /* there and back */
    out->count = 0;
    for (int i = 0; i < m; i++) {
        const int before = out->count;
        add(out, at[i], at[(i + 1) % m], curved ? any_of(5) : 0);
        if (style != 3 || out->count == before || any_of(2)) continue; /* back and there once more */
        double *b = out->b + 8 * before;
        for (int k = 0; k < 4; k++) memcpy(b + 8 + 2 * k, b + 6 - 2 * k, 2 * sizeof *b);
        memcpy(b + 16, b, 8 * sizeof *b);
        out->count += 2;
    }
}

static void place(chain *all, double scale, double far) {
    for (int i = 0; i < 8 * all->count; i++)
        all->b[i] = all->b[i] * scale + (i % 2 ? 0.7 : 1) * far * SIZE * scale;
}

static bat_curve *curve_of(const chain *from) {
    double points[6 * CUBICS_MAX + 2];
    bat_curve *made = NULL;
    memcpy(points, from->b, 2 * sizeof *points);
    for (int i = 0; i < from->count; i++) memcpy(points + 2 + 6 * i, from->b + 8 * i + 2, 6 * sizeof *points);
    if (from->count > 0) (void)bat_curve_from_bezier(2, 3, true, from->count, points, 0.05, 0, &made, NULL);
    return made;
}

/* Adds how often cubics go round a point; *near: not less than its distance from them. */
static int winding_of(const double *b, int count, const double *x, double *near) {
    int sum = 0;
    for (int i = 0; i < count; i++, b += 8) {
        double p[2] = {b[0], b[1]}, q[2];
        for (int k = 1; k <= STEPS; k++) {
            const double t = (double)k / STEPS, u = 1 - t;
            for (int c = 0; c < 2; c++)
                q[c] = k == STEPS ? b[6 + c]
                                  : u * u * u * b[c] + 3 * u * u * t * b[2 + c] + 3 * u * t * t * b[4 + c] +
                                        t * t * t * b[6 + c];
            const double d[2] = {q[0] - p[0], q[1] - p[1]}, w[2] = {x[0] - p[0], x[1] - p[1]};
            const double length = d[0] * d[0] + d[1] * d[1];
            const double s = length > 0 ? fmin(fmax((w[0] * d[0] + w[1] * d[1]) / length, 0), 1) : 0;
            *near = fmin(*near, hypot(w[0] - s * d[0], w[1] - s * d[1]));
            const double side = d[0] * w[1] - d[1] * w[0]; /* above 0: left of it */
            if (p[1] <= x[1] && q[1] > x[1]) sum += side > 0;
            if (p[1] > x[1] && q[1] <= x[1]) sum -= side < 0;
            memcpy(p, q, sizeof p);
        }
    }
    return sum;
}

static bool holds(bat_region_operation operation, int regions, bool first, bool second) {
    const int in = first + (regions > 1 && second);
    switch (operation) {
    case BAT_REGION_UNION: return in > 0;
    case BAT_REGION_DIFFERENCE: return first && in == 1;
    case BAT_REGION_INTERSECTION: return in == regions;
    default: return in % 2 == 1;
    }
}

/* How many points are on the wrong side. */
static int wrong_of(const chain *from, int regions, bool even_odd, bat_region_operation operation,
                    size_t count, bat_curve *const *curves, double tolerance, double scale, int *asked) {
    int wrong = 0, n[CUBICS_MAX * 8];
    double *made[CUBICS_MAX * 8], low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (count > CUBICS_MAX * 8) return 1;
    for (size_t i = 0; i < count; i++)
        (void)bat_curve_to_cubics(curves[i], 0.01 * tolerance, &n[i], &made[i]);
    for (int r = 0; r < regions; r++)
        for (int i = 0; i < 8 * from[r].count; i++) {
            low[i % 2] = fmin(low[i % 2], from[r].b[i]);
            high[i % 2] = fmax(high[i % 2], from[r].b[i]);
        }
    for (int k = 0; k < POINTS; k++) {
        double x[2], near = INFINITY, beside = INFINITY;
        for (int c = 0; c < 2; c++) x[c] = low[c] + (high[c] - low[c]) * chance();
        const int first = winding_of(from[0].b, from[0].count, x, &near),
                  second = regions > 1 ? winding_of(from[1].b, from[1].count, x, &near) : 0;
        if (near <= 2 * tolerance + LINES * scale) continue;
        int winding = 0;
        for (size_t i = 0; i < count; i++) winding += winding_of(made[i], n[i], x, &beside);
        ++*asked;
        wrong += winding != holds(operation, regions, even_odd ? first % 2 != 0 : first != 0, second != 0);
    }
    for (size_t i = 0; i < count; i++) bat_free(made[i]);
    return wrong;
}

int main(int argc, char **argv) {
    const int from = argc > 1 ? atoi(argv[1]) : 0, to = argc > 2 ? atoi(argv[2]) : 100;
    const double scale = argc > 3 ? atof(argv[3]) : 1, far = argc > 4 ? atof(argv[4]) : 0;
    int refused = 0, wrong = 0, asked = 0, rounding = 0, all = 0;
    for (int i = from; i < to; i++) {
        state = (uint64_t)i * 7919 + 13;
        (void)chance();
        chain chains[2] = {{0}};
        const int regions = 1 + any_of(2);
        const bool even_odd = any_of(3) == 0;
        const bat_region_operation operation = regions > 1 ? (bat_region_operation)any_of(4)
                                                           : BAT_REGION_UNION;
        const double tolerance = scale * 1e-3 * pow(10, -any_of(3));
        bat_curve *curves[2] = {NULL}, **out = NULL;
        size_t count = 0;
        bool whole = true;
        for (int r = 0; r < regions; r++) {
            draw(&chains[r]), place(&chains[r], scale, far);
            curves[r] = curve_of(&chains[r]);
            whole = whole && curves[r];
        }
        const bat_region both[2] = {{1, (const bat_curve *const *)&curves[0], even_odd},
                                    {1, (const bat_curve *const *)&curves[1], false}};
        const bat_status status = whole ? bat_regions_combine(operation, (size_t)regions, both, tolerance,
                                                              &count, &out)
                                        : BAT_STATE;
        const bool lost = status == BAT_TOLERANCE && far > 0;
        all += whole, rounding += lost;
        if (whole && status != BAT_OK && !lost) refused++, printf("%d: %s\n", i, bat_status_message(status));
        if (status == BAT_OK) {
            const int off = wrong_of(chains, regions, even_odd, operation, count, out, tolerance, scale,
                                     &asked);
            if (off) wrong++, printf("%d: %d points on the wrong side\n", i, off);
            bat_curves_free(count, out);
        }
        bat_curve_free(curves[0]), bat_curve_free(curves[1]);
    }
    printf("%d regions: %d refused, %d wrong at %d points, %d hidden by rounding\n", all, refused, wrong,
           asked, rounding);
    return refused || wrong;
}
