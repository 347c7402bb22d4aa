/* The width tool: drags. Across the curve they change the width, as much on both sides; a stop that is held by its middle and
 * dragged along the curve moves there. */
#include "editor/choice/choice.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/width/state.h"
#include "editor/view/stage.h"
#include <math.h>

static const double ON_IT = 3; /* px from the curve: the pen is on neither side of it */

/* How far the pen is across the curve at the stop, document units; false: it cannot tell. */
static bool across(const bat_context *c, const bat_object *object, const bat_broadening *b,
                   const double pixel[2], double *out) {
    const bat_width_stop *stop = &b->base.stops[b->held];
    bat_breadth_spot spot;
    double way[2], pen[2];
    if (!bat_broadening_spot(c, object, b->grip.curve, stop->at, stop->share, &spot)) return false;
    bat_stage_look_along(c->stage, 2, spot.point, spot.across, way);
    bat_stage_seen(c->stage, pixel, pen);
    const double square = way[0] * way[0] + way[1] * way[1];
    if (!(square > 1e-6)) return false; /* edge-on */
    *out = ((pen[0] - spot.seen[0][0]) * way[0] + (pen[1] - spot.seen[0][1]) * way[1]) / square;
    return isfinite(*out);
}

/* Whether the pen has gone along the curve rather than across it. */
static bool goes_along(const bat_context *c, const bat_object *object, const bat_broadening *b) {
    const bat_width_stop *stop = &b->base.stops[b->held];
    bat_breadth_spot spot;
    double way[2], from[2], to[2];
    if (!bat_broadening_spot(c, object, b->grip.curve, stop->at, stop->share, &spot)) return false;
    const double along[2] = {spot.across[1], -spot.across[0]};
    double side[2];
    bat_stage_look_along(c->stage, 2, spot.point, along, way);
    bat_stage_look_along(c->stage, 2, spot.point, spot.across, side);
    bat_stage_seen(c->stage, b->start, from);
    bat_stage_seen(c->stage, b->at, to);
    const double d[2] = {to[0] - from[0], to[1] - from[1]};
    return fabs(d[0] * way[0] + d[1] * way[1]) > fabs(d[0] * side[0] + d[1] * side[1]);
}

void bat_broadening_release(bat_broadening *b) { b->pressed = b->dragging = b->sliding = b->due = false; }

void bat_broadening_begin_drag(bat_context *c, bat_broadening *b) {
    const bat_object *object = bat_broadening_object(c, b->grip.object, b->grip.curve);
    bat_status status = object ? BAT_OK : BAT_STATE;
    if (object) {
        bat_broadening_load(object, b->grip.curve, &b->base);
        b->held = b->grip.stop >= 0 ? b->grip.stop : bat_breadths_add(&b->base, b->grip.at);
        if (b->held < 0 || (size_t)b->held >= b->base.count) status = BAT_COUNT;
    }
    if (status == BAT_OK && !across(c, object, b, b->start, &b->from)) status = BAT_STATE;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_broadening_release(b);
        bat_notice_failure(c, status);
        return;
    }
    b->sliding = b->grip.stop >= 0 && b->grip.middle && goes_along(c, object, b);
    b->half = 0.5 * b->base.stops[b->held].share * bat_object_style(object)->width;
    bat_broadening_choose(c, b, b->grip.object, b->grip.curve);
    bat_broadening_choose_at(b, -1, b->base.stops[b->held].at);
    b->dragging = true;
}

/* The width follows the pen: it grows by as much on either side as the pen moves away from the curve; around it by what the level that is
 * pulled tells. */
static bool broaden(bat_context *c, const bat_object *object, const bat_broadening *b, bat_breadths *breadths,
                    int *stop) {
    double now;
    *stop = b->held;
    if (!across(c, object, b, b->at, &now)) return false;
    const bool beside = fabs(b->from) > ON_IT * bat_stage_pixel(c->stage);
    const double out = beside ? (b->from > 0 ? now - b->from : b->from - now) : fabs(now) - fabs(b->from);
    const double share = 2 * (b->half + out) / bat_object_style(object)->width;
    if (!isfinite(share)) return false;
    bat_breadths_pull(breadths, b->held, share, bat_broadening_pulled(b));
    return true;
}

static bool slide(bat_context *c, const bat_object *object, const bat_broadening *b, bat_breadths *breadths,
                  int *stop) {
    double point[2];
    bat_near near;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, b->at, point);
    if (!bat_pick_on(c->scene, b->grip.object, b->grip.curve, point, &near)) return false;
    *stop = bat_breadths_slide(breadths, b->held, bat_broadening_share(object, b->grip.curve, near.u));
    return true;
}

void bat_broadening_drag(bat_context *c, bat_broadening *b) {
    if (!b->dragging || !b->due) return;
    b->due = false;
    const bat_object *object = bat_broadening_object(c, b->grip.object, b->grip.curve);
    bat_breadths breadths = b->base;
    int stop = b->held;
    if (object && !(b->sliding ? slide : broaden)(c, object, b, &breadths, &stop)) return;
    const bat_status status = object ? bat_breadths_put(c, b->grip.object, breadths.count, breadths.stops)
                                     : BAT_STATE;
    if (status == BAT_OK) {
        bat_broadening_keep(c, b, &breadths, stop);
        return;
    }
    bat_broadening_release(b);
    bat_transaction_cancel(c);
    bat_notice_failure(c, status);
}
