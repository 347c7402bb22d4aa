/* What is not edited becomes foreign content: texts, pictures in other formats, and whatever has a filter, or a mask, a
 * pattern or markers that cannot be painted. */
#include "base/box.h"
#include "base/matrix.h"
#include "document/document.h"
#include "document/kind.h"
#include "format/svg/alone.h"
#include "format/svg/digest.h"
#include "format/svg/geometry.h"

#include <math.h>
#include <string.h>

void bat_svg_box_through(const double m[6], const double own[4], double box[4]) {
    for (int i = 0; i < 2; i++) box[i] = INFINITY, box[i + 2] = -INFINITY;
    for (int i = 0; i < 4; i++) {
        const double x = own[i & 1 ? 2 : 0], y = own[i & 2 ? 3 : 1];
        const double at[2] = {m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]};
        for (int k = 0; k < 2; k++) box[k] = fmin(box[k], at[k]), box[k + 2] = fmax(box[k + 2], at[k]);
    }
}

/* Puts the element into the document as it looks in that box of the document. False: it cannot be. */
static bool put(bat_svg_walk *w, uint32_t element, const double box[4], bat_object **out) {
    bat_picture *picture = NULL;
    double m[6];
    bat_status status = bat_svg_alone(w, element, box, &picture);
    if (status == BAT_OK) status = bat_pictures_add(&w->pictures, picture);
    if (status == BAT_OK && !bat_drawing_matrix(picture, m)) status = BAT_NUMBER;
    if (status == BAT_OK)
        status = bat_object_create_foreign(bat_document_new_id(w->document), bat_svg_find_name(w, element),
                                           picture, m, 1, out);
    bat_picture_release(picture);
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK) return false;
    if (w->unseen)
        w->report->hidden++;
    else
        w->digest = bat_svg_digest_image(w->digest, bat_object_picture(*out), bat_object_matrix(*out), 1);
    return true;
}

/* The same, in that box of its own units, in its place among the objects. */
static bool put_within(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double own[4]) {
    double box[4];
    bat_object *object = NULL;
    bat_svg_box_through(s->matrix, own, box);
    if (!put(w, element, box, &object)) return false;
    bat_svg_put_object(w, element, s->style.shown, object);
    return true;
}

bool bat_svg_draw_text(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    double own[4];
    if (strcmp(bat_svg_tree_name(w->tree, element), "text") != 0)
        return false; /* others show what never was in SVG */
    if (!bat_svg_may_stand_alone(w) || !s->style.visible) return false;
    if (bat_svg_draw_lettering(w, element, s)) return true;
    if (!bat_svg_text_box(w, element, s, own)) return false;
    return put_within(w, element, s, own);
}

bool bat_svg_draw_other_image(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const char *href = bat_svg_find_href(w, element);
    double own[4];
    if (!bat_svg_may_stand_alone(w) || !href || strncmp(href, "data:image/", 11) != 0) return false;
    own[0] = bat_svg_geometry_length(w, element, &s->style, "x", s->width, 0);
    own[1] = bat_svg_geometry_length(w, element, &s->style, "y", s->height, 0);
    own[2] = own[0] + bat_svg_geometry_length(w, element, &s->style, "width", s->width, 0);
    own[3] = own[1] + bat_svg_geometry_length(w, element, &s->style, "height", s->height, 0);
    if (!(own[0] < own[2] && own[1] < own[3])) return false;
    return put_within(w, element, s, own);
}

/* ---- whatever has an effect ---- */

/* The region of a filter in parts of the box, as far as it is one. */
static void filter_region(const bat_svg_walk *w, const char *value, double region[4]) {
    static const char *const names[] = {"x", "y", "width", "height"};
    const char *at = strstr(value, "url(");
    const uint32_t filter = at ? bat_svg_tree_refer(w->tree, at + 4) : 0;
    const char *units = filter ? bat_svg_attribute_of(w, filter, "filterUnits") : NULL;
    const double given[4] = {-0.1, -0.1, 1.2, 1.2};
    double own[4];
    for (int i = 0; i < 4; i++)
        own[i] = filter && !(units && !strcmp(units, "userSpaceOnUse"))
                     ? bat_svg_length_of(w, filter, names[i], 1, given[i])
                 : i < 2 ? -0.5
                         : 2;
    for (int i = 0; i < 2; i++) {
        region[i] = fmax(-4, fmin(0, own[i]));
        region[i + 2] = fmin(5, fmax(1, own[i] + own[i + 2]));
    }
}

