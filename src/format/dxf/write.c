/* Writes DXF of release 2007: splines, polylines and lines; or polylines of arcs and lines, for cutters. */
#include "base/real.h"
#include "document/kind.h"
#include "document/scale.h"
#include "format/dxf/dxf.h"
#include "format/dxf/frame.h"

#include <batten/bezier.h>
#include <batten/refine.h>
#include <batten/relate.h>
#include <math.h>
#include <string.h>

static const double CORNER = 0.05;

typedef struct writer {
    bat_text *text;
    const bat_document *document;
    const bat_object *object; /* whose curves are written */
    double arcs;              /* tolerance, in the document's units; 0: none */
    double scale, origin[2];  /* bat_unit_corner */
    unsigned handle;          /* the next one */
    size_t curves;
} writer;

/* ---- layers ---- */

/* A name as DXF allows it, without <>/\":;?*|=`. An empty one is "_". */
static void put_name(bat_text *to, int code, const char *name) {
    bat_text value = {0};
    for (; *name; name++)
        bat_text_add(&value, strchr("<>/\\\":;?*|=`", *name) || (unsigned char)*name < ' ' ? "_" : name, 1);
    if (value.size == 0) bat_text_string(&value, "_");
    bat_text_add(&value, "", 1);
    if (value.failed)
        to->failed = true;
    else
        bat_dxf_text(to, code, value.data);
    bat_text_free(&value);
}

static bool is_layer(const bat_object *object) { return bat_object_is(object, BAT_LAYER); }

/* The layer that the object is in; NULL: none. */
static const bat_object *layer_of(const bat_document *document, const bat_object *object) {
    while (object && !is_layer(object)) {
        const bat_id parent = bat_object_parent(object);
        object = parent ? bat_document_at(document, bat_document_find(document, parent)) : NULL;
    }
    return object;
}

static void put_layer(writer *w, const bat_object *layer) {
    enum { FROZEN = 1, LOCKED = 4, BLACK = 7 };
    const int state = !layer ? 0
                             : (bat_object_is_hidden(layer) ? FROZEN : 0) |
                                   (bat_object_is_locked(layer) ? LOCKED : 0);
    bat_dxf_text(w->text, 0, "LAYER");
    bat_dxf_handle(w->text, 5, w->handle++);
    bat_dxf_handle(w->text, 330, BAT_DXF_LAYERS);
    bat_dxf_text(w->text, 100, "AcDbSymbolTableRecord");
    bat_dxf_text(w->text, 100, "AcDbLayerTableRecord");
    if (layer)
        put_name(w->text, 2, bat_object_name(layer));
    else
        bat_dxf_text(w->text, 2, "0");
    bat_dxf_integer(w->text, 70, state);
    bat_dxf_integer(w->text, 62, BLACK);
    bat_dxf_text(w->text, 6, "Continuous");
    bat_dxf_integer(w->text, 370, -3);
}

/* ---- entities ---- */

