/* Reading the last stroke again, or fitting it anew (again.h): the tool's side, which reports the result. */
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/sketch/parts.h"

bool bat_sketching_readings(const bat_context *c, const bat_sketching *s) {
    return s->state == BAT_SKETCHING_IDLE && bat_again_holds(c, &s->again);
}

/* As one of several careless strokes it remains one of them. */
static void go_on(const bat_context *c, bat_sketching *s) {
    if (s->again.at == s->again.converged) s->hairs.revision = c->session->revision;
}

bat_status bat_sketching_read_as(bat_context *c, bat_sketching *s, int reading) {
    if (!bat_sketching_readings(c, s)) return BAT_STATE;
    bat_status status = bat_again_read(c, &s->again, reading);
    go_on(c, s);
    if (status == BAT_OK)
        bat_notice(c, bat_again_word(&s->again, s->again.at));
    else if (status != BAT_STATE)
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_sketching_refit(bat_context *c, bat_sketching *s, double amount, bool done) {
    if (!bat_sketching_readings(c, s)) return BAT_STATE;
    bat_status status = bat_again_refit(c, &s->again, amount, done);
    go_on(c, s);
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
