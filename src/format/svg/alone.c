#include "format/svg/alone.h"

#include "format/svg/svg.h"
#include "text/number.h"
#include "text/utf8.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, BYTES_MAX = 1 << 22, LISTED_MAX = 4096 };

static const char HEAD[] = "<svg xmlns=\"" BAT_SVG_NAMESPACE "\" width=\"", HEIGHT[] = "\" height=\"",
                  VIEW[] = "\" viewBox=\"";

/* ---- what it refers to ---- */

typedef struct needs {
    bat_svg_walk *w;
    uint32_t list[LISTED_MAX]; /* elements, in the order in which they were found */
    size_t count;
    bool full;
} needs;

static const bat_svg_tag *tag_of(const bat_svg_walk *w, uint32_t element) { return &w->tags.list[element]; }

static void need(needs *n, uint32_t element) {
    if (!element || n->w->stamps[element] == n->w->stamp) return;
    n->w->stamps[element] = n->w->stamp;
    n->full = n->full || n->count == LISTED_MAX;
    if (!n->full) n->list[n->count++] = element;
}

static void need_all(needs *n, const char *text) {
    while ((text = strstr(text, "url("))) {
        text += 4;
        need(n, bat_svg_tree_refer(n->w->tree, text));
    }
}

/* What the attributes of an element refer to. */
static void look(needs *n, uint32_t element) {
    const bat_svg_element *e = &n->w->tree->elements[element];
    const uint32_t *pair = n->w->tree->attributes + e->attributes;
    const char *strings = n->w->tree->strings.data;
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *name = strings + pair[0], *value = strings + pair[1];
        const size_t size = strlen(name);
        if (size >= 4 && strcmp(name + size - 4, "href") == 0)
            need(n, bat_svg_tree_refer(n->w->tree, value));
        else if (size > 1)
            need_all(n, value);
    }
}

static void look_within(needs *n, uint32_t element) {
    for (uint32_t i = element; i <= tag_of(n->w, element)->last; i++) look(n, i);
}

/* ---- writing ---- */

/* Whether all entities in it are those of every XML file. */
static bool is_plain(const char *text, size_t size) {
    static const char *const known[] = {"amp;", "lt;", "gt;", "quot;", "apos;", "#"};
    const char *end = text + size;
    while ((text = memchr(text, '&', (size_t)(end - text)))) {
        bool plain = false;
        text++;
        for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
            const size_t length = strlen(known[i]);
            plain = plain || ((size_t)(end - text) >= length && memcmp(text, known[i], length) == 0);
        }
        if (!plain) return false;
    }
    return true;
}

/* Copies the file's text; false: it has entities of its own. */
static bool copy(const bat_svg_walk *w, size_t from, size_t to, bat_text *out) {
    if (!is_plain(w->text + from, to - from)) return false;
    bat_text_add(out, w->text + from, to - from);
    return out->size <= BYTES_MAX;
}

/* The same for a start tag, which is shown here even if it is hidden. */
static bool copy_tag(const bat_svg_walk *w, uint32_t element, bat_text *out) {
    static const char *const hiding[] = {" display=\"none\"", " display='none'", "display:none"};
    const bat_svg_tag *tag = tag_of(w, element);
    for (size_t at = tag->open; at < tag->body;) {
        size_t next = tag->body, length = 0;
        for (size_t i = 0; i < sizeof hiding / sizeof *hiding; i++) {
            const size_t size = strlen(hiding[i]);
            for (size_t k = at; k + size <= tag->body && k < next; k++)
                if (memcmp(w->text + k, hiding[i], size) == 0) next = k, length = size;
        }
        if (!copy(w, at, next, out)) return false;
        at = next + length;
    }
    return true;
}

static unsigned given(const bat_svg_walk *w, uint32_t element) {
    for (int i = 0; i < w->depth; i++)
        if (w->active[i] == element) return w->given[i];
    return 0;
}

