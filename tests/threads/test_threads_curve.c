/* The promise of base.h about threads: concurrent const calls on one curve, one chain of frames, one shape. */
#include "alike.h"
#include "support/random_curve.h"
#include "support/session.h"

static double somewhere(const bat_curve *curve, int seed) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return domain[0] + (domain[1] - domain[0]) * (seed + 1) / 9;
}

static uint64_t evaluate_curve(const void *shared, int seed) {
    const bat_curve *curve = shared;
    double out[64] = {0}, more[64] = {0}, u[16], at = somewhere(curve, seed);
    int first = 0, n = (int)bat_curve_count(curve), knots = bat_curve_knot_count(curve);
    uint64_t digest = add_doubles(bat_digest_begin(), bat_curve_knots(curve), knots);
    digest = add_doubles(digest, bat_curve_points(curve), n * bat_curve_dimension(curve));
    digest = add(add(digest, bat_curve_is_closed(curve)), (uint64_t)bat_curve_degree(curve));
    digest = bat_digest_double(digest, bat_curve_size(curve));
    bat_curve_eval(curve, at, 2, out);
    bat_curve_eval_left(curve, at, 2, out + 6);
    bat_curve_spread(curve, 16, u);
    digest = add(add_doubles(digest, out, 12), (uint64_t)bat_curve_eval_many(curve, 16, u, 0, more));
    bat_curve_greville(curve, out);
    digest = add_doubles(add_doubles(digest, more, 32), out, n);
    bat_curve_basis(curve, at, &first, out);
    bat_curve_blossom(curve, at, u, false, more);
    return add(add_doubles(add_doubles(digest, out, 4), more, 2), (uint64_t)first);
}

static uint64_t measure_curve(const void *shared, int seed) {
    const bat_curve *curve = shared;
    double low[3] = {0}, high[3] = {0}, u[16] = {0}, a = 0, b = 0, at = somewhere(curve, seed);
    const double point[3] = {1, seed, 2};
    size_t count = 0;
    uint64_t digest = bat_digest_begin();
    bat_curve_bounds(curve, low, high);
    digest = add_doubles(add_doubles(digest, low, 2), high, 2);
    digest = bat_digest_double(digest, bat_curve_length(curve, somewhere(curve, 0), at, 1e-9));
    digest = bat_digest_double(digest, bat_curve_at_length(curve, at, 1, 1e-9));
    digest = bat_digest_double(digest, bat_curve_curvature(curve, at));
    digest = add_doubles(add(digest, (uint64_t)bat_curve_inflections(curve, 16, u)), u, 16);
    digest = add_doubles(add(digest, (uint64_t)bat_curve_extremes(curve, 1, 16, u)), u, 16);
    digest = add(digest, (uint64_t)bat_curve_distance(curve, curve, 4, &a, &b));
    bat_near near[4] = {{0}};
    digest = add(digest, (uint64_t)bat_curve_nearest(curve, point, near));
    digest = bat_digest_double(bat_digest_double(digest, near[0].distance), a + b);
    digest = add(digest, (uint64_t)bat_curve_nearest_all(curve, point, 5, 4, near, &count));
    digest = bat_digest_double(digest, bat_curve_project_near(curve, point, at, 3));
    bat_frame3 frames[2] = {{0}};
    double ends[2] = {somewhere(curve, 0), at};
    digest = add(digest, (uint64_t)bat_frames(curve, 2, ends, NULL, frames, NULL));
    return add_doubles(add(digest, (uint64_t)count), frames[1].s, 3);
}

static uint64_t add_blend(uint64_t d, const bat_curve *curve, const bat_curve *other) {
    bat_curve *made = NULL, *met = NULL;
    double variation = 0, moved = 0, jump[4] = {0};
    bat_blend_options options;
    bat_blend_options_init(&options, sizeof options);
    d = add(d, (uint64_t)bat_curve_blend(curve, true, other, true, &options, &made, &variation));
    d = add(d, (uint64_t)bat_curve_match(curve, true, other, true, 2, 1, &met, &moved));
    d = add(d, (uint64_t)bat_curve_jump(curve, false, other, true, jump));
    bat_curve_free(made), bat_curve_free(met);
    return bat_digest_double(bat_digest_double(bat_digest_double(d, variation), moved), jump[1]);
}

