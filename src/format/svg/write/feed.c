#include "format/svg/write/feed.h"

#include "format/svg/tags.h"
#include "text/entities.h"

#include <stdlib.h>
#include <string.h>

/* The document type, where entities may be declared. */
typedef struct types {
    const char *text;
    size_t size;
} types;

/* Collects name, value, name, value, ... each ended by a NUL. */
static bat_status feed_start(bat_svg_reader *reader, const char *tag, size_t size, types known,
                             bat_text *strings) {
    enum { MOST = 1 << 12 };
    size_t count = 0, at = 1 + bat_svg_tag_name(tag, size);
    bat_svg_piece piece;
    strings->size = 0;
    bat_text_add(strings, tag + 1, at - 1);
    bat_text_add(strings, "", 1);
    while (bat_svg_next_piece(tag, size, &at, &piece)) {
        if (++count > MOST) return BAT_COUNT;
        bat_text_add(strings, tag + piece.name, piece.equal - piece.name);
        bat_text_add(strings, "", 1);
        if (!bat_xml_decode(tag + piece.value, piece.end - piece.value, known.text, known.size, true,
                            strings))
            return BAT_UNSUPPORTED;
        bat_text_add(strings, "", 1);
    }
    const char **attributes = strings->failed ? NULL : malloc((2 * count + 1) * sizeof *attributes);
    if (!attributes) return BAT_MEMORY;
    const char *next = strings->data;
    for (size_t i = 0; i < 2 * count; i++) attributes[i] = next += strlen(next) + 1;
    attributes[2 * count] = NULL;
    const bat_status status = bat_svg_reader_start(reader, strings->data, attributes);
    free(attributes);
    return status;
}

static bat_status feed_text(bat_svg_reader *reader, const char *raw, size_t size, const types *known,
                            bat_text *strings) {
    strings->size = 0;
    if (!known) return bat_svg_reader_text(reader, raw, size);
    if (!bat_xml_decode(raw, size, known->text, known->size, false, strings)) return BAT_UNSUPPORTED;
    return strings->failed ? BAT_MEMORY
                           : bat_svg_reader_text(reader, strings->data ? strings->data : "", strings->size);
}

bat_status bat_svg_feed(const char *text, size_t size, bat_svg_reader *reader) {
    static const char cdata[] = "<![CDATA[";
    bat_text strings = {0};
    types known = {"", 0};
    bat_status status = BAT_OK;
    for (size_t at = 0, from = 0; status == BAT_OK && from < size; from = at) {
        const bat_svg_token token = bat_svg_next_token(text, size, &at);
        const char *found = text + from;
        const size_t length = at - from;
        if (token == BAT_SVG_LAST_TOKEN) status = BAT_SYNTAX;
        if (token == BAT_SVG_TYPE_TOKEN) known = (types){found, length};
        if (token == BAT_SVG_START_TOKEN || token == BAT_SVG_EMPTY_TOKEN)
            status = feed_start(reader, found, length, known, &strings);
        if (token == BAT_SVG_TEXT_TOKEN) status = feed_text(reader, found, length, &known, &strings);
        if (token == BAT_SVG_PLAIN_TOKEN && length >= sizeof cdata + 2)
            status = feed_text(reader, found + sizeof cdata - 1, length - sizeof cdata - 2, NULL, &strings);
        if (status == BAT_OK && (token == BAT_SVG_END_TOKEN || token == BAT_SVG_EMPTY_TOKEN))
            status = bat_svg_reader_end(reader);
    }
    bat_text_free(&strings);
    return status;
}
