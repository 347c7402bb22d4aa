/* How a shape is painted: colours, and what replaces a gradient or a pattern. */
#include "format/svg/walk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* For shapes without a known colour, so that the outline is visible and can be edited. */
#define GREY 0x808080ffu

/* Adds a gradient's stops, weighted by their opacity; sum: red, green, blue, opacity, count. */
static void add_stops(bat_svg_walk *w, uint32_t gradient, double sum[5]) {
    bat_svg_scope s = {.width = 100, .height = 100};
    bat_svg_cascade_in_place(w, gradient, &s);
    for (uint32_t at = w->tree->elements[gradient].first; at; at = w->tree->elements[at].next) {
        if (w->tree->elements[at].kind != BAT_SVG_STOP) continue;
        if (++w->drawn > BAT_SVG_DRAWN_MAX) {
            w->status = BAT_COUNT;
            return;
        }
        bat_svg_style style;
        bat_svg_cascade(w, at, &s, &style);
        uint32_t c = style.stop.kind == BAT_PAINT_CURRENT ? style.colour : style.stop.colour;
        double share = (c & 0xff) * style.stop_opacity;
        for (int k = 0; k < 3; k++) sum[k] += share * (c >> (24 - 8 * k) & 0xff);
        sum[3] += share;
        sum[4]++;
    }
}

/* The mean of a gradient's stops, which it may take from another gradient; *colour is unchanged when there are
 * none. */
static void find_mean(bat_svg_walk *w, uint32_t gradient, uint32_t *colour) {
    enum { HOPS_MAX = 32 };
    double sum[5] = {0};
    for (int hops = 0; hops < HOPS_MAX && sum[4] == 0; hops++) {
        add_stops(w, gradient, sum);
        const char *href = bat_svg_find_href(w, gradient);
        gradient = href ? bat_svg_tree_refer(w->tree, href) : 0;
        if (!gradient || w->tree->elements[gradient].kind != BAT_SVG_GRADIENT) break;
    }
    if (sum[4] == 0) return;
    uint32_t mean = 0;
    for (int k = 0; k < 3; k++) mean = mean << 8 | (uint32_t)floor(sum[3] > 0 ? sum[k] / sum[3] + 0.5 : 0);
    *colour = mean << 8 | (uint32_t)floor(sum[3] / sum[4] + 0.5);
}

/* The colour that replaces a gradient, pattern or similar. *colour: its fallback, unchanged when no mean is
 * known. Returns whether there is one. */
static bool resolve_server(bat_svg_walk *w, uint32_t element, const char *text, uint32_t *colour) {
    uint32_t server = bat_svg_tree_refer(w->tree, text);
    bool gradient = server && w->tree->elements[server].kind == BAT_SVG_GRADIENT;
    bat_svg_note(&w->notes, element,
                 gradient ? BAT_LOSS_GRADIENT
                 : server ? BAT_LOSS_PATTERN
                          : BAT_LOSS_BROKEN);
    if (!gradient) return false;
    if (!w->means && !(w->means = calloc(w->tree->count, sizeof *w->means))) {
        w->status = BAT_MEMORY;
        return false;
    }
    uint32_t mean = GREY;
    if (!w->means[server]) {
        find_mean(w, server, &mean);
        w->means[server] = mean ^ 1;
    }
    *colour = w->means[server] ^ 1;
    return true;
}

/* Returns false when nothing is painted. */
static bool resolve_paint(bat_svg_walk *w, uint32_t element, const bat_svg_paint *paint,
                          const bat_svg_style *style, double share, uint32_t *colour) {
    uint32_t c = paint->bare ? GREY : paint->kind == BAT_PAINT_CURRENT ? style->colour : paint->colour;
    bool painted = paint->kind != BAT_PAINT_NONE || paint->bare;
    if (paint->server && resolve_server(w, element, paint->server, &c)) painted = true;
    if (!painted) return false;
    *colour = (c & 0xffffff00) | (uint32_t)floor((double)(c & 0xff) * share + 0.5);
    return true;
}

bat_style bat_svg_resolve_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    const bat_svg_style *from = &s->style;
    const double *m = s->matrix;
    bat_style style = {.even_odd = from->even_odd,
                       .width = from->width,
                       .opacity = s->opacity,
                       .cap = from->cap,
                       .join = from->join,
                       .miter_limit = from->miter_limit};
    style.filled = resolve_paint(w, element, &from->fill, from, from->fill_opacity, &style.fill);
    style.stroked = resolve_paint(w, element, &from->stroke, from, from->stroke_opacity, &style.stroke);
    if (!(from->odd & BAT_SVG_BIT(BAT_SVG_EFFECT))) style.width *= sqrt(fabs(m[0] * m[3] - m[1] * m[2]));
    return style;
}
