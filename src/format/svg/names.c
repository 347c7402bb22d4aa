#include "format/svg/names.h"

#include <string.h>

/* Sorted by their bytes. Names for text, gradients and filters that are not in the table begin with one of
 * `idle`. */
static const struct {
    char name[28];
    uint8_t what; /* bat_svg_name */
} names[] = {
    {"alignment-baseline", BAT_SVG_BASELINE},
    {"autofocus", BAT_SVG_SPOKEN},
    {"baseProfile", BAT_SVG_ATTRIBUTE},
    {"class", BAT_SVG_ATTRIBUTE},
    {"clip", BAT_SVG_IDLE},
    {"clip-path", BAT_SVG_CLIP},
    {"clip-rule", BAT_SVG_CLIP_RULE},
    {"color", BAT_SVG_COLOUR},
    {"color-interpolation", BAT_SVG_INTERPOLATION},
    {"color-interpolation-filters", BAT_SVG_IDLE},
    {"color-profile", BAT_SVG_IDLE},
    {"color-rendering", BAT_SVG_COLOUR_HINT},
    {"contentScriptType", BAT_SVG_ATTRIBUTE},
    {"contentStyleType", BAT_SVG_ATTRIBUTE},
    {"crossorigin", BAT_SVG_ATTRIBUTE},
    {"cursor", BAT_SVG_IDLE},
    {"cx", BAT_SVG_ATTRIBUTE},
    {"cy", BAT_SVG_ATTRIBUTE},
    {"d", BAT_SVG_ATTRIBUTE},
    {"data-box", BAT_SVG_ATTRIBUTE},
    {"data-line", BAT_SVG_ATTRIBUTE},
    {"data-locked", BAT_SVG_ATTRIBUTE},
    {"data-name", BAT_SVG_ATTRIBUTE},
    {"decoding", BAT_SVG_ATTRIBUTE},
    {"direction", BAT_SVG_IDLE},
    {"display", BAT_SVG_DISPLAY},
    {"dominant-baseline", BAT_SVG_BASELINE},
    {"download", BAT_SVG_ATTRIBUTE},
    {"enable-background", BAT_SVG_IDLE},
    {"externalResourcesRequired", BAT_SVG_ATTRIBUTE},
    {"fill", BAT_SVG_FILL},
    {"fill-opacity", BAT_SVG_FILL_OPACITY},
    {"fill-rule", BAT_SVG_RULE},
    {"filter", BAT_SVG_FILTER},
    {"focusable", BAT_SVG_SPOKEN},
    {"font", BAT_SVG_FONT},
    {"font-size", BAT_SVG_FONT_SIZE},
    {"height", BAT_SVG_ATTRIBUTE},
    {"href", BAT_SVG_ATTRIBUTE},
    {"hreflang", BAT_SVG_ATTRIBUTE},
    {"id", BAT_SVG_ATTRIBUTE},
    {"image-rendering", BAT_SVG_IMAGE_HINT},
    {"inkscape:groupmode", BAT_SVG_ATTRIBUTE},
    {"inkscape:label", BAT_SVG_ATTRIBUTE},
    {"inline-size", BAT_SVG_IDLE},
    {"isolation", BAT_SVG_ISOLATION},
    {"kerning", BAT_SVG_IDLE},
    {"lang", BAT_SVG_SPOKEN},
    {"lighting-color", BAT_SVG_IDLE},
    {"marker", BAT_SVG_MARKER},
    {"marker-end", BAT_SVG_MARKER_END},
    {"marker-mid", BAT_SVG_MARKER_MID},
    {"marker-start", BAT_SVG_MARKER_START},
    {"mask", BAT_SVG_MASK},
    {"mix-blend-mode", BAT_SVG_BLEND},
    {"opacity", BAT_SVG_OPACITY},
    {"overflow", BAT_SVG_OVERFLOW},
    {"paint-order", BAT_SVG_ORDER},
    {"ping", BAT_SVG_ATTRIBUTE},
    {"pointer-events", BAT_SVG_IDLE},
    {"points", BAT_SVG_ATTRIBUTE},
    {"preserveAspectRatio", BAT_SVG_ATTRIBUTE},
    {"r", BAT_SVG_ATTRIBUTE},
    {"referrerpolicy", BAT_SVG_ATTRIBUTE},
    {"rel", BAT_SVG_ATTRIBUTE},
    {"requiredExtensions", BAT_SVG_ATTRIBUTE},
    {"requiredFeatures", BAT_SVG_ATTRIBUTE},
    {"role", BAT_SVG_SPOKEN},
    {"rx", BAT_SVG_ATTRIBUTE},
    {"ry", BAT_SVG_ATTRIBUTE},
    {"shape-inside", BAT_SVG_IDLE},
    {"shape-margin", BAT_SVG_IDLE},
    {"shape-padding", BAT_SVG_IDLE},
    {"shape-rendering", BAT_SVG_SHAPE_HINT},
    {"shape-subtract", BAT_SVG_IDLE},
    {"sodipodi:insensitive", BAT_SVG_ATTRIBUTE},
    {"space", BAT_SVG_ATTRIBUTE},
    {"stop-color", BAT_SVG_STOP_COLOUR},
    {"stop-opacity", BAT_SVG_STOP_OPACITY},
    {"stroke", BAT_SVG_STROKE},
    {"stroke-dasharray", BAT_SVG_DASHES},
    {"stroke-dashoffset", BAT_SVG_DASH_OFFSET},
    {"stroke-linecap", BAT_SVG_CAP},
    {"stroke-linejoin", BAT_SVG_JOIN},
    {"stroke-miterlimit", BAT_SVG_MITER},
    {"stroke-opacity", BAT_SVG_STROKE_OPACITY},
    {"stroke-width", BAT_SVG_WIDTH},
    {"style", BAT_SVG_ATTRIBUTE},
    {"systemLanguage", BAT_SVG_ATTRIBUTE},
    {"tabindex", BAT_SVG_SPOKEN},
    {"target", BAT_SVG_ATTRIBUTE},
    {"text-anchor", BAT_SVG_ANCHOR},
    {"transform", BAT_SVG_ATTRIBUTE},
    {"transform-origin", BAT_SVG_ATTRIBUTE},
    {"type", BAT_SVG_ATTRIBUTE},
    {"unicode-bidi", BAT_SVG_IDLE},
    {"vector-effect", BAT_SVG_EFFECT},
    {"version", BAT_SVG_ATTRIBUTE},
    {"viewBox", BAT_SVG_ATTRIBUTE},
    {"visibility", BAT_SVG_VISIBILITY},
    {"white-space", BAT_SVG_IDLE},
    {"width", BAT_SVG_ATTRIBUTE},
    {"writing-mode", BAT_SVG_WRITING},
    {"x", BAT_SVG_ATTRIBUTE},
    {"x1", BAT_SVG_ATTRIBUTE},
    {"x2", BAT_SVG_ATTRIBUTE},
    {"xlink:actuate", BAT_SVG_ATTRIBUTE},
    {"xlink:arcrole", BAT_SVG_ATTRIBUTE},
    {"xlink:href", BAT_SVG_ATTRIBUTE},
    {"xlink:role", BAT_SVG_ATTRIBUTE},
    {"xlink:show", BAT_SVG_ATTRIBUTE},
    {"xlink:title", BAT_SVG_SPOKEN},
    {"xlink:type", BAT_SVG_ATTRIBUTE},
    {"xml:lang", BAT_SVG_SPOKEN},
    {"xml:space", BAT_SVG_ATTRIBUTE},
    {"xmlns", BAT_SVG_ATTRIBUTE},
    {"y", BAT_SVG_ATTRIBUTE},
    {"y1", BAT_SVG_ATTRIBUTE},
    {"y2", BAT_SVG_ATTRIBUTE},
    {"zoomAndPan", BAT_SVG_ATTRIBUTE},
};

