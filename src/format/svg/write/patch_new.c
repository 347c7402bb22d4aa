/* What is new or has moved: written behind the thing below it, as high in the file's structure as the drawing's groups
 * and order allow, so that as little as possible of what is around it has an effect on it. */
#include "base/matrix.h"
#include "document/kind.h"
#include "document/lettering.h"
#include "format/svg/write/covered.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"
#include "format/svg/write/basic.h"
#include "format/svg/write/patch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where something is put: in an element, at an offset of the file. */
typedef struct spot {
    uint32_t in;
    size_t at;
    double outer[6]; /* from the units there to the document's */
    double back[6];  /* the inverse */
    double opacity;
} spot;

/* Units and opacity in an element, from anything that is drawn in it. */
static bool look_in(const bat_svg_plan *plan, uint32_t element, spot *s) {
    const uint32_t last = plan->tags.list[element].last;
    for (int k = 0; k < bat_source_count(plan->source); k++) {
        const bat_sourced *entry = bat_source_at(plan->source, k);
        if (entry->element > last) break;
        if (entry->element == element) {
            memcpy(s->outer, entry->inner, sizeof s->outer);
            s->opacity = entry->id ? 1 : entry->opacity; /* a group has its own for what is in it */
        }
        if (entry->element <= element || plan->tags.list[entry->element].parent != element) continue;
        memcpy(s->outer, entry->outer, sizeof s->outer);
        s->opacity = entry->opacity;
        break;
    }
    return bat_svg_inverse(s->outer, s->back);
}

/* below, above: the elements that stay on either side in the order; 0: none. */
static bool find_spot(const bat_svg_patch *p, bat_id parent, uint32_t below, uint32_t above, spot *s) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tags = plan->tags.list;
    const uint32_t group = bat_svg_plan_group(plan, parent);
    const bool within = above && bat_svg_plan_holds(plan, group, above);
    if (below == group) below = 0; /* it is the first in it */
    if (within && below && !bat_svg_plan_holds(plan, group, below)) below = 0;
    uint32_t at = below ? below : above;
    s->in = group;
    s->at = tags[group].close;
    if (at && !below && !within) at = 0;
    if (at) {
        while (tags[at].parent != group && tags[at].parent > 1 &&
               !(below && above && bat_svg_plan_holds(plan, tags[at].parent, above)))
            at = tags[at].parent;
        s->in = tags[at].parent;
        s->at = below ? tags[at].end : tags[at].open;
        if (!below && p->plan.fate[at] & BAT_SVG_GONE) s->at = bat_svg_patch_lead(p, s->at);
    }
    while (s->in > 1 && tags[s->in].body == tags[s->in].end) { /* it has no inside */
        s->at = tags[s->in].end;
        s->in = tags[s->in].parent;
    }
    if (s->in == 0 || tags[s->in].body == tags[s->in].end) return false;
    return look_in(plan, s->in, s);
}

/* The opacities of groups around an object that it is not written in. */
static double missing(const bat_svg_plan *plan, const bat_object *object, uint32_t in) {
    double product = 1;
    for (int depth = 0; depth < BAT_NESTING_MAX && bat_object_parent(object); depth++) {
        const int index = bat_document_find(plan->document, bat_object_parent(object));
        if (index < 0) break;
        const bat_sourced *entry = bat_svg_plan_entry(plan, index);
        object = bat_document_at(plan->document, index);
        if (!entry || !bat_svg_plan_holds(plan, entry->element, in))
            product *= bat_object_style(object)->opacity;
    }
    return product;
}

static bool is_identity(const double m[6]) {
    return m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1 && m[4] == 0 && m[5] == 0;
}

static void write_transform(const double m[6], bat_text *out) {
    if (is_identity(m)) return;
    bat_text_string(out, " transform=\"");
    bat_svg_write_matrix(m, out);
    bat_text_string(out, "\"");
}

static void write_hidden(bat_text *out, const bat_object *object, bool hides) {
    if (hides && !bat_object_is_hidden(object)) bat_text_string(out, " display=\"none\"");
    bat_svg_write_state(out, object);
}

