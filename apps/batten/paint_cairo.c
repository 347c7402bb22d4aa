#include "paint_cairo.h"
#include "paint_bytes.h"
#include "paint_foreign.h"

#include "base/box.h"
#include "document/clip.h"
#include "document/kind.h"
#include "document/markers.h"
#include "document/nesting.h"
#include "document/unit.h"

#include <batten/bezier.h>
#include <batten/paint.h>

#include <cairo.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#define ZLIB_CONST
#include <zlib.h>

/* At least how much wider the stroke is somewhere than the style says: by its pen, or its profile. */
static double longest(const bat_paint *paint) {
    double square = 0, widest = 1;
    for (int k = 0; paint && k < 4; k++) square += paint->pen[k] * paint->pen[k];
    for (size_t i = 0; paint && i < paint->width_count; i++) widest = fmax(widest, paint->widths[i].share);
    return fmax(widest, sqrt(square));
}

/* Extends the box by the object's box and half its stroke width; miters may stick out as far as their limit. */
static void grow(const bat_object *object, double box[4]) {
    double own[4];
    bat_object_bounds(object, own);
    if (!(own[0] <= own[2])) return;
    const bat_style *style = bat_object_style(object);
    double margin = style->stroked ? style->width / 2 * longest(bat_object_paint(object)) : 0;
    if (style->stroked && style->join == BAT_JOIN_MITER) margin *= fmin(style->miter_limit, 4);
    if (style->stroked && style->cap == BAT_CAP_SQUARE) margin = fmax(margin, style->width * 0.7072);
    for (int k = 0; k < 2; k++) own[k] -= margin, own[k + 2] += margin;
    bat_box_hold(box, own);
}

static double pixels(double length) { return fmin(fmax(ceil(length - 1e-9), 1), PAINT_SIZE_MAX); }

/* The page, or the box of what is drawn; false: of what is drawn. */
static bool view_of(const bat_document *document, double view[4]) {
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    bat_document_page(document, view);
    if (view[2] > 0 && view[3] > 0) return true;
    for (int i = 0; i < bat_document_count(document); i++) grow(bat_document_at(document, i), box);
    if (!(box[0] <= box[2])) memcpy(box, (double[4]){0, 0, 1, 1}, sizeof box);
    double size = fmax(box[2] - box[0], box[3] - box[1]);
    if (size <= 0) size = 1; /* a single point drawn with a stroke of zero width */
    view[2] = fmax(box[2] - box[0], size * 1e-3);
    view[3] = fmax(box[3] - box[1], size * 1e-3);
    view[0] = (box[0] + box[2] - view[2]) / 2;
    view[1] = (box[1] + box[3] - view[3]) / 2;
    return false;
}

static bool is_page(picture_kind kind) { return kind == PICTURE_PDF || kind == PICTURE_EPS; }

/* Pixels, or points, of a unit of the document. */
static double resolution(const bat_document *document, const picture_wanted *wanted, const double view[4],
                         bool paged) {
    const bat_unit unit = bat_document_unit(document);
    const double inch = bat_document_scale(document) / 25.4, longer = fmax(view[2], view[3]);
    if (is_page(wanted->kind) && unit != BAT_UNIT_NONE) return 72 * inch;
    if (wanted->dpi > 0) return wanted->dpi * inch;
    if (bat_unit_is_physical(unit)) return 96 * inch;
    return paged ? 1 : 1000 / longer;
}

void paint_area_of(const bat_document *document, const picture_wanted *wanted, paint_area *out) {
    const long *size = wanted->size;
    const bool paged = view_of(document, out->view);
    double scale = resolution(document, wanted, out->view, paged);
    /* A page that is too large keeps its proportions. */
    scale = fmin(scale, PAINT_SIZE_MAX / fmax(out->view[2], out->view[3]));
    const double wide = out->view[2] * scale, high = out->view[3] * scale;
    const bool exact = is_page(wanted->kind);
    out->width = size[0] > 0 ? (double)size[0] : exact ? wide : pixels(wide);
    out->height = size[1] > 0 ? (double)size[1] : exact ? high : pixels(high);
}

