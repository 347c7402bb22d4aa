/* Any two curves: polylines and arcs begin and end where the curve does, what is handed over is near both curves, and the
 * distance is not below that of any sample. */
#include <batten/bezier.h>
#include <batten/blend.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/measure.h>
#include <batten/region.h>
#include <batten/relate.h>
#include <batten/width.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Outlines are closed, and as far from the curve as the width says. */
static void outline(const bat_curve *curve, unsigned kind, double size) {
    const bat_nib nib = {0.2 * size, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4},
                  other = {0.1 * size, (bat_cap)(kind % 3), (bat_join)(kind / 3 % 3), 1 + kind % 5};
    size_t count;
    bat_curve **all;
    if (bat_curve_outline(curve, &other, 1e-3 * size, 0.02, &count, &all, NULL) == BAT_OK)
        bat_curves_free(count, all);
    if (bat_curve_outline(curve, &nib, 1e-3 * size, 0.02, &count, &all, NULL) == BAT_OK) {
        for (size_t i = 0; i < count; i++) {
            double u[16], x[2];
            bat_near near;
            if (!bat_curve_is_closed(all[i])) abort();
            bat_curve_spread(all[i], 16, u);
            for (int k = 0; k < 16; k++) {
                bat_curve_eval(all[i], u[k], 0, x);
                if (bat_curve_nearest(curve, x, &near) != BAT_OK) abort();
                if (fabs(near.distance - 0.1 * size) > 1.3e-3 * size) abort();
            }
        }
        bat_curves_free(count, all);
    }
    const bat_region region = {1, &curve, kind & 1};
    if (bat_region_offset(&region, (kind & 2 ? 0.05 : -0.05) * size, (bat_join)(kind % 3), 4, 1e-3 * size,
                          0.02, &count, &all) == BAT_OK)
        bat_curves_free(count, all);
}

/* A profile stays one through edits; what is painted is made of finite numbers, and the outline closes. */
static void widen(const bat_curve *curve, unsigned kind, double size) {
    const bat_nib nib = {0.2 * size, (bat_cap)(kind % 3), (bat_join)(kind / 3 % 3), 1 + kind % 5};
    bat_width_stop stops[BAT_WIDTHS_MAX], part[BAT_WIDTHS_MAX];
    size_t count = 0, cubics;
    double *points, value[2];
    bat_curve **all;
    for (unsigned i = 0; i < 2 + kind % 5; i++)
        bat_width_put(&count, stops, (kind * 7 + i * 5) % 11 / 10.0, (kind + i * 3) % 5 / 4.0, 0.01);
    if (count > 2 && kind & 1 && bat_width_remove(&count, stops, 1) != BAT_OK) abort();
    if (bat_width_move(count, stops, 0, kind % 4 / 3.0, 0.5) != BAT_OK) abort();
    const bat_width_profile profile = {count, stops};
    if (bat_width_check(&profile, NULL) != BAT_OK) abort();
    bat_width_eval(&profile, kind & 2, kind % 9 / 8.0, value);
    if (!(value[0] >= 0 && value[0] <= 1)) abort();
    const bat_width_profile piece = {bat_width_stretch(&profile, 0.7, 0.1, part), part};
    if (bat_width_check(&piece, NULL) != BAT_OK) abort();
    if (bat_width_is_even(&profile) && !bat_width_is_even(&piece)) abort();
    if (bat_curve_cover_width(curve, &nib, &profile, 1e-3 * size, 0.02, &cubics, &points) == BAT_OK) {
        for (size_t i = 0; i < 8 * cubics; i++)
            if (!isfinite(points[i])) abort();
        bat_free(points);
    }
    if (bat_curve_outline_width(curve, &nib, &profile, 1e-3 * size, 0.02, &count, &all, NULL) != BAT_OK)
        return;
    for (size_t i = 0; i < count; i++)
        if (!bat_curve_is_closed(all[i])) abort();
    bat_curves_free(count, all);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST = 12 };

typedef struct input {
    const uint8_t *data;
    size_t size;
} input;

static unsigned byte(input *in) { return in->size ? (in->size--, (unsigned)*in->data++) : 0; }

