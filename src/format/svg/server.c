/* Gradients: what an element of one says, with what it takes from others (SVG 2, 14.2). */
#include "base/matrix.h"
#include "format/svg/chain.h"
#include "format/svg/svg.h"
#include "format/svg/walk.h"
#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- stops ---- */

/* A number, or a percentage, from 0 to 1. */
static double offset_of(const char *text) {
    double number;
    if (!text) return 0;
    while (*text == ' ' || *text == '\t' || *text == '\n' || *text == '\r') text++;
    const char *end = bat_number_scan(text, text + strlen(text), &number);
    if (!end || !isfinite(number)) return 0;
    if (*end == '%') number /= 100;
    return fmin(fmax(number, 0), 1);
}

static uint32_t faded(uint32_t colour, double share) {
    return (colour & 0xffffff00) | (uint32_t)floor((double)(colour & 0xff) * share + 0.5);
}

/* Stops as they are collected; sum: red, green, blue, opacity, of each weighted by its opacity. */
typedef struct collection {
    bat_stop list[BAT_STOPS_MAX];
    int count;
    bool more;
    double sum[4];
} collection;

static void add_stop(collection *all, double at, uint32_t colour, double opacity) {
    const double share = (colour & 0xff) * opacity;
    for (int k = 0; k < 3; k++) all->sum[k] += share * (double)(colour >> (24 - 8 * k) & 0xff);
    all->sum[3] += share;
    all->list[all->count++] = (bat_stop){at, faded(colour, opacity)};
}

static uint32_t mean_of(const collection *all) {
    const double *sum = all->sum;
    uint32_t mean = 0;
    for (int k = 0; k < 3; k++) mean = mean << 8 | (uint32_t)floor(sum[3] > 0 ? sum[k] / sum[3] + 0.5 : 0);
    return all->count ? mean << 8 | (uint32_t)floor(sum[3] / all->count + 0.5) : 0;
}

/* The stops among an element's children. */
static void add_stops(bat_svg_walk *w, uint32_t gradient, collection *all) {
    bat_svg_scope s = {.width = 100, .height = 100};
    double least = 0;
    bat_svg_cascade_in_place(w, gradient, &s);
    for (uint32_t at = w->tree->elements[gradient].first; at; at = w->tree->elements[at].next) {
        if (w->tree->elements[at].kind != BAT_SVG_STOP) continue;
        if (all->count == BAT_STOPS_MAX) {
            all->more = true;
            return;
        }
        bat_svg_style style;
        bat_svg_cascade(w, at, &s, &style);
        least = fmax(least, offset_of(bat_svg_attribute_of(w, at, "offset")));
        add_stop(all, least, style.stop.kind == BAT_PAINT_CURRENT ? style.colour : style.stop.colour,
                 style.stop_opacity);
    }
}

/* Found once for each gradient; NULL: out of memory. */
static const bat_svg_stops *stops_of(bat_svg_walk *w, uint32_t gradient) {
    if (!w->stops && !(w->stops = calloc(w->tree->count, sizeof *w->stops))) return NULL;
    if (w->stops[gradient]) return w->stops[gradient];
    collection all = {.count = 0};
    const bat_svg_chain c = bat_svg_chain_of(w, gradient);
    for (int i = 0; i < c.count && all.count == 0; i++) add_stops(w, c.elements[i], &all);
    bat_svg_stops *made = malloc(sizeof *made + (size_t)all.count * sizeof *made->list);
    if (!made) return NULL;
    *made = (bat_svg_stops){(bat_stop *)(void *)(made + 1), all.count, all.more, mean_of(&all)};
    memcpy(made->list, all.list, (size_t)all.count * sizeof *made->list);
    w->stops[gradient] = made;
    return made;
}

bool bat_svg_mixes_linearly(bat_svg_walk *w, uint32_t gradient) {
    bat_svg_scope s = {.width = 100, .height = 100};
    const bat_svg_stops *stops = stops_of(w, gradient);
    bat_svg_cascade_in_place(w, gradient, &s);
    return stops && stops->count > 1 && s.style.odd & BAT_SVG_BIT(BAT_SVG_INTERPOLATION);
}

void bat_svg_stops_free(bat_svg_walk *w) {
    for (uint32_t i = 0; w->stops && i < w->tree->count; i++) free(w->stops[i]);
    free(w->stops);
}

/* ---- the place ---- */

typedef struct measure {
    bool boxed;
    const bat_svg_scope *scope;
} measure;

