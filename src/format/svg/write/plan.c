#include "format/svg/write/plan.h"

#include "document/clip.h"
#include "document/lettering.h"
#include "document/markers.h"
#include "document/nesting.h"
#include "document/sheet.h"
#include "document/unit.h"
#include "format/svg/svg.h"
#include "format/svg/write/refer.h"
#include "format/svg/write/retag.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool bat_svg_reshaped(const bat_object *object, const bat_sourced *entry) {
    return bat_sourced_shape(object) != entry->shape;
}

bool bat_svg_remarked(const bat_object *object, const bat_sourced *entry) {
    return bat_markers_digest(bat_object_markers(object)) != entry->markers;
}

double bat_svg_plan_widens(const bat_svg_plan *plan, const bat_sourced *entry) {
    return entry->lost & 1u << BAT_LOSS_EFFECT ? plan->grown : 1;
}

bool bat_svg_restyled(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry) {
    const bat_style *a = bat_object_style(object), *b = &entry->style;
    for (int k = 0; k < BAT_PAINT_PARTS; k++)
        if (bat_paint_digest(bat_object_paint(object), (bat_paint_part)k) != entry->paint[k]) return true;
    if (bat_clip_digest(bat_object_clip(object)) != entry->clip) return true;
    if (bat_svg_remarked(object, entry) || bat_svg_plan_widens(plan, entry) != 1) return true;
    return a->stroked != b->stroked || a->filled != b->filled || a->even_odd != b->even_odd ||
           a->stroke != b->stroke || a->fill != b->fill || a->width != b->width || a->opacity != b->opacity ||
           a->cap != b->cap || a->join != b->join || a->miter_limit != b->miter_limit;
}

static void find_types(bat_svg_plan *plan) {
    for (size_t at = 0, from = 0; from < plan->size; from = at) {
        const bat_svg_token token = bat_svg_next_token(plan->text, plan->size, &at);
        if (token == BAT_SVG_TYPE_TOKEN) {
            plan->types = plan->text + from;
            plan->types_size = at - from;
        }
        if (token != BAT_SVG_TYPE_TOKEN && token != BAT_SVG_OTHER_TOKEN && token != BAT_SVG_TEXT_TOKEN)
            return;
    }
}

bool bat_svg_is_remade(const bat_object *object, const bat_sourced *entry) {
    return entry->part || bat_object_widths(object).count > 0 ||
           (bat_object_lettering(object) && bat_svg_reshaped(object, entry));
}

/* Objects and entries find each other by the object's id; of its parts the first stands for it. */
static void match(bat_svg_plan *plan) {
    for (int i = 0; i < plan->count; i++) plan->entry[i] = -1;
    for (int k = 0; k < bat_source_count(plan->source); k++) {
        const bat_sourced *entry = bat_source_at(plan->source, k);
        const int index = entry->id ? bat_document_find(plan->document, entry->id) : -1;
        if (index >= 0 && plan->entry[index] < 0)
            plan->entry[index] = k;
        else if (entry->id && !entry->copied)
            plan->fate[entry->element] |= BAT_SVG_GONE | BAT_SVG_TOUCHED;
    }
}

/* What groups without an element of their own hide. */
static void find_hidden(bat_svg_plan *plan) {
    for (int i = 0; i < plan->count; i++) {
        const bat_object *object = bat_document_at(plan->document, i);
        const int parent = bat_document_find(plan->document, bat_object_parent(object));
        if (parent < 0) continue;
        const bool bare = plan->entry[parent] < 0;
        plan->hidden[i] = (uint8_t)(plan->hidden[parent] ||
                                    (bare && bat_object_is_hidden(bat_document_at(plan->document, parent))));
    }
}

static void touch_edited(bat_svg_plan *plan) {
    for (int i = 0; i < plan->count; i++) {
        const bat_object *object = bat_document_at(plan->document, i);
        const bat_sourced *entry = bat_svg_plan_entry(plan, i);
        if (!entry || entry->copied) continue;
        if (bat_object_is_group(object)) {
            if (bat_svg_restyled(plan, object, entry)) plan->fate[entry->element] |= BAT_SVG_TOUCHED;
            continue;
        }
        const bool hidden = bat_object_is_hidden(object) || plan->hidden[i];
        if (bat_svg_reshaped(object, entry) || bat_svg_restyled(plan, object, entry) ||
            hidden != entry->hidden || bat_svg_is_remade(object, entry))
            plan->fate[entry->element] |= BAT_SVG_TOUCHED;
    }
}

