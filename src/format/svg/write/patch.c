#include "format/svg/write/patch.h"

#include "base/real.h"
#include "document/digest.h"
#include "document/kind.h"
#include "format/native/native.h"
#include "format/svg/write/covered.h"
#include "format/svg/reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_svg_tag *tag_of(const bat_svg_patch *p, uint32_t element) {
    return &p->plan.tags.list[element];
}

/* ---- elements that stay ---- */

static void copy_element(bat_svg_patch *p, const bat_svg_tag *tag) {
    bat_text_string(&p->made, "<defs>");
    bat_text_add(&p->made, p->plan.text + tag->open, tag->end - tag->open);
    bat_text_string(&p->made, "</defs>");
}

static void keep_object(bat_svg_patch *p, int index) {
    const bat_svg_plan *plan = &p->plan;
    const bat_object *object = bat_document_at(plan->document, index);
    const bat_sourced *entry = bat_svg_plan_entry(plan, index);
    const bat_svg_tag *tag = tag_of(p, entry->element);
    if (entry->copied) {
        p->kept[p->kept_count++] = (bat_svg_mark){bat_object_id(object), tag->open};
        return;
    }
    const size_t from = p->made.size;
    const uint8_t fate = plan->fate[entry->element];
    const bool shared = fate & BAT_SVG_NEEDED && fate & BAT_SVG_TOUCHED && !bat_object_is_group(object);
    if (shared) copy_element(p, tag); /* what refers to it goes on showing what it was */
    if (bat_svg_is_remade(object, entry)) {
        bat_svg_patch_remake(p, object, entry, plan->hidden[index]);
        bat_svg_patch_edit(p, from, tag->open, tag->end - tag->open);
        return;
    }
    const int mark = p->fresh_count;
    bat_svg_patch_try_shape(p, object, entry);
    if (p->status != BAT_OK) return;
    const bool apart = shared && plan->sheets; /* without its id, which rules may name */
    const bat_svg_ids ids = bat_svg_patch_gradients(p, object, entry, apart);
    bat_svg_patch_mark(p, bat_object_id(object));
    if (!bat_svg_patch_tag(p, object, entry, apart, plan->hidden[index], shared, &ids)) {
        p->fresh_count = mark;
        p->made.size = from;
        p->kept[p->kept_count++] = (bat_svg_mark){bat_object_id(object), tag->open};
        return;
    }
    bat_svg_patch_edit(p, from, tag->open, tag->body - tag->open);
    if (tag->close == tag->end || bat_object_is_group(object)) return;
    const size_t end = p->made.size;
    bat_svg_patch_end_tag(p, object, entry);
    bat_svg_patch_edit(p, end, tag->close, tag->end - tag->close);
}

/* ---- elements that go ---- */

/* Whether nothing would be left in it to be seen. */
static bool is_bare(const bat_svg_patch *p, uint32_t element) {
    static const char *const unseen[] = {"g", "title", "desc", "metadata"};
    const uint32_t last = tag_of(p, element)->last;
    for (uint32_t i = element + 1; i <= last; i++) {
        if (p->plan.fate[i] & BAT_SVG_GONE && !bat_svg_is_called(&p->plan, i, "g")) {
            i = tag_of(p, i)->last;
            continue;
        }
        bool passes = false;
        for (size_t k = 0; k < sizeof unseen / sizeof *unseen; k++)
            passes = passes || bat_svg_is_called(&p->plan, i, unseen[k]);
        if (!passes) return false;
    }
    return true;
}

static void drop_element(bat_svg_patch *p, uint32_t element) {
    const bat_svg_tag *tag = tag_of(p, element);
    const bool holds = bat_svg_is_called(&p->plan, element, "g") ||
                       bat_svg_is_called(&p->plan, element, "a") ||
                       bat_svg_is_called(&p->plan, element, "svg");
    const size_t made = p->made.size;
    if (holds && !is_bare(p, element)) {
        if (bat_svg_patch_group_tag(p, element))
            bat_svg_patch_edit(p, made, tag->open, tag->body - tag->open);
        return;
    }
    size_t from = tag->open;
    if (p->plan.fate[element] & BAT_SVG_NEEDED)
        copy_element(p, tag);
    else
        from = bat_svg_patch_lead(p, from);
    bat_svg_patch_edit(p, made, from, tag->end - from);
}

/* An element that is written elsewhere takes its id along, so nothing is left for those that refer to it; unless it has been
 * edited: then they go on finding it as it was. */
