/* What becomes of the two ends of a stroke (docs/math sketch 5.4). */
#include "hands/sketch/plan.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

static const double shortest_stub = 2, corner_reach = 8;
static const double seen_turn = 0.06;               /* radians; a smaller one is not seen */
static const double corner_turn = 0.5, steep = 0.5; /* radians */
static const double generous = 1.1; /* the few knots of a blend need this much more room than a quintic */

static double angle_between(const double *a, const double *b, size_t m) {
    double dot = 0;
    for (size_t c = 0; c < m; c++) dot += a[c] * b[c];
    return bat_acos(dot > 1 ? 1 : dot < -1 ? -1 : dot);
}

/* How far from the curve an end of the stroke may lie and still be meant for it. */
static double reach_of(const bat_clean *stroke) { return fmax(40, 0.25 * stroke->length); }

bool bat_ends_far(const bat_clean *stroke, const bat_correspondence *found, double around) {
    if (around == 0) return fmin(found->offset[0], found->offset[1]) > reach_of(stroke);
    const double most = fmax(40,
                             fmin(0.25 * stroke->length, around / 16)); /* of a circle, 0.4 of its radius */
    return fmax(found->offset[0], found->offset[1]) > most;
}

bat_status bat_plan_ends(bat_plan *plan, const bat_correspondence *found) {
    const bat_clean *stroke = plan->stroke;
    const size_t m = (size_t)plan->dimension;
    const double far = reach_of(stroke);
    const bool told = plan->end[0].rule || plan->end[1].rule;
    if (!told && fmin(found->offset[0], found->offset[1]) > far) return BAT_FAR;
    for (int side = 0; side < 2; side++) {
        bat_end *e = &plan->end[side];
        e->s = side == 0 ? found->start : found->end;
        e->offset = found->offset[side];
        double direction[BAT_DIMENSION_MAX], tangent[BAT_DIMENSION_MAX];
        bat_clean_frame(stroke, side == 0 ? 0 : stroke->length, 12, NULL, direction, NULL);
        bat_track_tangent(e->track, bat_track_u(e->track, e->s), tangent);
        e->angle = angle_between(direction, tangent, m);
        e->kind = BAT_END_KEPT;
        e->corner = false;
        if (plan->closed) continue;
        const double stub = side == 0 ? e->s : e->track->length - e->s;
        if (e->rule != BAT_END_RULE_HELD && stub < fmax(e->offset, shortest_stub)) e->kind = BAT_END_FREE;
        if (e->rule == BAT_END_RULE_FREE) e->kind = BAT_END_FREE;
        /* So much of a curve is not cut off because the stroke ends far away from it; and it can not blend back. */
        if (e->rule == BAT_END_RULE_AUTO && e->kind == BAT_END_FREE && stub > far) return BAT_FAR;
    }
    return BAT_OK;
}

/* A knot of full multiplicity, given by its first copy, where the tangent turns: files also have such knots where an
 * outline is smooth. */
static bool is_corner(const bat_curve *curve, int first) {
    const int last = first + curve->degree - 1;
    return curve->knots[last] == curve->knots[first] && bat_curve_corner_at(curve, last, seen_turn);
}

/* The corner nearest to the stroke within the transition, or -1. */
static int corner_in(const bat_end *e, int side, double reach) {
    const bat_curve *curve = e->curve;
    const int p = curve->degree;
    const double *t = curve->knots;
    const bool closed = curve->closed;
    int best = -1;
    double nearest = reach;
    for (int i = p + (closed ? 0 : 1); i < curve->spread; i++) {
        if (t[i] == t[i - 1] || i + p - 1 >= curve->spread + (closed ? p : 0) || !is_corner(curve, i))
            continue;
        if (!closed && (t[i] <= e->track->start || t[i] >= e->track->end)) continue;
        double away = (e->s - bat_track_s(e->track, t[i])) * (side == 0 ? 1 : -1);
        if (closed) away -= floor((away + corner_reach) / e->track->length) * e->track->length;
        if (away >= -corner_reach && away <= nearest) nearest = away, best = i;
    }
    return best;
}

