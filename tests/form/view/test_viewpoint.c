/* Views: closed forms, the ray of a pixel leads back to it, what is refused; VIEW and ON as JSON. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include "support/views.h"

static const double origin[3] = {0, 0, 0};

/* From (0, 0, 10) down, y up: the window is 8 x 6 pixels. */
static bat_viewpoint from_above(double fov, double height) {
    return (bat_viewpoint){.eye = {0, 0, 10}, .up = {0, 1, 0}, .size = {8, 6}, .fov = fov, .height = height};
}

static void closed_forms(void **state) {
    (void)state;
    double from[3], way[3], pixel[2], depth;
    bat_viewpoint view = from_above(0, 3); /* half a unit a pixel */
    assert_int_equal(bat_viewpoint_ray(&view, (const double[2]){0, 0}, from, way), BAT_OK);
    const double corner[3] = {-2, 1.5, 10}, down[3] = {0, 0, -1};
    for (int c = 0; c < 3; c++)
        assert_true(fabs(from[c] - corner[c]) < 1e-15 && fabs(way[c] - down[c]) < 1e-15);
    assert_int_equal(bat_viewpoint_project(&view, (const double[3]){1, -1, 4}, pixel, &depth), BAT_OK);
    assert_true(pixel[0] == 6 && pixel[1] == 5 && depth == 6);
    view = from_above(90, 0); /* at depth 1 the window is 2 units high, 3 pixels a unit */
    assert_int_equal(bat_viewpoint_project(&view, (const double[3]){5, 5, 5}, pixel, &depth), BAT_OK);
    assert_true(fabs(pixel[0] - 7) < 1e-14 && fabs(pixel[1] - 0) < 1e-14 && depth == 5);
    assert_int_equal(bat_viewpoint_ray(&view, (const double[2]){7, 3}, from, way), BAT_OK);
    assert_true(from[2] == 10 && fabs(way[0] - sqrt(0.5)) < 1e-15 && fabs(way[2] + sqrt(0.5)) < 1e-15);
    assert_int_equal(bat_viewpoint_project(&view, (const double[3]){0, 0, 10}, pixel, NULL), BAT_FAR);
}

static void rays_lead_back(void **state) {
    (void)state;
    random_source r = {5};
    for (int number = 0; number < 200; number++) {
        const bat_viewpoint view = some_view(&r, number, origin, 100);
        double pixel[2], back[2], from[3], way[3], point[3], depth;
        for (int d = 0; d < 2; d++) pixel[d] = random_between(&r, -0.2, 1.2) * view.size[d];
        assert_int_equal(bat_viewpoint_ray(&view, pixel, from, way), BAT_OK);
        assert_true(fabs(way[0] * way[0] + way[1] * way[1] + way[2] * way[2] - 1) < 1e-14);
        const double far = random_between(&r, 1, 300);
        for (int c = 0; c < 3; c++) point[c] = from[c] + far * way[c];
        assert_int_equal(bat_viewpoint_project(&view, point, back, &depth), BAT_OK);
        assert_true(fabs(back[0] - pixel[0]) < 1e-9 && fabs(back[1] - pixel[1]) < 1e-9 && depth > 0);
        /* the middle of the window is where the target is; up is up */
        assert_int_equal(bat_viewpoint_project(&view, view.target, back, NULL), BAT_OK);
        for (int d = 0; d < 2; d++) assert_true(fabs(back[d] - view.size[d] / 2) < 1e-9);
        for (int c = 0; c < 3; c++) point[c] = view.target[c] + 0.01 * view.up[c];
        assert_int_equal(bat_viewpoint_project(&view, point, back, NULL), BAT_OK);
        assert_true(back[1] < view.size[1] / 2 && fabs(back[0] - view.size[0] / 2) < 1e-9);
    }
}

