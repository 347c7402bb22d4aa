#include "format/svg/markup.h"

#include "base/matrix.h"
#include "base/real.h"
#include "document/document.h"
#include "document/lettering.h"
#include "document/scale.h"
#include "format/svg/digest.h"
#include "format/svg/svg.h"
#include "text/base64.h"
#include "text/number.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

void bat_svg_write_number(bat_text *text, const char *attribute, double number) {
    bat_text_string(text, attribute);
    bat_text_number(text, number);
    bat_text_string(text, "\"");
}

void bat_svg_write_size(bat_text *text, const char *attribute, double length, const bat_document *document) {
    const bool said = document && bat_unit_is_said(document);
    const bat_unit unit = said ? bat_document_unit(document) : BAT_UNIT_PX;
    char digits[32];
    bat_text_string(text, attribute);
    if (said) { /* ten digits: a scale is a ratio that was rounded */
        double value = length * bat_document_scale(document) / bat_unit_millimetres(unit);
        snprintf(digits, sizeof digits, "%.10g", value);
        (void)bat_number_scan(digits, digits + strlen(digits), &value);
        bat_text_number(text, value);
    } else
        bat_text_number(text, length);
    bat_text_string(text, bat_unit_is_physical(unit) ? bat_unit_name(unit) : "");
    bat_text_string(text, "\"");
}

void bat_svg_write_name(bat_text *text, const char *attribute, const char *name) {
    if (!*name) return;
    bat_text_string(text, attribute);
    bat_text_xml(text, name, strlen(name), true);
    bat_text_string(text, "\"");
}

void bat_svg_write_state(bat_text *text, const bat_object *object) {
    if (bat_object_is_hidden(object)) bat_text_string(text, " display=\"none\"");
    if (bat_object_is_locked(object)) bat_text_string(text, " data-locked=\"true\"");
}

void bat_svg_write_picture(bat_text *text, const bat_picture *picture, const double m[6], double opacity,
                           const bat_svg_ids *ids) {
    double sides[2];
    size_t size;
    const void *bytes = bat_picture_bytes(picture, &size);
    bat_picture_sides(picture, sides);
    bat_svg_write_number(text, " width=\"", sides[0]);
    bat_svg_write_number(text, " height=\"", sides[1]);
    bat_text_string(text, " preserveAspectRatio=\"none\" transform=\"matrix(");
    for (int i = 0; i < 6; i += 2) {
        if (i > 0) bat_text_string(text, " ");
        bat_svg_write_pair(text, m + i);
    }
    bat_text_string(text, ")\"");
    if (opacity != 1) bat_svg_write_number(text, " opacity=\"", opacity);
    bat_svg_refer_clip(text, ids);
    bat_text_string(text, " href=\"data:");
    bat_text_string(text, bat_picture_type(picture));
    bat_text_string(text, ";base64,");
    bat_base64_write(text, bytes, size);
    bat_text_string(text, "\"/>");
}

void bat_svg_write_lettering(bat_text *text, const bat_object *object, const double m[6], double opacity,
                             const bat_svg_ids *ids) {
    bat_text_string(text, " transform=\"");
    bat_svg_write_matrix(m, text);
    bat_text_string(text, "\"");
    if (opacity != 1) bat_svg_write_number(text, " opacity=\"", opacity);
    bat_svg_refer_clip(text, ids);
    bat_lettering_markup(bat_object_lettering(object), bat_object_style(object)->fill, text);
    bat_text_string(text, "</text>");
}

void bat_svg_write_matrix(const double m[6], bat_text *out) {
    bat_text_string(out, "matrix(");
    for (int i = 0; i < 6; i += 2) {
        if (i > 0) bat_text_string(out, " ");
        bat_svg_write_pair(out, m + i);
    }
    bat_text_string(out, ")");
}

/* ---- style and paint ---- */

static void write_stops(bat_text *text, const bat_gradient *g) {
    for (size_t i = 0; i < g->count; i++) {
        char value[40];
        const uint32_t colour = g->stops[i].colour;
        bat_svg_write_number(text, "<stop offset=\"", g->stops[i].at);
        snprintf(value, sizeof value, " stop-color=\"#%06lx\"", (unsigned long)(colour >> 8));
        bat_text_string(text, value);
        if ((colour & 0xff) != 0xff)
            bat_svg_write_number(text, " stop-opacity=\"", floor((colour & 0xff) / 0.255 + 0.5) / 1000);
        bat_text_string(text, "/>");
    }
}

