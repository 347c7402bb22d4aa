/* Surfaces as objects: their curves are their lines at the knots and cannot be replaced; they move with the page, and
 * are read from both formats bit for bit. */
#include "document/document.h"
#include "editor/edit/affine.h"

#include <batten/format.h>
#include <batten/nearest.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/alloc_fail.h"
#include "support/objects.h"
#include "support/pen.h"
#include "support/random_surface.h"
#include "support/xml.h"

static bat_object *object_of(const bat_surface *surface) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_surface(4, "sheet", &style, surface, &object), BAT_OK);
    return object;
}

static bat_surface *sheet(int u_extra, int v_extra) {
    random_source r = {9};
    return random_surface(&r, (const int[2]){3, 2}, (const int[2]){0, 2}, (const int[2]){u_extra, v_extra});
}

/* Inner knots of a direction that differ. */
static int inner_knots(const bat_surface *surface, bat_direction direction) {
    const double *knots = bat_surface_knots(surface, direction);
    double domain[2];
    int count = 0;
    bat_surface_domain(surface, direction, domain);
    for (int i = 1; i < bat_surface_knot_count(surface, direction); i++)
        count += knots[i] > knots[i - 1] && knots[i] > domain[0] && knots[i] < domain[1];
    return count;
}

static void its_curves_are_its_lines(void **state) {
    (void)state;
    random_source r = {5};
    for (int number = 0; number < 63; number++) {
        bat_surface *surface = some_surface(&r, number);
        bat_object *object = object_of(surface);
        int lines = 0;
        for (int d = 0; d < 2; d++)
            lines += inner_knots(surface, (bat_direction)d) + 2 -
                     bat_surface_is_closed(surface, (bat_direction)d);
        assert_int_equal(bat_object_curve_count(object), lines);
        assert_true(bat_surface_is_equal(bat_object_surface(object), surface));
        assert_null(bat_object_check(object));
        double box[4];
        bat_object_bounds(object, box);
        for (int i = 0; i < lines; i++) { /* each lies on the surface, and in the box */
            const bat_curve *line = bat_object_curve(object, i);
            double at[3], domain[2];
            bat_surface_point near;
            bat_curve_domain(line, domain);
            bat_curve_eval(line, random_between(&r, domain[0], domain[1]), 0, at);
            if (i % 5 == 0) {
                assert_int_equal(bat_surface_nearest(surface, at, &near), BAT_OK);
                assert_true(near.distance <= 1e-9 * bat_surface_size(surface));
            }
            assert_true(at[0] >= box[0] && at[0] <= box[2] && at[1] >= box[1] && at[1] <= box[3]);
        }
        bat_object_release(object);
        bat_surface_free(surface);
    }
}

/* A band of degree (2, 1) with x = u, over [0, 1], with as many inner knots in u as asked for. */
static bat_surface *band(int inner) {
    enum { MOST = 1003 };
    static double knots[MOST + 3], points[MOST * 6];
    const int count = inner + 3;
    assert_true(count <= MOST);
    for (int i = 0; i < count + 3; i++) knots[i] = fmin(fmax((i - 2) / (inner + 1.0), 0), 1);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < 2; j++) {
            double *p = points + 6 * i + 3 * j;
            p[0] = (knots[i + 1] + knots[i + 2]) / 2, p[1] = j, p[2] = 0;
        }
    bat_surface *surface = NULL;
    assert_int_equal(bat_surface_create((const int[2]){2, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){(size_t)count, 2}, points,
                                        (const int[2]){count + 3, 4}, knots, (const double[4]){0, 0, 1, 1},
                                        &surface),
                     BAT_OK);
    return surface;
}

