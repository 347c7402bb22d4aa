/* Gaze handles: rays that turn the gaze, roll it, or make the camera look at something; the field of view; keys added by a tap and
 * taken away. Every gesture is one step, and is undone exactly. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/alloc_fail.h"
#include "support/editing.h"

static bat_editor *with_camera(void) {
    bat_editor *editor = editor_with(1, (bat_curve *[]){pen_curve(200, 400, 60, 5, 11)});
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static const bat_object *last(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_count(document) - 1);
}

static const bat_camera *camera_of(const bat_editor *editor) { return bat_object_camera(last(editor)); }

static size_t keys_of(const bat_editor *editor) {
    size_t count = 0;
    bat_camera_base(camera_of(editor), &count);
    return count;
}

static void pose_at(const bat_editor *editor, double share, bat_camera_pose *pose) {
    double domain[2];
    bat_camera_domain(camera_of(editor), domain);
    bat_camera_at(camera_of(editor), domain[0] + share * (domain[1] - domain[0]), pose);
}

static void axis(const double *q, int which, double out[3]) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                            {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                            {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    for (int k = 0; k < 3; k++) out[k] = (which == 2 ? -1 : 1) * m[which][k]; /* 2: the gaze */
}

static double apart(const bat_camera_pose *a, const bat_camera_pose *b) {
    double dot = 0;
    for (int k = 0; k < 4; k++) dot += a->rotation[k] * b->rotation[k];
    return 2 * acos(fmin(fabs(dot), 1));
}

/* Where the end of the ray of a key is, in pixels: the view is face-on at zoom 1. A camera without keys has four places. */
static void end_of(const bat_editor *editor, int key, double at[2]) {
    bat_camera_pose pose;
    double gaze[3];
    const size_t keys = keys_of(editor);
    if (keys)
        bat_camera_at(camera_of(editor), bat_camera_key_place(camera_of(editor), (size_t)key), &pose);
    else
        pose_at(editor, key / 3.0, &pose);
    axis(pose.rotation, 2, gaze);
    const double length = fmax(0.1 * bat_curve_size(bat_camera_path(camera_of(editor))), 44);
    for (int k = 0; k < 2; k++) at[k] = pose.position[k] + length * gaze[k];
}

static const char *words(bat_editor *editor) {
    return bat_editor_outline_points(editor, bat_object_id(last(editor)));
}

static void a_drag_turns_the_gaze(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    bat_camera_pose before, after, far;
    double at[2], gaze[3], end[2];
    end_of(editor, 1, at);
    pose_at(editor, 1 / 3.0, &before);
    pose_at(editor, 1, &far);
    pen p = pen_for(editor);
    drag(&p, at[0], at[1], at[0] + 20, at[1] - 60);
    assert_int_equal(keys_of(editor), 4);
    pose_at(editor, 1 / 3.0, &after);
    axis(after.rotation, 2, gaze);
    /* It points to where the pen was lifted, and stays in the page. */
    const double x = at[0] + 20 - before.position[0], y = at[1] - 60 - before.position[1];
    assert_true(fabs(gaze[2]) < 1e-9);
    assert_true(fabs(gaze[0] * y - gaze[1] * x) < 1e-6 * hypot(x, y) && gaze[0] * x + gaze[1] * y > 0);
    axis(after.rotation, 1, gaze);
    assert_true(gaze[2] < -0.999999); /* and the camera does not roll */
    end_of(editor, 1, end);
    const bat_camera_pose other = after;
    assert_true(apart(&before, &after) > 0.2);
    pose_at(editor, 1, &after);
    assert_true(apart(&far, &after) < 0.15 * apart(&before, &other)); /* a ninth of what is felt at a third */
    replays(editor, 1);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_free(editor);
}