static void drop_elements(bat_svg_patch *p) {
    const bat_svg_plan *plan = &p->plan;
    for (int i = 0; i < plan->count; i++)
        if (plan->stay[i] == BAT_SVG_MOVED &&
            !(plan->fate[bat_svg_plan_entry(plan, i)->element] & BAT_SVG_TOUCHED))
            plan->fate[bat_svg_plan_entry(plan, i)->element] &= (uint8_t)~BAT_SVG_NEEDED;
    for (uint32_t i = 1; i < plan->tags.count; i++)
        if (plan->fate[i] & BAT_SVG_GONE) drop_element(p, i);
}

/* ---- the page and the native document ---- */

static bool is_native(const bat_svg_patch *p, uint32_t element) {
    const bat_svg_tag *tag = tag_of(p, element);
    const uint32_t parent = tag->parent;
    if (!parent || !bat_svg_is_called(&p->plan, parent, "metadata") ||
        !bat_svg_is_called(&p->plan, element, "document"))
        return false;
    const char *text = p->plan.text + tag->open;
    static const char space[] = BAT_SVG_NATIVE_NAMESPACE, own[] = "<batten:document";
    if (memcmp(text, own, sizeof own - 1) == 0) return true;
    for (size_t i = 0; i + sizeof space < tag->body - tag->open; i++)
        if (memcmp(text + i, space, sizeof space - 1) == 0) return true;
    return false;
}

#define NATIVE_BEGIN "<batten:document xmlns:batten=\"" BAT_SVG_NATIVE_NAMESPACE "\" "
static const char NATIVE_PLACE[] = NATIVE_BEGIN "></batten:document>";

static size_t blanks_at(const bat_svg_patch *p, size_t at) { return strspn(p->plan.text + at, " \t\r\n"); }

static void place_native(bat_svg_patch *p, bool with_native) {
    uint32_t native = 0, metadata = 0;
    for (uint32_t i = 2; i < p->plan.tags.count && !native; i++) {
        if (is_native(p, i)) native = i;
        if (!metadata && tag_of(p, i)->parent == 1 && bat_svg_is_called(&p->plan, i, "metadata") &&
            tag_of(p, i)->body < tag_of(p, i)->end)
            metadata = i;
    }
    if (!native && !with_native) return;
    if (!with_native) { /* with the metadata around it, if there is nothing else in them */
        const bat_svg_tag *own = tag_of(p, native), *around = tag_of(p, own->parent);
        const bool alone = own->open - around->body == blanks_at(p, around->body) &&
                           around->close - own->end == blanks_at(p, own->end);
        const bat_svg_tag *gone = alone ? around : own;
        bat_svg_patch_edit(p, p->made.size, gone->open, gone->end - gone->open);
        return;
    }
    const size_t from = p->made.size;
    const bool whole = !native && !metadata;
    if (whole) bat_text_string(&p->made, "\n<metadata>");
    bat_svg_patch_mark(p, 0);
    bat_text_string(&p->made, NATIVE_PLACE);
    if (whole) bat_text_string(&p->made, "</metadata>");
    const bat_svg_tag *tag = tag_of(p, native ? native : metadata ? metadata : 1);
    bat_svg_patch_edit(p, from,
                       native     ? tag->open
                       : metadata ? tag->close
                                  : tag->body,
                       native ? tag->end - tag->open : 0);
}

/* ---- what is written ---- */

/* The native document, with the element of each object. */
static bat_status write_native(const bat_document *document, const bat_svg_output *out, uint64_t digest,
                               bat_text *text) {
    bat_svg_tags tags;
    bat_status status = bat_svg_tags_scan(out->text.data, out->text.size, &tags);
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
    bat_text json = {0};
    char noted[17];
    bat_document_to_json(document, false, &json);
    static const char end[] = "}\n";
    if (json.size > sizeof end) json.size -= sizeof end - 1;
    bat_text_string(&json, ",\n\"elements\":[");
    bool first = true;
    for (int i = 0; i < out->count; i++) {
        const uint32_t element = out->marks[i].id ? bat_svg_element_at(&tags, out->marks[i].at) : 0;
        if (!element) continue;
        bat_text_string(&json, first ? "[" : ",[");
        bat_text_integer(&json, out->marks[i].id);
        bat_text_string(&json, ",");
        bat_text_integer(&json, element);
        bat_text_string(&json, "]");
        first = false;
    }
    bat_text_string(&json, "]}\n");
    bat_svg_tags_free(&tags);
    bat_digest_print(digest, noted);
    bat_text_string(text, NATIVE_BEGIN "digest=\"");
    bat_text_string(text, noted);
    bat_text_string(text, "\">");
    if (json.data) bat_text_xml(text, json.data, json.size, false);
    bat_text_string(text, "</batten:document>");
    text->failed = text->failed || json.failed;
    bat_text_free(&json);
    return BAT_OK;
}

