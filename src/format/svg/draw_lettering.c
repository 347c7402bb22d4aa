/* A text element that is lettering as this program writes it (bat_lettering_markup) becomes a text again. */
#include "document/lettering.h"
#include "format/svg/digest.h"
#include "format/svg/svg.h"
#include "format/svg/walk.h"
#include "text/entities.h"
#include "text/number.h"

#include <math.h>
#include <string.h>

static bool read_box(const char *text, double box[4]) {
    const char *end = text ? text + strlen(text) : NULL;
    for (int i = 0; i < 4 && text; i++) {
        while (text < end && *text == ' ') text++;
        text = text < end ? bat_number_scan(text, end, &box[i]) : NULL;
    }
    return text && text == end;
}

static bool is_said(const bat_svg_walk *w, uint32_t element, const char *name, const char *value) {
    const char *said = bat_svg_attribute_of(w, element, name);
    return said && strcmp(said, value) == 0;
}

/* One that says more is foreign content, so that nothing of it is lost. */
static bool read_look(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, bat_lettering *l) {
    static const char *const known[] = {"x",
                                        "y",
                                        "font-family",
                                        "font-size",
                                        "font-weight",
                                        "font-style",
                                        "letter-spacing",
                                        "fill",
                                        "opacity",
                                        "text-anchor",
                                        "transform",
                                        "id",
                                        "data-name",
                                        "inkscape:label",
                                        "data-line",
                                        "data-box",
                                        "fill-opacity",
                                        "xml:space",
                                        "data-locked",
                                        "display",
                                        "sodipodi:insensitive",
                                        NULL};
    const char *weight = bat_svg_attribute_of(w, element, "font-weight"),
               *line = bat_svg_attribute_of(w, element, "data-line");
    if (bat_svg_says_more(w->tree, element, known) || !is_said(w, element, "xml:space", "preserve"))
        return false;
    if (!read_box(bat_svg_attribute_of(w, element, "data-box"), l->box)) return false;
    if (!line || bat_number_scan(line, line + strlen(line), &l->line) != line + strlen(line)) return false;
    if (weight && bat_number_scan(weight, weight + strlen(weight), &l->weight) != weight + strlen(weight))
        return false;
    l->family = bat_svg_attribute_of(w, element, "font-family");
    l->size = bat_svg_length_of(w, element, "font-size", 0, 0);
    l->italic = is_said(w, element, "font-style", "italic");
    l->spacing = bat_svg_length_of(w, element, "letter-spacing", 0, 0);
    l->align = (bat_align)s->style.anchor;
    l->at[0] = bat_svg_length_of(w, element, "x", s->width, 0);
    l->at[1] = bat_svg_length_of(w, element, "y", s->height, 0);
    return l->family && *l->family;
}

/* A line in an element of its own must stand where it would be put. */
static bool is_line(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const bat_lettering *l,
                    int number) {
    static const char *const known[] = {"x", "y", NULL};
    const double x = bat_svg_length_of(w, element, "x", s->width, NAN),
                 y = bat_svg_length_of(w, element, "y", s->height, NAN), by = 1e-6 * l->size;
    return strcmp(bat_svg_tree_name(w->tree, element), "tspan") == 0 &&
           !bat_svg_says_more(w->tree, element, known) && fabs(x - l->at[0]) <= by &&
           fabs(y - l->at[1] - number * (l->line * l->size)) <= by;
}

/* What it says, zero-terminated. */
static bool read_content(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                         const bat_lettering *l, bat_text *out) {
    const bat_svg_tag *tag = &w->tags.list[element];
    uint32_t next = element;
    int depth = 0, lines = 0;
    bool loose = false; /* something is said outside of lines */
    for (size_t at = tag->body, from = at; from < tag->close; from = at) {
        const bat_svg_token token = bat_svg_next_token(w->text, tag->close, &at);
        if (token == BAT_SVG_TEXT_TOKEN) {
            if (!bat_xml_decode(w->text + from, at - from, NULL, 0, false, out)) return false;
            loose = loose || depth == 0;
        } else if (token == BAT_SVG_START_TOKEN || token == BAT_SVG_EMPTY_TOKEN) {
            if (depth > 0 || !is_line(w, ++next, s, l, lines)) return false;
            if (lines++ > 0) bat_text_string(out, "\n");
            depth += token == BAT_SVG_START_TOKEN;
        } else if (token == BAT_SVG_END_TOKEN) {
            depth--;
        } else {
            return false;
        }
    }
    bat_text_add(out, "", 1);
    return !out->failed && !(loose && lines) && (lines || !strchr(out->data, '\n'));
}

bool bat_svg_draw_lettering(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const bat_svg_paint *fill = &s->style.fill;
    bat_lettering l = bat_lettering_defaults();
    bat_text content = {0};
    bat_object *object = NULL;
    if (w->sheet->count || s->clip || s->boxed || s->mask || fill->kind != BAT_PAINT_COLOUR || fill->server ||
        s->style.stroke.kind != BAT_PAINT_NONE || s->style.stroke.server ||
        s->style.odd & (BAT_SVG_BIT(BAT_SVG_FILTER) | BAT_SVG_BIT(BAT_SVG_BLEND)) ||
        !read_look(w, element, s, &l) || !read_content(w, element, s, &l, &content)) {
        const bool failed = content.failed;
        if (failed) w->status = BAT_MEMORY;
        bat_text_free(&content);
        return failed;
    }
    l.content = content.data;
    const double alpha = floor((fill->colour & 255) * s->style.fill_opacity + 0.5);
    const bat_status status = bat_object_create_text(
        bat_document_new_id(w->document), bat_svg_find_name(w, element), &l, s->matrix,
        (fill->colour & 0xffffff00) | (uint32_t)alpha, s->opacity, &object);
    bat_text_free(&content);
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK) return status == BAT_MEMORY;
    if (w->unseen)
        w->report->hidden++;
    else
        w->digest = bat_svg_digest_image(w->digest, bat_object_picture(object), bat_object_matrix(object),
                                         s->opacity);
    bat_svg_put_object(w, element, s->style.shown, object);
    return true;
}
