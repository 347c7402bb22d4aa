#include "editor/commands/calm.h"
#include "editor/tables/commands.h"
#include "editor/choice/choice.h"
#include "editor/edit/stroke.h"
#include "editor/input/input.h"
#include "editor/pick/pick.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/choice/selection.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/fair.h"
#include <batten/measure.h>
#include <math.h>
#include <stdio.h>

static const double REACH = 24; /* px: reach of the pen for curves */

/* What the command would fair: the range, or the measured stretch, or else the stretch around the pen. */
static const bat_curve *find(bat_context *c, bat_id *object, int *curve, double range[2]) {
    const bat_slot *tool = bat_toolbox_tool(c);
    bat_stretch chosen;
    if (tool->is->stretch && tool->is->stretch(c, tool->state, &chosen)) {
        *object = chosen.object;
        *curve = chosen.curve;
        range[0] = chosen.u[0];
        range[1] = chosen.u[1];
        return bat_edit_target(c->session->document, *object, *curve);
    }
    if (!c->input->pen_near) return NULL;
    double point[2], pixel = bat_stage_pixel(c->stage);
    bat_seen_sync(c);
    bat_stage_seen(c->stage, c->input->pen, point);
    bat_pick pick = bat_pick_nearest(c->scene, point, REACH * pixel);
    if (!pick.object) return NULL;
    const bat_curve *target = bat_edit_target(c->session->document, pick.object, pick.curve);
    *object = pick.object;
    *curve = pick.curve;
    if (target)
        bat_fair_range(target, pick.near.u, c->settings->values[BAT_PROPERTY_BRUSH_SIZE] * pixel, range);
    return target;
}

/* A closed curve faired as a whole takes a second pass, half a period on, for the part that the first one held. */
static bat_status calm(const bat_context *c, const bat_curve *curve, const double range[2], bat_curve **out) {
    double pixel = bat_stage_pixel(c->stage), limit = c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel;
    double domain[2];
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0];
    *out = NULL;
    bat_status status = bat_sketch_calm(curve, range, limit, pixel, out);
    if (!bat_curve_is_closed(curve) || range[1] - range[0] < 0.9 * period) return status;
    if (status != BAT_OK && status != BAT_STATE) return status;
    bat_curve *all = NULL;
    const double rest[2] = {range[0] + period / 2, range[1] + period / 2};
    bat_status second = bat_sketch_calm(*out ? *out : curve, rest, limit, pixel, &all);
    if (second == BAT_OK) {
        bat_curve_free(*out);
        *out = all;
    }
    return second == BAT_STATE ? status : second;
}

/* Within the transaction; *far grows to the farthest that curves have moved. */
static bat_status calm_one(bat_context *c, bat_id object, int index, const double range[2], double *far) {
    const bat_curve *curve = bat_edit_target(c->session->document, object, index);
    bat_curve *calmed = NULL;
    double there = 0, back = 0;
    bat_status status = curve ? calm(c, curve, range, &calmed) : BAT_STATE;
    if (status != BAT_OK) {
        bat_curve_free(calmed);
        return status;
    }
    bat_curve_distance(curve, calmed, 8, &there, &back);
    *far = fmax(*far, fmax(there, back));
    return bat_put_curve(c, object, index, calmed);
}

/* Fairs all curves of the selection; BAT_STATE: none of them has anything left to fair. */
static bat_status calm_selection(bat_context *c, double *far) {
    const bat_document *document = c->session->document;
    bat_status any = BAT_STATE;
    int end = 0; /* of the selected group being walked through */
    bat_seen_sync(c);
    for (int i = 0; i < bat_document_count(document); i++) {
        bat_id id = bat_object_id(bat_document_at(document, i));
        if (bat_selection_has(&c->choice->selection, id)) end = bat_document_end(document, i);
        if (i >= end || bat_seen_out_of_reach(c, i)) continue;
        for (int k = 0; k < bat_object_curve_count(bat_document_at(document, i)); k++) {
            double domain[2];
            bat_curve_domain(bat_object_curve(bat_document_at(document, i), k), domain);
            bat_status status = calm_one(c, id, k, domain, far);
            if (status == BAT_OK) any = BAT_OK;
            if (status != BAT_OK && status != BAT_STATE) return status;
        }
    }
    return any;
}

bat_status bat_command_calm(bat_context *c, bool down) {
    bool was = c->input->calming;
    c->input->calming = false;
    if (bat_toolbox_busy(c) || c->session->transaction.open) return BAT_STATE;
    if (down) {
        c->input->calming = true;
        return BAT_OK;
    }
    if (!was) return BAT_STATE;
    bat_id object;
    int index;
    double range[2], far = 0;
    const bat_curve *curve = find(c, &object, &index, range);
    if (!curve && !c->choice->selection.count) {
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
        return BAT_STATE;
    }
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = curve ? calm_one(c, object, index, range, &far) : calm_selection(c, &far);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_CALM);
    }
    if (status == BAT_STATE) {
        bat_notice(c, BAT_STRING_NOTICE_CALM_ALREADY);
    } else if (status != BAT_OK) {
        bat_notice_failure(c, status);
    } else {
        char number[BAT_UNIT_ROOM];
        bat_unit_about(c, far, number);
        bat_notice_value(c, BAT_STRING_NOTICE_CALMED, number);
    }
    return status;
}

void bat_calm_show(bat_context *c, bat_overlay *overlay) {
    bat_id object;
    int index;
    double range[2];
    const bat_curve *curve = c->input->calming ? find(c, &object, &index, range) : NULL;
    if (!curve) return;
    bat_overlay_item(overlay, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, 5);
    bat_overlay_stretch(overlay, curve, range[0], range[1]);
}
