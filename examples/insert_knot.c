/* Inserts a knot: one more control point to pull at, and the shape stays as it was. */
#include <math.h>
#include <stdio.h>
#include <batten/batten.h>

int main(void) {
    const double knots[] = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    const double points[] = {0, 0, 20, 60, 60, 80, 110, 70, 130, 10};
    bat_curve *curve = NULL, *finer = NULL;
    bat_status status = bat_curve_create(2, 3, false, 5, points, 9, knots, &curve);
    if (status == BAT_OK) status = bat_curve_insert_knot(curve, 1.5, 1, &finer);
    if (status != BAT_OK) {
        fprintf(stderr, "%s\n", bat_status_message(status));
        bat_curve_free(curve);
        return 1;
    }

    double worst = 0;
    for (int i = 0; i <= 100; i++) {
        double before[2], after[2];
        bat_curve_eval(curve, i / 50.0, 0, before);
        bat_curve_eval(finer, i / 50.0, 0, after);
        worst = fmax(worst, hypot(after[0] - before[0], after[1] - before[1]));
    }
    printf("%zu control points, then %zu; the shape moved by %.1e\n", bat_curve_count(curve),
           bat_curve_count(finer), worst);
    int right = bat_curve_count(finer) == 6 && worst <= 1e-12 * bat_curve_size(curve);
    bat_curve_free(curve);
    bat_curve_free(finer);
    return right ? 0 : 1;
}
