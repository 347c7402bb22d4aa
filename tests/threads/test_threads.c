/* The promises of base.h about threads: concurrent const calls on one object, distinct objects on distinct threads,
 * copies of one document edited on many. Each job gives a digest of everything that it computed, and each thread must
 * arrive at the digest of a single thread. Under ThreadSanitizer (tree tsan) no job may race. */
#define _POSIX_C_SOURCE 200809L /* barriers */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <pthread.h>
#include <stdatomic.h>
#include <batten/sweep.h>
#include "document/digest.h"
#include "support/pictures.h"
#include "support/random_surface.h"
#include "support/session.h"
#include "support/xml.h"

enum { THREADS = 8, ROUNDS = 4 };

/* ---- running ---- */

typedef uint64_t job(const void *shared, int seed);

typedef struct crew {
    pthread_barrier_t start;
    job *work;
    const void *shared;
    int seeds; /* how many different ones there are */
} crew;

typedef struct hand {
    crew *crew;
    int number;
    uint64_t found[ROUNDS];
} hand;

static void *labour(void *context) {
    hand *h = context;
    pthread_barrier_wait(&h->crew->start);
    for (int i = 0; i < ROUNDS; i++)
        h->found[i] = h->crew->work(h->crew->shared, (h->number + i) % h->crew->seeds);
    return NULL;
}