static void write_new(bat_svg_patch *p, const bat_object *object, const spot *s, bool hides);

/* A stroke whose width changes, as what it covers, behind or before the fill: each element is the object's. */
static void write_parts(bat_svg_patch *p, const bat_object *object, const spot *s, bool hides) {
    bat_object *parts[2];
    bool group;
    spot inside = *s;
    const bat_status status = bat_object_parts(object, parts, &group);
    if (status != BAT_OK) {
        p->status = status;
        return;
    }
    const bool two = parts[0] && parts[1]; /* one element, since what it is in may count them */
    if (two) {
        bat_svg_patch_mark(p, bat_object_id(object));
        bat_text_string(&p->made, "<g");
        if (group) {
            const double opacity = bat_object_style(object)->opacity;
            bat_svg_write_number(&p->made, " opacity=\"",
                                 s->opacity > 0 ? fmin(1, opacity / s->opacity) : opacity);
            inside.opacity = 1;
        }
        bat_text_string(&p->made, ">");
    }
    for (int k = 0; k < 2; k++) {
        if (parts[k] && p->status == BAT_OK) write_new(p, parts[k], &inside, hides);
        if (two && p->number) p->number++; /* both have one id */
        bat_object_release(parts[k]);
    }
    if (two) bat_text_string(&p->made, "</g>");
}

static void write_new(bat_svg_patch *p, const bat_object *object, const spot *s, bool hides) {
    if (bat_object_widths(object).count) {
        write_parts(p, object, s, hides);
        return;
    }
    bat_text *out = &p->made;
    bat_style style = *bat_object_style(object);
    if (s->opacity > 0) style.opacity = fmin(1, style.opacity / s->opacity);
    if (bat_object_picture(object)) {
        double m[6], own[6];
        bat_svg_ids ids = {0};
        if (bat_svg_inverse(bat_object_matrix(object), own))
            p->status = bat_svg_write_clip(out, object, own, bat_svg_patch_number(p), &ids);
        bat_svg_patch_mark(p, bat_object_id(object));
        const bat_lettering *lettering = bat_object_lettering(object);
        bat_matrix_compose(s->back, lettering ? bat_object_place(object) : bat_object_matrix(object), m);
        bat_text_string(out, lettering ? "<text" : "<image");
        bat_svg_write_name(out, " data-name=\"", bat_object_name(object));
        write_hidden(out, object, hides);
        if (lettering)
            bat_svg_write_lettering(out, object, m, style.opacity, &ids);
        else
            bat_svg_write_picture(out, bat_object_picture(object), m, style.opacity, &ids);
        return;
    }
    double pen[6], back[6], m[6];
    bat_svg_basic basic;
    const bool uneven = bat_svg_pen(object, pen, back);
    const bool shaped = !uneven && bat_svg_has_basic(object, p->precision, out, &basic);
    if (shaped && bat_svg_inverse(basic.turn, back)) memcpy(pen, basic.turn, sizeof pen);
    bat_svg_ids ids = bat_svg_write_gradients(out, object, back, bat_svg_patch_number(p));
    p->status = bat_svg_write_clip(out, object, back, bat_svg_patch_number(p), &ids);
    bat_svg_patch_markers(p, object, pen, &ids);
    bat_svg_patch_mark(p, bat_object_id(object));
    bat_text_string(out, "<");
    bat_text_string(out, shaped ? basic.name : "path");
    bat_svg_write_name(out, " data-name=\"", bat_object_name(object));
    write_hidden(out, object, hides);
    bat_matrix_compose(s->back, pen, m);
    write_transform(m, out);
    bat_svg_write_style_attribute(out, object, &style, &ids);
    if (shaped) {
        bat_svg_write_basic(out, &basic);
        bat_text_string(out, "/>");
        return;
    }
    bat_text_string(out, " d=\"");
    const bat_status status = bat_svg_write_curves(out, object, uneven ? back : NULL, p->precision);
    if (status != BAT_OK) p->status = status;
    bat_text_string(out, "\"/>");
}

