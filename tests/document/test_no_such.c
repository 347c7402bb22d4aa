/* An index of what does not exist gives what the header says, and reads nothing: every public call that takes one is tried
 * (tests/house/check_indices.py finds those that are not). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "support/pen.h"
#include "support/random_surface.h"

#include <batten/batten.h>

#include <limits.h>
#include <math.h>
#include <string.h>

/* What is below the first of some things, and beyond the last. */
static int wrong_index(int number, int least, int count) {
    const int wrong[] = {INT_MIN, least - 1, count, count + 1, INT_MAX};
    return wrong[number < 5 ? number : 0];
}

/* `at` runs through them. */
#define EACH_WRONG(least, count)                                                                             \
    for (int wrong = 0, at = wrong_index(0, (least), (count)); wrong < 5;                                    \
         wrong++, at = wrong_index(wrong, (least), (count)))
#define REFUSED(call) assert_int_equal((call), BAT_ARGUMENT)

static const double shift[3] = {1, 2, 3};

static void of_widths(void **state) {
    (void)state;
    bat_width_stop stops[2] = {{0.25, 1}, {0.75, 2}};
    size_t count = 2;
    EACH_WRONG(0, 2) {
        REFUSED(bat_width_move(count, stops, at, 0.5, 1));
        REFUSED(bat_width_remove(&count, stops, at));
    }
    assert_int_equal(count, 2);
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7);
    const bat_style style = bat_style_defaults();
    const bat_paint paint = {.width_count = 2, .widths = stops};
    bat_object *plain = NULL, *wide = NULL;
    size_t cubics = 0;
    double *points = NULL;
    assert_int_equal(bat_object_create_path(1, "", &style, 1, &curve, &plain), BAT_OK);
    assert_int_equal(bat_object_with_paint(plain, &paint, &wide), BAT_OK);
    EACH_WRONG(0, 1) REFUSED(bat_object_cover(wide, at, &cubics, &points));
    assert_null(points);
    bat_object_release(plain), bat_object_release(wide);
}

static void of_shapes(void **state) {
    (void)state;
    bat_curve *base = pen_curve(0, 0, 10, 5, 7);
    bat_shape *shape = NULL;
    bat_shape_live *live = NULL;
    const double u[2] = {0, 1}, targets[4] = {0, 1, 2, 3};
    const bat_stroke stroke = {.count = 2, .dimension = 2, .points = targets};
    double left = 0;
    size_t many = 0;
    assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
    for (int levels = 0; levels < 3; levels++) {
        EACH_WRONG(1, levels + 1) {
            assert_null(bat_shape_details(shape, at));
            assert_null(bat_shape_nodes(shape, at));
            assert_null(bat_shape_source(shape, at));
            assert_true(bat_shape_gain(shape, at) == 0);
            assert_false(bat_shape_is_muted(shape, at));
            REFUSED(bat_shape_set_gain(shape, at, 1));
            REFUSED(bat_shape_set_muted(shape, at, true));
        }
        EACH_WRONG(0, levels + 1) {
            assert_null(bat_shape_curve(shape, at));
            REFUSED(bat_shape_move(shape, at, 0, shift));
            REFUSED(bat_shape_drag(shape, at, 1, shift));
            REFUSED(bat_shape_drag_finest(shape, at, 1, shift, 1, &left));
            REFUSED(bat_shape_move_many(shape, at, 0, 1, shift));
            REFUSED(bat_shape_drag_held(shape, at, 1, shift, &(bat_shape_held){0}));
            REFUSED(bat_shape_move_held(shape, at, 0, shift, &(bat_shape_held){0}));
            REFUSED(bat_shape_sketch(shape, at, 2, u, targets));
            REFUSED(bat_shape_redraw_level(shape, at, &stroke, NULL, NULL));
            REFUSED(bat_shape_sketch_stroke(shape, at, &stroke, NULL));
            REFUSED(bat_shape_live_begin(shape, at, &live));
        }
        const int points = (int)bat_curve_count(bat_shape_curve(shape, levels));
        EACH_WRONG(0, points) {
            REFUSED(bat_shape_move(shape, levels, at, shift));
            REFUSED(bat_shape_move_many(shape, levels, at, 1, shift));
            REFUSED(bat_shape_move_held(shape, levels, at, shift, &(bat_shape_held){0}));
        }
        assert_int_equal(bat_shape_live_begin(shape, levels, &live), BAT_OK);
        EACH_WRONG(0, points) REFUSED(bat_shape_live_move(live, at, 1, shift));
        assert_int_equal(bat_shape_live_move(live, 1, 1, shift), BAT_OK);
        EACH_WRONG(0, levels + 1) {
            int first = -1;
            bat_shape_live_touched(live, at, &first, &many);
            assert_true(first == 0 && many == 0);
        }
        bat_shape_live_cancel(live);
        live = NULL;
        assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
    }
    bat_shape_free(shape);
    bat_curve_free(base);
}

