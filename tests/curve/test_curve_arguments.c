/* Arguments out of their range, call by call, where test_arguments does not try them: curves in space, frames, fits,
 * mirrors, splines, what a stroke means, strokes that become one, and values as text. A status, and nothing made. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "curve/mirror.h"
#include "hands/sketch/converge.h"
#include "hands/sketch/intent.h"
#include "support/pen.h"
#include "support/random_surface.h"
#include <batten/batten.h>
#include <batten/fit.h>

static bat_curve *out; /* of every call that makes one: stays NULL */

static void refused(bat_status wanted, bat_status status, const char *call, int line) {
    if (status != wanted) fail_msg("line %d: %s: %s", line, call, bat_status_message(status));
    if (out) fail_msg("line %d: %s gave something", line, call);
}

#define REFUSED(wanted, call) refused(wanted, call, #call, __LINE__)
#define ARGUMENT(call) REFUSED(BAT_ARGUMENT, call)

static bat_curve *in_space(void) {
    const double points[] = {0, 0, 0, 10, 5, 1, 20, 0, 2, 30, 5, 3};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &curve), BAT_OK);
    return curve;
}

static void of_curves(void **state) {
    (void)state;
    bat_curve *open = pen_curve(0, 0, 10, 5, 7), *space = in_space(), *left = NULL;
    const double path[] = {0, 0, 1, 1, 2, 1, 3, 0, 4, 1, 5, 1, 6, 0}, delta[] = {1, 1}, before[] = {-9};
    double gap[2], domain[2], *points = NULL;
    int count;
    ARGUMENT(bat_curve_join(NULL, open, 0, 1, &out, NULL));
    ARGUMENT(bat_curve_join(open, NULL, 0, 1, &out, NULL));
    ARGUMENT(bat_curve_join(open, open, 0, 1, NULL, NULL));
    ARGUMENT(bat_curve_join(open, open, -1, 1, &out, NULL));
    ARGUMENT(bat_curve_join(open, open, 3, 1, &out, NULL));
    ARGUMENT(bat_curve_join(open, open, 0, NAN, &out, NULL));
    ARGUMENT(bat_curve_distance(NULL, open, 4, gap, gap));
    ARGUMENT(bat_curve_distance(open, NULL, 4, gap, gap));
    ARGUMENT(bat_curve_distance(open, open, 4, NULL, gap));
    ARGUMENT(bat_curve_distance(open, open, 4, gap, NULL));
    ARGUMENT(bat_curve_distance(open, open, 0, gap, gap));
    ARGUMENT(bat_curve_distance(open, open, (1 << 20) + 1, gap, gap));
    REFUSED(BAT_DIMENSION, bat_curve_distance(open, space, 4, gap, gap));
    bat_curve *quintic = NULL;
    assert_int_equal(bat_curve_elevate(open, 5, &quintic), BAT_OK);
    ARGUMENT(bat_curve_to_cubics(quintic, 0, &count, &points));
    ARGUMENT(bat_curve_to_cubics(quintic, NAN, &count, &points));
    assert_null(points);
    bat_curve_free(quintic);
    REFUSED(BAT_DEGREE, bat_curve_from_bezier(2, 0, false, 2, path, 0.1, 0, &out, NULL));
    REFUSED(BAT_DEGREE, bat_curve_from_bezier(2, 9, false, 2, path, 0.1, 0, &out, NULL));
    REFUSED(BAT_DIMENSION, bat_curve_from_bezier(1, 3, false, 2, path, 0.1, 0, &out, NULL));
    REFUSED(BAT_DIMENSION, bat_curve_from_bezier(4, 3, false, 2, path, 0.1, 0, &out, NULL));
    REFUSED(BAT_COUNT, bat_curve_from_bezier(2, 3, false, 0, path, 0.1, 0, &out, NULL));
    REFUSED(BAT_COUNT, bat_curve_from_bezier(2, 3, false, BAT_POINTS_MAX, path, 0.1, 0, &out, NULL));
    bat_curve_domain(open, domain);
    REFUSED(BAT_PARAMETER, bat_curve_drag(open, 1, before, delta, &out));
    REFUSED(BAT_PARAMETER, bat_curve_drag(open, 1, (double[]){domain[1] + 1}, delta, &out));
    REFUSED(BAT_PARAMETER, bat_curve_piece(open, -9, domain[1], &out));
    REFUSED(BAT_PARAMETER, bat_curve_piece(open, domain[0], domain[1] + 9, &out));
    REFUSED(BAT_PARAMETER, bat_curve_split(open, domain[0], &left, &out));
    REFUSED(BAT_PARAMETER, bat_curve_split(open, domain[1], &left, &out));
    REFUSED(BAT_PARAMETER, bat_curve_remove_knot(open, -9, 1, 1, &out, NULL, NULL));
    REFUSED(BAT_PARAMETER, bat_curve_remove_knot(open, 99, 1, 1, &out, NULL, NULL));
    REFUSED(BAT_KNOTS, bat_curve_insert_knot(open, domain[0] + 0.5, BAT_DEGREE_MAX + 2, &out));
    assert_null(left);
    bat_curve_free(open);
    bat_curve_free(space);
}

