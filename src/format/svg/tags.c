#include "format/svg/tags.h"

#include "format/svg/tree.h"

#include <stdlib.h>
#include <string.h>

/* Behind the next occurrence of `mark`, or the end of the text. */
static size_t behind(const char *text, size_t size, size_t at, const char *mark) {
    const size_t length = strlen(mark);
    for (; at + length <= size; at++) {
        const char *found = memchr(text + at, mark[0], size - length - at + 1);
        if (!found) return size;
        at = (size_t)(found - text);
        if (memcmp(found, mark, length) == 0) return at + length;
    }
    return size;
}

static bool begins(const char *text, size_t size, size_t at, const char *with) {
    const size_t length = strlen(with);
    return size - at >= length && memcmp(text + at, with, length) == 0;
}

/* Behind the '>' that ends a tag; '>' may stand in quotes. */
static size_t behind_tag(const char *text, size_t size, size_t at) {
    char quote = 0;
    for (; at < size; at++) {
        const char c = text[at];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            return at + 1;
    }
    return size;
}

/* Behind a document type with its declarations in brackets. */
static size_t behind_type(const char *text, size_t size, size_t at) {
    int depth = 0;
    char quote = 0;
    while (at < size) {
        const char c = text[at];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (begins(text, size, at, "<!--")) {
            at = behind(text, size, at, "-->");
            continue;
        } else if (begins(text, size, at, "<?")) {
            at = behind(text, size, at, "?>");
            continue;
        } else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '<' || c == '[')
            depth++;
        else if (c == ']')
            depth--;
        else if (c == '>' && --depth == 0)
            return at + 1;
        at++;
    }
    return size;
}

bat_svg_token bat_svg_next_token(const char *text, size_t size, size_t *at) {
    const size_t from = *at;
    if (from >= size) return BAT_SVG_LAST_TOKEN;
    if (text[from] != '<') {
        const char *next = memchr(text + from, '<', size - from);
        *at = next ? (size_t)(next - text) : size;
        return BAT_SVG_TEXT_TOKEN;
    }
    static const struct {
        const char *begin, *end;
        bat_svg_token token;
    } marks[] = {{"<!--", "-->", BAT_SVG_OTHER_TOKEN},
                 {"<![CDATA[", "]]>", BAT_SVG_PLAIN_TOKEN},
                 {"<?", "?>", BAT_SVG_OTHER_TOKEN}};
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (begins(text, size, from, marks[i].begin)) {
            *at = behind(text, size, from + strlen(marks[i].begin), marks[i].end);
            return marks[i].token;
        }
    if (begins(text, size, from, "<!")) {
        *at = behind_type(text, size, from);
        return BAT_SVG_TYPE_TOKEN;
    }
    *at = behind_tag(text, size, from + 1);
    if (text[*at - 1] != '>') return BAT_SVG_LAST_TOKEN;
    if (begins(text, size, from, "</")) return BAT_SVG_END_TOKEN;
    return text[*at - 2] == '/' ? BAT_SVG_EMPTY_TOKEN : BAT_SVG_START_TOKEN;
}

static bat_status add_tag(bat_svg_tags *tags, uint32_t *room, bat_svg_tag made) {
    if (tags->count >= BAT_SVG_ELEMENTS_MAX) return BAT_COUNT;
    if (tags->count == *room) {
        *room *= 2;
        bat_svg_tag *grown = realloc(tags->list, *room * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        tags->list = grown;
    }
    tags->list[tags->count++] = made;
    return BAT_OK;
}

static bat_status scan(const char *text, size_t size, bat_svg_tags *tags, uint32_t room) {
    uint32_t open = 0; /* the innermost element not yet ended */
    bat_status status = BAT_OK;
    for (size_t at = 0, from = 0; status == BAT_OK; from = at) {
        const bat_svg_token token = bat_svg_next_token(text, size, &at);
        if (token == BAT_SVG_LAST_TOKEN) return from == size && open == 0 ? BAT_OK : BAT_SYNTAX;
        if (token == BAT_SVG_START_TOKEN || token == BAT_SVG_EMPTY_TOKEN) {
            const bat_svg_tag made = {from, at, at, at, open, tags->count};
            status = add_tag(tags, &room, made);
            if (token == BAT_SVG_START_TOKEN) open = tags->count - 1;
        }
        if (token == BAT_SVG_END_TOKEN) {
            if (open == 0) return BAT_SYNTAX;
            bat_svg_tag *ended = &tags->list[open];
            ended->close = from;
            ended->end = at;
            ended->last = tags->count - 1;
            open = ended->parent;
        }
    }
    return status;
}

bat_status bat_svg_tags_scan(const char *text, size_t size, bat_svg_tags *out) {
    enum { FIRST = 256 };
    bat_svg_tags tags = {calloc(FIRST, sizeof *tags.list), 1};
    bat_status status = tags.list ? scan(text, size, &tags, FIRST) : BAT_MEMORY;
    if (status != BAT_OK)
        bat_svg_tags_free(&tags);
    else
        *out = tags;
    return status;
}

void bat_svg_tags_free(bat_svg_tags *tags) {
    free(tags->list);
    *tags = (bat_svg_tags){0};
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

size_t bat_svg_tag_name(const char *tag, size_t size) {
    size_t at = 1;
    while (at < size && !is_space(tag[at]) && tag[at] != '/' && tag[at] != '>') at++;
    return at - 1;
}

const char *bat_svg_tag_local(const char *tag, size_t size, size_t *length) {
    const size_t whole = bat_svg_tag_name(tag, size);
    const char *colon = memchr(tag + 1, ':', whole), *name = colon ? colon + 1 : tag + 1;
    *length = whole - (size_t)(name - (tag + 1));
    return name;
}

bool bat_svg_next_piece(const char *tag, size_t size, size_t *at, bat_svg_piece *piece) {
    bat_svg_piece found = {.lead = *at};
    size_t i = *at;
    while (i < size && is_space(tag[i])) i++;
    if (i >= size || tag[i] == '>' || tag[i] == '/') return false;
    found.name = i;
    while (i < size && !is_space(tag[i]) && tag[i] != '=') i++;
    found.equal = i;
    while (i < size && tag[i] != '"' && tag[i] != '\'') i++;
    if (i >= size) return false;
    const char *end = memchr(tag + i + 1, tag[i], size - i - 1);
    if (!end) return false;
    found.value = i + 1;
    found.end = (size_t)(end - tag);
    *at = found.end + 1;
    *piece = found;
    return true;
}
