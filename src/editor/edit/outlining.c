#include "editor/edit/outlining.h"

#include "document/object.h"

#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/paint.h>
#include <batten/refine.h>
#include <batten/region.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DASHES = 2000 };

static const double CORNER = 0.02;           /* radians */
static const double TOLERANCE_SHARE = 2e-5;  /* of the object with what lies around it */
static const double UNITE_SHARE = 0.1;       /* of the tolerance */
static const double DOT = 1e-3;              /* of the width: the length of a dash without one */
static const double LENGTH_PRECISION = 1e-6; /* of lengths along a curve */

/* Curves that are collected; all are owned. */
typedef struct list {
    size_t count, room;
    bat_curve **curves;
} list;

static bat_status add(list *l, bat_curve *curve) {
    if (l->count == l->room) {
        const size_t room = 2 * l->room + 8;
        bat_curve **more = realloc(l->curves, room * sizeof(bat_curve *));
        if (!more) {
            bat_curve_free(curve);
            return BAT_MEMORY;
        }
        l->curves = more, l->room = room;
    }
    l->curves[l->count++] = curve;
    return BAT_OK;
}

/* Takes over the array and what is in it. */
static bat_status add_all(list *l, size_t count, bat_curve **curves) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        status = add(l, curves[i]);
        curves[i] = NULL;
    }
    bat_curves_free(count, curves);
    return status;
}

bool bat_outlining_is_flat(const bat_object *object) {
    const int count = bat_object_curve_count(object);
    if (!bat_object_is_made_of_curves(object) || count == 0) return false;
    for (int i = 0; i < count; i++)
        if (bat_curve_dimension(bat_object_curve(object, i)) != 2) return false;
    return true;
}

static double tolerance_of(const bat_object *object, double around) {
    double box[4];
    bat_object_bounds(object, box);
    return TOLERANCE_SHARE * fmax(fmax(box[2] - box[0], box[3] - box[1]), 0) + TOLERANCE_SHARE * around;
}

/* The object as a path of these curves, which become its own; NULL: there are none. */
static bat_status path_of(const bat_object *object, list *l, bat_object **out) {
    *out = NULL;
    if (l->count == 0) return BAT_OK;
    if (l->count > BAT_POINTS_MAX) return BAT_COUNT;
    const bat_status status = bat_object_with_curves(object, (int)l->count, l->curves, out);
    l->count = 0; /* they are the object's, or gone */
    return status;
}

/* ---- offsets ---- */

/* Whether dashes or widths follow its strokes from where they begin. */
static bool goes_along(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    return paint && (paint->dash_count > 0 || paint->width_count > 0);
}

/* Where on the curve the start of the nearest of those comes to lie; *ahead: they run there in the same direction. */
static bat_status start_on(const bat_curve *made, size_t count, const bat_curve *const *from, double *u,
                           bool *ahead) {
    double least = INFINITY, here[4], there[4];
    bat_status status = BAT_OK;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double domain[2];
        bat_near near;
        bat_curve_domain(from[i], domain);
        bat_curve_eval(from[i], domain[0], 1, here);
        status = bat_curve_nearest(made, here, &near);
        if (status != BAT_OK || near.distance >= least) continue;
        bat_curve_eval(made, near.u, 1, there);
        least = near.distance, *u = near.u;
        *ahead = here[2] * there[2] + here[3] * there[3] >= 0;
    }
    return status;
}

static void replace(bat_curve **place, bat_curve *by) {
    bat_curve_free(*place);
    *place = by;
}

/* Curves begin where those do that they were made from, and run as they do, all or none turned round (holes stay holes). */
static bat_status begin_alike(size_t count, bat_curve **made, size_t from_count,
                              const bat_curve *const *from) {
    bat_status status = BAT_OK;
    bat_curve *next = NULL;
    size_t back = 0;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double u = 0;
        bool ahead = true;
        status = start_on(made[i], from_count, from, &u, &ahead);
        if (status == BAT_OK) status = bat_curve_move_seam(made[i], u, &next);
        if (status == BAT_OK) replace(made + i, next);
        back += !ahead;
    }
    for (size_t i = 0; i < count && 2 * back > count && status == BAT_OK; i++) {
        status = bat_curve_reverse(made[i], &next);
        if (status == BAT_OK) replace(made + i, next);
    }
    return status;
}

