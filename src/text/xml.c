/* XML 1.0, chapters 2 to 4: a recursive descent without the recursion, since elements nest as deep as they like. */
#include "text/xml.h"

#include "text/text.h"
#include "text/utf8.h"

#include <stdlib.h>
#include <string.h>

/* A part of the text. */
typedef struct span {
    const char *at;
    size_t size;
} span;

typedef struct entity {
    span name, value;
} entity;

/* Every function that reads something moves `at` behind it, or returns false. */
typedef struct reading {
    const char *text;
    size_t size, at;
    bat_text open, names; /* lists of spans: elements, attributes of a tag */
    bat_text entities;    /* those declared, in the order of their names after the document type */
} reading;

static void push(bat_text *list, span s) { bat_text_add(list, (const char *)&s, sizeof s); }
static size_t count_of(const bat_text *list) { return list->size / sizeof(span); }
static span *spans_of(const bat_text *list) { return (span *)(void *)list->data; }

static int compare_spans(const void *a, const void *b) {
    const span *x = a, *y = b;
    const int order = memcmp(x->at, y->at, x->size < y->size ? x->size : y->size);
    return order ? order : (x->size > y->size) - (x->size < y->size);
}

static int by_text(const void *a, const void *b) {
    const span *x = a, *y = b;
    const int order = compare_spans(a, b);
    return order ? order : (x->at > y->at) - (x->at < y->at);
}

/* ---- characters ---- */

