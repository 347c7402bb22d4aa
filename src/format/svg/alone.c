#include "format/svg/alone.h"

#include "format/svg/svg.h"
#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BYTES_MAX = 1 << 22, LISTED_MAX = 4096 };

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
        if (without & BAT_SVG_ITS_MASK) bat_text_string(out, "mask:none!important;");
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
    bat_text_string(out, " viewBox=\"");
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

/* What the element needs, and what all need. */
static void look_around(needs *n, uint32_t element) {
    bat_svg_walk *w = n->w;
    w->stamp++;
    look_within(n, element);
    for (uint32_t at = tag_of(w, element)->parent; at; at = tag_of(w, at)->parent) look(n, at);
    if (w->style_count && w->sheet->text) need_all(n, w->sheet->text);
    for (size_t i = 0; i < n->count; i++) look_within(n, n->list[i]);
}

/* before NULL: the element in its place; else what it holds, between these texts. */
typedef struct content {
    const bat_text *before;
    const char *after;
} content;

static bool write_content(const needs *n, uint32_t element, const content *c, bat_text *out) {
    const bat_svg_tag *tag = tag_of(n->w, element);
    if (!c->before) return write_way(n->w, element, out);
    bat_text_add(out, c->before->data, c->before->size);
    const bool good = copy(n->w, tag->body, tag->close, out);
    bat_text_string(out, c->after);
    return good;
}

static bool write_all(needs *n, uint32_t element, const content *c, bat_text *out) {
    look_around(n, element);
    write_root(n->w, out);
    const bool good = write_sheets(n->w, out) && write_definitions(n, element, out) &&
                      write_content(n, element, c, out);
    bat_text_string(out, "</svg></svg>");
    return good;
}

/* text: what comes before it all; it is freed. */
static bat_status make(bat_svg_walk *w, uint32_t element, const content *c, bat_text *text,
                       bat_picture **out) {
    needs *n = w->text ? malloc(sizeof *n) : NULL;
    bat_status status = w->text ? BAT_MEMORY : BAT_UNSUPPORTED;
    if (n) {
        n->w = w, n->count = 0, n->full = false;
        status = write_all(n, element, c, text) ? BAT_OK : BAT_UNSUPPORTED;
        if (text->failed) status = BAT_MEMORY;
    }
    if (status == BAT_OK) status = bat_picture_create(text->data, text->size, out);
    bat_text_free(text);
    free(n);
    return status;
}

bat_status bat_svg_alone(bat_svg_walk *w, uint32_t element, const double box[4], bat_picture **out) {
    bat_text text = {0};
    if (!bat_drawing_open(box, &text)) return BAT_UNSUPPORTED;
    return make(w, element, &(content){NULL, NULL}, &text, out);
}

bat_status bat_svg_alone_within(bat_svg_walk *w, uint32_t element, const uint32_t sides[2],
                                const bat_text *before, const char *after, bat_picture **out) {
    const double own[2] = {sides[0], sides[1]};
    bat_text text = {0};
    bat_drawing_head(own, (double[4]){0, 0, own[0], own[1]}, &text);
    return make(w, element, &(content){before, after}, &text, out);
}

/* Whether an attribute says what is not inherited, or when an element is shown. */
static bool is_own(const char *name) {
    static const char *const own[] = {"id",
                                      "x",
                                      "y",
                                      "width",
                                      "height",
                                      "viewBox",
                                      "patternTransform",
                                      "patternUnits",
                                      "patternContentUnits",
                                      "maskUnits",
                                      "maskContentUnits",
                                      "href",
                                      "xlink:href",
                                      "transform",
                                      "preserveAspectRatio"};
    for (size_t k = 0; k < sizeof own / sizeof *own; k++)
        if (strcmp(name, own[k]) == 0) return true;
    return strncmp(name, "on", 2) == 0 || strncmp(name, "inkscape:", 9) == 0 ||
           strncmp(name, "sodipodi:", 9) == 0;
}

static void write_attribute(const char *name, const char *value, bat_text *out) {
    bat_text_string(out, " ");
    bat_text_string(out, name);
    bat_text_string(out, "=\"");
    bat_text_xml(out, value, strlen(value), true);
    bat_text_string(out, "\"");
}

void bat_svg_alone_attributes(const bat_svg_walk *w, uint32_t holder, bat_text *out) {
    const bat_svg_element *e = &w->tree->elements[holder];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *name = w->tree->strings.data + pair[0];
        if (!is_own(name)) write_attribute(name, w->tree->strings.data + pair[1], out);
    }
}

/* Of an element around a holder: its style with that of its attributes, and without effects. False: it has none. */
static bool open_around(const bat_svg_walk *w, uint32_t element, bat_text *out) {
    static const char NONE[] =
        ";opacity:1!important;display:inline!important;mask:none!important;clip-path:none"
        "!important;filter:none!important;mix-blend-mode:normal!important";
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *style = bat_svg_attribute_of(w, element, "style");
    const size_t from = out->size;
    bool any = false;
    bat_text_string(out, "<g");
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        const char *name = strings + pair[0];
        const bat_svg_name what = bat_svg_name_of(name);
        const bool named = strcmp(name, "class") == 0 || strcmp(name, "id") == 0, /* for rules */
            taken = what <= BAT_SVG_IDLE || (named && w->sheet->count > 0) || strncmp(name, "xml", 3) == 0;
        if (taken) write_attribute(name, strings + pair[1], out);
        any = any || taken;
    }
    bat_text_string(out, " style=\"");
    if (style) bat_text_xml(out, style, strlen(style), true);
    bat_text_string(out, NONE);
    bat_text_string(out, "\">");
    if (!any && !style) out->size = from;
    return any || style;
}

void bat_svg_alone_around(const bat_svg_walk *w, uint32_t holder, bat_text *before, bat_text *after) {
    uint32_t way[BAT_SVG_DEPTH];
    int depth = 0;
    for (uint32_t at = w->tree->elements[holder].parent; at > 1 && depth < BAT_SVG_DEPTH;
         at = w->tree->elements[at].parent)
        way[depth++] = at;
    while (depth > 0)
        if (open_around(w, way[--depth], before)) bat_text_string(after, "</g>");
}
