/* Changes of the document outside their rules: without a transaction, twice begun, of objects and places that are not
 * there; and a history longer than it may be. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/session/transaction.h"
#include "support/editing.h"

static void out_of_order(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_context *c = &editor->context;
    const uint64_t before = digest(editor);
    bat_object *one = bat_object_retain(bat_document_at(bat_editor_document(editor), 0)), *other = NULL;
    assert_int_equal(bat_object_with_id(one, 50, &other), BAT_OK);
    assert_int_equal(bat_transaction_insert(c, 0, other), BAT_STATE);
    assert_int_equal(bat_transaction_replace(c, 0, one), BAT_STATE);
    assert_int_equal(bat_transaction_remove(c, 0), BAT_STATE);
    assert_int_equal(bat_transaction_commit(c, BAT_STRING_STEP_CHANGE, NULL), BAT_STATE);
    assert_int_equal(bat_transaction_begin(c), BAT_OK);
    assert_int_equal(bat_transaction_begin(c), BAT_STATE);
    assert_int_equal(bat_transaction_insert(c, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_insert(c, 3, other), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_insert(c, -1, other), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_insert(c, 0, one), BAT_ARGUMENT); /* its id is there */
    assert_int_equal(bat_transaction_replace(c, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_replace(c, 9, one), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_replace(c, 0, other), BAT_ARGUMENT); /* of another id */
    assert_int_equal(bat_transaction_remove(c, 9), BAT_ARGUMENT);
    assert_int_equal(bat_transaction_remove(c, -1), BAT_ARGUMENT);
    assert_int_equal(c->session->transaction.count, 0);
    assert_int_equal(bat_transaction_insert(c, 2, other), BAT_OK);
    assert_int_equal(bat_editor_compact(editor), BAT_STATE);
    bat_transaction_cancel(c);
    assert_true(digest(editor) == before);
    check(editor);
    bat_object_release(one);
    bat_object_release(other);
    bat_editor_free(editor);
}

/* What would break a group up is refused at the end, and all of it. */
static void broken_groups(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_context *c = &editor->context;
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    const uint64_t before = digest(editor);
    assert_int_equal(bat_transaction_begin(c), BAT_OK);
    assert_int_equal(bat_transaction_remove(c, 0), BAT_OK); /* the group, and not what it holds */
    assert_int_equal(bat_transaction_commit(c, BAT_STRING_STEP_CHANGE, NULL), BAT_ARGUMENT);
    assert_true(digest(editor) == before);
    check(editor);
    bat_editor_set_read_only(editor, true);
    assert_int_equal(bat_transaction_begin(c), BAT_OK);
    assert_int_equal(bat_transaction_remove(c, 2), BAT_OK);
    assert_int_equal(bat_transaction_commit(c, BAT_STRING_STEP_CHANGE, NULL), BAT_STATE);
    assert_true(digest(editor) == before);
    check(editor);
    bat_editor_free(editor);
}

/* Large steps are kept up to so many bytes, the last few always; what was dropped is counted no more. */
static void large_steps(void **state) {
    (void)state;
    static const size_t sizes[] = {BAT_HISTORY_BYTES / 100, BAT_HISTORY_BYTES / 20, 1, 2 * BAT_HISTORY_BYTES,
                                   10};
    bat_history history = {0};
    for (int k = 0; k < 5; k++)
        for (int i = 1; i <= 2000; i++) {
            assert_int_equal(bat_history_reserve(&history), BAT_OK);
            bat_history_push(&history, i, 0, NULL, sizes[k]);
            size_t bytes = 0;
            for (int j = 0; j < history.count; j++) bytes += history.steps[j].bytes;
            assert_true(bytes == history.bytes && history.steps[history.count - 1].label == i);
            assert_true(bytes <= BAT_HISTORY_BYTES || history.count <= BAT_HISTORY_FEWEST);
            if (bytes < BAT_HISTORY_BYTES / 4 * 3 && i > 1300 && sizes[k] < BAT_HISTORY_BYTES / 1000)
                assert_true(history.count >= BAT_HISTORY_STEPS);
            if (k < 2 && i > 1300) assert_true(bytes > BAT_HISTORY_BYTES / 3 * 2);
        }
    bat_history_clear(&history);
    assert_int_equal(history.bytes, 0);
}

/* The last thousand steps at least are kept, the oldest go, and undo still finds its state. */
static void long_histories(void **state) {
    (void)state;
    bat_history history = {0};
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    for (int i = 1; i <= 3 * BAT_HISTORY_ROOM; i++) {
        assert_int_equal(bat_history_reserve(&history), BAT_OK);
        bat_history_push(&history, i, 0, NULL, 0);
        assert_true(history.count == history.done && history.count <= BAT_HISTORY_ROOM);
        assert_true(history.count >= (i < BAT_HISTORY_STEPS ? i : BAT_HISTORY_STEPS));
        assert_int_equal(history.steps[history.count - 1].label, i); /* the last is there */
        assert_int_equal(history.steps[0].label, i - history.count + 1);
    }
    const uint64_t last = history.state;
    int steps = 0;
    while (bat_history_undo(&history, document) == BAT_OK) steps++;
    assert_int_equal(steps, history.count);
    assert_int_equal(bat_history_undo(&history, document), BAT_STATE);
    while (bat_history_redo(&history, document) == BAT_OK) steps--;
    assert_int_equal(steps, 0);
    assert_int_equal(bat_history_redo(&history, document), BAT_STATE);
    assert_true(history.state == last);
    bat_history_clear(&history);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(out_of_order), cmocka_unit_test(broken_groups),
                                       cmocka_unit_test(long_histories), cmocka_unit_test(large_steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