/* A drag turns the gaze at the active level: what is below keeps every bit, and the gaze far away, too. */
static void a_drag_turns_the_active_level(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_camera_pose before, after, far[2];
    double at[2], gaze[3];
    end_of(editor, 1, at);
    pen p = pen_for(editor);
    drag(&p, at[0], at[1], at[0] + 10, at[1] - 30); /* gives it keys */
    bat_editor_set(editor, "shake-amount", 2);
    assert_int_equal(bat_editor_command(editor, "shake-add"), BAT_OK);
    bat_editor_frame(editor);
    const uint64_t first = digest(editor);
    size_t count = 0;
    double keys[64];
    const double *base = bat_camera_base(camera_of(editor), &count);
    assert_true(count <= 16);
    memcpy(keys, base, 4 * count * sizeof *keys);
    assert_non_null(strstr(bat_editor_move(editor), "\"solo\":0,\"active\":1},{"));
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_CHOOSE, false, 2, 0, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_CHOOSE, true, 0, 0, true),
                     BAT_ARGUMENT); /* a path */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_CHOOSE, false, 1, 0, true), BAT_OK);
    assert_non_null(strstr(bat_editor_move(editor), "\"solo\":0,\"active\":1}]"));
    assert_true(digest(editor) == first); /* choosing is no edit */
    const double u = bat_camera_key_place(camera_of(editor), 1);
    bat_camera_at(camera_of(editor), u, &before);
    pose_at(editor, 1, &far[0]);
    end_of(editor, 1, at);
    drag(&p, at[0], at[1], at[0] + 25, at[1] + 20);
    assert_true(digest(editor) != first);
    assert_memory_equal(bat_camera_base(camera_of(editor), &count), keys, 4 * count * sizeof *keys);
    bat_camera_at(camera_of(editor), u, &after);
    axis(after.rotation, 2, gaze);
    const double length = fmax(0.1 * bat_curve_size(bat_camera_path(camera_of(editor))), 44);
    axis(before.rotation, 2, far[1].position); /* the gaze before, and where its end went */
    double wanted[3], size = 0;
    for (int k = 0; k < 3; k++) {
        wanted[k] = length * far[1].position[k] + (k == 0 ? 25 : k == 1 ? 20 : 0);
        size += wanted[k] * wanted[k];
    }
    for (int k = 0; k < 3; k++) assert_true(fabs(gaze[k] - wanted[k] / sqrt(size)) < 1e-9);
    pose_at(editor, 1, &far[1]);
    assert_memory_equal(far[0].rotation, far[1].rotation, sizeof far[0].rotation);
    replays(editor, 1);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    /* Keys, too: an arrow key turns by a degree. */
    assert_int_equal(bat_editor_command(editor, "gaze-left"), BAT_OK);
    assert_memory_equal(bat_camera_base(camera_of(editor), &count), keys, 4 * count * sizeof *keys);
    bat_camera_at(camera_of(editor), u, &after);
    assert_true(fabs(apart(&before, &after) - 3.14159265358979 / 180) < 1e-7);
    bat_editor_command(editor, "undo");
    /* What is silent can not be changed. */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_MUTE, false, 1, 1, true), BAT_OK);
    const uint64_t silent = digest(editor);
    end_of(editor, 1, at);
    drag(&p, at[0], at[1], at[0] + 25, at[1] + 20);
    assert_string_equal(bat_editor_frame(editor)->notice, "This level is hidden. Show it to edit it");
    assert_int_equal(bat_editor_command(editor, "gaze-left"), BAT_STATE);
    assert_true(digest(editor) == silent);
    check(editor);
    bat_editor_free(editor);
}

static void shift_only_rolls(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_camera_pose before, after;
    double at[2], a[3], b[3], across = 0;
    end_of(editor, 2, at);
    pose_at(editor, 2 / 3.0, &before);
    axis(before.rotation, 2, a);
    pen p = pen_for(editor);
    p.modifiers = BAT_SHIFT;
    drag(&p, at[0], at[1], at[0] - 30 * a[1], at[1] + 30 * a[0]);
    pose_at(editor, 2 / 3.0, &after);
    axis(after.rotation, 2, b);
    for (int k = 0; k < 3; k++) across = fmax(across, fabs(a[k] - b[k]));
    assert_true(across < 1e-9);
    assert_true(fabs(apart(&before, &after) - 0.5) < 0.01); /* 30 px across the ray: half a radian */
    bat_editor_free(editor);
}

