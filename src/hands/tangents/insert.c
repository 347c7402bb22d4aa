/*
 * A point put on a G1 spline so that the shape stays. A cubic cut at t has derivatives t D and (1-t) D over its
 * halves; a joint of the faithful mode takes any direction, and tension makes its derivatives as long as asked, so
 * both halves come out exactly.
 */
#include <batten/bezier.h>
#include <batten/tangents.h>

#include "base/vec.h"
#include "hands/tangents/even_insert.h"
#include "hands/tangents/spline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The spline with room for one more point; arrays in one block. */
typedef struct draft {
    bat_spline spline;
    double *points, *tangents, *tension;
} draft;

static double *make_room(const bat_spline *s, int at, draft *out) {
    size_t count = s->count + 1, size = count * (size_t)s->dimension;
    double *block = calloc(2 * size + 2 * count, sizeof *block);
    if (!block) return NULL;
    *out = (draft){*s, block, block + size, block + 2 * size};
    for (int i = 0; i < bat_spline_count(s); i++) {
        int to = i < at ? i : i + 1;
        size_t bytes = (size_t)s->dimension * sizeof(double);
        memcpy(out->points + to * s->dimension, s->points + i * s->dimension, bytes);
        if (s->tangents) memcpy(out->tangents + to * s->dimension, s->tangents + i * s->dimension, bytes);
        for (int k = 0; k < 2; k++) out->tension[2 * to + k] = s->tension ? s->tension[2 * i + k] : 1;
    }
    out->tension[2 * at] = out->tension[2 * at + 1] = 1;
    out->spline.count = count;
    out->spline.points = out->points;
    out->spline.tangents = out->tangents;
    out->spline.tension = out->tension;
    return block;
}

/* What a joint is to have: its derivatives, and thereby its direction. */
typedef struct wish {
    int point; /* of the new spline; -1: none */
    vec left, right;
} wish;

static void store(vec v, int size, double *out) {
    double all[3];
    vec_store(v, all);
    memcpy(out, all, (size_t)size * sizeof(double));
}

/* Sets the direction of the wish; where a tension of zero has taken it away, the present tangent stays. */
static void fix_direction(draft *d, const wish *w) {
    int size = d->spline.dimension;
    vec longer = vec_norm(w->left) > vec_norm(w->right) ? w->left : w->right;
    if (vec_norm(longer) > 0) store(vec_unit(longer), size, d->tangents + w->point * size);
    d->tension[2 * w->point] = d->tension[2 * w->point + 1] = 1;
}

static double factor(vec wanted, const double *natural) {
    double length = vec_norm(vec_load(natural, 3));
    return length > 0 ? fmin(vec_norm(wanted) / length, 1e6) : 1;
}

static vec mix(vec a, vec b, double t) { return vec_add(vec_scale(a, 1 - t), vec_scale(b, t)); }

/* de Casteljau: the seven control points of both halves. */
static void cut(const vec p[4], double t, vec out[7]) {
    vec a = mix(p[0], p[1], t), b = mix(p[1], p[2], t), c = mix(p[2], p[3], t);
    vec d = mix(a, b, t), e = mix(b, c, t);
    out[0] = p[0], out[1] = a, out[2] = d, out[3] = mix(d, e, t), out[4] = e, out[5] = c, out[6] = p[3];
}

/* The points that segment `segment` runs between. */
static void ends_of(const bat_spline *s, const bat_joint *joints, int segment, int *first, int *second) {
    int kept = -1, start = -1;
    *second = -1;
    for (int i = 0; i < bat_spline_count(s); i++) {
        if (joints[i].dropped) continue;
        if (start < 0) start = i;
        kept++;
        if (kept == segment) *first = i;
        if (kept == segment + 1) *second = i;
    }
    if (*second < 0) *second = start; /* the last segment of a loop */
}

/* The next point that was kept, forwards or backwards; -1 past the end of an open spline. */
static int beside(const bat_spline *s, const bat_joint *joints, int i, int step) {
    for (int n = 0; n < bat_spline_count(s); n++) {
        i += step;
        if (s->closed) i = (i + bat_spline_count(s)) % bat_spline_count(s);
        if (i < 0 || i >= bat_spline_count(s)) return -1;
        if (!joints[i].dropped) return i;
    }
    return -1;
}

static wish as_it_is(const bat_joint *joints, int i, int at) {
    return (wish){i < at ? i : i + 1, vec_load(joints[i].left, 3), vec_load(joints[i].right, 3)};
}

static bool free_end(const bat_spline *s, const bat_joint *joints, int i) {
    return i >= 0 && !s->closed && (beside(s, joints, i, -1) < 0 || beside(s, joints, i, 1) < 0);
}

