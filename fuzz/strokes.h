/* Bytes become curves, a stroke and options of the sketch hand. They are small: a fit of many samples takes so long
 * under the sanitizers that too few inputs are tried. */
#ifndef BATTEN_FUZZ_STROKES_H
#define BATTEN_FUZZ_STROKES_H

#include "bytes.h"
#include "curve/curve.h"
#include <batten/sketch.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { SAMPLES = 12, POINTS = 8 };

typedef struct scene {
    bool wild; /* with numbers beyond the range of a drawing */
    bat_curve *a, *b;
    double points[SAMPLES * 3];
    bat_stroke stroke;
    bat_sketch_options options;
} scene;

/* Mostly tame numbers in the range of a drawing; wild: occasionally any eight bytes. */
static inline double number(bytes *in, bool wild) {
    const int kind = small(in, 255);
    if (!wild || kind < 250) return kind - 125 + small(in, 15) / 16.0;
    return any_number(in);
}

static inline bat_curve *read_curve(bytes *in, int dimension, bool wild) {
    double knots[2 * POINTS + 16], points[(POINTS + 8) * 3], t = 0;
    const int degree = 1 + small(in, 6), n = degree + 1 + small(in, POINTS);
    const bool closed = small(in, 1);
    const int count = closed ? n + 1 : n + degree + 1;
    for (int i = 0; i < count; i++) {
        knots[i] = t;
        const bool end = !closed && (i < degree || i >= n);
        if (!end) t += small(in, 7) == 0 ? 0 : 1 + small(in, 3);
    }
    for (int i = 0; i < n * dimension; i++) points[i] = number(in, wild);
    bat_curve *curve = NULL;
    (void)bat_curve_create(dimension, degree, closed, (size_t)n, points, closed ? n + 1 : n + degree + 1,
                           knots, &curve);
    return curve;
}

/* Along curve a, so that not all calls end in BAT_FAR, or anywhere. */
static inline void read_stroke(bytes *in, scene *s, int dimension) {
    double x[3] = {0};
    const size_t count = (size_t)small(in, SAMPLES);
    const bool along = small(in, 1) && s->a;
    for (size_t i = 0; i < count; i++) {
        if (along) {
            double domain[2];
            bat_curve_domain(s->a, domain);
            bat_curve_eval(
                s->a, domain[0] + (domain[1] - domain[0]) * (0.2 + 0.6 * (double)i / (double)count), 0, x);
        }
        for (int c = 0; c < dimension; c++) {
            double *p = &s->points[i * (size_t)dimension + (size_t)c];
            if (along)
                *p = x[c] + (small(in, 255) - 128) / 32.0;
            else if (s->wild && small(in, 255) >= 250)
                *p = any_number(in);
            else
                *p = x[c] += small(in, 20) - 9;
        }
    }
    s->stroke = (bat_stroke){.dimension = dimension, .count = count, .points = s->points};
}

static inline void scene_read(bytes *in, bool wild, scene *s) {
    static const double tolerances[] = {0, 0.2, 0.5, 3, 30}, widths[] = {3, 0, 1, 10};
    *s = (scene){.wild = wild, .options = bat_sketch_defaults()};
    const int dimension = 2 + (small(in, 3) == 0);
    s->options.pins = 2 + small(in, 1);
    s->options.keep_corners = small(in, 1);
    s->options.tolerance = tolerances[small(in, 4)];
    s->options.width = widths[small(in, 3)];
    if (wild) s->options.pixel = fabs(number(in, true));
    s->a = read_curve(in, dimension, wild);
    s->b = read_curve(in, dimension, wild);
    read_stroke(in, s, dimension);
}

static inline void scene_free(scene *s) {
    bat_curve_free(s->a);
    bat_curve_free(s->b);
}

/* A result is there exactly when the status says so, and it is a valid curve. */
static inline void check_made(bat_status status, const bat_curve *curve) {
    if ((status == BAT_OK || status == BAT_TOLERANCE) != (curve != NULL)) abort();
    if (!curve) return;
    bat_curve *again = NULL;
    if (bat_curve_create(bat_curve_dimension(curve), bat_curve_degree(curve), bat_curve_is_closed(curve),
                         bat_curve_count(curve), bat_curve_points(curve), bat_curve_knot_count(curve),
                         bat_curve_knots(curve), &again) != BAT_OK)
        abort();
    if (!bat_curve_is_equal(curve, again)) abort();
    bat_curve_free(again);
}

#endif