static void of_frames_and_fits(void **state) {
    (void)state;
    bat_curve *space = in_space();
    bat_frame_chain *chain = NULL;
    bat_frame3 frame;
    const double u[] = {0.5}, points[] = {0, 0, 10, 5, 20, 0, 30, 9}, same[] = {3, 3, 3, 3, 3, 3, 3, 3};
    double holonomy, at[3];
    const bat_frame_arrays arrays = {.point = at};
    assert_int_equal(bat_frame_chain_create(space, NULL, &chain), BAT_OK);
    ARGUMENT(bat_frame_chain_many(chain, 1, NULL, &arrays));
    ARGUMENT(bat_frame_chain_many(chain, 1, u, NULL));
    assert_int_equal(bat_frame_chain_many(chain, 0, NULL, NULL), BAT_OK);
    assert_int_equal(bat_frame_chain_many(chain, 1, u, &arrays), BAT_OK); /* the place alone */
    bat_frame_chain_at(chain, u[0], &frame);
    assert_memory_equal(at, frame.point, sizeof at);
    assert_int_equal(bat_frames(space, 0, NULL, NULL, NULL, &holonomy), BAT_OK);
    bat_frame_chain_free(chain);
    bat_frame_options little = {.size = 1}; /* of before there were any */
    bat_frame_options_init(&little, 1);
    assert_int_equal(little.size, 1);
    bat_fit_options fit = bat_fit_defaults();
    fit.degree = 0;
    REFUSED(BAT_DEGREE, bat_fit(2, 4, points, &fit, &out, NULL));
    fit = bat_fit_defaults(), fit.smoothing = -1;
    ARGUMENT(bat_fit(2, 4, points, &fit, &out, NULL));
    fit.smoothing = INFINITY;
    ARGUMENT(bat_fit(2, 4, points, &fit, &out, NULL));
    int corner = -1;
    fit = bat_fit_defaults(), fit.corner_count = 1, fit.corners = &corner;
    ARGUMENT(bat_fit(2, 4, points, &fit, &out, NULL));
    corner = 4;
    ARGUMENT(bat_fit(2, 4, points, &fit, &out, NULL));
    fit = bat_fit_defaults();
    REFUSED(BAT_COUNT, bat_fit(2, 4, same, &fit, &out, NULL));
    bat_curve_free(space);
}

