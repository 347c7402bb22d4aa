/* Prints strokes and their outlines, a line of JSON each: a test's arm (strokes.mjs). Polylines and cubics, some with handles of
 * no length, folds, and ends that meet, widths up to their size, all caps and joins. Usage: strokes FROM TO [SCALE [FAR]]: the
 * outlines are made of curves so many times as large, moved away by FAR times their size, and printed as if they were not. */
#include <batten/batten.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { SPANS_MAX = 8 };

static const double SIZE = 100, TOLERANCE = 0.02, CORNER = 0.02;
static uint64_t state;

static double chance(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) / 9007199254740992.0;
}
static int any_of(int n) { return (int)(chance() * n); }

/* Cubics one after another; returns how many. */
static int draw(double points[2 * (3 * SPANS_MAX + 1)], bool *closed) {
    const int kind = any_of(4), n = kind == 0 ? 1 : 2 + any_of(SPANS_MAX - 2);
    double at[SPANS_MAX + 1][2];
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 2; c++) at[i][c] = SIZE * (kind == 3 ? any_of(5) / 4.0 : chance());
    *closed = kind > 0 && any_of(3) == 0;
    for (int c = 0; c < 2 && *closed; c++) at[n][c] = at[0][c];
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 2; c++) {
                const double straight = k == 3 ? at[i + 1][c] : at[i][c] + (at[i + 1][c] - at[i][c]) * k / 3;
                points[6 * i + 2 * k + c] = kind < 2 && k % 3 ? SIZE * chance() : straight;
            }
    for (int i = 0; i < n && kind < 2; i++) {
        double *p = points + 6 * i;
        const int folded = any_of(8);
        for (int c = 0; c < 2; c++) {
            if (folded == 0 || folded == 2) p[2 + c] = p[c];
            if (folded == 1 || folded == 2) p[4 + c] = p[6 + c];
        }
    }
    return n;
}

static void print_curves(const char *name, size_t count, bat_curve *const *curves, double scale,
                         const double *far) {
    printf(",\"%s\":\"", name);
    for (size_t i = 0; i < count; i++) {
        int cubics = 0;
        double *b = NULL;
        (void)bat_curve_to_cubics(curves[i], 1e-3 * TOLERANCE * scale, &cubics, &b);
        for (int k = 0; k < cubics; k++) {
            double p[8];
            for (int j = 0; j < 8; j++) p[j] = (b[8 * k + j] - far[j % 2]) / scale;
            if (k == 0) printf("M%.6f %.6f", p[0], p[1]);
            printf("C%.6f %.6f %.6f %.6f %.6f %.6f", p[2], p[3], p[4], p[5], p[6], p[7]);
        }
        if (bat_curve_is_closed(curves[i])) printf("Z");
        bat_free(b);
    }
    printf("\"");
}

int main(int argc, char **argv) {
    const int from = argc > 1 ? atoi(argv[1]) : 0, to = argc > 2 ? atoi(argv[2]) : 100;
    const double scale = argc > 3 ? atof(argv[3]) : 1, away = argc > 4 ? atof(argv[4]) : 0;
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    static const bat_cap cap_of[] = {BAT_CAP_BUTT, BAT_CAP_ROUND, BAT_CAP_SQUARE};
    static const bat_join join_of[] = {BAT_JOIN_MITER, BAT_JOIN_ROUND, BAT_JOIN_BEVEL};
    for (int i = from; i < to; i++) {
        state = (uint64_t)i * 7919 + 17;
        (void)chance();
        double points[2 * (3 * SPANS_MAX + 1)];
        bool closed;
        const int n = draw(points, &closed), cap = any_of(3), join = any_of(3);
        const double width = SIZE * pow(10, -2 * chance()),
                     far[2] = {away * SIZE * scale, -0.7 * away * SIZE * scale};
        for (int k = 0; k < 2 * (3 * n + 1); k++) points[k] = points[k] * scale + far[k % 2];
        bat_curve *curve = NULL, **out = NULL;
        size_t count = 0;
        if (bat_curve_from_bezier(2, 3, closed, n, points, CORNER, 0, &curve, NULL) != BAT_OK) continue;
        const bat_nib nib = {width * scale, cap_of[cap], join_of[join], 4};
        const bat_status status = bat_curve_outline(curve, &nib, TOLERANCE * scale, CORNER, &count, &out,
                                                    NULL);
        printf("{\"index\":%d,\"status\":%d,\"width\":%.9g,\"cap\":\"%s\",\"join\":\"%s\"", i, (int)status,
               width, caps[cap], joins[join]);
        print_curves("stroke", 1, &curve, scale, far);
        print_curves("outline", count, out, scale, far);
        printf("}\n");
        bat_curves_free(count, out), bat_curve_free(curve);
    }
    return 0;
}
