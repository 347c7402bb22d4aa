/* Clip paths: what of an element is seen. */
#include "document/clip.h"
#include "base/matrix.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "format/svg/digest.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEP = 8 }; /* clip paths of clip paths */

/* The shapes of a clip path, as they are collected. */
typedef struct region {
    bat_svg_walk *w;
    bat_outline outline; /* of one of them */
    bat_curve **curves;
    int count, room;
    int shapes;
    bool even_odd;    /* the last one is */
    bool exact;       /* what has been collected says all that there is */
    const char *clip; /* the last one's own */
    uint64_t digest;
} region;

static void release(region *r) {
    for (int i = 0; i < r->count; i++) bat_curve_free(r->curves[i]);
    free(r->curves);
    bat_outline_free(&r->outline);
}

/* ---- shapes ---- */

/* Twice the area that the handles of all subpaths go round; its sign is what matters. */
static double turning(const bat_outline *o) {
    double sum = 0;
    for (int i = 0; i < o->subpath_count; i++) {
        const double *p = o->points + 2 * o->subpaths[i].first;
        const size_t count = 3 * (size_t)o->subpaths[i].segments + 1;
        for (size_t k = 0; k < count; k++) {
            const double *a = p + 2 * k, *b = p + 2 * ((k + 1) % count);
            sum += a[0] * b[1] - a[1] * b[0];
        }
    }
    return sum;
}

static void turn_round(bat_outline *o) {
    for (int i = 0; i < o->subpath_count; i++) {
        double *low = o->points + 2 * o->subpaths[i].first;
        double *high = low + 6 * (size_t)o->subpaths[i].segments;
        for (; low < high; low += 2, high -= 2)
            for (int k = 0; k < 2; k++) {
                const double kept = low[k];
                low[k] = high[k];
                high[k] = kept;
            }
    }
}

static void add_curve(region *r, const bat_subpath *path) {
    const double *points = r->outline.points + 2 * path->first;
    bool good = true, moves = false;
    for (size_t k = 0; k < 2 * (3 * (size_t)path->segments + 1); k++) {
        good = good && fabs(points[k]) <= BAT_COORDINATE_MAX;
        moves = moves || points[k] != points[k % 2];
    }
    if (good && !moves) return; /* it encloses nothing */
    if (r->count == r->room) {
        const int room = 2 * r->room + 4;
        bat_curve **grown = realloc(r->curves, (size_t)room * sizeof *grown);
        if (!grown) {
            r->w->status = BAT_MEMORY;
            return;
        }
        r->curves = grown;
        r->room = room;
    }
    double error;
    const bat_status status = good ? bat_curve_from_bezier(2, 3, path->closed, path->segments, points,
                                                           r->w->options->corner, 0, &r->curves[r->count],
                                                           &error)
                                   : BAT_NUMBER;
    if (status == BAT_MEMORY) r->w->status = status;
    if (status == BAT_OK || status == BAT_TOLERANCE)
        r->count++;
    else
        r->exact = false;
}

/* m: from the shape's units. Shapes all go round in the same sense, so that together they enclose what each does. */
static void add_shape(region *r, uint32_t element, const bat_svg_scope *s, const double m[6]) {
    bat_svg_walk *w = r->w;
    bat_svg_shape_holder holder;
    const bat_svg_shape shape = bat_svg_shape_of(w, element, s, &holder);
    bat_outline_clear(&r->outline);
    if (!bat_svg_shape_outline(&shape, bat_svg_tree_name(w->tree, element), &r->outline)) r->exact = false;
    if (r->outline.failed || r->outline.full) {
        w->status = r->outline.failed ? BAT_MEMORY : BAT_COUNT;
        return;
    }
    bat_outline_transform(&r->outline, m);
    r->digest = bat_svg_digest_region(r->digest, &r->outline, s->style.clip_even_odd);
    if (turning(&r->outline) < 0) turn_round(&r->outline);
    if (r->shapes > 0 && (r->even_odd || r->clip)) r->exact = false;
    r->even_odd = s->style.clip_even_odd && (r->shapes > 0 || r->outline.subpath_count > 0);
    r->clip = s->style.clip;
    if (r->shapes++ > 0 && ((r->even_odd && r->outline.subpath_count > 1) || r->clip)) r->exact = false;
    for (int i = 0; i < r->outline.subpath_count && w->status == BAT_OK; i++)
        add_curve(r, &r->outline.subpaths[i]);
}