/* The nearest of the widths that there are, in hundredths of a millimetre. */
static int weight_of(double width) {
    static const int weights[] = {0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                  53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
    int best = 0;
    for (size_t i = 1; i < sizeof weights / sizeof *weights; i++)
        if (fabs(100 * width - weights[i]) < fabs(100 * width - weights[best])) best = (int)i;
    return weights[best];
}

/* What all entities begin with. part: the name of the part that holds the shape. */
static void put_head(writer *w, const char *name, const char *part) {
    const bat_style *style = bat_object_style(w->object);
    const bat_object *layer = layer_of(w->document, w->object);
    const uint32_t colour = style->stroked || !style->filled ? style->stroke : style->fill;
    bat_dxf_text(w->text, 0, name);
    bat_dxf_handle(w->text, 5, w->handle++);
    bat_dxf_handle(w->text, 330, BAT_DXF_MODEL);
    bat_dxf_text(w->text, 100, "AcDbEntity");
    if (layer)
        put_name(w->text, 8, bat_object_name(layer));
    else
        bat_dxf_text(w->text, 8, "0");
    if (bat_object_is_hidden(w->object)) bat_dxf_integer(w->text, 60, 1);
    bat_dxf_integer(w->text, 62, bat_dxf_index_near(colour));
    bat_dxf_integer(w->text, 420, (int)(colour >> 8));
    bat_dxf_integer(w->text, 370, weight_of(style->stroked ? style->width * w->scale : 0));
    bat_dxf_text(w->text, 100, part);
}

/* A point at the codes code, code + 10 and, in space, code + 20. space: z is written, whatever the dimension. */
static void put_point(writer *w, int code, const double *point, int dimension, bool space) {
    bat_dxf_real(w->text, code, (point[0] - w->origin[0]) * w->scale);
    bat_dxf_real(w->text, code + 10, (w->origin[1] - point[1]) * w->scale + 0.0); /* no -0 */
    if (space) bat_dxf_real(w->text, code + 20, dimension > 2 ? (0 - point[2]) * w->scale : 0);
}

/* What stands for no place, but has to be there. */
static void put_zero(writer *w) {
    for (int code = 10; code <= 30; code += 10) bat_dxf_real(w->text, code, 0);
}

static void put_line(writer *w, const double *points, int dimension) {
    put_head(w, "LINE", "AcDbLine");
    put_point(w, 10, points, dimension, true);
    put_point(w, 11, points + dimension, dimension, true);
}

static void begin_light_polyline(writer *w, size_t count, bool closed) {
    put_head(w, "LWPOLYLINE", "AcDbPolyline");
    bat_dxf_integer(w->text, 90, (int)count);
    bat_dxf_integer(w->text, 70, closed);
    bat_dxf_real(w->text, 43, 0);
}

static void put_polyline(writer *w, const bat_curve *curve) {
    enum { CLOSED = 1, SPACE = 8, VERTEX_IN_SPACE = 32 };
    const int dimension = bat_curve_dimension(curve);
    const size_t count = bat_curve_count(curve);
    const double *points = bat_curve_points(curve);
    const bool closed = bat_curve_is_closed(curve);
    if (dimension == 2) {
        begin_light_polyline(w, count, closed);
        for (size_t i = 0; i < count; i++) put_point(w, 10, points + 2 * i, 2, false);
        return;
    }
    put_head(w, "POLYLINE", "AcDb3dPolyline");
    put_zero(w);
    bat_dxf_integer(w->text, 70, SPACE | (closed ? CLOSED : 0));
    for (size_t i = 0; i < count; i++) {
        put_head(w, "VERTEX", "AcDbVertex");
        bat_dxf_text(w->text, 100, "AcDb3dPolylineVertex");
        put_point(w, 10, points + 3 * i, 3, true);
        bat_dxf_integer(w->text, 70, VERTEX_IN_SPACE);
    }
    bat_dxf_text(w->text, 0, "SEQEND");
    bat_dxf_handle(w->text, 5, w->handle++);
    bat_dxf_handle(w->text, 330, BAT_DXF_MODEL);
    bat_dxf_text(w->text, 100, "AcDbEntity");
    bat_dxf_text(w->text, 8, "0");
}

/* Clamped, whatever the curve is: most readers take a spline's ends to be its first and last point. */
static bat_status put_spline(writer *w, const bat_curve *curve) {
    enum { CLOSED = 1, PLANAR = 8 };
    const bool closed = bat_curve_is_closed(curve);
    bat_curve *open = NULL;
    const bat_status status = closed ? bat_curve_open_at(curve, bat_curve_knots(curve)[0], &open)
                                     : bat_curve_clamp(curve, &open);
    if (status != BAT_OK) return status;
    const int dimension = bat_curve_dimension(open), knots = bat_curve_knot_count(open);
    const size_t count = bat_curve_count(open);
    put_head(w, "SPLINE", "AcDbSpline");
    bat_dxf_integer(w->text, 70, (closed ? CLOSED : 0) | (dimension == 2 ? PLANAR : 0));
    bat_dxf_integer(w->text, 71, bat_curve_degree(open));
    bat_dxf_integer(w->text, 72, knots);
    bat_dxf_integer(w->text, 73, (int)count);
    bat_dxf_integer(w->text, 74, 0);
    for (int i = 0; i < knots; i++) bat_dxf_real(w->text, 40, bat_curve_knots(open)[i]);
    for (size_t i = 0; i < count; i++)
        put_point(w, 10, bat_curve_points(open) + i * (size_t)dimension, dimension, true);
    bat_curve_free(open);
    return BAT_OK;
}

/* tan of a quarter of the arc's angle; y of DXF points the other way, so anticlockwise becomes clockwise. */
static double bulge_of(const bat_arc *arc) {
    if (arc->radius == 0) return 0;
    const double from = bat_atan2(arc->from[1] - arc->centre[1], arc->from[0] - arc->centre[0]);
    const double to = bat_atan2(arc->to[1] - arc->centre[1], arc->to[0] - arc->centre[0]);
    double angle = arc->ccw ? to - from : from - to;
    if (angle < 0) angle += 2 * BAT_PI;
    return (arc->ccw ? -1 : 1) * bat_tan(angle / 4);
}

static bat_status put_arcs(writer *w, const bat_curve *curve) {
    bat_arc *arcs = NULL;
    size_t count = 0;
    const bool closed = bat_curve_is_closed(curve);
    const bat_status status = bat_curve_arcs(curve, w->arcs, CORNER, &count, &arcs, NULL);
    if (status != BAT_OK) return status;
    begin_light_polyline(w, count + !closed, closed);
    for (size_t i = 0; i < count; i++) {
        const double bulge = bulge_of(&arcs[i]);
        put_point(w, 10, arcs[i].from, 2, false);
        if (bulge != 0) bat_dxf_real(w->text, 42, bulge);
    }
    if (!closed && count > 0) put_point(w, 10, arcs[count - 1].to, 2, false);
    bat_free(arcs);
    return BAT_OK;
}

/* Whether the points of a polyline are one in the file: no reader sees anything of it, and ours refuses a file of such alone. */
static bool is_dot(const writer *w, const bat_curve *curve) {
    const size_t dimension = (size_t)bat_curve_dimension(curve), count = dimension * bat_curve_count(curve);
    const double *points = bat_curve_points(curve);
    for (size_t i = dimension; i < count; i++) {
        const double from = i % dimension < 2 ? w->origin[i % dimension] : 0;
        if ((points[i] - from) * w->scale != (points[i % dimension] - from) * w->scale) return false;
    }
    return bat_curve_degree(curve) == 1;
}

static bat_status put_curve(writer *w, const bat_curve *curve) {
    const int dimension = bat_curve_dimension(curve), degree = bat_curve_degree(curve);
    if (is_dot(w, curve)) return BAT_OK;
    w->curves++;
    if (degree == 1 && bat_curve_count(curve) == 2 && !bat_curve_is_closed(curve))
        put_line(w, bat_curve_points(curve), dimension);
    else if (degree == 1)
        put_polyline(w, curve);
    else if (w->arcs > 0 && dimension == 2)
        return put_arcs(w, curve);
    else
        return put_spline(w, curve);
    return BAT_OK;
}

/* ---- the file ---- */

static bat_status put_all(writer *w) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(w->document) && status == BAT_OK; i++) {
        w->object = bat_document_at(w->document, i);
        for (int k = 0; k < bat_object_curve_count(w->object) && status == BAT_OK; k++)
            status = put_curve(w, bat_object_curve(w->object, k));
    }
    return status;
}

