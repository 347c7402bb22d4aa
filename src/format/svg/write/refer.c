#include "format/svg/write/refer.h"

#include "format/svg/write/retag.h"

#include <stdlib.h>
#include <string.h>

typedef struct named {
    const char *id;
    size_t size;
    uint32_t element;
} named;

typedef struct reference {
    uint32_t from, to;
    bool use;
} reference;

typedef struct table {
    named *ids;
    reference *references;
    uint32_t id_count, reference_count;
} table;

static int compare_text(const named *x, const char *id, size_t size) {
    const int order = memcmp(x->id, id, x->size < size ? x->size : size);
    return order ? order : (x->size > size) - (x->size < size);
}

static int compare_ids(const void *a, const void *b) {
    const named *x = a, *y = b;
    const int order = compare_text(x, y->id, y->size);
    return order ? order : (x->element > y->element) - (x->element < y->element);
}

static uint32_t find(const table *t, const char *id, size_t size) {
    uint32_t low = 0, high = t->id_count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (compare_text(&t->ids[middle], id, size) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < t->id_count && compare_text(&t->ids[low], id, size) == 0 ? t->ids[low].element : 0;
}

static bool attribute_of(const bat_svg_plan *plan, uint32_t element, const char *name, const char **value,
                         size_t *size) {
    const bat_svg_tag *tag = &plan->tags.list[element];
    const bat_svg_retag r = {.tag = plan->text + tag->open, .size = tag->body - tag->open};
    bat_svg_piece piece;
    if (!bat_svg_retag_has(&r, name, &piece)) return false;
    *value = r.tag + piece.value;
    *size = piece.end - piece.value;
    return true;
}

static void collect(const bat_svg_plan *plan, table *t) {
    const char *value;
    size_t size;
    for (uint32_t i = 1; i < plan->tags.count; i++)
        if (attribute_of(plan, i, "id", &value, &size)) t->ids[t->id_count++] = (named){value, size, i};
    if (t->id_count > 1) qsort(t->ids, t->id_count, sizeof *t->ids, compare_ids); /* no ties */
    for (uint32_t i = 1; i < plan->tags.count; i++) {
        if (!attribute_of(plan, i, "href", &value, &size) &&
            !attribute_of(plan, i, "xlink:href", &value, &size))
            continue;
        const uint32_t to = size > 1 && value[0] == '#' ? find(t, value + 1, size - 1) : 0;
        if (to) t->references[t->reference_count++] = (reference){i, to, bat_svg_is_called(plan, i, "use")};
    }
}

/* before[i]: how many of the elements below i are touched. */
static void count_touched(const bat_svg_plan *plan, uint32_t *before) {
    before[0] = 0;
    for (uint32_t i = 1; i <= plan->tags.count; i++)
        before[i] = before[i - 1] + (i > 1 && (plan->fate[i - 1] & BAT_SVG_TOUCHED) != 0);
}

static void spread(bat_svg_plan *plan, const table *t, uint32_t *before) {
    for (bool more = true; more;) {
        more = false;
        count_touched(plan, before);
        for (uint32_t k = 0; k < t->reference_count; k++) {
            const reference *r = &t->references[k];
            if (!r->use || plan->fate[r->from] & BAT_SVG_TOUCHED) continue;
            if (before[plan->tags.list[r->to].last + 1] == before[r->to]) continue;
            plan->fate[r->from] |= BAT_SVG_TOUCHED;
            more = true;
        }
    }
}

bat_status bat_svg_refer(bat_svg_plan *plan) {
    const size_t count = plan->tags.count;
    table t = {.ids = malloc(count * sizeof *t.ids), .references = malloc(count * sizeof *t.references)};
    uint32_t *before = malloc((count + 1) * sizeof *before);
    const bool made = t.ids && t.references && before;
    if (made) {
        collect(plan, &t);
        spread(plan, &t, before);
        for (size_t i = 0; i < count; i++) plan->fate[i] &= (uint8_t)~BAT_SVG_NEEDED;
        for (uint32_t k = 0; k < t.reference_count; k++)
            if (!(plan->fate[t.references[k].from] & BAT_SVG_GONE))
                plan->fate[t.references[k].to] |= BAT_SVG_NEEDED;
    }
    free(t.ids);
    free(t.references);
    free(before);
    return made ? BAT_OK : BAT_MEMORY;
}

bool bat_svg_is_called(const bat_svg_plan *plan, uint32_t element, const char *local) {
    const bat_svg_tag *tag = &plan->tags.list[element];
    const char *name = plan->text + tag->open + 1;
    const size_t length = bat_svg_tag_name(name - 1, tag->body - tag->open), size = strlen(local);
    return length >= size && memcmp(name + length - size, local, size) == 0 &&
           (length == size || name[length - size - 1] == ':');
}