void bat_svg_patch_remake(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry, bool hides) {
    spot s = {.in = p->plan.tags.list[entry->element].parent, .opacity = entry->opacity};
    memcpy(s.outer, entry->outer, sizeof s.outer);
    if (bat_svg_inverse(s.outer, s.back))
        write_new(p, object, &s, hides);
    else
        p->status = BAT_UNSUPPORTED;
}

/* The element as it is, with its start tag as it has to be; where units differ, within a group that makes up for it. */
static void write_moved(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry, const spot *s,
                        bool hides) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[entry->element];
    const bool apart = tag->parent != s->in;
    double m[6];
    if (apart &&
        (bat_object_is_foreign(object) ||
         bat_object_lettering(object))) { /* what it has from the elements around it would be missing */
        write_new(p, object, s, hides);
        return;
    }
    bat_matrix_compose(s->back, entry->outer, m);
    const bool wraps = apart && !is_identity(m);
    if (wraps) {
        bat_text_string(&p->made, "<g");
        write_transform(m, &p->made);
        bat_text_string(&p->made, ">");
    }
    const bat_svg_ids ids = bat_svg_patch_gradients(p, object, entry, apart);
    bat_svg_patch_mark(p, bat_object_id(object));
    bat_sourced there = *entry;
    if (apart) there.opacity = s->opacity;
    const uint8_t left = BAT_SVG_NEEDED | BAT_SVG_TOUCHED; /* as it was, for what refers to it */
    const bool anonymous = (plan->fate[entry->element] & left) == left;
    if (!bat_svg_patch_tag(p, object, &there, apart, hides, anonymous, &ids))
        bat_text_add(&p->made, plan->text + tag->open, tag->body - tag->open);
    bat_text_add(&p->made, plan->text + tag->body, tag->close - tag->body);
    bat_svg_patch_end_tag(p, object, entry);
    if (wraps) bat_text_string(&p->made, "</g>");
}

static void write_one(bat_svg_patch *p, int index, const spot *s) {
    const bat_object *object = bat_document_at(p->plan.document, index);
    const bool hides = p->plan.hidden[index];
    const bat_sourced *entry = bat_svg_plan_entry(&p->plan, index);
    if (p->plan.stay[index] == BAT_SVG_MOVED && !bat_svg_is_remade(object, entry))
        write_moved(p, object, entry, s, hides);
    else if (bat_object_curve_count(object) > 0 || bat_object_picture(object))
        write_new(p, object, s, hides);
}

/* A group in which nothing stays where it was is written as one; its members are in it. */
static bool is_new_group(const bat_svg_plan *plan, int index, int end) {
    if (!bat_object_is_group(bat_document_at(plan->document, index))) return false;
    for (int i = index; i < end; i++)
        if (bat_svg_is_placed(plan, i)) return false;
    return end > index + 1;
}

static void write_group(bat_svg_patch *p, int index, int end, const spot *s) {
    const bat_document *document = p->plan.document;
    int open[BAT_NESTING_MAX], depth = 0;
    for (int i = index; i < end; i++) {
        const bat_object *object = bat_document_at(document, i);
        while (depth > 0 && i >= open[depth - 1]) {
            bat_text_string(&p->made, "</g>");
            depth--;
        }
        if (!bat_object_is_group(object)) {
            if (bat_object_is_drawn(object)) write_one(p, i, s);
            continue;
        }
        if (depth == BAT_NESTING_MAX) continue;
        bat_svg_ids ids = {0};
        const bat_status status = bat_svg_write_clip(&p->made, object, s->back, bat_svg_patch_number(p),
                                                     &ids);
        if (status != BAT_OK) p->status = status;
        bat_svg_patch_mark(p, bat_object_id(object));
        bat_text_string(&p->made, "<g");
        bat_svg_refer_clip(&p->made, &ids);
        bat_svg_write_name(&p->made, " data-name=\"", bat_object_name(object));
        bat_svg_write_state(&p->made, object);
        if (bat_object_style(object)->opacity != 1)
            bat_svg_write_number(&p->made, " opacity=\"", bat_object_style(object)->opacity);
        bat_text_string(&p->made, ">");
        open[depth++] = bat_document_end(document, i);
    }
    while (depth-- > 0) bat_text_string(&p->made, "</g>");
}

