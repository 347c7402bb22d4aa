/* The style of an element, from its attributes, the style sheets and its style attribute, in the order of CSS. */
#include "format/svg/walk.h"

#include <math.h>
#include <string.h>

/* sqrt((w^2 + h^2) / 2), to which percentages refer that belong to neither axis. */
static double diagonal(const bat_svg_scope *s) {
    return sqrt((s->width * s->width + s->height * s->height) / 2);
}

static void match_rules(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bool important,
                        bat_svg_style *style) {
    const char *id = bat_svg_attribute_of(w, element, "id"),
               *classes = bat_svg_attribute_of(w, element, "class");
    const char *type = bat_svg_tree_name(w->tree, element);
    size_t i = 0;
    while ((i = bat_svg_sheet_next(w->sheet, type, id, classes, i)) < w->sheet->count) {
        const bat_svg_rule *rule = &w->sheet->rules[i++];
        w->tried++;
        if (bat_svg_rule_matches(w->sheet, rule, type, id, classes))
            bat_svg_style_declarations(style, &outer->style, diagonal(outer), w->sheet->text + rule->body,
                                       rule->body_size, important);
    }
    w->tried++;
}

/* The cascade: attributes, sheets, style="", then the !important declarations of the latter two. */
void bat_svg_cascade(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_style *style) {
    *style = bat_svg_style_child(&outer->style);
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *own = bat_svg_attribute_of(w, element, "style");
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *value = strings + pair[1];
        bat_svg_name name = bat_svg_name_of(strings + pair[0]);
        if (name < BAT_SVG_IDLE &&
            !bat_svg_style_set(style, &outer->style, diagonal(outer), name, value, value))
            style->odd |= BAT_SVG_BIT(BAT_SVG_ODD_UNKNOWN);
    }
    match_rules(w, element, outer, false, style);
    if (own) bat_svg_style_declarations(style, &outer->style, diagonal(outer), own, strlen(own), false);
    match_rules(w, element, outer, true, style);
    if (own) bat_svg_style_declarations(style, &outer->style, diagonal(outer), own, strlen(own), true);
}

void bat_svg_cascade_in_place(bat_svg_walk *w, uint32_t element, bat_svg_scope *s) {
    uint32_t way[BAT_SVG_DEPTH];
    int depth = 0;
    s->style = bat_svg_style_initial();
    for (uint32_t at = element; at; at = w->tree->elements[at].parent) way[depth++] = at;
    while (depth > 0) {
        bat_svg_style style;
        bat_svg_cascade(w, way[--depth], s, &style);
        s->style = style;
    }
}
