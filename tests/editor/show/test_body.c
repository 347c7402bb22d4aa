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
#include "support/walker.h"

enum { FRAMES = 30 };
static const double LAST = (FRAMES - 1) / 60.0;

static bat_editor *with_skeleton(void) {
    const bat_style style = bat_style_defaults();
    bat_take *take = walker(2, FRAMES);
    bat_motion_options options = bat_motion_defaults();
    bat_motion *motion = NULL;
    bat_object *object = NULL;
    bat_document *document = NULL;
    options.tolerance = 0;
    assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
    assert_int_equal(bat_object_create_skeleton(5, "walker", &style, motion, NULL, &object), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_editor *editor = editor_of(document);
    bat_object_release(object);
    bat_motion_free(motion), bat_take_free(take);
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(is_shown_at_the_playhead), cmocka_unit_test(plays)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
