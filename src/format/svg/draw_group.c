/* Groups, layers, and switches. */
#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/nesting.h"
#include "document/object.h"
#include "format/svg/digest.h"
#include "format/svg/walk.h"

#include <string.h>

/* The opacity is part of what is drawn, whether the group will be needed or not. */
static bat_status make_group(bat_svg_walk *w, uint32_t element, bat_id id, bool layer, double opacity,
                             bat_object **out) {
    bat_object *plain = NULL;
    bat_status status = bat_object_create_group(id, bat_svg_find_name(w, element), layer, &plain);
    if (status != BAT_OK || opacity == 1) {
        *out = plain;
        return status;
    }
    if (!w->unseen) w->digest = bat_svg_digest_group(w->digest, opacity);
    status = bat_object_faded(plain, opacity, out); /* a new one is opaque */
    bat_object_release(plain);
    return status;
}

/* The only member of a group that is not needed has its opacity. */
static void fade_member(bat_svg_walk *w, int index, double opacity) {
    bat_object *faded = NULL;
    const bat_status status = bat_object_faded(bat_document_at(w->document, index), opacity, &faded);
    if (faded) bat_document_replace(w->document, index, faded);
    bat_object_release(faded);
    if (status != BAT_OK && w->status == BAT_OK) w->status = status;
}

/* In a marker: it is no group of the document. */
static void draw_collected(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const int before = w->collected->count;
    bat_svg_draw_children(w, element, s);
    if (s->style.opacity < 1 && w->collected->count > before + 1)
        bat_svg_note(&w->notes, element, BAT_LOSS_OPACITY);
    if (s->boxed) bat_svg_note(&w->notes, element, BAT_LOSS_CLIP);
}

/* A group that is not needed gives way to what is in it. Returns how many members there are then. */
static int dissolve(bat_svg_walk *w, const bat_svg_scope *s, int index, bat_id above, int members) {
    bat_object *moved = NULL;
    bat_document_remove(w->document, index);
    if (w->members == 1) {
        w->status = bat_object_with_parent(bat_document_at(w->document, index), above, &moved);
        if (moved) bat_document_replace(w->document, index, moved);
        bat_object_release(moved);
        if (s->opacity < 1) fade_member(w, index, s->opacity);
    }
    return members - 1 + w->members;
}

/* A group in the file becomes a group in the document when it is a layer, has several members, or has one
 * member and a name or is hidden or locked. The others only carry a transform or a style. */
void bat_svg_draw_group(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const char *mode = bat_svg_attribute_of(w, element, "inkscape:groupmode");
    static const double none[4] = {0, 0, 0, 0};
    bat_object *group = NULL;
    const bat_object *outer = bat_document_at(w->document, bat_document_find(w->document, w->group));
    bool layer = mode && !strcmp(mode, "layer") && (!outer || bat_object_is(outer, BAT_LAYER));
    if (w->collected) {
        draw_collected(w, element, s);
        return;
    }
    if (w->groups == BAT_NESTING_MAX) {
        const long before = w->put;
        bat_svg_draw_children(w, element, s);
        if (s->style.opacity < 1 && w->put > before + 1) bat_svg_note(&w->notes, element, BAT_LOSS_OPACITY);
        return;
    }
    bat_id above = w->group, own = bat_document_new_id(w->document);
    int index = bat_document_count(w->document), members = w->members + 1;
    bat_status status = make_group(w, element, own, layer, s->opacity, &group);
    if (status != BAT_OK) {
        w->status = status;
        return;
    }
    bat_svg_scope around = *s; /* with the mask, as soon as it can be painted */
    around.clip = bat_clip_retain(s->clip);
    const bool waits = s->mask && bat_svg_mask_is_boxed(w, s);
    if (s->mask && !waits) bat_svg_mask_paint(w, element, none, &around);
    w->boxed = s->boxed || waits;
    bat_svg_put_object(w, element, s->style.shown, group);
    if (w->status != BAT_OK) {
        bat_clip_release(around.clip);
        return;
    }
    const bool clipped = around.clip || s->boxed || waits;
    if (around.clip_digest && !w->unseen) w->digest = bat_digest_number(w->digest, around.clip_digest);
    w->group = own;
    w->members = 0;
    w->groups++;
    bat_svg_scope inner = *s;
    inner.opacity = 1;
    inner.clip = inner.boxed = NULL;
    inner.clip_digest = 0;
    w->given[w->depth - 1] = (uint8_t)((s->style.opacity < 1 ? BAT_SVG_ITS_OPACITY : 0) |
                                       (s->clip || s->boxed ? BAT_SVG_ITS_CLIP : 0) |
                                       (s->mask ? BAT_SVG_ITS_MASK : 0));
    bat_svg_draw_children(w, element, &inner);
    w->groups--;
    w->group = above;
    const bat_object *made = bat_document_at(w->document, index);
    bool plain = !layer && !clipped && !*bat_object_name(made) && !bat_object_is_hidden(made) &&
                 !bat_object_is_locked(made);
    if (w->status == BAT_OK && ((w->members == 1 && plain) || (w->members == 0 && !layer)))
        members = dissolve(w, s, index, above, members);
    if (w->status == BAT_OK && bat_document_find(w->document, own) == index)
        bat_svg_clip_group(w, element, &around, index);
    bat_clip_release(around.clip);
    w->members = members;
}

/* True: one of the comma-separated language tags is "en" or begins with "en-"; NULL: for every language. */
static bool for_english(const char *tags) {
    if (!tags) return true;
    while (*tags) {
        tags += strspn(tags, " \t\n\r,");
        const size_t size = strcspn(tags, " \t\n\r,");
        if (size >= 2 && (tags[0] | 32) == 'e' && (tags[1] | 32) == 'n' && (size == 2 || tags[2] == '-'))
            return true;
        tags += size;
    }
    return false;
}

/* Draws the first child that is supported, requires no extensions, and is for English or for every language. */
void bat_svg_draw_switch(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    for (uint32_t at = w->tree->elements[element].first; at; at = w->tree->elements[at].next) {
        bat_svg_kind kind = (bat_svg_kind)w->tree->elements[at].kind;
        if (kind == BAT_SVG_UNKNOWN || kind == BAT_SVG_OTHER || kind >= BAT_SVG_NEVER) continue;
        if (bat_svg_attribute_of(w, at, "requiredExtensions") ||
            !for_english(bat_svg_attribute_of(w, at, "systemLanguage")))
            continue;
        w->draw(w, at, s);
        return;
    }
}
