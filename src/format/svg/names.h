/* The names of attributes and style properties, and what becomes of each. */
#ifndef BATTEN_FORMAT_SVG_NAMES_H
#define BATTEN_FORMAT_SVG_NAMES_H

#include <batten/format.h>

/* What a name stands for. */
typedef enum bat_svg_name {
    /* properties that are drawn */
    BAT_SVG_COLOUR,
    BAT_SVG_FILL,
    BAT_SVG_STROKE,
    BAT_SVG_FILL_OPACITY,
    BAT_SVG_STROKE_OPACITY,
    BAT_SVG_WIDTH,
    BAT_SVG_MITER,
    BAT_SVG_CAP,
    BAT_SVG_JOIN,
    BAT_SVG_RULE,
    BAT_SVG_VISIBILITY,
    BAT_SVG_OPACITY,
    BAT_SVG_DISPLAY,
    BAT_SVG_STOP_COLOUR,
    BAT_SVG_STOP_OPACITY,
    /* properties that are not: odd ones, each a bit of a style */
    BAT_SVG_ODD,
    BAT_SVG_DASHES = BAT_SVG_ODD,
    BAT_SVG_ORDER,
    BAT_SVG_MARKER_START,
    BAT_SVG_MARKER_MID,
    BAT_SVG_MARKER_END,
    BAT_SVG_SHAPE_HINT,
    BAT_SVG_COLOUR_HINT,
    BAT_SVG_INTERPOLATION,
    BAT_SVG_IMAGE_HINT,
    BAT_SVG_INHERITED_END,
    BAT_SVG_CLIP = BAT_SVG_INHERITED_END,
    BAT_SVG_MASK,
    BAT_SVG_FILTER,
    BAT_SVG_EFFECT,
    BAT_SVG_BLEND,
    BAT_SVG_ISOLATION,
    BAT_SVG_ODD_UNKNOWN, /* whatever is not understood */
    BAT_SVG_ODD_END,
    BAT_SVG_MARKER = BAT_SVG_ODD_END, /* all three */
    /* the rest */
    BAT_SVG_IDLE,      /* a property of text, gradients or filters: it changes no shape */
    BAT_SVG_ATTRIBUTE, /* no property: read, or without effect */
    BAT_SVG_SPOKEN,    /* for who does not see it */
    BAT_SVG_NAMELESS   /* not known */
} bat_svg_name;

bat_svg_name bat_svg_name_of(const char *name);

/* Bits of a style's odd properties. */
#define BAT_SVG_BIT(name) (1u << ((name)-BAT_SVG_ODD))
#define BAT_SVG_INHERITED (BAT_SVG_BIT(BAT_SVG_INHERITED_END) - 1)

/* What is lost with the odd property of bit i; BAT_LOSS_COUNT: there is none. */
bat_loss bat_svg_odd_loss(int bit);
/* What is lost with an attribute that is no property, what bat_svg_name_of says it is; BAT_LOSS_COUNT: nothing. */
bat_loss bat_svg_attribute_loss(bat_svg_name what, const char *name);

#endif
