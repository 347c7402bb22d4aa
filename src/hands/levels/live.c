/* Edits of a shape while the pen is down. */
#include "hands/levels/shape.h"

#include "curve/curve.h"

#include <stdlib.h>

enum { FINEST_STEPS = 20 };

struct bat_shape_live {
    int level;
    bat_shape *shape, *before; /* before: made when an edit touches everything */
    bat_touch *touch;          /* of the last edit, when it is local */
    bool changed;              /* the shape differs from what it was at the beginning */
};

bat_status bat_shape_live_begin(const bat_shape *shape, int level, bat_shape_live **out) {
    if (!shape || !out || level < 0 || level > shape->count) return BAT_ARGUMENT;
    bat_shape_live *live = calloc(1, sizeof *live);
    if (!live) return BAT_MEMORY;
    live->level = level;
    bat_status status = bat_shape_copy(shape, &live->shape);
    if (status == BAT_OK)
        *out = live;
    else
        free(live);
    return status;
}

/* The shape as it was at the beginning. */
static bat_status restore(bat_shape_live *live) {
    if (live->changed && live->touch) {
        bat_touch_revert(live->touch);
    } else if (live->changed) {
        bat_shape *fresh;
        bat_status status = bat_shape_copy(live->before, &fresh);
        if (status != BAT_OK) return status;
        bat_shape_adopt(live->shape, fresh);
    }
    live->changed = false;
    return BAT_OK;
}

bat_status bat_shape_live_move(bat_shape_live *live, int first, size_t many, const double *deltas) {
    if (!live) return BAT_ARGUMENT;
    bool idle = false;
    bat_status status = bat_level_check(live->shape, live->level, first, many, deltas, &idle);
    if (status != BAT_OK || idle) {
        bat_status restored = restore(live);
        return status == BAT_OK ? restored : status;
    }
    int count = (int)many;
    if (!live->touch || !bat_touch_fits(live->touch, live->level, first, count)) {
        status = restore(live);
        bat_touch_free(live->touch);
        live->touch = NULL;
        if (status == BAT_OK) status = bat_touch_begin(live->shape, live->level, first, count, &live->touch);
        if (status != BAT_OK) return status;
    }
    if (live->touch) {
        status = bat_touch_apply(live->touch, deltas);
    } else {
        if (!live->before) status = bat_shape_copy(live->shape, &live->before);
        if (status == BAT_OK) status = restore(live);
        if (status == BAT_OK) status = bat_shape_move_all(live->shape, live->level, first, count, deltas);
    }
    live->changed = status == BAT_OK;
    return status;
}

bat_status bat_shape_live_drag(bat_shape_live *live, double u, const double *delta) {
    double deltas[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    int first, count;
    if (!live) return BAT_ARGUMENT;
    bat_status status = bat_level_pull(live->shape, live->level, u, delta, &first, &count, deltas);
    return status == BAT_OK ? bat_shape_live_move(live, first, (size_t)count, deltas) : status;
}

bat_status bat_shape_live_drag_finest(bat_shape_live *live, double u, const double *delta, double tolerance,
                                      double *left) {
    if (!live || !delta || !(tolerance > 0)) return BAT_ARGUMENT;
    int size = live->shape->base->dimension;
    if (!isfinite(u)) return BAT_NUMBER;
    for (int d = 0; d < size; d++)
        if (!(fabs(delta[d]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    bat_status status = restore(live);
    double target[BAT_DIMENSION_MAX], at[BAT_DIMENSION_MAX], whole[BAT_DIMENSION_MAX], miss = INFINITY;
    bat_curve_eval(bat_shape_curve(live->shape, live->shape->count), u, 0, target);
    for (int d = 0; d < size; d++) target[d] += delta[d], whole[d] = delta[d];
    for (int i = 0; i < FINEST_STEPS && status == BAT_OK && miss > tolerance; i++) {
        status = bat_shape_live_drag(live, u, whole);
        if (status != BAT_OK) break;
        bat_curve_eval(bat_shape_curve(live->shape, live->shape->count), u, 0, at);
        miss = 0;
        for (int d = 0; d < size; d++) miss = bat_hypot(miss, target[d] - at[d]);
        if (miss <= tolerance) break;
        for (int d = 0; d < size; d++) whole[d] += target[d] - at[d];
    }
    if (status == BAT_OK && !(miss <= tolerance)) status = BAT_TOLERANCE;
    if (status == BAT_OK && left) *left = miss;
    if (status != BAT_OK && live->changed) {
        bat_status restored = restore(live);
        if (restored != BAT_OK) status = restored;
    }
    return status;
}

const bat_shape *bat_shape_live_shape(const bat_shape_live *live) { return live->shape; }

void bat_shape_live_touched(const bat_shape_live *live, int level, int *first, size_t *count) {
    *first = 0, *count = 0;
    if (!live->changed || level < live->level || level > live->shape->count) return;
    if (live->touch) {
        int touched;
        bat_touch_run(live->touch, level, first, &touched);
        *count = (size_t)touched;
    } else
        *count = bat_curve_count(bat_shape_curve(live->shape, level));
}

bat_status bat_shape_live_commit(bat_shape_live *live, bat_shape **out) {
    if (!live || !out) {
        bat_shape_live_cancel(live);
        return BAT_ARGUMENT;
    }
    bat_status status = bat_shape_settle(live->shape); /* its own: on failure it goes */
    if (status == BAT_OK) *out = live->shape, live->shape = NULL;
    bat_shape_live_cancel(live);
    return status;
}

void bat_shape_live_cancel(bat_shape_live *live) {
    if (!live) return;
    bat_touch_free(live->touch);
    bat_shape_free(live->before);
    bat_shape_free(live->shape);
    free(live);
}

bat_status bat_shape_drag_finest(bat_shape *shape, int level, double u, const double *delta, double tolerance,
                                 double *left) {
    bat_shape_live *live;
    bat_status status = bat_shape_live_begin(shape, level, &live);
    if (status != BAT_OK) return status;
    status = bat_shape_live_drag_finest(live, u, delta, tolerance, left);
    if (status == BAT_OK) {
        bat_shape_adopt(shape, live->shape);
        live->shape = NULL;
    }
    bat_shape_live_cancel(live);
    return status;
}
