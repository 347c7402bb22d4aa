/* The points tool: knots that are inserted and removed, corners that are made and smoothed. */
#include "editor/tools/points/state.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/session/notice.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdio.h>

static void notice_number(bat_context *c, bat_string text, double value) {
    char number[BAT_UNIT_ROOM];
    bat_unit_about(c, value, number);
    bat_notice_value(c, text, number);
}

/* Inserts u until its multiplicity is `times` higher; the shape does not change. Chooses the knot. */
bat_status bat_pointing_insert(bat_context *c, bat_pointing *p, const bat_curve *curve, double u, int times,
                               bat_string label) {
    bat_curve *after = NULL;
    bat_status status = bat_curve_insert_knot(curve, u, times, &after);
    if (status == BAT_KNOTS) {
        bat_notice(c, BAT_STRING_NOTICE_KNOT_FULL);
        return BAT_STATE;
    }
    if (status != BAT_OK) return bat_pointing_told(c, status);
    status = bat_commit_curve(c, p->object, p->curve, after, label);
    if (status != BAT_OK) return bat_pointing_told(c, status);
    p->measured = false;
    bat_pointing_unmark(p);
    double knot;
    if (bat_knot_near(bat_pointing_curve(c, p), u, &knot))
        p->chosen = (bat_handle){BAT_HANDLE_KNOT, p->object, p->curve, 0, knot};
    return BAT_OK;
}

/* Removes `times` copies of a knot if the curve then moves by no more than `within` document units. */
static bat_status take_out(bat_context *c, bat_pointing *p, double u, int times, double within,
                           bat_string label) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    bat_curve *after = NULL;
    int removed = 0;
    double error = 0;
    /* With an unlimited bound it tells what the removal would cost. */
    bat_status status = bat_curve_remove_knot(curve, u, times, bat_curve_size(curve) * 1e6, &after, &removed,
                                              &error);
    if (status != BAT_OK) return bat_pointing_told(c, status);
    if (removed < times) {
        bat_curve_free(after);
        bat_notice(c, BAT_STRING_NOTICE_KNOT_NEEDED);
        return BAT_STATE;
    }
    if (error > within) {
        bat_curve_free(after);
        notice_number(c, BAT_STRING_NOTICE_KNOT_KEPT, error);
        return BAT_STATE;
    }
    status = bat_commit_curve(c, p->object, p->curve, after, label);
    if (status != BAT_OK) return bat_pointing_told(c, status);
    bat_pointing_settle(c, p);
    notice_number(c, BAT_STRING_NOTICE_MOVED_BY, error);
    return BAT_OK;
}

/* The knot that commands act on: the chosen one, or the one nearest to the chosen point. */
static bool meant_knot(const bat_context *c, const bat_pointing *p, double *u) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve || !p->chosen.kind) return false;
    if (p->chosen.kind == BAT_HANDLE_KNOT) {
        *u = p->chosen.u;
        return true;
    }
    return bat_knot_near(curve, p->chosen.u, u);
}

/* Without the knot nearest to the Greville abscissa u, if there is one, in *curve's place; *moved: by how much more it moves at most. */
static bat_status without(bat_curve **curve, double u, int *gone, double *moved) {
    double knot, error = 0;
    bat_curve *after = NULL;
    int removed = 0;
    if (!bat_knot_near(*curve, u, &knot)) return BAT_OK;
    const bat_status status = bat_curve_remove_knot(*curve, knot, 1, bat_curve_size(*curve) * 1e6, &after,
                                                    &removed, &error);
    if (status != BAT_OK) return status;
    bat_curve_free(*curve);
    *curve = after, *gone += removed, *moved += error;
    return BAT_OK;
}