static void of_splines(void **state) {
    (void)state;
    const double points[] = {0, 0, 10, 5, 20, 0}, way[] = {1, 0};
    bat_spline spline = {.dimension = 2, .count = 3, .points = points}, longer;
    bat_tangents_options options = bat_tangents_defaults();
    void *block = NULL;
    int index;
    double deviation, *bezier = NULL;
    assert_true(isnan(bat_tangents_k(2, NULL, way, way)) && isnan(bat_tangents_k(2, way, NULL, way)));
    assert_true(isnan(bat_tangents_k(2, way, way, NULL)) && isnan(bat_tangents_k(1, way, way, way)));
    assert_true(isnan(bat_tangents_k(BAT_DIMENSION_MAX + 1, way, way, way)));
    ARGUMENT(bat_tangents(NULL, NULL, NULL, NULL, NULL, &out));
    ARGUMENT(bat_tangents(&spline, NULL, NULL, NULL, &bezier, &out));
    options.mode = (bat_tangents_mode)9;
    ARGUMENT(bat_tangents(&spline, &options, NULL, NULL, NULL, &out));
    options = bat_tangents_defaults(), options.missing = (bat_tangents_default)9;
    ARGUMENT(bat_tangents(&spline, &options, NULL, NULL, NULL, &out));
    ARGUMENT(bat_tangents_insert(NULL, 0, 0.5, NULL, &longer, &block, &index, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, 0, 0.5, NULL, NULL, &block, &index, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, 0, 0.5, NULL, &longer, NULL, &index, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, 0, 0.5, NULL, &longer, &block, NULL, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, -1, 0.5, NULL, &longer, &block, &index, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, 0, 0, NULL, &longer, &block, &index, &deviation));
    ARGUMENT(bat_tangents_insert(&spline, 0, NAN, NULL, &longer, &block, &index, &deviation));
    spline.count = 1;
    REFUSED(BAT_COUNT, bat_tangents_insert(&spline, 0, 0.5, NULL, &longer, &block, &index, &deviation));
    spline.count = SIZE_MAX;
    REFUSED(BAT_COUNT, bat_tangents_insert(&spline, 0, 0.5, NULL, &longer, &block, &index, &deviation));
    assert_true(!block && !bezier);
}

static void of_mirrors(void **state) {
    (void)state;
    bat_curve *space = in_space(), *flat = pen_curve(0, 0, 10, 5, 7), *other = NULL;
    const bat_mirror mirror = {.on = true, .at = {30, 0}, .along = {0, 1}};
    bat_mirror wrong = mirror;
    wrong.at[1] = NAN;
    assert_false(bat_mirror_is_good(&wrong));
    wrong = mirror, wrong.at[0] = 2.0 * BAT_COORDINATE_MAX;
    assert_false(bat_mirror_is_good(&wrong));
    wrong = mirror, wrong.along[0] = 0.1;
    assert_false(bat_mirror_is_good(&wrong));
    REFUSED(BAT_DIMENSION, bat_mirror_curve(&mirror, space, &out));
    REFUSED(BAT_DIMENSION, bat_mirror_whole(&mirror, space, 0, 1, 1, &out));
    REFUSED(BAT_DIMENSION, bat_mirror_net(&mirror, space, flat, 1, &out));
    REFUSED(BAT_DIMENSION, bat_mirror_net(&mirror, flat, space, 1, &out));
    assert_int_equal(bat_curve_reparametrise(flat, 3, 5, &other), BAT_OK); /* as many knots, others */
    REFUSED(BAT_STATE, bat_mirror_net(&mirror, flat, other, 1, &out));
    bat_curve_free(other);
    bat_curve_free(space);
    bat_curve_free(flat);
}