static void set_colour(cairo_t *cairo, uint32_t colour) {
    cairo_set_source_rgba(cairo, (colour >> 24) / 255.0, ((colour >> 16) & 255) / 255.0,
                          ((colour >> 8) & 255) / 255.0, (colour & 255) / 255.0);
}

/* How many pixels one of the gradient's units is; 0: the surface has none. */
static double scale_of(cairo_t *cairo, const double m[6]) {
    cairo_matrix_t all, own = {m[0], m[1], m[2], m[3], m[4], m[5]};
    cairo_get_matrix(cairo, &all);
    cairo_matrix_multiply(&own, &own, &all);
    const bool pixels = cairo_surface_get_type(cairo_get_group_target(cairo)) == CAIRO_SURFACE_TYPE_IMAGE;
    return pixels ? fmax(sqrt(own.xx * own.xx + own.yx * own.yx), sqrt(own.xy * own.xy + own.yy * own.yy))
                  : 0;
}

static cairo_pattern_t *gradient_pattern(const bat_gradient *g) {
    static const cairo_extend_t extends[] = {CAIRO_EXTEND_PAD, CAIRO_EXTEND_REFLECT, CAIRO_EXTEND_REPEAT};
    cairo_pattern_t *pattern = g->radial
                                   ? cairo_pattern_create_radial(g->from[0], g->from[1], g->from[2], g->to[0],
                                                                 g->to[1], g->to[2])
                                   : cairo_pattern_create_linear(g->from[0], g->from[1], g->to[0], g->to[1]);
    for (size_t i = 0; i < g->count; i++) {
        const uint32_t c = g->stops[i].colour;
        cairo_pattern_add_color_stop_rgba(pattern, g->stops[i].at, (c >> 24) / 255.0, (c >> 16 & 255) / 255.0,
                                          (c >> 8 & 255) / 255.0, (c & 255) / 255.0);
    }
    cairo_pattern_set_extend(pattern, extends[g->spread]);
    return pattern;
}

/* What paints: the gradient or pattern, or the colour where there is none. */
static void set_source(cairo_t *cairo, const bat_gradient *g, uint32_t colour) {
    if (!g || g->count == 0) {
        set_colour(cairo, colour);
        return;
    }
    const double *m = g->matrix;
    cairo_matrix_t matrix = {m[0], m[1], m[2], m[3], m[4], m[5]}, own;
    cairo_pattern_t *pattern = g->tile ? paint_tile(cairo, g->tile, (g->stops[0].colour & 255) / 255.0,
                                                    scale_of(cairo, m))
                                       : gradient_pattern(g);
    if (pattern && cairo_matrix_invert(&matrix) == CAIRO_STATUS_SUCCESS) {
        cairo_pattern_get_matrix(pattern, &own);
        cairo_matrix_multiply(&matrix, &matrix, &own);
        cairo_pattern_set_matrix(pattern, &matrix);
        cairo_set_source(cairo, pattern);
    } else
        set_colour(cairo, colour);
    cairo_pattern_destroy(pattern);
}

/* Adds the curve to the path as cubic segments: exact up to degree 3, above that within tolerance. */
static bat_status trace(cairo_t *cairo, const bat_curve *curve, double tolerance) {
    double *cubics;
    int count;
    bat_status status = bat_curve_to_cubics(curve, tolerance, &count, &cubics);
    if (status != BAT_OK) return status;
    int dimension = bat_curve_dimension(curve);
    for (int i = 0; i < count; i++) {
        const double *p = cubics + 4 * i * dimension;
        if (i == 0) cairo_move_to(cairo, p[0], p[1]);
        cairo_curve_to(cairo, p[dimension], p[dimension + 1], p[2 * dimension], p[2 * dimension + 1],
                       p[3 * dimension], p[3 * dimension + 1]);
    }
    if (bat_curve_is_closed(curve)) cairo_close_path(cairo);
    bat_free(cubics);
    return BAT_OK;
}

/* Dashes, and the shape of the pen: between cairo_save and cairo_restore. */
static void shape_pen(cairo_t *cairo, const bat_paint *paint) {
    if (!paint) return;
    const double *m = paint->pen;
    cairo_matrix_t pen = {m[0], m[1], m[2], m[3], 0, 0};
    if (m[0] * m[3] - m[1] * m[2] != 0) cairo_transform(cairo, &pen);
    if (paint->dash_count) cairo_set_dash(cairo, paint->dashes, (int)paint->dash_count, paint->dash_offset);
}

