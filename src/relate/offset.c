/* The raw offset: each span halved until one cubic fits the parallel of it, by least squares in its two handles after Levien
 * 2022 (docs/math/relate.md 5). */
#include "relate/offset.h"

#include "base/real.h"
#include "curve/curve.h"
#include "relate/segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 8, BETWEEN = 12, ROUNDS = 4, DEPTH_MAX = 20, ROUND_MAX = 64, CUBICS_MAX = 1 << 18 };

static const double BACK = 3.1406; /* radians: a turn of half a turn, but for little */
static const double STILL = 1e-7;  /* of a piece's size: slower at an end, its tangent is noise */
static const double STEADY = 0.5;  /* cosine of the turn between two samples */
static const double SMALL = 1e-3;  /* tolerances: what is left of a cusp */

/* What has been made up to now ends at `end`, with the tangent there; `first` and `start`: where it began. */
typedef struct parallel {
    double distance, tolerance, corner;
    bat_chain *chain;
    bat_brim *brim; /* NULL: round */
    double way;     /* -1: along the reversed curve */
    bool around;    /* the end of the curve lies before what comes next */
    double end[2], tangent[2], start[2], first[2];
} parallel;

bat_status bat_chain_add(bat_chain *chain, const double cubic[8]) {
    if (chain->count == chain->room) {
        if (chain->room >= CUBICS_MAX) return BAT_COUNT;
        const int room = 2 * chain->room + 32;
        double *more = realloc(chain->points, (size_t)(6 * room + 2) * sizeof *more);
        if (!more) return BAT_MEMORY;
        chain->points = more, chain->room = room;
    }
    double *at = chain->points + 6 * chain->count;
    if (chain->count == 0) at[0] = cubic[0], at[1] = cubic[1];
    memcpy(at + 2, cubic + 2, 6 * sizeof *at);
    chain->count++;
    return BAT_OK;
}

/* Point, unit tangent and signed speed of the parallel at share x of a segment: (1 - k d) |C'|. */
static void at(const bat_segment *s, double x, double distance, double *point, double *t, double *speed) {
    const int p = s->degree;
    double d[(BAT_DEGREE_MAX + 1) * 2], first[2] = {0}, second[2] = {0};
    memcpy(d, s->b, (size_t)(2 * (p + 1)) * sizeof *d);
    for (int r = p; r > 0; r--) {
        for (int c = 0; c < 2 && r == 2; c++) second[c] = (d[4 + c] - 2 * d[2 + c] + d[c]) * p * (p - 1);
        for (int c = 0; c < 2 && r == 1; c++) first[c] = (d[2 + c] - d[c]) * p;
        for (int i = 0; i < 2 * r; i++) d[i] += x * (d[i + 2] - d[i]);
    }
    double v = bat_hypot(first[0], first[1]);
    if (v > 0) {
        t[0] = first[0] / v, t[1] = first[1] / v;
    } else {
        t[0] = 1, t[1] = 0;
    }
    const double bend = v > 0 ? (t[0] * second[1] - t[1] * second[0]) / v : 0; /* k |C'| */
    *speed = v - bend * distance;
    point[0] = d[0] - distance * t[1], point[1] = d[1] + distance * t[0];
}

/* The same at an end of a segment; where the curve all but stands still there, the tangent points to the first control point
 * that is not in the same place. */
static void at_end(const bat_segment *s, int end, double distance, double *point, double *t, double *speed) {
    at(s, end, distance, point, t, speed);
    const int p = s->degree, sign = end ? -1 : 1;
    const double *x = s->b + (size_t)2 * (size_t)(end ? p : 0), still = STILL * bat_segment_reach(s);
    for (int k = 1; k <= p; k++) {
        const double d[2] = {sign * (x[2 * sign * k] - x[0]), sign * (x[2 * sign * k + 1] - x[1])},
                     length = bat_hypot(d[0], d[1]);
        if (!(length > still)) continue;
        if (k == 1) return;
        t[0] = d[0] / length, t[1] = d[1] / length;
        point[0] = x[0] - distance * t[1], point[1] = x[1] + distance * t[0];
        return;
    }
}

static void cubic_at(const double *b, double x, double *point, double *first) {
    for (int c = 0; c < 2; c++) {
        const double p0 = b[c], p1 = b[2 + c], p2 = b[4 + c], p3 = b[6 + c], y = 1 - x;
        point[c] = y * y * y * p0 + 3 * y * y * x * p1 + 3 * y * x * x * p2 + x * x * x * p3;
        first[c] = 3 * (y * y * (p1 - p0) + 2 * y * x * (p2 - p1) + x * x * (p3 - p2));
    }
}

