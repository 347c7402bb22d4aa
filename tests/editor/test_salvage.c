/* Salvage: what can be run of a damaged journal is; an undo of what is missing does nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/document.h>
#include <batten/editor.h>

enum { LINES = 16, ROOM = 1 << 16 };

/* Three curves far from each other, the last one undone, redone and undone again. Its lines. */
static int session(char lines[LINES][4096]) {
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 1000, 800, 1);
    pen p = pen_for(editor);
    for (int i = 0; i < 3; i++) {
        pen_begin(&p, pen_arch, (double[]){100, 100 + 200 * i, 500, 100 + 200 * i, 30}, 60);
        pen_event(&p, BAT_POINTER_UP, 500, 100 + 200 * i);
    }
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "redo");
    bat_editor_command(editor, "undo");
    int count = 0;
    for (const char *at = bat_editor_journal(editor, NULL); *at; at = strchr(at, '\n') + 1, count++) {
        size_t length = (size_t)(strchr(at, '\n') - at);
        assert_true(count < LINES && length < 4096);
        memcpy(lines[count], at, length);
        lines[count][length] = 0;
    }
    bat_editor_free(editor);
    return count;
}

/* The ids of the objects that come of the lines, as bits; -1 when it was refused. */
static int salvaged(char lines[LINES][4096], int count, int *left_out) {
    static char text[ROOM];
    size_t size = 0;
    for (int i = 0; i < count; i++) size += (size_t)snprintf(text + size, ROOM - size, "%s\n", lines[i]);
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    int ids = bat_editor_salvage(editor, text, size, left_out) == BAT_OK ? 0 : -1;
    check(editor);
    const bat_document *document = bat_editor_document(editor);
    for (int i = 0; i < bat_document_count(document) && ids >= 0; i++)
        ids |= 1 << bat_object_id(bat_document_at(document, i));
    bat_editor_free(editor);
    return ids;
}

static void what_is_missing(void **state) {
    (void)state;
    static char lines[LINES][4096], kept[LINES][4096];
    const int count = session(lines);
    int left_out = -1;
    assert_int_equal(salvaged(lines, count, &left_out), 1 << 1 | 1 << 2);
    assert_int_equal(left_out, 0);
    int step = 0;
    for (int i = 0; i < count; i++) {
        memcpy(kept, lines, sizeof kept);
        strcpy(lines[i], i % 2 ? "{\"spoilt\":true}" : "no JSON");
        const int ids = salvaged(lines, count, &left_out);
        assert_true(left_out == 1 || (left_out == 2 && strstr(kept[i], "undo")));
        if (strstr(kept[i], "\"sketch-new\"")) {
            step++; /* the third is undone, or not there */
            assert_int_equal(ids, (1 << 1 | 1 << 2) & ~(1 << step));
        } else if (ids < 0 || (ids & 6) != 6)
            fail_msg("%s: %d", kept[i], ids);
        memcpy(lines, kept, sizeof kept);
    }
    assert_int_equal(step, 3);
}

static void refused(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t before = digest(editor);
    const char newer[] = "{\"journal\":\"batten\",\"version\":2}\n{\"do\":\"undo\"}\n";
    int left_out = 0;
    assert_int_equal(bat_editor_salvage(editor, newer, strlen(newer), &left_out), BAT_UNSUPPORTED);
    assert_int_equal(bat_editor_salvage(editor, "# a remark\n\n", 12, &left_out), BAT_SYNTAX);
    assert_int_equal(bat_editor_salvage(editor, NULL, 0, NULL), BAT_SYNTAX);
    assert_int_equal(bat_editor_salvage(editor, NULL, 1, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_editor_salvage(NULL, newer, 1, NULL), BAT_ARGUMENT);
    assert_true(digest(editor) == before);
    const char later[] = "# remark\n{\"journal\":\"batten\",\"version\":1}\n# "
                         "another\n{\"do\":\"of-the-future\"}\n{\"do\":\"undo\"}\n";
    assert_int_equal(bat_editor_salvage(editor, later, strlen(later), &left_out), BAT_OK);
    assert_int_equal(left_out, 1);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_missing), cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
