#include "text/json.h"

#include "text/utf8.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct reader {
    bat_json *json;
    const char *at, *end;
    size_t strings; /* bytes of json->strings in use */
    bat_problem *problem;
} reader;

static void place_of(const bat_json *json, size_t position, char *place, size_t room) {
    unsigned long line = 1, column = 1;
    for (size_t i = 0; i < position && i < json->size; i++) {
        column++;
        if (json->text[i] == '\n') line++, column = 1;
    }
    snprintf(place, room, "line %lu, column %lu", line, column);
}

static bat_status fail(reader *r, bat_status status, const char *expected) {
    if (r->problem) {
        place_of(r->json, (size_t)(r->at - r->json->text), r->problem->place, sizeof r->problem->place);
        char found[24] = "the end";
        if (r->at < r->end) {
            unsigned char c = (unsigned char)*r->at;
            snprintf(found, sizeof found, c > ' ' && c < 127 ? "'%c'" : "byte 0x%02x", c);
        }
        snprintf(r->problem->message, sizeof r->problem->message, "expected %s, found %s", expected, found);
    }
    return status;
}

static void skip_space(reader *r) {
    while (r->at < r->end && (*r->at == ' ' || *r->at == '\n' || *r->at == '\r' || *r->at == '\t')) r->at++;
}

static bat_status add_node(reader *r, bat_json_type type, uint32_t *out) {
    bat_json *json = r->json;
    if (json->count == json->room) {
        uint32_t room = json->room < 64 ? 64 : json->room + json->room / 2;
        /* size_t has 32 bits in WASM. */
        size_t size = (size_t)room * sizeof *json->nodes;
        bat_json_node *nodes = size / sizeof *nodes == room ? realloc(json->nodes, size) : NULL;
        if (!nodes) return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
        json->nodes = nodes;
        json->room = room;
    }
    json->nodes[json->count] = (bat_json_node){.type = (uint8_t)type,
                                               .position = (uint32_t)(r->at - json->text)};
    *out = json->count++;
    return BAT_OK;
}

static bool read_hex(reader *r, uint32_t *code) {
    if (r->end - r->at < 4) return false;
    *code = 0;
    for (int i = 0; i < 4; i++, r->at++) {
        char c = *r->at;
        int digit = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
        if (digit < 0) return false;
        *code = *code << 4 | (uint32_t)digit;
    }
    return true;
}

/* Called just after the backslash. */
static bat_status read_escape(reader *r, uint32_t *code) {
    static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
    const char *known = r->at < r->end && *r->at ? strchr(from, *r->at) : NULL;
    if (known) {
        *code = (uint32_t)to[known - from];
        r->at++;
        return BAT_OK;
    }
    if (r->at == r->end || *r->at != 'u') return fail(r, BAT_SYNTAX, "an escape such as \\n or \\u0041");
    r->at++;
    if (!read_hex(r, code)) return fail(r, BAT_SYNTAX, "four hexadecimal digits");
    if (*code >= 0xd800 && *code < 0xdc00) {
        uint32_t low = 0;
        if (r->end - r->at < 6 || r->at[0] != '\\' || r->at[1] != 'u')
            return fail(r, BAT_SYNTAX, "the second surrogate");
        r->at += 2;
        if (!read_hex(r, &low) || low < 0xdc00 || low > 0xdfff)
            return fail(r, BAT_SYNTAX, "the second surrogate");
        *code = 0x10000 + ((*code - 0xd800) << 10) + (low - 0xdc00);
    } else if (*code >= 0xdc00 && *code <= 0xdfff)
        return fail(r, BAT_SYNTAX, "a first surrogate before a second");
    if (*code == 0) return fail(r, BAT_SYNTAX, "a text without U+0000");
    return BAT_OK;
}

/* Called at the opening quote. Decoded text is never longer than its source, so json->strings has room. */
static bat_status read_text(reader *r, uint32_t *out) {
    bat_status status = add_node(r, BAT_JSON_TEXT, out);
    if (status != BAT_OK) return status;
    size_t start = r->strings;
    char *to = r->json->strings;
    for (r->at++;;) {
        if (r->at == r->end) return fail(r, BAT_SYNTAX, "a closing quote");
        if (*r->at == '"') break;
        uint32_t code;
        if (*r->at == '\\') {
            r->at++;
            status = read_escape(r, &code);
            if (status != BAT_OK) return status;
            r->strings += (size_t)bat_utf8_encode(code, to + r->strings);
            continue;
        }
        if ((unsigned char)*r->at < 0x20) return fail(r, BAT_SYNTAX, "an escape for a control character");
        int length = bat_utf8_decode(r->at, (size_t)(r->end - r->at), &code);
        if (length == 0) return fail(r, BAT_SYNTAX, "UTF-8");
        memcpy(to + r->strings, r->at, (size_t)length);
        r->strings += (size_t)length;
        r->at += length;
    }
    r->at++;
    bat_json_node *node = &r->json->nodes[*out];
    node->value.text.at = (uint32_t)start;
    node->value.text.size = (uint32_t)(r->strings - start);
    to[r->strings++] = '\0';
    return BAT_OK;
}

