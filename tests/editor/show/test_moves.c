/* Camera moves in the editor: cameras made along a curve and from a view, the playhead, play and look through; nothing of that
 * is an edit. */
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

static bat_editor *with_curve(void) {
    return editor_with(1, (bat_curve *[]){pen_curve(200, 400, 60, 5, 11)});
}

static bat_editor *with_camera(void) {
    bat_editor *editor = with_curve();
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
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

static void at_is(bat_editor *editor, double seconds) {
    assert_true(fabs(value(editor, "at") - seconds) < 1e-9);
}

static const bat_object *last(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_count(document) - 1);
}

static void is_made_along_a_curve(void **state) {
    (void)state;
    bat_editor *editor = with_curve();
    const uint64_t first = digest(editor);
    bat_editor_frame(editor);
    assert_int_equal(bat_editor_frame(editor)->moves, 0);
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_STATE); /* nothing is selected */
    assert_string_equal(bat_editor_frame(editor)->notice, "Select one curve for the camera to follow");
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_non_null(strstr(bat_editor_actions(editor), "camera-along"));
    assert_int_equal(bat_editor_command(editor, "camera-along"), BAT_OK);
    const bat_camera *camera = bat_object_camera(last(editor));
    assert_non_null(camera);
    assert_int_equal(bat_object_followed(last(editor)),
                     bat_object_id(bat_document_at(bat_editor_document(editor), 0)));
    assert_int_equal(bat_camera_mode_of(camera), BAT_CAMERA_ALONG);
    assert_true(bat_camera_duration(camera) == 4);
    bat_camera_pose pose;
    bat_camera_at_time(camera, 0, &pose);
    /* y of the camera is up from the page: the rotation of (0, 1, 0) points against z. */
    const double *q = pose.rotation;
    assert_true(2 * (q[1] * q[2] + q[0] * q[3]) < -0.999999);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->moves > 0);
    assert_int_equal(frame->selected, 1);
    int ghosts = 0;
    for (uint32_t i = 0; i < frame->live_count; i++) ghosts += frame->live[i].role == BAT_ROLE_GHOST;
    assert_int_equal(ghosts, 1);
    assert_true(value(editor, "duration") == 4 && value(editor, "playing") == 0 &&
                value(editor, "cameras") == 1);
    check(editor);
    replays(editor, 0);
    round_trip(editor, first);
    while (bat_editor_command(editor, "undo") == BAT_OK) {
    }
    assert_int_equal(bat_editor_frame(editor)->moves, 0);
    bat_editor_free(editor);
}

static void plays_by_the_hosts_time(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const uint64_t first = digest(editor);
    size_t before, after;
    bat_editor_journal(editor, &before);
    bat_editor_play(editor, 500);
    at_is(editor, 0);
    assert_int_equal(bat_editor_command(editor, "move-play"), BAT_OK);
    bat_editor_play(editor, 1000);
    at_is(editor, 0);
    bat_editor_play(editor, 1250);
    at_is(editor, 0.25);
    bat_editor_play(editor, 1100); /* a clock that goes back */
    at_is(editor, 0.25);
    bat_editor_play(editor, NAN);
    bat_editor_play(editor, 900000); /* the page slept */
    at_is(editor, 1.25);
    for (int i = 1; i <= 3; i++) bat_editor_play(editor, 900000 + 950 * i);
    assert_true(value(editor, "playing") == 0);
    at_is(editor, 4);
    bat_editor_command(editor, "move-play"); /* again from the start */
    bat_editor_play(editor, 1e6);
    at_is(editor, 0);
    bat_editor_command(editor, "move-loop");
    for (int i = 1; i <= 9; i++) bat_editor_play(editor, 1e6 + 500 * i);
    at_is(editor, 0.5);
    assert_true(value(editor, "playing") == 1 && value(editor, "loop") == 1);
    bat_editor_frame(editor);
    bat_editor_journal(editor, &after);
    assert_int_equal(after, before);
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "nudge-right"); /* an edit stops it, where it is */
    bat_editor_frame(editor);
    assert_true(value(editor, "playing") == 0);
    at_is(editor, 0.5);
    check(editor);
    bat_editor_free(editor);
}

static void key(bat_editor *editor, const char *name, double down, double up) {
    bat_editor_key(editor, name, true, 0, down);
    bat_editor_key(editor, name, false, 0, up);
}

