/* Corrections in the picture that a camera sees: what was taken hold of goes with the pen, at the active levels, as one step. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/alloc_fail.h"
#include "support/editing.h"

static const double SIZE[2] = {320, 180};
static const double FROM[2] = {90, 60}, TO[2] = {140, 95};

static bat_editor *with_path(void) {
    bat_editor *editor = editor_with(1, (bat_curve *[]){pen_curve(200, 400, 60, 5, 11)});
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    return editor;
}

static bat_editor *with_camera(void) {
    bat_editor *editor = with_path();
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    assert_int_equal(bat_editor_seek(editor, 1.7), BAT_OK);
    return editor;
}

static bat_editor *with_tripod(void) {
    bat_editor *editor = editor_with(1, (bat_curve *[]){pen_curve(200, 400, 60, 5, 11)});
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
    return editor;
}

static const bat_object *last(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_count(document) - 1);
}

static const bat_camera *camera_of(const bat_editor *editor) { return bat_object_camera(last(editor)); }
static const bat_object *path_of(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_find(document, bat_object_followed(last(editor))));
}

static double playhead(bat_editor *editor) {
    return strtod(strstr(bat_editor_move(editor), "\"at\":") + strlen("\"at\":"), NULL);
}

static bat_camera_pose pose_of(bat_editor *editor) {
    bat_camera_pose pose;
    bat_camera_at_time(camera_of(editor), playhead(editor), &pose);
    return pose;
}

static bat_viewpoint view_of(const bat_camera_pose *pose) {
    bat_viewpoint view;
    assert_int_equal(bat_camera_view(pose, 100, SIZE, &view), BAT_OK);
    return view;
}

/* How far away things are taken to be where nothing tells. */
static double depth_of(const bat_editor *editor) {
    const double size = bat_curve_size(bat_camera_path(camera_of(editor)));
    return 5 * (size > 0 ? 0.1 * size : 24);
}

/* The place at that distance that a pixel shows. */
static void place_at(const bat_camera_pose *pose, const double pixel[2], double far, double out[3]) {
    const bat_viewpoint view = view_of(pose);
    double origin[3], way[3];
    assert_int_equal(bat_viewpoint_ray(&view, pixel, origin, way), BAT_OK);
    for (int k = 0; k < 3; k++) out[k] = origin[k] + far * way[k];
}

static void seen_at(const bat_camera_pose *pose, const double place[3], const double pixel[2], double off) {
    const bat_viewpoint view = view_of(pose);
    double at[2];
    assert_int_equal(bat_viewpoint_project(&view, place, at, NULL), BAT_OK);
    if (!(fabs(at[0] - pixel[0]) <= off && fabs(at[1] - pixel[1]) <= off))
        fail_msg("%g %g is not %g %g", at[0], at[1], pixel[0], pixel[1]);
}

static double between(const double a[3], const double b[3]) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* In steps, as a pen does it. */
static void correct(bat_editor *editor, bat_correction kind, const double from[2], const double to[2]) {
    for (int i = 1; i <= 4; i++) {
        const double at[2] = {from[0] + (to[0] - from[0]) * i / 4, from[1] + (to[1] - from[1]) * i / 4};
        assert_int_equal(bat_editor_correct(editor, kind, SIZE, from, at, i == 4), BAT_OK);
        bat_editor_frame(editor);
        check(editor);
    }
}

static void undone(bat_editor *editor, uint64_t first) {
    replays(editor, 1);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
}

static void turning_takes_what_is_seen_along(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    const bat_camera_pose before = pose_of(editor);
    double place[3];
    place_at(&before, FROM, 200, place);
    correct(editor, BAT_CORRECT_TURN, FROM, TO);
    const bat_camera_pose after = pose_of(editor);
    assert_true(between(before.position, after.position) < 1e-9);
    seen_at(&after, place, TO, 1e-6);
    undone(editor, first);
    /* Rolling keeps the middle, and turns the picture with the pen. */
    const double side[2] = {160 + 60, 90}, below[2] = {160, 90 + 60}, middle[2] = {160, 90};
    place_at(&before, side, 200, place);
    correct(editor, BAT_CORRECT_ROLL, side, below);
    const bat_camera_pose rolled = pose_of(editor);
    seen_at(&rolled, place, below, 1e-6);
    place_at(&before, middle, 200, place);
    seen_at(&rolled, place, middle, 1e-6);
    undone(editor, first);
    bat_editor_free(editor);
}