bat_status bat_dxf_write(const bat_document *document, double arcs, char **text, size_t *size) {
    if (!document || !text || !size || !(arcs >= 0)) return BAT_ARGUMENT;
    bat_text layers = {0}, entities = {0}, all = {0};
    writer w = {.text = &layers, .document = document, .handle = BAT_DXF_FIRST};
    int layer_count = 1;
    w.scale = bat_unit_corner(document, w.origin);
    w.arcs = arcs / w.scale;
    put_layer(&w, NULL);
    for (int i = 0; i < bat_document_count(document); i++)
        if (is_layer(bat_document_at(document, i)))
            put_layer(&w, bat_document_at(document, i)), layer_count++;
    w.text = &entities;
    bat_status status = put_all(&w);
    if (status == BAT_OK && w.curves == 0) status = BAT_COUNT;
    if (status == BAT_OK) {
        bat_dxf_open(&all, w.handle, layer_count);
        bat_text_add(&all, layers.data, layers.size);
        bat_dxf_entities(&all);
        bat_text_add(&all, entities.data, entities.size);
        bat_dxf_close(&all);
        all.failed = all.failed || layers.failed || entities.failed;
        status = bat_text_finish(&all, text, size);
    }
    bat_text_free(&layers), bat_text_free(&entities);
    if (status != BAT_OK) bat_text_free(&all);
    return status;
}