/* With the picture in it, as translucent as it is. */
static void write_pattern(bat_text *text, const bat_gradient *g, const double m[6], const char *id) {
    static const double same[6] = {1, 0, 0, 1, 0, 0};
    const bat_svg_ids none = {0};
    const uint32_t alpha = g->stops[0].colour & 0xff;
    double sides[2], own[6];
    bat_picture_sides(g->tile, sides);
    bat_matrix_compose(m, g->matrix, own);
    bat_text_string(text, "<pattern id=\"");
    bat_text_string(text, id);
    bat_text_string(text, "\" patternUnits=\"userSpaceOnUse\"");
    bat_svg_write_number(text, " width=\"", sides[0]);
    bat_svg_write_number(text, " height=\"", sides[1]);
    bat_text_string(text, " patternTransform=\"");
    bat_svg_write_matrix(own, text);
    bat_text_string(text, "\"><image");
    bat_svg_write_picture(text, g->tile, same, floor(alpha / 0.255 + 0.5) / 1000, &none);
    bat_text_string(text, "</pattern>");
}

void bat_svg_write_gradient(bat_text *text, const bat_gradient *g, const double m[6], const char *id) {
    if (g->tile) {
        write_pattern(text, g, m, id);
        return;
    }
    static const char *const line[] = {" x1=\"", " y1=\"", "", " x2=\"", " y2=\"", ""},
                             *const circle[] = {" fx=\"", " fy=\"", " fr=\"", " cx=\"", " cy=\"", " r=\""};
    static const char *const spreads[] = {"", " spreadMethod=\"reflect\"", " spreadMethod=\"repeat\""};
    const char *const *names = g->radial ? circle : line;
    double own[6];
    bat_text_string(text, g->radial ? "<radialGradient id=\"" : "<linearGradient id=\"");
    bat_text_string(text, id);
    bat_text_string(text, "\" gradientUnits=\"userSpaceOnUse\"");
    for (int k = 0; k < 6; k++)
        if (*names[k] && (k != 2 || g->from[2] > 0))
            bat_svg_write_number(text, names[k], k < 3 ? g->from[k] : g->to[k - 3]);
    bat_matrix_compose(m, g->matrix, own);
    if (own[0] != 1 || own[1] != 0 || own[2] != 0 || own[3] != 1 || own[4] != 0 || own[5] != 0) {
        bat_text_string(text, " gradientTransform=\"");
        bat_svg_write_matrix(own, text);
        bat_text_string(text, "\"");
    }
    bat_text_string(text, spreads[g->spread]);
    bat_text_string(text, ">");
    write_stops(text, g);
    bat_text_string(text, g->radial ? "</radialGradient>" : "</linearGradient>");
}

bat_svg_ids bat_svg_write_gradients(bat_text *text, const bat_object *object, const double m[6], int number) {
    const bat_paint *paint = bat_object_paint(object);
    const bat_style *style = bat_object_style(object);
    const unsigned long id = (unsigned long)bat_object_id(object);
    bat_svg_ids ids = {0};
    if (!paint) return ids;
    if (style->filled && paint->fill.count) {
        snprintf(ids.fill, sizeof ids.fill, BAT_SVG_PAINT_ID "%lu-fill-%d", id, number);
        bat_svg_write_gradient(text, &paint->fill, m, ids.fill);
    }
    if (style->stroked && paint->stroke.count) {
        snprintf(ids.stroke, sizeof ids.stroke, BAT_SVG_PAINT_ID "%lu-stroke-%d", id, number);
        bat_svg_write_gradient(text, &paint->stroke, m, ids.stroke);
    }
    return ids;
}

bat_status bat_svg_write_region(bat_text *text, const bat_clip *region, const double m[6]) {
    bat_status status = BAT_OK;
    double rows[12];
    bat_matrix_rows(m, 2, rows);
    for (int i = 0; i < bat_clip_curve_count(region) && status == BAT_OK; i++) {
        bat_curve *own = NULL;
        status = bat_curve_transform(bat_clip_curve(region, i), rows, &own);
        if (status == BAT_OK) status = bat_svg_write_curve(text, own, NULL, 0);
        bat_curve_free(own);
    }
    return status;
}

