#include "format/svg/markup.h"

#include "text/base64.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Relative to the curve's size: the error allowed in the cubics for a curve above degree 3. */
static const double CUBICS = 1e-7;
/* The same: how far handles may be off the thirds of a line, which is rounding. */
static const double THIRDS = 1e-12;

void bat_svg_write_pair(bat_text *text, const double *p) {
    bat_text_number(text, p[0]);
    bat_text_string(text, " ");
    bat_text_number(text, p[1]);
}

/* Whether a cubic is what a reader makes of a line: its handles at the thirds. */
static bool is_line(const double *p, int dimension, double size) {
    const double *end = p + 3 * dimension;
    for (int k = 1; k < 3; k++)
        for (int i = 0; i < 2; i++)
            if (!(fabs(p[k * dimension + i] - (p[i] + k * (end[i] - p[i]) / 3)) <= THIRDS * size))
                return false;
    return true;
}

bat_status bat_svg_write_curve(bat_text *text, const bat_curve *curve) {
    const double extent = bat_curve_size(curve);
    double *points, tolerance = CUBICS * extent;
    int count, dimension = bat_curve_dimension(curve);
    bat_status status = bat_curve_to_cubics(curve, tolerance > 0 ? tolerance : 1, &count, &points);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    const double *p = points;
    bat_text_string(text, "M");
    bat_svg_write_pair(text, p);
    for (int i = 0; i < count; i++, p += 4 * dimension) {
        bool line = bat_curve_degree(curve) == 1 || is_line(p, dimension, extent);
        bat_text_string(text, line ? "L" : "C");
        for (int k = line ? 3 : 1; k < 4; k++) {
            const double *q = p + k * dimension;
            if (i == count - 1 && k == 3 && bat_curve_is_closed(curve))
                q = points; /* the curve closes bit for bit */
            bat_svg_write_pair(text, q);
            if (k < 3) bat_text_string(text, " ");
        }
    }
    if (bat_curve_is_closed(curve)) bat_text_string(text, "Z");
    bat_free(points);
    return BAT_OK;
}

void bat_svg_write_number(bat_text *text, const char *attribute, double number) {
    bat_text_string(text, attribute);
    bat_text_number(text, number);
    bat_text_string(text, "\"");
}

/* Three decimals of alpha are enough to restore all 256 values. */
static void bat_svg_write_paint(bat_text *text, const char *property, uint32_t colour) {
    char value[80];
    snprintf(value, sizeof value, " %s=\"#%06lx\"", property, (unsigned long)(colour >> 8));
    bat_text_string(text, value);
    if ((colour & 0xff) == 0xff) return;
    snprintf(value, sizeof value, " %s-opacity=\"", property);
    bat_svg_write_number(text, value, floor((colour & 0xff) / 0.255 + 0.5) / 1000);
}

void bat_svg_write_style(bat_text *text, const bat_style *style) {
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    if (style->filled) {
        bat_svg_write_paint(text, "fill", style->fill);
        if (style->even_odd) bat_text_string(text, " fill-rule=\"evenodd\"");
    } else
        bat_text_string(text, " fill=\"none\"");
    if (style->stroked) {
        bat_svg_write_paint(text, "stroke", style->stroke);
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
    }
    if (style->opacity != 1) bat_svg_write_number(text, " opacity=\"", style->opacity);
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

void bat_svg_write_picture(bat_text *text, const bat_picture *picture, const double m[6], double opacity) {
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
    bat_text_string(text, " href=\"data:");
    bat_text_string(text, bat_picture_type(picture));
    bat_text_string(text, ";base64,");
    bat_base64_write(text, bytes, size);
    bat_text_string(text, "\"/>");
}

static void declare(bat_text *text, const char *property, double number) {
    bat_text_string(text, property);
    bat_text_number(text, number);
}

static void declare_paint(bat_text *text, const char *property, bool painted, uint32_t colour) {
    char value[80];
    snprintf(value, sizeof value, painted ? "%s:#%06lx;" : "%s:none;", property,
             (unsigned long)(colour >> 8));
    bat_text_string(text, value);
    if (!painted) return;
    snprintf(value, sizeof value, "%s-opacity:", property);
    declare(text, value, floor((colour & 0xff) / 0.255 + 0.5) / 1000);
    bat_text_string(text, ";");
}

void bat_svg_write_style_attribute(bat_text *text, const bat_style *style) {
    static const char *const caps[] = {"butt", "round", "square"}, *const joins[] = {"miter", "round",
                                                                                     "bevel"};
    bat_text_string(text, " style=\"");
    declare_paint(text, "fill", style->filled, style->fill);
    if (style->filled) bat_text_string(text, style->even_odd ? "fill-rule:evenodd;" : "fill-rule:nonzero;");
    declare_paint(text, "stroke", style->stroked, style->stroke);
    if (style->stroked) {
        declare(text, "stroke-width:", style->width);
        bat_text_string(text, ";stroke-linecap:");
        bat_text_string(text, caps[style->cap]);
        bat_text_string(text, ";stroke-linejoin:");
        bat_text_string(text, joins[style->join]);
        declare(text, ";stroke-miterlimit:", style->miter_limit);
        bat_text_string(text, ";stroke-dasharray:none;");
    }
    declare(text, "opacity:", style->opacity);
    bat_text_string(text, "\"");
}