static void of_meanings(void **state) {
    (void)state;
    bat_curve *space = in_space(), *flat = pen_curve(0, 0, 10, 5, 7);
    const double map[6] = {1, 0, 0, 0, 1, 0}, points[] = {0, 0, 5, 0}, range[2] = {0, 1};
    const double endless[2] = {0, INFINITY};
    bat_intent *intent = NULL;
    bat_average mean = {0};
    const bat_stroke stroke = {.dimension = 2, .count = 2, .points = points},
                     deep = {.dimension = 3, .count = 1, .points = map}, none = {.dimension = 2};
    ARGUMENT(bat_intent_create(false, false, NULL));
    assert_int_equal(bat_intent_create(false, false, &intent), BAT_OK);
    ARGUMENT(bat_intent_line(NULL, flat, map, true));
    ARGUMENT(bat_intent_line(intent, NULL, map, true));
    ARGUMENT(bat_intent_line(intent, space, map, true));
    bat_intent_free(intent);
    ARGUMENT(bat_converge(0, &stroke, 1, &mean));
    ARGUMENT(bat_converge(1, NULL, 1, &mean));
    ARGUMENT(bat_converge(1, &stroke, 1, NULL));
    ARGUMENT(bat_converge(1, &stroke, 0, &mean));
    ARGUMENT(bat_converge(1, &stroke, NAN, &mean));
    REFUSED(BAT_DIMENSION, bat_converge(1, &deep, 1, &mean));
    REFUSED(BAT_DOT, bat_converge(1, &none, 1, &mean));
    REFUSED(BAT_DOT, bat_converge(1, &stroke, 4, &mean)); /* a pixel long */
    assert_null(mean.points);
    ARGUMENT(bat_sketch_calm(flat, NULL, 1, 1, &out));
    REFUSED(BAT_NUMBER, bat_sketch_calm(flat, endless, 1, 1, &out));
    REFUSED(BAT_NUMBER, bat_sketch_calm(flat, range, INFINITY, 1, &out));
    bat_sketch_live *live = NULL;
    REFUSED(BAT_DIMENSION, bat_sketch_live_begin(flat, 3, BAT_SKETCH_REDRAW, NULL, &live));
    assert_int_equal(bat_sketch_live_begin(flat, 2, BAT_SKETCH_REDRAW, NULL, &live), BAT_OK);
    assert_int_equal(bat_sketch_live_add(live, &none), BAT_OK); /* nothing is no mistake */
    bat_stroke endless_stroke = stroke;
    endless_stroke.count = SIZE_MAX;
    REFUSED(BAT_COUNT, bat_sketch_live_add(live, &endless_stroke));
    bat_sketch_live_cancel(live);
    bat_curve_free(space);
    bat_curve_free(flat);
}

static void of_levels(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 11), *space = in_space();
    bat_shape *shape = NULL, *made = NULL;
    bat_shape_options options = bat_shape_defaults();
    const double delta[6] = {1, 1, 1, 1, 1, 1};
    const bat_stroke deep = {.dimension = 3, .count = 2, .points = delta};
    ARGUMENT(bat_shape_create(curve, NULL, NULL));
    options.propagation = (bat_propagation)9;
    ARGUMENT(bat_shape_create(curve, &options, &made));
    options = bat_shape_defaults(), options.frame = (bat_frame_rule)9;
    ARGUMENT(bat_shape_create(curve, &options, &made));
    options = bat_shape_defaults(), options.nodes = (bat_node_rule)9;
    ARGUMENT(bat_shape_create(curve, &options, &made));
    REFUSED(BAT_COUNT, bat_shape_decompose(curve, -1, NULL, &made));
    REFUSED(BAT_COUNT, bat_shape_decompose(curve, BAT_LEVELS_MAX + 1, NULL, &made));
    REFUSED(BAT_COUNT, bat_shape_decompose_to(curve, 1, 0, NULL, &made));
    assert_int_equal(bat_shape_decompose(curve, 1, NULL, &shape), BAT_OK);
    const size_t points = bat_curve_count(bat_shape_curve(shape, 0));
    assert_int_not_equal(bat_shape_move_many(shape, 0, (int)points - 1, 3, delta), BAT_OK);
    REFUSED(BAT_DIMENSION, bat_shape_redraw_level(shape, 0, &deep, NULL, NULL));
    assert_int_equal(bat_shape_set_muted(shape, 1, true), BAT_OK);
    REFUSED(BAT_STATE, bat_shape_move(shape, 1, 0, delta)); /* a muted level shows no change */
    assert_null(made);
    bat_shape_free(shape);
    bat_curve_free(curve);
    bat_curve_free(space);
}