/* With the picture in it, within the one around it; only its alpha counts. */
static void write_mask(bat_text *text, const bat_clip *mask, const double m[6], const char *id,
                       const char *outer) {
    static const char *const names[] = {" x=\"", " y=\"", " width=\"", " height=\""};
    const bat_svg_ids none = {0};
    double own[6], sides[2], box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    bat_picture_sides(bat_clip_picture(mask), sides);
    bat_matrix_compose(m, bat_clip_matrix(mask), own);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++) {
            const double at = own[k] * (i & 1 ? sides[0] : 0) + own[2 + k] * (i & 2 ? sides[1] : 0) +
                              own[4 + k];
            box[k] = fmin(box[k], at), box[k + 2] = fmax(box[k + 2], at);
        }
    bat_text_string(text, "<mask id=\"");
    bat_text_string(text, id);
    bat_text_string(text, "\" maskUnits=\"userSpaceOnUse\"");
    for (int i = 0; i < 4; i++) bat_svg_write_number(text, names[i], box[i] - (i > 1 ? box[i - 2] : 0));
    bat_text_string(text, " style=\"mask-type:alpha\">");
    if (*outer) {
        bat_text_string(text, "<g mask=\"url(#");
        bat_text_string(text, outer);
        bat_text_string(text, ")\">");
    }
    bat_text_string(text, "<image");
    bat_svg_write_picture(text, bat_clip_picture(mask), own, 1, &none);
    bat_text_string(text, *outer ? "</g></mask>" : "</mask>");
}

/* From the outermost region inwards. */
bat_status bat_svg_write_clip(bat_text *text, const bat_object *object, const double m[6], int number,
                              bat_svg_ids *ids) {
    const bat_clip *list[BAT_CLIP_REGIONS_MAX];
    int count = 0;
    bat_status status = BAT_OK;
    for (const bat_clip *at = bat_object_clip(object); at; at = bat_clip_within(at)) list[count++] = at;
    for (int k = count - 1; k >= 0 && status == BAT_OK; k--) {
        char outer[BAT_SVG_ID], *id = bat_clip_picture(list[k]) ? ids->mask : ids->clip;
        memcpy(outer, id, sizeof outer);
        snprintf(id, BAT_SVG_ID, BAT_SVG_PAINT_ID "%lu-%s-%d-%d", (unsigned long)bat_object_id(object),
                 id == ids->mask ? "mask" : "clip", k, number);
        if (id == ids->mask) {
            write_mask(text, list[k], m, id, outer);
            continue;
        }
        bat_text_string(text, "<clipPath id=\"");
        bat_text_string(text, id);
        if (*outer) {
            bat_text_string(text, "\" clip-path=\"url(#");
            bat_text_string(text, outer);
            bat_text_string(text, ")");
        }
        bat_text_string(text, "\">");
        if (bat_clip_curve_count(list[k]) > 0) {
            bat_text_string(text, bat_clip_is_even_odd(list[k]) ? "<path clip-rule=\"evenodd\" d=\""
                                                                : "<path clip-rule=\"nonzero\" d=\"");
            status = bat_svg_write_region(text, list[k], m);
            bat_text_string(text, "\"/>");
        }
        bat_text_string(text, "</clipPath>");
    }
    return status;
}

/* The frame of its markers, where that slants them; else NULL. */
static const double *slant(const bat_object *object) {
    const bat_markers *markers = bat_object_markers(object);
    const double *f = markers ? bat_markers_marked(markers)->frame : NULL;
    double round[4];
    if (!f) return NULL;
    const bat_paint as_pen = {.pen = {f[0], f[1], f[2], f[3]}};
    bat_paint_pen(&as_pen, round);
    return round[0] == f[0] && round[1] == f[1] && round[2] == f[2] && round[3] == f[3] ? f : NULL;
}

bool bat_svg_pen(const bat_object *object, double pen[6], double back[6]) {
    double own[4];
    bat_paint_pen(bat_object_paint(object), own);
    const double *f = bat_object_style(object)->stroked ? NULL : slant(object);
    const double scale = f ? sqrt(fabs(f[0] * f[3] - f[1] * f[2])) : 1;
    for (int k = 0; k < 4 && f; k++) own[k] = f[k] / scale;
    const double m[6] = {own[0], own[1], own[2], own[3], 0, 0};
    const bool uneven = own[0] != 1 || own[1] != 0 || own[2] != 0 || own[3] != 1;
    memcpy(pen, m, sizeof m);
    if (uneven && (f || bat_object_style(object)->stroked) && bat_svg_inverse(m, back)) return true;
    bat_matrix_identity(pen);
    bat_matrix_identity(back);
    return false;
}

