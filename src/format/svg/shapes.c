/* Basic shapes as outlines (SVG 2, 10): start points and directions are those of the standard. */
#include "text/number.h"
#include "format/svg/svg.h"
#include "hands/figures/primitive.h"

#include <math.h>
#include <string.h>

static double length(const bat_svg_shape *s, const char *name, double whole, double otherwise, bool *good) {
    const char *text = s->attribute(s->element, name);
    double value = otherwise;
    if (text && !bat_svg_length(text, whole, &value)) {
        *good = false;
        return otherwise;
    }
    return value;
}

/* -1 when the attribute is missing, empty or "auto". */
static double radius(const bat_svg_shape *s, const char *name, double whole, bool *good) {
    const char *text = s->attribute(s->element, name);
    if (!text || strcmp(text, "auto") == 0) return -1;
    double value = length(s, name, whole, -1, good);
    if (value < 0) *good = *good && value == -1;
    return value;
}

/* x, y, width, height, and the radii of the corners, which fit. False: one could not be read. */
static bool rect_numbers(const bat_svg_shape *s, double box[4], double radii[2]) {
    bool good = true;
    box[0] = length(s, "x", s->width, 0, &good), box[1] = length(s, "y", s->height, 0, &good);
    box[2] = length(s, "width", s->width, 0, &good), box[3] = length(s, "height", s->height, 0, &good);
    double rx = radius(s, "rx", s->width, &good), ry = radius(s, "ry", s->height, &good);
    if (rx < 0) rx = ry < 0 ? 0 : ry;
    if (ry < 0) ry = rx;
    radii[0] = fmin(rx, box[2] / 2), radii[1] = fmin(ry, box[3] / 2);
    return good;
}

static bool rect(const bat_svg_shape *s, bat_outline *o) {
    double box[4], radii[2];
    const bool good = rect_numbers(s, box, radii);
    const double x = box[0], y = box[1], w = box[2], h = box[3], rx = radii[0], ry = radii[1];
    if (w < 0 || h < 0) return false;
    if (w == 0 || h == 0) return good;
    if (rx == 0 || ry == 0) {
        bat_outline_move(o, x, y);
        bat_outline_line(o, x + w, y);
        bat_outline_line(o, x + w, y + h);
        bat_outline_line(o, x, y + h);
    } else {
        bat_outline_move(o, x + rx, y);
        if (w > 2 * rx) bat_outline_line(o, x + w - rx, y);
        bat_outline_arc(o, rx, ry, 0, false, true, x + w, y + ry);
        if (h > 2 * ry) bat_outline_line(o, x + w, y + h - ry);
        bat_outline_arc(o, rx, ry, 0, false, true, x + w - rx, y + h);
        if (w > 2 * rx) bat_outline_line(o, x + rx, y + h);
        bat_outline_arc(o, rx, ry, 0, false, true, x, y + h - ry);
        if (h > 2 * ry) bat_outline_line(o, x, y + ry);
        bat_outline_arc(o, rx, ry, 0, false, true, x + rx, y);
    }
    bat_outline_close(o);
    return good;
}

static void quarters(bat_outline *o, double cx, double cy, double rx, double ry) {
    bat_outline_move(o, cx + rx, cy);
    bat_outline_arc(o, rx, ry, 0, false, true, cx, cy + ry);
    bat_outline_arc(o, rx, ry, 0, false, true, cx - rx, cy);
    bat_outline_arc(o, rx, ry, 0, false, true, cx, cy - ry);
    bat_outline_arc(o, rx, ry, 0, false, true, cx + rx, cy);
    bat_outline_close(o);
}