/* The same job on all threads at once, each round with another seed. */
static void assert_alike(job *work, const void *shared, int seeds) {
    crew all = {.work = work, .shared = shared, .seeds = seeds};
    hand hands[THREADS];
    pthread_t threads[THREADS];
    assert_int_equal(pthread_barrier_init(&all.start, NULL, THREADS), 0);
    for (int i = 0; i < THREADS; i++) {
        hands[i] = (hand){.crew = &all, .number = i};
        assert_int_equal(pthread_create(&threads[i], NULL, labour, &hands[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
    pthread_barrier_destroy(&all.start);
    for (int i = 0; i < THREADS; i++)
        for (int k = 0; k < ROUNDS; k++) assert_true(hands[i].found[k] == work(shared, (i + k) % seeds));
}

/* ---- digests of results ---- */

static uint64_t add(uint64_t digest, uint64_t number) { return bat_digest_number(digest, number); }

static uint64_t add_doubles(uint64_t digest, const double *numbers, int count) {
    for (int i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

/* What a call has made, and its status; frees it. */
static uint64_t add_curve(uint64_t digest, bat_status status, bat_curve **made) {
    digest = add(digest, (uint64_t)status);
    if (*made) digest = bat_digest_curve(digest, *made);
    bat_curve_free(*made);
    *made = NULL;
    return digest;
}

static uint64_t add_text(uint64_t digest, bat_status status, char **text, const size_t *size) {
    digest = add(digest, (uint64_t)status);
    if (*text) digest = bat_digest_bytes(digest, *text, *size);
    bat_free(*text);
    *text = NULL;
    return digest;
}

static uint64_t add_shape(uint64_t digest, bat_status status, bat_shape **made) {
    char *text = NULL;
    size_t size = 0;
    digest = add(digest, (uint64_t)status);
    if (*made) digest = add_text(digest, bat_shape_write(*made, &text, &size), &text, &size);
    bat_shape_free(*made);
    *made = NULL;
    return digest;
}

static uint64_t add_object(uint64_t digest, bat_status status, bat_object **made) {
    double box[4] = {0};
    digest = add(digest, (uint64_t)status);
    if (*made) {
        bat_object_bounds(*made, box);
        digest = bat_digest_text(add_doubles(digest, box, 4), bat_object_name(*made));
    }
    bat_object_release(*made);
    *made = NULL;
    return digest;
}

/* ---- const calls on one curve ---- */

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

/* ---- const calls on one surface ---- */

static uint64_t add_surface(uint64_t digest, bat_status status, bat_surface **made) {
    char *text = NULL;
    size_t size = 0;
    digest = add(digest, (uint64_t)status);
    if (*made) digest = add_text(digest, bat_surface_write(*made, &text, &size), &text, &size);
    bat_surface_free(*made);
    *made = NULL;
    return digest;
}

static uint64_t add_cast(uint64_t digest, const bat_surface *surface, int seed) {
    const bat_viewpoint view = {.eye = {seed, -40, 5}, .up = {0, 0, 1}, .size = {100, 100}, .fov = 40};
    const double pixels[] = {50, 50, 52, 51};
    const bat_stroke stroke = {.dimension = 2, .count = 2, .points = pixels};
    bat_canvas canvas = {.along = {0, 0, 1}, .surface = (bat_surface *)surface};
    bat_cast_point out[2] = {{.fate = BAT_CAST_LANDED}};
    for (int ruled = 0; ruled < 2; ruled++) {
        if (ruled && bat_surface_isocurve(surface, BAT_U, 0.5, &canvas.curve) != BAT_OK) return digest;
        digest = add(digest, (uint64_t)bat_cast(&view, &stroke, &canvas, out, NULL));
        digest = add_doubles(add(digest, out[0].fate), out[0].point, 3);
    }
    bat_curve_free(canvas.curve);
    bat_surface_pick pick = {.value = 0};
    digest = add(digest, (uint64_t)bat_surface_pick_line(&view, &stroke, surface, &pick));
    digest = bat_digest_double(digest, pick.value);
    bat_surface *made = NULL;
    digest = add(digest,
                 (uint64_t)bat_surface_sketch(surface, BAT_U, 0.5, &view, &stroke, NULL, &made, NULL, NULL));
    bat_surface_free(made);
    return digest;
}

/* Surfaces from its edges, on all threads at once. */
static uint64_t add_made(uint64_t digest, const bat_surface *s, int seed) {
    static const double origin[3] = {50, 0, 0}, axis[3] = {0, 1, 0};
    bat_curve *line[4] = {NULL};
    double domain[2];
    bat_surface *made = NULL;
    bat_status status = BAT_OK;
    for (int k = 0; k < 4 && status == BAT_OK; k++) {
        bat_surface_domain(s, BAT_U, domain);
        status = bat_surface_isocurve(s, BAT_U, domain[0] + (domain[1] - domain[0]) * (k + 1) / 6, &line[k]);
    }
    const bat_curve *given[4] = {line[0], line[1], line[2], line[3]};
    if (status == BAT_OK) {
        status = bat_surface_revolve(line[seed % 4], origin, axis, 1 + seed, 0.1, &made, NULL);
        digest = add_surface(digest, status, &made);
        status = bat_surface_loft(4, given, &made, NULL);
        digest = add_surface(digest, status, &made);
        status = bat_surface_coons(given, 100, &made, NULL);
        digest = add_surface(digest, status, &made);
    }
    for (int k = 0; k < 4; k++) bat_curve_free(line[k]);
    return digest;
}

static uint64_t add_tracks(uint64_t digest, bat_status status, bat_tracks *tracks) {
    digest = add(digest, (uint64_t)status);
    if (!tracks) return digest;
    digest = add(add(digest, (uint64_t)bat_tracks_count(tracks)), bat_tracks_is_given_up(tracks));
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *points;
        const size_t count = bat_tracks_points(tracks, i, &points);
        digest = add(add(digest, (uint64_t)count), bat_tracks_is_closed(tracks, i));
        digest = add_doubles(digest, points[count / 2].point, 3);
    }
    for (size_t i = 0; i < bat_tracks_crossing_count(tracks); i++)
        digest = add_doubles(digest, bat_tracks_crossing(tracks, i)->point, 3);
    bat_tracks_free(tracks);
    return digest;
}

static uint64_t add_traces(uint64_t digest, const bat_surface *surface, int seed) {
    const bat_viewpoint view = {.eye = {seed, -40, 5}, .up = {0, 0, 1}, .size = {100, 100}, .fov = 40};
    const double at[3] = {0, 0, 1}, normal[3] = {0.1, 0, 1};
    bat_tracks *tracks = NULL;
    bat_status status = bat_surface_silhouettes(surface, &view, &tracks);
    digest = add_tracks(digest, status, tracks);
    tracks = NULL;
    status = bat_surface_section(surface, at, normal, 0.01, &tracks);
    digest = add_tracks(digest, status, tracks);
    const double corners[] = {-1, -1, seed, -1, 1, 1, 1, -1, 0, 1, 1, 2}, knots[] = {0, 0, 1, 1};
    bat_surface *other = NULL;
    if (bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false}, (const size_t[2]){2, 2},
                           corners, (const int[2]){4, 4}, knots, knots, &other) != BAT_OK)
        return digest;
    tracks = NULL;
    bat_intersect_options options = bat_intersect_defaults();
    options.chord = 0.1, options.leaf = 1;
    status = bat_surface_intersect(surface, other, &options, &tracks);
    bat_curve *curve = NULL;
    if (tracks && bat_tracks_count(tracks) > 0)
        digest = add(digest, (uint64_t)bat_tracks_curve(tracks, 0, 1, &curve));
    bat_curve_free(curve);
    bat_surface_free(other);
    return add_tracks(digest, status, tracks);
}

typedef struct swept {
    bat_sweep *sweep;
    bat_function function;
} swept;
static uint64_t look_at_sweep(const void *shared, int seed) {
    const swept *w = shared;
    double domain[2], folds[4][2] = {{0}}, value[3];
    size_t count = 0;
    bat_sweep_point at;
    bat_surface *made = NULL;
    bat_sweep_domain(w->sweep, BAT_U, domain);
    bat_sweep_at(w->sweep, domain[0] + 0.1 * seed, 0.5, &at);
    bat_function_eval(&w->function, 0.2 * seed, value);
    uint64_t d = add_doubles(add_doubles(bat_digest_begin(), at.point, 3), value, 3);
    d = add(bat_digest_double(d, bat_sweep_holonomy(w->sweep)), (uint64_t)bat_function_check(&w->function));
    d = add(add(d, (uint64_t)bat_sweep_folds(w->sweep, 4, folds[0], &count)), count);
    return add_surface(d, bat_sweep_surface(w->sweep, 0.1, &made, NULL), &made);
}
static void const_calls_on_a_sweep(void **state) {
    (void)state;
    const double points[12] = {0, 0, 0, 5, 1, 0, 6, 7, 2, 0, 8, 5}, across[4] = {-1, 0, 1, 1},
                 knots[4] = {0, 0, 1, 1};
    bat_curve *path = NULL, *profile = NULL;
    swept w = {NULL, {0, NULL}};
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &path), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, across, &profile), BAT_OK);
    assert_int_equal(bat_curve_create(2, 1, false, 2, across, 4, knots, &w.function.curve), BAT_OK);
    bat_sweep_options options = bat_sweep_defaults();
    options.twist = w.function;
    assert_int_equal(bat_sweep_create(path, profile, &options, &w.sweep), BAT_OK);
    assert_alike(look_at_sweep, &w, 4);
    bat_sweep_free(w.sweep), bat_function_clear(&w.function);
    bat_curve_free(path), bat_curve_free(profile);
}

