/* Writes STEP AP214: one part, in millimetres: solids, where a surface bounds one, and a set of the other B-splines. */
#include "format/model/full.h"
#include "format/model/model.h"
#include "format/step/put.h"

#include <string.h>

/* The library knows neither the time nor who writes: the date is that of no day. */
static const char BEFORE[] =
    "ISO-10303-21;\nHEADER;\n"
    "FILE_DESCRIPTION(('B-spline curves and surfaces'),'2;1');\n"
    "FILE_NAME('','2000-01-01T00:00:00',(''),(''),'Batten','Batten','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\n"
    "ENDSEC;\nDATA;\n"
    "#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');\n"
    "#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);\n"
    "#3=PRODUCT_CONTEXT('',#1,'mechanical');\n"
    "#4=PRODUCT('shape','shape','',(#3));\n"
    "#5=PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#4));\n"
    "#6=PRODUCT_DEFINITION_FORMATION('','',#4);\n"
    "#7=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"
    "#8=PRODUCT_DEFINITION('design','',#6,#7);\n"
    "#9=PRODUCT_DEFINITION_SHAPE('','',#8);\n"
    "#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#11=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
    "#12=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
    "#13=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#10,'distance_accuracy_value','');\n"
    "#14=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#13))"
    "GLOBAL_UNIT_ASSIGNED_CONTEXT((#10,#11,#12))REPRESENTATION_CONTEXT('',''));\n"
    "#15=CARTESIAN_POINT('',(0.,0.,0.));\n#16=DIRECTION('',(0.,0.,1.));\n#17=DIRECTION('',(1.,0.,0.));\n"
    "#18=AXIS2_PLACEMENT_3D('',#15,#16,#17);\n";
enum { PLACEMENT = 18, FIRST = 19 };

/* A representation of the part by these items. */
static uint64_t put_shape(bat_text *text, uint64_t id, const char *name, const bat_numbers *items) {
    bat_step_put_id(text, id);
    bat_text_string(text, "=");
    bat_text_string(text, name);
    bat_text_string(text, "('',");
    bat_step_put_list(text, items);
    bat_text_string(text, ",#14);\n");
    bat_step_put_id(text, id + 1);
    bat_text_string(text, "=SHAPE_DEFINITION_REPRESENTATION(#9,");
    bat_step_put_id(text, id);
    bat_text_string(text, ");\n");
    return id + 2;
}

/* Surfaces that bound nothing, and curves, are a set. */
static uint64_t put_set(bat_text *text, uint64_t id, const bat_numbers *set, bool surfaces) {
    bat_numbers items = {0};
    bat_step_put_id(text, id);
    bat_text_string(text, surfaces ? "=GEOMETRIC_SET(''," : "=GEOMETRIC_CURVE_SET('',");
    bat_step_put_list(text, set);
    bat_text_string(text, ");\n");
    text->failed = !bat_numbers_add(&items, PLACEMENT) || !bat_numbers_add(&items, (double)id) ||
                   text->failed;
    id = put_shape(text, id + 1,
                   surfaces ? "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"
                            : "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
                   &items);
    bat_numbers_clear(&items);
    return id;
}

static bat_status put_all(const bat_model *model, bat_text *text, bat_numbers *solids, bat_numbers *set) {
    bat_status status = BAT_OK;
    uint64_t id = FIRST;
    bool surfaces = false;
    text->failed = !bat_numbers_add(solids, PLACEMENT) || text->failed;
    for (size_t i = 0; i < model->surface_count && status == BAT_OK; i++) {
        const bool solid = bat_step_is_solid(model->surfaces[i]);
        if (solid)
            status = bat_step_put_solid(text, &id, model->surfaces[i]);
        else
            id = bat_step_put_surface(text, id, model->surfaces[i]);
        text->failed = !bat_numbers_add(solid ? solids : set, (double)(id - 1)) || text->failed;
        surfaces = surfaces || !solid;
    }
    for (size_t i = 0; i < model->curve_count && status == BAT_OK; i++) {
        id = bat_step_put_curve(text, id, model->curves[i]);
        text->failed = !bat_numbers_add(set, (double)(id - 1)) || text->failed;
    }
    if (solids->count > 1) id = put_shape(text, id, "ADVANCED_BREP_SHAPE_REPRESENTATION", solids);
    if (set->count) put_set(text, id, set, surfaces);
    bat_text_string(text, "ENDSEC;\nEND-ISO-10303-21;\n");
    return status;
}

bat_status bat_step_write(const bat_model *model, char **bytes, size_t *size) {
    if (!model || !bytes || !size) return BAT_ARGUMENT;
    if (model->surface_count + model->curve_count == 0) return BAT_COUNT;
    bat_text text = {0};
    bat_numbers solids = {0}, set = {0};
    bat_text_string(&text, BEFORE);
    const bat_status status = put_all(model, &text, &solids, &set);
    text.failed = text.failed || status != BAT_OK;
    bat_numbers_clear(&solids);
    bat_numbers_clear(&set);
    return bat_text_finish(&text, bytes, size);
}