/* How far from the stroke the curve goes on without a corner, on the side that is kept. */
static double smooth_beyond(const bat_end *e, int side) {
    const int corner = corner_in(e, side, INFINITY);
    if (corner < 0) return INFINITY;
    double away = (e->s - bat_track_s(e->track, e->curve->knots[corner])) * (side == 0 ? 1 : -1);
    if (e->curve->closed) away -= floor((away + corner_reach) / e->track->length) * e->track->length;
    return away;
}

void bat_end_stop(bat_end *e, int side, double u, bool corner) {
    const double sign = side == 0 ? -1 : 1;
    double s = bat_track_s(e->track, u);
    if (e->curve->closed) { /* the period that lies nearest to the stroke's end */
        const double turns = floor((e->s - s) / e->track->length + 0.5);
        s += turns * e->track->length, u += turns * (e->track->end - e->track->start);
    }
    e->kind = BAT_END_POINT;
    e->corner = corner;
    e->lead = (s - e->s) * sign;
    e->joint = s, e->joint_u = u, e->cut = u;
}

/* Where to cut: at the joint, or at a simple knot near it. */
static void choose_cut(bat_end *e, int side, double room) {
    const bat_curve *curve = e->curve;
    const bat_stroke_track *k = e->track;
    const int p = curve->degree;
    const double sign = side == 0 ? -1 : 1;
    const double snap = 6, reach = fmin(fmax(e->lead, 10), room);
    const double period = k->end - k->start;
    e->joint = e->s + sign * e->lead;
    e->joint_u = bat_track_u(k, e->joint);
    e->cut = e->joint_u;
    double turns = 0, best = INFINITY, chosen = 0;
    if (curve->closed) turns = floor((e->joint_u - k->start) / period);
    bool snapped = false, sharp = false;
    for (int lap = curve->closed ? -1 : 0; lap <= (curve->closed ? 1 : 0); lap++)
        for (int i = p; i <= curve->spread; i++) {
            const double knot = curve->knots[i] + (turns + lap) * period;
            if (i > p && curve->knots[i] == curve->knots[i - 1]) continue;
            if (!curve->closed && (knot <= k->start || knot >= k->end)) continue;
            const double beyond = (bat_track_s(k, knot) - e->joint) * sign; /* > 0: on the kept side */
            const bool corner = is_corner(curve, i);
            const bool near = fabs(beyond) <= snap && e->lead + beyond >= 0.5 * e->lead && beyond <= room;
            if (!near && (beyond <= snap || beyond > reach || corner)) continue;
            if (fabs(beyond) >= best) continue;
            best = fabs(beyond), chosen = knot, snapped = near, sharp = corner;
        }
    if (sharp) {
        bat_end_stop(e, side, chosen, true);
    } else if (best < INFINITY) {
        e->cut = chosen;
        if (!snapped) return;
        e->joint_u = chosen;
        e->joint = bat_track_s(k, chosen);
        e->lead = (e->joint - e->s) * sign;
    }
}

/* The curve's radius near a place, from its mean square curvature over so much length on both sides. */
static double radius_near(const bat_end *e, double s, double reach) {
    enum { STEPS = 16 };
    const bat_stroke_track *k = e->track;
    const size_t m = (size_t)e->curve->dimension;
    double from = s - reach, to = s + reach, bend = 0, last[BAT_DIMENSION_MAX], next[BAT_DIMENSION_MAX];
    if (!e->curve->closed) from = fmin(fmax(from, 0), k->length), to = fmin(fmax(to, 0), k->length);
    const double step = (to - from) / STEPS;
    bat_track_tangent(k, bat_track_u(k, from), last);
    for (int i = 1; i <= STEPS; i++) {
        bat_track_tangent(k, bat_track_u(k, from + i * step), next);
        const double turn = angle_between(last, next, m);
        if (turn < corner_turn) bend += turn * turn;
        memcpy(last, next, sizeof last);
    }
    return bend > 0 ? step * sqrt(STEPS / bend) : INFINITY;
}

