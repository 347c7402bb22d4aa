#include "editor/edit/fair.h"

#include <batten/measure.h>

#include <math.h>

enum { SAMPLES = 240 };

void bat_fair_range(const bat_curve *curve, double u, double reach, double range[2]) {
    double domain[2];
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0];
    bool closed = bat_curve_is_closed(curve);
    if (closed && bat_curve_length(curve, domain[0], domain[1], 1e-3) <= 2 * reach) {
        range[0] = u - period / 2;
        range[1] = u + period / 2;
        return;
    }
    range[0] = bat_curve_at_length(curve, u, -reach, 1e-4);
    range[1] = bat_curve_at_length(curve, u, reach, 1e-4);
}

bat_status bat_fair_curve(const bat_curve *curve, const double range[2], double limit, double pixel,
                          bat_curve **out) {
    const int dimension = bat_curve_dimension(curve);
    double points[BAT_DIMENSION_MAX * SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        bat_curve_eval(curve, range[0] + (range[1] - range[0]) * i / (SAMPLES - 1), 0,
                       points + dimension * i);
    bat_stroke stroke = {.dimension = dimension, .count = SAMPLES, .points = points};
    bat_sketch_options options = bat_sketch_defaults();
    bat_sketch_report report;
    options.pixel = pixel;
    options.tolerance = fmin(limit, pixel);
    options.smooth_limit = limit;
    const bat_status status = bat_sketch_smooth(curve, &stroke, &options, out, &report);
    return status == BAT_TOLERANCE ? BAT_OK : status;
}
