/* Losses from elements that are drawn. */
#include "format/svg/walk.h"

#include <string.h>

/* Notes what is lost from an element, apart from its style. */
void bat_svg_note_element(bat_svg_walk *w, uint32_t element) {
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *name = bat_svg_tree_name(w->tree, element);
    if (!bat_svg_note_once(&w->notes, element)) return;
    const bool whole = e->kind == BAT_SVG_TEXT ||
                       e->kind == BAT_SVG_OTHER; /* noted where they are not shown */
    if (whole) return;
    bat_svg_note(&w->notes, element, (bat_loss)e->loss);
    if (e->kind == BAT_SVG_ROOT && element != 1) bat_svg_note(&w->notes, element, BAT_LOSS_NESTED);
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        bat_svg_name what = bat_svg_name_of(strings + pair[0]);
        if (what > BAT_SVG_IDLE)
            bat_svg_note(&w->notes, element, bat_svg_attribute_loss(what, strings + pair[0]));
        if (strcmp(name, "a") == 0 && strstr(strings + pair[0], "href"))
            bat_svg_note(&w->notes, element, BAT_LOSS_LINK);
    }
    if (e->kind != BAT_SVG_ROOT && e->kind != BAT_SVG_GROUP && e->kind != BAT_SVG_SWITCH)
        bat_svg_note_inside(&w->notes, element);
}

/* Notes what is lost from a style at this element, of the properties that are not inherited. */
void bat_svg_note_own_style(bat_svg_walk *w, uint32_t element, const bat_svg_style *style) {
    bat_svg_note_odd(&w->notes, element, style->odd, ~(BAT_SVG_INHERITED | BAT_SVG_BIT(BAT_SVG_EFFECT)));
}

/* Notes what is lost from a shape's style, as far as it would be visible. */
void bat_svg_note_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                        const bat_svg_painted *painted) {
    const bat_style *style = &painted->style;
    uint32_t odd = s->style.odd, mask = BAT_SVG_INHERITED & ~BAT_SVG_BIT(BAT_SVG_IMAGE_HINT);
    if (style->stroked) mask |= BAT_SVG_BIT(BAT_SVG_EFFECT);
    if (!style->stroked || painted->paint.dash_count) mask &= ~BAT_SVG_BIT(BAT_SVG_DASHES);
    bat_svg_note_odd(&w->notes, element, odd, mask);
}
