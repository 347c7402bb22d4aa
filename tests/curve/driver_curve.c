/* Reads lines "degree dimension closed count knots points task ..." and answers with numbers; fitpack.py
 * compares them with FITPACK's. Tasks: eval ORDER COUNT u..., insert u, elevated DEGREE COUNT u... */
#include <batten/refine.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 4096 };

static int whole(void) {
    int x;
    if (scanf("%d", &x) != 1) exit(3);
    return x;
}

static void numbers(int count, double *x) {
    if (count > ROOM) exit(3);
    for (int i = 0; i < count; i++)
        if (scanf("%lf", &x[i]) != 1) exit(3);
}

static void print(int count, const double *x) {
    for (int i = 0; i < count; i++) printf("%.17g ", x[i]);
}

int main(void) {
    static double knots[ROOM], points[ROOM], u[ROOM], out[ROOM];
    int degree;
    while (scanf("%d", &degree) == 1) {
        int size = whole(), closed = whole(), n = whole();
        char task[16];
        numbers(closed ? n + 1 : n + degree + 1, knots);
        numbers(n * size, points);
        bat_curve *curve, *other;
        if (bat_curve_create(size, degree, closed, (size_t)n, points, closed ? n + 1 : n + degree + 1, knots,
                             &curve) != BAT_OK)
            return 4;
        if (scanf("%15s", task) != 1) return 3;
        if (strcmp(task, "insert") == 0) {
            numbers(1, u);
            if (bat_curve_insert_knot(curve, u[0], 1, &other) != BAT_OK) return 5;
            print(bat_curve_knot_count(other), bat_curve_knots(other));
            print((int)bat_curve_count(other) * size, bat_curve_points(other));
        } else {
            int order = whole(), count = whole();
            numbers(count, u);
            if (strcmp(task, "elevated") == 0) {
                if (bat_curve_elevate(curve, order, &other) != BAT_OK) return 6;
                order = 0;
            } else if (bat_curve_copy(curve, &other) != BAT_OK) {
                return 7;
            }
            if (count * (order + 1) * size > ROOM) return 3;
            if (bat_curve_eval_many(other, (size_t)count, u, order, out) != BAT_OK) return 8;
            print(count * (order + 1) * size, out);
        }
        printf("\n");
        bat_curve_free(other);
        bat_curve_free(curve);
    }
    return 0;
}
