/* DXF: what is written is read back bit for bit; arcs, bulges, blocks, extrusions, units, colours and layers are where closed
 * forms say; what is broken is refused with its line. */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/document.h>

#include "support/random_curve.h"
#include "support/rounds.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static bat_svg_report report;
static bat_problem problem;

static bat_status try(const char *text, bat_document **out) {
    const bat_reading how = {.xml = NULL};
    const bat_format *format = bat_format_named("dxf");
    *out = NULL;
    problem = (bat_problem){"", ""};
    return bat_formats_read(&how, text, strlen(text), &format, out, &report, &problem);
}

/* Reads a file whose entities section holds this. */
static bat_document *entities(const char *before, const char *text) {
    static char file[8000];
    bat_document *document;
    snprintf(file, sizeof file, "%s0\nSECTION\n2\nENTITIES\n%s0\nENDSEC\n0\nEOF\n", before, text);
    if (try(file, &document) != BAT_OK) fail_msg("%s: %s", problem.place, problem.message);
    assert_null(bat_document_check(document));
    return document;
}

static const bat_curve *curve_at(const bat_document *document, int index) {
    const bat_curve *curve = bat_object_curve(bat_document_at(document, index), 0);
    assert_non_null(curve);
    return curve;
}

/* ---- there and back ---- */

static void there_and_back(void **unused) {
    (void)unused;
    random_source random = {11};
    const bat_format *dxf = bat_format_named("dxf");
    for (int run = 0; run < ROUNDS_OF(300); run++) {
        bat_curve *copy, *curve = random_curve(&random, 1 + run % 7, 2 + run / 7 % 2, run / 14 % 3, run % 30);
        bat_document *document = NULL, *back = NULL;
        bat_object *layer = NULL, *made = NULL, *object = NULL;
        bat_style style = bat_style_defaults();
        char *text;
        size_t size;
        style.stroke = 0x12AB9EFF;
        style.width = 0.35;
        assert_int_equal(bat_curve_copy(curve, &copy), BAT_OK);
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_MM), BAT_OK);
        assert_int_equal(bat_object_create_group(1,
                                                 "Gr\xC3\xB6\xC3\x9F"
                                                 "e",
                                                 true, &layer),
                         BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, layer), BAT_OK);
        assert_int_equal(bat_object_create_path(2, "", &style, 1, &copy, &made), BAT_OK);
        assert_int_equal(bat_object_with_parent(made, 1, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 1, object), BAT_OK);
        bat_object_release(layer), bat_object_release(made), bat_object_release(object);
        assert_int_equal(dxf->write(document, &text, &size, &problem), BAT_OK);
        assert_int_equal(try(text, &back), BAT_OK);
        assert_int_equal(bat_document_count(back), 2);
        const bat_object *read = bat_document_at(back, 1);
        assert_string_equal(bat_object_name(bat_document_at(back, 0)), "Gr\xC3\xB6\xC3\x9F"
                                                                       "e");
        assert_true(bat_object_style(read)->stroke == 0x12AB9EFF && bat_object_style(read)->width == 0.35);
        const bat_curve *other = bat_object_curve(read, 0);
        if (run / 14 % 3 > 0 && bat_curve_degree(curve) > 1) { /* clamped, and closed again */
            double away, back_away;
            assert_int_equal(bat_curve_is_closed(other), bat_curve_is_closed(curve));
            assert_int_equal(bat_curve_distance(curve, other, 8, &away, &back_away), BAT_OK);
            assert_true(away <= 1e-9 * bat_curve_size(curve) && back_away <= 1e-9 * bat_curve_size(curve));
            bat_free(text);
            bat_document_free(document), bat_document_free(back);
            bat_curve_free(curve);
            continue;
        }
        const size_t numbers = bat_curve_count(curve) * (size_t)bat_curve_dimension(curve);
        assert_int_equal(bat_curve_degree(other), bat_curve_degree(curve));
        assert_int_equal(bat_curve_count(other), bat_curve_count(curve));
        assert_int_equal(bat_curve_is_closed(other), bat_curve_is_closed(curve));
        for (size_t i = 0; i < numbers; i++)
            assert_true(bat_curve_points(other)[i] == bat_curve_points(curve)[i]);
        for (int i = 0; i < bat_curve_knot_count(curve) && bat_curve_degree(curve) > 1; i++)
            assert_true(bat_curve_knots(other)[i] == bat_curve_knots(curve)[i]);
        assert_int_equal(bat_losses_total(&report.lost), 0);
        bat_free(text);
        bat_document_free(document), bat_document_free(back);
        bat_curve_free(curve);
    }
}

