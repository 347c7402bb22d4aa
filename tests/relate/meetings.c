/* Prints, for each pair of Bézier curves read, what bat_curve_intersect finds: a test's arm (contacts.py). A line of input is
 * degree, degree, tolerance, points of both; of output: status, count, sum of signs, kinds; then the same with the curves
 * exchanged, and at 1e-6 and 1e6 times the size. */
#include <batten/relate.h>

#include <stdio.h>

static bat_curve *read_curve(int degree, double scale, const double *points) {
    double knots[2 * (BAT_DEGREE_MAX + 1)], scaled[2 * (BAT_DEGREE_MAX + 1)];
    bat_curve *curve = NULL;
    for (int i = 0; i < 2 * degree + 2; i++) knots[i] = i > degree, scaled[i] = scale * points[i];
    return bat_curve_create(2, degree, false, (size_t)degree + 1, scaled, 2 * degree + 2, knots, &curve) ==
                   BAT_OK
               ? curve
               : NULL;
}

static void put(const bat_curve *a, const bat_curve *b, double tolerance) {
    bat_meeting met = {0};
    int sum = 0, kinds[4] = {0};
    const bat_status status = bat_curve_intersect(a, b, tolerance, &met);
    for (size_t i = 0; i < met.count; i++) sum += met.crossings[i].sign, kinds[met.crossings[i].kind]++;
    printf(" %d %zu %zu %d %d %d %d %d", (int)status, met.count, met.overlap_count, sum, kinds[0], kinds[1],
           kinds[2], kinds[3]);
    bat_meeting_free(&met);
}

int main(void) {
    int p, q;
    double tolerance, points[4 * (BAT_DEGREE_MAX + 1)];
    while (scanf("%d %d %lf", &p, &q, &tolerance) == 3 && p > 0 && p <= BAT_DEGREE_MAX && q > 0 &&
           q <= BAT_DEGREE_MAX) {
        for (int i = 0; i < 2 * (p + q + 2); i++)
            if (scanf("%lf", points + i) != 1) return 1;
        const double scales[] = {1, 1, 1e-6, 1e6};
        for (int k = 0; k < 4; k++) {
            bat_curve *a = read_curve(p, scales[k], points),
                      *b = read_curve(q, scales[k], points + 2 * (p + 1));
            if (!a || !b) return 1;
            put(k == 1 ? b : a, k == 1 ? a : b, scales[k] * tolerance);
            bat_curve_free(a), bat_curve_free(b);
        }
        printf("\n");
    }
    return 0;
}