static uint64_t add_lines(uint64_t digest) {
    const bat_viewpoint view = {.eye = {3, -40, 5}, .up = {0, 0, 1}, .size = {40, 40}, .fov = 40};
    const double corners[] = {-1, -1, 0, -1, 1, 1, 1, -1, 0, 1, 1, 2}, knots[] = {0, 0, 1, 1};
    bat_surface *patch = NULL;
    bat_line_drawing *drawing = NULL;
    if (bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false}, (const size_t[2]){2, 2},
                           corners, (const int[2]){4, 4}, knots, knots, &patch) != BAT_OK)
        return digest;
    const bat_surface *list = patch;
    const bat_line_scene scene = {1, &list, 0, NULL};
    digest = add(digest, (uint64_t)bat_line_drawing_create(&view, &scene, &drawing));
    for (size_t i = 0; drawing && i < bat_line_drawing_count(drawing); i++) {
        bat_seen_line line;
        bat_line_drawing_at(drawing, i, &line);
        digest = add_doubles(add(digest, line.hidden), line.points, 6 * line.segments + 2);
    }
    if (drawing) digest = add(digest, bat_line_drawing_is_whole(drawing));
    bat_line_drawing_free(drawing);
    bat_surface_free(patch);
    return digest;
}

static uint64_t look_at_surface(const void *shared, int seed) {
    const bat_surface *s = shared;
    double out[18] = {0}, u[4], v[4], grid[48], low[3], high[3], domain[2];
    bat_surface_spread(s, BAT_U, 4, u);
    bat_surface_spread(s, BAT_V, 4, v);
    bat_surface_domain(s, BAT_U, domain);
    bat_surface_box(s, low, high);
    uint64_t d = add_doubles(add_doubles(bat_digest_begin(), low, 3), high, 3);
    d = add_doubles(bat_digest_double(d, bat_surface_size(s)), domain, 2);
    d = add(add(d, bat_surface_is_closed(s, BAT_V)), (uint64_t)bat_surface_degree(s, BAT_U));
    d = add_doubles(d, bat_surface_row(s, seed % 2), 3 * (int)bat_surface_count(s, BAT_V));
    d = add_doubles(d, bat_surface_knots(s, BAT_U), bat_surface_knot_count(s, BAT_U));
    bat_surface_eval(s, u[seed % 4], v[1], 2, out);
    d = add(add_doubles(d, out, 18), (uint64_t)bat_surface_eval_grid(s, 4, u, 4, v, 0, grid));
    d = add(add_doubles(d, grid, 48), (uint64_t)bat_surface_normal_grid(s, 4, u, 4, v, NULL, grid));
    d = add(add_doubles(d, grid, 48), (uint64_t)bat_surface_normal(s, u[seed % 4], v[2], out));
    d = add(add_doubles(d, out, 3), (uint64_t)bat_surface_curvature(s, u[1], v[seed % 4], out, out + 1));
    bat_surface_point at[8] = {{0}};
    const double from[3] = {seed, 2, 30}, way[3] = {0.1, 0, -3};
    size_t count = 0;
    d = add(d, (uint64_t)bat_surface_nearest(s, from, at));
    d = bat_digest_double(bat_digest_double(d, at[0].distance), at[0].u);
    d = add(d, (uint64_t)bat_surface_hits(s, from, way, 8, at, &count));
    bat_tessellation *triangles = NULL;
    bat_mesh mesh = {.rows = 0};
    d = add(d, (uint64_t)bat_surface_tessellate(s, NULL, &triangles, NULL));
    d = add(d, (uint64_t)bat_tessellation_update(triangles, s, BAT_U, domain, NULL));
    bat_tessellation_mesh(triangles, &mesh);
    d = add_doubles(add(d, mesh.triangle_count), mesh.normals, (int)(3 * mesh.rows * mesh.columns));
    bat_tessellation_free(triangles);
    bat_surface_finder *finder = NULL;
    d = add(d, (uint64_t)bat_surface_finder_create(s, &finder));
    d = add(d, (uint64_t)bat_surface_finder_nearest(finder, from, at));
    d = add(d, (uint64_t)bat_surface_finder_hits(finder, from, way, 8, at, &count));
    bat_surface_finder_free(finder);
    d = bat_digest_double(add(d, (uint64_t)count), at[0].distance);
    d = add_lines(add_traces(add_made(add_cast(d, s, seed), s, seed), s, seed));
    bat_curve *line = NULL;
    bat_surface *made = NULL, *fine = NULL;
    d = add_curve(d, bat_surface_isocurve(s, BAT_V, v[seed % 4], &line), &line);
    bat_status drawn = bat_surface_isocurve(s, BAT_V, v[1], &line);
    if (drawn == BAT_OK)
        drawn = bat_surface_redraw(s, BAT_V, v[1] + 0.01 * seed, line, NULL, &made, NULL, NULL);
    d = add_surface(add_curve(d, BAT_OK, &line), drawn, &made);
    const double turn[12] = {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, seed};
    d = add_surface(d, bat_surface_transform(s, turn, &made), &made);
    d = add_surface(d, bat_surface_copy(s, &made), &made);
    bat_status status = bat_surface_insert_knots(s, BAT_U, 1, &u[1], &fine);
    if (status != BAT_OK) return add(d, (uint64_t)status);
    d = add(d, bat_surface_is_equal(s, fine));
    status = bat_surface_refine(s, BAT_U, bat_surface_knot_count(fine, BAT_U), bat_surface_knots(fine, BAT_U),
                                &made);
    return add_surface(add_surface(d, BAT_OK, &fine), status, &made);
}

