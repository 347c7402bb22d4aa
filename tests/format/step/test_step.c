/* STEP: what is written comes back bit for bit; instances in any order, complex ones, units, knots that are left out,
 * boundaries of faces; what is refused, with its line; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/random_surface.h"

static void there_and_back(void **state) {
    (void)state;
    random_source r = {78};
    for (int run = 0; run < 150; run++) {
        int degree[2], kind[2], spans[2];
        for (int d = 0; d < 2; d++) {
            degree[d] = random_int(&r, 1, 4);
            kind[d] = random_int(&r, 0, 2);
            spans[d] = random_int(&r, 2, 5);
        }
        bat_surface *surface = random_surface(&r, degree, kind, spans);
        bat_curve *curves[2];
        for (int k = 0; k < 2; k++) {
            const int p = random_int(&r, 1, 7), how = random_int(&r, 0, 2);
            curves[k] = random_curve(&r, p, 2 + k, how, 4);
        }
        bat_model back;
        const bat_model model = {
            .surface_count = (size_t)(run % 3 > 0), .curve_count = 2, .surfaces = &surface, .curves = curves};
        bat_problem problem;
        char *bytes;
        size_t size;
        assert_int_equal(bat_step_write(&model, &bytes, &size), BAT_OK);
        assert_int_equal(bat_step_read(bytes, size, &back, &problem), BAT_OK);
        assert_true(back.surface_count == model.surface_count && back.curve_count == 2);
        assert_int_equal(back.left_out, 0);
        if (run % 3) assert_true(bat_surface_is_equal(back.surfaces[0], surface));
        for (int k = 0; k < 2; k++) assert_true(bat_curve_is_equal(back.curves[k], curves[k]));
        bat_model_clear(&back);
        bat_free(bytes);
        bat_surface_free(surface);
        for (int k = 0; k < 2; k++) bat_curve_free(curves[k]);
    }
}

/* ---- files of other programs ---- */

#define BEGIN                                                                                                \
    "ISO-10303-21;\r\nHEADER;\r\nFILE_NAME('it''s; /* here "                                                 \
    "*/','',(''),(''),'','','');\r\nENDSEC;\r\nDATA;\r\n"
#define END "ENDSEC;\nEND-ISO-10303-21;\n"
#define LINE "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,2.E0,.5));\n"
#define KNOTS "(2,2),(0.,1.),.UNSPECIFIED.);\n"
#define CURVE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.UNSPECIFIED.,.F.,.F.," KNOTS

static bat_model read(const char *text) {
    bat_model model;
    bat_problem problem = {.place = ""};
    const bat_status status = bat_step_read(text, strlen(text), &model, &problem);
    if (status != BAT_OK) print_message("%s: %s\n", problem.place, problem.message);
    assert_int_equal(status, BAT_OK);
    return model;
}

static void at(const bat_model *model, double u, double x, double y, double z) {
    double found[3] = {0, 0, 0};
    assert_int_equal(model->curve_count, 1);
    bat_curve_eval(model->curves[0], u, 0, found);
    assert_true(fabs(found[0] - x) < 1e-12 && fabs(found[1] - y) < 1e-12 && fabs(found[2] - z) < 1e-12);
}

/* The curve before its points, its numbers falling, a comment over lines; a weight that all share, in a complex instance. */
static void any_order(void **state) {
    (void)state;
    bat_model m = read(
        BEGIN
        "/* a\r\ncomment */ #9 = ( BOUNDED_CURVE ( ) B_SPLINE_CURVE ( 1 , ( #2 , #1 ) , .UNSPECIFIED. ,\r\n"
        " .F. , .U. ) B_SPLINE_CURVE_WITH_KNOTS ( ( 2 , 2 ) , ( 0. , 1. ) , .UNSPECIFIED. ) CURVE ( )\n"
        "GEOMETRIC_REPRESENTATION_ITEM ( ) RATIONAL_B_SPLINE_CURVE ( ( 2. , 2. ) )\n"
        "REPRESENTATION_ITEM ( 'a name' ) ) ;\n"
        "#2=CARTESIAN_POINT('',(1.,2.E0,.5));#1=CARTESIAN_POINT('',(0.,0.,0.));" END);
    at(&m, 0, 1, 2, 0.5);
    at(&m, 1, 0, 0, 0);
    assert_int_equal(m.left_out, 0);
    bat_model_clear(&m);
}