static void set_pen(cairo_t *cairo, const bat_style *style) {
    static const cairo_line_cap_t caps[] = {CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_ROUND, CAIRO_LINE_CAP_SQUARE};
    static const cairo_line_join_t joins[] = {CAIRO_LINE_JOIN_MITER, CAIRO_LINE_JOIN_ROUND,
                                              CAIRO_LINE_JOIN_BEVEL};
    cairo_set_line_width(cairo, style->width);
    cairo_set_line_cap(cairo, caps[style->cap]);
    cairo_set_line_join(cairo, joins[style->join]);
    cairo_set_miter_limit(cairo, style->miter_limit);
}

/* Clips the next painting to the box of the path and its stroke; otherwise a group would be as large as the
 * picture. */
static void clip_to_path(cairo_t *cairo, const bat_style *style, const bat_paint *paint, bool stroked) {
    double box[4], own[4], room = 2, across = 0; /* two pixels more, so that edges do not change */
    cairo_device_to_user_distance(cairo, &room, &across);
    cairo_fill_extents(cairo, &box[0], &box[1], &box[2], &box[3]);
    if (stroked) {
        set_pen(cairo, style);
        cairo_set_line_width(cairo,
                             style->width * longest(paint)); /* of a round pen around that of the paint */
        cairo_stroke_extents(cairo, &own[0], &own[1], &own[2], &own[3]);
        bat_box_hold(box, own);
    }
    cairo_path_t *path = cairo_copy_path(cairo);
    cairo_new_path(cairo);
    cairo_rectangle(cairo, box[0] - room, box[1] - room, box[2] - box[0] + 2 * room,
                    box[3] - box[1] + 2 * room);
    cairo_clip(cairo);
    cairo_append_path(cairo, path);
    cairo_path_destroy(path);
}

static void fill_path(cairo_t *cairo, const bat_style *style, const bat_paint *paint) {
    set_source(cairo, paint ? &paint->fill : NULL, style->fill);
    cairo_set_fill_rule(cairo, style->even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill_preserve(cairo);
}

/* What covers a stroke whose width changes, instead of the path, which comes back afterwards. */
static bat_status widen_path(cairo_t *cairo, const bat_object *object) {
    bat_status status = BAT_OK;
    cairo_path_t *path = cairo_copy_path(cairo);
    cairo_new_path(cairo);
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++) {
        size_t count = 0;
        double *p = NULL;
        status = bat_object_cover(object, i, &count, &p);
        for (size_t k = 0; k < count && status == BAT_OK; k++) {
            const double *b = p + 8 * k;
            if (k == 0 || memcmp(b, b - 2, 2 * sizeof *b) != 0) cairo_move_to(cairo, b[0], b[1]);
            cairo_curve_to(cairo, b[2], b[3], b[4], b[5], b[6], b[7]);
        }
        bat_free(p);
    }
    const bat_paint *paint = bat_object_paint(object);
    set_source(cairo, &paint->stroke, bat_object_style(object)->stroke);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
    cairo_fill(cairo);
    cairo_append_path(cairo, path);
    cairo_path_destroy(path);
    return status;
}

static void draw_stroke(cairo_t *cairo, const bat_style *style, const bat_paint *paint) {
    set_source(cairo, paint ? &paint->stroke : NULL, style->stroke);
    set_pen(cairo, style);
    cairo_save(cairo);
    shape_pen(cairo, paint);
    cairo_stroke_preserve(cairo);
    cairo_restore(cairo);
}

static bat_status stroke_path(cairo_t *cairo, const bat_object *object) {
    if (bat_object_widths(object).count) return widen_path(cairo, object);
    draw_stroke(cairo, bat_object_style(object), bat_object_paint(object));
    return BAT_OK;
}

/* Begins what is painted through the masks of a clip: each a group. */
static void begin_masks(cairo_t *cairo, const bat_clip *clip) {
    for (; clip; clip = bat_clip_within(clip))
        if (bat_clip_picture(clip)) cairo_push_group(cairo);
}

