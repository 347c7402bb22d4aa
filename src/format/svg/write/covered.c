#include "format/svg/write/covered.h"

#include "document/markers.h"
#include "document/object.h"

#include <batten/bezier.h>

#include <stdlib.h>
#include <string.h>

static const double CORNER = 0.02; /* radians */

/* Closed curves that are collected, owned. */
typedef struct chains {
    size_t count, room;
    bat_curve **curves;
} chains;

static bat_status add_chain(chains *c, const double *cubics, size_t count) {
    double *points = malloc((6 * count + 2) * sizeof *points);
    bat_curve **more = c->curves;
    if (c->count == c->room) {
        more = realloc(c->curves, (2 * c->room + 4) * sizeof(bat_curve *));
        if (more) c->curves = more, c->room = 2 * c->room + 4;
    }
    if (!points || !more) {
        free(points);
        return BAT_MEMORY;
    }
    memcpy(points, cubics, 2 * sizeof *points);
    for (size_t i = 0; i < count; i++) memcpy(points + 2 + 6 * i, cubics + 8 * i + 2, 6 * sizeof *points);
    const bat_status status = bat_curve_from_bezier(2, 3, true, (int)count, points, CORNER, 0,
                                                    &c->curves[c->count], NULL);
    free(points);
    if (status == BAT_OK) c->count++;
    return status == BAT_COUNT ? BAT_OK : status; /* a chain of no length */
}

static bat_status add_cover(chains *c, const bat_object *object, int curve) {
    size_t count = 0;
    double *p = NULL;
    bat_status status = bat_object_cover(object, curve, &count, &p);
    for (size_t from = 0, to; from < count && status == BAT_OK; from = to) {
        for (to = from + 1; to < count && !memcmp(p + 8 * to, p + 8 * to - 2, 2 * sizeof *p); to++) {
        }
        status = add_chain(c, p + 8 * from, to - from);
    }
    bat_free(p);
    return status;
}

/* Markers are at the vertices of the curve, not of what covers its stroke. */
static bat_status unmark(bat_object **path) {
    bat_object *made = NULL;
    if (!bat_object_markers(*path)) return BAT_OK;
    const bat_status status = bat_object_with_markers(*path, NULL, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*path);
    *path = made;
    return BAT_OK;
}

static bat_status stroke_of(const bat_object *object, bat_object **out) {
    chains c = {0};
    bat_object *path = NULL;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = add_cover(&c, object, i);
    if (status == BAT_OK) *out = NULL;
    if (status == BAT_OK && c.count) {
        status = bat_object_with_curves(object, (int)c.count, c.curves, &path);
        c.count = 0; /* they are the object's, or gone */
    }
    if (path) status = unmark(&path);
    if (path && status == BAT_OK) status = bat_object_filled_as_stroke(path, out);
    bat_object_release(path);
    for (size_t i = 0; i < c.count; i++) bat_curve_free(c.curves[i]);
    free(c.curves);
    return status;
}

static bat_status fill_of(const bat_object *object, bat_object **out) {
    bat_style style = *bat_object_style(object);
    style.stroked = false;
    return bat_object_with_style(object, &style, out);
}

static bat_status make_opaque(bat_object **object) {
    bat_object *made = NULL;
    bat_style style = *bat_object_style(*object);
    style.opacity = 1;
    const bat_status status = bat_object_with_style(*object, &style, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

bat_status bat_object_parts(const bat_object *object, bat_object *parts[2], bool *group) {
    parts[0] = parts[1] = NULL;
    if (!bat_object_widths(object).count) return BAT_ARGUMENT;
    const bool both = bat_object_style(object)->filled;
    const int stroke = bat_object_paint(object)->stroke_first ? 0 : 1;
    *group = both && bat_object_style(object)->opacity != 1;
    bat_status status = stroke_of(object, &parts[stroke]);
    if (status == BAT_OK && both) status = fill_of(object, &parts[1 - stroke]);
    for (int k = 0; k < 2 && *group; k++)
        if (status == BAT_OK && parts[k]) status = make_opaque(&parts[k]);
    for (int k = 0; k < 2 && status != BAT_OK; k++) {
        bat_object_release(parts[k]);
        parts[k] = NULL;
    }
    return status;
}
