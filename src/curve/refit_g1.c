/*
 * Covers a curve with as few cubics as keep it within a tolerance, joined by tangents only (G1). The ends of a piece
 * lie on the curve and have its tangents, so pieces do not depend on each other, and taking the longest each time
 * needs the fewest (nearly: what is left of a piece that fits has a piece that fits). On a closed curve without corners
 * the count depends on where one begins: two rounds are covered, and the joint is taken whose round has the fewest.
 */
#include "curve/curve.h"
#include "curve/hermite.h"

#include "base/real.h"
#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 48, SAMPLES_LEAST = 4 /* of a segment */, TRIES = 4, CHECKED = 12 };

static const double PRECISE = 0.01; /* of a piece: how well its end is found */
static const double LOOSE = 0.01;   /* of the tolerance: what joints may move to become C1 in the parameter */
static const double SPEED_RANGE = 30; /* of the result, about that of its segments' lengths */
static const double ROUNDING = 1e-6;  /* radians that two tangents may differ by when they are one */
static const double ORDER = 6;        /* of the error of a cubic with two free lengths, in its length */

/* The curve as cubics. Places are numbers s: the segment, and the parameter in it; on closed curves any s. */
typedef struct chain {
    int dimension, count;
    bool closed;
    double *points; /* count * 4 * dimension */
    bool *corner;   /* where segment i begins */
} chain;

typedef struct cover {
    const chain *of;
    double tolerance, most; /* longest piece, in s */
    double guess;           /* length of the last piece, in s */
    bat_hermite h;
    int count, room;
    double *from;   /* where the pieces begin */
    double *points; /* 4 * dimension each */
} cover;

/* ---- the curve ---- */

static const double *segment(const chain *q, double s, bool left, double *t) {
    double i = floor(s);
    if (left && i == s) i -= 1;
    *t = s - i;
    const int k = (int)fmod(i, q->count);
    return q->points + (size_t)(k < 0 ? k + q->count : k) * (size_t)(4 * q->dimension);
}

/* The control points of the part from..to of a cubic. */
static void part_of(const double *b, int m, double from, double to, double *out) {
    const double arguments[4][3] = {{from, from, from}, {from, from, to}, {from, to, to}, {to, to, to}};
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < m; c++) {
            double row[4] = {b[c], b[m + c], b[2 * m + c], b[3 * m + c]};
            for (int r = 0; r < 3; r++)
                for (int i = 0; i < 3 - r; i++)
                    row[i] = (1 - arguments[k][r]) * row[i] + arguments[k][r] * row[i + 1];
            out[k * m + c] = row[0];
        }
}

/* Unit vector into a piece from its end, whose points follow from there in steps of `step`. */
static void way_of(const double *end, ptrdiff_t step, int m, double *way) {
    double length = 0;
    for (int k = 1; k < 4 && !(length > 0); k++) {
        const double *next = end + k * step;
        length = bat_distance(end, next, m);
        for (int c = 0; c < m; c++) way[c] = length > 0 ? (next[c] - end[c]) / length : 0;
    }
}

static bat_status read_chain(const bat_curve *curve, double tolerance, double corner, chain *q) {
    const int m = curve->dimension;
    const size_t size = (size_t)(4 * m);
    *q = (chain){.dimension = m, .closed = curve->closed};
    int count = 0;
    bat_status status = bat_curve_to_cubics(curve, tolerance, &count, &q->points);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) {
        const double *b = q->points + (size_t)i * size;
        if (bat_distance(b, b + m, m) + bat_distance(b + m, b + 2 * m, m) +
                bat_distance(b + 2 * m, b + 3 * m, m) >
            0)
            memmove(q->points + (size_t)q->count++ * size, b, size * sizeof *b);
    }
    q->corner = calloc((size_t)q->count + 1, sizeof *q->corner);
    if (!q->corner) return BAT_MEMORY;
    for (int i = 0; i < q->count; i++) {
        double *b = q->points + (size_t)i * size,
               *a = q->points + (size_t)((i + q->count - 1) % q->count) * size;
        q->corner[i] = i == 0 && !q->closed;
        if (q->corner[i]) continue;
        double before[BAT_DIMENSION_MAX], after[BAT_DIMENSION_MAX];
        memcpy(a + 3 * m, b, (size_t)m * sizeof *b);
        way_of(a + 3 * m, -m, m, before), way_of(b, m, m, after);
        for (int c = 0; c < m; c++) before[c] += b[c], after[c] += b[c];
        q->corner[i] = bat_turn(before, b, after, m) > corner;
    }
    return BAT_OK;
}

