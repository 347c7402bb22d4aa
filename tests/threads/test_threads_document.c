/* The promises of base.h about threads: concurrent const calls on one document or editor, distinct ones on distinct
 * threads, copies of one document edited on many. */
#include "alike.h"
#include "support/walker.h"
#include "support/pictures.h"
#include "support/random_surface.h"
#include "support/session.h"
#include "support/xml.h"

static const char GLYPH[] = "<glyph name=\"a\" format=\"2\"><unicode hex=\"0061\"/><outline/></glyph>";

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
    const bat_object *from[2] = {bat_document_at(document, 0), bat_document_at(document, 0)};
    for (int i = 1; i < bat_document_count(document) && from[1] == from[0]; i++)
        if (bat_object_is_made_of_curves(bat_document_at(document, i)))
            from[1] = bat_document_at(document, i);
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_RULED);
    assert_int_equal(bat_object_create_made(14, "made", &style, &recipe, 2, from, &object), BAT_OK);
    put(document, object);
    bat_polymesh *mesh = NULL;
    bat_object *bound = NULL;
    assert_int_equal(bat_polymesh_create(4, (double[]){0, 0, 0, 9, 0, 0, 9, 9, 4, 0, 9, 0}, 1, (int[]){4},
                                         (int[]){0, 1, 2, 3}, &mesh, NULL),
                     BAT_OK);
    assert_int_equal(bat_object_create_mesh(15, "mesh", &style, mesh, &object), BAT_OK);
    bat_polymesh_free(mesh);
    const bat_wire wire = {.reference = bat_object_curve(from[0], 0),
                           .radius = bat_function_of(900),
                           .scale = bat_function_of(1)};
    assert_int_equal(bat_object_bind(object, 1, &wire, from, from + 1, NULL, &bound), BAT_OK);
    bat_object_release(object);
    put(document, bound);
    bat_camera *camera = NULL;
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_ALONG;
    assert_int_equal(bat_camera_create(bat_object_curve(bat_document_at(document, 0), 0), &options, &camera),
                     BAT_OK);
    assert_int_equal(bat_object_create_camera(13, "camera", &style, camera, 1, &object), BAT_OK);
    put(document, object);
    bat_camera_free(camera);
    bat_take *take = walker(3, 9);
    bat_motion *motion = NULL;
    assert_int_equal(bat_motion_fit(take, NULL, &motion, NULL), BAT_OK);
    assert_int_equal(bat_object_create_skeleton(16, "walker", &style, motion, NULL, &object), BAT_OK);
    put(document, object);
    bat_motion_free(motion), bat_take_free(take);
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
    d = add(d, bat_object_is_foreign(object));
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
    if (bat_object_view(object)) d = add_doubles(d, bat_object_view(object)->eye, 3);
    const bat_surface *surface = bat_object_surface(object);
    if (surface) d = add_doubles(d, bat_surface_row(surface, 0), 3);
    const bat_id *ids = NULL;
    d = add(add(d, bat_object_followed(object)), (uint64_t)bat_object_sources(object, &ids));
    if (bat_object_recipe(object)) d = add(d, (uint64_t)bat_object_recipe(object)->kind + ids[0]);
    double folds[2 * BAT_RECIPE_FOLDS];
    d = add(d, bat_object_folds(object, folds));
    const bat_wire *wires = NULL;
    if (bat_object_wires(object, &wires, NULL)) d = bat_digest_double(d, wires[0].radius.constant);
    const bat_polymesh *mesh = bat_object_mesh(object);
    if (mesh) d = add_doubles(d, bat_polymesh_vertices(mesh), 3);
    if (bat_object_camera(object)) d = bat_digest_double(d, bat_camera_length(bat_object_camera(object)));
    double place[12], joints[3 * WALKER_JOINTS];
    const bat_motion *motion = bat_object_motion(object, place);
    bat_motion *own = NULL;
    if (motion) {
        d = add(d, (uint64_t)bat_motion_positions(motion, 0.1, joints));
        d = add_doubles(add_doubles(d, joints, 3 * WALKER_JOINTS), place, 12);
        d = add(bat_digest_double(d, bat_motion_duration(motion)), (uint64_t)bat_motion_copy(motion, &own));
        d = add(d, (uint64_t)bat_motion_angle(motion, 1, 0, 0.1, place));
        d = bat_digest_double(bat_digest_double(d, place[0]), bat_take_frame_time(bat_motion_take(own)));
        bat_motion_free(own);
    }
    const bat_picture *picture = bat_object_picture(object);
    if (!picture) return bat_digest_double(d, at);
    const void *bytes = bat_picture_bytes(picture, &size);
    bat_picture_sides(picture, box);
    d = bat_digest_bytes(add_doubles(d, box, 2), bytes, size);
    return bat_digest_text(add(d, bat_picture_digest(picture)), bat_picture_type(picture));
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

