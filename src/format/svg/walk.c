/* Functions used by every part of the walk through a drawing. */
#include "format/svg/svg.h"
#include "format/svg/walk.h"

double bat_svg_length_of(const bat_svg_walk *w, uint32_t element, const char *name, double whole,
                         double otherwise) {
    const char *text = bat_svg_attribute_of(w, element, name);
    double value;
    return text && bat_svg_length(text, whole, &value) ? value : otherwise;
}

/* SVG 2 first, then the attribute of older files. */
const char *bat_svg_find_href(const bat_svg_walk *w, uint32_t element) {
    const char *href = bat_svg_attribute_of(w, element, "href");
    return href ? href : bat_svg_attribute_of(w, element, "xlink:href");
}

void bat_svg_draw_children(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    for (uint32_t at = w->tree->elements[element].first; at && w->status == BAT_OK;
         at = w->tree->elements[at].next)
        w->draw(w, at, s);
}
