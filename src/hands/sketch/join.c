/* Two open curves made one by a stroke from the one to the other (docs/math sketch 5.4). */
#include "hands/sketch/sketch.h"
#include "base/real.h"
#include <batten/refine.h>

#include <math.h>
#include <string.h>

enum { CANDIDATES = 6 };

/* Where on a curve the stroke's end belongs, and which way the curve must run: it comes in to the stroke's
 * start (way 0) or leaves its end (way 1). What the join would cut off counts against a place. */
typedef struct place {
    double s, distance, score;
    bool turned;
} place;

static place find_place(const bat_stroke_track *k, const double *point, const double *direction, int way) {
    const size_t m = (size_t)k->curve->dimension;
    bat_track_near near[CANDIDATES];
    const int count = bat_track_candidates(k, point, 25, CANDIDATES, near);
    place best = {.score = INFINITY};
    for (int i = 0; i < count; i++)
        for (int turned = 0; turned < 2; turned++) {
            double tangent[BAT_DIMENSION_MAX], dot = 0;
            bat_track_tangent(k, bat_track_u(k, near[i].s), tangent);
            for (size_t c = 0; c < m; c++) dot += tangent[c] * direction[c];
            const bool keeps_start = (way == 0) != (turned == 1);
            const double lost = keeps_start ? k->length - near[i].s : near[i].s;
            const double score = near[i].distance / 25 + 0.6 * (1 - (turned ? -dot : dot)) +
                                 2.5 * lost / (k->length > 0 ? k->length : 1);
            if (score < best.score)
                best = (place){
                    .s = near[i].s, .distance = near[i].distance, .score = score, .turned = turned == 1};
        }
    if (best.turned) best.s = k->length - best.s;
    return best;
}

/* The curve raised to the degree, turned if asked, with parameters that run at `speed` (0: as they are). */
static bat_status prepare(const bat_curve *curve, int degree, bool turned, double length, double speed,
                          bat_curve **out) {
    bat_curve *now, *next;
    bat_status status = bat_curve_degree(curve) < degree ? bat_curve_elevate(curve, degree, &now)
                                                         : bat_curve_copy(curve, &now);
    if (status == BAT_OK && turned) {
        status = bat_curve_reverse(now, &next);
        bat_curve_free(now);
        now = next;
    }
    if (status == BAT_OK && speed > 0 && length > 0) {
        double domain[2];
        bat_curve_domain(now, domain);
        status = bat_curve_reparametrise(now, domain[0], domain[0] + length / speed, &next);
        bat_curve_free(now);
        now = next;
    }
    if (status == BAT_OK) *out = now;
    return status;
}

/* Two curves being made one. */
typedef struct joining {
    const bat_curve *given[2];
    int degree;
    double origin[BAT_DIMENSION_MAX], pixel;
    bat_clean clean;
    bat_workpiece workpiece[2];
    place found[2];
} joining;

static void joining_free(joining *j) {
    for (int side = 0; side < 2; side++) bat_workpiece_free(&j->workpiece[side]);
    bat_clean_free(&j->clean);
}

/* Whether the stroke runs from the second curve to the first. */
static bool runs_back(const joining *j) {
    double distance[2][2];
    for (int end = 0; end < 2; end++) {
        double point[BAT_DIMENSION_MAX], direction[BAT_DIMENSION_MAX];
        bat_clean_frame(&j->clean, end == 0 ? 0 : j->clean.length, 12, point, direction, NULL);
        for (int side = 0; side < 2; side++) {
            bat_track_near near;
            bat_track_candidates(&j->workpiece[side].track, point, 0, 1, &near);
            distance[side][end] = near.distance;
        }
    }
    return distance[0][1] + distance[1][0] < distance[0][0] + distance[1][1];
}

static bat_status find_places(joining *j) {
    for (int side = 0; side < 2; side++) {
        double point[BAT_DIMENSION_MAX], direction[BAT_DIMENSION_MAX];
        bat_clean_frame(&j->clean, side == 0 ? 0 : j->clean.length, 12, point, direction, NULL);
        j->found[side] = find_place(&j->workpiece[side].track, point, direction, side);
    }
    const double far = fmax(40, 0.25 * j->clean.length);
    return j->found[0].distance > far || j->found[1].distance > far ? BAT_FAR : BAT_OK;
}

/* Turned and brought to one degree. own: both keep the parameters they have; else the second is brought to the first
 * one's mean speed (document units). */