/* All that gives another object of one. */
static uint64_t vary(uint64_t d, const bat_object *object, int seed) {
    bat_style style = *bat_object_style(object);
    style.opacity = seed / 8.0;
    bat_object *m = NULL;
    bat_curve *curve = NULL, *other = NULL;
    d = add_object(d, bat_object_with_style(object, &style, &m), &m);
    d = add_object(d, bat_object_with_name(object, "other", &m), &m);
    const double dashes[2] = {1, seed + 1.0};
    const bat_paint paint = {.dash_count = 2, .dashes = dashes};
    d = add_object(d, bat_object_with_paint(object, &paint, &m), &m);
    d = add(d, bat_object_paint(object) != NULL);
    size_t cubics = 0;
    double *cover = NULL;
    d = add(d, (uint64_t)bat_object_cover(object, 0, &cubics, &cover) + bat_object_widths(object).count);
    d = add(d, (uint64_t)cubics);
    bat_free(cover);
    if (bat_object_motion(object, NULL)) {
        d = add_object(d, bat_object_with_motion(object, bat_object_motion(object, NULL), &m), &m);
        d = add_object(d, bat_object_at_time(object, 0.1 * seed, &m), &m);
    }
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
    bat_relief *relief = NULL;
    if (bat_object_surface(object) && bat_relief_create(bat_object_surface(object), &relief) == BAT_OK)
        d = add_object(d, bat_object_with_relief(object, relief, &m), &m);
    d = add(d, bat_object_relief(object) != NULL);
    bat_relief_free(relief);
    if (bat_object_camera(object))
        d = add_object(d, bat_object_with_camera(object, bat_object_camera(object), 2, &m), &m);
    if (bat_object_picture(object)) {
        double matrix[6] = {2, 0, 0, 2, seed, 0};
        bat_picture *picture = bat_picture_retain(bat_object_picture(object));
        d = add_object(d, bat_object_create_image(77, "", picture, matrix, 1, &m), &m);
        d = add_object(d, bat_object_create_foreign(78, "", picture, matrix, 1, &m), &m);
        bat_picture_release(picture);
        d = add_object(d, bat_object_with_matrix(object, matrix, &m), &m);
    }
    bat_object_release(bat_object_retain(object));
    return d;
}

/* A surface made from two objects, and made again with other numbers. */
static uint64_t make_of(uint64_t d, const bat_object *a, const bat_object *b, int seed) {
    const bat_style style = bat_style_defaults();
    const bat_object *from[2] = {a, b};
    bat_recipe recipe = bat_recipe_of(BAT_RECIPE_RULED);
    bat_object *made = NULL, *m = NULL;
    d = add(d, (uint64_t)bat_object_create_made(900 + (bat_id)seed, "", &style, &recipe, 2, from, &made));
    if (!made) return d;
    recipe.kind = BAT_RECIPE_LOFT;
    d = add_object(d, bat_object_with_recipe(made, &recipe, 2, from, &m), &m);
    const bat_wire wire = {.reference = bat_object_curve(a, 0),
                           .radius = bat_function_of(300 + seed),
                           .scale = bat_function_of(1)};
    bat_object *bound = NULL, *unbound = NULL;
    if (bat_object_bind(made, 1, &wire, from, seed & 2 ? from + 1 : NULL, NULL, &bound) == BAT_OK) {
        d = add_object(d, bat_object_unbind(bound, seed & 1, &unbound), &unbound);
        d = add_object(d, BAT_OK, &bound);
    }
    return add_object(d, BAT_OK, &made);
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
    page[0] += bat_document_scale(document) * (double)bat_document_unit(document);
    digest = add_doubles(add_doubles(digest, box, 4), page, 4);
    digest = add(digest, bat_document_check(document) == NULL);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        digest = add(digest, (uint64_t)bat_document_find(document, bat_object_id(object)));
        digest = add(digest, (uint64_t)bat_document_end(document, i));
        digest = vary(look_at_object(digest, object), object, seed);
    }
    for (int i = 1; i < bat_document_count(document); i++)
        digest = make_of(digest, bat_document_at(document, i - 1), bat_document_at(document, i), seed);
    digest = add_text(digest, bat_document_write(document, &text, &size), &text, &size);
    digest = add_text(digest, bat_svg_write(document, true, &text, &size), &text, &size);
    digest = add_text(digest, bat_svg_write_within(document, false, 0.01, &text, &size), &text, &size);
    digest = add_text(digest, bat_svg_write_kept(document, false, 0.01, &text, &size), &text, &size);
    digest = add_text(digest, bat_dxf_write(document, 0, &text, &size), &text, &size);
    digest = add_text(digest, bat_gcode_write(document, NULL, &text, &size), &text, &size);
    digest = add_text(digest, bat_glif_write(document, true, &text, &size), &text, &size);
    digest = add_text(digest, bat_glif_replace(GLYPH, sizeof GLYPH - 1, document, false, &text, &size, NULL),
                      &text, &size);
    digest = add(digest, bat_svg_is_kept(document));
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
    digest = add(digest, (uint64_t)*bat_editor_problem(editor)->message);
    bat_document *made = NULL;
    digest = add(digest, (uint64_t)bat_editor_excerpt(editor, (bat_excerpt)(seed % 2), &made));
    digest = add(digest, bat_document_digest(made));
    bat_document_free(made);
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
        cmocka_unit_test(const_calls_on_a_document), cmocka_unit_test(copies_edited_on_many_threads),
        cmocka_unit_test(the_original_goes_first),   cmocka_unit_test(const_calls_on_an_editor),
        cmocka_unit_test(editors_and_readers_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