/* The squared distance from a sample to a cubic at parameter x, which steps bring nearer while it is above `enough`. */
static double step_near(const double *cubic, const double *sample, double *x, int steps, double enough) {
    double point[2], first[2];
    for (int i = 0;; i++) {
        cubic_at(cubic, *x, point, first);
        const double d[2] = {sample[0] - point[0], sample[1] - point[1]}, far = d[0] * d[0] + d[1] * d[1];
        const double square = first[0] * first[0] + first[1] * first[1];
        if (i == steps || far <= enough || !(square > 0)) return far;
        *x = fmin(fmax(*x + (d[0] * first[0] + d[1] * first[1]) / square, 0), 1);
    }
}

/* Whether a cubic is within the tolerance between the samples, too. */
static bool holds_between(const parallel *p, const bat_segment *s, const double *cubic) {
    const double square = p->tolerance * p->tolerance;
    for (int k = 0; k < BETWEEN; k++) {
        double x = (k + 0.5) / BETWEEN, sample[2], t[2], speed;
        at(s, x, p->distance, sample, t, &speed);
        if (!(step_near(cubic, sample, &x, 2 * ROUNDS, square) <= square)) return false;
    }
    return true;
}

/* The handles' lengths by least squares, with the samples' parameters brought nearer each time; returns the greatest
 * distance left. */
static double fit(const double *samples, const double *s, const double *t, const double *handles,
                  double tolerance, double *cubic) {
    double x[SAMPLES + 1], a = handles[0], b = handles[1], worst = INFINITY;
    for (int k = 0; k <= SAMPLES; k++) x[k] = (double)k / SAMPLES;
    for (int round = 0; round < ROUNDS; round++) {
        for (int c = 0; c < 2; c++)
            cubic[2 + c] = cubic[c] + a * s[c], cubic[4 + c] = cubic[6 + c] - b * t[c];
        double aa = 0, ab = 0, bb = 0, ra = 0, rb = 0;
        worst = 0;
        for (int k = 1; k < SAMPLES; k++) {
            double point[2], first[2];
            worst = fmax(worst, step_near(cubic, samples + (size_t)2 * (size_t)k, &x[k], 2, 0));
            cubic_at(cubic, x[k], point, first);
            const double gap[2] = {samples[2 * k] - point[0], samples[2 * k + 1] - point[1]},
                         v = sqrt(first[0] * first[0] + first[1] * first[1]);
            if (!(v > 0)) continue;
            const double n[2] = {-first[1] / v, first[0] / v}, y = 1 - x[k];
            const double ja = 3 * y * y * x[k] * (s[0] * n[0] + s[1] * n[1]),
                         jb = -3 * y * x[k] * x[k] * (t[0] * n[0] + t[1] * n[1]);
            const double r = gap[0] * n[0] + gap[1] * n[1];
            aa += ja * ja, ab += ja * jb, bb += jb * jb, ra += ja * r, rb += jb * r;
        }
        worst = sqrt(worst);
        if (worst <= tolerance || round + 1 == ROUNDS) break;
        const double det = aa * bb - ab * ab;
        if (!(det > 1e-12 * aa * bb)) break;
        a += (ra * bb - rb * ab) / det, b += (rb * aa - ra * ab) / det;
    }
    double length = 0; /* a cubic with longer handles is no parallel, whatever lies near it */
    for (int k = 0; k < SAMPLES; k++)
        length += bat_hypot(samples[2 * k + 2] - samples[2 * k], samples[2 * k + 3] - samples[2 * k + 1]);
    const bool fits = fabs(a) <= length && fabs(b) <= length;
    return fits && a * handles[0] >= 0 && b * handles[1] >= 0 ? worst : INFINITY;
}

static bat_status straight(bat_chain *chain, const double *from, const double *to) {
    double cubic[8];
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 2; c++) cubic[2 * k + c] = from[c] + (to[c] - from[c]) * k / 3;
    return bat_chain_add(chain, cubic);
}

/* Round the corner at `centre`, by `turn` radians, in as many cubics as keep the tolerance: one of an angle w is w^6 / 18,000
 * radii away at most. */
