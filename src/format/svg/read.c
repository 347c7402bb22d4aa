/* SVG in: elements are collected, then drawn into a document once all are known. */
#include "document/digest.h"
#include "base/options.h"
#include "document/document.h"
#include "document/nesting.h"
#include "text/utf8.h"
#include "text/base64.h"
#include "text/json.h"
#include "format/native/native.h"
#include "format/svg/svg.h"
#include "format/svg/digest.h"
#include "format/svg/notes.h"
#include "format/svg/style.h"
#include "format/svg/tree.h"
#include "base/matrix.h"
#include "document/kind.h"

#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Elements drawn (each time that `use` repeats them), and style rules tried, at most. */
enum { DRAWN_MAX = 1 << 20, TRIED_MAX = 1 << 28 };

/* What has no known colour: its outline can be seen and shaped. */
#define GREY 0x808080ffu

struct bat_svg_reader {
    bat_svg_options options;
    bat_svg_tree tree;
    bat_text styles, native;
    uint32_t native_element;
    bat_status status;  /* the first failure */
    uint32_t failed_at; /* elements begun when it came */
};

static const bat_svg_options DEFAULTS = {sizeof DEFAULTS, .corner = 0.05};
static const bat_svg_options MERGING = {sizeof MERGING, .tolerance = 1e-3, .corner = 0.05, .share = 1e-4};
enum { LEAST = sizeof DEFAULTS }; /* as of 0.2: a member that is added begins there */

void bat_svg_options_init(bat_svg_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_svg_options_init_merging(bat_svg_options *options, size_t size) {
    bat_options_give(&MERGING, sizeof MERGING, size, options);
}

bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out) {
    bat_svg_options chosen = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof chosen, &chosen);
    if (status != BAT_OK) return status;
    if (!out || !(chosen.tolerance >= 0 && chosen.tolerance <= BAT_COORDINATE_MAX) ||
        !(chosen.corner >= 0 && chosen.corner <= 4) || !(chosen.share >= 0))
        return BAT_ARGUMENT;
    bat_svg_reader *reader = malloc(sizeof *reader);
    if (!reader) return BAT_MEMORY;
    *reader = (bat_svg_reader){.options = chosen};
    *out = reader;
    return BAT_OK;
}

void bat_svg_reader_free(bat_svg_reader *reader) {
    if (!reader) return;
    bat_svg_tree_free(&reader->tree);
    bat_text_free(&reader->styles);
    bat_text_free(&reader->native);
    free(reader);
}

static bat_status note(bat_svg_reader *reader, bat_status status) {
    if (status != BAT_OK && reader->status == BAT_OK) {
        reader->status = status;
        reader->failed_at = reader->tree.count;
    }
    return reader->status;
}

bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name, const char *const *attributes) {
    if (!reader || !name) return BAT_ARGUMENT;
    if (reader->status != BAT_OK) return reader->status;
    bat_status status = bat_svg_tree_open(&reader->tree, name, attributes);
    if (status != BAT_OK) return note(reader, status);
    uint32_t index = reader->tree.count - 1;
    if (reader->tree.elements[index].kind == BAT_SVG_NATIVE && !reader->native_element)
        reader->native_element = index;
    if (index == 1 && reader->tree.elements[1].kind != BAT_SVG_ROOT) return note(reader, BAT_UNSUPPORTED);
    return BAT_OK;
}

bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size) {
    if (!reader || (!text && size > 0)) return BAT_ARGUMENT;
    if (reader->status != BAT_OK || reader->tree.depth == 0) return reader->status;
    bat_svg_tree *tree = &reader->tree;
    uint32_t element = tree->open[tree->depth - 1];
    bat_text *to = tree->elements[element].kind == BAT_SVG_STYLE  ? &reader->styles
                   : element == reader->native_element && element ? &reader->native
                                                                  : NULL;
    if (!to) return BAT_OK;
    if (size > BAT_JSON_SIZE - to->size) return note(reader, BAT_COUNT);
    bat_text_add(to, text, size);
    return note(reader, to->failed ? BAT_MEMORY : BAT_OK);
}

bat_status bat_svg_reader_end(bat_svg_reader *reader) {
    if (!reader) return BAT_ARGUMENT;
    if (reader->status != BAT_OK) return reader->status;
    return note(reader, bat_svg_tree_close(&reader->tree));
}

/* ---- drawing ---- */

