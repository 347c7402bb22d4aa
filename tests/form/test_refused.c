/* Whatever is checked before something is made of it says what is wrong with it: the place, what was expected and what was found. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/check.h>
#include <batten/mesh.h>
#include <batten/motion.h>
#include <batten/paint.h>
#include <batten/recipe.h>
#include <batten/view.h>
#include <batten/width.h>

typedef bat_status check(double value, bat_problem *problem);

static bat_status width(double value, bat_problem *problem) {
    const bat_width_stop stops[] = {{0, 1}, {0.5, value}, {1, 1}};
    return bat_width_check(&(bat_width_profile){3, stops}, problem);
}

static bat_status order(double value, bat_problem *problem) {
    const bat_width_stop stops[] = {{0, 1}, {0.5, 1}, {value, 1}};
    return bat_width_check(&(bat_width_profile){3, stops}, problem);
}

static bat_status function(double value, bat_problem *problem) {
    const bat_function given = bat_function_of(value);
    return bat_function_check(&given, problem);
}

static bat_status view_size(double value, bat_problem *problem) {
    const bat_viewpoint view = {.eye = {0, 0, 1}, .up = {0, 1, 0}, .size = {100, value}, .fov = 40};
    return bat_viewpoint_check(&view, problem);
}

static bat_status view_up(double value, bat_problem *problem) {
    const bat_viewpoint view = {.eye = {0, 0, 1}, .up = {0, value, 1}, .size = {100, 100}, .fov = 40};
    return bat_viewpoint_check(&view, problem);
}

static bat_status recipe(double value, bat_problem *problem) {
    bat_recipe made = bat_recipe_of(BAT_RECIPE_REVOLVE);
    made.angle = value;
    return bat_recipe_check(&made, 2, problem);
}

static bat_status recipe_count(double value, bat_problem *problem) {
    const bat_recipe made = bat_recipe_of(BAT_RECIPE_COONS);
    return bat_recipe_check(&made, (size_t)value, problem);
}

static bat_status style(double value, bat_problem *problem) {
    bat_style made = bat_style_defaults();
    made.opacity = value;
    return bat_style_check(&made, problem);
}

static bat_status object(double value, bat_problem *problem) {
    bat_style made = bat_style_defaults();
    made.width = value;
    return bat_object_head_check(1, "a", &made, problem);
}

static bat_status id(double value, bat_problem *problem) {
    return bat_object_head_check((bat_id)value, NULL, NULL, problem);
}

static bat_paint painted(const double dashes[2]) {
    return (bat_paint){.pen = {1, 0, 0, 1}, .dash_count = 2, .dashes = dashes};
}

static bat_status dashes(double value, bat_problem *problem) {
    const bat_paint paint = painted((const double[2]){1, value});
    return bat_paint_check(&paint, problem);
}

static bat_status gradient(double value, bat_problem *problem) {
    const bat_stop stops[] = {{0, 0}, {value, 0}};
    bat_paint paint = painted((const double[2]){1, 1});
    paint.fill = (bat_gradient){.to = {1, 0, 0}, .matrix = {1, 0, 0, 1, 0, 0}, .count = 2, .stops = stops};
    return bat_paint_check(&paint, problem);
}

static bat_status picture(double value, bat_problem *problem) {
    return value == 1 ? BAT_OK : bat_picture_check("GIF89a", 6, problem);
}

static bat_status face(double value, bat_problem *problem) {
    const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int sizes[] = {3, 3}, corners[] = {0, 1, 2, 0, (int)value, 2};
    return bat_polymesh_check(3, vertices, 2, sizes, corners, problem);
}

static bat_status vertex(double value, bat_problem *problem) {
    const double vertices[] = {0, 0, 0, 1, value, 0, 0, 1, 0};
    return bat_polymesh_check(3, vertices, 0, NULL, NULL, problem);
}

static bat_status joint(double value, bat_problem *problem) {
    const bat_bone bones[] = {{.name = "a", .parent = -1}, {.name = "b", .parent = (int)value}};
    return bat_take_check(2, bones, 1, 1, NULL, problem);
}

static bat_status seconds(double value, bat_problem *problem) {
    const bat_bone bone = {.name = "a", .parent = -1};
    return bat_take_check(1, &bone, 1, value, NULL, problem);
}

static bat_status clamped(double value, bat_problem *problem) {
    const double points[] = {0, 0, 1, 1, value, 2};
    return bat_curve_clamped_check(2, 2, 3, points, problem);
}

static const struct {
    check *check;
    double right, wrong;
    bat_status status;
    const char *place, *message;
} cases[] = {
    {width, 1, -1, BAT_NUMBER, "stops[1].share", "expected 0 to "},
    {order, 1, 0.5, BAT_NUMBER, "stops[2].at", "expected more than at the stop before, found 0.5"},
    {function, 1, NAN, BAT_NUMBER, "constant", "expected -1e75 to 1e75, found no number"},
    {view_size, 1, 0, BAT_ARGUMENT, "size[1]", "expected more than 0, found 0"},
    {view_up, 1, 0, BAT_SINGULAR, "up", "expected a target other than the eye"},
    {recipe, 90, 0, BAT_NUMBER, "angle", "expected an angle other than 0, found 0"},
    {recipe_count, 4, 3, BAT_COUNT, "count", "expected 4, found 3"},
    {style, 1, 1.5, BAT_ARGUMENT, "opacity", "expected 0 to 1, found 1.5"},
    {object, 0, -1, BAT_ARGUMENT, "style.width", "expected 0 to 1e75, found -1"},
    {id, 1, 0, BAT_ARGUMENT, "id", "expected 1 to 2147483647, found 0"},
    {dashes, 1, -1, BAT_NUMBER, "dashes[1]", "expected 0 to 1e75, found -1"},
    {gradient, 1, 2, BAT_NUMBER, "fill.stops[1].at", "expected 0 to 1, found 2"},
    {picture, 1, 0, BAT_UNSUPPORTED, "bytes", "expected the head of a PNG"},
    {face, 1, 3, BAT_PARAMETER, "faces[1]", "expected numbers of vertices, found 3"},
    {vertex, 1, INFINITY, BAT_NUMBER, "vertices[1][1]", "expected -1e75 to 1e75, found "},
    {joint, 0, 1, BAT_ARGUMENT, "joints[1].parent", "expected 0, found 1"},
    {seconds, 1, 0, BAT_ARGUMENT, "frame_time", "expected more than 0, found 0"},
    {clamped, 1, 1e80, BAT_NUMBER, "points[2][0]", "expected a number up to 1e75, found 1e80"},
};

static void each_says_where_and_why(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_problem problem = {"", ""};
        assert_int_equal(cases[i].check(cases[i].right, &problem), BAT_OK);
        assert_string_equal(problem.message, "");
        assert_int_equal(cases[i].check(cases[i].wrong, &problem), cases[i].status);
        assert_string_equal(problem.place, cases[i].place);
        assert_ptr_equal(strstr(problem.message, cases[i].message), problem.message);
        assert_int_equal(cases[i].check(cases[i].wrong, NULL), cases[i].status);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_says_where_and_why)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
