/* Where the markers of an object are, and what is painted there. */
#include "base/matrix.h"
#include "base/real.h"
#include "document/clip.h"
#include "document/kind.h"
#include "document/markers.h"
#include "document/paint.h"

#include <batten/bezier.h>
#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double FINE =
    1e-7; /* of a curve's size: cubics in place of curves of higher degrees, as files have them */
static const double SHORT = 1e-7; /* of a cubic's size: handles that say no direction */

/* What is made of an object, as far as it has been. */
typedef struct marks {
    const bat_object *host;
    const bat_marked *marked;
    double back[4]; /* the inverse of the frame */
    bat_object **list;
    int count, room;
} marks;

/* One curve as cubics. */
typedef struct chain {
    double *points; /* four a cubic, `size` numbers each */
    int count, size;
    bool closed;
} chain;

static const double *point(const chain *c, int cubic, int k) {
    return c->points + ((size_t)cubic * 4 + (size_t)k) * (size_t)c->size;
}

/* ---- directions, as they are in the units of the frame ---- */

/* Between two points of a cubic. */
static bool direction(const marks *m, const chain *c, int cubic, int from, int to, double *angle) {
    const double *a = point(c, cubic, from), *b = point(c, cubic, to), *p = point(c, cubic, 0);
    double size = 0;
    for (int k = 1; k < 4; k++)
        size = fmax(size, fmax(fabs(point(c, cubic, k)[0] - p[0]), fabs(point(c, cubic, k)[1] - p[1])));
    const double x = b[0] - a[0], y = b[1] - a[1];
    if (!(fmax(fabs(x), fabs(y)) > SHORT * size)) return false;
    *angle = bat_atan2(m->back[1] * x + m->back[3] * y, m->back[0] * x + m->back[2] * y);
    return true;
}

/* How the curve leaves the beginning of a cubic. */
static bool outgoing(const marks *m, const chain *c, int cubic, double *angle) {
    for (; cubic < c->count; cubic++)
        for (int k = 1; k < 4; k++)
            if (direction(m, c, cubic, 0, k, angle)) return true;
    return false;
}

/* How it arrives at the end of one. */
static bool incoming(const marks *m, const chain *c, int cubic, double *angle) {
    for (; cubic >= 0; cubic--)
        for (int k = 2; k >= 0; k--)
            if (direction(m, c, cubic, k, 3, angle)) return true;
    return false;
}

/* At vertex i of 0..count. Where a closed curve begins its first marker looks forwards; so librsvg does it. */
static double turn_at(const marks *m, const chain *c, int i, bat_marker_place place) {
    const int before = i > 0 ? i - 1 : c->closed && place != BAT_MARKER_START ? c->count - 1 : -1;
    const int behind = i < c->count ? i : c->closed ? 0 : c->count;
    double in = 0, out = 0;
    const bool arrives = incoming(m, c, before, &in), leaves = outgoing(m, c, behind, &out);
    if (!arrives || !leaves) return arrives ? in : leaves ? out : 0;
    const double half = (out - in) / 2;
    return fabs(half) > BAT_PI / 2 ? in + half - BAT_PI : in + half;
}

/* ---- one of them ---- */

/* From the marker's units to the document's. */
static void place_at(const marks *m, const bat_marking *marking, bat_marker_place place, const double at[2],
                     double turn, double out[6]) {
    const double *f = m->marked->frame;
    double angle = marking->angle * (BAT_PI / 180), size = 1, linear[6], turned[6];
    if (marking->turn != BAT_MARKER_FIXED) angle += turn;
    if (marking->turn == BAT_MARKER_REVERSED && place == BAT_MARKER_START) angle += BAT_PI;
    if (marking->by_width) size = bat_object_style(m->host)->width / sqrt(fabs(f[0] * f[3] - f[1] * f[2]));
    const double frame[6] = {f[0] * size, f[1] * size, f[2] * size, f[3] * size, at[0], at[1]};
    const double c = bat_cos(angle), s = bat_sin(angle), rotation[6] = {c, s, -s, c, 0, 0};
    bat_matrix_compose(frame, rotation, linear);
    bat_matrix_compose(linear, marking->matrix, turned);
    memcpy(out, turned, sizeof turned);
}

