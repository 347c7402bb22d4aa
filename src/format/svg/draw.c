/* The walk through the elements of a drawing: calls the drawing function of each kind. */
#include "base/matrix.h"
#include "document/document.h"
#include "document/unit.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const uint32_t EFFECTS = BAT_SVG_BIT(BAT_SVG_MASK) | BAT_SVG_BIT(BAT_SVG_FILTER);

static void draw_kind(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    static bat_svg_way *const ways[BAT_SVG_NEVER] = {
        [BAT_SVG_GROUP] = bat_svg_draw_group, [BAT_SVG_SWITCH] = bat_svg_draw_switch,
        [BAT_SVG_ROOT] = bat_svg_draw_nested, [BAT_SVG_USE] = bat_svg_draw_use,
        [BAT_SVG_SHAPE] = bat_svg_draw_shape, [BAT_SVG_IMAGE] = bat_svg_draw_image};
    const long before = w->put;
    const int from = bat_document_count(w->document);
    const bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    if (kind == BAT_SVG_TEXT || kind == BAT_SVG_OTHER) {
        if (w->copied || kind != BAT_SVG_TEXT || !bat_svg_draw_text(w, element, s)) {
            const bool blank = kind == BAT_SVG_TEXT && bat_svg_may_stand_alone(w) &&
                               bat_svg_is_blank(w, element);
            bat_svg_note(&w->notes, element,
                         blank ? BAT_LOSS_INVISIBLE : (bat_loss)w->tree->elements[element].loss);
        }
        return;
    }
    if (ways[kind]) ways[kind](w, element, s);
    if (kind != BAT_SVG_GROUP && s->style.opacity < 1 && w->put > before + 1 && bat_svg_overlap(w, from))
        bat_svg_note(&w->notes, element, BAT_LOSS_OPACITY);
}

/* Whether it may be shown as a whole, as foreign content. */
static bool may_be_foreign(const bat_svg_walk *w, uint32_t element) {
    const char *mode = bat_svg_attribute_of(w, element, "inkscape:groupmode");
    return !w->copied && !(mode && !strcmp(mode, "layer"));
}

/* Whether only the whole of it can show it, now that it has been drawn: it has a filter, or a mask, a pattern or markers that could not be
 * painted. */
static bool has_effect(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const uint32_t own = 1u << BAT_LOSS_PATTERN | 1u << BAT_LOSS_MARKER,
                   shape = w->tree->elements[element].kind == BAT_SVG_SHAPE ? own : 0;
    const bool failed = bat_svg_noted(&w->notes, element) & (shape | 1u << BAT_LOSS_MASK);
    return (failed || s->style.odd & EFFECTS) && bat_svg_may_stand_alone(w);
}

static bat_svg_before effect_begin(const bat_svg_walk *w) {
    return (bat_svg_before){.objects = bat_document_count(w->document),
                            .members = w->members,
                            .put = w->put,
                            .paths = w->report->paths,
                            .curves = w->report->curves,
                            .hidden = w->report->hidden,
                            .digest = w->digest,
                            .lost = *w->notes.lost};
}

/* With its own style's losses; what only the whole of it can show is foreign content. */
static void draw_whole(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, bool copied) {
    const bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    const bool noted = kind != BAT_SVG_TEXT && kind != BAT_SVG_OTHER, now = w->copied;
    w->copied = copied;
    const bool whole = noted && may_be_foreign(w, element);
    w->copied = now;
    const bat_svg_before before = effect_begin(w);
    if (noted) bat_svg_note_own_style(w, element, &s->style);
    draw_kind(w, element, s);
    w->copied = copied;
    if (whole && has_effect(w, element, s)) (void)bat_svg_effect_end(w, element, s, &before);
    const uint32_t blends = s->style.odd &
                            BAT_SVG_BIT(BAT_SVG_BLEND); /* with nothing, where nothing is below */
    if (blends && (w->collected || bat_svg_lies_over(w, before.objects)))
        bat_svg_note_odd(&w->notes, element, blends, blends);
    w->copied = now;
}