typedef struct walk {
    const bat_svg_options *options;
    const bat_svg_tree *tree;
    const bat_svg_sheet *sheet;
    bat_document *document;
    bat_svg_report *report;
    bat_svg_notes notes;
    uint32_t *means; /* of the gradients that paint, by element, the last bit turned; 0: not known yet */
    bat_outline outline;
    bat_pictures pictures; /* of the images drawn */
    uint64_t digest;
    uint32_t active[BAT_SVG_DEPTH]; /* elements being drawn, outermost first */
    int depth;
    long drawn, tried, put;
    bat_id group;      /* the group being read, 0: none */
    int members;       /* read into it so far */
    int groups;        /* how deep that is */
    int unseen;        /* how many of the elements being drawn are not displayed */
    bat_status status; /* stops everything */
} walk;

/* What is handed down while drawing. */
typedef struct scope {
    double matrix[6];
    bat_svg_style style;
    double opacity;       /* product of the containers' */
    double width, height; /* of the viewport */
} scope;

static const char *attribute(const walk *w, uint32_t element, const char *name) {
    return bat_svg_tree_attribute(w->tree, element, name);
}

/* sqrt((w^2 + h^2) / 2), what percentages of neither axis refer to. */
static double diagonal(const scope *s) { return sqrt((s->width * s->width + s->height * s->height) / 2); }