static uint64_t add_region(uint64_t d, const bat_curve *curve, const bat_curve *other) {
    const bat_region both[2] = {{1, &curve, false}, {1, &other, true}};
    size_t count = 0;
    bat_curve **all = NULL;
    d = add(d, (uint64_t)bat_regions_combine(BAT_REGION_EXCLUSION, 2, both, 1e-3, &count, &all));
    for (size_t i = 0; i < count; i++) d = bat_digest_double(d, bat_curve_area(all[i]));
    bat_curves_free(count, all);
    d = add(d, (uint64_t)count), count = 0, all = NULL;
    const bat_nib nib = {0.3, BAT_CAP_BUTT, BAT_JOIN_MITER, 4};
    d = add(d, (uint64_t)bat_curve_outline(curve, &nib, 1e-2, 0.1, &count, &all, NULL));
    bat_curves_free(count, all);
    d = add(d, (uint64_t)count), count = 0, all = NULL;
    d = add(d, (uint64_t)bat_region_offset(both, 0.2, BAT_JOIN_ROUND, 4, 1e-2, 0.1, &count, &all));
    bat_curves_free(count, all);
    d = add(d, (uint64_t)count), count = 0, all = NULL;
    const bat_width_stop stops[] = {{0, 0}, {0.5, 1}, {1, 0.2}};
    const bat_width_profile profile = {3, stops};
    double *points = NULL;
    d = add(d, (uint64_t)bat_curve_cover_width(curve, &nib, &profile, 1e-2, 0.1, &count, &points));
    if (points) d = add_doubles(d, points, (int)(8 * count));
    bat_free(points);
    count = 0;
    d = add(d, (uint64_t)bat_curve_outline_width(curve, &nib, &profile, 1e-2, 0.1, &count, &all, NULL));
    bat_curves_free(count, all);
    return add(d, (uint64_t)count);
}

/* Curves beside curves. */
static uint64_t relate_curve(const void *shared, int seed) {
    const bat_curve *curve = shared;
    bat_curve *other = NULL;
    bat_meeting meeting = {0};
    bat_apart apart = {0};
    size_t count = 0;
    double *points = NULL;
    bat_arc *arcs = NULL;
    uint64_t d = add(bat_digest_begin(), (uint64_t)bat_curve_reverse(curve, &other));
    d = add(d, (uint64_t)bat_curve_hausdorff(curve, other, 1e-3, &apart));
    bat_reference *reference = NULL;
    bat_deviation far = {0};
    d = add(
        d, (uint64_t)bat_reference_create(1, (const bat_curve *const *)&other, 0, NULL, 0, NULL, &reference));
    d = add(d, (uint64_t)bat_curve_deviation(curve, reference, 0, &far));
    bat_reference_free(reference);
    d = bat_digest_double(d, far.greatest);
    d = bat_digest_double(d, apart.distance);
    d = add_blend(d, curve, other);
    d = add(d, (uint64_t)bat_curve_intersect(curve, other, 1e-3, &meeting));
    d = add(d, (uint64_t)meeting.overlap_count);
    bat_meeting_free(&meeting);
    d = add(d, (uint64_t)bat_curve_self_intersect(curve, 1e-3, &meeting));
    d = add(d, (uint64_t)meeting.count);
    bat_meeting_free(&meeting);
    d = add(d, (uint64_t)bat_curve_flatten(curve, 0.1 + 0.01 * seed, &count, &points, NULL));
    d = add(d, (uint64_t)count), bat_free(points);
    d = add(d, (uint64_t)bat_curve_arcs(curve, 0.1, 0.1, &count, &arcs, NULL));
    bat_free(arcs);
    d = add_region(d, curve, other);
    bat_curve_free(other);
    size_t parallels = 0;
    bat_curve **all = NULL;
    d = add(d, (uint64_t)count);
    d = add(d, (uint64_t)bat_curve_offset(curve, 0.2, 0.01, 0.1, &parallels, &all, NULL));
    bat_curves_free(parallels, all);
    return add(d, (uint64_t)parallels);
}