static bat_status round_off(const parallel *p, const double *centre, const double *t, double turn) {
    const double radius = fabs(p->distance);
    int n = 1;
    for (; n < ROUND_MAX; n++) {
        const double square = turn / n * (turn / n);
        if (square <= 0.25 * BAT_PI * BAT_PI && radius * square * square * square <= 18000 * p->tolerance)
            break;
    }
    for (int k = 0; k < n; k++) {
        const double w = turn / n, handle = 4.0 / 3 * bat_tan(0.25 * w) * p->distance;
        double cubic[8], d[2][2];
        for (int e = 0; e < 2; e++) {
            const double angle = turn * (k + e) / n, x = bat_cos(angle), y = bat_sin(angle);
            d[e][0] = t[0] * x - t[1] * y, d[e][1] = t[0] * y + t[1] * x;
            cubic[6 * e] = centre[0] - p->distance * d[e][1],
                      cubic[6 * e + 1] = centre[1] + p->distance * d[e][0];
        }
        /* the circle is followed against its tangent when the corner opens on the right */
        for (int c = 0; c < 2; c++)
            cubic[2 + c] = cubic[c] - handle * d[0][c], cubic[4 + c] = cubic[6 + c] + handle * d[1][c];
        const bat_status status = bat_chain_add(p->chain, cubic);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

/* ---- corners and ends that are not round ---- */

static void put_line(bat_patch *patch, double x, double y, double far) {
    double *line = patch->lines[patch->count++];
    line[0] = x, line[1] = y, line[2] = far;
}

/* A straight way from the end of what has been made, over up to two places, to a point. */
static bat_status by_way_of(const parallel *p, int count, double places[2][2], const double *point) {
    bat_status status = BAT_OK;
    const double *from = p->end;
    for (int i = 0; i < count && status == BAT_OK; i++)
        status = straight(p->chain, from, places[i]), from = places[i];
    return status == BAT_OK ? straight(p->chain, from, point) : status;
}

/* The end of an open curve, butt or square, from the tangent s there. */
static bat_status make_end(const parallel *p, double u, const double *centre, const double *point) {
    const double *s = p->tangent, far = fabs(p->distance), out = p->brim->cap == BAT_CAP_SQUARE ? far : 0;
    bat_patch patch = {.u = p->way * u, .point = {centre[0], centre[1]}};
    double places[2][2] = {{p->end[0] + out * s[0], p->end[1] + out * s[1]},
                           {point[0] + out * s[0], point[1] + out * s[1]}};
    put_line(&patch, s[0], s[1], out);
    put_line(&patch, -s[1], s[0], far);
    put_line(&patch, s[1], -s[0], far);
    const bat_status status = bat_brim_add(p->brim, &patch);
    return status == BAT_OK ? by_way_of(p, out > 0 ? 2 : 0, places, point) : status;
}

/* A corner that opens by `turn`, mitred as far as the limit goes, or bevelled. */
static bat_status make_corner(const parallel *p, double u, const double *centre, const double *point,
                              const double *t, double turn) {
    const double *s = p->tangent, side = copysign(1, p->distance), far = fabs(p->distance);
    const double cosine = fmax(bat_cos(0.5 * turn), 0);
    double m[2] = {-side * (s[1] + t[1]), side * (s[0] + t[0])};
    const double length = bat_hypot(m[0], m[1]);
    bat_patch patch = {.u = p->way * u, .point = {centre[0], centre[1]}};
    if (fabs(turn) > BACK || !(length > 0)) {
        m[0] = s[0], m[1] = s[1];
    } else {
        m[0] /= length, m[1] /= length;
    }
    put_line(&patch, -side * s[1], side * s[0], far);
    put_line(&patch, -side * t[1], side * t[0], far);
    const bool mitre = p->brim->join == BAT_JOIN_MITER && p->brim->miter_limit * cosine >= 1;
    if (!mitre) put_line(&patch, m[0], m[1], far * cosine);
    bat_status status = bat_brim_add(p->brim, &patch);
    if (status != BAT_OK) return status;
    double tip[2][2] = {{0}};
    for (int k = 0; k < 2 && mitre; k++) tip[0][k] = centre[k] + far / cosine * m[k];
    return by_way_of(p, mitre, tip, point);
}

/* From the end of what has been made to a place of the parallel around `centre`, where the curve goes on at u. A curve that
 * turns back has its outside on both sides. */
static bat_status reach_out(const parallel *p, double u, const double *centre, const double *point,
                            const double *t) {
    const double *s = p->tangent;
    double turn = bat_atan2(s[0] * t[1] - s[1] * t[0], s[0] * t[0] + s[1] * t[1]);
    const double gap = bat_hypot(p->end[0] - point[0], p->end[1] - point[1]);
    if (fabs(turn) <= p->corner && gap <= 0.1 * p->tolerance) return BAT_OK;
    if (fabs(turn) > BACK) turn = copysign(turn, -p->distance);
    if (!(turn * p->distance < 0)) return straight(p->chain, p->end, point);
    if (p->brim && p->brim->join != BAT_JOIN_ROUND && fabs(turn) > p->corner)
        return make_corner(p, u, centre, point, t, turn);
    return round_off(p, centre, s, turn);
}

/* Around the end of an open curve. */
static bat_status reach_round(const parallel *p, double u, const double *centre, const double *point) {
    return p->brim && p->brim->cap != BAT_CAP_ROUND
               ? make_end(p, u, centre, point)
               : round_off(p, centre, p->tangent, copysign(BAT_PI, -p->distance));
}

/* Adds the parallel of a span; where it cannot be followed, at a cusp, the next one that can begins after a corner. */
static bat_status span(parallel *p, const bat_segment *s, int depth) {
    double samples[SAMPLES + 1][2], tangents[SAMPLES + 1][2], speeds[SAMPLES + 1];
    bool is_steady = true; /* one way, and no turn between samples is missed */
    for (int k = 0; k <= SAMPLES; k++) {
        if (k % SAMPLES)
            at(s, (double)k / SAMPLES, p->distance, samples[k], tangents[k], &speeds[k]);
        else
            at_end(s, k / SAMPLES, p->distance, samples[k], tangents[k], &speeds[k]);
        is_steady = is_steady && (k < 2 || k == SAMPLES || speeds[k] * speeds[1] > 0);
        is_steady = is_steady &&
                    (k == 0 ||
                     tangents[k - 1][0] * tangents[k][0] + tangents[k - 1][1] * tangents[k][1] > STEADY);
    }
    double cubic[8], handles[2] = {speeds[0] / 3, speeds[SAMPLES] / 3};
    memcpy(cubic, samples[0], 2 * sizeof *cubic), memcpy(cubic + 6, samples[SAMPLES], 2 * sizeof *cubic);
    const double turn = tangents[0][0] * tangents[SAMPLES][0] + tangents[0][1] * tangents[SAMPLES][1];
    if (is_steady && turn > -0.5 &&
        fit(samples[0], tangents[0], tangents[SAMPLES], handles, p->tolerance, cubic) <= p->tolerance &&
        holds_between(p, s, cubic)) {
        bat_status status = BAT_OK;
        if (p->chain->count)
            status = p->around ? reach_round(p, s->from, s->b, samples[0])
                               : reach_out(p, s->from, s->b, samples[0], tangents[0]);
        else
            memcpy(p->start, samples[0], sizeof p->start), memcpy(p->first, tangents[0], sizeof p->first);
        p->around = false;
        memcpy(p->end, samples[SAMPLES], sizeof p->end);
        memcpy(p->tangent, tangents[SAMPLES], sizeof p->tangent);
        return status == BAT_OK ? bat_chain_add(p->chain, cubic) : status;
    }
    bat_segment left, right;
    bat_segment_halve(s, &left, &right);
    if (depth == DEPTH_MAX || bat_segment_reach(s) < SMALL * p->tolerance ||
        !(left.from < left.to && right.from < right.to))
        return BAT_OK;
    const bat_status status = span(p, &left, depth + 1);
    return status == BAT_OK ? span(p, &right, depth + 1) : status;
}

/* The spans in order, or each reversed from the last to the first. */
static bat_status spans(parallel *p, const bat_segment *all, int count) {
    bat_status status = BAT_OK;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        bat_segment s = all[p->way > 0 ? i : count - 1 - i];
        if (!(bat_segment_reach(&s) > 0)) continue;
        if (p->way < 0) {
            const bat_segment *whole = &all[count - 1 - i];
            for (int k = 0; k <= s.degree; k++)
                memcpy(s.b + (size_t)2 * (size_t)k, whole->b + (size_t)2 * (size_t)(s.degree - k),
                       2 * sizeof *s.b);
            s.from = -whole->to, s.to = -whole->from;
        }
        status = span(p, &s, 0);
    }
    return status;
}

static bat_status raw(const bat_curve *curve, parallel *p, bool around) {
    bat_segment *all;
    int count;
    bat_status status = bat_segments_of(curve, &count, &all);
    if (status != BAT_OK) return status;
    p->way = 1;
    status = spans(p, all, count);
    if (status == BAT_OK && around && p->chain->count) {
        p->way = -1, p->around = true;
        status = spans(p, all, count);
        if (status == BAT_OK) status = reach_round(p, -all[0].from, all[0].b, p->start);
    }
    if (status == BAT_OK && bat_curve_is_closed(curve) && p->chain->count)
        status = reach_out(p, all[0].from, all[0].b, p->start, p->first);
    if (status == BAT_OK && (around || bat_curve_is_closed(curve)) && p->chain->count)
        memcpy(p->chain->points + 6 * p->chain->count, p->chain->points, 2 * sizeof *p->chain->points);
    free(all);
    return status;
}

bat_status bat_offset_raw(const bat_curve *curve, double distance, double tolerance, double corner,
                          bat_brim *brim, bat_chain *out) {
    parallel p = {.distance = distance, .tolerance = tolerance, .corner = corner, .chain = out, .brim = brim};
    return raw(curve, &p, false);
}

bat_status bat_offset_around(const bat_curve *curve, double distance, double tolerance, double corner,
                             bat_brim *brim, bat_chain *out) {
    parallel p = {.distance = distance, .tolerance = tolerance, .corner = corner, .chain = out, .brim = brim};
    return raw(curve, &p, true);
}
