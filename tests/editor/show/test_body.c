/* A skeleton in the time strip: its bones at the playhead, played and scrubbed; nothing of that is an edit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/editing.h"
#include "support/walking.h"

enum { FRAMES = 30 };
static const double LAST = (FRAMES - 1) / 60.0;

static bat_editor *with_skeleton(void) {
    bat_editor *editor = editor_of(walking(2, FRAMES, 0, 5));
    bat_editor_frame(editor);
    return editor;
}

static double value(bat_editor *editor, const char *name) {
    const char *text = bat_editor_move(editor), *at = NULL;
    char key[32];
    snprintf(key, sizeof key, "\"%s\":", name);
    assert_non_null(text);
    at = strstr(text, key);
    assert_non_null(at);
    return strtod(at + strlen(key), NULL);
}

static const bat_motion *motion_of(const bat_editor *editor) {
    return bat_object_motion(bat_document_at(bat_editor_document(editor), 0), NULL);
}

/* Whether a line in that role has a point there. */
static bool drawn(bat_editor *editor, bat_role role, const double at[2]) {
    const bat_frame *frame = bat_editor_frame(editor);
    for (uint32_t i = 0; i < frame->live_count; i++) {
        const bat_item *item = &frame->live[i];
        for (uint32_t k = 0; item->role == (uint32_t)role && k + 1 < item->path_count; k++)
            if (fabs((double)item->path[k] + frame->origin[0] - at[0]) < 1e-3 &&
                fabs((double)item->path[k + 1] + frame->origin[1] - at[1]) < 1e-3)
                return true;
    }
    return false;
}

/* Seen from the front, where x is to the right and y up. */
static void shows_bones(bat_editor *editor, double time) {
    double at[3 * WALKER_JOINTS];
    assert_int_equal(bat_motion_positions(motion_of(editor), time, at), BAT_OK);
    for (int i = 0; i < WALKER_JOINTS; i++)
        assert_true(drawn(editor, BAT_ROLE_SELECTION, (double[]){at[3 * i], -at[3 * i + 1]}));
}

static void is_shown_at_the_playhead(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    const uint64_t before = digest(editor);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->moves > 0);
    assert_true(fabs(value(editor, "duration") - LAST) < 1e-12);
    assert_true(value(editor, "sees") == 0 && value(editor, "id") == 5);
    shows_bones(editor, 0);
    for (int i = 1; i <= 7; i++) {
        assert_int_equal(bat_editor_seek(editor, LAST * i / 7), BAT_OK);
        assert_true(fabs(value(editor, "at") - LAST * i / 7) < 1e-12);
        shows_bones(editor, LAST * i / 7);
        check(editor);
    }
    assert_int_equal(bat_editor_seek(editor, NAN), BAT_NUMBER);
    assert_int_equal(bat_editor_seek(editor, -5), BAT_OK);
    assert_true(value(editor, "at") == 0);
    assert_int_equal(bat_editor_command(editor, "look-through"), BAT_STATE); /* it is no camera */
    assert_true(digest(editor) == before);
    assert_null(bat_editor_lens(editor, (double[]){320, 180}));
    bat_editor_free(editor);
}

/* What the skeleton itself looks like, in the picture of what is still. */
static const bat_item *still(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    for (uint32_t i = 0; i < frame->still_count; i++)
        if (frame->still[i].id == 5) return &frame->still[i];
    return NULL;
}

/* One body is seen: the first pose is pale behind what the playhead shows, until the skeleton is gone, and after undo. */
static void its_first_pose_is_pale(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    bat_editor_frame(editor);
    assert_non_null(still(editor));
    assert_true(still(editor)->opacity < 0.3F);
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, 5, false);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    bat_editor_frame(editor);
    assert_null(still(editor));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_frame(editor);
    assert_true(still(editor) && still(editor)->opacity < 0.3F);
    check(editor);
    bat_editor_free(editor);
}

