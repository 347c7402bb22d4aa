/* Functions used by every part of the walk through a drawing. */
#include "document/document.h"
#include "document/kind.h"
#include "format/svg/svg.h"
#include "format/svg/walk.h"
#include "text/utf8.h"

#include <string.h>

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

/* ---- into the document ---- */

/* Labels are meant for people; ids often are not. */
const char *bat_svg_find_name(const bat_svg_walk *w, uint32_t element) {
    static const char *const names[] = {"data-name", "inkscape:label", "id"};
    for (int i = 0; i < 3; i++) {
        const char *name = bat_svg_attribute_of(w, element, names[i]);
        if (name && bat_utf8_valid(name, strlen(name))) return name;
    }
    return "";
}

void bat_svg_put_object(bat_svg_walk *w, uint32_t element, bool shown, bat_object *object) {
    const char *locked = bat_svg_attribute_of(w, element, "data-locked"),
               *insensitive = bat_svg_attribute_of(w, element, "sodipodi:insensitive");
    bool lock = (locked && !strcmp(locked, "true")) || (insensitive && !strcmp(insensitive, "true"));
    bat_object *placed = NULL;
    bat_status status = BAT_OK;
    if (w->group && (status = bat_object_with_parent(object, w->group, &placed)) == BAT_OK) {
        bat_object_release(object);
        object = placed;
    }
    if (status == BAT_OK && (lock || !shown) &&
        (status = bat_object_with_state(object, !shown, lock, &placed)) == BAT_OK) {
        bat_object_release(object);
        object = placed;
    }
    if (status == BAT_OK) status = bat_document_insert(w->document, bat_document_count(w->document), object);
    if (status == BAT_OK && bat_object_is_drawn(object)) w->put++;
    if (status == BAT_OK) bat_svg_place_object(w, object);
    bat_object_release(object);
    if (status == BAT_OK) w->members++;
    if (status == BAT_MEMORY || status == BAT_COUNT) w->status = status;
}