static void alt_looks_at_what_the_pen_is_over(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    double at[2], gaze[3];
    end_of(editor, 1, at);
    pen p = pen_for(editor);
    p.modifiers = BAT_ALT;
    drag(&p, at[0], at[1], 700, 650);
    assert_int_equal(bat_camera_mode_of(camera_of(editor)), BAT_CAMERA_LOOK_AT);
    for (int i = 0; i <= 10; i++) {
        bat_camera_pose pose;
        pose_at(editor, i / 10.0, &pose);
        axis(pose.rotation, 2, gaze);
        const double x = 700 - pose.position[0], y = 650 - pose.position[1];
        assert_true(fabs(gaze[0] * y - gaze[1] * x) < 1e-9 * hypot(x, y) && fabs(gaze[2]) < 1e-12);
    }
    /* The target is the handle now. */
    p.modifiers = 0;
    drag(&p, 700, 650, 640, 600);
    bat_camera_pose pose;
    pose_at(editor, 0.5, &pose);
    axis(pose.rotation, 2, gaze);
    const double x = 640 - pose.position[0], y = 600 - pose.position[1];
    assert_true(fabs(gaze[0] * y - gaze[1] * x) < 1e-9 * hypot(x, y));
    assert_int_equal(bat_editor_command(editor, "gaze-add"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "gaze-along"), BAT_OK);
    assert_int_equal(bat_camera_mode_of(camera_of(editor)), BAT_CAMERA_ALONG);
    replays(editor, 1);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    /* On a surface, or a curve, in a tilted view it is there. */
    bat_editor_free(editor);
}

static void an_edge_sets_the_field_of_view(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_camera_pose pose;
    double gaze[3];
    bat_editor_seek(editor, 2);
    bat_camera_at_time(camera_of(editor), 2, &pose);
    assert_true(pose.fov == 40);
    axis(pose.rotation, 2, gaze);
    /* Seen from above the picture is a line across the gaze: its right edge is 16/9 tan 20 of the depth aside. */
    const double depth = 0.1 * bat_curve_size(bat_camera_path(camera_of(editor))),
                 wide = depth * tan(20 * 3.14159265358979 / 180) * 16 / 9;
    const double middle[2] = {pose.position[0] + depth * gaze[0], pose.position[1] + depth * gaze[1]};
    const double right[2] = {-gaze[1], gaze[0]};
    pen p = pen_for(editor);
    drag(&p, middle[0] + wide * right[0], middle[1] + wide * right[1], middle[0] + 2 * wide * right[0],
         middle[1] + 2 * wide * right[1]);
    bat_camera_at_time(camera_of(editor), 2, &pose);
    assert_true(fabs(pose.fov - 2 * atan(2 * tan(20 * 3.14159265358979 / 180)) * 180 / 3.14159265358979) <
                0.5);
    replays(editor, 1);
    bat_editor_free(editor);
}

