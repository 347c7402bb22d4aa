/* What the file contains and the document cannot hold: kept with the session and in its journal, and reported to the
 * host. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/tables/tables.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include <batten/bezier.h>
#include <stdio.h>

static const bat_losses some = {.count = {[BAT_LOSS_TEXT] = 2, [BAT_LOSS_DASH] = 3, [BAT_LOSS_PAGE] = 1}};
static const bat_losses none = {{0}};

static void assert_losses(const bat_editor *editor, const bat_losses *expected) {
    assert_memory_equal(bat_editor_losses(editor), expected, sizeof *expected);
}

static void noted_read_and_forgotten(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    assert_losses(editor, &none);
    assert_int_equal(bat_editor_frame(editor)->lost, 0);
    assert_int_equal(bat_editor_set_losses(editor, &some), BAT_OK);
    assert_losses(editor, &some);
    assert_int_equal(bat_editor_frame(editor)->lost, 6);
    uint32_t revision = bat_editor_frame(editor)->revision;
    assert_false(bat_editor_frame(editor)->unsaved); /* no change of the document */
    pen p = pen_for(editor);
    pen_line(&p, 300, 205, 700, 205, 8);
    bat_editor_command(editor, "undo");
    assert_losses(editor, &some);
    assert_true(bat_editor_frame(editor)->revision > revision);
    bat_losses bad = some;
    bad.count[0] = -1;
    assert_int_equal(bat_editor_set_losses(editor, &bad), BAT_ARGUMENT);
    assert_losses(editor, &some);
    assert_int_equal(bat_editor_set_losses(editor, NULL), BAT_OK);
    assert_losses(editor, &none);
    assert_int_equal(bat_editor_set_losses(editor, &some), BAT_OK);
    bat_document *other = NULL;
    assert_int_equal(bat_document_create(&other), BAT_OK);
    assert_int_equal(bat_editor_open(editor, other, "other"), BAT_OK);
    assert_losses(editor, &none); /* of another file */
    bat_editor_free(editor);
}

/* A page that crashed, and a journal made short, still know it; and that the file has been written over. */
static void the_journal_holds_it(void **state) {
    (void)state;
    bat_editor *editor = pen_editor(), *again;
    assert_int_equal(bat_editor_set_losses(editor, &some), BAT_OK);
    size_t size = 0, before = 0;
    bat_editor_journal(editor, &before);
    assert_int_equal(bat_editor_set_losses(editor, &some), BAT_OK); /* said already */
    assert_non_null(
        strstr(bat_editor_journal(editor, &size), "{\"lost\":{\"texts\":2,\"dashes\":3,\"page\":1}}\n"));
    assert_int_equal(size, before);
    pen p = pen_for(editor);
    pen_line(&p, 300, 205, 700, 205, 8);
    again = replay_of(editor, 0);
    assert_losses(again, &some);
    bat_editor_free(again);
    assert_int_equal(bat_editor_compact(editor), BAT_OK);
    assert_losses(editor, &some);
    again = replay_of(editor, 0);
    assert_losses(again, &some);
    assert_true(bat_document_digest(bat_editor_document(again)) ==
                bat_document_digest(bat_editor_document(editor)));
    bat_editor_free(again);
    assert_int_equal(bat_editor_set_losses(editor, NULL), BAT_OK);
    again = replay_of(editor, 0);
    assert_losses(again, &none);
    bat_editor_free(again);
    bat_editor_free(editor);
}

static void the_command_asks_the_host(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    assert_int_equal(bat_editor_command(editor, "losses"), BAT_OK);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->requests & BAT_ASK_LOSSES, 0);
    assert_true(*frame->notice); /* there is nothing to show */
    bat_editor_set_losses(editor, &some);
    assert_int_equal(bat_editor_command(editor, "losses"), BAT_OK);
    assert_int_equal(bat_editor_frame(editor)->requests & BAT_ASK_LOSSES, BAT_ASK_LOSSES);
    bat_editor_free(editor);
}

static void memory_may_fail(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    for (long n = 1;; n++) {
        alloc_fail_at(n);
        bat_status status = bat_editor_set_losses(editor, &some);
        bool hit = alloc_fail_reached();
        assert_int_equal(status, hit ? BAT_MEMORY : BAT_OK);
        assert_losses(editor, hit ? &none : &some);
        if (!hit) break;
    }
    bat_editor_free(editor);
}

/* The shells name the kinds by their keys. */
static void every_kind_has_its_words(void **state) {
    (void)state;
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        char key[40], words[64];
        int size = snprintf(key, sizeof key, "loss.%s.help", bat_loss_key((bat_loss)i));
        bat_string text = bat_string_named(key, (size_t)size);
        if (text == BAT_STRING_COUNT) fail_msg("no words for %s", key);
        /* The library's own words for many are the same but for the capital and the stop. */
        bat_loss_words((bat_loss)i, 2, words, sizeof words);
        const char *english = bat_string_english(text);
        assert_memory_equal(english + 1, words + 3, strlen(words + 3));
        assert_int_equal(strlen(english), strlen(words + 2) + 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noted_read_and_forgotten),  cmocka_unit_test(the_journal_holds_it),
        cmocka_unit_test(the_command_asks_the_host), cmocka_unit_test(memory_may_fail),
        cmocka_unit_test(every_kind_has_its_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