static bool is_digit(const reader *r, const char *at) { return at < r->end && *at >= '0' && *at <= '9'; }

/* JSON is stricter than bat_number_scan: no plus sign, no leading zeros, and digits on both sides of the
 * point. */
static bat_status skip_number(reader *r) {
    const char *at = r->at;
    if (at < r->end && *at == '-') at++;
    if (!is_digit(r, at)) return fail(r, BAT_SYNTAX, "a value");
    bool zero = *at == '0';
    at++;
    if (zero && is_digit(r, at)) return fail(r, BAT_SYNTAX, "a number without leading zeros");
    while (is_digit(r, at)) at++;
    if (at < r->end && *at == '.') {
        r->at = ++at;
        if (!is_digit(r, at)) return fail(r, BAT_SYNTAX, "digits after the point");
        while (is_digit(r, at)) at++;
    }
    if (at < r->end && (*at == 'e' || *at == 'E')) {
        at++;
        if (at < r->end && (*at == '+' || *at == '-')) at++;
        r->at = at;
        if (!is_digit(r, at)) return fail(r, BAT_SYNTAX, "digits of the exponent");
        while (is_digit(r, at)) at++;
    }
    r->at = at;
    return BAT_OK;
}

static bat_status read_number_node(reader *r, uint32_t *out) {
    const char *start = r->at;
    bat_status status = skip_number(r);
    if (status != BAT_OK) return status;
    const char *end = r->at;
    double value = 0;
    r->at = start;
    bat_number_scan(start, end, &value);
    if (!isfinite(value)) return fail(r, BAT_NUMBER, "a number that a double can hold");
    status = add_node(r, BAT_JSON_NUMBER, out);
    if (status != BAT_OK) return status;
    r->json->nodes[*out].value.number = value;
    r->at = end;
    return BAT_OK;
}

static bat_status read_value(reader *r, int depth, uint32_t *out);

/* Appends to the list from *first to *last; both are 0 while it is empty. */
static void put_last(reader *r, uint32_t node, uint32_t *first, uint32_t *last) {
    if (*last)
        r->json->nodes[*last].next = node;
    else
        *first = node;
    *last = node;
}

/* Called at the opening bracket; reads items, or (members) names and values. */
static bat_status read_list(reader *r, int depth, bool members, uint32_t *out) {
    if (depth >= BAT_JSON_DEPTH) return fail(r, BAT_COUNT, "at most 64 levels of nesting");
    bat_status status = add_node(r, members ? BAT_JSON_OBJECT : BAT_JSON_LIST, out);
    if (status != BAT_OK) return status;
    char close = members ? '}' : ']';
    uint32_t count = 0, first = 0, last = 0;
    r->at++;
    skip_space(r);
    if (r->at < r->end && *r->at == close) {
        r->at++;
        return BAT_OK;
    }
    for (;;) {
        uint32_t node = 0;
        skip_space(r);
        if (members) {
            if (r->at == r->end || *r->at != '"') return fail(r, BAT_SYNTAX, "a member's name in quotes");
            status = read_text(r, &node);
            if (status != BAT_OK) return status;
            put_last(r, node, &first, &last);
            skip_space(r);
            if (r->at == r->end || *r->at != ':') return fail(r, BAT_SYNTAX, "a colon");
            r->at++;
        }
        status = read_value(r, depth + 1, &node);
        if (status != BAT_OK) return status;
        put_last(r, node, &first, &last);
        count++;
        skip_space(r);
        if (r->at < r->end && *r->at == ',') {
            r->at++;
            continue;
        }
        if (r->at == r->end || *r->at != close)
            return fail(r, BAT_SYNTAX, members ? "a comma or }" : "a comma or ]");
        r->at++;
        break;
    }
    r->json->nodes[*out].value.list.first = first;
    r->json->nodes[*out].value.list.count = count;
    return BAT_OK;
}

static bat_status read_word(reader *r, const char *word, bat_json_type type, uint32_t *out) {
    size_t length = strlen(word);
    if ((size_t)(r->end - r->at) < length || memcmp(r->at, word, length) != 0)
        return fail(r, BAT_SYNTAX, "a value");
    bat_status status = add_node(r, type, out);
    r->at += length;
    return status;
}