static void const_calls_on_a_surface(void **state) {
    (void)state;
    random_source r = {8};
    bat_surface *surface = random_surface(&r, (const int[2]){3, 3}, (const int[2]){2, 0},
                                          (const int[2]){6, 6});
    assert_alike(look_at_surface, surface, 4);
    bat_surface_free(surface);
}

/* ---- const calls on one shape ---- */

static uint64_t look_at_shape(const void *shared, int seed) {
    const bat_shape *shape = shared;
    int top = bat_shape_levels(shape), first = 0;
    size_t count = 0;
    bat_shape *made = NULL;
    bat_curve *flat = NULL;
    char *text = NULL;
    size_t size = 0;
    uint64_t d = add_curve(bat_digest_begin(), bat_shape_flatten(shape, &flat), &flat);
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

/* ---- documents ---- */

/* Takes the object over. */
static void put(bat_document *document, bat_object *object) {
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

/* One of each kind that shares something: curves, a spline, levels, a picture. */
static bat_document *rich_document(void) {
    random_source r = {11};
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_style style = bat_style_defaults();
    bat_object *object = NULL, *shaped = NULL;
    for (bat_id id = 1; id <= 6; id++) {
        bat_curve *curves[2] = {random_curve(&r, 3, 2, 0, 5), random_curve(&r, 3, 2, 2, 5)};
        assert_int_equal(bat_object_create_path(id, "path", &style, 2, curves, &object), BAT_OK);
        put(document, object);
    }
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4};
    bat_spline spline = {.dimension = 2, .count = 4, .points = points};
    assert_int_equal(bat_object_create_spline(7, "spline", &style, &spline, NULL, &object), BAT_OK);
    put(document, object);
    bat_curve *curve = pen_curve(0, 0, 30, 20, 20);
    bat_shape *shape = NULL;
    assert_int_equal(bat_shape_decompose(curve, 2, NULL, &shape), BAT_OK);
    assert_int_equal(bat_object_create_path(8, "shape", &style, 1, &curve, &object), BAT_OK);
    assert_int_equal(bat_object_with_shape(object, 0, shape, &shaped), BAT_OK);
    bat_object_release(object);
    put(document, shaped);
    bat_picture *picture = make_picture(30, 20, 5);
    const double matrix[6] = {1, 0, 0, 1, 5, 5};
    assert_int_equal(bat_object_create_image(9, "image", picture, matrix, 0.5, &object), BAT_OK);
    put(document, object);
    bat_picture_release(picture);
    assert_int_equal(bat_object_create_guide(10, 0, 3, &object), BAT_OK);
    put(document, object);
    assert_int_equal(bat_object_create_plane(11, "plane", matrix, (double[]){1, 0, 0, 0, 1, 0}, &object),
                     BAT_OK);
    put(document, object);
    bat_surface *sheet = some_surface(&(random_source){6}, 5);
    assert_int_equal(bat_object_create_surface(12, "surface", &style, sheet, &object), BAT_OK);
    put(document, object);
    bat_surface_free(sheet);
    return document;
}

static uint64_t look_at_object(uint64_t d, const bat_object *object) {
    double corners[8] = {0}, at = 0, box[4];
    size_t size = 0;
    bat_object_bounds(object, box);
    bat_object_corners(object, corners);
    d = add_doubles(add_doubles(d, box, 4), corners, 8);
    d = add(add(d, bat_object_id(object)), (uint64_t)bat_object_kind(object));
    d = add(add(d, bat_object_is_group(object)), bat_object_is_drawn(object));
    d = add(add(d, bat_object_parent(object)), (uint64_t)(bat_object_guide(object, &at) + 1));
    d = add(add(d, bat_object_is_hidden(object)), bat_object_is_locked(object));
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        d = bat_digest_curve(d, bat_object_curve(object, i));
        const bat_shape *shape = bat_object_shape(object, i);
        if (shape) d = add(d, (uint64_t)bat_shape_levels(shape));
    }
    if (bat_object_spline(object)) d = add(d, (uint64_t)bat_object_spline_options(object)->mode);
    if (bat_object_matrix(object)) d = add_doubles(d, bat_object_matrix(object), 6);
    if (bat_object_plane(object)) d = add_doubles(d, bat_object_plane(object), 9);
    const bat_surface *surface = bat_object_surface(object);
    if (surface) d = add_doubles(d, bat_surface_row(surface, 0), 3);
    const bat_picture *picture = bat_object_picture(object);
    if (!picture) return bat_digest_double(d, at);
    const void *bytes = bat_picture_bytes(picture, &size);
    bat_picture_sides(picture, box);
    d = bat_digest_bytes(add_doubles(d, box, 2), bytes, size);
    return bat_digest_text(add(d, bat_picture_digest(picture)), bat_picture_type(picture));
}

