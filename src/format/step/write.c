/* Writes STEP AP214: one part, whose shape is a set of B-spline curves and surfaces, in millimetres. */
#include "format/model/full.h"
#include "format/model/model.h"

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
enum { FIRST = 19, ROW = 10 };

static void put_id(bat_text *text, uint64_t id) {
    bat_text_string(text, "#");
    bat_text_integer(text, id);
}

static void put_number(bat_text *text, double number) {
    char word[40];
    bat_full_number(number, word);
    bat_text_string(text, word);
}

static void separate(bat_text *text, uint64_t i) {
    if (i > 0) bat_text_string(text, i % ROW == 0 ? ",\n" : ",");
}

static uint64_t put_point(bat_text *text, uint64_t id, const double *point, int size) {
    put_id(text, id);
    bat_text_string(text, "=CARTESIAN_POINT('',(");
    for (int c = 0; c < 3; c++) {
        separate(text, (uint64_t)c);
        put_number(text, c < size ? point[c] : 0);
    }
    bat_text_string(text, "));\n");
    return id + 1;
}

/* (multiplicities) or (knots): both of the distinct knots. */
static void put_knots(bat_text *text, const bat_full_axis *axis, bool many) {
    const int last = axis->count + axis->degree;
    uint64_t written = 0;
    bat_text_string(text, "(");
    for (int i = 0, next; i <= last; i = next) {
        const double knot = bat_full_knot(axis, i);
        for (next = i + 1; next <= last && bat_full_knot(axis, next) == knot;) next++;
        separate(text, written++);
        if (many)
            bat_text_integer(text, (uint64_t)(next - i));
        else
            put_number(text, knot);
    }
    bat_text_string(text, ")");
}

static const char *logical(bool value) { return value ? ",.T." : ",.F."; }

static uint64_t put_curve(bat_text *text, uint64_t id, const bat_curve *curve) {
    const bat_full_axis axis = bat_full_axis_of_curve(curve);
    const int size = bat_curve_dimension(curve);
    const uint64_t points = id;
    for (int i = 0; i < axis.count; i++)
        id = put_point(text, id, bat_curve_points(curve) + bat_full_point(&axis, i) * size, size);
    put_id(text, id);
    bat_text_string(text, "=B_SPLINE_CURVE_WITH_KNOTS('',");
    bat_text_integer(text, (uint64_t)axis.degree);
    bat_text_string(text, ",(");
    for (uint64_t i = 0; i < (uint64_t)axis.count; i++) {
        separate(text, i);
        put_id(text, points + i);
    }
    bat_text_string(text, "),.UNSPECIFIED.");
    bat_text_string(text, logical(bat_curve_is_closed(curve)));
    bat_text_string(text, ",.F.,");
    put_knots(text, &axis, true);
    bat_text_string(text, ",");
    put_knots(text, &axis, false);
    bat_text_string(text, ",.UNSPECIFIED.);\n");
    return id + 1;
}

static uint64_t put_surface(bat_text *text, uint64_t id, const bat_surface *surface) {
    bat_full_axis axis[2];
    const uint64_t points = id;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) axis[d] = bat_full_axis_of_surface(surface, d);
    const int n = axis[0].count, m = axis[1].count;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            id = put_point(
                text, id,
                bat_surface_row(surface, bat_full_point(&axis[0], i)) + 3 * bat_full_point(&axis[1], j), 3);
    put_id(text, id);
    bat_text_string(text, "=B_SPLINE_SURFACE_WITH_KNOTS('',");
    for (int d = 0; d < 2; d++) {
        bat_text_integer(text, (uint64_t)axis[d].degree);
        bat_text_string(text, d ? ",(" : ",");
    }
    for (int i = 0; i < n; i++) {
        bat_text_string(text, i ? ",\n(" : "(");
        for (int j = 0; j < m; j++) {
            separate(text, (uint64_t)j);
            put_id(text, points + (uint64_t)i * (uint64_t)m + (uint64_t)j);
        }
        bat_text_string(text, ")");
    }
    bat_text_string(text, "),.UNSPECIFIED.");
    for (bat_direction d = BAT_U; d <= BAT_V; d++)
        bat_text_string(text, logical(bat_surface_is_closed(surface, d)));
    bat_text_string(text, ",.F.");
    for (int k = 0; k < 4; k++) {
        bat_text_string(text, ",");
        put_knots(text, &axis[k % 2], k < 2);
    }
    bat_text_string(text, ",.UNSPECIFIED.);\n");
    return id + 1;
}

static void put_shape(bat_text *text, uint64_t id, const bat_numbers *items, bool surfaces) {
    put_id(text, id);
    bat_text_string(text, surfaces ? "=GEOMETRIC_SET('',(" : "=GEOMETRIC_CURVE_SET('',(");
    for (size_t i = 0; i < items->count; i++) {
        separate(text, i);
        put_id(text, (uint64_t)items->list[i]);
    }
    bat_text_string(text, "));\n");
    put_id(text, id + 1);
    bat_text_string(text, surfaces ? "=GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(#18,"
                                   : "=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#18,");
    put_id(text, id);
    bat_text_string(text, "),#14);\n");
    put_id(text, id + 2);
    bat_text_string(text, "=SHAPE_DEFINITION_REPRESENTATION(#9,");
    put_id(text, id + 1);
    bat_text_string(text, ");\nENDSEC;\nEND-ISO-10303-21;\n");
}

bat_status bat_step_write(const bat_model *model, char **bytes, size_t *size) {
    if (!model || !bytes || !size) return BAT_ARGUMENT;
    if (model->surface_count + model->curve_count == 0) return BAT_COUNT;
    bat_text text = {0};
    bat_numbers items = {0};
    uint64_t id = FIRST;
    bat_text_string(&text, BEFORE);
    for (size_t i = 0; i < model->surface_count; i++) {
        id = put_surface(&text, id, model->surfaces[i]);
        text.failed = !bat_numbers_add(&items, (double)(id - 1)) || text.failed;
    }
    for (size_t i = 0; i < model->curve_count; i++) {
        id = put_curve(&text, id, model->curves[i]);
        text.failed = !bat_numbers_add(&items, (double)(id - 1)) || text.failed;
    }
    put_shape(&text, id, &items, model->surface_count > 0);
    bat_numbers_clear(&items);
    return bat_text_finish(&text, bytes, size);
}
