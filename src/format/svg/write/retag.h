/* A start tag written again with some of its attributes changed, and the rest as it was, character by character. */
#ifndef BATTEN_FORMAT_SVG_WRITE_RETAG_H
#define BATTEN_FORMAT_SVG_WRITE_RETAG_H

#include "format/svg/tags.h"

enum { BAT_SVG_CHANGES = 40 };

typedef struct bat_svg_change {
    const char *name; /* of an attribute; static */
    size_t at, size;  /* of its value in `values`, not escaped */
    bool gone, raw;   /* it goes; its value stands as it is in the text */
} bat_svg_change;

/* Begin with bat_svg_retag_begin, and end with bat_svg_retag_free. */
typedef struct bat_svg_retag {
    const char *tag; /* borrowed, from its '<' to behind its '>' */
    size_t size;
    bool sheets;        /* the file has style sheets, which only a style attribute overrules */
    const char *rename; /* the element's new name without prefix; NULL: as it was */
    bool (*drops)(const char *name, size_t size); /* which of the old attributes go; NULL: none */
    bat_svg_change changes[BAT_SVG_CHANGES];
    int count;
    bat_text values;
    bat_text style;        /* the style attribute, decoded */
    bool styled, restyled; /* there is one; it has changed */
    bool insists;          /* what is set overrules all that sheets say */
    bool failed;
} bat_svg_retag;

/* types: the document type of the file, or NULL. */
void bat_svg_retag_begin(bat_svg_retag *r, const char *tag, size_t size, const char *types, size_t types_size,
                         bool sheets);
void bat_svg_retag_free(bat_svg_retag *r);
bool bat_svg_retag_has(const bat_svg_retag *r, const char *name, bat_svg_piece *piece);
void bat_svg_retag_set(bat_svg_retag *r, const char *name, const char *value); /* NULL: goes */
/* value: markup without quotes, that stands as it is in the text. */
void bat_svg_retag_set_raw(bat_svg_retag *r, const char *name, const char *value);
/* Sets a property of style where the element has it: in its style attribute, or by itself. */
void bat_svg_retag_style(bat_svg_retag *r, const char *property, const char *value);
/* Sets a property in its style attribute, where only sheets that say !important overrule it, and not even those if it insists. */
void bat_svg_retag_declare(bat_svg_retag *r, const char *property, const char *value, bool insists);
/* Whether its style attribute says what the property is: then sheets do not, unless it insists. */
bool bat_svg_retag_declares(const bat_svg_retag *r, const char *property);
/* Whether the element itself says what the property is. */
bool bat_svg_retag_says(const bat_svg_retag *r, const char *property);
/* Whether the element is a picture of an SVG file that stands alone, and not the one that is in that file. */
bool bat_svg_is_written_alone(const bat_svg_retag *r);
/* Or out of memory: writing says so. */
bool bat_svg_retag_changed(const bat_svg_retag *r);
void bat_svg_retag_write(bat_svg_retag *r, bat_text *out);

#endif