/* All that gives another object of one. */
static uint64_t vary(uint64_t d, const bat_object *object, int seed) {
    bat_style style = *bat_object_style(object);
    style.opacity = seed / 8.0;
    bat_object *m = NULL;
    bat_curve *curve = NULL, *other = NULL;
    d = add_object(d, bat_object_with_style(object, &style, &m), &m);
    d = add_object(d, bat_object_with_name(object, "other", &m), &m);
    d = add_object(d, bat_object_with_id(object, 1000 + (bat_id)seed, &m), &m);
    d = add_object(d, bat_object_with_state(object, true, seed & 1, &m), &m);
    d = add_object(d, bat_object_with_parent(object, 500, &m), &m);
    d = add_object(d, bat_object_with_guide(object, seed, &m), &m);
    d = add_object(d, bat_object_to_path(object, &m), &m);
    if (bat_object_is_made_of_curves(object) &&
        bat_curve_copy(bat_object_curve(object, 0), &curve) == BAT_OK) {
        if (bat_curve_copy(curve, &other) == BAT_OK)
            d = add_object(d, bat_object_with_curves(object, 1, &other, &m), &m);
        d = add_object(d, bat_object_with_curve(object, 0, curve, &m), &m);
    }
    bat_shape *shape = NULL;
    if (bat_object_shape(object, 0) && bat_shape_copy(bat_object_shape(object, 0), &shape) == BAT_OK)
        d = add_object(d, bat_object_with_shape(object, 0, shape, &m), &m);
    if (bat_object_spline(object))
        d = add_object(d, bat_object_with_spline(object, bat_object_spline(object), &m), &m);
    if (bat_object_surface(object))
        d = add_object(d, bat_object_with_surface(object, bat_object_surface(object), &m), &m);
    if (bat_object_picture(object)) {
        double matrix[6] = {2, 0, 0, 2, seed, 0};
        bat_picture *picture = bat_picture_retain(bat_object_picture(object));
        d = add_object(d, bat_object_create_image(77, "", picture, matrix, 1, &m), &m);
        bat_picture_release(picture);
        d = add_object(d, bat_object_with_matrix(object, matrix, &m), &m);
    }
    bat_object_release(bat_object_retain(object));
    return d;
}

