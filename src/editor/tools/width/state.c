/* The width tool: the curve and the stop that are chosen, and places along a stroke. */
#include "editor/tools/width/state.h"
#include "base/real.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include <batten/measure.h>
#include <math.h>

static const double FINE = 1e-6; /* relative, of lengths */

bat_broadening *bat_broadening_of(const bat_context *c) {
    return bat_toolbox_that(c, BAT_EDITS_WIDTHS)->state;
}

const bat_object *bat_broadening_object(const bat_context *c, bat_id id, int curve) {
    const bat_object *object =
        id ? bat_document_at(c->session->document, bat_document_find(c->session->document, id)) : NULL;
    return bat_breadths_fit(object) && bat_object_curve(object, curve) ? object : NULL;
}

void bat_broadening_choose(bat_context *c, bat_broadening *b, bat_id object, int curve) {
    if (b->object != object || b->curve != curve) b->chosen = false;
    b->object = b->adopted = object;
    b->curve = curve;
    bat_selection_clear(&c->choice->selection);
    if (object) bat_selection_add(&c->choice->selection, object); /* out of memory: not selected */
}

void bat_broadening_load(const bat_object *object, int curve, bat_breadths *out) {
    bat_breadths_load(object, bat_curve_is_closed(bat_object_curve(object, curve)), out);
}

void bat_broadening_settle(bat_context *c, bat_broadening *b) {
    const bat_selection *selection = &c->choice->selection;
    if (selection->count == 1 &&
        selection->ids[0] != b->adopted) { /* what has been selected elsewhere, once */
        b->object = b->adopted = selection->ids[0];
        b->curve = 0;
        b->chosen = false;
    }
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    if (!object || bat_seen_out_of_reach(c, bat_document_find(c->session->document, b->object))) {
        b->object = 0;
        b->chosen = false;
    }
    if (!b->chosen || b->stop < 0) return;
    bat_breadths breadths;
    bat_broadening_load(object, b->curve, &breadths);
    b->chosen = (size_t)b->stop < breadths.count;
}

void bat_broadening_choose_at(bat_broadening *b, int stop, double place) {
    b->chosen = true;
    b->stop = stop;
    b->place = place;
}

void bat_broadening_keep(const bat_context *c, bat_broadening *b, const bat_breadths *breadths, int stop) {
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    bat_breadths now;
    b->chosen = object && stop >= 0 && (size_t)stop < breadths->count;
    if (!b->chosen) return;
    bat_broadening_load(object, b->curve, &now);
    bat_broadening_choose_at(b, now.count == breadths->count ? stop : -1, breadths->stops[stop].at);
}

int bat_broadening_chosen(const bat_context *c, const bat_broadening *b, bat_breadths *out) {
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    if (!object) return -1;
    bat_broadening_load(object, b->curve, out);
    if (!b->chosen) return -1;
    if (b->stop < 0) return bat_breadths_add(out, b->place);
    return (size_t)b->stop < out->count ? b->stop : -1;
}

double bat_broadening_length(const bat_object *object, int curve) {
    double domain[2];
    bat_curve_domain(bat_object_curve(object, curve), domain);
    return bat_curve_length(bat_object_curve(object, curve), domain[0], domain[1], FINE);
}

double bat_broadening_share(const bat_object *object, int curve, double u) {
    double domain[2];
    bat_curve_domain(bat_object_curve(object, curve), domain);
    const double length = bat_broadening_length(object, curve);
    if (!(length > 0)) return 0;
    return fmin(fmax(bat_curve_length(bat_object_curve(object, curve), domain[0], u, FINE) / length, 0), 1);
}

bool bat_broadening_spot(const bat_context *c, const bat_object *object, int which, double at, double share,
                         bat_breadth_spot *out) {
    const bat_curve *curve = bat_object_curve(object, which);
    double domain[2], jet[4];
    bat_curve_domain(curve, domain);
    const double far = at * bat_broadening_length(object, which);
    const double u = at < 1 ? bat_curve_at_length(curve, domain[0], far, FINE) : domain[1];
    if (at < 1)
        bat_curve_eval(curve, fmin(u, domain[1]), 1, jet);
    else
        bat_curve_eval_left(curve, u, 1, jet);
    const double speed = bat_hypot(jet[2], jet[3]);
    out->point[0] = jet[0], out->point[1] = jet[1];
    out->across[0] = speed > 0 ? -jet[3] / speed : 0, out->across[1] = speed > 0 ? jet[2] / speed : 1;
    out->half = 0.5 * share * bat_object_style(object)->width;
    bool seen = true;
    for (int k = 0; k < 3; k++) {
        const double side = k == 1 ? out->half : k == 2 ? -out->half : 0;
        const double place[2] = {out->point[0] + side * out->across[0],
                                 out->point[1] + side * out->across[1]};
        seen = seen && bat_stage_look(c->stage, 2, place, out->seen[k]);
    }
    return seen;
}