/* Paints the group as far as the picture covers it. */
static void end_mask(cairo_t *cairo, const bat_clip *mask) {
    const double *m = bat_clip_matrix(mask);
    const cairo_matrix_t place = {m[0], m[1], m[2], m[3], m[4], m[5]};
    cairo_pattern_t *inner = cairo_pop_group(cairo);
    cairo_save(cairo);
    cairo_push_group(cairo);
    cairo_transform(cairo, &place);
    const bool painted = paint_once(cairo, bat_clip_picture(mask));
    cairo_pattern_t *cover = cairo_pop_group(cairo);
    cairo_restore(cairo);
    cairo_set_source(cairo, inner);
    if (painted)
        cairo_mask(cairo, cover);
    else
        cairo_paint(cairo);
    cairo_pattern_destroy(cover);
    cairo_pattern_destroy(inner);
}

static void end_masks(cairo_t *cairo, const bat_clip *clip, paint_left *left) {
    for (; clip; clip = bat_clip_within(clip)) {
        if (!bat_clip_picture(clip)) continue;
        left->masks += !paint_is_known(cairo, bat_clip_picture(clip));
        end_mask(cairo, clip);
    }
}

/* From now on only what lies in all regions is painted, until cairo_restore. */
static bat_status clip_to(cairo_t *cairo, const bat_clip *clip, double tolerance) {
    bat_status status = BAT_OK;
    for (; clip && status == BAT_OK; clip = bat_clip_within(clip)) {
        cairo_new_path(cairo);
        for (int i = 0; i < bat_clip_curve_count(clip) && status == BAT_OK; i++)
            status = trace(cairo, bat_clip_curve(clip, i), tolerance);
        cairo_set_fill_rule(cairo,
                            bat_clip_is_even_odd(clip) ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        cairo_clip(cairo);
    }
    return status;
}

static bat_status trace_all(cairo_t *cairo, const bat_object *object, double tolerance) {
    bat_status status = BAT_OK;
    cairo_new_path(cairo);
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = trace(cairo, bat_object_curve(object, i), tolerance);
    return status;
}

/* The markers of an object, each as an object of its own. */
typedef struct marks {
    bat_object **list;
    int count;
    bat_marker_order order;
} marks;

static bat_status paint_object(cairo_t *cairo, const bat_object *object, const marks *m, double tolerance);

static bat_status paint_marks(cairo_t *cairo, const marks *m, double tolerance) {
    bat_status status = BAT_OK;
    for (int i = 0; i < m->count && status == BAT_OK; i++) {
        cairo_save(cairo);
        status = clip_to(cairo, bat_object_clip(m->list[i]), tolerance);
        if (status == BAT_OK) status = paint_object(cairo, m->list[i], NULL, tolerance);
        cairo_restore(cairo);
    }
    return status;
}

/* Fill, stroke and markers, in their order. */
static bat_status paint_parts(cairo_t *cairo, const bat_object *object, const marks *m, double tolerance) {
    const bat_style *style = bat_object_style(object);
    const bat_paint *paint = bat_object_paint(object);
    const bool first = paint && paint->stroke_first, stroked = style->stroked && style->width > 0;
    bat_status status = BAT_OK;
    for (int step = 0; step < 3 && status == BAT_OK; step++) {
        if (m && (int)m->order == (step + 1) % 3) status = paint_marks(cairo, m, tolerance);
        if (step == 2 || status != BAT_OK) continue;
        status = trace_all(cairo, object, tolerance);
        if (status == BAT_OK && stroked && first == (step == 0)) status = stroke_path(cairo, object);
        if (status == BAT_OK && style->filled && first == (step == 1)) fill_path(cairo, style, paint);
    }
    cairo_new_path(cairo);
    return status;
}

/* marks: NULL: it has none. */
static bat_status paint_object(cairo_t *cairo, const bat_object *object, const marks *m, double tolerance) {
    const bat_style *style = bat_object_style(object);
    const bool stroked = style->stroked && style->width > 0;
    if ((!stroked && !style->filled && !m) || style->opacity <= 0) return BAT_OK;
    if (style->opacity == 1) return paint_parts(cairo, object, m, tolerance);
    /* Opacity of the object as a whole: fill and stroke do not show through each other. */
    bat_status status = trace_all(cairo, object, tolerance);
    if (status != BAT_OK) return status;
    cairo_save(cairo);
    if (!m) clip_to_path(cairo, style, bat_object_paint(object), stroked);
    cairo_push_group(cairo);
    status = paint_parts(cairo, object, m, tolerance);
    cairo_pop_group_to_source(cairo);
    cairo_paint_with_alpha(cairo, style->opacity);
    cairo_restore(cairo);
    return status;
}

static bat_status paint_marked(cairo_t *cairo, const bat_object *object, double tolerance) {
    marks m = {0};
    if (!bat_object_markers(object)) return paint_object(cairo, object, NULL, tolerance);
    m.order = bat_markers_marked(bat_object_markers(object))->order;
    bat_status status = bat_object_mark(object, &m.count, &m.list);
    if (status == BAT_OK) status = paint_object(cairo, object, &m, tolerance);
    for (int i = 0; i < m.count; i++) bat_object_release(m.list[i]);
    free(m.list);
    return status;
}

/* Groups that are translucent as a whole or clipped, as far as they have been begun: the outermost first. */
typedef struct layers {
    struct {
        bat_id id;
        double opacity; /* 1: they are no picture of their own */
        const bat_clip *clip;
    } open[BAT_NESTING_MAX];
    int depth;
    paint_left left;
} layers;

/* What follows is painted for itself, in no more of the picture than the group's contents can reach. */
static bat_status begin_layer(cairo_t *cairo, const bat_document *document, int index, double tolerance,
                              layers *l) {
    const bat_object *group = bat_document_at(document, index);
    cairo_save(cairo);
    l->open[l->depth].id = bat_object_id(group);
    l->open[l->depth].clip = bat_object_clip(group);
    l->open[l->depth++].opacity = bat_object_style(group)->opacity;
    const bat_status status = clip_to(cairo, bat_object_clip(group), tolerance);
    begin_masks(cairo, bat_object_clip(group));
    if (status != BAT_OK || bat_object_style(group)->opacity == 1) return status;
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY}, room = 2, across = 0;
    for (int i = index + 1; i < bat_document_end(document, index); i++)
        grow(bat_document_at(document, i), box);
    cairo_device_to_user_distance(cairo, &room, &across);
    cairo_new_path(cairo);
    if (box[0] <= box[2])
        cairo_rectangle(cairo, box[0] - room, box[1] - room, box[2] - box[0] + 2 * room,
                        box[3] - box[1] + 2 * room);
    cairo_clip(cairo);
    cairo_push_group(cairo);
    return BAT_OK;
}

