/* Markers: what an element of one says, and what is drawn in it (SVG 2, 13.7). */
#include "base/matrix.h"
#include "document/digest.h"
#include "document/document.h"
#include "format/svg/digest.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"
#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What an element has become, whoever refers to it. */
struct bat_svg_marker {
    bat_marker *marker; /* NULL: it shows nothing */
    uint64_t digest;    /* of what is drawn in it */
    bool whole;         /* all of it is shown */
};

/* ---- what the element says ---- */

/* A reference point: a word, or a length of the view box. */
static double reference(const bat_svg_walk *w, uint32_t element, const char *name, double low, double side) {
    static const char *const words[] = {"left", "top", "center", "right", "bottom"};
    static const double shares[] = {0, 0, 0.5, 1, 1};
    const char *text = bat_svg_attribute_of(w, element, name);
    for (int i = 0; text && i < 5; i++)
        if (strcmp(text, words[i]) == 0) return low + shares[i] * side;
    return bat_svg_length_of(w, element, name, side, 0);
}

/* Degrees; also grad, rad, turn. */
static void read_orient(const char *text, bat_marking *out) {
    static const char *const units[] = {"deg", "grad", "rad", "turn"};
    static const double degrees[] = {1, 0.9, 57.295779513082320877, 360};
    double number;
    if (!text) return;
    while (*text == ' ') text++;
    if (strncmp(text, "auto", 4) == 0) {
        out->turn = strncmp(text + 4, "-start-reverse", 14) == 0 ? BAT_MARKER_REVERSED : BAT_MARKER_AUTO;
        return;
    }
    const char *unit = bat_number_scan(text, text + strlen(text), &number);
    if (!unit) return;
    for (int i = 0; i < 4; i++)
        if (strncmp(unit, units[i], strlen(units[i])) == 0) number *= degrees[i];
    if (fabs(number) <= 1e6) out->angle = number;
}

/* False: it shows nothing. scope: around what is drawn in it. */
static bool read_place(const bat_svg_walk *w, uint32_t element, bat_svg_scope *scope, bat_marking *out) {
    const char *units = bat_svg_attribute_of(w, element, "markerUnits"),
               *view = bat_svg_attribute_of(w, element, "viewBox");
    const double wide = bat_svg_length_of(w, element, "markerWidth", scope->width, 3),
                 high = bat_svg_length_of(w, element, "markerHeight", scope->height, 3);
    double box[4] = {0, 0, wide, high}, m[6] = {1, 0, 0, 1, 0, 0};
    if (!(wide > 0 && high > 0)) return false;
    if (view && bat_svg_view_box(view, box)) {
        if (!(box[2] > 0 && box[3] > 0)) return false;
        bat_svg_fit(box, 0, 0, wide, high, bat_svg_attribute_of(w, element, "preserveAspectRatio"), m);
    }
    const double back[6] = {1,
                            0,
                            0,
                            1,
                            -reference(w, element, "refX", box[0], box[2]),
                            -reference(w, element, "refY", box[1], box[3])};
    m[4] = m[5] = 0; /* the reference point is the vertex, however the box is aligned */
    bat_matrix_compose(m, back, out->matrix);
    out->by_width = !(units && strcmp(units, "userSpaceOnUse") == 0);
    read_orient(bat_svg_attribute_of(w, element, "orient"), out);
    out->clipped = !scope->style.overflows;
    memcpy(out->clip, box, sizeof out->clip);
    scope->width = box[2], scope->height = box[3];
    return true;
}

/* ---- what is drawn in it ---- */

/* The walk as it was; what is drawn in a marker leaves no other trace than the collection. */
static void draw_content(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, bat_svg_collected *to,
                         uint64_t *digest) {
    const uint64_t outer = w->digest;
    const bool copied = w->copied, boxed = w->boxed;
    const int unseen = w->unseen;
    const long put = w->put;
    w->collected = to;
    w->copied = true;
    w->unseen = 0;
    w->digest = bat_digest_begin();
    w->given[w->depth] = 0;
    w->active[w->depth++] = element;
    bat_svg_draw_children(w, element, s);
    w->depth--;
    *digest = w->digest;
    w->digest = outer;
    w->collected = NULL;
    w->copied = copied, w->boxed = boxed, w->unseen = unseen, w->put = put;
}

/* Whether nothing was noted in it that can be seen. */
static bool is_whole(const bat_svg_walk *w, uint32_t element) {
    const bat_svg_tree *tree = w->tree;
    static const bat_loss shown[] = {BAT_LOSS_TEXT, BAT_LOSS_IMAGE, BAT_LOSS_EMBEDDED};
    for (uint32_t i = element; i < tree->count && (i == element || tree->elements[i].parent >= element);
         i++) {
        if (bat_svg_noted(&w->notes, i) & ~(1u << BAT_LOSS_HINT | 1u << BAT_LOSS_ANIMATION)) return false;
        for (int k = 0; k < 3; k++)
            if (w->notes.seen[i] & 1u << shown[k]) return false;
    }
    return true;
}