/* A coordinate: of the box's share, or in user units. axis: 0 x, 1 y, 2 a radius. */
static double length(const bat_svg_walk *w, const bat_svg_chain *c, const measure *m, const char *name,
                     int axis, double otherwise) {
    const double width = m->scope->width, height = m->scope->height;
    const double whole = m->boxed    ? 1
                         : axis == 0 ? width
                         : axis == 1 ? height
                                     : sqrt((width * width + height * height) / 2);
    const char *text = bat_svg_chain_attribute(w, c, name);
    double value;
    return text && bat_svg_length(text, whole, &value) && fabs(value) <= BAT_COORDINATE_MAX
               ? value
               : otherwise * whole;
}

static void place_circles(const bat_svg_walk *w, const bat_svg_chain *c, const measure *m, bat_gradient *g) {
    static const char *const from[] = {"fx", "fy", "fr"}, *const to[] = {"cx", "cy", "r"};
    for (int k = 0; k < 3; k++) {
        g->to[k] = length(w, c, m, to[k], k, 0.5);
        g->from[k] = length(w, c, m, from[k], k, 0);
        if (k < 2 && !bat_svg_chain_attribute(w, c, from[k])) g->from[k] = g->to[k];
    }
}

static void place_line(const bat_svg_walk *w, const bat_svg_chain *c, const measure *m, bat_gradient *g) {
    static const char *const from[] = {"x1", "y1"}, *const to[] = {"x2", "y2"};
    for (int k = 0; k < 2; k++) {
        g->from[k] = length(w, c, m, from[k], k, 0);
        g->to[k] = length(w, c, m, to[k], k, k == 0);
    }
}

static bat_spread spread_of(const char *word) {
    if (word && strcmp(word, "reflect") == 0) return BAT_SPREAD_REFLECT;
    return word && strcmp(word, "repeat") == 0 ? BAT_SPREAD_REPEAT : BAT_SPREAD_PAD;
}

/* False: it has no place; it then paints nothing. */
static bool place(const bat_svg_walk *w, const bat_svg_chain *c, const bat_svg_scope *s, const double box[4],
                  bat_gradient *g, bool *boxed) {
    const char *units = bat_svg_chain_attribute(w, c, "gradientUnits"),
               *transform = bat_svg_chain_attribute(w, c, "gradientTransform");
    const measure m = {!units || strcmp(units, "userSpaceOnUse") != 0, s};
    double own[6], user[6];
    bat_matrix_identity(own);
    if (transform && !bat_svg_transform(transform, own)) return false;
    memcpy(user, own, sizeof user);
    if (m.boxed) {
        const double frame[6] = {box[2] - box[0], 0, 0, box[3] - box[1], box[0], box[1]};
        if (!(frame[0] > 0 && frame[3] > 0)) return false;
        bat_matrix_compose(frame, own, user);
    }
    bat_matrix_compose(s->matrix, user, g->matrix);
    g->radial = bat_svg_tree_name(w->tree, c->elements[0])[0] == 'r';
    if (g->radial)
        place_circles(w, c, &m, g);
    else
        place_line(w, c, &m, g);
    g->spread = spread_of(bat_svg_chain_attribute(w, c, "spreadMethod"));
    *boxed = m.boxed;
    return true;
}

bat_svg_served bat_svg_gradient(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                                const double box[4], double share, bat_stop *stops, bat_gradient *out,
                                uint32_t *colour) {
    const bat_svg_stops *all = stops_of(w, element);
    bat_gradient g = {.stops = stops};
    bool boxed;
    if (!all) {
        w->status = BAT_MEMORY;
        return BAT_SVG_NOTHING;
    }
    if (all->count == 0) return BAT_SVG_NOTHING;
    const bat_svg_chain c = bat_svg_chain_of(w, element);
    if (!place(w, &c, s, box, &g, &boxed)) return BAT_SVG_NOTHING;
    const bool point = g.radial ? !(g.to[2] > 0) : g.from[0] == g.to[0] && g.from[1] == g.to[1];
    const bool plain = all->count == 1 || point;
    *colour = faded(plain ? all->list[all->count - 1].colour : all->mean, share);
    if (plain) return BAT_SVG_PLAIN;
    if (all->more) return BAT_SVG_MEAN;
    for (int i = 0; i < all->count; i++)
        stops[i] = (bat_stop){all->list[i].at, faded(all->list[i].colour, share)};
    g.count = (size_t)all->count;
    *out = g;
    w->boxed = w->boxed || boxed;
    return BAT_SVG_SERVED;
}