static void match_rules(walk *w, uint32_t element, const scope *outer, bool important, bat_svg_style *style) {
    const char *id = attribute(w, element, "id"), *classes = attribute(w, element, "class");
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

/* The cascade: attributes, sheets, style="", then what is !important in the two. */
static void find_style(walk *w, uint32_t element, const scope *outer, bat_svg_style *style) {
    *style = bat_svg_style_child(&outer->style);
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *own = attribute(w, element, "style");
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

/* The style of an element where it stands, by all that it is in. */
static void find_style_in_place(walk *w, uint32_t element, scope *s) {
    uint32_t way[BAT_SVG_DEPTH];
    int depth = 0;
    s->style = bat_svg_style_initial();
    for (uint32_t at = element; at; at = w->tree->elements[at].parent) way[depth++] = at;
    while (depth > 0) {
        bat_svg_style style;
        find_style(w, way[--depth], s, &style);
        s->style = style;
    }
}

/* Adds a gradient's stops, each as far as it covers; sum: red, green, blue, cover, how many. */
static void add_stops(walk *w, uint32_t gradient, double sum[5]) {
    scope s = {.width = 100, .height = 100};
    find_style_in_place(w, gradient, &s);
    for (uint32_t at = w->tree->elements[gradient].first; at; at = w->tree->elements[at].next) {
        if (w->tree->elements[at].kind != BAT_SVG_STOP) continue;
        if (++w->drawn > DRAWN_MAX) {
            w->status = BAT_COUNT;
            return;
        }
        bat_svg_style style;
        find_style(w, at, &s, &style);
        uint32_t c = style.stop.kind == BAT_PAINT_CURRENT ? style.colour : style.stop.colour;
        double share = (c & 0xff) * style.stop_opacity;
        for (int k = 0; k < 3; k++) sum[k] += share * (c >> (24 - 8 * k) & 0xff);
        sum[3] += share;
        sum[4]++;
    }
}

/* The mean of a gradient's stops, which may be another one's; *colour is left alone when there are none. */
static void find_mean(walk *w, uint32_t gradient, uint32_t *colour) {
    enum { HOPS_MAX = 32 };
    double sum[5] = {0};
    for (int hops = 0; hops < HOPS_MAX && sum[4] == 0; hops++) {
        add_stops(w, gradient, sum);
        const char *href = attribute(w, gradient, "href");
        if (!href) href = attribute(w, gradient, "xlink:href");
        gradient = href ? bat_svg_tree_refer(w->tree, href) : 0;
        if (!gradient || w->tree->elements[gradient].kind != BAT_SVG_GRADIENT) break;
    }
    if (sum[4] == 0) return;
    uint32_t mean = 0;
    for (int k = 0; k < 3; k++) mean = mean << 8 | (uint32_t)floor(sum[3] > 0 ? sum[k] / sum[3] + 0.5 : 0);
    *colour = mean << 8 | (uint32_t)floor(sum[3] / sum[4] + 0.5);
}

/* What paints in place of a gradient, pattern or the like; *colour: its fallback, which stays where no mean is
 * known. True: there is one. */
static bool resolve_server(walk *w, uint32_t element, const char *text, uint32_t *colour) {
    uint32_t server = bat_svg_tree_refer(w->tree, text);
    bool gradient = server && w->tree->elements[server].kind == BAT_SVG_GRADIENT;
    bat_svg_note(&w->notes, element,
                 gradient ? BAT_LOSS_GRADIENT
                 : server ? BAT_LOSS_PATTERN
                          : BAT_LOSS_BROKEN);
    if (!gradient) return false;
    if (!w->means && !(w->means = calloc(w->tree->count, sizeof *w->means))) {
        w->status = BAT_MEMORY;
        return false;
    }
    uint32_t mean = GREY;
    if (!w->means[server]) {
        find_mean(w, server, &mean);
        w->means[server] = mean ^ 1;
    }
    *colour = w->means[server] ^ 1;
    return true;
}

/* False: nothing is painted. */
static bool resolve_paint(walk *w, uint32_t element, const bat_svg_paint *paint, const bat_svg_style *style,
                          double share, uint32_t *colour) {
    uint32_t c = paint->bare ? GREY : paint->kind == BAT_PAINT_CURRENT ? style->colour : paint->colour;
    bool painted = paint->kind != BAT_PAINT_NONE || paint->bare;
    if (paint->server && resolve_server(w, element, paint->server, &c)) painted = true;
    if (!painted) return false;
    *colour = (c & 0xffffff00) | (uint32_t)floor((double)(c & 0xff) * share + 0.5);
    return true;
}

/* A circle stays a circle. */
static bool is_even(const double m[6]) {
    double x = m[0] * m[0] + m[1] * m[1], y = m[2] * m[2] + m[3] * m[3], xy = m[0] * m[2] + m[1] * m[3];
    return fabs(x - y) <= 0.01 * (x + y) && fabs(xy) <= 0.01 * (x + y);
}

/* What of a shape's style is lost, of that which shows. */
static void note_style(walk *w, uint32_t element, const scope *s, const bat_style *style) {
    const char *name = bat_svg_tree_name(w->tree, element);
    uint32_t markers = BAT_SVG_BIT(BAT_SVG_MARKER_START) | BAT_SVG_BIT(BAT_SVG_MARKER_MID) |
                       BAT_SVG_BIT(BAT_SVG_MARKER_END);
    uint32_t odd = s->style.odd, mask = BAT_SVG_INHERITED & ~BAT_SVG_BIT(BAT_SVG_IMAGE_HINT);
    if (style->stroked)
        mask |= BAT_SVG_BIT(BAT_SVG_EFFECT);
    else
        mask &= ~BAT_SVG_BIT(BAT_SVG_DASHES);
    bool line = name[0] == 'p' || strcmp(name, "line") == 0; /* path, polyline, polygon */
    if (!line) mask &= ~markers;
    if (!style->stroked || !style->filled) {
        if (!(odd & mask & markers)) mask &= ~BAT_SVG_BIT(BAT_SVG_ORDER);
    }
    bat_svg_note_odd(&w->notes, element, odd, mask);
    bool fixed = odd & BAT_SVG_BIT(BAT_SVG_EFFECT);
    if (style->stroked && !fixed && !is_even(s->matrix)) bat_svg_note(&w->notes, element, BAT_LOSS_UNEVEN);
}

static bat_style resolve_style(walk *w, uint32_t element, const scope *s) {
    const bat_svg_style *from = &s->style;
    const double *m = s->matrix;
    bat_style style = {.even_odd = from->even_odd,
                       .width = from->width,
                       .opacity = s->opacity,
                       .cap = from->cap,
                       .join = from->join,
                       .miter_limit = from->miter_limit};
    style.filled = resolve_paint(w, element, &from->fill, from, from->fill_opacity, &style.fill);
    style.stroked = resolve_paint(w, element, &from->stroke, from, from->stroke_opacity, &style.stroke);
    if (!(from->odd & BAT_SVG_BIT(BAT_SVG_EFFECT))) style.width *= sqrt(fabs(m[0] * m[3] - m[1] * m[2]));
    return style;
}

static void count_paths(bat_svg_report *report, int curves) {
    report->paths++;
    report->curves += curves;
}

/* What a point may be off is nothing to a large path and much to a small one. */
static double tolerance_for(const bat_svg_options *options, int segments, const double *points) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!(options->share > 0)) return options->tolerance;
    for (size_t i = 0; i < 2 * (3 * (size_t)segments + 1); i++) {
        low[i % 2] = fmin(low[i % 2], points[i]);
        high[i % 2] = fmax(high[i % 2], points[i]);
    }
    return fmin(options->tolerance, options->share * fmax(high[0] - low[0], high[1] - low[1]));
}