static void free_chain(chain *q) {
    bat_free(q->points);
    free(q->corner);
}

/* ---- one piece ---- */

/* The samples of u..v, joints of segments among them. */
static bool sample(cover *w, double u, double v) {
    const chain *q = w->of;
    const size_t m = (size_t)q->dimension;
    bat_hermite *h = &w->h;
    h->count = 0;
    for (double a = u, b; a < v; a = b) {
        b = fmin(v, floor(a) + 1);
        const double share = ceil(SAMPLES * (b - a) / (v - u));
        const int pieces = share > SAMPLES_LEAST ? (int)share : SAMPLES_LEAST;
        double t, part[4 * BAT_DIMENSION_MAX];
        const double *x = segment(q, a, false, &t);
        if (!bat_hermite_room(h, h->count + (size_t)pieces)) return false;
        for (int i = a == u; i < pieces; i++) {
            const double at = t + (b - a) * i / pieces;
            part_of(x, q->dimension, at, at, part);
            memcpy(h->x + h->count++ * m, part, m * sizeof *part);
        }
    }
    return true;
}

/* The cubic for u..v; *error: how far it is from the curve. */
static bat_status fit_piece(cover *w, double u, double v, double *points, double *error) {
    const chain *q = w->of;
    const int m = q->dimension;
    double t, end, side[2][4 * BAT_DIMENSION_MAX], handle[2];
    const double *first = segment(q, u, false, &t), *last = segment(q, v, true, &end);
    if (v <= floor(u) + 1) {
        part_of(first, m, t, end, points);
        *error = 0;
        return BAT_OK;
    }
    part_of(first, m, t, 1, side[0]), part_of(last, m, 0, end, side[1]);
    bat_hermite *h = &w->h;
    memcpy(h->end[0], side[0], (size_t)m * sizeof(double));
    memcpy(h->end[1], side[1] + 3 * m, (size_t)m * sizeof(double));
    way_of(side[0], m, m, h->way[0]), way_of(side[1] + 3 * m, -m, m, h->way[1]);
    if (!sample(w, u, v)) return BAT_MEMORY;
    bat_hermite_measure(h);
    *error = bat_hermite_fit(h, w->tolerance, handle);
    bat_hermite_points(h, handle, points);
    return BAT_OK;
}

/* The longest piece from u, up to `end`. */
static bat_status longest(cover *w, double u, double end, double *points, double *reached) {
    const size_t size = (size_t)(4 * w->of->dimension) * sizeof(double);
    const double sure = fmin(floor(u) + 1, end = fmin(end, u + w->most));
    double low = u, high = INFINITY, over = 0, v = fmin(end, fmax(sure, u + w->guess)), error;
    while (high - low > PRECISE * (low - u) && low < end) {
        double trial[4 * BAT_DIMENSION_MAX];
        bat_status status = fit_piece(w, u, v, trial, &error);
        if (status != BAT_OK) return status;
        if (error <= w->tolerance)
            low = v, memcpy(points, trial, size);
        else
            high = v, over = error;
        if (high == INFINITY) {
            v = fmin(end, u + 1.5 * (v - u));
            continue;
        }
        const double gap = high - low,
                     likely = u + (high - u) * bat_exp(bat_log(w->tolerance / over) / ORDER);
        v = fmax(fmin(likely, high - 0.15 * gap), low + (low > u ? 0.15 : 0.3) * gap);
        if (low == u) v = fmax(v, sure);
    }
    *reached = low;
    return BAT_OK;
}

/* ---- all pieces ---- */

static bat_status cover_run(cover *w, double from, double to) {
    const size_t size = (size_t)(4 * w->of->dimension);
    for (double s = from; s < to;) {
        if (w->count == w->room) {
            const size_t room = (size_t)w->room * 2 + 64;
            double *more = realloc(w->points, room * size * sizeof *more);
            if (more) w->points = more;
            double *places = more ? realloc(w->from, room * sizeof *places) : NULL;
            if (places) w->from = places;
            if (!places) return BAT_MEMORY;
            w->room = (int)room;
        }
        w->from[w->count] = s;
        bat_status status = longest(w, s, to, w->points + (size_t)w->count * size, &s);
        if (status != BAT_OK) return status;
        w->guess = s - w->from[w->count++];
    }
    return BAT_OK;
}