static void of_reliefs(void **state) {
    (void)state;
    random_source r = {7};
    const int degree[2] = {3, 3}, kind[2] = {0, 0}, extra[2] = {2, 3};
    bat_surface *base = random_surface(&r, degree, kind, extra);
    bat_curve *line = pen_curve(0, 0, 10, 5, 7);
    bat_relief *relief = NULL;
    double left = 0;
    const size_t none = 0;
    assert_int_equal(bat_relief_create(base, &relief), BAT_OK);
    for (int levels = 0; levels < 3; levels++) {
        EACH_WRONG(1, levels + 1) {
            assert_null(bat_relief_details(relief, at));
            assert_null(bat_relief_source(relief, at));
            assert_true(bat_relief_gain(relief, at) == 0);
            assert_false(bat_relief_is_muted(relief, at));
            REFUSED(bat_relief_set_gain(relief, at, 1));
            REFUSED(bat_relief_set_muted(relief, at, true));
        }
        EACH_WRONG(0, levels + 1) {
            assert_null(bat_relief_surface(relief, at));
            REFUSED(bat_relief_move(relief, at, 1, &none, shift));
            REFUSED(bat_relief_drag(relief, at, 1, 1, shift));
            REFUSED(bat_relief_drag_finest(relief, at, 1, 1, shift, 1, &left));
            REFUSED(bat_relief_redraw(relief, at, BAT_U, 1, line, NULL, NULL, NULL));
        }
        const bat_surface *top = bat_relief_surface(relief, levels);
        const size_t beyond = bat_surface_count(top, BAT_U) * bat_surface_count(top, BAT_V), far = SIZE_MAX;
        REFUSED(bat_relief_move(relief, levels, 1, &beyond, shift));
        REFUSED(bat_relief_move(relief, levels, 1, &far, shift));
        EACH_WRONG(0, (int)bat_surface_count(top, BAT_U)) assert_null(bat_surface_row(top, at));
        assert_int_equal(bat_relief_add_level(relief, NULL, NULL, NULL, NULL, NULL), BAT_OK);
    }
    bat_relief_free(relief);
    bat_curve_free(line);
    bat_surface_free(base);
}

static void of_cameras(void **state) {
    (void)state;
    const bat_curve *const path = pen_curve(0, 0, 10, 5, 7);
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_ALONG;
    bat_camera *camera = NULL;
    bat_camera_shake shake;
    const double turn[4] = {1, 0, 0, 0};
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_true(isnan(bat_camera_key_place(camera, 0)));
    REFUSED(bat_camera_remove_key(camera, 0, NULL));
    size_t key = 0, keys = 0;
    assert_int_equal(bat_camera_add_key(camera, 1, &key), BAT_OK);
    assert_non_null(bat_camera_base(camera, &keys));
    assert_true(isfinite(bat_camera_key_place(camera, keys - 1)));
    for (size_t i = 0; i < 3; i++) {
        const size_t wrong = i == 2 ? SIZE_MAX : keys + i;
        assert_true(isnan(bat_camera_key_place(camera, wrong)));
        REFUSED(bat_camera_remove_key(camera, wrong, NULL));
    }
    for (int levels = 0; levels < 3; levels++) {
        EACH_WRONG(1, levels + 1) {
            assert_null(bat_camera_details(camera, at));
            assert_true(bat_camera_gain(camera, at) == 0);
            assert_false(bat_camera_is_muted(camera, at));
            REFUSED(bat_camera_set_gain(camera, at, 1));
            REFUSED(bat_camera_set_muted(camera, at, true));
            REFUSED(bat_camera_shake_of(camera, at, &shake));
        }
        EACH_WRONG(0, levels + 1) REFUSED(bat_camera_turn(camera, at, 1, turn));
        assert_int_equal(bat_camera_add_shake(camera, 1, 0.1, 2), BAT_OK);
    }
    bat_camera_free(camera);
    bat_curve_free((bat_curve *)path);
}

