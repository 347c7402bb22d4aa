/* Every call on views survives the failure of any one of its allocations: BAT_MEMORY, nothing leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/view.h>
#include "support/alloc_fail.h"
#include "support/random_surface.h"

static const bat_viewpoint view = {.eye = {0, -40, 5}, .up = {0, 0, 1}, .size = {100, 100}, .fov = 40};
static const double pixels[] = {50, 50, 52, 51, 55, 53};
static const bat_stroke stroke = {.dimension = 2, .count = 3, .points = pixels};
static bat_surface *sheet, *flat;
static bat_curve *line;

static bat_status on_ruled(void) {
    const bat_canvas canvas = {.curve = line, .along = {1, 0, 0}};
    bat_cast_point out[3];
    return bat_cast(&view, &stroke, &canvas, out, NULL);
}
static bat_status on_surface(void) {
    const bat_canvas canvas = {.surface = sheet};
    bat_cast_point out[3];
    return bat_cast(&view, &stroke, &canvas, out, NULL);
}
static bat_status pick(void) {
    bat_surface_pick out;
    return bat_surface_pick_line(&view, &stroke, sheet, &out);
}
static bat_status sketch_line(void) {
    enum { COUNT = 40 };
    double places[2 * COUNT];
    for (int i = 0; i < COUNT; i++)
        places[2 * i] = 300 + 10 * i, places[2 * i + 1] = 500 - 0.1 * (400 - (i - 20) * (i - 20));
    const bat_viewpoint above = {.eye = {0, -4, 9}, .up = {0, 1, 0}, .size = {1000, 1000}, .height = 10};
    const bat_stroke drawn = {.dimension = 2, .count = COUNT, .points = places};
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    options.tolerance = 0.02;
    bat_surface *out = NULL;
    const bat_status status = bat_surface_sketch(flat, BAT_V, 0.5, &above, &drawn, &options, &out, NULL,
                                                 NULL);
    bat_surface_free(out);
    return status;
}
static bat_status write_view(void) {
    char *text = NULL;
    size_t size;
    const bat_status status = bat_viewpoint_write(&view, &text, &size);
    bat_free(text);
    return status;
}
static bat_status read_view(void) {
    static const char text[] = "{\"eye\":[0,0,1],\"target\":[0,0],\"up\":[0,1],\"size\":[8,6],\"height\":1}";
    bat_viewpoint out;
    return bat_viewpoint_read(text, sizeof text - 1, &out, NULL);
}
static bat_status read_canvas(void) {
    static const char text[] =
        "{\"curve\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]},\"along\":[0,0,1]}";
    bat_canvas out = {.curve = NULL};
    const bat_status status = bat_canvas_read(text, sizeof text - 1, &out, NULL);
    bat_canvas_clear(&out);
    return status;
}

static void each_allocation(void **state) {
    (void)state;
    static bat_status (*const operations[])(void) = {on_ruled,   on_surface, pick,       sketch_line,
                                                     write_view, read_view,  read_canvas};
    random_source r = {3};
    sheet = random_surface(&r, (const int[2]){3, 2}, (const int[2]){2, 1}, (const int[2]){5, 4});
    const double square[] = {-5, -2, 0, -5, 2, 0, 5, -2, 0, 5, 2, 0}, ends[] = {0, 0, 1, 1};
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, square, (const int[2]){4, 4}, ends, ends,
                                        &flat),
                     BAT_OK);
    line = random_curve(&r, 3, 2, 0, 4);
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        const long before = alloc_live();
        for (long n = 1;; n++) {
            alloc_fail_at(n);
            const bat_status status = operations[i]();
            const bool reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_int_equal(alloc_live(), before);
            if (!reached) {
                assert_true(n > 1);
                break;
            }
        }
    }
    bat_curve_free(line);
    bat_surface_free(sheet), bat_surface_free(flat);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
