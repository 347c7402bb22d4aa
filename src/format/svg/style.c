/* Properties of stroke and fill, and what is inherited (SVG 2, 13; CSS). */
#include "format/svg/style.h"

#include "text/number.h"
#include "format/svg/svg.h"

#include <math.h>
#include <string.h>

bat_svg_style bat_svg_style_initial(void) {
    return (bat_svg_style){.colour = 0x000000ff,
                           .fill = {.kind = BAT_PAINT_COLOUR, .colour = 0x000000ff},
                           .fill_opacity = 1,
                           .stroke_opacity = 1,
                           .width = 1,
                           .miter_limit = 4,
                           .cap = BAT_CAP_BUTT,
                           .join = BAT_JOIN_MITER,
                           .visible = true,
                           .opacity = 1,
                           .shown = true};
}

bat_svg_style bat_svg_style_child(const bat_svg_style *parent) {
    bat_svg_style style = *parent;
    style.opacity = 1;
    style.shown = true;
    style.clipped = style.filtered = style.fixed_width = false;
    return style;
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

static void set_paint(bat_svg_paint *paint, const char *value) {
    uint32_t colour;
    bat_svg_paint made = {.kind = BAT_PAINT_NONE};
    if (strncmp(value, "url(", 4) == 0) {
        const char *close = strchr(value, ')');
        if (!close) return;
        made.server = true;
        value = close + 1;
        while (is_space(*value)) value++;
        if (!*value) {
            made.bare = true;
            *paint = made;
            return;
        }
    }
    if (strcmp(value, "currentColor") == 0 || strcmp(value, "currentcolor") == 0)
        made.kind = BAT_PAINT_CURRENT;
    else if (strcmp(value, "none") != 0) {
        if (!bat_svg_colour(value, &colour)) return;
        made.kind = BAT_PAINT_COLOUR;
        made.colour = colour;
    }
    *paint = made;
}

/* A number from 0 to 1, or a percentage; clamped. */
static void set_share(double *share, const char *value) {
    double number;
    const char *end = value + strlen(value), *at = bat_number_scan(value, end, &number);
    if (!at || !isfinite(number)) return;
    if (*at == '%') number /= 100, at++;
    if (at == end) *share = fmin(fmax(number, 0), 1);
}

/* The index of value among words, or what it was. */
static int choose(const char *value, const char *const words[], int count, int before) {
    for (int i = 0; i < count; i++)
        if (strcmp(value, words[i]) == 0) return i;
    return before;
}

static bool is_none(const char *value) { return strcmp(value, "none") == 0; }

enum {
    COLOUR,
    FILL,
    STROKE,
    FILL_OPACITY,
    STROKE_OPACITY,
    WIDTH,
    MITER,
    CAP,
    JOIN,
    RULE,
    VISIBILITY,
    OPACITY,
    DISPLAY,
    CLIP,
    MASK,
    FILTER,
    MARKER,
    MARKER_START,
    MARKER_MID,
    MARKER_END,
    EFFECT,
    PROPERTIES
};

static const char *const properties[PROPERTIES] = {"color",
                                                   "fill",
                                                   "stroke",
                                                   "fill-opacity",
                                                   "stroke-opacity",
                                                   "stroke-width",
                                                   "stroke-miterlimit",
                                                   "stroke-linecap",
                                                   "stroke-linejoin",
                                                   "fill-rule",
                                                   "visibility",
                                                   "opacity",
                                                   "display",
                                                   "clip-path",
                                                   "mask",
                                                   "filter",
                                                   "marker",
                                                   "marker-start",
                                                   "marker-mid",
                                                   "marker-end",
                                                   "vector-effect"};

static void inherit(bat_svg_style *style, const bat_svg_style *parent, int property) {
    switch (property) {
    case COLOUR: style->colour = parent->colour; break;
    case FILL: style->fill = parent->fill; break;
    case STROKE: style->stroke = parent->stroke; break;
    case FILL_OPACITY: style->fill_opacity = parent->fill_opacity; break;
    case STROKE_OPACITY: style->stroke_opacity = parent->stroke_opacity; break;
    case WIDTH: style->width = parent->width; break;
    case MITER: style->miter_limit = parent->miter_limit; break;
    case CAP: style->cap = parent->cap; break;
    case JOIN: style->join = parent->join; break;
    case RULE: style->even_odd = parent->even_odd; break;
    case VISIBILITY: style->visible = parent->visible; break;
    case OPACITY: style->opacity = parent->opacity; break;
    case DISPLAY: style->shown = parent->shown; break;
    default: break;
    }
}

void bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, const char *name,
                       const char *value) {
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    static const char *const rules[] = {"nonzero", "evenodd"};
    int property = choose(name, properties, PROPERTIES, PROPERTIES);
    if (property == PROPERTIES) return;
    while (is_space(*value)) value++;
    if (strcmp(value, "inherit") == 0) {
        inherit(style, parent, property);
        return;
    }
    double number;
    uint32_t colour;
    switch (property) {
    case COLOUR:
        if (bat_svg_colour(value, &colour)) style->colour = colour;
        break;
    case FILL: set_paint(&style->fill, value); break;
    case STROKE: set_paint(&style->stroke, value); break;
    case FILL_OPACITY: set_share(&style->fill_opacity, value); break;
    case STROKE_OPACITY: set_share(&style->stroke_opacity, value); break;
    case OPACITY: set_share(&style->opacity, value); break;
    case WIDTH:
        if (bat_svg_length(value, diagonal, &number) && number >= 0) style->width = number;
        break;
    case MITER:
        if (bat_svg_length(value, 0, &number) && number >= 1) style->miter_limit = number;
        break;
    case CAP: style->cap = (bat_cap)choose(value, caps, 3, (int)style->cap); break;
    case JOIN: style->join = (bat_join)choose(value, joins, 3, (int)style->join); break;
    case RULE: style->even_odd = choose(value, rules, 2, style->even_odd) == 1; break;
    case VISIBILITY: style->visible = strcmp(value, "visible") == 0; break;
    case DISPLAY: style->shown = !is_none(value); break;
    case CLIP:
    case MASK:
        if (!is_none(value)) style->clipped = true;
        break;
    case FILTER: style->filtered = !is_none(value); break;
    case EFFECT: style->fixed_width = strcmp(value, "non-scaling-stroke") == 0; break;
    default: style->marked = !is_none(value); break;
    }
}

