/* Properties of stroke and fill, and what is inherited (SVG 2, 13; CSS). */
#include "format/svg/style.h"

#include "document/markers.h"
#include "text/number.h"
#include "format/svg/geometry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_svg_style bat_svg_style_initial(void) {
    return (bat_svg_style){.colour = 0x000000ff,
                           .fill = {.kind = BAT_PAINT_COLOUR, .colour = 0x000000ff},
                           .fill_opacity = 1,
                           .stroke_opacity = 1,
                           .width = 1,
                           .miter_limit = 4,
                           .font_size = 16,
                           .cap = BAT_CAP_BUTT,
                           .join = BAT_JOIN_MITER,
                           .visible = true,
                           .opacity = 1,
                           .shown = true,
                           .stop = {.kind = BAT_PAINT_COLOUR, .colour = 0x000000ff},
                           .stop_opacity = 1};
}

bat_svg_style bat_svg_style_child(const bat_svg_style *parent) {
    bat_svg_style style = *parent, initial = bat_svg_style_initial();
    style.odd &= BAT_SVG_INHERITED;
    style.opacity = style.stop_opacity = 1;
    style.clip = style.mask = NULL;
    style.overflows = false;
    style.shown = true;
    style.placing = NULL;
    style.stop = initial.stop;
    return style;
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

static bool set_paint(bat_svg_paint *paint, const char *value, const char *source) {
    uint32_t colour;
    bat_svg_paint made = {.kind = BAT_PAINT_NONE};
    if (strncmp(value, "url(", 4) == 0) {
        const char *close = strchr(value, ')');
        if (!close) return false;
        made.server = source + 4;
        value = close + 1;
        while (is_space(*value)) value++;
        if (!*value) {
            made.bare = true;
            *paint = made;
            return true;
        }
    }
    if (strcmp(value, "currentColor") == 0 || strcmp(value, "currentcolor") == 0)
        made.kind = BAT_PAINT_CURRENT;
    else if (strcmp(value, "context-fill") == 0)
        made.kind = BAT_PAINT_CONTEXT_FILL;
    else if (strcmp(value, "context-stroke") == 0)
        made.kind = BAT_PAINT_CONTEXT_STROKE;
    else if (strcmp(value, "none") != 0) {
        if (!bat_svg_colour(value, &colour)) return false;
        made.kind = BAT_PAINT_COLOUR;
        made.colour = colour;
    }
    *paint = made;
    return true;
}

/* A number from 0 to 1, or a percentage; clamped. */
static bool set_share(double *share, const char *value) {
    double number;
    const char *end = value + strlen(value), *at = bat_number_scan(value, end, &number);
    if (!at || !isfinite(number)) return false;
    if (*at == '%') number /= 100, at++;
    if (at != end) return false;
    *share = fmin(fmax(number, 0), 1);
    return true;
}

/* Values below `low` are not valid and are ignored. */
static bool set_length(double *length, const char *value, double whole, double low) {
    double number;
    if (!bat_svg_length(value, whole, &number)) return false;
    if (number >= low) *length = number;
    return true;
}

/* The index of value among words, or -1. */
static int choose(const char *value, const char *const words[], int count) {
    for (int i = 0; i < count; i++)
        if (strcmp(value, words[i]) == 0) return i;
    return -1;
}

static void inherit(bat_svg_style *style, const bat_svg_style *parent, bat_svg_name property) {
    switch (property) {
    case BAT_SVG_COLOUR: style->colour = parent->colour; break;
    case BAT_SVG_FILL: style->fill = parent->fill; break;
    case BAT_SVG_STROKE: style->stroke = parent->stroke; break;
    case BAT_SVG_FILL_OPACITY: style->fill_opacity = parent->fill_opacity; break;
    case BAT_SVG_STROKE_OPACITY: style->stroke_opacity = parent->stroke_opacity; break;
    case BAT_SVG_WIDTH: style->width = parent->width; break;
    case BAT_SVG_MITER: style->miter_limit = parent->miter_limit; break;
    case BAT_SVG_CAP: style->cap = parent->cap; break;
    case BAT_SVG_JOIN: style->join = parent->join; break;
    case BAT_SVG_RULE: style->even_odd = parent->even_odd; break;
    case BAT_SVG_CLIP_RULE: style->clip_even_odd = parent->clip_even_odd; break;
    case BAT_SVG_CLIP: style->clip = parent->clip; break;
    case BAT_SVG_MASK: style->mask = parent->mask; break;
    case BAT_SVG_ORDER:
        style->stroke_first = parent->stroke_first;
        style->marker_order = parent->marker_order;
        break;
    case BAT_SVG_OVERFLOW: style->overflows = parent->overflows; break;
    case BAT_SVG_MARKER:
    case BAT_SVG_MARKER_START:
    case BAT_SVG_MARKER_MID:
    case BAT_SVG_MARKER_END:
        for (int k = 0; k < 3; k++)
            if (property == BAT_SVG_MARKER || (int)property == BAT_SVG_MARKER_START + k)
                style->markers[k] = parent->markers[k];
        break;
    case BAT_SVG_VISIBILITY: style->visible = parent->visible; break;
    case BAT_SVG_OPACITY: style->opacity = parent->opacity; break;
    case BAT_SVG_DISPLAY: style->shown = parent->shown; break;
    case BAT_SVG_STOP_COLOUR: style->stop = parent->stop; break;
    case BAT_SVG_STOP_OPACITY: style->stop_opacity = parent->stop_opacity; break;
    case BAT_SVG_DASH_OFFSET: style->dash_offset = parent->dash_offset; break;
    case BAT_SVG_DASHES:
        style->dashes = parent->dashes;
        style->odd = (style->odd & ~BAT_SVG_BIT(BAT_SVG_DASHES)) |
                     (parent->odd & BAT_SVG_BIT(BAT_SVG_DASHES));
        break;
    default: break;
    }
}

/* Clears the property's bit for values without effect, with which nothing is lost, and sets it for others. */
static void set_odd(bat_svg_style *style, bat_svg_name property, const char *value) {
    static const char *const plain[] = {
        "none", "normal", "auto", "0", "sRGB", "fill", "initial", "geometricPrecision", "optimizeQuality"};
    uint32_t bits = property == BAT_SVG_MARKER
                        ? BAT_SVG_BIT(BAT_SVG_MARKER_START) | BAT_SVG_BIT(BAT_SVG_MARKER_MID) |
                              BAT_SVG_BIT(BAT_SVG_MARKER_END)
                        : BAT_SVG_BIT(property);
    if (choose(value, plain, sizeof plain / sizeof *plain) >= 0)
        style->odd &= ~bits;
    else
        style->odd |= bits;
}

/* What is not named comes last: the fill, the stroke, the markers. */
static void set_order(bat_svg_style *style, const char *value) {
    const char *fill = strstr(value, "fill"), *stroke = strstr(value, "stroke"),
               *markers = strstr(value, "markers");
    style->stroke_first = stroke && !(fill && fill < stroke);
    const int before = !markers ? 2 : (fill && fill < markers) + (stroke && stroke < markers);
    style->marker_order = (uint8_t)(before == 0   ? BAT_MARKERS_FIRST
                                    : before == 1 ? BAT_MARKERS_BETWEEN
                                                  : BAT_MARKERS_LAST);
}

static void set_markers(bat_svg_style *style, bat_svg_name property, const char *value, const char *source) {
    for (int k = 0; k < BAT_MARKER_PLACES; k++)
        if (property == BAT_SVG_MARKER || (int)property == BAT_SVG_MARKER_START + k)
            style->markers[k] = strncmp(value, "url(", 4) == 0 ? source + 4 : NULL;
}

static bool set_word(bat_svg_style *style, bat_svg_name property, const char *value) {
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    static const char *const rules[] = {"nonzero", "evenodd"};
    int word;
    switch (property) {
    case BAT_SVG_CAP:
        if ((word = choose(value, caps, 3)) >= 0) style->cap = (bat_cap)word;
        return word >= 0;
    case BAT_SVG_JOIN:
        if ((word = choose(value, joins, 3)) >= 0) style->join = (bat_join)word;
        return word >= 0;
    default:
        if ((word = choose(value, rules, 2)) < 0) return false;
        *(property == BAT_SVG_RULE ? &style->even_odd : &style->clip_even_odd) = word == 1;
        return true;
    }
}

/* A font's size; in `font` the first length that is one. Words as sizes are not known. */
static void set_font_size(bat_svg_style *style, const bat_svg_style *parent, bat_svg_name name,
                          const char *value) {
    while (name == BAT_SVG_FONT && *value && !(*value >= '0' && *value <= '9')) value++;
    char word[24];
    double number;
    const size_t size = strcspn(value, " \t\r\n/,;");
    if (size == 0 || size >= sizeof word) return;
    memcpy(word, value, size);
    word[size] = '\0';
    const char *end = word + size, *unit = bat_number_scan(word, end, &number);
    if (!unit || (name == BAT_SVG_FONT && unit == end)) return;
    if (strcmp(unit, "em") == 0)
        number *= parent->font_size;
    else if (!bat_svg_length(word, parent->font_size, &number))
        return;
    if (number > 0 && number < 1e6) style->font_size = number;
}

/* `color: currentColor` is what is inherited. */
static bool set_colour(bat_svg_style *style, const bat_svg_style *parent, const char *value) {
    const bool current = strcmp(value, "currentColor") == 0 || strcmp(value, "currentcolor") == 0;
    if (current) style->colour = parent->colour;
    return current || bat_svg_colour(value, &style->colour);
}

/* ---- custom properties ---- */

enum { VARIABLES_BACK = 1000, VARIABLES_DEEP = 8, VALUE_MAX = 160 };

static const bat_svg_variable *find_variable(const bat_svg_style *style, const char *name, size_t size) {
    const bat_svg_variable *at = style->variables;
    for (int i = 0; at && i < VARIABLES_BACK; i++, at = at->before)
        if (at->name_size == size && memcmp(at->name, name, size) == 0) return at;
    return NULL;
}

/* The bracket that closes the one before `at`; NULL: there is none in this declaration. */
static const char *closing(const char *at) {
    for (int depth = 1; *at && *at != ';' && *at != '}'; at++) {
        if (*at == '(') depth++;
        if (*at == ')' && --depth == 0) return at;
    }
    return NULL;
}

/* What var(...) at *from stands for becomes [*from, *to); false: nothing. */
static bool look_up(const bat_svg_style *style, const char **from, const char **to) {
    const char *name = *from + 4, *close = closing(name);
    if (!close) return false;
    while (is_space(*name)) name++;
    size_t size = 0;
    while (name + size < close && name[size] != ',' && !is_space(name[size])) size++;
    const bat_svg_variable *found = find_variable(style, name, size);
    const char *comma = memchr(name, ',', (size_t)(close - name));
    if (!found && !comma) return false;
    *from = found ? found->value : comma + 1;
    *to = found ? found->value + found->value_size : close;
    while (*from < *to && is_space(**from)) ++*from;
    while (*to > *from && is_space((*to)[-1])) --*to;
    return true;
}

static bool is_reference(const char *from, const char *to) {
    return to - from >= 4 && memcmp(from, "var(", 4) == 0;
}

/* The same until it is no other variable. */
static bool resolve(const bat_svg_style *style, const char **from, const char **to) {
    for (int i = 0; i < VARIABLES_DEEP && is_reference(*from, *to); i++)
        if (!look_up(style, from, to)) return false;
    return true;
}

/* Sets a property to what "var(--name, fallback)" stands for; what stands for nothing is as if nothing was set. */
static bool set_variable(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                         bat_svg_name name, const char *from) {
    const char *to = from + 4;
    char value[VALUE_MAX];
    if (!resolve(style, &from, &to)) {
        inherit(style, parent, name);
        return true;
    }
    const size_t size = (size_t)(to - from);
    if (size == 0 || size >= sizeof value) return false;
    memcpy(value, from, size);
    value[size] = '\0';
    return !strstr(value, "var(") && bat_svg_style_set(style, parent, diagonal, name, value, from);
}

bool bat_svg_style_set(bat_svg_style *style, const bat_svg_style *parent, double diagonal, bat_svg_name name,
                       const char *value, const char *source) {
    if (name > BAT_SVG_MARKER) return name == BAT_SVG_IDLE;
    while (is_space(*value)) value++, source++;
    if (strncmp(value, "var(", 4) == 0) return set_variable(style, parent, diagonal, name, source);
    if (strcmp(value, "inherit") == 0) {
        inherit(style, parent, name);
        return true;
    }
    switch (name) {
    case BAT_SVG_COLOUR: return set_colour(style, parent, value);
    case BAT_SVG_FILL: return set_paint(&style->fill, value, source);
    case BAT_SVG_STROKE: return set_paint(&style->stroke, value, source);
    case BAT_SVG_STOP_COLOUR: return set_paint(&style->stop, value, source);
    case BAT_SVG_FILL_OPACITY: return set_share(&style->fill_opacity, value);
    case BAT_SVG_STROKE_OPACITY: return set_share(&style->stroke_opacity, value);
    case BAT_SVG_STOP_OPACITY: return set_share(&style->stop_opacity, value);
    case BAT_SVG_OPACITY: return set_share(&style->opacity, value);
    case BAT_SVG_WIDTH: return set_length(&style->width, value, diagonal, 0);
    case BAT_SVG_MITER: return set_length(&style->miter_limit, value, 0, 1);
    case BAT_SVG_CAP:
    case BAT_SVG_JOIN:
    case BAT_SVG_RULE:
    case BAT_SVG_CLIP_RULE: return set_word(style, name, value);
    case BAT_SVG_VISIBILITY: style->visible = strcmp(value, "visible") == 0; return true;
    case BAT_SVG_DISPLAY: style->shown = strcmp(value, "none") != 0; return true;
    case BAT_SVG_FONT:
    case BAT_SVG_FONT_SIZE: set_font_size(style, parent, name, value); return true;
    case BAT_SVG_ANCHOR: style->anchor = value[0] == 'm' ? 1 : value[0] == 'e' ? 2 : 0; return true;
    case BAT_SVG_WRITING: style->vertical = value[0] == 't' || value[0] == 'v'; return true;
    case BAT_SVG_BASELINE: style->base = strcmp(value, "auto") != 0; return true;
    case BAT_SVG_DASH_OFFSET: return set_length(&style->dash_offset, value, diagonal, -INFINITY);
    case BAT_SVG_DASHES:
        set_odd(style, name, value);
        style->dashes = style->odd & BAT_SVG_BIT(BAT_SVG_DASHES) ? source : NULL;
        return true;
    case BAT_SVG_ORDER: set_order(style, value); return true;
    case BAT_SVG_OVERFLOW:
        style->overflows = strcmp(value, "visible") == 0 || strcmp(value, "auto") == 0;
        return true;
    case BAT_SVG_MARKER:
    case BAT_SVG_MARKER_START:
    case BAT_SVG_MARKER_MID:
    case BAT_SVG_MARKER_END: set_markers(style, name, value, source); return true;
    case BAT_SVG_CLIP:
        set_odd(style, name, value);
        style->clip = strncmp(value, "url(", 4) == 0 ? source + 4 : NULL;
        return true;
    case BAT_SVG_MASK: {
        const char *end = strchr(value, ')'); /* one mask, and nothing else about it */
        set_odd(style, name, value);
        style->mask = strncmp(value, "url(", 4) == 0 && end && !end[1] ? source + 4 : NULL;
        return true;
    }
    default: set_odd(style, name, value); return true;
    }
}

/* Copies [from, to) without the blanks around it; false when it does not fit. */
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

static bool is_variable(const char *at, const char *end) {
    return end - at > 2 && at[0] == '-' && at[1] == '-';
}

/* name: value, both without blanks around them. */
static void add_variable(bat_svg_style *style, const char *name, const char *colon, const char *end) {
    bat_svg_variable *made = malloc(sizeof *made);
    const char *mark = memchr(colon, '!', (size_t)(end - colon)), *value = colon + 1;
    if (!made) {
        style->store->failed = true;
        return;
    }
    if (mark) end = mark;
    while (colon > name && is_space(colon[-1])) colon--;
    while (value < end && is_space(*value)) value++;
    while (end > value && is_space(end[-1])) end--;
    *made = (bat_svg_variable){style->variables,         style->store->made,     name, value,
                               (uint32_t)(colon - name), (uint32_t)(end - value)};
    style->variables = style->store->made = made;
}

/* NULL: there is none. */
static const char *colon_in(const char *at, const char *end) {
    while (at < end && *at != ':') at++;
    return at < end ? at : NULL;
}

void bat_svg_style_variables(bat_svg_style *style, const char *text, size_t size) {
    for (const char *at = text, *end = text + size; style->store && at < end;) {
        const char *stop = declaration_end(at, end), *colon = colon_in(at, stop);
        while (at < stop && is_space(*at)) at++;
        if (colon && is_variable(at, colon)) add_variable(style, at, colon, stop);
        at = stop < end ? stop + 1 : end;
    }
}

void bat_svg_variables_free(bat_svg_variables *variables) {
    while (variables->made) {
        bat_svg_variable *next = variables->made->made;
        free(variables->made);
        variables->made = next;
    }
    while (variables->placings) {
        bat_svg_placing *next = variables->placings->made;
        free(variables->placings);
        variables->placings = next;
    }
}

/* Whether a property may have such a value: a number, or a function. Colours by rgb() and hsl() are known, if they are any. */
static bool may_be_value(const char *value, size_t size) {
    while (size > 0 && is_space(*value)) value++, size--;
    if (size > 0 && strchr("0123456789.+-", *value)) return true;
    return memchr(value, '(', size) && strncmp(value, "rgb", 3) != 0 && strncmp(value, "hsl", 3) != 0;
}

void bat_svg_style_miss(bat_svg_style *style, const char *name, const char *value, size_t size) {
    static const char *const painting[] = {"transform", "rotate", "scale",    "translate", "animation",
                                           "offset",    "mask-",  "backdrop", "background"};
    const bat_svg_name what = bat_svg_name_of(name);
    bool seen = what == BAT_SVG_ATTRIBUTE || (what < BAT_SVG_IDLE && may_be_value(value, size));
    for (size_t i = 0; i < sizeof painting / sizeof *painting; i++)
        seen = seen || strncmp(name, painting[i], strlen(painting[i])) == 0;
    style->odd |= seen ? BAT_SVG_BIT(BAT_SVG_ODD_VALUE) : BAT_SVG_BIT(BAT_SVG_ODD_UNKNOWN);
}

/* Where the element is: from..to may be of any length. True: the property is one of those. */
static bool declare_place(bat_svg_style *style, const char *name, const char *from, const char *to,
                          bool important) {
    const bat_svg_geometry property = bat_svg_geometry_of(name);
    if (property == BAT_SVG_GEOMETRY_COUNT) return false;
    const char *mark = memchr(from, '!', (size_t)(to - from));
    if (important != (mark != NULL)) return true;
    if (mark) to = mark;
    while (from < to && is_space(*from)) from++;
    const bool means = resolve(style, &from, &to);
    if (means && !bat_svg_geometry_set(style, property, from, (size_t)(to - from), important))
        bat_svg_style_miss(style, name, from, (size_t)(to - from));
    return true;
}

void bat_svg_style_declarations(bat_svg_style *style, const bat_svg_style *parent, double diagonal,
                                const char *text, size_t size, bool important) {
    for (const char *at = text, *end = text + size; at < end;) {
        const char *stop = declaration_end(at, end), *colon = colon_in(at, stop);
        char name[32], value[VALUE_MAX]; /* anything longer is not supported */
        while (at < stop && is_space(*at)) at++;
        if (is_variable(at, stop)) {
            at = stop < end ? stop + 1 : end;
            continue;
        }
        bool named = colon && copy_trimmed(at, colon, name, sizeof name);
        bool known = !colon || (named && name[0] == '-'); /* neither has any effect here */
        bool marked = false;
        if (named && declare_place(style, name, colon + 1, stop, important)) {
            at = stop < end ? stop + 1 : end;
            continue;
        }
        if (named && copy_trimmed(colon + 1, stop, value, sizeof value)) {
            const char *source = colon + 1;
            while (is_space(*source)) source++;
            char *mark = strchr(value, '!');
            marked = mark != NULL;
            if (mark) {
                while (mark > value && is_space(mark[-1])) mark--;
                *mark = '\0';
            }
            known = marked != important ||
                    bat_svg_style_set(style, parent, diagonal, bat_svg_name_of(name), value, source);
        }
        if (!known && named)
            bat_svg_style_miss(style, name, colon + 1, (size_t)(stop - colon - 1));
        else if (!known)
            style->odd |= BAT_SVG_BIT(BAT_SVG_ODD_UNKNOWN);
        at = stop < end ? stop + 1 : end;
    }
}
