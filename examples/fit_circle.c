/* Fits a closed curve to points on a circle: a few control points hold it within a hundredth of a unit. */
#include <math.h>
#include <stdio.h>
#include <batten/batten.h>

int main(void) {
    enum { COUNT = 200 };
    const double radius = 100, turn = 6.28318530717958648;
    double points[2 * COUNT];
    for (int i = 0; i < COUNT; i++) {
        points[2 * i] = radius * cos(turn * i / COUNT);
        points[2 * i + 1] = radius * sin(turn * i / COUNT);
    }

    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 0.01;
    options.closed = true;
    bat_curve *circle = NULL;
    bat_fit_report report;
    bat_status status = bat_fit(2, COUNT, points, &options, &circle, &report);
    if (status != BAT_OK) {
        fprintf(stderr, "%s\n", bat_status_message(status));
        return 1;
    }

    double domain[2], worst = 0;
    bat_curve_domain(circle, domain);
    for (int i = 0; i <= 1000; i++) {
        double p[2];
        bat_curve_eval(circle, domain[0] + (domain[1] - domain[0]) * i / 1000, 0, p);
        worst = fmax(worst, fabs(hypot(p[0], p[1]) - radius));
    }
    size_t count = bat_curve_count(circle);
    printf("%zu control points, radius off by %.4f at most\n", count, worst);
    bat_curve_free(circle);
    return worst <= 0.02 && count < 40 ? 0 : 1;
}