static void take_ink(bat_marker_ink ink, const bat_object *host, bool *painted, uint32_t *colour,
                     bat_gradient *gradient) {
    const bool fill = ink == BAT_INK_FILL;
    if (ink == BAT_INK_OWN || !*painted) return;
    const bat_style *style = bat_object_style(host);
    const bat_paint *paint = bat_object_paint(host);
    const uint32_t from = fill ? style->fill : style->stroke;
    *painted = fill ? style->filled : style->stroked;
    *colour = (from & ~(uint32_t)255) | (uint32_t)((from & 255) * (*colour & 255) / 255.0 + 0.5);
    *gradient = paint ? fill ? paint->fill : paint->stroke : (bat_gradient){0};
}

/* Gives the mapped object its style and paint; takes it over. */
static bat_status dress(const bat_object *host, const bat_marker_part *part, const double matrix[6],
                        bat_object **object) {
    const double scale = sqrt(bat_matrix_area(matrix));
    double dashes[BAT_DASHES_MAX], own[4], pen[6];
    bat_style style = *bat_object_style(part->object);
    bat_paint paint = {0};
    bat_object *styled = NULL, *painted = NULL;
    if (bat_object_paint(part->object))
        paint = bat_paint_mapped(bat_object_paint(part->object), matrix, scale, dashes);
    bat_paint_pen(&paint, own);
    const double round[6] = {own[0], own[1], own[2], own[3], 0, 0};
    bat_matrix_compose(matrix, round, pen);
    for (int k = 0; k < 4 && style.stroked; k++) paint.pen[k] = pen[k] / scale;
    style.width = fmin(style.width * scale, BAT_COORDINATE_MAX);
    take_ink(host ? part->fill : BAT_INK_OWN, host, &style.filled, &style.fill, &paint.fill);
    take_ink(host ? part->stroke : BAT_INK_OWN, host, &style.stroked, &style.stroke, &paint.stroke);
    bat_status status = bat_object_with_style(*object, &style, &styled);
    if (status == BAT_OK) status = bat_object_with_paint(styled, &paint, &painted);
    if (status == BAT_NUMBER) { /* a paint so slanted that nothing is seen of it */
        paint = (bat_paint){0};
        status = bat_object_with_paint(styled, &paint, &painted);
    }
    bat_object_release(styled);
    bat_object_release(*object);
    *object = painted;
    return status;
}