/* 0: it says no radii. */
static bool ellipse_numbers(const bat_svg_shape *s, bool circle, double middle[2], double radii[2]) {
    bool good = true;
    middle[0] = length(s, "cx", s->width, 0, &good), middle[1] = length(s, "cy", s->height, 0, &good);
    if (circle) {
        radii[0] = length(s, "r", sqrt((s->width * s->width + s->height * s->height) / 2), 0, &good);
        radii[1] = radii[0];
        return good;
    }
    radii[0] = radius(s, "rx", s->width, &good), radii[1] = radius(s, "ry", s->height, &good);
    if (radii[0] < 0) radii[0] = radii[1];
    if (radii[1] < 0) radii[1] = radii[0];
    if (radii[0] < 0) radii[0] = radii[1] = 0; /* it says none */
    return good;
}

static bool ellipse(const bat_svg_shape *s, bool circle, bat_outline *o) {
    double middle[2], radii[2];
    const bool good = ellipse_numbers(s, circle, middle, radii);
    if (radii[0] < 0 || radii[1] < 0) return false;
    if (radii[0] > 0 && radii[1] > 0) quarters(o, middle[0], middle[1], radii[0], radii[1]);
    return good;
}

static bool line(const bat_svg_shape *s, bat_outline *o) {
    bool good = true;
    double x1 = length(s, "x1", s->width, 0, &good), y1 = length(s, "y1", s->height, 0, &good);
    double x2 = length(s, "x2", s->width, 0, &good), y2 = length(s, "y2", s->height, 0, &good);
    bat_outline_move(o, x1, y1);
    bat_outline_line(o, x2, y2);
    return good;
}

/* Reads points up to the first error; an odd number of coordinates is one. */
static bool polyline(const bat_svg_shape *s, bool closed, bat_outline *o) {
    const char *at = s->attribute(s->element, "points");
    if (!at) return true;
    const char *end = at + strlen(at);
    double p[2];
    bool first = true, good = true;
    while (at < end && strchr(" \t\r\n\f", *at)) at++;
    while (at < end && good) {
        for (int i = 0; i < 2 && good; i++) {
            const char *stop = bat_number_scan(at, end, &p[i]);
            good = stop && fabs(p[i]) <= 1e75;
            if (good) {
                at = stop;
                bat_svg_skip(&at, end);
            }
        }
        if (!good) break;
        if (first)
            bat_outline_move(o, p[0], p[1]);
        else
            bat_outline_line(o, p[0], p[1]);
        first = false;
    }
    if (closed) bat_outline_close(o);
    return good;
}

bool bat_svg_shape_outline(const bat_svg_shape *shape, const char *name, bat_outline *outline) {
    if (strcmp(name, "path") == 0) {
        const char *data = shape->attribute(shape->element, "d");
        return !data || strcmp(data, "none") == 0 || bat_svg_path(data, strlen(data), outline);
    }
    if (strcmp(name, "rect") == 0) return rect(shape, outline);
    if (strcmp(name, "circle") == 0 || strcmp(name, "ellipse") == 0)
        return ellipse(shape, name[0] == 'c', outline);
    if (strcmp(name, "line") == 0) return line(shape, outline);
    return polyline(shape, strcmp(name, "polygon") == 0, outline);
}

bool bat_svg_shape_primitive(const bat_svg_shape *shape, const char *name, bat_primitive *out) {
    double box[4], radii[2];
    bat_primitive p;
    if (strcmp(name, "rect") == 0) {
        (void)rect_numbers(shape, box, radii);
        p = (bat_primitive){.kind = BAT_RECTANGLE,
                            .place = {box[2], 0, 0, box[3], box[0], box[1]},
                            .radii = {radii[0], radii[1]}};
        if (!(radii[0] > 0 && radii[1] > 0)) p.radii[0] = p.radii[1] = 0;
    } else if (strcmp(name, "circle") == 0 || strcmp(name, "ellipse") == 0) {
        (void)ellipse_numbers(shape, name[0] == 'c', box, radii);
        p = (bat_primitive){
            .kind = BAT_ELLIPSE, .place = {radii[0], 0, 0, radii[1], box[0], box[1]}, .sweep = 360};
    } else
        return false;
    if (bat_primitive_check(&p) != BAT_OK) return false;
    *out = p;
    return true;
}
