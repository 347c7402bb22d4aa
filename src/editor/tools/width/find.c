/* The width tool: what lies under the pen. */
#include "base/real.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tools/width/state.h"
#include "editor/view/stage.h"
#include <math.h>

static const double HANDLE_REACH = 9, CURVE_REACH = 10; /* px */
static const double TOUCH = 2.2;                        /* factor on the reach for fingers */

static double reach(const bat_context *c, const bat_broadening *b, double pixels) {
    return pixels * (b->device == BAT_DEVICE_TOUCH ? TOUCH : 1) * bat_stage_pixel(c->stage);
}

/* The stop whose middle or handles are nearest. */
static bool stop_at(const bat_context *c, const bat_object *object, int curve, const double point[2],
                    double within, bat_breadth_hit *out) {
    bat_breadths breadths;
    bat_broadening_load(object, curve, &breadths);
    *out = (bat_breadth_hit){bat_object_id(object), curve, -1, false, 0};
    for (size_t i = 0; i < breadths.count; i++) {
        const bat_width_stop *stop = &breadths.stops[i];
        bat_breadth_spot spot;
        if (!bat_broadening_spot(c, object, curve, stop->at, stop->share, &spot)) continue;
        for (int k = 2; k >= 0; k--) { /* of two at one place the middle, which can do both */
            const double far = bat_hypot(spot.seen[k][0] - point[0], spot.seen[k][1] - point[1]);
            if (far > within) continue;
            within = far;
            out->stop = (int)i, out->at = stop->at, out->middle = k == 0;
        }
    }
    return out->stop >= 0;
}

/* A place between stops: on the curve, or where its stroke covers the point. */
static bool place_on(bat_context *c, const bat_broadening *b, const bat_object *object, int curve,
                     const double point[2], bat_breadth_hit *out) {
    bat_near near;
    bat_breadths breadths;
    bat_breadth_spot spot;
    if (!object || !bat_pick_on(c->scene, bat_object_id(object), curve, point, &near)) return false;
    bat_broadening_load(object, curve, &breadths);
    const double at = bat_broadening_share(object, curve, near.u);
    if (!bat_broadening_spot(c, object, curve, at, bat_breadths_at(&breadths, at), &spot)) return false;
    const double half = bat_hypot(spot.seen[1][0] - spot.seen[0][0], spot.seen[1][1] - spot.seen[0][1]);
    *out = (bat_breadth_hit){bat_object_id(object), curve, -1, near.distance < half / 2, at};
    return near.distance <= half + reach(c, b, CURVE_REACH);
}

bat_breadth_hit bat_broadening_find(bat_context *c, const bat_broadening *b, const double pixel[2]) {
    double point[2];
    bat_breadth_hit hit;
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    const bat_object *own = bat_broadening_object(c, b->object, b->curve);
    if (own && stop_at(c, own, b->curve, point, reach(c, b, HANDLE_REACH), &hit)) return hit;
    if (own && place_on(c, b, own, b->curve, point, &hit)) return hit;
    const bat_pick pick = bat_pick_curve(c->scene, 2, point, reach(c, b, CURVE_REACH));
    const int covered = pick.object ? -1 : bat_pick_object(c->scene, point, 0);
    const bat_object *other = bat_broadening_object(
        c, covered < 0 ? pick.object : bat_object_id(bat_document_at(c->session->document, covered)),
        pick.curve);
    if (other && stop_at(c, other, pick.curve, point, reach(c, b, HANDLE_REACH), &hit)) return hit;
    return place_on(c, b, other, pick.curve, point, &hit) ? hit : (bat_breadth_hit){.stop = -1};
}