static bat_status offset_closed(const bat_object *object, double distance, double tolerance, list *l) {
    const int n = bat_object_curve_count(object);
    const bat_style *style = bat_object_style(object);
    const bat_curve **closed = malloc((size_t)n * sizeof *closed);
    if (!closed) return BAT_MEMORY;
    size_t count = 0, made = 0;
    bat_curve **all = NULL;
    for (int i = 0; i < n; i++)
        if (bat_curve_is_closed(bat_object_curve(object, i))) closed[count++] = bat_object_curve(object, i);
    bat_status status = BAT_OK;
    if (count)
        status = bat_region_offset(&(bat_region){count, closed, style->even_odd}, distance, style->join,
                                   fmax(style->miter_limit, 1), tolerance, CORNER, &made, &all);
    if (status == BAT_OK && goes_along(object)) {
        status = begin_alike(made, all, count, closed);
        if (status != BAT_OK) bat_curves_free(made, all);
    }
    free(closed);
    return status == BAT_OK ? add_all(l, made, all) : status;
}

static bat_status offset_open(const bat_object *object, double distance, double tolerance, list *l) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        size_t made = 0;
        bat_curve **all = NULL;
        if (bat_curve_is_closed(curve)) continue;
        /* y points down on the page: its left is the right of the plane */
        status = bat_curve_offset(curve, -distance, tolerance, CORNER, &made, &all, NULL);
        if (status == BAT_OK) status = add_all(l, made, all);
    }
    return status;
}

bat_status bat_outlining_offset(const bat_object *object, double distance, bat_offset_side side,
                                bat_object **out) {
    const double tolerance = fmin(tolerance_of(object, distance), distance / 16);
    list l = {0};
    bat_status status = BAT_OK;
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        const double signed_distance = k ? -distance : distance;
        if (side == (k ? BAT_OFFSET_OUTSIDE : BAT_OFFSET_INSIDE)) continue;
        status = offset_closed(object, signed_distance, tolerance, &l);
        if (status == BAT_OK) status = offset_open(object, signed_distance, tolerance, &l);
    }
    if (status == BAT_OK) status = path_of(object, &l, out);
    bat_curves_free(l.count, l.curves);
    return status;
}

/* ---- strokes ---- */

/* The stretches of a curve that dashes leave, as open curves. */
static bat_status dash(const bat_curve *curve, const bat_paint *paint, double width, list *l) {
    double domain[2], whole = 0;
    bat_curve_domain(curve, domain);
    for (size_t i = 0; i < paint->dash_count; i++) whole += paint->dashes[i];
    const size_t n = paint->dash_count % 2 ? 2 * paint->dash_count : paint->dash_count; /* as SVG does */
    if (n != paint->dash_count) whole *= 2;
    const double length = bat_curve_length(curve, domain[0], domain[1], LENGTH_PRECISION);
    if (!(whole > 0) || !(length / whole * (double)n <= DASHES)) return BAT_COUNT;
    double at = -fmod(paint->dash_offset, whole);
    if (at > 0) at -= whole;
    bat_status status = BAT_OK;
    for (size_t i = 0; at < length && status == BAT_OK; i = (i + 1) % n) {
        const double piece = paint->dashes[i % paint->dash_count], from = fmax(at, 0),
                     to = fmin(fmax(at + piece, from + DOT * width), length);
        if (i % 2 == 0 && at + piece >= 0 && to > from) {
            bat_curve *one;
            const double u = bat_curve_at_length(curve, domain[0], from, LENGTH_PRECISION),
                         v = to >= length ? domain[1]
                                          : bat_curve_at_length(curve, domain[0], to, LENGTH_PRECISION);
            if (u < v) status = bat_curve_piece(curve, u, v, &one);
            if (u < v && status == BAT_OK) status = add(l, one);
        }
        at += piece;
    }
    return status;
}

/* Maps a curve by the pen, or back. */
static bat_status map(const bat_curve *curve, const double pen[4], bool back, bat_curve **out) {
    const double d = pen[0] * pen[3] - pen[1] * pen[2];
    double matrix[6] = {pen[0], pen[2], 0, pen[1], pen[3], 0}; /* rows */
    if (back) {
        const double inverse[6] = {pen[3] / d, -pen[2] / d, 0, -pen[1] / d, pen[0] / d, 0};
        memcpy(matrix, inverse, sizeof matrix);
    }
    return bat_curve_transform(curve, matrix, out);
}

