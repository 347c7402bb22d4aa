/* Part of the drawing as a document of its own: the page, everything, the selection; nothing of the drawing changes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/edit/excerpt.h"
#include "editor/editor.h"
#include "support/alloc_fail.h"
#include "support/editing.h"

static bat_document *excerpt(const bat_editor *editor, bat_excerpt part) {
    bat_document *made = NULL;
    const uint64_t before = bat_document_digest(bat_editor_document(editor));
    assert_int_equal(bat_editor_excerpt(editor, part, &made), BAT_OK);
    assert_true(bat_document_digest(bat_editor_document(editor)) == before);
    return made;
}

static void parts(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    const int all = bat_document_count(bat_editor_document(editor));
    assert_true(all > 1);
    bat_document *page = excerpt(editor, BAT_EXCERPT_PAGE), *whole = excerpt(editor, BAT_EXCERPT_ALL);
    assert_true(bat_document_digest(page) == bat_document_digest(bat_editor_document(editor)));
    assert_int_equal(bat_document_count(whole), all);
    for (int i = 0; i < all; i++)
        assert_ptr_equal(bat_document_at(whole, i), bat_document_at(bat_editor_document(editor), i));
    double box[4];
    bat_document_page(whole, box);
    assert_true(box[2] <= 0);
    bat_document *none = NULL;
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_excerpt(editor, BAT_EXCERPT_SELECTION, &none), BAT_STATE);
    assert_null(none);
    const bat_id last = bat_object_id(bat_document_at(bat_editor_document(editor), all - 1));
    bat_editor_select(editor, last, false);
    bat_document *chosen = excerpt(editor, BAT_EXCERPT_SELECTION);
    assert_int_equal(bat_document_count(chosen), 1);
    assert_true(bat_object_id(bat_document_at(chosen, 0)) == last);
    bat_document_free(page), bat_document_free(whole), bat_document_free(chosen);
    bat_editor_free(editor);
}

/* A group comes with what is in it, and an empty drawing is an empty document. */
static void nested_and_empty(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "group");
    bat_document *chosen = excerpt(editor, BAT_EXCERPT_SELECTION);
    assert_int_equal(bat_document_count(chosen), bat_document_count(bat_editor_document(editor)));
    bat_document_free(chosen);
    bat_editor_command(editor, "delete");
    bat_document *whole = excerpt(editor, BAT_EXCERPT_ALL);
    assert_int_equal(bat_document_count(whole), bat_document_count(bat_editor_document(editor)));
    bat_document_free(whole);
    bat_editor_free(editor);
}

/* An object by its id comes with all that is in it, out of its group, whatever is selected. */
static void one_object(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    const bat_id first = bat_object_id(bat_document_at(bat_editor_document(editor), 0));
    const int all = bat_document_count(bat_editor_document(editor));
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "group");
    bat_document *one = NULL, *whole = NULL, *none = NULL;
    const bat_id group = bat_object_parent(
        bat_document_at(bat_editor_document(editor), bat_document_find(bat_editor_document(editor), first)));
    bat_editor_command(editor, "deselect");
    assert_true(group != 0);
    assert_int_equal(bat_excerpt_object(&editor->context, first, &one), BAT_OK);
    assert_int_equal(bat_document_count(one), 1);
    assert_true(bat_object_id(bat_document_at(one, 0)) == first);
    assert_true(bat_object_parent(bat_document_at(one, 0)) == 0);
    assert_int_equal(bat_excerpt_object(&editor->context, group, &whole), BAT_OK);
    assert_int_equal(bat_document_count(whole), all + 1);
    assert_int_equal(bat_excerpt_object(&editor->context, 9999, &none), BAT_ARGUMENT);
    assert_null(none);
    bat_document_free(one), bat_document_free(whole);
    const long held = alloc_live();
    for (long n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_excerpt_object(&editor->context, group, &none);
        const bool failed = alloc_fail_reached();
        assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
        if (!failed) break;
        assert_null(none);
        assert_int_equal(alloc_live(), held);
    }
    bat_document_free(none);
    bat_editor_free(editor);
}

static void refused(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    bat_document *made = NULL;
    assert_int_equal(bat_editor_excerpt(NULL, BAT_EXCERPT_ALL, &made), BAT_ARGUMENT);
    assert_int_equal(bat_editor_excerpt(editor, BAT_EXCERPT_ALL, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_editor_excerpt(editor, (bat_excerpt)3, &made), BAT_ARGUMENT);
    bat_editor_command(editor, "select-all");
    for (int part = BAT_EXCERPT_PAGE; part <= BAT_EXCERPT_SELECTION; part++) {
        const long held = alloc_live();
        for (long n = 1;; n++) {
            alloc_fail_at(n);
            const bat_status status = bat_editor_excerpt(editor, (bat_excerpt)part, &made);
            const bool failed = alloc_fail_reached();
            assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
            if (!failed) break;
            assert_null(made);
            assert_int_equal(alloc_live(), held);
        }
        bat_document_free(made);
        made = NULL;
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts),
        cmocka_unit_test(nested_and_empty),
        cmocka_unit_test(one_object),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