/* How far the control points of the segments lie from where they were: a bound on how far the curve moves. */
static double moved(const double *before, int segments, const double *after, int segment, const vec halves[7],
                    int size) {
    double most = 0;
    for (int i = 0; i < segments; i++)
        for (int j = 0; j < 4; j++) {
            vec now = vec_load(after + (4 * (i > segment ? i + 1 : i) + j) * size, size);
            if (i != segment) {
                most = fmax(most, vec_norm(vec_sub(now, vec_load(before + (4 * i + j) * size, size))));
                continue;
            }
            vec next = vec_load(after + (4 * (i + 1) + j) * size, size);
            most = fmax(most, vec_norm(vec_sub(now, halves[j])));
            most = fmax(most, vec_norm(vec_sub(next, halves[3 + j])));
        }
    return most;
}

/* The five joints that feel the new point: those of the segment, the new one, and free ends beside them. */
static int make_wishes(const bat_spline *s, const bat_joint *joints, int segment, double t,
                       const vec halves[7], wish out[5], int *at) {
    int first = 0, second = 0, count = 0;
    ends_of(s, joints, segment, &first, &second);
    *at = first + 1;
    wish a = as_it_is(joints, first, *at), b = as_it_is(joints, second, *at);
    int before = beside(s, joints, first, -1), after = beside(s, joints, second, 1);
    if (first == second) b = a; /* cannot be: two distinct points at least */
    a.right = vec_scale(a.right, t);
    b.left = vec_scale(b.left, 1 - t);
    out[count++] = a;
    out[count++] = (wish){*at, vec_scale(vec_sub(halves[3], halves[2]), 3),
                          vec_scale(vec_sub(halves[4], halves[3]), 3)};
    out[count++] = b;
    if (free_end(s, joints, before)) out[count++] = as_it_is(joints, before, *at);
    if (free_end(s, joints, after)) out[count++] = as_it_is(joints, after, *at);
    return count;
}

static bat_status fulfil(draft *d, const bat_tangents_options *options, const wish *wishes, int count) {
    bat_joint *joints = malloc(d->spline.count * sizeof *joints);
    if (!joints) return BAT_MEMORY;
    for (int i = 0; i < count; i++) fix_direction(d, &wishes[i]);
    bat_status status = bat_tangents(&d->spline, options, joints, NULL, NULL, NULL);
    for (int i = 0; i < count && status == BAT_OK; i++) {
        const wish *w = &wishes[i];
        if (joints[w->point].dropped) status = BAT_ARGUMENT; /* too near to another point */
        d->tension[2 * w->point] = factor(w->left, joints[w->point].left);
        d->tension[2 * w->point + 1] = factor(w->right, joints[w->point].right);
    }
    free(joints);
    return status;
}

bat_status bat_tangents_insert(const bat_spline *spline, int segment, double t,
                               const bat_tangents_options *options, bat_spline *out, void **block, int *index,
                               double *deviation) {
    if (!spline || !out || !block || !index || !(t > 0 && t < 1) || segment < 0) return BAT_ARGUMENT;
    if (spline->count < 2 || spline->count > BAT_POINTS_MAX / 4) return BAT_COUNT;
    bat_tangents_options chosen;
    bat_status known = bat_tangents_options_read(options, &chosen);
    if (known != BAT_OK) return known;
    if (chosen.mode == BAT_TANGENTS_EVEN)
        return bat_even_insert(spline, segment, t, &chosen, out, block, index, deviation);
    bat_joint *joints = malloc(spline->count * sizeof *joints);
    double *before = NULL, *after = NULL, *room = NULL;
    int segments = 0, more = 0, at = 0, size = spline->dimension;
    draft d;
    bat_status status = joints ? bat_tangents(spline, options, joints, &segments, &before, NULL) : BAT_MEMORY;
    if (status == BAT_OK && segment >= segments) status = BAT_ARGUMENT;
    if (status == BAT_OK) {
        vec cubic[4], halves[7];
        wish wishes[5];
        for (int j = 0; j < 4; j++) cubic[j] = vec_load(before + (4 * segment + j) * size, size);
        cut(cubic, t, halves);
        int count = make_wishes(spline, joints, segment, t, halves, wishes, &at);
        room = make_room(spline, at, &d);
        if (!room) status = BAT_MEMORY;
        if (status == BAT_OK) {
            store(halves[3], size, d.points + at * size);
            status = fulfil(&d, options, wishes, count);
        }
        if (status == BAT_OK) status = bat_tangents(&d.spline, options, NULL, &more, &after, NULL);
        if (status == BAT_OK && more != segments + 1) status = BAT_ARGUMENT;
        if (status == BAT_OK && deviation) *deviation = moved(before, segments, after, segment, halves, size);
    }
    if (status == BAT_OK) {
        *out = d.spline;
        *block = room;
        *index = at;
        room = NULL;
    }
    free(joints);
    free(room);
    bat_free(before);
    bat_free(after);
    return status;
}
