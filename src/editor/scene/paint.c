#include "editor/scene/paint.h"

#include "document/paint.h"
#include "editor/scene/path.h"

#include <math.h>
#include <stdlib.h>

/* How much farther it reaches than with a round pen. */
static double widening(const bat_paint *paint) {
    double square = 0;
    for (int k = 0; k < 4; k++) square += paint->pen[k] * paint->pen[k];
    double widest = 1;
    for (size_t i = 0; i < paint->width_count; i++) widest = fmax(widest, paint->widths[i].share);
    return fmax(widest, sqrt(square));
}

double bat_paint_reach(const bat_style *style, const bat_paint *paint) {
    if (!style->stroked) return 0;
    double factor = style->cap == BAT_CAP_SQUARE ? 1.5 : 1;
    if (style->join == BAT_JOIN_MITER) factor = fmax(factor, style->miter_limit);
    return style->width / 2 * factor * (paint ? widening(paint) : 1);
}

void bat_paint_style(const bat_style *style, bat_item *item) {
    item->stroke = style->stroke;
    item->fill = style->fill;
    item->width = bat_path_float(style->width);
    item->opacity = (float)style->opacity;
    item->cap = (uint32_t)style->cap;
    item->join = (uint32_t)style->join;
    item->miter_limit = bat_path_float(style->miter_limit);
}

enum { PATTERN = 2 }; /* in the place of `radial` */

static float *put(float *at, double number) {
    *at = bat_path_float(number);
    return at + 1;
}

static float *put_gradient(float *at, const bat_gradient *g, bool stroke, const double origin[2]) {
    if (g->count == 0) return at;
    const uint64_t picture = g->tile ? bat_picture_digest(g->tile) : 0;
    const double from[3] = {(double)(picture >> 16 & 0xffff), (double)(picture & 0xffff), 0};
    at = put(put(put(at, stroke), g->tile ? PATTERN : g->radial), g->spread);
    for (int i = 0; i < 3; i++) at = put(at, g->tile ? from[i] : g->from[i]);
    for (int i = 0; i < 3; i++) at = put(at, g->to[i]);
    for (int i = 0; i < 6; i++) at = put(at, g->matrix[i] - (i > 3 ? origin[i - 4] : 0));
    at = put(at, (double)g->count);
    for (size_t i = 0; i < g->count; i++)
        at = put(put(put(at, g->stops[i].at), g->stops[i].colour >> 8), g->stops[i].colour & 0xff);
    return at;
}

float *bat_paint_floats(const bat_paint *paint, const double origin[2], uint32_t *count) {
    const size_t room = 6 + paint->dash_count + 2 * 16 + 3 * (paint->fill.count + paint->stroke.count);
    float *made = malloc(room * sizeof *made), *at = made;
    double pen[4];
    if (!made) return NULL;
    bat_paint_pen(paint, pen);
    for (int i = 0; i < 4; i++) at = put(at, pen[i]);
    at = put(put(at, paint->dash_offset), (double)paint->dash_count);
    for (size_t i = 0; i < paint->dash_count; i++) at = put(at, paint->dashes[i]);
    at = put_gradient(at, &paint->fill, false, origin);
    at = put_gradient(at, &paint->stroke, true, origin);
    *count = (uint32_t)(at - made);
    return made;
}
