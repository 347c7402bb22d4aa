/* A few functions of the kernel and the sketch hand as exports: the same vectors must come out of the native
 * library and of this module, bit for bit. */
#include "module.h"

MODULE_EXPORT(curve_create)
bat_curve *curve_create(int degree, int dimension, int closed, int count, const double *knots,
                        const double *points);
MODULE_EXPORT(curve_free) void curve_free(bat_curve *curve);
MODULE_EXPORT(curve_count) int curve_count(const bat_curve *curve);
MODULE_EXPORT(curve_knot_count) int curve_knot_count(const bat_curve *curve);
MODULE_EXPORT(curve_knots) const double *curve_knots(const bat_curve *curve);
MODULE_EXPORT(curve_points) const double *curve_points(const bat_curve *curve);
MODULE_EXPORT(curve_eval) void curve_eval(const bat_curve *curve, double u, int order, double *out);
MODULE_EXPORT(curve_nearest) double curve_nearest(const bat_curve *curve, const double *point);
MODULE_EXPORT(curve_insert_knot) bat_curve *curve_insert_knot(const bat_curve *curve, double u, int times);
MODULE_EXPORT(curve_sketch)
bat_curve *curve_sketch(const bat_curve *curve, int count, const double *points, double tolerance,
                        double pixel);

/* NULL when the data are bad. */
bat_curve *curve_create(int degree, int dimension, int closed, int count, const double *knots,
                        const double *points) {
    bat_curve *curve = NULL;
    (void)bat_curve_create(degree, dimension, closed != 0, count, knots, points, &curve);
    return curve;
}

void curve_free(bat_curve *curve) { bat_curve_free(curve); }

int curve_count(const bat_curve *curve) { return bat_curve_count(curve); }

int curve_knot_count(const bat_curve *curve) { return bat_curve_knot_count(curve); }

const double *curve_knots(const bat_curve *curve) { return bat_curve_knots(curve); }

const double *curve_points(const bat_curve *curve) { return bat_curve_points(curve); }

void curve_eval(const bat_curve *curve, double u, int order, double *out) {
    bat_curve_eval(curve, u, order, out);
}

/* The parameter of the closest point. */
double curve_nearest(const bat_curve *curve, const double *point) {
    bat_near near = {0};
    (void)bat_curve_nearest(curve, point, &near);
    return near.u;
}

bat_curve *curve_insert_knot(const bat_curve *curve, double u, int times) {
    bat_curve *out = NULL;
    (void)bat_curve_insert_knot(curve, u, times, &out);
    return out;
}

/* The curve redrawn with a stroke; NULL when the stroke is none. */
bat_curve *curve_sketch(const bat_curve *curve, int count, const double *points, double tolerance,
                        double pixel) {
    bat_sketch_options options = bat_sketch_defaults();
    options.tolerance = tolerance;
    options.pixel = pixel;
    const bat_stroke stroke = {bat_curve_dimension(curve), (size_t)count, points, NULL, NULL};
    bat_curve *out = NULL;
    (void)bat_sketch(curve, &stroke, &options, &out, NULL);
    return out;
}