/* As arcs no point is further from the curve than the tolerance, in either direction. */
static void arcs_are_near(void **unused) {
    (void)unused;
    random_source random = {5};
    for (int run = 0; run < ROUNDS_OF(40); run++) {
        bat_curve *copy, *curve = random_curve(&random, 2 + run % 3, 2, run % 3, 3 + run % 6);
        bat_document *document = NULL, *back = NULL;
        bat_object *object = NULL;
        const bat_style style = bat_style_defaults();
        const double tolerance = 1e-3 * bat_curve_size(curve);
        char *text;
        size_t size;
        double away, back_away;
        assert_int_equal(bat_curve_copy(curve, &copy), BAT_OK);
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_MM), BAT_OK);
        assert_int_equal(bat_object_create_path(1, "", &style, 1, &copy, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        assert_int_equal(bat_dxf_write(document, tolerance, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "LWPOLYLINE"));
        assert_null(strstr(text, "SPLINE\n  5"));
        assert_int_equal(try(text, &back), BAT_OK);
        assert_int_equal(bat_curve_distance(curve, curve_at(back, 0), 32, &away, &back_away), BAT_OK);
        if (!(away <= 1.01 * tolerance && back_away <= 1.01 * tolerance))
            fail_msg("run %d: %g and %g, tolerance %g", run, away, back_away, tolerance);
        bat_free(text);
        bat_document_free(document), bat_document_free(back);
        bat_curve_free(curve);
    }
}

/* ---- closed forms ---- */

/* Every point of the curve is at the radius from the centre; the length is the arc's. */
static void is_arc(const bat_curve *curve, double x, double y, double radius, double angle) {
    double domain[2], at[3];
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 100; i++) {
        bat_curve_eval(curve, domain[0] + i / 100.0 * (domain[1] - domain[0]), 0, at);
        const double off = hypot(at[0] - x, at[1] - y) - radius;
        if (!(fabs(off) <= 1e-6 * radius)) fail_msg("off by %g of %g", off, radius);
    }
    const double length = bat_curve_length(curve, domain[0], domain[1], 1e-9);
    if (!(fabs(length - radius * angle) <= 1e-6 * radius * angle))
        fail_msg("length %.9g, wanted %.9g", length, radius * angle);
}

static void starts_at(const bat_curve *curve, double x, double y) {
    double domain[2], at[3];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, at);
    if (!(hypot(at[0] - x, at[1] - y) < 1e-9 * (1 + hypot(x, y))))
        fail_msg("starts at %.9g %.9g, wanted %.9g %.9g", at[0], at[1], x, y);
}

static const double PI = 3.14159265358979323846;