static void plays(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "move-play"), BAT_OK);
    bat_editor_play(editor, 1000);
    bat_editor_play(editor, 1100);
    assert_true(value(editor, "playing") == 1 && fabs(value(editor, "at") - .1) < 1e-9);
    shows_bones(editor, .1);
    assert_int_equal(bat_editor_command(editor, "move-end"), BAT_OK);
    assert_true(fabs(value(editor, "at") - LAST) < 1e-12 && value(editor, "playing") == 0);
    assert_int_equal(bat_editor_command(editor, "move-start"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "move-next"), BAT_OK);
    assert_true(fabs(value(editor, "at") - 1 / value(editor, "rate")) < 1e-12);
    assert_true(digest(editor) == before);
    check(editor);
    bat_editor_free(editor);
}

static void pixel_of(bat_editor *editor, const double at[2], double pixel[2]) {
    const double *view = bat_editor_frame(editor)->view;
    for (int k = 0; k < 2; k++) pixel[k] = (at[k] - view[k]) * view[2];
}

static void choose(bat_editor *editor, int joint, int angle) {
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_JOINT, false, joint, 0, true), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_ANGLE, false, angle, 0, true), BAT_OK);
}

/* A tap on a joint selects the skeleton and the joint; the outline names it; what moves goes to the tool. */
static void a_tap_chooses_a_joint(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    const uint64_t before = digest(editor);
    double at[3 * WALKER_JOINTS], pixel[2];
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_seek(editor, LAST / 2), BAT_OK);
    for (int joint = 1; joint <= 2; joint++) {
        assert_int_equal(bat_motion_positions(motion_of(editor), LAST / 2, at), BAT_OK);
        pixel_of(editor, (double[]){at[3 * joint], -at[3 * joint + 1]}, pixel);
        tap(&p, pixel[0], pixel[1]);
        assert_true(value(editor, "joint") == joint);
        assert_int_equal(bat_editor_frame(editor)->selected, 1);
        char words[32];
        snprintf(words, sizeof words, "{\"at\":%d,", joint);
        assert_non_null(strstr(bat_editor_outline_points(editor, 5), words));
    }
    assert_non_null(strstr(bat_editor_outline_points(editor, 5), "[\"hips\",\"thigh\",\"knee\","));
    assert_int_equal(bat_editor_choose(editor, 5, 4), BAT_OK);
    assert_true(value(editor, "joint") == 4);
    assert_int_equal(bat_editor_choose(editor, 5, 3), BAT_ARGUMENT); /* an end does not turn */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_ANGLE, false, 3, 0, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_JOINT, false, 9, 0, true), BAT_ARGUMENT);
    assert_true(digest(editor) == before);
    check(editor);
    bat_editor_free(editor);
}

/* Faders, mutes and solo of a joint's levels are steps that move only what hangs on the joint; undone, all is as it was. */
static void levels_of_a_joint_are_mixed(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    const uint64_t before = digest(editor);
    double was[3 * WALKER_JOINTS], is[3 * WALKER_JOINTS];
    choose(editor, 1, 0);
    assert_int_equal(bat_motion_positions(motion_of(editor), .2, was), BAT_OK);
    const bat_camera *joint = bat_motion_joint(motion_of(editor), 1);
    const int top = bat_camera_levels(joint);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, top, 1.5, false), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, top, 2, false), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, top, 2, true), BAT_OK);
    assert_true(bat_camera_gain(bat_motion_joint(motion_of(editor), 1), top) == 2);
    assert_true(bat_camera_gain(bat_motion_joint(motion_of(editor), 0), top) == 1);
    assert_int_equal(bat_motion_positions(motion_of(editor), .2, is), BAT_OK);
    for (int k = 0; k < 6; k++) assert_true(is[k] == was[k]); /* hips and the thigh's beginning */
    assert_true(fabs(is[6] - was[6]) + fabs(is[7] - was[7]) + fabs(is[8] - was[8]) > 1e-6);
    assert_true(is[12] == was[12]); /* the head */
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_MUTE, false, top, 1, true), BAT_OK);
    assert_true(bat_camera_is_muted(bat_motion_joint(motion_of(editor), 1), top));
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, false, 0, 0, true), BAT_OK);
    for (int l = 1; l <= top; l++)
        assert_true(bat_camera_is_muted(bat_motion_joint(motion_of(editor), 1), l));
    /* those of the root's path */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, true, 1, 0.5, true), BAT_OK);
    assert_true(bat_shape_gain(bat_motion_path(motion_of(editor)), 1) == 0.5);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_DURATION, false, 0, 2, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_command(editor, "shake-add"), BAT_STATE);
    check(editor);
    while (bat_editor_command(editor, "undo") == BAT_OK && digest(editor) != before) check(editor);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* A stroke over the graph is the angle, at once and not only when the pen goes up; Esc takes it back, undo too. */
