/* Selectors of style sheets (Selectors 4): compounds of types, classes, ids, attributes, :not(), :root, :first-child and
 * :last-child, within each other (A B) or directly so (A > B). A rule with any other selector is left out. */
#include "format/svg/style.h"

#include <string.h>

enum { COMPOUNDS_MAX = 16, NAME_MAX_SIZE = 64 };

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

bool bat_svg_is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || (unsigned char)c >= 0x80;
}

/* kind: 't' a type, '*', '.', '#', '[' an attribute, '!' what must not match, ':' a place. */
typedef struct simple {
    char kind,
        test; /* test, of an attribute: 0 it is there, '=' it is the value, '~', '^', '$', '*' as in CSS */
    const char *name, *value;
    size_t size, value_size;
} simple;

static const char *name_end(const char *s, const char *end) {
    while (s < end && bat_svg_is_name(*s)) s++;
    return s;
}

/* What follows "[". */
static const char *read_attribute(const char *s, const char *end, simple *out) {
    const char *close = memchr(s, ']', (size_t)(end - s)), *to = name_end(s, end);
    if (!close || to == s) return NULL;
    out->name = s;
    out->size = (size_t)(to - s);
    if (to == close) return close + 1;
    if (*to != '=') {
        if (!strchr("~^$*", *to) || to[1] != '=') return NULL;
        out->test = *to++;
    } else
        out->test = '=';
    const char *from = to + 1;
    if (close - from >= 2 && (*from == '"' || *from == '\'') && close[-1] == *from)
        out->value = from + 1, out->value_size = (size_t)(close - from - 2);
    else
        out->value = from, out->value_size = (size_t)(close - from);
    const bool bare = out->value == from;
    return bare && (out->value_size == 0 || name_end(from, close) != close) ? NULL : close + 1;
}

/* What follows ":". */
static const char *read_place(const char *s, const char *end, simple *out) {
    const char *to = name_end(s, end);
    out->name = s;
    out->size = (size_t)(to - s);
    if (out->size == 3 && memcmp(s, "not", 3) == 0 && to < end && *to == '(') {
        const char *close = memchr(to, ')', (size_t)(end - to));
        *out = (simple){.kind = '!', .name = to + 1, .size = close ? (size_t)(close - to - 1) : 0};
        while (out->size > 0 && is_space(*out->name)) out->name++, out->size--;
        while (out->size > 0 && is_space(out->name[out->size - 1])) out->size--;
        return out->size > 0 ? close + 1 : NULL;
    }
    const bool known = (out->size == 4 && memcmp(s, "root", 4) == 0) ||
                       (out->size == 11 && memcmp(s, "first-child", 11) == 0) ||
                       (out->size == 10 && memcmp(s, "last-child", 10) == 0);
    return known ? to : NULL;
}

/* Reads one part of a compound; NULL: it is none that is known. */
static const char *read_simple(const char *s, const char *end, bool first, simple *out) {
    *out = (simple){.kind = *s, .name = s + 1};
    if (*s == '[') return read_attribute(s + 1, end, out);
    if (*s == ':') return read_place(s + 1, end, out);
    if (*s == '*') return first ? s + 1 : NULL;
    if (*s != '.' && *s != '#') {
        out->kind = 't';
        out->name = s;
        if (!first) return NULL;
    }
    const char *to = name_end(out->name, end);
    out->size = (size_t)(to - out->name);
    return out->size > 0 ? to : NULL;
}

/* Where the compound ends; NULL: it is none that is known. */
static const char *compound_end(const char *s, const char *end) {
    const char *from = s;
    simple part;
    while (s && s < end && !is_space(*s) && *s != '>') s = read_simple(s, end, s == from, &part);
    return s == from ? NULL : s;
}

typedef struct compound {
    const char *from, *to;
    bool child; /* directly within the one before it */
} compound;

/* How many compounds the selector has; 0: it is none that is known. */
static int split(const char *s, const char *end, compound *list) {
    int count = 0;
    bool child = false;
    while (s < end) {
        const char *to = compound_end(s, end);
        if (!to || count == COMPOUNDS_MAX) return 0;
        list[count++] = (compound){s, to, child};
        child = false;
        for (s = to; s < end && (is_space(*s) || *s == '>'); s++) {
            if (*s == '>' && child) return 0;
            child = child || *s == '>';
        }
    }
    return child ? 0 : count;
}

/* Adds to the counts of ids, classes and types; false: :not() holds something that is not known. */
static bool count_parts(const char *s, const char *end, uint32_t count[3]) {
    const char *from = s;
    simple part;
    while (s < end) {
        s = read_simple(s, end, s == from, &part);
        if (!s) return false;
        if (part.kind == '!') {
            for (const char *at = part.name, *to = at + part.size; at < to;) {
                simple inner;
                at = read_simple(at, to, at == part.name, &inner);
                if (!at || inner.kind == '!' || is_space(at < to ? *at : 'x')) return false;
                if (inner.kind != '*') count[inner.kind == '#' ? 0 : inner.kind == 't' ? 2 : 1]++;
            }
        } else if (part.kind != '*')
            count[part.kind == '#' ? 0 : part.kind == 't' ? 2 : 1]++;
    }
    return true;
}

