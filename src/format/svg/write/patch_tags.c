/* Elements that stay: their start tags, with what was edited and no more. */
#include "base/matrix.h"
#include "document/digest.h"
#include "document/kind.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"
#include "format/svg/alone.h"
#include "format/svg/write/patch.h"
#include "format/svg/write/retag.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NUMBER = BAT_NUMBER_ROOM + 8 };

/* What says where a shape's points are, in any element, or is known to other programs as where they came from. */
static bool says_shape(const char *name, size_t size) {
    static const char *const names[] = {"x",
                                        "y",
                                        "width",
                                        "height",
                                        "rx",
                                        "ry",
                                        "cx",
                                        "cy",
                                        "r",
                                        "x1",
                                        "y1",
                                        "x2",
                                        "y2",
                                        "d",
                                        "points",
                                        "pathLength",
                                        "inkscape:original-d",
                                        "inkscape:path-effect",
                                        "inkscape:rounded",
                                        "inkscape:flatsided",
                                        "inkscape:randomized",
                                        "inkscape:original"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strlen(names[i]) == size && memcmp(names[i], name, size) == 0) return true;
    return size > 9 && memcmp(name, "sodipodi:", 9) == 0 &&
           !(size == 20 && memcmp(name + 9, "insensitive", 11) == 0);
}

static void print(char value[NUMBER], double number) { value[bat_number_print(number, value)] = '\0'; }

/* Whether a style sheet has a rule for elements of that name. */
static bool has_rule(const bat_svg_plan *plan, const char *name, size_t size) {
    for (uint32_t i = 1; i < plan->tags.count; i++) {
        if (!bat_svg_is_called(plan, i, "style")) continue;
        const char *end = plan->text + plan->tags.list[i].close;
        for (const char *at = plan->text + plan->tags.list[i].body; at + size < end; at++) {
            if (memcmp(at, name, size) != 0) continue;
            const char before = at[-1], behind = at[size];
            const bool begins = strchr(" \t\r\n,>+~}[*|;", before) != NULL;
            if (begins && strchr(" \t\r\n,>+~{.#[:", behind)) return true;
        }
    }
    return false;
}

/* Whether rules for its name, or for paths, say how it looks: as a path it has to say so itself. */
static bool is_ruled(const bat_svg_plan *plan, uint32_t element) {
    const bat_svg_tag *tag = &plan->tags.list[element];
    size_t size;
    const char *name = bat_svg_tag_local(plan->text + tag->open, tag->body - tag->open, &size);
    return plan->sheets && (has_rule(plan, "path", 4) || has_rule(plan, name, size));
}

static bool is_renamed(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry) {
    return bat_svg_reshaped(object, entry) && !(plan->fate[entry->element] & BAT_SVG_SHAPED) &&
           !bat_svg_is_called(plan, entry->element, "path");
}

static bool says_all(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry,
                     bool apart) {
    return apart || plan->fate[entry->element] & BAT_SVG_INSISTS ||
           (is_renamed(plan, object, entry) && is_ruled(plan, entry->element));
}

/* Its markers change, or a path would get some that the element has not, or the other way round. */
static bool says_markers(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry,
                         bool apart) {
    return bat_svg_remarked(object, entry) ||
           (plan->marked && ((is_renamed(plan, object, entry) && !bat_object_markers(object)) ||
                             says_all(plan, object, entry, apart)));
}

static bool differs(const bat_object *object, const bat_sourced *entry, bat_paint_part part) {
    return bat_paint_digest(bat_object_paint(object), part) != entry->paint[part];
}

/* A gradient that is placed by the shape's box would follow the shape. */
bat_svg_ids bat_svg_patch_gradients(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry,
                                    bool apart) {
    bat_svg_ids ids = {0};
    double m[6];
    const bool all = (entry->boxed && bat_svg_reshaped(object, entry)) ||
                     says_all(&p->plan, object, entry, apart);
    if (bat_object_paint(object) && bat_svg_inverse(entry->inner, m) &&
        (all || differs(object, entry, BAT_PAINT_FILL) || differs(object, entry, BAT_PAINT_STROKE)))
        ids = bat_svg_write_gradients(&p->made, object, m, bat_svg_patch_number(p));
    bat_svg_patch_clip(p, object, entry, &ids);
    static const double same[6] = {1, 0, 0, 1, 0, 0};
    if (says_markers(&p->plan, object, entry, apart)) bat_svg_patch_markers(p, object, same, &ids);
    return ids;
}