static void draw(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer) {
    bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    if (kind == BAT_SVG_UNKNOWN || kind == BAT_SVG_SYMBOL || kind >= BAT_SVG_NEVER) {
        bat_svg_note_undrawn(&w->notes, element);
        return;
    }
    if (++w->drawn > BAT_SVG_DRAWN_MAX || w->tried > BAT_SVG_TRIED_MAX) {
        w->status = BAT_COUNT;
        return;
    }
    bat_svg_scope s = *outer;
    bat_svg_cascade(w, element, outer, &s.style);
    bool shown = s.style.shown;
    /* What is not displayed is kept as hidden, so that saving does not lose it; but `use` makes no copies of
     * it. */
    if (!shown && kind != BAT_SVG_SHAPE && kind != BAT_SVG_GROUP && kind != BAT_SVG_IMAGE &&
        kind != BAT_SVG_TEXT) {
        bat_svg_note(&w->notes, element, BAT_LOSS_INVISIBLE);
        return;
    }
    bat_svg_note_element(w, element);
    if (w->depth == BAT_SVG_DEPTH) {
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
        return;
    }
    s.opacity = outer->opacity * s.style.opacity;
    double m[6];
    const bat_svg_moved moved = bat_svg_matrix_of(w, element, &s, m);
    if (moved == BAT_SVG_MOVED_BADLY) bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
    if (moved == BAT_SVG_MOVED_WRONGLY) bat_svg_note(&w->notes, element, BAT_LOSS_UNKNOWN);
    if (moved != BAT_SVG_MOVED_NOT) bat_matrix_compose(outer->matrix, m, s.matrix);
    const bool copied = w->copied;
    const int place = w->place;
    bat_svg_place(w, element, outer, &s);
    if (w->keeps && !w->copied && w->place_count > 0 && moved == BAT_SVG_MOVED_BY_BOX)
        w->places[w->place].declared |= BAT_DECLARED_BOX;
    w->copied = copied || kind == BAT_SVG_USE;
    w->given[w->depth] = 0;
    w->active[w->depth++] = element;
    w->unseen += !shown;
    bat_svg_clip_begin(w, element, outer, &s);
    bat_svg_mask_begin(w, element, &s);
    if (w->status == BAT_OK) draw_whole(w, element, &s, copied);
    bat_svg_clip_end(&s);
    w->unseen -= !shown;
    w->depth--;
    w->copied = copied;
    w->place = place;
}

/* ---- how large a file says that its drawing is (SVG 2, 8.2 and 8.6) ---- */

/* What thirteen digits tell of a ratio, which was rounded twice: 1 where lengths in mm meet as many units. */
static double even(double ratio) {
    char text[32];
    double value = ratio;
    snprintf(text, sizeof text, "%.13g", ratio);
    (void)bat_number_scan(text, text + strlen(text), &value);
    return value;
}

/* A length that is none of the page's share. */
static double given(const char *text, bat_unit *unit) {
    double value;
    if (!text || strchr(text, '%') || !bat_svg_length(text, 0, &value) || !(value > 0)) return 0;
    if (*unit == BAT_UNIT_PX) *unit = bat_unit_of(text);
    return value;
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/* Takes space off both ends. */
static void trim(const char **from, const char **to) {
    while (*from < *to && is_space(**from)) ++*from;
    while (*to > *from && is_space((*to)[-1])) --*to;
}

/* Whether a unit is as long everywhere. */
static bool is_fixed(const char *unit) {
    static const char *const units[] = {"px", "mm", "cm", "in", "pt", "pc", "q"};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const size_t size = strlen(units[i]);
        bool same = strlen(unit) == size;
        for (size_t k = 0; same && k < size; k++) same = (unit[k] | 32) == units[i][k];
        if (same) return true;
    }
    return false;
}

/* Copies a value in a unit that is the same everywhere; false: it is none. *important: it says so. */
static bool copy_length(const char *from, const char *to, char room[BAT_SVG_SIDE_ROOM], bool *important) {
    char made[BAT_SVG_SIDE_ROOM];
    double value;
    const char *mark = memchr(from, '!', (size_t)(to - from));
    *important = mark != NULL;
    if (mark) to = mark;
    trim(&from, &to);
    const size_t size = (size_t)(to - from);
    if (size >= sizeof made) return false;
    memcpy(made, from, size);
    made[size] = '\0';
    const char *unit = bat_number_scan(made, made + size, &value);
    if (!unit || !(value > 0) || !is_fixed(unit)) return false;
    memcpy(room, made, size + 1);
    return true;
}

const char *bat_svg_root_side(const char *style, size_t size, const char *name, const char *attribute,
                              char room[BAT_SVG_SIDE_ROOM]) {
    const char *out = attribute;
    bool insists = false;
    for (const char *at = style, *end = style ? style + size : NULL; at && at < end;) {
        const char *next = memchr(at, ';', (size_t)(end - at)), *to = next ? next : end;
        const char *colon = memchr(at, ':', (size_t)(to - at)), *name_end = colon;
        bool important = false;
        if (colon) trim(&at, &name_end);
        if (colon && strlen(name) == (size_t)(name_end - at) && memcmp(at, name, strlen(name)) == 0 &&
            copy_length(colon + 1, to, insists ? (char[BAT_SVG_SIDE_ROOM]){0} : room, &important) &&
            !insists) {
            insists = important;
            out = room;
        }
        at = next ? next + 1 : NULL;
    }
    return out;
}

/* The part of the plane that paper of that size shows, where its proportions are others than the box has; and what stretches
 * the drawing, where they are made to agree. On a screen, whose size is none, the box is the page. */
static void show(const double box[4], double wide, double high, const char *ratio, bat_svg_root *out) {
    double m[6];
    bat_svg_fit(box, 0, 0, wide, high, ratio, m);
    if (!(m[0] > 0 && m[3] > 0) || fabs(wide * box[3] - high * box[2]) <= 1e-5 * wide * box[3]) return;
    const double s = m[0] == m[3] ? m[0] : sqrt(m[0] * m[3]);
    const double shown[4] = {-m[4] / s, -m[5] / s, wide / s, high / s};
    for (int i = 0; i < 4; i++)
        if (!(fabs(shown[i]) <= BAT_COORDINATE_MAX)) return;
    if (m[0] == m[3]) {
        if (bat_unit_is_physical(out->sheet.unit)) memcpy(out->sheet.page, shown, sizeof shown);
        return;
    }
    out->stretch[0] = m[0] / s, out->stretch[1] = m[3] / s;
    for (int i = 0; i < 4; i++) out->sheet.page[i] = box[i] * out->stretch[i % 2];
}