bool bat_svg_is_placed(const bat_svg_plan *plan, int index) {
    const bat_sourced *entry = bat_svg_plan_entry(plan, index);
    if (!entry) return false;
    const bool group = bat_object_is_group(bat_document_at(plan->document, index));
    return (group && entry->copied) || plan->stay[index] == BAT_SVG_STAYS ||
           plan->stay[index] == BAT_SVG_CARRIED;
}

/* The element of the group that an object is in, as far as groups have elements. */
uint32_t bat_svg_plan_group(const bat_svg_plan *plan, bat_id parent) {
    for (int depth = 0; parent && depth < BAT_NESTING_MAX; depth++) {
        const int index = bat_document_find(plan->document, parent);
        if (index < 0) return 1;
        if (bat_svg_is_placed(plan, index)) return bat_svg_plan_entry(plan, index)->element;
        parent = bat_object_parent(bat_document_at(plan->document, index));
    }
    return 1;
}

/* Whether a group around it that has no element is translucent or clipped: then it has to be written as one, with it. */
static bool is_veiled(const bat_svg_plan *plan, const bat_object *object) {
    for (int depth = 0; depth < BAT_NESTING_MAX; depth++) {
        const int index = bat_document_find(plan->document, bat_object_parent(object));
        if (index < 0 || bat_svg_is_placed(plan, index)) return false;
        object = bat_document_at(plan->document, index);
        if (bat_object_style(object)->opacity != 1 || bat_object_clip(object)) return true;
    }
    return false;
}

/* What has left its group cannot stay in its element. */
static bool is_in_place(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry) {
    uint32_t around = plan->tags.list[entry->element].parent;
    while (around > 1 && !(plan->fate[around] & BAT_SVG_GROUPED)) around = plan->tags.list[around].parent;
    const uint32_t group = bat_svg_plan_group(plan, bat_object_parent(object));
    return (around > 1 ? around : 1) == group;
}

static void mark_groups(bat_svg_plan *plan) {
    for (int i = 0; i < plan->count; i++)
        if (plan->entry[i] >= 0 && bat_object_is_group(bat_document_at(plan->document, i)))
            plan->fate[bat_svg_plan_entry(plan, i)->element] |= BAT_SVG_GROUPED;
}

/* The outermost group that is drawn from another place by the same element; else the object. */
static const bat_object *drawn_whole(const bat_svg_plan *plan, const bat_object *object,
                                     const bat_sourced *entry) {
    for (int depth = 0; entry->copied && depth < BAT_NESTING_MAX; depth++) {
        const int index = bat_document_find(plan->document, bat_object_parent(object));
        const bat_sourced *around = index < 0 ? NULL : bat_svg_plan_entry(plan, index);
        if (!around || around->element != entry->element) break;
        object = bat_document_at(plan->document, index);
    }
    return object;
}

/* Whether it can be part of a row within an element. Groups count until it is known that they are not. */
static bool may_stay(const bat_svg_plan *plan, int index, uint32_t within) {
    const bat_sourced *entry = bat_svg_plan_entry(plan, index);
    const bat_object *object = bat_document_at(plan->document, index);
    if (!entry || !bat_svg_plan_holds(plan, within, entry->element) || is_veiled(plan, object)) return false;
    return is_in_place(plan, drawn_whole(plan, object, entry), entry);
}

/* Rooms for as many as there are objects. */
typedef struct rows {
    int *ends, *before;
} rows;

/* Finds the longest row of objects from..to-1 whose elements stand in the order of the file. They stay. */
static void find_row(bat_svg_plan *plan, int from, int to, uint32_t within, const rows *r) {
    int length = 0;
    for (int i = from; i < to; i++) {
        const bat_sourced *entry = bat_svg_plan_entry(plan, i);
        const bool group = bat_object_is_group(bat_document_at(plan->document, i));
        if (!entry || (group && entry->copied)) continue;
        plan->stay[i] = BAT_SVG_MOVED;
        if (!may_stay(plan, i, within)) continue;
        if (group) plan->stay[i] = BAT_SVG_STAYS;
        int low = 0, high = length; /* the first row that ends behind this element */
        while (low < high) {
            const int middle = (low + high) / 2;
            if (bat_svg_plan_entry(plan, r->ends[middle])->element <= entry->element)
                low = middle + 1;
            else
                high = middle;
        }
        r->before[i] = low > 0 ? r->ends[low - 1] : -1;
        r->ends[low] = i;
        if (low == length) length++;
    }
    for (int i = from; i < to; i++)
        if (plan->stay[i] == BAT_SVG_STAYS) plan->stay[i] = BAT_SVG_CARRIED; /* groups that may not stay */
    for (int i = length > 0 ? r->ends[length - 1] : -1; i >= 0; i = r->before[i])
        plan->stay[i] = BAT_SVG_STAYS;
}

