/* The pieces of text that take the place of others. */
#include "format/svg/write/patch.h"

#include <stdlib.h>
#include <string.h>

void bat_svg_patch_edit(bat_svg_patch *p, size_t from, size_t at, size_t cut) {
    if (p->edit_count == p->edit_room) {
        const int room = p->edit_room < 64 ? 64 : 2 * p->edit_room;
        bat_svg_edit *grown = realloc(p->edits, (size_t)room * sizeof *grown);
        if (!grown) {
            p->status = BAT_MEMORY;
            return;
        }
        p->edits = grown;
        p->edit_room = room;
    }
    p->edits[p->edit_count] = (bat_svg_edit){at, cut, from, p->made.size, p->edit_count, 0};
    p->edit_count++;
}

size_t bat_svg_patch_lead(const bat_svg_patch *p, size_t at) {
    const char *text = p->plan.text;
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) at--;
    if (at > 0 && text[at - 1] == '\n') at--;
    if (at > 0 && text[at - 1] == '\r') at--;
    return at;
}

void bat_svg_patch_carry(bat_svg_patch *p, uint32_t element, size_t at) {
    const bat_svg_tag *tag = &p->plan.tags.list[element];
    const size_t lead = bat_svg_patch_lead(p, tag->open);
    bat_svg_patch_edit(p, p->made.size, lead, tag->end - lead);
    bat_svg_patch_edit(p, p->made.size, at, 0);
    if (p->status == BAT_OK) p->edits[p->edit_count - 1].carried = element;
}

void bat_svg_patch_mark(bat_svg_patch *p, bat_id id) {
    p->fresh[p->fresh_count++] = (bat_svg_mark){id, p->made.size};
}

int bat_svg_patch_number(bat_svg_patch *p) {
    if (p->number) return p->number;
    for (const char *at = p->plan.text; (at = strstr(at, BAT_SVG_PAINT_ID)); at++) {
        const char *end = at + sizeof BAT_SVG_PAINT_ID - 1;
        int number = 0;
        while (*end == '-' || (*end >= 'a' && *end <= 'z') || (*end >= '0' && *end <= '9')) {
            number = *end >= '0' && *end <= '9' && number < 100000000 ? 10 * number + (*end - '0') : 0;
            end++;
        }
        if (number > p->number) p->number = number;
    }
    return ++p->number;
}

/* ---- gradients that were written for shapes which have others now ---- */

enum { PREFIX = sizeof BAT_SVG_PAINT_ID - 1 };

/* A gradient of ours in the file. */
typedef struct served {
    const char *id;
    size_t size;
    const bat_svg_tag *tag;
    bool used;
} served;

/* How much of the text, which begins with the prefix, is an id of ours. */
static size_t id_size(const char *text) {
    size_t size = PREFIX;
    while (text[size] == '-' || (text[size] >= 'a' && text[size] <= 'z') ||
           (text[size] >= '0' && text[size] <= '9'))
        size++;
    return size;
}

static const char *id_of(const bat_svg_plan *plan, const bat_svg_tag *tag) {
    static const char *const begins[] = {
        "<linearGradient id=\"" BAT_SVG_PAINT_ID, "<radialGradient id=\"" BAT_SVG_PAINT_ID,
        "<clipPath id=\"" BAT_SVG_PAINT_ID,       "<mask id=\"" BAT_SVG_PAINT_ID,
        "<pattern id=\"" BAT_SVG_PAINT_ID,        "<marker id=\"" BAT_SVG_PAINT_ID};
    for (size_t i = 0; i < sizeof begins / sizeof *begins; i++)
        if (strncmp(plan->text + tag->open, begins[i], strlen(begins[i])) == 0)
            return plan->text + tag->open + strlen(begins[i]) - PREFIX;
    return NULL;
}

static int compare(const void *a, const void *b) {
    const served *x = a, *y = b;
    const int order = memcmp(x->id, y->id, x->size < y->size ? x->size : y->size);
    if (order) return order;
    if (x->size != y->size) return x->size < y->size ? -1 : 1;
    return (x->tag > y->tag) - (x->tag < y->tag);
}