static void a_tap_adds_a_key_and_delete_takes_it_away(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_camera_pose place, before[21], after;
    double at[2];
    end_of(editor, 1, at);
    pen p = pen_for(editor);
    drag(&p, at[0], at[1], at[0] + 20, at[1] - 60);
    const uint64_t four = digest(editor);
    for (int i = 0; i <= 20; i++) pose_at(editor, i / 20.0, &before[i]);
    pose_at(editor, 0.42, &place);
    tap(&p, place.position[0], place.position[1]);
    assert_int_equal(keys_of(editor), 5);
    for (int i = 0; i <= 20; i++) {
        pose_at(editor, i / 20.0, &after);
        assert_true(apart(&before[i], &after) < 1e-7); /* acos near 1 */
        for (int k = 0; k < 4; k++)
            assert_true(fabs(fabs(before[i].rotation[k]) - fabs(after.rotation[k])) < 1e-12);
    }
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "keyframe 3 of 5"));
    assert_non_null(strstr(words(editor), "\"at\":2"));
    tap(&p, place.position[0], place.position[1]); /* there is one */
    assert_int_equal(keys_of(editor), 5);
    assert_string_equal(bat_editor_frame(editor)->notice, "There is a keyframe here already");
    bat_editor_command(editor, "gaze-next");
    bat_editor_command(editor, "gaze-previous");
    bat_editor_key(editor, "<", true, 0, 1e5);
    bat_editor_key(editor, ">", true, 0, 1e5 + 1);
    while (!strstr(words(editor), "\"at\":2"))
        assert_int_equal(bat_editor_command(editor, "gaze-next"), BAT_OK);
    bat_editor_key(editor, "Delete", true, 0, 1e5 + 2);
    assert_int_equal(keys_of(editor), 4);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Keyframe deleted: the aim turns by at most"));
    for (int i = 0; i <= 20; i++) {
        pose_at(editor, i / 20.0, &after);
        assert_true(apart(&before[i], &after) < 1e-6);
    }
    assert_int_equal(bat_editor_command(editor, "gaze-delete"), BAT_STATE); /* none is chosen */
    bat_editor_command(editor, "gaze-next");
    assert_int_equal(bat_editor_command(editor, "gaze-delete"), BAT_STATE); /* all are needed */
    assert_string_equal(bat_editor_frame(editor)->notice, "The camera needs all its keyframes");
    replays(editor, 1);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == four);
    /* Without keys of its own the camera gets its first ones by a tap. */
    bat_editor_command(editor, "undo");
    assert_int_equal(keys_of(editor), 0);
    tap(&p, place.position[0], place.position[1]);
    assert_int_equal(keys_of(editor), 5);
    bat_editor_free(editor);
}

/* A drag of the path is the select tool's: the curve goes along. */
static void the_path_is_dragged_as_before(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_camera_pose before, after;
    pose_at(editor, 0.42, &before);
    const bat_curve *path = bat_camera_path(camera_of(editor));
    double start[3];
    bat_curve_eval(path, before.u, 0, start);
    pen p = pen_for(editor);
    drag(&p, start[0], start[1], start[0] + 40, start[1] + 30);
    pose_at(editor, 0.42, &after);
    assert_int_equal(keys_of(editor), 0);
    assert_true(fabs(after.position[0] - before.position[0] - 40) < 1e-9);
    check(editor);
    bat_editor_free(editor);
}

static void escape_and_pinches_take_back(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    double at[2];
    end_of(editor, 1, at);
    pen p = pen_for(editor);
    drag_to(&p, at[0], at[1], at[0] + 20, at[1] - 60);
    assert_true(digest(editor) != first);
    assert_string_equal(bat_editor_frame(editor)->hint,
                        "Drag to aim the camera. Shift: only roll, Alt: aim at what is under the pen");
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == first);
    pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
    assert_true(digest(editor) == first);
    check(editor);
    /* A tap on an end chooses the key; Esc forgets it, then deselects. */
    tap(&p, at[0], at[1]);
    assert_non_null(strstr(words(editor), "\"at\":1"));
    assert_non_null(strstr(words(editor), "keyframe 2 of 4, "));
    assert_non_null(strstr(words(editor), ", aims level"));
    bat_editor_command(editor, "cancel");
    assert_non_null(strstr(words(editor), "\"at\":-1"));
    assert_int_equal(bat_editor_frame(editor)->selected, 1);
    bat_editor_command(editor, "cancel");
    assert_int_equal(bat_editor_frame(editor)->selected, 0);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Arrows turn about the camera's own axes; Ctrl rolls and zooms; Shift does ten times as much. */