static void of_motions(void **state) {
    (void)state;
    const bat_bone bone = {.name = "hip",
                           .parent = -1,
                           .channel_count = 3,
                           .channels = {BAT_X_POSITION, BAT_Z_ROTATION, BAT_X_ROTATION}};
    bat_take *take = NULL;
    bat_motion *motion = NULL;
    double place[3], degrees = 0;
    const double points[4] = {0, 0, 1, 1};
    assert_int_equal(bat_take_create(1, &bone, 3, 0.1, (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9}, &take), BAT_OK);
    assert_int_equal(bat_motion_fit(take, NULL, &motion, NULL), BAT_OK);
    REFUSED(bat_take_positions(take, 3, place));
    REFUSED(bat_take_positions(take, SIZE_MAX, place));
    EACH_WRONG(0, 1) {
        assert_null(bat_motion_joint(motion, at));
        if (at != -1) REFUSED(bat_motion_set_gain(motion, at, 1, 1)); /* -1: all */
        REFUSED(bat_motion_angle(motion, at, 0, 0, &degrees));
        REFUSED(bat_motion_redraw(motion, at, 0, 0, 2, points));
    }
    EACH_WRONG(0, 3) {
        REFUSED(bat_motion_angle(motion, 0, at, 0, &degrees));
        REFUSED(bat_motion_redraw(motion, 0, at, 0, 2, points));
    }
    EACH_WRONG(1, bat_motion_levels(motion) + 1) REFUSED(bat_motion_set_gain(motion, 0, at, 1));
    EACH_WRONG(0, bat_motion_levels(motion) + 1)
    REFUSED(bat_motion_redraw(motion, 0, 0, at, 2, points));
    bat_motion_free(motion);
    bat_take_free(take);
}

static void of_lists(void **state) {
    (void)state;
    const double corners[12] = {0, 0, 0, 9, 0, 0, 9, 9, 4, 0, 9, 0};
    const int sides[1] = {4}, list[4] = {0, 1, 2, 3};
    bat_polymesh *mesh = NULL;
    bat_tracks *tracks = NULL;
    bat_line_drawing *drawing = NULL;
    bat_curve *curve = NULL;
    assert_int_equal(bat_polymesh_create(4, corners, 1, sides, list, &mesh, NULL), BAT_OK);
    random_source r = {3};
    const int degree[2] = {2, 2}, kind[2] = {0, 0}, extra[2] = {1, 1};
    bat_surface *surface = random_surface(&r, degree, kind, extra);
    const double origin[3] = {0, 0, 0}, normal[3] = {0, 0, 1};
    assert_int_equal(bat_surface_section(surface, origin, normal, 0, &tracks), BAT_OK);
    const bat_viewpoint view = {.eye = {40, 50, 60}, .up = {0, 0, 1}, .size = {200, 200}, .fov = 40};
    const bat_surface *const surfaces[1] = {surface};
    const bat_line_scene scene = {.surface_count = 1, .surfaces = surfaces};
    assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
    assert_true(bat_tracks_count(tracks) > 0 && bat_line_drawing_count(drawing) > 0);
    for (size_t i = 0; i < 3; i++) {
        const size_t far = SIZE_MAX - 1;
        size_t count = 9;
        assert_null(bat_polymesh_face(mesh, i == 2 ? far : 1 + i, &count));
        assert_true(count == 0);
        const bat_track_point *points = bat_tracks_crossing(tracks, 0);
        size_t wrong = i == 2 ? far : bat_tracks_count(tracks) + i;
        assert_true(bat_tracks_points(tracks, wrong, &points) == 0 && !points);
        assert_false(bat_tracks_is_closed(tracks, wrong));
        REFUSED(bat_tracks_curve(tracks, wrong, 1e-3, &curve));
        assert_null(bat_tracks_crossing(tracks, i == 2 ? far : bat_tracks_crossing_count(tracks) + i));
        bat_seen_line line = {.segments = 5, .points = corners};
        bat_line_drawing_at(drawing, i == 2 ? far : bat_line_drawing_count(drawing) + i, &line);
        assert_true(line.segments == 0 && !line.points && line.source == 0 && !line.hidden);
    }
    bat_line_drawing_free(drawing);
    bat_tracks_free(tracks);
    bat_surface_free(surface);
    bat_polymesh_free(mesh);
}