static uint64_t look_at_document(const void *shared, int seed) {
    const bat_document *document = shared;
    double box[4], page[4];
    char *text = NULL;
    size_t size = 0;
    bat_document *copy = NULL;
    uint64_t digest = bat_document_digest(document);
    bat_document_bounds(document, box);
    bat_document_page(document, page);
    digest = add_doubles(add_doubles(digest, box, 4), page, 4);
    digest = add(digest, bat_document_check(document) == NULL);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        digest = add(digest, (uint64_t)bat_document_find(document, bat_object_id(object)));
        digest = add(digest, (uint64_t)bat_document_end(document, i));
        digest = vary(look_at_object(digest, object), object, seed);
    }
    digest = add_text(digest, bat_document_write(document, &text, &size), &text, &size);
    digest = add_text(digest, bat_svg_write(document, true, &text, &size), &text, &size);
    bat_status status = bat_document_copy(document, &copy);
    bat_document_free(copy);
    return add(digest, (uint64_t)status);
}

static void const_calls_on_a_document(void **state) {
    (void)state;
    bat_document *document = rich_document();
    assert_alike(look_at_document, document, 5);
    bat_document_free(document);
}

/* Everything that changes a document, on a copy that is this thread's own. */
static uint64_t edit_copy(bat_document *own, int seed) {
    uint64_t digest = bat_digest_begin();
    for (int round = 0; round < 12; round++) {
        int at = (round * 7 + seed) % bat_document_count(own);
        const bat_object *object = bat_document_at(own, at);
        bat_object *made = NULL, *twin = NULL;
        bat_style style = *bat_object_style(object);
        style.opacity = (round + seed) % 9 / 8.0;
        bat_status status = bat_object_with_style(object, &style, &made);
        if (status == BAT_OK) status = bat_document_replace(own, at, made);
        bat_object_release(made);
        object = bat_document_at(own, at);
        if (bat_object_is_made_of_curves(object)) {
            bat_curve *moved = NULL;
            const double delta[3] = {seed, round, 1};
            bat_object *other = NULL;
            if (bat_curve_move_point(bat_object_curve(object, 0), 1, delta, &moved) == BAT_OK)
                bat_object_with_curve(object, 0, moved, &other);
            if (other) bat_document_replace(own, at, other);
            bat_object_release(other);
        }
        if (bat_object_with_id(bat_document_at(own, at), bat_document_new_id(own), &twin) == BAT_OK)
            bat_document_insert(own, round % 2 ? at : 0, twin);
        bat_object_release(twin);
        if (round % 3 == 2) bat_document_remove(own, at);
        digest = add(add(digest, (uint64_t)status), bat_document_digest(own));
    }
    return digest;
}

