/* <style> sheets: as much of CSS as drawings use (CSS Syntax 3, Selectors 4). */
#include "format/svg/style.h"

#include <stdlib.h>
#include <string.h>

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

static bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || (unsigned char)c >= 0x80;
}

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

/* The specificity of "type", ".class", "#id" or a compound of these; 0: any other selector. */
static uint32_t weigh(const char *selector, size_t size) {
    uint32_t ids = 0, classes = 0, types = 0;
    size_t i = 0;
    if (size == 1 && selector[0] == '*') return 1;
    if (size > 0 && is_name(selector[0])) types = 1;
    while (i < size && is_name(selector[i])) i++;
    while (i < size) {
        if (selector[i] != '.' && selector[i] != '#') return 0;
        if (selector[i] == '#')
            ids++;
        else
            classes++;
        size_t start = ++i;
        while (i < size && is_name(selector[i])) i++;
        if (i == start || classes > 100 || ids > 100) return 0;
    }
    return 1 + types + (classes << 8) + (ids << 16);
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

static int compare_keys(const void *a, const void *b) {
    const bat_svg_key *x = a, *y = b;
    int order = memcmp(x->text, y->text, x->size < y->size ? x->size : y->size);
    if (order != 0) return order;
    if (x->size != y->size) return x->size < y->size ? -1 : 1;
    return (x->rule > y->rule) - (x->rule < y->rule);
}

/* The key of a rule: the id in its selector, else the first class, else the type. */
static bat_svg_key key_of(const bat_svg_sheet *sheet, size_t rule) {
    const char *s = sheet->text + sheet->rules[rule].selector, *end = s + sheet->rules[rule].selector_size;
    const char *at = memchr(s, '#', (size_t)(end - s));
    if (!at) at = memchr(s, '.', (size_t)(end - s));
    if (!at) at = s;
    const char *to = at + 1;
    while (to < end && is_name(*to)) to++;
    return (bat_svg_key){at, (uint32_t)(to - at), (uint32_t)rule};
}

static bat_status put_in_order(bat_svg_sheet *sheet) {
    if (sheet->count == 0) return BAT_OK;
    qsort(sheet->rules, sheet->count, sizeof *sheet->rules, compare_rules); /* no ties */
    sheet->keys = malloc(sheet->count * sizeof *sheet->keys);
    if (!sheet->keys) return BAT_MEMORY;
    for (size_t i = 0; i < sheet->count; i++) sheet->keys[i] = key_of(sheet, i);
    qsort(sheet->keys, sheet->count, sizeof *sheet->keys, compare_keys); /* no ties */
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

static bat_status parse(bat_svg_sheet *sheet, size_t size) {
    const char *text = sheet->text;
    size_t room = 0, at = 0;
    while (at < size) {
        if (is_space(text[at]) || text[at] == '}') {
            at++;
            continue;
        }
        size_t open = at;
        while (open < size && text[open] != '{' && text[open] != ';') open++;
        sheet->blocks++;
        if (text[at] == '@') {
            at = open < size && text[open] == '{' ? skip_block(text, size, open) : open + 1;
            continue;
        }
        if (open >= size || text[open] != '{') {
            at = open + 1;
            continue;
        }
        size_t close = open + 1;
        while (close < size && text[close] != '}') close++;
        for (size_t from = at; from < open;) {
            size_t to = from;
            while (to < open && text[to] != ',') to++;
            size_t next = to + 1;
            while (from < to && is_space(text[from])) from++;
            while (to > from && is_space(text[to - 1])) to--;
            uint32_t weight = weigh(text + from, to - from);
            bat_svg_rule rule = {(uint32_t)from, (uint32_t)(to - from), (uint32_t)(open + 1),
                                 (uint32_t)(close - open - 1), weight};
            bat_status status = from < to && weight ? add_rule(sheet, &room, rule) : BAT_OK;
            if (status != BAT_OK) return status;
            from = next;
        }
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

static bool same(const char *text, const char *part, size_t size) {
    return text && strlen(text) == size && memcmp(text, part, size) == 0;
}

static bool has_class(const char *classes, const char *part, size_t size) {
    while (classes && *classes) {
        while (is_space(*classes)) classes++;
        size_t n = 0;
        while (classes[n] && !is_space(classes[n])) n++;
        if (n == size && memcmp(classes, part, size) == 0) return true;
        classes += n;
    }
    return false;
}

/* The first rule from `from` on whose key has this mark (0: none) and name. */
static size_t next_of(const bat_svg_sheet *sheet, char mark, const char *name, size_t size, size_t from) {
    size_t low = 0, high = sheet->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const bat_svg_key *key = &sheet->keys[middle];
        const char *text = key->text + (mark != 0);
        size_t left = key->size - (mark != 0);
        int order = mark ? (unsigned char)*key->text - (unsigned char)mark : 0;
        if (order == 0) order = memcmp(text, name, left < size ? left : size);
        if (order == 0) order = (left > size) - (left < size);
        if (order < 0 || (order == 0 && key->rule < from))
            low = middle + 1;
        else
            high = middle;
    }
    if (low == sheet->count) return sheet->count;
    const bat_svg_key *key = &sheet->keys[low];
    bool same_name = key->size == size + (mark != 0) && (!mark || *key->text == mark) &&
                     memcmp(key->text + (mark != 0), name, size) == 0;
    return same_name ? key->rule : sheet->count;
}

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

size_t bat_svg_sheet_next(const bat_svg_sheet *sheet, const char *type, const char *id, const char *classes,
                          size_t from) {
    if (from >= sheet->count) return sheet->count;
    size_t next = next_of(sheet, 0, "*", 1, from);
    if (type) next = least(next, next_of(sheet, 0, type, strlen(type), from));
    if (id) next = least(next, next_of(sheet, '#', id, strlen(id), from));
    while (classes && *classes) {
        while (is_space(*classes)) classes++;
        size_t n = 0;
        while (classes[n] && !is_space(classes[n])) n++;
        if (n > 0) next = least(next, next_of(sheet, '.', classes, n, from));
        classes += n;
    }
    return next;
}

bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const char *type,
                          const char *id, const char *classes) {
    const char *s = sheet->text + rule->selector, *end = s + rule->selector_size;
    if (*s == '*') return true;
    while (s < end) {
        char mark = *s == '.' || *s == '#' ? *s++ : ' ';
        size_t n = 0;
        while (s + n < end && is_name(s[n])) n++;
        if (!(mark == '.' ? has_class(classes, s, n) : same(mark == '#' ? id : type, s, n))) return false;
        s += n;
    }
    return true;
}
