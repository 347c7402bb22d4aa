/* Texts in the editor: the tool asks for one, which is written, changed with others in one step, deleted and undone; the journal says
 * what they say, and replays to the same. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "document/lettering.h"
#include "editor/editor.h"
#include "support/editing.h"
#include <batten/editor.h>

static bat_status put(bat_editor *editor, const char *json) {
    const bat_status status = bat_editor_write(editor, json, strlen(json), NULL);
    assert_null(bat_editor_check(editor));
    return status;
}

static const bat_lettering *lettering(const bat_editor *editor, int index) {
    const bat_object *object = bat_document_at(bat_editor_document(editor), index);
    return object ? bat_object_lettering(object) : NULL;
}

static void written_changed_and_undone(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    const uint64_t before = digest(editor);
    const int first = bat_document_count(bat_editor_document(editor));
    size_t size;
    assert_int_equal(bat_editor_command(editor, "tool-text"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK); /* without a pen: in the middle */
    assert_true(bat_editor_frame(editor)->requests & BAT_ASK_TEXT);
    assert_non_null(strstr(bat_editor_writing(editor), "{\"id\":0,\"text\":\"\""));
    assert_int_equal(put(editor, "{\"text\":\"\"}"), BAT_OK); /* nothing was typed */
    assert_true(digest(editor) == before);
    assert_int_equal(put(editor, "{\"text\":\"a\"}"), BAT_NUMBER); /* nobody has measured it */
    assert_true(digest(editor) == before);
    assert_int_equal(put(editor, "{\"text\":\"a\\nb\",\"size\":20,\"box\":[0,-20,30,40]}"), BAT_OK);
    assert_string_equal(lettering(editor, first)->content, "a\nb");
    assert_non_null(
        strstr(bat_editor_outline(editor, 0, 500), "\"a, text\"")); /* its name, as long as it has no other */
    assert_int_equal(editor->choice.selection.count, 1);
    assert_int_equal(editor->choice.tool, BAT_TOOL_SELECT);
    const uint64_t one = digest(editor);
    assert_int_equal(bat_editor_command(editor, "text-edit"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);

    /* Two in one step; then one is emptied. */
    const bat_document *document = bat_editor_document(editor);
    char json[200];
    const unsigned long ids[2] = {(unsigned long)bat_object_id(bat_document_at(document, first)),
                                  (unsigned long)bat_object_id(bat_document_at(document, first + 1))};
    const uint64_t two = digest(editor);
    snprintf(json, sizeof json, "[{\"id\":%lu,\"weight\":700},{\"id\":%lu,\"fill\":\"#ff0000ff\"}]", ids[0],
             ids[1]);
    assert_int_equal(put(editor, json), BAT_OK);
    assert_true(lettering(editor, first)->weight == 700 && lettering(editor, first + 1)->weight == 400);
    const char *texts = bat_editor_texts(editor), *bold = strstr(texts, "\"weight\":700");
    assert_true(bold && strstr(bold, "\"weight\":400")); /* both are selected, back to front */
    assert_int_equal(bat_object_style(bat_document_at(document, first + 1))->fill, 0xff0000ff);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == two);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    snprintf(json, sizeof json, "{\"id\":%lu,\"text\":\"\"}", ids[1]);
    assert_int_equal(put(editor, json), BAT_OK);
    assert_null(lettering(editor, first + 1));
    assert_int_equal(put(editor, json), BAT_ARGUMENT); /* it is gone */

    assert_null(strstr(bat_editor_journal(editor, &size), "\"data\""));
    bat_editor *again = replay_of(editor, 0);
    assert_true(digest(again) == digest(editor));
    bat_editor_free(again);
    for (int i = 0; i < 3; i++) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == one);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(written_changed_and_undone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