static uint64_t edit_a_copy(const void *shared, int seed) {
    bat_document *own = NULL;
    if (bat_document_copy(shared, &own) != BAT_OK) return 0;
    uint64_t digest = edit_copy(own, seed);
    bat_document_free(own);
    return digest;
}

static void copies_edited_on_many_threads(void **state) {
    (void)state;
    bat_document *document = rich_document();
    uint64_t before = bat_document_digest(document);
    for (int i = 0; i < 4; i++) assert_alike(edit_a_copy, document, 5);
    assert_true(bat_document_digest(document) == before);
    assert_null(bat_document_check(document));
    bat_document_free(document);
}

/* Each thread has a copy, made before, and the last users of what they share go on any of them. */
typedef struct owner {
    pthread_barrier_t *start;
    bat_document *own;
    int seed;
    uint64_t found;
} owner;

static void *use_up(void *context) {
    owner *o = context;
    pthread_barrier_wait(o->start);
    o->found = edit_copy(o->own, o->seed);
    bat_document_free(o->own);
    return NULL;
}

static void the_original_goes_first(void **state) {
    (void)state;
    for (int round = 0; round < 10; round++) {
        bat_document *document = rich_document(), *check = rich_document();
        owner owners[THREADS];
        pthread_t threads[THREADS];
        pthread_barrier_t start;
        assert_int_equal(pthread_barrier_init(&start, NULL, THREADS), 0);
        for (int i = 0; i < THREADS; i++) {
            owners[i] = (owner){.start = &start, .seed = i % 3};
            assert_int_equal(bat_document_copy(document, &owners[i].own), BAT_OK);
        }
        bat_document_free(document);
        for (int i = 0; i < THREADS; i++)
            assert_int_equal(pthread_create(&threads[i], NULL, use_up, &owners[i]), 0);
        for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
        for (int i = 0; i < THREADS; i++) assert_true(owners[i].found == edit_a_copy(check, i % 3));
        pthread_barrier_destroy(&start);
        bat_document_free(check);
    }
}

