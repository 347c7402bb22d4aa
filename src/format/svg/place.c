/* Notes what each element became, so that the file can be written again with nothing changed but what was edited. */
#include "document/document.h"
#include "format/svg/geometry.h"

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

/* All are opaque as long as nothing else is known. */
static bool note_opacity(bat_svg_walk *w, uint32_t element, double opacity) {
    if (!w->opacities) {
        w->opacities = malloc(w->tree->count * sizeof *w->opacities);
        for (uint32_t i = 0; w->opacities && i < w->tree->count; i++) w->opacities[i] = 1;
    }
    if (w->opacities) w->opacities[element] = opacity;
    return w->opacities != NULL;
}

void bat_svg_place(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer,
                   const bat_svg_scope *inner) {
    if (!w->keeps || w->copied) return;
    bat_sourced *made = add(w);
    if (!made || !note_opacity(w, element, inner->style.opacity)) {
        w->status = BAT_MEMORY;
        return;
    }
    w->place = w->place_count - 1;
    made->element = element;
    made->opacity = made->own = 1;
    made->declared = (uint8_t)bat_svg_geometry_declared(&inner->style);
    if (bat_svg_attribute_of(w, element, "transform-origin")) made->declared |= BAT_DECLARED_MATRIX;
    memcpy(made->outer, outer->matrix, sizeof made->outer);
    memcpy(made->inner, inner->matrix, sizeof made->inner);
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
        at->lost = 0;
        for (int i = w->depth - 1; i >= 0 && w->active[i] != from.element; i--)
            at->lost |= bat_svg_noted(&w->notes, w->active[i]);
    }
    at->id = bat_object_id(object);
    at->boxed = w->boxed;
}

/* ---- where elements stand in the text ---- */

bat_status bat_svg_match(const char *text, size_t size, const bat_svg_tree *tree, bat_svg_tags *tags,
                         bool *out) {
    const bat_status status = bat_svg_tags_scan(text, size, tags);
    *out = false;
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_OK;
    bool same = tags->count == tree->count;
    for (uint32_t i = 1; same && i < tags->count; i++) {
        const char *tag = text + tags->list[i].open, *name = bat_svg_tree_name(tree, i);
        const size_t length = bat_svg_tag_name(tag, tags->list[i].body - tags->list[i].open),
                     local = strlen(name);
        same = tags->list[i].parent == tree->elements[i].parent && length >= local &&
               memcmp(tag + 1 + length - local, name, local) == 0;
    }
    *out = same;
    return BAT_OK;
}

/* The elements of style sheets. */
static bool list_styles(bat_svg_walk *w) {
    uint32_t count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t i = 1; i < w->tree->count; i++) {
            if (w->tree->elements[i].kind != BAT_SVG_STYLE) continue;
            if (pass) w->styles[w->style_count++] = i;
            count += !pass;
        }
        if (!pass && !(w->styles = malloc((count + 1) * sizeof *w->styles))) return false;
    }
    return true;
}

bool bat_svg_may_stand_alone(bat_svg_walk *w) {
    if (w->scanned || !w->text) return w->text != NULL;
    bool same = false;
    bat_status status = bat_svg_match(w->text, w->text_size, w->tree, &w->tags, &same);
    w->scanned = true;
    if (status == BAT_OK && same) {
        w->stamps = calloc(w->tree->count, sizeof *w->stamps);
        if (!w->stamps || !list_styles(w)) status = BAT_MEMORY;
    }
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK || !same) w->text = NULL;
    return w->text != NULL;
}

void bat_svg_stand_free(bat_svg_walk *w) {
    bat_svg_tags_free(&w->tags);
    free(w->stamps);
    free(w->styles);
}