static void of_documents(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 7), *other = NULL;
    bat_object *object = NULL, *made = NULL;
    bat_document *document = NULL;
    const bat_style style = bat_style_defaults();
    const int points = (int)bat_curve_count(curve);
    EACH_WRONG(0, points) REFUSED(bat_curve_move_point(curve, at, shift, &other));
    assert_int_equal(bat_object_create_path(1, "", &style, 1, &curve, &object), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    EACH_WRONG(0, 1) {
        assert_null(bat_object_curve(object, at));
        assert_null(bat_object_shape(object, at));
        REFUSED(bat_object_with_curve(object, at, pen_curve(0, 0, 10, 5, 7), &made));
        bat_curve *base = pen_curve(0, 0, 10, 5, 7);
        bat_shape *shape = NULL;
        assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
        bat_curve_free(base);
        REFUSED(bat_object_with_shape(object, at, shape, &made));
        assert_null(bat_document_at(document, at));
        REFUSED(bat_document_replace(document, at, object));
        REFUSED(bat_document_remove(document, at));
        assert_int_equal(bat_document_end(document, at), at < 0 ? 0 : 1);
    }
    bat_object *second = NULL;
    curve = pen_curve(0, 0, 10, 5, 7);
    assert_int_equal(bat_object_create_path(2, "", &style, 1, &curve, &second), BAT_OK);
    EACH_WRONG(0, 2) REFUSED(bat_document_insert(document, at, second));
    assert_int_equal(bat_document_count(document), 1);
    bat_object_release(second);
    bat_object_release(object);
    bat_document_free(document);
}

static void of_splines(void **state) {
    (void)state;
    const double points[8] = {0, 0, 10, 0, 10, 10, 20, 10};
    const bat_spline spline = {.dimension = 2, .count = 4, .points = points};
    bat_spline out;
    void *block = NULL;
    int index = 0;
    EACH_WRONG(0, 3)
    REFUSED(bat_tangents_insert(&spline, at, 0.5, NULL, &out, &block, &index, NULL));
}

static void of_the_editor(void **state) {
    (void)state;
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 400, 300, 1);
    EACH_WRONG(0, 1) REFUSED(bat_editor_go(editor, at));
    EACH_WRONG(0, 0) {
        assert_non_null(bat_editor_outline(editor, at, 1));
        assert_non_null(bat_editor_outline(editor, 0, at));
        assert_true(bat_editor_choose(editor, 1, at) != BAT_OK);
        assert_true(bat_editor_read_as(editor, at) != BAT_OK);
        assert_true(bat_editor_level(editor, BAT_LEVEL_GAIN, at, 1, true) != BAT_OK);
        assert_true(bat_editor_move_set(editor, BAT_MOVE_JOINT, false, at, 1, true) != BAT_OK);
        assert_null(bat_editor_picture(editor, (uint32_t)at));
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_shapes),  cmocka_unit_test(of_reliefs), cmocka_unit_test(of_cameras),
        cmocka_unit_test(of_motions), cmocka_unit_test(of_lists),   cmocka_unit_test(of_documents),
        cmocka_unit_test(of_splines), cmocka_unit_test(of_widths),  cmocka_unit_test(of_the_editor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
