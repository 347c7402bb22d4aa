/* Reading the last stroke again, or fitting it anew (again.h): the tool's side, which reports the result. */
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/sketch/parts.h"

/* What was selected after the last stroke comes first. */
const bat_kept_stroke *bat_sketching_offered(const bat_context *c, const bat_sketching *s) {
    const bat_again *again = &s->again;
    if (s->state != BAT_SKETCHING_IDLE || !s->kept.count) return NULL;
    const bool holds = bat_again_holds(c, again);
    if (holds && again->selection == c->choice->selection.version) return NULL;
    const bat_kept_stroke *stroke = bat_kept_offered(c, &s->kept);
    return stroke && !(holds && stroke->serial == again->kept) ? stroke : NULL;
}

bool bat_sketching_readings(const bat_context *c, const bat_sketching *s) {
    return s->state == BAT_SKETCHING_IDLE && bat_again_holds(c, &s->again) && !bat_sketching_offered(c, s);
}

void bat_sketching_keep(const bat_context *c, bat_sketching *s) {
    bat_again *again = &s->again;
    if (!again->count || again->at == again->converged) return;
    again->kept = bat_kept_add(c, &s->kept, &again->edit[again->at], again->amount, again->tolerance,
                               again->kept);
}

/* As one of several careless strokes it remains one of them. */
static void go_on(const bat_context *c, bat_sketching *s) {
    if (s->again.at == s->again.converged) s->hairs.revision = c->session->revision;
}

bat_status bat_sketching_read_as(bat_context *c, bat_sketching *s, int reading) {
    if (!bat_sketching_readings(c, s)) return BAT_STATE;
    bat_status status = bat_again_read(c, &s->again, reading);
    go_on(c, s);
    if (status == BAT_OK) bat_sketching_keep(c, s);
    if (status == BAT_OK)
        bat_notice(c, bat_again_word(&s->again, s->again.at));
    else if (status != BAT_STATE)
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_sketching_refit(bat_context *c, bat_sketching *s, double amount, bool done) {
    const bool other = bat_sketching_offered(c, s), last = bat_sketching_readings(c, s);
    if (!other && !last) return BAT_STATE;
    bat_status status = other ? bat_kept_refit(c, &s->kept, amount, done)
                              : bat_again_refit(c, &s->again, amount, done);
    if (last) go_on(c, s);
    if (last && done && status == BAT_OK) bat_sketching_keep(c, s);
    if (status != BAT_OK && status != BAT_STATE) bat_notice_failure(c, status);
    return status;
}

bat_status bat_sketching_command(bat_context *c, void *state, bat_command_id id) {
    bat_sketching *s = state;
    const bat_again *again = &s->again;
    int step = id == BAT_COMMAND_READING_PREVIOUS ? again->count - 1 : 1;
    if (id != BAT_COMMAND_READING_NEXT && id != BAT_COMMAND_READING_PREVIOUS) return BAT_STATE;
    if (!bat_sketching_readings(c, s) || again->count < 2) return BAT_STATE;
    return bat_sketching_read_as(c, s, (again->at + step) % again->count);
}