static bat_status read_value(reader *r, int depth, uint32_t *out) {
    skip_space(r);
    switch (r->at < r->end ? *r->at : '\0') {
    case '{': return read_list(r, depth, true, out);
    case '[': return read_list(r, depth, false, out);
    case '"': return read_text(r, out);
    case 't': return read_word(r, "true", BAT_JSON_TRUE, out);
    case 'f': return read_word(r, "false", BAT_JSON_FALSE, out);
    case 'n': return read_word(r, "null", BAT_JSON_NULL, out);
    default: return read_number_node(r, out);
    }
}

static bat_status parse(reader *r) {
    uint32_t node;
    if (r->json->size > BAT_JSON_SIZE) return fail(r, BAT_COUNT, "at most 256 MB of text");
    r->json->strings = malloc(r->json->size + 1);
    if (!r->json->strings) return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    bat_status status = add_node(r, BAT_JSON_NULL, &node); /* node 0 */
    if (status == BAT_OK) status = read_value(r, 0, &node);
    if (status != BAT_OK) return status;
    skip_space(r);
    return r->at == r->end ? BAT_OK : fail(r, BAT_SYNTAX, "nothing more");
}

bat_status bat_json_parse(const char *text, size_t size, bat_json *out, bat_problem *problem) {
    bat_json json = {.text = text, .size = size};
    /* A byte order mark is not JSON, but some editors write one. */
    size_t start = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    reader r = {.json = &json, .at = text + start, .end = text + size, .problem = problem};
    bat_status status = parse(&r);
    if (status != BAT_OK)
        bat_json_free(&json);
    else
        *out = json;
    return status;
}

void bat_json_free(bat_json *json) {
    free(json->nodes);
    free(json->strings);
    json->nodes = NULL;
    json->strings = NULL;
}

bat_json_type bat_json_type_of(const bat_json *json, uint32_t node) {
    return (bat_json_type)json->nodes[node].type;
}

uint32_t bat_json_member(const bat_json *json, uint32_t object, const char *name) {
    uint32_t found = 0;
    if (bat_json_type_of(json, object) != BAT_JSON_OBJECT) return 0;
    for (uint32_t at = json->nodes[object].value.list.first; at; at = json->nodes[at].next) {
        uint32_t value = json->nodes[at].next;
        if (strcmp(json->strings + json->nodes[at].value.text.at, name) == 0) found = value;
        at = value;
    }
    return found;
}

uint32_t bat_json_first(const bat_json *json, uint32_t list) {
    return bat_json_type_of(json, list) == BAT_JSON_LIST ? json->nodes[list].value.list.first : 0;
}

uint32_t bat_json_count(const bat_json *json, uint32_t list) {
    return bat_json_type_of(json, list) == BAT_JSON_LIST ? json->nodes[list].value.list.count : 0;
}

const char *bat_json_text(const bat_json *json, uint32_t node) {
    return bat_json_type_of(json, node) == BAT_JSON_TEXT ? json->strings + json->nodes[node].value.text.at
                                                         : NULL;
}

bat_status bat_json_say(const bat_json *json, uint32_t node, bat_status status, const char *message,
                        bat_problem *problem) {
    bat_problem_set(problem, status, "", message);
    if (problem) place_of(json, json->nodes[node].position, problem->place, sizeof problem->place);
    return status;
}

static bool is_within(const bat_json *json, uint32_t whole, uint32_t node) {
    if (whole == node) return true;
    if (json->nodes[whole].type != BAT_JSON_LIST && json->nodes[whole].type != BAT_JSON_OBJECT) return false;
    for (uint32_t i = json->nodes[whole].value.list.count ? json->nodes[whole].value.list.first : 0; i;
         i = json->nodes[i].next)
        if (is_within(json, i, node)) return true;
    return false;
}

/* Whether the node is an object without such a member, and not in a member of that name itself. O(size), for what has gone
 * wrong. */
static bool lacks(const bat_json *json, uint32_t node, const char *what) {
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT || strpbrk(what, " ,.[")) return false;
    for (uint32_t i = 1; i < json->count; i++) {
        const bat_json_node *name = &json->nodes[i];
        if (name->type == BAT_JSON_TEXT && name->next && strcmp(bat_json_text(json, i), what) == 0 &&
            is_within(json, name->next, node))
            return false;
    }
    return bat_json_member(json, node, what) == 0;
}

bat_status bat_json_complain(const bat_json *json, uint32_t node, bat_status status, const char *what,
                             const char *expected, bat_problem *problem) {
    static const char *const names[] = {"null", "false", "true", "number ", "text", "a list", "an object"};
    char number[BAT_NUMBER_ROOM] = "", message[160];
    if (bat_json_type_of(json, node) == BAT_JSON_NUMBER)
        bat_number_print(json->nodes[node].value.number, number);
    snprintf(message, sizeof message, "%s: expected %s, found %s%s", what, expected,
             node && !lacks(json, node, what) ? names[json->nodes[node].type] : "none", number);
    return bat_json_say(json, node, status, message, problem);
}