/* The same for a group of the document around it, which has the opacity and the clip path. */
static bool copy_bare(const bat_svg_walk *w, uint32_t element, unsigned without, bat_text *out) {
    const size_t from = out->size;
    if (!copy_tag(w, element, out) || out->failed) return false;
    bat_text tag = {0};
    bat_text_add(&tag, out->data + from, out->size - from);
    bool styled = false, good = !tag.failed;
    if (good) {
        bat_svg_piece piece;
        const size_t name = 1 + bat_svg_tag_name(tag.data, tag.size);
        size_t at = name;
        while (!styled && bat_svg_next_piece(tag.data, tag.size, &at, &piece))
            styled = piece.equal - piece.name == 5 && memcmp(tag.data + piece.name, "style", 5) == 0;
        const size_t put = styled ? piece.value : name;
        out->size = from + put;
        if (!styled) bat_text_string(out, " style=\"");
        if (without & BAT_SVG_ITS_OPACITY) bat_text_string(out, "opacity:1!important;");
        if (without & BAT_SVG_ITS_CLIP) bat_text_string(out, "clip-path:none!important;");
        if (!styled) bat_text_string(out, "\"");
        bat_text_add(out, tag.data + put, tag.size - put);
    }
    out->failed = out->failed || tag.failed;
    bat_text_free(&tag);
    return good;
}

static void write_numbers(const double *numbers, int count, bat_text *out) {
    for (int i = 0; i < count; i++) {
        if (i > 0) bat_text_string(out, " ");
        bat_text_number(out, numbers[i]);
    }
}

/* The root as an element within, with the same units. */
static void write_root(const bat_svg_walk *w, bat_text *out) {
    static const char *const own[] = {
        "x", "y", "width", "height", "viewBox", "xmlns", "version", "overflow", "preserveAspectRatio"};
    const bat_svg_element *e = &w->tree->elements[1];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data;
    const double page[4] = {w->page[0], w->page[1], w->page[2] > 0 ? w->page[2] : 100,
                            w->page[3] > 0 ? w->page[3] : 100};
    static const char *const names[] = {" x=\"", " y=\"", " width=\"", " height=\""};
    bat_text_string(out, "<svg");
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *name = strings + pair[0];
        bool taken = strncmp(name, "on", 2) == 0;
        for (size_t k = 0; k < sizeof own / sizeof *own; k++) taken = taken || strcmp(name, own[k]) == 0;
        if (taken) continue;
        bat_text_string(out, " ");
        bat_text_string(out, name);
        bat_text_string(out, "=\"");
        bat_text_xml(out, strings + pair[1], strlen(strings + pair[1]), true);
        bat_text_string(out, "\"");
    }
    for (int i = 0; i < 4; i++) {
        bat_text_string(out, names[i]);
        bat_text_number(out, page[i]);
        bat_text_string(out, "\"");
    }
    bat_text_string(out, VIEW + 1);
    write_numbers(page, 4, out);
    bat_text_string(out, "\" overflow=\"visible\">");
}

static bool write_definitions(needs *n, uint32_t element, bat_text *out) {
    const bat_svg_walk *w = n->w;
    const uint32_t last = tag_of(w, element)->last;
    bool good = !n->full;
    bat_text_string(out, "<defs>");
    for (size_t i = 0; i < n->count && good; i++) {
        const uint32_t own = n->list[i], end = tag_of(w, own)->last;
        if (own >= element && own <= last) continue;    /* it is there */
        if (own <= element && end >= element) continue; /* it would hold itself */
        good = copy(w, tag_of(w, own)->open, tag_of(w, own)->end, out);
    }
    bat_text_string(out, "</defs>");
    return good;
}

