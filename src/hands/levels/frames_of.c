/* The frames of a shape's curves, as the curves alone give them (math 3.4). */
#include "hands/levels/shape.h"

#include "curve/frames_walk.h"

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

/* Room for one walk over the nodes of a level. */
typedef struct visit {
    bat_frame_walk walk;
    int *index;
    double *u, *lengths;
    vec *t, *s;
} visit;

static void visit_free(visit *v) {
    if (!v) return;
    free(v->index);
    free(v->u);
    free(v->lengths);
    free(v->t);
    free(v->s);
    free(v);
}

static visit *visit_new(size_t n) {
    visit *v = calloc(1, sizeof *v);
    if (!v) return NULL;
    v->index = malloc(n * sizeof(int));
    v->u = malloc(n * sizeof(double));
    v->lengths = malloc(n * sizeof(double));
    v->t = malloc(n * sizeof(vec));
    v->s = malloc(n * sizeof(vec));
    if (v->index && v->u && v->lengths && v->t && v->s) return v;
    visit_free(v);
    return NULL;
}

/* Gathers the nodes that ride on level `from`, ascending: they nearly are, except for those that a seam has
 * wrapped. */
static int gather(const bat_level *level, int from, visit *v) {
    int n = 0, least = 0;
    for (int i = 1; i < level->count; i++)
        if (level->nodes[i] < level->nodes[least]) least = i;
    for (int k = 0; k < level->count; k++) {
        int i = (least + k) % level->count, at = n;
        if (level->source[i] != from) continue;
        for (; at > 0 && v->u[at - 1] > level->nodes[i]; at--)
            v->u[at] = v->u[at - 1], v->index[at] = v->index[at - 1];
        v->u[at] = level->nodes[i], v->index[at] = i;
        n++;
    }
    return n;
}

bat_status bat_shape_frames_of(bat_shape *shape, int level, bat_triad *out) {
    const bat_level *at = &shape->levels[level - 1];
    if (shape->options.frame == BAT_FRAMES_FIXED) {
        for (int i = 0; i < at->count; i++) out[i] = (bat_triad){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        return BAT_OK;
    }
    visit *v = visit_new((size_t)at->count);
    if (!v) return BAT_MEMORY;
    for (int l = level - 1; l >= 0; l--) {
        int n = gather(at, l, v);
        if (n == 0) continue;
        const bat_curve *curve = bat_shape_curve_at(shape, l);
        bat_frame_options options = bat_shape_frame_options(&shape->options, shape->holonomy[l]);
        if (curve->dimension == 2 && options.rule == BAT_FRAMES_RMF) options.substeps = 1;
        bat_frame_walk_whole(&v->walk, curve, &options);
        vec first_t = v->walk.t, first_s = v->walk.s;
        int met = bat_frame_walk_along(&v->walk, n, v->u, v->t, v->s, v->lengths);
        while (bat_frame_walk_next(&v->walk)) {
        }
        if (v->walk.measured) {
            vec t = v->walk.t, s = v->walk.s;
            double angle = bat_frame_holonomy(first_t, first_s, t, s, options.holonomy_near);
            shape->holonomy[l] = angle;
            for (int i = 0; i < met && angle != 0 && v->walk.length > 0; i++)
                v->s[i] = vec_unit(vec_reject(
                    bat_turn_about(v->s[i], v->t[i], -angle * v->lengths[i] / v->walk.length), v->t[i]));
        }
        for (int i = 0; i < met; i++) out[v->index[i]] = bat_triad_of(shape, v->t[i], v->s[i]);
    }
    visit_free(v);
    return BAT_OK;
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
