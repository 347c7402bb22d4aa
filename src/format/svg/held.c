#include "format/svg/held.h"

#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "format/native/held.h"
#include "format/svg/digest.h"
#include "text/json.h"

#include <stdlib.h>
#include <string.h>

void bat_svg_held_begin(bat_svg_reader *reader) {
    const char *nodes = bat_svg_tree_attribute(&reader->tree, reader->native_element, "nodes");
    reader->options = nodes && strcmp(nodes, "merged") == 0 ? bat_svg_merging() : bat_svg_defaults();
}

/* ---- what is shown ---- */

void bat_svg_show(bat_svg_walk *w, const bat_svg_scope *s, const bat_svg_painted *painted, uint64_t marked) {
    const bat_object *object = bat_document_at(w->document, bat_document_count(w->document) - 1);
    if (!object || w->collected || w->status != BAT_OK) return;
    const bat_id id = bat_object_id(object);
    if (w->shown_count > 0 && w->shown[w->shown_count - 1].id >= id) return; /* nothing has been made */
    if (w->shown_count == w->shown_room) {
        const int room = w->shown_room < 64 ? 64 : 2 * w->shown_room;
        bat_svg_shown *grown = realloc(w->shown, (size_t)room * sizeof *grown);
        if (!grown) {
            w->status = BAT_MEMORY;
            return;
        }
        w->shown = grown;
        w->shown_room = room;
    }
    uint64_t digest = bat_svg_digest(bat_digest_begin(), &w->outline, &painted->style, &painted->paint);
    digest = bat_digest_number(bat_digest_number(digest, s->clip_digest), marked);
    w->shown[w->shown_count++] = (bat_svg_shown){id, digest};
}