/* One curve for each subpath that has any length. */
static int make_curves(walk *w, uint32_t element, const bat_style *style, bat_curve **curves) {
    const bat_outline *o = &w->outline;
    int count = 0;
    for (int i = 0; i < o->subpath_count && w->status == BAT_OK; i++) {
        const bat_subpath *path = &o->subpaths[i];
        const double *points = o->points + 2 * path->first;
        bool moves = false, good = true;
        for (size_t k = 0; k < 2 * (3 * (size_t)path->segments + 1); k++) {
            good = good && fabs(points[k]) <= BAT_COORDINATE_MAX;
            moves = moves || points[k] != points[k % 2];
        }
        if (good && !moves) {
            bool dot = style->stroked && style->cap != BAT_CAP_BUTT;
            bat_svg_note(&w->notes, element, dot ? BAT_LOSS_BROKEN : BAT_LOSS_COUNT);
            continue;
        }
        double error;
        bat_status status = BAT_NUMBER;
        if (good)
            status = bat_curve_from_bezier(2, 3, path->closed, path->segments, points, w->options->corner,
                                           tolerance_for(w->options, path->segments, points), &curves[count],
                                           &error);
        if (status == BAT_MEMORY)
            w->status = status;
        else if (status == BAT_OK || status == BAT_TOLERANCE)
            count++;
        else
            bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
    }
    return count;
}

/* Layers' labels are for people; ids often are not. */
static const char *find_name(const walk *w, uint32_t element) {
    static const char *const names[] = {"data-name", "inkscape:label", "id"};
    for (int i = 0; i < 3; i++) {
        const char *name = attribute(w, element, names[i]);
        if (name && bat_utf8_valid(name, strlen(name))) return name;
    }
    return "";
}

/* Into the group being read, hidden and locked as the element says. Takes the object over. */
static void put_object(walk *w, uint32_t element, bool shown, bat_object *object) {
    const char *locked = attribute(w, element, "data-locked"),
               *insensitive = attribute(w, element, "sodipodi:insensitive");
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
    bat_object_release(object);
    if (status == BAT_OK) w->members++;
    if (status == BAT_MEMORY || status == BAT_COUNT) w->status = status;
}

static void add_object(walk *w, uint32_t element, bool shown, const bat_style *style) {
    const char *name = find_name(w, element);
    bat_curve **curves = malloc((size_t)w->outline.subpath_count * sizeof *curves);
    if (!curves) {
        w->status = BAT_MEMORY;
        return;
    }
    int count = make_curves(w, element, style, curves);
    bat_object *object = NULL;
    bat_status status = w->status;
    if (status == BAT_OK && count > 0)
        status = bat_object_create_path(bat_document_new_id(w->document), name, style, count, curves,
                                        &object);
    else
        for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    if (object) {
        put_object(w, element, shown, object);
        if (w->unseen)
            w->report->hidden++;
        else
            count_paths(w->report, count);
    } else if (count > 0 && status != BAT_OK) { /* a stroke width out of all bounds */
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
    }
    if (status == BAT_MEMORY || status == BAT_COUNT) w->status = status;
    free(curves);
}

typedef struct element_of {
    const bat_svg_tree *tree;
    uint32_t element;
} element_of;

static const char *shape_attribute(const void *element, const char *name) {
    const element_of *e = element;
    return bat_svg_tree_attribute(e->tree, e->element, name);
}

static void draw_shape(walk *w, uint32_t element, const scope *s) {
    if (!s->style.visible) {
        bat_svg_note(&w->notes, element, BAT_LOSS_INVISIBLE);
        return;
    }
    element_of holder = {w->tree, element};
    bat_svg_shape shape = {shape_attribute, &holder, s->width, s->height};
    bat_outline_clear(&w->outline);
    if (!bat_svg_shape_outline(&shape, bat_svg_tree_name(w->tree, element), &w->outline))
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
    if (w->outline.failed || w->outline.full) w->status = w->outline.failed ? BAT_MEMORY : BAT_COUNT;
    if (w->outline.subpath_count == 0 || w->status != BAT_OK) return;
    bat_outline_transform(&w->outline, s->matrix);
    bat_style style = resolve_style(w, element, s);
    if (!style.stroked && !style.filled) {
        bat_svg_note(&w->notes, element, BAT_LOSS_INVISIBLE);
        return;
    }
    note_style(w, element, s, &style);
    if (!w->unseen) w->digest = bat_svg_digest(w->digest, &w->outline, &style);
    add_object(w, element, s->style.shown, &style);
}

