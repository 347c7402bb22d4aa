#include "relate/widen.h"

#include "base/gauss.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 12, LOOKS = 32, BISECTIONS = 48, EVOLUTE_DEPTH = 4, CUTS = BAT_WIDTHS_MAX + LOOKS + 2 };

static const double CUSP = 1e-9;   /* of a stretch's length: as slow, the tangent is taken from beside */
static const double BESIDE = 1e-4; /* of its parameter */

static void derivatives(const double *b, double t, double *point, double *first, double *second) {
    const double u = 1 - t;
    for (int c = 0; c < 2; c++) {
        const double p0 = b[c], p1 = b[2 + c], p2 = b[4 + c], p3 = b[6 + c];
        point[c] = u * u * u * p0 + 3 * u * u * t * p1 + 3 * u * t * t * p2 + t * t * t * p3;
        first[c] = 3 * (u * u * (p1 - p0) + 2 * u * t * (p2 - p1) + t * t * (p3 - p2));
        second[c] = 6 * (u * (p2 - 2 * p1 + p0) + t * (p3 - 2 * p2 + p1));
    }
}

static double speed_at(const void *stretch, double t) {
    double point[2], first[2], second[2];
    derivatives(((const bat_wide_stretch *)stretch)->b, t, point, first, second);
    return bat_hypot(first[0], first[1]);
}

static double length_at(const bat_wide_stretch *s, double t) {
    const int k = (int)fmin(fmax(floor(t * BAT_STRETCH_STEPS), 0), BAT_STRETCH_STEPS - 1);
    return s->steps[k] + bat_gauss(speed_at, s, (double)k / BAT_STRETCH_STEPS, t);
}

