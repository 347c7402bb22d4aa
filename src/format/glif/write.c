/* The outlines of a drawing as a glyph: GLIF 2. y = 0 of the document is the baseline, the page's width the advance. */
#include "document/nesting.h"
#include "text/text.h"

#include <batten/bezier.h>
#include <batten/format.h>
#include <math.h>
#include <string.h>

static const double CUBICS = 1e-9; /* of a curve's size: within that, curves of higher degree become cubics */
static const double THIRDS = 1e-12, SMOOTH = 1e-6; /* of a curve's size; radians */

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
    bat_text_string(text, "      <point x=\"");
    bat_text_number(text, at[0]);
    bat_text_string(text, "\" y=\"");
    bat_text_number(text, 0 - at[1]);
    bat_text_string(text, "\"");
    if (type) bat_text_string(text, " type=\""), bat_text_string(text, type), bat_text_string(text, "\"");
    if (smooth) bat_text_string(text, " smooth=\"yes\"");
    bat_text_string(text, "/>\n");
}

static const char *type_of(const outline *o, int segment) { return is_line(o, segment) ? "line" : "curve"; }

static void put_contour(const outline *o) {
    const int last = o->count - 1;
    bat_text_string(o->text, "    <contour>\n");
    put_point(o->text, corner(o, 0, 0), o->closed ? type_of(o, last) : "move",
              o->closed && is_smooth(o, last, 0));
    for (int i = 0; i < o->count; i++) {
        for (int k = 1; k < 3 && !is_line(o, i); k++) put_point(o->text, corner(o, i, k), NULL, false);
        if (i < last)
            put_point(o->text, corner(o, i, 3), type_of(o, i), is_smooth(o, i, i + 1));
        else if (!o->closed)
            put_point(o->text, corner(o, i, 3), type_of(o, i), false);
    }
    bat_text_string(o->text, "    </contour>\n");
}

static bat_status put_curve(bat_text *text, const bat_curve *curve) {
    outline o = {.text = text, .closed = bat_curve_is_closed(curve), .size = bat_curve_size(curve)};
    double *points;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    const bat_status status = bat_curve_to_cubics(curve, o.size > 0 ? CUBICS * o.size : 1, &o.count, &points);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    o.points = points;
    put_contour(&o);
    bat_free(points);
    return BAT_OK;
}

static bat_status put_outline(bat_text *text, const bat_document *document) {
    bat_nesting nesting = {0};
    bat_nesting_level level;
    bat_status status = BAT_OK;
    bat_text_string(text, "  <outline>\n");
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_nesting_next(&nesting, object, &level) || level.hidden) continue;
        for (int k = 0; k < bat_object_curve_count(object) && status == BAT_OK; k++)
            status = put_curve(text, bat_object_curve(object, k));
    }
    bat_text_string(text, "  </outline>\n");
    return status;
}

/* That of the first object that has one. */
static const char *name_of(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++) {
        const char *name = bat_object_name(bat_document_at(document, i));
        if (name && *name) return name;
    }
    return "glyph";
}

bat_status bat_glif_write(const bat_document *document, char **text, size_t *size) {
    bat_text all = {0};
    double page[4];
    if (!document || !text || !size) return BAT_ARGUMENT;
    bat_document_page(document, page);
    const char *name = name_of(document);
    bat_text_string(&all, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<glyph name=\"");
    bat_text_xml(&all, name, strlen(name), true);
    bat_text_string(&all, "\" format=\"2\">\n");
    if (page[2] > 0) {
        bat_text_string(&all, "  <advance width=\"");
        bat_text_number(&all, page[2]);
        bat_text_string(&all, "\"/>\n");
    }
    const bat_status status = put_outline(&all, document);
    bat_text_string(&all, "</glyph>\n");
    if (status == BAT_OK) return bat_text_finish(&all, text, size);
    bat_text_free(&all);
    return status;
}