/* ---- editors ---- */

static uint64_t look_at_editor(const void *shared, int seed) {
    const bat_editor *editor = shared;
    double value = 0;
    size_t size = 0;
    uint64_t digest = bat_document_digest(bat_editor_document(editor));
    digest = add(digest, (uint64_t)bat_editor_get(editor, "tolerance", &value));
    digest = bat_digest_double(digest, value + bat_editor_pressure(editor, seed / 8.0));
    const char *journal = bat_editor_journal(editor, &size);
    digest = bat_digest_bytes(digest, journal, size);
    digest = add(digest, bat_editor_picture(editor, 1) != NULL);
    digest = add(digest, (uint64_t)bat_losses_total(bat_editor_losses(editor)));
    return add(digest, bat_editor_check(editor) == NULL);
}

static void const_calls_on_an_editor(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_line(&p, 300, 205, 700, 205, 8);
    bat_editor_frame(editor);
    assert_alike(look_at_editor, editor, 5);
    bat_editor_free(editor);
}

static uint64_t play(bat_editor *editor, int seed) {
    uint8_t data[400];
    uint64_t random = (uint64_t)seed + 1;
    for (size_t i = 0; i < sizeof data; i++) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        data[i] = (uint8_t)(random >> 56);
    }
    session_bytes bytes = {data, sizeof data, 0};
    double time = 0;
    while (bytes.at < bytes.size) session_event(editor, &bytes, &time);
    uint64_t digest = bat_document_digest(bat_editor_document(editor));
    bat_editor_free(editor);
    return digest;
}

static uint64_t play_alone(const void *shared, int seed) {
    (void)shared;
    return play(pen_editor(), seed);
}

/* Editors of their own, each on a copy of the document that all have, or with what is in it. */
static uint64_t play_on_a_copy(const void *shared, int seed) {
    bat_editor *editor = pen_editor();
    bat_document *own = NULL;
    if (bat_document_copy(shared, &own) == BAT_OK) bat_editor_open(editor, own, "copy");
    bat_editor_paste(editor, shared, true);
    return play(editor, seed);
}

static uint64_t read_svg(const void *shared, int seed) {
    (void)seed;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    if (xml_read(shared, NULL, &document, &report, &problem) != BAT_OK) return 0;
    uint64_t digest = bat_document_digest(document);
    bat_document_free(document);
    return digest;
}

static void editors_and_readers_apart(void **state) {
    (void)state;
    bat_document *document = rich_document();
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
    assert_alike(read_svg, text, 1);
    assert_alike(play_alone, NULL, 3);
    assert_alike(play_on_a_copy, document, 3);
    bat_free(text);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(const_calls_on_a_curve),    cmocka_unit_test(const_calls_on_a_surface),
        cmocka_unit_test(const_calls_on_a_sweep),    cmocka_unit_test(const_calls_on_a_shape),
        cmocka_unit_test(const_calls_on_a_document), cmocka_unit_test(copies_edited_on_many_threads),
        cmocka_unit_test(the_original_goes_first),   cmocka_unit_test(const_calls_on_an_editor),
        cmocka_unit_test(editors_and_readers_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