bat_status bat_svg_write_curve(bat_text *text, const bat_curve *curve, const double m[6], double precision) {
    bat_svg_cubics c;
    const bat_status status = bat_svg_cubics_make(curve, m, precision, &c);
    if (status != BAT_OK) return status;
    const bool closed = bat_curve_is_closed(curve);
    double start[2], from[2], end[2];
    bat_svg_round(&c, c.points, start);
    bat_text_string(text, "M");
    bat_svg_write_pair(text, start);
    memcpy(from, start, sizeof from);
    for (int i = 0; i < c.count; i++) {
        const bool last = closed && i == c.count - 1; /* the curve closes bit for bit */
        if (last)
            memcpy(end, start, sizeof end);
        else
            bat_svg_round(&c, bat_svg_cubic(&c, i) + (ptrdiff_t)3 * c.dimension, end);
        if (last && bat_svg_is_closing(&c, i, from, start)) break;
        bat_svg_write_cubic(text, &c, i, end);
        memcpy(from, end, sizeof from);
    }
    if (closed) bat_text_string(text, "Z");
    bat_svg_cubics_free(&c);
    return BAT_OK;
}

bat_status bat_svg_write_curves(bat_text *text, const bat_object *object, const double m[6],
                                double precision) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = bat_svg_write_curve(text, bat_object_curve(object, i), m, precision);
    return status;
}

void bat_svg_write_dashes(bat_text *text, const bat_paint *paint, double scale) {
    for (size_t i = 0; i < paint->dash_count; i++) {
        if (i > 0) bat_text_string(text, " ");
        bat_text_number(text, paint->dashes[i] * scale);
    }
}

const char *bat_svg_order(const bat_object *object) {
    static const char *const words[BAT_MARKER_ORDERS][2] = {
        {"normal", "stroke"}, {"markers", "markers stroke"}, {"fill markers", "stroke markers"}};
    const bat_markers *markers = bat_object_markers(object);
    const bat_paint *paint = bat_object_paint(object);
    return words[markers ? bat_markers_marked(markers)->order : BAT_MARKERS_LAST]
                [paint && paint->stroke_first];
}

static const char *const places[BAT_MARKER_PLACES] = {"marker-start", "marker-mid", "marker-end"};

static void refer_markers(bat_text *text, const bat_svg_ids *ids) {
    char value[BAT_SVG_ID + 32];
    for (int k = 0; k < BAT_MARKER_PLACES; k++) {
        if (!*ids->markers[k]) continue;
        snprintf(value, sizeof value, " %s=\"url(#%s)\"", places[k], ids->markers[k]);
        bat_text_string(text, value);
    }
}

/* Three decimals of alpha are enough to restore all 256 values. */
static void write_paint(bat_text *text, const char *property, uint32_t colour, const char *id) {
    char value[80];
    if (*id) {
        snprintf(value, sizeof value, " %s=\"url(#%s)\"", property, id);
        bat_text_string(text, value);
        return;
    }
    snprintf(value, sizeof value, " %s=\"#%06lx\"", property, (unsigned long)(colour >> 8));
    bat_text_string(text, value);
    if ((colour & 0xff) == 0xff) return;
    snprintf(value, sizeof value, " %s-opacity=\"", property);
    bat_svg_write_number(text, value, floor((colour & 0xff) / 0.255 + 0.5) / 1000);
}

/* begin: of what names the clip path, and the mask. */
static void refer(bat_text *text, const bat_svg_ids *ids, const char *const begin[2], const char *end) {
    const char *const own[2] = {ids->clip, ids->mask};
    for (int k = 0; k < 2; k++) {
        if (!*own[k]) continue;
        bat_text_string(text, begin[k]);
        bat_text_string(text, own[k]);
        bat_text_string(text, end);
    }
}

void bat_svg_refer_clip(bat_text *text, const bat_svg_ids *ids) {
    refer(text, ids, (const char *const[]){" clip-path=\"url(#", " mask=\"url(#"}, ")\"");
}

