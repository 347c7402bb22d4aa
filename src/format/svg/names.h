/* The names of attributes and style properties, and how each is treated. */
#ifndef BATTEN_FORMAT_SVG_NAMES_H
#define BATTEN_FORMAT_SVG_NAMES_H

#include <batten/format.h>

/* The meaning of a name. */
typedef enum bat_svg_name {
    /* properties that are supported */
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
    BAT_SVG_CLIP_RULE,
    BAT_SVG_VISIBILITY,
    BAT_SVG_OPACITY,
    BAT_SVG_DISPLAY,
    BAT_SVG_STOP_COLOUR,
    BAT_SVG_STOP_OPACITY,
    BAT_SVG_DASH_OFFSET,
    BAT_SVG_FONT, /* of texts: where they lie */
    BAT_SVG_FONT_SIZE,
    BAT_SVG_ANCHOR,
    BAT_SVG_WRITING,
    BAT_SVG_BASELINE,
    BAT_SVG_OVERFLOW,
    /* properties that are not ("odd" ones): each is a bit in a style */
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
    BAT_SVG_ODD_UNKNOWN, /* any property or word without effect */
    BAT_SVG_ODD_VALUE,   /* any property or value of which it is not known that it has none */
    BAT_SVG_ODD_END,
    BAT_SVG_MARKER = BAT_SVG_ODD_END, /* all three */
    /* the rest */
    BAT_SVG_IDLE,      /* a property of text, gradients or filters: it changes no shape */
    BAT_SVG_ATTRIBUTE, /* not a property: either read, or without effect */
    BAT_SVG_SPOKEN,    /* for screen readers */
    BAT_SVG_NAMELESS   /* not known */
} bat_svg_name;

bat_svg_name bat_svg_name_of(const char *name);

/* Bits of the odd properties of a style. */
#define BAT_SVG_BIT(name) (1u << ((name)-BAT_SVG_ODD))
#define BAT_SVG_INHERITED (BAT_SVG_BIT(BAT_SVG_INHERITED_END) - 1)

/* What is lost with the odd property of this bit number; BAT_LOSS_COUNT: there is no such property. */
bat_loss bat_svg_odd_loss(int bit);
/* What is lost with an attribute that is not a property; what: its bat_svg_name_of. BAT_LOSS_COUNT: nothing. */
bat_loss bat_svg_attribute_loss(bat_svg_name what, const char *name);

#endif
