#include "editor/scene/paint.h"

#include "document/paint.h"
#include "editor/scene/path.h"

#include <math.h>
#include <stdlib.h>

double bat_paint_reach(const bat_paint *paint) {
    double square = 0;
    for (int k = 0; k < 4; k++) square += paint->pen[k] * paint->pen[k];
    double widest = 1;
    for (size_t i = 0; i < paint->width_count; i++) widest = fmax(widest, paint->widths[i].share);
    return fmax(widest, sqrt(square));
}

static float *put(float *at, double number) {
    *at = bat_path_float(number);
    return at + 1;
}

static float *put_gradient(float *at, const bat_gradient *g, bool stroke, const double origin[2]) {
    if (g->count == 0) return at;
    at = put(put(put(at, stroke), g->radial), g->spread);
    for (int i = 0; i < 3; i++) at = put(at, g->from[i]);
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
