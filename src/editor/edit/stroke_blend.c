#include "editor/edit/stroke_blend.h"
#include "curve/curve.h"
#include <batten/blend.h>
#include <batten/nearest.h>
#include <math.h>

static const double TENSION[] = {0.35, 0.5, 0.7, 1, 1.4, 2, 2.8};
enum { TENSIONS = sizeof TENSION / sizeof *TENSION, MIDDLE = 3, ROUNDS = 2, SAMPLES = 32 };

static void end_of(const bat_curve *curve, bool last, double at[BAT_DIMENSION_MAX]) {
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[last], 0, at);
}

/* Which ends are meant: those nearest to the stroke's, either way round. */
static void find_ends(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke, bool last[2]) {
    const int n = stroke->dimension;
    const double *tip[2] = {stroke->points, stroke->points + (stroke->count - 1) * (size_t)n};
    double least = INFINITY;
    for (int way = 0; way < 8; way++) {
        const bool a_last = !(way & 1), b_last = way & 2;
        double from[BAT_DIMENSION_MAX], to[BAT_DIMENSION_MAX];
        if (a == b && a_last == b_last) continue;
        end_of(a, a_last, from), end_of(b, b_last, to);
        const double far = bat_distance(from, tip[way >> 2], n) + bat_distance(to, tip[!(way >> 2)], n);
        if (far < least) least = far, last[0] = a_last, last[1] = b_last;
    }
}

/* The mean of the squared distances of the stroke from the curve. */
static double off(const bat_curve *curve, const bat_stroke *stroke) {
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const size_t k = (stroke->count - 1) * (size_t)i / (SAMPLES - 1);
        bat_near near;
        if (bat_curve_nearest(curve, stroke->points + k * (size_t)stroke->dimension, &near) != BAT_OK)
            return INFINITY;
        sum += near.distance * near.distance;
    }
    return sum;
}

bat_status bat_edit_blend(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke, bat_curve **out) {
    bool last[2] = {true, false};
    int at[2] = {MIDDLE, MIDDLE};
    double least = INFINITY;
    bat_curve *best = NULL;
    bat_status status = stroke->count > 0 ? BAT_OK : BAT_DOT;
    if (status == BAT_OK) find_ends(a, b, stroke, last);
    for (int k = 0; k < 2 * ROUNDS && status == BAT_OK; k++) { /* one end after the other */
        int found = at[k % 2];
        for (int i = 0; i < TENSIONS && status == BAT_OK; i++) {
            bat_curve *made = NULL;
            bat_blend_options options = bat_blend_defaults();
            at[k % 2] = i;
            for (int side = 0; side < 2; side++) options.tension[side] = TENSION[at[side]];
            status = bat_curve_blend(a, last[0], b, last[1], &options, &made, NULL);
            const double now = status == BAT_OK ? off(made, stroke) : INFINITY;
            if (now < least) {
                bat_curve *worse = best;
                best = made, made = worse, least = now, found = i;
            }
            bat_curve_free(made);
        }
        at[k % 2] = found;
    }
    if (status == BAT_OK && !best) status = BAT_SINGULAR;
    if (status == BAT_OK)
        *out = best;
    else
        bat_curve_free(best);
    return status;
}
