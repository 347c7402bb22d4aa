#include "hands/figures/trace.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

static const double FARTHEST = 0.05; /* rms over the stroke's size: beyond it the stroke is like no figure */
/* How much nearer a figure has to be for each further way to bend, as a share of the stroke's length: a line
 * that is meant straight sags by up to a thirtieth of it, a circle that is meant round has axes that differ
 * by up to a seventh. */
static const double DEARER = 0.009;
static const double STEP = 3; /* px between its points */

static const double WAYS[BAT_FIGURE_COUNT] = {[BAT_FIGURE_ARC] = 1,
                                              [BAT_FIGURE_ELLIPSE] = 1,
                                              [BAT_FIGURE_CLOTHOID] = 2,
                                              [BAT_FIGURE_ELLIPSE_ARC] = 2.5};

static bool near_enough(const bat_trace *trace, bat_found *best) {
    static bool (*const open[])(const bat_trace *, bat_found *) = {bat_trace_line, bat_trace_circle,
                                                                   bat_trace_ellipse, bat_trace_clothoid};
    static bool (*const closed[])(const bat_trace *, bat_found *) = {bat_trace_circle, bat_trace_ellipse};
    const size_t count = trace->closed ? sizeof closed / sizeof *closed : sizeof open / sizeof *open;
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) {
        bat_found found;
        if (!(trace->closed ? closed[i] : open[i])(trace, &found)) continue;
        const double cost = found.miss + DEARER * trace->length * WAYS[found.kind];
        if (cost < least) *best = found, least = cost;
    }
    return least < INFINITY && best->miss <= FARTHEST;
}

/* A place on the figure, in the trace's units; not for clothoids. */
static void place(const bat_found *found, double f, double out[2]) {
    const double *n = found->number;
    if (found->kind == BAT_FIGURE_LINE) {
        for (int k = 0; k < 2; k++) out[k] = n[k] + f * (n[2 + k] - n[k]);
    } else if (found->kind == BAT_FIGURE_ARC || found->kind == BAT_FIGURE_CIRCLE) {
        const double angle = n[3] + f * n[4];
        out[0] = n[0] + n[2] * bat_cos(angle);
        out[1] = n[1] + n[2] * bat_sin(angle);
    } else {
        const double angle = n[5] + f * n[6], c = bat_cos(n[4]), s = bat_sin(n[4]);
        const double x = n[2] * bat_cos(angle), y = n[3] * bat_sin(angle);
        out[0] = n[0] + c * x - s * y;
        out[1] = n[1] + s * x + c * y;
    }
}

void bat_figure_nearest(size_t count, const double *pixels, bat_figure *out) {
    bat_trace trace;
    bat_found found;
    *out = (bat_figure){.kind = BAT_FIGURE_NONE};
    if (!bat_trace_make(count, pixels, &trace) || !near_enough(&trace, &found)) return;
    const double length = trace.length * trace.size;
    out->kind = found.kind;
    out->miss = found.miss * trace.size;
    out->count = (size_t)fmin(fmax(ceil(length / STEP), 16), BAT_FIGURE_POINTS);
    if (found.kind == BAT_FIGURE_CLOTHOID) bat_found_clothoid(found.number, out->count, out->points);
    for (size_t i = 0; i < out->count; i++) {
        double *p = out->points + 2 * i;
        if (found.kind != BAT_FIGURE_CLOTHOID) place(&found, (double)i / (double)(out->count - 1), p);
        for (int k = 0; k < 2; k++) p[k] = trace.middle[k] + trace.size * p[k];
    }
    if (trace.closed) memcpy(out->points + 2 * (out->count - 1), out->points, 2 * sizeof *out->points);
}
