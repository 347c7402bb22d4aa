#include "editor/edit/breadths.h"
#include "document/kind.h"
#include "editor/edit/profile.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"

#include <math.h>
#include <string.h>

static const double GAP = 1e-4; /* of the length, between two stops */

bool bat_breadths_fit(const bat_object *object) {
    if (!object || !bat_object_is_made_of_curves(object) || bat_object_curve_count(object) == 0) return false;
    const bat_style *style = bat_object_style(object);
    const bat_paint *paint = bat_object_paint(object);
    if (paint && (paint->dash_count || paint->pen[0] != 0 || paint->pen[1] != 0)) return false;
    return style->stroked && style->width > 0 && bat_curve_dimension(bat_object_curve(object, 0)) == 2;
}

void bat_breadths_load(const bat_object *object, bool closed, bat_breadths *out) {
    const bat_paint *paint = bat_object_paint(object);
    *out = (bat_breadths){.closed = closed};
    if (paint && paint->width_count) {
        out->count = paint->width_count;
        memcpy(out->stops, paint->widths, out->count * sizeof *out->stops);
    } else if (!closed) {
        out->count = 2;
        out->stops[0] = (bat_width_stop){0, 1};
        out->stops[1] = (bat_width_stop){1, 1};
    }
}

double bat_breadths_at(const bat_breadths *breadths, double at) {
    const bat_width_profile profile = {breadths->count, breadths->stops};
    double value[2];
    bat_width_eval(&profile, breadths->closed, at, value);
    return value[0];
}

int bat_breadths_add(bat_breadths *breadths, double at) {
    const double share = bat_breadths_at(breadths, at), opposite = at < 0.5 ? at + 0.5 : at - 0.5;
    if (breadths->closed && breadths->count == 0 &&
        bat_width_put(&breadths->count, breadths->stops, opposite, share, 0) < 0)
        return -1;
    return bat_width_put(&breadths->count, breadths->stops, at, share, GAP);
}

/* Round a closed curve: between the neighbours, of which one may be in the next period. */
static int slide_round(bat_breadths *breadths, int index, double at) {
    const int n = (int)breadths->count;
    const bat_width_stop *stops = breadths->stops, stop = stops[index];
    const double before = (index > 0 ? stops[index - 1].at : stops[n - 1].at - 1) + GAP,
                 after = (index + 1 < n ? stops[index + 1].at : stops[0].at + 1) - GAP;
    if (!(before <= after)) return index;
    at = fmin(fmax(at + round(stop.at - at), before), after); /* the nearest of its periods */
    if (at < 0 || at > 1) at -= floor(at);
    bat_width_remove(&breadths->count, breadths->stops, index);
    return bat_width_put(&breadths->count, breadths->stops, at, stop.share, 0);
}

int bat_breadths_slide(bat_breadths *breadths, int index, double at) {
    if (index < 0 || (size_t)index >= breadths->count || !isfinite(at)) return index;
    if (breadths->closed && breadths->count > 1) return slide_round(breadths, index, at);
    const double low = index > 0 ? breadths->stops[index - 1].at + GAP : 0,
                 high = (size_t)index + 1 < breadths->count ? breadths->stops[index + 1].at - GAP : 1;
    if (low <= high)
        bat_width_move(breadths->count, breadths->stops, index, fmin(fmax(at, low), high),
                       breadths->stops[index].share);
    return index;
}

bat_status bat_breadths_put(bat_context *c, bat_id object, size_t count, const bat_width_stop *stops) {
    const int index = bat_document_find(c->session->document, object);
    const bat_object *before = bat_document_at(c->session->document, index);
    if (!before) return BAT_STATE;
    bat_object *after = NULL;
    bat_status status = bat_profile_set(before, count, stops, &after);
    if (status != BAT_OK) return status;
    status = bat_transaction_replace(c, index, after);
    bat_object_release(after);
    return status;
}