static void a_tripod_pans_orbits_and_comes_nearer(void **state) {
    (void)state;
    bat_editor *editor = with_tripod();
    const uint64_t first = digest(editor);
    const bat_camera_pose before = pose_of(editor);
    const double far = depth_of(editor);
    double place[3];
    place_at(&before, FROM, far, place);
    correct(editor, BAT_CORRECT_PAN, FROM, TO);
    bat_camera_pose after = pose_of(editor);
    assert_memory_equal(before.rotation, after.rotation, sizeof before.rotation);
    seen_at(&after, place, TO, 1e-6);
    assert_true(bat_camera_length(camera_of(editor)) == 0);
    undone(editor, first);
    correct(editor, BAT_CORRECT_ORBIT, FROM, TO);
    after = pose_of(editor);
    assert_true(fabs(between(after.position, place) - far) < 1e-9 * far);
    seen_at(&after, place, FROM, 1e-6); /* what it turns about stays */
    assert_true(between(after.position, before.position) > 0.1 * far);
    undone(editor, first);
    correct(editor, BAT_CORRECT_DOLLY, FROM, (double[]){FROM[0], FROM[1] - 200});
    after = pose_of(editor);
    assert_true(fabs(between(after.position, place) - 0.5 * far) < 1e-9 * far);
    seen_at(&after, place, FROM, 1e-6);
    undone(editor, first);
    bat_editor_free(editor);
}

/* A path in the page becomes one in space; what is carried is where the pen says, and the playhead stays at its place. */
static void a_path_is_bent(void **state) {
    (void)state;
    for (int taken = 0; taken < 2; taken++) {
        bat_editor *editor = with_path();
        if (taken) {
            bat_editor_command(editor, "tool-levels");
            bat_editor_command(editor, "select-all");
            bat_editor_command(editor, "take-apart");
            bat_editor_command(editor, "accept");
            bat_editor_command(editor, "tool-select");
            bat_editor_command(editor, "select-all");
        }
        assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
        assert_int_equal(bat_editor_seek(editor, 1.7), BAT_OK);
        assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_CHOOSE, true, 1, 0, true),
                         taken ? BAT_OK : BAT_ARGUMENT);
        const uint64_t first = digest(editor);
        const bat_camera_pose before = pose_of(editor);
        const double far = depth_of(editor);
        double place[3], wanted[3], base[64 * 3] = {0};
        int count = 0;
        if (taken) {
            const bat_curve *coarse = bat_shape_curve(bat_object_shape(path_of(editor), 0), 0);
            count = (int)bat_curve_count(coarse);
            assert_true(count <= 64);
            memcpy(base, bat_curve_points(coarse), 2 * (size_t)count * sizeof *base);
        }
        place_at(&before, FROM, far, place);
        for (int k = 0; k < 3; k++) wanted[k] = 0.5 * (before.position[k] + place[k]);
        correct(editor, BAT_CORRECT_DOLLY, FROM, (double[]){FROM[0], FROM[1] - 200});
        const bat_camera_pose after = pose_of(editor);
        assert_true(fabs(after.u - before.u) < 1e-9);
        assert_true(between(after.position, wanted) < 1e-6 * far);
        assert_int_equal(bat_curve_dimension(bat_object_curve(path_of(editor), 0)), 3);
        if (taken) { /* level 0 keeps every bit */
            const bat_curve *coarse = bat_shape_curve(bat_object_shape(path_of(editor), 0), 0);
            for (int i = 0; i < 2 * count; i++)
                assert_true(bat_curve_points(coarse)[i / 2 * 3 + i % 2] == base[i]);
        }
        undone(editor, first);
        /* Orbiting meets the place and the gaze, although the path turns the camera, too. */
        const bat_camera_pose again = pose_of(editor); /* the playhead stayed where it was in time */
        place_at(&again, FROM, far, place);
        correct(editor, BAT_CORRECT_ORBIT, FROM, TO);
        const bat_camera_pose round = pose_of(editor);
        assert_true(fabs(between(round.position, place) - far) < 1e-6 * far);
        seen_at(&round, place, FROM, 1e-4);
        undone(editor, first);
        bat_editor_free(editor);
    }
}

static void what_looks_at_something_orbits_it(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    assert_int_equal(bat_editor_command(editor, "gaze-at"), BAT_OK);
    const uint64_t first = digest(editor);
    const double middle[2] = {160, 90};
    const bat_camera_pose before = pose_of(editor);
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_TURN, SIZE, FROM, TO, true), BAT_UNSUPPORTED);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "no keyframes"));
    assert_true(digest(editor) == first);
    correct(editor, BAT_CORRECT_ORBIT, FROM, TO);
    const bat_camera_pose after = pose_of(editor);
    double place[3] = {500, 400, 0}; /* the middle of the window */
    seen_at(&before, place, middle, 1e-6);
    seen_at(&after, place, middle, 1e-6);
    assert_true(fabs(between(before.position, place) - between(after.position, place)) < 1e-6);
    assert_true(between(before.position, after.position) > 1);
    undone(editor, first);
    bat_editor_free(editor);
}

