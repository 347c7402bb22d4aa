/* What was written is compared with the document, object by object: place, paint, visibility. */
#include "base/real.h"
#include "document/kind.h"
#include "document/nesting.h"
#include "format/svg/write/covered.h"
#include "format/svg/write/patch.h"

#include <math.h>
#include <string.h>

/* Two documents that ought to show the same, the second from `next` on. */
typedef struct seen {
    const bat_document *document, *again;
    int next;
    double slack;
    bool clipped;
    bat_nesting around; /* of the second */
} seen;

static bool near(double a, double b) { return fabs(a - b) <= 1e-3 * fmax(fabs(a), fabs(b)); }

static bool same_gradient(const bat_gradient *a, const bat_gradient *b) {
    if (a->count != b->count || !a->tile != !b->tile) return false;
    for (size_t i = 0; i < a->count; i++)
        if (a->stops[i].colour != b->stops[i].colour) return false;
    return true;
}

/* Of what is painted. */
static bool same_paint(const bat_object *one, const bat_object *other) {
    static const bat_paint plain = {0};
    const bat_style *a = bat_object_style(one), *b = bat_object_style(other);
    const bat_paint *p = bat_object_paint(one) ? bat_object_paint(one) : &plain,
                    *q = bat_object_paint(other) ? bat_object_paint(other) : &plain;
    if (a->filled != b->filled || a->stroked != b->stroked) return false;
    if (a->filled && (a->even_odd != b->even_odd || !same_gradient(&p->fill, &q->fill) ||
                      (p->fill.count == 0 && a->fill != b->fill)))
        return false;
    if (!a->stroked) return true;
    return same_gradient(&p->stroke, &q->stroke) && (p->stroke.count > 0 || a->stroke == b->stroke) &&
           near(a->width, b->width) && a->cap == b->cap && a->join == b->join &&
           (a->join != BAT_JOIN_MITER || near(a->miter_limit, b->miter_limit)) &&
           p->dash_count == q->dash_count && (!a->filled || p->stroke_first == q->stroke_first);
}

/* Whether they are in the same place, which is all that is known of what is foreign. */
static bool same_place(const bat_object *one, const bat_object *other, double slack) {
    double a[4], b[4];
    if (bat_object_is_foreign(one) && bat_object_is_foreign(other)) return true; /* their boxes are guesses */
    bat_object_bounds(one, a);
    bat_object_bounds(other, b);
    for (int j = 0; j < 4; j++)
        if (!(fabs(a[j] - b[j]) <= slack)) return false;
    return true;
}

/* The next drawn thing of the second document; NULL: there is none. */
static const bat_object *next_drawn(seen *s, bat_nesting_level *level) {
    const bat_object *other;
    while ((other = bat_document_at(s->again, s->next++))) {
        *level = (bat_nesting_level){0};
        bat_nesting_next(&s->around, other, level);
        if (bat_object_is_drawn(other)) return other;
    }
    return NULL;
}

/* Whether the next drawn thing of the second document looks as that one, which shows the object or a part of it. How translucent
 * it is may be said by it or by what is around it. */
static bat_status find_next(seen *s, const bat_object *object, const bat_object *shown,
                            const bat_nesting_level *level, bool *differs) {
    bat_nesting_level its = {0};
    const bat_object *other = next_drawn(s, &its);
    if (!other) return BAT_UNSUPPORTED;
    const double opacity = bat_object_style(object)->opacity * level->around,
                 is = bat_object_style(other)->opacity * its.around;
    if (!same_place(shown, other, s->slack) || level->hidden != its.hidden) *differs = true;
    if (bat_object_is_foreign(shown) && bat_object_is_foreign(other)) return BAT_OK;
    if (!bat_object_markers(shown) != !bat_object_markers(other)) *differs = true;
    if (!level->hidden && fabs(opacity - is) > 0.5 / 255) *differs = true;
    if (!level->hidden && !bat_object_picture(shown) && !same_paint(shown, other)) *differs = true;
    return s->clipped && !bat_svg_same_clip(s->document, object, s->again, other, s->slack) ? BAT_UNSUPPORTED
                                                                                            : BAT_OK;
}

/* The object, or the two parts that stand for it. */
static bat_status find_shown(seen *s, const bat_object *object, const bat_nesting_level *level,
                             bool *differs) {
    bat_object *parts[2] = {NULL};
    bool group = false;
    if (!bat_object_widths(object).count) return find_next(s, object, object, level, differs);
    bat_status status = bat_object_parts(object, parts, &group);
    for (int j = 0; j < 2; j++) {
        if (status == BAT_OK && parts[j]) status = find_next(s, object, parts[j], level, differs);
        bat_object_release(parts[j]);
    }
    return status;
}

bat_status bat_svg_patch_compare(bat_svg_plan *plan, const bat_document *again, bool *differs) {
    const bat_document *document = plan->document;
    bat_status status = BAT_OK;
    double all[4];
    bat_document_bounds(document, all);
    const double slack = 1e-3 * fmax(1, bat_hypot(all[2] - all[0], all[3] - all[1]));
    seen s = {document,    again, 0, slack, bat_svg_is_clipped(document) || bat_svg_is_clipped(again),
              {.depth = 0}};
    bat_nesting around = {.depth = 0};
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bool own = false;
        bat_nesting_next(&around, object, &level);
        if (!bat_object_is_drawn(object) || !(bat_object_style(object)->stroked ||
                                              bat_object_style(object)->filled || bat_object_markers(object)))
            continue;
        status = find_shown(&s, object, &level, &own);
        if (!own) continue;
        *differs = true;
        const bat_sourced *entry = bat_svg_plan_entry(plan, i);
        if (!entry || entry->copied) continue;
        plan->fate[entry->element] |= BAT_SVG_INSISTS;
        plan->fate[entry->element] &= (uint8_t)~BAT_SVG_SHAPED;
    }
    if (status == BAT_OK && next_drawn(&s, &(bat_nesting_level){0})) status = BAT_UNSUPPORTED;
    return status;
}