static void set_number(bat_svg_retag *r, const char *property, double number) {
    char value[NUMBER];
    print(value, number);
    bat_svg_retag_style(r, property, value);
}

/* scale: from the element's units to the document's. */
static void set_dashes(bat_svg_retag *r, const bat_paint *paint, double scale) {
    bat_text text = {0};
    if (paint && paint->dash_count && scale > 0) {
        bat_svg_write_dashes(&text, paint, 1 / scale);
        bat_text_add(&text, "", 1);
        if (text.data) bat_svg_retag_style(r, "stroke-dasharray", text.data);
        set_number(r, "stroke-dashoffset", paint->dash_offset / scale);
    } else
        bat_svg_retag_style(r, "stroke-dasharray", "none");
    r->failed = r->failed || text.failed;
    bat_text_free(&text);
}

static void set_paint(bat_svg_retag *r, bool fill, bool painted, uint32_t colour, uint32_t before, bool all,
                      const char *id) {
    char value[BAT_SVG_ID + 8];
    if (painted && *id) {
        snprintf(value, sizeof value, "url(#%s)", id);
        bat_svg_retag_style(r, fill ? "fill" : "stroke", value);
        set_number(r, fill ? "fill-opacity" : "stroke-opacity", 1);
        return;
    }
    snprintf(value, sizeof value, painted ? "#%06lx" : "none", (unsigned long)(colour >> 8));
    bat_svg_retag_style(r, fill ? "fill" : "stroke", value);
    if (painted && (all || (colour & 0xff) != (before & 0xff)))
        set_number(r, fill ? "fill-opacity" : "stroke-opacity", floor((colour & 0xff) / 0.255 + 0.5) / 1000);
}

/* What the element says itself of an object's opacity. */
static double share_of(double opacity, const bat_sourced *entry) {
    return entry->opacity > 0 ? fmin(1, opacity / entry->opacity) : opacity;
}

/* A property that sheets may say otherwise, or no longer say. */
static bool unsaid(const bat_svg_retag *r, bool all, const char *property) {
    return all && (r->insists || !bat_svg_retag_declares(r, property));
}

static void set_order(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry, bool all) {
    const char *order = bat_svg_order(object);
    const bool plain = strcmp(order, "normal") == 0, says = bat_svg_retag_says(r, "paint-order");
    const bool other = differs(object, entry, BAT_PAINT_LINE) || bat_svg_remarked(object, entry);
    if (!other && !(all && !plain && !says)) return;
    if (!plain || says) bat_svg_retag_style(r, "paint-order", order);
}

static void set_markers(bat_svg_retag *r, const bat_svg_ids *ids) {
    static const char *const places[BAT_MARKER_PLACES] = {"marker-start", "marker-mid", "marker-end"};
    char value[BAT_SVG_ID + 8];
    for (int k = 0; k < BAT_MARKER_PLACES; k++) {
        snprintf(value, sizeof value, *ids->markers[k] ? "url(#%s)" : "none", ids->markers[k]);
        bat_svg_retag_style(r, places[k], value);
    }
}

/* From the units of an element's stroke to the document's: those of one that does not scale are pixels. */
static double line_scale(const bat_svg_retag *r, const bat_svg_plan *plan, const bat_sourced *entry,
                         bool begun) {
    const bool fixed = entry->lost & 1u << BAT_LOSS_EFFECT ||
                       (begun && bat_svg_retag_says(r, "vector-effect"));
    return fixed ? plan->pixel : sqrt(bat_matrix_area(entry->inner));
}

