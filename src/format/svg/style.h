/* Style of SVG elements: presentation attributes, style="", and style sheets with simple selectors. */
#ifndef BATTEN_FORMAT_SVG_STYLE_H
#define BATTEN_FORMAT_SVG_STYLE_H

#include "format/svg/names.h"
#include "format/svg/tree.h"

#include <batten/document.h>

typedef struct bat_svg_paint {
    enum {
        BAT_PAINT_NONE,
        BAT_PAINT_COLOUR,
        BAT_PAINT_CURRENT,
        BAT_PAINT_CONTEXT_FILL, /* that of the shape that the marker is on; elsewhere none */
        BAT_PAINT_CONTEXT_STROKE
    } kind;
    uint32_t colour;
    const char *server; /* the content of url(), where it was read; NULL: none. kind is the fallback */
    bool bare;          /* there is a url() without a fallback */
} bat_svg_paint;

/* A custom property (--name: value) that is in force, and those set before it or around it. */
typedef struct bat_svg_variable {
    const struct bat_svg_variable *before;
    struct bat_svg_variable *made;
    const char *name, *value; /* where they were read */
    uint32_t name_size, value_size;
} bat_svg_variable;

/* What a declaration says of where an element is (geometry.h), and what was said before it. */
typedef struct bat_svg_placing {
    const struct bat_svg_placing *before;
    struct bat_svg_placing *made;
    uint8_t property; /* bat_svg_geometry */
    bool important;
    char value[];
} bat_svg_placing;

typedef struct bat_svg_variables {
    bat_svg_variable *made; /* all that are; owned */
    bat_svg_placing *placings;
    bool failed; /* out of memory */
} bat_svg_variables;

typedef struct bat_svg_style {
    /* inherited */
    const bat_svg_variable *variables; /* the last one; NULL: none */
    bat_svg_variables *store;          /* that owns them; NULL: none can be set */
    uint32_t colour;                   /* currentColor */
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
    bool clip_even_odd; /* as part of a clip path */
    bool stroke_first;
    const char *markers[3]; /* the content of url(), where it was read; NULL: none. bat_marker_place */
    uint8_t marker_order;   /* bat_marker_order */
    uint32_t odd;           /* BAT_SVG_BIT of the odd properties that are set; some are inherited */
    /* not inherited */
    const bat_svg_placing *placing; /* the last one; NULL: none */
    double opacity;
    const char *clip, *mask; /* the content of url(), where it was read; NULL: none */
    bool overflows;          /* what is beyond its viewport is seen */
    bool shown;
    bat_svg_paint stop; /* of a gradient */
    double stop_opacity;
} bat_svg_style;

bool bat_svg_colour(const char *text, uint32_t *colour); /* 0xRRGGBBAA */

/* The initial style of SVG. */
bat_svg_style bat_svg_style_initial(void);
/* The style with which the child of an element with this style begins. */
bat_svg_style bat_svg_style_child(const bat_svg_style *parent);
/* Notes a declaration that bat_svg_style_set did not understand: as seen where browsers may paint something by it, which a mere
 * word instead of a number or a function does not. */
void bat_svg_style_miss(bat_svg_style *style, const char *name, const char *value, size_t size);
/* Sets one property. Names that are not properties and values that do not parse change nothing and give false.
 * diagonal: what a percentage of stroke-width refers to. source: the value in its original text, which must
 * outlive the style and may continue after the value. */
bool bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, bat_svg_name name,
                       const char *value, const char *source);
/* Applies declarations "name: value; ...": those that are !important, or those that are not. text must outlive
 * the style. */
void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important);

/* Sets the custom properties among declarations. text must outlive the style. */
void bat_svg_style_variables(bat_svg_style *style, const char *text, size_t size);
void bat_svg_variables_free(bat_svg_variables *variables);

/* A style sheet: rules with one selector each (select.c). */
typedef struct bat_svg_rule {
    uint32_t selector, selector_size, body, body_size; /* in the sheet's text */
    uint32_t subject;                                  /* where in the selector its last compound begins */
    uint32_t weight;                                   /* specificity */
    bool
        guess; /* that it holds: of a selector or a condition that is not known here. It is not obeyed, but said */
} bat_svg_rule;

