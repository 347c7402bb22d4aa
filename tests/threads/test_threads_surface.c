/* The promise of base.h about threads: concurrent const calls on one surface, one sweep, one camera move, one
 * take. */
#include "alike.h"
#include "support/random_surface.h"

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
        const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_RULED);
        status = bat_recipe_surface(&recipe, 2, given, &made, NULL);
        digest = add(add_surface(digest, status, &made), (uint64_t)bat_recipe_stands(given[0], given[1]));
        status = bat_surface_loft(4, given, &made, NULL);
        digest = add_surface(digest, status, &made);
        status = bat_surface_coons(given, 100, &made, NULL);
        digest = add_surface(digest, status, &made);
        status = bat_surface_blend_curve(s, BAT_SIDE_U1, given[0], NULL, &made);
        digest = add_surface(digest, status, &made);
        status = bat_surface_blend(s, BAT_SIDE_U1, s, BAT_SIDE_U0, NULL, &made);
        digest = add_surface(digest, status, &made);
        status = bat_surface_match(s, BAT_SIDE_U1, s, BAT_SIDE_U0, 2, 1, &made, NULL);
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

/* A relief: read, written, taken apart and carried over on all threads at once. */
static uint64_t add_relief(uint64_t digest, bat_status status, bat_relief *made) {
    char *text = NULL;
    size_t size = 0;
    digest = add(digest, (uint64_t)status);
    if (made) digest = add_text(digest, bat_relief_write(made, &text, &size), &text, &size);
    bat_relief_free(made);
    return digest;
}
static uint64_t look_at_relief(const void *shared, int seed) {
    const bat_relief *r = shared;
    const int level = bat_relief_levels(r);
    const bat_surface *s = bat_relief_surface(r, level), *base = bat_relief_surface(r, 0);
    bat_relief *made[6] = {NULL};
    bat_curve *line = NULL;
    uint64_t d = add(bat_digest_begin(), bat_relief_is_muted(r, level));
    d = add(bat_digest_double(d, bat_relief_gain(r, level)), (uint64_t)bat_relief_source(r, level)[seed]);
    d = add_doubles(d, bat_relief_details(r, level), 3);
    d = add_relief(d, bat_relief_copy(r, &made[0]), made[0]);
    d = add_relief(d, bat_relief_decompose(s, 1, &made[1]), made[1]);
    d = add_relief(d, bat_relief_decompose_to(s, 1, (const size_t[2]){5, 5}, &made[2]), made[2]);
    d = add_relief(d, bat_relief_create(base, &made[4]), made[4]);
    if (bat_surface_isocurve(base, BAT_U, 0.3, &line) == BAT_OK && bat_relief_copy(r, &made[5]) == BAT_OK)
        d = add_relief(d, bat_relief_redraw(made[5], 0, BAT_U, 0.3, line, NULL, NULL, NULL), made[5]);
    bat_curve_free(line);
    return add_relief(d, bat_relief_copy_levels(r, base, &made[3]), made[3]);
}
static void const_calls_on_a_relief(void **state) {
    (void)state;
    random_source r = {8};
    bat_surface *s = random_surface(&r, (const int[2]){3, 3}, (const int[2]){0, 2}, (const int[2]){9, 9});
    bat_relief *relief = NULL;
    assert_int_equal(bat_relief_decompose(s, 2, &relief), BAT_OK);
    assert_alike(look_at_relief, relief, 4);
    bat_relief_free(relief);
    bat_surface_free(s);
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
    d = add(bat_digest_double(d, bat_sweep_holonomy(w->sweep)),
            (uint64_t)bat_function_check(&w->function, NULL));
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

/* ---- camera moves ---- */

static uint64_t look_through(const void *shared, int seed) {
    const bat_camera *camera = shared;
    const double times[2] = {0.5 * seed, 3.5};
    bat_camera_pose pose[3] = {{.u = 0}};
    double domain[2] = {0}, held[2] = {0};
    size_t count = 0;
    bat_camera *copy = NULL;
    bat_camera_domain(camera, domain);
    bat_camera_at(camera, 0.2 * seed, &pose[0]);
    bat_camera_at_time(camera, seed, &pose[1]);
    uint64_t d = add_doubles(add_doubles(bat_digest_begin(), pose[0].rotation, 4), pose[1].rotation, 4);
    d = add(d, (uint64_t)bat_camera_sample(camera, 2, times, pose));
    d = bat_digest_double(add_doubles(d, pose[1].rotation, 4), bat_camera_length(camera) + domain[1]);
    d = bat_digest_double(d, bat_camera_duration(camera) + bat_camera_least_norm(camera) +
                                 bat_camera_gain(camera, 1));
    d = add(add(d, bat_camera_held(camera, 1, held)), (uint64_t)bat_camera_levels(camera));
    d = bat_digest_double(d, bat_camera_key_place(camera, 0));
    bat_camera_shake shake;
    d = add(d, (uint64_t)bat_camera_shake_of(camera, 1, &shake));
    d = add(d, bat_camera_is_muted(camera, 1) + 2 * (uint64_t)(bat_camera_timing(camera)->curve != NULL));
    bat_camera *aimed[2] = {NULL};
    const double far[3] = {1e3, 2, 3}, up[3] = {0, 0, 1};
    d = add(d, (uint64_t)bat_camera_aim(camera, far, up, &aimed[0]));
    d = add(d, (uint64_t)bat_camera_let_go(camera, up, &aimed[1]));
    for (int k = 0; k < 2; k++) d = aimed[k] ? bat_digest_double(d, bat_camera_length(aimed[k])) : d;
    if (aimed[0]) d = add(d, (uint64_t)bat_camera_take_levels(aimed[0], camera));
    bat_camera_free(aimed[0]), bat_camera_free(aimed[1]);
    const double *keys = bat_camera_base(camera, &count);
    d = add_doubles(d, keys, 4 * (int)count);
    if (bat_camera_details(camera, 1)) d = bat_digest_curve(d, bat_camera_details(camera, 1));
    bat_camera_key *list = NULL;
    char *bytes = NULL;
    size_t size = 0;
    d = add(d, (uint64_t)bat_camera_keys(camera, 1, 0.5, &count, &list));
    d = add(bat_digest_curve(d, bat_camera_path(camera)), count);
    bat_free(list);
    const bat_status written = bat_gltf_write_move(camera, 1, 0.5, &bytes, &size);
    d = add_text(d, written, &bytes, &size);
    d = add(d, (uint64_t)bat_camera_mode_of(camera));
    const bat_status scene = bat_gltf_write_scene(camera, NULL, 1, 0.5, &bytes, &size);
    d = add_text(d, scene, &bytes, &size);
    char *text = NULL;
    size_t length = 0;
    d = add_text(d, bat_camera_write(camera, &text, &length), &text, &length);
    d = add(d, (uint64_t)bat_camera_with_path(camera, bat_camera_path(camera), &copy));
    bat_camera_free(copy), copy = NULL;
    d = add(d, (uint64_t)bat_camera_copy(camera, &copy));
    bat_camera_free(copy);
    return d;
}

/* ---- motion ---- */

static uint64_t look_at_take(const void *shared, int seed) {
    const bat_take *take = shared;
    size_t frames = 0, channels = 0;
    int count = 0;
    double at[6];
    bat_motion_options options = bat_motion_defaults();
    options.tolerance = 0.1 * seed;
    const bat_bone *bones = bat_take_joints(take, &count);
    uint64_t d = add_doubles(bat_digest_begin(), bat_take_values(take, &frames, &channels), 4);
    d = add(add(d, (uint64_t)count), (uint64_t)bones[0].channel_count);
    d = add(d, (uint64_t)bat_take_positions(take, (size_t)seed % frames, at));
    d = bat_digest_double(add_doubles(d, at, 6), bat_take_frame_time(take));
    char *text = NULL;
    size_t length = 0;
    d = add_text(d, bat_bvh_write(take, &text, &length), &text, &length);
    bat_motion *motion = NULL;
    bat_motion_report report;
    d = add(d, (uint64_t)bat_motion_fit(take, &options, &motion, &report));
    if (!motion) return d;
    const double way[12] = {0, 0, 0, 1, 0, 3, 2, 1, 4, 5, 0, 6};
    bat_curve *path = NULL;
    if (bat_curve_create_clamped(3, 3, 4, way, &path) == BAT_OK)
        d = add(d, (uint64_t)bat_motion_bend(motion, path));
    d = add(d, (uint64_t)bat_motion_take_style(motion, motion));
    bat_curve_free(path);
    bat_take *again = NULL;
    d = add(d, (uint64_t)bat_motion_sample(motion, &again));
    d = add_text(d, bat_motion_write(motion, &report, &text, &length), &text, &length);
    d = add(d, (uint64_t)bat_motion_levels(motion) + (bat_motion_joint(motion, 0) != NULL) +
                   (bat_motion_path(motion) != NULL));
    bat_take_free(again);
    bat_motion_free(motion);
    return d;
}

static void const_calls_on_a_take(void **state) {
    (void)state;
    const bat_bone bones[2] = {
        {"hips", -1, false, {0, 0, 0}, 4, {BAT_Z_POSITION, BAT_X_ROTATION, BAT_Y_ROTATION, BAT_Z_ROTATION}},
        {"end", 0, true, {0, 1, 0}, 0, {BAT_X_POSITION}}};
    double values[48];
    for (int i = 0; i < 48; i++) values[i] = (i * 37 % 23) + i / 4;
    bat_take *take = NULL;
    assert_int_equal(bat_take_create(2, bones, 12, 0.01, values, &take), BAT_OK);
    assert_alike(look_at_take, take, 5);
    bat_take_free(take);
}

static void const_calls_on_a_camera(void **state) {
    (void)state;
    const double points[12] = {0, 0, 0, 5, 1, 0, 6, 7, 2, 0, 8, 5}, knots[4] = {0, 0, 1, 1},
                 keys[8] = {0, 0, 0, 1, 0, 1, 0, 1}, details[6] = {0.1, 0, 0, 0, 0.2, 0};
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    const bat_rotation_curve base = {
        .degree = 1, .count = 2, .points = keys, .knot_count = 4, .knots = knots};
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_ALONG, options.base = &base;
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &path), BAT_OK);
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_int_equal(bat_camera_add_level(camera, 4, knots, 2, details), BAT_OK);
    assert_alike(look_through, camera, 5);
    bat_camera_free(camera), bat_curve_free(path);
}

