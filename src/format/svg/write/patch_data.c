/* Path data of an element that was edited: subpaths that nobody has touched keep their text, and so do segments of others. */
#include "document/markers.h"
#include "format/svg/svg.h"
#include "format/svg/write/patch.h"

#include <stdlib.h>
#include <string.h>

/* The path data that an element had, and what its subpaths became. */
typedef struct was {
    const char *data;
    size_t size;
    bat_outline outline; /* in the document's units */
    bat_svg_segments segments;
    double *points;             /* of the outline, in the element's */
    bat_curve **curves;         /* of each subpath, or NULL */
    int *drawn, count;          /* the subpaths that have curves */
    const bat_markers *markers; /* of the object; NULL: none */
} was;

static void forget(was *w) {
    for (int i = 0; w->curves && i < w->outline.subpath_count; i++) bat_curve_free(w->curves[i]);
    free(w->curves);
    free(w->points);
    free(w->segments.list);
    free(w->drawn);
    bat_outline_free(&w->outline);
}

/* dots: what has no length is seen, as a short line. BAT_SYNTAX: there are some. */
static bat_status make_curves(was *w, const double inner[6], bool dots) {
    const bat_svg_options options = bat_svg_merging();
    const int count = w->outline.subpath_count;
    w->points = malloc(2 * w->outline.count * sizeof *w->points);
    w->curves = calloc((size_t)count, sizeof *w->curves);
    w->drawn = malloc((size_t)count * sizeof *w->drawn);
    if (!w->points || !w->curves || !w->drawn) return BAT_MEMORY;
    memcpy(w->points, w->outline.points, 2 * w->outline.count * sizeof *w->points);
    bat_outline_transform(&w->outline, inner);
    for (int i = 0; i < count; i++) {
        const bat_svg_drawn what = bat_svg_subpath_curve(&w->outline, i, &options, w->markers, &w->curves[i]);
        if (what == BAT_SVG_NO_MEMORY) return BAT_MEMORY;
        if (what == BAT_SVG_DOT && dots) return BAT_SYNTAX;
        if (what == BAT_SVG_CURVE) w->drawn[w->count++] = i;
    }
    return BAT_OK;
}

/* Reads the data again. BAT_SYNTAX: there are none that could be kept in part. */
static bat_status recall(was *w, const bat_svg_retag *r, const bat_sourced *entry) {
    bat_svg_piece piece;
    const size_t name = bat_svg_tag_name(r->tag, r->size);
    const bool path = name >= 4 && memcmp(r->tag + 1 + name - 4, "path", 4) == 0 &&
                      (name == 4 || r->tag[name - 4] == ':');
    if (entry->declared & BAT_DECLARED_SHAPE)
        return BAT_SYNTAX;                /* what the attribute says may not be shown */
    if (!entry->shape) return BAT_SYNTAX; /* other data were asked for on reading (keep.c) */
    if (!path || !bat_svg_retag_has(r, "d", &piece)) return BAT_SYNTAX;
    w->data = r->tag + piece.value;
    w->size = piece.end - piece.value;
    const bool good = bat_svg_path_segments(w->data, w->size, &w->outline, &w->segments);
    if (w->outline.failed || w->segments.failed) return BAT_MEMORY;
    if (!good || w->outline.full || w->outline.subpath_count == 0) return BAT_SYNTAX;
    return make_curves(w, entry->inner, entry->style.stroked && entry->style.cap != BAT_CAP_BUTT);
}

/* Whether the curve is what a reader made of the subpath, whatever it merged. */
static bool is_same(const was *w, int subpath, const bat_curve *curve, bat_status *status) {
    const bat_svg_options exact = bat_svg_defaults();
    bat_curve *other = NULL;
    if (bat_curve_is_equal(w->curves[subpath], curve)) return true;
    if (bat_svg_subpath_curve(&w->outline, subpath, &exact, w->markers, &other) == BAT_SVG_NO_MEMORY)
        *status = BAT_MEMORY;
    const bool same = other && bat_curve_is_equal(other, curve);
    bat_curve_free(other);
    return same;
}

static void write_start(const was *w, int subpath, bat_text *out) {
    const bat_subpath *path = &w->outline.subpaths[subpath];
    const char implied[2] = {path->implied, 0};
    bat_text_string(out, "M");
    bat_svg_write_pair(out, w->points + 2 * path->first);
    bat_text_string(out, implied);
}

