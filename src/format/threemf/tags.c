#include "format/threemf/tags.h"

#include "text/number.h"

#include <math.h>
#include <string.h>

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

static bool begins(const char *at, const char *end, const char *with) {
    const size_t size = strlen(with);
    return (size_t)(end - at) >= size && memcmp(at, with, size) == 0;
}

/* Behind the next occurrence of a short word; the end when there is none. */
static const char *behind(const char *at, const char *end, const char *word) {
    const size_t size = strlen(word);
    for (; (size_t)(end - at) >= size; at++)
        if (memcmp(at, word, size) == 0) return at + size;
    return end;
}

/* Splits a name where its colon is. */
static void split(const char *at, const char *end, bat_tag *out) {
    const char *colon = memchr(at, ':', (size_t)(end - at));
    out->prefix = at, out->prefix_size = colon ? (size_t)(colon - at) : 0;
    out->name = colon ? colon + 1 : at;
    out->name_size = (size_t)(end - out->name);
}

static const char *name_end(const char *at, const char *end) {
    while (at < end && !is_blank(*at) && *at != '/' && *at != '>' && *at != '=') at++;
    return at;
}

/* From behind "<". */
static const char *read_tag(const char *at, const char *end, bat_tag *out) {
    char quote = 0;
    *out = (bat_tag){.opens = at < end && *at != '/', .closes = at < end && *at == '/'};
    at += out->closes;
    const char *stop = name_end(at, end);
    split(at, stop, out);
    out->at = at = stop;
    for (; at < end && (quote || *at != '>'); at++)
        if (quote ? *at == quote : *at == '"' || *at == '\'') quote = quote ? 0 : *at;
    out->end = at;
    if (out->end > out->at && out->end[-1] == '/') out->end--, out->closes = true;
    return at < end ? at + 1 : end;
}

bool bat_tags_next(bat_tags *tags, bat_tag *out) {
    while (tags->at < tags->end) {
        const char *at = memchr(tags->at, '<', (size_t)(tags->end - tags->at));
        if (!at) break;
        if (begins(at, tags->end, "<!--"))
            tags->at = behind(at + 4, tags->end, "-->");
        else if (begins(at, tags->end, "<![CDATA["))
            tags->at = behind(at, tags->end, "]]>");
        else if (begins(at, tags->end, "<?"))
            tags->at = behind(at, tags->end, "?>");
        else {
            tags->at = read_tag(at + 1, tags->end, out);
            return true;
        }
    }
    tags->at = tags->end;
    return false;
}

bool bat_tag_is(const bat_tag *tag, const char *name) {
    return strlen(name) == tag->name_size && memcmp(name, tag->name, tag->name_size) == 0;
}

bool bat_tag_find(const bat_tag *tag, const char *name, const char **value, size_t *size) {
    const char *at = tag->at;
    while (at < tag->end) {
        bat_tag attribute;
        while (at < tag->end && is_blank(*at)) at++;
        const char *stop = name_end(at, tag->end);
        split(at, stop, &attribute);
        for (at = stop; at < tag->end && *at != '"' && *at != '\'';) at++;
        if (at == tag->end) return false;
        const char *last = memchr(at + 1, *at, (size_t)(tag->end - at - 1));
        if (!last) return false;
        if (bat_tag_is(&attribute, name)) {
            *value = at + 1, *size = (size_t)(last - at - 1);
            return true;
        }
        at = last + 1;
    }
    return false;
}

bool bat_tag_numbers(const bat_tag *tag, const char *name, int count, double *out) {
    const char *at;
    size_t size;
    if (!bat_tag_find(tag, name, &at, &size)) return false;
    const char *end = at + size;
    for (int k = 0; k <= count; k++) {
        while (at < end && is_blank(*at)) at++;
        if (k == count) break;
        at = at < end ? bat_number_scan(at, end, &out[k]) : NULL;
        if (!at || (at < end && !is_blank(*at))) return false;
    }
    return at == end;
}

bool bat_tag_whole(const bat_tag *tag, const char *name, uint32_t most, uint32_t *out) {
    double value;
    if (!bat_tag_numbers(tag, name, 1, &value) ||
        !(value >= 0 && value <= (double)most && value == floor(value)))
        return false;
    *out = (uint32_t)value;
    return true;
}
