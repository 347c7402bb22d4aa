#include "editor/show/inspect.h"
#include "base/vec.h"
#include "editor/choice/choice.h"
#include "editor/edit/stroke.h"
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include "editor/show/handles.h"
#include "editor/pick/pick.h"
#include "editor/edit/curves_of.h"
#include <batten/bezier.h>
#include <batten/measure.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double SPACING = 7, TALL = 46, HIGHEST = 110; /* px: between teeth, of tall ones, of any */
static const double REACH = 16, MARK = 4;                  /* px */
enum { TEETH_MAX = 1500, MARKS_MAX = 200 };

/* A tooth: its point, the curvature vector turned outwards, its length, the length of curve that it represents. */
typedef struct tooth {
    vec at, out;
    double curvature, share;
} tooth;

/* Where a place is in the drawing; false: not in sight. */
static bool look_at(const bat_stage *stage, vec place, double at[2]) {
    double point[3];
    vec_store(place, point);
    return bat_stage_look(stage, 3, point, at);
}

static bool in_sight(const bat_stage *stage, vec place) {
    double screen[2], point[2];
    if (!look_at(stage, place, point)) return false;
    bat_stage_project(stage, point, screen);
    return screen[0] > -HIGHEST && screen[1] > -HIGHEST && screen[0] < stage->view.width + HIGHEST &&
           screen[1] < stage->view.height + HIGHEST;
}

/* False: the curve stands still there. */
static bool cut(const bat_curve *curve, double u, bool left, tooth *out) {
    const int n = bat_curve_dimension(curve);
    double d[3 * BAT_DIMENSION_MAX];
    (left ? bat_curve_eval_left : bat_curve_eval)(curve, u, 2, d);
    const vec along = vec_load(d + n, n), bend = vec_load(d + 2 * n, n);
    const double squared = vec_dot(along, along);
    if (!(squared > 0)) return false;
    out->at = vec_load(d, n);
    out->out = vec_scale(vec_sub(vec_scale(along, vec_dot(along, bend) / squared), bend), 1 / squared);
    out->curvature = vec_norm(out->out);
    return true;
}

/* The teeth in view; *count of them. NULL: out of memory, or none. */
static tooth *grow(const bat_curve *curve, const bat_stage *stage, int *count) {
    int segments = bat_curve_segment_count(curve);
    double *breaks = malloc(((size_t)segments + 1) * sizeof *breaks);
    tooth *teeth = malloc(TEETH_MAX * sizeof *teeth);
    *count = 0;
    if (!breaks || !teeth || bat_curve_to_bezier(curve, NULL, breaks) != BAT_OK) {
        free(breaks);
        free(teeth);
        return NULL;
    }
    for (int s = 0; s < segments && *count < TEETH_MAX; s++) {
        double length = bat_curve_length(curve, breaks[s], breaks[s + 1], 1e-2) * stage->view.zoom;
        int steps = (int)fmin(fmax(ceil(length / SPACING), 12), 400);
        for (int i = 0; i <= steps && *count < TEETH_MAX; i++) {
            const double u = breaks[s] + (breaks[s + 1] - breaks[s]) * i / steps;
            tooth *one = &teeth[*count];
            if (!cut(curve, u, i == steps, one) || !in_sight(stage, one->at)) continue;
            one->share = length / steps;
            ++*count;
        }
    }
    free(breaks);
    return teeth;
}

/* Document units per unit of curvature: along nine tenths of the curve no tooth is longer than TALL. In steps of the
 * square root of two, so that the comb does not pulsate while the curve is dragged. 0: the curve is straight. */
static double scale_of(const tooth *teeth, int count, double pixel) {
    double low = 0, high = 0, whole = 0;
    for (int i = 0; i < count; i++) whole += teeth[i].share;
    for (int i = 0; i < count; i++) high = fmax(high, teeth[i].curvature);
    double least = high / 8;
    for (int round = 0; round < 40;
         round++) { /* bisects for the curvature that a tenth of the curve exceeds */
        double middle = (low + high) / 2;
        double above = 0;
        for (int i = 0; i < count; i++) above += teeth[i].curvature > middle ? teeth[i].share : 0;
        if (above > whole / 10)
            low = middle;
        else
            high = middle;
    }
    double usual = fmax(high, least);
    if (!(usual * pixel > 1e-7) || !isfinite(usual)) return 0; /* too flat to see */
    double scale = TALL * pixel / usual;
    return bat_exp(floor(bat_log(scale) / 0.34657359) * 0.34657359);
}

