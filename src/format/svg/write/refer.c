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

/* In any prefix: files call the namespace of XLink as they like. */
static bool href_of(const bat_svg_plan *plan, uint32_t element, const char **value, size_t *size) {
    const bat_svg_tag *tag = &plan->tags.list[element];
    const char *text = plan->text + tag->open;
    size_t at = 1 + bat_svg_tag_name(text, tag->body - tag->open);
    bat_svg_piece piece;
    bool found = false;
    while (bat_svg_next_piece(text, tag->body - tag->open, &at, &piece)) {
        const size_t length = piece.equal - piece.name;
        const bool plain = length == 4 && memcmp(text + piece.name, "href", 4) == 0;
        if (!plain && (found || length < 6 || memcmp(text + piece.equal - 5, ":href", 5) != 0)) continue;
        *value = text + piece.value;
        *size = piece.end - piece.value;
        found = true;
        if (plain) break;
    }
    return found;
}

static void collect(const bat_svg_plan *plan, table *t) {
    const char *value;
    size_t size;
    for (uint32_t i = 1; i < plan->tags.count; i++)
        if (attribute_of(plan, i, "id", &value, &size)) t->ids[t->id_count++] = (named){value, size, i};
    if (t->id_count > 1) qsort(t->ids, t->id_count, sizeof *t->ids, compare_ids); /* no ties */
    for (uint32_t i = 1; i < plan->tags.count; i++) {
        if (!href_of(plan, i, &value, &size)) continue;
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

/* Whether what `use` shows of an element has been edited. An edited shape is not enough: it stays as it was for those that refer to
 * it, in a `defs` at its place. */
static bool shows_touched(const bat_svg_plan *plan, const uint32_t *before, uint32_t element) {
    const uint32_t from = plan->fate[element] & BAT_SVG_GROUPED ? element : element + 1;
    return before[plan->tags.list[element].last + 1] != before[from];
}

static void spread(bat_svg_plan *plan, const table *t, uint32_t *before) {
    for (bool more = true; more;) {
        more = false;
        count_touched(plan, before);
        for (uint32_t k = 0; k < t->reference_count; k++) {
            const reference *r = &t->references[k];
            if (!r->use || plan->fate[r->from] & BAT_SVG_TOUCHED) continue;
            if (!shows_touched(plan, before, r->to)) continue;
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
