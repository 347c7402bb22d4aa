#include "text/entities.h"

#include <stdlib.h>
#include <string.h>

enum { ENTITY_DEPTH = 4 };

/* The text that <!ENTITY name "..."> gives; NULL: not declared. */
static const char *declared(const char *types, size_t size, const char *name, size_t length,
                            size_t *value_size) {
    static const char mark[] = "<!ENTITY";
    const size_t marked = sizeof mark - 1;
    for (size_t at = 0; at + marked < size; at++) {
        if (memcmp(types + at, mark, marked) != 0) continue;
        size_t i = at + marked + strspn(types + at + marked, " \t\r\n");
        if (i >= size || size - i < length || memcmp(types + i, name, length) != 0) continue;
        i += length;
        const size_t gap = strspn(types + i, " \t\r\n");
        const char quote = i + gap < size ? types[i + gap] : '\0';
        if (gap == 0 || (quote != '"' && quote != '\'')) continue;
        const char *value = types + i + gap + 1, *end = memchr(value, quote, size - (size_t)(value - types));
        if (!end) return NULL;
        *value_size = (size_t)(end - value);
        return value;
    }
    return NULL;
}

static bool add_character(unsigned long code, bat_text *out) {
    char bytes[4];
    size_t size = 0;
    if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return false;
    if (code < 0x80)
        bytes[size++] = (char)code;
    else {
        const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
        static const unsigned char first[4] = {0, 0xC0, 0xE0, 0xF0};
        bytes[size++] = (char)(first[more] | (code >> (6 * more)));
        for (int i = more - 1; i >= 0; i--) bytes[size++] = (char)(0x80 | ((code >> (6 * i)) & 0x3F));
    }
    bat_text_add(out, bytes, size);
    return true;
}

typedef struct types {
    const char *text;
    size_t size;
} types;

static bool decode(const char *raw, size_t size, types known, bool attribute, int depth, bat_text *out);

/* name: without & and ; */
static bool add_entity(const char *name, size_t length, types known, bool attribute, int depth,
                       bat_text *out) {
    static const struct {
        const char *name, *text;
    } fixed[] = {{"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}};
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++)
        if (strlen(fixed[i].name) == length && memcmp(fixed[i].name, name, length) == 0) {
            bat_text_string(out, fixed[i].text);
            return true;
        }
    if (length > 1 && length < 12 && name[0] == '#') {
        char digits[12] = "";
        const bool hexadecimal = name[1] == 'x';
        memcpy(digits, name + 1 + hexadecimal, length - 1 - hexadecimal);
        char *end;
        const unsigned long code = strtoul(digits, &end, hexadecimal ? 16 : 10);
        return digits[0] && *end == '\0' && add_character(code, out);
    }
    size_t value_size = 0;
    const char *value = depth < ENTITY_DEPTH ? declared(known.text, known.size, name, length, &value_size)
                                             : NULL;
    return value && !memchr(value, '<', value_size) &&
           decode(value, value_size, known, attribute, depth + 1, out);
}

static bool decode(const char *raw, size_t size, types known, bool attribute, int depth, bat_text *out) {
    for (size_t at = 0; at < size;) {
        size_t plain = at;
        while (plain < size && raw[plain] != '&' && raw[plain] != '\r' &&
               !(attribute && (raw[plain] == '\n' || raw[plain] == '\t')))
            plain++;
        bat_text_add(out, raw + at, plain - at);
        at = plain;
        if (at == size) break;
        if (raw[at] != '&') { /* line ends are one character, and spaces in an attribute */
            at += raw[at] == '\r' && at + 1 < size && raw[at + 1] == '\n' ? 2 : 1;
            bat_text_string(out, attribute ? " " : "\n");
            continue;
        }
        const char *end = memchr(raw + at, ';', size - at);
        if (!end || !add_entity(raw + at + 1, (size_t)(end - raw) - at - 1, known, attribute, depth, out))
            return false;
        at = (size_t)(end - raw) + 1;
    }
    return true;
}

bool bat_xml_decode(const char *raw, size_t size, const char *declarations, size_t declarations_size,
                    bool attribute, bat_text *out) {
    return decode(raw, size, (types){declarations ? declarations : "", declarations_size}, attribute, 0, out);
}