void bat_comb_show(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage) {
    int count;
    double pixel = bat_stage_pixel(stage);
    tooth *teeth = grow(curve, stage, &count);
    double scale = teeth && count ? scale_of(teeth, count, pixel) : 0;
    if (teeth && scale > 0) {
        double foot[2], tip[2];
        for (int i = 0; i < count; i++) {
            const double most = HIGHEST * pixel, length = teeth[i].curvature * scale;
            teeth[i].out = vec_add(teeth[i].at,
                                   vec_scale(teeth[i].out, length > most ? scale * most / length : scale));
        }
        bat_overlay_item(overlay, BAT_ROLE_COMB, BAT_ITEM_STROKED, 0.75F);
        for (int i = 0; i < count; i++) {
            if (!look_at(stage, teeth[i].at, foot) || !look_at(stage, teeth[i].out, tip)) continue;
            bat_path_move(&overlay->path, foot[0], foot[1]);
            bat_path_line(&overlay->path, tip[0], tip[1]);
        }
        bat_overlay_item(overlay, BAT_ROLE_COMB, BAT_ITEM_STROKED, 1.5F);
        for (int i = 0; i < count; i++) {
            const double gap = i ? vec_norm(vec_sub(teeth[i].at, teeth[i - 1].at)) : INFINITY;
            bool on = gap < 6 * SPACING * pixel; /* otherwise the curve was out of view between them */
            if (look_at(stage, teeth[i].out, tip))
                (on ? bat_path_line : bat_path_move)(&overlay->path, tip[0], tip[1]);
        }
    }
    free(teeth);
    double u[MARKS_MAX], at[2];
    size_t found = bat_curve_inflections(curve, MARKS_MAX, u);
    if (found > MARKS_MAX) found = MARKS_MAX;
    bat_overlay_item(overlay, BAT_ROLE_COMB, BAT_ITEM_FILLED, 0);
    for (size_t i = 0; i < found && scale > 0; i++) {
        double place[3] = {0};
        bat_curve_eval(curve, u[i], 0, place); /* of a planar curve */
        if (in_sight(stage, vec_load(place, 2)) && look_at(stage, vec_load(place, 2), at))
            bat_overlay_circle(overlay, at, MARK * pixel);
    }
}

/* Squares on extremes. */
static void show_extremes(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage) {
    double u[MARKS_MAX];
    bat_overlay_item(overlay, BAT_ROLE_COMB, BAT_ITEM_STROKED, 1);
    for (int axis = 0; axis < 2; axis++) {
        const size_t found = bat_curve_extremes(curve, axis, MARKS_MAX, u);
        for (size_t i = 0; i < found && i < MARKS_MAX; i++) {
            double at[2];
            bat_curve_eval(curve, u[i], 0, at);
            if (in_sight(stage, vec_load(at, 2)))
                bat_overlay_square(overlay, at, MARK * bat_stage_pixel(stage));
        }
    }
}

/* The curve being inspected. */
static const bat_curve *look(bat_context *c) {
    bat_insight *insight = c->insight;
    if (c->input->pen_near && !c->session->busy && bat_contacts_clear(c)) {
        double point[2];
        bat_stage_seen(c->stage, c->input->pen, point);
        bat_pick pick = bat_pick_nearest(c->scene, point, REACH * bat_stage_pixel(c->stage));
        if (pick.object) insight->object = pick.object, insight->curve = pick.curve;
    }
    const bat_curve *curve = insight->object
                                 ? bat_edit_target(c->session->document, insight->object, insight->curve)
                                 : NULL;
    if (!curve && c->choice->selection.count)
        curve = bat_edit_target(c->session->document, c->choice->selection.ids[0], 0);
    return curve;
}

void bat_insight_show(bat_context *c, const bat_curve *made, bat_overlay *overlay) {
    bool comb = c->settings->values[BAT_PROPERTY_SHOW_COMB] != 0;
    bool knots = c->settings->values[BAT_PROPERTY_SHOW_KNOTS] != 0;
    bool length = c->settings->values[BAT_PROPERTY_SHOW_LENGTH] != 0;
    if (!comb && !knots && !length) return;
    const bat_curve *curve = made ? made : look(c);
    if (!curve) return;
    bat_curve *seen = NULL; /* a curve in space as it is seen from above: without its height */
    if (bat_curve_to_dimension(curve, 2, &seen) != BAT_OK) return;
    if (comb) bat_comb_show(overlay, seen, c->stage), show_extremes(overlay, seen, c->stage);
    if (knots) bat_handles_show_knots(overlay, curve, c->stage);
    bat_curve_free(seen);
    if (length && c->input->pen_near) {
        double domain[2], at[2];
        char text[64];
        bat_curve_domain(curve, domain);
        bat_unit_write(c, bat_curve_length(curve, domain[0], domain[1], 1e-6), text);
        bat_stage_seen(c->stage, c->input->pen, at);
        bat_overlay_label(overlay, BAT_ROLE_VALUE, at, 16, -20, text);
    }
}