/* The elements around it, the element, and their ends. */
static bool write_way(const bat_svg_walk *w, uint32_t element, bat_text *out) {
    uint32_t way[BAT_SVG_DEPTH];
    int depth = 0;
    for (uint32_t at = element; at > 1 && depth < BAT_SVG_DEPTH; at = tag_of(w, at)->parent)
        way[depth++] = at;
    bool good = true;
    for (int i = depth - 1; i >= 0 && good; i--)
        good = i > 0 && given(w, way[i]) ? copy_bare(w, way[i], given(w, way[i]), out)
                                         : copy_tag(w, way[i], out);
    good = good && copy(w, tag_of(w, element)->body, tag_of(w, element)->close, out);
    for (int i = 0; i < depth && good; i++)
        good = copy(w, tag_of(w, way[i])->close, tag_of(w, way[i])->end, out);
    return good;
}

static bool write_sheets(const bat_svg_walk *w, bat_text *out) {
    bool good = true;
    for (uint32_t i = 0; i < w->style_count && good; i++)
        good = copy(w, tag_of(w, w->styles[i])->open, tag_of(w, w->styles[i])->end, out);
    return good;
}

/* Whole pixels that are a power of two of units: the box grows by less than one pixel. */
static bool write_head(const double box[4], bat_text *out) {
    const double width = box[2] - box[0], height = box[3] - box[1];
    int power;
    if (!(width > 0 && height > 0 && width < 1e30 && height < 1e30)) return false;
    frexp(SIDE / fmax(width, height), &power);
    const double scale = ldexp(1, power - 1), wide = fmax(1, ceil(width * scale)),
                 high = fmax(1, ceil(height * scale));
    const double view[4] = {box[0], box[1], wide / scale, high / scale};
    bat_text_string(out, HEAD);
    bat_text_integer(out, (uint64_t)wide);
    bat_text_string(out, HEIGHT);
    bat_text_integer(out, (uint64_t)high);
    bat_text_string(out, VIEW);
    write_numbers(view, 4, out);
    bat_text_string(out, "\">");
    return true;
}

static bool write_all(needs *n, uint32_t element, const double box[4], bat_text *out) {
    bat_svg_walk *w = n->w;
    w->stamp++;
    look_within(n, element);
    for (uint32_t at = tag_of(w, element)->parent; at; at = tag_of(w, at)->parent) look(n, at);
    if (w->style_count && w->sheet->text) need_all(n, w->sheet->text);
    for (size_t i = 0; i < n->count; i++) look_within(n, n->list[i]);
    if (!write_head(box, out)) return false;
    write_root(w, out);
    const bool good = write_sheets(w, out) && write_definitions(n, element, out) &&
                      write_way(w, element, out);
    bat_text_string(out, "</svg></svg>");
    return good;
}

bat_status bat_svg_alone(bat_svg_walk *w, uint32_t element, const double box[4], bat_picture **out) {
    bat_text text = {0};
    needs *n = w->text ? malloc(sizeof *n) : NULL;
    if (!n) return w->text ? BAT_MEMORY : BAT_UNSUPPORTED;
    n->w = w, n->count = 0, n->full = false;
    bat_status status = write_all(n, element, box, &text) ? BAT_OK : BAT_UNSUPPORTED;
    if (text.failed) status = BAT_MEMORY;
    if (status == BAT_OK) status = bat_picture_create(text.data, text.size, out);
    bat_text_free(&text);
    free(n);
    return status;
}

bool bat_svg_alone_matrix(const bat_picture *picture, double m[6]) {
    size_t size;
    const char *text = bat_picture_bytes(picture, &size), *end = text + size;
    double sides[2], view[4];
    bat_picture_sides(picture, sides);
    if (!bat_picture_is_drawing(picture)) return false;
    const char *at = text + sizeof HEAD - 1;
    for (int quotes = 0; at < end && quotes < 4; at++) quotes += *at == '"';
    for (int i = 0; i < 4; i++) {
        while (at < end && *at == ' ') at++;
        at = at < end ? bat_number_scan(at, end, &view[i]) : NULL;
        if (!at) return false;
    }
    const double made[6] = {view[2] / sides[0], 0, 0, view[3] / sides[1], view[0], view[1]};
    for (int i = 0; i < 6; i++) m[i] = made[i];
    return view[2] > 0 && view[3] > 0;
}

/* ---- where a text lies, as far as it can be known without its font ---- */

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
