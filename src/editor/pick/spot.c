#include "editor/pick/spot.h"
#include "base/real.h"
#include "base/vec.h"
#include "editor/pick/snap.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

/* Keeps a place on a plane to steps of the angle around another, counted from the plane's x. */
static void keep_to_steps(bat_context *c, const double from[3], double at[3]) {
    double x[3], y[3], own[2], kept[3];
    const vec away = vec_sub(vec_load(at, 3), vec_load(from, 3));
    bat_ground_axes(&c->stage->ground, x, y);
    own[0] = vec_dot(away, vec_load(x, 3));
    own[1] = vec_dot(away, vec_load(y, 3));
    bat_snap_angle(c, (double[]){0, 0}, own);
    c->snap->kind = BAT_SNAP_NONE; /* it is shown on the page only */
    for (int k = 0; k < 3; k++) kept[k] = from[k] + own[0] * x[k] + own[1] * y[k];
    memcpy(at, kept, sizeof kept);
}

bat_status bat_spot(bat_context *c, const double pixel[2], int count, const int *but, const double *from,
                    double at[3]) {
    const bat_stage *stage = c->stage;
    const bool step = c->modifiers & BAT_SHIFT && from;
    bat_hit hit;
    bat_status status = bat_stage_place(stage, pixel, NULL, &hit);
    if (status != BAT_OK) return status;
    memcpy(at, hit.at, sizeof hit.at);
    if (bat_stage_dimension(stage) != 2) {
        c->snap->kind = BAT_SNAP_NONE;
        if (bat_ground_bounded(&stage->ground)) return BAT_OK; /* it stays on the surface */
        if (step)
            keep_to_steps(c, from, at);
        else
            bat_snap_point_space(c, count, but, at);
    } else if (step) {
        bat_snap_angle(c, from, at);
    } else {
        bat_snap_point(c, count, but, at);
    }
    return BAT_OK;
}

double bat_spots_apart(const bat_context *c, int dimension, const double *a, const double *b) {
    double p[2], q[2];
    if (!bat_stage_look(c->stage, dimension, a, p) || !bat_stage_look(c->stage, dimension, b, q))
        return INFINITY;
    return bat_hypot(p[0] - q[0], p[1] - q[1]) / bat_stage_pixel(c->stage);
}
