/* A fit that misses the tolerance awaits confirmation. */
#include "editor/session/notice.h"
#include "editor/tools/sketch/parts.h"

void bat_sketching_keep_pending(bat_sketching *s, const bat_edit_result *result,
                                const bat_sketch_report *report) {
    bat_samples spare = s->pending.samples;
    s->pending = s->edit;
    s->pending.accepted = true;
    s->edit.samples = spare;
    s->pending_result = *result;
    s->pending_report = *report;
    s->has_pending = true;
}

bool bat_sketching_accept(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (!s->has_pending) return false;
    bat_edit_result result = s->pending_result;
    s->pending_result = (bat_edit_result){0};
    bat_sketching_drop_pending(s);
    bat_sketching_end_stroke(s);
    bool closed = bat_curve_is_closed(result.curve[0]);
    bat_status status = bat_edit_commit(c, &s->pending, &result);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_notice(c, bat_sketching_outcome(&s->pending, false, closed));
    return true;
}