static void arcs_and_circles(void **unused) {
    (void)unused;
    bat_document *document = entities(
        "", "0\nCIRCLE\n10\n3\n20\n4\n40\n2\n0\nARC\n10\n3\n20\n4\n40\n2\n50\n350\n51\n80\n"
            "0\nARC\n10\n3\n20\n4\n40\n2\n50\n0\n51\n90\n210\n0\n220\n0\n230\n-1\n"
            "0\nELLIPSE\n10\n0\n20\n0\n11\n0\n21\n5\n40\n1\n41\n0\n42\n1.5\n");
    is_arc(curve_at(document, 0), 3, -4, 2, 2 * PI);
    assert_true(bat_curve_is_closed(curve_at(document, 0)));
    is_arc(curve_at(document, 1), 3, -4, 2, PI / 2);
    starts_at(curve_at(document, 1), 3 + 2 * cos(PI / 18), -4 + 2 * sin(PI / 18));
    is_arc(curve_at(document, 2), -3, -4, 2, PI / 2); /* seen from behind: x is turned round */
    starts_at(curve_at(document, 2), -5, -4);
    is_arc(curve_at(document, 3), 0, 0, 5, 1.5);
    starts_at(curve_at(document, 3), 0, -5);
    bat_document_free(document);
}

static void bulges(void **unused) {
    (void)unused;
    /* Two half circles; a quarter circle and back by lines; one that ends where it began, and is closed. */
    bat_document *document = entities(
        "", "0\nLWPOLYLINE\n90\n2\n70\n1\n10\n0\n20\n0\n42\n1\n10\n4\n20\n0\n42\n1\n"
            "0\nPOLYLINE\n66\n1\n70\n0\n0\nVERTEX\n10\n1\n20\n0\n42\n0."
            "41421356237309503\n0\nVERTEX\n10\n0\n20\n1\n0\nSEQEND\n"
            "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n3\n10\n0\n20\n0\n");
    is_arc(curve_at(document, 0), 2, 0, 2, 2 * PI);
    is_arc(curve_at(document, 1), 0, 0, 1, PI / 2);
    starts_at(curve_at(document, 1), 1, 0);
    assert_int_equal(bat_curve_degree(curve_at(document, 2)), 1);
    assert_int_equal(bat_curve_count(curve_at(document, 2)), 3);
    assert_true(bat_curve_is_closed(curve_at(document, 2)));
    bat_document_free(document);
}

/* A weighted quadratic is a quarter circle; nine points make a whole one, closed. */
static void weights(void **unused) {
    (void)unused;
    bat_document *document = entities(
        "",
        "0\nSPLINE\n70\n4\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n41\n1\n41\n0."
        "70710678118654757\n41\n1\n"
        "10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n"
        "0\nSPLINE\n70\n5\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n2\n40\n2\n40\n3\n40\n3\n40\n4\n40\n4"
        "\n40\n4\n"
        "41\n1\n41\n.70710678118654757\n41\n1\n41\n.70710678118654757\n41\n1\n41\n.70710678118654757\n41\n1\n"
        "41\n.70710678118654757\n41\n1\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n10\n-1\n20\n1\n10\n-"
        "1\n20\n0\n10\n-1\n20\n-1\n"
        "10\n0\n20\n-1\n10\n1\n20\n-1\n10\n1\n20\n0\n");
    is_arc(curve_at(document, 0), 0, 0, 1, PI / 2);
    is_arc(curve_at(document, 1), 0, 0, 1, 2 * PI);
    assert_true(bat_curve_is_closed(curve_at(document, 1)));
    bat_document_free(document);
}

/* A block with its base at (1, 0), twice in a row, scaled, turned and mirrored; and a block in a block. */
static void blocks(void **unused) {
    (void)unused;
    static const char defined[] =
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n10\n1\n20\n0\n0\nCIRCLE\n8\n0\n10\n2\n20\n0\n40\n1\n0\nENDBLK"
        "\n"
        "0\nBLOCK\n2\nouter\n10\n0\n20\n0\n0\nINSERT\n2\nb\n10\n5\n20\n0\n0\nENDBLK\n0\nENDSEC\n";
    bat_document *document = entities(
        defined, "0\nINSERT\n8\nparts\n2\nb\n10\n10\n20\n20\n41\n3\n42\n-3\n50\n90\n70\n2\n44\n7\n62\n1\n"
                 "0\nINSERT\n2\nouter\n10\n100\n20\n0\n0\nINSERT\n2\nnowhere\n");
    assert_int_equal(bat_document_count(document), 5); /* layers parts and 0, and three circles */
    assert_string_equal(bat_object_name(bat_document_at(document, 0)), "parts");
    is_arc(curve_at(document, 1), 10, -23, 3, 2 * PI);
    is_arc(curve_at(document, 2), 10, -30, 3, 2 * PI);
    is_arc(curve_at(document, 4), 106, 0, 1, 2 * PI);
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN], 1);
    bat_document_free(document);
}

