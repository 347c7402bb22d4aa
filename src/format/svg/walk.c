/* Functions used by every part of the walk through a drawing. */
#include "document/document.h"
#include "document/kind.h"
#include "format/svg/digest.h"
#include "format/svg/svg.h"
#include "format/svg/walk.h"
#include "text/base64.h"
#include "text/utf8.h"

#include <math.h>
#include <string.h>

double bat_svg_length_of(const bat_svg_walk *w, uint32_t element, const char *name, double whole,
                         double otherwise) {
    const char *text = bat_svg_attribute_of(w, element, name);
    double value;
    return text && bat_svg_length(text, whole, &value) ? value : otherwise;
}

/* SVG 2 first, then the attribute of older files, by whatever prefix they call the namespace of XLink. */
const char *bat_svg_find_href(const bat_svg_walk *w, uint32_t element) {
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *found = NULL;
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *name = strings + pair[0], *colon = strchr(name, ':');
        if (strcmp(name, "href") == 0) return strings + pair[1];
        if (!found && colon && strcmp(colon, ":href") == 0) found = strings + pair[1];
    }
    return found;
}

bat_picture *bat_svg_find_picture(bat_svg_walk *w, uint32_t element) {
    const char *href = bat_svg_find_href(w, element);
    const char *data = href && !strncmp(href, "data:", 5) ? strchr(href, ',') : NULL;
    bat_picture *picture = NULL;
    if (!data || data - href < 7 || memcmp(data - 7, ";base64", 7) != 0) return NULL;
    bat_status status = bat_picture_from_base64(data + 1, strlen(data + 1), &picture);
    if (status == BAT_OK) status = bat_pictures_add(&w->pictures, picture);
    if (status == BAT_MEMORY) w->status = status;
    if (status == BAT_OK) return picture;
    bat_picture_release(picture);
    return NULL;
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

/* ---- what is drawn in a marker: shapes, apart from the document ---- */

static bat_marker_ink ink_of(const bat_svg_paint *paint) {
    return paint->kind == BAT_PAINT_CONTEXT_FILL     ? BAT_INK_FILL
           : paint->kind == BAT_PAINT_CONTEXT_STROKE ? BAT_INK_STROKE
                                                     : BAT_INK_OWN;
}

void bat_svg_collect(bat_svg_walk *w, const bat_svg_scope *s, bat_object *object) {
    bat_svg_collected *to = w->collected;
    if (!s || !bat_object_is_made_of_curves(object) || to->count == BAT_MARKER_PARTS_MAX) {
        to->whole = false;
        bat_object_release(object);
        return;
    }
    w->digest = bat_svg_digest_inks(w->digest, ink_of(&s->style.fill), ink_of(&s->style.stroke));
    to->list[to->count++] = (bat_marker_part){object, ink_of(&s->style.fill), ink_of(&s->style.stroke)};
}

/* ---- objects ---- */

void bat_svg_put_object(bat_svg_walk *w, uint32_t element, bool shown, bat_object *object) {
    const char *locked = bat_svg_attribute_of(w, element, "data-locked"),
               *insensitive = bat_svg_attribute_of(w, element, "sodipodi:insensitive");
    bool lock = (locked && !strcmp(locked, "true")) || (insensitive && !strcmp(insensitive, "true"));
    bat_object *placed = NULL;
    bat_status status = BAT_OK;
    if (w->collected) {
        bat_svg_collect(w, NULL, object);
        return;
    }
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

/* ---- the style of an element, from its attributes, the style sheets and its style attribute, in the order of CSS ---- */

/* sqrt((w^2 + h^2) / 2), to which percentages refer that belong to neither axis. */
static double diagonal(const bat_svg_scope *s) {
    return sqrt((s->width * s->width + s->height * s->height) / 2);
}

/* What is taken from declarations. */
typedef enum taken { VARIABLES, NORMAL, IMPORTANT } taken;

static void declare(const bat_svg_scope *outer, const char *text, size_t size, taken what,
                    bat_svg_style *style) {
    if (what == VARIABLES)
        bat_svg_style_variables(style, text, size);
    else
        bat_svg_style_declarations(style, &outer->style, diagonal(outer), text, size, what == IMPORTANT);
}

/* Finds the rules that match, for declare_rules, and notes one that may. */
static void match_rules(bat_svg_walk *w, uint32_t element, bat_svg_style *style) {
    bat_svg_candidates *c = &w->candidates;
    const bat_status status = bat_svg_candidates_find(w->sheet, w->tree, element, c);
    size_t kept = 0;
    if (status != BAT_OK) w->status = status;
    for (size_t i = 0; i < c->count; i++) {
        const bat_svg_rule *rule = &w->sheet->rules[c->rules[i]];
        if (!bat_svg_rule_matches(w->sheet, rule, w->tree, element, &w->tried)) continue;
        if (rule->guess)
            style->odd |= BAT_SVG_BIT(BAT_SVG_ODD_VALUE);
        else
            c->rules[kept++] = c->rules[i];
    }
    c->count = kept;
    w->tried++;
}

static void declare_rules(const bat_svg_walk *w, const bat_svg_scope *outer, taken what,
                          bat_svg_style *style) {
    for (size_t i = 0; i < w->candidates.count; i++) {
        const bat_svg_rule *rule = &w->sheet->rules[w->candidates.rules[i]];
        declare(outer, w->sheet->text + rule->body, rule->body_size, what, style);
    }
}

/* The cascade: attributes, sheets, style="", then the !important declarations of the latter two. */
void bat_svg_cascade(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_style *style) {
    *style = bat_svg_style_child(&outer->style);
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *own = bat_svg_attribute_of(w, element, "style");
    match_rules(w, element, style);
    if (w->sheet->variables) declare_rules(w, outer, VARIABLES, style);
    if (own) bat_svg_style_variables(style, own, strlen(own));
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *value = strings + pair[1];
        bat_svg_name name = bat_svg_name_of(strings + pair[0]);
        if (name < BAT_SVG_IDLE &&
            !bat_svg_style_set(style, &outer->style, diagonal(outer), name, value, value))
            bat_svg_style_miss(style, strings + pair[0], value, strlen(value));
    }
    declare_rules(w, outer, NORMAL, style);
    if (own) declare(outer, own, strlen(own), NORMAL, style);
    if (w->sheet->important) declare_rules(w, outer, IMPORTANT, style);
    if (own) declare(outer, own, strlen(own), IMPORTANT, style);
    if (w->variables.failed) w->status = BAT_MEMORY;
}

void bat_svg_cascade_in_place(bat_svg_walk *w, uint32_t element, bat_svg_scope *s) {
    uint32_t way[BAT_SVG_DEPTH];
    int depth = 0;
    s->style = bat_svg_style_initial();
    s->style.store = &w->variables;
    for (uint32_t at = element; at; at = w->tree->elements[at].parent) way[depth++] = at;
    while (depth > 0) {
        bat_svg_style style;
        bat_svg_cascade(w, way[--depth], s, &style);
        s->style = style;
    }
}