/* Other curves made of one. */
static uint64_t rework_curve(const void *shared, int seed) {
    const bat_curve *curve = shared;
    double error = 0, at = somewhere(curve, seed), end = somewhere(curve, 7);
    const double delta[3] = {1, seed, 2}, turn[6] = {0, 1, seed, -1, 0, 2};
    int removed = 0;
    bat_curve *m = NULL, *other = NULL;
    uint64_t d = add_curve(bat_digest_begin(), bat_curve_copy(curve, &m), &m);
    d = add_curve(d, bat_curve_transform(curve, turn, &m), &m);
    d = add_curve(d, bat_curve_to_dimension(curve, 3, &m), &m);
    d = add_curve(d, bat_curve_insert_knots(curve, 1, &at, &m), &m);
    d = add_curve(d, bat_curve_remove_knot(curve, at, 1, 1, &m, &removed, &error), &m);
    d = add_curve(d, bat_curve_simplify(curve, 0.1, 0.1, &m, &error), &m);
    d = add_curve(d, bat_curve_refit(curve, 0.1, 0.1, &m, &error), &m);
    d = add_curve(d, bat_curve_refit_g1(curve, 0.1, 0.1, &m, &error), &m);
    d = add_curve(d, bat_curve_refit_extremes(curve, 0.1, 0.1, 1, &m, &error), &m);
    d = add_curve(d, bat_curve_elevate(curve, 4, &m), &m);
    d = add_curve(d, bat_curve_clamp(curve, &m), &m);
    d = add_curve(d, bat_curve_reverse(curve, &m), &m);
    d = add_curve(d, bat_curve_reparametrise(curve, 0, 1, &m), &m);
    d = add_curve(d, bat_curve_split(curve, at, &m, &other), &m);
    d = add_curve(d, BAT_OK, &other);
    d = add_curve(d, bat_curve_piece(curve, at, end, &m), &m);
    d = add_curve(d, bat_curve_open_at(curve, at, &m), &m);
    d = add_curve(d, bat_curve_close(curve, 1, &m), &m);
    d = add_curve(d, bat_curve_move_seam(curve, at, &m), &m);
    d = add_curve(d, bat_curve_join(curve, curve, 0, 100, &m, &error), &m);
    d = add_curve(d, bat_curve_drag(curve, 1, &at, delta, &m), &m);
    d = add_curve(d, bat_curve_move_point(curve, 1, delta, &m), &m);
    bat_status status = bat_curve_insert_knot(curve, at, 1, &m);
    if (status != BAT_OK) return add(d, (uint64_t)status);
    d = add(d, bat_curve_is_equal(curve, m));
    status = bat_curve_refine(curve, bat_curve_knot_count(m), bat_curve_knots(m), &other);
    return add_curve(add_curve(d, BAT_OK, &m), status, &other);
}

/* What curves become besides curves. */
static uint64_t convert_curve(const void *shared, int seed) {
    const bat_curve *curve = shared;
    enum { SEGMENTS = 32 };
    double points[SEGMENTS * 8] = {0}, breaks[SEGMENTS + 1] = {0}, *cubics = NULL;
    int count = bat_curve_segment_count(curve);
    char *text = NULL;
    size_t size = 0;
    bat_shape *shape = NULL;
    uint64_t d = add(bat_digest_begin(), (uint64_t)count);
    if (count <= SEGMENTS) d = add(d, (uint64_t)bat_curve_to_bezier(curve, points, breaks));
    bat_status status = bat_curve_to_cubics(curve, 0.01, &count, &cubics);
    d = add_doubles(add_doubles(add(d, (uint64_t)status), points, SEGMENTS * 8), cubics, 8 * count);
    bat_free(cubics);
    d = add_text(d, bat_curve_write(curve, &text, &size), &text, &size);
    d = add_shape(d, bat_shape_create(curve, NULL, &shape), &shape);
    d = add_shape(d, bat_shape_decompose(curve, 1, NULL, &shape), &shape);
    return add_shape(d, bat_shape_decompose_to(curve, 1, (size_t)(5 + seed), NULL, &shape), &shape);
}

static uint64_t draw_over_curve(const void *shared, int seed) {
    double points[120];
    for (int i = 0; i < 60; i++)
        points[2 * i] = 300 + 5 * i, points[2 * i + 1] = 200 + seed + 8 * sin(i / 19.0);
    bat_stroke stroke = {.dimension = 2, .count = 60, .points = points};
    bat_curve *made = NULL;
    bat_sketch_report report = {0};
    bat_sketch_live *live = NULL;
    uint64_t d = add_curve(bat_digest_begin(), bat_sketch(shared, &stroke, NULL, &made, &report), &made);
    d = add_curve(d, bat_sketch_smooth(shared, &stroke, NULL, &made, &report), &made);
    d = add_curve(d, bat_sketch_calm(shared, (double[2]){0.2, 0.6}, 2, 1, &made), &made);
    d = add_curve(d, bat_sketch_join(shared, shared, &stroke, NULL, &made, &report), &made);
    bat_status status = bat_sketch_live_begin(shared, 2, BAT_SKETCH_REDRAW, NULL, &live);
    if (status != BAT_OK) return add(d, (uint64_t)status);
    bat_sketch_live_add(live, &stroke);
    d = add_curve(d, bat_sketch_live_commit(live, &made, &report), &made);
    return bat_digest_double(d, report.max_error);
}

/* Whatever has been computed beforehand for many questions. */
typedef struct prepared {
    bat_finder *finder;
    bat_frame_chain *chain;
} prepared;

