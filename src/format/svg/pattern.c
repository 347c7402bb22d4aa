/* Patterns: what is repeated becomes a picture that stands alone, or is one already (SVG 2, 14.3). */
#include "base/matrix.h"
#include "document/digest.h"
#include "document/paint.h"
#include "format/svg/alone.h"
#include "format/svg/chain.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"
#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The last picture made of a pattern or a mask. */
typedef struct bat_svg_tile {
    uint64_t digest; /* of what it depends on */
    bat_picture *picture;
} bat_svg_tile;

typedef struct tile {
    uint32_t holder;   /* the element that holds what is repeated; 0: none */
    bool boxed;        /* it depends on the shape's box */
    double box[4];     /* x, y, width, height in the pattern's units */
    double content[6]; /* from the units of what is repeated to those, from the box's corner */
    double matrix[6];  /* from the pattern's units to those of the shape */
    double opacity;    /* of the picture that it is, if it is one */
} tile;

bool bat_svg_is_pattern(const bat_svg_walk *w, uint32_t element) {
    return strcmp(bat_svg_tree_name(w->tree, element), "pattern") == 0;
}

void bat_svg_tiles_free(bat_svg_walk *w) {
    for (uint32_t i = 0; w->tiles && i < w->tree->count; i++) {
        if (w->tiles[i]) bat_picture_release(w->tiles[i]->picture);
        free(w->tiles[i]);
    }
    free(w->tiles);
}

/* ---- its place ---- */

static bool is_of_box(const char *units, bool otherwise) {
    return units ? strcmp(units, "objectBoundingBox") == 0 : otherwise;
}

static bool place(const bat_svg_walk *w, const bat_svg_chain *c, const bat_svg_scope *s, const double box[4],
                  tile *t) {
    static const char *const names[] = {"x", "y", "width", "height"};
    const bool boxed = is_of_box(bat_svg_chain_attribute(w, c, "patternUnits"), true);
    const double wide = box[2] - box[0], high = box[3] - box[1];
    for (int k = 0; k < 4; k++) {
        const double viewport = k % 2 ? s->height : s->width, side = k % 2 ? high : wide;
        const char *text = bat_svg_chain_attribute(w, c, names[k]);
        double value = 0;
        if (text && !bat_svg_length(text, boxed ? 1 : viewport, &value)) value = 0;
        t->box[k] = boxed ? value * side + (k < 2 ? box[k] : 0) : value;
        if (!(fabs(t->box[k]) <= BAT_COORDINATE_MAX)) return false;
    }
    t->boxed = boxed;
    return t->box[2] > 0 && t->box[3] > 0;
}

/* From the units of what is repeated to those of the pattern, from its corner. */
static bool fit(const bat_svg_walk *w, const bat_svg_chain *c, const double box[4], tile *t) {
    const char *view = bat_svg_chain_attribute(w, c, "viewBox");
    double own[4];
    bat_matrix_identity(t->content);
    if (view && bat_svg_view_box(view, own)) {
        if (!(own[2] > 0 && own[3] > 0)) return false;
        bat_svg_fit(own, 0, 0, t->box[2], t->box[3], bat_svg_chain_attribute(w, c, "preserveAspectRatio"),
                    t->content);
    } else if (is_of_box(bat_svg_chain_attribute(w, c, "patternContentUnits"), false)) {
        t->content[0] = box[2] - box[0];
        t->content[3] = box[3] - box[1];
        t->boxed = true;
    }
    return bat_matrix_is_regular(t->content);
}

static bool read_tile(const bat_svg_walk *w, const bat_svg_chain *c, const bat_svg_scope *s,
                      const double box[4], tile *t) {
    const char *transform = bat_svg_chain_attribute(w, c, "patternTransform");
    *t = (tile){.opacity = 1};
    bat_matrix_identity(t->matrix);
    if (transform && !bat_svg_transform(transform, t->matrix)) return false;
    for (int i = 0; i < c->count && !t->holder; i++)
        if (w->tree->elements[c->elements[i]].first) t->holder = c->elements[i];
    return t->holder && place(w, c, s, box, t) && fit(w, c, box, t);
}

/* ---- one that is a picture ---- */

static bool is_near(double a, double b) { return fabs(a - b) <= 1e-9 * fabs(b); }

/* The attributes that an image may have which is as large as the tile. */
static bool is_plain_image(const bat_svg_walk *w, uint32_t image) {
    static const char *const known[] = {"id",        "x",       "y",          "width",
                                        "height",    "href",    "xlink:href", "preserveAspectRatio",
                                        "transform", "opacity", NULL};
    const bat_svg_element *e = &w->tree->elements[image];
    return !bat_svg_says_more(w->tree, image, known) && e->kind == BAT_SVG_IMAGE && !e->next &&
           w->sheet->count == 0;
}

/* Whether the image fills the tile from corner to corner, as the picture says. */
static bool fills(const bat_svg_walk *w, uint32_t image, const bat_picture *picture, const tile *t) {
    const char *transform = bat_svg_attribute_of(w, image, "transform"),
               *ratio = bat_svg_attribute_of(w, image, "preserveAspectRatio");
    double own[6], m[6], sides[2];
    bat_picture_sides(picture, sides);
    bat_matrix_identity(own);
    if (transform && !bat_svg_transform(transform, own)) return false;
    bat_matrix_compose(t->content, own, m);
    const double x = bat_svg_length_of(w, image, "x", 0, 0), y = bat_svg_length_of(w, image, "y", 0, 0),
                 wide = bat_svg_length_of(w, image, "width", 0, sides[0]),
                 high = bat_svg_length_of(w, image, "height", 0, sides[1]);
    if (!(ratio && strcmp(ratio, "none") == 0) && !is_near(wide * sides[1], high * sides[0])) return false;
    return m[1] == 0 && m[2] == 0 && m[4] == 0 && m[5] == 0 && x == 0 && y == 0 &&
           is_near(m[0] * wide, t->box[2]) && is_near(m[3] * high, t->box[3]);
}