static bool has_pen(const bat_paint *paint) {
    return paint && paint->pen[0] * paint->pen[3] - paint->pen[1] * paint->pen[2] != 0;
}

/* The outline of one stretch, as the pen draws it. */
static bat_status outline(const bat_curve *curve, const bat_nib *nib, const bat_paint *paint,
                          const bat_width_profile *widths, double tolerance, list *l) {
    bat_curve *seen = NULL;
    size_t count = 0;
    bat_curve **all = NULL;
    bat_status status = has_pen(paint) ? map(curve, paint->pen, true, &seen) : BAT_OK;
    if (status == BAT_OK)
        status = bat_curve_outline_width(seen && !widths->count ? seen : curve, nib, widths, tolerance,
                                         CORNER, &count, &all, NULL);
    bat_curve_free(seen);
    for (size_t i = 0; i < count && status == BAT_OK && has_pen(paint); i++) {
        bat_curve *mapped = NULL;
        status = map(all[i], paint->pen, false, &mapped);
        if (status == BAT_OK) bat_curve_free(all[i]), all[i] = mapped;
    }
    if (status == BAT_OK) return add_all(l, count, all);
    bat_curves_free(count, all);
    return status;
}

/* What several stretches cover together; ends[i]: where the outline of each ends in the list. */
static bat_status unite(list *l, size_t parts, const size_t *ends, double tolerance) {
    bat_region *regions = calloc(parts, sizeof *regions);
    size_t count = 0, from = 0;
    bat_curve **all = NULL;
    if (!regions) return BAT_MEMORY;
    for (size_t i = 0; i < parts; i++) {
        regions[i] = (bat_region){ends[i] - from, (const bat_curve *const *)l->curves + from, false};
        from = ends[i];
    }
    const bat_status status = bat_regions_combine(BAT_REGION_UNION, parts, regions, UNITE_SHARE * tolerance,
                                                  &count, &all);
    free(regions);
    if (status != BAT_OK) return status;
    bat_curves_free(l->count, l->curves);
    *l = (list){0};
    return add_all(l, count, all);
}

static bat_status stretches(const bat_object *object, const bat_paint *paint, list *l) {
    const double width = bat_object_style(object)->width;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        bat_curve *copy = NULL;
        if (paint && paint->dash_count) {
            status = dash(curve, paint, width, l);
        } else {
            status = bat_curve_copy(curve, &copy);
            if (status == BAT_OK) status = add(l, copy);
        }
        if (l->count > DASHES && paint && paint->dash_count) status = BAT_COUNT;
    }
    return status;
}

bat_status bat_outlining_stroke(const bat_object *object, bat_object **out, bool *first) {
    const bat_style *style = bat_object_style(object);
    const bat_paint *paint = bat_object_paint(object);
    const bat_nib nib = {style->width, style->cap, style->join, fmax(style->miter_limit, 1)};
    const bat_width_profile widths = bat_object_widths(object);
    const double tolerance = fmin(tolerance_of(object, style->width), style->width / 32);
    list lines = {0}, outlines = {0};
    bat_object *path = NULL;
    bat_status status = stretches(object, paint, &lines);
    size_t *ends = status == BAT_OK ? malloc((lines.count + 1) * sizeof *ends) : NULL;
    if (status == BAT_OK && !ends) status = BAT_MEMORY;
    for (size_t i = 0; i < lines.count && status == BAT_OK; i++) {
        status = outline(lines.curves[i], &nib, paint, &widths, tolerance, &outlines);
        ends[i] = outlines.count;
    }
    if (status == BAT_OK && lines.count > 1 && outlines.count > 1)
        status = unite(&outlines, lines.count, ends, tolerance);
    free(ends);
    if (status == BAT_OK) status = path_of(object, &outlines, &path);
    *out = NULL;
    if (status == BAT_OK && path) status = bat_object_filled_as_stroke(path, out);
    bat_object_release(path);
    bat_curves_free(lines.count, lines.curves);
    bat_curves_free(outlines.count, outlines.curves);
    *first = paint && paint->stroke_first;
    return status;
}
