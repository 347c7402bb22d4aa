/* What is drawn in a marker: shapes, apart from the document. */
#include "format/svg/digest.h"
#include "format/svg/walk.h"

static bat_marker_ink ink_of(const bat_svg_paint *paint) {
    return paint->kind == BAT_PAINT_CONTEXT_FILL     ? BAT_INK_FILL
           : paint->kind == BAT_PAINT_CONTEXT_STROKE ? BAT_INK_STROKE
                                                     : BAT_INK_OWN;
}

void bat_svg_collect(bat_svg_walk *w, const bat_svg_scope *s, bat_object *object) {
    bat_svg_collected *to = w->collected;
    if (!s || !bat_object_is_made_of_curves(object) || to->count == BAT_MARKER_PARTS_MAX) {
        to->whole = false;
        bat_object_release(object);
        return;
    }
    w->digest = bat_svg_digest_inks(w->digest, ink_of(&s->style.fill), ink_of(&s->style.stroke));
    to->list[to->count++] = (bat_marker_part){object, ink_of(&s->style.fill), ink_of(&s->style.stroke)};
}
