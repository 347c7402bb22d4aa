/* The file is kept with the document that was read from it. */
#include "document/digest.h"
#include "document/document.h"
#include "format/svg/reader.h"
#include "format/svg/tags.h"
#include "format/svg/walk.h"
#include "text/json.h"

#include <stdlib.h>
#include <string.h>

/* Whether the elements that the parser reported are those of the text: a name declared in the document type may stand
 * for elements, and then they are not. */
static bat_status compare(const bat_svg_reader *reader, bool *out) {
    bat_svg_tags tags;
    const bat_status status = bat_svg_tags_scan(reader->source, reader->source_size, &tags);
    *out = false;
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_OK;
    bool same = tags.count == reader->tree.count;
    for (uint32_t i = 1; same && i < tags.count; i++) {
        const char *tag = reader->source + tags.list[i].open;
        const char *name = bat_svg_tree_name(&reader->tree, i);
        const size_t length = bat_svg_tag_name(tag, tags.list[i].body - tags.list[i].open),
                     local = strlen(name);
        same = tags.list[i].parent == reader->tree.elements[i].parent && length >= local &&
               memcmp(tag + 1 + length - local, name, local) == 0;
    }
    bat_svg_tags_free(&tags);
    *out = same;
    return BAT_OK;
}

/* Gives each entry the object that the native document says: {"elements":[[id, element], ...]}. *out: whether it says so. */
static bat_status name_native(const bat_svg_reader *reader, bat_sourced *list, int count, bool *out) {
    bat_json json;
    const bat_status status = bat_json_parse(reader->native.data ? reader->native.data : "",
                                             reader->native.size, &json, NULL);
    if (status != BAT_OK) return status;
    const uint32_t pairs = bat_json_member(&json, 1, "elements");
    for (int i = 0; i < count; i++) list[i].id = 0;
    for (uint32_t pair = bat_json_first(&json, pairs); pair; pair = json.nodes[pair].next) {
        const uint32_t first = bat_json_first(&json, pair), second = first ? json.nodes[first].next : 0;
        if (bat_json_type_of(&json, first) != BAT_JSON_NUMBER ||
            bat_json_type_of(&json, second) != BAT_JSON_NUMBER)
            continue;
        const double id = json.nodes[first].value.number, element = json.nodes[second].value.number;
        int low = 0, high = count;
        while (low < high) {
            const int middle = (low + high) / 2;
            if (list[middle].element < element)
                low = middle + 1;
            else
                high = middle;
        }
        const bool shared = low + 1 < count && list[low + 1].element == element;
        if (shared) low++; /* the first is the `use` itself */
        while (low < count && list[low].element == element && list[low].id) low++;
        if (low < count && list[low].element == element && id >= 1 && id <= (double)BAT_ID_MAX)
            list[low].id = (bat_id)id;
    }
    *out = pairs != 0;
    bat_json_free(&json);
    return BAT_OK;
}

bat_status bat_svg_keep(const bat_svg_reader *reader, const bat_svg_walk *w, bool native,
                        bat_document *document) {
    bool kept;
    bat_status status = compare(reader, &kept);
    if (status == BAT_OK && kept && native) status = name_native(reader, w->places, w->place_count, &kept);
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
        if (simpler) entry->shape = 0;
        w->places[count++] = *entry;
    }
    double page[4];
    bat_document_page(document, page);
    bat_source *source = NULL;
    status = bat_source_create(reader->source, reader->source_size, page,
                               simpler ? 0 : bat_document_digest(document), count, w->places, &source);
    if (status != BAT_OK) return status;
    bat_document_set_origin(document, source);
    bat_source_release(source);
    return BAT_OK;
}