void bat_svg_root_read(const double box[4], bool boxed, const char *width, const char *height,
                       const char *ratio, bat_svg_root *out) {
    bat_svg_root root = {.stretch = {1, 1}, .pixel = 1};
    bat_unit unit = BAT_UNIT_PX;
    const double wide = given(width, &unit), high = given(height, &unit);
    const double one = bat_unit_millimetres(unit);
    memcpy(root.sheet.page, box, sizeof root.sheet.page);
    root.sheet.unit = unit;
    if (boxed) root.pixel = bat_svg_pixel(box, width, height, ratio);
    if (boxed && box[2] > 0 && wide > 0 && high > 0) show(box, wide, high, ratio, &root);
    root.sheet.scale = root.pixel == 1 ? BAT_PX_MILLIMETRES
                                       : one * even(BAT_PX_MILLIMETRES / one / root.pixel);
    *out = root;
}

typedef struct root_sides {
    const char *width, *height; /* NULL: not said */
    char room[2][BAT_SVG_SIDE_ROOM];
} root_sides;

static void find_sides(const bat_svg_walk *w, root_sides *out) {
    const char *style = bat_svg_attribute_of(w, 1, "style");
    const size_t size = style ? strlen(style) : 0;
    out->width = bat_svg_root_side(style, size, "width", bat_svg_attribute_of(w, 1, "width"), out->room[0]);
    out->height = bat_svg_root_side(style, size, "height", bat_svg_attribute_of(w, 1, "height"),
                                    out->room[1]);
}

static double side_length(const char *text) {
    double value;
    return text && bat_svg_length(text, 0, &value) ? value : 0;
}

/* Gives the document its page and its physical size; stretch: what is done to the drawing where width and height do not keep
 * its proportions. boxed: there is a viewBox, which is w->page. */
static void size_document(bat_svg_walk *w, bool boxed, const root_sides *sides, double stretch[6]) {
    bat_svg_root root;
    bat_svg_root_read(w->page, boxed, sides->width, sides->height,
                      bat_svg_attribute_of(w, 1, "preserveAspectRatio"), &root);
    bat_matrix_identity(stretch);
    stretch[0] = root.stretch[0], stretch[3] = root.stretch[1];
    w->pixel = root.pixel;
    bat_document_set_page(w->document, root.sheet.page);
    (void)bat_document_set_scale(w->document, root.sheet.scale, root.sheet.unit);
}

/* The outermost viewBox defines the user units and the page; without one, width and height define the page. */
void bat_svg_draw_root(bat_svg_walk *w) {
    w->draw = draw;
    bat_svg_scope none = {.style = bat_svg_style_initial(), .opacity = 1, .width = 100, .height = 100};
    none.style.store = &w->variables;
    bat_matrix_identity(none.matrix);
    double page[4] = {0};
    root_sides sides;
    find_sides(w, &sides);
    const char *box = bat_svg_attribute_of(w, 1, "viewBox"),
               *transform = bat_svg_attribute_of(w, 1, "transform");
    if (!box || !bat_svg_view_box(box, page)) {
        page[0] = page[1] = 0;
        page[2] = side_length(sides.width), page[3] = side_length(sides.height);
    }
    if (!(page[2] > 0 && page[3] > 0)) memset(page, 0, sizeof page);
    if (page[2] > 0) none.width = page[2], none.height = page[3];
    memcpy(w->page, page, sizeof w->page);
    bat_svg_scope s = none;
    double stretch[6], own[6];
    size_document(w, box, &sides, stretch);
    bat_svg_cascade(w, 1, &none, &s.style);
    s.opacity = s.style.opacity;
    bat_matrix_identity(own);
    if (transform && !bat_svg_transform(transform, own)) bat_svg_note(&w->notes, 1, BAT_LOSS_BROKEN);
    bat_matrix_compose(stretch, own, s.matrix);
    bat_svg_note_element(w, 1);
    bat_svg_note_own_style(w, 1, &s.style);
    if (bat_svg_geometry_declared(&s.style) & BAT_DECLARED_MATRIX)
        bat_svg_note(&w->notes, 1, BAT_LOSS_BROKEN); /* of the whole picture */
    if (!s.style.shown) {
        bat_svg_note(&w->notes, 1, BAT_LOSS_INVISIBLE);
        return;
    }
    bat_svg_place(w, 1, &none, &s);
    w->given[w->depth] = 0;
    w->active[w->depth++] = 1;
    bat_svg_draw_children(w, 1, &s);
    w->depth--;
    if (s.opacity < 1 && w->put > 1 && bat_svg_overlap(w, 0)) bat_svg_note(&w->notes, 1, BAT_LOSS_OPACITY);
}