/* Of the pieces of two rounds those of one: the round with the fewest, its last piece cut off where it began. */
static bat_status cover_round(cover *w) {
    const chain *q = w->of;
    const size_t size = (size_t)(4 * q->dimension);
    w->most = 0.5 * q->count;
    bat_status status = cover_run(w, 0, 2 * q->count);
    if (status != BAT_OK) return status;
    int best = 0, least = w->count;
    for (int i = 0, k = 0; i < w->count && w->from[i] < q->count; i++) {
        while (k < w->count && w->from[k] < w->from[i] + q->count) k++;
        if (k < w->count && k - i < least) least = k - i, best = i;
    }
    if (least < 1) return BAT_SINGULAR; /* cannot be: a round has pieces */
    const double begun = w->from[best], last = w->from[best + least - 1];
    memmove(w->points, w->points + (size_t)best * size, (size_t)(least - 1) * size * sizeof *w->points);
    w->count = least - 1;
    return cover_run(w, last, begun + q->count);
}

static bat_status cover_all(cover *w) {
    const chain *q = w->of;
    int first = 0;
    while (first < q->count && !q->corner[first]) first++;
    w->most = INFINITY, w->count = 0, w->guess = 1;
    if (first == q->count) return cover_round(w);
    bat_status status = BAT_OK;
    for (int i = first, next; i < first + q->count && status == BAT_OK; i = next) {
        for (next = i + 1; next < first + q->count && !q->corner[next % q->count];) next++;
        status = cover_run(w, i, next);
    }
    return status;
}

/* The pieces as a curve. */
static bat_status assemble(const cover *w, double corner, bat_curve **out) {
    const chain *q = w->of;
    const size_t m = (size_t)q->dimension;
    double *points = malloc(((size_t)w->count * 3 + 1) * m * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (int i = 0; i < w->count; i++)
        memcpy(points + (size_t)(3 * i) * m, w->points + (size_t)(4 * i) * m, 4 * m * sizeof *points);
    if (q->closed) memcpy(points + (size_t)(3 * w->count) * m, points, m * sizeof *points);
    bat_status status = bat_curve_from_chain(q->dimension, 3, q->closed, w->count, points, corner,
                                             SPEED_RANGE, LOOSE * w->tolerance, out, NULL);
    free(points);
    return status;
}

static bat_status covered(const bat_curve *curve, const chain *q, double tolerance, double corner,
                          bat_curve **out, double *error) {
    cover w = {.of = q, .h = {.dimension = q->dimension}, .tolerance = 0.99 * tolerance};
    bat_status status = BAT_TOLERANCE;
    for (int i = 0; i < TRIES && status == BAT_TOLERANCE; i++, w.tolerance *= 0.85) {
        double there = 0, back = 0;
        bat_curve *made = NULL;
        status = cover_all(&w);
        if (status == BAT_OK) status = assemble(&w, corner, &made);
        if (status == BAT_OK) status = bat_curve_distance(curve, made, CHECKED, &there, &back);
        *error = fmax(there, back);
        if (status == BAT_OK && *error > tolerance) status = BAT_TOLERANCE;
        if (status == BAT_OK)
            *out = made;
        else
            bat_curve_free(made);
    }
    bat_hermite_free(&w.h);
    free(w.points), free(w.from);
    return status;
}

bat_status bat_curve_refit_g1(const bat_curve *curve, double tolerance, double corner, bat_curve **out,
                              double *error) {
    if (!curve || !out || !(tolerance >= 0) || !isfinite(tolerance) || !(corner >= 0)) return BAT_ARGUMENT;
    corner = fmax(corner, ROUNDING);
    bat_curve *fewer = NULL, *again = NULL;
    double kept = 0, worst = 0;
    bat_status status = bat_curve_simplify(curve, tolerance, corner, &fewer, &kept);
    if (status != BAT_OK) return status;
    if (tolerance > 0) {
        chain q;
        status = read_chain(curve, 0.05 * tolerance, corner, &q);
        if (status == BAT_OK && q.count > 0) status = covered(curve, &q, tolerance, corner, &again, &worst);
        free_chain(&q);
    }
    if (status == BAT_MEMORY) {
        bat_curve_free(fewer);
        return status;
    }
    const bool better = again && (curve->degree > 3 ||
                                  bat_curve_segment_count(again) < bat_curve_segment_count(fewer));
    *out = better ? again : fewer;
    if (error) *error = better ? worst : kept;
    bat_curve_free(better ? fewer : again);
    return BAT_OK;
}
