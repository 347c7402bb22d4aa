/* How a shape is painted: colours, gradients, patterns and dashes. */
#include "format/svg/svg.h"
#include "format/svg/walk.h"

#include <math.h>
#include <string.h>

/* For shapes without a known colour, so that the outline is visible and can be edited. */
#define GREY 0x808080ffu

typedef struct painting {
    const bat_svg_scope *scope;
    const double *box;
    bat_stop *stops;
    bat_gradient *gradient;
} painting;

static bat_svg_served serve(bat_svg_walk *w, uint32_t server, double share, const painting *to,
                            uint32_t *colour) {
    if (!bat_svg_is_pattern(w, server))
        return bat_svg_gradient(w, server, to->scope, to->box, share, to->stops, to->gradient, colour);
    return bat_svg_pattern(w, server, to->scope, to->box, share, to->stops, to->gradient);
}

/* What a gradient, pattern or similar paints. *painted, *colour: of its fallback. */
static void resolve_server(bat_svg_walk *w, uint32_t element, const bat_svg_paint *paint, double share,
                           const painting *to, bool *painted, uint32_t *colour) {
    const uint32_t server = bat_svg_tree_refer(w->tree, paint->server);
    const bool pattern = server && bat_svg_is_pattern(w, server);
    if (!server || (w->tree->elements[server].kind != BAT_SVG_GRADIENT && !pattern)) {
        bat_svg_note(&w->notes, element, server ? BAT_LOSS_PATTERN : BAT_LOSS_UNKNOWN);
        if (!server && paint->bare) *painted = false; /* it is as if it said none (SVG 2, 13.2) */
        return;
    }
    const bat_svg_served served = serve(w, server, share, to, colour);
    if (served == BAT_SVG_MEAN)
        bat_svg_note(&w->notes, element, pattern ? BAT_LOSS_PATTERN : BAT_LOSS_GRADIENT);
    if (!pattern && bat_svg_mixes_linearly(w, server)) bat_svg_note(&w->notes, element, BAT_LOSS_HINT);
    if (served == BAT_SVG_MEAN && pattern) return;
    if (served != BAT_SVG_NOTHING)
        *painted = true;
    else if (paint->bare)
        *painted = false;
}

/* Returns false when nothing is painted. */
static bool resolve_paint(bat_svg_walk *w, uint32_t element, const bat_svg_paint *paint, double share,
                          const painting *to, uint32_t *colour) {
    const bat_svg_style *style = &to->scope->style;
    uint32_t c = paint->bare ? GREY : paint->kind == BAT_PAINT_CURRENT ? style->colour : paint->colour;
    const bool context = paint->kind == BAT_PAINT_CONTEXT_FILL || paint->kind == BAT_PAINT_CONTEXT_STROKE;
    bool painted = context ? w->collected != NULL : paint->kind != BAT_PAINT_NONE || paint->bare;
    if (context) c = 0xff; /* whose opacity counts */
    c = (c & 0xffffff00) | (uint32_t)floor((double)(c & 0xff) * share + 0.5);
    if (paint->server) resolve_server(w, element, paint, share, to, &painted, &c);
    if (painted) *colour = c;
    return painted;
}

static bool ends_dashes(char c) { return c == '\0' || c == ';' || c == '!' || c == '}' || c == ')'; }

/* The dashes in user units, and how many; -1: they are not understood. */
static int read_dashes(const char *at, double whole, double *dashes) {
    int count = 0;
    for (;;) {
        char word[32];
        size_t size = 0;
        while (*at == ' ' || *at == ',' || *at == '\t' || *at == '\n' || *at == '\r') at++;
        if (ends_dashes(*at)) return count;
        while (!ends_dashes(*at) && !strchr(" ,\t\n\r", *at) && size + 1 < sizeof word) word[size++] = *at++;
        word[size] = '\0';
        if (count == BAT_DASHES_MAX || !bat_svg_length(word, whole, &dashes[count]) || !(dashes[count] >= 0))
            return -1;
        count++;
    }
}

/* scale: from user units to the document's. */
static void resolve_dashes(const bat_svg_scope *s, double scale, bat_svg_painted *out) {
    const double whole = sqrt((s->width * s->width + s->height * s->height) / 2);
    const int count = s->style.dashes ? read_dashes(s->style.dashes, whole, out->dashes) : 0;
    double sum = 0;
    for (int i = 0; i < count; i++) sum += out->dashes[i] *= scale;
    out->solid = count > 0 && sum == 0;
    if (!(sum > 0)) return;
    out->paint.dashes = out->dashes;
    out->paint.dash_count = (size_t)count;
    out->paint.dash_offset = s->style.dash_offset * scale;
}

/* The width is the mean one; where the matrix makes strokes uneven, the pen says so. One that does not scale is what it is at
 * the size of the file. */
static void resolve_line(const bat_svg_walk *w, const bat_svg_scope *s, bat_svg_painted *out) {
    const double *m = s->matrix, scale = sqrt(fabs(m[0] * m[3] - m[1] * m[2]));
    const bool fixed = s->style.odd & BAT_SVG_BIT(BAT_SVG_EFFECT);
    out->style.width *= fixed ? w->pixel : scale;
    if (!out->style.stroked || !(scale > 0)) return;
    resolve_dashes(s, fixed ? w->pixel : scale, out);
    for (int k = 0; k < 4 && !fixed; k++) out->paint.pen[k] = m[k] / scale;
}

void bat_svg_resolve_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double box[4],
                           bat_svg_painted *out) {
    const bat_svg_style *from = &s->style;
    const painting fill = {s, box, out->stops[0], &out->paint.fill};
    const painting stroke = {s, box, out->stops[1], &out->paint.stroke};
    bat_style *style = &out->style;
    *style = (bat_style){.even_odd = from->even_odd,
                         .width = from->width,
                         .opacity = s->opacity,
                         .cap = from->cap,
                         .join = from->join,
                         .miter_limit = from->miter_limit};
    out->paint = (bat_paint){0};
    out->solid = false;
    w->boxed = false;
    style->filled = resolve_paint(w, element, &from->fill, from->fill_opacity, &fill, &style->fill);
    style->stroked = resolve_paint(w, element, &from->stroke, from->stroke_opacity, &stroke, &style->stroke);
    resolve_line(w, s, out);
    const bool marked = from->markers[0] || from->markers[1] || from->markers[2];
    const bool ordered = (style->filled && style->stroked) ||
                         (marked && from->marker_order == BAT_MARKERS_BETWEEN);
    out->paint.stroke_first = ordered && from->stroke_first;
}