static void a_stroke_redraws_an_angle(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    const uint64_t before = digest(editor);
    double points[2 * 41], range[2], was[3 * WALKER_JOINTS], is[3 * WALKER_JOINTS];
    choose(editor, 1, 2);
    const char *at = strstr(bat_editor_move(editor), "\"range\":[");
    assert_non_null(at);
    char *next = NULL;
    range[0] = strtod(at + 9, &next), range[1] = strtod(next + 1, NULL);
    assert_true(range[1] - range[0] >= 30);
    assert_int_equal(bat_motion_positions(motion_of(editor), LAST / 2, was), BAT_OK);
    for (int i = 0; i <= 40; i++) {
        points[2 * i] = .25 + .5 * i / 40.0;
        double degrees = 0;
        assert_int_equal(bat_motion_angle(motion_of(editor), 1, 2, points[2 * i] * LAST, &degrees), BAT_OK);
        const double s = sin(3.141592653589793 * i / 40.0);
        points[2 * i + 1] = (degrees + 12 * s * s - range[0]) / (range[1] - range[0]);
    }
    for (int way = 0; way < 2; way++) {
        for (size_t n = 2; n <= 41; n += 13) {
            assert_int_equal(bat_editor_retime(editor, n, points, false), BAT_OK);
            bat_editor_frame(editor);
            check(editor);
        }
        assert_int_equal(bat_motion_positions(motion_of(editor), LAST / 2, is), BAT_OK);
        assert_true(fabs(is[6] - was[6]) + fabs(is[7] - was[7]) + fabs(is[8] - was[8]) > .1);
        shows_bones(editor, 0);
        if (way) break;
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        assert_true(digest(editor) == before);
    }
    assert_int_equal(bat_editor_retime(editor, 41, points, true), BAT_OK);
    for (int i = 0; i <= 40; i++) {
        double degrees = 0;
        assert_int_equal(bat_motion_angle(motion_of(editor), 1, 2, points[2 * i] * LAST, &degrees), BAT_OK);
        assert_true(fabs(degrees - (range[0] + (range[1] - range[0]) * points[2 * i + 1])) < .5);
    }
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) != before);
    check(editor);
    bat_editor_free(editor);
}

/* What is fitted into the window leaves room for the time strip. */
static void fit_leaves_room_for_the_strip(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    double at[3 * WALKER_JOINTS], pixel[2];
    assert_int_equal(bat_editor_command(editor, "view-fit"), BAT_OK);
    assert_int_equal(bat_motion_positions(motion_of(editor), 0, at), BAT_OK);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < WALKER_JOINTS; i++) {
        pixel_of(editor, (double[]){at[3 * i], -at[3 * i + 1]}, pixel);
        low = fmin(low, pixel[1]), high = fmax(high, pixel[1]);
    }
    const double height = 800; /* of the window */
    assert_true(low >= 70 && high <= height - 70 && high - low > height - 170);
    check(editor);
    bat_editor_free(editor);
}

static void same_levels(const bat_camera *a, const bat_camera *b) {
    assert_int_equal(bat_camera_levels(a), bat_camera_levels(b));
    for (int l = 1; l <= bat_camera_levels(a); l++) {
        assert_true(bat_curve_is_equal(bat_camera_details(a, l), bat_camera_details(b, l)));
        assert_true(bat_camera_gain(a, l) == bat_camera_gain(b, l));
    }
}