/* apart: as of bat_svg_patch_tag. */
static void set_style(bat_svg_retag *r, const bat_svg_plan *plan, const bat_object *object,
                      const bat_sourced *entry, bool apart, const bat_svg_ids *ids) {
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    const bat_style *was = &entry->style, *now = bat_object_style(object);
    const bool all = says_all(plan, object, entry, apart);
    const bool fill_served = entry->paint[BAT_PAINT_FILL] != 0,
               stroke_served = entry->paint[BAT_PAINT_STROKE] != 0;
    const bool fill = *ids->fill || differs(object, entry, BAT_PAINT_FILL) || now->filled != was->filled ||
                      (now->filled && now->fill != was->fill);
    const bool stroke = *ids->stroke || differs(object, entry, BAT_PAINT_STROKE) ||
                        now->stroked != was->stroked || (now->stroked && now->stroke != was->stroke);
    const bool begun = now->stroked && !was->stroked;
    const double scale = line_scale(r, plan, entry, begun), widens = bat_svg_plan_widens(plan, entry);
    if (fill || unsaid(r, all, "fill"))
        set_paint(r, true, now->filled, now->fill, was->filled ? was->fill : 0xff,
                  all || !was->filled || fill_served, ids->fill);
    if (stroke || unsaid(r, all, "stroke"))
        set_paint(r, false, now->stroked, now->stroke, was->stroked ? was->stroke : 0xff,
                  all || begun || stroke_served, ids->stroke);
    if (now->even_odd != was->even_odd || unsaid(r, all, "fill-rule"))
        bat_svg_retag_style(r, "fill-rule", now->even_odd ? "evenodd" : "nonzero");
    if (now->stroked) {
        const bat_paint *paint = bat_object_paint(object);
        if (now->width != was->width * widens || begun || unsaid(r, all, "stroke-width"))
            set_number(r, "stroke-width", scale > 0 ? now->width / scale : now->width);
        if (now->cap != was->cap || begun || unsaid(r, all, "stroke-linecap"))
            bat_svg_retag_style(r, "stroke-linecap", caps[now->cap]);
        if (now->join != was->join || begun || unsaid(r, all, "stroke-linejoin"))
            bat_svg_retag_style(r, "stroke-linejoin", joins[now->join]);
        if (now->miter_limit != was->miter_limit || begun || unsaid(r, all, "stroke-miterlimit"))
            set_number(r, "stroke-miterlimit", now->miter_limit);
        if (differs(object, entry, BAT_PAINT_LINE) || (widens != 1 && paint && paint->dash_count) ||
            (begun && bat_svg_retag_says(r, "stroke-dasharray")) || unsaid(r, all, "stroke-dasharray"))
            set_dashes(r, paint, scale);
    }
    set_order(r, object, entry, all);
    if (says_markers(plan, object, entry, apart)) set_markers(r, ids);
    if (now->opacity != was->opacity || all) set_number(r, "opacity", share_of(now->opacity, entry));
}

static void set_state(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry, bool hidden) {
    const uint64_t name = bat_digest_text(bat_digest_begin(), bat_object_name(object));
    bat_svg_piece piece;
    if (name != entry->name)
        bat_svg_retag_set(r,
                          bat_svg_retag_has(r, "inkscape:label", &piece) &&
                                  !bat_svg_retag_has(r, "data-name", &piece)
                              ? "inkscape:label"
                              : "data-name",
                          bat_object_name(object));
    if (hidden != entry->hidden || r->insists) bat_svg_retag_style(r, "display", hidden ? "none" : "inline");
    if (r->insists && !hidden) bat_svg_retag_style(r, "visibility", "visible");
    if (bat_object_is_locked(object) != entry->locked) {
        bat_svg_retag_set(r, "data-locked", entry->locked ? NULL : "true");
        if (entry->locked) bat_svg_retag_set(r, "sodipodi:insensitive", NULL);
    }
}

static bool is_important(const bat_svg_retag *r, const bat_sourced *entry) {
    return r->insists || entry->declared & BAT_DECLARED_IMPORTANT;
}

static bat_status declare_data(bat_svg_retag *r, const char *data, const bat_sourced *entry) {
    bat_text text = {0};
    bat_text_string(&text, "path('");
    bat_text_string(&text, data);
    bat_text_string(&text, "')");
    bat_text_add(&text, "", 1);
    if (text.data) bat_svg_retag_declare(r, "d", text.data, is_important(r, entry));
    const bool failed = text.failed;
    bat_text_free(&text);
    return failed ? BAT_MEMORY : BAT_OK;
}

static bat_status set_path(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                           double precision) {
    double m[6];
    bat_text data = {0};
    bool raw = false;
    if (!bat_svg_inverse(entry->inner, m)) return BAT_UNSUPPORTED;
    bat_status status = bat_svg_patch_data(&data, r, object, entry, m, precision, &raw);
    bat_text_add(&data, "", 1);
    if (data.failed) status = BAT_MEMORY;
    if (status == BAT_OK) {
        r->rename = "path";
        r->drops = says_shape;
        if (entry->declared & BAT_DECLARED_SHAPE)
            status = declare_data(r, data.data, entry);
        else
            (raw ? bat_svg_retag_set_raw : bat_svg_retag_set)(r, "d", data.data);
    }
    bat_text_free(&data);
    return status;
}