/* The parameter at a length from its start. */
static double at_length(const bat_wide_stretch *s, double length) {
    double low = 0, high = 1;
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = 0.5 * (low + high);
        *(length_at(s, middle) < length ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

void bat_widening_at(const bat_widening *w, const bat_wide_stretch *s, double t, bat_wide *out) {
    double first[2], second[2], share[2], other[2];
    derivatives(s->b, t, out->point, first, second);
    out->speed = bat_hypot(first[0], first[1]);
    double length = out->speed;
    if (length <= CUSP * s->length) {
        derivatives(s->b, t < 0.5 ? t + BESIDE : t - BESIDE, other, first, second);
        length = bat_hypot(first[0], first[1]);
        out->speed = length;
    }
    const double cross = first[0] * second[1] - first[1] * second[0];
    for (int c = 0; c < 2; c++) out->tangent[c] = length > 0 ? first[c] / length : c == 0;
    out->bend = length > 0 ? cross / (length * length * length) : 0;
    bat_width_eval(w->profile, w->closed, (s->before + length_at(s, t)) / w->length, share);
    out->half = w->half * share[0];
    out->slope = w->half * share[1] / w->length;
}

void bat_wide_side(const bat_wide *at, int side, double out[2]) {
    out[0] = at->point[0] - side * at->half * at->tangent[1];
    out[1] = at->point[1] + side * at->half * at->tangent[0];
}

/* Above 0 where the side runs as the curve does. */
static double course(const bat_wide *at, int side) { return 1 - side * at->bend * at->half; }

/* The cubic that has the side's points and derivatives at both ends of u[0]..u[1]. */
static void hermite(const bat_wide ends[2], int side, double h, double cubic[8]) {
    for (int e = 0; e < 2; e++) {
        const bat_wide *at = &ends[e];
        const double along = course(at, side) * at->speed, across = side * at->slope * at->speed;
        const double d[2] = {along * at->tangent[0] - across * at->tangent[1],
                             along * at->tangent[1] + across * at->tangent[0]};
        bat_wide_side(at, side, cubic + 6 * e);
        for (int c = 0; c < 2; c++) cubic[2 + 2 * e + c] = cubic[6 * e + c] + (e ? -1 : 1) * d[c] * h / 3;
    }
}

/* How far the cubic is from the side at the same parameters. */
static double error_of(const bat_widening *w, const bat_wide_stretch *s, int side, double a, double b,
                       const double *cubic) {
    static const double shares[3] = {0.25, 0.5, 0.75};
    double most = 0, made[2], first[2], second[2], wanted[2];
    for (int k = 0; k < 3; k++) {
        bat_wide at;
        bat_widening_at(w, s, a + (b - a) * shares[k], &at);
        bat_wide_side(&at, side, wanted);
        derivatives(cubic, shares[k], made, first, second);
        most = fmax(most, bat_hypot(made[0] - wanted[0], made[1] - wanted[1]));
    }
    return most;
}

static void fit(bat_widening *w, const bat_wide_stretch *s, int side, double a, double b, int depth,
                bat_border *border) {
    bat_wide ends[2];
    double cubic[8];
    bat_widening_at(w, s, a, &ends[0]);
    bat_widening_at(w, s, b, &ends[1]);
    hermite(ends, side, b - a, cubic);
    const double error = error_of(w, s, side, a, b, cubic);
    if (!(error <= w->tolerance) && depth < DEPTH) {
        fit(w, s, side, a, 0.5 * (a + b), depth + 1, border);
        fit(w, s, side, 0.5 * (a + b), b, depth + 1, border);
        return;
    }
    w->error = fmax(w->error, error);
    bat_border_line(border, cubic); /* where something else was before */
    if (error <= w->tolerance)
        bat_border_cubic(border, cubic);
    else
        bat_border_line(border, cubic + 6); /* at a cusp */
}

/* The centre of curvature. */
static void centre_at(const bat_widening *w, const bat_wide_stretch *s, double t, double out[2]) {
    bat_wide at;
    bat_widening_at(w, s, t, &at);
    const double radius = fabs(at.bend) * at.half > 1 ? 1 / at.bend : (at.bend < 0 ? -1 : 1) * at.half;
    out[0] = at.point[0] - radius * at.tangent[1];
    out[1] = at.point[1] + radius * at.tangent[0];
}

static void evolute(const bat_widening *w, const bat_wide_stretch *s, double a, double b, int depth,
                    bat_border *border) {
    double p[2], q[2], m[2];
    centre_at(w, s, a, p);
    centre_at(w, s, b, q);
    centre_at(w, s, 0.5 * (a + b), m);
    const double away = bat_hypot(m[0] - 0.5 * (p[0] + q[0]), m[1] - 0.5 * (p[1] + q[1]));
    bat_border_line(border, p);
    if (depth < 2 || (away > w->tolerance && depth < EVOLUTE_DEPTH)) {
        evolute(w, s, a, 0.5 * (a + b), depth + 1, border);
        evolute(w, s, 0.5 * (a + b), b, depth + 1, border);
    } else
        bat_border_line(border, q);
}

/* A side that runs backwards: the sheet ends at the evolute, and the other sheet is a loop of its own. */
static void turn_over(bat_widening *w, const bat_wide_stretch *s, int side, double a, double b,
                      bat_border *border, bat_border *over) {
    bat_border line = {0}, back = {0}, loop = {0};
    evolute(w, s, a, b, 0, &line);
    fit(w, s, side, a, b, 0, &back);
    if (line.count) bat_border_line(border, line.points);
    bat_border_append(border, &line, false);
    bat_border_append(&loop, &line, false);
    if (back.count) bat_border_line(&loop, back.points + 8 * back.count - 2);
    bat_border_append(&loop, &back, true);
    if (loop.count) bat_border_line(&loop, loop.points);
    over->begun = false;
    bat_border_append(over, &loop, side > 0);
    bat_border_free(&line), bat_border_free(&back), bat_border_free(&loop);
}

static double course_at(const bat_widening *w, const bat_wide_stretch *s, int side, double t) {
    bat_wide at;
    bat_widening_at(w, s, t, &at);
    return course(&at, side);
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the stops are, and where the side turns; ascending, from 0 to 1. */
static int cuts_of(const bat_widening *w, const bat_wide_stretch *s, int side, double *cuts) {
    int count = 0;
    cuts[count++] = 0;
    for (size_t i = 0; i < w->profile->count; i++) {
        const double length = w->profile->stops[i].at * w->length - s->before;
        if (length > 1e-9 * w->length && length < s->length - 1e-9 * w->length)
            cuts[count++] = at_length(s, length);
    }
    for (int k = 0; k < LOOKS; k++) {
        double low = (double)k / LOOKS, high = (double)(k + 1) / LOOKS;
        const bool runs = course_at(w, s, side, low) > 0;
        if (runs == (course_at(w, s, side, high) > 0)) continue;
        for (int i = 0; i < BISECTIONS; i++) {
            const double middle = 0.5 * (low + high);
            *((course_at(w, s, side, middle) > 0) == runs ? &low : &high) = middle;
        }
        cuts[count++] = 0.5 * (low + high);
    }
    cuts[count++] = 1;
    qsort(cuts, (size_t)count, sizeof *cuts, compare); /* no ties that differ */
    return count;
}

void bat_widening_side(bat_widening *w, const bat_wide_stretch *s, int side, bat_border *border,
                       bat_border *over) {
    double cuts[CUTS];
    const int count = cuts_of(w, s, side, cuts);
    for (int i = 0; i + 1 < count; i++) {
        if (!(cuts[i + 1] > cuts[i])) continue;
        const bool runs = course_at(w, s, side, 0.5 * (cuts[i] + cuts[i + 1])) > 0;
        if (runs)
            fit(w, s, side, cuts[i], cuts[i + 1], 0, border);
        else
            turn_over(w, s, side, cuts[i], cuts[i + 1], border, over);
    }
}
