/* DXF as a format of drawings: curves, with their layers, colours and widths of lines. */
#include "document/format.h"
#include "format/dxf/dxf.h"
#include "kinds/kinds.h"
#include "text/json.h"

#include <math.h>

static bat_status insert(bat_document *document, bat_object *object) {
    const bat_status status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return status;
}

static bat_status insert_layer(bat_document *document, const bat_dxf_layer *layer, bat_id id) {
    bat_object *made = NULL, *object = NULL;
    bat_status status = bat_object_create_group(id, layer->name, true, &made);
    if (status == BAT_OK) status = bat_object_with_state(made, layer->hidden, layer->locked, &object);
    bat_object_release(made);
    return status == BAT_OK ? insert(document, object) : status;
}

/* parent: 0: none. hair: the width of lines that have none. Takes the curve over. */
static bat_status insert_shape(bat_document *document, bat_dxf_shape *shape, bat_id parent, double hair) {
    bat_style style = bat_style_defaults();
    bat_object *made = NULL, *placed = NULL, *object = NULL;
    style.stroke = shape->colour;
    style.width = shape->width > 0 ? shape->width : hair;
    bat_curve *curve = shape->curve;
    shape->curve = NULL;
    bat_status status = bat_object_create_path(bat_document_new_id(document), NULL, &style, 1, &curve, &made);
    if (status == BAT_OK) status = bat_object_with_parent(made, parent, &placed);
    if (status == BAT_OK) status = bat_object_with_state(placed, shape->hidden, false, &object);
    bat_object_release(made), bat_object_release(placed);
    return status == BAT_OK ? insert(document, object) : status;
}

/* A thousandth of the drawing's larger side. */
static double hair_of(const bat_dxf *dxf) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < dxf->shape_count; i++) {
        const bat_curve *curve = dxf->shapes[i].curve;
        const size_t size = (size_t)bat_curve_dimension(curve);
        const double *points = bat_curve_points(curve);
        for (size_t k = 0; k < size * bat_curve_count(curve); k += size)
            for (size_t c = 0; c < 2; c++) {
                low[c] = fmin(low[c], points[k + c]);
                high[c] = fmax(high[c], points[k + c]);
            }
    }
    const double side = fmax(high[0] - low[0], high[1] - low[1]);
    return side > 0 ? side / 1000 : 1;
}

static bat_status insert_all(bat_document *document, bat_dxf *dxf) {
    const double hair = hair_of(dxf);
    bat_status status = BAT_OK;
    bool layers = false; /* a single one that is called "0" is what DXF has when nobody made one */
    for (size_t i = 0; i < dxf->layer_count; i++)
        layers = layers ||
                 (dxf->layers[i].shapes > 0 && (dxf->layers[i].name[0] != '0' || dxf->layers[i].name[1] ||
                                                dxf->layers[i].hidden || dxf->layers[i].locked));
    for (size_t i = 0; i < dxf->layer_count && status == BAT_OK; i++) {
        if (dxf->layers[i].shapes == 0) continue;
        const bat_id parent = layers ? bat_document_new_id(document) : 0;
        if (layers) status = insert_layer(document, &dxf->layers[i], parent);
        for (size_t k = 0; k < dxf->shape_count && status == BAT_OK; k++)
            if (dxf->shapes[k].layer == i) status = insert_shape(document, &dxf->shapes[k], parent, hair);
    }
    return status;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_dxf dxf;
    bat_document *document = NULL;
    bat_status status = bat_dxf_parse(&how->svg, text, size, &dxf, &report->lost, problem);
    if (status != BAT_OK) return status;
    if (dxf.shape_count == 0) {
        bat_dxf_clear(&dxf);
        return bat_problem_set(problem, BAT_COUNT, "", "expected a curve among the entities, found none");
    }
    status = bat_document_create(&document);
    if (status == BAT_OK) status = bat_document_set_scale(document, 1, dxf.unit);
    if (status == BAT_OK) status = insert_all(document, &dxf);
    bat_dxf_clear(&dxf);
    if (status == BAT_OK) {
        *out = document;
        return status;
    }
    bat_document_free(document);
    return bat_problem_set(problem, status, "", bat_status_message(status));
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    const bat_status status = bat_dxf_write(document, 0, text, size);
    if (status == BAT_COUNT)
        return bat_problem_set(problem, status, "",
                               "a .dxf file holds curves, expected 1 at least, found none");
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_dxf = {"dxf", "image/vnd.dxf", false, bat_dxf_sniff, read, write};