static void of_texts(void **state) {
    (void)state;
    bat_spline spline;
    bat_stroke stroke;
    bat_surface *surface = NULL, *made = NULL;
    bat_shape *shape = NULL;
    bat_problem problem;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 11);
    void *block = NULL;
    char *text = NULL;
    size_t size;
    random_source r = {5};
    surface = random_surface(&r, (int[]){2, 2}, (int[]){0, 0}, (int[]){2, 2});
    assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
    ARGUMENT(bat_spline_read(NULL, 0, &spline, &block, &problem));
    ARGUMENT(bat_spline_read("{}", 2, NULL, &block, &problem));
    ARGUMENT(bat_spline_read("{}", 2, &spline, NULL, &problem));
    ARGUMENT(bat_stroke_read(NULL, 0, &stroke, &block, &problem));
    ARGUMENT(bat_stroke_read("{}", 2, NULL, &block, &problem));
    ARGUMENT(bat_stroke_read("{}", 2, &stroke, NULL, &problem));
    ARGUMENT(bat_surface_read(NULL, 0, &made, &problem));
    ARGUMENT(bat_surface_read("{}", 2, NULL, &problem));
    ARGUMENT(bat_surface_write(NULL, &text, &size));
    ARGUMENT(bat_surface_write(surface, NULL, &size));
    ARGUMENT(bat_surface_write(surface, &text, NULL));
    ARGUMENT(bat_shape_write(NULL, &text, &size));
    ARGUMENT(bat_shape_write(shape, NULL, &size));
    ARGUMENT(bat_shape_write(shape, &text, NULL));
    REFUSED(BAT_SYNTAX, bat_surface_read("[]", 2, &made, &problem));
    const double at[] = {0.5};
    double place[3] = {7};
    assert_int_equal(bat_surface_eval_grid(surface, 1, at, 0, NULL, 0, place), BAT_OK);
    assert_true(place[0] == 7);
    bat_surface_redraw_options options = bat_surface_redraw_defaults();
    const int before = -1;
    bat_curve *line = NULL;
    assert_int_equal(bat_surface_isocurve(surface, BAT_U, bat_surface_knots(surface, BAT_U)[3], &line),
                     BAT_OK);
    options.hold_count = 1, options.hold = &before;
    ARGUMENT(bat_surface_redraw(surface, BAT_U, bat_surface_knots(surface, BAT_U)[3], line, &options, &made,
                                NULL, NULL));
    bat_curve_free(line);
    const double flat[] = {0, 0, 1, 1}, net[12] = {0};
    REFUSED(BAT_DEGREE, bat_surface_create((int[]){0, 1}, (bool[]){false, false}, (size_t[]){2, 2}, net,
                                           (int[]){4, 4}, flat, flat, &made));
    REFUSED(BAT_COUNT, bat_surface_create((int[]){1, 1}, (bool[]){false, false},
                                          (size_t[]){BAT_POINTS_MAX + (size_t)1, 2}, net, (int[]){4, 4}, flat,
                                          flat, &made));
    assert_true(!block && !text && !made);
    bat_surface_free(surface);
    bat_shape_free(shape);
    bat_curve_free(curve);
}

static void of_objects(void **state) {
    (void)state;
    const double origin[3] = {0, 0, 0}, axes[6] = {1, 0, 0, 0, 1, 0};
    bat_object *made = NULL, *path = NULL, *moved = NULL;
    bat_curve *curves[1] = {pen_curve(0, 0, 10, 5, 7)};
    const bat_spline spline = {.dimension = 2, .count = 3, .points = (double[]){0, 0, 10, 5, 20, 0}};
    const bat_style style = bat_style_defaults();
    ARGUMENT(bat_object_create_plane(1, "", NULL, axes, &made));
    ARGUMENT(bat_object_create_plane(1, "", origin, NULL, &made));
    ARGUMENT(bat_object_create_spline(1, "", NULL, &spline, NULL, &made));
    ARGUMENT(bat_object_with_spline(NULL, &spline, &made));
    assert_int_equal(bat_object_create_path(2, "", &style, 1, curves, &path), BAT_OK);
    ARGUMENT(bat_object_with_matrix(path, NULL, &made));
    assert_null(bat_object_curve(path, -1));
    assert_null(bat_object_curve(path, 1));
    assert_null(bat_object_shape(path, -1));
    assert_null(bat_object_retain(NULL));
    assert_int_equal(bat_object_with_parent(path, 9, &moved), BAT_OK);
    ARGUMENT(bat_object_with_id(moved, 9, &made)); /* in itself */
    assert_null(made);
    bat_object_release(moved);
    bat_object_release(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_curves),   cmocka_unit_test(of_frames_and_fits),
                                       cmocka_unit_test(of_splines),  cmocka_unit_test(of_mirrors),
                                       cmocka_unit_test(of_meanings), cmocka_unit_test(of_levels),
                                       cmocka_unit_test(of_texts),    cmocka_unit_test(of_objects)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