static void make(bat_svg_walk *w, uint32_t element, struct bat_svg_marker *out) {
    bat_svg_scope s = {.opacity = 1,
                       .width = w->page[2] > 0 ? w->page[2] : 100,
                       .height = w->page[3] > 0 ? w->page[3] : 100};
    bat_svg_collected *to = calloc(1, sizeof *to);
    bat_marking marking = {0};
    *out = (struct bat_svg_marker){.whole = true};
    if (!to) {
        w->status = BAT_MEMORY;
        return;
    }
    bat_matrix_identity(s.matrix);
    bat_svg_cascade_in_place(w, element, &s);
    s.opacity = s.style.opacity;
    if (read_place(w, element, &s, &marking)) {
        to->whole = true;
        draw_content(w, element, &s, to, &out->digest);
        out->digest = bat_svg_digest_marking(out->digest, &marking);
        out->whole = to->whole && is_whole(w, element) && !(s.opacity < 1 && to->count > 1);
        marking.count = to->count, marking.parts = to->list;
        const bat_status status = w->status == BAT_OK ? bat_marker_create(&marking, &out->marker) : w->status;
        if (status == BAT_MEMORY) w->status = status;
        if (status != BAT_OK) out->whole = false;
    }
    for (int i = 0; i < to->count; i++) bat_object_release((bat_object *)to->list[i].object);
    free(to);
}

static const struct bat_svg_marker *marker_of(bat_svg_walk *w, uint32_t element) {
    if (!w->markers && !(w->markers = calloc(w->tree->count, sizeof *w->markers))) w->status = BAT_MEMORY;
    if (!w->markers) return NULL;
    if (!w->markers[element] && w->depth == BAT_SVG_DEPTH) return NULL; /* no room for what is drawn in it */
    if (!w->markers[element]) {
        struct bat_svg_marker *made = malloc(sizeof *made);
        if (!made) {
            w->status = BAT_MEMORY;
            return NULL;
        }
        make(w, element, made);
        w->markers[element] = made;
    }
    return w->markers[element];
}

void bat_svg_markers_free(bat_svg_walk *w) {
    for (uint32_t i = 0; w->markers && i < w->tree->count; i++) {
        if (w->markers[i]) bat_marker_release(w->markers[i]->marker);
        free(w->markers[i]);
    }
    free(w->markers);
}

/* ---- on a shape ---- */

static uint32_t target_of(const bat_svg_walk *w, const char *server) {
    const uint32_t found = server ? bat_svg_tree_refer(w->tree, server) : 0;
    return found && strcmp(bat_svg_tree_name(w->tree, found), "marker") == 0 ? found : 0;
}

bool bat_svg_takes_markers(const bat_svg_walk *w, uint32_t element) {
    const char *name = bat_svg_tree_name(w->tree, element);
    return name[0] == 'p' || strcmp(name, "line") == 0; /* path, polyline, polygon */
}

bat_markers *bat_svg_markers(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, uint64_t *digest) {
    const double *m = s->matrix;
    bat_marked marked = {.order = (bat_marker_order)s->style.marker_order, .frame = {m[0], m[1], m[2], m[3]}};
    bat_markers *made = NULL;
    bool any = false, whole = true;
    *digest = bat_digest_number(bat_digest_begin(), s->style.marker_order);
    if (!bat_svg_takes_markers(w, element)) return NULL;
    for (int k = 0; k < BAT_MARKER_PLACES && w->status == BAT_OK; k++) {
        const uint32_t target = target_of(w, s->style.markers[k]);
        const struct bat_svg_marker *found = target && !w->collected ? marker_of(w, target) : NULL;
        if (target && !(found && found->whole)) whole = false;
        if (found) marked.markers[k] = found->marker;
        any = any || marked.markers[k];
        *digest = bat_digest_number(*digest, found && found->marker ? found->digest : 0);
    }
    const char *data = marked.markers[BAT_MARKER_MID]
                           ? bat_svg_geometry_text(w->tree, element, &s->style, "d")
                           : NULL;
    if (data && strpbrk(data, "Aa")) whole = false; /* within an arc there are knots, too */
    if (!whole) bat_svg_note(&w->notes, element, BAT_LOSS_MARKER);
    if (!any || w->status != BAT_OK) return NULL;
    const bat_status status = bat_markers_create(&marked, &made);
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK) bat_svg_note(&w->notes, element, BAT_LOSS_MARKER);
    return made;
}

/* The diagonal of its box, or twice that of what may lie outside. */
double bat_svg_marker_reach(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    double reach = 0;
    for (int k = 0; k < BAT_MARKER_PLACES && bat_svg_takes_markers(w, element); k++) {
        const uint32_t target = target_of(w, s->style.markers[k]);
        const char *units = target ? bat_svg_attribute_of(w, target, "markerUnits") : NULL;
        if (!target) continue;
        const double wide = bat_svg_length_of(w, target, "markerWidth", s->width, 3),
                     high = bat_svg_length_of(w, target, "markerHeight", s->height, 3),
                     unit = units && strcmp(units, "userSpaceOnUse") == 0 ? 1 : s->style.width;
        reach = fmax(reach, 2 * sqrt(wide * wide + high * high) * unit);
    }
    return reach * sqrt(bat_matrix_area(s->matrix));
}
