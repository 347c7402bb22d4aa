/* <style> sheets: as much of CSS as drawings use (CSS Syntax 3, Selectors 4). */
#include "format/svg/style.h"

#include <stdlib.h>
#include <string.h>

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/* Removes comments and the marks of HTML comments (<!--, -->), in place; returns the new size. */
static size_t drop_comments(char *text, size_t size) {
    size_t n = 0;
    for (size_t i = 0; i < size;) {
        if (size - i >= 2 && text[i] == '/' && text[i + 1] == '*') {
            for (i += 2; i < size && !(text[i] == '*' && i + 1 < size && text[i + 1] == '/');) i++;
            i = size - i >= 2 ? i + 2 : size;
            text[n++] = ' ';
        } else if (size - i >= 4 && memcmp(text + i, "<!--", 4) == 0)
            i += 4;
        else if (size - i >= 3 && memcmp(text + i, "-->", 3) == 0)
            i += 3;
        else
            text[n++] = text[i++];
    }
    return n;
}

static bat_status add_rule(bat_svg_sheet *sheet, size_t *room, bat_svg_rule rule) {
    if (sheet->count >= BAT_SVG_RULES_MAX) return BAT_OK;
    if (sheet->count == *room) {
        size_t more = *room < 32 ? 32 : *room * 2;
        bat_svg_rule *grown = realloc(sheet->rules, more * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        sheet->rules = grown;
        *room = more;
    }
    sheet->rules[sheet->count++] = rule;
    return BAT_OK;
}

static int compare_rules(const void *a, const void *b) {
    const bat_svg_rule *x = a, *y = b;
    if (x->weight != y->weight) return x->weight < y->weight ? -1 : 1;
    if (x->body != y->body) return x->body < y->body ? -1 : 1;
    return (x->selector > y->selector) - (x->selector < y->selector);
}

static int compare_texts(const char *a, size_t a_size, const char *b, size_t b_size) {
    const size_t both = a_size < b_size ? a_size : b_size;
    const int order = both > 0 ? memcmp(a, b, both) : 0;
    return order ? order : (a_size > b_size) - (a_size < b_size);
}

int bat_svg_key_compare(const bat_svg_key *a, const bat_svg_key *b) {
    if (a->mark != b->mark) return a->mark < b->mark ? -1 : 1;
    const int order = compare_texts(a->text, a->size, b->text, b->size);
    return order ? order : compare_texts(a->value, a->value_size, b->value, b->value_size);
}

static int compare_keys(const void *a, const void *b) {
    const bat_svg_key *x = a, *y = b;
    const int order = bat_svg_key_compare(x, y);
    return order ? order : (x->rule > y->rule) - (x->rule < y->rule);
}

/* The key of a rule: of the last compound of its selector the id, else an attribute's value, a class, an attribute, the type. */
static bat_svg_key key_of(const bat_svg_sheet *sheet, size_t rule) {
    const bat_svg_rule *r = &sheet->rules[rule];
    const char *s = sheet->text + r->selector;
    bat_svg_key key = bat_svg_selector_key(s + r->subject, s + r->selector_size);
    key.rule = (uint32_t)rule;
    return key;
}

static bat_status put_in_order(bat_svg_sheet *sheet) {
    if (sheet->count == 0) return BAT_OK;
    qsort(sheet->rules, sheet->count, sizeof *sheet->rules, compare_rules); /* no ties */
    sheet->keys = malloc(sheet->count * sizeof *sheet->keys);
    if (!sheet->keys) return BAT_MEMORY;
    for (size_t i = 0; i < sheet->count; i++) {
        sheet->keys[i] = key_of(sheet, i);
        if (strchr("=^$[", sheet->keys[i].mark)) sheet->by_attributes = true;
        if (strchr("^$", sheet->keys[i].mark)) sheet->by_ends = true;
    }
    qsort(sheet->keys, sheet->count, sizeof *sheet->keys, compare_keys); /* no ties */
    for (size_t i = sheet->count; i-- > 0;) {
        const bool alike = i + 1 < sheet->count &&
                           bat_svg_key_compare(&sheet->keys[i], &sheet->keys[i + 1]) == 0;
        sheet->keys[i].end = alike ? sheet->keys[i + 1].end : (uint32_t)i + 1;
    }
    return BAT_OK;
}

/* The position after the block that opens at `at`. */
static size_t skip_block(const char *text, size_t size, size_t at) {
    int depth = 0;
    for (; at < size; at++) {
        if (text[at] == '{') depth++;
        if (text[at] == '}' && --depth <= 0) return at + 1;
    }
    return size;
}

static bool begins(const char *at, const char *end, const char *word) {
    const size_t size = strlen(word);
    return (size_t)(end - at) >= size && memcmp(at, word, size) == 0;
}

/* Whether rules within an "@" block hold. */
typedef enum holds { NEVER, MAYBE, ALWAYS } holds;

/* Whether a media query holds for a picture on a screen whose colours are light. */
static holds query_holds(const char *at, const char *end) {
    static const char *const shown[] = {"screen", "all", "only screen", "only all"};
    static const char *const unseen[] = {"print",       "speech",  "only print",
                                         "only speech", "not all", "not screen"};
    while (at < end && is_space(*at)) at++;
    while (end > at && is_space(end[-1])) end--;
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        if (strlen(shown[i]) == (size_t)(end - at) && begins(at, end, shown[i])) return ALWAYS;
    for (size_t i = 0; i < sizeof unseen / sizeof *unseen; i++)
        if (begins(at, end, unseen[i])) return NEVER;
    for (const char *s = at; s < end; s++)
        if (begins(s, end, "prefers-")) {
            for (const char *light = s; light < end; light++)
                if (begins(light, end, "light")) return MAYBE;
            return NEVER;
        }
    return MAYBE;
}

/* The same of a block's "@..."; NEVER also where it holds no rules. */
static holds block_holds(const char *at, const char *end) {
    static const char *const others[] = {"@supports", "@layer", "@container", "@scope"};
    holds best = NEVER;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (begins(at, end, others[i])) return MAYBE;
    if (!begins(at, end, "@media") || bat_svg_is_name(at[6])) return NEVER;
    for (at += 6; at < end && is_space(*at);) at++;
    if (at == end) return ALWAYS; /* nothing is said */
    while (at <= end) {
        const char *to = bat_svg_list_end(at, end);
        const holds found = query_holds(at, to);
        if (found > best) best = found;
        at = to + 1;
    }
    return best;
}

/* Adds a rule for each selector from `at` on, of the block that opens at `open`; guess: it may hold. */
static bat_status add_rules(bat_svg_sheet *sheet, size_t *room, size_t at, size_t open, size_t close,
                            bool guess) {
    const char *text = sheet->text;
    for (size_t from = at; from < open;) {
        size_t to = (size_t)(bat_svg_list_end(text + from, text + open) - text);
        const size_t next = to + 1;
        while (from < to && is_space(text[from])) from++;
        while (to > from && is_space(text[to - 1])) to--;
        bat_svg_rule rule = {.selector = (uint32_t)from,
                             .selector_size = (uint32_t)(to - from),
                             .body = (uint32_t)(open + 1),
                             .body_size = (uint32_t)(close - open - 1),
                             .guess = guess};
        rule.weight = bat_svg_selector_weigh(text + from, to - from, &rule.subject, &rule.guess);
        const bat_status status = from < to && rule.weight ? add_rule(sheet, room, rule) : BAT_OK;
        if (status != BAT_OK) return status;
        from = next;
    }
    return BAT_OK;
}

static bat_status parse(bat_svg_sheet *sheet, size_t size) {
    const char *text = sheet->text;
    size_t room = 0, at = 0, doubtful = 0; /* up to there rules may hold */
    while (at < size) {
        if (is_space(text[at]) || text[at] == '}') { /* also that of @media */
            at++;
            continue;
        }
        size_t open = at;
        while (open < size && text[open] != '{' && text[open] != ';') open++;
        sheet->blocks++;
        if (text[at] == '@') {
            const bool block = open < size && text[open] == '{';
            const holds held = block ? block_holds(text + at, text + open) : NEVER;
            const size_t end = block ? skip_block(text, size, open) : open + 1;
            if (held == MAYBE && end > doubtful) doubtful = end;
            at = held == NEVER ? end : open + 1;
            continue;
        }
        if (open >= size || text[open] != '{') {
            at = open + 1;
            continue;
        }
        size_t close = open + 1;
        while (close < size && text[close] != '}') close++;
        const bat_status status = add_rules(sheet, &room, at, open, close, at < doubtful);
        if (status != BAT_OK) return status;
        at = close + 1;
    }
    return put_in_order(sheet);
}

bat_status bat_svg_sheet_parse(const char *text, size_t size, bat_svg_sheet *sheet) {
    *sheet = (bat_svg_sheet){0};
    if (size == 0) return BAT_OK;
    sheet->text = malloc(size + 1);
    if (!sheet->text) return BAT_MEMORY;
    memcpy(sheet->text, text, size);
    size = drop_comments(sheet->text, size);
    sheet->text[size] = '\0';
    sheet->variables = strstr(sheet->text, "--") != NULL;
    sheet->ranks = strstr(sheet->text, "-child") || strstr(sheet->text, "-of-type");
    sheet->important = strchr(sheet->text, '!') != NULL;
    bat_status status = parse(sheet, size);
    if (status != BAT_OK) bat_svg_sheet_free(sheet);
    return status;
}

void bat_svg_sheet_free(bat_svg_sheet *sheet) {
    free(sheet->text);
    free(sheet->rules);
    free(sheet->keys);
    *sheet = (bat_svg_sheet){0};
}

/* ---- the rules that may match an element: those that ask for its type, id, classes or attributes ---- */

/* Where keys begin that ask for what the element has; each goes on to its `end`. */
typedef struct runs {
    const bat_svg_sheet *sheet;
    uint32_t *starts; /* owned */
    size_t count, room;
    bool failed;
} runs;

static void add_run(runs *r, char mark, const char *text, size_t size, const char *value, size_t value_size) {
    const bat_svg_key wanted = {.mark = mark,
                                .text = text,
                                .size = (uint32_t)size,
                                .value = value,
                                .value_size = (uint32_t)value_size};
    const bat_svg_key *keys = r->sheet->keys;
    size_t low = 0, high = r->sheet->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (bat_svg_key_compare(&keys[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == r->sheet->count || bat_svg_key_compare(&keys[low], &wanted) != 0) return;
    if (r->count == r->room) {
        const size_t more = r->room ? r->room * 2 : 16;
        uint32_t *grown = realloc(r->starts, more * sizeof *grown);
        if (!grown) {
            r->failed = true;
            return;
        }
        r->starts = grown;
        r->room = more;
    }
    r->starts[r->count++] = (uint32_t)low;
}

static void add_classes(runs *r, const char *classes) {
    while (*classes) {
        while (is_space(*classes)) classes++;
        size_t n = 0;
        while (classes[n] && !is_space(classes[n])) n++;
        if (n > 0) add_run(r, '.', classes, n, NULL, 0);
        classes += n;
    }
}

static void add_attribute(runs *r, const char *name, const char *value) {
    const size_t name_size = strlen(name), size = strlen(value),
                 most = !r->sheet->by_ends        ? 0
                        : size < BAT_SVG_ENDS_MAX ? size
                                                  : BAT_SVG_ENDS_MAX;
    add_run(r, '[', name, name_size, NULL, 0);
    add_run(r, '=', name, name_size, value, size);
    for (size_t n = 1; n <= most; n++) {
        add_run(r, '^', name, name_size, value, n);
        add_run(r, '$', name, name_size, value + size - n, n);
    }
}

static void add_all(runs *r, const bat_svg_tree *tree, uint32_t element) {
    const char *type = bat_svg_tree_name(tree, element), *id = bat_svg_tree_attribute(tree, element, "id"),
               *classes = bat_svg_tree_attribute(tree, element, "class");
    add_run(r, 't', "*", 1, NULL, 0);
    if (type) add_run(r, 't', type, strlen(type), NULL, 0);
    if (id) add_run(r, '#', id, strlen(id), NULL, 0);
    if (classes) add_classes(r, classes);
    if (!r->sheet->by_attributes) return;
    const bat_svg_element *e = &tree->elements[element];
    const uint32_t *pair = tree->attributes + e->attributes;
    for (uint32_t k = 0; k < e->attribute_count; k++, pair += 2)
        add_attribute(r, tree->strings.data + pair[0], tree->strings.data + pair[1]);
}

static int compare_starts(const void *a, const void *b) {
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* A class named twice is one run. */
static void each_once(runs *r) {
    size_t kept = 0;
    if (r->count > 1)
        qsort(r->starts, r->count, sizeof *r->starts, compare_starts); /* no ties but of equals */
    for (size_t i = 0; i < r->count; i++)
        if (kept == 0 || r->starts[i] != r->starts[kept - 1]) r->starts[kept++] = r->starts[i];
    r->count = kept;
}

/* The position after the ascending run at `at`. */
static size_t run_end(const uint32_t *rules, size_t at, size_t count) {
    for (at++; at < count && rules[at - 1] < rules[at];) at++;
    return at;
}

/* Merges [a, b) and [b, c) of `from` into [a, c) of `to`. */
static void merge(const uint32_t *from, size_t a, size_t b, size_t c, uint32_t *to) {
    for (size_t i = a, k = b, n = a; n < c;)
        to[n++] = k == c || (i < b && from[i] < from[k]) ? from[i++] : from[k++];
}

/* Sorts by merging what ascends already: O(n log k) for k runs. No two are equal, since a rule has one key. */
static void sort(uint32_t *rules, size_t count) {
    uint32_t *from = rules, *to = rules + count;
    for (bool sorted = false; !sorted;) {
        sorted = count == 0 || run_end(from, 0, count) == count;
        if (sorted) break;
        for (size_t a = 0; a < count;) {
            const size_t b = run_end(from, a, count), c = b < count ? run_end(from, b, count) : b;
            merge(from, a, b, c, to);
            a = c;
        }
        uint32_t *other = from;
        from = to;
        to = other;
    }
    if (from != rules) memcpy(rules, from, count * sizeof *rules);
}

bat_status bat_svg_candidates_find(const bat_svg_sheet *sheet, const bat_svg_tree *tree, uint32_t element,
                                   bat_svg_candidates *out) {
    runs r = {.sheet = sheet};
    out->count = 0;
    if (sheet->count == 0) return BAT_OK;
    add_all(&r, tree, element);
    each_once(&r);
    size_t count = 0;
    for (size_t i = 0; i < r.count; i++) count += sheet->keys[r.starts[i]].end - r.starts[i];
    if (!r.failed && count > out->room) {
        uint32_t *grown = realloc(out->rules, 2 * count * sizeof *grown);
        r.failed = !grown;
        if (grown) out->rules = grown, out->room = count;
    }
    for (size_t i = 0; !r.failed && i < r.count; i++)
        for (uint32_t k = r.starts[i]; k < sheet->keys[r.starts[i]].end; k++)
            out->rules[out->count++] = sheet->keys[k].rule;
    if (out->count > 1) sort(out->rules, out->count);
    free(r.starts);
    return r.failed ? BAT_MEMORY : BAT_OK;
}

void bat_svg_candidates_free(bat_svg_candidates *candidates) {
    free(candidates->rules);
    *candidates = (bat_svg_candidates){0};
}
