/* Curves as the contours of a glyph: lines and cubics, cut at their extremes when wanted. */
#include "format/glif/contours.h"

#include "curve/roots.h"
#include "document/nesting.h"
#include "format/glyph/glyph.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CUBICS = 1e-9; /* of a curve's size: within that, curves of higher degree become cubics */
static const double THIRDS = 1e-12, SMOOTH = 1e-6; /* of a curve's size; radians */
static const double ENDS = 1e-6;                   /* of a segment: an extreme that near to an end is at it */

typedef struct outline {
    bat_text *text;
    const double *points; /* 4 of each segment, in the plane */
    int count;
    bool closed;
    double size;
} outline;

static const double *corner(const outline *o, int segment, int k) {
    return o->points + 8 * (size_t)segment + 2 * k;
}

static bool is_line(const outline *o, int segment) {
    const double *a = corner(o, segment, 0), *b = corner(o, segment, 3);
    for (int k = 1; k < 3; k++)
        for (int c = 0; c < 2; c++)
            if (!(fabs(corner(o, segment, k)[c] - (a[c] + k * (b[c] - a[c]) / 3)) <= THIRDS * o->size))
                return false;
    return true;
}

/* From the end of one segment to the start of the next there is no turn; between two lines nothing is smooth. */
static bool is_smooth(const outline *o, int before, int after) {
    const double *p = corner(o, before, 2), *q = corner(o, before, 3), *r = corner(o, after, 1);
    const double a[2] = {q[0] - p[0], q[1] - p[1]}, b[2] = {r[0] - q[0], r[1] - q[1]};
    const double across = a[0] * b[1] - a[1] * b[0], along = a[0] * b[0] + a[1] * b[1];
    return along > 0 && fabs(across) <= SMOOTH * along && !(is_line(o, before) && is_line(o, after));
}

static void put_point(bat_text *text, const double *at, const char *type, bool smooth) {
    bat_text_string(text, "\n      <point x=\"");
    bat_text_number(text, at[0]);
    bat_text_string(text, "\" y=\"");
    bat_text_number(text, 0 - at[1]);
    bat_text_string(text, "\"");
    if (type) bat_text_string(text, " type=\""), bat_text_string(text, type), bat_text_string(text, "\"");
    if (smooth) bat_text_string(text, " smooth=\"yes\"");
    bat_text_string(text, "/>");
}

static const char *type_of(const outline *o, int segment) { return is_line(o, segment) ? "line" : "curve"; }

static void put_contour(const outline *o) {
    const int last = o->count - 1;
    bat_text_string(o->text, "\n    <contour>");
    put_point(o->text, corner(o, 0, 0), o->closed ? type_of(o, last) : "move",
              o->closed && is_smooth(o, last, 0));
    for (int i = 0; i < o->count; i++) {
        for (int k = 1; k < 3 && !is_line(o, i); k++) put_point(o->text, corner(o, i, k), NULL, false);
        if (i < last)
            put_point(o->text, corner(o, i, 3), type_of(o, i), is_smooth(o, i, i + 1));
        else if (!o->closed)
            put_point(o->text, corner(o, i, 3), type_of(o, i), false);
    }
    bat_text_string(o->text, "\n    </contour>");
}

/* ---- extremes ---- */

/* De Casteljau: the part up to t into `low`, the rest stays in `cubic`. The cut is an extreme of axis c: its handles lie as
 * far along that axis as it does. */
static void cut_at(double cubic[8], double t, int c, double low[8]) {
    memcpy(low, cubic, 2 * sizeof *low);
    for (int k = 1; k <= 3; k++) {
        for (int i = 0; i <= 3 - k; i++)
            for (int a = 0; a < 2; a++)
                cubic[2 * i + a] = (1 - t) * cubic[2 * i + a] + t * cubic[2 * i + 2 + a];
        memcpy(low + 2 * (size_t)k, cubic, 2 * sizeof *low);
    }
    low[4 + c] = cubic[2 + c] = cubic[c];
}

typedef struct place {
    double t;
    int axis;
} place;

/* Extremes strictly within a cubic, ascending; at most two of each axis. */
static int find_extremes(const double cubic[8], double size, place found[4]) {
    int count = 0;
    for (int c = 0; c < 2; c++) {
        const double rise[3] = {cubic[2 + c] - cubic[c], cubic[4 + c] - cubic[2 + c],
                                cubic[6 + c] - cubic[4 + c]};
        bat_signs signs = {0};
        double x[3];
        const int roots = bat_bernstein_crossings(2, rise, THIRDS * size, &signs, x);
        for (int r = 0; r < roots; r++) {
            if (!(x[r] > ENDS && x[r] < 1 - ENDS)) continue;
            int at = count++;
            for (; at > 0 && found[at - 1].t > x[r]; at--) found[at] = found[at - 1];
            found[at] = (place){x[r], c};
        }
    }
    return count;
}

/* points: of o->count cubics. Gives way to those of the cubics between extremes. */
static bat_status cut_at_extremes(outline *o, double **points) {
    double *all = malloc(5 * 8 * (size_t)o->count * sizeof *all);
    int count = 0;
    if (!all) return BAT_MEMORY;
    for (int i = 0; i < o->count; i++) {
        double *rest = all + 8 * (size_t)count++, low[8];
        place at[4];
        memcpy(rest, *points + 8 * (size_t)i, 8 * sizeof *rest);
        const int places = is_line(o, i) ? 0 : find_extremes(rest, o->size, at);
        double from = 0;
        for (int k = 0; k < places; k++) {
            if (!(at[k].t - from > ENDS)) continue; /* of both axes at once */
            cut_at(rest, (at[k].t - from) / (1 - from), at[k].axis, low);
            memcpy(rest + 8, rest, 8 * sizeof *rest);
            memcpy(rest, low, sizeof low);
            rest += 8, count++, from = at[k].t;
        }
    }
    free(*points);
    *points = all, o->points = all, o->count = count;
    return BAT_OK;
}

/* ---- curves ---- */

static bat_status put_curve(bat_text *text, const bat_curve *curve, bool extremes) {
    outline o = {.text = text, .closed = bat_curve_is_closed(curve), .size = bat_curve_size(curve)};
    double *points;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    bat_status status = bat_curve_to_cubics(curve, o.size > 0 ? CUBICS * o.size : 1, &o.count, &points);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    o.points = points;
    status = extremes ? cut_at_extremes(&o, &points) : BAT_OK;
    for (int i = 0; i < 8 * o.count && status == BAT_OK; i++)
        if (!(fabs(o.points[i]) <= BAT_GLYPH_FARTHEST)) status = BAT_NUMBER;
    if (status == BAT_OK) put_contour(&o);
    bat_free(points);
    return status;
}

bat_status bat_glif_contours(const bat_document *document, bool extremes, bat_text *text) {
    bat_nesting nesting = {0};
    bat_nesting_level level;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_nesting_next(&nesting, object, &level) || level.hidden) continue;
        for (int k = 0; k < bat_object_curve_count(object) && status == BAT_OK; k++)
            status = put_curve(text, bat_object_curve(object, k), extremes);
    }
    return status;
}