/* The place of the element that drew something from another place, which gives way to it. */
static bool find_copy(const bat_svg_patch *p, uint32_t element, spot *s) {
    const bat_svg_tag *tag = &p->plan.tags.list[element];
    s->in = tag->parent;
    s->at = tag->end;
    return look_in(&p->plan, s->in, s);
}

/* The line breaks and spaces before an element, so that what is put beside it looks like it. */
static void write_indent(bat_svg_patch *p, const spot *s, bool before) {
    const char *text = p->plan.text;
    size_t at = s->at;
    if (!before) {
        bat_text_string(&p->made, "\n");
        return;
    }
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) at--;
    bat_text_string(&p->made, "\n");
    bat_text_add(&p->made, text + at, s->at - at);
}

/* Of each of the places from..to: the element of the first thing from there on that stays, or 0. NULL: out of memory. */
static uint32_t *find_above(const bat_svg_plan *plan, int from, int to) {
    uint32_t *above = calloc((size_t)(to - from) + 1, sizeof *above);
    for (int i = from, next; above && i < to; i = next) {
        next = plan->stay[i] == BAT_SVG_CARRIED ? bat_document_end(plan->document, i) : i + 1;
        above[i - from] = bat_svg_plan_anchor(plan, i);
    }
    for (int i = to - from - 1; above && i >= 0; i--)
        if (!above[i]) above[i] = above[i + 1];
    return above;
}

/* The objects from..to-1, among which one is below the other in the file as well. */
static void write_all(bat_svg_patch *p, int from, int to) {
    const bat_svg_plan *plan = &p->plan;
    uint32_t below = 0, *above = find_above(plan, from, to);
    if (!above) p->status = BAT_MEMORY;
    for (int i = from, end; i < to && p->status == BAT_OK; i = end) {
        const bat_object *object = bat_document_at(plan->document, i);
        end = i + 1;
        const uint32_t anchor = bat_svg_plan_anchor(plan, i);
        if (anchor) below = anchor;
        const int last = bat_document_end(plan->document, i);
        const bool carried = plan->stay[i] == BAT_SVG_CARRIED, group = carried || is_new_group(plan, i, last);
        if (!group && (plan->stay[i] == BAT_SVG_STAYS || !bat_object_is_drawn(object))) continue;
        if (group) end = last;
        const uint32_t element = carried ? bat_svg_plan_entry(plan, i)->element : 0;
        const uint32_t copy = plan->copy[i];
        spot s;
        if (!(copy ? find_copy(p, copy, &s)
                   : find_spot(p, bat_object_parent(object), below, above[end - from], &s)) ||
            (carried && s.in != plan->tags.list[element].parent)) {
            p->status = BAT_UNSUPPORTED;
            break;
        }
        s.opacity /= fmax(missing(plan, object, s.in), 1e-9);
        const size_t made = p->made.size;
        const bool behind = below != 0;
        if (copy) {
            const size_t open = plan->tags.list[copy].open, lead = bat_svg_patch_lead(p, open);
            bat_text_add(&p->made, plan->text + lead, open - lead);
        } else if (behind)
            write_indent(p, &s, false);
        if (carried) {
            bat_svg_patch_edit(p, made, s.at, 0);
            bat_svg_patch_carry(p, element, s.at);
            const size_t behind_it = p->made.size;
            if (!behind) write_indent(p, &s, true);
            if (!behind) bat_svg_patch_edit(p, behind_it, s.at, 0);
            if (p->status == BAT_OK) write_all(p, i + 1, last);
            continue;
        }
        if (group)
            write_group(p, i, end, &s);
        else
            write_one(p, i, &s);
        if (!behind) write_indent(p, &s, true);
        bat_svg_patch_edit(p, made, s.at, 0);
    }
    free(above);
}

void bat_svg_patch_new(bat_svg_patch *p) { write_all(p, 0, p->plan.count); }