/* Ends the groups that the next object is not in. */
static void end_layers(cairo_t *cairo, const bat_nesting *nesting, layers *l) {
    for (bool in = false; l->depth > 0 && !in;) {
        for (int i = 0; nesting && i < nesting->depth; i++)
            in = in || nesting->open[i].id == l->open[l->depth - 1].id;
        if (in) return;
        if (l->open[--l->depth].opacity != 1) {
            cairo_pop_group_to_source(cairo);
            cairo_paint_with_alpha(cairo, l->open[l->depth].opacity);
        }
        end_masks(cairo, l->open[l->depth].clip, &l->left);
        cairo_restore(cairo);
    }
}

static bool is_layer(const bat_object *object) {
    return bat_object_is_group(object) && (bat_object_style(object)->opacity < 1 || bat_object_clip(object));
}

/* How many of its patterns are not painted as they are. */
static int count_unrepeated(cairo_t *cairo, const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    const bat_gradient none = {0}, *const parts[2] = {paint ? &paint->fill : &none,
                                                      paint ? &paint->stroke : &none};
    int count = 0;
    for (int k = 0; k < 2; k++) count += parts[k]->tile && !paint_is_known(cairo, parts[k]->tile);
    return count;
}

/* As far as it is seen. */
static bat_status paint_clipped(cairo_t *cairo, const bat_object *object, double tolerance,
                                paint_left *left) {
    cairo_save(cairo);
    bat_status status = clip_to(cairo, bat_object_clip(object), tolerance);
    begin_masks(cairo, bat_object_clip(object));
    if (status == BAT_OK && bat_object_picture(object)) {
        int *missing = bat_object_is_foreign(object) ? &left->foreign : &left->images;
        *missing += !paint_is_known(cairo, bat_object_picture(object));
        paint_placed(cairo, object);
    } else if (status == BAT_OK) {
        left->patterns += count_unrepeated(cairo, object);
        status = paint_marked(cairo, object, tolerance);
    }
    end_masks(cairo, bat_object_clip(object), left);
    cairo_restore(cairo);
    return status;
}