/* Where style says how the element is transformed, that matrix takes the place of all that it says. */
static void declare_matrix(bat_svg_retag *r, const char *matrix, const bat_sourced *entry) {
    static const char *const singly[] = {"translate", "rotate", "scale"};
    const bool insists = is_important(r, entry);
    bat_svg_retag_declare(r, "transform", matrix, insists);
    bat_svg_retag_declare(r, "transform-origin", "0 0", insists);
    if (entry->declared & BAT_DECLARED_BOX) bat_svg_retag_declare(r, "transform-box", "view-box", insists);
    for (int k = 0; k < 3 && entry->declared & BAT_DECLARED_SINGLY; k++)
        bat_svg_retag_declare(r, singly[k], "none", insists);
}

static bat_status set_matrix(bat_svg_retag *r, const double m[6], const bat_sourced *entry) {
    bat_text text = {0};
    bat_svg_write_matrix(m, &text);
    bat_text_add(&text, "", 1);
    if (text.data && entry->declared & BAT_DECLARED_MATRIX) {
        for (char *at = text.data; *at; at++)
            if (*at == ' ') *at = ','; /* as CSS has it */
        declare_matrix(r, text.data, entry);
    } else if (text.data)
        bat_svg_retag_set(r, "transform", text.data);
    const bool failed = text.failed;
    bat_text_free(&text);
    return failed ? BAT_MEMORY : BAT_OK;
}

/* A transform that depends on the shape, or that sheets say of elements of another name, stays what it was. */
static bat_status keep_matrix(bat_svg_retag *r, const bat_sourced *entry) {
    double back[6], m[6];
    if (!bat_svg_inverse(entry->outer, back)) return BAT_UNSUPPORTED;
    bat_matrix_compose(back, entry->inner, m);
    return set_matrix(r, m, entry);
}

/* The picture's own pixels are the units, and the transform places them. */
static bat_status set_image(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry) {
    static const char *const lengths[] = {"x", "y", "width", "height"};
    double out[6], m[6], sides[2];
    char value[NUMBER];
    if (!bat_svg_inverse(entry->outer, out)) return BAT_UNSUPPORTED;
    bat_matrix_compose(out, bat_object_matrix(object), m);
    bat_picture_sides(bat_object_picture(object), sides);
    const bat_status status = set_matrix(r, m, entry);
    print(value, sides[0]);
    bat_svg_retag_set(r, "width", value);
    print(value, sides[1]);
    bat_svg_retag_set(r, "height", value);
    bat_svg_retag_set(r, "x", NULL);
    bat_svg_retag_set(r, "y", NULL);
    for (int k = 0; k < 4 && entry->declared & BAT_DECLARED_SHAPE; k++)
        bat_svg_retag_pixels(r, lengths[k], k < 2 ? 0 : sides[k - 2], entry);
    bat_svg_retag_set(r, "preserveAspectRatio", "none");
    return status;
}

/* Before the element's own transform comes what has moved the content since it was read. */
static bat_status set_foreign(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry) {
    double back[6], was[6], moved[6], to[6], own[6], m[6];
    if (!bat_drawing_matrix(bat_object_picture(object), was) || !bat_svg_inverse(was, back) ||
        !bat_svg_inverse(entry->outer, to))
        return BAT_UNSUPPORTED;
    bat_matrix_compose(bat_object_matrix(object), back, moved);
    bat_matrix_compose(moved, entry->inner, own);
    bat_matrix_compose(to, own, m);
    return set_matrix(r, m, entry);
}

static bat_status set_shape(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                            double precision) {
    if (bat_object_is_foreign(object) && !bat_svg_is_written_alone(r)) return set_foreign(r, object, entry);
    return bat_object_picture(object) ? set_image(r, object, entry) : set_path(r, object, entry, precision);
}

/* How translucent an element is itself that has become so much more or less. */
static void fade_foreign(bat_svg_retag *r, double now, const bat_sourced *entry) {
    const double was = entry->style.opacity;
    if (now != was) set_number(r, "opacity", fmin(1, entry->own * (was > 0 ? now / was : now)));
}

