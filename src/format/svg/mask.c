/* Masks: what a mask leaves becomes a picture that stands alone, of which only the alpha counts: in it, white is painted through
 * the mask, so that whoever paints the picture knows about luminance and units (CSS Masking 1). */
#include "base/matrix.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/nesting.h"
#include "format/svg/alone.h"
#include "format/svg/digest.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"

#include <math.h>
#include <string.h>

typedef struct region {
    double box[4];     /* x, y, width, height in the element's units */
    double content[6]; /* from the units of what is in the mask to those */
    bool boxed;        /* it depends on the element's box */
} region;

static bool is_boxed(const bat_svg_walk *w, uint32_t mask, const char *units, bool otherwise) {
    const char *value = bat_svg_attribute_of(w, mask, units);
    return value ? strcmp(value, "objectBoundingBox") == 0 : otherwise;
}

bool bat_svg_mask_is_boxed(const bat_svg_walk *w, const bat_svg_scope *s) {
    return is_boxed(w, s->mask, "maskUnits", true) || is_boxed(w, s->mask, "maskContentUnits", false);
}

/* ---- one of ours ---- */

/* The image in a mask as bat_svg_write_clip writes it; outer: the mask around it, or 0. 0: it is none. */
static uint32_t image_of(const bat_svg_walk *w, uint32_t mask, uint32_t *outer) {
    const char *id = bat_svg_attribute_of(w, mask, "id"), *style = bat_svg_attribute_of(w, mask, "style");
    uint32_t at = w->tree->elements[mask].first;
    *outer = 0;
    if (!id || strncmp(id, BAT_SVG_PAINT_ID, sizeof BAT_SVG_PAINT_ID - 1) != 0) return 0;
    if (!style || strcmp(style, "mask-type:alpha") != 0 || is_boxed(w, mask, "maskUnits", true)) return 0;
    if (at && w->tree->elements[at].kind == BAT_SVG_GROUP) {
        const char *around = bat_svg_attribute_of(w, at, "mask");
        if (!around || strncmp(around, "url(", 4) != 0 || w->tree->elements[at].next) return 0;
        *outer = bat_svg_tree_refer(w->tree, around + 4);
        at = *outer ? w->tree->elements[at].first : 0;
    }
    if (!at || w->tree->elements[at].kind != BAT_SVG_IMAGE || w->tree->elements[at].next) return 0;
    return bat_svg_attribute_of(w, at, "x") || bat_svg_attribute_of(w, at, "y") ? 0 : at;
}

/* BAT_UNSUPPORTED: it is none of ours. */
static bat_status read_ours(bat_svg_walk *w, uint32_t mask, const bat_svg_scope *s, int deep, bat_clip **out,
                            uint64_t *digest) {
    uint32_t outer;
    const uint32_t image = strcmp(bat_svg_tree_name(w->tree, mask), "mask") == 0 ? image_of(w, mask, &outer)
                                                                                 : 0;
    if (!image || deep == BAT_CLIP_REGIONS_MAX) return BAT_UNSUPPORTED;
    const char *transform = bat_svg_attribute_of(w, image, "transform");
    double own[6], all[6];
    bat_matrix_identity(own);
    if (transform && !bat_svg_transform(transform, own)) return BAT_UNSUPPORTED;
    bat_matrix_compose(s->matrix, own, all);
    bat_picture *picture = bat_svg_find_picture(w, image);
    if (!picture) return BAT_UNSUPPORTED;
    *digest = bat_svg_digest_image(*digest, picture, all, 1);
    bat_clip *around = bat_clip_retain(s->clip);
    bat_status status = BAT_OK;
    if (outer) {
        bat_clip_release(around);
        around = NULL;
        status = read_ours(w, outer, s, deep + 1, &around, digest);
    }
    if (status == BAT_OK) status = bat_clip_mask(picture, all, around, out);
    bat_clip_release(around);
    bat_picture_release(picture);
    return status;
}

