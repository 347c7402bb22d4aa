/*
 * A stroke is what disks along its curve cover. Where the curve is far smaller than they, each of them sees the middle of all, and
 * the outline is in every direction the disk that reaches furthest: the upper envelope of functions of the angle of which any
 * two cross twice (Sharir and Agarwal 1995, Davenport-Schinzel sequences, 6.2), by dividing and merging.
 */
#include "relate/disks.h"

#include "base/real.h"
#include "curve/curve.h"
#include "relate/widen.h"

#include <batten/bezier.h>
#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DISKS_MAX = 1 << 20 };
static const double TINY = 1.0 / 64; /* of half the width: the curve's size */
/* Shares of the tolerance: of the polyline, of the notches between disks, of the arcs, of the removal of knots. */
static const double FLAT = 0.1, NOTCH = 0.2, ARC = 0.3, REMOVAL = 0.2;

/* From `angle` on, up to the next, the disk at (x, y) from the middle reaches furthest; in half widths, as all here. */
typedef struct reach {
    double angle, x, y;
} reach;

typedef struct envelope {
    size_t count,
        room; /* of n disks: 2 n at most, and the start; there is room for twice as many, as rounding may cut finer */
    reach *list;
} envelope;

bool bat_is_spot(const bat_curve *curve, const bat_nib *nib, double corner) {
    const double size = bat_curve_size(curve);
    if (!(size <= TINY * 0.5 * nib->width)) return false;
    if (!curve->closed && nib->cap != BAT_CAP_ROUND) return false;
    if (nib->join == BAT_JOIN_ROUND) return true;
    if (!(size > 0)) return !curve->closed; /* a dot */
    for (int i = curve->degree; i < curve->spread; i++)
        if (curve->knots[i] < curve->knots[i + 1] && (curve->closed || i > curve->degree) &&
            bat_curve_corner_at(curve, i, corner))
            return false;
    return true;
}

static double far_at(const reach *r, double angle) {
    const double x = bat_cos(angle), y = bat_sin(angle), off = r->x * y - r->y * x;
    return r->x * x + r->y * y + sqrt(1 - off * off);
}

/* The directions of the two places where two circles cross, ascending within a turn. */
static void crossings(const reach *a, const reach *b, double out[2]) {
    const double d[2] = {b->x - a->x, b->y - a->y}, apart = bat_hypot(d[0], d[1]);
    const double up = sqrt(1 - 0.25 * apart * apart);
    for (int k = 0; k < 2; k++) {
        const double side = k ? up : -up;
        out[k] = bat_atan2(0.5 * (a->y + b->y) + side * d[0] / apart,
                           0.5 * (a->x + b->x) - side * d[1] / apart);
        if (out[k] < 0) out[k] += 2 * BAT_PI;
    }
    if (out[0] > out[1]) {
        const double first = out[1];
        out[1] = out[0], out[0] = first;
    }
}

static void put(envelope *e, double angle, const reach *r) {
    reach *last = e->count ? &e->list[e->count - 1] : NULL;
    if (last && last->x == r->x && last->y == r->y) return;
    if (e->count < e->room) e->list[e->count++] = (reach){angle, r->x, r->y};
}

/* What of two disks reaches furthest between two angles. */
static void put_further(envelope *e, const reach *a, const reach *b, double from, double to) {
    double cuts[4] = {from, to, to, to}, at[2];
    int count = 1;
    if (a->x != b->x || a->y != b->y) {
        crossings(a, b, at);
        for (int k = 0; k < 2; k++)
            if (at[k] > cuts[count - 1] && at[k] < to) cuts[count++] = at[k];
    }
    for (int k = 0; k < count; k++) {
        const double end = k + 1 < count ? cuts[k + 1] : to, middle = 0.5 * (cuts[k] + end);
        put(e, cuts[k], far_at(a, middle) >= far_at(b, middle) ? a : b);
    }
}

static void merge(const envelope *a, const envelope *b, envelope *out) {
    size_t i = 0, k = 0;
    double from = 0;
    out->count = 0;
    while (from < 2 * BAT_PI) {
        const double next_a = i + 1 < a->count ? a->list[i + 1].angle : 2 * BAT_PI,
                     next_b = k + 1 < b->count ? b->list[k + 1].angle : 2 * BAT_PI;
        const double to = fmin(next_a, next_b);
        if (from < to) put_further(out, &a->list[i], &b->list[k], from, to);
        i += next_a == to && i + 1 < a->count, k += next_b == to && k + 1 < b->count;
        from = to;
    }
}

static size_t room_for(size_t n) { return 4 * n + 4; }

