/* Rectangles, circles and ellipses are elements of SVG and stay shapes; parts of ellipses, and polygons, are paths that are shapes as long as
 * nobody else has changed them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "kinds/primitive.h"
#include "support/svg_kept.h"
#include <batten/format.h>

#include <math.h>

static const char FIVE[] =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 200'>\n"
    " <rect id='a' x='10' y='20' width='50' height='30' rx='5' fill='#f00'/>\n"
    " <g transform='rotate(30)'><rect id='b' x='80' y='20' width='50' height='30'/></g>\n"
    " <circle id='c' cx='150' cy='50' r='20'/><ellipse id='d' cx='100' cy='150' rx='40' ry='20'/>\n"
    " <rect id='e' width='30' height='30' transform='skewX(20)'/>\n</svg>\n";

static bat_document *opened(const char *text) {
    bat_document *document = NULL;
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, NULL), BAT_OK);
    assert_null(bat_document_check(document));
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

static int index_of(const bat_document *document, const char *name) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (strcmp(bat_object_name(bat_document_at(document, i)), name) == 0) return i;
    return -1;
}

static const bat_primitive *shape_of(const bat_document *document, const char *name) {
    return bat_object_primitive(bat_document_at(document, index_of(document, name)));
}

static void become(bat_document *document, const char *name, const bat_primitive *p) {
    bat_object *made = NULL;
    const int index = index_of(document, name);
    assert_int_equal(bat_object_with_primitive(bat_document_at(document, index), p, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

static void elements_are_shapes(void **state) {
    (void)state;
    bat_document *document = opened(FIVE);
    double value;
    assert_true(bat_primitive_get(shape_of(document, "a"), BAT_PRIMITIVE_RADIUS, &value) && value == 5);
    assert_int_equal(shape_of(document, "b")->kind, BAT_RECTANGLE);
    assert_true(fabs(hypot(shape_of(document, "b")->place[0], shape_of(document, "b")->place[1]) - 50) <
                1e-12);
    assert_int_equal(shape_of(document, "c")->kind, BAT_ELLIPSE);
    assert_int_equal(shape_of(document, "d")->kind, BAT_ELLIPSE);
    assert_null(shape_of(document, "e")); /* it is skewed */
    bat_document_free(document);
}

/* Other corners are one attribute of one element, and nothing beside. */
static void an_edit_is_an_attribute(void **state) {
    (void)state;
    bat_document *document = opened(FIVE);
    bat_primitive p = *shape_of(document, "a");
    assert_true(bat_primitive_set(&p, BAT_PRIMITIVE_RADIUS, 8));
    become(document, "a", &p);
    p = *shape_of(document, "c");
    assert_true(bat_primitive_map(&p, (double[]){1, 0, 0, 1, 4, 0}, &p));
    become(document, "c", &p);
    char *text = written(document, false), expected[sizeof FIVE];
    memcpy(expected, FIVE, sizeof FIVE);
    strstr(expected, "rx='5'")[4] = '8';
    strstr(expected, "cx='150'")[6] = '4';
    for (char *at = text; (at = strchr(at, '"'));) *at = '\'';
    assert_string_equal(text, expected);
    free(text);
    text = written(document, true);
    bat_document *again = opened(text);
    assert_true(bat_document_digest(again) == bat_document_digest(document));
    assert_null(strstr(text, "\"primitive\"")); /* it comes back from its numbers */
    bat_document_free(again);
    bat_document_free(document);
    free(text);
}

static bat_document *three(void) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_set_page(document, (double[]){0, 0, 300, 300}), BAT_OK);
    bat_style style = bat_style_defaults();
    style.filled = true;
    bat_primitive shapes[] = {bat_primitive_rectangle((double[]){10, 20, 60, 50}, 7),
                              bat_primitive_rectangle((double[]){100, 20, 160, 50}, 0),
                              bat_primitive_ellipse((double[]){10, 100, 60, 150}),
                              bat_primitive_ellipse((double[]){100, 100, 200, 150}),
                              bat_primitive_polygon((double[]){50, 220}, (double[]){90, 220}, 5)};
    const double turn[6] = {0.8, 0.6, -0.6, 0.8, 40, 3};
    assert_true(bat_primitive_map(&shapes[1], turn, &shapes[1]));
    shapes[3].sweep = 120;
    shapes[4].depth = 0.5;
    static const char *const names[] = {"r", "t", "c", "pie", "star"};
    for (int i = 0; i < 5; i++) {
        bat_object *made = NULL;
        assert_int_equal(bat_object_create_primitive((bat_id)i + 1, names[i], &style, &shapes[i], &made),
                         BAT_OK);
        assert_int_equal(bat_document_insert(document, i, made), BAT_OK);
        bat_object_release(made);
    }
    return document;
}

/* All come back bit for bit; without our data those that SVG has. What another program has changed is what it made of it. */
static void written_and_read(void **state) {
    (void)state;
    bat_document *document = three();
    char *text = written(document, true);
    assert_non_null(strstr(text, "<rect id=\"r\""));
    assert_non_null(strstr(text, "x=\"10\" y=\"20\" width=\"50\" height=\"30\" rx=\"7\"/>"));
    assert_non_null(strstr(text, "<rect id=\"t\" transform=\"matrix("));
    assert_non_null(strstr(text, "<circle id=\"c\""));
    assert_non_null(strstr(text, "cx=\"35\" cy=\"125\" r=\"25\"/>"));
    assert_non_null(strstr(text, "<path id=\"pie\""));
    bat_document *again = opened(text);
    assert_true(bat_document_digest(again) == bat_document_digest(document));
    bat_document_free(again);
    char *d = strstr(strstr(text, "id=\"star\""), " d=\"M");
    d[5] = '1'; /* another place */
    again = opened(text);
    assert_non_null(shape_of(again, "r"));
    assert_null(shape_of(again, "star"));
    bat_document_free(again);
    free(text);
    text = written(document, false);
    again = opened(text);
    for (int k = 0; k < 6; k++) {
        assert_true(fabs(shape_of(again, "r")->place[k] - shape_of(document, "r")->place[k]) < 1e-12);
        assert_true(fabs(shape_of(again, "t")->place[k] - shape_of(document, "t")->place[k]) < 1e-2);
        assert_true(fabs(shape_of(again, "c")->place[k] - shape_of(document, "c")->place[k]) < 1e-12);
    }
    assert_null(shape_of(again, "star"));
    bat_document_free(again);
    free(text);
    bat_document_free(document);
}

/* In a file that is kept: a star beside it comes back as one, and is a path if its element was changed. */
static void a_star_in_a_kept_file(void **state) {
    (void)state;
    bat_document *document = opened(FIVE), *from = three();
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_id(bat_document_at(from, 4), 50, &made), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), made), BAT_OK);
    bat_object_release(made);
    char *text = written(document, true);
    bat_document *again = opened(text);
    assert_true(bat_document_digest(again) == bat_document_digest(document));
    bat_document_free(again);
    char *d = strstr(strstr(text, "data-name=\"star\""), "d=\"M");
    d[4] = '1';
    again = opened(text);
    assert_non_null(shape_of(again, "a"));
    assert_null(shape_of(again, "star"));
    bat_document_free(again);
    free(text);
    bat_document_free(document);
    bat_document_free(from);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elements_are_shapes),
        cmocka_unit_test(an_edit_is_an_attribute),
        cmocka_unit_test(written_and_read),
        cmocka_unit_test(a_star_in_a_kept_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
