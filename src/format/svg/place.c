/* Notes what each element became, so that the file can be written again with nothing changed but what was edited. */
#include "document/document.h"
#include "format/svg/walk.h"

#include <stdlib.h>
#include <string.h>

static bat_sourced *add(bat_svg_walk *w) {
    if (w->place_count == w->place_room) {
        const int room = w->place_room < 64 ? 64 : 2 * w->place_room;
        bat_sourced *grown = realloc(w->places, (size_t)room * sizeof *grown);
        if (!grown) {
            w->status = BAT_MEMORY;
            return NULL;
        }
        w->places = grown;
        w->place_room = room;
    }
    bat_sourced *made = &w->places[w->place_count++];
    memset(made, 0, sizeof *made);
    return made;
}

void bat_svg_place(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, const double inner[6]) {
    if (!w->keeps || w->copied) return;
    bat_sourced *made = add(w);
    if (!made) return;
    w->place = w->place_count - 1;
    made->element = element;
    made->opacity = outer->opacity;
    memcpy(made->outer, outer->matrix, sizeof made->outer);
    memcpy(made->inner, inner, sizeof made->inner);
}

void bat_svg_place_object(bat_svg_walk *w, const bat_object *object) {
    if (!w->keeps || w->place_count == 0) return;
    bat_sourced *at = &w->places[w->place];
    if (w->copied) {
        const bat_sourced from = *at;
        at = add(w);
        if (!at) return;
        *at = from;
        at->copied = true;
    }
    at->id = bat_object_id(object);
    at->boxed = w->boxed;
}