/* The matrix of an element's contents; s: with its style; around: of what it is in. */
static void place(region *r, uint32_t element, const bat_svg_scope *s, const double around[6], double m[6]) {
    double own[6];
    if (bat_svg_matrix_of(r->w, element, s, own) == BAT_SVG_MOVED_BADLY) r->exact = false;
    bat_matrix_compose(around, own, m);
}

/* A shape, or one that is drawn from another place. */
static void add_child(region *r, uint32_t element, const bat_svg_scope *outer, const double around[6],
                      bool used) {
    bat_svg_walk *w = r->w;
    const bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    if (kind == BAT_SVG_TEXT) r->exact = false;
    if (kind != BAT_SVG_SHAPE && (kind != BAT_SVG_USE || used)) return;
    if (++w->drawn > BAT_SVG_DRAWN_MAX || w->tried > BAT_SVG_TRIED_MAX) {
        w->status = BAT_COUNT;
        return;
    }
    bat_svg_scope s = *outer;
    double m[6];
    bat_svg_cascade(w, element, outer, &s.style);
    if (!s.style.shown) return;
    place(r, element, &s, around, m);
    if (kind == BAT_SVG_SHAPE) {
        if (s.style.visible) add_shape(r, element, &s, m);
        return;
    }
    const char *href = bat_svg_find_href(w, element);
    const uint32_t target = href && href[0] == '#' ? bat_svg_tree_find(w->tree, href + 1) : 0;
    const double by[6] = {1,
                          0,
                          0,
                          1,
                          bat_svg_geometry_length(w, element, &s.style, "x", s.width, 0),
                          bat_svg_geometry_length(w, element, &s.style, "y", s.height, 0)};
    double moved[6];
    bat_matrix_compose(m, by, moved);
    if (s.style.clip) r->exact = false;
    if (target) add_child(r, target, &s, moved, true);
}

/* ---- clip paths ---- */

static uint32_t find(const bat_svg_walk *w, const char *server) {
    const uint32_t found = server ? bat_svg_tree_refer(w->tree, server) : 0;
    return found && strcmp(bat_svg_tree_name(w->tree, found), "clipPath") == 0 ? found : 0;
}

static bool is_boxed(const bat_svg_walk *w, uint32_t element) {
    const char *units = bat_svg_attribute_of(w, element, "clipPathUnits");
    return units && strcmp(units, "objectBoundingBox") == 0;
}

/* The region of a clip path, within that of its own clip path, that of its only shape, and `within`. m: from the units of what
 * is clipped. */
static bool build(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double m[6],
                  const bat_clip *within, int deep, bat_clip **out, uint64_t *digest) {
    bat_svg_scope inner = *s;
    region r = {.w = w, .exact = true, .digest = *digest};
    bat_clip *around = bat_clip_retain(within);
    double own[6];
    bat_svg_cascade_in_place(w, element, &inner);
    place(&r, element, &inner, m, own);
    const char *const clip = inner.style.clip;
    for (uint32_t at = w->tree->elements[element].first; at && w->status == BAT_OK;
         at = w->tree->elements[at].next)
        add_child(&r, at, &inner, own, false);
    const char *const more[2] = {clip, r.clip};
    for (int k = 0; k < 2 && w->status == BAT_OK; k++) {
        const uint32_t other = find(w, more[k]);
        bat_clip *next = NULL;
        if (!other) continue;
        if (deep == DEEP || is_boxed(w, other)) {
            r.exact = false;
            continue;
        }
        r.exact = build(w, other, s, m, around, deep + 1, &next, &r.digest) && r.exact;
        if (!next) continue;
        bat_clip_release(around);
        around = next;
    }
    bat_status status = w->status;
    if (status == BAT_OK)
        status = bat_clip_create(r.count, r.curves, r.even_odd && r.shapes == 1, around, out);
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK) r.exact = false;
    *digest = r.digest;
    bat_clip_release(around);
    release(&r);
    return r.exact;
}

void bat_svg_clip_begin(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_scope *s) {
    static const double same[6] = {1, 0, 0, 1, 0, 0};
    const bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    const uint32_t target = kind == BAT_SVG_TEXT ? 0 : find(w, s->style.clip);
    s->clip = bat_clip_retain(outer->clip);
    s->boxed = NULL;
    if (s->style.clip && !bat_svg_tree_refer(w->tree, s->style.clip)) /* as if it said none */
        s->style.odd &= ~BAT_SVG_BIT(BAT_SVG_CLIP);
    if (!target) return;
    const bool boxed = is_boxed(w, target);
    if (boxed && kind != BAT_SVG_SHAPE && kind != BAT_SVG_GROUP && kind != BAT_SVG_IMAGE) return;
    bat_svg_scope units = *s;
    if (boxed) units.width = units.height = 1;
    bat_clip *made = NULL;
    const bool exact = build(w, target, &units, boxed ? same : s->matrix, boxed ? NULL : s->clip, 0, &made,
                             &s->clip_digest);
    if (exact) s->style.odd &= ~BAT_SVG_BIT(BAT_SVG_CLIP);
    if (boxed) {
        s->boxed = made;
    } else if (made) {
        bat_clip_release(s->clip);
        s->clip = made;
    }
}