/* The text of a subpath; intact: so is the text before it. Else it says where it begins, unless it has done so before. */
static void copy(const was *w, int subpath, bool intact, bat_text *out) {
    const bat_subpath *path = &w->outline.subpaths[subpath];
    const bool moves = !intact && w->data[path->from] != 'M';
    const size_t from = moves ? path->drawn : intact && subpath == 0 ? 0 : path->from;
    const size_t to = subpath + 1 < w->outline.subpath_count ? path[1].from : w->size;
    if (moves) write_start(w, subpath, out);
    bat_text_add(out, w->data + from, to - from);
}

typedef struct task {
    const was *w;
    const bat_object *object;
    const double *m;
    double precision;
    bat_text *out;
} task;

static bat_status write_fresh(const task *t, int from, int to) {
    bat_status status = BAT_OK;
    for (int j = from; j < to && status == BAT_OK; j++)
        status = bat_svg_write_curve(t->out, bat_object_curve(t->object, j), t->m, t->precision);
    return status;
}

/* Curve k, which subpath i has become; intact: so is the text before it. The curve that a reader made may have merged nodes or not. */
static bat_status write_touched(const task *t, int i, int k, bool intact) {
    const was *w = t->w;
    const bat_subpath *path = &w->outline.subpaths[i];
    const bool stands = intact || w->data[path->from] == 'M';
    const bat_svg_subtext text = {.data = w->data,
                                  .from = !stands  ? SIZE_MAX
                                          : i == 0 ? 0
                                                   : path->from,
                                  .segments = w->segments.list + (path->first - (size_t)i) / 3,
                                  .points = w->points + 2 * path->first,
                                  .count = path->segments,
                                  .closed = path->closed};
    const bat_svg_options exact = bat_svg_defaults();
    const bat_curve *now = bat_object_curve(t->object, k);
    bat_curve *other = NULL;
    bool done = false;
    bat_status status = bat_svg_patch_segments(t->out, &text, w->curves[i], now, t->m, t->precision, &done);
    if (status == BAT_OK && !done) {
        if (bat_svg_subpath_curve(&w->outline, i, &exact, w->markers, &other) == BAT_SVG_NO_MEMORY)
            status = BAT_MEMORY;
        if (other) status = bat_svg_patch_segments(t->out, &text, other, now, t->m, t->precision, &done);
        bat_curve_free(other);
    }
    return status == BAT_OK && !done ? write_fresh(t, k, k + 1) : status;
}

/* Subpath k of those drawn is curve k where their numbers agree; else only what begins and what ends the path is compared, and
 * the curves between stand for the subpaths between. */
static bat_status merge(const task *t) {
    const was *w = t->w;
    const int curves = bat_object_curve_count(t->object), less = w->count < curves ? w->count : curves;
    bat_status status = BAT_OK;
    int head = 0, tail = 0;
    while (head < less && is_same(w, w->drawn[head], bat_object_curve(t->object, head), &status)) head++;
    while (tail < less - head &&
           is_same(w, w->drawn[w->count - 1 - tail], bat_object_curve(t->object, curves - 1 - tail), &status))
        tail++;
    bool intact = true;
    for (int i = 0, k = 0; i < w->outline.subpath_count && status == BAT_OK; i++) {
        bool keeps = true;
        if (w->curves[i]) {
            if (k == head && curves != w->count) status = write_fresh(t, head, curves - tail);
            keeps = k < head || k >= w->count - tail ||
                    (curves == w->count && is_same(w, i, bat_object_curve(t->object, k), &status));
            if (!keeps && curves == w->count && status == BAT_OK) status = write_touched(t, i, k, intact);
            if (k == head && curves != w->count) intact = false;
            k++;
        }
        if (keeps) copy(w, i, intact, t->out);
        intact = keeps;
    }
    if (head == w->count && curves > w->count && status == BAT_OK) status = write_fresh(t, head, curves);
    return status;
}

bat_status bat_svg_patch_data(bat_text *out, const bat_svg_retag *r, const bat_object *object,
                              const bat_sourced *entry, const double m[6], double precision, bool *raw) {
    was w = {.markers = bat_object_markers(object)};
    const size_t before = out->size;
    bat_status status = recall(&w, r, entry);
    if (status == BAT_OK) {
        *raw = true;
        status = merge(&(task){&w, object, m, precision, out});
    } else if (status == BAT_SYNTAX) {
        out->size = before;
        status = bat_svg_write_curves(out, object, m, precision);
    }
    forget(&w);
    return status;
}
