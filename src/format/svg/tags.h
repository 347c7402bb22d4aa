/* Where the elements of an XML file stand in its text. The text has been parsed before by a real parser, which found it
 * well formed; here only places are looked for, so that the text can be changed at one place and nowhere else. */
#ifndef BATTEN_FORMAT_SVG_TAGS_H
#define BATTEN_FORMAT_SVG_TAGS_H

#include "text/text.h"

#include <batten/format.h>

typedef enum bat_svg_token {
    BAT_SVG_TEXT_TOKEN,
    BAT_SVG_PLAIN_TOKEN, /* CDATA: text without entities */
    BAT_SVG_START_TOKEN,
    BAT_SVG_EMPTY_TOKEN, /* starts and ends an element */
    BAT_SVG_END_TOKEN,
    BAT_SVG_TYPE_TOKEN,  /* the document type */
    BAT_SVG_OTHER_TOKEN, /* comments, instructions */
    BAT_SVG_LAST_TOKEN   /* the end of the text, or something that is not well formed */
} bat_svg_token;

/* The token that begins at *at, which moves behind it. */
bat_svg_token bat_svg_next_token(const char *text, size_t size, size_t *at);

/* Offsets in the text. An element without contents and end tag has body, close and end at the same place. */
typedef struct bat_svg_tag {
    size_t open;  /* of the start tag's '<' */
    size_t body;  /* behind the start tag */
    size_t close; /* of the end tag's '<' */
    size_t end;   /* behind the end tag */
    uint32_t parent;
    uint32_t last; /* the number of its last descendant, or its own */
} bat_svg_tag;

typedef struct bat_svg_tags {
    bat_svg_tag *list; /* element i at list[i], from 1 */
    uint32_t count;    /* of elements, plus 1 */
} bat_svg_tags;

/* BAT_SYNTAX: tags do not match. O(size). */
bat_status bat_svg_tags_scan(const char *text, size_t size, bat_svg_tags *out);
void bat_svg_tags_free(bat_svg_tags *tags);

/* An attribute of a start tag: offsets in it. */
typedef struct bat_svg_piece {
    size_t lead;        /* of the space before the name */
    size_t name, equal; /* of the name, and behind it */
    size_t value, end;  /* of the value within its quotes, and of the closing quote */
} bat_svg_piece;
/* The attribute at or after *at in a tag that begins at its '<'; false: there are no more, and *at is where they end. */
bool bat_svg_next_piece(const char *tag, size_t size, size_t *at, bat_svg_piece *piece);
/* Length of the tag's name, which begins at tag + 1. */
size_t bat_svg_tag_name(const char *tag, size_t size);
/* Its name without a prefix; *length: of that. */
const char *bat_svg_tag_local(const char *tag, size_t size, size_t *length);

#endif
