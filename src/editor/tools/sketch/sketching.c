/* The sketch tool's memory: what it keeps, and releasing it. */
#include "editor/input/samples.h"
#include "editor/tools/sketch/parts.h"

void bat_sketching_drop_preview(bat_sketching *s) {
    bat_curve_free(s->preview.curve);
    bat_followers_clear(&s->preview.followers);
    s->preview = (bat_sketching_preview){0};
}

void bat_sketching_drop_session(bat_sketching *s) {
    bat_sketch_live_cancel(s->live);
    s->live = NULL;
    s->fed = 0;
}

void bat_sketching_drop_pending(bat_sketching *s) {
    bat_edit_result_clear(&s->pending_result);
    s->has_pending = false;
}

void bat_sketching_end_stroke(bat_sketching *s) {
    bat_sketching_drop_session(s);
    bat_sketching_drop_preview(s);
    bat_samples_clear(&s->edit.samples);
    s->hold.figure.kind = BAT_FIGURE_NONE;
    s->state = s->has_pending ? BAT_SKETCHING_PENDING : BAT_SKETCHING_IDLE;
    s->preview_due = false;
    bat_meaning_end(&s->meaning);
    s->predicted_count = 0;
    s->hover_changed = true;
}

void bat_sketching_end(void *state) {
    bat_sketching *s = state;
    bat_samples_free(&s->edit.samples);
    bat_samples_free(&s->pending.samples);
    bat_again_free(&s->again);
    bat_hairs_free(&s->hairs);
    bat_kept_free(&s->kept);
    bat_meaning_end(&s->meaning);
}
