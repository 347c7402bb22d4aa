/* Selectors of style sheets (Selectors 4): compounds of types, classes, ids, attributes, :not(), :root, :first-child and
 * :last-child, within each other (A B) or directly so (A > B), behind each other (A ~ B) or directly so (A + B). A rule with any
 * other selector is left out. */
#include "format/svg/style.h"

#include <string.h>

enum { COMPOUNDS_MAX = 16, NAME_MAX_SIZE = 64, STEPS_MAX = 4096 };

static bool is_joint(char c) { return c == '>' || c == '+' || c == '~'; }
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
    while (s && s < end && !is_space(*s) && !is_joint(*s)) s = read_simple(s, end, s == from, &part);
    return s == from ? NULL : s;
}

typedef struct compound {
    const char *from, *to;
    char
        joint; /* where it stands: ' ' within the one before it, '>' directly so, '~' behind it, '+' directly so */
} compound;

/* How many compounds the selector has; 0: it is none that is known. */
static int split(const char *s, const char *end, compound *list) {
    int count = 0;
    char joint = ' ';
    while (s < end) {
        const char *to = compound_end(s, end);
        if (!to || count == COMPOUNDS_MAX) return 0;
        list[count++] = (compound){s, to, joint};
        joint = ' ';
        for (s = to; s < end && (is_space(*s) || is_joint(*s)); s++) {
            if (is_joint(*s) && joint != ' ') return 0;
            if (is_joint(*s)) joint = *s;
        }
    }
    return joint == ' ' ? count : 0;
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

static bat_svg_key key_of(const simple *part) {
    bat_svg_key key = {.mark = part->kind, .text = part->name, .size = (uint32_t)part->size};
    const bool ends = part->test == '^' || part->test == '$';
    if (part->kind != '[') return key;
    if (part->test == '~' && part->size == 5 && memcmp(part->name, "class", 5) == 0)
        return (bat_svg_key){.mark = '.', .text = part->value, .size = (uint32_t)part->value_size};
    if (part->test == '=' || (ends && part->value_size > 0 && part->value_size <= BAT_SVG_ENDS_MAX))
        key.mark = part->test, key.value = part->value, key.value_size = (uint32_t)part->value_size;
    return key;
}

bat_svg_key bat_svg_selector_key(const char *s, const char *end) {
    static const char any[] = "*", marks[] = "*t[.$^=#"; /* the rarer, the later */
    bat_svg_key best = {.mark = 't', .text = any, .size = 1};
    const char *from = s;
    ptrdiff_t most = 0;
    simple part;
    while (s && s < end) {
        s = read_simple(s, end, s == from, &part);
        if (!s) break;
        const bat_svg_key key = key_of(&part);
        const char *found = memchr(marks, key.mark, sizeof marks - 1);
        if (!found || found - marks <= most) continue;
        most = found - marks, best = key;
    }
    return best;
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

/* How far a failure reaches: another place may still match, no sibling's may, none may. So no place is tried twice. */
typedef enum outcome { MATCHES, FAILS_HERE, FAILS_SIBLINGS, FAILS } outcome;

typedef struct search {
    const compound *list;
    const bat_svg_tree *tree;
    int left; /* steps; beyond them nothing matches */
} search;

/* 0: it is the first one. */
static uint32_t sibling_before(const bat_svg_tree *tree, uint32_t element) {
    const uint32_t parent = tree->elements[element].parent;
    uint32_t at = element - 1;
    if (!parent || at == parent) return 0;
    while (tree->elements[at].parent != parent) at = tree->elements[at].parent;
    return at;
}

/* The compounds up to the last, that one at the element. */
static outcome match(search *s, int last, uint32_t element) {
    const bat_svg_element *elements = s->tree->elements;
    const char joint = s->list[last].joint;
    outcome found = FAILS_HERE;
    if (--s->left < 0) return FAILS;
    if (!compound_matches(&s->list[last], s->tree, element)) return FAILS_HERE;
    if (last == 0) return MATCHES;
    if (joint == '>') {
        if (elements[element].parent) found = match(s, last - 1, elements[element].parent);
        return found == MATCHES || found == FAILS ? found : FAILS_SIBLINGS;
    }
    if (joint == '+') {
        const uint32_t before = sibling_before(s->tree, element);
        return before ? match(s, last - 1, before) : FAILS_HERE;
    }
    if (joint == '~') {
        for (uint32_t at = sibling_before(s->tree, element); at; at = sibling_before(s->tree, at))
            if ((found = match(s, last - 1, at)) != FAILS_HERE) return found;
        return FAILS_SIBLINGS;
    }
    for (uint32_t at = elements[element].parent; at; at = elements[at].parent)
        if ((found = match(s, last - 1, at)) == MATCHES || found == FAILS) return found;
    return FAILS;
}

bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const bat_svg_tree *tree,
                          uint32_t element, long *steps) {
    compound list[COMPOUNDS_MAX];
    const char *text = sheet->text + rule->selector;
    search s = {list, tree, STEPS_MAX};
    const bool good = match(&s, split(text, text + rule->selector_size, list) - 1, element) == MATCHES;
    *steps += STEPS_MAX - s.left;
    return good;
}