static void draw(walk *w, uint32_t element, const scope *outer);

static void draw_children(walk *w, uint32_t element, const scope *s) {
    for (uint32_t at = w->tree->elements[element].first; at && w->status == BAT_OK;
         at = w->tree->elements[at].next)
        draw(w, at, s);
}

/* A group of the file becomes one of the document when it is a layer, has a name, hides or locks something, or
 * holds more than one thing together; the rest only carried a transform or a style. */
static void draw_group(walk *w, uint32_t element, const scope *s) {
    const char *mode = attribute(w, element, "inkscape:groupmode");
    bat_object *group = NULL;
    const bat_object *outer = bat_document_at(w->document, bat_document_find(w->document, w->group));
    bool layer = mode && !strcmp(mode, "layer") && (!outer || bat_object_is(outer, BAT_LAYER));
    if (w->groups == BAT_NESTING_MAX) {
        draw_children(w, element, s);
        return;
    }
    bat_id above = w->group, own = bat_document_new_id(w->document);
    int index = bat_document_count(w->document), members = w->members + 1;
    bat_status status = bat_object_create_group(own, find_name(w, element), layer, &group);
    if (status != BAT_OK) {
        w->status = status;
        return;
    }
    put_object(w, element, s->style.shown, group);
    if (w->status != BAT_OK) return;
    w->group = own;
    w->members = 0;
    w->groups++;
    draw_children(w, element, s);
    w->groups--;
    w->group = above;
    const bat_object *made = bat_document_at(w->document, index);
    bool plain = !layer && !*bat_object_name(made) && !bat_object_is_hidden(made) &&
                 !bat_object_is_locked(made);
    if (w->status == BAT_OK && ((w->members == 1 && plain) || (w->members == 0 && !layer))) {
        members = members - 1 + w->members;
        bat_document_remove(w->document, index);
        bat_object *moved = NULL;
        if (w->members == 1) {
            w->status = bat_object_with_parent(bat_document_at(w->document, index), above, &moved);
            if (moved) bat_document_replace(w->document, index, moved);
            bat_object_release(moved);
        }
    }
    w->members = members;
}

static double length_of(const walk *w, uint32_t element, const char *name, double whole, double otherwise) {
    const char *text = attribute(w, element, name);
    double value;
    return text && bat_svg_length(text, whole, &value) ? value : otherwise;
}

/* A nested svg, or a symbol drawn by use: a viewport with its own units. sizer: whose width and height count.
 */
static void draw_viewport(walk *w, uint32_t element, uint32_t sizer, double x, double y, const scope *s) {
    scope inner = *s;
    const char *text = attribute(w, element, "viewBox");
    double width = length_of(w, element, "width", s->width, s->width), box[4], m[6];
    double height = length_of(w, element, "height", s->height, s->height);
    width = length_of(w, sizer, "width", s->width, width);
    height = length_of(w, sizer, "height", s->height, height);
    if (!(width > 0 && height > 0)) return;
    if (text && bat_svg_view_box(text, box)) {
        if (box[2] == 0 || box[3] == 0) return;
        bat_svg_fit(box, x, y, width, height, attribute(w, element, "preserveAspectRatio"), m);
        inner.width = box[2], inner.height = box[3];
    } else {
        bat_matrix_identity(m);
        m[4] = x, m[5] = y;
        inner.width = width, inner.height = height;
    }
    bat_matrix_compose(s->matrix, m, inner.matrix);
    draw_children(w, element, &inner);
}

/* What of a style is lost where it stands, and is not handed down. */
static void note_own_style(walk *w, uint32_t element, const bat_svg_style *style) {
    bat_svg_note_odd(&w->notes, element, style->odd, ~(BAT_SVG_INHERITED | BAT_SVG_BIT(BAT_SVG_EFFECT)));
}

