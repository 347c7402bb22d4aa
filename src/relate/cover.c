/* Strokes of varying width: sides, corners and ends put together (docs/math/relate.md 8). */
#include "base/gauss.h"
#include "base/real.h"
#include "relate/widen.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double FIT = 0.4;       /* of the tolerance: what the sides may take */
static const double NOTHING = 1e-12; /* of the length: a stretch that is a point */

typedef struct stroke {
    bat_widening w;
    bat_nib nib;
    double corner;
    bat_border main, over;
} stroke;

static double speed_at(const void *cubic, double t) {
    const double *b = cubic, u = 1 - t;
    double d[2];
    for (int c = 0; c < 2; c++)
        d[c] = 3 * (u * u * (b[2 + c] - b[c]) + 2 * u * t * (b[4 + c] - b[2 + c]) +
                    t * t * (b[6 + c] - b[4 + c]));
    return bat_hypot(d[0], d[1]);
}

static void measure(bat_wide_stretch *s) {
    s->steps[0] = 0;
    for (int k = 0; k < BAT_STRETCH_STEPS; k++)
        s->steps[k + 1] = s->steps[k] + bat_gauss(speed_at, s->b, (double)k / BAT_STRETCH_STEPS,
                                                  (double)(k + 1) / BAT_STRETCH_STEPS);
    s->length = s->steps[BAT_STRETCH_STEPS];
}

/* The curve's stretches. */
static bat_status prepare(bat_widening *w, const bat_curve *curve) {
    int count = 0;
    double *cubics = NULL;
    bat_status status = bat_curve_to_cubics(curve, FIT * w->tolerance, &count, &cubics);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    w->stretches = malloc(((size_t)count + 1) * sizeof *w->stretches);
    if (!w->stretches) {
        bat_free(cubics);
        return BAT_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        memcpy(w->stretches[i].b, cubics + 8 * i, sizeof w->stretches[i].b);
        measure(&w->stretches[i]);
        w->length += w->stretches[i].length;
    }
    bat_free(cubics);
    double before = 0;
    for (int i = 0; i < count; i++) {
        bat_wide_stretch s = w->stretches[i];
        s.before = before, before += s.length;
        if (s.length > NOTHING * w->length) w->stretches[w->count++] = s;
    }
    return BAT_OK;
}

static void end_of(const stroke *k, int stretch, int end, bat_wide *out) {
    bat_widening_at(&k->w, &k->w.stretches[stretch], end, out);
}

/* From one stretch to the next, on one side: nothing on a smooth curve; at a corner round the outside, and through the corner on
 * the inside. */
static void join(const stroke *k, const bat_wide *a, const bat_wide *b, int side, bat_border *border) {
    const double cross = a->tangent[0] * b->tangent[1] - a->tangent[1] * b->tangent[0],
                 dot = a->tangent[0] * b->tangent[0] + a->tangent[1] * b->tangent[1];
    const double turn = bat_atan2(cross, dot);
    double from[2], to[2];
    if (!(fabs(turn) > k->corner)) return;
    bat_wide_side(a, side, from);
    bat_wide_side(b, side, to);
    if ((turn > 0) == (side > 0)) {
        bat_border_line(border, b->point);
        bat_border_line(border, to);
        return;
    }
    bat_border_line(border, from);
    const double half = bat_cos(0.5 * turn); /* 1 / how many widths a mitre is long */
    if (k->nib.join == BAT_JOIN_ROUND)
        bat_border_arc(border, b->point, turn, FIT * k->w.tolerance);
    else if (k->nib.join == BAT_JOIN_MITER && half * k->nib.miter_limit >= 1) {
        const double out = side * b->half / (1 + dot);
        const double tip[2] = {b->point[0] - out * (a->tangent[1] + b->tangent[1]),
                               b->point[1] + out * (a->tangent[0] + b->tangent[0])};
        bat_border_line(border, tip);
    }
    bat_border_line(border, to);
}

static void follow(stroke *k, int side, bat_border *border) {
    bat_widening *w = &k->w;
    for (int i = 0; i < w->count; i++) {
        bat_wide a, b;
        bat_widening_side(w, &w->stretches[i], side, border, &k->over);
        if (i + 1 == w->count && !w->closed) break;
        end_of(k, i, 1, &a);
        end_of(k, (i + 1) % w->count, 0, &b);
        join(k, &a, &b, side, border);
    }
}