static void a_tap_of_space_plays(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    key(editor, "Space", 100, 200);
    assert_true(value(editor, "playing") == 1);
    bat_editor_key(editor, "Space", true, 0, 300);
    bat_editor_key(editor, "Space", true, 0, 340); /* keys repeat */
    bat_editor_key(editor, "Space", false, 0, 400);
    assert_true(value(editor, "playing") == 0);
    key(editor, "Space", 1000, 1400); /* held */
    assert_true(value(editor, "playing") == 0);
    pen p = mouse(editor);
    p.time = 2000;
    bat_editor_key(editor, "Space", true, 0, 2000);
    pen_event(&p, BAT_POINTER_DOWN, 400, 300);
    pen_event(&p, BAT_POINTER_MOVE, 420, 300);
    pen_event(&p, BAT_POINTER_UP, 420, 300);
    bat_editor_key(editor, "Space", false, 0, p.time + 1);
    assert_true(value(editor, "playing") == 0);
    assert_true(bat_editor_frame(editor)->view[0] != 0);
    check(editor);
    bat_editor_free(editor);
    editor = with_curve(); /* no camera: nothing */
    key(editor, "Space", 100, 200);
    assert_int_equal(bat_editor_command(editor, "move-play"), BAT_STATE);
    assert_int_equal(bat_editor_seek(editor, 1), BAT_STATE);
    assert_true(value(editor, "id") == 0);
    bat_editor_free(editor);
}

static void steps_are_frames(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    bat_editor_set(editor, "move-rate", 30);
    assert_int_equal(bat_editor_seek(editor, 1.01), BAT_OK);
    bat_editor_key(editor, ".", true, 0, 1);
    at_is(editor, 31 / 30.0);
    bat_editor_key(editor, ".", true, 0, 2);
    at_is(editor, 32 / 30.0);
    bat_editor_seek(editor, 1.01);
    bat_editor_key(editor, ",", true, 0, 3);
    at_is(editor, 1);
    bat_editor_key(editor, ",", true, 0, 4);
    at_is(editor, 29 / 30.0);
    bat_editor_key(editor, "End", true, 0, 5);
    bat_editor_key(editor, ".", true, 0, 6);
    at_is(editor, 4);
    bat_editor_key(editor, "Home", true, 0, 7);
    bat_editor_key(editor, ",", true, 0, 8);
    at_is(editor, 0);
    assert_int_equal(bat_editor_seek(editor, 1e300), BAT_OK);
    at_is(editor, 4);
    assert_int_equal(bat_editor_seek(editor, -1), BAT_OK);
    at_is(editor, 0);
    assert_int_equal(bat_editor_seek(editor, NAN), BAT_NUMBER);
    bat_editor_free(editor);
}

/* Where a point is seen on the canvas, -1 to 1. */
static void seen(bat_editor *editor, const double point[3], const double origin[3], double at[2]) {
    bat_editor_frame(editor);
    const bat_space *space = bat_editor_space(editor);
    double clip[4];
    assert_non_null(space);
    for (int row = 0; row < 4; row++) {
        clip[row] = space->clip[12 + row];
        for (int d = 0; d < 3; d++) clip[row] += space->clip[4 * d + row] * (point[d] - origin[d]);
    }
    assert_true(clip[3] > 0);
    for (int k = 0; k < 2; k++) at[k] = clip[k] / clip[3];
}