static void draw_use(walk *w, uint32_t element, const scope *s) {
    const char *href = attribute(w, element, "href");
    if (!href) href = attribute(w, element, "xlink:href");
    uint32_t target = href && href[0] == '#' ? bat_svg_tree_find(w->tree, href + 1) : 0;
    for (int i = 0; i < w->depth; i++)
        if (w->active[i] == target) target = 0; /* it would draw itself */
    if (!target) {
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
        return;
    }
    double x = length_of(w, element, "x", s->width, 0), y = length_of(w, element, "y", s->height, 0);
    double m[6] = {1, 0, 0, 1, x, y};
    scope inner = *s;
    bat_matrix_compose(s->matrix, m, inner.matrix);
    bat_svg_kind kind = (bat_svg_kind)w->tree->elements[target].kind;
    if (kind != BAT_SVG_SYMBOL && kind != BAT_SVG_ROOT) {
        draw(w, target, &inner);
        return;
    }
    if (w->depth == BAT_SVG_DEPTH) return;
    scope own = inner;
    find_style(w, target, &inner, &own.style);
    note_own_style(w, target, &own.style);
    own.opacity = inner.opacity * own.style.opacity;
    w->active[w->depth++] = target;
    if (own.style.shown) draw_viewport(w, target, element, 0, 0, &own);
    w->depth--;
}

/* The first child that can be drawn: no foreign content, no extensions asked for. */
static void draw_switch(walk *w, uint32_t element, const scope *s) {
    for (uint32_t at = w->tree->elements[element].first; at; at = w->tree->elements[at].next) {
        bat_svg_kind kind = (bat_svg_kind)w->tree->elements[at].kind;
        const char *language = attribute(w, at, "systemLanguage");
        if (kind == BAT_SVG_UNKNOWN || kind == BAT_SVG_OTHER || kind >= BAT_SVG_NEVER) continue;
        if (attribute(w, at, "requiredExtensions") || (language && strncmp(language, "en", 2) != 0)) continue;
        draw(w, at, s);
        return;
    }
}

