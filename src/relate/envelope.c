#include "relate/envelope.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>

double bat_reach_at(const bat_reach *r, double angle) {
    const double x = bat_cos(angle), y = bat_sin(angle), along = r->x * x + r->y * y;
    if (r->kind == BAT_REACH_NONE) return -INFINITY;
    if (r->kind == BAT_REACH_LINE) return along * r->d > 0 ? r->d / along : -INFINITY;
    const double off = r->x * y - r->y * x;
    return along + sqrt(1 - off * off);
}

static double direction(double x, double y) {
    const double angle = bat_atan2(y, x);
    return angle < 0 ? angle + 2 * BAT_PI : angle;
}

/* Where a circle meets a line. */
static int disk_and_line(const bat_reach *disk, const bat_reach *line, double out[2]) {
    const double far = line->d - (disk->x * line->x + disk->y * line->y);
    if (!(far * far < 1)) return 0;
    const double along = sqrt(1 - far * far), x = disk->x + far * line->x, y = disk->y + far * line->y;
    out[0] = direction(x - along * line->y, y + along * line->x);
    out[1] = direction(x + along * line->y, y - along * line->x);
    return 2;
}

static int lines(const bat_reach *a, const bat_reach *b, double out[2]) {
    const double det = a->x * b->y - a->y * b->x;
    if (det == 0) return 0;
    out[0] = direction((a->d * b->y - b->d * a->y) / det, (b->d * a->x - a->d * b->x) / det);
    return 1;
}

static int disks(const bat_reach *a, const bat_reach *b, double out[2]) {
    const double d[2] = {b->x - a->x, b->y - a->y}, apart = bat_hypot(d[0], d[1]);
    const double up = sqrt(1 - 0.25 * apart * apart);
    if (!(apart > 0)) return 0;
    for (int k = 0; k < 2; k++) {
        const double side = k ? up : -up;
        out[k] = direction(0.5 * (a->x + b->x) - side * d[1] / apart,
                           0.5 * (a->y + b->y) + side * d[0] / apart);
    }
    return 2;
}

/* The directions of the places where two edges cross, ascending within a turn; returns how many. */
static int crossings(const bat_reach *a, const bat_reach *b, double out[2]) {
    int count = 0;
    if (a->kind == BAT_REACH_DISK && b->kind == BAT_REACH_DISK) count = disks(a, b, out);
    if (a->kind == BAT_REACH_DISK && b->kind == BAT_REACH_LINE) count = disk_and_line(a, b, out);
    if (a->kind == BAT_REACH_LINE && b->kind == BAT_REACH_DISK) count = disk_and_line(b, a, out);
    if (a->kind == BAT_REACH_LINE && b->kind == BAT_REACH_LINE) count = lines(a, b, out);
    if (count == 2 && out[0] > out[1]) {
        const double first = out[1];
        out[1] = out[0], out[0] = first;
    }
    return count;
}

static bool same(const bat_reach *a, const bat_reach *b) {
    return a->kind == b->kind && a->x == b->x && a->y == b->y && a->d == b->d;
}

static void put(bat_envelope *e, double from, const bat_reach *r) {
    if (e->count && same(&e->list[e->count - 1], r)) return;
    if (e->count == e->room) {
        e->full = true;
        return;
    }
    e->list[e->count] = *r;
    e->list[e->count].from = from;
    if (e->count++) e->list[e->count - 2].to = from;
    e->list[e->count - 1].to = 2 * BAT_PI;
}

/* What of two edges reaches furthest between two directions. */
static void put_further(bat_envelope *e, const bat_reach *a, const bat_reach *b, double from, double to) {
    double cuts[4] = {from, to, to, to}, at[2];
    int count = 1;
    if (!same(a, b))
        for (int k = 0, n = crossings(a, b, at); k < n; k++)
            if (at[k] > cuts[count - 1] && at[k] < to) cuts[count++] = at[k];
    for (int k = 0; k < count; k++) {
        const double end = k + 1 < count ? cuts[k + 1] : to, middle = 0.5 * (cuts[k] + end);
        put(e, cuts[k], bat_reach_at(a, middle) >= bat_reach_at(b, middle) ? a : b);
    }
}

static void merge(const bat_envelope *a, const bat_envelope *b, bat_envelope *out) {
    size_t i = 0, k = 0;
    double from = 0;
    out->count = 0, out->full = a->full || b->full;
    while (from < 2 * BAT_PI) {
        const double next_a = i + 1 < a->count ? a->list[i + 1].from : 2 * BAT_PI,
                     next_b = k + 1 < b->count ? b->list[k + 1].from : 2 * BAT_PI;
        const double to = fmin(next_a, next_b);
        if (from < to) put_further(out, &a->list[i], &b->list[k], from, to);
        i += next_a == to && i + 1 < a->count, k += next_b == to && k + 1 < b->count;
        from = to;
    }
}

/* Of n edges of parts of circles there are some 2 n pieces, and 2 n ends; as many again, as rounding may cut finer. */
static size_t room_for(size_t n) { return 8 * n + 4; }

static void one(const bat_reach *r, bat_envelope *out) {
    const bat_reach none = {0};
    out->count = 0, out->full = false;
    if (r->from > 0) put(out, 0, &none);
    put(out, r->from, r);
    if (r->to < 2 * BAT_PI) put(out, r->to, &none);
}

/* rest: scratch for two envelopes of all, and 64 more of one. */
static void envelop(const bat_reach *elements, size_t n, bat_envelope *out, bat_reach *rest) {
    if (n == 1) {
        one(elements, out);
        return;
    }
    const size_t left = n / 2;
    bat_envelope a = {.room = room_for(left), .list = rest},
                 b = {.room = room_for(n - left), .list = rest + room_for(left)};
    rest = b.list + b.room;
    envelop(elements, left, &a, rest);
    envelop(elements + left, n - left, &b, rest);
    merge(&a, &b, out);
}

bat_status bat_envelope_of(const bat_reach *elements, size_t n, bat_envelope *out) {
    bat_reach *list = malloc(room_for(n) * sizeof *list);
    bat_reach *rest = malloc((2 * room_for(n) + 64 * room_for(1)) * sizeof *rest);
    bat_envelope all = {.room = room_for(n), .list = list};
    if (list && rest) envelop(elements, n, &all, rest);
    free(rest);
    if (!list || !rest || all.full) {
        free(list);
        return list && rest ? BAT_COUNT : BAT_MEMORY;
    }
    *out = all;
    return BAT_OK;
}
