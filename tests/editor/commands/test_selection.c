/* The commands offered for a selection, and its style. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static double value(const bat_editor *editor, const char *name) {
    double out = -1;
    bat_editor_get(editor, name, &out);
    return out;
}

static void style_of_selection_and_of_new(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_set(editor, "stroke-colour", (double)0xff0000ffu), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-width", 7), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "fill-colour", (double)0x00ff0080u), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "opacity", 0.5), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-cap", BAT_CAP_SQUARE), BAT_OK);
    const bat_style *style = bat_object_style(object(editor, 1));
    assert_true(style->stroke == 0xff0000ffu && style->width == 7 && style->filled &&
                style->fill == 0x00ff0080u && style->opacity == 0.5 && style->cap == BAT_CAP_SQUARE);
    assert_true(bat_object_style(object(editor, 2))->width == 2);
    assert_int_equal(editor->session.history.done, 5);
    bat_editor_set(editor, "opacity", 0.5); /* no change, no step */
    assert_int_equal(editor->session.history.done, 5);
    only(editor, 2, 0);
    assert_true(value(editor, "stroke-width") == 2); /* the selection's */
    only(editor, 0, 0);
    assert_true(value(editor, "stroke-width") == 7); /* of new curves */
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 200, 400, 800, 400, 60);
    style = bat_object_style(object(editor, 3));
    assert_true(style->stroke == 0xff0000ffu && style->width == 7 && style->filled && style->opacity == 0.5 &&
                style->cap == BAT_CAP_SQUARE);
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "style-marker");
    for (bat_id id = 1; id <= 3; id++) assert_true(bat_object_style(object(editor, id))->width == 12);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* That of a group is the group's, as one picture; that of what is in it stays. */
static void opacity_of_a_group(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    uint64_t first = digest(editor);
    only(editor, 2, 0);
    bat_editor_set(editor, "opacity", 0.75);
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    assert_true(value(editor, "opacity") == 1);
    const int steps = editor->session.history.done;
    assert_int_equal(bat_editor_set(editor, "opacity", 0.5), BAT_OK);
    assert_int_equal(editor->session.history.done, steps + 1);
    const bat_object *group = bat_document_at(bat_editor_document(editor), 0);
    assert_true(bat_object_is_group(group) && bat_object_style(group)->opacity == 0.5);
    assert_true(bat_object_style(object(editor, 1))->opacity == 1);
    assert_true(bat_object_style(object(editor, 2))->opacity == 0.75);
    assert_true(value(editor, "opacity") == 0.5);
    assert_true(value(editor, "stroke-width") == 2); /* of what is in it */
    bat_editor_set(editor, "stroke-width", 5);
    assert_true(bat_object_style(object(editor, 1))->width == 5);
    assert_true(bat_object_style(object(editor, 1))->opacity == 1);
    const bat_frame *frame = bat_editor_frame(editor);
    int pictures = 0;
    for (uint32_t i = 0; i < frame->still_count; i++)
        pictures += frame->still[i].role == BAT_ROLE_GROUP && frame->still[i].opacity == 0.5F;
    assert_int_equal(pictures, 1);
    assert_int_equal(bat_editor_command(editor, "ungroup"), BAT_OK);
    assert_true(bat_object_style(object(editor, 1))->opacity == 0.5);
    assert_true(bat_object_style(object(editor, 2))->opacity == 0.375);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static bool offered(bat_editor *editor, const char *name) {
    const char *list = bat_editor_actions(editor), *at = strstr(list, name);
    return at && (at == list || at[-1] == ' ') && (at[strlen(name)] == ' ' || !at[strlen(name)]);
}

/* What is said to be impossible is refused, and changes nothing, whatever is selected; nothing that can be done is said to be. */
static void what_cannot_be_done(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-select");
    int said = 0;
    for (int round = 0; round < 6; round++) {
        for (int i = 0; i < BAT_COMMAND_COUNT; i++) {
            const char *name = bat_command_at((bat_command_id)i)->name;
            char key[64];
            bat_editor_command(editor, "deselect");
            if (round == 1)
                bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
            else if (round > 1)
                bat_editor_command(editor, "select-all");
            const char *refused = bat_editor_refused(editor);
            snprintf(key, sizeof key, "\"%s\":\"", name);
            if (!strstr(refused, key)) continue;
            said++;
            const uint64_t before = digest(editor);
            if (bat_editor_command(editor, name) == BAT_OK || digest(editor) != before)
                fail_msg("%d: %s is said to be impossible", round, name);
        }
        if (round == 2) bat_editor_command(editor, "group");
        if (round == 3) bat_editor_command(editor, "curve-close");
        if (round == 4) bat_editor_command(editor, "orbit-up"), bat_editor_glide(editor, 1);
    }
    assert_true(said > 100);
    assert_non_null(strstr(bat_editor_refused(editor), "\"mirror-across\":\"Needs the page view\""));
    bat_editor_command(editor, "view-upright");
    assert_null(strstr(bat_editor_refused(editor), "\"mirror-across\""));
    bat_editor_free(editor);
}

/* What is offered can be done, and what is not cannot. */
static void actions_of_the_selection(void **state) {
    (void)state;
    static const char *const names[] = {
        "align-left", "distribute-across", "group",         "ungroup",     "curve-close",
        "curve-open", "curve-join",        "curve-reverse", "curve-split", "delete"};
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "tool-points");
    assert_string_equal(bat_editor_actions(editor), ""); /* the select tool is not in force */
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "deselect");
    assert_string_equal(bat_editor_actions(editor), "");
    bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
    assert_true(offered(editor, "order-front") && offered(editor, "align-left") &&
                offered(editor, "curve-close"));
    assert_false(offered(editor, "group") || offered(editor, "curve-open") || offered(editor, "curve-join"));
    for (int round = 0; round < 4; round++) {
        if (round == 1) bat_editor_command(editor, "select-all");
        if (round == 2) bat_editor_command(editor, "group");
        if (round == 3) bat_editor_command(editor, "curve-close");
        for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
            bool said = offered(editor, names[i]);
            uint64_t before = digest(editor);
            bat_status status = bat_editor_command(editor, names[i]);
            /* One open curve alone is joined with itself: closed, which has its own button. */
            bool closes = round == 0 && !strcmp(names[i], "curve-join");
            if (said != (status == BAT_OK) && !closes) fail_msg("%d: %s", round, names[i]);
            if (digest(editor) != before) bat_editor_command(editor, "undo");
            bat_editor_command(editor, "deselect");
            if (round == 0)
                bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
            else
                bat_editor_command(editor, "select-all");
        }
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(style_of_selection_and_of_new),
        cmocka_unit_test(opacity_of_a_group),
        cmocka_unit_test(actions_of_the_selection),
        cmocka_unit_test(what_cannot_be_done),
    };
    return cmocka_run_group_tests_name("selection", tests, NULL, NULL);
}