bool bat_svg_covers(const bat_object *object, double box[4]) {
    const bat_style *style = bat_object_style(object);
    if (!bat_object_is_drawn(object)) return false;
    bat_object_bounds(object, box);
    const double share = style->join == BAT_JOIN_MITER ? fmin(style->miter_limit, 4) : 1.5,
                 more = style->stroked ? style->width / 2 * share : 0;
    for (int k = 0; k < 2; k++) box[k] -= more, box[k + 2] += more;
    return true;
}

/* Whether an object of from..to-1 may meet one that comes later, from `next` on. */
static bool may_meet(const bat_svg_walk *w, int from, int to, int next) {
    enum { MOST = 1 << 20 }; /* pairs */
    const int end = bat_document_count(w->document);
    double a[4], b[4];
    if ((double)(to - from) * (end - next) > MOST) return true;
    for (int i = from; i < to; i++) {
        const bat_object *one = bat_document_at(w->document, i);
        if (bat_object_markers(one)) return true;
        if (!bat_svg_covers(one, a)) continue;
        for (int k = next > i ? next : i + 1; k < end; k++) {
            const bat_object *other = bat_document_at(w->document, k);
            if (bat_object_markers(other)) return true;
            if (bat_svg_covers(other, b) && a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3])
                return true;
        }
    }
    return false;
}

bool bat_svg_overlap(const bat_svg_walk *w, int from) {
    const int count = bat_document_count(w->document);
    const bool grouped = from < count && bat_document_end(w->document, from) == count;
    return !grouped && may_meet(w, from, count, from);
}

bool bat_svg_lies_over(const bat_svg_walk *w, int from) { return may_meet(w, 0, from, from); }

/* What the objects from an index on cover, with their strokes, markers that reach so far, and what a filter adds. */
static bool covered(const bat_svg_walk *w, int from, double reach, const double region[4], double box[4]) {
    bat_box_nothing(box);
    for (int i = from; i < bat_document_count(w->document); i++) {
        const bat_object *object = bat_document_at(w->document, i);
        double own[4], bare[4];
        if (!bat_svg_covers(object, own)) continue;
        bat_object_bounds(object, bare);
        for (int k = 0; k < 2; k++) {
            own[k] = fmin(own[k], bare[k] - reach);
            own[k + 2] = fmax(own[k + 2], bare[k + 2] + reach);
        }
        bat_box_hold(box, own);
    }
    if (!(box[0] < box[2] && box[1] < box[3])) return false;
    const double low[2] = {box[0], box[1]}, side[2] = {box[2] - box[0], box[3] - box[1]};
    for (int k = 0; k < 2; k++) {
        box[k] = low[k] + region[k] * side[k];
        box[k + 2] = low[k] + region[k + 2] * side[k];
    }
    return true;
}

static const char *filter_of(const bat_svg_walk *w, uint32_t element) {
    const char *value = bat_svg_attribute_of(w, element, "filter"),
               *style = bat_svg_attribute_of(w, element, "style");
    const char *own = style ? strstr(style, "filter:") : NULL;
    return own ? own : value ? value : "";
}

bool bat_svg_effect_end(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                        const bat_svg_before *before) {
    double region[4] = {0, 0, 1, 1}, box[4];
    const double reach = bat_svg_marker_reach(w, element, s);
    bat_object *object = NULL;
    if (s->style.odd & BAT_SVG_BIT(BAT_SVG_FILTER)) filter_region(w, filter_of(w, element), region);
    const uint64_t digest = w->digest;
    w->digest = before->digest;
    if (w->status != BAT_OK || !covered(w, before->objects, reach, region, box) ||
        !put(w, element, box, &object)) {
        w->digest = digest;
        return false;
    }
    for (int i = bat_document_count(w->document) - 1; i >= before->objects; i--)
        bat_document_remove(w->document, i);
    w->members = before->members;
    w->put = before->put;
    w->report->paths = before->paths;
    w->report->curves = before->curves;
    w->report->hidden = before->hidden + (w->unseen > 0);
    *w->notes.lost = before->lost;
    bat_svg_put_object(w, element, s->style.shown, object);
    return true;
}
