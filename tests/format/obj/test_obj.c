/* OBJ: what is written is read back bit for bit; files of other programs are read; whatever is not a curve is reported.
 * */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/curve.h>
#include <batten/document.h>
#include <batten/mesh.h>

#include "support/random_curve.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static bat_status read(const char *text, bat_document **out, bat_svg_report *report, bat_problem *problem) {
    bat_reading how = {.xml = NULL};
    const bat_format *format = NULL;
    return bat_formats_read(&how, text, strlen(text), &format, out, report, problem);
}

static void there_and_back(void **unused) {
    (void)unused;
    random_source random = {7};
    const bat_format *obj = bat_format_named("OBJ");
    assert_non_null(obj);
    for (int run = 0; run < 300; run++) {
        bat_curve *copy, *curve = random_curve(&random, 1 + run % 7, 2 + run / 7 % 2, run / 14 % 3, run % 30);
        bat_document *document = NULL, *back = NULL;
        bat_object *object = NULL;
        bat_style style = bat_style_defaults();
        char *text;
        size_t size;
        bat_svg_report report;
        bat_problem problem = {.place = ""};
        assert_int_equal(bat_curve_copy(curve, &copy), BAT_OK);
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(
            bat_object_create_path(1, run % 2 ? "a name" : "a\nname \\", &style, 1, &copy, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        assert_int_equal(obj->write(document, &text, &size, &problem), BAT_OK);
        assert_int_equal(read(text, &back, &report, &problem), BAT_OK);
        assert_int_equal(bat_document_count(back), 1);
        assert_string_equal(bat_object_name(bat_document_at(back, 0)), run % 2 ? "a name" : "a name /");
        assert_true(bat_curve_is_equal(bat_object_curve(bat_document_at(back, 0), 0), curve));
        assert_int_equal(bat_losses_total(&report.lost), 0);
        bat_free(text);
        bat_document_free(document);
        bat_document_free(back);
        bat_curve_free(curve);
    }
}

/* As the format's specification writes a curve, with a line that goes on, numbers from the end, and faces beside it. */
static void from_others(void **unused) {
    (void)unused;
    static const char text[] =
        "# a curve\r\nv -2.3 1.9 0 1.0\r\nv -2.2 0.7 0\r\nv 1.0 0.5 0\r\nv 2.0 1.0 0\r\n"
        "g edge \r\ncstype rat bspline\r\ndeg 3\r\ncurv 0.25 1.0 -4 -3 \\\r\n -2 -1\r\n"
        "parm u 0 0 0 0 \\\r\n 1 1 1 1\r\nend\r\nf 1 2 3\r\n";
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    assert_int_equal(read(text, &document, &report, &problem), BAT_OK);
    const bat_object *object = bat_document_at(document, 0);
    const bat_curve *curve = bat_object_curve(object, 0);
    double domain[2], at[3];
    bat_curve_domain(curve, domain);
    assert_string_equal(bat_object_name(object), "edge");
    assert_int_equal(bat_curve_dimension(curve), 2);
    assert_true(domain[0] == 0.25 && domain[1] == 1);
    bat_curve_eval(curve, 1, 0, at);
    assert_true(at[0] == 2 && at[1] == -1); /* y of a page runs down */
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN], 0);
    const bat_polymesh *mesh = bat_object_mesh(bat_document_at(document, 1));
    assert_true(bat_document_count(document) == 2 && bat_polymesh_face_count(mesh) == 1);
    assert_true(bat_polymesh_vertices(mesh)[0] == -2.3);
    bat_document_free(document);
}

/* Bit for bit, in the order of the file: isolated vertices, an edge with three faces, two meshes after each other. */
static void meshes_are_kept(void **unused) {
    (void)unused;
    static const char text[] =
        "v 0.1 0.2 0.3\nv 1 0 0\nv 0 1 0\nv 0 -1 0.30000000000000004\nv 0 0 1\nv 9 9 9\n"
        "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2 3\n";
    bat_document *document = NULL, *again = NULL;
    bat_svg_report report;
    bat_problem problem;
    char *out = NULL;
    size_t size = 0;
    assert_int_equal(read(text, &document, &report, &problem), BAT_OK);
    const bat_polymesh *mesh = bat_object_mesh(bat_document_at(document, 0));
    assert_int_equal(bat_polymesh_vertex_count(mesh), 6);
    assert_int_equal(bat_polymesh_face_count(mesh), 4);
    assert_true(bat_polymesh_vertices(mesh)[10] == 1); /* up is y in the file, down on the page */
    assert_true(bat_polymesh_vertices(mesh)[11] == -0.30000000000000004);
    assert_null(bat_document_check(document));
    assert_int_equal(bat_format_named("OBJ")->write(document, &out, &size, &problem), BAT_OK);
    char *ended = calloc(size + 1, 1);
    memcpy(ended, out, size);
    assert_int_equal(read(ended, &again, &report, &problem), BAT_OK);
    assert_true(bat_polymesh_is_equal(mesh, bat_object_mesh(bat_document_at(again, 0))));
    free(ended);
    bat_free(out);
    bat_document_free(document), bat_document_free(again);
}

