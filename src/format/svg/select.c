/* Selectors of style sheets (Selectors 4): compounds of types, classes, ids, attributes, :not(), :is(), :where() and places among
 * siblings (rank.c), within each other (A B) or directly so (A > B), behind each other (A ~ B) or directly so (A + B). A
 * pseudo-class that is not known here, such as :has(), is a guess: it may match. One of what a pointer or a key does, such as
 * :hover, never matches. A rule with any other selector is left out. */
#include "format/svg/style.h"

#include <string.h>

enum { COMPOUNDS_MAX = 16, NAME_MAX_SIZE = 64, STEPS_MAX = 4096, LISTS_DEEP = 4 };

static bool is_joint(char c) { return c == '>' || c == '+' || c == '~'; }
static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

bool bat_svg_is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || (unsigned char)c >= 0x80;
}

/* kind: 't' a type, '*', '.', '#', '[' an attribute, ':' a place, '?' a guess, '0' what never matches; of a list '!' none may
 * match, '|' one must, 'w' one must, which weighs nothing. */
typedef struct simple {
    char kind,
        test; /* test, of an attribute: 0 it is there, '=' it is the value, '~', '^', '$', '*' as in CSS */
    const char *name, *value; /* value: of an attribute; a list */
    size_t size, value_size;
    bat_svg_rank rank;
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

static const struct {
    const char *name;
    char kind;
} pseudo_classes[] = {{"not", '!'},       {"is", '|'},     {"where", 'w'},         {"hover", '0'},
                      {"active", '0'},    {"focus", '0'},  {"focus-visible", '0'}, {"focus-within", '0'},
                      {"visited", '0'},   {"target", '0'}, {"has", '?'},           {"lang", '?'},
                      {"dir", '?'},       {"empty", '?'},  {"link", '?'},          {"any-link", '?'},
                      {"nth-child", '?'}, {"scope", '?'},  {"nth-last-child", '?'} /* with "of" */};

/* The bracket that closes the one at s, or NULL. */
static const char *closing(const char *s, const char *end) {
    int depth = 0;
    for (; s < end; s++) {
        depth += (*s == '(') - (*s == ')');
        if (depth == 0) return s;
    }
    return NULL;
}

/* What follows ":". */
static const char *read_pseudo(const char *s, const char *end, simple *out) {
    const char *to = name_end(s, end), *close = NULL;
    *out = (simple){.name = s, .size = (size_t)(to - s)};
    if (to < end && *to == '(') {
        close = closing(to, end);
        if (!close) return NULL;
        const char *from = to + 1, *last = close;
        while (from < last && is_space(*from)) from++;
        while (last > from && is_space(last[-1])) last--;
        if (from == last) return NULL;
        out->value = from, out->value_size = (size_t)(last - from);
    }
    to = close ? close + 1 : to;
    if (bat_svg_rank_read(out->name, out->size, out->value, out->value_size, &out->rank)) {
        out->kind = ':';
        return to;
    }
    for (size_t i = 0; i < sizeof pseudo_classes / sizeof *pseudo_classes; i++) {
        const char *name = pseudo_classes[i].name;
        if (strlen(name) != out->size || memcmp(name, out->name, out->size) != 0) continue;
        out->kind = pseudo_classes[i].kind;
        return !strchr("!|w", out->kind) || close ? to : NULL;
    }
    return NULL;
}

/* Reads one part of a compound; NULL: it is none that is known. */
static const char *read_simple(const char *s, const char *end, bool first, simple *out) {
    *out = (simple){.kind = *s, .name = s + 1};
    if (*s == '[') return read_attribute(s + 1, end, out);
    if (*s == ':') return read_pseudo(s + 1, end, out);
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

const char *bat_svg_list_end(const char *from, const char *end) {
    int depth = 0;
    char quote = 0;
    for (; from < end; from++) {
        const char c = *from;
        if (quote)
            quote = c == quote ? 0 : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '(' || c == '[')
            depth++;
        else if (c == ')' || c == ']')
            depth--;
        else if (c == ',' && depth <= 0)
            return from;
    }
    return end;
}

/* The next of a list of compounds: [*from, *to); false: there is none. */
static bool next_of_list(const char **at, const char *end, const char **from, const char **to) {
    if (*at >= end) return false;
    *from = *at;
    *to = bat_svg_list_end(*at, end);
    *at = *to + 1;
    while (*from < *to && is_space(**from)) ++*from;
    while (*to > *from && is_space((*to)[-1])) --*to;
    return true;
}

static uint32_t weight_of(const uint32_t count[3]) { return count[2] + (count[1] << 8) + (count[0] << 16); }

/* Adds to the counts of ids, classes and types; *guess: it holds one. */
static void count_parts(const char *s, const char *end, int deep, uint32_t count[3], bool *guess);

/* A list counts as the weightiest in it. */
static void count_list(const simple *part, int deep, uint32_t count[3], bool *guess) {
    uint32_t most[3] = {0, 0, 0};
    const char *at = part->value, *end = at + part->value_size, *from, *to;
    while (next_of_list(&at, end, &from, &to)) {
        uint32_t one[3] = {0, 0, 0};
        if (deep == LISTS_DEEP || compound_end(from, to) != to) {
            *guess = true;
            continue;
        }
        count_parts(from, to, deep + 1, one, guess);
        if (weight_of(one) > weight_of(most)) memcpy(most, one, sizeof most);
    }
    for (int k = 0; k < 3 && part->kind != 'w'; k++) count[k] += most[k];
}

static void count_parts(const char *s, const char *end, int deep, uint32_t count[3], bool *guess) {
    const char *from = s;
    simple part;
    while (s && s < end) {
        s = read_simple(s, end, s == from, &part);
        if (!s) return;
        if (strchr("!|w", part.kind))
            count_list(&part, deep, count, guess);
        else if (part.kind != '*')
            count[part.kind == '#' ? 0 : part.kind == 't' ? 2 : 1]++;
        *guess = *guess || part.kind == '?';
    }
}

uint32_t bat_svg_selector_weigh(const char *selector, size_t size, uint32_t *subject, bool *guess) {
    compound list[COMPOUNDS_MAX];
    uint32_t parts[3] = {0, 0, 0};
    const int count = split(selector, selector + size, list);
    for (int i = 0; i < count; i++) count_parts(list[i].from, list[i].to, 0, parts, guess);
    if (count == 0 || parts[0] > 100 || parts[1] > 100 || parts[2] > 100) return 0;
    *subject = (uint32_t)(list[count - 1].from - selector);
    return 1 + weight_of(parts);
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

static bool compound_matches(const char *s, const char *end, const bat_svg_tree *tree, uint32_t element);

/* Whether one of the list matches; one that cannot be read may, so that it is a guess. */
static bool list_matches(const simple *part, const bat_svg_tree *tree, uint32_t element) {
    const char *at = part->value, *end = at + part->value_size, *from, *to;
    while (next_of_list(&at, end, &from, &to)) {
        const bool known = compound_end(from, to) == to;
        if (known ? compound_matches(from, to, tree, element) : part->kind != '!') return true;
    }
    return false;
}

static bool part_matches(const bat_svg_tree *tree, uint32_t element, const simple *part) {
    switch (part->kind) {
    case '*':
    case '?': return true;
    case '0': return false;
    case 't': return same(bat_svg_tree_name(tree, element), part->name, part->size);
    case '#': return same(bat_svg_tree_attribute(tree, element, "id"), part->name, part->size);
    case '.': return has_word(bat_svg_tree_attribute(tree, element, "class"), part->name, part->size);
    case '[': return attribute_matches(tree, element, part);
    case ':': return bat_svg_rank_holds(&part->rank, tree, element);
    default: return list_matches(part, tree, element) == (part->kind != '!');
    }
}

static bool compound_matches(const char *s, const char *end, const bat_svg_tree *tree, uint32_t element) {
    const char *from = s;
    simple part;
    while (s && s < end) {
        s = read_simple(s, end, s == from, &part);
        if (!s || !part_matches(tree, element, &part)) return false;
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
    if (!compound_matches(s->list[last].from, s->list[last].to, s->tree, element)) return FAILS_HERE;
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