bat_status paint_area_onto(cairo_t *cairo, const bat_document *document, const paint_area *area,
                           uint32_t background, paint_left *left) {
    if (background & 255) {
        set_colour(cairo, background);
        cairo_paint(cairo);
    }
    double scale = fmin(area->width / area->view[2], area->height / area->view[3]);
    cairo_translate(cairo, (area->width - scale * area->view[2]) / 2,
                    (area->height - scale * area->view[3]) / 2);
    cairo_scale(cairo, scale, scale);
    cairo_translate(cairo, -area->view[0], -area->view[1]);
    bat_nesting nesting = {0};
    layers translucent = {0};
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        end_layers(cairo, &nesting, &translucent);
        if (level.hidden) continue;
        if (is_layer(object)) status = begin_layer(cairo, document, i, 0.05 / scale, &translucent);
        if (status == BAT_OK && (bat_object_is_painted(object) || bat_object_picture(object)))
            status = paint_clipped(cairo, object, 0.05 / scale, left);
    }
    end_layers(cairo, NULL, &translucent);
    left->masks += translucent.left.masks;
    return status;
}

/* Adds what says how large a pixel is (pHYs), after the header. */
static bool say_size(byte_list *png, double pixels_a_metre) {
    enum { HEADER = 33, CHUNK = 21 };
    const uint32_t per = (uint32_t)fmin(fmax(round(pixels_a_metre), 1), 0x7fffffff);
    unsigned char chunk[CHUNK] = {0, 0, 0, 9, 'p', 'H', 'Y', 's', [16] = 1};
    if (png->size < HEADER) return false;
    unsigned char *all = realloc(png->data, png->size + CHUNK);
    if (!all) return false;
    png->data = all;
    for (int k = 0; k < 8; k++) chunk[8 + k] = (unsigned char)(per >> (24 - 8 * (k % 4)));
    const uint32_t check = (uint32_t)crc32(0, chunk + 4, 13);
    for (int k = 0; k < 4; k++) chunk[17 + k] = (unsigned char)(check >> (24 - 8 * k));
    memmove(all + HEADER + CHUNK, all + HEADER, png->size - HEADER);
    memcpy(all + HEADER, chunk, CHUNK);
    png->size += CHUNK;
    return true;
}

/* The picture of pixels as a file. */
static cairo_status_t write_png(const bat_document *document, const paint_area *area,
                                const picture_wanted *wanted, cairo_surface_t *surface, byte_list *bytes) {
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface, collect_bytes, bytes);
    const double scale = fmin(area->width / area->view[2], area->height / area->view[3]);
    if (status != CAIRO_STATUS_SUCCESS) return status;
    if (!bat_unit_is_physical(bat_document_unit(document)) && !(wanted->dpi > 0)) return status;
    return say_size(bytes, 1000 * scale / bat_document_scale(document)) ? status : CAIRO_STATUS_NO_MEMORY;
}

const char *paint_document(const bat_document *document, const paint_area *area, const picture_wanted *wanted,
                           unsigned char **data, size_t *size, paint_left *left) {
    byte_list bytes = {0};
    const picture_kind kind = wanted->kind;
    cairo_surface_t *surface = kind == PICTURE_PNG
                                   ? cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)area->width,
                                                                (int)area->height)
                                   : page_create(kind, &bytes, area->width, area->height);
    cairo_t *cairo = cairo_create(surface);
    bat_status status = paint_area_onto(cairo, document, area, wanted->background, left);
    cairo_status_t painted = cairo_status(cairo);
    cairo_destroy(cairo);
    if (painted == CAIRO_STATUS_SUCCESS && status == BAT_OK && kind == PICTURE_PNG)
        painted = write_png(document, area, wanted, surface, &bytes);
    return page_end(surface, status, painted, &bytes, data, size);
}