/* ---- any other ---- */

static bool find_region(const bat_svg_walk *w, const bat_svg_scope *s, const double box[4], region *r) {
    static const char *const names[] = {"x", "y", "width", "height"};
    const double low[2] = {box[0], box[1]}, sides[2] = {box[2] - box[0], box[3] - box[1]};
    const bool boxed = is_boxed(w, s->mask, "maskUnits", true);
    r->boxed = bat_svg_mask_is_boxed(w, s);
    if (r->boxed && !(sides[0] > 0 && sides[1] > 0)) return false;
    for (int k = 0; k < 4; k++) {
        const double whole = boxed ? 1 : k % 2 ? s->height : s->width;
        const char *text = bat_svg_attribute_of(w, s->mask, names[k]);
        double value;
        if (!text || !bat_svg_length(text, whole, &value)) value = (k < 2 ? -0.1 : 1.2) * whole;
        r->box[k] = boxed ? value * sides[k % 2] + (k < 2 ? low[k] : 0) : value;
        if (!(fabs(r->box[k]) <= BAT_COORDINATE_MAX)) return false;
    }
    bat_matrix_identity(r->content);
    if (is_boxed(w, s->mask, "maskContentUnits", false)) {
        const double m[6] = {sides[0], 0, 0, sides[1], low[0], low[1]};
        memcpy(r->content, m, sizeof r->content);
    }
    return r->box[2] >= 0 && r->box[3] >= 0;
}

/* Whether an id can stand in url() as it is. */
static bool is_plain(const char *id) {
    for (const char *at = id; *at; at++) {
        const bool letter = ((*at | 32) >= 'a' && (*at | 32) <= 'z') || (*at >= '0' && *at <= '9');
        if (!letter && !strchr("-_.:", *at)) return false;
    }
    return *id;
}

/* The mask in the picture's pixels, as far as its contents, and what follows them. */
static void write_around(const bat_svg_walk *w, uint32_t mask, const region *r, const uint32_t sides[2],
                         bat_text *before, bat_text *after) {
    static const char *const names[] = {"\" maskUnits=\"userSpaceOnUse\" x=\"", "\" y=\"", "\" width=\"",
                                        "\" height=\""};
    const char *id = bat_svg_attribute_of(w, mask, "id");
    const double x = sides[0] / r->box[2], y = sides[1] / r->box[3],
                 to[6] = {x, 0, 0, y, -x * r->box[0], -y * r->box[1]};
    bat_text around = {0};
    bat_text_string(before, "<g transform=\"");
    bat_svg_write_matrix(to, before);
    bat_text_string(before, "\">");
    bat_svg_alone_around(w, mask, before, &around);
    bat_text_string(before, "<mask id=\"");
    bat_text_string(before, id);
    for (int k = 0; k < 4; k++) {
        bat_text_string(before, names[k]);
        bat_text_number(before, r->box[k]);
    }
    bat_text_string(before, "\"");
    bat_svg_alone_attributes(w, mask, before);
    bat_text_string(before, "><g transform=\"");
    bat_svg_write_matrix(r->content, before);
    bat_text_string(before, "\">");
    bat_text_string(after, "</g></mask>");
    bat_text_add(after, around.data, around.size);
    after->failed = after->failed || around.failed;
    bat_text_free(&around);
    bat_text_string(after, "<path style=\"fill:#fff!important;fill-opacity:1!important;stroke:none"
                           "!important;opacity:1!important;display:inline!important;visibility:visible"
                           "!important;filter:none!important;clip-path:none!important;mask:url(#");
    bat_text_string(after, id);
    bat_text_string(after, ")!important\" d=\"M");
    bat_text_number(after, r->box[0]);
    bat_text_string(after, ",");
    bat_text_number(after, r->box[1]);
    bat_text_string(after, "h");
    bat_text_number(after, r->box[2]);
    bat_text_string(after, "v");
    bat_text_number(after, r->box[3]);
    bat_text_string(after, "h");
    bat_text_number(after, -r->box[2]);
    bat_text_string(after, "z\"/></g>");
}