uint32_t bat_svg_selector_weigh(const char *selector, size_t size, uint32_t *subject) {
    compound list[COMPOUNDS_MAX];
    uint32_t parts[3] = {0, 0, 0};
    const int count = split(selector, selector + size, list);
    for (int i = 0; i < count; i++)
        if (!count_parts(list[i].from, list[i].to, parts)) return 0;
    if (count == 0 || parts[0] > 100 || parts[1] > 100 || parts[2] > 100) return 0;
    *subject = (uint32_t)(list[count - 1].from - selector);
    return 1 + parts[2] + (parts[1] << 8) + (parts[0] << 16);
}

bat_svg_key bat_svg_selector_key(const char *s, const char *end) {
    static const char any[] = "*";
    bat_svg_key key = {any, 1, 0};
    int best = 0;
    const char *from = s;
    simple part;
    while (s && s < end) {
        const char *at = s;
        s = read_simple(s, end, s == from, &part);
        const int rank = part.kind == '#' ? 3 : part.kind == '.' ? 2 : part.kind == 't' ? 1 : 0;
        if (!s || rank <= best) continue;
        best = rank;
        key = (bat_svg_key){at, (uint32_t)(s - at), 0};
    }
    return key;
}

/* ---- matching ---- */

static bool same(const char *text, const char *part, size_t size) {
    return text && strlen(text) == size && memcmp(text, part, size) == 0;
}

static bool has_word(const char *words, const char *part, size_t size) {
    while (words && *words) {
        while (is_space(*words)) words++;
        size_t n = 0;
        while (words[n] && !is_space(words[n])) n++;
        if (n > 0 && n == size && memcmp(words, part, size) == 0) return true;
        words += n;
    }
    return false;
}

static bool contains(const char *text, const char *part, size_t size) {
    for (size_t left = strlen(text); left >= size; left--, text++)
        if (memcmp(text, part, size) == 0) return true;
    return false;
}

static bool attribute_matches(const bat_svg_tree *tree, uint32_t element, const simple *part) {
    char name[NAME_MAX_SIZE];
    if (part->size >= sizeof name) return false;
    memcpy(name, part->name, part->size);
    name[part->size] = '\0';
    const char *text = bat_svg_tree_attribute(tree, element, name);
    const size_t size = part->value_size, whole = text ? strlen(text) : 0;
    if (!text || !part->test) return text != NULL;
    if (part->test == '=') return same(text, part->value, size);
    if (part->test == '~') return has_word(text, part->value, size);
    if (size == 0 || size > whole) return false;
    if (part->test == '^') return memcmp(text, part->value, size) == 0;
    if (part->test == '$') return memcmp(text + whole - size, part->value, size) == 0;
    return contains(text, part->value, size);
}

static bool place_matches(const bat_svg_tree *tree, uint32_t element, const simple *part) {
    const uint32_t parent = tree->elements[element].parent;
    if (part->name[0] == 'r') return parent == 0;
    if (part->name[0] == 'l') return parent != 0 && tree->elements[element].next == 0;
    return parent != 0 && tree->elements[parent].first == element;
}

static bool part_matches(const bat_svg_tree *tree, uint32_t element, const simple *part) {
    switch (part->kind) {
    case '*': return true;
    case 't': return same(bat_svg_tree_name(tree, element), part->name, part->size);
    case '#': return same(bat_svg_tree_attribute(tree, element, "id"), part->name, part->size);
    case '.': return has_word(bat_svg_tree_attribute(tree, element, "class"), part->name, part->size);
    case '[': return attribute_matches(tree, element, part);
    default: return place_matches(tree, element, part);
    }
}

/* What stands in :not() holds no other :not(). */
static bool not_matches(const bat_svg_tree *tree, uint32_t element, const simple *part) {
    simple inner;
    for (const char *at = part->name, *end = at + part->size; at && at < end;) {
        at = read_simple(at, end, at == part->name, &inner);
        if (at && !part_matches(tree, element, &inner)) return true;
    }
    return false;
}

static bool compound_matches(const compound *c, const bat_svg_tree *tree, uint32_t element) {
    simple part;
    for (const char *s = c->from; s && s < c->to;) {
        s = read_simple(s, c->to, s == c->from, &part);
        const bool good = part.kind == '!' ? not_matches(tree, element, &part)
                                           : part_matches(tree, element, &part);
        if (!good) return false;
    }
    return true;
}

/* Whether the compounds first to last, each directly within the one before it, match the element and those around it; the
 * outermost of these, or 0. */
static uint32_t chain_at(const compound *list, int first, int last, const bat_svg_tree *tree,
                         uint32_t element) {
    for (int i = last; element; i--, element = tree->elements[element].parent) {
        if (!compound_matches(&list[i], tree, element)) return 0;
        if (i == first) return element;
    }
    return 0;
}

/* From the last chain of compounds to the first, each as near as it can be: what is further out stays possible. */
bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const bat_svg_tree *tree,
                          uint32_t element) {
    compound list[COMPOUNDS_MAX];
    const char *text = sheet->text + rule->selector;
    int last = split(text, text + rule->selector_size, list) - 1;
    for (bool within = false; last >= 0; within = true) {
        int first = last;
        while (first > 0 && list[first].child) first--;
        uint32_t top = chain_at(list, first, last, tree, element);
        while (!top && within && (element = tree->elements[element].parent))
            top = chain_at(list, first, last, tree, element);
        if (!top) return false;
        if (first == 0) return true;
        element = tree->elements[top].parent;
        if (!element) return false;
        last = first - 1;
    }
    return false;
}