/* All points that are marked, whatever that does to the curve: it is told. The ends of an open curve stay. */
static bat_status delete_marked(bat_context *c, bat_pointing *p, const bat_curve *curve) {
    const int ends = bat_curve_is_closed(curve) ? 0 : 1;
    bat_curve *after = NULL;
    double moved = 0;
    int gone = 0;
    bat_status status = bat_curve_copy(curve, &after);
    for (int i = ends; i < p->marks_size - ends && status == BAT_OK; i++)
        if (p->marks[i]) status = without(&after, bat_handle_greville(curve, i), &gone, &moved);
    if (status == BAT_OK && gone == 0) {
        bat_curve_free(after);
        bat_notice(c, BAT_STRING_NOTICE_KNOT_NEEDED);
        return BAT_STATE;
    }
    if (status != BAT_OK) {
        bat_curve_free(after);
        return bat_pointing_told(c, status);
    }
    status = bat_commit_curve(c, p->object, p->curve, after, BAT_STRING_STEP_DELETE);
    if (status != BAT_OK) return bat_pointing_told(c, status);
    bat_pointing_unmark(p);
    bat_pointing_choose_curve(c, p, p->object, p->curve);
    notice_number(c, BAT_STRING_NOTICE_MOVED_BY, moved);
    return BAT_OK;
}

/* With all its points a curve is gone, and an object with its last curve. */
static bat_status delete_curve(bat_context *c, bat_pointing *p) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_remove_curve(c, p->object, p->curve), BAT_STRING_STEP_DELETE);
    bat_pointing_settle(c, p);
    return bat_pointing_told(c, status);
}

bat_status bat_pointing_delete_knot(bat_context *c, bat_pointing *p) {
    double u;
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (curve && p->marked == p->marks_size && p->marked > 0) return delete_curve(c, p);
    if (curve && p->marked > 1) return delete_marked(c, p, curve);
    if (!p->chosen.kind) return BAT_STATE;
    if (!meant_knot(c, p, &u)) {
        bat_notice(c, BAT_STRING_NOTICE_KNOT_NEEDED);
        return BAT_STATE;
    }
    double within = c->settings->values[BAT_PROPERTY_TOLERANCE] * bat_stage_pixel(c->stage);
    return take_out(c, p, u, 1, within, BAT_STRING_STEP_KNOT_OUT);
}

/* Inserts a knot with no place given: under the pen, or in the middle of the span after what is chosen. */
bat_status bat_pointing_insert_knot(bat_context *c, bat_pointing *p) {
    if (p->hovering && p->hot.kind == BAT_HANDLE_CURVE) {
        bat_pointing_choose_curve(c, p, p->hot.object, p->hot.curve);
        return bat_pointing_insert(c, p, bat_pointing_curve(c, p), p->hot.u, 1, BAT_STRING_STEP_KNOT_IN);
    }
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve) return BAT_STATE;
    double domain[2], from, to;
    bat_curve_domain(curve, domain);
    from = p->chosen.kind ? p->chosen.u : domain[0];
    if (from >= domain[1]) from = domain[0];
    if (p->chosen.kind != BAT_HANDLE_KNOT) { /* a point: the span that contains its Greville abscissa */
        double u, start = domain[0];
        for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL) && u <= from; after = u)
            start = u;
        from = start;
    }
    if (!bat_knot_next(curve, from, &to, NULL)) to = domain[1];
    return bat_pointing_insert(c, p, curve, from + (to - from) / 2, 1, BAT_STRING_STEP_KNOT_IN);
}

bat_status bat_pointing_make_corner(bat_context *c, bat_pointing *p) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    double u;
    if (!curve || !meant_knot(c, p, &u)) return BAT_STATE;
    int more = bat_curve_degree(curve) - bat_knot_held(curve, u);
    if (more <= 0) {
        bat_notice(c, BAT_STRING_NOTICE_CORNER_ALREADY);
        return BAT_STATE;
    }
    bat_status status = bat_pointing_insert(c, p, curve, u, more, BAT_STRING_STEP_CORNER);
    if (status == BAT_OK) p->corner = p->chosen;
    return status;
}

/* Reduces the multiplicity until the curve is C2 (degree 2: C1), whatever the deviation, and reports the deviation. */
bat_status bat_pointing_smooth_corner(bat_context *c, bat_pointing *p) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    double u;
    if (!curve || !meant_knot(c, p, &u)) return BAT_STATE;
    int left = bat_curve_degree(curve) > 2 ? bat_curve_degree(curve) - 2 : 1;
    int less = bat_knot_held(curve, u) - left;
    if (less <= 0) {
        bat_notice(c, BAT_STRING_NOTICE_SMOOTH_ALREADY);
        return BAT_STATE;
    }
    return take_out(c, p, u, less, INFINITY, BAT_STRING_STEP_CORNER_OUT);
}