static void bad_views(void **state) {
    (void)state;
    const struct {
        bat_viewpoint view;
        bat_status status;
    } cases[] = {
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .fov = 40, .height = 1}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .fov = 180}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .height = -1}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 0}, .height = 1}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .height = 1e-300}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 0, 2}, .size = {8, 6}, .height = 1}, BAT_SINGULAR},
        {{.up = {0, 0, 2}, .size = {8, 6}, .height = 1}, BAT_SINGULAR},
        {{.eye = {0, 0, 1}, .size = {8, 6}, .height = 1}, BAT_SINGULAR},
        {{.eye = {0, NAN, 1}, .up = {0, 1, 0}, .size = {8, 6}, .height = 1}, BAT_NUMBER},
        {{.eye = {0, 0, 1}, .up = {0, 1, INFINITY}, .size = {8, 6}, .height = 1}, BAT_NUMBER},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .fov = NAN}, BAT_NUMBER},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .height = NAN}, BAT_NUMBER},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, INFINITY}, .height = 1}, BAT_NUMBER},
        {{.eye = {0, 0, 1}, .target = {1e300, 0, 0}, .up = {0, 1, 0}, .size = {8, 6}, .height = 1},
         BAT_NUMBER},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 6}, .fov = -1}, BAT_ARGUMENT},
        {{.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {8, 1e-9}, .height = 1e70}, BAT_ARGUMENT},
    };
    double a[3], b[3], pixel[2] = {7, 7};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(bat_viewpoint_check(&cases[i].view, NULL), cases[i].status);
        assert_int_equal(bat_viewpoint_project(&cases[i].view, origin, pixel, NULL), cases[i].status);
        assert_int_equal(bat_viewpoint_ray(&cases[i].view, pixel, a, b), cases[i].status);
    }
    const bat_viewpoint good = from_above(0, 3);
    assert_int_equal(bat_viewpoint_ray(&good, (const double[2]){NAN, 0}, a, b), BAT_NUMBER);
    assert_int_equal(bat_viewpoint_project(&good, (const double[3]){0, INFINITY, 0}, pixel, NULL),
                     BAT_NUMBER);
    assert_int_equal(bat_viewpoint_check(NULL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_viewpoint_ray(&good, NULL, a, b), BAT_ARGUMENT);
    assert_int_equal(bat_viewpoint_ray(&good, pixel, NULL, b), BAT_ARGUMENT);
    assert_int_equal(bat_viewpoint_ray(&good, pixel, a, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_viewpoint_project(&good, NULL, pixel, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_viewpoint_project(&good, origin, NULL, NULL), BAT_ARGUMENT);
    assert_true(pixel[0] == 7 && pixel[1] == 7);
}

static void json_round_trip(void **state) {
    (void)state;
    random_source r = {6};
    for (int number = 0; number < 20; number++) {
        const bat_viewpoint view = some_view(&r, number, origin, 10);
        bat_viewpoint again;
        char *text;
        size_t size;
        assert_int_equal(bat_viewpoint_write(&view, &text, &size), BAT_OK);
        assert_int_equal(bat_viewpoint_read(text, size, &again, NULL), BAT_OK);
        assert_memory_equal(&view, &again, sizeof view);
        bat_free(text);
    }
    bat_viewpoint bad = from_above(0, 0);
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_viewpoint_write(&bad, &text, &size), BAT_ARGUMENT);
    assert_null(text);
}

static void bad_json(void **state) {
    (void)state;
    static const char *const views[][2] = {
        {"[]", "view: expected an object, found a list"},
        {"{\"target\":[0,0,0]}", "eye: expected 2 or 3 numbers, found none"},
        {"{\"eye\":[1],\"target\":[0,0,0]}", "eye: expected 2 or 3 numbers, found a list"},
        {"{\"eye\":[0,0,1e80],\"target\":[0,0,0]}", "eye: expected numbers up to 1e75, found a list"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8],\"fov\":40}",
         "size: expected width and height, in pixels, found a list"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,6]}",
         "fov: expected fov or height, found neither"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,6],\"fov\":40,\"height\":3}",
         "fov: expected either fov or height, found both"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,6],\"fov\":200}",
         "fov: expected an angle between 0 and 180 degrees, found number 200"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,6],\"height\":0}",
         "height: expected a length above 0, found number 0"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,-6],\"height\":1}",
         "size: expected width and height above 0, found others"},
        {"{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,0,1],\"size\":[8,6],\"height\":1}",
         "up: expected a direction at an angle to the gaze, found one along it, or no gaze"},
    };
    static const char *const canvases[][2] = {
        {"{}", "canvas: expected a curve with \"along\", a plane, or a surface, found none"},
        {"{\"plane\":{\"normal\":[0,0,1]}}", "origin: expected 2 or 3 numbers, found none"},
        {"{\"plane\":{\"origin\":[0,0],\"normal\":[0,0,0]}}",
         "normal: expected a direction other than 0, found a list"},
        {"{\"curve\":{}}", "along: expected 2 or 3 numbers, found none"},
        {"{\"points\":[]}", "degree: expected two degrees, of u and v, found none"},
    };
    bat_problem problem;
    bat_viewpoint view;
    bat_canvas canvas;
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        assert_int_not_equal(bat_viewpoint_read(views[i][0], strlen(views[i][0]), &view, &problem), BAT_OK);
        assert_string_equal(problem.message, views[i][1]);
    }
    for (size_t i = 0; i < sizeof canvases / sizeof *canvases; i++) {
        assert_int_not_equal(bat_canvas_read(canvases[i][0], strlen(canvases[i][0]), &canvas, &problem),
                             BAT_OK);
        assert_string_equal(problem.message, canvases[i][1]);
    }
    static const char plane[] = "{\"plane\":{\"origin\":[1,2],\"normal\":[0,0,3]}}";
    assert_int_equal(bat_canvas_read(plane, sizeof plane - 1, &canvas, NULL), BAT_OK);
    assert_true(canvas.origin[1] == 2 && canvas.normal[2] == 3 && !canvas.curve && !canvas.surface);
    bat_canvas_clear(&canvas);
    bat_canvas_clear(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),    cmocka_unit_test(rays_lead_back), cmocka_unit_test(bad_views),
        cmocka_unit_test(json_round_trip), cmocka_unit_test(bad_json),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