void bat_svg_write_style(bat_text *text, const bat_object *object, const bat_svg_ids *ids) {
    const bat_style *style = bat_object_style(object);
    const bat_paint *paint = bat_object_paint(object);
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    if (style->filled) {
        write_paint(text, "fill", style->fill, ids->fill);
        if (style->even_odd) bat_text_string(text, " fill-rule=\"evenodd\"");
    } else
        bat_text_string(text, " fill=\"none\"");
    if (style->stroked) {
        write_paint(text, "stroke", style->stroke, ids->stroke);
        bat_svg_write_number(text, " stroke-width=\"", style->width);
        if (style->cap != BAT_CAP_BUTT) {
            bat_text_string(text, " stroke-linecap=\"");
            bat_text_string(text, caps[style->cap]);
            bat_text_string(text, "\"");
        }
        if (style->join != BAT_JOIN_MITER) {
            bat_text_string(text, " stroke-linejoin=\"");
            bat_text_string(text, joins[style->join]);
            bat_text_string(text, "\"");
        }
        if (style->miter_limit != 4) bat_svg_write_number(text, " stroke-miterlimit=\"", style->miter_limit);
        if (paint && paint->dash_count) {
            bat_text_string(text, " stroke-dasharray=\"");
            bat_svg_write_dashes(text, paint, 1);
            bat_text_string(text, "\"");
            if (paint->dash_offset != 0)
                bat_svg_write_number(text, " stroke-dashoffset=\"", paint->dash_offset);
        }
    }
    if (strcmp(bat_svg_order(object), "normal") != 0) {
        bat_text_string(text, " paint-order=\"");
        bat_text_string(text, bat_svg_order(object));
        bat_text_string(text, "\"");
    }
    refer_markers(text, ids);
    if (style->opacity != 1) bat_svg_write_number(text, " opacity=\"", style->opacity);
    bat_svg_refer_clip(text, ids);
}

static void declare(bat_text *text, const char *property, double number) {
    bat_text_string(text, property);
    bat_text_number(text, number);
}

/* Of what has them, or could have those of something around it. */
static void declare_markers(bat_text *text, const bat_svg_ids *ids) {
    char value[BAT_SVG_ID + 32];
    bool any = ids->unmarked;
    for (int k = 0; k < BAT_MARKER_PLACES; k++) any = any || *ids->markers[k];
    for (int k = 0; k < BAT_MARKER_PLACES && any; k++) {
        snprintf(value, sizeof value, *ids->markers[k] ? "%s:url(#%s);" : "%s:none;", places[k],
                 ids->markers[k]);
        bat_text_string(text, value);
    }
}

static void declare_paint(bat_text *text, const char *property, bool painted, uint32_t colour, const char *id,
                          bat_marker_ink ink) {
    static const char *const inks[BAT_INKS] = {"", "context-fill", "context-stroke"};
    char value[80];
    if (painted && *id) {
        snprintf(value, sizeof value, "%s:url(#%s);%s-opacity:1;", property, id, property);
        bat_text_string(text, value);
        return;
    }
    if (painted && ink != BAT_INK_OWN)
        snprintf(value, sizeof value, "%s:%s;", property, inks[ink]);
    else
        snprintf(value, sizeof value, painted ? "%s:#%06lx;" : "%s:none;", property,
                 (unsigned long)(colour >> 8));
    bat_text_string(text, value);
    if (!painted) return;
    snprintf(value, sizeof value, "%s-opacity:", property);
    declare(text, value, floor((colour & 0xff) / 0.255 + 0.5) / 1000);
    bat_text_string(text, ";");
}