/* Of two selected skeletons the second gets the first one's levels over its own bases, as one step, with gains. */
static void style_goes_to_another_walk(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    bat_editor *editor = NULL;
    bat_document *document = NULL;
    bat_motion_options options = bat_motion_defaults();
    options.tolerance = 0;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    for (int k = 0; k < 2; k++) {
        bat_take *take = walker(2 + k, FRAMES);
        bat_motion *motion = NULL;
        bat_object *object = NULL;
        assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
        if (k == 0) assert_int_equal(bat_motion_set_gain(motion, 1, 2, 1.5), BAT_OK);
        assert_int_equal(bat_object_create_skeleton((bat_id)(5 + k), "", &style, motion, NULL, &object),
                         BAT_OK);
        assert_int_equal(bat_document_insert(document, k, object), BAT_OK);
        bat_object_release(object);
        bat_motion_free(motion), bat_take_free(take);
    }
    editor = editor_of(document);
    bat_editor_frame(editor);
    const uint64_t before = digest(editor);
    bat_motion *was = NULL;
    assert_int_equal(
        bat_motion_copy(bat_object_motion(bat_document_at(bat_editor_document(editor), 1), NULL), &was),
        BAT_OK);
    bat_editor_select(editor, 5, false);
    bat_editor_select(editor, 6, true);
    assert_int_equal(bat_editor_command(editor, "gaze-copy"), BAT_OK);
    const bat_motion *from = bat_object_motion(bat_document_at(bat_editor_document(editor), 0), NULL),
                     *to = bat_object_motion(bat_document_at(bat_editor_document(editor), 1), NULL);
    for (int joint = 0; joint < WALKER_JOINTS; joint++) {
        if (!bat_motion_joint(from, joint)) continue;
        same_levels(bat_motion_joint(from, joint), bat_motion_joint(to, joint));
        size_t count = 0, same = 0;
        const double *base = bat_camera_base(bat_motion_joint(to, joint), &count),
                     *own = bat_camera_base(bat_motion_joint(was, joint), &same);
        assert_true(count == same);
        for (size_t i = 0; i < 4 * count; i++) assert_true(base[i] == own[i]);
    }
    bat_motion_free(was);
    assert_true(digest(editor) != before);
    check(editor);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* A camera beside the walker, which is then the move that is looked at. */
static void put_camera(bat_editor *editor) {
    const double points[12] = {-300, 0, -200, -100, -50, -300, 100, -50, -300, 300, 0, -200};
    const bat_style style = bat_style_defaults();
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_LOOK_AT;
    options.target[1] = -90, options.up[1] = -1, options.up[2] = 0;
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    bat_object *object = NULL;
    bat_document *document = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, points, &path), BAT_OK);
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_int_equal(bat_object_create_camera(8, "eye", &style, camera, 0, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 1, object), BAT_OK);
    assert_int_equal(bat_editor_open(editor, document, "walk"), BAT_OK);
    bat_object_release(object);
    bat_camera_free(camera), bat_curve_free(path);
    bat_editor_select(editor, 8, 0);
    bat_editor_frame(editor);
    assert_true(value(editor, "sees") == 1 && value(editor, "id") == 8);
}

/* Whether the lines of the walker go through all its joints as they are then, and are painted in full. */
static bool stands(const bat_editor *editor, const bat_space *space, double time) {
    double at[3 * WALKER_JOINTS];
    assert_int_equal(bat_motion_positions(motion_of(editor), time, at), BAT_OK);
    int found = 0;
    for (uint32_t i = 0; i < space->count; i++) {
        const bat_space_item *item = &space->items[i];
        if (item->id != 5) continue;
        assert_true(item->opacity == 1);
        for (int joint = 0; joint < WALKER_JOINTS; joint++) {
            bool met = false;
            for (uint32_t k = 0; k < item->rows && !met; k++)
                met = fabs((double)item->vertices[4 * k] - at[3 * joint]) < 1e-3 &&
                      fabs((double)item->vertices[4 * k + 1] + at[3 * joint + 1]) < 1e-3 &&
                      fabs((double)item->vertices[4 * k + 2] + at[3 * joint + 2]) < 1e-3;
            found += met;
        }
    }
    return found == WALKER_JOINTS;
}