/* The child of `outer` that is or holds the element; 0: it is elsewhere. */
static uint32_t child_of(const bat_svg_plan *plan, uint32_t outer, uint32_t element) {
    while (element > outer && plan->tags.list[element].parent != outer)
        element = plan->tags.list[element].parent;
    return element > outer ? element : 0;
}

/* Whether a group's element can stand elsewhere as it is: what is around it there is the same. */
static bool may_be_carried(const bat_svg_plan *plan, int index, int from, int to, uint32_t within) {
    const bat_object *object = bat_document_at(plan->document, index);
    const uint32_t parent = plan->tags.list[bat_svg_plan_entry(plan, index)->element].parent;
    if (!may_stay(plan, index, within) || parent != bat_svg_plan_group(plan, bat_object_parent(object)))
        return false;
    int below = index - 1, above = bat_document_end(plan->document, index);
    while (below >= from && plan->stay[below] != BAT_SVG_STAYS) below--;
    while (above < to && plan->stay[above] != BAT_SVG_STAYS) above++;
    if (below < from || above == to) return true;
    const uint32_t child = child_of(plan, parent, bat_svg_plan_entry(plan, below)->element);
    return !child || child != child_of(plan, parent, bat_svg_plan_entry(plan, above)->element);
}

/* Of a group that is not in the row nothing is; it has a row of its own when it is written elsewhere as it is. */
static void keep_order(bat_svg_plan *plan, int from, int to, uint32_t within, const rows *r) {
    find_row(plan, from, to, within, r);
    for (int i = from, end; i < to; i = end) {
        end = i + 1;
        if (plan->stay[i] != BAT_SVG_CARRIED) continue;
        end = bat_document_end(plan->document, i);
        if (may_be_carried(plan, i, from, to, within))
            keep_order(plan, end > i + 1 ? i + 1 : end, end, bat_svg_plan_entry(plan, i)->element, r);
        else
            for (int k = i; k < end; k++)
                if (plan->entry[k] >= 0) plan->stay[k] = BAT_SVG_MOVED;
    }
}

static bat_status keep_all(bat_svg_plan *plan) {
    const size_t size = ((size_t)plan->count + 1) * sizeof(int);
    const rows r = {malloc(size), malloc(size)};
    const bool made = r.ends && r.before;
    if (made) keep_order(plan, 0, plan->count, 1, &r);
    free(r.ends);
    free(r.before);
    return made ? BAT_OK : BAT_MEMORY;
}

/* Whether an element drawn from another place still shows just what it showed: entries from..to-1 are its objects. */
static bool is_whole(const bat_svg_plan *plan, int from, int to) {
    int last = -1;
    for (int k = from; k < to; k++) {
        const bat_sourced *entry = bat_source_at(plan->source, k);
        if (!entry->copied) continue;
        const int index = bat_document_find(plan->document, entry->id);
        const bat_object *object = bat_document_at(plan->document, index);
        if (!object || plan->fate[entry->element] & BAT_SVG_TOUCHED) return false;
        const bool drawn = bat_object_is_drawn(object);
        if (bat_svg_reshaped(object, entry) || bat_svg_restyled(plan, object, entry) ||
            bat_svg_is_remade(object, entry) || plan->hidden[index] ||
            bat_object_is_hidden(object) != entry->hidden || (drawn && plan->stay[index] != BAT_SVG_STAYS))
            return false;
        if (last >= 0 && index < last) return false;
        for (int i = last + 1; last >= 0 && i < index; i++) /* nothing has come between them */
            if (bat_object_is_drawn(bat_document_at(plan->document, i))) return false;
        if (drawn) last = index;
    }
    return true;
}

/* Copies of which one has changed are written as what they show. True: there were some. */
static bool untie(bat_svg_plan *plan) {
    bool any = false;
    const int count = bat_source_count(plan->source);
    for (int from = 0, to; from < count; from = to) {
        const uint32_t element = bat_source_at(plan->source, from)->element;
        for (to = from; to < count && bat_source_at(plan->source, to)->element == element; to++) {
        }
        if (to == from + 1 || plan->fate[element] & BAT_SVG_GONE || is_whole(plan, from, to)) continue;
        plan->fate[element] |= BAT_SVG_GONE | BAT_SVG_TOUCHED;
        for (int k = to - 1; k >= from; k--) { /* what is in a group before the group */
            const int index = bat_document_find(plan->document, bat_source_at(plan->source, k)->id);
            if (index < 0 || plan->entry[index] < 0) continue;
            if (plan->stay[index] == BAT_SVG_STAYS)
                plan->copy[index] = element;
            else if (index + 1 < bat_document_end(plan->document, index))
                plan->copy[index] = plan->copy[index + 1];
            plan->entry[index] = -1;
            plan->stay[index] = BAT_SVG_NEW;
        }
        any = true;
    }
    return any;
}