/* Copies [from, to) without blanks around it; false when there is no room. */
static bool copy_trimmed(const char *from, const char *to, char *out, size_t room) {
    while (from < to && is_space(*from)) from++;
    while (to > from && is_space(to[-1])) to--;
    size_t size = (size_t)(to - from);
    if (size == 0 || size >= room) return false;
    memcpy(out, from, size);
    out[size] = '\0';
    return true;
}

/* The end of the declaration at `at`: a semicolon outside brackets and quotes. */
static const char *declaration_end(const char *at, const char *end) {
    int depth = 0;
    char quote = 0;
    for (; at < end; at++) {
        if (quote) {
            if (*at == quote) quote = 0;
        } else if (*at == '"' || *at == '\'')
            quote = *at;
        else if (*at == '(')
            depth++;
        else if (*at == ')')
            depth--;
        else if (*at == ';' && depth <= 0)
            return at;
    }
    return end;
}

void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important) {
    for (const char *at = text, *end = text + size; at < end;) {
        const char *stop = declaration_end(at, end), *colon = memchr(at, ':', (size_t)(stop - at));
        char name[24], value[160]; /* what is longer is none of ours */
        if (colon && copy_trimmed(at, colon, name, sizeof name) &&
            copy_trimmed(colon + 1, stop, value, sizeof value)) {
            char *mark = strchr(value, '!');
            if (mark) {
                while (mark > value && is_space(mark[-1])) mark--;
                *mark = '\0';
            }
            if ((mark != NULL) == important) bat_svg_style_set(style, parent, diagonal, name, value);
        }
        at = stop < end ? stop + 1 : end;
    }
}
