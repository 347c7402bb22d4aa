/* What the pen is doing, or would do, as text. */
#include "editor/tables/tables.h"
#include "editor/tools/sketch/parts.h"

static bat_string doing(const bat_edit *edit) {
    static const bat_string hints[BAT_EDIT_COUNT] = {[BAT_EDIT_NEW] = BAT_STRING_HINT_DRAWING,
                                                     [BAT_EDIT_REDRAW] = BAT_STRING_HINT_REDRAWING,
                                                     [BAT_EDIT_SMOOTH] = BAT_STRING_HINT_SMOOTHING,
                                                     [BAT_EDIT_JOIN] = BAT_STRING_HINT_JOINING,
                                                     [BAT_EDIT_LEVEL] = BAT_STRING_HINT_REDRAWING,
                                                     [BAT_EDIT_EXTEND] = BAT_STRING_HINT_EXTENDING,
                                                     [BAT_EDIT_CLOSE] = BAT_STRING_HINT_CLOSING,
                                                     [BAT_EDIT_SEVERAL] = BAT_STRING_HINT_REDRAWING_SEVERAL};
    bool closes = edit->kind == BAT_EDIT_NEW && edit->meaning.closing == BAT_CLOSING_YES;
    return closes ? BAT_STRING_HINT_CLOSING : hints[edit->kind];
}

bat_string bat_sketching_hint(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    if (s->has_pending) return BAT_STRING_HINT_PENDING;
    if (s->state == BAT_SKETCHING_DRAWING) {
        if (s->hold.figure.kind != BAT_FIGURE_NONE) return BAT_STRING_HINT_HELD;
        if (bat_sketching_smooths_nothing(s)) return BAT_STRING_HINT_SMOOTH_NOTHING;
        if (s->edit.kind == BAT_EDIT_SMOOTH) return BAT_STRING_HINT_SMOOTHING;
        if (s->preview.converges) return BAT_STRING_HINT_CONVERGING;
        if (s->preview.status == BAT_FAR) return BAT_STRING_HINT_STRAYED;
        return doing(&s->edit);
    }
    if (c->modifiers & BAT_ALT)
        return s->pick.object ? BAT_STRING_HINT_SMOOTH : BAT_STRING_HINT_SMOOTH_NOTHING;
    int level = -1;
    if (bat_meaning_level(c, s->pick.object, s->pick.curve, &level) && level >= 0)
        return BAT_STRING_HINT_LEVEL_SKETCH;
    return s->pick.object ? BAT_STRING_HINT_REDRAW : BAT_STRING_HINT_NEW;
}
