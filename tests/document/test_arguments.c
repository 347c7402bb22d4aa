/* Invalid arguments to any public function give a status, change nothing and produce nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "hands/sketch/meant.h"
#include "support/pen.h"
#include <batten/batten.h>
#include <batten/fit.h>

static bat_curve *out; /* of every call that makes one: stays NULL */

static void refused(bat_status wanted, bat_status status, const char *call, int line) {
    if (status != wanted) fail_msg("line %d: %s: %s", line, call, bat_status_message(status));
    if (out) fail_msg("line %d: %s gave something", line, call);
}

#define ARGUMENT(call) refused(BAT_ARGUMENT, call, #call, __LINE__)
#define NUMBER(call) refused(BAT_NUMBER, call, #call, __LINE__)
#define COUNT(call) refused(BAT_COUNT, call, #call, __LINE__)

static bat_curve *closed_curve(void) {
    const double knots[] = {0, 1, 2, 3, 4, 5}, points[] = {0, 0, 9, 0, 9, 9, 4, 12, 0, 9};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 5, points, 6, knots, &curve), BAT_OK);
    return curve;
}

static void of_refinement(void **state) {
    (void)state;
    bat_curve *open = pen_curve(0, 0, 10, 5, 7), *closed = closed_curve(), *left = NULL;
    const double u[] = {1, 2};
    int count = 0;
    double error;
    ARGUMENT(bat_curve_copy(NULL, &out));
    ARGUMENT(bat_curve_copy(open, NULL));
    ARGUMENT(bat_curve_insert_knot(NULL, 1, 1, &out));
    ARGUMENT(bat_curve_insert_knot(open, 1, 1, NULL));
    ARGUMENT(bat_curve_insert_knot(open, 1, -1, &out));
    ARGUMENT(bat_curve_insert_knots(NULL, 2, u, &out));
    ARGUMENT(bat_curve_insert_knots(open, 2, u, NULL));
    ARGUMENT(bat_curve_insert_knots(open, -1, u, &out));
    ARGUMENT(bat_curve_insert_knots(open, 2, NULL, &out));
    ARGUMENT(bat_curve_refine(NULL, 2, u, &out));
    ARGUMENT(bat_curve_refine(open, 2, NULL, &out));
    ARGUMENT(bat_curve_refine(open, 2, u, NULL));
    ARGUMENT(bat_curve_remove_knot(NULL, 1, 1, 1, &out, NULL, NULL));
    ARGUMENT(bat_curve_remove_knot(open, 1, 1, 1, NULL, NULL, NULL));
    ARGUMENT(bat_curve_remove_knot(open, 1, -1, 1, &out, NULL, NULL));
    ARGUMENT(bat_curve_remove_knot(open, 1, 1, NAN, &out, NULL, NULL));
    ARGUMENT(bat_curve_simplify(NULL, 1, 1, &out, &error));
    ARGUMENT(bat_curve_simplify(open, 1, 1, NULL, &error));
    ARGUMENT(bat_curve_simplify(open, -1, 1, &out, &error));
    ARGUMENT(bat_curve_refit(NULL, 1, 1, &out, &error));
    ARGUMENT(bat_curve_refit(open, 1, 1, NULL, &error));
    ARGUMENT(bat_curve_refit(open, -1, 1, &out, &error));
    ARGUMENT(bat_curve_refit(open, INFINITY, 1, &out, &error));
    ARGUMENT(bat_curve_refit(open, 1, -1, &out, &error));
    ARGUMENT(bat_curve_refit_g1(NULL, 1, 1, &out, &error));
    ARGUMENT(bat_curve_refit_g1(open, 1, 1, NULL, &error));
    ARGUMENT(bat_curve_refit_g1(open, -1, 1, &out, &error));
    ARGUMENT(bat_curve_refit_g1(open, NAN, 1, &out, &error));
    ARGUMENT(bat_curve_refit_g1(open, INFINITY, 1, &out, &error));
    ARGUMENT(bat_curve_refit_g1(open, 1, NAN, &out, &error));
    ARGUMENT(bat_curve_simplify(open, 1, NAN, &out, &error));
    ARGUMENT(bat_curve_elevate(NULL, 5, &out));
    ARGUMENT(bat_curve_elevate(open, 5, NULL));
    ARGUMENT(bat_curve_clamp(NULL, &out));
    ARGUMENT(bat_curve_clamp(open, NULL));
    ARGUMENT(bat_curve_clamp(closed, &out));
    ARGUMENT(bat_curve_reverse(NULL, &out));
    ARGUMENT(bat_curve_reverse(open, NULL));
    ARGUMENT(bat_curve_reparametrise(NULL, 0, 1, &out));
    ARGUMENT(bat_curve_reparametrise(open, 0, 1, NULL));
    NUMBER(bat_curve_reparametrise(open, NAN, 1, &out));
    NUMBER(bat_curve_reparametrise(open, 0, INFINITY, &out));
    ARGUMENT(bat_curve_split(NULL, 1, &left, &out));
    ARGUMENT(bat_curve_split(open, 1, NULL, &out));
    ARGUMENT(bat_curve_split(open, 1, &left, NULL));
    ARGUMENT(bat_curve_split(closed, 1, &left, &out));
    assert_null(left);
    ARGUMENT(bat_curve_piece(NULL, 0, 1, &out));
    ARGUMENT(bat_curve_piece(open, 0, 1, NULL));
    NUMBER(bat_curve_piece(open, NAN, 1, &out));
    NUMBER(bat_curve_piece(open, 0, INFINITY, &out));
    ARGUMENT(bat_curve_open_at(NULL, 1, &out));
    ARGUMENT(bat_curve_open_at(closed, 1, NULL));
    ARGUMENT(bat_curve_open_at(open, 1, &out));
    ARGUMENT(bat_curve_close(NULL, 1, &out));
    ARGUMENT(bat_curve_close(open, 1, NULL));
    ARGUMENT(bat_curve_close(closed, 1, &out));
    ARGUMENT(bat_curve_close(open, NAN, &out));
    ARGUMENT(bat_curve_move_seam(NULL, 1, &out));
    ARGUMENT(bat_curve_move_seam(closed, 1, NULL));
    ARGUMENT(bat_curve_move_seam(open, 1, &out));
    NUMBER(bat_curve_move_seam(closed, NAN, &out));
    ARGUMENT(bat_curve_to_bezier(NULL, NULL, NULL));
    double *points = NULL;
    ARGUMENT(bat_curve_to_cubics(NULL, 1, &count, &points));
    ARGUMENT(bat_curve_to_cubics(open, 1, &count, NULL));
    ARGUMENT(bat_curve_to_cubics(open, 1, NULL, &points));
    ARGUMENT(bat_curve_from_bezier(2, 3, false, 1, NULL, 0, 0, &out, NULL));
    ARGUMENT(bat_curve_from_bezier(2, 3, false, 1, (double[]){0, 0, 1, 0, 2, 0, 3, 0}, 0, 0, NULL, NULL));
    ARGUMENT(bat_curve_from_bezier(2, 3, false, 1, (double[]){0, 0, 1, 0, 2, 0, 3, 0}, -1, 0, &out, NULL));
    ARGUMENT(bat_curve_from_bezier(2, 3, false, 1, (double[]){0, 0, 1, 0, 2, 0, 3, 0}, 0, NAN, &out, NULL));
    bat_curve_free(open);
    bat_curve_free(closed);
}