/* ---- lines ---- */

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

/* ---- comparing ---- */

/* Two sheets that wave, the second above the first, which is the reference. */
typedef struct compared {
    bat_surface *sheet[2];
    bat_reference *reference;
} compared;

static uint64_t look_at_reference(const void *shared, int seed) {
    const compared *c = shared;
    const double point[3] = {0.3 * seed, 0.4, 2};
    double closest[3] = {0}, distance = 0;
    bat_deviation far = {0};
    uint64_t d = add(bat_digest_begin(),
                     (uint64_t)bat_reference_nearest(c->reference, point, closest, &distance));
    d = bat_digest_double(add_doubles(d, closest, 3), distance);
    d = add(d, (uint64_t)bat_surface_deviation(c->sheet[1], c->reference, 1 + seed, &far));
    return add_doubles(bat_digest_double(add(d, far.samples), far.greatest), far.at, 3);
}

static void const_calls_on_a_reference(void **state) {
    (void)state;
    const double knots[5] = {0, 0, 1, 2, 2};
    compared c = {.reference = NULL};
    for (int k = 0; k < 2; k++) {
        double points[27];
        for (int i = 0; i < 9; i++)
            points[3 * i] = i / 3, points[3 * i + 1] = i % 3, points[3 * i + 2] = (i * 5 % 4) * 0.1 + k;
        assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                            (const size_t[2]){3, 3}, points, (const int[2]){5, 5}, knots,
                                            knots, &c.sheet[k]),
                         BAT_OK);
    }
    const bat_surface *first = c.sheet[0];
    assert_int_equal(bat_reference_create(0, NULL, 1, &first, 0, NULL, &c.reference), BAT_OK);
    assert_alike(look_at_reference, &c, 4);
    bat_reference_free(c.reference);
    bat_surface_free(c.sheet[0]), bat_surface_free(c.sheet[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(const_calls_on_a_relief),  cmocka_unit_test(const_calls_on_a_sweep),
        cmocka_unit_test(const_calls_on_a_camera),  cmocka_unit_test(const_calls_on_a_take),
        cmocka_unit_test(const_calls_on_a_surface), cmocka_unit_test(const_calls_on_a_reference),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
