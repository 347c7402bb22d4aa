/* Where a text lies, as far as it can be known without its font. */
#include "format/svg/alone.h"

#include "format/svg/svg.h"
#include "text/number.h"
#include "text/utf8.h"

#include <math.h>
#include <string.h>

enum { OPEN_MAX = 16 };

/* Advances of wide fonts, in parts of the font's size. */
static const double NARROW = 0.42, MIDDLE = 0.68, WIDE = 0.85, WIDEST = 1.1;
static const double UP = 1.15, DOWN = 0.45; /* from the base line */

typedef struct line {
    double box[4];
    double x, y;   /* where the next character stands */
    double from;   /* where this chunk of text began */
    double around; /* how far it may reach aside, whatever its direction */
    bool any, space;
} line;

static double advance(uint32_t code) {
    if (code >= 0x80) return code >= 0x1100 ? WIDEST : WIDE;
    if (strchr(" ijlI|.,:;'!()[]tfr", (int)code)) return NARROW;
    if (strchr("mwMW@%", (int)code)) return WIDEST;
    return code >= 'A' && code <= 'Z' ? WIDE : MIDDLE;
}

static void widen(line *l, double x, double y, double size) {
    l->box[0] = fmin(l->box[0], x), l->box[2] = fmax(l->box[2], x);
    l->box[1] = fmin(l->box[1], y - UP * size), l->box[3] = fmax(l->box[3], y + DOWN * size);
}

/* The first number of a list; the sum of the others' sizes is of no interest. */
static bool first_of(const bat_svg_walk *w, uint32_t element, const char *name, double whole, double *value) {
    const char *text = bat_svg_attribute_of(w, element, name);
    char word[32];
    if (!text) return false;
    text += strspn(text, " \t\r\n,");
    const size_t size = strcspn(text, " \t\r\n,");
    if (size == 0 || size >= sizeof word) return false;
    memcpy(word, text, size);
    word[size] = '\0';
    return bat_svg_length(word, whole, value);
}

/* Every x of a list, where each character has its own. */
static void widen_list(const bat_svg_walk *w, uint32_t element, double size, line *l) {
    const char *text = bat_svg_attribute_of(w, element, "x"), *end = text ? text + strlen(text) : NULL;
    double value;
    while (text && text < end) {
        const char *next = bat_number_scan(text, end, &value);
        if (next && isfinite(value)) {
            widen(l, value, l->y, size);
            widen(l, value + size, l->y, size);
        }
        text = next ? next : text + 1;
    }
}

static void begin(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, line *l) {
    double value;
    if (first_of(w, element, "x", s->width, &value)) l->x = l->from = value;
    if (first_of(w, element, "y", s->height, &value)) l->y = value;
    if (first_of(w, element, "dx", s->width, &value)) l->x += value;
    if (first_of(w, element, "dy", s->height, &value)) l->y += value;
    widen_list(w, element, s->style.font_size, l);
}

static void add(line *l, const char *text, size_t size, const bat_svg_style *style) {
    double width = 0;
    for (size_t i = 0; i < size;) {
        uint32_t code = 0;
        const int length = bat_utf8_decode(text + i, size - i, &code);
        const bool space = code == ' ' || code == '\n' || code == '\t' || code == '\r';
        if (!(space && l->space)) width += advance(space ? ' ' : code) * style->font_size;
        l->space = space;
        i += length > 0 ? (size_t)length : 1;
    }
    if (!(width > 0)) return;
    const double back = style->anchor == 1 ? 0.5 : style->anchor == 2 ? 1 : 0;
    l->x += width;
    l->around += width;
    widen(l, l->from - back * (l->x - l->from), l->y, style->font_size);
    widen(l, l->x - back * (l->x - l->from), l->y, style->font_size);
    l->any = true;
}

/* Where a text on a path may lie. */
static void along(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, line *l) {
    const char *href = bat_svg_find_href(w, element);
    const uint32_t path = href ? bat_svg_tree_refer(w->tree, href) : 0;
    const char *data = path ? bat_svg_attribute_of(w, path, "d") : NULL;
    double box[4];
    bat_outline_clear(&w->outline);
    if (!data || !bat_svg_path(data, strlen(data), &w->outline) || w->outline.subpath_count == 0) return;
    bat_outline_box(&w->outline, box);
    const double more = 1.5 * s->style.font_size;
    widen(l, box[0] - more, box[1], more);
    widen(l, box[2] + more, box[3] + more, more);
    l->x = l->from = box[0], l->y = box[1];
}

bool bat_svg_is_blank(const bat_svg_walk *w, uint32_t element) {
    const bat_svg_tag *tag = w->text ? &w->tags.list[element] : NULL;
    for (size_t at = tag ? tag->body : 0, from = at; tag && from < tag->close; from = at) {
        const bat_svg_token token = bat_svg_next_token(w->text, tag->close, &at);
        if (token == BAT_SVG_LAST_TOKEN || at <= from) break;
        if (token != BAT_SVG_TEXT_TOKEN && token != BAT_SVG_PLAIN_TOKEN) continue;
        for (size_t i = from; i < at; i++)
            if (!strchr(" \t\r\n", w->text[i])) return false;
    }
    return tag != NULL;
}

bool bat_svg_text_box(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, double box[4]) {
    const bat_svg_tag *tag = &w->tags.list[element];
    bat_svg_scope open[OPEN_MAX];
    line l = {.box = {INFINITY, INFINITY, -INFINITY, -INFINITY}, .space = true};
    uint32_t next = element;
    int depth = 0;
    bool turned = false;
    open[0] = *s;
    begin(w, element, s, &l);
    for (size_t at = tag->body, from = at; from < tag->close; from = at) {
        const bat_svg_token token = bat_svg_next_token(w->text, tag->close, &at);
        const bat_svg_scope *outer = &open[depth < OPEN_MAX ? depth : OPEN_MAX - 1];
        if (token == BAT_SVG_LAST_TOKEN || at <= from) break;
        if (token == BAT_SVG_TEXT_TOKEN || token == BAT_SVG_PLAIN_TOKEN)
            add(&l, w->text + from, at - from, &outer->style);
        if (token == BAT_SVG_START_TOKEN || token == BAT_SVG_EMPTY_TOKEN) {
            bat_svg_scope inner = *outer;
            bat_svg_cascade(w, ++next, outer, &inner.style);
            begin(w, next, &inner, &l);
            turned = turned || bat_svg_attribute_of(w, next, "rotate");
            if (strcmp(bat_svg_tree_name(w->tree, next), "textPath") == 0) along(w, next, &inner, &l);
            if (token == BAT_SVG_START_TOKEN && ++depth < OPEN_MAX) open[depth] = inner;
        }
        if (token == BAT_SVG_END_TOKEN) depth -= depth > 0;
    }
    turned = turned || bat_svg_attribute_of(w, element, "rotate") || s->style.vertical;
    const double more = turned ? l.around : 0, size = s->style.font_size;
    for (int i = 0; i < 4; i++)
        box[i] = l.box[i] + (i < 2 ? -more : more) + (i == 0 ? -0.1 : i == 2 ? 0.1 : 0) * size;
    if (s->style.base) box[1] -= size, box[3] += size;
    return l.any && box[0] < box[2] && box[1] < box[3];
}