void bat_svg_write_style_attribute(bat_text *text, const bat_object *object, const bat_style *style,
                                   const bat_svg_ids *ids) {
    const bat_paint *paint = bat_object_paint(object);
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    bat_text_string(text, " style=\"");
    declare_paint(text, "fill", style->filled, style->fill, ids->fill, ids->inks[0]);
    if (style->filled) bat_text_string(text, style->even_odd ? "fill-rule:evenodd;" : "fill-rule:nonzero;");
    declare_paint(text, "stroke", style->stroked, style->stroke, ids->stroke, ids->inks[1]);
    if (style->stroked) {
        declare(text, "stroke-width:", style->width);
        bat_text_string(text, ";stroke-linecap:");
        bat_text_string(text, caps[style->cap]);
        bat_text_string(text, ";stroke-linejoin:");
        bat_text_string(text, joins[style->join]);
        declare(text, ";stroke-miterlimit:", style->miter_limit);
        bat_text_string(text, ";stroke-dasharray:");
        if (paint && paint->dash_count) {
            bat_svg_write_dashes(text, paint, 1);
            declare(text, ";stroke-dashoffset:", paint->dash_offset);
            bat_text_string(text, ";");
        } else
            bat_text_string(text, "none;");
    }
    if (strcmp(bat_svg_order(object), "normal") != 0) {
        bat_text_string(text, "paint-order:");
        bat_text_string(text, bat_svg_order(object));
        bat_text_string(text, ";");
    }
    declare_markers(text, ids);
    declare(text, "opacity:", style->opacity);
    refer(text, ids, (const char *const[]){";clip-path:url(#", ";mask:url(#"}, ")");
    bat_text_string(text, "\"");
}

/* ---- what is seen from a view ---- */

static double hundredths(double value) { return floor(value * 100 + 0.5) / 100 + 0.0; }

/* A line that is shorter than the digits written: nothing of it would be seen. */
static bool is_dot(const bat_seen_line *line) {
    for (int k = 2; k < 2 * (3 * line->segments + 1); k++)
        if (hundredths(line->points[k]) != hundredths(line->points[k % 2])) return false;
    return true;
}

static bat_status add_digest(uint64_t *digest, const bat_text *text, size_t start, const bat_seen_pen *p,
                             bool dashed, bat_outline *outline) {
    const double dashes[] = {BAT_SEEN_DASH, BAT_SEEN_GAP};
    bat_style style = bat_style_defaults();
    const bat_paint paint = {.dashes = dashes, .dash_count = dashed ? 2 : 0};
    style.stroke = p->colour, style.width = p->width;
    if (dashed) style.cap = BAT_CAP_BUTT;
    bat_outline_clear(outline);
    bat_svg_path(text->data + start, text->size - start, outline);
    if (outline->failed || outline->full) return outline->failed ? BAT_MEMORY : BAT_COUNT;
    *digest = bat_svg_digest(*digest, outline, &style, &paint);
    return BAT_OK;
}

static bat_status write_line(bat_text *text, const bat_seen_line *line, const bat_seen_pen *p,
                             bat_outline *outline, uint64_t *digest) {
    char colour[40];
    snprintf(colour, sizeof colour, "<path stroke=\"#%06lx\"", (unsigned long)(p->colour >> 8));
    bat_text_string(text, colour);
    if ((p->colour & 255) != 255)
        bat_svg_write_number(text, " stroke-opacity=\"", floor((p->colour & 255) / 0.255 + 0.5) / 1000);
    bat_svg_write_number(text, " stroke-width=\"", p->width);
    if (line->hidden) bat_text_string(text, " stroke-linecap=\"butt\" stroke-dasharray=\"4 3\"");
    bat_text_string(text, " d=\"");
    const size_t start = text->size;
    for (int k = 0; k < 3 * line->segments + 1; k++) {
        const double at[2] = {hundredths(line->points[2 * k]), hundredths(line->points[2 * k + 1])};
        bat_text_string(text, k == 0 ? "M" : k % 3 == 1 ? "C" : " ");
        bat_svg_write_pair(text, at);
    }
    const bat_status status = text->failed ? BAT_MEMORY
                              : digest     ? add_digest(digest, text, start, p, line->hidden, outline)
                                           : BAT_OK;
    bat_text_string(text, "\"/>\n");
    return status;
}

bat_status bat_svg_write_seen(bat_text *text, const bat_seen_content *c, bool dashed, uint64_t *digest) {
    bat_outline outline = {0};
    bat_status status = BAT_OK;
    bat_text_string(text, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    for (int pass = dashed ? 0 : 1; pass < 2; pass++)
        for (size_t i = 0; status == BAT_OK && i < bat_line_drawing_count(c->lines); i++) {
            bat_seen_line line;
            bat_line_drawing_at(c->lines, i, &line);
            if (line.hidden == (pass == 1) || is_dot(&line)) continue;
            bat_seen_pen p = bat_seen_pen_of(c, &line);
            p.width = hundredths(p.width);
            status = write_line(text, &line, &p, &outline, digest);
        }
    bat_text_string(text, "</g>\n");
    bat_outline_free(&outline);
    return status;
}
