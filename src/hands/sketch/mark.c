/* Marks: dots, periods, strokes too short for the sketch hand as they are. */
#include "hands/sketch/sketch.h"
#include "base/real.h"

#include <math.h>

/* px: what is no larger, or winds so many times about its size, is a dot; how long a dot is, and as how large a
 * stroke a mark is fitted. */
static const double dot_size = 1.5, dot_winds = 4, dot_length = 0.02, fitted_size = 60;

typedef struct extent {
    double low[BAT_DIMENSION_MAX], high[BAT_DIMENSION_MAX], first[BAT_DIMENSION_MAX], last[BAT_DIMENSION_MAX];
    double size, length;
    size_t count;
} extent;

static double distance(const double *a, const double *b, size_t m) {
    double sum = 0;
    for (size_t c = 0; c < m; c++) sum = bat_hypot(sum, a[c] - b[c]);
    return sum;
}

static void measure(const bat_stroke *stroke, extent *out) {
    const size_t m = (size_t)stroke->dimension;
    *out = (extent){0};
    for (size_t i = 0; i < stroke->count; i++) {
        const double *p = stroke->points + i * m;
        bool finite = true;
        for (size_t c = 0; c < m; c++) finite = finite && fabs(p[c]) < 1e150;
        if (!finite) continue;
        if (out->count) out->length += distance(p, out->last, m);
        for (size_t c = 0; c < m; c++) {
            if (!out->count) out->low[c] = out->high[c] = out->first[c] = p[c];
            out->low[c] = fmin(out->low[c], p[c]), out->high[c] = fmax(out->high[c], p[c]);
            out->last[c] = p[c];
        }
        out->count++;
    }
    out->size = distance(out->low, out->high, m);
}

static bat_status straight(size_t m, int degree, const double *a, const double *b, bat_curve **out) {
    double points[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    for (int i = 0; i <= degree; i++)
        for (size_t c = 0; c < m; c++) points[(size_t)i * m + c] = a[c] + (b[c] - a[c]) * i / degree;
    return bat_curve_create_clamped((int)m, degree, (size_t)degree + 1, points, out);
}

bat_status bat_sketch_mark(const bat_stroke *stroke, const bat_sketch_options *given, bat_curve **out,
                           bat_sketch_report *report) {
    bat_sketch_options o;
    extent e;
    if (!out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    const size_t m = (size_t)stroke->dimension;
    measure(stroke, &e);
    if (!e.count) return BAT_DOT;
    const bool dot = e.size <= dot_size * o.pixel || e.length > dot_winds * e.size;
    if (!dot) {
        /* As a stroke that is drawn large, for that is how much there is of it. */
        const double fine = fmin(1, e.size / (fitted_size * o.pixel));
        bat_sketch_options finer = o;
        finer.pixel *= fine, finer.tolerance *= fine;
        status = bat_sketch_new_with(stroke, &finer, NULL, NULL, out, report);
        if (status == BAT_OK || status == BAT_TOLERANCE) return BAT_OK;
        if (status == BAT_MEMORY) return status;
    }
    double from[BAT_DIMENSION_MAX], to[BAT_DIMENSION_MAX];
    for (size_t c = 0; c < m; c++) {
        const double middle = 0.5 * (e.low[c] + e.high[c]), half = c == 0 ? 0.5 * dot_length * o.pixel : 0;
        from[c] = dot ? middle - half : e.first[c], to[c] = dot ? middle + half : e.last[c];
    }
    if (report) *report = (bat_sketch_report){0};
    return straight(m, o.degree, from, to, out);
}