static void keys_turn_too(void **state) {
    (void)state;
    static const struct {
        const char *name;
        double degrees, fov;
    } all[] = {{"gaze-left", 1, 0},  {"gaze-right", 1, 0},     {"gaze-up", 1, 0},
               {"gaze-down", 1, 0},  {"gaze-roll-left", 1, 0}, {"gaze-roll-right", 1, 0},
               {"gaze-wider", 0, 1}, {"gaze-narrower", 0, -1}};
    bat_editor *editor = with_camera();
    for (int i = 0; i < 8; i++) assert_int_equal(bat_editor_command(editor, all[i].name), BAT_STATE);
    bat_editor_command(editor, "gaze-next");
    bat_editor_command(editor, "gaze-next");
    for (int i = 0; i < 8; i++) {
        bat_camera_pose before, after;
        pose_at(editor, 1 / 3.0, &before);
        assert_int_equal(bat_editor_command(editor, all[i].name), BAT_OK);
        pose_at(editor, 1 / 3.0, &after);
        assert_true(fabs(apart(&before, &after) * 180 / 3.14159265358979 - all[i].degrees) < 1e-5);
        assert_true(fabs(after.fov - before.fov - all[i].fov) < 1e-9);
    }
    bat_editor_key(editor, "ArrowDown", true, BAT_SHIFT, 5);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "aims 10 degrees down"));
    bat_editor_key(editor, "Control", true, BAT_CTRL, 6);
    bat_editor_key(editor, "ArrowUp", true, BAT_CTRL, 6);
    bat_camera_pose pose;
    pose_at(editor, 0, &pose);
    assert_true(fabs(pose.fov - 41) < 1e-9);
    assert_int_equal(bat_editor_command(editor, "gaze-at"),
                     BAT_OK); /* what lies in the middle of the window */
    assert_int_equal(bat_camera_mode_of(camera_of(editor)), BAT_CAMERA_LOOK_AT);
    check(editor);
    replays(editor, 1);
    bat_editor_free(editor);
}

/* By the list of objects: its rows name the keys, and choose them. */
static void the_outline_names_keys(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const bat_id id = bat_object_id(last(editor));
    assert_non_null(strstr(bat_editor_outline(editor, 0, 10), "camera 2, 4 keyframes"));
    bat_editor_command(editor, "tool-sketch");
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_choose(editor, id, 4), BAT_ARGUMENT);
    assert_int_equal(bat_editor_choose(editor, id, 3), BAT_OK);
    assert_non_null(strstr(words(editor), "\"at\":3"));
    assert_non_null(strstr(bat_editor_move(editor), "\"at\":4,"));
    const char *korean = "{\"key.level\":\"키 %/%, %초, 수평을 봄\"}";
    assert_int_equal(bat_editor_words(editor, korean, strlen(korean), NULL), BAT_OK);
    assert_non_null(strstr(words(editor), "키 4/4, 4.00초, 수평을 봄"));
    check(editor);
    bat_editor_free(editor);
}

/* In a tilted view, and with other tools: nothing is taken hold of with those. */
static void in_a_tilted_view(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    const bat_frame *frame = bat_editor_frame(editor);
    double at[2] = {0};
    bool found = false;
    for (uint32_t i = 0; i < frame->live_count; i++) found = found || frame->live[i].role == BAT_ROLE_ARROW;
    assert_true(found);
    pen p = pen_for(editor);
    for (double y = 100; y < 700 && digest(editor) == first; y += 12) /* finds one by trying */
        for (double x = 100; x < 900 && digest(editor) == first; x += 12) {
            p.time += 1000;
            pen_event(&p, BAT_POINTER_DOWN, x, y);
            pen_event(&p, BAT_POINTER_MOVE, x + 10, y + 10);
            if (strstr(bat_editor_frame(editor)->hint, "Drag to aim the camera")) {
                at[0] = x, at[1] = y;
                pen_event(&p, BAT_POINTER_UP, x + 10, y + 10);
            } else {
                bat_editor_command(editor, "cancel");
                pen_event(&p, BAT_POINTER_CANCEL, x, y);
                bat_editor_select(editor, bat_object_id(last(editor)), false);
            }
            bat_editor_frame(editor);
            check(editor);
        }
    assert_true(at[0] > 0 && digest(editor) != first);
    replays(editor, 1);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "tool-points");
    assert_int_equal(bat_editor_command(editor, "gaze-next"), BAT_STATE);
    bat_editor_free(editor);
}

/* ---- what the time strip changes ---- */

