/* Style of SVG elements: presentation attributes, style="", and style sheets of simple selectors. */
#ifndef BATTEN_FORMAT_SVG_STYLE_H
#define BATTEN_FORMAT_SVG_STYLE_H

#include <batten/document.h>

typedef struct bat_svg_paint {
    enum { BAT_PAINT_NONE, BAT_PAINT_COLOUR, BAT_PAINT_CURRENT } kind;
    uint32_t colour;
    bool server; /* a gradient or pattern stood here; kind is its fallback */
    bool bare;   /* ... and it had none */
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
    bool even_odd, visible, marked;
    /* of the element alone */
    double opacity;
    bool shown, clipped, filtered, fixed_width;
} bat_svg_style;

bool bat_svg_colour(const char *text, uint32_t *colour); /* 0xRRGGBBAA */

/* What SVG begins with. */
bat_svg_style bat_svg_style_initial(void);
/* The style that a child of an element with this style begins with. */
bat_svg_style bat_svg_style_child(const bat_svg_style *parent);
/* One property; unknown names and values that do not parse change nothing. diagonal: what stroke-width's %
 * refer to. */
void bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, const char *name,
                       const char *value);
/* Declarations "name: value; ...", those that are !important or those that are not. */
void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important);

/* A style sheet: rules with one selector each, made of a type, classes and an id without combinators. */
typedef struct bat_svg_rule {
    uint32_t selector, selector_size, body, body_size; /* in the sheet's text */
    uint32_t weight;                                   /* specificity */
} bat_svg_rule;

typedef struct bat_svg_sheet {
    char *text;          /* without comments; owned */
    bat_svg_rule *rules; /* ascending weight, then order */
    size_t count;
    size_t left_out; /* rules with selectors that are not known */
} bat_svg_sheet;

enum { BAT_SVG_RULES_MAX = 20000 };

bat_status bat_svg_sheet_parse(const char *text, size_t size, bat_svg_sheet *sheet);
void bat_svg_sheet_free(bat_svg_sheet *sheet);
/* type, id, class: NULL when there is none. */
bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const char *type,
                          const char *id, const char *classes);

#endif