/* As the table of docs/format.md says: from a wall (x, -y, -z), from a floor (x, -z, y). */
static void up_is_y(void **unused) {
    (void)unused;
    static const double axes[2][6] = {{1, 0, 0, 0, 1, 0}, {1, 0, 0, 0, 0, -1}}, at[3] = {2, 3, 5};
    for (int floor = 0; floor < 2; floor++) {
        const bat_style style = bat_style_defaults();
        bat_document *document = NULL;
        bat_object *objects[2];
        bat_polymesh *point = NULL;
        bat_problem problem;
        char *text = NULL;
        size_t size;
        assert_int_equal(bat_polymesh_create(1, at, 0, NULL, NULL, &point, NULL), BAT_OK);
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_object_create_mesh(1, "", &style, point, &objects[0]), BAT_OK);
        assert_int_equal(bat_object_create_plane(2, "", at, axes[floor], &objects[1]), BAT_OK);
        for (int i = 0; i < 2; i++) {
            assert_int_equal(bat_document_insert(document, i, objects[i]), BAT_OK);
            bat_object_release(objects[i]);
        }
        assert_int_equal(bat_format_named("OBJ")->write(document, &text, &size, &problem), BAT_OK);
        const char *wanted = floor ? "v 2 -5 3\n" : "v 2 -3 -5\n";
        assert_memory_equal(text, wanted, strlen(wanted));
        bat_free(text), bat_polymesh_free(point), bat_document_free(document);
    }
}

static void refusals(void **unused) {
    (void)unused;
    static const struct {
        const char *text, *place;
        bat_status status;
    } cases[] = {
        {"v 1 2\n", "line 1", BAT_SYNTAX},
        {"# nothing\no name\n", "", BAT_UNSUPPORTED},
        {"cstype bspline\ndeg 9\n", "line 2", BAT_DEGREE},
        {"v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 1\ncurv 0 1 1 3\n", "line 5", BAT_SYNTAX},
        {"v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1\nend\n", "line 7", BAT_KNOTS},
        {"v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 0\nend\n", "line 7", BAT_KNOTS},
        {"v 0 0 0\nv 1 0 0 0\ncstype rat bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n", "line 7",
         BAT_NUMBER},
        {"v nan 0 0\n", "line 1", BAT_SYNTAX},
        {"v 0 0 0\nv 1e999 0 0\n", "line 2", BAT_NUMBER},
        {"v 0 0 0\nv 1 0 0\nf 1 2 -3\n", "line 3", BAT_SYNTAX},
        {"v 0 0 0\nv 1 0 0\nf 1//1 2/1 3/1/1\n", "line 3", BAT_SYNTAX},
        {"v 0 0 0\nf 0 1 1\n", "line 2", BAT_SYNTAX},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\n"
         "parm v 0 0 1\nend\n",
         "line 10", BAT_KNOTS},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\ncstype bspline\ndeg 1 1\nsurf 0 .5 0 1 1 2 3 4\nparm u 0 0 1 "
         "1\n"
         "parm v 0 0 1 1\nend\n",
         "line 10", BAT_UNSUPPORTED},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0 -2\nv 1 1 1\ncstype rat bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 "
         "0 1 "
         "1\nparm v 0 0 1 1\nend\n",
         "line 10", BAT_NUMBER},
        {"surf 0 1 0\n", "line 1", BAT_SYNTAX}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = NULL;
        bat_svg_report report;
        bat_problem problem = {.place = ""};
        assert_int_equal(read(cases[i].text, &document, &report, &problem), cases[i].status);
        assert_null(document);
        assert_string_equal(problem.place, cases[i].place);
        assert_true(problem.message[0]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_and_back), cmocka_unit_test(from_others),
                                       cmocka_unit_test(meshes_are_kept), cmocka_unit_test(up_is_y),
                                       cmocka_unit_test(refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