/* Round an end, anticlockwise, from one side to the other. outwards: 1 at the end of the curve, -1 at its start. */
static void cap(stroke *k, const bat_wide *end, int outwards, bat_border *border) {
    double from[2], to[2];
    bat_wide_side(end, -outwards, from);
    bat_wide_side(end, outwards, to);
    bat_border_line(border, from);
    if (!(end->half > 0)) return;
    if (k->nib.cap == BAT_CAP_ROUND) bat_border_arc(border, end->point, BAT_PI, FIT * k->w.tolerance);
    if (k->nib.cap == BAT_CAP_SQUARE)
        for (int e = 0; e < 2; e++) {
            const double *at = e ? to : from, out = outwards * end->half;
            const double edge[2] = {at[0] + out * end->tangent[0], at[1] + out * end->tangent[1]};
            bat_border_line(border, edge);
        }
    bat_border_line(border, to);
}

static void close_at(bat_border *border, size_t first) {
    if (border->count > first) bat_border_line(border, border->points + 8 * first);
    border->begun = false;
}

/* Begins the side where the curve begins, even where it is turned over there. */
static void begin(const stroke *k, int side, bat_border *border) {
    bat_wide start;
    double at[2];
    end_of(k, 0, 0, &start);
    bat_wide_side(&start, side, at);
    bat_border_move(border, at);
}

static void build(stroke *k) {
    bat_border left = {0};
    begin(k, -1, &k->main);
    follow(k, -1, &k->main);
    begin(k, 1, &left);
    follow(k, 1, &left);
    if (k->w.closed) {
        close_at(&k->main, 0);
        close_at(&left, 0);
        bat_border_append(&k->main, &left, true);
    } else {
        bat_wide ends[2];
        double at[2];
        end_of(k, k->w.count - 1, 1, &ends[1]);
        end_of(k, 0, 0, &ends[0]);
        bat_wide_side(&ends[1], 1, at);
        bat_border_line(&left, at);
        cap(k, &ends[1], 1, &k->main);
        bat_border_append(&k->main, &left, true);
        cap(k, &ends[0], -1, &k->main);
        close_at(&k->main, 0);
    }
    k->main.begun = false;
    bat_border_append(&k->main, &k->over, false);
    bat_border_free(&left);
}

static void clear(stroke *k) {
    free(k->w.stretches);
    bat_border_free(&k->main);
    bat_border_free(&k->over);
}

static bat_status check(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                        double tolerance, double corner) {
    if (!curve || !nib || !profile || !(tolerance > 0) || !(corner >= 0) || !(nib->width > 0) ||
        !(nib->width <= BAT_COORDINATE_MAX) || !(nib->miter_limit >= 1) || (unsigned)nib->cap > 2 ||
        (unsigned)nib->join > 2)
        return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    return bat_width_check(profile);
}

static bat_status cover(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                        double tolerance, double corner, stroke *k) {
    *k = (stroke){.w = {.profile = profile,
                        .half = 0.5 * nib->width,
                        .tolerance = tolerance,
                        .closed = bat_curve_is_closed(curve)},
                  .nib = *nib,
                  .corner = corner};
    bat_status status = prepare(&k->w, curve);
    if (status == BAT_OK && k->w.count) {
        build(k);
        status = k->main.status != BAT_OK ? k->main.status : k->over.status;
    }
    if (status != BAT_OK) clear(k);
    return status;
}

bat_status bat_widen_cover(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                           double tolerance, double corner, size_t *cubics, double **points, double *error) {
    stroke k;
    bat_status status = check(curve, nib, profile, tolerance, corner);
    if (status == BAT_OK) status = cover(curve, nib, profile, tolerance, corner, &k);
    if (status != BAT_OK) return status;
    *cubics = k.main.count, *points = k.main.points, *error = k.w.error;
    k.main.points = NULL;
    clear(&k);
    return BAT_OK;
}

bat_status bat_curve_cover_width(const bat_curve *curve, const bat_nib *nib, const bat_width_profile *profile,
                                 double tolerance, double corner, size_t *cubics, double **points) {
    double error;
    if (!cubics || !points) return BAT_ARGUMENT;
    return bat_widen_cover(curve, nib, profile, tolerance, corner, cubics, points, &error);
}