/* What SVG cannot hold, or, where it cannot be told apart, the native document. */
static bat_status write_beside(const bat_document *document, const bat_svg_output *out,
                               const bat_svg_again *again, bat_text *text) {
    const size_t from = text->size;
    bat_text_string(text, NATIVE_BEGIN);
    const bat_status status = bat_svg_held_write(document, out, again, text);
    bat_text_string(text, "</batten:document>");
    if (status != BAT_UNSUPPORTED) return status;
    text->size = from;
    return write_native(document, out, again->digest, text);
}

/* The text as it was read again, with what SVG cannot hold in its place. */
static bat_status finish(const bat_document *document, const bat_svg_output *out, const bat_svg_again *again,
                         bool with_native, bat_text *text) {
    size_t at = out->text.size, behind = at;
    bat_status status = BAT_OK;
    for (int i = 0; i < out->count && with_native; i++)
        if (out->marks[i].id == 0) {
            at = out->marks[i].at;
            behind = at + sizeof NATIVE_PLACE - 1;
        }
    bat_text_add(text, out->text.data, at);
    if (with_native) status = write_beside(document, out, again, text);
    if (status == BAT_OK) bat_text_add(text, out->text.data + behind, out->text.size - behind);
    return status == BAT_OK && text->failed ? BAT_MEMORY : status;
}

static void collect(bat_svg_patch *p, bool with_native) {
    const bat_svg_plan *plan = &p->plan;
    for (int i = 0; i < plan->count && p->status == BAT_OK; i++) {
        if (bat_svg_is_placed(plan, i)) keep_object(p, i);
    }
    if (p->status == BAT_OK) drop_elements(p);
    if (p->status == BAT_OK) bat_svg_patch_new(p);
    bat_svg_patch_page(p);
    place_native(p, with_native);
}

/* Makes the new text from the plan. */
static void make(bat_svg_patch *p, bool with_native, bat_svg_output *out) {
    p->made.size = out->text.size = 0;
    p->edit_count = p->kept_count = p->fresh_count = out->count = p->number = 0;
    collect(p, with_native);
    if (p->status == BAT_OK) bat_svg_patch_apply(p, out);
    if (p->status == BAT_OK && bat_svg_patch_sweep(p, &out->text) > 0) {
        out->text.size = 0;
        out->count = 0;
        bat_svg_patch_apply(p, out);
    }
}

/* Makes it and reads it again. *differs: something looks otherwise, which the plan now says. */
static void attempt(bat_svg_patch *p, bool with_native, bat_svg_output *out, bat_svg_again *again,
                    bool *differs) {
    const bat_svg_options merging = bat_svg_merging();
    *differs = false;
    again->like = p->plan.document;
    make(p, with_native, out);
    if (p->status == BAT_OK) p->status = bat_svg_again_read(&out->text, &merging, again);
    if (p->status == BAT_OK) p->status = bat_svg_patch_compare(&p->plan, again->document, differs);
}

bat_status bat_svg_patch_write(const bat_document *document, bool with_native, double precision,
                               bat_text *text) {
    const bat_source *source = bat_document_origin(document);
    if (bat_document_digest(document) == bat_source_digest(source) &&
        (with_native || !strstr(bat_source_text(source, &(size_t){0}), BAT_SVG_NATIVE_NAMESPACE))) {
        size_t size;
        const char *same = bat_source_text(source, &size);
        bat_text_add(text, same, size);
        return text->failed ? BAT_MEMORY : BAT_OK;
    }
    bat_svg_patch p = {.precision = precision};
    bat_status status = bat_svg_plan_make(document, &p.plan);
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
    const size_t room = 3 * (size_t)p.plan.count + 2; /* an object may have two parts in a group */
    bat_svg_output out = {.marks = malloc(2 * room * sizeof *out.marks)};
    bat_svg_again again = {0};
    bool differs = false;
    p.kept = malloc(room * sizeof *p.kept);
    p.fresh = malloc(room * sizeof *p.fresh);
    if (!out.marks || !p.kept || !p.fresh) p.status = BAT_MEMORY;
    if (p.status == BAT_OK) attempt(&p, with_native, &out, &again, &differs);
    if (p.status == BAT_OK &&
        differs) { /* rules that hold for others than before: once more, and all is said */
        bat_svg_again_free(&again);
        attempt(&p, with_native, &out, &again, &differs);
    }
    if (p.status == BAT_OK && differs) p.status = BAT_UNSUPPORTED;
    if (p.status == BAT_OK) p.status = finish(document, &out, &again, with_native, text);
    status = p.status;
    bat_svg_again_free(&again);
    free(out.marks);
    bat_text_free(&out.text);
    free(p.kept);
    free(p.fresh);
    free(p.edits);
    bat_text_free(&p.made);
    bat_svg_plan_free(&p.plan);
    return status;
}
