/* The frames of a shape's curves, as the curves alone give them (math 3.4). */
#include "hands/levels/shape.h"

#include "curve/frames/along.h"
#include "curve/frames/turn.h"

#include <stdlib.h>
#include <string.h>

bat_frame_options bat_shape_frame_options(const bat_shape_options *o, double holonomy_near) {
    bat_frame_options frames = {.size = sizeof frames,
                                .rule = o->frame,
                                .has_first = o->has_first,
                                .has_reference = o->has_reference,
                                .holonomy_near = holonomy_near};
    memcpy(frames.first, o->first, sizeof frames.first);
    memcpy(frames.reference_t, o->reference_t, sizeof frames.reference_t);
    memcpy(frames.reference_s, o->reference_s, sizeof frames.reference_s);
    return frames;
}

/* One walk along a curve, which meets the nodes of a level. */
typedef struct visit {
    bat_frame_walk walk;
    const bat_shape *shape;
    bat_level *level;
    bool fold, moved;
    const double
        *u; /* the nodes that ride on the curve, ascending: those of the level, or a list of their own */
    int *index, n; /* which they are; NULL: all, in order */
    double *sorted;
    vec *t, *s; /* frames that a loop turns back when its length is known; NULL: they are taken at once */
    double *lengths;
} visit;

static void visit_free(visit *v) {
    if (!v) return;
    free(v->index);
    free(v->sorted);
    free(v->lengths);
    free(v->t);
    free(v->s);
    free(v);
}

static bool none_rides(const bat_level *level, int from) {
    for (int i = 0; i < level->count; i++)
        if (level->source[i] == from) return false;
    return true;
}

static bool all_in_order(const bat_level *level, int from) {
    for (int i = 0; i < level->count; i++)
        if (level->source[i] != from || (i > 0 && !(level->nodes[i - 1] <= level->nodes[i]))) return false;
    return true;
}

/* Gathers the nodes that ride on level `from`, ascending: they nearly are, except for those that a seam has
 * wrapped. */
static bat_status gather(visit *v, int from) {
    const bat_level *level = v->level;
    const size_t room = (size_t)level->count;
    v->n = 0;
    if (none_rides(level, from)) return BAT_OK;
    if (all_in_order(level, from)) {
        v->u = level->nodes, v->n = level->count;
        return BAT_OK;
    }
    if (!v->index) v->index = malloc(room * sizeof(int));
    if (!v->sorted) v->sorted = malloc(room * sizeof(double));
    if (!v->index || !v->sorted) return BAT_MEMORY;
    int n = 0, least = 0;
    for (int i = 1; i < level->count; i++)
        if (level->nodes[i] < level->nodes[least]) least = i;
    for (int k = 0; k < level->count; k++) {
        int i = (least + k) % level->count, at = n;
        if (level->source[i] != from) continue;
        for (; at > 0 && v->sorted[at - 1] > level->nodes[i]; at--)
            v->sorted[at] = v->sorted[at - 1], v->index[at] = v->index[at - 1];
        v->sorted[at] = level->nodes[i], v->index[at] = i;
        n++;
    }
    v->u = v->sorted, v->n = n;
    return BAT_OK;
}

static void take(visit *v, int k, vec t, vec s) {
    const int i = v->index ? v->index[k] : k;
    const bat_triad fresh = bat_triad_of(v->shape, t, s);
    bat_triad *frame = &v->level->frames[i];
    if (v->fold)
        v->moved = bat_triad_turn_back(frame, &fresh, v->level->details + 3 * (ptrdiff_t)i) || v->moved;
    *frame = fresh;
}

static void meet(void *context, int k, vec t, vec s) {
    visit *v = context;
    if (v->t)
        v->t[k] = t, v->s[k] = s;
    else
        take(v, k, t, s);
}

/* The frames of a loop, each turned back by its share of what does not close. */
static void turn_back(visit *v, int met, double angle) {
    const double whole = v->walk.length;
    for (int i = 0; i < met; i++) {
        vec t = v->t[i], s = v->s[i];
        if (angle != 0 && whole > 0)
            s = vec_unit(vec_reject(bat_turn_about(s, t, -angle * v->lengths[i] / whole), t));
        take(v, i, t, s);
    }
}

/* The frames of all nodes that ride on level `from`. */
static bat_status ride(visit *v, int from, double *holonomy) {
    bat_status status = gather(v, from);
    if (status != BAT_OK || v->n == 0) return status;
    const bat_curve *curve = bat_shape_curve_at(v->shape, from);
    bat_frame_options options = bat_shape_frame_options(&v->shape->options, *holonomy);
    if (curve->dimension == 2 && options.rule == BAT_FRAMES_RMF) options.substeps = 1;
    bat_frame_walk_whole(&v->walk, curve, &options);
    if (v->walk.measured && !v->t) {
        const size_t n = (size_t)v->level->count;
        v->lengths = malloc(n * sizeof(double));
        v->t = malloc(n * sizeof(vec));
        v->s = malloc(n * sizeof(vec));
        if (!v->lengths || !v->t || !v->s) return BAT_MEMORY;
    }
    vec first_t = v->walk.t, first_s = v->walk.s;
    int met = bat_frame_walk_along(&v->walk, v->n, v->u, meet, v, v->lengths);
    if (!v->walk.measured) return BAT_OK;
    while (bat_frame_walk_next(&v->walk)) {
    }
    *holonomy = bat_frame_holonomy(first_t, first_s, v->walk.t, v->walk.s, options.holonomy_near);
    turn_back(v, met, *holonomy);
    return BAT_OK;
}

bat_status bat_shape_frames_of(bat_shape *shape, int level, bool *folded) {
    bat_level *at = &shape->levels[level - 1];
    if (folded) *folded = false;
    if (shape->options.frame == BAT_FRAMES_FIXED) {
        for (int i = 0; i < at->count; i++) at->frames[i] = (bat_triad){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        return BAT_OK;
    }
    visit *v = calloc(1, sizeof *v);
    if (!v) return BAT_MEMORY;
    v->shape = shape, v->level = at, v->fold = folded != NULL;
    bat_status status = BAT_OK;
    for (int l = level - 1; l >= 0 && status == BAT_OK; l--) status = ride(v, l, &shape->holonomy[l]);
    if (folded) *folded = v->moved;
    visit_free(v);
    return status;
}

bool bat_triad_turn_back(const bat_triad *old, const bat_triad *fresh, double *d) {
    if (memcmp(old, fresh, sizeof *old) == 0) return false;
    double c = vec_dot(fresh->s, old->s), s = vec_dot(fresh->r, old->s), n = bat_hypot(c, s);
    if (!(n > 0)) return false;
    c /= n, s /= n;
    double b = c * d[1] - s * d[2];
    d[2] = s * d[1] + c * d[2];
    d[1] = b;
    return true;
}