/* The first with that id, or where it would be. */
static int find(const served *list, int count, const served *wanted) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (compare(&list[middle], wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void note_uses(served *list, int count, const char *text, size_t size) {
    const char *end = text + size;
    while ((text = memchr(text, '#', (size_t)(end - text)))) {
        text++;
        if ((size_t)(end - text) <= PREFIX || memcmp(text, BAT_SVG_PAINT_ID, PREFIX) != 0) continue;
        const served wanted = {.id = text, .size = id_size(text)};
        for (int i = find(list, count, &wanted); i < count; i++) {
            if (list[i].size != wanted.size || memcmp(list[i].id, text, wanted.size) != 0) break;
            if (list[i].used) break; /* and so are those that share its id */
            list[i].used = true;
        }
    }
}

int bat_svg_patch_sweep(bat_svg_patch *p, const bat_text *made) {
    const bat_svg_plan *plan = &p->plan;
    int count = 0, swept = 0;
    for (uint32_t i = 1; i < plan->tags.count; i++) count += id_of(plan, &plan->tags.list[i]) != NULL;
    if (count == 0 || !made->data) return 0;
    served *list = malloc((size_t)count * sizeof *list);
    if (!list) {
        p->status = BAT_MEMORY;
        return 0;
    }
    count = 0;
    for (uint32_t i = 1; i < plan->tags.count; i++) {
        const bat_svg_tag *tag = &plan->tags.list[i];
        const char *id = id_of(plan, tag);
        if (id) list[count++] = (served){.id = id, .size = id_size(id), .tag = tag};
    }
    if (count > 1) qsort(list, (size_t)count, sizeof *list, compare); /* no ties */
    note_uses(list, count, made->data, made->size);
    for (int i = 0; i < count; i++) {
        if (list[i].used) continue;
        bat_svg_patch_edit(p, p->made.size, list[i].tag->open, list[i].tag->end - list[i].tag->open);
        swept++;
    }
    free(list);
    return swept;
}

/* ---- putting it together ---- */

/* What is cut as a whole comes before what is cut in it. */
static int compare_edits(const void *a, const void *b) {
    const bat_svg_edit *x = a, *y = b;
    if (x->at != y->at) return x->at < y->at ? -1 : 1;
    if ((x->cut > 0) != (y->cut > 0)) return x->cut > 0 ? 1 : -1;
    if (x->cut != y->cut) return x->cut > y->cut ? -1 : 1;
    return x->order - y->order;
}

static int compare_marks(const void *a, const void *b) {
    const bat_svg_mark *x = a, *y = b;
    if (x->at != y->at) return x->at < y->at ? -1 : 1;
    return (x->id > y->id) - (x->id < y->id);
}

/* The first at or behind that place. */
static int first_mark(const bat_svg_mark *list, int count, size_t at) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (list[middle].at < at)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void copy_marks(const bat_svg_mark *list, int count, size_t from, size_t to, bat_svg_output *out) {
    for (int i = first_mark(list, count, from); i < count && list[i].at < to; i++)
        out->marks[out->count++] = (bat_svg_mark){list[i].id, out->text.size + list[i].at - from};
}

static void copy_source(bat_svg_patch *p, size_t from, size_t to, bat_svg_output *out) {
    copy_marks(p->kept, p->kept_count, from, to, out);
    bat_text_add(&out->text, p->plan.text + from, to - from);
}

static void copy_made(bat_svg_patch *p, const bat_svg_edit *edit, bat_svg_output *out) {
    copy_marks(p->fresh, p->fresh_count, edit->from, edit->to, out);
    if (edit->to > edit->from) bat_text_add(&out->text, p->made.data + edit->from, edit->to - edit->from);
}

/* The first edit at or behind that place. */
static int first_edit(const bat_svg_patch *p, size_t at) {
    int low = 0, high = p->edit_count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (p->edits[middle].at < at)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* A part of the file as it is now; `whole`: of all of it, else of an element that is written elsewhere. */
static void copy_part(bat_svg_patch *p, size_t from, size_t to, bool whole, bat_svg_output *out) {
    size_t at = from;
    for (int i = first_edit(p, from); i < p->edit_count && (whole || p->edits[i].at < to); i++) {
        const bat_svg_edit *edit = &p->edits[i];
        if (!whole && edit->at == from && (edit->cut == 0 || edit->cut == to - from))
            continue;                /* before the element, or that it is not at its place */
        if (edit->at < at) continue; /* in something that is gone */
        copy_source(p, at, edit->at, out);
        copy_made(p, edit, out);
        if (edit->carried) {
            const bat_svg_tag *tag = &p->plan.tags.list[edit->carried];
            copy_part(p, tag->open, tag->end, false, out);
        }
        at = edit->at + edit->cut;
    }
    copy_source(p, at, to, out);
}

void bat_svg_patch_apply(bat_svg_patch *p, bat_svg_output *out) {
    if (p->edit_count > 1)
        qsort(p->edits, (size_t)p->edit_count, sizeof *p->edits, compare_edits); /* no ties */
    if (p->kept_count > 1)
        qsort(p->kept, (size_t)p->kept_count, sizeof *p->kept, compare_marks); /* no ties */
    copy_part(p, 0, p->plan.size, true, out);
    if (out->count > 1)
        qsort(out->marks, (size_t)out->count, sizeof *out->marks, compare_marks); /* no ties */
    if (out->text.failed || p->made.failed) p->status = BAT_MEMORY;
}
