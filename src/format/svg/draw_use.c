/* Elements drawn from another place or in a viewport of their own: use, symbol, nested svg. */
#include "base/matrix.h"
#include "document/document.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"

/* Whether objects from an index on reach beyond that box in the units of the matrix. */
static bool reaches_beyond(const bat_svg_walk *w, int from, const double m[6], const double view[4]) {
    const double slack = 1e-6 * (view[2] - view[0] + view[3] - view[1]);
    double back[6];
    if (!bat_svg_inverse(m, back)) return true;
    for (int i = from; i < bat_document_count(w->document); i++) {
        double all[4], own[4];
        if (!bat_svg_covers(bat_document_at(w->document, i), all)) continue;
        bat_svg_box_through(back, all, own);
        for (int k = 0; k < 2; k++)
            if (own[k] < view[k] - slack || own[k + 2] > view[k + 2] + slack) return true;
    }
    return false;
}

/* Draws a nested svg, or a symbol referred to by use: a viewport with its own units. sizer: the element whose
 * width and height count. */
static void draw_viewport(bat_svg_walk *w, uint32_t element, uint32_t sizer, double x, double y,
                          const bat_svg_scope *s) {
    bat_svg_scope inner = *s;
    const char *text = bat_svg_attribute_of(w, element, "viewBox");
    double width = bat_svg_length_of(w, element, "width", s->width, s->width), box[4], m[6];
    double height = bat_svg_length_of(w, element, "height", s->height, s->height);
    width = bat_svg_length_of(w, sizer, "width", s->width, width);
    height = bat_svg_length_of(w, sizer, "height", s->height, height);
    if (!(width > 0 && height > 0)) return;
    if (text && bat_svg_view_box(text, box)) {
        if (box[2] == 0 || box[3] == 0) return;
        bat_svg_fit(box, x, y, width, height, bat_svg_attribute_of(w, element, "preserveAspectRatio"), m);
        inner.width = box[2], inner.height = box[3];
    } else {
        bat_matrix_identity(m);
        m[4] = x, m[5] = y;
        inner.width = width, inner.height = height;
    }
    bat_matrix_compose(s->matrix, m, inner.matrix);
    const int from = bat_document_count(w->document);
    bat_svg_draw_children(w, element, &inner);
    if (!s->style.overflows &&
        (w->collected || reaches_beyond(w, from, s->matrix, (double[4]){x, y, x + width, y + height})))
        bat_svg_note(&w->notes, element, BAT_LOSS_NESTED); /* it would be cut off there */
}

/* An svg element within the outermost one. */
void bat_svg_draw_nested(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    draw_viewport(w, element, element, bat_svg_length_of(w, element, "x", s->width, 0),
                  bat_svg_length_of(w, element, "y", s->height, 0), s);
}

void bat_svg_draw_use(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const char *href = bat_svg_find_href(w, element);
    uint32_t target = href && href[0] == '#' ? bat_svg_tree_find(w->tree, href + 1) : 0;
    for (int i = 0; i < w->depth; i++)
        if (w->active[i] == target) target = 0; /* it would draw itself */
    if (!target || w->depth == BAT_SVG_DEPTH) {
        const bool elsewhere = href && *href && href[0] != '#'; /* else nobody shows anything */
        bat_svg_note(&w->notes, element, target || elsewhere ? BAT_LOSS_BROKEN : BAT_LOSS_UNKNOWN);
        return;
    }
    double x = bat_svg_geometry_length(w, element, &s->style, "x", s->width, 0),
           y = bat_svg_geometry_length(w, element, &s->style, "y", s->height, 0);
    double m[6] = {1, 0, 0, 1, x, y};
    bat_svg_scope inner = *s;
    bat_matrix_compose(s->matrix, m, inner.matrix);
    bat_svg_kind kind = (bat_svg_kind)w->tree->elements[target].kind;
    if (kind != BAT_SVG_SYMBOL && kind != BAT_SVG_ROOT) {
        w->draw(w, target, &inner);
        return;
    }
    bat_svg_scope own = inner;
    bat_svg_cascade(w, target, &inner, &own.style);
    bat_svg_note_own_style(w, target, &own.style);
    bat_svg_note_odd(&w->notes, target, own.style.odd, BAT_SVG_BIT(BAT_SVG_BLEND));
    own.opacity = inner.opacity * own.style.opacity;
    w->given[w->depth] = 0;
    w->active[w->depth++] = target;
    if (own.style.shown) draw_viewport(w, target, element, 0, 0, &own);
    w->depth--;
}
