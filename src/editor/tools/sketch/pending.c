/* A fit that misses the tolerance awaits confirmation. */
#include "editor/session/notice.h"
#include "editor/tools/sketch/parts.h"

void bat_sketching_keep_pending(bat_sketching *s, bat_curve *curve, const bat_sketch_report *report) {
    bat_samples spare = s->pending.samples;
    s->pending = s->edit;
    s->pending.accepted = true;
    s->edit.samples = spare;
    s->pending_curve = curve;
    s->pending_report = *report;
    s->has_pending = true;
}

bool bat_sketching_accept(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (!s->has_pending) return false;
    bat_curve *curve = s->pending_curve;
    s->pending_curve = NULL;
    bat_sketching_drop_pending(s);
    bat_sketching_end_stroke(s);
    bool closed = bat_curve_is_closed(curve);
    bat_status status = bat_edit_commit(c, &s->pending, curve);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_notice(c, bat_sketching_outcome(&s->pending, false, closed));
    return true;
}
