/* The elements of an SVG file, kept until the end because `use` and style sheets may point forward. */
#ifndef BATTEN_FORMAT_SVG_TREE_H
#define BATTEN_FORMAT_SVG_TREE_H

#include "text/text.h"

#include <batten/format.h>

enum { BAT_SVG_DEPTH = 256, BAT_SVG_ELEMENTS_MAX = 1 << 22 };

#define BAT_SVG_NAMESPACE "http://www.w3.org/2000/svg"
#define BAT_SVG_NATIVE_NAMESPACE "urn:batten:1"

typedef enum bat_svg_kind {
    BAT_SVG_UNKNOWN, /* of another namespace, or not known */
    BAT_SVG_ROOT,    /* svg, at the top or nested */
    BAT_SVG_GROUP,   /* g, a */
    BAT_SVG_SWITCH,
    BAT_SVG_SYMBOL,
    BAT_SVG_USE,
    BAT_SVG_SHAPE, /* path rect circle ellipse line polyline polygon */
    BAT_SVG_TEXT,
    BAT_SVG_IMAGE,
    BAT_SVG_OTHER, /* drawn or animated, but not supported */
    BAT_SVG_NEVER, /* clipPath, title, ...: not drawn in place */
    BAT_SVG_DEFS,
    BAT_SVG_GRADIENT, /* linear or radial */
    BAT_SVG_STOP,
    BAT_SVG_METADATA,
    BAT_SVG_STYLE,
    BAT_SVG_NATIVE /* Batten's own document, in the metadata */
} bat_svg_kind;

/* Indices; 0: none. */
typedef struct bat_svg_element {
    uint32_t name; /* without prefix, in strings */
    uint32_t attributes, attribute_count;
    uint32_t parent, first, next;
    uint8_t kind;
    uint8_t loss; /* bat_loss of the element as such; BAT_LOSS_COUNT: none */
    uint8_t type; /* of those with known names the same for the same name; 0: another */
} bat_svg_element;

/* How many siblings stand before and after an element: [0] of all, [1] of those of its type. */
typedef struct bat_svg_standing {
    uint32_t before[2], after[2];
} bat_svg_standing;

typedef struct bat_svg_tree {
    bat_svg_element *elements; /* element 1 is the root */
    uint32_t count, room;
    uint32_t *attributes; /* pairs of name and value, as offsets in strings */
    uint32_t attribute_count, attribute_room;
    bat_text strings;
    uint32_t open[BAT_SVG_DEPTH], last[BAT_SVG_DEPTH]; /* elements not yet ended, and their last children */
    int depth;
    uint32_t *ids; /* elements that have an id, sorted by it; set by bat_svg_tree_index */
    uint32_t id_count;
    bat_svg_standing *standings; /* of each element; NULL until bat_svg_tree_number */
    char drawing_prefix[16], native_prefix[16];
} bat_svg_tree;

/* BAT_MEMORY, BAT_COUNT (too deep, too many), BAT_SYNTAX (a second root). */
bat_status bat_svg_tree_open(bat_svg_tree *tree, const char *name, const char *const *attributes);
bat_status bat_svg_tree_close(bat_svg_tree *tree);
bat_status bat_svg_tree_index(bat_svg_tree *tree);
/* Finds the standings; once. O(elements). */
bat_status bat_svg_tree_number(bat_svg_tree *tree);
void bat_svg_tree_free(bat_svg_tree *tree);

const char *bat_svg_tree_name(const bat_svg_tree *tree, uint32_t element);
const char *bat_svg_tree_attribute(const bat_svg_tree *tree, uint32_t element,
                                   const char *name); /* or NULL */
/* Whether it has an attribute that is none of those names; the last one is NULL. */
bool bat_svg_says_more(const bat_svg_tree *tree, uint32_t element, const char *const *known);
uint32_t bat_svg_tree_find(const bat_svg_tree *tree, const char *id); /* the first with this id, or 0 */
/* The element to which "#id" after url( refers; the id may be in quotes, and the text may continue after it.
 * 0: no element of this file. */
uint32_t bat_svg_tree_refer(const bat_svg_tree *tree, const char *text);

#endif