static bool says(bat_editor *editor, const char *text) {
    return strstr(bat_editor_move(editor), text) != NULL;
}

static void levels_fade_mute_and_solo(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t still = digest(editor);
    bat_camera_pose before[9], now;
    for (int i = 0; i < 9; i++) bat_camera_at_time(camera_of(editor), 0.5 * i, &before[i]);
    assert_true(says(editor, "\"gaze\":[{\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}],\"path\":[],"));
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 2, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, true, 1, 2, true), BAT_STATE);
    bat_editor_set(editor, "shake-amount", 3);
    assert_int_equal(bat_editor_command(editor, "shake-add"), BAT_OK);
    bat_camera_shake from;
    assert_int_equal(bat_camera_shake_of(camera_of(editor), 1, &from), BAT_OK);
    assert_true(fabs(from.amount - 0.05235987755982988) < 1e-15); /* 3 degrees */
    const uint64_t shaken = digest(editor);
    assert_true(shaken != still);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.5, false), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.25, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "shake-add"), BAT_STATE); /* a fader is held */
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == shaken);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.5, false), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.25, true), BAT_OK);
    assert_true(says(editor, "{\"gain\":0.25,\"muted\":0,"));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* one step */
    assert_true(digest(editor) == shaken);
    /* Solo of level 0 is the move without shake, bit for bit; again: all of it. */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, false, 0, 0, true), BAT_OK);
    assert_true(says(editor, "\"gaze\":[{\"gain\":1,\"muted\":0,\"solo\":1,\"active\":1},"
                             "{\"gain\":1,\"muted\":1,\"solo\":0,\"active\":0}]"));
    for (int i = 0; i < 9; i++) {
        bat_camera_at_time(camera_of(editor), 0.5 * i, &now);
        assert_memory_equal(now.rotation, before[i].rotation, sizeof now.rotation);
    }
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, false, 0, 0, true), BAT_OK);
    assert_true(digest(editor) == shaken);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_MUTE, false, 1, 1, true), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_MUTE, false, 1, 0, true), BAT_OK);
    assert_true(digest(editor) == shaken);
    assert_int_equal(bat_editor_move_set(editor, (bat_move_act)99, false, 1, 0, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, NAN, true), BAT_NUMBER);
    bat_editor_command(editor, "move-play"); /* an edit stops it */
    bat_editor_play(editor, 1);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.5, true), BAT_OK);
    assert_true(says(editor, "\"playing\":0"));
    check(editor);
    replays(editor, 1);
    while (digest(editor) != still) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_free(editor);
}