static void of_measures_and_drags(void **state) {
    (void)state;
    bat_curve *open = pen_curve(0, 0, 10, 5, 7);
    const double u[] = {1, 2}, at[2] = {1, 1}, bad[2] = {NAN, 0};
    double values[20];
    size_t count = 0;
    bat_near near;
    bat_finder *finder = NULL;
    bat_frame3 frames[2];
    bat_frame_chain *chain = NULL;
    ARGUMENT(bat_curve_eval_many(NULL, 2, u, 0, values));
    ARGUMENT(bat_curve_eval_many(open, 2, u, -1, values));
    ARGUMENT(bat_curve_eval_many(open, 2, NULL, 0, values));
    ARGUMENT(bat_curve_eval_many(open, 2, u, 0, NULL));
    assert_int_equal(bat_curve_eval_many(open, 0, NULL, 0, NULL), BAT_OK);
    ARGUMENT(bat_curve_transform(NULL, values, &out));
    ARGUMENT(bat_curve_transform(open, NULL, &out));
    ARGUMENT(bat_curve_transform(open, values, NULL));
    ARGUMENT(bat_curve_to_dimension(NULL, 3, &out));
    ARGUMENT(bat_curve_to_dimension(open, 3, NULL));
    ARGUMENT(bat_curve_nearest(NULL, at, &near));
    ARGUMENT(bat_curve_nearest(open, NULL, &near));
    ARGUMENT(bat_curve_nearest(open, at, NULL));
    ARGUMENT(bat_curve_nearest_all(NULL, at, 1, 1, &near, &count));
    ARGUMENT(bat_curve_nearest_all(open, NULL, 1, 1, &near, &count));
    ARGUMENT(bat_curve_nearest_all(open, at, 1, 1, &near, NULL));
    ARGUMENT(bat_curve_nearest_all(open, at, 1, 1, NULL, &count));
    ARGUMENT(bat_curve_nearest_all(open, at, NAN, 1, &near, &count));
    NUMBER(bat_curve_nearest_all(open, bad, 1, 1, &near, &count));
    ARGUMENT(bat_finder_create(NULL, &finder));
    ARGUMENT(bat_finder_create(open, NULL));
    ARGUMENT(bat_curve_drag(NULL, 1, u, at, &out));
    ARGUMENT(bat_curve_drag(open, 1, NULL, at, &out));
    ARGUMENT(bat_curve_drag(open, 1, u, NULL, &out));
    ARGUMENT(bat_curve_drag(open, 1, u, at, NULL));
    ARGUMENT(bat_curve_drag(open, 0, u, at, &out));
    ARGUMENT(bat_curve_move_point(NULL, 0, at, &out));
    ARGUMENT(bat_curve_move_point(open, 0, NULL, &out));
    ARGUMENT(bat_curve_move_point(open, 0, at, NULL));
    ARGUMENT(bat_curve_move_point(open, -1, at, &out));
    ARGUMENT(bat_curve_move_point(open, 7, at, &out));
    bat_curve *space = NULL;
    assert_int_equal(bat_curve_to_dimension(open, 3, &space), BAT_OK);
    ARGUMENT(bat_frames(NULL, 2, u, NULL, frames, NULL));
    ARGUMENT(bat_frames(space, 2, NULL, NULL, frames, NULL));
    ARGUMENT(bat_frames(space, 2, u, NULL, NULL, NULL));
    ARGUMENT(bat_frame_chain_create(NULL, NULL, &chain));
    ARGUMENT(bat_frame_chain_create(space, NULL, NULL));
    bat_frame_options options = {.size = sizeof options, .substeps = -1};
    ARGUMENT(bat_frame_chain_create(space, &options, &chain));
    options.substeps = 1025;
    ARGUMENT(bat_frame_chain_create(space, &options, &chain));
    options = (bat_frame_options){.size = sizeof options, .rule = (bat_frame_rule)77};
    ARGUMENT(bat_frame_chain_create(space, &options, &chain));
    options = (bat_frame_options){.size = sizeof options, .holonomy_near = NAN};
    NUMBER(bat_frame_chain_create(space, &options, &chain));
    options = (bat_frame_options){.size = sizeof options, .has_first = true, .first = {0, NAN, 0}};
    NUMBER(bat_frame_chain_create(space, &options, &chain));
    assert_null(chain);
    ARGUMENT(bat_frame_chain_many(NULL, 0, u, NULL));
    bat_curve_free(space);
    bat_curve_free(open);
}