static uint64_t ask_prepared(const void *shared, int seed) {
    const prepared *p = shared;
    bat_near near = {0};
    bat_frame3 frame = {0};
    uint64_t digest = bat_digest_begin();
    for (int i = 0; i < 20; i++) {
        const double at[3] = {i - 10.0, seed, 0};
        bat_finder_nearest(p->finder, at, &near);
        bat_frame_chain_at(p->chain, near.u, &frame);
        digest = add_doubles(bat_digest_double(digest, near.distance), frame.s, 3);
    }
    double u[2] = {near.u, near.u}, s[6] = {0};
    bat_frame_options options = bat_frame_defaults();
    const bat_frame_arrays arrays = {.s = s};
    bat_frame_chain_follow(p->chain, &options);
    digest = add(digest, (uint64_t)bat_frame_chain_many(p->chain, 2, u, &arrays));
    digest = bat_digest_double(add_doubles(digest, s, 6), options.holonomy_near);
    return bat_digest_double(digest, bat_frame_chain_holonomy(p->chain));
}

static void const_calls_on_a_curve(void **state) {
    (void)state;
    random_source r = {3};
    for (int kind = 0; kind < 3; kind++) {
        bat_curve *curve = random_curve(&r, 3, 2, kind, 9);
        prepared p = {NULL, NULL};
        assert_alike(evaluate_curve, curve, 7);
        assert_alike(measure_curve, curve, 7);
        assert_alike(relate_curve, curve, 7);
        assert_alike(rework_curve, curve, 7);
        assert_alike(convert_curve, curve, 3);
        assert_int_equal(bat_finder_create(curve, &p.finder), BAT_OK);
        assert_int_equal(bat_frame_chain_create(curve, NULL, &p.chain), BAT_OK);
        assert_alike(ask_prepared, &p, 7);
        bat_finder_free(p.finder);
        bat_frame_chain_free(p.chain);
        bat_curve_free(curve);
    }
    bat_curve *curve = pen_curve(200, 200, 60, 2, 11);
    assert_alike(draw_over_curve, curve, 5);
    bat_curve_free(curve);
}

/* ---- shapes ---- */

static uint64_t look_at_shape(const void *shared, int seed) {
    const bat_shape *shape = shared;
    int top = bat_shape_levels(shape), first = 0;
    size_t count = 0;
    bat_shape *made = NULL;
    bat_curve *flat = NULL;
    char *text = NULL;
    size_t size = 0;
    uint64_t d = add_curve(bat_digest_begin(), bat_shape_flatten(shape, &flat), &flat);
    bat_shape *seen = NULL;
    d = add_shape(d, bat_shape_to_dimension(shape, 3, &seen), &seen);
    for (int l = 1; l <= top; l++) {
        const int n = (int)bat_curve_count(bat_shape_curve(shape, l));
        d = add_doubles(add_doubles(d, bat_shape_details(shape, l), 3 * n), bat_shape_nodes(shape, l), n);
        d = add(add(d, (uint64_t)bat_shape_source(shape, l)[0]), bat_shape_is_muted(shape, l));
        d = bat_digest_double(d, bat_shape_gain(shape, l));
    }
    d = add(d, (uint64_t)bat_shape_options_of(shape)->frame);
    d = add_text(d, bat_shape_write(shape, &text, &size), &text, &size);
    d = add_shape(d, bat_shape_copy(shape, &made), &made);
    d = add_shape(d, bat_shape_copy_levels(shape, bat_shape_curve(shape, 0), &made), &made);
    const double delta[3] = {0, seed, 0}, points[] = {300, seed, 350, 5, 400, 9, 450, 5, 500, 0};
    bat_stroke stroke = {.dimension = 2, .count = 5, .points = points};
    bat_sketch_report report = {0};
    d = add_shape(d, bat_shape_redraw(shape, &stroke, false, NULL, &made, &report), &made);
    bat_shape_live *live = NULL;
    bat_status status = bat_shape_live_begin(shape, 1, &live);
    if (status != BAT_OK) return add(d, (uint64_t)status);
    d = add(d, (uint64_t)bat_shape_live_move(live, 1, 1, delta));
    bat_shape_live_touched(live, top, &first, &count);
    d = bat_digest_curve(add(d, (uint64_t)count), bat_shape_curve(bat_shape_live_shape(live), top));
    return add_shape(d, bat_shape_live_commit(live, &made), &made);
}

static void const_calls_on_a_shape(void **state) {
    (void)state;
    bat_shape *shape = NULL;
    bat_curve *curve = pen_curve(0, 0, 30, 20, 30);
    assert_int_equal(bat_shape_decompose(curve, 2, NULL, &shape), BAT_OK);
    assert_alike(look_at_shape, shape, 5);
    bat_shape_free(shape);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(const_calls_on_a_curve),
        cmocka_unit_test(const_calls_on_a_shape),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
