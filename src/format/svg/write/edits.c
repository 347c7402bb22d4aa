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
    p->edits[p->edit_count] = (bat_svg_edit){at, cut, from, p->made.size, p->edit_count};
    p->edit_count++;
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
    static const char *const begins[] = {"<linearGradient id=\"" BAT_SVG_PAINT_ID,
                                         "<radialGradient id=\"" BAT_SVG_PAINT_ID,
                                         "<clipPath id=\"" BAT_SVG_PAINT_ID};
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