static uint64_t find_shown(const bat_svg_shown *list, int count, bat_id id) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (list[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && list[low].id == id ? list[low].digest : 0;
}

uint64_t bat_svg_held_digests(const bat_document *drawing, const bat_svg_shown *shown, int shown_count,
                              uint64_t *digests) {
    uint64_t all = bat_digest_begin();
    for (int i = 0; i < bat_document_count(drawing); i++) {
        const bat_object *object = bat_document_at(drawing, i);
        const double opacity = bat_object_style(object)->opacity;
        uint64_t own = bat_digest_number(bat_digest_begin(), (uint64_t)bat_object_type(object)->number);
        if (bat_object_picture(object))
            own = bat_svg_digest_image(own, bat_object_picture(object), bat_object_matrix(object), opacity);
        else if (bat_object_is_group(object))
            own = bat_svg_digest_group(own, opacity);
        else
            own = bat_digest_number(own, find_shown(shown, shown_count, bat_object_id(object)));
        if (bat_object_picture(object) || bat_object_is_group(object))
            own = bat_digest_number(own, bat_clip_digest(bat_object_clip(object)));
        digests[i] = own;
        const int parent = bat_object_parent(object) ? bat_document_find(drawing, bat_object_parent(object))
                                                     : -1;
        all = bat_digest_number(bat_digest_number(all, own), (uint64_t)(parent + 1));
    }
    return all;
}

uint64_t bat_svg_held_digest(const uint64_t *digests, int count) {
    uint64_t digest = digests[0];
    for (int i = 1; i < count; i++) digest = bat_digest_number(digest, digests[i]);
    return digest;
}

void bat_svg_held_keep(bat_svg_walk *w, bat_svg_again *out) {
    out->digest = w->digest;
    out->places = w->places;
    out->place_count = w->place_count;
    out->shown = w->shown;
    out->shown_count = w->shown_count;
    w->places = NULL;
    w->shown = NULL;
}

/* ---- where it belongs in a drawing that another program has changed ---- */

typedef struct numbered {
    uint64_t digest;
    int index, next; /* next: where the next free one with this digest is looked for, of the first with it */
} numbered;

static int compare(const void *a, const void *b) {
    const numbered *x = a, *y = b;
    if (x->digest != y->digest) return x->digest < y->digest ? -1 : 1;
    return (x->index > y->index) - (x->index < y->index);
}

static int first_with(const numbered *list, int count, uint64_t digest) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (list[middle].digest < digest)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* What shows the same takes its place, in order; several together where they stand together. Returns how many have none. */
static int place(const bat_held *held, const uint64_t *digests, int count, numbered *list, bool *taken,
                 int *placed) {
    int lost = 0, runs = 0, tries = 1 << 22;
    for (int i = 0; i < count; i++) list[i] = (numbered){digests[i], i, 0};
    if (count > 1) qsort(list, (size_t)count, sizeof *list, compare); /* no ties */
    for (int i = 0; i < count; i++) list[i].next = i;
    for (int k = 0; k < held->count; k++) {
        const bat_substitute *s = &held->splices[k];
        const bool gone = s->broken ||
                          (s->object && s->grouped); /* what depends on a group that is not drawn */
        placed[k] = s->count == 0 && !gone && !bat_object_is_group(s->object) ? count : -1;
        lost += gone;
        if (s->count == 0 || gone) continue;
        if (s->count > 1) { /* a stroke and its fill: looked for where they were, and behind */
            for (int i = runs; i + s->count <= count && placed[k] < 0 && --tries > 0; i++)
                if (bat_svg_held_digest(digests + i, s->count) == s->digest) placed[k] = i;
            runs = placed[k] < 0 ? runs : placed[k] + s->count;
        } else {
            const int first = first_with(list, count, s->digest);
            int at = first < count ? list[first].next : count;
            while (at < count && list[at].digest == s->digest && taken[list[at].index]) at++;
            if (first < count) list[first].next = at;
            if (at < count && list[at].digest == s->digest) placed[k] = list[at].index;
        }
        for (int j = 0; placed[k] >= 0 && j < s->count; j++) {
            if (taken[placed[k] + j]) placed[k] = -1;
            if (placed[k] >= 0) taken[placed[k] + j] = true;
        }
        lost += placed[k] < 0 && (s->object || s->like);
    }
    return lost;
}

/* ---- together ---- */

typedef struct task {
    uint64_t *digests;
    int *placed;
    bat_id *ids;
    numbered *list;
    bool *taken;
} task;

static bool is_as_written(const bat_held *held, const char *noted, uint64_t all, const uint64_t *digests,
                          int count) {
    char own[17];
    bat_digest_print(all, own);
    if (strcmp(noted, own) != 0) return false;
    for (int k = 0; k < held->count; k++) {
        const bat_substitute *s = &held->splices[k];
        if (s->at + s->count > count || s->broken) return false;
        if (s->count > 0 && bat_svg_held_digest(digests + s->at, s->count) != s->digest) return false;
    }
    return true;
}

/* The first place of an element or behind it, of places in their order. */
static int first_place(const bat_sourced *places, int count, double element) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (places[middle].element < element)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Gives elements from which nothing is read their objects. */
static void name_others(bat_svg_walk *w, const bat_held *held) {
    for (int k = 0; k < held->count; k++) {
        const bat_substitute *s = &held->splices[k];
        if (!s->element || !s->object) continue;
        const bat_svg_kind kind = bat_object_is_group(s->object) ? BAT_SVG_GROUP : BAT_SVG_SHAPE;
        const int at = first_place(w->places, w->place_count, s->element);
        if (at < w->place_count && w->places[at].element == s->element && !w->places[at].id &&
            w->tree->elements[s->element].kind == kind)
            w->places[at].id = bat_object_id(s->object);
    }
}

/* Whose objects the file's elements are. */
static void name_places(bat_svg_walk *w, const bat_document *drawing, const bat_id *ids) {
    for (int i = 0; i < w->place_count; i++) {
        const int at = w->places[i].id ? bat_document_find(drawing, w->places[i].id) : -1;
        w->places[i].id = at < 0 ? 0 : ids[at];
    }
}

static bat_status use(const bat_svg_reader *reader, bat_svg_walk *w, const bat_held *held, task *t,
                      bat_document **document, int *lost) {
    const bat_document *drawing = *document;
    const int count = bat_document_count(drawing);
    const uint64_t all = bat_svg_held_digests(drawing, w->shown, w->shown_count, t->digests);
    const char *noted = bat_svg_tree_attribute(&reader->tree, reader->native_element, "drawing");
    const bool whole = is_as_written(held, noted, all, t->digests, count);
    bat_document *made = NULL;
    *lost = 0;
    if (whole)
        for (int k = 0; k < held->count; k++) t->placed[k] = held->splices[k].at;
    else
        *lost = place(held, t->digests, count, t->list, t->taken, t->placed);
    const bat_status status = bat_held_apply(drawing, held, t->placed, whole, t->ids, &made);
    if (status != BAT_OK) return status;
    name_places(w, drawing, t->ids);
    if (whole && held->element_count == w->tree->count) name_others(w, held);
    bat_document_free(*document);
    *document = made;
    return BAT_OK;
}

bat_status bat_svg_held_use(const bat_svg_reader *reader, bat_svg_walk *w, bat_document **document,
                            bat_svg_report *report) {
    const size_t count = (size_t)bat_document_count(*document);
    bat_held held = {0};
    int lost = 1;
    bat_status status = bat_held_read(reader->native.data ? reader->native.data : "", reader->native.size,
                                      &w->pictures, &held);
    task t = {.digests = malloc((count + 1) * sizeof *t.digests),
              .placed = malloc(((size_t)held.count + 1) * sizeof *t.placed),
              .ids = malloc((count + 1) * sizeof *t.ids),
              .list = malloc((count + 1) * sizeof *t.list),
              .taken = calloc(count + 1, sizeof *t.taken)};
    if (!t.digests || !t.placed || !t.ids || !t.list || !t.taken) status = BAT_MEMORY;
    if (status == BAT_OK) status = use(reader, w, &held, &t, document, &lost);
    if (status == BAT_OK) bat_svg_report_native(*document, report);
    report->edited = status != BAT_OK || lost > 0;
    report->lost.count[BAT_LOSS_NATIVE] = lost;
    bat_held_free(&held);
    free(t.digests);
    free(t.placed);
    free(t.ids);
    free(t.list);
    free(t.taken);
    return status == BAT_MEMORY ? status : BAT_OK;
}

/* ---- whole documents ---- */

bat_status bat_svg_name_native(const bat_svg_reader *reader, bat_sourced *list, int count, bool *out) {
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
        int low = first_place(list, count, element);
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
