#include "relate/segment.h"

#include <batten/bezier.h>

#include "base/real.h"
#include "base/vec.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBERS = (BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX, AXES_MAX = 8 };

double bat_segments_reach_of(const bat_curve *curve) {
    const size_t count = bat_curve_count(curve) * (size_t)bat_curve_dimension(curve);
    const double *points = bat_curve_points(curve);
    double most = 0;
    for (size_t i = 0; i < count; i++) most = fmax(most, fabs(points[i]));
    return most;
}

double bat_segments_hidden(const bat_curve *curve) { return 64 * DBL_EPSILON * bat_segments_reach_of(curve); }

bool bat_segments_hide(const bat_curve *curve, double tolerance) {
    return bat_curve_degree(curve) > 1 && !(tolerance >= bat_segments_hidden(curve));
}

bat_status bat_segments_of(const bat_curve *curve, int *count, bat_segment **out) {
    const int p = bat_curve_degree(curve), m = bat_curve_dimension(curve), n = bat_curve_segment_count(curve);
    const size_t block = (size_t)((p + 1) * m);
    bat_segment *all = malloc((size_t)n * sizeof *all);
    double *points = malloc((size_t)n * block * sizeof *points),
           *breaks = malloc((size_t)(n + 1) * sizeof *breaks);
    bat_status status = all && points && breaks ? bat_curve_to_bezier(curve, points, breaks) : BAT_MEMORY;
    for (int i = 0; i < n && status == BAT_OK; i++) {
        all[i] = (bat_segment){.degree = p, .size = m, .from = breaks[i], .to = breaks[i + 1]};
        memcpy(all[i].b, points + (size_t)i * block, block * sizeof *points);
    }
    free(points), free(breaks);
    if (status != BAT_OK) {
        free(all);
        return status;
    }
    *count = n, *out = all;
    return BAT_OK;
}

/* De Casteljau's triangle at x; left and right may be the segment itself, or NULL. */
static void cut(const bat_segment *s, double x, bat_segment *left, bat_segment *right) {
    const int p = s->degree, m = s->size;
    double d[NUMBERS], first[NUMBERS];
    memcpy(d, s->b, sizeof d);
    for (int r = 0; r <= p; r++) {
        memcpy(first + r * m, d, (size_t)m * sizeof *d);
        if (right) memcpy(right->b + (p - r) * m, d + (p - r) * m, (size_t)m * sizeof *d);
        for (int i = 0; i < (p - r) * m; i++) d[i] += x * (d[i + m] - d[i]);
    }
    if (left) memcpy(left->b, first, (size_t)((p + 1) * m) * sizeof *d);
}

void bat_segment_halve(const bat_segment *s, bat_segment *left, bat_segment *right) {
    const double middle = 0.5 * s->from + 0.5 * s->to;
    *left = *s, *right = *s;
    cut(s, 0.5, left, right);
    left->to = right->from = middle;
}

void bat_segment_part(const bat_segment *s, double x0, double x1, bat_segment *out) {
    const double from = s->from, to = s->to;
    *out = *s;
    if (x1 < 1) cut(out, x1, out, NULL);
    if (x0 > 0 && x1 > 0) cut(out, x0 / x1, NULL, out);
    out->from = x0 > 0 ? from + x0 * (to - from) : from;
    out->to = x1 < 1 ? from + x1 * (to - from) : to;
}

void bat_segment_raise(bat_segment *s, int degree) {
    const int m = s->size;
    for (; s->degree < degree; s->degree++) {
        const int p = s->degree;
        for (int c = 0; c < m; c++) s->b[(p + 1) * m + c] = s->b[p * m + c];
        for (int i = p; i >= 1; i--)
            for (int c = 0; c < m; c++)
                s->b[i * m + c] += (s->b[(i - 1) * m + c] - s->b[i * m + c]) * (i / (p + 1.0));
    }
}

static double norm(const double *v, int m) {
    const double plane = bat_hypot(v[0], v[1]);
    return m == 3 ? bat_hypot(plane, v[2]) : plane;
}

static double between(const double *a, const double *b, int m) {
    const double d[3] = {b[0] - a[0], b[1] - a[1], m == 3 ? b[2] - a[2] : 0};
    return norm(d, m);
}

double bat_segment_reach(const bat_segment *s) {
    double most = 0;
    for (int i = 1; i <= s->degree; i++) most = fmax(most, between(s->b, s->b + i * s->size, s->size));
    return most;
}

double bat_segment_bulge(const bat_segment *s) {
    const int p = s->degree, m = s->size;
    double bend = 0;
    for (int i = 0; i + 2 <= p; i++) {
        double second[3] = {0};
        const double *b = s->b + i * m;
        for (int c = 0; c < m; c++) second[c] = (b[2 * m + c] - b[m + c]) - (b[m + c] - b[c]);
        bend = fmax(bend, norm(second, m));
    }
    return bend * p * (p - 1) / 8;
}

void bat_segment_cone(const bat_segment *s, double *axis, double *half) {
    const int p = s->degree, m = s->size;
    const vec chord = vec_sub(vec_load(s->b + p * m, m), vec_load(s->b, m)), unit = vec_unit(chord);
    axis[0] = unit.x, axis[1] = unit.y;
    if (m == 3) axis[2] = unit.z;
    const bool known = vec_dot(unit, unit) > 0.5;
    *half = 0;
    for (int i = 0; i < p; i++) {
        const vec step = vec_sub(vec_load(s->b + (i + 1) * m, m), vec_load(s->b + i * m, m));
        if (!(vec_norm(step) > 0)) continue;
        *half = fmax(*half, known ? vec_angle(step, unit) : 2 * BAT_PI);
    }
}

static int across(const bat_segment *s, vec *axes) {
    const vec t = vec_unit(vec_sub(vec_load(s->b + s->degree * s->size, s->size), vec_load(s->b, s->size)));
    if (s->size == 2) {
        axes[0] = (vec){-t.y, t.x, 0};
        return 1;
    }
    axes[0] = vec_any_normal(t), axes[1] = vec_cross(t, axes[0]);
    return 2;
}

static void shadow(const bat_segment *s, vec axis, double out[2]) {
    out[0] = INFINITY, out[1] = -INFINITY;
    for (int i = 0; i <= s->degree; i++) {
        const double x = vec_dot(vec_load(s->b + i * s->size, s->size), axis);
        out[0] = fmin(out[0], x), out[1] = fmax(out[1], x);
    }
}

bool bat_segments_apart(const bat_segment *a, const bat_segment *b, double gap) {
    vec axes[AXES_MAX] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int count = a->size;
    count += across(a, axes + count);
    count += across(b, axes + count);
    for (int i = 0; i < count; i++) {
        double x[2], y[2];
        shadow(a, axes[i], x), shadow(b, axes[i], y);
        if (x[0] - y[1] > gap || y[0] - x[1] > gap) return true;
    }
    return false;
}
