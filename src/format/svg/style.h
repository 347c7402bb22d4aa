/* Style of SVG elements: presentation attributes, style="", and style sheets of simple selectors. */
#ifndef BATTEN_FORMAT_SVG_STYLE_H
#define BATTEN_FORMAT_SVG_STYLE_H

#include "format/svg/names.h"

#include <batten/document.h>

typedef struct bat_svg_paint {
    enum { BAT_PAINT_NONE, BAT_PAINT_COLOUR, BAT_PAINT_CURRENT } kind;
    uint32_t colour;
    const char *server; /* what stood in url(), where it was read; NULL: nothing. kind is its fallback */
    bool bare;          /* ... and it had none */
} bat_svg_paint;

typedef struct bat_svg_style {
    /* handed down */
    uint32_t colour; /* currentColor */
    bat_svg_paint fill, stroke;
    double fill_opacity, stroke_opacity;
    double width; /* user units */
    double miter_limit;
    bat_cap cap;
    bat_join join;
    bool even_odd, visible;
    uint32_t odd; /* BAT_SVG_BIT of the odd properties that are set; some are handed down */
    /* of the element alone */
    double opacity;
    bool shown;
    bat_svg_paint stop; /* of a gradient */
    double stop_opacity;
} bat_svg_style;

bool bat_svg_colour(const char *text, uint32_t *colour); /* 0xRRGGBBAA */

/* What SVG begins with. */
bat_svg_style bat_svg_style_initial(void);
/* The style that a child of an element with this style begins with. */
bat_svg_style bat_svg_style_child(const bat_svg_style *parent);
/* One property; what is no property, and values that do not parse, change nothing, and it is false. diagonal: what
 * stroke-width's % refer to. source: where the value stands and stays; it may go on there. */
bool bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, bat_svg_name name,
                       const char *value, const char *source);
/* Declarations "name: value; ...", those that are !important or those that are not; text stays. */
void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important);

/* A style sheet: rules with one selector each, made of a type, classes and an id without combinators. */
typedef struct bat_svg_rule {
    uint32_t selector, selector_size, body, body_size; /* in the sheet's text */
    uint32_t weight;                                   /* specificity */
} bat_svg_rule;

/* What an element must have for a rule to match: "#id", ".class", "type" or "*". */
typedef struct bat_svg_key {
    const char *text;
    uint32_t size, rule;
} bat_svg_key;

typedef struct bat_svg_sheet {
    char *text;          /* without comments, a zero behind it; owned */
    bat_svg_rule *rules; /* ascending weight, then order */
    bat_svg_key *keys;   /* one a rule, sorted by their texts, then rules */
    size_t count;
    int blocks; /* "{ ... }" and what begins with "@" */
} bat_svg_sheet;

enum { BAT_SVG_RULES_MAX = 20000 };

bat_status bat_svg_sheet_parse(const char *text, size_t size, bat_svg_sheet *sheet);
void bat_svg_sheet_free(bat_svg_sheet *sheet);
/* type, id, class: NULL when there is none. The first rule from `from` on that may match by its key; count: none. */
size_t bat_svg_sheet_next(const bat_svg_sheet *sheet, const char *type, const char *id, const char *classes,
                          size_t from);
bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const char *type,
                          const char *id, const char *classes);

#endif