static void taken_back_and_refused(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "move-play");
    bat_editor_play(editor, 1);
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_DOLLY, SIZE, FROM, TO, false), BAT_OK);
    bat_editor_frame(editor);
    assert_non_null(strstr(bat_editor_move(editor), "\"playing\":0"));
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_DURATION, false, 0, 3, true), BAT_STATE);
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == first && fabs(playhead(editor) - 1.7) < 1e-12);
    assert_int_equal(bat_editor_correct(editor, (bat_correction)9, SIZE, FROM, TO, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_PAN, NULL, FROM, TO, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_PAN, (double[]){0, 180}, FROM, TO, true),
                     BAT_ARGUMENT);
    for (int k = 0; k < 3; k++) {
        double values[3][2] = {{320, 180}, {90, 60}, {140, 95}};
        values[k][k % 2] = k ? NAN : INFINITY;
        assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_PAN, values[0], values[1], values[2], true),
                         BAT_NUMBER);
    }
    /* Out of the middle of the picture no angle is known: nothing turns. */
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_ROLL, SIZE, (double[]){160, 90}, TO, false),
                     BAT_OK);
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_set_state(editor, bat_object_id(path_of(editor)), false, true), BAT_OK);
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_PAN, SIZE, FROM, TO, true), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, "The camera's path is locked or hidden");
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_TURN, SIZE, FROM, TO, true), BAT_OK);
    check(editor);
    bat_editor_free(editor);
    editor = with_path();
    assert_int_equal(bat_editor_correct(editor, BAT_CORRECT_PAN, SIZE, FROM, TO, true), BAT_STATE);
    bat_editor_free(editor);
}

/* The picture beside the drawing: the same buffers as the room, another eye; face-on as well as tilted. */
static void the_docked_picture(void **state) {
    (void)state;
    bat_editor *editor = with_path();
    assert_null(bat_editor_lens(editor, SIZE));
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    assert_null(bat_editor_lens(editor, (double[]){0, 180}));
    assert_null(bat_editor_lens(editor, (double[]){NAN, 180}));
    assert_null(bat_editor_lens(editor, NULL));
    bat_editor_frame(editor);
    assert_null(bat_editor_space(editor));
    const bat_space *lens = bat_editor_lens(editor, SIZE);
    assert_non_null(lens);
    assert_int_equal(lens->perspective, 1);
    assert_int_equal(lens->count, 1); /* the curve, and no camera */
    const uint32_t version = lens->items[0].version;
    float clip[16], moved[16];
    memcpy(clip, lens->clip, sizeof clip);
    bat_editor_seek(editor, 2);
    bat_editor_frame(editor);
    lens = bat_editor_lens(editor, SIZE);
    assert_true(memcmp(clip, lens->clip, sizeof clip) != 0); /* numbers, without padding */
    bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
    const bat_space *room = bat_editor_space(editor);
    assert_non_null(room);
    memcpy(moved, room->clip, sizeof moved);
    const uint32_t now = room->items[0].version;
    lens = bat_editor_lens(editor, SIZE);
    assert_true(memcmp(moved, lens->clip, sizeof moved) != 0);
    assert_int_equal(lens->items[0].version, now);
    assert_true(version > 0);
    /* Seen through the camera, the two change places. */
    assert_int_equal(bat_editor_command(editor, "look-through"), BAT_OK);
    bat_editor_frame(editor);
    assert_non_null(bat_editor_space(editor));
    lens = bat_editor_lens(editor, (double[]){500, 400});
    assert_non_null(lens);
    for (int i = 0; i < 16; i++) /* depths are of other pixels */
        assert_true(i % 4 == 2 || fabsf(lens->clip[i] - moved[i]) < 1e-4F * fmaxf(1, fabsf(moved[i])));
    bat_editor_free(editor);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_editor *editor = with_camera();
        alloc_fail_at(n);
        bat_editor_correct(editor, BAT_CORRECT_ORBIT, SIZE, FROM, TO, false);
        bat_editor_correct(editor, BAT_CORRECT_ORBIT, SIZE, FROM, TO, true);
        bat_editor_lens(editor, SIZE);
        reached = alloc_fail_reached();
        alloc_fail_at(0);
        check(editor);
        while (bat_editor_command(editor, "undo") == BAT_OK) {
        }
        check(editor);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turning_takes_what_is_seen_along),
        cmocka_unit_test(a_tripod_pans_orbits_and_comes_nearer),
        cmocka_unit_test(a_path_is_bent),
        cmocka_unit_test(what_looks_at_something_orbits_it),
        cmocka_unit_test(taken_back_and_refused),
        cmocka_unit_test(the_docked_picture),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