static bat_curve *read_curve(input *in, int m) {
    double knots[MOST + 8], points[MOST * 3], t = 0;
    const unsigned shape = byte(in);
    const int p = 1 + (int)(shape % 7), n = p + 1 + (int)(byte(in) % (MOST - 7));
    const bool closed = shape & 64, wide = shape & 128;
    const int count = closed ? n + 1 : n + p + 1;
    for (int i = 0; i < count; i++) {
        const unsigned step = byte(in);
        knots[i] = t, t += step % 4 ? 0.25 * (step % 16) : 0;
    }
    for (int i = 0; i < n * m; i++) {
        if (wide && in->size >= 8)
            memcpy(points + i, in->data, 8), in->data += 8, in->size -= 8;
        else
            points[i] = (double)byte(in) - 128;
    }
    bat_curve *curve;
    return bat_curve_create(m, p, closed, (size_t)n, points, count, knots, &curve) == BAT_OK ? curve : NULL;
}

static double far_from(const double *a, const double *b, int m) {
    double d = 0;
    for (int c = 0; c < m; c++) d = hypot(d, a[c] - b[c]);
    return d;
}

static double greatest(const bat_curve *curve) {
    double most = 0;
    const double *points = bat_curve_points(curve);
    const size_t count = bat_curve_count(curve) * (size_t)bat_curve_dimension(curve);
    for (size_t i = 0; i < count; i++) most = fmax(most, fabs(points[i]));
    return most;
}

static void make(const bat_curve *curve, double size) {
    const int m = bat_curve_dimension(curve);
    double domain[2], start[3], end[3], *points, *u, error;
    size_t count;
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, start), bat_curve_eval_left(curve, domain[1], 0, end);
    bat_status status = bat_curve_flatten(curve, 1e-3 * size, &count, &points, &u);
    if (status != BAT_OK && status != BAT_COUNT) abort();
    if (status == BAT_OK) {
        if (count < 2 || far_from(points, start, m) > 1e-9 * size) abort();
        if (far_from(points + (count - 1) * (size_t)m, end, m) > 1e-9 * size) abort();
        for (size_t i = 1; i < count; i++)
            if (!(u[i - 1] < u[i])) abort();
        bat_free(points), bat_free(u);
    }
    bat_arc *arcs;
    status = bat_curve_arcs(curve, 1e-3 * size, 0.1, &count, &arcs, &error);
    if (m == 3) {
        if (status != BAT_DIMENSION) abort();
        return;
    }
    if (status != BAT_OK && status != BAT_COUNT) abort();
    if (status != BAT_OK) return;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(arcs[i].radius) || (i && arcs[i - 1].to[0] != arcs[i].from[0])) abort();
    bat_free(arcs);
}

/* Parallels are finite and nowhere nearer to the curve, or further, than they say. */
static void beside(const bat_curve *curve, double distance, double size) {
    size_t count;
    bat_curve **all;
    double error;
    const bat_status status = bat_curve_offset(curve, distance, 1e-3 * size, 0.1, &count, &all, &error);
    if (status == BAT_COUNT || (status == BAT_DIMENSION && bat_curve_dimension(curve) == 3)) return;
    if (status != BAT_OK || !isfinite(error)) abort();
    for (size_t i = 0; i < count; i++) {
        double domain[2], x[2];
        bat_near near;
        bat_curve_domain(all[i], domain), bat_curve_eval(all[i], domain[0], 0, x);
        if (bat_curve_nearest(curve, x, &near) != BAT_OK) abort();
        if (fabs(near.distance - fabs(distance)) > error + 1e-9 * size) abort();
    }
    bat_curves_free(count, all);
}

static void check(const bat_meeting *meeting, const bat_curve *a, const bat_curve *b, double gap) {
    for (size_t i = 0; i < meeting->count; i++) {
        double x[3], y[3];
        bat_curve_eval(a, meeting->crossings[i].u, 0, x), bat_curve_eval(b, meeting->crossings[i].v, 0, y);
        if (!(far_from(x, y, bat_curve_dimension(a)) <= 2 * gap)) abort();
    }
}