/* What is seen of a part: within its own clip, and within the marker's box. */
static bat_status clip_part(const bat_marking *marking, const double matrix[6], const bat_object *part,
                            bat_object **object) {
    bat_clip *box = NULL, *all = NULL, *own = NULL;
    bat_object *made = NULL;
    const double *c = marking->clip, corners[10] = {c[0],        c[1], c[0] + c[2], c[1], c[0] + c[2],
                                                    c[1] + c[3], c[0], c[1] + c[3], c[0], c[1]};
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
    bat_status status = BAT_OK;
    if (marking->clipped) {
        bat_curve *edge = NULL;
        status = bat_curve_create(2, 1, false, 5, corners, 7, knots, &edge);
        if (status == BAT_OK) status = bat_clip_create(1, &edge, false, NULL, &box);
        bat_curve_free(edge);
    }
    if (status == BAT_OK) status = bat_clip_join(bat_object_clip(part), box, &all);
    if (status == BAT_OK && all) status = bat_clip_mapped(all, matrix, &own);
    if (status == BAT_OK && own) status = bat_object_with_clip(*object, own, &made);
    bat_clip_release(box);
    bat_clip_release(all);
    bat_clip_release(own);
    if (!made) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

static bat_status add(marks *m, bat_object *object) {
    if (m->count == m->room) {
        const int room = 2 * m->room + 8;
        bat_object **grown = m->count < BAT_POINTS_MAX ? realloc(m->list, (size_t)room * sizeof *grown)
                                                       : NULL;
        if (!grown) return m->count < BAT_POINTS_MAX ? BAT_MEMORY : BAT_COUNT;
        m->list = grown;
        m->room = room;
    }
    m->list[m->count++] = object;
    return BAT_OK;
}

bat_status bat_marking_part(const bat_marking *marking, int part, const double matrix[6],
                            const bat_object *host, bat_object **out) {
    const bat_object *object = marking->parts[part].object;
    bat_object *made = NULL;
    double rows[12];
    bat_matrix_rows(matrix, 3, rows);
    bat_status status = bat_object_type(object)->transform(object, rows, &made);
    if (status == BAT_OK && !made) status = BAT_NUMBER;
    if (status == BAT_OK) status = dress(host, &marking->parts[part], matrix, &made);
    if (status == BAT_OK) status = clip_part(marking, matrix, object, &made);
    if (status == BAT_OK)
        *out = made;
    else
        bat_object_release(made);
    return status;
}

/* The parts of a marker, where that matrix puts them. */
static bat_status add_parts(marks *m, const bat_marking *marking, const double matrix[6]) {
    bat_status status = BAT_OK;
    for (int i = 0; i < marking->count && status == BAT_OK; i++) {
        bat_object *made = NULL;
        status = bat_marking_part(marking, i, matrix, m->host, &made);
        if (status == BAT_OK) status = add(m, made);
        if (status != BAT_OK) bat_object_release(made);
        if (status != BAT_MEMORY && status != BAT_COUNT) status = BAT_OK; /* too large to be seen */
    }
    return status;
}

/* ---- all of them ---- */

static bat_status add_vertices(marks *m, const chain *c, bool first, bool last) {
    bat_status status = BAT_OK;
    for (int i = 0; i <= c->count && status == BAT_OK; i++) {
        const bat_marker_place place = first && i == 0         ? BAT_MARKER_START
                                       : last && i == c->count ? BAT_MARKER_END
                                                               : BAT_MARKER_MID;
        const bat_marking *marking = bat_marker_marking(m->marked->markers[place]);
        double matrix[6];
        if (!marking || marking->count == 0) continue;
        const double turn = marking->turn == BAT_MARKER_FIXED ? 0 : turn_at(m, c, i, place);
        place_at(m, marking, place, i < c->count ? point(c, i, 0) : point(c, i - 1, 3), turn, matrix);
        const double area = bat_matrix_area(matrix);
        if (area > 0 && isfinite(1 / area)) status = add_parts(m, marking, matrix);
    }
    return status;
}

static bat_status add_curve(marks *m, int index, int count) {
    const bat_curve *curve = bat_object_curve(m->host, index);
    chain c = {.size = bat_curve_dimension(curve), .closed = bat_curve_is_closed(curve)};
    double low[BAT_DIMENSION_MAX], high[BAT_DIMENSION_MAX];
    bat_curve_bounds(curve, low, high);
    const double fine = FINE * fmax(high[0] - low[0], high[1] - low[1]);
    bat_status status = bat_curve_to_cubics(curve, fmax(fine, 1e-300), &c.count, &c.points);
    if (status == BAT_TOLERANCE) status = BAT_OK;
    if (status == BAT_OK && c.count > 0) status = add_vertices(m, &c, index == 0, index == count - 1);
    bat_free(c.points);
    return status;
}

bat_status bat_object_mark(const bat_object *object, int *count, bat_object ***list) {
    const bat_markers *markers = bat_object_markers(object);
    const int curves = bat_object_curve_count(object);
    *count = 0, *list = NULL;
    if (!markers) return BAT_OK;
    marks m = {.host = object, .marked = bat_markers_marked(markers)};
    const double *f = m.marked->frame, area = f[0] * f[3] - f[1] * f[2];
    const double back[4] = {f[3] / area, -f[1] / area, -f[2] / area, f[0] / area};
    memcpy(m.back, back, sizeof back);
    bat_status status = BAT_OK;
    for (int i = 0; i < curves && status == BAT_OK; i++) status = add_curve(&m, i, curves);
    if (status != BAT_OK) {
        for (int i = 0; i < m.count; i++) bat_object_release(m.list[i]);
        free(m.list);
        return status;
    }
    *count = m.count, *list = m.list;
    return BAT_OK;
}