static void of_strokes(void **state) {
    (void)state;
    bat_curve *open = pen_curve(0, 0, 10, 5, 7), *closed = closed_curve();
    const double points[] = {0, 0, 10, 5, 20, 0};
    const bat_stroke stroke = {.dimension = 2, .count = 3, .points = points},
                     none = {.dimension = 2, .count = 3};
    bat_sketch_options options = bat_sketch_defaults();
    bat_sketch_report report;
    bat_sketch_live *live = NULL;
    ARGUMENT(bat_sketch(NULL, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch(open, NULL, &options, &out, &report));
    ARGUMENT(bat_sketch(open, &none, &options, &out, &report));
    ARGUMENT(bat_sketch(open, &stroke, &options, NULL, &report));
    ARGUMENT(bat_sketch_new(NULL, false, &options, &out, &report));
    ARGUMENT(bat_sketch_new(&stroke, false, &options, NULL, &report));
    ARGUMENT(bat_sketch_smooth(NULL, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch_smooth(open, &stroke, &options, NULL, &report));
    ARGUMENT(bat_sketch_join(NULL, open, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch_join(open, NULL, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch_join(open, open, &stroke, &options, NULL, &report));
    ARGUMENT(bat_sketch_join(open, closed, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch_join(closed, open, &stroke, &options, &out, &report));
    ARGUMENT(bat_sketch_live_begin(open, 2, (bat_sketch_kind)9, &options, &live));
    assert_null(live);
    ARGUMENT(bat_sketch_live_add(NULL, &stroke));
    ARGUMENT(bat_sketch_live_preview(NULL, &out, NULL));
    ARGUMENT(bat_sketch_live_commit(NULL, &out, &report));
    assert_int_equal(bat_sketch_live_begin(open, 2, BAT_SKETCH_REDRAW, &options, &live), BAT_OK);
    ARGUMENT(bat_sketch_live_add(live, NULL));
    ARGUMENT(bat_sketch_live_add(live, &none));
    ARGUMENT(bat_sketch_live_commit(live, NULL, &report)); /* which ends it */
    options.width = 101;
    ARGUMENT(bat_sketch(open, &stroke, &options, &out, &report));
    options.width = -1;
    ARGUMENT(bat_sketch(open, &stroke, &options, &out, &report));
    const double range[2] = {0, 1};
    NUMBER(bat_sketch_calm(open, range, INFINITY, 1, &out));
    NUMBER(bat_sketch_calm(open, range, 1, INFINITY, &out));
    bat_fit_options fit = bat_fit_defaults();
    ARGUMENT(bat_fit(2, 3, points, &fit, NULL, NULL));
    fit.corner_count = SIZE_MAX;
    assert_int_equal(bat_fit(2, 3, points, &fit, &out, NULL), BAT_COUNT);
    fit.corner_count = 1;
    ARGUMENT(bat_fit(2, 3, points, &fit, &out, NULL));
    fit.corner_count = 0, fit.solves_max = -1;
    ARGUMENT(bat_fit(2, 3, points, &fit, &out, NULL));
    bat_curve_free(open);
    bat_curve_free(closed);
}

#define DIMENSION(call) refused(BAT_DIMENSION, call, #call, __LINE__)

/* Strokes and curves that do not go together, and options out of their range. */
static void of_strokes_and_what_they_mean(void **state) {
    (void)state;
    bat_curve *open = pen_curve(0, 0, 10, 5, 7), *closed = closed_curve(), *space = NULL;
    const double points[] = {0, 0, 0, 10, 5, 1, 20, 0, 2, 30, 5, 3}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    assert_int_equal(bat_curve_create(3, 3, false, 4, points, 8, knots, &space), BAT_OK);
    const bat_stroke flat = {.dimension = 2, .count = 3, .points = points},
                     deep = {.dimension = 3, .count = 3, .points = points},
                     thin = {.dimension = 1, .count = 3, .points = points},
                     wide = {.dimension = 4, .count = 3, .points = points},
                     endless = {.dimension = 2, .count = SIZE_MAX, .points = points};
    const bat_curve *both[] = {open, open};
    const double cuts[] = {5, 5};
    bat_sketch_meaning meaning[2] = {{0}};
    bat_curve *made[2] = {NULL, NULL};
    DIMENSION(bat_sketch(open, &deep, NULL, &out, NULL));
    DIMENSION(bat_sketch(open, &thin, NULL, &out, NULL));
    DIMENSION(bat_sketch(open, &wide, NULL, &out, NULL));
    COUNT(bat_sketch(open, &endless, NULL, &out, NULL));
    DIMENSION(bat_sketch_smooth(open, &deep, NULL, &out, NULL));
    DIMENSION(bat_sketch_join(open, space, &flat, NULL, &out, NULL));
    DIMENSION(bat_sketch_join(space, open, &flat, NULL, &out, NULL));
    DIMENSION(bat_sketch_join(open, open, &deep, NULL, &out, NULL));
    ARGUMENT(bat_sketch_close(NULL, &flat, NULL, &out, NULL));
    ARGUMENT(bat_sketch_close(open, &flat, NULL, NULL, NULL));
    ARGUMENT(bat_sketch_close(closed, &flat, NULL, &out, NULL));
    ARGUMENT(bat_sketch_chain(0, both, cuts, meaning, &flat, NULL, made));
    ARGUMENT(bat_sketch_chain(2, NULL, cuts, meaning, &flat, NULL, made));
    ARGUMENT(bat_sketch_chain(2, both, NULL, meaning, &flat, NULL, made));
    ARGUMENT(bat_sketch_chain(2, both, cuts, NULL, &flat, NULL, made));
    ARGUMENT(bat_sketch_chain(2, both, cuts, meaning, &flat, NULL, NULL));
    ARGUMENT(bat_sketch_chain(2, both, cuts, meaning, NULL, NULL, made));
    DIMENSION(bat_sketch_chain(1, both, cuts, meaning, &deep, NULL, made));
    const bat_curve *mixed[] = {open, space}; /* the first could be made */
    const double along[] = {0, 0, 10, 5, 20, 0, 30, 5, 40, 0, 50, 5, 60, 0};
    const bat_stroke stroke = {.dimension = 2, .count = 7, .points = along};
    DIMENSION(bat_sketch_chain(2, mixed, (double[]){30, 5}, meaning, &stroke, NULL, made));
    assert_true(!made[0] && !made[1]);
    for (int i = 0; i < 7; i++) {
        bat_sketch_options options = bat_sketch_defaults();
        double *const numbers[] = {&options.pixel,     &options.pixel,     &options.tolerance,
                                   &options.tolerance, &options.tolerance, &options.smooth_limit,
                                   &options.pixel};
        const double bad[] = {0, 1e200, -1, 1e-9, 1e9, -1, -1};
        *numbers[i] = bad[i];
        ARGUMENT(bat_sketch(open, &flat, &options, &out, NULL));
        ARGUMENT(bat_sketch_new(&flat, false, &options, &out, NULL));
        *numbers[i] = NAN;
        NUMBER(bat_sketch(open, &flat, &options, &out, NULL));
        NUMBER(bat_sketch_smooth(open, &flat, &options, &out, NULL));
        NUMBER(bat_sketch_join(open, open, &flat, &options, &out, NULL));
        NUMBER(bat_sketch_close(open, &flat, &options, &out, NULL));
    }
    bat_sketch_options options = bat_sketch_defaults();
    options.pins = 4;
    ARGUMENT(bat_sketch(open, &flat, &options, &out, NULL));
    bat_curve_free(open);
    bat_curve_free(closed);
    bat_curve_free(space);
}

/* SVG: what a host hands over that is none, and what it asks for without room. */
static void of_svg(void **state) {
    (void)state;
    bat_svg_reader *reader = NULL;
    bat_svg_options options = bat_svg_defaults();
    const char *const attributes[] = {"d", "M0 0L1 1", NULL};
    double *const numbers[] = {&options.tolerance, &options.tolerance, &options.corner, &options.corner,
                               &options.share};
    const double bad[] = {-1, 1e80, -1, 5, -1};
    ARGUMENT(bat_svg_reader_create(&options, NULL));
    for (int i = 0; i < 5; i++) {
        options = bat_svg_defaults();
        *numbers[i] = bad[i];
        ARGUMENT(bat_svg_reader_create(&options, &reader));
        *numbers[i] = NAN;
        ARGUMENT(bat_svg_reader_create(&options, &reader));
    }
    ARGUMENT(bat_svg_reader_start(NULL, "svg", attributes));
    ARGUMENT(bat_svg_reader_text(NULL, "a", 1));
    ARGUMENT(bat_svg_reader_end(NULL));
    bat_svg_reader_free(NULL);
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    ARGUMENT(bat_svg_reader_start(reader, NULL, attributes));
    ARGUMENT(bat_svg_reader_text(reader, NULL, 1));
    bat_svg_reader_free(reader);
    char word[] = "as it was";
    bat_svg_report report = {.lost.count[BAT_LOSS_TITLE] = 2};
    bat_loss_words(BAT_LOSS_TITLE, 2, NULL, 9);
    bat_loss_words(BAT_LOSS_TITLE, 2, word, 0);
    bat_svg_report_line(NULL, word, sizeof word);
    bat_svg_report_line(&report, NULL, 9);
    bat_svg_report_line(&report, word, 0);
    assert_string_equal(word, "as it was");
    bat_loss_words(BAT_LOSS_TITLE, 2, word, sizeof word); /* half a word is none */
    assert_string_equal(word, "");
}

static void of_levels(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 11);
    bat_shape *shape = NULL, *made = NULL;
    bat_shape_live *live = NULL;
    const double delta[2] = {1, 1}, bad[6] = {1, 0, 0, 0, NAN, 0};
    double left;
    assert_int_equal(bat_shape_decompose(curve, 1, NULL, &shape), BAT_OK);
    ARGUMENT(bat_shape_decompose(NULL, 1, NULL, &made));
    ARGUMENT(bat_shape_decompose(curve, 1, NULL, NULL));
    ARGUMENT(bat_shape_decompose_to(NULL, 1, 4, NULL, &made));
    ARGUMENT(bat_shape_decompose_to(curve, 1, 4, NULL, NULL));
    const size_t many[] = {BAT_POINTS_MAX + (size_t)1, SIZE_MAX,
                           sizeof(size_t) > 4 ? (size_t)0x100000005 : SIZE_MAX};
    const bat_fit_options fit = bat_fit_defaults();
    for (int i = 0; i < 3; i++) { /* refused before anything is reckoned with them, or read */
        const bat_spline endless = {.dimension = 2, .count = many[i], .points = delta};
        COUNT(bat_shape_decompose_to(curve, 1, many[i], NULL, &made));
        COUNT(bat_shape_move_many(shape, 0, 0, many[i], delta));
        COUNT(bat_shape_sketch(shape, 0, many[i], delta, delta));
        COUNT(bat_curve_drag(curve, many[i], delta, delta, &out));
        COUNT(bat_tangents(&endless, NULL, NULL, NULL, NULL, &out));
        COUNT(bat_fit(2, many[i], delta, &fit, &out, NULL));
    }
    ARGUMENT(bat_shape_create(NULL, NULL, &made));
    ARGUMENT(bat_shape_create(curve, NULL, NULL));
    ARGUMENT(bat_shape_copy(NULL, &made));
    ARGUMENT(bat_shape_copy(shape, NULL));
    ARGUMENT(bat_shape_flatten(NULL, &out));
    ARGUMENT(bat_shape_flatten(shape, NULL));
    ARGUMENT(bat_shape_add_level(NULL, 0, NULL, NULL, NULL));
    ARGUMENT(bat_shape_move(NULL, 0, 0, delta));
    ARGUMENT(bat_shape_move(shape, -1, 0, delta));
    ARGUMENT(bat_shape_move(shape, 2, 0, delta));
    ARGUMENT(bat_shape_set_gain(shape, 0, 1));
    ARGUMENT(bat_shape_set_gain(NULL, 1, 1));
    ARGUMENT(bat_shape_set_muted(shape, 0, true));
    ARGUMENT(bat_shape_set_muted(shape, 2, true));
    ARGUMENT(bat_shape_transform(NULL, bad));
    ARGUMENT(bat_shape_transform(shape, NULL));
    NUMBER(bat_shape_transform(shape, bad));
    ARGUMENT(bat_shape_commit(NULL));
    ARGUMENT(bat_shape_sketch(NULL, 0, 1, delta, delta));
    ARGUMENT(bat_shape_sketch(shape, -1, 1, delta, delta));
    ARGUMENT(bat_shape_sketch(shape, 2, 1, delta, delta));
    ARGUMENT(bat_shape_sketch(shape, 0, 0, delta, delta));
    ARGUMENT(bat_shape_sketch(shape, 0, 1, NULL, delta));
    ARGUMENT(bat_shape_sketch(shape, 0, 1, delta, NULL));
    NUMBER(bat_shape_sketch(shape, 0, 1, delta, bad + 4));
    NUMBER(bat_shape_sketch(shape, 0, 1, bad + 4, delta));
    ARGUMENT(bat_shape_redraw(NULL, NULL, false, NULL, &made, NULL));
    ARGUMENT(bat_shape_redraw(shape, NULL, false, NULL, NULL, NULL));
    ARGUMENT(bat_shape_redraw_level(NULL, 0, NULL, NULL, NULL));
    ARGUMENT(bat_shape_redraw_level(shape, -1, NULL, NULL, NULL));
    ARGUMENT(bat_shape_redraw_level(shape, 2, NULL, NULL, NULL));
    ARGUMENT(bat_shape_live_begin(NULL, 0, &live));
    ARGUMENT(bat_shape_live_begin(shape, 0, NULL));
    ARGUMENT(bat_shape_live_begin(shape, -1, &live));
    ARGUMENT(bat_shape_live_begin(shape, 2, &live));
    assert_null(live);
    ARGUMENT(bat_shape_live_move(NULL, 0, 1, delta));
    ARGUMENT(bat_shape_live_drag(NULL, 0, delta));
    ARGUMENT(bat_shape_live_drag_finest(NULL, 0, delta, 1, &left));
    assert_int_equal(bat_shape_live_begin(shape, 0, &live), BAT_OK);
    ARGUMENT(bat_shape_live_drag_finest(live, 0, NULL, 1, &left));
    ARGUMENT(bat_shape_live_drag_finest(live, 0, delta, 0, &left));
    NUMBER(bat_shape_live_drag_finest(live, NAN, delta, 1, &left));
    bat_shape_live_cancel(live);
    assert_null(made);
    bat_shape_free(shape);
    bat_curve_free(curve);
}

static void of_objects_and_documents(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_object *made = NULL;
    bat_style style = bat_style_defaults(), wrong = style;
    wrong.width = NAN;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7), *nothing = NULL;
    const double page[4] = {0, 0, 10, 10}, matrix[6] = {1, 0, 0, 1, 0, 0};
    ARGUMENT(bat_document_create(NULL));
    assert_int_equal(bat_document_create(&document), BAT_OK);
    pen_add(document, pen_curve(0, 0, 10, 5, 7));
    const bat_object *object = bat_document_at(document, 0);
    const bat_id id = bat_object_id(object);
    const uint64_t before = bat_document_digest(document);
    ARGUMENT(bat_document_copy(NULL, &document));
    ARGUMENT(bat_document_copy(document, NULL));
    ARGUMENT(bat_document_insert(NULL, 0, object));
    ARGUMENT(bat_document_insert(document, 0, NULL));
    ARGUMENT(bat_document_insert(document, -1, object));
    ARGUMENT(bat_document_insert(document, 2, object));
    ARGUMENT(bat_document_insert(document, 1, object)); /* it is there already */
    ARGUMENT(bat_document_replace(NULL, 0, object));
    ARGUMENT(bat_document_replace(document, 0, NULL));
    ARGUMENT(bat_document_replace(document, -1, object));
    ARGUMENT(bat_document_replace(document, 1, object));
    ARGUMENT(bat_document_remove(NULL, 0));
    ARGUMENT(bat_document_remove(document, -1));
    ARGUMENT(bat_document_remove(document, 1));
    ARGUMENT(bat_document_set_page(NULL, page));
    ARGUMENT(bat_document_set_page(document, NULL));
    ARGUMENT(bat_object_create_path(7, "", &style, 1, NULL, &made));
    ARGUMENT(bat_object_create_path(7, "", &style, 1, &nothing, &made));
    ARGUMENT(bat_object_create_path(7, "", &style, 1, (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, NULL));
    ARGUMENT(bat_object_create_path(0, "", &style, 1, (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, &made));
    ARGUMENT(bat_object_create_path((bat_id)BAT_ID_MAX + 1, "", &style, 1,
                                    (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, &made));
    ARGUMENT(bat_object_create_path(7, "", &wrong, 1, (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, &made));
    ARGUMENT(bat_object_create_path(7, "\xff", &style, 1, (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, &made));
    ARGUMENT(bat_object_with_curves(NULL, 1, (bat_curve *[]){pen_curve(0, 0, 10, 5, 7)}, &made));
    ARGUMENT(bat_object_with_curve(NULL, 0, pen_curve(0, 0, 10, 5, 7), &made));
    ARGUMENT(bat_object_with_curve(object, 0, NULL, &made));
    ARGUMENT(bat_object_with_curve(object, 0, pen_curve(0, 0, 10, 5, 7), NULL));
    ARGUMENT(bat_object_with_curve(object, -1, pen_curve(0, 0, 10, 5, 7), &made));
    ARGUMENT(bat_object_with_curve(object, 1, pen_curve(0, 0, 10, 5, 7), &made));
    ARGUMENT(bat_object_with_style(NULL, &style, &made));
    ARGUMENT(bat_object_with_style(object, NULL, &made));
    ARGUMENT(bat_object_with_style(object, &style, NULL));
    ARGUMENT(bat_object_with_style(object, &wrong, &made));
    ARGUMENT(bat_object_with_parent(NULL, 0, &made));
    ARGUMENT(bat_object_with_parent(object, 0, NULL));
    ARGUMENT(bat_object_with_parent(object, id, &made));
    ARGUMENT(bat_object_with_name(NULL, "a", &made));
    ARGUMENT(bat_object_with_name(object, NULL, &made));
    ARGUMENT(bat_object_with_name(object, "a", NULL));
    ARGUMENT(bat_object_with_name(object, "\xc3", &made));
    ARGUMENT(bat_object_with_state(NULL, true, true, &made));
    ARGUMENT(bat_object_with_state(object, true, true, NULL));
    ARGUMENT(bat_object_with_id(NULL, 9, &made));
    ARGUMENT(bat_object_with_id(object, 9, NULL));
    ARGUMENT(bat_object_with_id(object, 0, &made));
    ARGUMENT(bat_object_to_path(NULL, &made));
    ARGUMENT(bat_object_to_path(object, &made)); /* it is one */
    ARGUMENT(bat_object_create_guide(7, 2, 1, &made));
    ARGUMENT(bat_object_create_guide(7, -1, 1, &made));
    ARGUMENT(bat_object_create_guide(7, 0, 1, NULL));
    ARGUMENT(bat_object_create_image(7, "", NULL, matrix, 1, &made));
    ARGUMENT(bat_object_with_matrix(object, matrix, &made)); /* no image */
    bat_picture *picture = NULL;
    ARGUMENT(bat_picture_create(NULL, 9, &picture));
    ARGUMENT(bat_picture_create(page, 9, NULL));
    assert_null(picture);
    char *text = NULL;
    size_t size = 0;
    ARGUMENT(bat_document_write(NULL, &text, &size));
    ARGUMENT(bat_document_write(document, NULL, &size));
    ARGUMENT(bat_document_write(document, &text, NULL));
    ARGUMENT(bat_svg_write(NULL, true, &text, &size));
    ARGUMENT(bat_svg_write(document, true, NULL, &size));
    ARGUMENT(bat_svg_write_within(NULL, true, 0, &text, &size));
    ARGUMENT(bat_svg_write_within(document, true, NAN, &text, &size));
    ARGUMENT(bat_svg_write_kept(NULL, true, 0, &text, &size));
    ARGUMENT(bat_svg_write_kept(document, true, NAN, &text, &size));
    ARGUMENT(bat_svg_write(document, true, &text, NULL));
    ARGUMENT(bat_curve_write(NULL, &text, &size));
    ARGUMENT(bat_curve_write(curve, NULL, &size));
    ARGUMENT(bat_curve_write(curve, &text, NULL));
    bat_problem problem;
    ARGUMENT(bat_curve_read(NULL, 0, &out, &problem));
    ARGUMENT(bat_curve_read("{}", 2, NULL, &problem));
    ARGUMENT(bat_document_read(NULL, 0, &document, &problem));
    ARGUMENT(bat_document_read("{}", 2, NULL, &problem));
    ARGUMENT(bat_svg_reader_start(NULL, "g", NULL));
    ARGUMENT(bat_svg_reader_text(NULL, "", 0));
    ARGUMENT(bat_svg_reader_end(NULL));
    assert_null(made);
    assert_null(text);
    assert_true(bat_document_digest(document) == before);
    assert_null(bat_document_check(document));
    bat_curve_free(curve);
    bat_document_free(document);
}

static void of_surfaces(void **state) {
    (void)state;
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1}, nan[] = {0, NAN, 0};
    const int one[2] = {1, 1}, four[2] = {4, 4};
    const bool open[2] = {false, false};
    const size_t two[2] = {2, 2};
    double at[2] = {0, 1}, found[18] = {7}, matrix[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    bat_surface *s = NULL, *made = NULL;
    bat_surface_point place = {0};
    size_t count = 0;
    bat_curve *line = NULL;
    assert_int_equal(bat_surface_create(one, open, two, points, four, knots, knots, &s), BAT_OK);
    ARGUMENT(bat_surface_create(NULL, open, two, points, four, knots, knots, &made));
    ARGUMENT(bat_surface_create(one, NULL, two, points, four, knots, knots, &made));
    ARGUMENT(bat_surface_create(one, open, NULL, points, four, knots, knots, &made));
    ARGUMENT(bat_surface_create(one, open, two, points, NULL, knots, knots, &made));
    ARGUMENT(bat_surface_create(one, open, two, points, four, NULL, knots, &made));
    ARGUMENT(bat_surface_create(one, open, two, points, four, knots, NULL, &made));
    ARGUMENT(bat_surface_create(one, open, two, points, four, knots, knots, NULL));
    ARGUMENT(bat_surface_copy(NULL, &made));
    ARGUMENT(bat_surface_copy(s, NULL));
    ARGUMENT(bat_surface_transform(NULL, matrix, &made));
    ARGUMENT(bat_surface_transform(s, NULL, &made));
    ARGUMENT(bat_surface_transform(s, matrix, NULL));
    ARGUMENT(bat_surface_eval_grid(NULL, 2, at, 2, at, 0, found));
    ARGUMENT(bat_surface_eval_grid(s, 2, at, 2, at, -1, found));
    ARGUMENT(bat_surface_eval_grid(s, 2, NULL, 2, at, 0, found));
    ARGUMENT(bat_surface_eval_grid(s, 2, at, 2, NULL, 0, found));
    ARGUMENT(bat_surface_eval_grid(s, 2, at, 2, at, 0, NULL));
    COUNT(bat_surface_eval_grid(s, 2, at, SIZE_MAX / 8, at, 0, found));
    ARGUMENT(bat_surface_normal_grid(NULL, 2, at, 2, at, NULL, found));
    ARGUMENT(bat_surface_normal_grid(s, 2, NULL, 2, at, NULL, found));
    ARGUMENT(bat_surface_normal_grid(s, 2, at, 2, NULL, NULL, found));
    ARGUMENT(bat_surface_normal_grid(s, 2, at, 2, at, found, NULL));
    COUNT(bat_surface_normal_grid(s, 2, at, SIZE_MAX / 8, at, NULL, found));
    ARGUMENT(bat_surface_normal(NULL, 0, 0, found));
    ARGUMENT(bat_surface_normal(s, 0, 0, NULL));
    ARGUMENT(bat_surface_curvature(NULL, 0, 0, found, found));
    ARGUMENT(bat_surface_curvature(s, 0, 0, NULL, found));
    ARGUMENT(bat_surface_curvature(s, 0, 0, found, NULL));
    ARGUMENT(bat_surface_isocurve(NULL, BAT_U, 0, &out));
    ARGUMENT(bat_surface_isocurve(s, BAT_U, 0, NULL));
    NUMBER(bat_surface_isocurve(s, BAT_V, NAN, &out));
    ARGUMENT(bat_surface_nearest(NULL, points, &place));
    ARGUMENT(bat_surface_nearest(s, NULL, &place));
    ARGUMENT(bat_surface_nearest(s, points, NULL));
    NUMBER(bat_surface_nearest(s, nan, &place));
    ARGUMENT(bat_surface_hits(NULL, points, points + 3, 1, &place, &count));
    ARGUMENT(bat_surface_hits(s, NULL, points + 3, 1, &place, &count));
    ARGUMENT(bat_surface_hits(s, points, NULL, 1, &place, &count));
    ARGUMENT(bat_surface_hits(s, points, points + 3, 1, NULL, &count));
    ARGUMENT(bat_surface_hits(s, points, points + 3, 1, &place, NULL));
    ARGUMENT(bat_surface_hits(s, points, points, 1, &place, &count)); /* no direction */
    NUMBER(bat_surface_hits(s, nan, points + 3, 1, &place, &count));
    NUMBER(bat_surface_hits(s, points, nan, 1, &place, &count));
    ARGUMENT(bat_surface_insert_knots(NULL, BAT_U, 1, at, &made));
    ARGUMENT(bat_surface_insert_knots(s, BAT_U, 1, NULL, &made));
    ARGUMENT(bat_surface_insert_knots(s, BAT_U, 1, at, NULL));
    ARGUMENT(bat_surface_refine(NULL, BAT_V, 4, knots, &made));
    ARGUMENT(bat_surface_refine(s, BAT_V, 4, NULL, &made));
    ARGUMENT(bat_surface_refine(s, BAT_V, 4, knots, NULL));
    assert_int_equal(bat_surface_isocurve(s, BAT_U, 0, &line), BAT_OK);
    bat_surface_redraw_options options = bat_surface_redraw_defaults();
    ARGUMENT(bat_surface_redraw(NULL, BAT_U, 0, line, NULL, &made, NULL, NULL));
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, NULL, NULL, &made, NULL, NULL));
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, NULL, NULL, NULL, NULL));
    NUMBER(bat_surface_redraw(s, BAT_U, NAN, line, NULL, &made, NULL, NULL));
    options.reach = -1;
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, &options, &made, NULL, NULL));
    options.reach = INFINITY;
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, &options, &made, NULL, NULL));
    options.reach = 0, options.hold_count = 1;
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, &options, &made, NULL, NULL));
    options.hold = (const int[]){2};
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, &options, &made, NULL, NULL));
    options.size = 0;
    ARGUMENT(bat_surface_redraw(s, BAT_U, 0, line, &options, &made, NULL, NULL));
    assert_null(made);
    assert_true(found[0] == 7 && count == 0 && place.distance == 0);
    bat_curve_free(line);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_refinement), cmocka_unit_test(of_measures_and_drags),
        cmocka_unit_test(of_strokes),    cmocka_unit_test(of_strokes_and_what_they_mean),
        cmocka_unit_test(of_svg),        cmocka_unit_test(of_levels),
        cmocka_unit_test(of_surfaces),   cmocka_unit_test(of_objects_and_documents)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