static bat_status decide(bat_svg_plan *plan) {
    match(plan);
    find_hidden(plan);
    touch_edited(plan);
    mark_groups(plan);
    bat_status status = bat_svg_refer(plan);
    if (status == BAT_OK) status = keep_all(plan);
    while (status == BAT_OK && untie(plan)) {
        status = bat_svg_refer(plan);
        find_hidden(plan);
    }
    for (int i = 0; i < plan->count; i++)
        if (plan->stay[i] == BAT_SVG_MOVED)
            plan->fate[bat_svg_plan_entry(plan, i)->element] |=
                BAT_SVG_GONE |
                (bat_object_is_group(bat_document_at(plan->document, i)) ? BAT_SVG_TOUCHED : 0);
    return status;
}

/* As the reader finds it: from the root's attributes. */
static double pixel_of_file(const bat_svg_plan *plan) {
    static const char *const names[] = {"width", "height", "preserveAspectRatio"};
    const bat_svg_tag *root = &plan->tags.list[1];
    const char *given[3] = {NULL};
    char values[3][64];
    bat_svg_retag r;
    bat_svg_piece piece;
    bat_svg_retag_begin(&r, plan->text + root->open, root->body - root->open, plan->types, plan->types_size,
                        plan->sheets);
    for (int i = 0; i < 3; i++) {
        if (!bat_svg_retag_has(&r, names[i], &piece) || piece.end - piece.value >= sizeof values[i]) continue;
        memcpy(values[i], r.tag + piece.value, piece.end - piece.value);
        values[i][piece.end - piece.value] = '\0';
        given[i] = values[i];
    }
    const bool boxed = bat_svg_retag_has(&r, "viewBox", &piece);
    bat_svg_retag_free(&r);
    return boxed ? bat_svg_pixel(bat_source_page(plan->source), given[0], given[1], given[2]) : 1;
}

/* Of the file, and as the page says its size now: where nothing is scaled they are the same. */
static void find_pixels(bat_svg_plan *plan) {
    const bat_sheet sheet = bat_sheet_of(plan->document);
    const double was = pixel_of_file(plan), now = BAT_PX_MILLIMETRES / sheet.scale;
    plan->pixel = bat_sheet_has_page(&sheet) && fabs(now - was) > 1e-8 * was ? now : was;
    plan->grown = plan->pixel / was;
}

bat_status bat_svg_plan_make(const bat_document *document, bat_svg_plan *out) {
    bat_svg_plan plan = {
        .document = document, .source = bat_document_origin(document), .count = bat_document_count(document)};
    plan.text = bat_source_text(plan.source, &plan.size);
    bat_status status = bat_svg_tags_scan(plan.text, plan.size, &plan.tags);
    if (status != BAT_OK) return status;
    plan.entry = malloc(((size_t)plan.count + 1) * sizeof *plan.entry);
    plan.stay = calloc((size_t)plan.count + 1, 1);
    plan.hidden = calloc((size_t)plan.count + 1, 1);
    plan.copy = calloc((size_t)plan.count + 1, sizeof *plan.copy);
    plan.fate = calloc(plan.tags.count, 1);
    for (int k = 0; k < bat_source_count(plan.source);
         k++) /* a list that was read with the document may be anything */
        if (bat_source_at(plan.source, k)->element == 0 ||
            bat_source_at(plan.source, k)->element >= plan.tags.count)
            status = BAT_SYNTAX;
    plan.sheets = strstr(plan.text, "<style") != NULL || strstr(plan.text, ":style") != NULL;
    plan.marked = strstr(plan.text, "marker") != NULL;
    find_types(&plan);
    find_pixels(&plan);
    if (status == BAT_OK)
        status = plan.entry && plan.stay && plan.hidden && plan.copy && plan.fate ? decide(&plan)
                                                                                  : BAT_MEMORY;
    if (status != BAT_OK)
        bat_svg_plan_free(&plan);
    else
        *out = plan;
    return status;
}

void bat_svg_plan_free(bat_svg_plan *plan) {
    free(plan->entry);
    free(plan->stay);
    free(plan->hidden);
    free(plan->copy);
    free(plan->fate);
    bat_svg_tags_free(&plan->tags);
}