/* Blends begin and end where they are asked to, and so do ends that are moved. */
static void blend(const bat_curve *a, const bat_curve *b, int continuity, double size) {
    bat_blend_options options;
    bat_blend_options_init(&options, sizeof options);
    options.continuity[0] = continuity % 4, options.continuity[1] = continuity / 4 % 4;
    const bool a_end = continuity & 16, b_end = continuity & 32;
    bat_curve *made = NULL, *met = NULL;
    double jump[4];
    if (bat_curve_blend(a, a_end, b, b_end, &options, &made, NULL) == BAT_OK)
        if (bat_curve_jump(a, a_end, made, false, jump) != BAT_OK || !(jump[0] <= 1e-9 * size)) abort();
    if (bat_curve_match(a, a_end, b, b_end, continuity % 4, 1, &met, NULL) == BAT_OK)
        if (bat_curve_jump(met, a_end, b, b_end, jump) != BAT_OK || !(jump[0] <= 1e-9 * size)) abort();
    bat_curve_free(made), bat_curve_free(met);
}

static void relate(const bat_curve *a, const bat_curve *b, double size) {
    const double gap = 1e-4 * size;
    bat_meeting meeting;
    bat_status status = bat_curve_intersect(a, b, gap, &meeting);
    if (status != BAT_OK && status != BAT_COUNT) abort();
    if (status == BAT_OK) check(&meeting, a, b, gap), bat_meeting_free(&meeting);
    status = bat_curve_self_intersect(a, gap, &meeting);
    if (status != BAT_OK && status != BAT_COUNT) abort();
    if (status == BAT_OK) check(&meeting, a, a, gap), bat_meeting_free(&meeting);
    bat_apart apart;
    status = bat_curve_hausdorff(a, b, gap, &apart);
    if (status != BAT_OK && status != BAT_TOLERANCE) abort();
    double domain[2], x[3];
    bat_curve_domain(a, domain);
    for (int i = 0; i <= 32 && status == BAT_OK; i++) {
        bat_near near;
        bat_curve_eval(a, domain[0] + (domain[1] - domain[0]) * i / 32, 0, x);
        if (bat_curve_nearest(b, x, &near) != BAT_OK) abort();
        if (near.distance > apart.distance + 1.01 * gap) abort();
    }
}

/* The result lies on the curves, and closed. */
static void unite(const bat_curve *a, const bat_curve *b, bat_region_operation operation, double size) {
    const bat_region both[2] = {{1, &a, false}, {1, &b, true}};
    const bool fit = bat_curve_dimension(a) == 2 && bat_curve_is_closed(a) && bat_curve_is_closed(b);
    size_t count;
    bat_curve **all;
    const bat_status status = bat_regions_combine(operation, 2, both, 1e-4 * size, &count, &all);
    if (!fit && status != BAT_ARGUMENT && status != BAT_DIMENSION) abort();
    if (status != BAT_OK) return;
    for (size_t i = 0; i < count; i++) {
        double u[16], x[2];
        if (!(fabs(bat_curve_area(all[i])) > 0)) abort();
        bat_curve_spread(all[i], 16, u);
        for (int k = 0; k < 16; k++) {
            bat_near near, other;
            bat_curve_eval(all[i], u[k], 0, x);
            if (bat_curve_nearest(a, x, &near) != BAT_OK || bat_curve_nearest(b, x, &other) != BAT_OK)
                abort();
            if (fmin(near.distance, other.distance) > 1e-4 * size) abort();
        }
    }
    bat_curves_free(count, all);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    input in = {data, size};
    const int m = byte(&in) & 1 ? 3 : 2;
    bat_curve *a = read_curve(&in, m), *b = read_curve(&in, m);
    if (a) {
        const double scale = fmax(greatest(a), b ? greatest(b) : 0);
        if (scale > 0 && scale < 1e60 && scale > 1e-60) {
            make(a, scale);
            beside(a, ((int)(size % 64) - 32) * 0.02 * scale, scale);
            if (b) relate(a, b, scale);
            if (b) blend(a, b, (int)(size % 64), scale);
            outline(a, (unsigned)(size % 64), scale);
            widen(a, (unsigned)(size % 64), scale);
            if (b) unite(a, b, (bat_region_operation)(size % BAT_REGION_OPERATION_COUNT), scale);
        }
    }
    bat_curve_free(a), bat_curve_free(b);
    return 0;
}
