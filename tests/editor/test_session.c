/* Long random sessions: the invariants hold after every event, undoing everything restores the first document, redoing
 * everything the last, and the journal replays to the same. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/session.h"
#include <batten/document.h>
#include <batten/editor.h>
#include "support/editing.h"

static void check_at(const bat_editor *editor, uint64_t seed, size_t at) {
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, at, wrong);
}

static void settle(bat_editor *editor) {
    bat_editor_command(editor, "cancel");
    bat_editor_command(editor, "cancel");
}

/* The first of those of pen_editor that has only two ids left to give. */
static bat_editor *scarce_editor(void) {
    bat_editor *editor = pen_editor();
    bat_document *document = NULL;
    bat_object *guide = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    assert_int_equal(bat_object_create_guide(BAT_ID_MAX - 2, 0, 1, &guide), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, guide), BAT_OK);
    bat_object_release(guide);
    assert_int_equal(bat_editor_open(editor, document, "scarce"), BAT_OK);
    bat_editor_command(editor, "zoom-100");
    return editor;
}

/* How many sketches were committed. */
static int wild_session(bat_editor *editor, uint64_t seed) {
    enum { SIZE = 1500 };
    static uint8_t data[SIZE];
    int commits = 0;
    session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed});
    uint64_t first = digest(editor);
    double time = 0;
    while (bytes.at < bytes.size) {
        session_event(editor, &bytes, &time);
        check_at(editor, seed, bytes.at);
    }
    settle(editor);
    uint64_t last = digest(editor);
    size_t size = 0;
    const char *text = bat_editor_journal(editor, &size);

    for (const char *at = text; (at = strstr(at, "\"do\":\"sketch")); at++) commits++;

    bat_editor *again = replay_of(editor, seed);
    size_t size_again = 0;
    const char *text_again = bat_editor_journal(again, &size_again);
    assert_true(size == size_again && !memcmp(text, text_again, size));
    bat_editor_free(again);

    uint64_t here = last;
    int back = 0, undone = 0;
    while (bat_editor_command(editor, "redo") == BAT_OK) back++;
    uint64_t top = digest(editor);
    while (bat_editor_command(editor, "undo") == BAT_OK) {
        undone++;
        if (undone == back) assert_true(digest(editor) == here);
    }
    assert_true(digest(editor) == first);
    check_at(editor, seed, 0);
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    assert_true(digest(editor) == top);
    check_at(editor, seed, 0);
    bat_editor_free(editor);
    return commits;
}

static void wild_sessions(void **state) {
    (void)state;
    int commits = 0;
    for (uint64_t seed = 1; seed <= 12; seed++) commits += wild_session(pen_editor(), seed);
    assert_true(commits > 60); /* sessions that do something */
}

/* What needs a new id fails then, and nothing else. */
static void ids_run_out(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 4; seed++) wild_session(scarce_editor(), seed);
    bat_editor *editor = scarce_editor();
    pen p = pen_for(editor);
    int count = bat_document_count(bat_editor_document(editor));
    for (int i = 0; i < 4; i++) pen_line(&p, 300, 350 + 40 * i, 700, 350 + 40 * i, 5);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), count + 2);
    check_at(editor, 0, 0);
    assert_true(*bat_editor_frame(editor)->notice); /* it is said */
    pen_line(&p, 300, 205, 700, 205, 0);            /* a curve that is there can be redrawn */
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    check_at(editor, 0, 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(wild_sessions), cmocka_unit_test(ids_run_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
