/* Strokes of varying width: sides, corners and ends put together (docs/math/relate.md 8). */
#include "base/gauss.h"
#include "base/real.h"
#include "relate/outline.h"
#include "relate/segment.h"
#include "relate/widen.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOOKS = 32, GOLDEN_STEPS = 48, HALVINGS = 60 };

static const double CUT_OUT = 0.05;  /* tolerances: how much of a curve a cusp may take */
static const double FIT = 0.4;       /* of the tolerance: what the sides may take */
static const double NOTHING = 1e-12; /* of the length: a stretch that is a point */

typedef struct stroke {
    bat_widening w;
    bat_nib nib;
    double corner;
    bat_border main, over;
} stroke;

static void velocity(const double *b, double t, double d[2]) {
    const double u = 1 - t;
    for (int c = 0; c < 2; c++)
        d[c] = 3 * (u * u * (b[2 + c] - b[c]) + 2 * u * t * (b[4 + c] - b[2 + c]) +
                    t * t * (b[6 + c] - b[4 + c]));
}

static double speed_at(const void *cubic, double t) {
    double d[2];
    velocity(cubic, t, d);
    return bat_hypot(d[0], d[1]);
}

static void measure(bat_wide_stretch *s) {
    s->steps[0] = 0;
    for (int k = 0; k < BAT_STRETCH_STEPS; k++)
        s->steps[k + 1] = s->steps[k] + bat_gauss(speed_at, s->b, (double)k / BAT_STRETCH_STEPS,
                                                  (double)(k + 1) / BAT_STRETCH_STEPS);
    s->length = s->steps[BAT_STRETCH_STEPS];
}

/* ---- cusps ---- */

/* The shares of a cubic between which it turns back within little of the tolerance, near the place between low and high where it
 * is slowest; false: it does not. */
static bool find_cusp(const double *b, double low, double high, double tolerance, double cusp[2]) {
    const double golden = 0.6180339887498949;
    for (int k = 0; k < GOLDEN_STEPS; k++) {
        const double x = high - golden * (high - low), y = low + golden * (high - low);
        *(speed_at(b, x) < speed_at(b, y) ? &high : &low) = speed_at(b, x) < speed_at(b, y) ? y : x;
    }
    const double t = 0.5 * (low + high);
    double reach = fmin(fmin(t, 1 - t), 0.25);
    for (int k = 0;
         k < HALVINGS &&
         bat_gauss(speed_at, b, t - reach, t) + bat_gauss(speed_at, b, t, t + reach) > CUT_OUT * tolerance;
         k++)
        reach *= 0.5;
    double from[2], to[2];
    velocity(b, t - reach, from), velocity(b, t + reach, to);
    cusp[0] = t - reach, cusp[1] = t + reach;
    return reach > 0 && from[0] * to[0] + from[1] * to[1] < 0;
}

/* The piece of a cubic between two shares. */
static void part_of(const double *b, double from, double to, double *out) {
    bat_segment whole = {.degree = 3, .size = 2, .from = 0, .to = 1}, part;
    memcpy(whole.b, b, 8 * sizeof *b);
    bat_segment_part(&whole, from, to, &part);
    memcpy(out, part.b, 8 * sizeof *b);
}

/* A cubic without its cusps, two at most: up to three stretches; returns how many. */
static int part_at_cusps(const double *b, double tolerance, bat_wide_stretch *out) {
    double from = 0, speeds[LOOKS + 1];
    int count = 0;
    for (int k = 0; k <= LOOKS; k++) speeds[k] = speed_at(b, (double)k / LOOKS);
    for (int k = 0; k <= LOOKS && count < 2; k++) {
        const int before = k > 0 ? k - 1 : 0, after = k < LOOKS ? k + 1 : LOOKS;
        double cusp[2];
        if (speeds[k] > speeds[before] || (k < LOOKS && speeds[k] >= speeds[after]) ||
            !find_cusp(b, (double)before / LOOKS, (double)after / LOOKS, tolerance, cusp) ||
            !(cusp[0] > from))
            continue;
        out[count].cusp = true;
        part_of(b, from, cusp[0], out[count++].b);
        from = cusp[1];
    }
    out[count].cusp = false;
    part_of(b, from, 1, out[count++].b);
    return count;
}

/* The curve's stretches. */
static bat_status prepare(bat_widening *w, const bat_curve *curve) {
    int count = 0;
    double *cubics = NULL;
    bat_status status = bat_curve_to_cubics(curve, FIT * w->tolerance, &count, &cubics);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    w->stretches = malloc((3 * (size_t)count + 1) * sizeof *w->stretches);
    if (!w->stretches) {
        bat_free(cubics);
        return BAT_MEMORY;
    }
    int all = 0;
    for (int i = 0; i < count; i++) all += part_at_cusps(cubics + 8 * i, w->tolerance, w->stretches + all);
    bat_free(cubics);
    for (int i = 0; i < all; i++) measure(&w->stretches[i]), w->length += w->stretches[i].length;
    double before = 0;
    for (int i = 0; i < all; i++) {
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
 * the inside. A cusp is round whatever the joins are, as browsers paint it. */
static void join(const stroke *k, const bat_wide *a, const bat_wide *b, bool cusp, int side,
                 bat_border *border) {
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
    if (k->nib.join == BAT_JOIN_ROUND || cusp)
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
        join(k, &a, &b, w->stretches[i].cusp, side, border);
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
    if (!profile) return BAT_ARGUMENT;
    const bat_status status = bat_outline_check(curve, nib, tolerance, corner);
    return status == BAT_OK ? bat_width_check(profile, NULL) : status;
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
