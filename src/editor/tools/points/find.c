/* The points tool: what lies under the pen. */
#include "editor/tools/points/state.h"
#include "base/real.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/view/stage.h"

static const double HANDLE_REACH = 9, CURVE_REACH = 10, HANDLE_LEAD = 5; /* px */
static const double TOUCH = 2.2;                                         /* factor on the reach for fingers */

static double reach(const bat_context *c, const bat_pointing *p, double pixels) {
    double factor = p->device == BAT_DEVICE_TOUCH ? TOUCH : 1;
    return pixels * factor * bat_stage_pixel(c->stage);
}

/* Whether the handle is an end control point of an open curve, which fixes its end. */
static bool is_end(const bat_curve *curve, const bat_handle *handle) {
    bool last = handle->index == 0 || handle->index == bat_point_count(curve) - 1;
    return handle->kind == BAT_HANDLE_POINT && last && !bat_curve_is_closed(curve);
}

/* The handle at the point. A handle beside the curve yields to the curve when the pen is on the curve: otherwise the
 * curve could not be pulled where its control polygon is close to it. */
static bool handle_at(const bat_context *c, const bat_pointing *p, const bat_curve *curve,
                      const double point[2], const bat_pick *pick, bat_handle *out) {
    double at[2];
    if (!bat_handle_find(curve, c->stage, point, reach(c, p, HANDLE_REACH), out)) return false;
    if (!pick->object || is_end(curve, out)) return true;
    bat_handle_seen(curve, c->stage, out, at);
    double distance = bat_hypot(at[0] - point[0], at[1] - point[1]);
    return distance <= pick->near.distance + reach(c, p, HANDLE_LEAD);
}

/* What a press here would grab: handles of the displayed curve before curves. */
bat_handle bat_pointing_find(bat_context *c, bat_pointing *p, const double pixel[2]) {
    double point[2];
    bat_handle handle = {0};
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    bat_pick pick = bat_pick_curve(c->scene, 0, point, reach(c, p, CURVE_REACH));
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (curve && handle_at(c, p, curve, point, &pick, &handle)) {
        handle.object = p->object;
        handle.curve = p->curve;
        return handle;
    }
    if (!pick.object) return (bat_handle){0};
    curve = bat_edit_target_in(c->session->document, 0, pick.object, pick.curve);
    if (!curve || !handle_at(c, p, curve, point, &pick, &handle)) {
        handle.kind = BAT_HANDLE_CURVE;
        handle.index = 0;
        handle.u = pick.near.u;
    }
    handle.object = pick.object;
    handle.curve = pick.curve;
    return handle;
}