static void sees_what_the_camera_sees(void **state) {
    (void)state;
    const double origin[3] = {0};
    for (int tilted = 0; tilted < 2; tilted++) {
        bat_editor *editor = with_camera();
        const bat_camera *camera = bat_object_camera(last(editor));
        bat_camera_pose pose;
        double at[2], point[3], domain[2], ahead[6];
        if (tilted) bat_editor_command(editor, "orbit-up");
        bat_editor_frame(editor);
        assert_true(tilted == (bat_editor_space(editor) != NULL));
        bat_editor_seek(editor, 1.3);
        assert_int_equal(bat_editor_command(editor, "look-through"), BAT_OK);
        assert_true(value(editor, "through") == 1);
        bat_camera_at_time(camera, 1.3, &pose);
        bat_camera_domain(camera, domain);
        bat_curve_eval(bat_camera_path(camera), pose.u, 1, ahead);
        for (int d = 0; d < 3; d++) point[d] = pose.position[d] + 0.02 * ahead[3 + d];
        seen(editor, point, origin, at); /* along the path: straight ahead */
        assert_true(fabs(at[0]) < 1e-3 && fabs(at[1]) < 1e-3);
        point[2] -= 5; /* above the page is above */
        seen(editor, point, origin, at);
        assert_true(at[1] > 1e-3 && fabs(at[0]) < 1e-3);
        /* A pen does nothing there; Esc goes back. */
        const uint64_t before = digest(editor);
        const bat_frame *frame = bat_editor_frame(editor);
        const double x = frame->view[0];
        assert_int_equal(frame->live_count, 0);
        pen p = pen_for(editor);
        drag(&p, 300, 300, 600, 500);
        bat_editor_wheel(editor, 300, 300, 20, 20, 0, 9000);
        assert_true(digest(editor) == before && bat_editor_frame(editor)->view[0] == x);
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        assert_true(value(editor, "through") == 0);
        assert_true(tilted == (bat_editor_space(editor) != NULL));
        bat_editor_command(editor, "look-through");
        bat_editor_command(editor, "undo"); /* the camera goes */
        bat_editor_frame(editor);
        assert_true(value(editor, "through") == 0);
        assert_int_equal(bat_editor_command(editor, "look-through"), BAT_STATE);
        check(editor);
        bat_editor_free(editor);
    }
}

/* From a view in perspective: the camera sees what the view showed. */
static void stands_where_the_view_is(void **state) {
    (void)state;
    bat_editor *editor = with_curve();
    const uint64_t first = digest(editor);
    const double origin[3] = {0};
    bat_editor_set(editor, "perspective", 1);
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    double was[4][2], now[2];
    for (int i = 0; i < 4; i++) seen(editor, (double[]){200 + 150 * i, 390 + 30 * i, 10 * i}, origin, was[i]);
    assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
    assert_true(bat_object_followed(last(editor)) == 0);
    assert_true(value(editor, "length") == 0 && value(editor, "duration") == 4);
    for (int k = 0; k < 3; k++) bat_editor_command(editor, "orbit-right");
    bat_editor_command(editor, "look-through");
    bat_editor_seek(editor, 2.5);
    for (int i = 0; i < 4; i++) {
        seen(editor, (double[]){200 + 150 * i, 390 + 30 * i, 10 * i}, origin, now);
        for (int k = 0; k < 2; k++) assert_true(fabs(now[k] - was[i][k]) < 1e-4);
    }
    bat_editor_command(editor, "cancel");
    check(editor);
    replays(editor, 1);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* From other views, while it is selected: one camera, whose move goes through all of them; each looks as its view did. */
static void through_views(bool deep) {
    enum { VIEWS = 4, MARKS = 4 };
    static const char *const turns[VIEWS - 1][2] = {
        {"orbit-right", "zoom-in"}, {"orbit-up", "orbit-up"}, {"zoom-out", "pan-left"}};
    bat_editor *editor = with_curve();
    const uint64_t first = digest(editor);
    const double origin[3] = {0};
    double was[VIEWS][MARKS][2], now[2];
    uint64_t digests[VIEWS];
    bat_editor_set(editor, "perspective", deep);
    bat_editor_command(editor, "orbit-up");
    for (int v = 0; v < VIEWS; v++) {
        for (int k = 0; v > 0 && k < 2; k++)
            assert_int_equal(bat_editor_command(editor, turns[v - 1][k]), BAT_OK);
        for (int i = 0; i < MARKS; i++)
            seen(editor, (double[]){200 + 150 * i, 390 + 30 * i, 10 * i}, origin, was[v][i]);
        assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
        digests[v] = digest(editor);
        assert_true(value(editor, "cameras") == 1 && value(editor, "duration") == 4);
        assert_int_equal(bat_editor_frame(editor)->selected, 1);
        assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_STATE); /* the same view again */
        assert_string_equal(bat_editor_frame(editor)->notice,
                            "The camera ends at this view already: move or turn the view first");
        assert_true(digest(editor) == digests[v]);
        at_is(editor, v ? 4 : 0);
    }
    assert_true(value(editor, "length") > 0);
    const bat_camera *camera = bat_object_camera(last(editor));
    const double *knots = bat_curve_knots(bat_camera_path(camera));
    bat_editor_command(editor, "view-home");
    for (int v = 0; v < VIEWS; v++) { /* the time at which it is there, by halving */
        double a = 0, b = 4;
        bat_camera_pose pose;
        for (int k = 0; k < 60; k++) {
            bat_camera_at_time(camera, 0.5 * (a + b), &pose);
            *(pose.u < knots[3 + v] ? &a : &b) = 0.5 * (a + b);
        }
        bat_editor_seek(editor, v ? b : 0);
        bat_editor_command(editor, "look-through");
        for (int i = 0; i < MARKS; i++) {
            seen(editor, (double[]){200 + 150 * i, 390 + 30 * i, 10 * i}, origin, now);
            for (int k = 0; k < 2; k++) assert_true(fabs(now[k] - was[v][i][k]) < (deep ? 1e-4 : 60));
        }
        bat_editor_command(editor, "cancel");
    }
    check(editor);
    replays(editor, 1);
    for (int v = VIEWS - 1; v > 0; v--) { /* each is one step */
        assert_true(digest(editor) == digests[v]);
        bat_editor_command(editor, "undo");
    }
    assert_true(digest(editor) == digests[0]);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void goes_through_views(void **state) {
    (void)state;
    through_views(true);
    through_views(false);
}

/* Another camera is begun with nothing selected, with something else selected, and by its own command. */
static void another_camera_can_begin(void **state) {
    (void)state;
    bat_editor *editor = with_curve();
    bat_editor_command(editor, "camera-here");
    bat_editor_command(editor, "orbit-right");
    assert_int_equal(bat_editor_command(editor, "camera-new"), BAT_OK);
    assert_true(value(editor, "cameras") == 2 && value(editor, "length") == 0);
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "orbit-right");
    assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
    assert_true(value(editor, "cameras") == 3 && value(editor, "length") == 0);
    bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false);
    bat_editor_command(editor, "orbit-right");
    assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
    assert_true(value(editor, "cameras") == 4 && value(editor, "length") == 0);
    bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false);
    bat_editor_command(editor, "camera-along"); /* it goes where its curve goes */
    assert_int_equal(bat_editor_command(editor, "camera-here"), BAT_OK);
    assert_true(value(editor, "cameras") == 6 && value(editor, "length") == 0);
    check(editor);
    replays(editor, 1);
    bat_editor_free(editor);
}

