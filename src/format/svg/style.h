/* Style of SVG elements: presentation attributes, style="", and style sheets with simple selectors. */
#ifndef BATTEN_FORMAT_SVG_STYLE_H
#define BATTEN_FORMAT_SVG_STYLE_H

#include "format/svg/names.h"

#include <batten/document.h>

typedef struct bat_svg_paint {
    enum { BAT_PAINT_NONE, BAT_PAINT_COLOUR, BAT_PAINT_CURRENT } kind;
    uint32_t colour;
    const char *server; /* the content of url(), where it was read; NULL: none. kind is the fallback */
    bool bare;          /* there is a url() without a fallback */
} bat_svg_paint;

typedef struct bat_svg_style {
    /* inherited */
    uint32_t colour; /* currentColor */
    bat_svg_paint fill, stroke;
    double fill_opacity, stroke_opacity;
    double width;       /* user units */
    const char *dashes; /* where they were read; NULL: none */
    double dash_offset;
    double miter_limit;
    bat_cap cap;
    bat_join join;
    double font_size;
    int anchor;          /* of a text: 0 its start, 1 its middle, 2 its end */
    bool vertical, base; /* it runs downwards; its lines do not stand on their base line */
    bool even_odd, visible;
    uint32_t odd; /* BAT_SVG_BIT of the odd properties that are set; some are inherited */
    /* not inherited */
    double opacity;
    bool shown;
    bat_svg_paint stop; /* of a gradient */
    double stop_opacity;
} bat_svg_style;

bool bat_svg_colour(const char *text, uint32_t *colour); /* 0xRRGGBBAA */

/* The initial style of SVG. */
bat_svg_style bat_svg_style_initial(void);
/* The style with which the child of an element with this style begins. */
bat_svg_style bat_svg_style_child(const bat_svg_style *parent);
/* Sets one property. Names that are not properties and values that do not parse change nothing and give false.
 * diagonal: what a percentage of stroke-width refers to. source: the value in its original text, which must
 * outlive the style and may continue after the value. */
bool bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, bat_svg_name name,
                       const char *value, const char *source);
/* Applies declarations "name: value; ...": those that are !important, or those that are not. text must outlive
 * the style. */
void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important);

/* A style sheet: rules with one selector each, made of a type, classes and an id without combinators. */
typedef struct bat_svg_rule {
    uint32_t selector, selector_size, body, body_size; /* in the sheet's text */
    uint32_t weight;                                   /* specificity */
} bat_svg_rule;

/* What an element must have for a rule to match it: "#id", ".class", "type" or "*". */
typedef struct bat_svg_key {
    const char *text;
    uint32_t size, rule;
} bat_svg_key;

typedef struct bat_svg_sheet {
    char *text;          /* without comments, zero-terminated; owned */
    bat_svg_rule *rules; /* ascending weight, then order */
    bat_svg_key *keys;   /* one per rule, sorted by text, then by rule */
    size_t count;
    int blocks; /* number of "{ ... }" blocks and "@" rules */
} bat_svg_sheet;

enum { BAT_SVG_RULES_MAX = 20000 };

bat_status bat_svg_sheet_parse(const char *text, size_t size, bat_svg_sheet *sheet);
void bat_svg_sheet_free(bat_svg_sheet *sheet);
/* The first rule from `from` on that may match, judged by its key; `count`: none. type, id, classes: NULL when
 * there is none. */
size_t bat_svg_sheet_next(const bat_svg_sheet *sheet, const char *type, const char *id, const char *classes,
                          size_t from);
bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const char *type,
                          const char *id, const char *classes);

#endif
