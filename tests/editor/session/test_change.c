/* Any transaction replays bit for bit; the selection follows the document. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"

static uint32_t roll(uint32_t *seed) { return *seed = *seed * 1664525u + 1013904223u, *seed >> 8; }

/* A new object with numbers that no short decimal writes. */
static bat_object *made(bat_editor *editor, bat_id id, uint32_t *seed) {
    double x = (double)roll(seed) / 7e3, y = (double)roll(seed) / 3e4;
    bat_style style = bat_style_defaults();
    style.width = 1 + (double)roll(seed) / 1e9;
    style.filled = roll(seed) & 1;
    bat_object *object = NULL;
    bat_curve *curve = pen_curve(x, y, 10 + x / 100, 3.1, 4 + (int)(roll(seed) % 6));
    if (!id) id = bat_document_new_id(editor->session.document);
    assert_int_equal(bat_object_create_path(id, "a \"name\"\n", &style, 1, &curve, &object), BAT_OK);
    return object;
}

static void one_change(bat_editor *editor, uint32_t *seed) {
    int count = bat_document_count(editor->session.document);
    int at = count ? (int)(roll(seed) % (uint32_t)count) : 0;
    uint32_t kind = count ? roll(seed) % 4 : 0;
    if (kind == 3) {
        assert_int_equal(bat_transaction_remove(&editor->context, at), BAT_OK);
        return;
    }
    bat_object *object = made(
        editor, kind == 1 ? bat_object_id(bat_document_at(editor->session.document, at)) : 0, seed);
    assert_int_equal(kind == 1 ? bat_transaction_replace(&editor->context, at, object)
                               : bat_transaction_insert(&editor->context, kind ? at : count, object),
                     BAT_OK);
    bat_object_release(object);
}

static void any_transaction_replays(void **state) {
    (void)state;
    uint32_t seed = 7;
    bat_editor *editor = pen_editor(), *again = NULL;
    uint64_t digests[61] = {digest(editor)};
    for (int step = 1; step <= 60; step++) {
        assert_int_equal(bat_transaction_begin(&editor->context), BAT_OK);
        for (uint32_t i = 0; i <= roll(&seed) % 5; i++) one_change(editor, &seed);
        assert_int_equal(bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL), BAT_OK);
        assert_null(bat_editor_check(editor));
        digests[step] = digest(editor);
    }
    for (int step = 59; step >= 0; step--) {
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == digests[step]);
        assert_null(bat_editor_check(editor));
    }
    for (int step = 1; step <= 60; step++) {
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        assert_true(digest(editor) == digests[step]);
    }
    size_t size;
    const char *journal = bat_editor_journal(editor, &size);
    again = replay_of(editor, 0);
    size_t same_size;
    assert_string_equal(bat_editor_journal(again, &same_size), journal);
    bat_editor_free(again);
    bat_editor_free(editor);
}

static void wrong_changes_change_nothing(void **state) {
    (void)state;
#define HEAD                                                                                                 \
    "{\"journal\":\"batten\",\"version\":1}\n{\"do\":\"change\",\"label\":\"step.change\",\"changes\":"
#define LINE                                                                                                 \
    "{\"id\":3,\"kind\":\"path\",\"curves\":[{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}]}"
    static const char *const good = HEAD "[{\"at\":0,\"insert\":" LINE "}]}";
    static const char *const wrong[] = {
        HEAD "[]}",
        HEAD "7}",
        HEAD "[{\"insert\":" LINE "}]}",
        HEAD "[{\"at\":1,\"insert\":" LINE "}]}",
        HEAD "[{\"at\":0.5,\"insert\":" LINE "}]}",
        HEAD "[{\"at\":0,\"replace\":" LINE "}]}",
        HEAD "[{\"at\":0,\"remove\":3}]}",
        HEAD "[{\"at\":0}]}",
        HEAD "[{\"at\":0,\"insert\":" LINE "},{\"at\":1,\"insert\":" LINE "}]}",
        HEAD "[{\"at\":0,\"insert\":" LINE "},{\"at\":0,\"remove\":4}]}",
    };
    bat_editor *editor = NULL;
    bat_editor_create(&editor);
    bat_problem problem;
    assert_int_equal(bat_editor_replay(editor, good, strlen(good), true, &problem), BAT_OK);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_not_equal(bat_editor_replay(editor, wrong[i], strlen(wrong[i]), true, &problem), BAT_OK);
        assert_string_equal(problem.place, "line 2");
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
        assert_null(bat_editor_check(editor));
    }
    bat_editor_free(editor);
}

static void selection_is_a_set(void **state) {
    (void)state;
    bat_selection selection = {0};
    bool in[50] = {false};
    uint32_t seed = 3;
    for (int i = 0; i < 2000; i++) {
        bat_id id = 1 + roll(&seed) % 49;
        if (roll(&seed) & 1) {
            assert_int_equal(bat_selection_add(&selection, id), BAT_OK);
            in[id] = true;
        } else {
            bat_selection_remove(&selection, id);
            in[id] = false;
        }
        int count = 0;
        for (bat_id k = 1; k < 50; k++) {
            assert_int_equal(bat_selection_has(&selection, k), in[k]);
            count += in[k];
        }
        assert_int_equal(selection.count, count);
    }
    bat_selection_free(&selection);
}

static void selection_follows_the_document(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    editor->choice.tool = BAT_TOOL_PAN;
    bat_selection *selection = &editor->choice.selection;
    bat_selection_add(selection, 1);
    bat_selection_add(selection, 2);
    const bat_item *outlines = pen_live(bat_editor_frame(editor), BAT_ROLE_SELECTION);
    assert_non_null(outlines);
    assert_true(outlines->bounds[1] < 200 && outlines->bounds[3] > 600);
    bat_transaction_begin(&editor->context);
    bat_transaction_remove(&editor->context, 0);
    bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL);
    assert_int_equal(selection->count, 1);
    assert_false(bat_selection_has(selection, 1));
    bat_editor_command(editor, "undo"); /* what comes back is selected */
    assert_int_equal(selection->count, 1);
    assert_true(bat_selection_has(selection, 1));
    bat_editor_command(editor, "redo");
    assert_int_equal(selection->count, 0);
    bat_selection_add(selection, 1); /* not there */
    assert_non_null(bat_editor_check(editor));
    bat_selection_clear(selection);
    bat_selection_add(selection, 2);
    bat_document *other = NULL;
    bat_document_create(&other);
    bat_editor_open(editor, other, "");
    assert_int_equal(selection->count, 0);
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_transaction_replays),
        cmocka_unit_test(wrong_changes_change_nothing),
        cmocka_unit_test(selection_is_a_set),
        cmocka_unit_test(selection_follows_the_document),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
