/* Points of strands: beads, and what lies between them. */
#include "form/sight/strand.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 8 };

double bat_strand_facing(const bat_sight_scene *s, const bat_surface *surface, const double uv[2],
                         double gradient[2]) {
    double jet[18];
    vec d[6];
    bat_surface_eval(surface, uv[0], uv[1], gradient ? 2 : 1, jet);
    for (int k = 0; k < (gradient ? 6 : 3); k++) d[k] = vec_load(jet + 3 * k, 3);
    const vec e = s->gaze.focus > 0 ? vec_sub(d[0], s->gaze.eye) : s->gaze.ahead;
    if (gradient) {
        gradient[0] = vec_dot(vec_add(vec_cross(d[3], d[2]), vec_cross(d[1], d[4])), e);
        gradient[1] = vec_dot(vec_add(vec_cross(d[4], d[2]), vec_cross(d[1], d[5])), e);
    }
    return vec_dot(vec_cross(d[1], d[2]), e);
}

double bat_sight_beyond(const bat_sight_scene *s, const bat_bead *a, const bat_bead *b) {
    double most = 0;
    if (!(a->depth > s->near && b->depth > s->near)) return 0;
    for (int d = 0; d < 2; d++) {
        const double wide = 2 * s->gaze.middle[d];
        most = fmax(most, -wide - fmax(a->pixel[d], b->pixel[d]));
        most = fmax(most, fmin(a->pixel[d], b->pixel[d]) - 2 * wide);
    }
    return most;
}

static double between(const bat_curve *axis, double a, double b, double f) {
    const double period = axis->knots[axis->spread] - axis->knots[axis->degree];
    double way = b - a;
    if (axis->closed && way > 0.5 * period) way -= period;
    if (axis->closed && way < -0.5 * period) way += period;
    return a + f * way;
}

static double width(const bat_curve *axis, double x) {
    const int span = bat_span(axis, bat_curve_reduce(axis, x), -1);
    return axis->knots[span + 1] - axis->knots[span];
}

/* Newton's method across the silhouette; stays at the start when it leads away. */
static void to_silhouette(const bat_sight_scene *s, const bat_surface *surface, double uv[2]) {
    double at[2] = {uv[0], uv[1]};
    for (int i = 0; i < STEPS; i++) {
        double slope[2], far = 0, wide[2];
        const double g = bat_strand_facing(s, surface, at, slope);
        for (int d = 0; d < 2; d++) wide[d] = width(&surface->axis[d], at[d]), slope[d] *= wide[d];
        const double square = slope[0] * slope[0] + slope[1] * slope[1];
        if (!(square > 0)) break;
        for (int d = 0; d < 2; d++) {
            const double step = -g * slope[d] / square;
            at[d] += step * wide[d];
            far = fmax(far, fabs(at[d] - uv[d]) / wide[d]);
        }
        if (!(far < 0.2)) return;
    }
    uv[0] = at[0], uv[1] = at[1];
}

static void finish(const bat_sight_scene *s, bat_bead *bead) {
    double at[3], out[3];
    vec_store(bead->at, at);
    bat_gaze_image(&s->gaze, at, out);
    bead->pixel[0] = out[0], bead->pixel[1] = out[1], bead->depth = out[2];
}

void bat_strand_locate(const bat_sight_scene *s, const bat_strand *strand, double place, bat_bead *out) {
    const double last = (double)(strand->count - 1);
    place = fmin(fmax(place, 0), last);
    const size_t i = (size_t)fmin(floor(place), last - 1);
    const double f = place - (double)i;
    const bat_bead *a = &strand->beads[i], *b = a + 1;
    if (f == 0 || f == 1) {
        *out = f == 0 ? *a : *b;
        return;
    }
    double jet[3];
    out->t = a->t + f * (b->t - a->t);
    out->at = vec_add(vec_scale(a->at, 1 - f), vec_scale(b->at, f));
    for (int k = 0; k < 4; k++)
        out->uv[k] = strand->side[k / 2] ? between(&strand->side[k / 2]->axis[k % 2], a->uv[k], b->uv[k], f)
                                         : 0;
    if (strand->curve) {
        bat_curve_eval(strand->curve, out->t, 0, jet);
        out->at = vec_load(jet, strand->curve->dimension);
        if (strand->side[0]) out->uv[1 - strand->direction] = out->t;
    } else if (strand->kind == BAT_LINE_INTERSECTION) {
        const bat_meet m = {.side = {strand->side[0], strand->side[1]}, .size = strand->side[0]->size};
        bat_meet_place place_on;
        if (bat_meet_across(&m, out->at, vec_unit(vec_sub(b->at, a->at)), 0, out->uv) &&
            bat_meet_place_at(&m, out->uv, &place_on))
            out->at = place_on.at;
    } else {
        to_silhouette(s, strand->side[0], out->uv);
        bat_surface_eval(strand->side[0], out->uv[0], out->uv[1], 0, jet);
        out->at = vec_load(jet, 3);
    }
    finish(s, out);
}

bat_status bat_strand_split(bat_strand *strand, double place, bool corner) {
    if (!(place > 0) || !(place < (double)(strand->count - 1))) return BAT_OK;
    if (strand->split_count == strand->split_room) {
        const size_t room = 2 * strand->split_room + 8;
        bat_split *more = realloc(strand->splits, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        strand->splits = more, strand->split_room = room;
    }
    strand->splits[strand->split_count++] = (bat_split){place, corner};
    return BAT_OK;
}

void bat_strands_free(bat_sight_scene *s) {
    for (size_t i = 0; i < s->count; i++) {
        bat_curve_free(s->strands[i].curve);
        free(s->strands[i].beads);
        free(s->strands[i].splits);
    }
    free(s->strands);
    s->strands = NULL, s->count = s->room = 0;
}