static bool holds_characters(const char *text, size_t size) {
    for (size_t i = 0; i < size;) {
        uint32_t code;
        const int length = bat_utf8_decode(text + i, size - i, &code);
        if (length == 0 || code == 0xFFFE || code == 0xFFFF) return false;
        if (code < 0x20 && code != '\t' && code != '\n' && code != '\r') return false;
        i += (size_t)length;
    }
    return true;
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

static bool is_in_names(char c, bool first) {
    const unsigned char u = (unsigned char)c;
    if ((u >= 'a' && u <= 'z') || (u >= 'A' && u <= 'Z') || u == '_' || u == ':' || u >= 0x80) return true;
    return !first && ((u >= '0' && u <= '9') || u == '-' || u == '.');
}

static bool begins(const reading *r, const char *with) {
    const size_t length = strlen(with);
    return r->size - r->at >= length && memcmp(r->text + r->at, with, length) == 0;
}

static bool take(reading *r, const char *with) {
    if (!begins(r, with)) return false;
    r->at += strlen(with);
    return true;
}

static bool take_spaces(reading *r) {
    const size_t from = r->at;
    while (r->at < r->size && is_space(r->text[r->at])) r->at++;
    return r->at > from;
}

static bool take_name(reading *r, span *name) {
    const size_t from = r->at;
    while (r->at < r->size && is_in_names(r->text[r->at], r->at == from)) r->at++;
    *name = (span){r->text + from, r->at - from};
    return r->at > from;
}

/* Up to `end` and behind it. */
static bool take_until(reading *r, const char *end, span *passed) {
    const size_t from = r->at;
    for (; r->at < r->size; r->at++) {
        const char *next = memchr(r->text + r->at, end[0], r->size - r->at);
        if (!next) return false;
        r->at = (size_t)(next - r->text);
        *passed = (span){r->text + from, r->at - from};
        if (take(r, end)) return true;
    }
    return false;
}

static bool take_quoted(reading *r, span *value) {
    if (r->at >= r->size || (r->text[r->at] != '"' && r->text[r->at] != '\'')) return false;
    const char end[2] = {r->text[r->at++], '\0'};
    return take_until(r, end, value);
}

/* ---- references ---- */

static bool is_code(span digits) {
    const bool hexadecimal = digits.size > 0 && digits.at[0] == 'x';
    uint32_t code = 0;
    size_t i = hexadecimal;
    for (; i < digits.size && code <= 0x10FFFF; i++) {
        const char c = digits.at[i];
        const int digit = c >= '0' && c <= '9'                  ? c - '0'
                          : hexadecimal && c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : hexadecimal && c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                                : -1;
        if (digit < 0) return false;
        code = code * (hexadecimal ? 16 : 10) + (uint32_t)digit;
    }
    if (i == (size_t)hexadecimal || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return false;
    return code >= 0x20 ? code != 0xFFFE && code != 0xFFFF : code == '\t' || code == '\n' || code == '\r';
}

static bool is_known(const reading *r, span name) {
    static const char *const fixed[] = {"lt", "gt", "amp", "quot", "apos"};
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++)
        if (strlen(fixed[i]) == name.size && memcmp(fixed[i], name.at, name.size) == 0) return true;
    const size_t count = r->entities.size / sizeof(entity);
    const entity *found = count > 0 ? bsearch(&name, r->entities.data, count, sizeof(entity), compare_spans)
                                    : NULL;
    return found && found->value.at + found->value.size < name.at;
}

/* Whether each & begins a reference to a character or to an entity that is known. */
static bool are_references(const reading *r, span text) {
    const char *end = text.at + text.size;
    for (const char *at = text.at; (at = memchr(at, '&', (size_t)(end - at))) != NULL;) {
        const char *last = memchr(at, ';', (size_t)(end - at));
        if (!last) return false;
        const span name = {at + 1, (size_t)(last - at) - 1};
        if (name.size > 0 && name.at[0] == '#' ? !is_code((span){name.at + 1, name.size - 1})
                                               : !is_known(r, name))
            return false;
        at = last + 1;
    }
    return true;
}

/* ---- what may stand between elements ---- */

/* Behind "<!--". */
static bool take_comment(reading *r) {
    span passed;
    return take_until(r, "--", &passed) && take(r, ">");
}

/* Behind "<?". Only at the beginning of the text may it be called xml. */
static bool take_instruction(reading *r) {
    span name, passed;
    if (!take_name(r, &name)) return false;
    if (name.size == 3 && (name.at[0] | 32) == 'x' && (name.at[1] | 32) == 'm' && (name.at[2] | 32) == 'l')
        return false;
    return take(r, "?>") || (take_spaces(r) && take_until(r, "?>", &passed));
}

static bool take_pair(reading *r, const char *name, span *value) {
    const size_t from = r->at;
    const bool spaced = take_spaces(r);
    if (!take(r, name)) {
        r->at = from;
        *value = (span){NULL, 0};
        return true;
    }
    take_spaces(r);
    if (!spaced || !take(r, "=")) return false;
    take_spaces(r);
    return take_quoted(r, value) && value->size > 0;
}

/* The declaration that a text may begin with. */
static bool take_declaration(reading *r) {
    span version, encoding, alone;
    if (!begins(r, "<?xml") || r->size - r->at < 6 || is_in_names(r->text[r->at + 5], false)) return true;
    r->at += 5;
    if (!take_pair(r, "version", &version) || version.size < 3 || memcmp(version.at, "1.", 2) != 0)
        return false;
    if (!take_pair(r, "encoding", &encoding) || !take_pair(r, "standalone", &alone)) return false;
    for (size_t i = 0; i < encoding.size; i++)
        if (!is_in_names(encoding.at[i], i == 0) || encoding.at[i] == ':') return false;
    if (alone.at && !(alone.size == 3 && memcmp(alone.at, "yes", 3) == 0) &&
        !(alone.size == 2 && memcmp(alone.at, "no", 2) == 0))
        return false;
    take_spaces(r);
    return take(r, "?>");
}

/* ---- the document type ---- */

static bool take_external(reading *r) {
    span name;
    const bool open = take(r, "PUBLIC");
    if (!open && !take(r, "SYSTEM")) return false;
    if (open && (!take_spaces(r) || !take_quoted(r, &name))) return false;
    return take_spaces(r) && take_quoted(r, &name);
}

/* Behind "<!ENTITY". */
static bool take_entity(reading *r) {
    span name, value;
    if (!take_spaces(r)) return false;
    const bool parameter = take(r, "%");
    if ((parameter && !take_spaces(r)) || !take_name(r, &name) || !take_spaces(r)) return false;
    if (take_quoted(r, &value)) {
        const entity made = {name, value};
        const bool plain = !memchr(value.at, '<', value.size) && !memchr(value.at, '%', value.size);
        if (plain && !parameter) bat_text_add(&r->entities, (const char *)&made, sizeof made);
    } else {
        if (!take_external(r)) return false;
        const bool spaced = take_spaces(r);
        if (take(r, "NDATA") && (!spaced || parameter || !take_spaces(r) || !take_name(r, &name)))
            return false;
    }
    take_spaces(r);
    return take(r, ">");
}

/* Behind "<!ELEMENT" and the like: whatever it declares, quotes are closed, and nothing begins in it. */
static bool take_other_declaration(reading *r) {
    span name;
    if (!take_spaces(r) || !take_name(r, &name) || !take_spaces(r)) return false;
    while (r->at < r->size && r->text[r->at] != '>') {
        const char c = r->text[r->at];
        if (c == '<' || c == '&' || ((c == '"' || c == '\'') && !take_quoted(r, &name))) return false;
        if (c != '"' && c != '\'') r->at++;
    }
    return take(r, ">");
}

/* None of them refers to itself, however indirectly, since each may refer only to those before it. */
static bool sort_entities(reading *r) {
    const size_t count = r->entities.size / sizeof(entity);
    if (r->entities.failed) return false;
    if (count == 0) return true;
    const entity *list = (const void *)r->entities.data;
    qsort(r->entities.data, count, sizeof *list, by_text); /* no ties: places differ */
    for (size_t i = 0; i < count; i++)
        if (!are_references(r, list[i].value)) return false;
    return true;
}

static bool take_declarations(reading *r) {
    while (!take(r, "]")) {
        span name;
        const bool good = take_spaces(r)        ? true
                          : take(r, "<!--")     ? take_comment(r)
                          : take(r, "<?")       ? take_instruction(r)
                          : take(r, "<!ENTITY") ? take_entity(r)
                          : take(r, "<!ELEMENT") || take(r, "<!ATTLIST") || take(r, "<!NOTATION")
                              ? take_other_declaration(r)
                          : take(r, "%") ? take_name(r, &name) && take(r, ";")
                                         : false;
        if (!good) return false;
    }
    return sort_entities(r);
}

/* Behind "<!DOCTYPE". */
static bool take_type(reading *r) {
    span name;
    if (!take_spaces(r) || !take_name(r, &name)) return false;
    if (take_spaces(r) && (begins(r, "PUBLIC") || begins(r, "SYSTEM")) && !take_external(r)) return false;
    take_spaces(r);
    if (take(r, "[") && !take_declarations(r)) return false;
    take_spaces(r);
    return take(r, ">");
}

/* ---- elements ---- */

static bool are_different(bat_text *names) {
    const size_t count = count_of(names);
    if (count < 2) return true;
    span *list = spans_of(names);
    qsort(list, count, sizeof *list, by_text); /* no ties: places differ */
    for (size_t i = 1; i < count; i++)
        if (compare_spans(&list[i - 1], &list[i]) == 0) return false;
    return true;
}

/* Behind "<". */
static bool take_start(reading *r) {
    span name, value;
    r->names.size = 0;
    if (!take_name(r, &name)) return false;
    push(&r->open, name);
    while (take_spaces(r) && take_name(r, &name)) {
        take_spaces(r);
        if (!take(r, "=")) return false;
        take_spaces(r);
        if (!take_quoted(r, &value) || memchr(value.at, '<', value.size) || !are_references(r, value))
            return false;
        push(&r->names, name);
    }
    if (r->open.failed || r->names.failed || !are_different(&r->names)) return false;
    if (take(r, "/>"))
        r->open.size -= sizeof name;
    else if (!take(r, ">"))
        return false;
    return true;
}

/* Behind "</". */
static bool take_end(reading *r) {
    span name;
    if (!take_name(r, &name) || r->open.size == 0) return false;
    r->open.size -= sizeof name;
    if (compare_spans(&spans_of(&r->open)[count_of(&r->open)], &name) != 0) return false;
    take_spaces(r);
    return take(r, ">");
}

static bool take_text(reading *r) {
    const char *next = memchr(r->text + r->at, '<', r->size - r->at);
    const span text = {r->text + r->at, (next ? (size_t)(next - r->text) : r->size) - r->at};
    const char *end = text.at + text.size;
    for (const char *at = text.at; (at = memchr(at, ']', (size_t)(end - at))) != NULL; at++)
        if (end - at >= 3 && memcmp(at, "]]>", 3) == 0) return false;
    r->at += text.size;
    return are_references(r, text);
}

/* Of the root, which has begun. */
static bool take_content(reading *r) {
    span passed;
    while (r->open.size > 0) {
        const bool good = r->at >= r->size        ? false
                          : r->text[r->at] != '<' ? take_text(r)
                          : take(r, "<!--")       ? take_comment(r)
                          : take(r, "<![CDATA[")  ? take_until(r, "]]>", &passed)
                          : take(r, "<?")         ? take_instruction(r)
                          : take(r, "</")         ? take_end(r)
                                                  : take(r, "<") && take_start(r);
        if (!good) return false;
    }
    return true;
}

/* Comments and the like before or behind the root. */
static bool take_around(reading *r) {
    for (;;) {
        const bool good = take_spaces(r)    ? true
                          : take(r, "<!--") ? take_comment(r)
                          : take(r, "<?")   ? take_instruction(r)
                                            : false;
        if (!good) return r->at == r->size || r->text[r->at] == '<';
    }
}

static bool take_document(reading *r) {
    take(r, "\xEF\xBB\xBF");
    if (!take_declaration(r) || !take_around(r)) return false;
    if (take(r, "<!DOCTYPE") && !(take_type(r) && take_around(r))) return false;
    return take(r, "<") && take_start(r) && take_content(r) && take_around(r) && r->at == r->size;
}

bat_status bat_xml_check(const char *text, size_t size) {
    reading r = {.text = text, .size = size};
    const bool good = holds_characters(text, size) && take_document(&r);
    const bool failed = r.open.failed || r.names.failed || r.entities.failed;
    bat_text_free(&r.open);
    bat_text_free(&r.names);
    bat_text_free(&r.entities);
    return failed ? BAT_MEMORY : good ? BAT_OK : BAT_SYNTAX;
}