/* The picture of a data URI; NULL when it is none, or must be left out. */
static bat_picture *find_picture(walk *w, uint32_t element) {
    const char *href = attribute(w, element, "href");
    if (!href) href = attribute(w, element, "xlink:href");
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

static void draw_image(walk *w, uint32_t element, const scope *s) {
    bat_picture *picture = s->style.visible ? find_picture(w, element) : NULL;
    bat_object *object = NULL;
    if (!picture) {
        bat_svg_note(&w->notes, element, s->style.visible ? BAT_LOSS_IMAGE : BAT_LOSS_INVISIBLE);
        return;
    }
    bat_svg_note_odd(&w->notes, element, s->style.odd, BAT_SVG_BIT(BAT_SVG_IMAGE_HINT));
    double box[4] = {0}, m[6], matrix[6];
    bat_picture_sides(picture, box + 2);
    double width = length_of(w, element, "width", s->width, -1);
    double height = length_of(w, element, "height", s->height, -1);
    if (width < 0) width = height < 0 ? box[2] : height * box[2] / box[3];
    if (height < 0) height = width * box[3] / box[2];
    const char *ratio = attribute(w, element, "preserveAspectRatio");
    if (ratio && strstr(ratio, "slice")) bat_svg_note(&w->notes, element, BAT_LOSS_CLIP);
    bat_svg_fit(box, length_of(w, element, "x", s->width, 0), length_of(w, element, "y", s->height, 0), width,
                height, ratio, m);
    bat_matrix_compose(s->matrix, m, matrix);
    bat_status status = bat_object_create_image(bat_document_new_id(w->document), find_name(w, element),
                                                picture, matrix, s->opacity, &object);
    if (status == BAT_OK) {
        if (!w->unseen)
            w->digest = bat_svg_digest_image(w->digest, picture, bat_object_matrix(object), s->opacity);
        put_object(w, element, s->style.shown, object);
    } else
        bat_svg_note(&w->notes, element, BAT_LOSS_IMAGE);
    if (status == BAT_MEMORY) w->status = status;
    bat_picture_release(picture);
}

/* What of an element is lost, apart from its style. */
static void note_element(walk *w, uint32_t element) {
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *name = bat_svg_tree_name(w->tree, element);
    if (!bat_svg_note_once(&w->notes, element)) return;
    bat_svg_note(&w->notes, element, (bat_loss)e->loss);
    if (e->kind == BAT_SVG_ROOT && element != 1) bat_svg_note(&w->notes, element, BAT_LOSS_NESTED);
    if (e->kind == BAT_SVG_TEXT || e->kind == BAT_SVG_OTHER) return; /* as a whole */
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

static void draw_kind(walk *w, uint32_t element, const scope *s) {
    long before = w->put;
    switch (w->tree->elements[element].kind) {
    case BAT_SVG_GROUP: draw_group(w, element, s); break;
    case BAT_SVG_SWITCH: draw_switch(w, element, s); break;
    case BAT_SVG_ROOT:
        draw_viewport(w, element, element, length_of(w, element, "x", s->width, 0),
                      length_of(w, element, "y", s->height, 0), s);
        break;
    case BAT_SVG_USE: draw_use(w, element, s); break;
    case BAT_SVG_SHAPE: draw_shape(w, element, s); break;
    case BAT_SVG_IMAGE: draw_image(w, element, s); break;
    default: break;
    }
    if (s->style.opacity < 1 && w->put > before + 1) bat_svg_note(&w->notes, element, BAT_LOSS_OPACITY);
}

static void draw(walk *w, uint32_t element, const scope *outer) {
    bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    if (kind == BAT_SVG_UNKNOWN || kind == BAT_SVG_SYMBOL || kind >= BAT_SVG_NEVER) {
        bat_svg_note_undrawn(&w->notes, element);
        return;
    }
    if (++w->drawn > DRAWN_MAX || w->tried > TRIED_MAX) {
        w->status = BAT_COUNT;
        return;
    }
    scope s = *outer;
    find_style(w, element, outer, &s.style);
    bool shown = s.style.shown;
    /* What is not displayed is kept, hidden, so that saving does not lose it; but copies are not made of it. */
    if (!shown && kind != BAT_SVG_SHAPE && kind != BAT_SVG_GROUP && kind != BAT_SVG_IMAGE) {
        bool copied = kind != BAT_SVG_TEXT && kind != BAT_SVG_OTHER;
        bat_loss loss = (bat_loss)w->tree->elements[element].loss;
        bat_svg_note(&w->notes, element, copied ? BAT_LOSS_INVISIBLE : loss);
        return;
    }
    note_element(w, element);
    if (w->depth == BAT_SVG_DEPTH) {
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
        return;
    }
    s.opacity = outer->opacity * s.style.opacity;
    const char *transform = attribute(w, element, "transform");
    double m[6];
    if (transform) {
        if (!bat_svg_transform(transform, m)) bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
        bat_matrix_compose(outer->matrix, m, s.matrix);
    }
    if (kind != BAT_SVG_TEXT && kind != BAT_SVG_OTHER) note_own_style(w, element, &s.style);
    w->active[w->depth++] = element;
    w->unseen += !shown;
    draw_kind(w, element, &s);
    w->unseen -= !shown;
    w->depth--;
}

/* User units are those of the outermost viewBox, and it is the page; without one, width and height are. */
static void draw_root(walk *w) {
    scope none = {.style = bat_svg_style_initial(), .opacity = 1, .width = 100, .height = 100};
    bat_matrix_identity(none.matrix);
    double page[4] = {0};
    const char *box = attribute(w, 1, "viewBox"), *transform = attribute(w, 1, "transform");
    if (!box || !bat_svg_view_box(box, page)) {
        page[0] = page[1] = 0;
        page[2] = length_of(w, 1, "width", 0, 0), page[3] = length_of(w, 1, "height", 0, 0);
    }
    if (!(page[2] > 0 && page[3] > 0)) memset(page, 0, sizeof page);
    if (page[2] > 0) none.width = page[2], none.height = page[3];
    bat_document_set_page(w->document, page);
    scope s = none;
    find_style(w, 1, &none, &s.style);
    s.opacity = s.style.opacity;
    if (transform && !bat_svg_transform(transform, s.matrix)) bat_svg_note(&w->notes, 1, BAT_LOSS_BROKEN);
    note_element(w, 1);
    note_own_style(w, 1, &s.style);
    bat_svg_note_page(&w->notes, page);
    if (!s.style.shown) {
        bat_svg_note(&w->notes, 1, BAT_LOSS_INVISIBLE);
        return;
    }
    w->active[w->depth++] = 1;
    draw_children(w, 1, &s);
    w->depth--;
    if (s.opacity < 1 && w->put > 1) bat_svg_note(&w->notes, 1, BAT_LOSS_OPACITY);
}

/* ---- the native document ---- */

/* Takes the native document's place when the drawing still shows what was written with it. */
static void use_native(bat_svg_reader *reader, uint64_t digest, bat_pictures *pictures,
                       bat_document **document, bat_svg_report *report) {
    if (!reader->native_element) return;
    const char *noted = bat_svg_tree_attribute(&reader->tree, reader->native_element, "digest");
    char own[17];
    bat_digest_print(digest, own);
    bat_document *native = NULL;
    report->edited = true;
    report->lost.count[BAT_LOSS_NATIVE] = 1;
    if (!noted || strcmp(noted, own) != 0) return;
    bat_status status = bat_document_read_with(reader->native.data ? reader->native.data : "",
                                               reader->native.size, pictures, &native, NULL);
    if (status != BAT_OK) return;
    /* The page may have been changed alone. */
    double page[4], written[4];
    bat_document_page(*document, page);
    bat_svg_page(native, written);
    if (memcmp(page, written, sizeof page) != 0) bat_document_set_page(native, page);
    report->edited = false;
    report->native = true;
    report->lost.count[BAT_LOSS_NATIVE] = 0;
    report->paths = report->curves = 0;
    int *invisible = &report->lost.count[BAT_LOSS_INVISIBLE];
    for (int i = 0; i < bat_document_count(native); i++) {
        const bat_object *object = bat_document_at(native, i);
        const bat_style *style = bat_object_style(object);
        report->paths += bat_object_is_drawn(object);
        report->curves += bat_object_curve_count(object);
        /* What paints nothing is not read from the drawing, but it is here. */
        if (bat_object_is_drawn(object) && !style->stroked && !style->filled && *invisible > 0) --*invisible;
    }
    bat_document_free(*document);
    *document = native;
}

static bat_status read_drawing(bat_svg_reader *reader, bat_document **out, bat_svg_report *report) {
    bat_svg_sheet sheet;
    bat_document *document = NULL;
    bat_status status = bat_svg_tree_index(&reader->tree);
    if (status == BAT_OK) status = bat_svg_sheet_parse(reader->styles.data, reader->styles.size, &sheet);
    if (status != BAT_OK) return status;
    status = bat_document_create(&document);
    walk *w = status == BAT_OK ? malloc(sizeof *w) : NULL;
    if (!w) {
        bat_svg_sheet_free(&sheet);
        bat_document_free(document);
        return BAT_MEMORY;
    }
    *w = (walk){.options = &reader->options,
                .tree = &reader->tree,
                .sheet = &sheet,
                .document = document,
                .report = report,
                .digest = bat_digest_begin()};
    status = bat_svg_notes_begin(&w->notes, &reader->tree, &sheet, &report->lost);
    if (status == BAT_OK) draw_root(w);
    if (status == BAT_OK) status = w->status;
    if (status == BAT_OK) use_native(reader, w->digest, &w->pictures, &document, report);
    bat_outline_free(&w->outline);
    bat_pictures_free(&w->pictures);
    bat_svg_notes_free(&w->notes);
    free(w->means);
    free(w);
    bat_svg_sheet_free(&sheet);
    if (status != BAT_OK)
        bat_document_free(document);
    else
        *out = document;
    return status;
}

static bat_status explain(const bat_svg_reader *reader, bat_status status, bat_problem *problem) {
    char place[64] = "";
    const char *message = bat_status_message(status);
    if (reader->status != BAT_OK && reader->failed_at > 0)
        snprintf(place, sizeof place, "element %lu", (unsigned long)reader->failed_at);
    if (status == BAT_UNSUPPORTED) message = "expected an svg element at the top, found another";
    if (status == BAT_COUNT)
        message = "expected at most 256 levels, 4 million elements and 1 million drawn, found more";
    if (status == BAT_SYNTAX)
        message = reader->tree.count == 0  ? "expected an svg element, found nothing"
                  : reader->tree.depth > 0 ? "expected the ends of all elements, found the end of the file"
                                           : "expected one element at the top, found more";
    return bat_problem_set(problem, status, place, message);
}

bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                 bat_problem *problem) {
    if (!reader || !out) {
        bat_svg_reader_free(reader);
        return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    }
    bat_svg_report facts = {0};
    bat_document *document = NULL;
    bat_status status = reader->status;
    if (status == BAT_OK && (reader->tree.count == 0 || reader->tree.depth > 0)) status = BAT_SYNTAX;
    if (status == BAT_OK) status = read_drawing(reader, &document, &facts);
    if (status == BAT_OK) {
        *out = document;
        if (report) *report = facts;
    } else
        explain(reader, status, problem);
    bat_svg_reader_free(reader);
    return status;
}