/* What an element must have for a rule to match it. mark: '#' an id, '.' a class, 't' a type or "*", '=' an attribute of that
 * value, '^' and '$' one that begins or ends so, '[' an attribute of any value. */
typedef struct bat_svg_key {
    char mark;
    const char *text, *value; /* value: of '=', '^' and '$' */
    uint32_t size, value_size, rule;
    uint32_t end; /* of the keys of a sheet that ask for the same */
} bat_svg_key;

typedef struct bat_svg_sheet {
    char *text;          /* without comments, zero-terminated; owned */
    bat_svg_rule *rules; /* ascending weight, then order */
    bat_svg_key *keys;   /* one per rule, sorted by what they ask for, then by rule */
    size_t count;
    int blocks;                  /* number of "{ ... }" blocks and "@" rules */
    bool variables, important;   /* it may set some; it may hold declarations that are !important */
    bool by_attributes, by_ends; /* keys ask for attributes; for how they begin or end */
    bool ranks;                  /* selectors may ask where elements stand among their siblings */
} bat_svg_sheet;

enum {
    BAT_SVG_RULES_MAX = 20000,
    BAT_SVG_ENDS_MAX = 32 /* bytes of a value that a key says the beginning or end of */
};

bat_status bat_svg_sheet_parse(const char *text, size_t size, bat_svg_sheet *sheet);
void bat_svg_sheet_free(bat_svg_sheet *sheet);
/* Their order by what they ask for. */
int bat_svg_key_compare(const bat_svg_key *a, const bat_svg_key *b);

/* Rules that may match an element, judged by their keys: ascending, each once. */
typedef struct bat_svg_candidates {
    uint32_t *rules; /* owned, with room for as many again */
    size_t count, room;
} bat_svg_candidates;

/* Replaces them by those of the element. O(k log(rules) + n log k) for n rules of k keys that the element answers to; k is at most
 * the number of its classes and attributes, and some more for each where rules ask how a value begins or ends. */
bat_status bat_svg_candidates_find(const bat_svg_sheet *sheet, const bat_svg_tree *tree, uint32_t element,
                                   bat_svg_candidates *out);
void bat_svg_candidates_free(bat_svg_candidates *candidates);

/* ---- rank.c: places among siblings (Selectors 4, 13) ---- */

/* Of a pseudo-class: step n + offset, n >= 0, is the number from 1 on. */
typedef struct bat_svg_rank {
    uint8_t number; /* in the list of ranks */
    int32_t step, offset;
} bat_svg_rank;

/* argument: what stands in its brackets, NULL: it has none. False: it is no place, or its argument is not An+B. */
bool bat_svg_rank_read(const char *name, size_t size, const char *argument, size_t argument_size,
                       bat_svg_rank *out);
/* After bat_svg_tree_number. O(1). */
bool bat_svg_rank_holds(const bat_svg_rank *rank, const bat_svg_tree *tree, uint32_t element);

/* ---- select.c ---- */
bool bat_svg_is_name(char c);
/* The next comma of a list that is not in brackets or quotes, or `end`. */
const char *bat_svg_list_end(const char *from, const char *end);
/* The specificity of a selector, and where its last compound begins; 0: it is not supported. *guess becomes true where it holds
 * one; else it stays as it is. */
uint32_t bat_svg_selector_weigh(const char *selector, size_t size, uint32_t *subject, bool *guess);
/* The key of that compound; `rule` is not set. */
bat_svg_key bat_svg_selector_key(const char *compound, const char *end);
/* Adds to *steps, by at most some thousands, how many elements were looked at: of those around and before the element, when the
 * selector has more than one compound. What is further away matches nothing. */
bool bat_svg_rule_matches(const bat_svg_sheet *sheet, const bat_svg_rule *rule, const bat_svg_tree *tree,
                          uint32_t element, long *steps);

#endif