static bat_status draw(bat_svg_walk *w, const bat_svg_scope *s, const region *r, bat_picture **out) {
    const char *id = bat_svg_attribute_of(w, s->mask, "id");
    bat_text before = {0}, after = {0};
    uint32_t sides[2];
    if (!id || !is_plain(id) || !bat_svg_may_stand_alone(w)) return BAT_UNSUPPORTED;
    bat_drawing_sides(r->box[2], r->box[3], sides);
    write_around(w, s->mask, r, sides, &before, &after);
    bat_text_add(&after, "", 1);
    const bat_status status = before.failed || after.failed
                                  ? BAT_MEMORY
                                  : bat_svg_held(w, s->mask, sides, &before, after.data, out);
    bat_text_free(&before);
    bat_text_free(&after);
    return status;
}

static bat_status read_mask(bat_svg_walk *w, const bat_svg_scope *s, const double box[4], bat_clip **out,
                            uint64_t *digest) {
    region r;
    bat_picture *picture = NULL;
    double sides[2], all[6];
    if (!find_region(w, s, box, &r)) return BAT_UNSUPPORTED;
    w->boxed = w->boxed || r.boxed;
    *digest = bat_digest_number(*digest, 4);
    if (r.box[2] == 0 || r.box[3] == 0 || !w->tree->elements[s->mask].first)
        return bat_clip_create(0, NULL, false, s->clip, out);
    bat_status status = draw(w, s, &r, &picture);
    if (status != BAT_OK) return status;
    bat_picture_sides(picture, sides);
    const double corner[6] = {r.box[2] / sides[0], 0, 0, r.box[3] / sides[1], r.box[0], r.box[1]};
    bat_matrix_compose(s->matrix, corner, all);
    *digest = bat_svg_digest_image(*digest, picture, all, 1);
    status = bat_clip_mask(picture, all, s->clip, out);
    bat_picture_release(picture);
    return status;
}

/* ---- masks of elements ---- */

/* What refers to no mask is seen as it is, as browsers show it. */
void bat_svg_mask_begin(bat_svg_walk *w, uint32_t element, bat_svg_scope *s) {
    const bat_svg_kind kind = (bat_svg_kind)w->tree->elements[element].kind;
    uint32_t outer, found;
    s->mask = 0;
    if (!s->style.mask || w->collected || w->groups == BAT_NESTING_MAX) return;
    if (kind != BAT_SVG_SHAPE && kind != BAT_SVG_GROUP && kind != BAT_SVG_IMAGE) return;
    found = bat_svg_tree_refer(w->tree, s->style.mask);
    if (found && strcmp(bat_svg_tree_name(w->tree, found), "mask") != 0) found = 0;
    if (found && !bat_svg_may_stand_alone(w) && !image_of(w, found, &outer)) return;
    s->style.odd &= ~BAT_SVG_BIT(BAT_SVG_MASK);
    s->mask = found;
}

void bat_svg_mask_paint(bat_svg_walk *w, uint32_t element, const double box[4], bat_svg_scope *s) {
    bat_clip *made = NULL;
    uint64_t digest = s->clip_digest;
    if (w->status != BAT_OK) return;
    bat_status status = read_ours(w, s->mask, s, 0, &made, &digest);
    if (status == BAT_UNSUPPORTED) {
        digest = s->clip_digest;
        status = read_mask(w, s, box, &made, &digest);
    }
    if (status == BAT_OK) {
        bat_clip_release(s->clip);
        s->clip = made;
        s->clip_digest = digest;
    } else if (status == BAT_MEMORY)
        w->status = status;
    else
        bat_svg_note(&w->notes, element, BAT_LOSS_MASK);
}
