/* Draws over a curve: it follows the stroke there and stays as it was elsewhere. */
#include <math.h>
#include <stdio.h>
#include <batten/batten.h>

static double distance_at(const bat_curve *curve, double x, double y) {
    const double point[] = {x, y};
    bat_near near;
    return bat_curve_nearest(curve, point, &near) == BAT_OK ? near.distance : INFINITY;
}

int main(void) {
    /* A flat arc, 300 units long. */
    const double knots[] = {0, 0, 0, 0, 75, 150, 225, 300, 300, 300, 300};
    const double points[] = {0, 0, 25, 8, 75, 22, 150, 30, 225, 22, 275, 8, 300, 0};
    bat_curve *arc = NULL, *redrawn = NULL;
    bat_status status = bat_curve_create(2, 3, false, 7, points, 11, knots, &arc);

    /* A stroke with a bump of 10 units over its middle third. */
    enum { COUNT = 60 };
    double ink[2 * COUNT];
    for (int i = 0; i < COUNT && status == BAT_OK; i++) {
        double x = 100 + 100.0 * i / (COUNT - 1), on[2], lift = (x - 100) * (200 - x) / 250;
        bat_curve_eval(arc, x, 0, on);
        ink[2 * i] = on[0];
        ink[2 * i + 1] = on[1] + lift;
    }
    bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = ink};
    bat_sketch_options options = bat_sketch_defaults();
    bat_sketch_report report;
    if (status == BAT_OK) status = bat_sketch(arc, &stroke, &options, &redrawn, &report);
    if (status != BAT_OK) {
        fprintf(stderr, "%s\n", bat_status_message(status));
        bat_curve_free(arc);
        return 1;
    }

    double crest = distance_at(redrawn, ink[COUNT], ink[COUNT + 1]);
    double end = distance_at(redrawn, 0, 0);
    printf("%d knots, then %d; at the stroke's middle %.3f away, at the curve's start %.1e\n",
           report.knots_before, report.knots_after, crest, end);
    bat_curve_free(arc);
    bat_curve_free(redrawn);
    return crest <= options.pixel && end <= 1e-9 ? 0 : 1;
}