/* A block so small and so far away that its line has both ends in one place: nothing is left of it, which is said. */
static void what_is_placed_in_one_point(void **unused) {
    (void)unused;
    static const char defined[] = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n10\n0\n20\n0\n0\nLINE\n10\n0\n20\n0"
                                  "\n11\n1\n21\n0\n0\nENDBLK\n0\nENDSEC\n";
    bat_document *document = entities(
        defined, "0\nINSERT\n2\nb\n10\n50\n20\n50\n41\n1e-20\n0\nINSERT\n2\nb\n10\n50\n20\n50\n41\n1e-10\n");
    assert_int_equal(bat_document_count(document), 1); /* what is not too small, on no layer */
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN], 1);
    bat_document_free(document);
}

static void units_and_colours(void **unused) {
    (void)unused;
    static const char before[] = "999\na "
                                 "comment\n0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n9\n$"
                                 "X\n40\n2\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\n"
                                 "LAYER\n0\nLAYER\n2\ncut\n70\n4\n62\n-3\n370\n50\n0\nENDTAB\n0\nENDSEC\n";
    bat_document *document = entities(
        before,
        "0\nLINE\n8\ncut\n10\n0\n20\n0\n11\n1\n21\n2\n0\nLINE\n8\ncut\n62\n0\n420\n1193046\n10\n0\n20\n0\n11"
        "\n1\n21\n2\n"
        "0\nLINE\n8\nother\n62\n30\n60\n1\n10\n0\n20\n0\n11\n1\n21\n2\n31\n1\n0\nTEXT\n1\nhi\n0\nHATCH\n");
    const bat_object *cut = bat_document_at(document, 0), *line = bat_document_at(document, 1);
    assert_true(bat_object_is_hidden(cut) && bat_object_is_locked(cut));
    assert_true(bat_object_parent(line) == bat_object_id(cut));
    assert_true(bat_object_style(line)->stroke == 0x00FF00FF && bat_object_style(line)->width == 0.5);
    assert_true(bat_curve_points(curve_at(document, 1))[2] == 25.4 &&
                bat_curve_points(curve_at(document, 1))[3] == -50.8);
    assert_true(bat_object_style(bat_document_at(document, 2))->stroke == 0x123456FF);
    const bat_object *other = bat_document_at(document, 4);
    assert_true(bat_object_style(other)->stroke == 0xFF7F00FF && bat_object_is_hidden(other));
    assert_int_equal(bat_curve_dimension(bat_object_curve(other, 0)), 3);
    assert_true(bat_curve_points(bat_object_curve(other, 0))[5] == -25.4);
    assert_true(report.lost.count[BAT_LOSS_TEXT] == 1 && report.lost.count[BAT_LOSS_UNKNOWN] == 1);
    bat_document_free(document);
}