/* Prefixes of properties that change no shape, and of properties private to other programs. */
static const char *const idle[] = {"font",  "text-",  "glyph-", "letter-",   "word-", "line-",
                                   "stop-", "flood-", "solid-", "baseline-", "-"};

static bool begins(const char *name, const char *with) { return strncmp(name, with, strlen(with)) == 0; }

bat_svg_name bat_svg_name_of(const char *name) {
    size_t low = 0, high = sizeof names / sizeof *names;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = strcmp(name, names[middle].name);
        if (order == 0) return (bat_svg_name)names[middle].what;
        if (order < 0)
            high = middle;
        else
            low = middle + 1;
    }
    for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
        if (begins(name, idle[i])) return BAT_SVG_IDLE;
    return BAT_SVG_NAMELESS;
}

bat_loss bat_svg_odd_loss(int bit) {
    static const uint8_t losses[BAT_SVG_ODD_END - BAT_SVG_ODD] = {
        [BAT_SVG_DASHES - BAT_SVG_ODD] = BAT_LOSS_DASH,
        [BAT_SVG_ORDER - BAT_SVG_ODD] = BAT_LOSS_ORDER,
        [BAT_SVG_MARKER_START - BAT_SVG_ODD] = BAT_LOSS_MARKER,
        [BAT_SVG_MARKER_MID - BAT_SVG_ODD] = BAT_LOSS_MARKER,
        [BAT_SVG_MARKER_END - BAT_SVG_ODD] = BAT_LOSS_MARKER,
        [BAT_SVG_SHAPE_HINT - BAT_SVG_ODD] = BAT_LOSS_HINT,
        [BAT_SVG_COLOUR_HINT - BAT_SVG_ODD] = BAT_LOSS_HINT,
        [BAT_SVG_INTERPOLATION - BAT_SVG_ODD] = BAT_LOSS_HINT,
        [BAT_SVG_IMAGE_HINT - BAT_SVG_ODD] = BAT_LOSS_HINT,
        [BAT_SVG_CLIP - BAT_SVG_ODD] = BAT_LOSS_CLIP,
        [BAT_SVG_MASK - BAT_SVG_ODD] = BAT_LOSS_MASK,
        [BAT_SVG_FILTER - BAT_SVG_ODD] = BAT_LOSS_FILTER,
        [BAT_SVG_EFFECT - BAT_SVG_ODD] = BAT_LOSS_EFFECT,
        [BAT_SVG_BLEND - BAT_SVG_ODD] = BAT_LOSS_BLEND,
        [BAT_SVG_ISOLATION - BAT_SVG_ODD] = BAT_LOSS_UNKNOWN, /* what blends within it is noted there */
        [BAT_SVG_ODD_UNKNOWN - BAT_SVG_ODD] = BAT_LOSS_UNKNOWN,
        [BAT_SVG_ODD_VALUE - BAT_SVG_ODD] = BAT_LOSS_BROKEN,
    };
    return bit < BAT_SVG_ODD_END - BAT_SVG_ODD ? (bat_loss)losses[bit] : BAT_LOSS_COUNT;
}

bat_loss bat_svg_attribute_loss(bat_svg_name what, const char *name) {
    if (what == BAT_SVG_SPOKEN || begins(name, "aria-")) return BAT_LOSS_TITLE;
    if (what != BAT_SVG_NAMELESS || begins(name, "xmlns:")) return BAT_LOSS_COUNT;
    if (begins(name, "on")) return BAT_LOSS_SCRIPT;
    return begins(name, "data-") || strchr(name, ':') ? BAT_LOSS_FOREIGN : BAT_LOSS_UNKNOWN;
}