/* A stroke that misses a bend by a little: a transition of sqrt(22 miss R) changes its curvature by about a quarter of
 * 1 / R, and a much shorter one would turn the other way. A curve that is nearly straight beside the stroke has no such
 * bend; a stroke that arrives at an angle is blended by that; and neither a corner nor an end of the curve is near. */
static double gentle_lead(const bat_plan *plan, int side) {
    const bat_end *e = &plan->end[side];
    const double L = plan->stroke->length, R = radius_near(e, e->s, 0.5 * L), straight = R / (5 * L);
    if (!(straight < 1)) return 0;
    const double miss = e->offset * e->offset / (e->offset + 0.25 * plan->tolerance);
    const double bent = 1 - straight * straight * (3 - 2 * straight);
    const double along = fmax(0, 1 - e->angle * e->angle / (steep * steep));
    const double stub = plan->closed ? INFINITY : side == 0 ? e->s : e->track->length - e->s;
    return fmin(fmin(0.6 * stub, smooth_beyond(e, side)),
                plan->width / 3 * along * fmin(sqrt(22 * miss * R * bent), 110));
}

void bat_plan_leads(bat_plan *plan) {
    const double L = plan->stroke->length, gentle = plan->width / 3, rho = 20;
    for (int side = 0; side < 2; side++) {
        bat_end *e = &plan->end[side];
        e->lead = e->blend = e->look = 0;
        if (e->kind == BAT_END_FREE) continue;
        e->lead = fmax(fmax(plan->width * e->offset, gentle * sqrt(6 * e->offset * 60)), rho * e->angle);
        e->lead *= generous;
        const double longer = gentle_lead(plan, side);
        e->lead = fmax(e->lead, longer);
        e->lead = fmax(fmin(e->lead, 0.5 * L + 3.6 * e->offset), 12); /* a dab has no wide blend */
        e->blend = fmin(rho * e->angle, 0.2 * L);
        e->look = fmin(0.4 * fmin(longer, e->lead), 0.25 * L);
    }
}

void bat_plan_cuts(bat_plan *plan) {
    const double L = plan->stroke->length;
    double room[2] = {INFINITY, INFINITY};
    if (plan->closed) {
        const double around = plan->end[0].track->length;
        const double free_arc = fmax(around - (plan->end[1].s - plan->end[0].s), 0.02 * around);
        const double wanted = plan->end[0].lead + plan->end[1].lead;
        if (wanted > 0.9 * free_arc)
            for (int side = 0; side < 2; side++) plan->end[side].lead *= 0.9 * free_arc / wanted;
        const double left = free_arc - plan->end[0].lead - plan->end[1].lead;
        room[0] = room[1] = 0.4 * left;
    }
    for (int side = 0; side < 2; side++) {
        bat_end *e = &plan->end[side];
        if (e->kind == BAT_END_FREE) continue;
        const bat_stroke_track *k = e->track;
        if (e->rule == BAT_END_RULE_HELD && !plan->closed) {
            bat_end_stop(e, side, side == 0 ? k->start : k->end, false);
            e->blend = fmin(fmax(12, 3 * e->offset), 0.3 * L);
            continue;
        }
        if (plan->keep_corners) {
            const int corner = corner_in(e, side, e->lead);
            if (corner >= 0) {
                bat_end_stop(e, side, e->curve->knots[corner], true);
                if (e->lead < corner_reach) { /* the stroke is meant to start there */
                    e->lead = 0;
                    e->blend = fmin(fmax(12, 3 * e->offset), 0.3 * L);
                }
                continue;
            }
        }
        if (!e->curve->closed) {
            const double stub = side == 0 ? e->s : k->length - e->s;
            if (stub - e->lead < 6) {
                bat_end_stop(e, side, side == 0 ? k->start : k->end, false);
                continue;
            }
            room[side] = stub - e->lead - 1;
        }
        choose_cut(e, side, room[side]);
    }
}