/* Through points; knots that a file leaves out; a closed spline whose ends are clamped; a layer's name in Latin-1 and by number. */
static void splines_of_others(void **unused) {
    (void)unused;
    bat_document *document = entities(
        "", "0\nSPLINE\n8\nGr\\U+00F6\xDF"
            "e\n70\n0\n71\n3\n74\n3\n11\n0\n21\n0\n11\n5\n21\n5\n11\n9\n21\n0\n"
            "0\nSPLINE\n8\nGr\\U+00F6\xDF"
            "e\n71\n2\n10\n0\n20\n0\n10\n4\n20\n4\n10\n8\n20\n0\n10\n9\n20\n9\n"
            "0\nSPLINE\n8\nGr\\U+00F6\xDF"
            "e\n70\n1\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n2\n40\n2\n40\n2\n40\n2\n10\n0\n20\n0\n"
            "10\n0\n20\n4\n10\n4\n20\n4\n10\n4\n20\n0\n10\n0\n20\n0\n0\nSPLINE\n71\n9\n10\n0\n");
    assert_string_equal(bat_object_name(bat_document_at(document, 0)), "Gr\xC3\xB6\xC3\x9F"
                                                                       "e");
    double at[3];
    bat_curve_eval(curve_at(document, 1), bat_curve_knots(curve_at(document, 1))[4], 0, at);
    assert_true(hypot(at[0] - 5, at[1] + 5) < 1e-12);
    assert_int_equal(bat_curve_degree(curve_at(document, 2)), 2);
    assert_true(bat_curve_is_closed(curve_at(document, 3)));
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN], 1);
    bat_document_free(document);
}

static void refusals(void **unused) {
    (void)unused;
    static const char *const bad[][2] = {
        {"0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n0\nENDSEC\n", "line 8"},
        {"0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n1e99\n0\nENDSEC\n", "line 8"},
        {"0\nSECTION\n2\nENTITIES\nzero\nLINE\n", "line 5"},
        {"0\nSECTION\n2\nENTITIES\n0", "line 5"},
        {"0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n", "line 8"},
        {"0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\n0\n0\nENDSEC\n", "line 6"},
        {"0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\n3\n10\n0\n0\nENDSEC\n", "line 6"},
        {"0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\n1\n10\n0\n10\n1\n40\n0\n0\nENDSEC\n", "line 6"},
        {"0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\n1\n10\n0\n10\n1\n41\n1\n0\nENDSEC\n", "line 6"},
        {"0\nSECTION\n2\nENTITIES\n0\nSPLINE\n0\nENDSEC\n", "line 6"},
        {"AutoCAD Binary DXF\r\n\x1A", ""},
        {"0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", ""},
        {"0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n1\n20\n1\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n", ""},
        /* a block that is in itself, sixteen times at every level */
        {"0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n0\nINSERT\n2\nb\n70\n99\n71\n99\n0\nLINE\n11\n1\n0\nENDBLK\n"
         "0\nENDSEC\n"
         "0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nb\n0\nENDSEC\n0\nEOF\n",
         ""},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bat_document *document;
        assert_int_not_equal(try(bad[i][0], &document), BAT_OK);
        assert_null(document);
        if (strcmp(problem.place, bad[i][1]) != 0 || !problem.message[0])
            fail_msg("%zu: %s: %s", i, problem.place, problem.message);
    }
}

static void nothing_to_write(void **unused) {
    (void)unused;
    bat_document *document = NULL;
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_dxf_write(document, 0, &text, &size), BAT_COUNT);
    assert_int_equal(bat_dxf_write(document, -1, &text, &size), BAT_ARGUMENT);
    assert_int_equal(bat_dxf_write(document, NAN, &text, &size), BAT_ARGUMENT);
    assert_int_equal(bat_dxf_write(NULL, 0, &text, &size), BAT_ARGUMENT);
    assert_null(text);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back),
        cmocka_unit_test(arcs_are_near),
        cmocka_unit_test(arcs_and_circles),
        cmocka_unit_test(bulges),
        cmocka_unit_test(weights),
        cmocka_unit_test(blocks),
        cmocka_unit_test(what_is_placed_in_one_point),
        cmocka_unit_test(units_and_colours),
        cmocka_unit_test(splines_of_others),
        cmocka_unit_test(refusals),
        cmocka_unit_test(nothing_to_write),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