static void units(void **state) {
    (void)state;
    static const struct {
        const char *unit;
        double millimetres;
    } cases[] = {{"#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n", 1},
                 {"#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n", 1000},
                 {"#10=(NAMED_UNIT(*)LENGTH_UNIT()SI_UNIT(.CENTI.,.METRE.));\n", 10},
                 {"#20=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#21=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(."
                  "MILLI.,.METRE.));\n"
                  "#22=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#21);\n"
                  "#10=(CONVERSION_BASED_UNIT('INCH',#22)LENGTH_UNIT()NAMED_UNIT(#20));\n",
                  25.4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[2000];
        snprintf(text, sizeof text,
                 BEGIN LINE CURVE
                 "%s#11=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
                 "#12=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#10))"
                 "REPRESENTATION_CONTEXT('',''));\n" END,
                 cases[i].unit);
        bat_model m = read(text);
        const double mm = cases[i].millimetres;
        at(&m, 1, mm, 2 * mm, 0.5 * mm);
        assert_int_equal(m.left_out, 0);
        bat_model_clear(&m);
    }
}

/* Knots that the kind of the curve implies. */
static void implied_knots(void **state) {
    (void)state;
#define FIVE                                                                                                 \
    "#1=CARTESIAN_POINT('',(0.,0.,1.));#2=CARTESIAN_POINT('',(1.,2.,0.));#3=CARTESIAN_POINT('',(2.,0.,0.));" \
    "#4=CARTESIAN_POINT('',(3.,2.,0.));#5=CARTESIAN_POINT('',(4.,0.,3.));\n"
    static const struct {
        const char *name;
        double knots[8];
    } cases[] = {{"QUASI_UNIFORM_CURVE", {0, 0, 0, 1, 2, 3, 3, 3}},
                 {"UNIFORM_CURVE", {-2, -1, 0, 1, 2, 3, 4, 5}},
                 {"BEZIER_CURVE", {0, 0, 0, 1, 1, 2, 2, 2}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[2000];
        snprintf(text, sizeof text, BEGIN FIVE "#6=%s('',2,(#1,#2,#3,#4,#5),.UNSPECIFIED.,.F.,.F.);\n" END,
                 cases[i].name);
        bat_model m = read(text);
        assert_int_equal(m.curve_count, 1);
        assert_int_equal(bat_curve_knot_count(m.curves[0]), 8);
        for (int k = 0; k < 8; k++) assert_true(bat_curve_knots(m.curves[0])[k] == cases[i].knots[k]);
        bat_model_clear(&m);
    }
}

/* A face: its surface is read whole, the curves of its edge, in space and in its parameters, are not. */
static void a_face(void **state) {
    (void)state;
    bat_model m = read(
        BEGIN LINE CURVE
        "#4=CARTESIAN_POINT('',(0.,2.,0.));#5=CARTESIAN_POINT('',(1.,0.,0.));\n"
        "#6=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#4),(#5,#2)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),"
        "(0.,1.),(0.,3.),.UNSPECIFIED.);\n"
        "#7=CARTESIAN_POINT('',(0.,0.));#8=CARTESIAN_POINT('',(1.,1.));\n"
        "#9=B_SPLINE_CURVE_WITH_KNOTS('',1,(#7,#8),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.);\n"
        "#10=DEFINITIONAL_REPRESENTATION('',(#9),#99);#11=PCURVE('',#6,#10);\n"
        "#12=SURFACE_CURVE('',#3,(#11),.PCURVE_S1.);#13=EDGE_CURVE('',#14,#14,#12,.T.);\n"
        "#14=VERTEX_POINT('',#1);#15=ORIENTED_EDGE('',*,*,#13,.T.);#16=EDGE_LOOP('',(#15));\n"
        "#17=FACE_BOUND('',#16,.T.);#18=ADVANCED_FACE('',(#17),#6,.T.);#19=SPHERICAL_SURFACE('',#20,2.);\n"
        "#21=PRODUCT('B_SPLINE_CURVE(','; #3=',$,());\n" END);
    double found[3];
    assert_true(m.surface_count == 1 && m.curve_count == 0);
    bat_surface_eval(m.surfaces[0], 1, 0, 0, found); /* the list of rows runs along u */
    assert_true(found[0] == 1 && found[1] == 0);
    assert_int_equal(m.left_out, 2); /* the trim of the face, the sphere */
    bat_model_clear(&m);
}

static void refusals(void **state) {
    (void)state;
    static const struct {
        const char *text;
        bat_status status;
        const char *place, *says;
    } cases[] = {
        {"", BAT_SYNTAX, "line 1", "ISO-10303-21"},
        {"solid\n", BAT_SYNTAX, "line 1", "ISO-10303-21"},
        {BEGIN END, BAT_COUNT, "", "found none"},
        {BEGIN LINE, BAT_SYNTAX, "line 8", "ENDSEC"},
        {BEGIN "#1 CARTESIAN_POINT('',(0.,0.,0.));" END, BAT_SYNTAX, "line 6", "="},
        {BEGIN "#1=CARTESIAN_POINT('',(0.,0.,0.);\n" END, BAT_SYNTAX, "line 6", "as many"},
        {BEGIN "#1=CARTESIAN_POINT('(0.,0.,0.);\n" END, BAT_SYNTAX, "line 6", "semicolon"},
        {BEGIN LINE LINE CURVE END, BAT_SYNTAX, "line 8", "twice"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#4),.U.,.F.,.F.," KNOTS END, BAT_SYNTAX, "line 8",
         "CARTESIAN_POINT"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3),.U.,.F.,.F.," KNOTS END, BAT_SYNTAX, "line 8",
         "CARTESIAN_POINT"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',8,(#1,#2),.U.,.F.,.F.," KNOTS END, BAT_DEGREE, "line 8",
         "degree"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',2,(#1,#2),.U.,.F.,.F.," KNOTS END, BAT_DEGREE, "line 8",
         "more points"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.U.,.F.,.F.,(2,3),(0.,1.),.U.);\n" END,
         BAT_KNOTS, "line 8", "knots"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.U.,.F.,.F.,(2,2),(1.,0.),.U.);\n" END,
         BAT_KNOTS, "line 8", "knots"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.U.,.F.,.F.,(2,2),(0.,1.);\n" END, BAT_SYNTAX,
         "line 8", ")"},
        {BEGIN LINE "#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,*),.U.,.F.,.F.," KNOTS END, BAT_SYNTAX, "line 8",
         "a point"},
        {BEGIN LINE "#3=(B_SPLINE_CURVE(1,(#1,#2),.U.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.,1.),.U.)\n"
                    "RATIONAL_B_SPLINE_CURVE((1.,0.)));\n" END,
         BAT_NUMBER, "line 8", "weights"},
        {BEGIN "#1=CARTESIAN_POINT('',(0.,1.E80,0.));\n#2=CARTESIAN_POINT('',(0.,0.,0.));\n" CURVE END,
         BAT_NUMBER, "line 6", "1e75"},
        {BEGIN "#1=CARTESIAN_POINT('',(0.,0.,0.,0.));\n#2=CARTESIAN_POINT('',(0.,0.,0.));\n" CURVE END,
         BAT_SYNTAX, "line 6", "coordinates"},
        {BEGIN LINE CURVE "#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
                          "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"
                          "#12=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#10))X(3));\n#13=(GLOBAL_UNIT_ASSIGNED_CONTEXT("
                          "(#11))X(3));\n" END,
         BAT_UNSUPPORTED, "line 10", "one unit"},
        {BEGIN LINE CURVE "#10=(CONVERSION_BASED_UNIT('',#10)LENGTH_UNIT()NAMED_UNIT(*));\n"
                          "#12=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#10))X(3));\n" END,
         BAT_UNSUPPORTED, "line 9", "unit of length"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_model model;
        bat_problem problem = {.place = ""};
        const bat_status status = bat_step_read(cases[i].text, strlen(cases[i].text), &model, &problem);
        if (status != cases[i].status || strcmp(problem.place, cases[i].place) != 0)
            print_message("%zu: %s: %s\n", i, problem.place, problem.message);
        assert_int_equal(status, cases[i].status);
        assert_string_equal(problem.place, cases[i].place);
        assert_non_null(strstr(problem.message, cases[i].says));
    }
    bat_model model;
    const bat_model empty = {.mesh = NULL};
    char *bytes;
    size_t size;
    assert_int_equal(bat_step_read(NULL, 0, &model, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_step_read("x", 1, NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_step_write(&empty, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_step_write(NULL, &bytes, &size), BAT_ARGUMENT);
}

static void each_allocation(void **state) {
    (void)state;
    static const char text[] = BEGIN LINE CURVE
        "#4=CARTESIAN_POINT('',(0.,2.,0.));#5=CARTESIAN_POINT('',(1.,0.,0.));\n"
        "#6=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#4),(#5,#2)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),"
        "(0.,1.),(0.,3.),.UNSPECIFIED.);\n#7=(B_SPLINE_CURVE(1,(#1,#2),.U.,.F.,.F.)BEZIER_CURVE()"
        "RATIONAL_B_SPLINE_CURVE((1.,1.)));\n" END;
    bat_model whole = read(text);
    assert_true(whole.curve_count == 2 && whole.surface_count == 1);
    for (int write = 0; write < 2; write++) {
        const long before = alloc_live();
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_model model = {.mesh = NULL};
            char *bytes = NULL;
            size_t size;
            alloc_fail_at(n);
            const bat_status status = write ? bat_step_write(&whole, &bytes, &size)
                                            : bat_step_read(text, strlen(text), &model, NULL);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_true(model.surface_count + model.curve_count == 0 && !bytes);
            bat_model_clear(&model);
            bat_free(bytes);
            assert_int_equal(alloc_live(), before);
        }
    }
    bat_model_clear(&whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_and_back), cmocka_unit_test(any_order),
                                       cmocka_unit_test(units),          cmocka_unit_test(implied_knots),
                                       cmocka_unit_test(a_face),         cmocka_unit_test(refusals),
                                       cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