/* The selected camera is the one that is played; without a selection the one before. */
static void the_selected_one_is_played(void **state) {
    (void)state;
    bat_editor *editor = with_camera();
    const double one = value(editor, "id");
    bat_editor_seek(editor, 1);
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "camera-here");
    const double two = value(editor, "id");
    assert_true(one != two && value(editor, "cameras") == 2);
    at_is(editor, 0);
    bat_editor_command(editor, "deselect");
    assert_true(value(editor, "id") == two);
    bat_editor_select(editor, (bat_id)one, false);
    assert_true(value(editor, "id") == one);
    bat_editor_command(editor, "delete");
    assert_true(value(editor, "id") == two && value(editor, "cameras") == 1);
    check(editor);
    bat_editor_free(editor);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    static const char *const commands[] = {"camera-along", "camera-here", "camera-here"};
    for (int i = 0; i < 3; i++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_editor *editor = with_curve();
            bat_editor_command(editor, "tool-select");
            bat_editor_command(editor, "select-all");
            if (i == 2) { /* another view of a camera that stands */
                bat_editor_command(editor, "camera-here");
                bat_editor_command(editor, "orbit-up");
            }
            bat_editor_frame(editor);
            const uint64_t first = digest(editor);
            alloc_fail_at(n);
            const bat_status status = bat_editor_command(editor, commands[i]);
            bat_editor_move(editor);
            reached = alloc_fail_reached();
            alloc_fail_at(0);
            assert_true(status == BAT_OK || (reached && digest(editor) == first));
            check(editor);
            bat_editor_free(editor);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_made_along_a_curve),      cmocka_unit_test(plays_by_the_hosts_time),
        cmocka_unit_test(a_tap_of_space_plays),       cmocka_unit_test(steps_are_frames),
        cmocka_unit_test(sees_what_the_camera_sees),  cmocka_unit_test(stands_where_the_view_is),
        cmocka_unit_test(goes_through_views),         cmocka_unit_test(another_camera_can_begin),
        cmocka_unit_test(the_selected_one_is_played), cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