/* The gains of the levels of the path that is followed: they change the curve, and the camera with it. */
static void levels_of_the_path(void **state) {
    (void)state;
    bat_editor *editor = editor_with(1, (bat_curve *[]){pen_curve(100, 400, 30, 20, 28)});
    bat_editor_command(editor, "tool-levels");
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "take-apart");
    bat_editor_command(editor, "accept");
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    bat_editor_frame(editor);
    const uint64_t first = digest(editor);
    const double length = bat_camera_length(camera_of(editor));
    bat_camera_pose start, now;
    pose_at(editor, 0, &start);
    assert_true(says(editor, "\"path\":[{\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1},{"));
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, true, 0, 0, false), BAT_OK);
    bat_editor_frame(editor);
    assert_true(fabs(bat_camera_length(camera_of(editor)) - length) > 1e-6 * length);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, false, 0, 0, false),
                     BAT_STATE); /* of the other column */
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_SOLO, true, 0, 0, true), BAT_OK);
    pose_at(editor, 0, &now);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_GAIN, true, 1, 1.5, true), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_EASE, true, 1, 1.5, true), BAT_ARGUMENT);
    check(editor);
    replays(editor, 2);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void a_stroke_redraws_the_timing(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    const double stroke[6] = {0.2, 0.2, 0.4, 0.7, 0.6, 0.7};
    assert_int_equal(bat_editor_retime(editor, 1, stroke, false), BAT_ARGUMENT);
    for (size_t n = 2; n <= 3; n++) {
        assert_int_equal(bat_editor_retime(editor, n, stroke, false), BAT_OK);
        bat_editor_frame(editor);
        check(editor);
    }
    assert_true(digest(editor) != first); /* live */
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_retime(editor, 2, stroke, false), BAT_OK);
    assert_int_equal(bat_editor_retime(editor, 3, stroke, true), BAT_OK);
    const double length = bat_camera_length(camera_of(editor));
    bat_camera_pose pose;
    bat_camera_at_time(camera_of(editor), 0.5 * 4, &pose);
    assert_true(fabs(pose.distance / length - 0.7) < 0.01);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_DURATION, false, 0, 6, false), BAT_OK);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_DURATION, false, 0, 8, true), BAT_OK);
    assert_true(bat_camera_duration(camera_of(editor)) == 8);
    assert_int_equal(bat_editor_move_set(editor, BAT_MOVE_DURATION, false, 0, -1, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_command(editor, "move-ease"), BAT_OK);
    bat_camera_at_time(camera_of(editor), 0.01, &pose);
    assert_true(pose.distance / length < 0.01 / 8 * 0.2);
    check(editor);
    replays(editor, 1);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* The shake of one camera goes to another, which may have another path. */
static void copies_shake(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const bat_id one = bat_object_id(last(editor));
    bat_editor_command(editor, "shake-add");
    assert_int_equal(bat_editor_command(editor, "gaze-copy"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice,
                        "Select two cameras: the second gets the first one's shake");
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "camera-here");
    const bat_id two = bat_object_id(last(editor));
    bat_editor_select(editor, one, false);
    bat_editor_select(editor, two, true);
    const bat_status status = bat_editor_command(editor, "gaze-copy");
    assert_int_equal(status, BAT_UNSUPPORTED); /* of a tripod the base is a straight line */
    bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false);
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    const bat_id three = bat_object_id(last(editor));
    bat_editor_select(editor, one, false);
    bat_editor_select(editor, three, true);
    assert_int_equal(bat_editor_command(editor, "gaze-copy"), BAT_OK);
    assert_int_equal(bat_camera_levels(camera_of(editor)), 1);
    check(editor);
    replays(editor, 1);
    bat_editor_free(editor);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_editor *editor = with_camera();
        double at[2];
        end_of(editor, 1, at);
        pen p = pen_for(editor);
        const uint64_t first = digest(editor);
        alloc_fail_at(n);
        drag(&p, at[0], at[1], at[0] + 10, at[1] - 40);
        bat_editor_command(editor, "gaze-add");
        bat_editor_command(editor, "gaze-left");
        bat_editor_command(editor, "shake-add");
        bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.5, false);
        bat_editor_move_set(editor, BAT_MOVE_GAIN, false, 1, 0.7, true);
        bat_editor_retime(editor, 2, (double[]){0.1, 0.5, 0.6, 0.7}, true);
        bat_editor_move(editor);
        reached = alloc_fail_reached();
        alloc_fail_at(0);
        check(editor);
        while (bat_editor_command(editor, "undo") == BAT_OK) {
        }
        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        (void)first;
        check(editor);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_drag_turns_the_gaze),
                                       cmocka_unit_test(a_drag_turns_the_active_level),
                                       cmocka_unit_test(shift_only_rolls),
                                       cmocka_unit_test(alt_looks_at_what_the_pen_is_over),
                                       cmocka_unit_test(an_edge_sets_the_field_of_view),
                                       cmocka_unit_test(a_tap_adds_a_key_and_delete_takes_it_away),
                                       cmocka_unit_test(the_path_is_dragged_as_before),
                                       cmocka_unit_test(escape_and_pinches_take_back),
                                       cmocka_unit_test(keys_turn_too),
                                       cmocka_unit_test(the_outline_names_keys),
                                       cmocka_unit_test(in_a_tilted_view),
                                       cmocka_unit_test(levels_fade_mute_and_solo),
                                       cmocka_unit_test(levels_of_the_path),
                                       cmocka_unit_test(a_stroke_redraws_the_timing),
                                       cmocka_unit_test(copies_shake),
                                       cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