/* The envelope of n >= 1 disks. rest: scratch for room_for(n) + room_for(1) more, and as many again. */
static void envelop(const reach *disks, size_t n, envelope *out, reach *rest) {
    if (n == 1) {
        out->count = 1;
        out->list[0] = (reach){0, disks[0].x, disks[0].y};
        return;
    }
    const size_t left = n / 2;
    envelope a = {0, room_for(left), rest}, b = {0, room_for(n - left), rest + room_for(left)};
    rest = b.list + b.room;
    envelop(disks, left, &a, rest);
    envelop(disks + left, n - left, &b, rest);
    merge(&a, &b, out);
}

/* Disks along a polyline, so near to each other that the notches between them are not seen. */
static bat_status place_disks(size_t count, double *points, const double middle[2], double half, double step,
                              size_t *n, reach **out) {
    for (size_t i = 0; i < 2 * count; i++) points[i] = (points[i] - middle[i % 2]) / half;
    double most = 1;
    for (size_t i = 1; i < count; i++)
        most += fmax(
            ceil(bat_hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]) / step),
            1);
    if (!(most <= DISKS_MAX)) return BAT_COUNT;
    reach *disks = malloc((size_t)most * sizeof *disks);
    if (!disks) return BAT_MEMORY;
    *n = 0;
    for (size_t i = 0; i < count; i++) {
        const double *to = points + 2 * i, *from = i ? to - 2 : to;
        const int parts = (int)fmax(ceil(bat_hypot(to[0] - from[0], to[1] - from[1]) / step), 1);
        for (int k = i ? 1 : parts; k <= parts; k++) {
            const double share = (double)k / parts;
            disks[(*n)++] = (reach){0, from[0] + share * (to[0] - from[0]),
                                    from[1] + share * (to[1] - from[1])};
        }
    }
    *out = disks;
    return BAT_OK;
}

static void trace(const envelope *e, const double middle[2], double half, double tolerance,
                  bat_border *border) {
    for (size_t i = 0; i < e->count; i++) {
        const reach *r = &e->list[i];
        const double centre[2] = {middle[0] + half * r->x, middle[1] + half * r->y};
        double ends[2];
        for (int k = 0; k < 2; k++) {
            const double angle = k == 0 ? r->angle : i + 1 < e->count ? e->list[i + 1].angle : 2 * BAT_PI;
            const double far = far_at(r, angle), x = far * bat_cos(angle), y = far * bat_sin(angle);
            ends[k] = bat_atan2(y - r->y, x - r->x);
            if (i > 0 || k > 0) continue;
            const double start[2] = {middle[0] + half * x, middle[1] + half * y};
            bat_border_move(border, start);
        }
        double turn = ends[1] - ends[0]; /* of several disks none has more than half a turn */
        turn -= 2 * BAT_PI * rint(turn / (2 * BAT_PI));
        if (turn < -1) turn += 2 * BAT_PI;
        if (e->count == 1) turn = 2 * BAT_PI;
        if (turn > 0) bat_border_arc(border, centre, turn, tolerance);
    }
}

static bat_status curve_of(bat_border *border, double corner, double removal, bat_curve **out) {
    const size_t count = border->count;
    if (count == 0 || !border->points) return BAT_COUNT;
    double *points = malloc((6 * count + 2) * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, border->points, 2 * sizeof *points);
    for (size_t i = 0; i < count; i++)
        memcpy(points + 2 + 6 * i, border->points + 8 * i + 2, 6 * sizeof *points);
    memcpy(points + 6 * count, points, 2 * sizeof *points); /* no gap by rounding */
    const bat_status status = bat_curve_from_bezier(2, 3, true, (int)count, points, corner, removal, out,
                                                    NULL);
    free(points);
    return status;
}

bat_status bat_spot_outline(const bat_curve *curve, double half, double tolerance, double corner,
                            bat_curve **out, double *error) {
    double *points = NULL, low[2], high[2];
    size_t count = 0, n = 0;
    reach *disks = NULL, *room = NULL;
    bat_status status = bat_curve_flatten(curve, FLAT * tolerance, &count, &points, NULL);
    if (status != BAT_OK) return status;
    bat_curve_bounds(curve, low, high);
    const double middle[2] = {0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1]};
    status = place_disks(count, points, middle, half, sqrt(8 * NOTCH * (tolerance / half)), &n, &disks);
    bat_free(points);
    if (status == BAT_OK && !(room = malloc((3 * room_for(n) + 64 * room_for(1)) * sizeof *room)))
        status = BAT_MEMORY;
    bat_border border = {0};
    if (status == BAT_OK) {
        envelope all = {0, room_for(n), room};
        envelop(disks, n, &all, room + all.room);
        trace(&all, middle, half, ARC * tolerance, &border);
        status = border.status;
    }
    free(disks), free(room);
    if (status == BAT_OK) status = curve_of(&border, corner, REMOVAL * tolerance, out);
    bat_border_free(&border);
    if (status == BAT_OK) *error = (FLAT + NOTCH + ARC + REMOVAL) * tolerance;
    return status;
}
