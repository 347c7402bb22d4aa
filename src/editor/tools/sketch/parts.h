/* What the files of the sketch tool share. s, state: the tool's state (sketching.h). */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_PARTS_H
#define BATTEN_EDITOR_TOOLS_SKETCH_PARTS_H

#include "editor/tools/sketch/sketching.h"
#include "editor/tools/tool.h"

/* ---- sketching.c: memory ---- */
void bat_sketching_drop_preview(bat_sketching *s);
void bat_sketching_drop_session(bat_sketching *s);
void bat_sketching_drop_pending(bat_sketching *s);
/* Resets the stroke under the pen; the memory of the samples is kept. */
void bat_sketching_end_stroke(bat_sketching *s);
void bat_sketching_end(void *state);

/* ---- hover.c: the pen above the drawing ---- */
bat_pick bat_sketching_pick_at(bat_context *c, const double pixel[2], bat_device device);
/* Where a stroke lands that begins at the pixel, at the pick: on the ground of its curve, else on the one in use. */
bat_stage bat_sketching_stage(const bat_context *c, const bat_pick *pick, const double pixel[2]);
/* The ruled surface that it lands on, translucent. */
void bat_sketching_show_ground(const bat_context *c, const bat_stage *stage, bat_overlay *overlay);
void bat_sketching_hover(bat_context *c, void *state, const bat_pointer *event);
void bat_sketching_leave(bat_context *c, void *state);
void bat_sketching_look(bat_context *c, bat_sketching *s); /* once per frame: picks anew if needed */
void bat_sketching_highlight(const bat_context *c, bat_overlay *overlay, int dimension, bat_id object,
                             int curve);
bat_cursor bat_sketching_cursor(const bat_context *c, const void *state);
bool bat_sketching_focus(const bat_context *c, const void *state, bat_focus *out);

/* ---- drawing.c: the pen is down ---- */
/* Until more is known a stroke is a new curve; forced: it redraws what was picked. */
void bat_sketching_begin(bat_context *c, bat_sketching *s, const bat_pointer *event, bat_pick pick,
                         bool forced);
void bat_sketching_down(bat_context *c, void *state, const bat_pointer *event);
void bat_sketching_move(bat_context *c, void *state, const bat_pointer *event);
void bat_sketching_start_smoothing(bat_sketching *s);
void bat_sketching_update_stroke(bat_context *c, bat_sketching *s); /* once per frame */
static inline bool bat_sketching_smooths_nothing(const bat_sketching *s) {
    return s->smoothing && s->edit.kind == BAT_EDIT_NEW;
}

/* ---- preview.c: the fit so far ---- */
/* Whether the fit is of one curve that changes; otherwise the stroke itself is shown as a curve. */
bool bat_sketching_one_changes(const bat_edit *edit);
/* Feeds new samples to the session; starts it when needed. */
bat_status bat_sketching_feed(bat_context *c, bat_sketching *s);
void bat_sketching_refresh_preview(bat_context *c, bat_sketching *s);
/* Whether the stroke is one of several careless ones: what they mean together, and the curve that it makes of the
 * edit's. */
bool bat_sketching_converged(const bat_context *c, const bat_sketching *s, bat_together *together,
                             bat_curve **curve, bat_sketch_report *report);

/* ---- finish.c: the pen is lifted ---- */
void bat_sketching_up(bat_context *c, void *state, const bat_pointer *event);

/* ---- said.c: messages ---- */
bat_string bat_sketching_outcome(const bat_edit *edit, bool strayed, bool closed);
void bat_sketching_say_done(bat_context *c, const bat_edit *edit, const bat_sketch_report *report,
                            bool strayed, bool closed);
void bat_sketching_say_failed(bat_context *c, const bat_sketching *s, bat_status status);
/* How many samples did not land; refused: so many that the stroke was; left: it went on beside its surface. */
void bat_sketching_say_dropped(bat_context *c, const bat_sketching *s, bool refused, bool left);

/* ---- pending.c: a fit that awaits confirmation ---- */
void bat_sketching_keep_pending(bat_sketching *s, const bat_edit_result *result,
                                const bat_sketch_report *report);
bool bat_sketching_accept(bat_context *c, void *state); /* false: nothing awaits confirmation */

/* ---- traced.c: a stroke without a pen ---- */
bat_status bat_sketching_trace(bat_context *c, void *state, const bat_traced *stroke);
bat_status bat_sketching_lift(bat_context *c, void *state, const bat_traced *stroke);

/* ---- halo.c: the halo around a line ---- */
/* How wide a line is seen where it is widest, view pixels. */
float bat_sketching_width(const bat_context *c, const bat_style *style, const bat_width_profile *profile);
/* Begins a faint item in the accent around a line of that width: on either side at most half as wide again. */
void bat_sketching_halo(bat_overlay *overlay, bat_role role, float width);

/* ---- show.c: the overlay ---- */
void bat_sketching_show_stroke(bat_context *c, bat_sketching *s, bat_overlay *overlay);
void bat_sketching_show_pending(const bat_context *c, const bat_sketching *s, bat_overlay *overlay);
/* The last stroke with the new amount, over its present state; with symmetry, on both sides. */
void bat_sketching_show_refit(bat_context *c, const bat_sketching *s, bat_overlay *overlay);

/* ---- hint.c: what it does, as text ---- */
bat_string bat_sketching_hint(const bat_context *c, const void *state);

/* ---- reread.c: the last stroke, read again ---- */
/* The step that it has made is kept for refitting. */
void bat_sketching_keep(const bat_context *c, bat_sketching *s);
bat_status bat_sketching_command(bat_context *c, void *state, bat_command_id id);

#endif
