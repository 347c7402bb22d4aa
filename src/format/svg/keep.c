/* The file is kept with the document that was read from it. */
#include "base/matrix.h"
#include "document/digest.h"
#include "document/document.h"
#include "format/svg/alone.h"
#include "format/svg/markup.h"
#include "format/svg/reader.h"
#include "format/svg/svg.h"
#include "format/svg/tags.h"
#include "format/svg/walk.h"

#include <stdlib.h>
#include <string.h>

/* Foreign content of a native document may have been moved before it was saved, and the file's element with it: what counts
 * from now on is how far it is moved from where it is. */
static void place_foreign(bat_sourced *entry, const bat_object *object) {
    double read[6], back[6], first[6], was[6];
    if (!bat_drawing_matrix(bat_object_picture(object), first) ||
        !bat_svg_inverse(bat_object_matrix(object), back))
        return;
    memcpy(read, entry->inner, sizeof read);
    bat_matrix_compose(back, read, was);
    bat_matrix_compose(first, was, entry->inner);
}

/* What is not shown of each object: what was noted at its element, or at one around it that is no object itself. */
static bat_status note_lost(const bat_svg_walk *w, bat_sourced *list, int count) {
    const bat_svg_tree *tree = w->tree;
    uint32_t *above = calloc(tree->count, sizeof *above); /* what an element's contents have from around it */
    int at = 0;
    if (!above) return BAT_MEMORY;
    for (uint32_t i = 2; i < tree->count; i++) {
        const uint32_t own = above[tree->elements[i].parent] | bat_svg_noted(&w->notes, i);
        bool made = false;
        for (; at < count && list[at].element <= i; at++) {
            if (list[at].element < i || !list[at].id) continue;
            made = made || !list[at].copied;
            list[at].lost |= own;
        }
        above[i] = made ? 0 : own;
    }
    free(above);
    return BAT_OK;
}

/* What each entry has from the elements around it: their opacities, apart from those of groups of the document. */
static bat_status note_opacities(const bat_svg_walk *w, const bat_document *document, bat_sourced *list,
                                 int count) {
    const bat_svg_tree *tree = w->tree;
    double *within = malloc(tree->count * sizeof *within);
    int at = 0;
    if (!within) return BAT_MEMORY;
    within[0] = 1;
    for (uint32_t i = 1; i < tree->count; i++) {
        const double around = within[tree->elements[i].parent];
        bool group = false;
        for (; at < count && list[at].element <= i; at++) {
            const bat_object *object = bat_document_at(document, bat_document_find(document, list[at].id));
            list[at].opacity = around;
            if (object && bat_object_is_foreign(object) && w->opacities)
                list[at].own = w->opacities[list[at].element];
            group = group || (object && !list[at].copied && bat_object_is_group(object));
        }
        within[i] = group ? 1 : around * (w->opacities ? w->opacities[i] : 1);
    }
    free(within);
    return BAT_OK;
}

bat_status bat_svg_keep(const bat_svg_reader *reader, const bat_svg_walk *w, bool native,
                        bat_document *document) {
    bat_svg_tags tags = {0};
    bool kept;
    bat_status status = bat_svg_match(reader->source, reader->source_size, &reader->tree, &tags, &kept);
    bat_svg_tags_free(&tags);
    if (status == BAT_OK && kept && native && !reader->held)
        status = bat_svg_name_native(reader, w->places, w->place_count, &kept);
    if (status != BAT_OK || !kept) return status;
    /* Who asks for fewer nodes whatever the path's size has asked for other path data. */
    const bool simpler = !native && reader->options.tolerance > 0 && !(reader->options.share > 0);
    int count = 0;
    for (int i = 0; i < w->place_count; i++) {
        bat_sourced *entry = &w->places[i];
        const bat_object *object = bat_document_at(document, bat_document_find(document, entry->id));
        if (!object) entry->id = 0;
        if (!object && entry->copied) continue; /* a group that was not needed */
        if (object) bat_sourced_note(entry, object);
        entry->part = object && native && bat_object_widths(object).count > 0;
        if (object && native && bat_object_is_foreign(object)) place_foreign(entry, object);
        if (simpler && object && !bat_object_is_foreign(object)) entry->shape = 0;
        w->places[count++] = *entry;
    }
    double page[4];
    bat_document_page(document, page);
    bat_source *source = NULL;
    status = note_opacities(w, document, w->places, count);
    if (status == BAT_OK) status = note_lost(w, w->places, count);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(document, bat_document_find(document, w->places[i].id));
        if (object && bat_object_is_foreign(object)) w->places[i].lost = 0;
    }
    status = bat_source_create(reader->source, reader->source_size, page,
                               simpler ? 0 : bat_document_digest(document), count, w->places, &source);
    if (status != BAT_OK) return status;
    bat_document_set_origin(document, source);
    bat_source_release(source);
    return BAT_OK;
}