/* 65 lines in each direction at most: both ends, and inner knots that lie evenly among all of them. */
static void a_fine_surface_shows_some_of_its_lines(void **state) {
    (void)state;
    static const int inners[] = {0, 1, 2, 61, 62, 63, 64, 65, 66, 127, 200, 1000};
    for (size_t k = 0; k < sizeof inners / sizeof *inners; k++) {
        const int inner = inners[k], lines = inner < 63 ? inner + 2 : 65;
        bat_surface *surface = band(inner);
        bat_object *object = object_of(surface);
        assert_int_equal(bat_object_curve_count(object), lines + 2);
        assert_null(bat_object_check(object));
        double last = 0;
        for (int i = 0; i < lines; i++) {
            const double x = bat_curve_points(bat_object_curve(object, i))[0], knot = x * (inner + 1);
            assert_true(fabs(knot - nearbyint(knot)) < 1e-9);
            assert_true(i == 0 ? fabs(x) < 1e-12 : x > last && x - last <= 2.0 / (lines - 1));
            last = x;
        }
        assert_true(fabs(last - 1) < 1e-12);
        bat_object_release(object);
        bat_surface_free(surface);
    }
}

static void its_curves_stay(void **state) {
    (void)state;
    bat_surface *surface = sheet(3, 3);
    bat_object *object = object_of(surface), *out = NULL;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_copy(bat_object_curve(object, 0), &curve), BAT_OK);
    assert_int_equal(bat_object_with_curve(object, 0, curve, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_copy(bat_object_curve(object, 0), &curve), BAT_OK);
    assert_int_equal(bat_object_with_curves(object, 1, &curve, &out), BAT_ARGUMENT);
    bat_shape *shape = NULL;
    bat_curve *flat = pen_curve(0, 0, 30, 20, 20);
    assert_int_equal(bat_shape_decompose(flat, 2, NULL, &shape), BAT_OK);
    assert_int_equal(bat_object_with_shape(object, 0, shape, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_to_path(object, &out), BAT_ARGUMENT);
    assert_null(out);
    bat_curve_free(flat);
    bat_object_release(object);
    bat_surface_free(surface);
}

static void refusals(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    bat_style wrong = style;
    wrong.width = NAN;
    bat_surface *surface = sheet(0, 0);
    bat_object *out = NULL, *guide = NULL;
    assert_int_equal(bat_object_create_surface(1, "", &style, NULL, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_surface(1, "", NULL, surface, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_surface(1, "", &wrong, surface, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_surface(0, "", &style, surface, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_surface(1, "\xff", &style, surface, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_surface(1, "", &style, surface, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_guide(3, 0, 1, &guide), BAT_OK);
    assert_int_equal(bat_object_with_surface(guide, surface, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_surface(NULL, surface, &out), BAT_ARGUMENT);
    assert_null(bat_object_surface(guide));
    assert_null(out);
    bat_object_release(guide);
    bat_surface_free(surface);
}

static void moves_with_the_page(void **state) {
    (void)state;
    const double turn[6] = {0, 2, -2, 0, 10, 20};
    bat_surface *surface = sheet(2, 3);
    bat_object *object = object_of(surface), *moved = NULL;
    assert_int_equal(bat_affine_object(object, turn, true, &moved), BAT_OK);
    const bat_surface *image = bat_object_surface(moved);
    assert_true(bat_object_style(moved)->width == 2 * bat_object_style(object)->width);
    for (int i = 0; i < (int)bat_surface_count(surface, BAT_U); i++) {
        const double *p = bat_surface_row(surface, i), *q = bat_surface_row(image, i);
        for (size_t j = 0; j < bat_surface_count(surface, BAT_V); j++, p += 3, q += 3) {
            assert_true(fabs(q[0] - (10 - 2 * p[1])) < 1e-12 && fabs(q[1] - (20 + 2 * p[0])) < 1e-12);
            assert_true(q[2] == p[2]);
        }
    }
    assert_null(bat_object_check(moved));
    bat_object_release(moved);
    assert_int_equal(bat_affine_object(object, (const double[6]){1e300, 0, 0, 1, 0, 0}, true, &moved),
                     BAT_NUMBER);
    bat_object *other = NULL;
    bat_surface *next = sheet(4, 1);
    assert_int_equal(bat_object_with_surface(object, next, &other), BAT_OK);
    assert_true(bat_surface_is_equal(bat_object_surface(other), next));
    assert_int_equal(bat_object_id(other), 4);
    bat_object_release(other);
    bat_surface_free(next);
    bat_object_release(object);
    bat_surface_free(surface);
}

/* Files that hold one are of version 2, and no others. */
static void files(void **state) {
    (void)state;
    random_source r = {21};
    for (int number = 0; number < 20; number++) {
        bat_surface *surface = some_surface(&r, number);
        bat_document *document = of_one(object_of(surface)), *back = NULL;
        for (int svg = 0; svg < 2; svg++) {
            bat_svg_report report;
            bat_problem problem;
            char *text;
            size_t size;
            assert_int_equal(svg ? bat_svg_write(document, true, &text, &size)
                                 : bat_document_write(document, &text, &size),
                             BAT_OK);
            assert_non_null(strstr(text, svg ? "{&quot;batten&quot;:2," : "{\"batten\":2,"));
            assert_int_equal(svg ? xml_read(text, NULL, &back, &report, &problem)
                                 : bat_document_read(text, size, &back, &problem),
                             BAT_OK);
            assert_true(bat_surface_is_equal(bat_object_surface(bat_document_at(back, 0)), surface));
            assert_true(bat_document_digest(back) == bat_document_digest(document));
            bat_document_free(back);
            bat_free(text);
        }
        bat_document_free(document);
        bat_surface_free(surface);
    }
    object_refused("{\"id\":1,\"kind\":\"surface\"}");
    object_refused("{\"id\":1,\"kind\":\"surface\",\"surface\":3}");
    object_refused("{\"id\":1,\"kind\":\"surface\",\"surface\":{\"degree\":[1,1],\"knots\":[[0,0,1,1],"
                   "[0,0,1,1]],\"points\":[[[1,1,1],[1,1,1]],[[1,1,1],[1,1,1]]]}}");
    static const char later[] = "{\"batten\":1000,\"objects\":[]}";
    bat_document *none = NULL;
    bat_problem problem;
    assert_int_equal(bat_document_read(later, sizeof later - 1, &none, &problem), BAT_UNSUPPORTED);
    bat_curve *curve = pen_curve(0, 0, 30, 20, 20);
    bat_object *path = NULL;
    const bat_style style = bat_style_defaults();
    assert_int_equal(bat_object_create_path(1, "", &style, 1, &curve, &path), BAT_OK);
    bat_document *plain = of_one(path);
    char *text;
    size_t size;
    assert_int_equal(bat_document_write(plain, &text, &size), BAT_OK);
    assert_non_null(strstr(text, "{\"batten\":1,"));
    bat_free(text);
    bat_document_free(plain);
}

static bat_status make(int way, const bat_object *object, bat_object **out) {
    const bat_style style = bat_style_defaults();
    const bat_surface *surface = bat_object_surface(object);
    if (way == 0) return bat_object_create_surface(4, "sheet", &style, surface, out);
    if (way == 1) return bat_object_with_surface(object, surface, out);
    return bat_affine_object(object, (const double[6]){0, 2, -2, 0, 10, 20}, true, out);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_surface *surface = sheet(2, 2);
    bat_object *object = object_of(surface);
    for (int way = 0; way < 3; way++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            const long before = alloc_live();
            bat_object *out = NULL;
            alloc_fail_at(n);
            const bat_status status = make(way, object, &out);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_true(reached == !out);
            if (out) assert_null(bat_object_check(out));
            bat_object_release(out);
            assert_int_equal(alloc_live(), before);
        }
    }
    bat_object_release(object);
    bat_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(its_curves_are_its_lines), cmocka_unit_test(a_fine_surface_shows_some_of_its_lines),
        cmocka_unit_test(its_curves_stay),          cmocka_unit_test(refusals),
        cmocka_unit_test(moves_with_the_page),      cmocka_unit_test(files),
        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