/* NULL: it is none. */
static bat_picture *picture_of(bat_svg_walk *w, tile *t) {
    const uint32_t image = w->tree->elements[t->holder].first;
    if (!is_plain_image(w, image)) return NULL;
    bat_picture *picture = bat_svg_find_picture(w, image);
    if (!picture) return NULL;
    if (fills(w, image, picture, t)) {
        t->opacity = fmin(fmax(bat_svg_length_of(w, image, "opacity", 1, 1), 0), 1);
        return picture;
    }
    bat_picture_release(picture);
    return NULL;
}

/* ---- one that is drawn ---- */

/* From the picture's pixels to the tile: what the tile's contents begin with, and what follows them. */
static void write_around(const bat_svg_walk *w, const tile *t, const uint32_t sides[2], bat_text *out,
                         bat_text *after) {
    static const char *const names[] = {"<svg x=\"0\" y=\"0\" preserveAspectRatio=\"none\" width=\"",
                                        "\" height=\"", "\" viewBox=\"0 0 ", " "};
    const double numbers[] = {sides[0], sides[1], t->box[2], t->box[3]};
    for (int k = 0; k < 4; k++) {
        bat_text_string(out, names[k]);
        bat_text_number(out, numbers[k]);
    }
    bat_text_string(out, "\">");
    bat_text_string(after, "</g>");
    bat_svg_alone_around(w, t->holder, out, after);
    bat_text_string(after, "</svg>");
    bat_text_add(after, "", 1);
    bat_text_string(out, "<g transform=\"");
    bat_svg_write_matrix(t->content, out);
    bat_text_string(out, "\"");
    bat_svg_alone_attributes(w, t->holder, out);
    bat_text_string(out, ">");
}

bat_status bat_svg_held(bat_svg_walk *w, uint32_t holder, const uint32_t sides[2], const bat_text *before,
                        const char *after, bat_picture **out) {
    const uint64_t digest = bat_digest_bytes(bat_digest_begin(), before->data, before->size);
    bat_picture *picture = NULL;
    if (!w->tiles && !(w->tiles = calloc(w->tree->count, sizeof *w->tiles))) return BAT_MEMORY;
    bat_svg_tile *known = w->tiles[holder];
    if (known && known->digest == digest) {
        *out = bat_picture_retain(known->picture);
        return BAT_OK;
    }
    bat_status status = bat_svg_alone_within(w, holder, sides, before, after, &picture);
    if (status == BAT_OK) status = bat_pictures_add(&w->pictures, picture);
    if (status == BAT_OK && !known && !(known = w->tiles[holder] = calloc(1, sizeof *known)))
        status = BAT_MEMORY;
    if (status != BAT_OK) {
        bat_picture_release(picture);
        return status;
    }
    bat_picture_release(known->picture);
    *known = (bat_svg_tile){digest, bat_picture_retain(picture)};
    *out = picture;
    return BAT_OK;
}

/* NULL: it cannot be made. */
static bat_picture *draw(bat_svg_walk *w, const tile *t) {
    bat_text before = {0}, after = {0};
    bat_picture *picture = NULL;
    uint32_t sides[2];
    bat_drawing_sides(t->box[2], t->box[3], sides);
    write_around(w, t, sides, &before, &after);
    const bat_status status = before.failed || after.failed
                                  ? BAT_MEMORY
                                  : bat_svg_held(w, t->holder, sides, &before, after.data, &picture);
    if (status == BAT_MEMORY) w->status = status;
    bat_text_free(&before);
    bat_text_free(&after);
    return picture;
}

bat_svg_served bat_svg_pattern(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double box[4],
                               double share, bat_stop *stops, bat_gradient *out) {
    const bat_svg_chain c = bat_svg_chain_of(w, element);
    tile t;
    double sides[2], own[6], all[6];
    if (!read_tile(w, &c, s, box, &t)) return BAT_SVG_NOTHING;
    bat_picture *picture = w->collected ? NULL : picture_of(w, &t);
    if (!picture && !w->collected && bat_svg_may_stand_alone(w)) picture = draw(w, &t);
    if (!picture) return BAT_SVG_MEAN;
    bat_picture_sides(picture, sides);
    const double corner[6] = {t.box[2] / sides[0], 0, 0, t.box[3] / sides[1], t.box[0], t.box[1]};
    bat_matrix_compose(t.matrix, corner, own);
    bat_matrix_compose(s->matrix, own, all);
    const uint32_t alpha = (uint32_t)floor(255 * fmin(fmax(share * t.opacity, 0), 1) + 0.5);
    *out = bat_paint_pattern(bat_pictures_find(&w->pictures, bat_picture_digest(picture)), all, alpha, stops);
    bat_picture_release(picture); /* the walk keeps one like it */
    const bool regular = bat_matrix_is_regular(all);
    if (!regular) *out = (bat_gradient){0};
    w->boxed = w->boxed || t.boxed;
    return regular ? BAT_SVG_SERVED : BAT_SVG_NOTHING;
}