void bat_svg_clip_end(bat_svg_scope *s) {
    bat_clip_release(s->clip);
    bat_clip_release(s->boxed);
}

bat_status bat_svg_clip_object(const bat_svg_scope *s, const double box[4], bat_object **object) {
    bat_clip *own = NULL, *all = NULL;
    bat_object *made = NULL;
    bat_status status = BAT_OK;
    if (!s->clip && !s->boxed) return BAT_OK;
    if (s->boxed && box[0] < box[2] && box[1] < box[3]) {
        const double m[6] = {box[2] - box[0], 0, 0, box[3] - box[1], box[0], box[1]};
        double to[6];
        bat_matrix_compose(s->matrix, m, to);
        status = bat_clip_mapped(s->boxed, to, &own);
    }
    if (status == BAT_OK) status = bat_clip_join(own, s->clip, &all);
    if (status == BAT_OK && all) status = bat_object_with_clip(*object, all, &made);
    bat_clip_release(own);
    bat_clip_release(all);
    if (!made) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

/* The box of what is in the group, in the group's units. */
static void box_within(const bat_svg_walk *w, int index, const double matrix[6], double box[4]) {
    double back[6];
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    if (!bat_svg_inverse(matrix, back)) return;
    for (int i = index + 1; i < bat_document_count(w->document); i++) {
        double own[4];
        if (bat_object_is_hidden(bat_document_at(w->document, i))) i = bat_document_end(w->document, i) - 1;
        if (!bat_object_is_drawn(bat_document_at(w->document, i)) ||
            bat_object_is_hidden(bat_document_at(w->document, i)))
            continue;
        bat_object_bounds(bat_document_at(w->document, i), own);
        for (int k = 0; k < 4; k++) {
            const double x = own[k & 1 ? 2 : 0], y = own[k & 2 ? 3 : 1];
            const double at[2] = {back[0] * x + back[2] * y + back[4], back[1] * x + back[3] * y + back[5]};
            for (int j = 0; j < 2; j++) {
                box[j] = fmin(box[j], at[j]);
                box[j + 2] = fmax(box[j + 2], at[j]);
            }
        }
    }
}

/* A mask that is placed by the box. */
static void mask_group(bat_svg_walk *w, uint32_t element, bat_svg_scope *s, int index) {
    const uint64_t before = s->clip_digest;
    double box[4];
    if (!s->mask || !bat_svg_mask_is_boxed(w, s)) return;
    bool exact = s->matrix[1] == 0 && s->matrix[2] == 0; /* else the box is not quite that of the contents */
    for (int i = index + 1; i < bat_document_count(w->document); i++)
        exact = exact && !bat_object_is_foreign(bat_document_at(w->document, i));
    box_within(w, index, s->matrix, box);
    if (exact)
        bat_svg_mask_paint(w, element, box, s);
    else
        bat_svg_note(&w->notes, element, BAT_LOSS_MASK);
    if (s->clip_digest != before && !w->unseen) w->digest = bat_digest_number(w->digest, s->clip_digest);
}

void bat_svg_clip_group(bat_svg_walk *w, uint32_t element, bat_svg_scope *s, int index) {
    double box[4] = {0, 0, 0, 0};
    mask_group(w, element, s, index);
    if (!s->clip && !s->boxed) return;
    bat_object *object = bat_object_retain(bat_document_at(w->document, index));
    if (s->boxed) {
        box_within(w, index, s->matrix, box);
        const bool turned = s->matrix[1] != 0 || s->matrix[2] != 0;
        if (turned)
            bat_svg_note(&w->notes, element, BAT_LOSS_CLIP); /* the box is not quite that of the contents */
    }
    const bat_status status = bat_svg_clip_object(s, box, &object);
    if (status == BAT_OK)
        bat_document_replace(w->document, index, object);
    else if (status == BAT_MEMORY)
        w->status = status;
    bat_object_release(object);
}