void bat_svg_patch_try_shape(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[entry->element];
    bat_svg_retag r;
    if (!bat_svg_reshaped(object, entry) || bat_object_is_foreign(object) || bat_object_picture(object) ||
        bat_object_is_group(object) || plan->fate[entry->element] & BAT_SVG_INSISTS)
        return;
    bat_svg_retag_begin(&r, plan->text + tag->open, tag->body - tag->open, plan->types, plan->types_size,
                        plan->sheets);
    if (bat_svg_patch_shape(&r, object, entry, p->precision)) plan->fate[entry->element] |= BAT_SVG_SHAPED;
    if (r.failed || r.values.failed) p->status = BAT_MEMORY;
    bat_svg_retag_free(&r);
}

bool bat_svg_patch_tag(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry, bool apart,
                       bool hides, bool anonymous, const bat_svg_ids *ids) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[entry->element];
    bat_svg_retag r;
    bat_svg_retag_begin(&r, plan->text + tag->open, tag->body - tag->open, plan->types, plan->types_size,
                        plan->sheets);
    r.insists = plan->fate[entry->element] & BAT_SVG_INSISTS;
    if (!bat_object_is_group(object)) {
        const bool reshaped = bat_svg_reshaped(object, entry);
        if (!bat_object_is_foreign(object))
            set_style(&r, plan, object, entry, apart, ids);
        else
            fade_foreign(&r, bat_object_style(object)->opacity, entry);
        if (plan->fate[entry->element] & BAT_SVG_SHAPED)
            bat_svg_patch_shape(&r, object, entry, p->precision);
        else if (reshaped) {
            const bat_status status = set_shape(&r, object, entry, p->precision);
            if (status != BAT_OK) p->status = status;
        }
        const bool others = r.insists || (plan->sheets && is_renamed(plan, object, entry));
        if (reshaped && !bat_object_picture(object) &&
            (entry->declared & BAT_DECLARED_BOX || (others && entry->declared & BAT_DECLARED_MATRIX))) {
            const bat_status status = keep_matrix(&r, entry);
            if (status != BAT_OK) p->status = status;
        }
    } else if (bat_object_style(object)->opacity != entry->style.opacity)
        set_number(&r, "opacity", share_of(bat_object_style(object)->opacity, entry));
    bat_svg_patch_set_clip(&r, object, entry, ids);
    set_state(&r, object, entry, bat_object_is_hidden(object) || hides);
    if (anonymous) bat_svg_retag_set(&r, "id", NULL);
    const bool changed = bat_svg_retag_changed(&r);
    if (changed) bat_svg_retag_write(&r, &p->made);
    bat_svg_retag_free(&r);
    return changed;
}

/* A group that is no longer one has given its opacity and its clip path to what was in it. */
bool bat_svg_patch_group_tag(bat_svg_patch *p, uint32_t element) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[element];
    int low = 0, high = bat_source_count(plan->source);
    while (low < high) { /* the first one of this element */
        const int middle = (low + high) / 2;
        if (bat_source_at(plan->source, middle)->element < element)
            low = middle + 1;
        else
            high = middle;
    }
    const bat_sourced *own = low < bat_source_count(plan->source) ? bat_source_at(plan->source, low) : NULL;
    if (!own || own->element != element || !own->id) return false;
    if (own->style.opacity == 1 && !own->clip) return false;
    bat_svg_retag r;
    bat_svg_retag_begin(&r, plan->text + tag->open, tag->body - tag->open, plan->types, plan->types_size,
                        plan->sheets);
    if (own->style.opacity != 1) set_number(&r, "opacity", 1);
    if (own->clip) bat_svg_unclip(&r);
    bat_svg_retag_write(&r, &p->made);
    bat_svg_retag_free(&r);
    return true;
}

/* A shape that has become a path ends as one. */
void bat_svg_patch_end_tag(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[entry->element];
    const char *name = plan->text + tag->open + 1;
    const size_t length = bat_svg_tag_name(name - 1, tag->body - tag->open);
    if (tag->close == tag->end) return;
    if (!bat_svg_reshaped(object, entry) || bat_object_picture(object) ||
        plan->fate[entry->element] & BAT_SVG_SHAPED) {
        bat_text_add(&p->made, plan->text + tag->close, tag->end - tag->close);
        return;
    }
    const char *colon = memchr(name, ':', length);
    bat_text_string(&p->made, "</");
    if (colon) bat_text_add(&p->made, name, (size_t)(colon - name) + 1);
    bat_text_string(&p->made, "path>");
}