static bat_status bring_together(joining *j, bool own) {
    const double speed = j->workpiece[0].track.mean * j->pixel;
    for (int side = 0; side < 2; side++) {
        bat_curve *ready;
        bat_status status = prepare(j->given[side], j->degree, j->found[side].turned,
                                    j->workpiece[side].track.length * j->pixel, side == 0 || own ? 0 : speed,
                                    &ready);
        bat_workpiece_free(&j->workpiece[side]);
        if (status != BAT_OK) return status;
        status = bat_workpiece_make(ready, j->origin, j->pixel, &j->workpiece[side]);
        bat_curve_free(ready);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static const double meeting = BAT_PI / 4; /* a turn from which on the joint stays a corner */
static const double slight = 0.05; /* of the shorter of curve and stroke: so little may be left of an end */

/* Where the stroke goes on at an angle from a curve's very end, they meet there in a corner. */
static void keep_meeting(const bat_plan *plan, bat_end *e, int side) {
    const bat_stroke_track *k = e->track;
    const double L = plan->stroke->length, left = side == 0 ? k->length - e->s : e->s;
    if (e->angle < meeting || left > e->offset + slight * fmin(L, k->length)) return;
    e->s = side == 0 ? k->length : 0;
    bat_end_stop(e, side, side == 0 ? k->end : k->start, true);
    e->lead = 0;
    e->blend = fmin(fmax(0.1 * L, 3 * e->offset), 0.3 * L);
}

static bat_status plan_join(const joining *j, bat_plan *plan, double changed[2]) {
    bat_workpiece_bind(plan, &j->workpiece[0]);
    plan->end[1].curve = j->workpiece[1].pixels, plan->end[1].original = j->workpiece[1].original;
    plan->end[1].track = &j->workpiece[1].track;
    const bat_correspondence meant = {
        .start = j->found[0].s, .end = j->found[1].s, .offset = {j->found[0].distance, j->found[1].distance}};
    bat_status status = bat_plan_ends(plan, &meant);
    if (status != BAT_OK) return status;
    bat_plan_leads(plan);
    bat_plan_cuts(plan);
    for (int side = 0; side < 2; side++) keep_meeting(plan, &plan->end[side], side);
    for (int side = 0; side < 2; side++)
        if (plan->end[side].kind != BAT_END_FREE) changed[side] = plan->end[side].cut;
    return bat_plan_target(plan);
}

static bat_status join(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke,
                       const bat_sketch_options *given, bool own, bat_curve **out,
                       bat_sketch_report *report) {
    bat_sketch_options o;
    if (!a || !b || !out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    if (a->closed || b->closed) return BAT_ARGUMENT;
    if (a->dimension != b->dimension || a->dimension != stroke->dimension) return BAT_DIMENSION;
    joining j = {.given = {a, b}, .pixel = o.pixel, .degree = 3};
    for (int side = 0; side < 2; side++)
        if (j.given[side]->degree > j.degree) j.degree = j.given[side]->degree;
    bat_stroke_origin(stroke, j.origin);
    const double tolerance = o.tolerance / o.pixel;
    const bat_clean_options cleaning = {1 / o.pixel, j.origin, tolerance, o.keep_corners, NULL};
    status = bat_clean_stroke(stroke, &cleaning, &j.clean);
    if (status != BAT_OK) return status;
    for (int side = 0; side < 2 && status == BAT_OK; side++)
        status = bat_workpiece_make(j.given[side], j.origin, o.pixel, &j.workpiece[side]);
    bat_plan plan = {.degree = j.degree,
                     .dimension = stroke->dimension,
                     .pins = o.pins == 2 ? j.degree - 1 : j.degree,
                     .tolerance = j.clean.share * tolerance,
                     .width = o.width,
                     .fairness = o.fairness,
                     .keep_corners = o.keep_corners,
                     .stroke = &j.clean};
    bat_sketch_report facts = {.knots_before = bat_curve_knot_count(a) + bat_curve_knot_count(b)};
    if (status == BAT_OK) {
        facts.reversed = runs_back(&j);
        if (facts.reversed) bat_clean_reverse(&j.clean);
        status = find_places(&j);
    }
    if (status == BAT_OK) status = bring_together(&j, own);
    if (status == BAT_OK) status = plan_join(&j, &plan, facts.changed);
    if (status == BAT_OK) status = bat_plan_finish(&plan, j.origin, o.pixel, NULL, out, &facts);
    if (report && (status == BAT_OK || status == BAT_TOLERANCE)) *report = facts;
    bat_plan_free(&plan);
    joining_free(&j);
    return status;
}

bat_status bat_sketch_join(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke,
                           const bat_sketch_options *options, bat_curve **out, bat_sketch_report *report) {
    return join(a, b, stroke, options, false, out, report);
}

/* The curve cut in the middle, its two ends joined, and the cut mended: there it is as it was. */
bat_status bat_sketch_close(const bat_curve *curve, const bat_stroke *stroke,
                            const bat_sketch_options *options, bat_curve **out, bat_sketch_report *report) {
    if (!curve || !out || curve->closed) return BAT_ARGUMENT;
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve *half[2] = {NULL, NULL}, *bridged = NULL;
    bat_status status = bat_curve_split(curve, 0.5 * (domain[0] + domain[1]), &half[0], &half[1]),
               met = BAT_OK;
    if (status == BAT_OK) {
        met = join(half[1], half[0], stroke, options, true, &bridged, report);
        status = met == BAT_TOLERANCE ? BAT_OK : met;
    }
    if (status == BAT_OK) status = bat_curve_close(bridged, 1e-9 * bat_curve_size(bridged), out);
    bat_curve_free(bridged);
    for (int i = 0; i < 2; i++) bat_curve_free(half[i]);
    return status == BAT_OK ? met : status;
}