/* The docked picture of a camera, and the drawing seen through it, show the body at the playhead; so does a turned view. */
static void a_camera_sees_it_at_the_playhead(void **state) {
    (void)state;
    const double size[2] = {320, 180};
    bat_editor *editor = with_skeleton();
    put_camera(editor);
    const uint64_t before = digest(editor);
    for (int i = 0; i < 6; i++) {
        const double time = i == 5 ? 0 : LAST * (i + 1) / 4; /* also past its end, and back */
        assert_int_equal(bat_editor_seek(editor, time), BAT_OK);
        bat_editor_frame(editor);
        assert_true(stands(editor, bat_editor_lens(editor, size), fmin(time, LAST)));
        assert_true(i == 5 || !stands(editor, bat_editor_lens(editor, size), 0));
        assert_int_equal(bat_editor_command(editor, "look-through"), BAT_OK);
        bat_editor_frame(editor);
        assert_true(stands(editor, bat_editor_space(editor), fmin(time, LAST)));
        assert_true(stands(editor, bat_editor_lens(editor, size), fmin(time, LAST)));
        assert_int_equal(bat_editor_command(editor, "look-through"), BAT_OK);
        check(editor);
    }
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* Whether the drawing, seen from the front, shows the walker's joints as they are then, in full. */
static bool lies(bat_editor *editor, double time) {
    double at[3 * WALKER_JOINTS];
    assert_int_equal(bat_motion_positions(motion_of(editor), time, at), BAT_OK);
    const bat_item *item = still(editor);
    const double *origin = bat_editor_frame(editor)->origin;
    int found = 0;
    assert_true(item && item->opacity == 1);
    for (int joint = 0; joint < WALKER_JOINTS; joint++) {
        bool met = false;
        for (uint32_t k = 0; k + 1 < item->path_count && !met; k++)
            met = fabs((double)item->path[k] + origin[0] - at[3 * joint]) < 1e-3 &&
                  fabs((double)item->path[k + 1] + origin[1] + at[3 * joint + 1]) < 1e-3;
        found += met;
        if (!met) continue; /* within what has to be painted anew */
        assert_true((double)item->bounds[0] <= at[3 * joint] - origin[0] + 1e-3);
        assert_true((double)item->bounds[3] >= -at[3 * joint + 1] - origin[1] - 1e-3);
    }
    return found == WALKER_JOINTS;
}

/* Face-on, too, while a camera is the move that is looked at; and it is there for the pen. */
static void the_drawing_shows_it_at_the_playhead(void **state) {
    (void)state;
    bat_editor *editor = with_skeleton();
    put_camera(editor);
    const uint64_t before = digest(editor);
    const double size[2] = {320, 180};
    for (int i = 0; i < 12; i++) {
        const double time = i == 5 ? 0 : LAST * (i + 1) / 10;
        const uint32_t was = bat_editor_frame(editor)->still_version;
        assert_int_equal(bat_editor_seek(editor, time), BAT_OK);
        if (i % 3 == 1) bat_editor_lens(editor, size); /* before the frame */
        assert_true(lies(editor, fmin(time, LAST)));
        assert_true(bat_editor_frame(editor)->still_version != was || time > LAST);
        if (i % 3 == 2) bat_editor_lens(editor, size); /* behind it */
        const uint32_t now = bat_editor_frame(editor)->still_version;
        bat_editor_frame(editor);
        assert_true(bat_editor_frame(editor)->still_version == now); /* at rest nothing is painted */
        assert_true(time == 0 || !lies(editor, 0));
        check(editor);
    }
    bat_editor_select(editor, 5, 0); /* now it is the move: its first pose is pale */
    assert_true(value(editor, "id") == 5);
    assert_int_equal(bat_editor_seek(editor, LAST / 2), BAT_OK);
    bat_editor_frame(editor);
    assert_true(still(editor)->opacity < 0.3F);
    shows_bones(editor, LAST / 2);
    bat_editor_select(editor, 8, 0);
    assert_int_equal(bat_editor_seek(editor, LAST / 3), BAT_OK);
    assert_true(lies(editor, LAST / 3));
    check(editor);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(is_shown_at_the_playhead),
                                       cmocka_unit_test(its_first_pose_is_pale),
                                       cmocka_unit_test(plays),
                                       cmocka_unit_test(a_tap_chooses_a_joint),
                                       cmocka_unit_test(levels_of_a_joint_are_mixed),
                                       cmocka_unit_test(a_stroke_redraws_an_angle),
                                       cmocka_unit_test(fit_leaves_room_for_the_strip),
                                       cmocka_unit_test(style_goes_to_another_walk),
                                       cmocka_unit_test(a_camera_sees_it_at_the_playhead),
                                       cmocka_unit_test(the_drawing_shows_it_at_the_playhead)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
